//! What traces follows edits: films after them are those of the scene that is saved, whatever traces, and whatever happens between.

use crate::common::headless::until;
use crate::common::{packed, rendered};
use crate::drawing::{device, engine, finished, view as large_view};
use crate::losses::Shop;
use std::sync::Arc;
use std::sync::mpsc::Receiver;
use voxtrace::dynamic::{DynamicScene, Edit};
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::{PackedScene, Shape};
use voxtrace_viewer::engine::{Backend, Engine, Event, View};
use voxtrace_vulkan::{Fault, Primitive, Settings, Traversal};

fn view(samples: u32) -> View {
    View { width: 48, height: 32, ..large_view(samples) }
}

/// A ball.
fn ball(center: [f64; 3], radius: f64, material: Option<u16>) -> Edit {
    Edit::Fill { shape: Shape::Sphere { center: DVec3::from_array(center), radius }, material }
}

/// Edits a scene, and has it followed.
fn edit(scene: &mut DynamicScene, engine: &Engine, edit: &Edit) {
    scene.edit(0, edit).unwrap();
    engine.follow(Arc::new(scene.take_patch()));
}

/// The scene from a file that was saved of it.
fn saved(scene: &DynamicScene) -> Arc<PackedScene> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("edited.vxt");
    scene.scene().save(&path).unwrap();
    Arc::new(PackedScene::open(&path).unwrap())
}

fn film(engine: &Engine, events: &Receiver<Event>, side: usize, view: &View) -> voxtrace::Film {
    engine.set_view(view.clone(), false);
    loop {
        finished(engine, events, view.samples);
        if let Some((_, film)) = engine.film_of(side).recv().unwrap()
            && film.sample_range().0 == view.samples
        {
            return film;
        }
    }
}

