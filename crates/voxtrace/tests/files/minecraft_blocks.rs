//! Blocks of Minecraft with their shapes: sizes, what joins what, what hides what, textures of resource packs; and builds and worlds of which
//! a part is damaged.

use crate::voxel_samples::{minecraft, region_of, schem_of};
use crate::zipped::gzip;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, BlockOptions, BlockSize, ImportErrorKind, ImportOptions, Limits, Voxels};
use voxtrace::material::srgb_from_linear;

type Placed = BTreeMap<[i32; 3], [u8; 3]>;

fn options(size: BlockSize, shell: bool) -> ImportOptions {
    ImportOptions { blocks: BlockOptions { size, shell, resource_pack: None }, ..ImportOptions::default() }
}

fn read(name: &str, bytes: &[u8], options: &ImportOptions) -> Voxels {
    import::voxels_from_bytes(bytes, Path::new(name), options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The voxels of a scene in the world with their colours.
fn placed(scene: &Scene) -> Placed {
    let mut found = BTreeMap::new();
    for instance in &scene.instances {
        for (voxel, material) in scene.grids[instance.grid].voxels() {
            let middle = instance.world_from_grid.point(voxel.as_vec3() + 0.5).floor().as_ivec3();
            let color = scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
            assert_eq!(found.insert(middle.to_array(), color), None, "two voxels at one place");
        }
    }
    found
}

/// A row of blocks from west to east, each a place apart from the next where `gap` is 2.
fn row(names: &[&str], gap: usize) -> Vec<u8> {
    let palette: Vec<&str> = ["air"].into_iter().chain(names.iter().copied()).collect();
    schem_of([gap * names.len(), 1, 1], &palette, |x, _, _| if x % gap == 0 { x / gap + 1 } else { 0 })
}

/// The voxels of one block of 16³, from the west, south and below.
fn block(name: &str) -> Placed {
    placed(&read("a.schem", &row(&[name], 1), &options(BlockSize::Sixteen, false)).scene)
}

/// The lowest and one past the highest corner.
fn extent(voxels: &Placed) -> [[i32; 3]; 2] {
    let corner =
        |by: fn(IVec3, IVec3) -> IVec3, from| voxels.keys().fold(from, |found, at| by(found, IVec3::from_array(*at)));
    [corner(IVec3::min, IVec3::MAX).to_array(), (corner(IVec3::max, IVec3::MIN) + 1).to_array()]
}

#[test]
fn states_turn_blocks_as_the_game_turns_them() {
    // In the order of our axes: east, north, up.
    for (name, wanted) in [
        ("oak_slab[type=bottom]", [[0, 0, 0], [16, 16, 8]]),
        ("oak_slab[type=top]", [[0, 0, 8], [16, 16, 16]]),
        ("oak_door[facing=north,half=lower,open=false,hinge=left]", [[0, 0, 0], [16, 3, 16]]),
        ("oak_door[facing=east,half=lower,open=false,hinge=left]", [[0, 0, 0], [3, 16, 16]]),
        ("oak_trapdoor[facing=south,half=top,open=false]", [[0, 0, 13], [16, 16, 16]]),
        ("oak_trapdoor[facing=south,half=top,open=true]", [[0, 13, 0], [16, 16, 16]]),
        ("oak_fence[north=true,east=false,south=false,west=false]", [[6, 6, 0], [10, 16, 16]]),
        ("glass_pane[north=false,east=true,south=false,west=true]", [[0, 7, 0], [16, 9, 16]]),
        ("white_carpet", [[0, 0, 0], [16, 16, 1]]),
        ("snow[layers=3]", [[0, 0, 0], [16, 16, 6]]),
        ("ladder[facing=west]", [[15, 0, 0], [16, 16, 16]]),
        ("end_rod[facing=west]", [[0, 6, 6], [16, 10, 10]]),
        ("water[level=0]", [[0, 0, 0], [16, 16, 14]]),
        ("lever[face=floor,facing=north,powered=false]", [[5, 4, 0], [11, 13, 10]]),
        ("chest[facing=north,type=left]", [[1, 1, 0], [16, 16, 14]]),
        ("lantern[hanging=true]", [[5, 5, 1], [11, 11, 16]]),
        ("cactus", [[1, 1, 0], [15, 15, 16]]),
        ("poppy", [[0, 0, 0], [16, 16, 16]]),
        ("stone", [[0, 0, 0], [16, 16, 16]]),
    ] {
        let voxels = block(name);
        let found = extent(&voxels);
        if name == "poppy" {
            assert!(found[1][2] < 16 && voxels.len() < 400, "{name}: {found:?}");
        } else {
            assert_eq!(found, wanted, "{name}");
        }
    }
    let stairs = block("oak_stairs[facing=west,half=bottom,shape=straight]");
    assert_eq!(stairs.len(), 3 * 16 * 16 * 16 / 4);
    assert!(stairs.contains_key(&[3, 8, 12]) && !stairs.contains_key(&[12, 8, 12]));
}

#[test]
fn full_cubes_are_the_same_at_every_size_from_every_format() {
    for (name, bytes) in minecraft() {
        let single = placed(&read(name, &bytes, &options(BlockSize::One, true)).scene);
        let double = placed(&read(name, &bytes, &options(BlockSize::Two, false)).scene);
        let mut wanted = Placed::new();
        for ([x, y, z], color) in single {
            for part in 0..8 {
                wanted.insert([2 * x + (part & 1), 2 * y + (part >> 1 & 1), 2 * z + (part >> 2)], color);
            }
        }
        assert!(double == wanted, "{name}");
    }
}

#[test]
fn smaller_blocks_keep_what_is_thin() {
    let count = |name: &str, size| read("a.schem", &row(&[name], 1), &options(size, false)).scene.grids[0].count();
    let counts = |name| BlockSize::ALL.map(|size| count(name, size));
    assert_eq!(counts("stone"), [1, 8, 64, 512, 4096]);
    assert_eq!(counts("stone_slab[type=bottom]"), [1, 4, 32, 256, 2048]);
    assert_eq!(counts("white_carpet"), [1, 4, 16, 64, 256]);
    // Four voxels of four around the middle, three high.
    assert_eq!(counts("torch")[..3], [1, 8, 12]);
    for name in ["glass_pane", "oak_fence", "lever", "rail", "poppy", "chain", "vine"] {
        assert!(counts(name).iter().all(|&count| count > 0), "{name}");
    }
}

#[test]
fn what_states_do_not_say_neighbours_do() {
    let gap = |names: &[&str]| {
        let voxels = placed(&read("a.schem", &row(names, 1), &options(BlockSize::Sixteen, false)).scene);
        voxels.keys().any(|at| at[0] == 14)
    };
    assert!(gap(&["oak_fence", "birch_fence"]) && gap(&["oak_fence", "stone"]));
    assert!(!gap(&["oak_fence", "torch"]) && !gap(&["oak_fence[north=false,east=false]", "oak_fence"]));
    assert!(gap(&["glass_pane", "iron_bars"]) && !gap(&["glass_pane", "oak_fence"]));
    // Water has no step where there is more of it above.
    let column = schem_of([1, 2, 1], &["water"], |_, _, _| 0);
    let [_, [.., top]] = extent(&placed(&read("a.schem", &column, &options(BlockSize::Sixteen, false)).scene));
    assert_eq!(top, 16 + 14);
    let column = placed(&read("a.schem", &column, &options(BlockSize::Sixteen, false)).scene);
    assert!(column.contains_key(&[5, 5, 15]));
    // A fence in water is in water.
    assert!(block("oak_fence[waterlogged=true,north=false]").len() == 14 * 256 + 2 * 16);
}

#[test]
fn a_shell_has_all_that_has_an_empty_or_clear_neighbour_and_of_cubes_nothing_else() {
    let cubes = ["air", "stone", "glass", "dirt", "oak_log", "water"];
    let shapes = ["air", "stone", "glass", "oak_stairs[facing=east,half=bottom,shape=straight]", "oak_fence", "dirt"];
    for (names, size) in
        [cubes, shapes].iter().flat_map(|names| BlockSize::ALL[1..].iter().map(move |size| (names, *size)))
    {
        let bytes = schem_of([4, 4, 4], names, |x, y, z| (x * 7 + y * 5 + z * 3) % 11 % 6);
        let full = read("a.schem", &bytes, &options(size, false)).scene;
        let shell = placed(&read("a.schem", &bytes, &options(size, true)).scene);
        let grid = &full.grids[0];
        let is_opaque = |at: IVec3| grid.get(at).is_some_and(|m| full.materials[usize::from(m)].transmission == 0.0);
        let steps = [IVec3::X, IVec3::NEG_X, IVec3::Y, IVec3::NEG_Y, IVec3::Z, IVec3::NEG_Z];
        let seen = |at: &[i32; 3]| steps.iter().any(|&step| !is_opaque(IVec3::from_array(*at) + step));
        let full = placed(&full);
        let wanted: Placed = full.iter().filter(|(at, _)| seen(at)).map(|(at, color)| (*at, *color)).collect();
        if *names == cubes {
            assert!(shell == wanted, "{size:?}: {} {}", shell.len(), wanted.len());
        }
        // A face that hides another one in part does not count as hiding it.
        let edge = size.edge() as i32;
        let is_at_border = |at: &[i32; 3]| at.iter().any(|c| c % edge == 0 || c % edge == edge - 1);
        assert!(wanted.iter().all(|(at, color)| shell.get(at) == Some(color)), "{size:?}");
        assert!(
            shell.iter().all(|(at, color)| full.get(at) == Some(color) && (seen(at) || is_at_border(at))),
            "{size:?}"
        );
        assert!(size <= BlockSize::Four || shell.len() < full.len());
    }
}

#[test]
fn a_large_build_takes_memory_for_its_surface_alone() {
    let edge = 160;
    let bytes = schem_of([edge, 8, edge], &["stone", "grass_block", "air"], |_, y, _| if y < 7 { y / 6 } else { 2 });
    let scene = read("a.schem", &gzip(&bytes), &options(BlockSize::Sixteen, true)).scene;
    let (side, height) = (edge as u64 * 16, 7 * 16);
    // 179,200 blocks of 4,096 voxels would be 734 million.
    let shell = 2 * side * side + 4 * (side - 1) * (height - 2);
    assert_eq!(scene.grids[0].count(), shell);
    let few = Limits { voxels: shell - 1, ..Limits::default() };
    let options = ImportOptions { limits: few, ..options(BlockSize::Sixteen, true) };
    let error = import::voxels_from_bytes(&bytes, Path::new("a.schem"), &options).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
}

fn png(width: u32, height: u32, texel: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgba);
    let texels: Vec<u8> = (0..width * height).flat_map(|at| texel(at % width, at / width)).collect();
    encoder.write_header().unwrap().write_image_data(&texels).unwrap();
    bytes
}

/// A resource pack of our own: pixels that tell where they are.
fn pack() -> Vec<(&'static str, Vec<u8>)> {
    let at = |blue: u8| move |x: u32, y: u32| [x as u8 * 10, y as u8 * 10, blue, 255];
    vec![
        ("stone", png(16, 16, at(0))),
        ("oak_log", png(16, 16, at(50))),
        ("oak_log_top", png(16, 16, at(100))),
        ("short_grass", png(16, 16, |x, y| if x < 8 { [255, 255, 255, 255] } else { [0, y as u8, 0, 0] })),
        ("magma", png(16, 48, |_, y| if y < 16 { [7, 7, 7, 255] } else { [200, 0, 0, 255] })),
    ]
}

#[test]
fn faces_take_the_pixels_of_a_resource_pack() {
    let folder = tempfile::tempdir().unwrap();
    let inside = "assets/minecraft/textures/block";
    let zip = folder.path().join("pack.zip");
    let mut archive = zip::ZipWriter::new(std::fs::File::create(&zip).unwrap());
    let stored = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    let deflated = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
    std::fs::create_dir_all(folder.path().join(inside)).unwrap();
    for (index, (name, bytes)) in pack().iter().enumerate() {
        archive.start_file(format!("{inside}/{name}.png"), if index % 2 == 0 { stored } else { deflated }).unwrap();
        archive.write_all(bytes).unwrap();
        std::fs::write(folder.path().join(inside).join(format!("{name}.png")), bytes).unwrap();
    }
    archive.finish().unwrap();
    let names = ["stone", "oak_log[axis=y]", "oak_log[axis=x]", "short_grass", "magma_block", "dirt"];
    let read_with = |path: &Path, size| {
        let blocks = BlockOptions { size, resource_pack: Some(path.to_owned()), shell: true };
        placed(&read("a.schem", &row(&names, 2), &ImportOptions { blocks, ..ImportOptions::default() }).scene)
    };
    let voxels = read_with(&zip, BlockSize::Sixteen);
    assert!(voxels == read_with(folder.path(), BlockSize::Sixteen));
    // Above: to the east and to the south (our y goes north). On the south side: to the east and down.
    assert_eq!((voxels[&[3, 15 - 5, 15]], voxels[&[3, 0, 15 - 5]]), ([30, 50, 0], [30, 50, 0]));
    // The northern side is seen from the north: its left is east.
    assert_eq!(voxels[&[3, 15, 15 - 5]], [120, 50, 0]);
    assert_eq!((voxels[&[32 + 3, 10, 15]], voxels[&[32 + 3, 0, 10]]), ([30, 50, 100], [30, 50, 50]));
    assert_eq!((voxels[&[64 + 3, 10, 15]], voxels[&[64 + 15, 10, 10]]), ([30, 50, 50], [100, 50, 100]));
    let grass: BTreeSet<i32> = voxels.keys().filter(|at| (96..112).contains(&at[0])).map(|at| at[0] - 96).collect();
    assert_eq!(grass, (0..8).collect());
    assert_eq!(voxels[&[96, 15, 3]], [0x91, 0xbd, 0x59]);
    assert_eq!((voxels[&[128 + 4, 4, 15]], voxels[&[160 + 4, 4, 15]]), ([7, 7, 7], [0x86, 0x60, 0x43]));
    // Smaller ones have the mean: here of light, so a little above that of the numbers.
    let small = read_with(&zip, BlockSize::One);
    assert_eq!((small[&[8, 0, 0]], small[&[10, 0, 0]]), ([7, 7, 7], [0x86, 0x60, 0x43]));
    assert!((70..100).contains(&small[&[0, 0, 0]][0]), "{:?}", small[&[0, 0, 0]]);
    for wrong in ["nothing.zip", "pack.zip/no", "wrong.zip"] {
        std::fs::write(folder.path().join("wrong.zip"), b"PK no").unwrap();
        let blocks = BlockOptions { resource_pack: Some(folder.path().join(wrong)), ..BlockOptions::default() };
        let options = ImportOptions { blocks, ..ImportOptions::default() };
        let error = import::voxels_from_bytes(&row(&["stone"], 1), Path::new("a.schem"), &options).unwrap_err();
        assert!(error.path.ends_with(wrong), "{error}");
    }
}

#[test]
fn one_damaged_chunk_does_not_lose_its_region_nor_one_region_its_world() {
    let strict = ImportOptions { strict: true, ..ImportOptions::default() };
    let region = |damaged: &[usize], options: &ImportOptions| {
        import::voxels_from_bytes(&region_of(3, damaged), Path::new("r.0.0.mca"), options)
    };
    let whole = placed(&region(&[], &strict).unwrap().scene);
    let left = region(&[1], &ImportOptions::default()).unwrap();
    assert!(left.notes.len() == 1 && left.notes[0].starts_with("1 of the 3 chunks"), "{:?}", left.notes);
    let kept: Placed =
        whole.iter().filter(|(at, _)| !(16..32).contains(&at[0])).map(|(at, color)| (*at, *color)).collect();
    assert!(placed(&left.scene) == kept && kept.len() * 3 == whole.len() * 2);
    assert!(region(&[1], &strict).is_err() && region(&[0, 1, 2], &ImportOptions::default()).is_err());

    let world = tempfile::tempdir().unwrap();
    std::fs::write(world.path().join("r.0.0.mca"), region_of(3, &[])).unwrap();
    std::fs::write(world.path().join("r.1.0.mca"), &region_of(1, &[])[..5000]).unwrap();
    let voxels = import::read_voxels(world.path(), &ImportOptions::default()).unwrap();
    assert!(voxels.notes.len() == 1 && voxels.notes[0].starts_with("1 of the 2 regions"), "{:?}", voxels.notes);
    assert!(placed(&voxels.scene) == whole);
    let error = import::read_voxels(world.path(), &strict).unwrap_err();
    assert!(error.path.ends_with("r.1.0.mca"), "{error}");
}

#[test]
fn bytes_behind_a_schematic_do_not_refuse_it_unless_all_has_to_be_whole() {
    let strict = ImportOptions { strict: true, ..ImportOptions::default() };
    for (name, bytes) in minecraft().into_iter().filter(|(name, _)| !name.ends_with("mca") && !name.ends_with("mcr")) {
        let whole = read(name, &bytes, &strict);
        for behind in [&[0; 3][..], b"\x1f\x8b", b"some more bytes, as a disc pads files"] {
            let longer = [&bytes[..], behind].concat();
            let voxels = read(name, &longer, &ImportOptions::default());
            assert!(placed(&voxels.scene) == placed(&whole.scene), "{name}");
            assert!(
                voxels.notes.iter().any(|note| note.starts_with(&format!("{} bytes behind", behind.len()))),
                "{:?}",
                voxels.notes
            );
            assert!(import::voxels_from_bytes(&longer, Path::new(name), &strict).is_err(), "{name}");
        }
    }
    // Two streams in a row are one file.
    let (name, bytes) = minecraft().into_iter().find(|(name, _)| *name == "plain.schematic").unwrap();
    let halves = [gzip(&bytes[..40]), gzip(&bytes[40..])].concat();
    assert!(placed(&read(name, &halves, &strict).scene) == placed(&read(name, &bytes, &strict).scene));
}
