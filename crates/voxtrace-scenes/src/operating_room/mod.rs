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
mod stores;
mod table;
mod tiles;
mod tools;
mod walls;

use super::kit::*;
use glam::{Vec3, vec3};
use paints::Paints;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::sky::Sky;

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
        stores::stores(&shop),
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
            camera("default", vec3(2.2, 1.55, 1.74), vec3(5.6, 4.75, 1.22), 55.0),
            camera("table", vec3(3.1, 2.55, 1.72), vec3(5.45, 4.45, 1.08), 52.0),
            camera("lamps", vec3(6.8, 5.05, 1.62), vec3(5.0, 3.72, 2.02), 62.0),
            camera("monitors", vec3(5.55, 2.35, 1.62), vec3(7.9, 5.3, 1.25), 50.0),
            camera("door", vec3(10.3, 3.3, 1.72), vec3(5.0, 4.65, 1.25), 58.0),
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
    use crate::generate;
    use glam::{IVec3, vec2};
    use voxtrace_core::PackedScene;
    use voxtrace_core::walk;

    #[test]
    fn has_the_extents_of_the_studys_room_and_a_few_percent_of_lamps() {
        let scene = generate("operating-room", None).unwrap();
        let size = scene.grids[0].bounds().unwrap().size();
        assert!((size - IVec3::new(783, 627, 262)).abs().max_element() < 25, "{size}");
        let lit = scene.grids[0].voxels().filter(|(_, at)| scene.materials[usize::from(*at)].is_emissive()).count();
        assert!((3_000..80_000).contains(&lit), "{lit} emissive voxels");
    }

    #[test]
    fn the_default_camera_sees_what_the_lamps_light_not_the_lamps() {
        // Edges of things a hundred times brighter than the rest would be the noise of every picture.
        let scene = generate("operating-room", Some(1_000_000)).unwrap();
        let packed = PackedScene::pack(&scene).unwrap();
        let brightest = |name: &str| {
            let camera = scene.cameras.iter().find(|camera| camera.name == name).unwrap();
            let frame = camera.frame(192, 108);
            let hits = (0..192 * 108).map(|i| frame.central_ray(vec2((i % 192) as f32 + 0.5, (i / 192) as f32 + 0.5)));
            let hits = hits.map(|ray| walk::cast(&packed, &ray)).filter(|hit| !hit.is_miss());
            let radiance = hits.map(|hit| packed.material(&hit).emission.max_element() * scene.light_intensity);
            let mut radiance: Vec<f32> = radiance.collect();
            radiance.sort_by(f32::total_cmp);
            // All but a pixel or two, which may look into a gap.
            radiance[radiance.len() - 4]
        };
        assert!(brightest("default") < 5.0, "{}", brightest("default"));
        assert!(brightest("lamps") > 100.0);
    }
}
