//! Motion blur: the film of an exposed frame is the sum of films of the moments of its samples, bit for bit, on every tracer, in whatever parts
//! it was rendered.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use voxtrace::animation::{Animation, Interpolation, Motion, ObjectTrack, PoseKey};
use voxtrace::dynamic::Patch;
use voxtrace::glam::{DQuat, DVec3, Vec3};
use voxtrace::motion::{Moment, Moments, MovingTracer, Shot, share_of_exposure};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Hit, PackedScene, Placement, Progress, Ray, Region, Scene, TraceError, Tracer,
};
use voxtrace_test_support::skip;
use voxtrace_tests::gpu::device;
use voxtrace_tests::moving::moving;
use voxtrace_vulkan::{Device, Fault, Faults, Options, Primitive, Settings, Traversal, VulkanTracer, missing};

const SAMPLES: u32 = 8;

/// A lit scene of thirty things, of which one slides and one turns, as it is at a time; the camera wanders, too.
fn moments() -> (Arc<PackedScene>, Moments) {
    let scene = moving(30, 0);
    let pose = |time: f64, x: f64| PoseKey { time, offset: DVec3::X * x, turn: DQuat::IDENTITY, scale: 1.0 };
    let slide = Motion::keys(DVec3::ZERO, vec![pose(0.0, 0.0), pose(1.0, 12.0)], Interpolation::Linear);
    let spin = Motion::Spin { pivot: DVec3::ZERO, axis: DVec3::new(0.2, 0.1, 1.0), turns_per_second: 0.1 };
    let track =
        |instances: Vec<usize>, motion| ObjectTrack { instances, motions: vec![motion], ..ObjectTrack::default() };
    let animation = Animation {
        objects: vec![track((1..15).collect(), slide), track((15..30).collect(), spin)],
        ..Animation::default()
    };
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let geometry = Arc::clone(packed.geometry());
    let camera = scene.cameras[0].clone();
    let at = move |seconds: f64| {
        let now: Scene = animation.scene_at(&scene, seconds);
        let eye = camera.eye + Vec3::Z * seconds as f32;
        let placement = Placement::of_scene(&geometry, &now)?;
        Ok(Moment { camera: Camera { eye, ..camera.clone() }, placement: Some(placement) })
    };
    (packed, Arc::new(at))
}

fn frame() -> Frame {
    let (_, moments) = moments();
    Frame::new(moments(0.0).unwrap().camera, 24, 14).samples(SAMPLES).seed(5).max_bounces(2)
}

fn shot(exposure: f64) -> Shot {
    Shot { opens: 0.25, exposure, moments: moments().1 }
}

fn read(tracer: &mut dyn Tracer) -> Film {
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    film
}

fn blurred(tracer: Box<dyn Tracer + Send>, shot: Shot, frame: &Frame) -> Film {
    let mut tracer = MovingTracer::new(tracer);
    tracer.set_scene(&moments().0).unwrap();
    tracer.set_shot(shot).unwrap();
    tracer.render(frame, &Progress::default()).unwrap();
    read(&mut tracer)
}

/// The films of all samples, each of a scene packed anew as it is at its time, added up.
fn sum_of_moments(share: impl Fn(u32) -> f64) -> Film {
    let (packed, moments) = moments();
    let mut sum: Option<Film> = None;
    for sample in 0..SAMPLES {
        let Moment { camera, placement } = moments(0.25 + 0.5 * share(sample)).unwrap();
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&Arc::new(packed.with_placement(&placement.unwrap()).unwrap())).unwrap();
        tracer.render(&frame().camera(camera).first_sample(sample).samples(1), &Progress::default()).unwrap();
        let film = read(&mut tracer);
        match &mut sum {
            Some(sum) => sum.merge(&film).unwrap(),
            None => sum = Some(film),
        }
    }
    sum.unwrap()
}

#[test]
fn a_blurred_film_is_the_sum_of_films_at_the_moments_of_its_samples() {
    let film = blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame());
    assert!(film == sum_of_moments(|sample| share_of_exposure(5, sample)));
    // One moment that is a thousandth of the exposure off is seen.
    let off = |sample: u32| share_of_exposure(5, sample) + if sample == 3 { 0.001 } else { 0.0 };
    assert!(film != sum_of_moments(off));
    // Without exposure it is the still picture.
    let still = blurred(Box::new(CpuTracer::new(None)), shot(0.0), &frame());
    assert!(film != still);
}

#[test]
fn a_shot_without_exposure_is_the_scene_at_its_time() {
    let (packed, moments) = moments();
    let Moment { placement, .. } = moments(0.25).unwrap();
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&Arc::new(packed.with_placement(&placement.unwrap()).unwrap())).unwrap();
    tracer.render(&frame(), &Progress::default()).unwrap();
    let still = read(&mut tracer);
    assert!(blurred(Box::new(CpuTracer::new(None)), shot(0.0), &frame()) == still);
    let later = Shot { opens: 0.26, ..shot(0.0) };
    assert!(blurred(Box::new(CpuTracer::new(None)), later, &frame()) != still, "the comparison sees another time");
}

