//! A model: a painted solid with its palette, light and cameras, in metres; and the scene that it becomes at a given
//! voxel size.

use super::{
    noise::floor,
    paint::{Paint, Palette},
    program::Program,
    shell::Lattice,
    solid::Solid,
};
use glam::{IVec3, Vec3};
use voxtrace_scene::camera::Camera;
use voxtrace_scene::scene::{Scene, Unit};
use voxtrace_scene::sky::Sky;
use voxtrace_scene::transform::Transform;

/// What a built-in scene is made from. All lengths in metres.
#[derive(Clone, Debug)]
pub struct Model {
    /// The solid; rooms are [`super::around`] their cavity.
    pub solid: Solid,
    /// Paint of parts that have none.
    pub paint: Paint,
    /// The materials that the paints use.
    pub palette: Palette,
    /// Lowest corner of the box that is built; what lies outside is cut off.
    pub min: Vec3,
    /// Highest corner of the box that is built.
    pub max: Vec3,
    /// Cameras; the first one is the default.
    pub cameras: Vec<Camera>,
    /// Light from outside.
    pub sky: Sky,
    /// Factor on every material's emission.
    pub light_intensity: f32,
}

impl Model {
    /// The scene at a voxel size in metres.
    pub fn into_scene(self, name: &str, voxel: f32) -> Scene {
        self.into_scene_while(name, voxel, &|| true)
    }

    /// The scene, or some part of it once it is not `wanted` any more.
    pub(crate) fn into_scene_while(self, name: &str, voxel: f32, wanted: &(dyn Fn() -> bool + Sync)) -> Scene {
        let lattice = self.lattice(voxel);
        let grid = lattice.build(wanted);
        let voxels = |metres: Vec3| metres / voxel - lattice.origin.as_vec3();
        let cameras = self.cameras.iter().map(|camera| Camera {
            eye: voxels(camera.eye),
            target: voxels(camera.target),
            lens: camera.lens.scaled(1.0 / voxel),
            ..camera.clone()
        });
        let mut scene = Scene {
            cameras: cameras.collect(),
            materials: self.palette.into_materials(),
            sky: self.sky,
            light_intensity: self.light_intensity,
            voxel_size: f64::from(voxel),
            unit: Unit::Metre,
            ..Scene::new(name)
        };
        scene.add_instance(grid, Transform::IDENTITY);
        scene
    }

    /// About how many voxels the scene has at a voxel size, from one in `stride` bricks.
    pub fn count(&self, voxel: f32, stride: u32) -> u64 {
        self.lattice(voxel).count(stride)
    }

