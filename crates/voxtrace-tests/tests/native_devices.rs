//! Native files on the Vulkan device: the corpus of the fuzz target, and damaged files whose checksums were mended. Every tracer
//! traces what is opened; where nothing was forged but the hierarchy over instances, it finds the hits of the CPU.

#[path = "../../../fuzz/check/native.rs"]
mod check;
#[path = "../../../fuzz/check/checksums.rs"]
mod checksums;
#[path = "../../voxtrace/tests/files/damage/mod.rs"]
mod damage;
#[path = "../../../fuzz/check/devices.rs"]
mod devices;
#[path = "../../../fuzz/check/forged.rs"]
mod forged;

use check::Traced;
use damage::damaged;
use devices::Tracers;
use forged::chain;
use std::fs;
use std::path::{Path, PathBuf};
use voxtrace::glam::Vec3;
use voxtrace::{Hit, PackedScene, Ray};
use voxtrace_core::packed::MAX_INSTANCE_DEPTH;
use voxtrace_core::walk;
use voxtrace_tests::gpu::{assert_valid, compare_hits, device};
use voxtrace_tests::random::Random;
use voxtrace_vulkan::{Primitive, Traversal};

/// The files of the corpus, by their names.
fn corpus() -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/native");
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read(path).unwrap())).collect()
}

#[test]
fn the_deepest_chain_of_instances_gives_every_tracer_the_hits_of_the_cpu() {
    let (bytes, packed) = chain(MAX_INSTANCE_DEPTH);
    let mut random = Random(21);
    // From within, where all boxes are entered at once, and from outside.
    let rays: Vec<Ray> = (0..4096)
        .map(|index| {
            let (target, direction) = (random.point(Vec3::ZERO, Vec3::new(18.0, 17.0, 9.0)), random.direction());
            Ray::new(target - direction * 40.0 * (index % 2) as f32, direction)
        })
        .collect();
    let scene = PackedScene::from_bytes(&bytes).unwrap();
    // The same instances under a tree that halves them.
    let expected: Vec<Hit> = rays.iter().map(|ray| walk::cast(&packed, ray)).collect();
    assert!(expected.iter().filter(|hit| hit.instance == 0 || hit.instance == 32).count() > 10, "both ends are met");
    let mut batch = vec![Hit::MISS; rays.len()];
    walk::cast_batch(&scene, &rays, &mut batch);
    compare_hits(&rays, &batch, &expected).unwrap();
    let traced = Traced { scene, rays: rays.clone() };
    let Some(device) = device() else { return };
    let hardware = [Traversal::Query, Traversal::Pipeline];
    let mut kinds = vec![(Traversal::Walk, Primitive::default())];
    kinds.extend(hardware.into_iter().flat_map(|traversal| Primitive::ALL.map(|primitive| (traversal, primitive))));
    // Its order of voxels is another one.
    kinds.retain(|&(_, primitive)| primitive != Primitive::VoxelApprox);
    let mut tracers = Tracers::with(&device, &kinds);
    for (kind, mut hits) in tracers.check(&traced) {
        compare_hits(&rays, &hits, &expected).unwrap_or_else(|difference| panic!("{kind:?}: {difference}"));
        // A planted hit of the next instance.
        let met = hits.iter().position(|hit| !hit.is_miss()).unwrap();
        hits[met].instance += 1;
        compare_hits(&rays, &hits, &expected).unwrap_err();
    }
    drop(tracers);
    assert_valid(&device);
}

#[test]
fn native_files_of_the_corpus_and_damaged_ones_are_traced_on_the_device() {
    let Some(device) = device() else { return };
    let mut tracers = Tracers::few(&device);
    let numbers = [0, 1, 2, 64, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX, f32::NAN.to_bits(), 1 << 21];
    let mut random = Random(22);
    let (mut opened, mut opened_damaged) = (0, 0);
    for (path, bytes) in corpus() {
        let Some(traced) = check::check(&bytes) else { continue };
        opened += 1;
        let cast = |ray: &Ray| traced.scene.hit_of_part(&walk::cast(&traced.scene, ray));
        let expected: Vec<Hit> = traced.rays.iter().map(cast).collect();
        for (kind, hits) in tracers.check(&traced) {
            let compared = compare_hits(&traced.rays, &hits, &expected);
            compared.unwrap_or_else(|difference| panic!("{} {kind:?}: {difference}", path.display()));
        }
        for _ in 0..12 {
            let damaged = damaged(&bytes, &numbers, &["CELL"], |end| random.below(end));
            if let Some(traced) = check::check(&damaged) {
                tracers.check(&traced);
                opened_damaged += 1;
            }
        }
    }
    assert!(opened >= 4, "{opened} files of the corpus were opened");
    assert!(opened_damaged > 10, "only {opened_damaged} damaged files were opened");
    drop(tracers);
    assert_valid(&device);
}
