//! The native file: what is saved is what is opened, and a damaged file is an error, never a panic.

#[path = "../../../fuzz/check/checksums.rs"]
mod checksums;
#[path = "../../../fuzz/check/forged.rs"]
mod forged;

use forged::{chain, forge};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::sky::{Background, Environment};
use voxtrace::{Camera, Hit, Material, PackedScene, Ray, Scene, Sky, Sun, Transform};
use voxtrace_core::packed::MAX_INSTANCE_DEPTH;
use voxtrace_core::walk;
use voxtrace_tests::environments::noise_map;
use voxtrace_tests::lattice::models;
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_tests::scenes::{dust, noise};

fn scene() -> Scene {
    let mut scene = Scene::from_grid("two grids", noise(IVec3::new(3, -7, 0), 20, 0.1, 30, 1), vec![]);
    let turned = Transform { linear: Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z), translation: Vec3::splat(40.0) };
    scene.add_instance(dust(200, 10, 2), turned);
    scene.materials = (0..500).map(|i| Material::diffuse(Vec3::splat(i as f32 / 500.0))).collect();
    scene.cameras = vec![Camera::look_at(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO)];
    scene.sky.set_sun(Sun { direction: Vec3::Z, angular_radius: 0.01, irradiance: Vec3::ONE });
    scene
}

fn bytes_of(scene: &PackedScene) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    scene.save(&path).unwrap();
    std::fs::read(path).unwrap()
}

/// Says so often that it is wanted, and how often it was asked.
fn wanted(most: usize, asked: &AtomicUsize) -> impl Fn() -> bool + Sync {
    asked.store(0, Ordering::Relaxed);
    move || asked.fetch_add(1, Ordering::Relaxed) < most
}

#[test]
fn unpacking_and_saving_end_where_nobody_waits_for_them() {
    let asked = AtomicUsize::new(0);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    for packed in [PackedScene::pack(&scene()).unwrap(), PackedScene::pack_merged(&models(12, 8)).unwrap()] {
        let scene = packed.to_scene_while(&wanted(usize::MAX, &asked)).unwrap();
        assert_eq!(scene, packed.to_scene());
        let questions = asked.load(Ordering::Relaxed);
        assert!(questions > 5, "asked {questions} times");
        for answered in [0, 1, questions / 2, questions - 1] {
            assert!(packed.to_scene_while(&wanted(answered, &asked)).is_none(), "after {answered} of {questions}");
        }
        assert!(packed.to_scene_while(&wanted(questions, &asked)).is_some());

        let split = packed.split_while(&wanted(usize::MAX, &asked)).unwrap();
        assert_eq!(split.content_hash(), packed.split().content_hash());
        assert_eq!(packed.split_while(&|| false).is_some(), !packed.is_merged(), "what is apart stays as it is");

        packed.save_while(&path, &wanted(usize::MAX, &asked)).unwrap();
        let (whole, questions) = (std::fs::read(&path).unwrap(), asked.load(Ordering::Relaxed));
        for answered in 0..questions {
            std::fs::write(&path, "old").unwrap();
            assert!(packed.save_while(&path, &wanted(answered, &asked)).is_err(), "after {answered} of {questions}");
            assert_eq!(std::fs::read(&path).unwrap(), b"old");
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left behind");
        }
        packed.save_while(&path, &wanted(questions, &asked)).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
    }
}

#[test]
fn saved_and_opened_scene_is_the_same() {
    let source = scene();
    let packed = PackedScene::pack(&source).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    packed.save(&path).unwrap();
    let opened = PackedScene::open(&path).unwrap();
    assert_eq!(opened.content_hash(), packed.content_hash());
    assert_eq!(opened.to_scene(), source);
    let rays = mixed(&source.grids[0], 2000, 3);
    let cast = |scene: &PackedScene| rays.iter().map(|ray| walk::cast(scene, ray)).collect::<Vec<Hit>>();
    assert_eq!(cast(&opened), cast(&packed));
}

