//! Files of voxels: the same build from every format, directions, colours, and damage of every kind. Nothing panics. Also
//! replays the corpora of the fuzz target.

use crate::check_voxels as check;
use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use crate::voxel_samples::{COLORS, SIZE, block_at, minecraft, others, shaped};
use crate::zipped::gzip;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Limits, Voxels};
use voxtrace::material::srgb_from_linear;
use voxtrace::mesh::UpAxis;
use voxtrace_test_support::data;

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    [minecraft(), others()].concat()
}

fn read(name: &str, bytes: &[u8]) -> Voxels {
    import::voxels_from_bytes(bytes, Path::new(name), &ImportOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The voxels of a scene in the world, with the colours of their materials.
fn placed(scene: &Scene) -> BTreeMap<[i32; 3], [u8; 3]> {
    let mut found = BTreeMap::new();
    for instance in &scene.instances {
        for (voxel, material) in scene.grids[instance.grid].voxels() {
            let middle = instance.world_from_grid.point(voxel.as_vec3() + 0.5);
            let color = scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
            assert_eq!(found.insert(middle.floor().as_ivec3().to_array(), color), None, "two voxels at one place");
        }
    }
    found
}

/// As [`placed`], from the lowest corner on.
fn from_corner(scene: &Scene) -> BTreeMap<IVec3Key, [u8; 3]> {
    let found = placed(scene);
    let min = found.keys().fold(IVec3::MAX, |min, &at| min.min(IVec3::from_array(at)));
    found.into_iter().map(|(at, color)| ((IVec3::from_array(at) - min).to_array(), color)).collect()
}

type IVec3Key = [i32; 3];

#[test]
fn a_build_has_the_same_blocks_from_every_format_and_is_not_mirrored() {
    let mut wanted = BTreeMap::new();
    for x in 0..SIZE[0] {
        for y in 0..SIZE[1] {
            for z in 0..SIZE[2] {
                let block = block_at(x, y, z);
                if block > 0 {
                    // East is x, south −y, up z.
                    wanted.insert([x, SIZE[2] - 1 - z, y].map(|c| c as i32), COLORS[block]);
                }
            }
        }
    }
    for (name, bytes) in others() {
        let scene = read(name, &bytes).scene;
        let found = from_corner(&scene);
        let in_six_bits = |color: [u8; 3]| color.map(|channel| channel >> 2 << 2 | channel >> 6);
        if name.ends_with("binvox") {
            assert!(found.keys().eq(wanted.keys()) && found.values().all(|color| *color == [0xcc; 3]), "{name}");
        } else if name.ends_with("vox") || name.ends_with("kvx") {
            let wanted: BTreeMap<_, _> = wanted.iter().map(|(&at, &color)| (at, in_six_bits(color))).collect();
            assert_eq!(found, wanted, "{name}");
        } else {
            assert_eq!(found, wanted, "{name}");
            let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
            let has_names = name.contains(".qb");
            assert_eq!(names.len() == 2 && names == ["west", "east"], has_names, "{name}: {names:?}");
        }
    }
    for (name, bytes) in minecraft() {
        let voxels = read(name, &bytes);
        assert_eq!(from_corner(&voxels.scene), wanted, "{name}");
        let glowing = voxels.scene.materials.iter().filter(|material| material.is_emissive()).count();
        assert_eq!((glowing, voxels.scene.name.as_str()), (1, Path::new(name).file_stem().unwrap().to_str().unwrap()));
        assert_eq!(voxels.notes.len(), usize::from(name == "gzip.mca"), "{name}: {:?}", voxels.notes);
    }
}

#[test]
fn a_chunk_lies_where_the_file_says() {
    let of_name = |wanted: &str| minecraft().into_iter().find(|(name, _)| *name == wanted).unwrap().1;
    let corner = |scene: &Scene| placed(scene).keys().fold(IVec3::MAX, |min, &at| min.min(IVec3::from_array(at)));
    // Chunk (2, 1): x from 32, z from 16 to 31 and so y from −32; its three rows in the north end at −17.
    assert_eq!(corner(&read("lz4.mca", &of_name("lz4.mca")).scene), IVec3::new(32, -19, -64));
    assert_eq!(corner(&read("raw.mca", &of_name("raw.mca")).scene), IVec3::new(32, -19, 0));
}

#[test]
fn a_world_is_read_by_its_folder_with_every_region_in_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let region = minecraft().into_iter().find(|(name, _)| *name == "r.0.0.mca").unwrap().1;
    fs::create_dir(folder.path().join("region")).unwrap();
    for name in ["r.-1.3.mca", "r.0.3.mca", "r.0.4.mca"] {
        fs::write(folder.path().join("region").join(name), &region).unwrap();
    }
    fs::write(folder.path().join("region/r.1.3.mca"), []).unwrap();
    for path in [folder.path().to_owned(), folder.path().join("region")] {
        assert_eq!(import::detect(&path, &ImportOptions::default()).unwrap().name, "Minecraft world");
        let scene = import::open(&path, &ImportOptions::default()).unwrap();
        let single = placed(&read("r.0.0.mca", &region).scene);
        let mut wanted = BTreeMap::new();
        for [x, y] in [[0, 0], [512, 0], [512, -512]] {
            wanted.extend(single.iter().map(|(at, color)| ([at[0] + x, at[1] + y, at[2]], *color)));
        }
        assert_eq!(placed(&scene), wanted);
    }
    let empty = tempfile::tempdir().unwrap();
    assert!(import::open(empty.path(), &ImportOptions::default()).is_err());
}

#[test]
fn another_axis_can_point_up() {
    let (name, bytes) = &minecraft()[0];
    let open = |up| {
        let options = ImportOptions { up, ..ImportOptions::default() };
        placed(&import::voxels_from_bytes(bytes, Path::new(name), &options).unwrap().scene)
    };
    assert_eq!(open(None), open(Some(UpAxis::Y)));
    let as_it_is = open(Some(UpAxis::Z));
    for ([x, y, z], color) in open(None) {
        // Our y is −z of the file, so its z is −1 − y; both count whole voxels.
        assert_eq!(as_it_is.get(&[x, z, -1 - y]), Some(&color));
    }
}

#[test]
fn a_file_cut_at_any_byte_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        let is_region = name.ends_with("mca") || name.ends_with("mcr");
        for length in 0..bytes.len() {
            check::check(name, &bytes[..length]);
            // Regions end in padding, lines of text with any voxel; Goxel's chunks and the models of Build are as many as there are.
            let may_end = ["qef", "gox", "kvx"].iter().any(|extension| name.ends_with(extension));
            if !is_region && !may_end {
                let cut = import::voxels_from_bytes(&bytes[..length], Path::new(name), &ImportOptions::default());
                assert!(cut.is_err(), "{name} {length}");
            }
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error() {
    let numbers = [0, 1, 255, 65_535, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x0000_0080];
    let texts = ["\x0a\0\0", "\x09\0\0", "\x0c", "\x7f\x7f", "\0", "\x03\0\x01x"];
    let mut random = Random(7);
    for (name, bytes) in samples() {
        let is_region = name.ends_with("mca") || name.ends_with("mcr");
        let raw = if is_region { Vec::new() } else { unpacked(&bytes) };
        for _ in 0..1_500 {
            check::check(name, &damaged(&bytes, &numbers, &texts, |end| random.below(end)));
            // Damage inside what is compressed, packed again, gets past the checksum.
            if !raw.is_empty() {
                check::check(name, &damaged(&raw, &numbers, &texts, |end| random.below(end)));
            }
        }
    }
}

/// The bytes inside gzip or zlib, or nothing.
fn unpacked(bytes: &[u8]) -> Vec<u8> {
    use std::io::Read;
    let mut raw = Vec::new();
    let read = match bytes[0] {
        0x1f => flate2::read::GzDecoder::new(bytes).read_to_end(&mut raw),
        0x78 => flate2::read::ZlibDecoder::new(bytes).read_to_end(&mut raw),
        _ => Ok(0),
    };
    read.unwrap();
    raw
}

#[test]
fn sixteen_megabytes_of_noise_are_refused_in_every_format() {
    let mut random = Random(8);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for (name, head) in [
        ("a.schem", &b"\x0a\0\0\x0a\0\x01"[..]),
        ("b.schem", b""),
        ("c.schematic", b"\x1f\x8b\x08\0"),
        ("d.litematic", b"\x78\x9c"),
        ("e.mca", b"\0\0\x02\x01"),
        ("f.mca", b""),
        ("g.qb", b"\x01\x01\0\0\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\x01\0\0\0\0"),
        ("h.qb", b""),
        ("k.qbt", b"QB 2\x01\0\0\0\0\0\0\0\0\0\0\0\0\0COLORMAP\0\0\0\0DATATREE\x01\0\0\0"),
        ("l.qbt", b"QB 2"),
        ("m.qbcl", b"QBCL\0\0\0\0\x02\0\0\0\0\0\0\0"),
        ("n.qef", b"Qubicle Exchange Format\n\n\n99 99 99\n1\n1 1 1\n"),
        ("i.binvox", b"#binvox 1\ndim 300 300 300\ndata\n"),
        ("j.binvox", b"abc"),
        ("o.vox", b"\x20\0\0\0\x20\0\0\0\x20\0\0\0"),
        ("p.kv6", b"Kvxl\x20\0\0\0\x20\0\0\0\x20\0\0\0"),
        ("q.kvx", b"\0\0\x20\0\x20\0\0\0\x20\0\0\0\x20\0\0\0"),
        ("r.vxl", b""),
        ("s.vxl", b"\0\x20\x07\x09\x20\0\0\0\x20\0\0\0"),
        ("t.gox", b"GOX \x02\0\0\0LAYR\0\x01\0\0\x01\0\0\0"),
    ] {
        noise[..head.len()].copy_from_slice(head);
        let result = import::voxels_from_bytes(&noise, Path::new(name), &ImportOptions::default());
        assert!(result.is_err(), "{name}");
    }
}

#[test]
fn a_picture_of_a_project_that_is_larger_than_numbers_is_cut_off() {
    let mut bytes = b"QBCL\0\0\0\0\x02\0\0\0".to_vec();
    // 2^31 by 2^31: four bytes for each are 2^64, which a wrapped product would take for none.
    bytes.extend([0, 0, 0, 0x80, 0, 0, 0, 0x80]);
    bytes.resize(200, 0);
    let error = import::voxels_from_bytes(&bytes, Path::new("m.qbcl"), &ImportOptions::default()).unwrap_err();
    assert!(error.to_string().contains("picture"), "{error}");
}

#[test]
fn each_limit_holds() {
    for (name, bytes) in samples() {
        for limits in [
            Limits { bytes: 50, ..Limits::default() },
            Limits { voxels: 20, ..Limits::default() },
            Limits { items: 1, ..Limits::default() },
            Limits { depth: 1, ..Limits::default() },
        ] {
            // Nothing is nested in these, and most have no items.
            let ends = |extensions: &[&str]| extensions.iter().any(|extension| name.ends_with(extension));
            let has_no_items = ends(&["vox", "kv6", "kvx", "vxl"]);
            let is_flat = has_no_items || ends(&["schematic", "qb", "qef", "gox"]);
            if limits.depth == 1 && is_flat || limits.items == 1 && has_no_items {
                continue;
            }
            let options = ImportOptions { limits, ..ImportOptions::default() };
            let error = import::voxels_from_bytes(&bytes, Path::new(name), &options).unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{name} {limits:?}: {error}");
        }
    }
}

#[test]
fn what_unpacks_to_more_than_may_be_is_refused_and_a_file_that_is_cut_off_is_told() {
    let head = b"\x0a\0\0\x07\0\x06Blocks\x10\0\0\0";
    let bomb = gzip(&[&head[..], &vec![0; 0x1000_0000]].concat());
    assert!(bomb.len() < 300_000);
    let read = |limits| {
        let options = ImportOptions { limits, ..ImportOptions::default() };
        import::voxels_from_bytes(&bomb, Path::new("bomb.schematic"), &options).unwrap_err()
    };
    let error = read(Limits { bytes: 0x800_0000, ..Limits::default() });
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
    // Deflate can make so much of a byte, as it does of flat worlds: the file is only not whole.
    let error = read(Limits::default());
    assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    corpus::replay("voxels", &[samples(), shaped()].concat(), check::check_all);
}

#[test]
fn shared_builds_have_the_blocks_that_the_manifest_counts() {
    let Some(data) = data() else { return };
    // Blocks that are not air, as the manifest has them from other programs; those of these that nobody sees are left out.
    for (name, wanted, unseen) in [
        ("1wide_15ss_detector.schem", 165, 0),
        ("all_blocks.litematic", 964, 19),
        ("smallhouse1.schem", 3_201, 0),
        ("v2_block_entities_test.schem", 3, 0),
        ("v2_house.schem", 1_084, 0),
        ("v2_newblocks.schem", 17, 0),
        ("viking-house1.schematic", 2_492, 0),
        ("mcschemes/7-spruce-tree-bundle.schematic", 11_254, 0),
        ("mcschemes/HC7_Oak_Church.litematic", 2_634, 0),
        ("mcschemes/HC8_Christmas_house.litematic", 2_909, 0),
        ("mcschemes/Statue_Of_Death.litematic", 17_782, 0),
        ("mcschemes/medieval-house-bundle.schematic", 8_899, 0),
    ] {
        let voxels = import::read_voxels(&data.join("minecraft").join(name), &ImportOptions::default()).unwrap();
        let count: u64 = voxels.scene.grids.iter().map(|grid| grid.count()).sum();
        assert_eq!(count + unseen, wanted, "{name}");
        // As many as nbtlib counts.
        let notes: &[&str] = match name {
            "all_blocks.litematic" => &["not shown: 30 entities"],
            "mcschemes/HC8_Christmas_house.litematic" => &["not shown: 2 entities"],
            "mcschemes/Statue_Of_Death.litematic" => &["not shown: 21 entities"],
            _ => &[],
        };
        assert_eq!(voxels.notes, notes, "{name}");
    }
}

#[test]
fn shared_models_have_the_size_that_their_headers_say() {
    let Some(data) = data() else { return };
    for (name, matrices, least) in [
        ("qubicle/chr_knight.qb", 17, 1_000),
        ("qubicle/deciduous3.qb", 1, 1_000),
        ("qubicle/qubicle.qb", 10, 100),
        ("qubicle/rgb.qb", 1, 3),
        ("qubicle/rgb_small.qb", 1, 3),
        ("qubicle/rgb_small.qbt", 1, 3),
        ("qubicle/rgb_small.qbcl", 1, 3),
        ("qubicle/qubicle.qbt", 17, 2_612),
        ("qubicle/qubicle.qbcl", 18, 5_164),
        ("qubicle/chr_knight.qbcl", 18, 5_164),
        ("qubicle/qubicle.qef", 1, 427),
        ("vox/vengi/slab6_vox_test.vox", 1, 2_612),
        ("binvox/test.binvox", 1, 10_000),
    ] {
        let scene = import::open(&data.join(name), &ImportOptions::default()).unwrap();
        assert_eq!(scene.instances.len(), matrices, "{name}");
        let count: u64 = scene.grids.iter().map(|grid| grid.count()).sum();
        assert!(count >= least, "{name}: {count}");
    }
}

#[test]
fn a_shared_model_is_the_same_from_each_format_of_qubicle() {
    let Some(data) = data() else { return };
    let open = |name: &str| import::open(&data.join("qubicle").join(name), &ImportOptions::default()).unwrap();
    for (first, second) in [
        ("rgb.qb", "rgb.qbcl"),
        ("rgb.qb", "rgb.qef"),
        ("rgb_small.qb", "rgb_small.qbt"),
        ("rgb_small.qb", "rgb_small.qbcl"),
    ] {
        assert_eq!(placed(&open(first)), placed(&open(second)), "{second}");
    }
    // A knight, whose parts reach into each other; the project has a second figure beside him.
    let part = |scene: &Scene, index: usize| {
        let single = Scene { instances: vec![scene.instances[index].clone()], ..scene.clone() };
        (scene.instances[index].name.clone(), placed(&single))
    };
    let knight = open("chr_knight.qb");
    for name in ["qubicle.qbt", "chr_knight.qbcl"] {
        let mut other = open(name);
        other.instances.retain(|instance| instance.name != "Compound");
        assert_eq!(other.instances.len(), knight.instances.len(), "{name}");
        for index in 0..knight.instances.len() {
            assert_eq!(part(&other, index), part(&knight, index), "{name}");
        }
    }
}

#[test]
fn letters_of_a_shared_model_read_as_those_of_the_same_model_from_magicavoxel() {
    let Some(data) = data() else { return };
    let read = |name: &str| placed(&import::open(&data.join(name), &ImportOptions::default()).unwrap());
    let (wanted, model) = (read("vox/vengi/rgb.vox"), read("qubicle/rgb.qb"));
    // One was looked at from the other side: turned by half a circle about z, not mirrored.
    let turned = |found: &BTreeMap<[i32; 3], [u8; 3]>, x: i32, y: i32| {
        let low = |axis: usize, sign: i32| found.keys().map(|at| at[axis] * sign).min().unwrap();
        let moved = |at: &[i32; 3]| [at[0] * x - low(0, x), at[1] * y - low(1, y), at[2] - low(2, 1)];
        found.keys().map(moved).collect::<std::collections::BTreeSet<_>>()
    };
    assert_eq!(turned(&model, -1, -1), turned(&wanted, 1, 1));
    assert_ne!(turned(&model, -1, 1), turned(&wanted, 1, 1));
    assert_ne!(turned(&model, 1, -1), turned(&wanted, 1, 1));
}

#[test]
fn a_run_that_is_longer_than_its_layer_is_refused() {
    let mut bytes = others().into_iter().find(|(name, _)| *name == "runs.qb").unwrap().1;
    let at = bytes.windows(4).position(|word| word == [2, 0, 0, 0]).unwrap();
    let run = bytes[at + 12..].windows(8).position(|words| words[..4] == [2, 0, 0, 0]).unwrap() + at + 16;
    bytes[run..run + 4].copy_from_slice(&u32::MAX.to_le_bytes());
    let error = import::voxels_from_bytes(&bytes, Path::new("a.qb"), &ImportOptions::default()).unwrap_err();
    assert!(error.to_string().contains("a layer with more than"), "{error}");
}