#[test]
fn parts_of_a_blurred_film_are_the_film_in_one_go() {
    let whole = blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame());
    let part = |first: u32, count: u32| {
        blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame().first_sample(first).samples(count))
    };
    let mut merged = part(0, 3);
    merged.merge(&part(3, 5)).unwrap();
    assert!(merged == whole);
    let mut wrong = part(0, 3);
    wrong.merge(&blurred(Box::new(CpuTracer::new(None)), shot(0.6), &frame().first_sample(3).samples(5))).unwrap();
    assert!(wrong != whole, "the comparison sees another shutter");
    // Continued from a film in which some pixels are ahead, as an interrupt leaves it, with more samples.
    let mut tracer = MovingTracer::new(Box::new(CpuTracer::new(None)));
    tracer.set_scene(&moments().0).unwrap();
    tracer.set_shot(shot(0.5)).unwrap();
    let (behind, ahead) = (part(0, 2), part(0, 5));
    let mut uneven = behind.clone();
    uneven.pixels.iter_mut().zip(&ahead.pixels).step_by(3).for_each(|(pixel, ahead)| *pixel = *ahead);
    tracer.resume(&frame(), uneven).unwrap();
    let progress = Progress::default();
    tracer.render(&frame(), &progress).unwrap();
    assert!(read(&mut tracer) == whole);
    let had: u32 = (0..24 * 14).map(|pixel| if pixel % 3 == 0 { 5 } else { 2 }).sum();
    assert_eq!(progress.samples_done(), u64::from(24 * 14 * SAMPLES - had));
}

#[test]
fn aovs_of_a_blurred_film_are_those_of_the_middle_of_the_exposure() {
    let film = blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame().aovs(true));
    let middle = moments().1(0.5).unwrap().camera;
    let still = Shot { opens: 0.5, ..shot(0.0) };
    let still = blurred(Box::new(CpuTracer::new(None)), still, &frame().camera(middle).aovs(true));
    assert!(film.aovs.is_some() && film.aovs == still.aovs);
    let early = blurred(Box::new(CpuTracer::new(None)), shot(0.0), &frame().aovs(true));
    assert!(film.aovs != early.aovs, "the comparison sees another time");
}

#[test]
fn errors_of_moments_and_a_cancelled_render_leave_a_film_that_goes_on() {
    let mut tracer = MovingTracer::new(Box::new(CpuTracer::new(None)));
    tracer.set_scene(&moments().0).unwrap();
    tracer.set_shot(shot(0.5)).unwrap();
    let cancelled = Progress::default();
    cancelled.cancel();
    tracer.render(&frame(), &cancelled).unwrap();
    assert_eq!(read(&mut tracer).sample_range(), (0, 0));
    tracer.render(&frame(), &Progress::default()).unwrap();
    assert!(read(&mut tracer) == blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame()));
    let failing: Moments = Arc::new(|_| Err(TraceError::NoScene));
    assert_eq!(tracer.set_shot(Shot { moments: failing, ..shot(0.5) }).unwrap_err(), TraceError::NoScene);
}

#[test]
fn a_device_blurs_as_the_cpu_does() {
    let Some(device) = device() else { return };
    for traversal in [Traversal::Walk, Traversal::Query] {
        if let Some(reason) = missing(device.info(), traversal) {
            skip(&format!("{} has no {}: {reason}", device.info().name, traversal.name()));
            continue;
        }
        let settings = Settings { traversal, primitive: Primitive::Brick, is_exact: true };
        let tracer = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
        let film = blurred(Box::new(tracer), shot(0.5), &frame());
        assert!(film == sum_of_moments(|sample| share_of_exposure(5, sample)), "{}", traversal.name());
    }
}

/// A tracer that counts how often its film is read and given.
struct Counted {
    tracer: CpuTracer,
    /// Reads, and films that are given.
    counts: Arc<[AtomicU32; 2]>,
}

impl Tracer for Counted {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.tracer.set_scene(scene)
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        self.tracer.set_placement(placement)
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        self.tracer.patch(patch)
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        self.tracer.cast_into(rays, hits)
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        self.tracer.render(frame, progress)
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        self.counts[0].fetch_add(1, Ordering::Relaxed);
        self.tracer.read(film)
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        self.counts[1].fetch_add(1, Ordering::Relaxed);
        self.tracer.resume(frame, film)
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        self.tracer.set_moment(placement, frame)
    }
}

