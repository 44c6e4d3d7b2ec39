//! The forest: a hillside in the evening, with instances of a dozen models, trees, rocks, undergrowth and lamps, turned, mirrored and scaled. x runs
//! east, y north and uphill, z up. Its area grows with the number of instances; what stands where depends on that number alone.

mod ground;
mod plants;
#[cfg(test)]
mod tests;

use crate::kit::noise::{fractal_noise, hash, sin_cos_degrees, unit};
use crate::kit::*;
use glam::{Mat3, Vec2, Vec3, vec2, vec3};
use ground::{Ground, PATH, place};
use plants::{Kind, Plant, Ramps, plants};
use std::sync::Arc;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::scene::{Instance, Scene, Unit};
use voxtrace_scene::sky::{Sky, Sun};
use voxtrace_scene::transform::{Axis as About, Transform};

/// Ground for each instance, square metres.
const AREA: f32 = 9.0;
/// Widest hillside whose voxels are as small as those of the models, metres.
const FINE: f32 = 400.0;
/// One of so many instances is a lamp.
const LAMPS: u32 = 78;

/// A forest to be built.
pub struct Forest {
    pub voxel: f32,
    pub instances: u32,
}

/// What stands somewhere: its model and its place, metres.
struct Standing {
    plant: usize,
    at: Vec2,
    seed: u32,
}

impl Forest {
    /// The hillside; its voxels are a whole number of the models' where it is wide.
    fn ground(&self) -> (Ground, u32) {
        let side = (AREA * self.instances as f32).sqrt().max(30.0);
        let scale = 1 + (side / FINE) as u32;
        (Ground { side, voxel: self.voxel * scale as f32 }, scale)
    }

    /// The model that becomes a grid of its own.
    fn model(&self, plant: &Plant, ramps: &Ramps, palette: &Palette) -> Model {
        let (half, height) = plant.reach;
        Model {
            solid: plant.solid.clone(),
            paint: Paint::plain(ramps.bark.even(0.5, 0.4)),
            palette: palette.clone(),
            min: vec3(-half, -half, -1.2),
            max: vec3(half, half, height),
            cameras: Vec::new(),
            sky: Sky::black(),
            light_intensity: 1.0,
        }
    }

    /// The scene, or some part of it once it is not `wanted` any more. Its first grid and instance are the hillside.
    pub fn into_scene_while(self, name: &str, wanted: &(dyn Fn() -> bool + Sync)) -> Scene {
        let (ramps, palette) = Ramps::new();
        let (ground, scale) = self.ground();
        let plants = plants(&ramps, self.voxel);
        let mut scene = Scene {
            cameras: cameras(&ground, self.voxel),
            sky: evening(),
            voxel_size: f64::from(self.voxel),
            unit: Unit::Metre,
            ..Scene::new(name)
        };
        scene.add_instance(ground.build(&ramps, wanted), Transform::IDENTITY.scaled(scale as f32));
        scene.instances[0].name = "hillside".into();
        let origins = plants.iter().map(|plant| {
            let model = self.model(plant, &ramps, &palette);
            let origin = (model.min / self.voxel).to_array().map(noise::floor);
            let built = model.into_scene_while(plant.name, self.voxel, wanted);
            scene.grids.push(Arc::clone(&built.grids[0]));
            Vec3::from_array(origin.map(|cell| cell as f32))
        });
        let origins: Vec<Vec3> = origins.collect();
        scene.materials = palette.into_materials();
        for index in 0..self.instances {
            let standing = standing(index, &ground, &plants);
            let top = (ground.top(standing.at) / self.voxel + 0.5).floor();
            let foot = (standing.at / self.voxel).floor().extend(top);
            let linear = turned(standing.seed, plants[standing.plant].kind);
            let translation = foot + linear * origins[standing.plant];
            scene.instances.push(Instance::new(standing.plant + 1, Transform { linear, translation }));
        }
        scene
    }
}

