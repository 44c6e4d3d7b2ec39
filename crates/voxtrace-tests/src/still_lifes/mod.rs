//! Three scenes of what filters find hard, as people build them: vessels of coloured glass with drinks, worked metal in a hall of mirrors, and a
//! village under clouds with mist on its lake. Every number is + − × ÷ √, so that they are the same everywhere.

mod cloud;
mod glass;
mod metal;

use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::scenes::kit::noise::hash3;
use voxtrace::{Material, Scene, VoxelGrid};

/// Names of the scenes.
pub const NAMES: [&str; 3] = ["glass", "metal", "cloud"];

/// The scene of a name, with a camera; `None` if there is no such scene.
pub fn scene(name: &str) -> Option<Scene> {
    match name {
        "glass" => Some(glass::scene()),
        "metal" => Some(metal::scene()),
        "cloud" => Some(cloud::scene()),
        _ => None,
    }
}

/// Most bounces of a scene, built in or of these: light passes many surfaces of glass and scatters often in clouds.
pub fn max_bounces(name: &str) -> u32 {
    match name {
        "glass" => 24,
        "metal" => 12,
        "cloud" => 48,
        _ => 8,
    }
}

/// A grid and its materials in the making.
#[derive(Default)]
struct Builder {
    grid: VoxelGrid,
    materials: Vec<Material>,
}

impl Builder {
    fn material(&mut self, material: Material) -> u16 {
        self.materials.push(material);
        self.materials.len() as u16 - 1
    }

    /// Shades of one colour, sRGB, from dark to light.
    fn shades(&mut self, color: [u8; 3], of: impl Fn(Material) -> Material) -> [u16; 4] {
        [0.82_f32, 0.9, 1.0, 1.08].map(|factor| {
            let shade = color.map(|channel| (f32::from(channel) * factor).min(255.0) as u8);
            self.material(of(Material::from_srgb(shade)))
        })
    }

    /// Sets the voxels of a box by the places of their middles.
    fn fill(&mut self, min: Vec3, max: Vec3, material: impl Fn(Vec3) -> Option<u16>) {
        let (min, max) = (min.floor().as_ivec3(), max.ceil().as_ivec3());
        for z in min.z..max.z {
            for y in min.y..max.y {
                for x in min.x..max.x {
                    let voxel = IVec3::new(x, y, z);
                    if let Some(material) = material(voxel.as_vec3() + 0.5) {
                        self.grid.set(voxel, material);
                    }
                }
            }
        }
    }

    /// A solid ball.
    fn ball(&mut self, middle: Vec3, radius: f32, material: impl Fn(Vec3) -> u16) {
        self.fill(middle - radius, middle + radius, |at| (at.distance(middle) < radius).then(|| material(at)));
    }

    /// A solid that a profile of heights and radii makes as it turns about an axis that stands at `foot`.
    fn turned(&mut self, foot: Vec3, profile: &[(f32, f32)], material: impl Fn(Vec3) -> u16) {
        let (reach, height) = extent(profile);
        self.fill(foot - Vec3::new(reach, reach, 0.0), foot + Vec3::new(reach, reach, height), |at| {
            let at = at - foot;
            (at.truncate().length() < radius_at(profile, at.z)?).then(|| material(at))
        });
    }

    /// A vessel: as `turned`, hollow above `bottom`, with a drink up to a level.
    fn vessel(&mut self, foot: Vec3, profile: &[(f32, f32)], vessel: &Vessel) {
        let (reach, height) = extent(profile);
        self.fill(foot - Vec3::new(reach, reach, 0.0), foot + Vec3::new(reach, reach, height), |at| {
            let at = at - foot;
            let (outer, distance) = (radius_at(profile, at.z)?, at.truncate().length());
            let is_within = at.z > vessel.bottom && distance < outer - vessel.wall;
            match vessel.drink {
                _ if distance >= outer => None,
                Some((level, drink)) if is_within && at.z < level => Some(drink),
                _ => (!is_within).then_some(vessel.glass),
            }
        });
    }

    fn into_scene(self, name: &str) -> Scene {
        Scene::from_grid(name, self.grid, self.materials)
    }
}

/// What a vessel is made of.
struct Vessel {
    glass: u16,
    wall: f32,
    bottom: f32,
    /// Up to where there is what.
    drink: Option<(f32, u16)>,
}

/// The largest radius and height of a profile.
fn extent(profile: &[(f32, f32)]) -> (f32, f32) {
    profile.iter().fold((0.0, 0.0), |(reach, top), &(height, radius)| (radius.max(reach), height.max(top)))
}

/// The radius of a profile at a height.
fn radius_at(profile: &[(f32, f32)], height: f32) -> Option<f32> {
    let part = profile.windows(2).find(|part| (part[0].0..part[1].0).contains(&height))?;
    let share = (height - part[0].0) / (part[1].0 - part[0].0);
    Some(part[0].1 + (part[1].1 - part[0].1) * share)
}

/// One of some materials, by a random number of a cell.
fn one_of<const N: usize>(materials: [u16; N], cell: IVec3) -> u16 {
    materials[hash3(cell, 1) as usize % N]
}

/// Rectangles of a pattern on a plane: which one a place is in, and whether it is in the gap between two.
fn tile(at: Vec2, size: Vec2, gap: f32) -> (IVec3, bool) {
    let cell = (at / size).floor();
    let within = at - cell * size;
    (cell.extend(0.0).as_ivec3(), within.x < gap || within.y < gap)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Voxels of the materials that a scene is named after.
    fn voxels_of(scene: &Scene, is_of: fn(&Material) -> bool) -> usize {
        scene.grids[0].voxels().filter(|(_, material)| is_of(&scene.materials[usize::from(*material)])).count()
    }

    #[test]
    fn each_scene_has_much_of_what_it_is_named_after() {
        let kinds: [fn(&Material) -> bool; 3] = [
            |material| material.is_transmissive() && material.ior > 1.0,
            |material| material.metallic == 1.0,
            |material| material.scattering > 0.0,
        ];
        for (index, name) in NAMES.into_iter().enumerate() {
            let scene = scene(name).unwrap();
            assert_eq!(scene.cameras.len(), 1, "{name}");
            let counts = kinds.map(|is_of| voxels_of(&scene, is_of));
            assert!(counts[index] > 100_000, "{name}: {counts:?}");
            assert!((0..3).all(|other| counts[other] <= counts[index]), "{name}: {counts:?}");
        }
        assert!(scene("city").is_none());
    }
}
