//! `cargo bench -p voxtrace-tests --bench device_edits -- church`: what edits of a scene cost until a device may trace the next frame, and what
//! tracing costs while a scene is edited. Medians of nine edits here and there, milliseconds: the edit and its patch on the host, passing it to the
//! tracer, which does not wait for the device, a ray that is cast then, which does, and repairing skip distances afterwards.

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::dynamic::{DynamicScene, Edit};
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::{Film, Frame, Integrator, PackedScene, Progress, Ray, Region, Shape, Tracer, scenes};
use voxtrace_vulkan::{Device, Options, Primitive, Settings, Traversal, VulkanTracer, missing};

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The device's milliseconds for a sample of `path`, the least of a few.
fn sample_ms(tracer: &mut VulkanTracer, frame: &Frame) -> Result<f64, Box<dyn Error>> {
    let mut least = f64::INFINITY;
    for seed in 0..4 {
        let frame = frame.clone().seed(seed).samples(8);
        tracer.render(&frame, &Progress::default())?;
        least = least.min(tracer.statistics().gpu_ms / 8.0);
    }
    Ok(least)
}

/// Milliseconds that something takes.
fn timed<T>(work: impl FnOnce() -> Result<T, Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    let start = Instant::now();
    work()?;
    Ok(start.elapsed().as_secs_f64() * 1e3)
}

fn film_of(tracer: &mut VulkanTracer, frame: &Frame) -> Result<Film, Box<dyn Error>> {
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.render(&frame.clone().samples(2), &Progress::default())?;
    tracer.read(&mut film)?;
    Ok(film)
}

fn measure(
    packed: &PackedScene,
    device: &Arc<Device>,
    (traversal, primitive): (Traversal, Primitive),
) -> Result<(), Box<dyn Error>> {
    let settings = Settings { traversal, primitive, is_exact: true };
    let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
    tracer.set_scene(&Arc::new(packed.clone()))?;
    let camera = packed.cameras.first().cloned().ok_or("the scene has no camera")?;
    let frame = Frame::new(camera, 1980, 1080).integrator(Integrator::Path);
    let before = sample_ms(&mut tracer, &frame)?;
    let mut scene = DynamicScene::new(packed.clone())?;
    let bounds = (packed.grids()[0].min.as_dvec3(), packed.grids()[0].max.as_dvec3());
    let size = bounds.1 - bounds.0;
    // The first patch brings the scene as it is edited.
    let place = |i: u32| {
        let share = DVec3::new(0.31, 0.17, 0.23) * f64::from(i);
        bounds.0 + size * (DVec3::splat(0.1) + 0.8 * (share - share.floor()))
    };
    let edit = |center: DVec3, radius: f64, material| Edit::Fill { shape: Shape::Sphere { center, radius }, material };
    scene.edit(0, &edit(place(0), 3.0, Some(0)))?;
    let start = Instant::now();
    tracer.patch(&scene.take_patch())?;
    println!(
        "{}:{}: taking it to be edited {:.2}",
        traversal.name(),
        primitive.name(),
        start.elapsed().as_secs_f64() * 1e3
    );
    let ray = [Ray::new((bounds.0 + size / 2.0).as_vec3(), Vec3::NEG_Z)];
    let alone: Result<Vec<f64>, _> = (0..9).map(|_| timed(|| Ok(tracer.cast(&ray)?))).collect();
    println!("  one ray: {:.3}", median(alone?));
    let lamp = packed.geometry().emitters().first().map_or(0, |emitter| emitter.material as u16);
    for (name, radius) in [("one voxel", 0.5), ("radius 16", 16.0), ("radius 64", 64.0)] {
        for (what, material) in
            [("filled", Some(0)), ("cleared", None), ("filled with light", Some(lamp)), ("cleared", None)]
        {
            let (mut on_host, mut passed, mut cast, mut repairs) = (vec![], vec![], vec![], vec![]);
            for i in 0..9 {
                let start = Instant::now();
                scene.edit(0, &edit(place(i + 1).floor() + 0.5, radius, material))?;
                let patch = scene.take_patch();
                on_host.push(start.elapsed().as_secs_f64() * 1e3);
                passed.push(timed(|| Ok(tracer.patch(&patch)?))?);
                cast.push(timed(|| Ok(tracer.cast(&ray)?))?);
                repairs.push(timed(|| Ok(scene.repair(usize::MAX)))?);
                tracer.patch(&scene.take_patch())?;
                tracer.cast(&ray)?;
            }
            let (host, passed, cast, repair) = (median(on_host), median(passed), median(cast), median(repairs));
            println!(
                "  {name} {what}: {host:.3} on the host, {passed:.3} passing it on, {cast:.3} a ray then; repairing {repair:.3}"
            );
        }
    }
    let after = sample_ms(&mut tracer, &frame)?;
    let film = film_of(&mut tracer, &frame)?;
    tracer.set_scene(&Arc::new(scene.compact()))?;
    let anew = sample_ms(&mut tracer, &frame)?;
    println!("  a sample of path: {before:.2} before, {after:.2} while it is edited, {anew:.2} packed anew");
    let is_same = film.pixels == film_of(&mut tracer, &frame)?.pixels;
    println!("  the film of the edited scene is {}that of the scene packed anew", if is_same { "" } else { "NOT " });
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let device = Device::open(Options::default(), std::env::var("VOXTRACE_DEVICE").ok().as_deref(), None)?;
    println!("{}", device.info().name);
    for name in if names.is_empty() { vec!["church".into()] } else { names } {
        let scene = scenes::generate(&name, None)?;
        let packed = PackedScene::pack(&scene)?;
        println!("{name}, {} voxels", packed.statistics().voxels);
        for method in [(Traversal::Walk, Primitive::Grid), (Traversal::Pipeline, Primitive::Grid)] {
            if missing(device.info(), method.0).is_none() {
                measure(&packed, &device, method)?;
            }
        }
    }
    Ok(())
}
