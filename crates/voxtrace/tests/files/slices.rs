//! Volumes in many files or without a header: folders of pictures, pages of a TIFF, raw samples, Zarr. All hold the same
//! samples.

#[path = "../../../../fuzz/check/zarr.rs"]
mod check_zarr;

use crate::check_volume as check;
use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use crate::zipped::{gzip, zip};
use std::fs;
use std::io::Cursor;
use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::DVec3;
use voxtrace::import::{self, ImportError, ImportErrorKind, ImportOptions, Limits};
use voxtrace::scene::Unit;
use voxtrace::voxelize::Scale;

/// Samples along x, y and z.
const SIZE: [usize; 3] = [7, 5, 12];

fn value(x: usize, y: usize, z: usize) -> u16 {
    (x * 1000 + y * 100 + z * 7) as u16
}

fn values() -> Vec<u16> {
    let rows = (0..SIZE[2]).flat_map(|z| (0..SIZE[1]).map(move |y| (y, z)));
    rows.flat_map(|(y, z)| (0..SIZE[0]).map(move |x| value(x, y, z))).collect()
}

fn wanted() -> Vec<f32> {
    values().into_iter().map(f32::from).collect()
}

fn read(path: &Path) -> Result<Volume, ImportError> {
    import::read_volume(path, &ImportOptions::default())
}

fn png(z: usize) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIZE[0] as u32, SIZE[1] as u32);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let samples = &values()[z * SIZE[0] * SIZE[1]..][..SIZE[0] * SIZE[1]];
    let data: Vec<u8> = samples.iter().flat_map(|value| value.to_be_bytes()).collect();
    encoder.write_header().unwrap().write_image_data(&data).unwrap();
    bytes
}

/// Pages of a TIFF, as ImageJ describes them.
fn tiff(pages: std::ops::Range<usize>) -> Vec<u8> {
    described_tiff(pages, "ImageJ=1.53t\nimages=12\nspacing=2.5\nunit=mm\n")
}

fn described_tiff(pages: std::ops::Range<usize>, description: &str) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut out).unwrap();
    for z in pages {
        let samples = &values()[z * SIZE[0] * SIZE[1]..][..SIZE[0] * SIZE[1]];
        let mut page = encoder.new_image::<tiff::encoder::colortype::Gray16>(SIZE[0] as u32, SIZE[1] as u32).unwrap();
        if z == 0 {
            let tag = tiff::tags::Tag::ImageDescription;
            page.encoder().write_tag(tag, description).unwrap();
            page.x_resolution(tiff::encoder::Rational { n: 2, d: 1 });
            page.y_resolution(tiff::encoder::Rational { n: 4, d: 1 });
        }
        page.write_data(samples).unwrap();
    }
    out.into_inner()
}

/// Writes an array of axes z, y and x in chunks of 4 × 3 × 5, gzip; of version 3 with a transposed chunk. The last chunk is
/// not there where it holds the fill value alone.
fn write_zarr(folder: &Path, is_third: bool) {
    fs::create_dir_all(folder).unwrap();
    let metadata = if is_third {
        r#"{"zarr_format": 3, "node_type": "array", "shape": [12, 5, 7], "data_type": "uint16", "fill_value": 9,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [4, 3, 5]}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
            "codecs": [{"name": "transpose", "configuration": {"order": [2, 0, 1]}},
                {"name": "bytes", "configuration": {"endian": "big"}},
                {"name": "gzip", "configuration": {"level": 5}}]}"#
    } else {
        r#"{"zarr_format": 2, "shape": [12, 5, 7], "chunks": [4, 3, 5], "dtype": "<u2", "order": "C", "filters": null,
            "compressor": {"id": "gzip", "level": 5}, "fill_value": 9}"#
    };
    fs::write(folder.join(if is_third { "zarr.json" } else { ".zarray" }), metadata).unwrap();
    for (k, j, i) in (0..3).flat_map(|k| (0..2).flat_map(move |j| (0..2).map(move |i| (k, j, i)))) {
        let at = |x: usize, y: usize, z: usize| {
            let (x, y, z) = (i * 5 + x, j * 3 + y, k * 4 + z);
            if x < 7 && y < 5 { value(x, y, z) } else { 0 }
        };
        let mut bytes = Vec::new();
        if is_third {
            for (x, z) in (0..5).flat_map(|x| (0..4).map(move |z| (x, z))) {
                (0..3).for_each(|y| bytes.extend(at(x, y, z).to_be_bytes()));
            }
        } else {
            for (z, y) in (0..4).flat_map(|z| (0..3).map(move |y| (z, y))) {
                (0..5).for_each(|x| bytes.extend(at(x, y, z).to_le_bytes()));
            }
        }
        let name = if is_third { format!("c/{k}/{j}/{i}") } else { format!("{k}.{j}.{i}") };
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, gzip(&bytes)).unwrap();
    }
}

