//! The view of a scene that brings no camera, by perspective or by parallel rays: its silhouette stands in the middle of the picture and fills most of it.

use crate::PackedScene;
use crate::overview::{FOV_Y, TOWARDS_CAMERA, world_up};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use voxtrace_scene::Camera;
use voxtrace_scene::camera::Lens;

/// Share of the picture's width or height, whichever is tighter, that the silhouette spans.
const FILL: f64 = 0.8;
/// Halvings of the interval that the camera's place is looked for in.
const STEPS: u32 = 40;

impl PackedScene {
    /// A camera as [`Self::overview`] has one, in front, to the right and above, for a still picture of `aspect` = width / height: what is seen of
    /// the scene spans 80 % of the picture's width or height, whichever is tighter, and is as far from its left as from its right edge, and
    /// from the upper as from the lower one.
    pub fn portrait(&self, aspect: f32) -> Camera {
        let points = self.shape_points();
        if points.is_empty() {
            return self.overview(aspect);
        }
        let middle = self.bounds().map_or(Vec3::ZERO, |(min, max)| (min + max) * 0.5);
        let forward = -TOWARDS_CAMERA.as_dvec3().normalize();
        let right = forward.cross(DVec3::Z).normalize();
        let up = right.cross(forward);
        // In the axes of the picture.
        let seen: Vec<DVec3> = (points.par_iter())
            .map(|point| {
                let offset = (*point - middle).as_dvec3();
                DVec3::new(offset.dot(right), offset.dot(up), offset.dot(forward))
            })
            .collect();
        let tan_y = (f64::from(FOV_Y).to_radians() * 0.5).tan() * FILL;
        let eye = fitted(&seen, [tan_y * f64::from(aspect), tan_y]);
        let place = |x: f64, y: f64, z: f64| middle + (right * x + up * y + forward * z).as_vec3();
        // As deep as the middle of the scene.
        let target = place(eye.x, eye.y, (eye.z + 1.0).max(0.0));
        Camera { fov_y: FOV_Y, ..Camera::look_at(place(eye.x, eye.y, eye.z), target) }
    }

    /// A camera of parallel rays that stands as [`Self::portrait`] does, in front, to the right and above, and shows as much.
    pub fn parallel_portrait(&self, aspect: f32) -> Camera {
        self.parallel_portrait_from(TOWARDS_CAMERA, aspect)
    }

