//! The Vulkan device that tests run on, and scenes and rays to compare tracers with.

use crate::random::Random;
use crate::rays::mixed;
use crate::scenes::{dust, hollow_sphere, noise};
use std::sync::Arc;
use std::{panic, thread};
use voxtrace::glam::{EulerRot, IVec3, Mat3, Vec3};
use voxtrace::{
    Film, Frame, Hit, Material, PackedScene, Progress, Ray, Region, Scene, Tracer, Transform, VoxelGrid, scenes,
};
use voxtrace_test_support::{Alone, Need, skip, skip_without};
use voxtrace_vulkan::{Device, DeviceKind, Options, Primitive, Settings, Traversal, VulkanTracer, devices, missing};

/// The device that `VOXTRACE_DEVICE` names, else the first one (software devices included), with the validation layer on. Without a
/// device the caller's test is skipped, or fails where `VOXTRACE_REQUIRE_VULKAN=1`.
pub fn device() -> Option<Alone<Arc<Device>>> {
    let options = Options { validation: true, ..Options::default() };
    let open = |wanted: String| match Device::open(options, Some(&wanted), None) {
        Ok(device) => Some(device),
        Err(error) => lacking(&error.to_string()),
    };
    wanted()?.map(open).some()
}

/// The name or number of the device that tests run on, for those that open it themselves; as [`device`] where there is none.
pub fn wanted() -> Option<Alone<String>> {
    Alone::new(first_or_named).some()
}

fn first_or_named() -> Option<String> {
    let found = match devices(Options::default()) {
        Ok(found) => found,
        Err(error) => return lacking(&error.to_string()),
    };
    let first = found.first().map(|info| info.index.to_string());
    std::env::var("VOXTRACE_DEVICE").ok().or(first).or_else(|| lacking("none is listed"))
}

fn lacking<T>(reason: &str) -> Option<T> {
    skip_without(Need::Vulkan, &format!("no Vulkan device: {reason}"));
    None
}

/// An exact tracer of a device with a scene, `None` where the device lacks the traversal: the test is skipped in part.
pub fn tracer_of(
    device: &Arc<Device>,
    traversal: Traversal,
    primitive: Primitive,
    scene: &Arc<PackedScene>,
) -> Option<VulkanTracer> {
    if let Some(reason) = missing(device.info(), traversal) {
        skip(&format!("{} has no {}: {reason}", device.info().name, traversal.name()));
        return None;
    }
    let settings = Settings { traversal, primitive, is_exact: true };
    let mut tracer = VulkanTracer::new(Arc::clone(device), settings).unwrap();
    tracer.set_scene(scene).unwrap();
    Some(tracer)
}

/// Runs a check of each exact tracer that the device has, side by side: a software device compiles a module for half a minute, on the
/// thread that asks for it.
pub fn for_each_tracer(
    device: &Arc<Device>,
    methods: &[(Traversal, Primitive)],
    scene: &Arc<PackedScene>,
    check: impl Fn(&mut VulkanTracer, Traversal, Primitive) + Sync,
) {
    let check_one = |&(traversal, primitive): &(Traversal, Primitive)| {
        if let Some(mut tracer) = tracer_of(device, traversal, primitive, scene) {
            check(&mut tracer, traversal, primitive);
        }
    };
    thread::scope(|scope| {
        let threads: Vec<_> = methods.iter().map(|method| scope.spawn(|| check_one(method))).collect();
        for thread in threads {
            // A failed check keeps its message.
            thread.join().unwrap_or_else(|panic| panic::resume_unwind(panic));
        }
    });
}

/// A traversal, and what its acceleration structures are made of.
pub type Method = (Traversal, Primitive);

/// Every traversal with every primitive whose hits are exact.
pub fn exact_methods() -> Vec<Method> {
    let primitives = [Primitive::Brick, Primitive::Triangle, Primitive::VoxelExact, Primitive::Grid];
    let with = |traversal| primitives.map(|primitive| (traversal, primitive));
    let walk = [(Traversal::Walk, Primitive::Brick)];
    walk.into_iter().chain(with(Traversal::Query)).chain(with(Traversal::Pipeline)).collect()
}

/// The methods by which films are compared on a device: all that are exact, and of a software device, which compiles shaders with materials for half a
/// minute, the `few`.
pub fn film_methods(device: &Device, few: &[Method]) -> Vec<Method> {
    if device.info().kind == DeviceKind::Cpu { few.to_vec() } else { exact_methods() }
}

/// A method for each traversal.
pub const ONE_OF_EACH: [Method; 3] = [
    (Traversal::Walk, Primitive::Brick),
    (Traversal::Query, Primitive::Brick),
    (Traversal::Pipeline, Primitive::Triangle),
];

/// The film that a tracer, which has a scene, makes of a frame.
pub fn film(tracer: &mut dyn Tracer, frame: &Frame) -> Film {
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    film
}

