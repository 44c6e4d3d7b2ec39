//! Tests of the navigator: what it promises about pictures is looked at in the camera that the tracer gets.

mod around;
mod flight;
mod parallel;
mod undo;
mod walking;

use super::*;
use voxtrace::camera::Lens;

const WIDTH: u32 = 1280;
const HEIGHT: u32 = 720;
const BOUNDS: (Vec3, Vec3) = (Vec3::new(-10.0, -20.0, 0.0), Vec3::new(90.0, 60.0, 50.0));

/// SplitMix64 (Steele, Lea, Flood 2014): random numbers by a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, least: f32, most: f32) -> f32 {
        least + (most - least) * ((self.next() >> 40) as f32 / (1u64 << 24) as f32)
    }

    fn vector(&mut self, most: f32) -> Vec3 {
        Vec3::new(self.within(-most, most), self.within(-most, most), self.within(-most, most))
    }

    fn cursor(&mut self) -> Vec2 {
        Vec2::new(self.within(0.0, WIDTH as f32), self.within(0.0, HEIGHT as f32))
    }
}

fn at(camera: Camera) -> Navigator {
    let mut navigator = Navigator::new(camera, Some(BOUNDS));
    navigator.set_viewport(WIDTH, HEIGHT);
    navigator
}

fn somewhere(random: &mut Random) -> Navigator {
    let eye = random.vector(200.0) + Vec3::new(40.0, 20.0, 25.0);
    let camera = Camera::look_at(eye, eye + random.vector(100.0));
    at(Camera { fov_y: random.within(10.0, 100.0), ..camera })
}

/// Where the tracer's picture shows a point, pixels; it lies in front of the camera.
fn pixel_of(camera: &Camera, point: Vec3) -> Vec2 {
    let forward = (camera.target - camera.eye).as_dvec3().normalize();
    let right = forward.cross(camera.up.as_dvec3()).normalize();
    let up = right.cross(forward);
    let offset = (point - camera.eye).as_dvec3();
    let depth = offset.dot(forward);
    assert!(depth > 0.0, "{point} lies behind {camera:?}");
    let half = (f64::from(camera.fov_y).to_radians() / 2.0).tan() * depth;
    let (width, height) = (f64::from(WIDTH), f64::from(HEIGHT));
    let x = (offset.dot(right) / (half * width / height) + 1.0) * 0.5 * width;
    Vec2::new(x as f32, ((1.0 - offset.dot(up) / half) * 0.5 * height) as f32)
}

fn forward(navigator: &Navigator) -> Vec3 {
    (navigator.camera().target - navigator.camera().eye).normalize()
}

/// Whether the tracer can use a camera, with numbers that leave room for its arithmetic.
fn sends_rays(camera: &Camera) -> bool {
    let is_small = |vector: Vec3| vector.abs().max_element() < 1e13;
    camera.check().is_ok()
        && camera.eye != camera.target
        && camera.up != Vec3::ZERO
        && is_small(camera.eye)
        && is_small(camera.target)
}

/// Numbers that arithmetic stumbles over.
const NASTY: [f32; 14] =
    [0.0, -0.0, 1.0, -1.0, 0.5, 1e-30, -1e-42, 1e4, -3e7, 1e20, -3e38, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];

fn nasty(random: &mut Random) -> f32 {
    match random.next() % 3 {
        0 => NASTY[random.next() as usize % NASTY.len()],
        1 => random.within(-1e3, 1e3),
        _ => random.within(-2.0, 2.0),
    }
}

fn nasty_motion(random: &mut Random) -> Motion {
    let mut number = || nasty(random);
    let (a, b, c) = (Vec2::new(number(), number()), Vec2::new(number(), number()), number());
    let mut vector = || Vec3::new(number(), number(), number());
    let (p, q, r) = (vector(), vector(), vector());
    let is_there = random.next().is_multiple_of(2);
    let views = [AxisView::Front, AxisView::Back, AxisView::Right, AxisView::Left, AxisView::Top, AxisView::Bottom];
    match random.next() % 11 {
        0 => Motion::Look(a),
        1 => Motion::Orbit { delta: a, pivot: is_there.then_some(p) },
        2 => Motion::Pan { from: a, to: b, anchor: is_there.then_some(p) },
        3 => Motion::Zoom { cursor: a, distance: is_there.then_some(c), steps: p.x },
        4 => Motion::FrameAll,
        5 => Motion::Frame { min: p, max: q },
        6 => Motion::View(views[random.next() as usize % 6]),
        7 => Motion::Level,
        8 => Motion::FieldOfView(c),
        9 => Motion::GoTo(Camera { name: String::new(), eye: p, target: q, up: r, fov_y: c, lens: Lens::Pinhole }),
        _ => Motion::Speed(c),
    }
}

