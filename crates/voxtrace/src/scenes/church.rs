//! The church: a Gothic parish church seen from within.

use super::kit::{patterns::*, *};
use crate::{camera::Camera, sky::Sky};
use glam::vec3;

/// The church at a voxel size in metres.
pub fn model(_voxel: f32) -> Model {
    let mut palette = Palette::default();
    let stone = palette.ramp(&[[120, 110, 95], [190, 180, 160]], 16);
    let flame = palette.glow(&[[255, 200, 130]], 1, 3.0);
    let walls = ashlar(stone, 0.5, 0.6, 0.3);
    let cavity = extrude(Profile::arch(14.0, 7.0, 8.0), Axis::Y, 0.0, 38.0);
    let lamp = ball(0.3).paint(&Paint::plain(flame.even(0.0, 0.0)));
    Model {
        solid: around(cavity).and(row(5, vec3(0.0, 6.0, 0.0), &lamp).at(vec3(0.0, 6.0, 8.0))),
        paint: walls,
        palette,
        min: vec3(-8.0, -0.5, -0.5),
        max: vec3(8.0, 38.5, 15.5),
        cameras: vec![Camera::look_at(vec3(0.0, 3.0, 1.7), vec3(0.0, 30.0, 5.0))],
        sky: Sky::black(),
        light_intensity: 1.0,
    }
}
