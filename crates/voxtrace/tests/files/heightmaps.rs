//! Heightmaps: the same heights from every format, directions, scale, colours, and damage of every kind. Nothing panics.

use crate::check_voxels as check;
use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use std::fs;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::import::{self, Data, Height, HeightOptions, ImportError, ImportOptions};
use voxtrace::material::srgb_from_linear;
use voxtrace::scene::Unit;
use voxtrace_test_support::data;

/// Points along x and from north to south.
const SIZE: [usize; 2] = [4, 3];
/// Heights, the northern row first: highest in the north-west.
const HEIGHTS: [u16; 12] = [90, 50, 40, 30, 20, 20, 20, 20, 10, 10, 20, 30];

fn asc(cell: &str, hole: bool) -> Vec<u8> {
    let mut text = format!("ncols 4\nnrows 3\nxllcorner 1000\nyllcorner 2000\n{cell}NODATA_value -9999\n");
    for row in HEIGHTS.chunks(4) {
        let row: Vec<String> =
            row.iter().map(|h| if hole && *h == 50 { "-9999".into() } else { format!("{h}.0") }).collect();
        text += &format!("{}\n", row.join(" "));
    }
    text.into_bytes()
}

fn png(deep: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 4, 3);
    encoder.set_depth(if deep { png::BitDepth::Sixteen } else { png::BitDepth::Eight });
    encoder.set_color(png::ColorType::Grayscale);
    let data = HEIGHTS.iter().flat_map(|h| if deep { (h * 300).to_be_bytes().to_vec() } else { vec![*h as u8] });
    encoder.write_header().unwrap().write_image_data(&data.collect::<Vec<_>>()).unwrap();
    bytes
}

/// A TIFF of floats with so many pages.
fn tiff(pages: u32) -> Vec<u8> {
    let mut bytes = b"II*\0".to_vec();
    bytes.extend(56u32.to_le_bytes());
    bytes.extend(HEIGHTS.iter().flat_map(|h| f32::from(*h).to_le_bytes()));
    for page in 0..pages {
        let start = bytes.len() as u32;
        let tags: [(u16, u16, u32); 9] = [
            (256, 3, 4),
            (257, 3, 3),
            (258, 3, 32),
            (259, 3, 1),
            (262, 3, 1),
            (273, 4, 8),
            (278, 3, 3),
            (279, 4, 48),
            (339, 3, 3),
        ];
        bytes.extend((tags.len() as u16).to_le_bytes());
        for (tag, kind, value) in tags {
            bytes.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
            bytes.extend([1, value].map(u32::to_le_bytes).concat());
        }
        let next = if page + 1 < pages { start + 2 + 12 * 9 + 4 } else { 0 };
        bytes.extend(next.to_le_bytes());
    }
    bytes
}

/// A model of the USGS, whose profiles run from south to north.
fn dem() -> Vec<u8> {
    let mut head = vec![b' '; 1024];
    let mut put = |at: usize, text: &str| head[at..at + text.len()].copy_from_slice(text.as_bytes());
    let double = |value: f64| format!("{:>24}", format!("{value:.15e}").replace('e', "D+0"));
    put(144, "     1     1     1    10");
    put(528, "     2     2     4");
    for (n, corner) in [[100.0, 0.0], [100.0, 20.0], [130.0, 20.0], [130.0, 0.0]].into_iter().flatten().enumerate() {
        put(546 + 24 * n, &double(corner));
    }
    put(816, "0.100000E+020.100000E+020.100000E+01     1     4");
    for column in 0..4 {
        let mut block = vec![b' '; 1024];
        let mut put = |at: usize, text: &str| block[at..at + text.len()].copy_from_slice(text.as_bytes());
        put(0, &format!("{:6}{:6}{:6}{:6}", 1, column + 1, 3, 1));
        put(24, &(double(100.0 + 10.0 * column as f64) + &double(0.0) + &double(0.0)));
        for row in 0..3 {
            put(144 + 6 * row, &format!("{:6}", HEIGHTS[(2 - row) * 4 + column]));
        }
        head.extend(block);
    }
    head
}

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.asc", asc("cellsize 10\n", false)),
        ("a.dem", dem()),
        ("eight.png", png(false)),
        ("sixteen.png", png(true)),
        ("float.tif", tiff(1)),
    ]
}

fn open(name: &str, bytes: &[u8], heights: HeightOptions) -> Result<Scene, ImportError> {
    let options = ImportOptions { heights, ..ImportOptions::default() };
    import::voxels_from_bytes(bytes, Path::new(name), &options).map(|voxels| voxels.scene)
}

