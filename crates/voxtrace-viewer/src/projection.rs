//! Where the picture shows a point of the scene: the inverse of the rays of a camera, for what is drawn over the picture. Places are
//! pixels from the upper left corner.

use std::f32::consts::{PI, TAU};
use voxtrace::Camera;
use voxtrace::camera::{Axes, Lens};
use voxtrace::glam::{Vec2, Vec3};

/// Depth before which nothing is drawn, as a share of the distance of what is looked at.
const NEAR: f32 = 1e-4;

/// A camera with the size of its picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Projection {
    camera: Camera,
    axes: Axes,
    size: Vec2,
}

impl Projection {
    /// Of pictures of `size` pixels.
    pub fn new(camera: &Camera, size: (u32, u32)) -> Self {
        Self { axes: camera.axes(), camera: camera.clone(), size: Vec2::new(size.0 as f32, size.1 as f32) }
    }

    /// Where rays begin that show `point`, world space: the eye, or, where rays are parallel, a place far before the scene on the ray of the
    /// point.
    pub fn seen_from(&self, point: Vec3) -> Vec3 {
        match self.camera.lens {
            Lens::Orthographic { .. } => point - self.axes.forward * self.depth(point),
            _ => self.camera.eye,
        }
    }

    /// Along the view, world units.
    pub fn depth(&self, point: Vec3) -> f32 {
        (point - self.camera.eye).dot(self.axes.forward)
    }

    /// World units that a pixel is wide at a point.
    pub fn pixel_at(&self, point: Vec3) -> f32 {
        match self.camera.lens {
            Lens::Orthographic { view_height } => view_height / self.size.y,
            Lens::Panorama { .. } => self.camera.eye.distance(point) * PI / self.size.y,
            Lens::Fisheye { fisheye_angle } => {
                self.camera.eye.distance(point) * fisheye_angle.to_radians() / self.size.y
            }
            _ => 2.0 * self.half_field() * self.depth(point).max(0.0) / self.size.y,
        }
    }

    fn half_field(&self) -> f32 {
        (self.camera.fov_y.to_radians() * 0.5).tan()
    }

    fn near(&self) -> f32 {
        NEAR * self.camera.eye.distance(self.camera.target)
    }

    /// The place of a point, `None` where no ray leads to it. It may lie beside the picture.
    pub fn place(&self, point: Vec3) -> Option<Vec2> {
        let Axes { forward, right, up } = self.axes;
        let offset = point - self.camera.eye;
        let (x, y, depth) = (offset.dot(right), offset.dot(up), offset.dot(forward));
        let place = match self.camera.lens {
            Lens::Orthographic { view_height } => 0.5 * self.size + Vec2::new(x, -y) / view_height * self.size.y,
            Lens::Fisheye { fisheye_angle } => {
                let radius =
                    offset.normalize_or_zero().dot(forward).clamp(-1.0, 1.0).acos() / fisheye_angle.to_radians();
                0.5 * self.size + Vec2::new(x, -y).normalize_or_zero() * radius * self.size.y
            }
            Lens::Panorama { eye_distance } => {
                let eyes = if eye_distance > 0.0 { 2.0 } else { 1.0 };
                let longitude = (-x).atan2(-depth).rem_euclid(TAU) / TAU;
                let latitude = (y / offset.length().max(f32::MIN_POSITIVE)).clamp(-1.0, 1.0).acos() / PI;
                Vec2::new(longitude, latitude / eyes) * self.size
            }
            _ => {
                let half = self.half_field() * depth;
                (depth >= self.near()).then(|| 0.5 * self.size + Vec2::new(x, -y) / half * 0.5 * self.size.y)?
            }
        };
        place.is_finite().then_some(place)
    }

    /// The part of a line that lies before the camera, `None` where there is none.
    pub fn before_camera(&self, from: Vec3, to: Vec3) -> Option<(Vec3, Vec3)> {
        if !matches!(self.camera.lens, Lens::Pinhole | Lens::Thin { .. }) {
            return Some((from, to));
        }
        let near = self.near() * 1.001;
        let (a, b) = (self.depth(from), self.depth(to));
        let cut = |end: Vec3, depth: f32, other: Vec3, other_depth: f32| match depth < near {
            true => other + (end - other) * ((other_depth - near) / (other_depth - depth)),
            false => end,
        };
        (a >= near || b >= near).then(|| (cut(from, a, to, b), cut(to, b, from, a)))
    }

    /// Whether a line between two places is one of the picture, and not one around it, as between both sides of a panorama.
    pub fn is_joined(&self, from: Vec2, to: Vec2) -> bool {
        !matches!(self.camera.lens, Lens::Panorama { .. }) || (from.x - to.x).abs() < 0.5 * self.size.x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_on_the_ray_of_a_pixel_is_shown_at_that_pixel_through_every_lens() {
        let size = (640, 480);
        let camera = Camera::look_at(Vec3::new(3.0, -20.0, 7.0), Vec3::new(5.0, 4.0, 1.0));
        let lenses = [
            Lens::Pinhole,
            Lens::Thin { aperture: 0.5, focus: 12.0, blades: 6, blade_rotation: 0.0 },
            Lens::Orthographic { view_height: 30.0 },
            Lens::Panorama { eye_distance: 0.0 },
            Lens::Fisheye { fisheye_angle: 180.0 },
        ];
        for lens in lenses {
            let camera = camera.clone().with_lens(lens);
            let projection = Projection::new(&camera, size);
            let frame = camera.frame(size.0, size.1);
            for place in [Vec2::new(320.0, 240.0), Vec2::new(100.5, 37.0), Vec2::new(500.0, 300.0)] {
                let ray = frame.central_ray(place);
                let shown = projection.place(ray.at(9.0)).unwrap();
                assert!(shown.distance(place) < 0.05, "{lens:?} {place}: {shown}");
                let beside = projection.place(ray.at(9.0) + 0.1 * camera.axes().right).unwrap();
                assert!(beside.distance(place) > 0.5, "the comparison sees a tenth of a voxel: {lens:?}");
                let wide = projection.pixel_at(ray.at(9.0));
                let next = frame.central_ray(place + Vec2::Y).at(9.0).distance(ray.at(9.0));
                assert!((0.4..2.5).contains(&(wide / next)), "{lens:?} {place}: {wide} {next}");
            }
        }
        assert_eq!(Projection::new(&camera, size).place(camera.eye - 3.0 * camera.axes().forward), None);
    }

    #[test]
    fn what_lies_behind_the_camera_is_left_out_of_a_line() {
        let camera = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 10.0, 0.0));
        let projection = Projection::new(&camera, (100, 100));
        let (from, to) = projection.before_camera(Vec3::new(1.0, -5.0, 0.0), Vec3::new(1.0, 5.0, 0.0)).unwrap();
        assert!(from.y > 0.0 && from.y < 0.01 && to.y == 5.0 && from.x == 1.0, "{from} {to}");
        assert!(projection.place(from).is_some());
        assert_eq!(projection.before_camera(Vec3::new(1.0, -5.0, 0.0), Vec3::new(1.0, -1.0, 0.0)), None);
    }
}
