//! Real-time light on devices: its paths have the bits of the processor's, and its pictures are those of the processor as far as half floats allow.

use crate::cuts::things;
use std::sync::Arc;
use voxtrace::glam::{IVec3, UVec2, Vec3};
use voxtrace::lines::{Line, Lines};
use voxtrace::{
    Camera, DynamicScene, Edit, Frame, Instance, Material, PackedScene, Placement, Scene, Shape, TraceError, Tracer,
    Transform, VoxelGrid,
};
use voxtrace_core::packed::PackedInstance;
use voxtrace_realtime::{Parts, Rate, RealTime, Sample};
use voxtrace_tests::gpu::{assert_valid, device};
use voxtrace_vulkan::{Device, Picture, Settings, VulkanTracer};

const SIZE: UVec2 = UVec2::new(61, 43);

fn view() -> Frame {
    let camera = Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0));
    Frame::new(camera, SIZE.x, SIZE.y).max_bounces(5).seed(7)
}

fn packed(is_matte: bool, turns: bool) -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(&things(is_matte, turns)).unwrap())
}

/// Both sides: the processor's, and a device's.
struct Both {
    scene: Arc<PackedScene>,
    cpu: RealTime,
    gpu: VulkanTracer,
    picture: Picture,
    rate: Rate,
    /// Names of the steps of the device's last frame; empty where it tells no times.
    steps: Vec<&'static str>,
}

impl Both {
    /// A device's traces by one shader that follows each path.
    fn new(device: &Arc<Device>, scene: &Arc<PackedScene>, parts: Parts) -> Self {
        Self::with_most_paths(device, scene, parts, 0)
    }

    /// A device's traces in waves, which paths leave that meet other than matte things, for waves of few paths.
    fn in_waves(device: &Arc<Device>, scene: &Arc<PackedScene>, parts: Parts) -> Self {
        Self::with_most_paths(device, scene, parts, 200)
    }

    fn with_most_paths(device: &Arc<Device>, scene: &Arc<PackedScene>, parts: Parts, most_paths: u32) -> Self {
        let gpu = VulkanTracer::new(Arc::clone(device), Settings::default()).unwrap();
        let mut gpu = gpu.with_most_paths(most_paths);
        gpu.set_real_time(parts, true);
        gpu.set_scene(scene).unwrap();
        let picture = Picture::new(device, SIZE.x, SIZE.y, true).unwrap();
        Self { scene: Arc::clone(scene), cpu: RealTime::new(parts), gpu, picture, rate: Rate::Full, steps: Vec::new() }
    }

    /// Another frame. Returns both pictures, the processor's first.
    fn frame(&mut self, frame: &Frame) -> [Vec<Vec3>; 2] {
        let expected = self.cpu.frame(&self.scene, frame);
        let shown = self.gpu.show_real_time(frame, self.rate, &self.picture).unwrap().expect("a device traces");
        self.steps = shown.passes.iter().map(|(step, _)| *step).collect();
        [expected, self.picture.radiance().into_iter().map(Vec3::from).collect()]
    }

    /// Whether the device's last frame had a step, if it says so.
    fn had(&self, step: &str) -> bool {
        self.steps.is_empty() || self.steps.contains(&step)
    }

    /// The samples that the device's last frame found, in a row for each pixel: light, direct, albedo, place.
    fn samples(&mut self) -> Vec<[f32; 12]> {
        let [_, scratch, ..] = self.gpu.real_time_words().unwrap();
        let pixels = (SIZE.x * SIZE.y) as usize;
        // In waves other paths have slots behind those of the pixels.
        let slots = scratch.len() / 20;
        let pixel = |index: usize| {
            let word = |row: usize, which: usize| f32::from_bits(scratch[2 * (row * slots + index) + which]);
            let [light, direct] = [0, 2].map(|row| [word(row, 0), word(row, 1), word(row + 1, 0)]);
            let place = [word(3, 1), word(4, 0), word(4, 1)];
            let albedo = [word(5, 0), word(5, 1), word(6, 0)];
            let mut all = [0.0; 12];
            for (part, three) in all.chunks_mut(3).zip([light, direct, albedo, place]) {
                part.copy_from_slice(&three);
            }
            all
        };
        (0..pixels).map(pixel).collect()
    }
}

