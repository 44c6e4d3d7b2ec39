//! Paths in waves: films and counts of rays are those of one shader that follows each path, bit for bit, however many paths are traced at once.

use crate::cuts::{cut, plane, things};
use std::sync::Arc;
use voxtrace::glam::Vec3;
use voxtrace::{
    BounceLimits, Camera, CpuTracer, Film, Frame, Integrator, LightGroup, PackedScene, Progress, Region, TraceError,
    Tracer,
};
use voxtrace_realtime::{Parts, Rate};
use voxtrace_tests::gpu::{assert_valid, device, film, wanted};
use voxtrace_vulkan::{Device, Fault, Faults, Options, Picture, Settings, VulkanTracer};

fn view() -> Frame {
    let camera = Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0));
    Frame::new(camera, 37, 29).samples(5).max_bounces(8)
}

/// A tracer of a scene that traces at most so many paths at once, 0: by one shader.
fn tracer(device: &Arc<Device>, scene: &Arc<PackedScene>, most_paths: u32) -> VulkanTracer {
    let mut tracer = VulkanTracer::new(Arc::clone(device), Settings::default()).unwrap().with_most_paths(most_paths);
    tracer.set_scene(scene).unwrap();
    tracer
}

/// Whether memory is held for paths under way.
fn holds_paths(tracer: &VulkanTracer) -> bool {
    let entries = tracer.memory().entries;
    let has = |name: &str| entries.iter().any(|(other, bytes)| other == name && *bytes > 0);
    assert_eq!(has("paths"), has("queues of paths"));
    has("paths")
}

fn one_grid() -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(&things(true, false)).unwrap())
}

/// Compares films and counts of rays with those of the processor, however many paths are traced at once.
fn compare(device: &Arc<Device>, name: &str, scene: &Arc<PackedScene>, frames: &[(&str, Frame)], sizes: &[u32]) {
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(scene).unwrap();
    let mut gpu = tracer(device, scene, 0);
    for &size in sizes {
        gpu = gpu.with_most_paths(size);
        for (what, frame) in frames {
            let expected = film(&mut cpu, frame);
            let counts = cpu.ray_counts();
            let ours = film(&mut gpu, frame);
            assert!(ours.pixels == expected.pixels, "{name}, {what}, {size} paths at once");
            assert!(holds_paths(&gpu), "{name}, {what}");
            let theirs = gpu.statistics();
            let theirs = [theirs.camera_rays, theirs.bounce_rays, theirs.shadow_rays];
            assert_eq!(theirs, [counts.camera, counts.bounce, counts.light], "{name}, {what}");
        }
    }
    // A planted fault: fewer bounces.
    let other = frames[0].1.clone().max_bounces(2);
    assert!(film(&mut gpu, &other).pixels != film(&mut cpu, &frames[0].1).pixels, "{name}");
}

#[test]
fn films_in_waves_are_those_of_the_processor() {
    let Some(device) = device() else { return };
    let turned = Arc::new(PackedScene::pack(&things(true, true)).unwrap());
    let crop = Region { x0: 3, y0: 5, x1: 30, y1: 21 };
    let frames = [
        ("all of it", view()),
        ("no bounce", view().max_bounces(0)),
        ("a part, without background", view().region(crop).transparent(true)),
        ("the light of lamps", view().light_group(LightGroup::Emitters)),
    ];
    for (name, scene) in [("one grid", one_grid()), ("turned instances", turned)] {
        // All paths at once, some samples at once, some pixels at once.
        compare(&device, name, &scene, &frames, &[1 << 20, 2500, 700]);
    }
    assert_valid(&device);
}

#[test]
fn films_in_waves_of_glass_metal_and_clouds_are_those_of_the_processor() {
    let Some(device) = device() else { return };
    let mut within = view();
    within.camera = Camera::look_at(Vec3::new(-4.1, -3.6, 3.2), Vec3::new(4.0, 4.0, 2.0));
    let limits = BounceLimits { transmitted: 2, ..BounceLimits::default() };
    let frames = [
        ("all of it", view()),
        ("light that passes glass straight", view().clear_shadows(true)),
        ("limits", view().bounce_limits(limits).clamp_indirect(1.5)),
        ("from within", within),
    ];
    // A cut asks for all that waves know, and programs take a software device a minute to compile.
    let scene = cut(&things(false, true), &plane([0.0, -1.0, 0.0], 4.0));
    compare(&device, "cut", &scene, &frames, &[1500]);
    assert_valid(&device);
}

#[test]
fn a_film_whose_pixels_have_more_and_less_samples_goes_on_in_waves() {
    let Some(device) = device() else { return };
    let scene = one_grid();
    let mut one = tracer(&device, &scene, 0);
    let mut uneven = film(&mut one, &view().samples(2));
    let ahead = film(&mut one, &view().samples(4));
    let whole = film(&mut one, &view());
    assert!(!holds_paths(&one));
    let rest: Vec<usize> = (0..uneven.pixels.len()).filter(|index| index % 3 == 0).collect();
    rest.iter().for_each(|&index| uneven.pixels[index] = ahead.pixels[index]);
    let mut waves = tracer(&device, &scene, 1500);
    waves.resume(&view(), uneven).unwrap();
    assert!(film(&mut waves, &view()) == whole);
    assert!(holds_paths(&waves));
    assert_valid(&device);
}