/// The instance of a number. Trees stand away from paths and glades, conifers among their like; what would stand on a path is beside it, and lamps are.
fn standing(index: u32, ground: &Ground, plants: &[Plant]) -> Standing {
    let seed = hash(index ^ 0x51ed_270b);
    let draw = |part: u32| unit(hash(seed.wrapping_add(part.wrapping_mul(0x9e37_79b9))));
    let mut at = place(index, ground.side, 1.2);
    let (path, far) = ground.path(at);
    let is_lamp = index % LAMPS == LAMPS - 1;
    let side = if at.x < path { -1.0 } else { 1.0 };
    let beside = path + side * (PATH + 0.9);
    if (is_lamp || far < PATH + 0.6) && (1.0..ground.side - 1.0).contains(&beside) {
        at.x = if is_lamp { beside } else { path + side * (PATH + 0.9 + 1.6 * draw(1)) };
    }
    let glade = fractal_noise(vec3(at.x / 34.0, at.y / 34.0, 0.3), 2, 321);
    let is_open = glade > 0.24 || far < 6.5 || (at - ground.viewpoint()).length() < 12.0;
    let conifers = 0.42 + 1.3 * fractal_noise(vec3(at.x / 60.0, at.y / 60.0, 0.9), 2, 322);
    let kind = match draw(2) {
        _ if is_lamp => Kind::Lamp,
        chance if chance < 0.1 => Kind::Rock,
        chance if is_open || chance < 0.5 => Kind::Undergrowth,
        _ if draw(3) < conifers => Kind::Conifer,
        _ => Kind::Broadleaf,
    };
    let choices = || (0..plants.len()).filter(|&plant| plants[plant].kind == kind);
    let count = choices().count();
    let chosen = ((draw(4) * count as f32) as usize).min(count - 1);
    let plant = choices().nth(chosen).expect("each kind has a model");
    Standing { plant, at, seed }
}

/// How an instance is turned: most by quarter turns and mirrored, on the lattice; the others freely about the vertical and scaled, rocks about any axis.
fn turned(seed: u32, kind: Kind) -> Mat3 {
    let draw = |part: u32| unit(hash(seed ^ part.wrapping_mul(0x85eb_ca6b)));
    let mirror = Mat3::from_diagonal(vec3(if draw(11) < 0.5 { -1.0 } else { 1.0 }, 1.0, 1.0));
    let about_z = |degrees: f32| {
        let (sin, cos) = sin_cos_degrees(degrees);
        Mat3::from_cols(vec3(cos, sin, 0.0), vec3(-sin, cos, 0.0), Vec3::Z)
    };
    let about_x = |degrees: f32| {
        let (sin, cos) = sin_cos_degrees(degrees);
        Mat3::from_cols(Vec3::X, vec3(0.0, cos, sin), vec3(0.0, -sin, cos))
    };
    if kind == Kind::Lamp || draw(12) < 0.6 {
        return Transform::from_quarter_turns(About::Z, (draw(13) * 4.0) as i32).linear * mirror;
    }
    let tilt = if kind == Kind::Rock { 360.0 * draw(14) } else { 0.0 };
    about_z(360.0 * draw(15)) * about_x(tilt) * mirror * (0.75 + 0.5 * draw(16))
}

impl Ground {
    /// The place below the first camera.
    fn viewpoint(&self) -> Vec2 {
        vec2(0.47, 0.03) * self.side
    }
}

/// The views; the first from the foot of the hill up its slope.
fn cameras(ground: &Ground, voxel: f32) -> Vec<Camera> {
    let above = |at: Vec2, height: f32| at.extend(ground.height(at) + height);
    let side = ground.side;
    let camera = |name: &str, eye: Vec3, target: Vec3, fov_y: f32| Camera {
        name: name.into(),
        fov_y,
        ..Camera::look_at(eye / voxel, target / voxel)
    };
    let near = vec2(ground.viewpoint().x + 6.0, ground.viewpoint().y + 130.0_f32.min(0.43 * side));
    let foot = vec2(ground.path(vec2(0.5 * side, 0.12 * side)).0, 0.12 * side);
    let ahead = vec2(ground.path(vec2(foot.x, foot.y + 24.0)).0, foot.y + 24.0);
    vec![
        camera("default", above(ground.viewpoint(), 24.0), above(near, 7.0), 44.0),
        camera("path", above(foot, 2.6), above(ahead, 3.4), 56.0),
        camera("aerial", above(vec2(-0.1, -0.25) * side, 0.5 * side), above(vec2(0.5, 0.5) * side, 0.0), 42.0),
    ]
}

/// The sky of an evening, its sun low in the west.
fn evening() -> Sky {
    let sun =
        Sun { direction: vec3(-0.8, -0.28, 0.42).normalize(), angular_radius: 0.012, irradiance: vec3(6.4, 4.3, 2.4) };
    Sky::gradient(vec3(1.05, 0.72, 0.55), vec3(0.22, 0.36, 0.66)).with_sun(sun)
}
