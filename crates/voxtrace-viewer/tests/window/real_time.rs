//! Real-time light in the window: it is seen while the view moves and until the film is clean, and the film has nothing of it.

use crate::common::headless::until;
use crate::common::panel::{click, panels};
use crate::common::{in_room, rendered};
use crate::drawing::{device, engine, finished, no_panels, scene, view as large_view};
use crate::losses::Shop;
use egui_kittest::kittest::{NodeT, Queryable};
use std::sync::Arc;
use std::sync::mpsc::Receiver;
use std::time::Duration;
use voxtrace::dynamic::{DynamicScene, Edit};
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::output::{Operator, ToneMap};
use voxtrace::{Camera, Film, Integrator, PackedScene, Progress, Shape, Tracer};
use voxtrace_viewer::engine::{Backend, Engine, Event, Light, Lit, Pause, Quality, RealTimeChoice, Shown, View};
use voxtrace_viewer::gpu::{Layer, Offscreen};
use voxtrace_viewer::input::Input;
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_vulkan::{
    Device, Fault, Picture, Rate, RealTimeFrame, Settings, Statistics, Traversal, Under, VulkanTracer,
};

const ON: Light = Light { real_time: RealTimeChoice::On, is_bare: false };
const BARE: Light = Light { is_bare: true, ..ON };

fn view(samples: u32) -> View {
    View { width: 48, height: 32, ..large_view(samples) }
}

/// The view from a step to the side.
fn aside(step: f32, samples: u32) -> View {
    let camera = Camera::look_at(Vec3::new(70.0, -40.0 + step, 40.0), Vec3::new(18.0, 20.0, 6.0));
    View { camera, ..view(samples) }
}

/// The next picture that is so.
fn picture(engine: &Engine, events: &Receiver<Event>, is_so: impl Fn(&Shown) -> bool) -> Shown {
    loop {
        if let Some(shown) = engine.shown().filter(&is_so) {
            return shown;
        }
        if let Event::Failed(error) = events.recv_timeout(Duration::from_secs(300)).expect("the engine goes on") {
            panic!("{error}");
        }
    }
}

fn film(engine: &Engine, events: &Receiver<Event>, samples: u32) -> Film {
    finished(engine, events, samples);
    let (_, film) = engine.film().recv().unwrap().expect("the picture is whole");
    film
}

/// The film of the picture that a tracer shows, and what a window of its size shows of a picture, linear.
struct Wall {
    target: Offscreen,
    size: (u32, u32),
}

const LINEAR: ToneMap = ToneMap { operator: Operator::Linear, exposure: 0.0 };

impl Wall {
    fn new(device: &Arc<Device>, size: (u32, u32)) -> Self {
        Self { target: Offscreen::new(device, size.0, size.1).unwrap(), size }
    }

    /// Red, green and blue of its pixels, of 255.
    fn seen(&mut self, picture: &Arc<Picture>) -> Vec<f64> {
        let (picture, size) = (Arc::clone(picture), [self.size.0 as f32, self.size.1 as f32]);
        let layer = Layer { picture, corner: [0.0; 2], size, tone_map: LINEAR, beside: None };
        let pixels = self.target.draw(Some(&layer), no_panels()).unwrap();
        pixels.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]].map(f64::from)).collect()
    }
}

fn largest_error(expected: &[f64], seen: &[f64]) -> f64 {
    expected.iter().zip(seen).map(|(expected, seen)| (expected - seen).abs()).fold(0.0, f64::max)
}

fn mean_error(expected: &[f64], seen: &[f64]) -> f64 {
    expected.iter().zip(seen).map(|(expected, seen)| (expected - seen).abs()).sum::<f64>() / expected.len() as f64
}

/// A film of a view, and a tracer that holds it.
fn traced(device: &Arc<Device>, view: &View) -> (VulkanTracer, Film) {
    let mut tracer = VulkanTracer::new(Arc::clone(device), Settings::default()).unwrap();
    tracer.set_scene(&scene()).unwrap();
    tracer.render(&view.frame(), &Progress::default()).unwrap();
    let mut film = Film::new(0, 0, view.frame().region, 0);
    tracer.read(&mut film).unwrap();
    (tracer, film)
}