/// The uppermost voxel of each column, north row first.
fn tops(scene: &Scene) -> Vec<Option<i32>> {
    let grid = &scene.grids[0];
    let column = |x: usize, row: usize| {
        (0..400).rev().find(|&z| grid.get(IVec3::new(x as i32, (SIZE[1] - 1 - row) as i32, z)).is_some())
    };
    (0..SIZE[1]).flat_map(|row| (0..SIZE[0]).map(move |x| (x, row))).map(|(x, row)| column(x, row)).collect()
}

#[test]
fn the_same_heights_from_every_format_are_the_same_columns() {
    let voxels = HeightOptions { height: Height::Voxels(81), ..HeightOptions::default() };
    let wanted: Vec<Option<i32>> = HEIGHTS.iter().map(|&h| Some(i32::from(h) - 10)).collect();
    for (name, bytes) in samples() {
        let scene = open(name, &bytes, voxels.clone()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(tops(&scene), wanted, "{name}");
        // From the lowest point to the highest.
        assert_eq!(scene.grids[0].bounds().unwrap().size(), IVec3::new(4, 3, 81), "{name}");
        let solid = open(name, &bytes, HeightOptions { shell: false, ..voxels.clone() }).unwrap();
        assert_eq!(solid.grids[0].count(), HEIGHTS.iter().map(|&h| u64::from(h) - 9).sum::<u64>(), "{name}");
    }
}

#[test]
fn a_grid_that_says_how_far_its_points_are_apart_is_true_to_scale() {
    for (name, bytes) in [("a.asc", asc("cellsize 10\n", false)), ("a.dem", dem())] {
        let scene = open(name, &bytes, HeightOptions::default()).unwrap();
        assert_eq!(tops(&scene).iter().flatten().max(), Some(&8), "{name}");
        assert_eq!(scene.voxel_size, 10.0, "{name}");
    }
    let scaled = HeightOptions { height: Height::Scale(0.5), ..HeightOptions::default() };
    assert_eq!(tops(&open("eight.png", &png(false), scaled).unwrap())[0], Some(40));
    // Without a scale: a quarter of the longer side.
    assert_eq!(tops(&open("eight.png", &png(false), HeightOptions::default()).unwrap())[0], Some(1));
    let options = ImportOptions::default();
    let degrees = import::voxels_from_bytes(
        &String::from_utf8(asc("cellsize 0.001\n", false))
            .unwrap()
            .replace("1000", "8")
            .replace("2000", "47")
            .into_bytes(),
        Path::new("a.asc"),
        &options,
    );
    let degrees = degrees.unwrap();
    assert!(degrees.notes[0].contains("degrees") && (degrees.scene.voxel_size - 111.32).abs() < 1e-9);
}

#[test]
fn holes_stay_empty() {
    let scene = open("a.asc", &asc("cellsize 10\n", true), HeightOptions::default()).unwrap();
    let tops = tops(&scene);
    assert_eq!((tops[1], tops[0], tops.iter().flatten().count()), (None, Some(8), 11));
}

#[test]
fn a_picture_is_laid_over_the_heights_with_its_first_row_in_the_north() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("colors.png");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(png::ColorType::Rgb);
    let corners = [[200, 0, 0], [0, 200, 0], [0, 0, 200], [90, 90, 90]];
    encoder.write_header().unwrap().write_image_data(corners.as_flattened()).unwrap();
    fs::write(&path, &bytes).unwrap();
    let options = HeightOptions { color_image: Some(path.clone()), ..HeightOptions::default() };
    let scene = open("eight.png", &png(false), options.clone()).unwrap();
    let color = |x, y| {
        let material = scene.grids[0].get(IVec3::new(x, y, 0)).unwrap();
        scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear)
    };
    assert_eq!([color(0, 2), color(3, 2), color(0, 0), color(3, 0)], corners);
    fs::write(&path, &bytes[..40]).unwrap();
    assert!(open("eight.png", &png(false), options).is_err());
}

#[test]
fn one_page_is_a_heightmap_and_several_are_slices() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.tif");
    for pages in [1, 2] {
        fs::write(&path, tiff(pages)).unwrap();
        let data = import::read(&path, &ImportOptions::default()).unwrap();
        assert_eq!((matches!(data, Data::Voxels(_)), matches!(data, Data::Volume(_))), (pages == 1, pages == 2));
    }
    fs::write(folder.path().join("b.png"), png(false)).unwrap();
    let name = |path: &Path| import::detect(path, &ImportOptions::default()).unwrap().name;
    assert_eq!((name(&folder.path().join("b.png")), name(folder.path())), ("heightmap", "slices"));
}

