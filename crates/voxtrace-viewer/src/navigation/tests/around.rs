//! Around things: orbit, pan, zoom, framing, views on the axes.

use super::*;

#[test]
fn what_is_under_the_cursor_stays_there_while_one_pans() {
    let mut random = Random(1);
    for _ in 0..300 {
        let mut navigator = somewhere(&mut random);
        let press = random.cursor();
        let anchor = navigator.point_at(press, random.within(1.0, 300.0));
        let mut from = press;
        let direction = forward(&navigator);
        for _ in 0..20 {
            let to = random.cursor();
            navigator.apply(Motion::Pan { from, to, anchor: Some(anchor) });
            let seen = pixel_of(navigator.camera(), anchor);
            assert!(seen.distance(to) < 0.1, "{seen} {to}");
            assert!(forward(&navigator).distance(direction) < 1e-4);
            from = to;
        }
    }
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -100.0, 0.0), Vec3::ZERO));
    let (from, to) = (Vec2::new(640.0, 360.0), Vec2::new(740.0, 360.0));
    navigator.apply(Motion::Pan { from, to, anchor: None });
    assert!(pixel_of(navigator.camera(), Vec3::ZERO).distance(to) < 0.1, "the target is taken to be there");
    let near = pixel_of(navigator.camera(), Vec3::new(0.0, -50.0, 0.0));
    assert!(near.distance(to) > 50.0, "the comparison sees a point at another depth slide: {near}");
}

#[test]
fn the_pivot_keeps_its_place_and_its_distance_while_one_orbits() {
    let mut random = Random(2);
    for _ in 0..300 {
        let mut navigator = somewhere(&mut random);
        let cursor = random.cursor();
        let pivot = navigator.point_at(cursor, random.within(1.0, 300.0));
        let distance = navigator.camera().eye.distance(pivot);
        for _ in 0..20 {
            let delta = Vec2::new(random.within(-200.0, 200.0), random.within(-200.0, 200.0));
            navigator.apply(Motion::Orbit { delta, pivot: Some(pivot) });
        }
        let camera = navigator.camera();
        assert!(pixel_of(camera, pivot).distance(cursor) < 0.5, "{} {cursor}", pixel_of(camera, pivot));
        assert!((camera.eye.distance(pivot) / distance - 1.0).abs() < 1e-3);
        navigator.apply(Motion::Orbit { delta: Vec2::new(90.0, 0.0), pivot: Some(pivot + distance * 0.1) });
        assert!(pixel_of(navigator.camera(), pivot).distance(cursor) > 0.5, "the comparison sees another pivot");
    }
}

#[test]
fn dragging_the_scene_to_the_right_carries_the_camera_to_the_left() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -100.0, 20.0), Vec3::ZERO));
    navigator.apply(Motion::Orbit { delta: Vec2::new(30.0, 0.0), pivot: None });
    assert!(navigator.camera().eye.x < -1.0, "{}", navigator.camera().eye);
    let height = navigator.camera().eye.z;
    navigator.apply(Motion::Orbit { delta: Vec2::new(0.0, 30.0), pivot: None });
    assert!(navigator.camera().eye.z > height + 1.0);
}

#[test]
fn zooming_goes_to_what_is_under_the_cursor_and_never_through_it() {
    let mut random = Random(3);
    for _ in 0..200 {
        let mut navigator = somewhere(&mut random);
        let cursor = random.cursor();
        let point = navigator.point_at(cursor, random.within(1.0, 500.0));
        let mut last = navigator.camera().eye.distance(point);
        for _ in 0..200 {
            let (eye, distance) = (navigator.camera().eye, navigator.camera().eye.distance(point));
            let steps = random.within(0.0, 30.0);
            navigator.apply(Motion::Zoom { cursor, distance: Some(distance), steps });
            let now = navigator.camera().eye.distance(point);
            assert!(now <= last + 1e-3, "{now} {last}");
            assert!((point - navigator.camera().eye).dot(point - eye) > 0.0, "it went through");
            last = now;
        }
        assert!((0.01..0.5).contains(&last), "{last}");
        let eye = navigator.camera().eye;
        navigator.apply(Motion::Zoom { cursor, distance: Some(last), steps: -10.0 });
        assert!(navigator.camera().eye.distance(point) > 2.0 * last && navigator.camera().eye != eye);
    }
    // Who does not say that something is ten voxels away goes through it: the comparison sees that.
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -100.0, 0.0), Vec3::ZERO));
    let (eye, point) = (navigator.camera().eye, Vec3::new(0.0, -90.0, 0.0));
    navigator.apply(Motion::Zoom { cursor: Vec2::new(640.0, 360.0), distance: None, steps: 10.0 });
    assert!((point - navigator.camera().eye).dot(point - eye) < 0.0);
}