#[test]
fn pictures_in_a_folder_are_stacked_as_people_count() {
    let folder = tempfile::tempdir().unwrap();
    (0..SIZE[2]).for_each(|z| fs::write(folder.path().join(format!("slice{z}.png")), png(z)).unwrap());
    fs::write(folder.path().join("notes.txt"), "no picture").unwrap();
    let volume = read(folder.path()).unwrap();
    assert_eq!((volume.size, volume.values), (SIZE, wanted()));
    assert_eq!((volume.unit, volume.notes.len()), (Unit::Voxel, 1));
    // Two pages in one file count as two slices.
    fs::write(folder.path().join("slice8.png"), tiff(8..10)).unwrap();
    fs::remove_file(folder.path().join("slice9.png")).unwrap();
    assert_eq!(read(folder.path()).unwrap().values, wanted());
    let spacing = Some(DVec3::new(0.5, 0.25, 3.0));
    let volume = import::read_volume(folder.path(), &ImportOptions { spacing, ..ImportOptions::default() }).unwrap();
    assert_eq!((Some(volume.spacing()), volume.unit), (spacing, Unit::Millimetre));
    fs::write(folder.path().join("slice3.png"), &png(3)[..60]).unwrap();
    let error = read(folder.path()).unwrap_err();
    assert!(error.path.ends_with("slice3.png"), "{error}");
}

#[test]
fn pages_of_a_tiff_are_slices_with_the_spacing_that_is_written_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stack.tif");
    let bytes = tiff(0..SIZE[2]);
    fs::write(&path, &bytes).unwrap();
    let volume = read(&path).unwrap();
    assert_eq!(volume.spacing(), DVec3::new(0.5, 0.25, 2.5));
    assert_eq!((volume.size, volume.values), (SIZE, wanted()));
    let limits = Limits { points: 419, ..Limits::default() };
    assert!(import::read_volume(&path, &ImportOptions { limits, ..ImportOptions::default() }).is_err());
    let mut random = Random(3);
    for _ in 0..3_000 {
        let mut damaged = bytes.clone();
        for _ in 0..=random.below(3) {
            let at = random.below(damaged.len());
            damaged[at] = random.below(256) as u8;
        }
        let limits = Limits { bytes: 1 << 20, points: 1 << 14, ..Limits::default() };
        let options = ImportOptions { limits, ..ImportOptions::default() };
        if let Ok(volume) = import::volume_from_bytes(&damaged, Path::new("a.tif"), &options) {
            volume.validate().unwrap();
        }
    }
    for length in 0..bytes.len() {
        assert!(import::volume_from_bytes(&bytes[..length], Path::new("a.tif"), &ImportOptions::default()).is_err());
    }
}