#[test]
fn waves_make_room_and_give_way_to_one_shader() {
    let Some(device) = device() else { return };
    let scene = one_grid();
    let mut roomy = tracer(&device, &scene, 1 << 20);
    let whole = film(&mut roomy, &view());
    assert!(holds_paths(&roomy));
    // What waves do not know is for one shader, and their memory is free.
    film(&mut roomy, &view().integrator(Integrator::Essay));
    assert!(!holds_paths(&roomy));
    // Where there is little memory they take what they may.
    let (mut sizes, mut films) = (Vec::new(), Vec::new());
    for budget in [400 << 10, 1 << 20] {
        let Some(wanted) = wanted() else { return };
        let options = Options { validation: true, ..Options::default() };
        let open = |budget| Device::open(options.clone(), Some(&wanted), budget).unwrap();
        let idle = tracer(&open(None), &scene, 1 << 20).memory().total_bytes();
        let film_bytes = 32 * whole.pixels.len() as u64;
        let mut tight = tracer(&open(Some(idle + film_bytes + budget)), &scene, 1 << 20);
        films.push(film(&mut tight, &view()));
        let of_paths = tight.memory().entries.iter().find(|(name, _)| *name == "paths").map_or(0, |(_, bytes)| *bytes);
        assert!(of_paths <= budget / 3, "{of_paths} of {budget}");
        sizes.push(of_paths);
        // They make room for a larger film that is given.
        let bytes = tight.device().available_bytes() + film_bytes + of_paths / 2;
        let (width, height) = (64, (bytes / (32 * 64)) as u32);
        let larger = Frame::new(view().camera, width, height);
        tight.resume(&larger, Film::new(width, height, Region::full(width, height), 0)).unwrap();
        assert!(!holds_paths(&tight));
    }
    assert!(0 < sizes[0] && sizes[0] < sizes[1], "{sizes:?}");
    assert!(films.iter().all(|film| *film == whole));
    assert_valid(&device);
}

#[test]
fn where_the_driver_has_no_memory_for_waves_one_shader_renders() {
    let Some(wanted) = wanted() else { return };
    let scene = one_grid();
    let render = |faults: &Arc<Faults>| {
        let options = Options { faults: Some(Arc::clone(faults)), validation: true, ..Options::default() };
        let device = Device::open(options, Some(&wanted), None).unwrap();
        let mut tracer = tracer(&device, &scene, 1 << 20);
        // So many paths have an allocation of their own.
        let film = film(&mut tracer, &view().samples(12));
        assert_valid(&device);
        (film, holds_paths(&tracer))
    };
    let counting = Faults::none();
    let (expected, has_waves) = render(&counting);
    assert!(has_waves);
    // Paths are what is allocated last.
    let last = counting.calls().iter().rposition(|call| *call == "vkAllocateMemory").unwrap();
    let faults = Faults::at(&[(last as u64, Fault::OutOfDeviceMemory)]);
    let (ours, has_waves) = render(&faults);
    assert_eq!(faults.fired(), [("vkAllocateMemory", Fault::OutOfDeviceMemory)]);
    assert!(!has_waves && ours == expected);
}

#[test]
fn a_wave_that_lacks_a_step_is_noticed() {
    let Some(device) = device() else { return };
    let scene = one_grid();
    let render = |step: Option<&'static str>| -> Result<Film, TraceError> {
        let mut tracer = tracer(&device, &scene, 1 << 20);
        step.into_iter().for_each(|step| tracer.leave_out(step));
        tracer.render(&view(), &Progress::default())?;
        let mut film = Film::new(1, 1, Region::full(1, 1), 0);
        tracer.read(&mut film)?;
        Ok(film)
    };
    let whole = render(None).unwrap();
    for step in ["wave_begin", "wave_shade", "wave_lit", "wave_finish", "wave_end"] {
        let error = render(Some(step)).expect_err(step);
        assert!(error.to_string().contains("did not do the work"), "{step}: {error}");
    }
    // Every path came to its end, but not where it should.
    assert!(render(Some("wave_walk")).unwrap() != whole);
    assert_valid(&device);
}

#[test]
fn waves_of_films_make_room_for_real_time_light() {
    let Some(wanted) = wanted() else { return };
    let scene = one_grid();
    // Returns the bytes at the end, and those of paths of the film that are still there.
    let show = |budget: Option<u64>| {
        let options = Options { validation: true, ..Options::default() };
        let device = Device::open(options, Some(&wanted), budget).unwrap();
        let mut tracer = tracer(&device, &scene, 1 << 20);
        tracer.set_real_time(Parts::NONE, false);
        film(&mut tracer, &view());
        assert!(holds_paths(&tracer));
        let picture = Picture::new(&device, view().width, view().height, false).unwrap();
        tracer.show_real_time(&view(), Rate::Full, &picture).unwrap();
        assert_valid(&device);
        let report = tracer.memory();
        (report.total_bytes(), report.bytes("paths") + report.bytes("queues of paths"))
    };
    let (bytes, of_paths) = show(None);
    assert!(of_paths > 0);
    assert_eq!(show(Some(bytes - of_paths / 2)), (bytes - of_paths, 0));
}
