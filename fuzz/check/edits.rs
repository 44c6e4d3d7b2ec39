//! What must hold for any sequence of edits: a scene that is edited has the voxels of a plain map that is edited alike, rays find the same in it as in
//! the scene packed from scratch, and packing it anew gives the same bytes. Shared by the fuzz target and the tests.

use std::collections::HashMap;
use voxtrace::dynamic::{Clip, DynamicScene, Edit};
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::FACES;
use voxtrace::{CpuTracer, Hit, Material, PackedScene, Ray, Scene, Shape, Tracer, VoxelGrid};

type Voxels = HashMap<IVec3, u16>;

/// Reads commands from bytes; zeros where there are none left.
struct Commands<'a>(&'a [u8]);

impl Commands<'_> {
    fn byte(&mut self) -> i32 {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        i32::from(*first)
    }

    /// Mostly near, sometimes far out.
    fn voxel(&mut self) -> IVec3 {
        let near = IVec3::new(self.byte(), self.byte(), self.byte()) / 4 - 32;
        if self.byte() == 255 { near * 1000 } else { near }
    }

    fn region(&mut self) -> VoxelBox {
        let min = self.voxel();
        VoxelBox { min, max: min + IVec3::new(self.byte(), self.byte(), self.byte()) % 14 }
    }

    fn material(&mut self, scene: &DynamicScene) -> u16 {
        (self.byte() as usize % scene.scene().materials().len()) as u16
    }

    fn content(&mut self, scene: &DynamicScene) -> Option<u16> {
        let byte = self.byte() as usize % (scene.scene().materials().len() + 1);
        (byte < scene.scene().materials().len()).then_some(byte as u16)
    }

    fn new_material(&mut self) -> Material {
        let strength = Vec3::splat(self.byte() as f32 / 16.0);
        match self.byte() % 3 {
            0 => Material::diffuse(strength / 32.0),
            1 => Material::emissive(strength),
            _ => Material::glass(1.5, 0.0),
        }
    }

    fn shape(&mut self) -> Shape {
        let center = self.voxel().as_dvec3() + DVec3::splat(f64::from(self.byte()) / 256.0);
        let radius = f64::from(self.byte()) / 32.0;
        match self.byte() % 3 {
            0 => Shape::Box(self.region()),
            1 => Shape::Sphere { center, radius },
            _ => Shape::Capsule {
                from: center,
                to: center + self.voxel().clamp(IVec3::splat(-12), IVec3::splat(12)).as_dvec3(),
                radius,
            },
        }
    }

    fn edit(&mut self, scene: &DynamicScene) -> Edit {
        match self.byte() % 8 {
            0..3 => Edit::Fill { shape: self.shape(), material: self.content(scene) },
            3 => Edit::Paint { shape: self.shape(), material: self.material(scene) },
            4 => Edit::Replace { within: Some(self.region()), from: self.material(scene), to: self.content(scene) },
            5 => Edit::Extrude {
                layer: self.region(),
                face: FACES[self.byte() as usize % 6],
                distance: self.byte() % 9 - 4,
            },
            6 => {
                let clip = scene.copy(0, self.region()).unwrap_or_else(|_| Clip::new(VoxelGrid::new(), IVec3::ONE));
                Edit::Paste { clip: clip.into(), at: self.voxel(), with_empty: self.byte() % 2 == 0 }
            }
            _ => {
                Edit::Flood { start: self.voxel(), material: self.content(scene), within: self.region(), most: 1 << 16 }
            }
        }
    }
}

fn places(region: VoxelBox) -> impl Iterator<Item = IVec3> {
    let size = region.size();
    (0..size.element_product())
        .map(move |i| region.min + IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y)))
}

fn set(voxels: &mut Voxels, voxel: IVec3, material: Option<u16>) {
    match material {
        Some(material) => _ = voxels.insert(voxel, material),
        None => _ = voxels.remove(&voxel),
    }
}