#[test]
fn pages_that_do_not_say_how_far_apart_they_are_keep_the_lengths_of_pixels() {
    let read = |description: &str| {
        let bytes = described_tiff(0..SIZE[2], description);
        import::volume_from_bytes(&bytes, Path::new("a.tif"), &ImportOptions::default()).unwrap()
    };
    // ImageJ leaves out a distance of one unit.
    let volume = read("ImageJ=1.53t\nimages=12\nslices=12\nunit=mm\n");
    assert_eq!((volume.spacing(), volume.unit), (DVec3::new(0.5, 0.25, 1.0), Unit::Millimetre));
    assert!(volume.notes.is_empty(), "{:?}", volume.notes);
    let pixels = r#"<Pixels DimensionOrder="XYZCT" SizeX="7" SizeY="5" SizeZ="12" SizeC="1" SizeT="1""#;
    let sizes = r#"PhysicalSizeX="0.5" PhysicalSizeXUnit="mm" PhysicalSizeY="0.25" PhysicalSizeYUnit="mm""#;
    let volume = read(&format!("<OME xmlns=\"x\"><Image ID=\"a\">{pixels} {sizes}></Pixels></Image></OME>"));
    assert_eq!((volume.spacing(), volume.unit), (DVec3::new(0.5, 0.25, 0.5), Unit::Millimetre));
    assert!(volume.notes[0].contains("the distance of slices is not said"), "{:?}", volume.notes);
}

#[test]
fn raw_samples_are_what_their_shape_says() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scan.bin");
    let mut bytes = vec![7; 10];
    bytes.extend(values().iter().flat_map(|value| value.to_be_bytes()));
    fs::write(&path, bytes).unwrap();
    let options = |shape: &str| ImportOptions { raw: Some(shape.parse().unwrap()), ..ImportOptions::default() };
    let volume = import::read_volume(&path, &options("7x5x12:u16be:10")).unwrap();
    assert_eq!((volume.size, volume.values), (SIZE, wanted()));
    assert!(volume.notes.is_empty());
    assert_eq!(import::read_volume(&path, &options("7x5x11:u16be:10")).unwrap().notes.len(), 1);
    let error = import::read_volume(&path, &options("7x5x13:u16be:10")).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
    let error = import::read_volume(&path, &options("999999x999999x999999:f64le")).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
    fs::rename(&path, folder.path().join("scan.raw")).unwrap();
    assert!(read(&folder.path().join("scan.raw")).unwrap_err().to_string().contains("--raw-shape"));
}

#[test]
fn arrays_of_zarr_of_both_versions_have_the_same_samples() {
    for is_third in [false, true] {
        let folder = tempfile::tempdir().unwrap();
        write_zarr(folder.path(), is_third);
        assert_eq!(import::detect(folder.path(), &ImportOptions::default()).unwrap().name, "Zarr");
        let volume = read(folder.path()).unwrap();
        assert_eq!((volume.size, volume.values), (SIZE, wanted()), "{is_third}");
        // What is not there has the fill value; what is broken is an error.
        let first = folder.path().join(if is_third { "c/0/0/0" } else { "0.0.0" });
        let bytes = fs::read(&first).unwrap();
        fs::remove_file(&first).unwrap();
        let volume = read(folder.path()).unwrap();
        assert_eq!((volume.values[0], volume.values[5]), (9.0, f32::from(value(5, 0, 0))));
        for length in 0..bytes.len() {
            fs::write(&first, &bytes[..length]).unwrap();
            let error = read(folder.path()).unwrap_err();
            assert!(error.path.ends_with(first.strip_prefix(folder.path()).unwrap()), "{error}");
        }
        fs::write(&first, gzip(&[0; 1 << 20])).unwrap();
        assert!(read(folder.path()).unwrap_err().to_string().contains("more than its"));
    }
}