#[test]
fn an_environment_map_is_saved_and_its_damage_noticed() {
    let gradient = scene();
    let environment = Environment::new(noise_map(12, 5), 30.0);
    let mut source = scene();
    source.sky =
        Sky::new(Background::Environment(environment)).with_brightness(0.7).with_sun(*gradient.sky.sun().unwrap());
    let [packed, without] = [&source, &gradient].map(|scene| PackedScene::pack(scene).unwrap());
    let bytes = bytes_of(&packed);
    let opened = PackedScene::from_bytes(&bytes).unwrap();
    assert_eq!(opened.to_scene(), source);
    assert_eq!(opened.content_hash(), packed.content_hash());
    assert_ne!(packed.content_hash(), without.content_hash());
    let turned = |rotation| {
        let mut scene = packed.clone();
        let map = packed.sky.background().environment().unwrap().map().clone();
        scene.sky.set_background(Background::Environment(Environment::new(map, rotation)));
        scene.content_hash()
    };
    assert_eq!(turned(30.0), packed.content_hash());
    assert_ne!(turned(31.0), packed.content_hash());
    let hidden = Scene { sky: source.sky.clone().with_sun_disc_visible(false), ..source.clone() };
    let with_hidden = PackedScene::pack(&hidden).unwrap();
    let again = PackedScene::from_bytes(&bytes_of(&with_hidden)).unwrap();
    assert_eq!((again.to_scene(), again.content_hash()), (hidden, with_hidden.content_hash()));
    assert_ne!(again.to_scene(), source, "the comparison sees whether the sun's disc is visible");
    // Files without a map do not have its sections, and those with one have all the others.
    let (long, short) = (bytes.len(), bytes_of(&without).len());
    assert!(long - short >= 12 * 144 + 8 + 64 && long - short < 12 * 144 + 512, "{long} {short}");
    // A map that says another size, and a texel that is no light, their checksums mended.
    let find = |tag: &[u8]| (0..bytes.len()).find(|&at| bytes[at..].starts_with(tag)).unwrap();
    for (tag, value) in [(&b"ENVI"[..], 13_u32), (b"ENVT", f32::NAN.to_bits()), (b"ENVT", (-1.0_f32).to_bits())] {
        let entry = find(tag);
        let at = u64::from_le_bytes(bytes[entry + 8..entry + 16].try_into().unwrap()) as usize;
        let mut damaged = bytes.clone();
        damaged[at..at + 4].copy_from_slice(&value.to_le_bytes());
        assert!(PackedScene::from_bytes(&damaged).is_err(), "a wrong checksum");
        checksums::mend(&mut damaged);
        assert!(PackedScene::from_bytes(&damaged).is_err(), "{value:08x} in {tag:?}");
        let mut mended = bytes.clone();
        checksums::mend(&mut mended);
        assert!(PackedScene::from_bytes(&mended).is_ok(), "mending alone damages nothing");
    }
}

#[test]
fn hash_notices_any_change() {
    let packed = PackedScene::pack(&scene()).unwrap();
    let hash = packed.content_hash();
    let mut brighter = packed.clone();
    brighter.light_intensity = 2.0;
    assert_ne!(brighter.content_hash(), hash);
    let mut changed = scene();
    Arc::make_mut(&mut changed.grids[0]).set(IVec3::new(3, -7, 0), 29);
    assert_ne!(PackedScene::pack(&changed).unwrap().content_hash(), hash);
}

#[test]
fn every_cut_and_every_flipped_byte_is_an_error() {
    let bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    let opens = |bytes: &[u8]| PackedScene::from_bytes(bytes).map(|scene| scene.content_hash());
    let hash = opens(&bytes).unwrap();
    for length in (0..bytes.len()).step_by(61) {
        assert!(opens(&bytes[..length]).is_err(), "cut to {length} bytes");
    }
    let mut random = Random(5);
    for _ in 0..400 {
        let mut damaged = bytes.clone();
        let at = random.below(bytes.len());
        damaged[at] ^= 1 << random.below(8);
        // Padding between sections and reserved words mean nothing.
        let is_unharmed = opens(&damaged).is_ok_and(|found| found == hash);
        assert!(is_unharmed || opens(&damaged).is_err(), "byte {at}");
    }
}

#[test]
fn forged_scene_is_refused_or_harmless() {
    let bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    let rays: Vec<Ray> = mixed(&scene().grids[0], 300, 8);
    let mut random = Random(9);
    let mut refused = 0;
    for round in 0..3000 {
        let mut forged = bytes.clone();
        let tag = [b"CELL", b"BRIK", b"BMAT", b"GRID", b"INST", b"INOD"][round % 6];
        forge(&mut forged, tag, |section| {
            let at = 4 * random.below(section.len() / 4);
            let word = random.bits() as u32 >> random.below(32);
            section[at..at + 4].copy_from_slice(&word.to_le_bytes());
        });
        match PackedScene::from_bytes(&forged) {
            Err(_) => refused += 1,
            Ok(scene) => {
                for hit in rays.iter().map(|ray| walk::cast(&scene, ray)).filter(|hit| !hit.is_miss()) {
                    assert!(scene.material_index(&hit) < 500);
                }
            }
        }
    }
    assert!(refused > 500, "only {refused} of 3000 were refused");
}

