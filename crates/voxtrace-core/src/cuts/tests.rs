use super::*;
use glam::IVec3;

#[test]
fn a_span_is_what_closed_forms_say_it_is() {
    let cuts = Cuts::default().slice(0, 2.0, 6.0).unwrap().plane(Vec3::new(0.0, 0.0, 5.0), 50.0).unwrap();
    let inset = 2.0 * MARGIN_MIN;
    let ray = Ray::new(Vec3::new(10.0, 0.0, 4.0), Vec3::new(-2.0, 0.0, 1.0));
    let span = cuts.span(&ray);
    assert_eq!((span.t_in, span.t_out), ((10.0 - 6.0 + inset) / 2.0, (10.0 - 2.0 - inset) / 2.0));
    let hit = |t| Hit { t, instance: 0, voxel: IVec3::ZERO, face: 3 };
    assert_eq!(span.entered(hit(span.t_in)).cut(), Some(1), "the plane x ≤ 6 was added second");
    assert_eq!(span.entered(hit(span.t_in + 0.01)), hit(span.t_in + 0.01));
    // Along a plane, within and beyond it; beyond one and away from it.
    let along = |x: f32| cuts.span(&Ray::new(Vec3::new(x, 0.0, 4.0), Vec3::Y));
    assert_eq!((along(3.0).t_in, along(3.0).t_out), (0.0, f32::INFINITY));
    assert!(along(6.0).t_in > along(6.0).t_out);
    let away = cuts.span(&Ray::new(Vec3::new(6.5, 0.0, 4.0), Vec3::X));
    assert!(away.t_in > away.t_out);
}

#[test]
fn planes_cut_just_before_themselves_and_normals_need_no_length() {
    let plane = Plane::new(Vec3::new(0.0, 3.0, 4.0), 10.0).unwrap();
    assert_eq!((plane.normal(), plane.offset()), (Vec3::new(0.0, 0.6, 0.8), 2.0));
    let cuts = Cuts::default().plane(Vec3::X, 7.0).unwrap();
    assert!(cuts.keeps(Vec3::new(6.99, 5.0, 5.0)));
    assert!(!cuts.keeps(Vec3::new(7.0, 5.0, 5.0)), "a voxel from 7 on is cut away, and its face with it");
    // Far away numbers are coarser, and so is the margin.
    assert!(plane_margin(5e4) > 8.0 * f32::EPSILON * 5e4 / 4.0);
}

#[test]
fn what_is_no_cut_is_refused() {
    let none = Cuts::default();
    assert_eq!(none.clone().plane(Vec3::ZERO, 1.0), Err(CutError::NoPlane));
    assert_eq!(none.clone().plane(Vec3::new(f32::NAN, 0.0, 1.0), 1.0), Err(CutError::NoPlane));
    assert_eq!(none.clone().plane(Vec3::X, f32::INFINITY), Err(CutError::NoPlane));
    assert_eq!(none.clone().plane(Vec3::splat(1e-30), 1e30), Err(CutError::NoPlane));
    assert_eq!(none.clone().slice(3, 0.0, 1.0), Err(CutError::NoPlane));
    assert_eq!(none.clone().slice(1, 4.0, 4.0), Err(CutError::EmptyBox));
    assert_eq!(none.clone().clip_box(Vec3::ZERO, Vec3::new(1.0, -1.0, 1.0)), Err(CutError::EmptyBox));
    let six = none.clip_box(Vec3::ZERO, Vec3::ONE).unwrap();
    let all = six.clone().clip_box(Vec3::ZERO, Vec3::ONE).unwrap();
    assert_eq!((six.planes().len(), all.planes().len()), (6, MAX_PLANES));
    assert_eq!(all.clone().plane(Vec3::X, 1.0), Err(CutError::TooManyPlanes));
    let parts: Vec<(Vec3, f32)> = all.planes().iter().map(|plane| (plane.normal(), plane.offset())).collect();
    assert_eq!(Cuts::from_parts(&parts, false), Ok(all));
    assert_eq!(Cuts::from_parts(&[(Vec3::splat(0.6), 1.0)], false), Err(CutError::NoPlane));
    assert_eq!(Cuts::from_parts(&[(Vec3::X, 1.0); 13], true), Err(CutError::TooManyPlanes));
}

#[test]
fn lights_beyond_a_plane_are_no_lights_unless_the_light_is_that_of_the_whole_scene() {
    let cuts = Cuts::default().plane(Vec3::X, 5.0).unwrap();
    let lamp = |x: f32| Ray { t_max: 1.0, ..Ray::new(Vec3::new(1.0, 0.0, 0.0), Vec3::new(x - 1.0, 0.0, 0.0)) };
    assert!(cuts.admits(&lamp(4.0), true) && !cuts.admits(&lamp(6.0), true) && cuts.admits(&lamp(6.0), false));
    assert!(cuts.admits(&Ray::new(Vec3::ZERO, Vec3::X), true), "the sky");
    let on_voxel = Hit { t: 1.0, instance: 0, voxel: IVec3::ZERO, face: 1 };
    let on_cut = Hit { face: Hit::FIRST_CUT, ..on_voxel };
    assert!(cuts.clips_after(&on_voxel) && cuts.clips_after(&on_cut));
    let whole = cuts.shadows(true);
    assert!(!whole.clips_after(&on_voxel) && whole.clips_after(&on_cut));
}