#[test]
fn of_a_picture_of_ome_zarr_the_level_that_suits_is_read() {
    let folder = tempfile::tempdir().unwrap();
    write_zarr(&folder.path().join("0"), false);
    write_zarr(&folder.path().join("1"), false);
    let small = fs::read_to_string(folder.path().join("1/.zarray")).unwrap().replace("12, 5, 7", "6, 3, 4");
    fs::write(folder.path().join("1/.zarray"), small).unwrap();
    let axes = |names: &str| format!(r#"{{"name": "{names}", "type": "space", "unit": "micrometer"}}"#);
    let level = |path: &str, scale: &str| {
        format!(r#"{{"path": "{path}", "coordinateTransformations": [{{"type": "scale", "scale": {scale}}}]}}"#)
    };
    let write = |second: &str| {
        let (axes, levels) =
            (["z", "y", "x"].map(axes).join(","), [level("0", "[4, 2, 1]"), level(second, "[8, 4, 2]")].join(","));
        let text = format!(r#"{{"multiscales": [{{"version": "0.4", "axes": [{axes}], "datasets": [{levels}]}}]}}"#);
        fs::write(folder.path().join(".zattrs"), text).unwrap();
    };
    write("1");
    let with = |scale| {
        let mut options = ImportOptions::default();
        options.volume.scale = scale;
        import::read_volume(folder.path(), &options)
    };
    for (scale, size) in [
        (None, SIZE),
        (Some(Scale::Resolution(6)), [4, 3, 6]),
        (Some(Scale::Resolution(7)), SIZE),
        (Some(Scale::VoxelSize(0.008)), [4, 3, 6]),
        (Some(Scale::VoxelSize(0.005)), SIZE),
    ] {
        assert_eq!(with(scale).unwrap().size, size, "{scale:?}");
    }
    let volume = with(None).unwrap();
    assert!((volume.spacing() - DVec3::new(0.001, 0.002, 0.004)).length() < 1e-12);
    assert_eq!((volume.unit, volume.values), (Unit::Millimetre, wanted()));
    let outer = folder.path().parent().unwrap().join("elsewhere");
    for bad in ["../elsewhere", outer.to_str().unwrap(), "0/../../elsewhere"] {
        write(bad);
        assert!(with(None).unwrap_err().to_string().contains("leads out of"), "{bad}");
    }
    write("2");
    assert!(with(None).unwrap_err().to_string().contains("missing"));
}

#[test]
fn metadata_of_zarr_that_make_no_sense_are_errors() {
    let folder = tempfile::tempdir().unwrap();
    write_zarr(folder.path(), false);
    let path = folder.path().join(".zarray");
    let good = fs::read_to_string(&path).unwrap();
    for (from, to) in [
        ("[12, 5, 7]", "[12, 5]"),
        ("[12, 5, 7]", "[12, 5, 0]"),
        ("[12, 5, 7]", "[12, 5, -7]"),
        ("[12, 5, 7]", "[99999999999, 99999999999, 99999999999]"),
        ("[4, 3, 5]", "[99999999999, 99999999999, 99999999999]"),
        ("[4, 3, 5]", "7"),
        ("<u2", "<c16"),
        ("\"C\"", "\"X\""),
        ("\"gzip\"", "\"lzma\""),
        ("null", "[{\"id\": \"delta\"}]"),
        ("}", ""),
    ] {
        assert!(good.contains(from));
        fs::write(&path, good.replacen(from, to, 1)).unwrap();
        assert!(read(folder.path()).is_err(), "{to}");
    }
    let mut random = Random(8);
    for _ in 0..1_000 {
        let mut damaged = good.clone().into_bytes();
        let at = random.below(damaged.len());
        damaged[at] = random.below(256) as u8;
        fs::write(&path, damaged).unwrap();
        let limits = Limits { bytes: 1 << 20, points: 1 << 14, ..Limits::default() };
        if let Ok(volume) = import::read_volume(folder.path(), &ImportOptions { limits, ..ImportOptions::default() }) {
            volume.validate().unwrap();
        }
    }
}

/// Writes an array of 2 × 2 × 2 bytes from 1 on, two chunks of which share a shard that is said to have this shape.
fn write_shards(folder: &Path, shard: [u64; 3]) {
    let metadata = format!(
        r#"{{"zarr_format": 3, "node_type": "array", "shape": [2, 2, 2], "data_type": "uint8", "fill_value": 0,
            "chunk_grid": {{"name": "regular", "configuration": {{"chunk_shape": {shard:?}}}}},
            "chunk_key_encoding": {{"name": "default"}},
            "codecs": [{{"name": "sharding_indexed", "configuration": {{"chunk_shape": [1, 2, 2],
                "codecs": [{{"name": "bytes"}}], "index_codecs": [{{"name": "bytes"}}]}}}}]}}"#
    );
    fs::create_dir_all(folder.join("c/0/0")).unwrap();
    fs::write(folder.join("zarr.json"), metadata).unwrap();
    let index = [[0u64, 4], [4, 4]].as_flattened().iter().flat_map(|word| word.to_le_bytes());
    fs::write(folder.join("c/0/0/0"), (1..=8).chain(index).collect::<Vec<u8>>()).unwrap();
}

#[test]
fn a_shard_without_chunks_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    write_shards(folder.path(), [2, 2, 2]);
    assert_eq!(read(folder.path()).unwrap().values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    for axis in 0..3 {
        let mut shard = [2, 2, 2];
        shard[axis] = 0;
        write_shards(folder.path(), shard);
        let error = read(folder.path()).unwrap_err().to_string();
        assert!(error.contains("not whole numbers of chunks"), "{error}");
    }
}

/// Writes an array of N5 of 3 × 2 × 2 bytes from 1 on, in blocks of 2 × 2 × 2 of which the second is cut.
fn write_n5(folder: &Path) {
    fs::create_dir_all(folder.join("0/0")).unwrap();
    fs::create_dir_all(folder.join("1/0")).unwrap();
    let metadata = r#"{"n5": "2.5.0", "dimensions": [3, 2, 2], "blockSize": [2, 2, 2], "dataType": "uint8",
        "compression": {"type": "gzip"}}"#;
    fs::write(folder.join("attributes.json"), metadata).unwrap();
    let block = |size: [u32; 3], values: &[u8]| {
        let mut bytes = vec![0, 0, 0, 3];
        size.into_iter().for_each(|size| bytes.extend(size.to_be_bytes()));
        bytes.extend(gzip(values));
        bytes
    };
    fs::write(folder.join("0/0/0"), block([2, 2, 2], &[1, 2, 4, 5, 7, 8, 10, 11])).unwrap();
    fs::write(folder.join("1/0/0"), block([1, 2, 2], &[3, 6, 9, 12])).unwrap();
}