/// What opening says after numbers were put over the record of the first grid, from a byte of it on.
fn fault_of_grid(at: usize, numbers: &[i32]) -> String {
    let mut bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    forge(&mut bytes, b"GRID", |grids| {
        for (place, number) in grids[at..].chunks_exact_mut(4).zip(numbers) {
            place.copy_from_slice(&number.to_le_bytes());
        }
    });
    PackedScene::from_bytes(&bytes).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn a_grid_at_the_smallest_of_all_coordinates_is_refused() {
    // It has no absolute value, so that a wrapped one would pass for near.
    for axis in 0..3 {
        let fault = fault_of_grid(4 * axis, &[i32::MIN]);
        assert!(fault.contains("coordinates out of range"), "{axis}: {fault}");
    }
}

#[test]
fn a_grid_of_more_cells_than_can_be_counted_is_refused() {
    // 2⁶⁴ in all, which 64 bits take for none.
    let fault = fault_of_grid(16, &[1 << 22, 1 << 21, 1 << 21]);
    assert!(fault.contains("cells reach too far"), "{fault}");
    // As many as may lie side by side, and no file holds.
    let fault = fault_of_grid(12, &[3, 1 << 19, 1 << 19, 1 << 19]);
    assert!(fault.contains("cells are missing"), "{fault}");
}

#[test]
fn grids_that_lie_over_the_same_cells_are_refused() {
    // Each of many grids could have all cells looked at once more.
    let mut bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    forge(&mut bytes, b"GRID", |grids| grids.copy_within(68..136, 0));
    let fault = PackedScene::from_bytes(&bytes).map(|_| ()).unwrap_err().to_string();
    assert!(fault.contains("cells are shared"), "{fault}");
}

#[test]
fn a_grid_that_says_other_bounds_or_voxels_than_its_bricks_have_is_refused() {
    let grid = PackedScene::pack(&scene()).unwrap().grids()[0];
    let said = |at: usize, number: i32| fault_of_grid(at, &[number]);
    for axis in 0..3 {
        let (min, max) = (grid.min[axis], grid.max[axis]);
        // Smaller, by bricks and by a voxel, and larger: as far as the cells reach.
        for (at, number) in [(32, min + 8), (32, min + 1), (52, min + 1), (52, max - 1), (52, max + 1)] {
            let fault = said(at + 4 * axis, number);
            assert!(fault.contains("grid 0: it says that its voxels span"), "{axis}: {fault}");
        }
    }
    let voxels = grid.voxels[0] as i32;
    for fault in [said(44, voxels + 1), said(44, 0), said(48, 1)] {
        assert!(fault.contains(&format!("voxels, and has {voxels}")), "{fault}");
    }
}

#[test]
fn what_a_file_says_twice_must_agree() {
    let mut lamps = scene();
    lamps.materials[7] = Material::emissive(Vec3::ONE);
    let bytes = bytes_of(&PackedScene::pack(&lamps).unwrap());
    PackedScene::from_bytes(&bytes).unwrap();
    let float = |number: f32| number.to_le_bytes();
    type Change<'a> = (&'a [u8; 4], usize, [u8; 4], &'a str);
    let changes: [Change; 9] = [
        (b"BRIK", 0, [0, 16, 0, 0], "a brick has no voxels where it says that it has some"),
        (b"EMIT", 0, (-4_000_000_i32).to_le_bytes(), "emitter 0 is no voxel of its material"),
        (b"EMIT", 20, 8_u32.to_le_bytes(), "emitter 0 is no voxel of its material"),
        (b"EMIT", 24, float(f32::NAN), "emitter 0 has a luminance of NaN"),
        (b"EMIT", 24, float(-1.0), "emitter 0 has a luminance of -1"),
        // From world to grid, of the second instance.
        (b"INST", 104 + 36, float(7.0), "the two transforms of instance 1 are not each other's inverse"),
        // The root, and a leaf: boxes that leave out what is in them, or are none.
        (b"INOD", 16, float(1.0), "node 0 of the tree over instances is too small for what it holds"),
        (b"INOD", 0, float(f32::NAN), "node 0 of the tree over instances is too small for what it holds"),
        (b"INOD", 32 + 20, float(-300.0), "of the tree over instances is too small for what it holds"),
    ];
    for (tag, at, value, says) in changes {
        let mut forged = bytes.clone();
        forge(&mut forged, tag, |section| section[at..at + 4].copy_from_slice(&value));
        let fault = PackedScene::from_bytes(&forged).map(|_| ()).unwrap_err().to_string();
        assert!(fault.contains(says) && !fault.contains('\n'), "{says}: {fault}");
    }
}

#[test]
fn a_chain_of_instances_is_opened_up_to_the_depth_that_stacks_have() {
    let fault = |bytes: &[u8]| PackedScene::from_bytes(bytes).map(|_| ()).unwrap_err().to_string();
    let (deepest, packed) = chain(MAX_INSTANCE_DEPTH);
    let opened = PackedScene::from_bytes(&deepest).unwrap();
    assert_eq!(opened.placement().instance_nodes().len(), 2 * MAX_INSTANCE_DEPTH + 1);
    let mut random = Random(3);
    let rays: Vec<Ray> = (0..4000)
        .map(|_| {
            let (target, direction) = (random.point(Vec3::ZERO, Vec3::new(18.0, 17.0, 9.0)), random.direction());
            Ray::new(target - direction * 30.0 * (random.unit() - 0.2), direction)
        })
        .collect();
    let cast = |scene: &PackedScene| rays.iter().map(|ray| walk::cast(scene, ray)).collect::<Vec<Hit>>();
    assert_eq!(cast(&opened), cast(&packed));
    let blocked = |scene: &PackedScene| rays.iter().map(|ray| walk::occluded(scene, ray)).collect::<Vec<bool>>();
    assert_eq!(blocked(&opened), blocked(&packed));
    // Another tree is the same scene; an instance elsewhere is not.
    assert_ne!(opened.placement().instance_nodes(), packed.placement().instance_nodes());
    assert_eq!(opened.content_hash(), packed.content_hash());
    let mut moved = deepest;
    forge(&mut moved, b"INST", |records| records[..4].copy_from_slice(&0.5_f32.to_le_bytes()));
    assert!(PackedScene::from_bytes(&moved).map_or(true, |scene| scene.content_hash() != packed.content_hash()));
    for levels in [MAX_INSTANCE_DEPTH + 1, 40, 63, 64, 1000] {
        let fault = fault(&chain(levels).0);
        assert!(fault.contains("the tree over instances is more than 32 levels deep"), "{levels}: {fault}");
    }
}

#[test]
fn nodes_over_instances_that_share_a_child_or_forget_one_are_refused() {
    let fault = |node: usize, index: u32, is_leaf: u32| {
        let (mut bytes, _) = chain(20);
        forge(&mut bytes, b"INOD", |nodes| {
            nodes[32 * node + 12..][..4].copy_from_slice(&index.to_le_bytes());
            nodes[32 * node + 28..][..4].copy_from_slice(&is_leaf.to_le_bytes());
        });
        PackedScene::from_bytes(&bytes).map(|_| ()).unwrap_err().to_string()
    };
    // Were every node so, there would be 2²⁰ ways to the last one.
    assert!(fault(3, 5, 0).contains("node 5 of the tree over instances has two parents"));
    assert!(fault(19, 0, 1).contains("node 20 of the tree over instances has no parent"));
    assert!(fault(40, 19, 1).contains("instance 20 is in no leaf"));
    assert!(fault(40, 21, 1).contains("points outside"));
    assert!(fault(2, 2, 0).contains("points outside") && fault(2, 41, 0).contains("points outside"));
}

#[test]
fn instances_without_a_tree_over_them_are_refused() {
    let mut bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    let size = bytes[64..].windows(4).position(|tag| tag == b"INOD").unwrap() + 64 + 16;
    bytes[size..size + 8].fill(0);
    forge(&mut bytes, b"INST", |_| ());
    let fault = PackedScene::from_bytes(&bytes).map(|_| ()).unwrap_err().to_string();
    assert!(fault.contains("instance 0 is in no leaf"), "{fault}");
}

#[test]
fn a_grid_whose_cells_reach_farther_than_devices_can_count_is_refused() {
    // One row of the largest cells; each of them is in the file.
    let fault = fault_of_grid(12, &[21, 3, 1, 1]);
    assert!(fault.contains("cells reach too far"), "{fault}");
    let fault = fault_of_grid(12, &[21, 2, 1, 1]);
    assert!(!fault.contains("cells reach too far"), "{fault}");
}

#[test]
fn a_scene_in_memory_is_untouched_by_what_happens_to_its_file() {
    let packed = PackedScene::pack(&scene()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    packed.save(&path).unwrap();
    let read = PackedScene::read(&path).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    bytes[64..].fill(0xff);
    std::fs::write(&path, &bytes).unwrap();
    assert_eq!(read.content_hash(), packed.content_hash());
    std::fs::write(&path, []).unwrap();
    assert_eq!(read.content_hash(), packed.content_hash());
    assert_eq!(read.to_scene(), scene());
    // Both ways to open a file refuse what is left of it.
    assert!(PackedScene::read(&path).is_err() && PackedScene::open(&path).is_err());
}

#[test]
fn bytes_are_copied_from_any_place_in_memory() {
    let packed = PackedScene::pack(&scene()).unwrap();
    let bytes = bytes_of(&packed);
    for offset in 0..9 {
        let mut shifted = vec![0; offset];
        shifted.extend_from_slice(&bytes);
        let opened = PackedScene::from_bytes(&shifted[offset..]).unwrap();
        shifted.fill(0xff);
        assert_eq!(opened.content_hash(), packed.content_hash(), "{offset}");
    }
}

#[test]
fn documentation_gives_the_size_of_every_record() {
    let bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    let text = include_str!("../../../docs/format.md");
    let check = |text: &str| {
        let sections = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        (64..64 + 32 * sections).step_by(32).all(|at| {
            let tag = std::str::from_utf8(&bytes[at..at + 4]).unwrap();
            let size = u32::from_le_bytes(bytes[at + 4..at + 8].try_into().unwrap());
            text.lines().any(|line| line.starts_with(&format!("| `{tag}` |")) && line.ends_with(&format!("| {size} |")))
        })
    };
    assert!(check(text));
    assert!(!check(&text.replace("| 68 |", "| 72 |")));
}

#[test]
fn a_merged_scene_is_saved_with_its_parts_and_their_damage_noticed() {
    let packed = PackedScene::pack_merged(&models(12, 8)).unwrap();
    assert!(packed.is_merged());
    let bytes = bytes_of(&packed);
    let opened = PackedScene::from_bytes(&bytes).unwrap();
    assert_eq!(opened.content_hash(), packed.content_hash());
    assert_eq!(opened.to_scene(), packed.to_scene());
    assert_eq!(opened.split().content_hash(), packed.split().content_hash());
    let rays = mixed(&noise(IVec3::splat(-30), 60, 0.05, 1, 1), 2000, 3);
    let cast = |scene: &PackedScene| rays.iter().map(|ray| scene.cast(ray)).collect::<Vec<_>>();
    assert_eq!(cast(&opened), cast(&packed));
    assert!(cast(&opened).iter().flatten().count() > 200);
    // Numbers that say something impossible, their checksums mended.
    let faults: [(&[u8; 4], usize, u32); 9] = [
        (b"PART", 0, 1),
        (b"PART", 4, 1000),
        (b"PART", 12, 0),
        (b"PART", 16, 1 << 24),
        (b"POWN", 0, u32::MAX),
        (b"POWN", 4, 999),
        (b"PSHR", 0, 0),
        (b"PCOV", 0, 999),
        (b"PCOV", 16, 9),
    ];
    for (tag, at, value) in faults {
        let mut damaged = bytes.clone();
        forge(&mut damaged, tag, |section| section[at..at + 4].copy_from_slice(&value.to_le_bytes()));
        assert!(PackedScene::from_bytes(&damaged).is_err(), "{value} at {at} of {}", tag.escape_ascii());
    }
    // Whatever a file says there, it is refused, or can be traced and comes apart.
    let mut random = Random(11);
    let mut opens = 0;
    for _ in 0..600 {
        let mut damaged = bytes.clone();
        let tag = [b"PART", b"POWN", b"PSHR", b"PCOV", b"INST"][random.below(5)];
        forge(&mut damaged, tag, |section| {
            let at = random.below(section.len());
            section[at] = random.bits() as u8;
        });
        let Ok(scene) = PackedScene::from_bytes(&damaged) else { continue };
        opens += 1;
        cast(&scene).iter().flatten().for_each(|hit| _ = scene.material(hit));
        scene.split().validate().unwrap();
    }
    assert!(opens > 20 && opens < 580, "{opens}");
}