#[test]
fn the_film_stays_where_it_is_from_one_moment_to_the_next() {
    let counts = Arc::new([AtomicU32::new(0), AtomicU32::new(0)]);
    let tracer = Counted { tracer: CpuTracer::new(None), counts: Arc::clone(&counts) };
    let film = blurred(Box::new(tracer), shot(0.5), &frame().samples(64));
    let [reads, given] = [0, 1].map(|which: usize| counts[which].load(Ordering::Relaxed));
    // After 1, 2, 4, … 64 samples, and at the end.
    assert!(reads == 8 && given == 1, "{reads} {given}");
    assert!(film == blurred(Box::new(CpuTracer::new(None)), shot(0.5), &frame().samples(64)));
}

#[test]
fn a_device_that_is_lost_between_moments_ends_with_the_film_of_all_moments() {
    let Some(wanted) = voxtrace_tests::gpu::wanted() else { return };
    let expected = sum_of_moments(|sample| share_of_exposure(5, sample));
    let run = |faults: &Arc<Faults>| {
        let options = Options { faults: Some(Arc::clone(faults)), ..Options::default() };
        let device = Device::open(options, Some(&wanted), None).unwrap();
        let mut tracer = MovingTracer::new(Box::new(VulkanTracer::new(device, Settings::default()).unwrap()));
        tracer.set_scene(&moments().0).unwrap();
        tracer.set_shot(shot(0.5)).unwrap();
        tracer.render(&frame(), &Progress::default()).unwrap();
        (read(&mut tracer), tracer.take_notes())
    };
    let counting = Faults::none();
    assert!(run(&counting).0 == expected);
    let calls = counting.calls();
    let submits: Vec<u64> = (0..calls.len()).filter(|&at| calls[at] == "vkQueueSubmit").map(|at| at as u64).collect();
    // From the first sample on, those of the scene before it are others' business.
    let mut lost = 0;
    for &submit in submits.iter().skip(submits.len() / 4).step_by(submits.len() / 5) {
        let (film, notes) = run(&Faults::at(&[(submit, Fault::DeviceLost)]));
        assert!(film == expected, "lost at call {submit}: {notes:?}");
        lost += usize::from(notes.iter().any(|note| note.contains("lost")));
    }
    assert!(lost > 2, "{lost}");
}

#[test]
fn a_moment_that_does_not_suit_leaves_scene_and_film() {
    let Some(device) = device() else { return };
    let gpu = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    let tracers: [Box<dyn Tracer>; 2] = [Box::new(CpuTracer::new(None)), Box::new(gpu)];
    let (packed, moments) = moments();
    let later = moments(0.5).unwrap().placement.unwrap();
    for mut tracer in tracers {
        tracer.set_scene(&packed).unwrap();
        assert_eq!(tracer.set_moment(Some(&later), &frame()), Err(TraceError::NoFilm));
        tracer.render(&frame(), &Progress::default()).unwrap();
        let film = read(&mut *tracer);
        let smaller = Frame::new(frame().camera, 8, 4);
        assert!(matches!(tracer.set_moment(Some(&later), &smaller), Err(TraceError::BadFrame(_))));
        assert!(read(&mut *tracer) == film);
        // Things are where they were.
        tracer.render(&frame().seed(9), &Progress::default()).unwrap();
        tracer.render(&frame(), &Progress::default()).unwrap();
        assert!(read(&mut *tracer) == film);
        tracer.set_placement(&later).unwrap();
        tracer.render(&frame(), &Progress::default()).unwrap();
        assert!(read(&mut *tracer) != film, "the comparison sees what moved");
    }
}

#[test]
fn a_film_that_begins_after_one_of_many_moments_is_mended_after_a_loss() {
    let Some(wanted) = voxtrace_tests::gpu::wanted() else { return };
    let (packed, moments) = moments();
    let later = moments(0.5).unwrap().placement.unwrap();
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&wanted), None).unwrap();
    let mut tracer = VulkanTracer::new(device, Settings::default()).unwrap();
    tracer.set_scene(&packed).unwrap();
    tracer.render(&frame().samples(1), &Progress::default()).unwrap();
    tracer.set_moment(Some(&later), &frame().samples(2)).unwrap();
    tracer.render(&frame().samples(2), &Progress::default()).unwrap();
    let other = frame().seed(9);
    tracer.render(&other.clone().samples(2), &Progress::default()).unwrap();
    faults.plant("vkQueueSubmit", Fault::DeviceLost);
    tracer.render(&other, &Progress::default()).unwrap();
    assert_eq!(faults.fired(), [("vkQueueSubmit", Fault::DeviceLost)]);
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&Arc::new(packed.with_placement(&later).unwrap())).unwrap();
    cpu.render(&other, &Progress::default()).unwrap();
    assert!(read(&mut tracer) == read(&mut cpu));
    // One that goes on has samples that cannot be made again.
    tracer.set_moment(Some(packed.placement()), &other.clone().samples(SAMPLES + 1)).unwrap();
    faults.plant("vkQueueSubmit", Fault::DeviceLost);
    let lost = tracer.render(&other.samples(SAMPLES + 1), &Progress::default());
    assert!(matches!(lost, Err(TraceError::DeviceLost { .. })), "{lost:?}");
}