/// A sample of the processor, as [`Both::samples`] has them.
fn row_of(sample: &Sample) -> [f32; 12] {
    let place = sample.shown.map_or(Vec3::ZERO, |shown| shown.place);
    let mut all = [0.0; 12];
    for (part, three) in all.chunks_mut(3).zip([sample.light, sample.direct, sample.albedo, place]) {
        part.copy_from_slice(&three.to_array());
    }
    all
}

/// PSNR of what is shown, dB.
fn psnr([a, b]: &[Vec<Vec3>; 2]) -> f32 {
    let shown = |color: Vec3| color / (color + 1.0);
    let squares = a.iter().zip(b).map(|(a, b)| (shown(*a) - shown(*b)).length_squared()).sum::<f32>();
    assert_eq!(a.len(), b.len());
    -10.0 * (squares / (3 * a.len()) as f32).max(1e-12).log10()
}

/// Pixels whose samples differ in a bit.
fn differing(ours: &[[f32; 12]], theirs: &[Sample]) -> usize {
    assert_eq!(ours.len(), theirs.len());
    let bits = |row: [f32; 12]| row.map(|value| (value + 0.0).to_bits());
    ours.iter().zip(theirs).filter(|(ours, theirs)| bits(**ours) != bits(row_of(theirs))).count()
}

#[test]
fn paths_of_real_time_light_have_the_bits_of_the_processor() {
    let Some(device) = device() else { return };
    let all = Parts { candidates: true, cache: true, visibility: true, ..Parts::NONE };
    for (name, scene, parts) in [
        ("matte, one grid", packed(true, false), Parts::NONE),
        ("matte, turned", packed(true, true), all),
        ("materials", packed(false, true), all),
    ] {
        let mut both = Both::new(&device, &scene, parts);
        for number in 0..4 {
            both.frame(&view());
            let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
            let different = differing(&ours, &theirs);
            let first = ours.iter().zip(&theirs).find(|(ours, theirs)| **ours != row_of(theirs));
            assert!(different == 0, "{name}, frame {number}: {different} pixels, {first:?}");
        }
        let light: f32 = both.samples().iter().map(|row| row[0]).sum();
        assert!(light > 1.0, "{name}: there is light");
        // A planted fault: another seed.
        both.gpu.show_real_time(&view().seed(8), Rate::Full, &both.picture).unwrap();
        let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
        assert!(differing(&ours, &theirs) > 100, "{name}");
    }
    assert_valid(&device);
}

#[test]
fn paths_of_real_time_light_in_waves_have_the_bits_of_the_processor() {
    let Some(device) = device() else { return };
    let parts = Parts { candidates: true, cache: true, visibility: true, ..Parts::NONE };
    // One tracer: a software device compiles its shaders for long.
    let mut both = Both::in_waves(&device, &packed(true, false), parts);
    for (max_bounces, frames) in [(5, 4), (1, 1), (0, 1), (5, 1)] {
        let frame = view().max_bounces(max_bounces);
        for number in 0..frames {
            both.frame(&frame);
            let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
            let different = differing(&ours, &theirs);
            let first = ours.iter().zip(&theirs).find(|(ours, theirs)| **ours != row_of(theirs));
            assert!(different == 0, "{max_bounces} bounces, frame {number}: {different} pixels, {first:?}");
        }
    }
    // A planted fault: another seed.
    let faulty = both.gpu.show_real_time(&view().seed(8), Rate::Full, &both.picture).unwrap().unwrap();
    assert!(faulty.passes.is_empty() || faulty.passes.iter().any(|(step, _)| *step == "trace_ends"), "in waves");
    let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
    assert!(differing(&ours, &theirs) > 100);
    assert_valid(&device);
}

