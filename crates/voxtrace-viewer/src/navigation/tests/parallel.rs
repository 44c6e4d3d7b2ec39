//! Parallel rays: the wheel changes the height of the picture, what is under the cursor stays there, and everything fits.

use super::*;

fn parallel(view_height: f32) -> Navigator {
    let camera = Camera::look_at(Vec3::new(140.0, -90.0, 80.0), Vec3::new(40.0, 20.0, 25.0));
    at(camera.with_lens(Lens::Orthographic { view_height }))
}

fn height(navigator: &Navigator) -> f32 {
    match navigator.camera().lens {
        Lens::Orthographic { view_height } => view_height,
        other => panic!("{other:?}"),
    }
}

/// Where the picture shows a point, pixels.
fn place_of(navigator: &Navigator, point: Vec3) -> Vec2 {
    let camera = navigator.camera();
    let (axes, offset) = (camera.axes(), point - camera.eye);
    let of_height = Vec2::new(offset.dot(axes.right), -offset.dot(axes.up)) / height(navigator);
    (of_height + Vec2::new(0.5 * WIDTH as f32 / HEIGHT as f32, 0.5)) * HEIGHT as f32
}

#[test]
fn zooming_with_parallel_rays_shows_less_and_keeps_what_is_under_the_cursor() {
    let mut random = Random(5);
    for _ in 0..200 {
        let mut navigator = parallel(random.within(5.0, 200.0));
        let cursor = random.cursor();
        let ray = navigator.ray(cursor);
        let point = ray.origin + ray.direction * random.within(1.0, 300.0);
        assert!(place_of(&navigator, point).distance(cursor) < 0.2);
        let (before, steps) = (height(&navigator), random.within(-4.0, 4.0));
        assert!(navigator.apply(Motion::Zoom { cursor, distance: None, steps }));
        let share = height(&navigator) / before;
        assert!((share - ZOOM_STEP.powf(-steps)).abs() < 1e-4, "{share} {steps}");
        assert!(place_of(&navigator, point).distance(cursor) < 0.5, "{steps}");
        // The comparison sees a height that is changed around the middle of the picture.
        let mut wrong = parallel(before);
        wrong.apply(Motion::Lens(navigator.camera().lens));
        let from_middle = cursor.distance(Vec2::new(WIDTH as f32, HEIGHT as f32) * 0.5);
        let is_off = place_of(&wrong, point).distance(cursor) > 0.5;
        assert!(is_off || from_middle * (1.0 - 1.0 / share).abs() < 1.0, "{steps}");
    }
}

#[test]
fn moving_sideways_with_parallel_rays_keeps_what_is_held_under_the_cursor() {
    let mut random = Random(6);
    for index in 0..200 {
        let mut navigator = parallel(80.0);
        let (from, to) = (random.cursor(), random.cursor());
        let ray = navigator.ray(from);
        let point = ray.origin + ray.direction * random.within(1.0, 300.0);
        let anchor = (index % 2 == 0).then_some(point);
        navigator.apply(Motion::Pan { from, to, anchor });
        assert!(place_of(&navigator, point).distance(to) < 0.2, "{anchor:?}");
        assert_eq!(height(&navigator), 80.0);
    }
}

#[test]
fn the_whole_scene_fits_a_picture_of_parallel_rays() {
    for view in [AxisView::Front, AxisView::Left, AxisView::Top] {
        let mut navigator = parallel(3.0);
        navigator.apply(Motion::View(view));
        let (min, max) = BOUNDS;
        let corners = (0..8).map(|corner| {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { max[axis] } else { min[axis] };
            place_of(&navigator, Vec3::new(pick(0), pick(1), pick(2))) / Vec2::new(WIDTH as f32, HEIGHT as f32)
        });
        let furthest = corners.map(|place| (place * 2.0 - 1.0).abs().max_element()).fold(0.0, f32::max);
        assert!((0.9..1.0).contains(&furthest), "{view:?} {furthest}");
    }
}

#[test]
fn a_lens_that_is_not_set_right_changes_nothing_and_one_that_is_can_be_undone() {
    let mut navigator = parallel(10.0);
    let before = navigator.camera().clone();
    assert!(!navigator.apply(Motion::Lens(Lens::Orthographic { view_height: f32::NAN })));
    assert_eq!(*navigator.camera(), before);
    assert!(navigator.apply(Motion::Lens(Lens::Fisheye { fisheye_angle: 200.0 })));
    assert_ne!(*navigator.camera(), before);
    assert!(navigator.undo());
    assert_eq!(*navigator.camera(), before);
}

#[test]
fn zooming_a_panorama_leads_to_what_is_under_the_cursor_also_behind_the_camera() {
    let camera = Camera::look_at(Vec3::new(40.0, 20.0, 25.0), Vec3::new(40.0, 60.0, 25.0));
    let mut navigator = at(camera.with_lens(Lens::Panorama { eye_distance: 0.0 }));
    let cursor = Vec2::new(1.0, HEIGHT as f32 * 0.5);
    let (ray, eye) = (navigator.ray(cursor), navigator.camera().eye);
    assert!(ray.direction.y < -0.9, "{:?}", ray.direction);
    navigator.apply(Motion::Zoom { cursor, distance: Some(20.0), steps: 2.0 });
    let step = navigator.camera().eye - eye;
    assert!(step.normalize().dot(ray.direction) > 0.999, "{step}");
}

#[test]
fn moving_sideways_in_a_wide_picture_keeps_what_is_held_under_the_cursor() {
    let mut random = Random(7);
    for lens in [Lens::Panorama { eye_distance: 0.0 }, Lens::Fisheye { fisheye_angle: 180.0 }] {
        for index in 0..100 {
            let camera = Camera::look_at(Vec3::new(40.0, 20.0, 25.0), Vec3::new(40.0, 60.0, 35.0));
            let mut navigator = at(camera.clone().with_lens(lens));
            let (press, far) = (random.cursor(), 30.0);
            let point = navigator.point_at(press, far);
            let anchor = (index % 2 == 0).then_some(point);
            navigator.apply(Motion::Pan { from: press, to: press + Vec2::X, anchor });
            let step = navigator.camera().eye.distance(camera.eye);
            let most = 0.01 * far.max(camera.eye.distance(camera.target));
            assert!(step < most, "{lens:?} {press}: a pixel led {step} away");
            let to = random.cursor();
            navigator.apply(Motion::Pan { from: press + Vec2::X, to, anchor });
            let seen = (point - navigator.camera().eye).normalize();
            if anchor.is_some() {
                assert!(seen.dot(navigator.ray(to).direction) > 0.99999, "{lens:?} {press} {to}");
            }
        }
    }
}