#[test]
fn blocks_of_n5_are_put_together_and_one_that_is_larger_than_its_array_says_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    write_n5(folder.path());
    let found = read(folder.path()).unwrap();
    assert_eq!((found.size, found.values), ([3, 2, 2], (1..=12).map(|value| value as f32).collect()));
    let path = folder.path().join("1/0/0");
    let mut bytes = fs::read(&path).unwrap();
    bytes[7] = 3;
    fs::write(&path, bytes).unwrap();
    assert!(read(folder.path()).unwrap_err().to_string().contains("another size"));
    fs::remove_file(path).unwrap();
    assert_eq!(read(folder.path()).unwrap().values[2], 0.0);
}

#[test]
fn a_zip_archive_of_zarr_is_read_as_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    write_zarr(&folder.path().join("in"), false);
    let wanted = read(&folder.path().join("in")).unwrap();
    for prefix in ["", "deeper/own.zarr/"] {
        let inside = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().unwrap();
            entry.path().is_file().then(|| (format!("{prefix}{name}"), fs::read(entry.path()).unwrap()))
        };
        let entries = fs::read_dir(folder.path().join("in")).unwrap();
        let files: Vec<(String, Vec<u8>)> = entries.filter_map(|entry| inside(entry.unwrap())).collect();
        assert!(files.len() > 10, "chunks lie beside their metadata");
        let files: Vec<(&str, Vec<u8>)> = files.iter().map(|(name, bytes)| (name.as_str(), bytes.clone())).collect();
        let path = folder.path().join("a.zarr.zip");
        fs::write(&path, zip(&files)).unwrap();
        assert_eq!(read(&path).unwrap().values, wanted.values);
        fs::write(&path, zip(&[("readme", b"no array".to_vec())])).unwrap();
        assert!(read(&path).unwrap_err().to_string().contains("holds no Zarr"));
        let whole = zip(&files);
        fs::write(&path, &whole[..whole.len() / 2]).unwrap();
        assert!(read(&path).unwrap_err().to_string().contains("ZIP"));
    }
}

