//! The city: blocks of Manhattan as a photogrammetry scan leaves them, around a square where a slanted road crosses an
//! avenue. x runs east, y north, z up; metres; the roadways are z = 0.

mod blocks;
mod facade;
mod house;
mod landmarks;
mod paints;
mod park;
mod plan;
mod roofs;
mod rows;
mod shopfronts;
mod site;
mod streets;
mod styles;
mod towers;
mod traffic;
mod trees;
mod vehicles;
mod wedge;

use super::kit::*;
use glam::{Vec3, vec3};
use voxtrace_scene::camera::Camera;
use voxtrace_scene::sky::{Sky, Sun};

/// The city at a voxel size in metres.
pub fn model(voxel: f32) -> Model {
    let (paints, palette) = paints::Paints::new();
    let paint = paints.concrete.clone();
    let site = site::Site { paints, voxel };
    let trees = trees::Trees::new(&site);
    let solid = union([
        streets::ground(&site),
        blocks::blocks(&site),
        wedge::wedge(&site),
        park::park(&site, &trees),
        traffic::traffic(&site, &trees),
    ]);
    let cameras = vec![
        camera("default", vec3(146.0, 234.0, 66.0), vec3(100.0, 108.0, 16.0), 46.0),
        camera("street", vec3(101.0, 132.0, 5.6), vec3(94.0, 98.0, 17.0), 64.0),
        camera("avenue", vec3(77.3, 191.0, 9.0), vec3(82.5, 100.0, 20.0), 54.0),
        camera("roofs", vec3(172.0, 158.0, 66.0), vec3(90.0, 84.0, 12.0), 48.0),
        camera("aerial", vec3(300.0, 330.0, 190.0), vec3(118.0, 122.0, 8.0), 38.0),
    ];
    Model {
        solid,
        paint,
        palette,
        // Roadways lie between two layers of voxels: even ground at every voxel size.
        min: vec3(0.0, 0.0, -4.0 * voxel),
        max: vec3(plan::SIZE, plan::SIZE, 72.0),
        cameras,
        sky: Sky::study(1.0).with_sun(morning_sun()),
        light_intensity: 1.0,
    }
}

/// A sun in the east-north-east, as on a summer morning.
fn morning_sun() -> Sun {
    Sun { direction: vec3(0.66, 0.36, 0.6).normalize(), angular_radius: 0.01, irradiance: vec3(7.2, 5.9, 4.3) }
}

fn camera(name: &str, eye: Vec3, target: Vec3, fov_y: f32) -> Camera {
    Camera { name: name.into(), fov_y, ..Camera::look_at(eye, target) }
}

#[cfg(test)]
mod tests {
    use crate::generate;
    use rustc_hash::FxHashSet;

    #[test]
    fn the_city_has_the_voxels_and_the_colours_of_a_scan() {
        let scene = generate("city", None).unwrap();
        let grid = &scene.grids[0];
        let count = grid.count() as f64;
        assert!((count / 4.3e6 - 1.0).abs() < 0.005, "{count} voxels");
        let size = grid.bounds().unwrap().size();
        assert!((size.as_vec3() / glam::vec3(821.0, 821.0, 246.0) - 1.0).abs().max_element() < 0.05, "{size}");
        let mut used = FxHashSet::default();
        let (mut colours, mut bricks) = (0, 0);
        for (_, brick) in grid.sorted_bricks() {
            let here: FxHashSet<u16> = brick.materials().iter().copied().collect();
            colours += here.len();
            bricks += 1;
            used.extend(here);
        }
        assert!(used.len() >= 200 && used.len() <= 255, "{} materials are in use", used.len());
        let mean = f64::from(colours as u32) / f64::from(bricks);
        assert!((12.0..=16.5).contains(&mean), "a brick shows {mean} materials");
    }

    #[test]
    fn a_city_of_any_size_has_about_the_voxels_asked_for_and_is_the_same_every_time() {
        let scene = generate("city", Some(150_000)).unwrap();
        let count = scene.grids[0].count() as f64;
        assert!((count / 1.5e5 - 1.0).abs() < 0.01, "{count} voxels");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        assert_eq!(scene, pool.install(|| generate("city", Some(150_000)).unwrap()));
        assert_ne!(scene, generate("city", Some(160_000)).unwrap());
    }

    #[test]
    fn no_ray_falls_through_the_ground() {
        let scene = generate("city", Some(300_000)).unwrap();
        let grid = &scene.grids[0];
        let size = grid.bounds().unwrap();
        let columns = |grid: &voxtrace_scene::VoxelGrid| {
            let covered: FxHashSet<(i32, i32)> = grid.voxels().map(|(at, _)| (at.x, at.y)).collect();
            covered.len() as i32
        };
        let all = size.size().x * size.size().y;
        assert_eq!(columns(grid), all, "a column of voxels is empty");
        // The check itself: a column taken out is noticed.
        let mut holed = (**grid).clone();
        for z in size.min.z..size.max.z {
            holed.clear(glam::ivec3(40, 50, z));
        }
        assert_eq!(columns(&holed), all - 1);
    }
}