fn assert_same_bits(both: &mut Both, what: &str) {
    let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
    let different = differing(&ours, &theirs);
    let first = ours.iter().zip(&theirs).find(|(ours, theirs)| **ours != row_of(theirs));
    assert!(different == 0, "{what}: {different} pixels, {first:?}");
}

#[test]
fn paths_that_leave_the_waves_have_the_bits_of_the_processor() {
    let Some(device) = device() else { return };
    let parts = Parts { candidates: true, cache: true, visibility: true, ..Parts::NONE };
    let mut both = Both::in_waves(&device, &packed(false, true), parts);
    for number in 0..4 {
        both.frame(&view());
        assert!(both.had("shade_left"), "frame {number} in waves: {:?}", both.steps);
        assert_same_bits(&mut both, &format!("frame {number}"));
    }
    // One at a time: more rounds than a workgroup has invocations.
    both.gpu = both.gpu.with_most_paths(1);
    for number in 0..4 {
        both.frame(&view());
        assert!(both.had("finish_left"), "in waves: {:?}", both.steps);
        assert_same_bits(&mut both, &format!("one path at a time, frame {number}"));
    }
    both.gpu = both.gpu.with_most_paths(200);
    // Instances move, so that paths of the frame before are followed again.
    both.gpu.set_real_time(Parts::ALL, true);
    both.cpu = RealTime::new(Parts::ALL);
    compare(&mut both, "among all materials in waves", 2, |_| view());
    shift(&mut both);
    compare(&mut both, "among all materials in waves, where instances moved", 1, |_| view());
    shift(&mut both);
    // As windows do: the same light is no change.
    both.gpu.set_scene(&both.scene).unwrap();
    compare(&mut both, "among all materials in waves, where they go on", 1, |_| view());
    let kept = compare_rests(&mut both, "among all materials in waves");
    assert!((0.1..0.99).contains(&kept), "{kept}");
    assert!(both.had("shade_left") && both.had("trace_before"), "in waves: {:?}", both.steps);
    both.rate = Rate::Half;
    both.cpu.set_rate(Rate::Half);
    compare(&mut both, "among all materials in waves, at half the rate", 2, |number| aside(3 + number));
    assert!(both.had("shade_left"), "in waves: {:?}", both.steps);
    // A planted fault: another seed.
    both.gpu.show_real_time(&view().seed(8), Rate::Full, &both.picture).unwrap();
    let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
    assert!(differing(&ours, &theirs) > 100);
    assert_valid(&device);
}

#[test]
fn more_paths_leave_the_waves_than_have_room_and_have_the_bits_of_the_processor() {
    let Some(device) = device() else { return };
    let mut scene = things(false, true);
    scene.materials.iter_mut().for_each(|material| (material.transmission, material.ior) = (1.0, 1.5));
    let parts = Parts { candidates: true, cache: true, visibility: true, ..Parts::NONE };
    let mut both = Both::in_waves(&device, &Arc::new(PackedScene::pack(&scene).unwrap()), parts);
    for number in 0..4 {
        let mut frame = view();
        frame.camera.fov_y = 12.0;
        both.frame(&frame);
        // Some come too late for the rounds of the first frame; from the second one on rounds are as many as it takes, until one shader is tried.
        assert!(number > 1 || both.had("shade_left") && both.had("trace_left"), "frame {number}: {:?}", both.steps);
        assert_same_bits(&mut both, &format!("frame {number}"));
    }
    // A planted fault: another seed.
    both.gpu.show_real_time(&view().seed(8), Rate::Full, &both.picture).unwrap();
    let (ours, theirs) = (both.samples(), both.cpu.samples().to_vec());
    assert!(differing(&ours, &theirs) > 100);
    assert_valid(&device);
}