#[test]
fn overviews_and_masks_behind_a_page_are_no_slices() {
    // A page of 4 x 3 pixels, then half of it as a coarser one, then which of its pixels count.
    let mut out = std::io::Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut out).unwrap();
    for (kind, [width, height]) in [(0u32, [4, 3]), (1, [2, 1]), (4, [4, 3])] {
        let mut page = encoder.new_image::<tiff::encoder::colortype::Gray32Float>(width, height).unwrap();
        page.encoder().write_tag(tiff::tags::Tag::NewSubfileType, kind).unwrap();
        let heights: Vec<f32> = HEIGHTS.iter().take((width * height) as usize).map(|&h| h.into()).collect();
        page.write_data(&heights).unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.tif");
    fs::write(&path, out.into_inner()).unwrap();
    let Data::Voxels(found) = import::read(&path, &ImportOptions::default()).unwrap() else {
        panic!("a heightmap is read as a volume");
    };
    let bounds = found.scene.grids[0].bounds().unwrap();
    assert_eq!(([bounds.max.x, bounds.max.y], found.notes), ([4, 3], Vec::<String>::new()));
}

#[test]
fn a_grid_has_holes_where_nobody_says_how_they_are_marked_and_cells_that_are_no_squares() {
    let text = "ncols 2\nnrows 2\nxllcorner 100\nyllcorner 200\ndx 2\ndy 8\n5 -9999\n5 6\n";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.asc");
    // Some programs mark a text as UTF-8.
    fs::write(&path, format!("\u{feff}{text}")).unwrap();
    let Data::Voxels(found) = import::read(&path, &ImportOptions::default()).unwrap() else { panic!() };
    assert_eq!(found.scene.voxel_size, 4.0);
    assert!(found.notes[0].contains("cells of 2 by 8 are taken for squares"), "{:?}", found.notes);
    assert!((0..9).all(|z| found.scene.grids[0].get([1, 1, z].into()).is_none()));
    let place = found.scene.georeference.unwrap().coordinates_from_world;
    let corner = place.transform_point3(DVec3::new(2.0, 2.0, 0.0));
    assert_eq!([corner.x, corner.y], [104.0, 216.0]);
}

#[test]
fn a_grid_with_decimal_commas_is_the_one_with_points() {
    let text =
        "ncols 2\nnrows 2\nxllcorner 100.5\nyllcorner 200\ncellsize 2.5\nNODATA_value -9999.5\n5.25 -9999.5\n10.5 6\n";
    let folder = tempfile::tempdir().unwrap();
    let read = |text: &str| {
        let path = folder.path().join("a.asc");
        fs::write(&path, text).unwrap();
        let Data::Voxels(found) = import::read(&path, &ImportOptions::default()).unwrap() else { panic!() };
        let bounds = found.scene.grids[0].bounds().unwrap();
        let place = found.scene.georeference.unwrap().coordinates_from_world;
        (found.scene.voxel_size, found.scene.grids[0].count(), bounds.min, bounds.max, place)
    };
    let found = read(text);
    assert_eq!(found.0, 2.5);
    assert_eq!(read(&text.replace('.', ",")), found);
}

#[test]
fn damage_is_an_error_or_another_map_and_never_a_panic() {
    let numbers = [0, 1, 0x7fff_ffff, u32::MAX, f32::NAN.to_bits(), f32::INFINITY.to_bits()];
    let texts = ["nan", "inf", "-1", "1e400", "1e38", "99999999999", " ", "\n", "0", "-9999", "D+99"];
    let mut random = Random(11);
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            check::check(name, &bytes[..length]);
            if name.ends_with("asc") && length < bytes.len() - 2 {
                // The last digits of the last height may be missing.
                assert!(
                    length > bytes.len() - 6 || open(name, &bytes[..length], HeightOptions::default()).is_err(),
                    "{length}"
                );
            }
        }
        for _ in 0..1_500 {
            check::check(name, &damaged(&bytes, &numbers, &texts, |end| random.below(end)));
        }
    }
    let noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for name in ["a.asc", "a.dem", "a.png"] {
        assert!(open(name, &noise, HeightOptions::default()).is_err(), "{name}");
    }
    let huge = b"ncols 4000000000\nnrows 4000000000\n1 2 3";
    assert!(open("a.asc", huge, HeightOptions::default()).is_err());
    let steep = HeightOptions { height: Height::Scale(1e9), ..HeightOptions::default() };
    assert!(open("a.png", &png(false), steep).is_err());
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_in_text() {
    let samples = samples();
    samples.iter().for_each(|(_, bytes)| check::check_all(bytes));
    corpus::replay(
        "voxels",
        samples.iter().filter(|(name, _)| name.ends_with("asc") || name.ends_with("dem")),
        check::check_all,
    );
}

