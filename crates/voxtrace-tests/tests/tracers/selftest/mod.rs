//! The functions that shaders share with the library give the same bits. Each entry point of `shaders/pass/selftest.slang` runs one
//! group of them on the device, and the library computes the same here. For each group a mutated twin must differ, which
//! proves that the inputs tell the difference.

mod exact;
mod light;
mod pure;
mod seams;

use std::sync::{Arc, Mutex};
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::{Hit, PackedScene, Ray};
use voxtrace_tests::gpu;
use voxtrace_vulkan::selftest;

/// One group of functions, for the scene that some of them read.
struct Group<'a> {
    /// Entry point.
    entry: &'static str,
    scene: &'a Arc<PackedScene>,
    /// Words of input and of output of a case.
    words: (usize, usize),
    /// Input words of all cases.
    inputs: Vec<u32>,
}

impl Group<'_> {
    /// Compares the device's outputs with those of `twin`, which must agree, and with those of `wrong_twin`, which must differ.
    fn check(&self, twin: impl Fn(&[u32]) -> Vec<u32>, wrong_twin: impl Fn(&[u32]) -> Vec<u32>) {
        // One test at a time: software devices use all cores.
        static ALONE: Mutex<()> = Mutex::new(());
        let _alone = ALONE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let Some(device) = gpu::device() else { return };
        let (given, made) = self.words;
        let count = self.inputs.len() / given;
        let outputs = selftest::run(&device, self.scene, self.entry, &self.inputs, count as u32, count * made).unwrap();
        let differences = |twin: &dyn Fn(&[u32]) -> Vec<u32>| -> Vec<(usize, Vec<u32>)> {
            let expected = self.inputs.chunks(given).map(twin).enumerate();
            expected.filter(|(case, expected)| outputs[case * made..][..made] != expected[..]).collect()
        };
        let wrong = differences(&twin);
        if let Some((case, expected)) = wrong.first() {
            let (input, output) = (&self.inputs[case * given..][..given], &outputs[case * made..][..made]);
            panic!(
                "{} of {count} cases of {} differ; case {case}:\n {input:#x?}\n = {:?}\n gives {output:#x?}\n = {:?}\n not {expected:#x?}\n = {:?}",
                wrong.len(),
                self.entry,
                numbers(input),
                numbers(output),
                numbers(expected),
            );
        }
        assert!(!differences(&wrong_twin).is_empty(), "{} would not notice a wrong twin", self.entry);
        gpu::assert_valid(&device);
    }
}

/// Words as numbers, for messages.
fn numbers(words: &[u32]) -> Vec<f32> {
    words.iter().map(|&word| f32::from_bits(word)).collect()
}

/// A scene for functions that read none.
fn empty() -> Arc<PackedScene> {
    Arc::new(PackedScene::empty())
}

fn words(values: impl IntoIterator<Item = f32>) -> impl Iterator<Item = u32> {
    values.into_iter().map(f32::to_bits)
}

fn cell_words(cell: IVec3) -> [u32; 3] {
    cell.to_array().map(|value| value as u32)
}

fn vector(words: &[u32]) -> Vec3 {
    Vec3::from_slice(&numbers(&words[..3]))
}

fn cell(words: &[u32]) -> IVec3 {
    IVec3::new(words[0] as i32, words[1] as i32, words[2] as i32)
}

fn ray(words: &[u32]) -> Ray {
    let number = |at: usize| f32::from_bits(words[at]);
    Ray { origin: vector(words), t_min: number(3), direction: vector(&words[4..]), t_max: number(7) }
}

fn ray_words(ray: &Ray) -> impl Iterator<Item = u32> {
    let Ray { origin, t_min, direction, t_max } = *ray;
    words([origin.x, origin.y, origin.z, t_min, direction.x, direction.y, direction.z, t_max])
}

fn hit(words: &[u32]) -> Hit {
    Hit { t: f32::from_bits(words[0]), instance: words[1], voxel: cell(&words[2..]), face: words[5] }
}

fn hit_words(hit: &Hit) -> [u32; 6] {
    let [x, y, z] = cell_words(hit.voxel);
    [hit.t.to_bits(), hit.instance, x, y, z, hit.face]
}