/// Fails if the validation layer reported anything.
pub fn assert_valid(device: &Device) {
    let messages = device.vulkan().messages();
    assert_eq!(messages.count(), 0, "validation messages: {:#?}", messages.first());
}

/// A scene with a set of difficult rays.
pub struct Case {
    /// Name for messages.
    pub name: &'static str,
    /// The scene.
    pub scene: Arc<PackedScene>,
    /// Rays in world space.
    pub rays: Vec<Ray>,
}

/// Five scenes with `count` rays each.
pub fn cases(count: usize) -> Vec<Case> {
    vec![
        single("noise", noise(IVec3::new(-13, 5, 100), 40, 0.02, 300, 1), count),
        single("hollow sphere", hollow_sphere(30), count),
        single("dust", dust(3000, 60, 7), count),
        placed(count),
        city(count),
    ]
}

fn single(name: &'static str, grid: VoxelGrid, count: usize) -> Case {
    let rays = mixed(&grid, count, 11);
    Case { name, scene: pack(Scene::from_grid(name, grid.clone(), materials(&grid))), rays }
}

/// Turned, mirrored, scaled and overlapping instances of two grids.
fn placed(count: usize) -> Case {
    let grids = [noise(IVec3::splat(-9), 18, 0.1, 40, 3), hollow_sphere(7)];
    let mut scene = Scene { materials: materials(&grids[0]), ..Scene::new("placed") };
    scene.grids = grids.iter().cloned().map(Arc::new).collect();
    let mut random = Random(5);
    for index in 0..24 {
        let quarter = Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z);
        let turned = Mat3::from_euler(EulerRot::XYZ, random.unit() * 6.0, random.unit() * 6.0, random.unit() * 6.0);
        let linear = match index % 6 {
            0 => Mat3::IDENTITY,
            1 => quarter,
            2 => Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0)),
            3 => turned,
            4 => turned * Mat3::from_diagonal(Vec3::new(1.0, 1.0, -1.0)) * 0.37,
            _ => quarter * quarter * 2.0,
        };
        let translation = random.point(Vec3::splat(-40.0), Vec3::splat(40.0));
        // Every other one at whole coordinates, where faces of instances coincide.
        let translation = if index % 2 == 0 { translation.round() } else { translation };
        scene.instances.push(voxtrace::Instance::new(index % 2, Transform { linear, translation }));
    }
    // Two in the same place: of equal hits that of the lower instance must win.
    let twin = scene.instances[3].clone();
    scene.instances.push(twin);
    let mut rays = Vec::with_capacity(count);
    let sets: Vec<Vec<Ray>> = grids.iter().map(|grid| mixed(grid, count / scene.instances.len() + 1, 13)).collect();
    for index in 0..count {
        let instance = &scene.instances[index % scene.instances.len()];
        let ray = sets[instance.grid][index / scene.instances.len()];
        let place = &instance.world_from_grid;
        rays.push(Ray { origin: place.point(ray.origin), direction: place.direction(ray.direction), ..ray });
    }
    Case { name: "placed", scene: pack(scene), rays }
}

/// A built-in scene, seen by random rays, some of them clipped.
fn city(count: usize) -> Case {
    let scene = scenes::generate("city", Some(150_000)).expect("the scene is built in");
    let bounds = scene.grids[0].bounds().expect("the city holds voxels");
    let (min, max) = (bounds.min.as_vec3(), bounds.max.as_vec3());
    let mut random = Random(17);
    let rays = (0..count)
        .map(|index| {
            let ray = Ray::new(random.point(min - 10.0, max + 10.0), random.direction());
            match index % 4 {
                0 => Ray { t_min: random.unit() * 50.0, ..ray },
                1 => Ray { t_max: random.unit() * 50.0, ..ray },
                _ => ray,
            }
        })
        .collect();
    Case { name: "city", scene: pack(scene), rays }
}

fn materials(grid: &VoxelGrid) -> Vec<Material> {
    let largest = grid.voxels().map(|(_, material)| material).max().unwrap_or(0);
    vec![Material::default(); usize::from(largest) + 1]
}

fn pack(scene: Scene) -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(&scene).expect("the scene is sound"))
}

/// Compares hits exactly (t may be 0 or −0); describes the first difference.
pub fn compare_hits(rays: &[Ray], hits: &[Hit], expected: &[Hit]) -> Result<(), String> {
    let differing: Vec<usize> = (0..rays.len()).filter(|&i| hits[i] != expected[i]).collect();
    match differing.first() {
        None => Ok(()),
        Some(&i) => Err(format!(
            "{} of {} rays differ; ray {i}: {:?}\n got {:?}\n not {:?}",
            differing.len(),
            rays.len(),
            rays[i],
            hits[i],
            expected[i]
        )),
    }
}