#[test]
fn one_step_of_zoom_is_its_factor_and_keeps_what_is_there_under_the_cursor() {
    let mut navigator = at(Camera::look_at(Vec3::new(5.0, -100.0, 30.0), Vec3::ZERO));
    let cursor = Vec2::new(200.0, 600.0);
    let point = navigator.point_at(cursor, 80.0);
    navigator.apply(Motion::Zoom { cursor, distance: Some(80.0), steps: 1.0 });
    assert!((navigator.camera().eye.distance(point) - 80.0 / ZOOM_STEP).abs() < 1e-3);
    assert!(pixel_of(navigator.camera(), point).distance(cursor) < 0.05);
    assert!((steps_of_pinch(ZOOM_STEP * ZOOM_STEP) - 2.0).abs() < 1e-5);
    assert!([0.0, -1.0, f32::NAN, f32::INFINITY].iter().all(|scale| steps_of_pinch(*scale) == 0.0));
}

#[test]
fn zooming_into_the_void_never_gets_stuck_nor_lost() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -100.0, 0.0), Vec3::ZERO));
    let cursor = Vec2::new(640.0, 360.0);
    for _ in 0..300 {
        let before = navigator.camera().eye.y;
        navigator.apply(Motion::Zoom { cursor, distance: None, steps: 1.0 });
        assert!(navigator.camera().eye.y > before + 0.1, "{before}");
    }
    for _ in 0..1000 {
        navigator.apply(Motion::Zoom { cursor, distance: None, steps: -20.0 });
    }
    assert!(navigator.camera().eye.length() < 1e5, "{}", navigator.camera().eye);
}

/// The largest distance of a corner from the middle of the picture, as a share of its half width or height.
fn reach(camera: &Camera, (min, max): (Vec3, Vec3)) -> f32 {
    let corners = (0..8).map(|corner| {
        let pick = |axis: usize| if corner >> axis & 1 == 1 { max[axis] } else { min[axis] };
        let half = Vec2::new(WIDTH as f32, HEIGHT as f32) / 2.0;
        ((pixel_of(camera, Vec3::new(pick(0), pick(1), pick(2))) - half) / half).abs().max_element()
    });
    corners.fold(0.0, f32::max)
}

#[test]
fn framing_fills_the_picture_from_the_present_direction() {
    let mut random = Random(4);
    for _ in 0..200 {
        let mut navigator = somewhere(&mut random);
        let direction = forward(&navigator);
        navigator.apply(Motion::FrameAll);
        let reached = reach(navigator.camera(), BOUNDS);
        assert!((0.9..=0.98).contains(&reached), "{reached}");
        assert!(forward(&navigator).distance(direction) < 1e-5);
        let picked = (Vec3::new(3.0, 4.0, 5.0), Vec3::new(6.0, 8.0, 6.0));
        navigator.apply(Motion::Frame { min: picked.0, max: picked.1 });
        assert!((0.85..=0.98).contains(&reach(navigator.camera(), picked)));
        let voxel = Vec3::new(3.0, 4.0, 5.0);
        navigator.apply(Motion::Frame { min: voxel, max: voxel });
        assert!((navigator.camera().eye.distance(voxel) - 1.0).abs() < 1e-4);
    }
}

#[test]
fn the_fit_is_that_of_the_overview() {
    let scene = voxtrace::scenes::generate("city", Some(20_000)).unwrap();
    let packed = voxtrace::PackedScene::pack(&scene).unwrap();
    let overview = packed.overview(WIDTH as f32 / HEIGHT as f32);
    let away = Camera { eye: overview.eye * 3.0 - overview.target * 2.0, ..overview.clone() };
    let mut navigator = Navigator::new(away, packed.bounds());
    navigator.set_viewport(WIDTH, HEIGHT);
    assert!(navigator.camera().eye.distance(overview.eye) > 1.0);
    navigator.apply(Motion::FrameAll);
    let size = overview.eye.distance(overview.target);
    assert!(navigator.camera().eye.distance(overview.eye) < 1e-5 * size, "{:?} {overview:?}", navigator.camera());
    assert!(navigator.camera().target.distance(overview.target) < 1e-5 * size);
}

#[test]
fn axis_views_look_along_the_axes_and_turning_from_them_levels_the_horizon() {
    let mut navigator = at(Camera { up: Vec3::new(0.3, 1.0, 0.2), ..Camera::look_at(Vec3::ONE, Vec3::ZERO) });
    let expected = [
        (AxisView::Front, Vec3::Y, Vec3::Z),
        (AxisView::Back, Vec3::NEG_Y, Vec3::Z),
        (AxisView::Right, Vec3::NEG_X, Vec3::Z),
        (AxisView::Left, Vec3::X, Vec3::Z),
        (AxisView::Top, Vec3::NEG_Z, Vec3::Y),
        (AxisView::Bottom, Vec3::Z, Vec3::NEG_Y),
    ];
    for (view, direction, up) in expected {
        navigator.apply(Motion::View(view));
        assert!(forward(&navigator).distance(direction) < 1e-6, "{view:?} {}", forward(&navigator));
        assert_eq!(navigator.camera().up, up, "{view:?}");
        assert!((0.9..=0.98).contains(&reach(navigator.camera(), BOUNDS)));
    }
    navigator.apply(Motion::View(AxisView::Top));
    navigator.apply(Motion::Orbit { delta: Vec2::new(0.0, -100.0), pivot: None });
    assert_eq!(navigator.camera().up, Vec3::Z);
    let direction = forward(&navigator);
    assert!(direction.x.abs() < 1e-4 && direction.y > 0.3 && direction.z < -0.5, "{direction}");
}