/// A folder as the bytes that the fuzz target makes files of.
fn as_one(folder: &Path) -> Vec<u8> {
    let files = check_zarr::FILES.iter().enumerate();
    let content = files.filter_map(|(number, name)| Some((number, fs::read(folder.join(name)).ok()?)));
    content.flat_map(|(n, bytes)| [&[n as u8], &(bytes.len() as u16).to_le_bytes()[..], &bytes].concat()).collect()
}

/// Arrays of both versions, one with a shard, and a picture of two levels.
fn zarr_samples() -> Vec<(&'static str, Vec<u8>)> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write_zarr(&path("second"), false);
    write_zarr(&path("third"), true);
    ["picture/0", "picture/1"].iter().for_each(|level| write_zarr(&path(level), false));
    let levels = r#"{"multiscales": [{"version": "0.4", "axes": ["z", "y", "x"], "datasets": [{"path": "0",
        "coordinateTransformations": [{"type": "scale", "scale": [4, 2, 1]}]}, {"path": "1"}]}]}"#;
    fs::write(path("picture/.zattrs"), levels).unwrap();
    let sample = |name: &'static str| {
        assert!(read(&path(name)).is_ok_and(|volume| volume.values.len() >= 8), "{name}");
        (name, as_one(&path(name)))
    };
    write_shards(&path("shards"), [2, 2, 2]);
    write_n5(&path("n5"));
    write_n5(&path("pyramid/s0"));
    fs::write(
        path("pyramid/attributes.json"),
        r#"{"n5": "2.5.0", "pixelResolution": {"unit": "um", "dimensions": [1, 2, 4]}}"#,
    )
    .unwrap();
    ["second", "third", "picture", "shards", "n5", "pyramid"].map(sample).to_vec()
}

#[test]
fn folders_of_zarr_with_any_damage_are_read_or_give_an_error() {
    let texts = ["null", "-1", "99999999999", "[]", "{}", "\"\"", "1e400", "0", "|u1", ">f8", "blosc", "zstd"];
    let mut random = Random(14);
    for (_, bytes) in zarr_samples() {
        for length in (0..bytes.len()).step_by(7) {
            check_zarr::check(&bytes[..length]);
        }
        for _ in 0..400 {
            check_zarr::check(&damaged(&bytes, &[0, 1, 0x8000_0000, u32::MAX], &texts, |end| random.below(end)));
        }
    }
}

#[test]
fn sixteen_megabytes_of_noise_in_a_file_of_zarr_are_refused() {
    let mut random = Random(15);
    let noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for name in ["0.0.0", ".zarray"] {
        let folder = tempfile::tempdir().unwrap();
        write_zarr(folder.path(), false);
        fs::write(folder.path().join(name), &noise).unwrap();
        assert!(read(folder.path()).is_err(), "{name}");
        if name == ".zarray" {
            fs::rename(folder.path().join(name), folder.path().join(".zattrs")).unwrap();
            assert!(read(folder.path()).is_err(), ".zattrs");
        }
    }
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_folders_of_zarr() {
    corpus::replay("zarr", &zarr_samples(), check_zarr::check);
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_pages_of_a_tiff() {
    corpus::replay("volume", &[("pages.tif", tiff(0..3))], check::check_all);
}