#[test]
fn where_most_paths_leave_the_waves_the_quicker_way_is_taken_and_pictures_stay() {
    let Some(device) = device() else { return };
    let mut scene = things(true, true);
    scene.materials.iter_mut().for_each(|material| (material.metallic, material.roughness) = (1.0, 0.3));
    let mut both = Both::in_waves(&device, &Arc::new(PackedScene::pack(&scene).unwrap()), Parts::ALL);
    // Near enough that no sky is seen.
    let near = || {
        let mut frame = view();
        frame.camera.fov_y = 12.0;
        frame
    };
    compare(&mut both, "metal, both ways", 1, |_| near());
    // The first picture has four frames: each way is tried, as most paths leave, and then the quicker one is taken.
    assert!(both.had("shade_left") && both.had("trace"), "{:?}", both.steps);
    compare(&mut both, "metal, the quicker way", 2, |_| near());
    assert!(both.steps.is_empty() || both.had("shade_left") != both.had("trace"), "{:?}", both.steps);
    // Waves are tried where the camera looks elsewhere.
    compare(&mut both, "metal, after a cut", 1, |_| near().seed(9));
    assert!(both.had("shade_left"), "{:?}", both.steps);
    assert_valid(&device);
}

#[test]
fn pictures_of_real_time_light_in_waves_are_those_of_the_processor() {
    let Some(device) = device() else { return };
    let mut both = Both::in_waves(&device, &packed(true, true), Parts::ALL);
    compare(&mut both, "in waves", 3, |_| view());
    compare(&mut both, "in waves, moving", 2, aside);
    // Paths of the frame before are followed again.
    shift(&mut both);
    compare(&mut both, "in waves, where instances moved", 2, |_| view());
    both.rate = Rate::Half;
    both.cpu.set_rate(Rate::Half);
    compare(&mut both, "in waves, at half the rate", 2, |number| aside(3 + number));
    assert_valid(&device);
}

/// PSNR that pictures of both sides have at least: half floats differ.
const LEAST_PSNR: f32 = 65.0;

