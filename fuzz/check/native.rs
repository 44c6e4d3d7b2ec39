//! What must hold for any bytes that are opened as a native file, with checksums that a malicious writer would mend; shared
//! by the fuzz target and the tests.

use super::checksums::mend;
use voxtrace::glam::Vec3;
use voxtrace::packed::Levels;
use voxtrace::{Hit, PackedScene, Placement, Ray};
use voxtrace_core::light::{Lights, Receiver};
use voxtrace_core::walk;

/// A scene that was opened, and rays at it.
pub struct Traced {
    pub scene: PackedScene,
    pub rays: Vec<Ray>,
}

/// Either the file is refused, or its scene can be traced and unpacked.
///
/// # Panics
/// If not.
pub fn check(bytes: &[u8]) -> Option<Traced> {
    let mut bytes = bytes.to_vec();
    mend(&mut bytes);
    let scene = PackedScene::from_bytes(&bytes).ok()?;
    let levels = Levels::from_bytes(&bytes);
    for (levels, level) in levels.iter().flat_map(|levels| (1..=levels.count()).map(move |level| (levels, level))) {
        let _ = levels.summary(level);
        levels.scene(level).ok().map(checked);
    }
    Some(checked(scene))
}

/// A scene that was opened, which can be traced and unpacked.
fn checked(scene: PackedScene) -> Traced {
    let rays = rays(&scene);
    let mut hits = vec![Hit::MISS; rays.len()];
    walk::cast_batch(&scene, &rays, &mut hits);
    for (ray, hit) in rays.iter().zip(&hits) {
        assert_eq!(*hit, walk::cast(&scene, ray), "{ray:?}");
        if !hit.is_miss() {
            let of_part = scene.hit_of_part(hit);
            assert_eq!(scene.hit_of_packed(&of_part), *hit, "{ray:?}");
            assert!((of_part.instance as usize) < scene.instance_count());
            assert!(hit.t >= 0.0 && (scene.material_index(&of_part) as usize) < scene.materials().len());
            scene.material(&of_part);
        }
    }
    let lights = Lights::new(&scene);
    for (index, (ray, hit)) in rays.iter().zip(&hits).enumerate() {
        let receiver = Receiver::on_surface(ray.origin, ray.direction);
        lights.sample(&receiver, [0.0, 0.3, 0.6, 0.99].map(|u: f32| (u + 0.37 * index as f32).fract()));
        if !hit.is_miss() {
            lights.emitter_pdf(&receiver, ray, hit);
        }
    }
    scene.validate().unwrap();
    let unpacked = scene.to_scene();
    assert_eq!(unpacked.instances.len(), scene.instance_count());
    let split = scene.split();
    split.validate().unwrap();
    if !scene.is_merged() {
        Placement::of_scene(scene.geometry(), &unpacked).unwrap();
    }
    for (hit, instance) in
        hits.iter().filter(|hit| !hit.is_miss()).map(|hit| (hit, &scene.instances()[hit.instance as usize]))
    {
        let grid = &scene.grids()[instance.grid as usize];
        let coverage = scene.geometry().coverage_at(grid, hit.voxel).expect("a hit's voxel is occupied");
        assert!(coverage > 0.0 && coverage <= 1.0);
    }
    Traced { scene, rays }
}

/// Rays from all sides at the origin and at corners of the first instances.
fn rays(scene: &PackedScene) -> Vec<Ray> {
    let corners = scene.instances().iter().take(3).flat_map(|instance| {
        let grid = &scene.grids()[instance.grid as usize];
        [grid.min, grid.max, (grid.min + grid.max) / 2].map(|corner| instance.world_from_grid.point(corner.as_vec3()))
    });
    let sides = [Vec3::X, Vec3::NEG_Y, Vec3::Z, Vec3::new(0.5, 0.25, -1.0), Vec3::new(-0.3, 0.9, 0.2)];
    let aims = std::iter::once(Vec3::ZERO).chain(corners).filter(|aim| aim.is_finite() && aim.length() < 1e5);
    aims.flat_map(|aim| sides.map(|side| Ray::new(aim - side * 50.0 + Vec3::splat(0.37), side))).collect()
}
