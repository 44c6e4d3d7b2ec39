//! What is known of one voxel: where it is, whose, of what, and, where it was made of a volume, the value that its file has there.

pub mod sampling;

pub use sampling::{Sampling, Values};

use crate::open::Open;
use crate::scale::{Scale, grouped};
use crate::session::{Picked, Session};
use crate::tr;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::material::srgb_from_linear;
use voxtrace::packed::PackedMaterial;

/// A line about a voxel: what, and how much.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// What it is.
    pub name: &'static str,
    /// How much, or which.
    pub text: String,
}

fn fact(name: &'static str, text: impl Into<String>) -> Fact {
    Fact { name, text: text.into() }
}

/// The middle of the voxel of a hit, world space.
pub fn middle(open: &Open, picked: &Picked) -> DVec3 {
    let instance = open.pickable.instance(&picked.hit);
    instance.world_from_grid.point(picked.hit.voxel.as_vec3() + 0.5).as_dvec3()
}

/// Where a voxel is, and whose.
pub fn place_facts(open: &Open, picked: &Picked) -> Vec<Fact> {
    let scale = Scale::of(&open.original);
    let (voxel, world, point) = (picked.hit.voxel, middle(open, picked), picked.point.as_dvec3());
    let mut facts = vec![fact(tr!("voxel.in_model"), whole(voxel))];
    let in_scene = world.floor().as_ivec3();
    if in_scene != voxel {
        facts.push(fact(tr!("voxel.in_scene"), whole(in_scene)));
    }
    facts.push(fact(tr!("voxel.point"), three(point, 2, " vx")));
    if let Some(at) = scale.place(point).filter(|_| scale.georeference.is_none()) {
        facts.push(fact(tr!("voxel.place"), three(at, 3, &format!(" {}", scale.symbol()))));
    }
    if let Some(at) = scale.coordinates(point) {
        facts.push(fact(tr!("voxel.coordinates"), three(at, 3, &scale.coordinates_symbol())));
        let crs = scale.georeference.as_ref().map(|of| of.crs_name().to_owned()).unwrap_or_default();
        if !crs.is_empty() {
            facts.push(fact(tr!("voxel.system"), crs));
        }
    }
    facts.extend(part_facts(open, picked));
    facts
}

/// The object that a voxel belongs to, and what that belongs to.
fn part_facts(open: &Open, picked: &Picked) -> Vec<Fact> {
    let Some(index) = open.object_of(&picked.hit) else { return Vec::new() };
    let named = |number: usize, name: &str| match name.is_empty() {
        true => number.to_string(),
        false => format!("{number}: {name}"),
    };
    let outline = &open.outline;
    let object = outline.objects.get(index);
    let mut facts = vec![fact(tr!("voxel.object"), named(index, object.map_or("", |object| object.name.as_str())))];
    let group = object.and_then(|object| Some((object.group?, outline.groups.get(object.group?)?)));
    facts.extend(group.map(|(number, group)| fact(tr!("voxel.group"), named(number, &group.name))));
    let layer = object.and_then(|object| Some((object.layer?, outline.layers.get(object.layer?)?)));
    facts.extend(layer.map(|(number, name)| fact(tr!("voxel.layer"), named(number, name))));
    facts
}

/// What a material is like: its colour, and whatever else is not that of a plain matte one.
pub fn material_facts(number: usize, material: &PackedMaterial) -> Vec<Fact> {
    let number_text = |value: f32| grouped(f64::from(value), 4);
    let color = |color: Vec3| {
        let [red, green, blue] = color.to_array().map(srgb_from_linear);
        format!("#{red:02x}{green:02x}{blue:02x}")
    };
    let vector = |of: Vec3| of.to_array().map(number_text).join(", ");
    let mut facts = vec![
        fact(tr!("voxel.material"), format!("{number}, {}", color(material.base_color))),
        fact(tr!("voxel.base_color"), vector(material.base_color)),
        fact(tr!("voxel.roughness"), number_text(material.roughness)),
    ];
    let mut given = |name, is_given: bool, text: String| facts.extend(is_given.then(|| fact(name, text)));
    given(tr!("voxel.metallic"), material.metallic > 0.0, number_text(material.metallic));
    given(tr!("voxel.specular"), material.specular > 0.0, number_text(material.specular));
    given(tr!("voxel.transmission"), material.transmission > 0.0, number_text(material.transmission));
    let refracts = material.transmission > 0.0 || material.specular > 0.0;
    given(tr!("voxel.ior"), refracts, number_text(material.ior));
    given(tr!("voxel.emission"), material.emission != Vec3::ZERO, vector(material.emission));
    given(tr!("voxel.absorption"), material.absorption != Vec3::ZERO, vector(material.absorption));
    given(tr!("voxel.scattering"), material.scattering > 0.0, number_text(material.scattering));
    given(tr!("voxel.anisotropy"), material.scattering > 0.0, number_text(material.anisotropy));
    facts
}

/// All that is known of a voxel, for people who write it down.
pub fn text(session: &Session, picked: &Picked) -> Option<String> {
    let open = session.open.as_ref()?;
    let material = open.lit.materials().get(picked.material as usize)?;
    let facts = [
        place_facts(open, picked),
        session.sampling.facts(middle(open, picked)),
        material_facts(picked.material as usize, material),
    ];
    let lines = facts.concat().into_iter().map(|fact| format!("{}: {}", fact.name, fact.text));
    Some(std::iter::once(open.original.name.clone()).chain(lines).collect::<Vec<_>>().join("\n"))
}

fn whole(voxel: IVec3) -> String {
    format!("{}, {}, {}", voxel.x, voxel.y, voxel.z)
}

fn three(point: DVec3, decimals: usize, unit: &str) -> String {
    format!("{:.decimals$}, {:.decimals$}, {:.decimals$}{unit}", point.x, point.y, point.z)
}