    fn lattice(&self, voxel: f32) -> Lattice {
        // The scene's origin is a corner of voxels, so that planes through it (floors, above all) look the same at any
        // voxel size.
        let cells = |at: Vec3| IVec3::from_array((at / voxel).to_array().map(floor));
        let origin = cells(self.min);
        Lattice { program: Program::new(&self.solid, &self.paint), origin, voxel, size: cells(self.max) + 1 - origin }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{noise::fractal_noise, *};
    use glam::{IVec3, Vec3, vec2, vec3};
    use voxtrace_scene::Camera;
    use voxtrace_scene::Sky;

    /// A room with one of each kind of solid and paint.
    fn room() -> Model {
        let mut palette = Palette::default();
        let stone = palette.ramp(&[[120, 110, 95], [190, 180, 160]], 16);
        let walls = patterns::ashlar(stone, 0.5, 0.6, 0.3);
        let cavity = cuboid(Vec3::ZERO, vec3(4.0, 5.0, 3.0))
            .and(extrude(Profile::arch(1.5, 1.0, 1.3).stretched(1.4), Axis::Y, -0.8, 0.5).at(vec3(2.0, 0.0, 0.5)))
            .and(ball(1.0).at(vec3(4.0, 3.0, 1.5)));
        let column = revolve(&[(0.5, 0.0), (0.3, 0.3), (0.3, 2.6), (0.5, 3.1)]).turn_z(20.0);
        let turned = block(1.0, 0.3, 0.2).turn_x(30.0).turn_z(40.0).scaled(1.3);
        Model {
            solid: around(cavity).and(column.at(vec3(1.0, 2.0, 0.0))).and(turned.at(vec3(2.5, 4.0, 1.0))),
            paint: walls,
            palette,
            min: vec3(-0.5, -1.2, -0.5),
            max: vec3(5.5, 5.5, 3.5),
            cameras: vec![Camera::look_at(vec3(2.0, 1.0, 1.5), vec3(2.0, 4.0, 1.0))],
            sky: Sky::black(),
            light_intensity: 1.0,
        }
    }

    /// Whether a walk through faces of empty voxels leads from `start` to the border of the box.
    fn leaks(scene: &voxtrace_scene::Scene, start: IVec3) -> bool {
        let grid = &scene.grids[0];
        let bounds = grid.bounds().unwrap();
        let mut seen = rustc_hash::FxHashSet::from_iter([start]);
        let mut open = vec![start];
        while let Some(at) = open.pop() {
            if !bounds.contains(at) {
                return true;
            }
            for face in voxtrace_scene::ray::FACES {
                let next = at + face.normal();
                if grid.get(next).is_none() && seen.insert(next) {
                    open.push(next);
                }
            }
        }
        false
    }

    #[test]
    fn a_room_is_closed_at_any_size() {
        for voxel in [0.043, 0.071, 0.1] {
            let mut scene = room().into_scene("room", voxel);
            let start = scene.cameras[0].eye.as_ivec3();
            assert!(!leaks(&scene, start), "a hole at voxels of {voxel} m");
            // The check itself: with one voxel taken out of the wall on either side of it, there is a hole.
            let grid = std::sync::Arc::make_mut(&mut scene.grids[0]);
            let mut at = start;
            while grid.bounds().unwrap().contains(at) {
                grid.clear(at);
                at.z -= 1;
            }
            assert!(leaks(&scene, start), "a planted hole goes unseen");
        }
    }

    #[test]
    fn distances_change_no_faster_than_the_point_moves() {
        let arch = || Profile::arch(1.0, 0.7, 0.8);
        let shapes = [
            Shape::Cuboid(vec3(0.5, 0.4, 0.3), 0.1),
            Shape::Ellipsoid(vec3(0.5, 0.4, 0.8)),
            Shape::Torus(0.6, 0.2),
            Shape::Cylinder(0.4, 0.5),
            Shape::Bar(vec3(-0.5, 0.0, 0.1), vec3(0.5, 0.3, 0.2), 0.1),
            Shape::Prism(arch().stretched(1.5), Axis::X, 0.4),
            Shape::Prism(Profile::foil(4, 0.3, 0.25).outline(0.1), Axis::Y, 0.2),
            Shape::Revolution(Profile::polygon(&[(0.5, -0.5), (0.2, 0.0), (0.6, 0.6), (-9.0, 0.6), (-9.0, -0.5)])),
            Shape::Moulding {
                path: arch(),
                section: Profile::polygon(&[(0., 0.), (0.2, 0.), (0., 0.2)]),
                axis: Axis::Y,
            },
            Shape::Prism(Profile::Octagon(0.5), Axis::Z, 0.5),
            Shape::Hills(0.3, 0.7, 5),
            Shape::Prism(
                Profile::Rectangle(vec2(0.1, 0.05)).grid(vec![-0.6, -0.3, 0.2], vec![-0.4, 0.3, 0.6]),
                Axis::Y,
                0.6,
            ),
        ];
        for shape in shapes {
            let mut inside = 0;
            for i in 0..20_000u32 {
                let draw = |k| noise::signed(noise::hash(i * 8 + k));
                let a = vec3(draw(0), draw(1), draw(2));
                let b = a + vec3(draw(3), draw(4), draw(5)) * 0.05;
                let (da, db) = (shape.distance(a), shape.distance(b));
                assert!((da - db).abs() <= (a - b).length() * 1.0001 + 1e-6, "{shape:?} between {a} and {b}");
                inside += u32::from(da < 0.0);
            }
            assert!((100..19_900).contains(&inside), "{shape:?} fills {inside} of 20000 points");
        }
    }

    #[test]
    fn shortened_tapes_build_what_the_whole_tape_says() {
        // Brute force: the tape of the whole solid at each voxel, no octree.
        let voxel = 0.11;
        let lattice = room().lattice(voxel);
        let grid = lattice.build(&|| true);
        let far = |at: IVec3| {
            let p = ((lattice.origin + at).as_vec3() + 0.5) * voxel;
            let distance = lattice.program.nearest(lattice.program.tape(), p, &mut Default::default()).distance / voxel;
            (!(-2.06..=0.31).contains(&distance), (-0.94..=-0.31).contains(&distance))
        };
        for x in 0..lattice.size.x {
            for y in 0..lattice.size.y {
                for z in 0..lattice.size.z {
                    let at = IVec3::new(x, y, z);
                    let (outside, shell) = far(at);
                    assert!(!(outside && grid.get(at).is_some()), "{at} is not of the shell");
                    assert!(!(shell && grid.get(at).is_none()), "{at} is missing from the shell");
                }
            }
        }
    }

    #[test]
    fn threads_do_not_change_the_voxels() {
        let build = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| room().into_scene("room", 0.05))
        };
        let one = build(1);
        assert_eq!(one, build(3));
        assert_eq!(one.grids[0].count(), room().count(0.05, 1));
    }

    #[test]
    fn paint_inside_goes_before_paint_outside_and_cuts_inherit() {
        let mut palette = Palette::default();
        let [a, b] = [[[9, 9, 9]], [[99, 99, 99]]].map(|stop| Paint::plain(palette.ramp(&stop, 1).tone(0.0)));
        let solid = block(2.0, 2.0, 2.0).paint(&a).minus(block(1.0, 1.0, 3.0)).and(ball(0.3).paint(&b)).paint(&b);
        let model = Model { solid, palette, min: Vec3::splat(-1.5), max: Vec3::splat(2.5), ..room() };
        let grid = model.into_scene("cut", 0.1).grids[0].clone();
        assert!(grid.voxels().all(|(at, material)| (material == 1) == ((at.as_vec3() - 15.0).length() < 5.0)));
        assert!(fractal_noise(Vec3::ONE, 3, 1).abs() <= 1.0);
    }
}
