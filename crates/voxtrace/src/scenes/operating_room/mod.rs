//! The operating room: a hospital theatre seen from within, as a scan leaves it between two operations: the patient
//! draped, the lamps on, nobody there. x runs to the east wall with the door, y to the north, z up; metres; the floor is
//! z = 0 and the table stands near the middle, the patient's head to the east.

mod anaesthesia;
mod cabinets;
mod carts;
mod fabric;
mod lamps;
mod paints;
mod parts;
mod pendants;
mod screens;
mod table;
mod tiles;
mod tools;
mod walls;

use super::kit::*;
use crate::{camera::Camera, sky::Sky};
use glam::{Vec3, vec3};
use paints::Paints;

/// Size of the room along x.
const WIDTH: f32 = 10.84;
/// Size of the room along y.
const DEPTH: f32 = 8.6;
/// Height of the room.
const HEIGHT: f32 = 3.56;
/// Middle of the operating table's column, on the floor.
const TABLE: Vec3 = vec3(5.35, 4.35, 0.0);
/// How far the door and the niche reach into the walls.
const ALCOVE: f32 = 0.12;

/// What every part is made with: the paints, and the size of a voxel, below which nothing can be thin.
struct Workshop {
    paints: Paints,
    voxel: f32,
}

impl Workshop {
    /// The radius of a rod: at least nine tenths of a voxel, else it would have holes.
    fn rod(&self, radius: f32) -> f32 {
        radius.max(0.9 * self.voxel)
    }

    /// The thickness of a sheet: at least 1.8 voxels.
    fn sheet(&self, thickness: f32) -> f32 {
        thickness.max(1.8 * self.voxel)
    }
}

/// The operating room at a voxel size in metres.
pub fn model(voxel: f32) -> Model {
    let (paints, palette) = Paints::new();
    let shop = Workshop { paints, voxel };
    let solid = union([
        fabric::fabric(&shop),
        walls::fittings(&shop),
        lamps::lamps(&shop),
        table::table(&shop),
        anaesthesia::workplace(&shop),
        pendants::pendants(&shop),
        cabinets::cabinets(&shop),
        carts::carts(&shop),
        tools::tools(&shop),
    ]);
    // The shell of the room's walls lies outside the cavity.
    let margin = Vec3::splat(2.2 * voxel);
    Model {
        solid,
        paint: shop.paints.plaster,
        palette,
        min: vec3(0.0, -ALCOVE, 0.0) - margin,
        max: vec3(WIDTH + ALCOVE, DEPTH, HEIGHT + fabric::LIGHT_RECESS) + margin,
        cameras: vec![
            camera("default", vec3(1.3, 0.8, 1.68), vec3(5.75, 4.75, 1.32), 50.0),
            camera("table", vec3(3.1, 2.55, 1.72), vec3(5.45, 4.45, 1.08), 52.0),
            camera("lamps", vec3(3.55, 2.65, 1.15), vec3(5.5, 4.6, 2.15), 60.0),
            camera("monitors", vec3(5.15, 2.75, 1.62), vec3(8.1, 4.95, 1.3), 50.0),
            camera("door", vec3(10.35, 2.35, 1.75), vec3(4.2, 5.1, 1.15), 58.0),
            camera("cabinets", vec3(6.1, 2.1, 1.7), vec3(2.2, 8.2, 1.2), 52.0),
        ],
        sky: Sky::black(),
        light_intensity: 10.0,
    }
}

fn camera(name: &str, eye: Vec3, target: Vec3, fov_y: f32) -> Camera {
    Camera { name: name.into(), fov_y, ..Camera::look_at(eye, target) }
}

#[cfg(test)]
mod tests {
    use crate::{
        Scene,
        ray::FACES,
        scenes::{default_voxels, generate},
    };
    use glam::IVec3;
    use rustc_hash::{FxHashMap, FxHashSet};

    const NAME: &str = "operating-room";

    fn room(voxels: u64) -> Scene {
        generate(NAME, Some(voxels)).unwrap()
    }

    #[test]
    fn has_the_voxels_that_were_asked_for_and_the_size_of_the_study_s() {
        let scene = generate(NAME, None).unwrap();
        let grid = &scene.grids[0];
        let wanted = default_voxels(NAME).unwrap();
        assert!(grid.count().abs_diff(wanted) < wanted / 200, "{} voxels", grid.count());
        let off = (grid.bounds().unwrap().size() - IVec3::new(783, 627, 262)).abs();
        assert!(off.max_element() < 60, "{off} off the study's extents");
        let smaller = room(1_000_000).grids[0].count();
        assert!(smaller.abs_diff(1_000_000) < 5_000, "{smaller} voxels");
    }

    #[test]
    fn colors_vary_as_in_a_scan_and_lamps_are_few() {
        let scene = generate(NAME, None).unwrap();
        let grid = &scene.grids[0];
        let mut used = FxHashMap::<u16, u64>::default();
        let mut shown = 0;
        for (_, brick) in grid.sorted_bricks() {
            for &material in brick.materials() {
                *used.entry(material).or_default() += 1;
            }
            shown += brick.materials().iter().collect::<FxHashSet<_>>().len();
        }
        let mean = shown as f64 / grid.brick_count() as f64;
        assert!((12.0..16.5).contains(&mean), "{mean} materials in a mean brick");
        assert!(used.len() >= 200 && scene.materials.len() <= 255, "{} of {}", used.len(), scene.materials.len());
        let lit = used.iter().filter(|(at, _)| scene.materials[usize::from(**at)].is_emissive());
        let emissive: u64 = lit.map(|(_, count)| count).sum();
        assert!((3_000..80_000).contains(&emissive), "{emissive} emissive voxels");
    }

    #[test]
    fn threads_do_not_change_the_room() {
        let build = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| room(60_000))
        };
        assert_eq!(build(1), build(3));
    }

    /// Whether a walk through faces of empty voxels leads from `start` out of the grid.
    fn leaks(scene: &Scene, start: IVec3) -> bool {
        let grid = &scene.grids[0];
        let bounds = grid.bounds().unwrap();
        let (mut seen, mut open) = (FxHashSet::from_iter([start]), vec![start]);
        while let Some(at) = open.pop() {
            if !bounds.contains(at) {
                return true;
            }
            let free = FACES.map(|face| at + face.normal()).into_iter().filter(|&next| grid.get(next).is_none());
            open.extend(free.filter(|&next| seen.insert(next)));
        }
        false
    }

    #[test]
    fn every_camera_stands_in_the_closed_room_at_any_size() {
        for voxels in [10_000, 250_000] {
            let mut scene = room(voxels);
            let eyes: Vec<IVec3> = scene.cameras.iter().map(|camera| camera.eye.floor().as_ivec3()).collect();
            for &eye in &eyes {
                assert!(scene.grids[0].get(eye).is_none(), "{eye} is in a wall");
                assert!(!leaks(&scene, eye), "a hole at {voxels} voxels");
            }
            // The check itself: with the voxels of a column taken out from the eye down, there is a hole.
            let grid = std::sync::Arc::make_mut(&mut scene.grids[0]);
            for z in 0..=eyes[0].z {
                grid.clear(IVec3::new(eyes[0].x, eyes[0].y, z));
            }
            assert!(leaks(&scene, eyes[0]), "a planted hole goes unseen");
        }
    }
}