    /// A camera of parallel rays from the direction `towards_camera`, which is not zero, for a still picture of `aspect` = width / height: what is seen
    /// of the scene spans 80 % of the picture's width or height, whichever is tighter, and stands in its middle. Up is as in
    /// [`Self::overview_from`].
    pub fn parallel_portrait_from(&self, towards_camera: Vec3, aspect: f32) -> Camera {
        let forward = -towards_camera.as_dvec3().normalize();
        let world_up = world_up(towards_camera);
        let right = forward.cross(world_up.as_dvec3()).normalize();
        let up = right.cross(forward);
        let middle = self.bounds().map_or(Vec3::splat(0.5), |(min, max)| (min + max) * 0.5);
        let seen = |point: &Vec3| {
            let offset = (*point - middle).as_dvec3();
            DVec3::new(offset.dot(right), offset.dot(up), offset.dot(forward))
        };
        let widest = |a: (DVec3, DVec3), b: (DVec3, DVec3)| (a.0.min(b.0), a.1.max(b.1));
        let nothing = || (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let points = self.shape_points();
        let (low, high) = match points.is_empty() {
            // Of nothing it shows a voxel's place.
            true => (DVec3::splat(-0.5), DVec3::splat(0.5)),
            false => points.par_iter().map(seen).map(|at| (at, at)).reduce(nothing, widest),
        };
        let (span, at) = (high - low, (low + high) * 0.5);
        let view_height = span.y.max(span.x / f64::from(aspect)) / FILL;
        let target = middle + (right * at.x + up * at.y + forward * at.z).as_vec3();
        // In front of all of it: rays begin at the camera.
        let eye = target - (forward * (0.5 * span.z + view_height)).as_vec3();
        let lens = Lens::Orthographic { view_height: view_height as f32 };
        Camera { fov_y: FOV_Y, up: world_up, ..Camera::look_at(eye, target) }.with_lens(lens)
    }
}

/// Where a camera that looks along z sees all points within the tangents `tan` of the middle, as near as can be, and in the middle both ways.
fn fitted(points: &[DVec3], tan: [f64; 2]) -> DVec3 {
    // Along an axis a point at (p, z) is inside where |p − e| ≤ tan (z − e_z): two half planes of (e, e_z) for each point.
    let reach = |axis: usize, sign: f64, point: &DVec3| sign * point[axis] - tan[axis] * point.z;
    let [z_across, z_upward] = [0, 1].map(|axis| {
        let reaches = points.par_iter().map(|point| (reach(axis, -1.0, point), reach(axis, 1.0, point)));
        let (low, high) =
            reaches.reduce(|| (f64::NEG_INFINITY, f64::NEG_INFINITY), |a, b| (a.0.max(b.0), a.1.max(b.1)));
        -(low + high) / (2.0 * tan[axis])
    });
    let z = z_across.min(z_upward);
    let [x, y] = [0, 1].map(|axis| centred(points, axis, z));
    DVec3::new(x, y, z)
}

/// The place along an axis from which points span as far to both sides, as seen from the depth `z`.
fn centred(points: &[DVec3], axis: usize, z: f64) -> f64 {
    let lines: Vec<Line> =
        (points.par_iter()).map(|point| Line { place: point[axis], depth: (point.z - z).max(1e-9) }).collect();
    let widest = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
    let ends = lines.par_iter().map(|line| (line.place, line.place));
    let (mut low, mut high) = ends.reduce(|| (f64::INFINITY, f64::NEG_INFINITY), widest);
    // Those that may be the lowest or the highest somewhere in what is left of the interval.
    let (mut lowest, mut highest) = (lines.clone(), lines);
    for _ in 0..STEPS {
        let place = 0.5 * (low + high);
        let (least, most) = (extreme(&lowest, place, -1.0), extreme(&highest, place, 1.0));
        // More to the upper side: the camera goes there.
        if most.slope(place) + least.slope(place) > 0.0 {
            low = place
        } else {
            high = place
        }
        keep_beside(&mut lowest, &least, (low, high), -1.0);
        keep_beside(&mut highest, &most, (low, high), 1.0);
    }
    0.5 * (low + high)
}

/// A point by the slope at which it is seen, which falls evenly as the place that it is seen from goes up.
#[derive(Clone, Copy)]
struct Line {
    place: f64,
    depth: f64,
}

impl Line {
    fn slope(&self, from: f64) -> f64 {
        (self.place - from) / self.depth
    }
}

/// The one with the highest slope, or with the lowest one where `sign` is −1.
fn extreme(lines: &[Line], from: f64, sign: f64) -> Line {
    let nowhere = || (f64::NEG_INFINITY, Line { place: 0.0, depth: 1.0 });
    let slopes = lines.par_iter().map(|line| (sign * line.slope(from), *line));
    slopes.reduce(nowhere, |a, b| if b.0 > a.0 { b } else { a }).1
}

/// Drops those that are below `best` at both ends of an interval, so everywhere in it (above it where `sign` is −1), by more than slopes are rounded.
fn keep_beside(lines: &mut Vec<Line>, best: &Line, ends: (f64, f64), sign: f64) {
    const MARGIN: f64 = 1e-12;
    if lines.len() == 1 {
        return;
    }
    let bounds = [ends.0, ends.1]
        .map(|end| (end, sign * best.slope(end)))
        .map(|(end, slope)| (end, slope - MARGIN * slope.abs()));
    let is_near = |line: &&Line| {
        bounds.iter().any(|&(end, slope)| {
            let offset = sign * (line.place - end);
            offset + MARGIN * offset.abs() >= slope * line.depth
        })
    };
    *lines = lines.par_iter().filter(is_near).copied().collect();
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{IVec3, Quat, Vec2};
    use voxtrace_scene::grid::VoxelBox;
    use voxtrace_scene::{Material, Scene, Transform, VoxelGrid};

    /// Least and most of the picture's plane that a scene's voxels cover, each from −1 to 1, by every corner of every voxel.
    fn covered(scene: &Scene, camera: &Camera, aspect: f32) -> (Vec2, Vec2) {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let up = right.cross(forward);
        let tan = (camera.fov_y.to_radians() * 0.5).tan();
        let mut ends = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        for instance in &scene.instances {
            for (voxel, _) in scene.grids[instance.grid].voxels() {
                for corner in 0..8 {
                    let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                    let offset = instance.world_from_grid.point((voxel + pick).as_vec3()) - camera.eye;
                    let depth = offset.dot(forward);
                    assert!(depth > 0.0);
                    let at = Vec2::new(offset.dot(right) / aspect, offset.dot(up)) / depth / tan;
                    ends = (ends.0.min(at), ends.1.max(at));
                }
            }
        }
        ends
    }

    fn scenes() -> Vec<Scene> {
        let materials = || vec![Material::default()];
        let mut block = VoxelGrid::new();
        block.fill_box(VoxelBox { min: IVec3::new(100, -40, 7), max: IVec3::new(130, -10, 12) }, 0);
        // A high mast in the corner of a wide floor, whose box is mostly empty.
        let mut mast = VoxelGrid::new();
        mast.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(300, 200, 2) }, 0);
        mast.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(4, 4, 180) }, 0);
        let mut voxel = VoxelGrid::new();
        voxel.set(IVec3::new(-7, 8, 9), 0);
        let mut needle = VoxelGrid::new();
        needle.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(2, 900, 3) }, 0);
        let mut two = Scene::from_grid("two", block.clone(), materials());
        let turned = Transform::from_rotation(Quat::from_rotation_y(0.7)).translated(Vec3::new(-60.0, 90.0, 30.0));
        two.add_instance(mast.clone(), turned);
        let one = |grid| Scene::from_grid("one", grid, materials());
        vec![one(block), one(mast), one(voxel), one(needle), two]
    }

    #[test]
    fn the_silhouette_fills_80_percent_of_the_picture_in_its_middle() {
        for (number, scene) in scenes().iter().enumerate() {
            let packed = PackedScene::pack(scene).unwrap();
            for aspect in [16.0 / 9.0, 1.0, 0.6] {
                let camera = packed.portrait(aspect);
                let (low, high) = covered(scene, &camera, aspect);
                let span = (high - low) * 0.5;
                assert!((span.max_element() - 0.8).abs() < 0.005, "scene {number}, {aspect}: {span}");
                assert!((high + low).abs().max_element() < 0.005, "scene {number}, {aspect}: {low} {high}");
                // That of the box around it is smaller or beside the middle.
                let (low, high) = covered(scene, &packed.overview(aspect), aspect);
                let is_worse = (high + low).abs().max_element() > 0.02 || ((high - low) * 0.5).max_element() < 0.79;
                assert!(is_worse || number == 2 || number == 0, "scene {number}: {low} {high}");
            }
        }
    }

    #[test]
    fn parallel_rays_show_all_of_it_as_large_and_in_the_middle_too() {
        let directions = [TOWARDS_CAMERA, Vec3::new(1.0, -1.0, 1.0), Vec3::X, Vec3::Z, Vec3::NEG_Z];
        for (number, scene) in scenes().iter().enumerate() {
            let packed = PackedScene::pack(scene).unwrap();
            for (aspect, towards_camera) in
                [1.75, 1.0, 0.6].into_iter().zip(directions).chain([1.0; 5].into_iter().zip(directions))
            {
                let camera = packed.parallel_portrait_from(towards_camera, aspect);
                let Lens::Orthographic { view_height } = camera.lens else { panic!("{:?}", camera.lens) };
                let axes = camera.axes();
                assert!(axes.forward.abs_diff_eq(-towards_camera.normalize(), 1e-4), "{}", axes.forward);
                let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
                for instance in &scene.instances {
                    for (voxel, _) in scene.grids[instance.grid].voxels() {
                        for corner in 0..8 {
                            let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                            let offset = instance.world_from_grid.point((voxel + pick).as_vec3()) - camera.eye;
                            assert!(offset.dot(axes.forward) > 0.0, "scene {number}: a voxel is behind the camera");
                            let at =
                                Vec2::new(offset.dot(axes.right) / aspect, offset.dot(axes.up)) * 2.0 / view_height;
                            (low, high) = (low.min(at), high.max(at));
                        }
                    }
                }
                let span = (high - low) * 0.5;
                assert!((span.max_element() - 0.8).abs() < 0.005, "scene {number}, {aspect}, {towards_camera}: {span}");
                assert!((high + low).abs().max_element() < 0.005, "scene {number}, {aspect}: {low} {high}");
            }
        }
    }

    #[test]
    fn large_scenes_are_measured_by_their_bricks_to_a_percent() {
        let mut ball = VoxelGrid::new();
        ball.fill_sphere(DVec3::splat(0.5), 110.0, 0);
        ball.fill_box(VoxelBox { min: IVec3::new(-150, 100, -10), max: IVec3::new(150, 300, -8) }, 0);
        let mut hall = VoxelGrid::new();
        hall.fill_box(VoxelBox { min: IVec3::new(-3, 5, 0), max: IVec3::new(1900, 1500, 2) }, 0);
        hall.fill_box(VoxelBox { min: IVec3::new(-3, 5, 0), max: IVec3::new(0, 1500, 301) }, 0);
        for grid in [ball, hall] {
            let scene = Scene::from_grid("large", grid, vec![Material::default()]);
            let packed = PackedScene::pack(&scene).unwrap();
            let (low, high) = covered(&scene, &packed.portrait(1.5), 1.5);
            assert!((((high - low) * 0.5).max_element() - 0.8).abs() < 0.01, "{low} {high}");
            assert!((high + low).abs().max_element() < 0.01, "{low} {high}");
        }
    }

    /// [`centred`] with every point at every step.
    fn centred_by_all(points: &[DVec3], axis: usize, z: f64) -> f64 {
        let ends = |value: &dyn Fn(&DVec3) -> f64| {
            let both = points.iter().map(value).map(|value| (value, value));
            both.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).unwrap()
        };
        let (mut low, mut high) = ends(&|point| point[axis]);
        for _ in 0..STEPS {
            let place = 0.5 * (low + high);
            let (least, most) = ends(&|point| (point[axis] - place) / (point.z - z).max(1e-9));
            if most + least > 0.0 { low = place } else { high = place }
        }
        0.5 * (low + high)
    }

    #[test]
    fn points_that_are_dropped_on_the_way_change_no_bit() {
        let mut random = 1u64;
        let mut next = move || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as f64 / (1u64 << 31) as f64
        };
        for case in 0..300 {
            // Clouds, flat ones, many at the same place, few, some at the camera's depth.
            let count = [1, 2, 3, 50, 2000][case % 5];
            let scale = [1e-3, 1.0, 3e4][case % 3];
            let step = if case % 2 == 0 { 0.0 } else { 0.125 };
            let points: Vec<DVec3> = (0..count)
                .map(|_| {
                    let point = DVec3::new(next(), next() * next(), next()) - 0.3;
                    scale * if step > 0.0 { (point / step).round() * step } else { point }
                })
                .collect();
            let z = points.iter().map(|point| point.z).fold(f64::INFINITY, f64::min)
                - scale * [0.0, 1e-6, 0.5, 20.0][case % 4];
            for axis in [0, 1] {
                assert_eq!(
                    centred(&points, axis, z).to_bits(),
                    centred_by_all(&points, axis, z).to_bits(),
                    "case {case}"
                );
            }
        }
    }

    #[test]
    fn nothing_at_all_has_a_view_too() {
        let packed = PackedScene::pack(&Scene::new("empty")).unwrap();
        assert_eq!(packed.portrait(1.5), packed.overview(1.5));
        assert_eq!(packed.parallel_portrait(1.5).lens, Lens::Orthographic { view_height: 1.25 });
    }
}