#[test]
fn real_time_light_that_is_turned_off_while_samples_are_left_out_is_seen_no_more() {
    let Some(device) = device() else { return };
    for other in [Light { real_time: RealTimeChoice::Off, ..ON }, BARE] {
        let (engine, events) = engine(&device, Backend::Device(Settings::default()));
        engine.pause(Pause::Samples);
        engine.set_light(ON);
        engine.set_view(view(4096), false);
        let lit = picture(&engine, &events, |shown| shown.samples == 1 && shown.lit.is_some());
        engine.set_light(other);
        let bare = picture(&engine, &events, |shown| shown.lit.is_none());
        assert_eq!((bare.samples, bare.scale), (1, 1));
        let mut wall = Wall::new(&device, (48, 32));
        let (mut tracer, _) = traced(&device, &view(1));
        let film = Arc::new(Picture::new(&device, 48, 32, false).unwrap());
        tracer.resolve(&film).unwrap();
        assert_eq!(wall.seen(&bare.picture), wall.seen(&film));
        assert_ne!(wall.seen(&lit.picture), wall.seen(&film), "the comparison sees real-time light");
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_film_is_laid_over_a_picture_by_its_weight_and_over_a_coarse_one_that_is_interpolated() {
    let Some(device) = device() else { return };
    let picture = |(width, height)| Arc::new(Picture::new(&device, width, height, false).unwrap());
    let (mut wall, size) = (Wall::new(&device, (48, 32)), (48, 32));
    let (mut tracer, film) = traced(&device, &view(9));
    let (mut other, other_film) = traced(&device, &View { seed: 77, ..aside(6.0, 2) });
    let (below, shown) = (picture(size), picture(size));
    other.resolve(&below).unwrap();
    let mixed = |weight: f32| -> Vec<f64> {
        let pixels = film.pixels.iter().zip(&other_film.pixels);
        let mean = pixels.map(|(film, below)| below.mean().lerp(film.mean(), weight));
        mean.flat_map(|mean| (LINEAR.signal(mean) * 255.0).to_array()).collect()
    };
    for weight in [0.0, 0.25, 0.7, 1.0] {
        tracer.resolve_over(&shown, Some(Under { picture: &below, film_weight: weight })).unwrap();
        let seen = wall.seen(&shown);
        assert!(largest_error(&mixed(weight), &seen) <= 1.0, "{weight}: {}", largest_error(&mixed(weight), &seen));
        assert!(largest_error(&mixed(weight + 0.1), &seen) > 1.0, "the comparison sees weights");
        // With the last samples, which are all there already, it is the same picture.
        let under = Under { picture: &below, film_weight: weight };
        tracer.render_over(&view(9).frame(), &Progress::default(), &shown, Some(under)).unwrap();
        assert_eq!(wall.seen(&shown), seen);
    }
    // A coarse picture is what drawing it by itself shows, nearly: there it is interpolated after the curve.
    let (coarse, fine) = (picture((24, 16)), picture(size));
    let (mut coarser, _) = traced(&device, &View { width: 24, height: 16, ..view(64) });
    coarser.resolve(&coarse).unwrap();
    tracer.resolve_over(&fine, Some(Under { picture: &coarse, film_weight: 0.0 })).unwrap();
    let (alone, laid) = (wall.seen(&coarse), wall.seen(&fine));
    let (error, shifted) = (mean_error(&alone, &laid), mean_error(&alone[3..], &laid));
    assert!(error < 1.0 && shifted > 2.0 * error, "{error}; by a pixel aside {shifted}");
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_view_that_moves_is_seen_in_real_time_light_and_one_that_stands_goes_over_to_the_film_of_a_render() {
    let Some(device) = device() else { return };
    let (engine, events) = engine(&device, Backend::Device(Settings::default()));
    engine.set_light(ON);
    let mut coarsest = 1;
    for step in 0..3 {
        engine.set_view(aside(step as f32, 300), true);
        let moving = picture(&engine, &events, |shown| shown.lit.is_some());
        assert_eq!((moving.samples, moving.step_samples), (0, 0), "the film waits");
        coarsest = coarsest.max(moving.lit.map_or(1, |lit| lit.quality.scale));
    }
    assert_eq!(engine.film().recv().unwrap(), None, "a frame is no film");
    engine.set_view(view(300), false);
    // Of a slow device's coarse frames there is less to lay over: how coarse they were says how much.
    let scale = std::cell::Cell::new(0);
    let clean = picture(&engine, &events, |shown| {
        shown.lit.iter().for_each(|lit| scale.set(lit.quality.scale.max(scale.get())));
        shown.samples > 0 && shown.lit.is_none()
    });
    // Where this thread looks too late for a frame, it was no coarser than those before.
    let scale = if scale.get() > 0 { scale.get() } else { coarsest };
    let least = 256 / (scale * scale);
    assert!(clean.samples >= least, "{} samples, not {least}", clean.samples);
    let expected = rendered(&scene(), &view(300).frame());
    assert_eq!(film(&engine, &events, 300), expected);
    assert_ne!(rendered(&scene(), &view(299).frame()), expected, "the comparison sees a sample");
    // Another size and back, while frames come and after.
    engine.set_view(View { width: 40, ..view(300) }, true);
    picture(&engine, &events, |shown| shown.lit.is_some() && shown.picture.size().0 <= 40);
    engine.set_view(view(300), false);
    assert_eq!(film(&engine, &events, 300), expected);
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn after_a_cut_the_picture_is_nearer_to_the_light_of_many_samples_than_a_sample_of_each_pixel() {
    let Some(device) = device() else { return };
    let (engine, events) = engine(&device, Backend::Device(Settings::default()));
    let mut wall = Wall::new(&device, (48, 32));
    engine.set_light(ON);
    // As fine as the window, however slow the machine is: of a view that stands.
    engine.set_view(aside(-90.0, 4096), false);
    picture(&engine, &events, |shown| shown.lit.is_some());
    engine.set_view(view(4096), false);
    let is_fine = |shown: &Shown| shown.picture.size() == (48, 32);
    let shown = picture(&engine, &events, |shown| {
        let weight = shown.lit.as_ref().map(|lit| lit.film_weight);
        weight == Some(0.0) && is_fine(shown) && shown.samples >= 4
    });
    let seen = wall.seen(&shown.picture);
    drop(engine);
    let of = |samples| -> Vec<f64> {
        let film = rendered(&scene(), &View { seed: 1234, ..view(samples) }.frame());
        film.pixels.iter().flat_map(|pixel| (LINEAR.signal(pixel.mean()) * 255.0).to_array()).collect()
    };
    let (reference, sample) = (of(2048), of(1));
    let square = |picture: &[f64]| -> f64 {
        picture.iter().zip(&reference).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / picture.len() as f64
    };
    let (lit, raw) = (square(&seen), square(&sample));
    assert!(lit < 0.25 * raw, "{lit} and {raw}");
}

#[test]
fn the_film_over_a_frame_becomes_more_and_more_of_the_picture_and_the_bare_one_is_there_at_once() {
    let Some(device) = device() else { return };
    let (engine, events) = engine(&device, Backend::Device(Settings::default()));
    // On a busy machine this thread may look too late, and looks at another view then.
    let mut views = (0..40).map(|step| aside(step as f32, 64));
    let mut becomes_the_picture = |view: View| {
        engine.set_view(view.clone(), true);
        picture(&engine, &events, |shown| shown.lit.is_some() && shown.samples == 0);
        engine.set_view(view, false);
        let mut seen: Vec<(u32, f32)> = Vec::new();
        while seen.last().is_none_or(|&(samples, _)| samples < 64) {
            events.recv_timeout(Duration::from_secs(300)).unwrap();
            let Some(shown) = engine.shown() else { continue };
            seen.push((shown.samples, shown.lit.map_or(1.0, |lit| lit.film_weight)));
        }
        assert!(seen.is_sorted_by(|a, b| a.0 <= b.0 && a.1 <= b.1), "{seen:?}");
        assert_eq!(seen.last(), Some(&(64, 1.0)));
        seen.iter().any(|&(_, weight)| weight > 0.0 && weight < 1.0)
    };
    engine.set_light(ON);
    assert!(views.by_ref().take(20).any(&mut becomes_the_picture), "the film was never a part of the picture");
    engine.set_light(BARE);
    let bare = views.find(|view| {
        engine.set_view(view.clone(), true);
        picture(&engine, &events, |shown| shown.lit.is_some() && shown.samples == 0);
        engine.set_view(view.clone(), false);
        let first = picture(&engine, &events, |shown| shown.samples > 0);
        assert!(first.lit.is_none(), "{} samples", first.samples);
        first.samples < 64
    });
    let bare = bare.expect("a film is seen before it has all its samples");
    assert_eq!(film(&engine, &events, 64), rendered(&scene(), &bare.frame()));
}

#[test]
fn edits_are_seen_in_real_time_light_and_the_film_after_them_is_that_of_the_edited_scene() {
    let Some(device) = device() else { return };
    let packed: Arc<PackedScene> = scene();
    let mut edited = DynamicScene::new((*packed).clone()).unwrap();
    let (engine, events) = engine(&device, Backend::Device(Settings::default()));
    engine.set_scene(Some(Arc::new(edited.scene().clone())));
    engine.set_light(ON);
    engine.set_view(view(20), false);
    film(&engine, &events, 20);
    for radius in [2.0, 3.5] {
        let shape = Shape::Sphere { center: DVec3::new(16.0, 8.0, 4.0), radius };
        edited.edit(0, &Edit::Fill { shape, material: Some(1) }).unwrap();
        engine.follow(Arc::new(edited.take_patch()));
        picture(&engine, &events, |shown| shown.lit.is_some());
    }
    let expected = rendered(&Arc::new(edited.scene().clone()), &view(20).frame());
    assert_eq!(film(&engine, &events, 20), expected);
    assert_ne!(rendered(&packed, &view(20).frame()), expected, "the comparison sees the edits");
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn two_tracers_essay_and_the_processor_show_their_films_alone() {
    let Some(device) = device() else { return };
    let walk = Backend::Device(Settings::default());
    let never_lit = |engine: &Engine, events: &Receiver<Event>, view: &View| {
        engine.set_view(view.clone(), false);
        loop {
            events.recv_timeout(Duration::from_secs(300)).unwrap();
            let Some(shown) = engine.shown() else { continue };
            assert!(shown.lit.is_none() || shown.samples == 0);
            if shown.samples == view.samples {
                return;
            }
        }
    };
    let (engine, events) = engine(&device, walk);
    engine.set_light(ON);
    let essay = View { integrator: Integrator::Essay, ..view(5) };
    never_lit(&engine, &events, &essay);
    engine.set_backend(Backend::Cpu);
    never_lit(&engine, &events, &view(6));
    engine.set_backend(walk);
    engine.compare_with(Some(Backend::Cpu));
    never_lit(&engine, &events, &view(7));
    engine.compare_with(None);
    engine.set_view(view(300), false);
    picture(&engine, &events, |shown| shown.lit.is_some());
    // A device in software has it where somebody wants it alone.
    engine.set_light(Light { real_time: RealTimeChoice::Auto, is_bare: false });
    never_lit(&engine, &events, &view(8));
}

#[test]
fn a_device_that_is_lost_amidst_real_time_light_goes_on_with_it_and_the_film_is_that_of_a_render() {
    let walk = Backend::Device(Settings::default());
    for (function, fault) in [("vkQueueSubmit", Fault::DeviceLost), ("vkQueuePresentKHR", Fault::DeviceLost)] {
        for is_moving in [true, false] {
            let Some(mut shop) = Shop::open(walk) else { return };
            shop.window.engine.set_light(ON);
            let expected = rendered(&crate::common::packed(), &shop.view.frame());
            shop.window.engine.set_view(shop.view.clone(), is_moving);
            shop.show(2);
            shop.window.faults.plant(function, fault);
            until("the loss", || {
                shop.window.is_due = true;
                shop.turn();
                shop.window.moves > 0
            });
            if is_moving {
                until("real-time light", || {
                    shop.turn();
                    shop.window.engine.shown().is_some_and(|shown| shown.lit.is_some())
                });
            }
            shop.window.engine.set_view(shop.view.clone(), false);
            assert_eq!(shop.film(), expected, "{function}");
            assert_eq!((shop.window.failures.clone(), shop.window.messages()), (vec![], vec![]), "{function}");
        }
    }
}

#[test]
fn keys_and_boxes_turn_real_time_light_off_and_on_and_say_why_it_is_not_seen() {
    let mut session = in_room("room.vxt");
    session.render_settings.traversal = Traversal::Walk;
    session.take_commands();
    assert!(session.wants_real_time() && session.no_real_time().is_none());
    let mut input = Input::default();
    let mut press = |session: &mut Session, modifiers| {
        input.set_modifiers(modifiers, session);
        input.key(Key::Letter('R'), true, false, session);
        input.key(Key::Letter('R'), false, false, session);
        input.set_modifiers(Modifiers::NONE, session);
        session.take_commands()
    };
    let light = |real_time, is_bare| Command::SetLight(Light { real_time, is_bare });
    assert_eq!(press(&mut session, Modifiers::NONE), [light(RealTimeChoice::Off, false)]);
    assert_eq!(press(&mut session, Modifiers::SHIFT), [light(RealTimeChoice::Off, true)]);
    assert_eq!(press(&mut session, Modifiers::NONE), [light(RealTimeChoice::Auto, true)]);
    // On a device in software somebody has to want it.
    session.has_hardware = false;
    assert!(!session.wants_real_time());
    assert_eq!(press(&mut session, Modifiers::NONE), [light(RealTimeChoice::On, true)]);
    assert_eq!(press(&mut session, Modifiers::NONE), [light(RealTimeChoice::Off, true)]);

    let mut harness = panels(session, Status::default());
    let name = "real-time light while the view moves";
    click(&mut harness, name);
    assert_eq!(harness.state_mut().take_commands(), [light(RealTimeChoice::On, true)]);
    click(&mut harness, "bare film where it stands");
    assert_eq!(harness.state_mut().take_commands(), [light(RealTimeChoice::On, false)]);
    harness.state_mut().act(Action::NextIntegrator, None);
    harness.run_steps(3);
    assert!(harness.get_by_label(name).accesskit_node().is_disabled(), "essay has another light");
    assert!(harness.state().no_real_time().is_some_and(|reason| reason.contains("essay")));
}

#[test]
fn times_of_passes_rays_and_memory_are_one_key_away_with_panels_or_without() {
    let Some(device) = device() else { return };
    let picture = Arc::new(Picture::new(&device, 8, 8, false).unwrap());
    let frame = RealTimeFrame {
        gpu_ms: 3.5,
        frames: 1,
        passes: vec![("paths", 1.25), ("filter", 0.5), ("filter", 0.25)],
        bytes: 300 << 20,
    };
    let lit = Lit { frame: Arc::new(frame), quality: Quality { scale: 2, rate: Rate::Half }, film_weight: 0.25 };
    let statistics = Statistics { gpu_ms: 2.0, camera_rays: 4000, bounce_rays: 2000, ..Statistics::default() };
    let device = Some((statistics, device.memory()));
    let shown = Shown { picture, samples: 32, scale: 1, step_ms: 4.0, step_samples: 2, device, lit: Some(lit) };
    for has_panels in [true, false] {
        let mut session = in_room("room.vxt");
        session.has_panels = has_panels;
        let mut status = Status::default();
        status.take(Shown { step_samples: 0, ..shown.clone() });
        status.take(shown.clone());
        let mut harness = panels(session, status);
        assert!(harness.query_all_by_label("filter").next().is_none());
        harness.state_mut().act(Action::ToggleTimes, None);
        harness.run_steps(3);
        for text in
            ["paths", "1.250 ms", "filter", "0.750 ms", "real-time light: 3.50 ms", "the film is 25 % of the picture"]
        {
            assert!(harness.query_all_by_label(text).next().is_some(), "{text}");
        }
        assert!(harness.query_all_by_label_contains("3.0 million rays").next().is_some());
        assert!(harness.query_all_by_label_contains("2.00 ms a sample").next().is_some());
        assert!(harness.query_all_by_label("picture as seen").next().is_some(), "memory by name");
        harness.state_mut().act(Action::ToggleTimes, None);
        harness.run_steps(3);
        assert!(harness.query_all_by_label("filter").next().is_none());
    }
}