#[test]
fn a_model_of_the_usgs_knows_its_place_its_zone_and_its_feet() {
    let place = |bytes: &[u8]| {
        let scene = open("a.dem", bytes, HeightOptions::default()).unwrap();
        let place = scene.georeference.unwrap();
        (place.coordinates_from_world.transform_point3(DVec3::ZERO), place.crs, scene.voxel_size)
    };
    // Points are in the middles of cells; the middle of the lowest voxel is at 10 m.
    let (corner, crs, _) = place(&dem());
    assert_eq!(corner, DVec3::new(95.0, -5.0, 5.0));
    assert_eq!(crs, "UTM zone 10, whose datum the file does not say");
    let with = |changes: &[(usize, &str)]| {
        let mut bytes = dem();
        changes.iter().for_each(|&(at, text)| bytes[at..at + text.len()].copy_from_slice(text.as_bytes()));
        bytes
    };
    assert_eq!(place(&with(&[(890, " 1")])).1, "EPSG:26710");
    assert_eq!(place(&with(&[(890, " 4")])).1, "EPSG:26910");
    // Steps of ten seconds of arc, heights in feet.
    let (corner, crs, voxel_size) = place(&with(&[(156, "     0"), (528, "     3     1"), (890, " 3")]));
    assert_eq!(crs, "EPSG:4326");
    assert!((corner.x - 95.0 / 3600.0).abs() < 1e-12 && (voxel_size - 111_320.0 / 360.0).abs() < 1e-9, "{corner}");
    let heights = |bytes: &[u8]| {
        let options = HeightOptions { height: Height::Scale(1.0), ..HeightOptions::default() };
        tops(&open("a.dem", bytes, options).unwrap()).into_iter().flatten().max().unwrap() as f32
    };
    let [metres, feet] = [dem(), with(&[(528, "     2     1")])].map(|bytes| heights(&bytes));
    assert!((feet / metres - 0.3048).abs() < 0.01, "{feet} {metres}");
}

#[test]
fn flat_maps_and_maps_without_a_height_are_decided() {
    let flat = b"ncols 2\nnrows 1\ncellsize 1\n5 5\n";
    assert_eq!(open("a.asc", flat, HeightOptions::default()).unwrap().grids[0].count(), 2);
    let empty = b"ncols 2\nnrows 1\nNODATA_value -1\n-1 -1\n";
    assert!(open("a.asc", empty, HeightOptions::default()).unwrap_err().to_string().contains("no point has a height"));
}

#[test]
fn shared_heightmaps_have_their_size() {
    let Some(data) = data() else { return };
    for (name, width, depth) in [
        ("heightmap/SainteHelens.dem", 327, 466),
        ("heightmap/lidar_dem.tif", 400, 400),
        ("heightmap/lidar_dem_16bit.png", 400, 400),
        ("heightmap/pybullet_wm_height_out.png", 512, 512),
    ] {
        let scene = import::open(&data.join(name), &ImportOptions::default()).unwrap();
        let size = scene.grids[0].bounds().unwrap().size();
        assert_eq!((size.x, size.y), (width, depth), "{name}: {size}");
    }
    let options = ImportOptions::default();
    let model = import::open(&data.join("heightmap/SainteHelens.dem"), &options).unwrap();
    assert_eq!((model.voxel_size, model.unit), (30.0, Unit::Metre));
    let (place, summit) = (model.georeference.unwrap(), DVec3::new(4_000.0 / 30.0, 8_000.0 / 30.0, 0.0));
    // The crater is in zone 10 near 562,500 east, 5,116,000 north.
    let summit = place.coordinates_from_world.transform_point3(summit);
    assert!((summit.x - 562_500.0).abs() < 1_500.0 && (summit.y - 5_116_000.0).abs() < 1_500.0, "{summit}");
    assert!(place.crs.starts_with("UTM zone 10"), "{}", place.crs);
    let place = import::open(&data.join("heightmap/lidar_dem.tif"), &options).unwrap().georeference.unwrap();
    let corner = place.coordinates_from_world.transform_point3(DVec3::new(0.0, 400.0, 0.0));
    assert!((corner.x - 429_252.313_37).abs() < 1e-4 && (corner.y - 5_150_885.424_94).abs() < 1e-4, "{corner}");
}