#[test]
fn films_after_edits_are_those_of_the_saved_scene_whatever_traces() {
    let Some(device) = device() else { return };
    let of_device = |traversal, primitive| Backend::Device(Settings { traversal, primitive, is_exact: true });
    let backends = [
        Backend::Cpu,
        of_device(Traversal::Walk, Primitive::Brick),
        of_device(Traversal::Query, Primitive::Grid),
        of_device(Traversal::Pipeline, Primitive::Grid),
    ];
    let (engine, events) = engine(&device, Backend::Cpu);
    let scene = packed();
    let mut dynamic = DynamicScene::new((*scene).clone()).unwrap();
    engine.set_scene(Some(scene));
    let mut at = 2.0;
    for backend in backends {
        engine.set_backend(backend);
        engine.set_view(view(3), false);
        finished(&engine, &events, 3);
        // While a film is made, also beyond the bounds of the model.
        at += 3.0;
        edit(&mut dynamic, &engine, &ball([at, at, 4.0], 4.5, Some(1)));
        edit(&mut dynamic, &engine, &ball([at + 20.0, 3.0, 14.0], 3.0, Some(0)));
        edit(&mut dynamic, &engine, &ball([at + 2.0, at, 6.0], 3.0, None));
        let expected = rendered(&saved(&dynamic), &view(4).frame());
        assert_eq!(film(&engine, &events, 0, &view(4)), expected, "{backend:?}");
        assert_ne!(rendered(&packed(), &view(4).frame()), expected, "the comparison sees edits");
        if matches!(backend, Backend::Device(settings) if settings.traversal != Traversal::Walk) {
            continue;
        }
        // Undone, and done again.
        dynamic.undo().unwrap();
        engine.follow(Arc::new(dynamic.take_patch()));
        let before = rendered(&saved(&dynamic), &view(4).frame());
        assert_eq!(film(&engine, &events, 0, &view(4)), before, "{backend:?}");
        assert_ne!(before, expected);
        dynamic.redo().unwrap();
        engine.follow(Arc::new(dynamic.take_patch()));
        assert_eq!(film(&engine, &events, 0, &view(4)), expected, "{backend:?}");
        // In another light, which needs no upload, and then one voxel more.
        let mut lit = dynamic.scene().clone();
        lit.light_intensity = 0.5;
        lit.sky.set_brightness(0.25);
        engine.set_scene(Some(Arc::new(lit.clone())));
        edit(&mut dynamic, &engine, &ball([1.5, 1.5, 2.5], 0.5, Some(1)));
        let mut expected = (*saved(&dynamic)).clone();
        (expected.sky, expected.light_intensity) = (lit.sky, lit.light_intensity);
        assert_eq!(film(&engine, &events, 0, &view(4)), rendered(&Arc::new(expected), &view(4).frame()), "{backend:?}");
        engine.set_scene(Some(Arc::new(dynamic.scene().clone())));
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn both_sides_of_a_comparison_follow_edits_and_so_does_a_tracer_that_comes_later() {
    let Some(device) = device() else { return };
    let walk = Backend::Device(Settings { traversal: Traversal::Walk, primitive: Primitive::Brick, is_exact: true });
    let (engine, events) = engine(&device, walk);
    let scene = packed();
    let mut dynamic = DynamicScene::new((*scene).clone()).unwrap();
    engine.set_scene(Some(scene));
    // Before anything is traced, too.
    edit(&mut dynamic, &engine, &ball([5.0, 5.0, 3.0], 3.0, Some(1)));
    film(&engine, &events, 0, &view(2));
    edit(&mut dynamic, &engine, &ball([15.0, 5.0, 3.0], 3.0, Some(0)));
    engine.compare_with(Some(Backend::Cpu));
    let expected = rendered(&saved(&dynamic), &view(4).frame());
    for side in [0, 1] {
        assert_eq!(film(&engine, &events, side, &view(4)), expected, "{side}");
    }
    edit(&mut dynamic, &engine, &ball([20.0, 20.0, 9.0], 6.0, Some(1)));
    let expected = rendered(&saved(&dynamic), &view(5).frame());
    for side in [0, 1] {
        assert_eq!(film(&engine, &events, side, &view(5)), expected, "{side}");
    }
    // The first one's means change.
    engine.set_backend(Backend::Cpu);
    engine.compare_with(Some(walk));
    for side in [0, 1] {
        assert_eq!(film(&engine, &events, side, &view(5)), expected, "{side}");
    }
    let other = View { width: 50, height: 40, ..view(3) };
    assert_eq!(film(&engine, &events, 0, &other), rendered(&saved(&dynamic), &other.frame()), "of another size");
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_device_that_is_lost_after_edits_comes_back_with_them() {
    let walk = crate::losses::backends()[1];
    let Some(mut shop) = Shop::open(walk) else { return };
    shop.show(1);
    let mut dynamic = DynamicScene::new((*packed()).clone()).unwrap();
    edit(&mut dynamic, &shop.window.engine, &ball([6.0, 6.0, 3.0], 4.0, Some(1)));
    let expected = rendered(&saved(&dynamic), &shop.view.frame());
    assert_eq!(shop.film(), expected);
    // Lost while it is traced, and while a patch is taken.
    shop.window.faults.plant("vkQueueSubmit", Fault::DeviceLost);
    edit(&mut dynamic, &shop.window.engine, &ball([18.0, 6.0, 3.0], 4.0, None));
    until("the loss", || {
        shop.window.is_due = true;
        shop.turn();
        !shop.window.faults.fired().is_empty() && shop.window.moves > 0
    });
    edit(&mut dynamic, &shop.window.engine, &ball([18.0, 18.0, 3.0], 4.0, Some(0)));
    let after = rendered(&saved(&dynamic), &shop.view.frame());
    assert_ne!(after, expected);
    assert_eq!(shop.film(), after);
    assert_eq!((shop.window.messages(), shop.window.failures.clone()), (Vec::new(), Vec::new()));
    assert_eq!(dynamic.voxel(0, IVec3::new(6, 6, 3)), Some(1));
}