#[test]
fn no_input_makes_a_camera_that_cannot_send_rays() {
    for seed in 0..200 {
        let random = &mut Random(seed);
        let bounds = Some((Vec3::new(nasty(random), 0.0, nasty(random)), Vec3::new(nasty(random), nasty(random), 9.0)));
        let camera = Camera::look_at(Vec3::new(nasty(random), 1.0, 2.0), Vec3::new(nasty(random), nasty(random), 0.0));
        let mut navigator = Navigator::new(camera, bounds);
        for step in 0..400 {
            let before = navigator.camera().clone();
            let motion = nasty_motion(random);
            let has_changed = navigator.apply(motion.clone());
            assert_eq!(has_changed, *navigator.camera() != before, "{motion:?}");
            navigator.held.set(Movement::ALL[random.next() as usize % 10], step % 3 != 0);
            navigator.held.stick = Vec3::new(nasty(random), nasty(random), nasty(random));
            navigator.held.turn = Vec2::new(nasty(random), nasty(random));
            navigator.set_viewport(nasty(random) as u32, nasty(random) as u32);
            navigator.advance(nasty(random));
            match random.next() % 8 {
                0 => navigator.begin_gesture(),
                1 => navigator.end_gesture(),
                2 => assert_eq!(navigator.can_undo(), navigator.undo()),
                3 => assert_eq!(navigator.can_redo(), navigator.redo()),
                _ => {}
            }
            assert!(sends_rays(navigator.camera()), "seed {seed}, step {step}, {motion:?}: {:?}", navigator.camera());
            let ray = navigator.ray(Vec2::ZERO);
            assert!((ray.direction.length() - 1.0).abs() < 1e-5 && navigator.speed() > 0.0, "{:?}", navigator.camera());
        }
    }
    assert!(!sends_rays(&Camera::look_at(Vec3::X, Vec3::X)) && !sends_rays(&Camera::look_at(Vec3::NAN, Vec3::X)));
}

#[test]
fn a_camera_that_was_given_stays_as_it_is_until_it_moves() {
    let camera = Camera {
        name: "porch".into(),
        eye: Vec3::new(0.1, 7.3, -2.9),
        target: Vec3::new(33.3, 1.7, 0.3),
        up: Vec3::new(0.1, 0.2, 3.0),
        fov_y: 33.3,
        lens: Lens::Fisheye { fisheye_angle: 120.0 },
    };
    let mut navigator = at(camera.clone());
    let still = [
        Motion::Look(Vec2::ZERO),
        Motion::Look(Vec2::NAN),
        Motion::Pan { from: Vec2::ONE, to: Vec2::ONE, anchor: None },
        Motion::Zoom { cursor: Vec2::ONE, distance: Some(4.0), steps: 0.0 },
        Motion::Zoom { cursor: Vec2::ONE, distance: None, steps: f32::NAN },
        Motion::Frame { min: Vec3::ONE, max: Vec3::ZERO },
        Motion::FieldOfView(33.3),
        Motion::GoTo(camera.clone()),
        Motion::GoTo(Camera::look_at(Vec3::X, Vec3::X)),
        Motion::Speed(3.0),
    ];
    for motion in still {
        assert!(!navigator.apply(motion.clone()), "{motion:?}");
    }
    assert!(!navigator.advance(1.0) && !navigator.can_undo());
    assert_eq!(navigator.camera(), &camera);
    assert!(navigator.apply(Motion::Look(Vec2::X)));
    assert_ne!(navigator.camera(), &camera);
}

#[test]
fn rays_are_those_of_the_picture() {
    let mut random = Random(5);
    for _ in 0..100 {
        let navigator = somewhere(&mut random);
        let cursor = random.cursor();
        let point = navigator.point_at(cursor, 50.0);
        assert!(pixel_of(navigator.camera(), point).distance(cursor) < 0.05);
    }
}