fn edit_plainly(voxels: &mut Voxels, edit: &Edit) {
    match edit {
        Edit::Fill { shape, material } => {
            let inside = shape.bounds().into_iter().flat_map(places).filter(|&voxel| shape.contains(voxel));
            inside.for_each(|voxel| set(voxels, voxel, *material));
        }
        Edit::Paint { shape, material } => {
            voxels.iter_mut().filter(|(voxel, _)| shape.contains(**voxel)).for_each(|(_, own)| *own = *material);
        }
        Edit::Replace { within, from, to } => {
            let is_met = |voxel: &IVec3| within.is_none_or(|within| within.contains(*voxel));
            let met: Vec<IVec3> =
                voxels.iter().filter(|(voxel, own)| *own == from && is_met(voxel)).map(|(voxel, _)| *voxel).collect();
            met.into_iter().for_each(|voxel| set(voxels, voxel, *to));
        }
        Edit::Paste { clip, at, with_empty } => {
            for place in places(VoxelBox { min: IVec3::ZERO, max: clip.size() }) {
                let material = clip.voxels().get(place);
                if material.is_some() || *with_empty {
                    set(voxels, *at + place, material);
                }
            }
        }
        Edit::Extrude { layer, face, distance } => {
            let was = voxels.clone();
            for voxel in places(*layer).filter(|voxel| was.contains_key(voxel)) {
                for step in 1..=*distance {
                    // The nearest voxel of the layer below counts, for what is there itself too.
                    let to = voxel + face.normal() * step;
                    let mut below = (0..=step).map(|step| to - face.normal() * step).filter(|&at| layer.contains(at));
                    let nearest = below.find_map(|at| was.get(&at).copied());
                    set(voxels, to, nearest);
                }
                (0..-*distance).for_each(|step| set(voxels, voxel - face.normal() * step, None));
            }
        }
        Edit::Flood { start, material, within, .. } => {
            let was = voxels.get(start).copied();
            let mut waiting = if was == *material || !within.contains(*start) { vec![] } else { vec![*start] };
            while let Some(voxel) = waiting.pop() {
                if within.contains(voxel) && voxels.get(&voxel).copied() == was {
                    set(voxels, voxel, *material);
                    waiting.extend(FACES.iter().map(|face| voxel + face.normal()));
                }
            }
        }
        _ => {}
    }
}

fn packed(voxels: &Voxels, materials: &[Material]) -> PackedScene {
    let mut grid = VoxelGrid::new();
    voxels.iter().for_each(|(&voxel, &material)| _ = grid.set(voxel, material));
    PackedScene::pack(&Scene::from_grid("edits", grid, materials.to_vec())).expect("not too many materials")
}

fn hits(tracer: &mut CpuTracer, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(rays, &mut hits).expect("a scene is set");
    hits
}

/// Bytes are a sequence of edits.
///
/// # Panics
/// If something does not hold.
pub fn check(bytes: &[u8]) {
    let mut voxels = Voxels::from([(IVec3::new(3, 7, -1), 1)]);
    let mut materials = vec![
        Material::diffuse(Vec3::splat(0.5)),
        Material::emissive(Vec3::ONE),
        Material::glass(1.5, 0.0),
        Material::emissive(Vec3::X),
    ];
    let first = packed(&voxels, &materials);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&first.clone().into()).expect("memory");
    let mut scene = DynamicScene::new(first).expect("nothing is merged");
    let (mut done, mut undone): (Vec<Voxels>, Vec<Voxels>) = (Vec::new(), Vec::new());
    let mut commands = Commands(&bytes[..bytes.len().min(600)]);
    while !commands.0.is_empty() {
        match commands.byte() % 11 {
            0 => {
                assert_eq!(scene.undo().expect("room").is_some(), !done.is_empty());
                done.pop().into_iter().for_each(|before| undone.push(std::mem::replace(&mut voxels, before)));
            }
            1 => {
                assert_eq!(scene.redo().expect("room").is_some(), !undone.is_empty());
                undone.pop().into_iter().for_each(|after| done.push(std::mem::replace(&mut voxels, after)));
            }
            2 => _ = scene.repair(commands.byte() as usize % 4),
            3 => scene.settle(),
            10 => {
                // Now and then so many that a byte cannot name them.
                let many = if commands.byte() == 255 { 260 } else { 1 };
                for material in vec![commands.new_material(); many] {
                    assert_eq!(scene.add_material(&material), Ok(materials.len() as u16));
                    materials.push(material);
                }
                if materials.len() > 256 && materials.len() - many <= 256 {
                    (done, undone) = (Vec::new(), Vec::new());
                }
            }
            4 => tracer.patch(&scene.take_patch()).expect("in step"),
            _ => {
                let edit = commands.edit(&scene);
                let Ok(edited) = scene.edit(0, &edit) else { continue };
                let before = voxels.clone();
                edit_plainly(&mut voxels, &edit);
                assert_eq!(edited.bricks == 0, voxels == before, "{edit:?}");
                if edited.bricks > 0 {
                    done.push(before);
                    undone.clear();
                }
            }
        }
    }
    scene.validate().expect("a sound scene");
    tracer.patch(&scene.take_patch()).expect("in step");
    let expected = packed(&voxels, &materials);
    assert_eq!(scene.compact().content_hash(), expected.content_hash());
    let mut fresh = CpuTracer::new(None);
    fresh.set_scene(&expected.into()).expect("memory");
    let ray = |index: i32| {
        let at = |factor: i32, size: i32| (index.wrapping_mul(factor) & 0xff_ffff) % size - size / 2;
        let origin = IVec3::new(at(7919, 90), at(104_729, 90), at(1_299_709, 90)).as_vec3() + 0.25;
        Ray::new(origin, IVec3::new(at(31, 17), at(37, 19), at(41, 23)).as_vec3())
    };
    let rays: Vec<Ray> = (1..500).map(ray).collect();
    assert_eq!(hits(&mut tracer, &rays), hits(&mut fresh, &rays));
}
