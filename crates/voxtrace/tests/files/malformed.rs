//! What no reader may take for a scene, for all formats alike: broken files of `shared/data`, decided one by one, good ones
//! that are cut anywhere, noise. Meshes, points and `.vox` have their own lists in `mesh_files`, `points` and `vox_files`.

use crate::meshes::Random;
use std::fs;
use std::path::Path;
use voxtrace::import::{self, ImportError, ImportErrorKind, ImportOptions, Limits, READERS};
use voxtrace_test_support::{data, files_below};

/// Reads bytes by whatever reader their first ones or the name tell, without voxelizing.
fn read(name: &str, bytes: &[u8]) -> Result<(), ImportError> {
    import::read_bytes(bytes, Path::new(name), &ImportOptions::default()).map(|_| ())
}

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

#[test]
fn each_broken_volume_file_of_voxels_or_unknown_file_is_decided() {
    /// What the error says beside the byte.
    const REFUSED: [(&str, &str); 21] = [
        ("asc_short_rows.asc", "ends inside a grid of 5 x 3"),
        ("assimp_OutOfMemory.off", "unknown format"),
        ("assimp_empty.3ds", "unknown format"),
        ("assimp_empty.off", "unknown format"),
        ("binvox_bad_dims.binvox", "more than the limit"),
        ("mhd_missing_raw.mhd", "not_here.raw"),
        // Heads without their data.
        ("nibabel_analyze.hdr", "nibabel_analyze.img"),
        ("nibabel_bad_attribute+orig.HEAD", "unknown format"),
        ("nibabel_nifti1.hdr", "nibabel_nifti1.img"),
        ("nibabel_nifti2.hdr", "nibabel_nifti2.img"),
        ("nifti_dims_huge.nii", "27000000000000 is more than the limit"),
        ("nifti_gz_truncated.nii.gz", "compressed data"),
        ("nrrd_detached_traversal.nhdr", "leads out of"),
        ("nrrd_negative_size.nrrd", "-5 0 99999999999"),
        ("nrrd_short_data.nrrd", "268435456 bytes"),
        ("png_truncated.png", "PNG"),
        ("qb_count_huge.qb", "4294967295 matrices"),
        ("schem_nested_deep.schem", "depth of nested tags"),
        ("schem_truncated.schem", "compressed data"),
        ("schematic_negative_dims.schematic", "more than the limit"),
        ("vdb_truncated.vdb", "ends inside a grid"),
    ];
    /// In truth good: a picture beside a broken glTF file, which by itself is a heightmap.
    const READABLE: [&str; 1] = ["glTF2_wrongTypes_CesiumLogoFlat.png"];
    /// Lists of their own in other tests, and what belongs to those files.
    const ELSEWHERE: [&str; 14] =
        ["vox", "glb", "gltf", "obj", "ply", "stl", "las", "laz", "e57", "pcd", "xyz", "mtl", "bin", "txt"];
    let Some(data) = data() else { return };
    let mut refused = Vec::new();
    for path in files_below(&data.join("malformed"), &[]) {
        let name = name_of(&path);
        if path.extension().is_some_and(|extension| ELSEWHERE.iter().any(|other| extension == *other)) {
            continue;
        }
        let Err(error) = import::open(&path, &ImportOptions::default()) else {
            assert!(READABLE.contains(&name.as_str()), "{name} is read");
            continue;
        };
        println!("{error}");
        let known = REFUSED.iter().find(|known| known.0 == name);
        let (_, text) = known.unwrap_or_else(|| panic!("nobody has decided about {error}"));
        assert!(error.to_string().contains(text) && error.offset.is_some(), "{error}");
        refused.push(name);
    }
    refused.sort();
    assert_eq!(refused, REFUSED.map(|known| known.0));
}

#[test]
fn a_small_file_of_the_shared_data_cut_at_any_byte_is_read_or_gives_an_error_that_says_where() {
    let Some(data) = data() else { return };
    let mut files = files_below(&data, &READERS.extensions());
    files.retain(|path| !path.starts_with(data.join("malformed")) && path.metadata().unwrap().len() <= 12_000);
    assert!(files.len() > 40, "{}", files.len());
    for path in files {
        let (name, bytes) = (name_of(&path), fs::read(&path).unwrap());
        for length in 0..bytes.len() {
            let Err(error) = read(&name, &bytes[..length]) else { continue };
            let is_io = matches!(error.kind, ImportErrorKind::Io(_));
            assert!(error.offset.is_some() || is_io, "{name} {length}: {error}");
            assert!(!error.to_string().contains("the decoder failed"), "{name} {length}: {error}");
        }
    }
}

#[test]
fn sixteen_megabytes_of_noise_are_an_error_by_every_name_and_behind_every_magic_number() {
    let mut random = Random(16);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for extension in READERS.extensions() {
        let name = format!("noise.{extension}");
        let error = read(&name, &noise).expect_err(&name);
        assert!(error.offset.is_some() && !error.to_string().contains("the decoder failed"), "{error}");
    }
    for (name, head) in [
        ("main.vox", &b"VOX \xc8\0\0\0MAIN\0\0\0\0\xff\xff\xff\0"[..]),
        ("size.vox", b"VOX \xc8\0\0\0MAIN\0\0\0\0\xff\xff\xff\0SIZE\x0c\0\0\0\0\0\0\0"),
        ("a.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x10\0\0\0\x10\0\x10\0\0\0\0"),
        ("a.tif", b"II*\0\x08\0\0\0\xff\xff"),
        ("b.tif", b"MM\0+\0\x08\0\0\0\0\0\0\0\0\0\x10"),
        ("a.pcd", b"# .PCD v"),
        ("a.e57", b"ASTM-E57\x01\0\0\0"),
        ("a.npy", b"\x93NUMPY\x01\0"),
        ("a.vdb", b" BDV\0\0\0\0\xe0\0\0\0"),
    ] {
        noise[..head.len()].copy_from_slice(head);
        let error = read(name, &noise).expect_err(name);
        assert!(!error.to_string().contains("the decoder failed"), "{error}");
    }
    let magic = READERS.iter().flat_map(|reader| reader.magic.iter().map(move |magic| (reader.name, magic)));
    for (name, magic) in magic {
        noise[magic.offset..][..magic.bytes.len()].copy_from_slice(magic.bytes);
        let error = read("noise", &noise).expect_err(name);
        assert!(!error.to_string().contains("the decoder failed"), "{error}");
    }
    // More than the limit of a file.
    let limits = Limits { bytes: 1 << 20, ..Limits::default() };
    let options = ImportOptions { limits, ..ImportOptions::default() };
    let error = import::geometry_from_bytes(&noise, Path::new("a.obj"), &options).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
}