/// Compares the next frames, whose views `view` gives, and makes sure that a fault is seen: the picture of the frame before.
fn compare(both: &mut Both, what: &str, frames: u32, view: impl Fn(u32) -> Frame) {
    let mut last = None;
    for number in 0..frames {
        let pictures = both.frame(&view(number));
        let found = psnr(&pictures);
        println!("{what}, frame {number}: {found:.1} dB");
        assert!(found >= LEAST_PSNR, "{what}, frame {number}: {found:.1} dB");
        let [expected, ours] = pictures;
        if let Some(before) = last.replace(ours) {
            let fault = psnr(&[expected, before]);
            assert!(fault < found - 3.0, "{what}: the frame before is as near: {fault:.1} dB");
        }
    }
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_part_by_part() {
    let Some(device) = device() else { return };
    let memory = Parts { memory: true, ..Parts::NONE };
    for (name, parts) in [
        ("a path", Parts::NONE),
        ("memory", memory),
        ("cache", Parts { cache: true, candidates: true, ..memory }),
        ("filter", Parts { filter: true, ..memory }),
        ("all", Parts::ALL),
    ] {
        compare(&mut Both::new(&device, &packed(true, true), parts), name, 6, |_| view());
    }
    compare(&mut Both::new(&device, &packed(false, true), Parts::ALL), "all, materials", 6, |_| view());
    assert_valid(&device);
}

/// A view that goes aside.
fn aside(number: u32) -> Frame {
    let by = Vec3::new(0.3, 0.1, 0.05) * number as f32;
    let camera = Camera::look_at(Vec3::new(3.0, -26.0, 17.0) + by, Vec3::new(0.0, 0.0, 1.0));
    let mut frame = view();
    frame.camera = camera;
    frame
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_while_the_camera_moves() {
    let Some(device) = device() else { return };
    compare(&mut Both::new(&device, &packed(true, true), Parts::ALL), "moving, matte", 5, aside);
    assert_valid(&device);
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_while_camera_and_things_move_among_glass_and_at_half_rate() {
    let Some(device) = device() else { return };
    let mut both = Both::new(&device, &packed(false, true), Parts::ALL);
    compare(&mut both, "moving, materials", 5, aside);
    shift(&mut both);
    compare(&mut both, "materials, where instances moved", 2, |number| aside(4 + number));
    both.rate = Rate::Half;
    both.cpu.set_rate(Rate::Half);
    compare(&mut both, "moving at half the rate", 4, |number| aside(5 + number));
    compare(&mut both, "still at half the rate", 4, |_| view());
    assert_valid(&device);
}

/// Instances move, all but those of the first grid.
fn shift(both: &mut Both) {
    let moved = |instance: &PackedInstance| {
        let by = if instance.grid == 0 { Vec3::ZERO } else { Vec3::new(0.4, 0.2, 0.0) };
        PackedInstance::new(instance.grid, instance.world_from_grid.translated(by), instance.scene_instance)
    };
    let moved = both.scene.instances().iter().map(moved).collect();
    place(both, moved);
}

/// Instances stand elsewhere, or there are others.
fn place(both: &mut Both, instances: Vec<PackedInstance>) {
    let before = both.scene.instances().to_vec();
    let placement = Placement::new(both.scene.geometry(), instances).unwrap();
    both.gpu.set_placement(&placement).unwrap();
    both.scene = Arc::new(both.scene.with_placement(&placement).unwrap());
    both.cpu.move_instances(&before);
}

/// Of each pixel, whether it is at rest, and the rays of the camera that it remembers: the processor's, and the device's.
fn rests(both: &mut Both) -> [Vec<(bool, f32)>; 2] {
    let ours = both.cpu.memory().iter().map(|memory| (memory.is_at_rest, memory.looks)).collect();
    let [memory, ..] = both.gpu.real_time_words().unwrap();
    let pixels = (SIZE.x * SIZE.y) as usize;
    // Half floats that are neither 0 nor below the normal ones.
    let looks = |word: u32| f32::from_bits(((word >> 16) << 13) + (112 << 23));
    let theirs = (0..pixels).map(|index| (memory[4 * index + 3] >> 31 != 0, looks(memory[4 * (pixels + index)])));
    [ours, theirs.collect()]
}

/// Makes sure that both sides keep what they know in the same pixels. Returns the share of those.
fn compare_rests(both: &mut Both, what: &str) -> f32 {
    let [ours, theirs] = rests(both);
    let different = ours.iter().zip(&theirs).filter(|(ours, theirs)| ours != theirs).count();
    assert!(different == 0, "{what}: {different} pixels");
    ours.iter().filter(|(is_at_rest, looks)| *is_at_rest && *looks > 4.0).count() as f32 / ours.len() as f32
}

/// A ball appears.
fn edit(both: &mut Both, dynamic: &mut DynamicScene) {
    let shape = Shape::Sphere { center: Vec3::new(-4.0, -8.0, 3.0).as_dvec3(), radius: 3.0 };
    dynamic.edit(0, &Edit::Fill { shape, material: Some(1) }).unwrap();
    both.gpu.patch(&dynamic.take_patch()).unwrap();
    both.scene = Arc::new(dynamic.scene().clone());
    both.cpu.change();
}

/// Lamps and sky give a tenth of their light.
fn dim(both: &mut Both) {
    let mut scene = (*both.scene).clone();
    scene.light_intensity *= 0.1;
    scene.sky = scene.sky.with_brightness(0.1);
    both.scene = Arc::new(scene);
    both.gpu.set_scene(&both.scene).unwrap();
    both.cpu.change();
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_after_lamps_were_dimmed() {
    let Some(device) = device() else { return };
    let mut both = Both::new(&device, &packed(true, true), Parts::ALL);
    compare(&mut both, "before", 6, |_| view());
    dim(&mut both);
    compare(&mut both, "after lamps were dimmed", 3, |_| view());
    assert_valid(&device);
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_after_edits_and_where_instances_move() {
    let Some(device) = device() else { return };
    let mut dynamic = DynamicScene::new(packed(true, true).split()).unwrap();
    let first = Arc::new(dynamic.scene().clone());
    let mut both = Both::new(&device, &first, Parts::ALL);
    compare(&mut both, "before the edit", 3, |_| view());
    edit(&mut both, &mut dynamic);
    compare(&mut both, "after the edit", 3, |_| view());

    for step in 1..4 {
        shift(&mut both);
        let what = format!("where instances moved, {step}");
        compare(&mut both, &what, 1, |_| view());
        let kept = compare_rests(&mut both, &what);
        // Of the first step it is not known before what it moves.
        assert!(if step == 1 { kept == 0.0 } else { (0.3..0.99).contains(&kept) }, "{what}: {kept}");
    }
    compare(&mut both, "at rest again", 2, |_| view());
    shift(&mut both);
    compare(&mut both, "and on", 1, |_| view());
    assert!(compare_rests(&mut both, "and on") > 0.3);
    both.rate = Rate::Half;
    both.cpu.set_rate(Rate::Half);
    for step in 1..4 {
        shift(&mut both);
        let what = format!("where instances moved, at half the rate, {step}");
        compare(&mut both, &what, 1, |_| view());
        assert!(compare_rests(&mut both, &what) > 0.3, "{what}");
    }
    // A planted fault: the device does not know of a frame.
    shift(&mut both);
    both.cpu.frame(&both.scene, &view());
    let [ours, theirs] = rests(&mut both);
    assert!(ours != theirs);
    assert_valid(&device);
}

#[test]
fn pictures_of_real_time_light_are_those_of_the_processor_where_instances_go_and_come() {
    let Some(device) = device() else { return };
    let mut both = Both::new(&device, &packed(true, true), Parts::ALL);
    let all = both.scene.instances().to_vec();
    compare(&mut both, "all of them", 3, |_| view());
    // The light cache knows faces of those that go.
    place(&mut both, all[..2].to_vec());
    compare(&mut both, "two of them", 3, |_| view());
    place(&mut both, all);
    compare(&mut both, "all of them again", 3, |_| view());
    assert_valid(&device);
}

/// A tracer of pictures of real-time light of any size, in waves or not, without the light cache: that knows places whatever the size of pictures.
struct AnySize {
    device: Arc<Device>,
    gpu: VulkanTracer,
}

impl AnySize {
    fn new(device: &Arc<Device>, scene: &Arc<PackedScene>, most_paths: u32) -> Self {
        let gpu = VulkanTracer::new(Arc::clone(device), Settings::default()).unwrap();
        let mut gpu = gpu.with_most_paths(most_paths);
        gpu.set_real_time(Parts { cache: false, ..Parts::ALL }, true);
        gpu.set_scene(scene).unwrap();
        Self { device: Arc::clone(device), gpu }
    }

    /// The next two pictures, and how many frames are in the first one.
    fn pictures(&mut self, size: UVec2, seed: u32) -> (u32, [Vec<[f32; 3]>; 2]) {
        let frame = view().size(size.x, size.y).seed(seed);
        let mut frames = Vec::new();
        let pictures = [0, 1].map(|_| {
            let picture = Picture::new(&self.device, size.x, size.y, true).unwrap();
            frames.push(self.gpu.show_real_time(&frame, Rate::Full, &picture).unwrap().unwrap().frames);
            picture.radiance()
        });
        (frames[0], pictures)
    }
}

#[test]
fn pictures_of_another_size_are_those_of_a_tracer_that_began_with_it() {
    let Some(device) = device() else { return };
    let scene = packed(true, true);
    let sizes = [SIZE, UVec2::new(40, 56), UVec2::new(80, 60), SIZE];
    for most_paths in [0, 200] {
        let mut resized = AnySize::new(&device, &scene, most_paths);
        for (number, size) in sizes.into_iter().enumerate() {
            let ours = resized.pictures(size, 7);
            assert!(ours.0 > 1, "{size}: nothing is known of its pixels");
            // As many frames before, of other seeds: of these nothing is known either.
            let mut other = AnySize::new(&device, &scene, most_paths);
            let seeds = (0..number as u32).map(|before| 20 + before);
            seeds.for_each(|seed| _ = other.pictures(size, seed));
            assert!(ours == other.pictures(size, 7), "{most_paths} paths in waves, picture {number}, {size}");
            assert!(ours.1 != other.pictures(size, 7).1, "the comparison sees what is known of pixels");
        }
    }
    assert_valid(&device);
}

#[test]
fn lines_on_instances_that_were_merged_are_refused_as_by_films() {
    let Some(device) = device() else { return };
    let mut block = VoxelGrid::new();
    block.set(IVec3::ZERO, 0);
    let mut scene = Scene { materials: vec![Material::default()], ..Scene::new("merged") };
    let at = |x, y, z| Transform::from_translation(Vec3::new(x, y, z));
    for place in [at(9.0, 0.0, 0.0), Transform::IDENTITY, Transform::IDENTITY, at(0.0, 9.0, 0.0)] {
        scene.add_instance(block.clone(), place);
    }
    let again = Instance { world_from_grid: at(30.0, 30.0, 30.0), ..scene.instances[1].clone() };
    scene.instances.push(again);
    let merged = Arc::new(PackedScene::pack_merged(&scene).unwrap());
    assert!(merged.is_merged());
    let mut both = Both::new(&device, &merged, Parts::NONE);
    let lines = Lines { edges: Some(Line { width: 0.1, color: Vec3::X }), grid: None };
    let answer = both.gpu.show_real_time(&view().lines(lines), Rate::Full, &both.picture);
    assert!(matches!(answer, Err(TraceError::BadFrame(_))), "{answer:?}");
    both.gpu.show_real_time(&view(), Rate::Full, &both.picture).unwrap();
    assert_valid(&device);
}

#[test]
fn films_in_waves_go_on_after_real_time_light_in_waves_among_all_materials() {
    let Some(device) = device() else { return };
    let scene = packed(false, true);
    let mut both = Both::in_waves(&device, &scene, Parts::ALL);
    let frame = view().samples(1);
    voxtrace_tests::gpu::film(&mut both.gpu, &frame);
    both.gpu.show_real_time(&view(), Rate::Full, &both.picture).unwrap();
    let more = voxtrace_tests::gpu::film(&mut both.gpu, &frame.clone().samples(3));
    let mut other = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    other.set_scene(&scene).unwrap();
    assert_eq!(more.pixels, voxtrace_tests::gpu::film(&mut other, &frame.samples(3)).pixels);
    assert_valid(&device);
}

#[test]
fn real_time_light_leaves_the_film_as_it_is_and_gives_its_memory_back() {
    let Some(device) = device() else { return };
    let scene = packed(true, false);
    let mut both = Both::new(&device, &scene, Parts::ALL);
    let frame = view().samples(2);
    let film = voxtrace_tests::gpu::film(&mut both.gpu, &frame);
    both.frame(&view());
    let mut after = voxtrace::Film::new(1, 1, frame.region, 0);
    both.gpu.read(&mut after).unwrap();
    assert_eq!(film.pixels, after.pixels);
    let more = voxtrace_tests::gpu::film(&mut both.gpu, &frame.clone().samples(4));
    let mut other = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    other.set_scene(&scene).unwrap();
    assert_eq!(more.pixels, voxtrace_tests::gpu::film(&mut other, &frame.samples(4)).pixels);
    let held = |tracer: &VulkanTracer| {
        let entries = tracer.memory().entries;
        entries
            .iter()
            .filter(|(name, _)| name.starts_with("real-time") || *name == "light cache")
            .map(|entry| entry.1)
            .sum::<u64>()
    };
    assert!(held(&both.gpu) > 1 << 20);
    both.gpu.forget_real_time();
    assert_eq!(held(&both.gpu), 0);
    assert_valid(&device);
}
