//! Volume files: the same volume from every format, proportions, places in the world, and damage of every kind. Nothing
//! panics. Also replays the corpora of the fuzz targets.

use crate::check_volume as check;
use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use crate::volume_samples;
use crate::volume_samples::{SIZE, SPACING, dicom, samples, values};
use std::fs;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::{DMat3, DVec3, IVec3};
use voxtrace::import::{self, ImportError, ImportErrorKind, ImportOptions, Limits};
use voxtrace::scene::Unit;
use voxtrace::volume::{self, Preset, VolumeError, VolumeOptions};
use voxtrace::voxelize::Scale;
use voxtrace::{PackedScene, Volume};
use voxtrace_test_support::data;

fn options(volume: VolumeOptions) -> ImportOptions {
    ImportOptions { volume, ..ImportOptions::default() }
}

fn bone() -> VolumeOptions {
    VolumeOptions { transfer: Some(Preset::CtBone.transfer()), ..VolumeOptions::default() }
}

fn open(name: &str, bytes: &[u8], options: &ImportOptions) -> Result<Scene, ImportError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    import::open(&path, options)
}

fn voxels(scene: &Scene) -> Vec<(IVec3, u16)> {
    scene.grids[0].voxels().collect()
}

#[test]
fn the_same_volume_from_every_format_has_the_same_voxels() {
    let mut first: Option<(Vec<_>, _)> = None;
    for (name, bytes) in samples() {
        let scene = open(name, &bytes, &options(bone())).unwrap();
        assert!(scene.grids[0].count() > 100, "{name}");
        let found = (voxels(&scene), scene.instances[0].world_from_grid);
        if name.ends_with("npy") || name.ends_with("npz") {
            // An array has no place in the world.
            assert_eq!(scene.unit, Unit::Voxel, "{name}");
            continue;
        }
        assert_eq!((scene.unit, scene.voxel_size), (Unit::Millimetre, SPACING[0]), "{name}");
        let first = first.get_or_insert_with(|| found.clone());
        assert!(found == *first, "{name} differs");
    }
}

#[test]
fn a_detached_header_finds_its_data_beside_it_and_nowhere_else() {
    let outer = tempfile::tempdir().unwrap();
    let inner = outer.path().join("scan");
    fs::create_dir(&inner).unwrap();
    fs::write(outer.path().join("data.raw"), [1; 8]).unwrap();
    fs::write(inner.join("data.raw"), [1; 8]).unwrap();
    for (file, header) in [
        ("a.nhdr", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: "),
        ("a.mhd", "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = "),
    ] {
        let read = |name: &str| {
            fs::write(inner.join(file), format!("{header}{name}\n")).unwrap();
            import::read_volume(&inner.join(file), &ImportOptions::default())
        };
        assert_eq!(read("data.raw").unwrap().values, [1.0; 8]);
        for bad in ["../data.raw", "/etc/hostname", "x/../../data.raw"] {
            let error = read(bad).unwrap_err().to_string();
            assert!(error.contains("leads out of the scene's folder"), "{error}");
        }
        assert!(matches!(read("missing.raw").unwrap_err().kind, ImportErrorKind::Io(_)));
    }
}

#[test]
fn a_folder_is_read_as_the_series_with_the_most_pictures_and_one_file_as_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: String, bytes: Vec<u8>| fs::write(folder.path().join(name), bytes).unwrap();
    // Names that sort otherwise than places.
    (0..SIZE[2]).for_each(|z| write(format!("{}.dcm", z * 5 % SIZE[2]), dicom::slice("1.2.3", 4, z)));
    (0..2).for_each(|z| write(format!("other{z}"), dicom::slice("1.2.4", 7, z)));
    write("notes.txt".into(), b"not a picture".to_vec());
    let read = |path: &Path, series| import::read_volume(path, &ImportOptions { series, ..ImportOptions::default() });
    let whole = read(folder.path(), None).unwrap();
    assert_eq!((whole.size, whole.values), (SIZE, values().into_iter().map(f32::from).collect()));
    assert!((whole.world_from_index.matrix3.z_axis - DVec3::Z * SPACING[2]).length() < 1e-9);
    assert_eq!(whole.world_from_index.translation.to_array(), volume_samples::ORIGIN);
    assert_eq!((whole.unit, whole.suited), (Unit::Millimetre, Some(Preset::CtBone)));
    let notes = whole.notes.join("; ");
    assert!(notes.contains("series 4 (a lump): 7 pictures is read") && notes.contains("1 files"), "{notes}");
    let other = read(folder.path(), Some(7)).unwrap();
    assert_eq!(other.size[2], 2);
    assert!(read(folder.path(), Some(8)).unwrap_err().to_string().contains("no series 8"));
    let of_file = read(&folder.path().join("other1"), None).unwrap();
    assert_eq!((of_file.size[2], of_file.values), (2, other.values));
}

#[test]
fn slices_that_are_cut_short_are_left_out_of_their_series_but_not_the_one_that_was_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = |z: usize| folder.path().join(format!("{z}.dcm"));
    let read = |path: &Path| import::read_volume(path, &ImportOptions::default());
    let cut = |z: usize| {
        let bytes = dicom::slice("1.2.3", 4, z);
        fs::write(file(z), &bytes[..bytes.len() - 10]).unwrap();
    };
    (0..SIZE[2]).for_each(|z| fs::write(file(z), dicom::slice("1.2.3", 4, z)).unwrap());
    let whole = read(folder.path()).unwrap();
    let strict = ImportOptions { strict: true, ..ImportOptions::default() };
    assert_eq!(import::read_volume(folder.path(), &strict).unwrap().values, whole.values);
    let last = SIZE[2] - 1;
    cut(last);
    for path in [folder.path().to_owned(), file(0)] {
        let rest = read(&path).unwrap();
        assert_eq!(rest.size, [SIZE[0], SIZE[1], last]);
        assert_eq!(rest.values, whole.values[..SIZE[0] * SIZE[1] * last]);
        let notes = rest.notes.join("; ");
        let left_out = format!("1 of the {} files of the series are left out: ", SIZE[2]);
        assert!(notes.contains(&left_out) && notes.contains(&format!("{last}.dcm")), "{notes}");
        let error = import::read_volume(&path, &strict).unwrap_err();
        assert!(error.path.ends_with(format!("{last}.dcm")), "{error}");
    }
    assert!(read(&file(last)).unwrap_err().to_string().contains(&format!("{last}.dcm")));
    (0..SIZE[2]).for_each(cut);
    assert!(read(folder.path()).is_err());
}

#[test]
fn groups_of_frames_of_stated_lengths_say_where_frames_lie_also_without_kinds_of_values() {
    let read =
        |kind| import::volume_from_bytes(&dicom::file(kind), Path::new("a.dcm"), &ImportOptions::default()).unwrap();
    let (stated, open) = (read(dicom::Kind::Lengths), read(dicom::Kind::Groups));
    assert!((stated.world_from_index.matrix3.z_axis - DVec3::Z * SPACING[2]).length() < 1e-9);
    assert_eq!((&stated.values, &stated.notes), (&open.values, &open.notes));
    assert_eq!(stated.world_from_index, open.world_from_index);
}

#[test]
fn an_instance_without_a_picture_is_not_called_damaged() {
    let mut bytes = dicom::slice("1.2.3", 4, 0);
    // Rows: (0028,0010) becomes another element.
    let at = bytes.windows(6).position(|bytes| bytes == b"\x28\0\x10\0US").unwrap();
    bytes[at + 2] = 0x0f;
    let error = import::volume_from_bytes(&bytes, Path::new("a.dcm"), &ImportOptions::default()).unwrap_err();
    assert!(
        matches!(&error.kind, ImportErrorKind::Unsupported(what) if what.contains("(CT) without a picture")),
        "{error}"
    );
}

#[test]
fn a_compression_that_is_not_read_is_named() {
    let mut bytes = dicom::file(dicom::Kind::RunLengths);
    let at = bytes.windows(19).position(|bytes| bytes == b"1.2.840.10008.1.2.5").unwrap();
    // The value has one byte of padding, and its length stands before it.
    bytes.splice(at..at + 20, *b"1.2.840.10008.1.2.4.201\0");
    bytes[at - 2] = 24;
    let error = import::volume_from_bytes(&bytes, Path::new("a.dcm"), &ImportOptions::default()).unwrap_err();
    assert!(
        matches!(&error.kind, ImportErrorKind::Unsupported(what) if what.contains("high-throughput JPEG 2000")),
        "{error}"
    );
}

#[test]
fn samples_that_are_farther_apart_along_one_axis_keep_their_proportions() {
    let mut volume = Volume::new([20, 20, 10], vec![1.0; 4000]);
    for spacing in [1.0, 2.0, 2.5, 0.5] {
        volume.world_from_index.matrix3.z_axis = DVec3::Z * spacing;
        let transfer = Some(Preset::Labels.transfer());
        for scale in [None, Some(Scale::VoxelSize(1.0)), Some(Scale::Resolution(50))] {
            let options = VolumeOptions { scale, transfer: transfer.clone(), shell: false, ..VolumeOptions::default() };
            let scene = volume::voxelize(&volume, &options, &Limits::default()).unwrap();
            let size = scene.grids[0].bounds().unwrap().size().as_dvec3() * scene.voxel_size;
            let wanted = DVec3::new(20.0, 20.0, 10.0 * spacing);
            assert!((size - wanted).abs().max_element() <= scene.voxel_size * 0.5 + 1e-9, "{spacing}: {size}");
            assert_eq!(scene.grids[0].count() as i32, scene.grids[0].bounds().unwrap().size().element_product());
        }
    }
}

#[test]
fn voxels_between_samples_are_cubes_and_have_the_values_of_their_places() {
    // The value is the height, from both ends of the lattice.
    let volumes = [1.0, -1.0].map(|sign| {
        let heights = (0..3 * 3 * 25).map(|n| (n / 9) as f64 * 2.5 * sign + 107.3);
        let mut volume = Volume::new([3, 3, 25], heights.map(|height| height as f32).collect());
        volume.world_from_index.matrix3.z_axis = DVec3::Z * 2.5 * sign;
        volume.world_from_index.translation.z = 107.3;
        (volume, sign)
    });
    for (volume, sign) in &volumes {
        // 63, 31, 89 and 23 voxels, of which the last ones fit in no whole number of times.
        for size in [1.0, 2.0, 0.7, 2.75] {
            let threshold = 107.3 + 29.9 * sign;
            let transfer = Some(Preset::Surface.transfer());
            let options = VolumeOptions {
                scale: Some(Scale::VoxelSize(size)),
                transfer,
                threshold: Some(threshold as f32),
                ..VolumeOptions::default()
            };
            let scene = volume::voxelize(volume, &options, &Limits::default()).unwrap();
            let place = scene.georeference.as_ref().unwrap().coordinates_from_world;
            assert!((place.matrix3.z_axis - DVec3::Z * size).length() < 1e-12, "{size}: {place:?}");
            let lowest = voxels(&scene).iter().map(|(voxel, _)| voxel.z).min().unwrap();
            let middle = DVec3::new(0.5, 0.5, f64::from(lowest) + 0.5);
            let world = scene.instances[0].world_from_grid.point(middle.as_vec3()).as_dvec3();
            let height = place.transform_point3(world).z;
            // The box filter sees samples as steps, a step is 2.5 high.
            let mixed = if size > 2.5 { 0.3 } else { 1e-4 };
            assert!((-mixed..size + mixed).contains(&(height - threshold)), "{size} {sign}: {height} {threshold}");
        }
    }
}

#[test]
fn a_shell_looks_the_same_from_outside_and_hides_nothing() {
    let size = [21, 19, 23];
    let value = |x: usize, y: usize, z: usize| {
        let from = DVec3::new(x as f64 - 10.0, y as f64 - 9.0, z as f64 - 11.0);
        if from.length() < 9.0 { 1000.0 } else { -1000.0 }
    };
    let mut values = Vec::new();
    for z in 0..size[2] {
        for y in 0..size[1] {
            values.extend((0..size[0]).map(|x| value(x, y, z)));
        }
    }
    let volume = Volume::new(size, values);
    let scene = |shell| volume::voxelize(&volume, &VolumeOptions { shell, ..bone() }, &Limits::default()).unwrap();
    let (full, shell) = (scene(false), scene(true));
    let (full, shell) = (&full.grids[0], &shell.grids[0]);
    for (voxel, material) in full.voxels() {
        let steps = [IVec3::X, IVec3::Y, IVec3::Z];
        let is_inside = steps.iter().all(|&s| full.get(voxel + s).is_some() && full.get(voxel - s).is_some());
        assert_eq!(shell.get(voxel), (!is_inside).then_some(material), "{voxel}");
    }
    assert!(shell.count() < full.count() / 2 && shell.voxels().all(|(voxel, _)| full.get(voxel).is_some()));
}

#[test]
fn axes_of_the_lattice_are_turned_into_the_world() {
    // One sample shines; its place in the world is told by the matrix.
    let mut values = vec![0.0; 4 * 5 * 6];
    values[1 + 4 * (3 + 5 * 4)] = 1.0;
    let mut volume = Volume::new([4, 5, 6], values);
    let axes = [DVec3::NEG_Y, DVec3::Z, DVec3::NEG_X];
    (volume.world_from_index.matrix3.x_axis, volume.world_from_index.matrix3.y_axis) = (axes[0], axes[1]);
    volume.world_from_index.matrix3.z_axis = axes[2];
    volume.world_from_index.translation = DVec3::new(0.5, 0.5, 10.5);
    let options = VolumeOptions { transfer: Some(Preset::Labels.transfer()), ..VolumeOptions::default() };
    let scene = volume::voxelize(&volume, &options, &Limits::default()).unwrap();
    let voxel = voxels(&scene)[0].0;
    let found = scene.instances[0].world_from_grid.point(voxel.as_vec3() + 0.5).as_dvec3();
    let wanted = volume.world_from_index.transform_point3(DVec3::new(1.0, 3.0, 4.0));
    assert_eq!((found, wanted), (DVec3::new(-3.5, -0.5, 13.5), DVec3::new(-3.5, -0.5, 13.5)));
}

#[test]
fn an_oblique_volume_is_placed_by_its_instance() {
    let mut values = vec![0.0; 1000];
    values[2 + 10 * (7 + 10 * 4)] = 1.0;
    let mut volume = Volume::new([10, 10, 10], values);
    let turn = DMat3::from_rotation_z(0.3) * DMat3::from_rotation_x(-0.2);
    volume.world_from_index.matrix3 = turn * 2.0;
    volume.world_from_index.translation = DVec3::new(-30.0, 12.0, 5.0);
    let options = VolumeOptions { transfer: Some(Preset::Labels.transfer()), ..VolumeOptions::default() };
    let scene = volume::voxelize(&volume, &options, &Limits::default()).unwrap();
    let found = scene.instances[0].world_from_grid.point(voxels(&scene)[0].0.as_vec3() + 0.5).as_dvec3() * 2.0;
    let wanted = volume.world_from_index.transform_point3(DVec3::new(2.0, 7.0, 4.0));
    assert!((found - wanted).length() < 1e-4, "{found} {wanted}");
    PackedScene::pack(&scene).unwrap();
    // The coordinates of the file are kept in f64, also where voxels are no whole part of the volume.
    for scale in [None, Some(Scale::VoxelSize(1.3)), Some(Scale::Resolution(23))] {
        let scene = volume::voxelize(&volume, &VolumeOptions { scale, ..options.clone() }, &Limits::default()).unwrap();
        let (grid, instance) = (&scene.grids[0], &scene.instances[0]);
        let middle = grid.voxels().map(|(voxel, _)| voxel.as_dvec3() + 0.5).sum::<DVec3>() / grid.count() as f64;
        let world = instance.world_from_grid.point(middle.as_vec3()).as_dvec3();
        let found = scene.georeference.unwrap().coordinates_from_world.transform_point3(world);
        assert!((found - wanted).abs().max_element() < 1.0, "{scale:?}: {found} {wanted}");
        let is_exact = scale.is_none();
        assert!(!is_exact || (found - wanted).length() < 1e-4, "{found}");
    }
}

#[test]
fn a_volume_in_which_nothing_is_to_be_seen_says_what_values_it_has() {
    let volume = Volume::new([2, 2, 2], vec![5.0; 8]);
    let error = volume::voxelize(&volume, &bone(), &Limits::default()).unwrap_err();
    assert!(matches!(&error, VolumeError::Empty { .. }) && error.to_string().contains("between 5 and 5"), "{error}");
}

#[test]
fn a_file_cut_at_any_byte_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            check::check(name, &bytes[..length]);
            // What is packed may end later than its samples, and text anywhere.
            if !["gz", "bz", "text", "zlib", "deflated"].iter().any(|packed| name.contains(packed)) {
                let error = import::volume_from_bytes(&bytes[..length], Path::new(name), &ImportOptions::default());
                let error = error.unwrap_err();
                assert!(error.offset.is_some_and(|offset| offset <= length as u64), "{name} {length}: {error}");
            }
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error() {
    let numbers = [0, 1, 255, 65_535, 0x7fff_ffff, 0x8000_0000, u32::MAX, f32::NAN.to_bits(), f32::INFINITY.to_bits()];
    let texts = ["nan", "inf", "-1", "1e400", "1e38", "99999999999", "-99999", "none", "()", "(", " ", "\n", "=", ":"];
    let mut random = Random(5);
    for (name, bytes) in samples() {
        // Faults in the header are the interesting ones.
        let front = bytes.len().min(420);
        for _ in 0..1_500 {
            let (head, rest) = bytes.split_at(front);
            let head = damaged(head, &numbers, &texts, |end| random.below(end));
            check::check(name, &[&head, rest].concat());
        }
    }
}

#[test]
fn sixteen_megabytes_of_noise_are_refused_in_every_format() {
    let mut random = Random(6);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for (name, head) in [
        ("a.nii", &b"\x5c\x01\0\0"[..]),
        ("a.nii.gz", b"\x1f\x8b\x08\0"),
        ("a.nrrd", b"NRRD0005\ntype: short\n"),
        ("a.mha", b"NDims = 3\n"),
        ("a.npy", b"\x93NUMPY\x01\0"),
        ("a.dcm", b"\x08\0\x05\0CS\x0a\0"),
        ("b.npy", b""),
        ("b.mhd", b""),
    ] {
        noise[..head.len()].copy_from_slice(head);
        assert!(import::volume_from_bytes(&noise, Path::new(name), &ImportOptions::default()).is_err(), "{name}");
    }
}

#[test]
fn each_limit_holds() {
    for (name, bytes) in samples() {
        let count = SIZE.iter().product::<usize>() as u64;
        for limits in [
            Limits { bytes: 50, ..Limits::default() },
            Limits { points: count - 1, ..Limits::default() },
            Limits { voxels: count - 1, ..Limits::default() },
        ] {
            let error = open(name, &bytes, &ImportOptions { limits, ..options(bone()) }).unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{name} {limits:?}: {error}");
        }
    }
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    corpus::replay("volume", &samples(), check::check_all);
}

#[test]
fn shared_volumes_have_the_size_that_their_headers_say() {
    let Some(data) = data() else { return };
    // Samples and spacing as the manifest has them from other programs.
    for (name, size, spacing) in [
        ("CT_AVM.nii.gz", [256, 242, 154], [0.72, 0.721, 1.0]),
        ("breast1_image.nrrd", [45, 120, 21], [0.664, 0.664, 2.1]),
        ("headsq_quarter.mhd", [64, 64, 93], [3.2, 3.2, 1.5]),
        ("mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz", [197, 233, 189], [1.0, 1.0, 1.0]),
        ("nibabel_anatomical.nii", [33, 41, 25], [2.0, 2.0, 2.0]),
        ("nibabel_example4d.nii.gz", [128, 96, 24], [2.0, 2.0, 2.2]),
        ("nibabel_example_nifti2.nii.gz", [32, 20, 12], [2.0, 2.0, 2.2]),
        ("nibabel_functional.nii", [17, 21, 3], [4.0, 4.0, 8.0]),
        ("nibabel_reoriented_anat_moved.nii", [21, 26, 22], [4.0, 4.0, 4.0]),
        ("nibabel_standard.nii.gz", [4, 5, 7], [1.0, 3.0, 2.0]),
        ("nrrd-js_example4.nrrd", [4, 3, 2], [1.0, 0.5, 0.3]),
        ("vtkdata/HeadMRVolume.mhd", [48, 62, 42], [4.0, 4.0, 4.0]),
        ("vtkdata/frogtissue.mhd", [500, 470, 136], [1.0, 1.0, 1.5]),
    ] {
        let volume = import::read_volume(&data.join("volume").join(name), &ImportOptions::default()).unwrap();
        assert_eq!(volume.size, size, "{name}");
        let wanted = DVec3::from_array(spacing);
        assert!((volume.spacing() - wanted).abs().max_element() < 2e-3, "{name}: {}", volume.spacing());
    }
}

#[test]
fn one_shared_picture_as_jpeg_2000_and_with_twelve_bits_of_jpeg_looks_alike() {
    let Some(data) = data() else { return };
    let read = |name: &str| {
        let bytes = fs::read(data.join("volume/pydicom").join(name)).unwrap();
        import::volume_from_bytes(&bytes, Path::new(name), &ImportOptions::default()).unwrap()
    };
    let (whole, lossy) = (read("JPEG2000.dcm"), read("JPEG-lossy.dcm"));
    assert_eq!((whole.size, lossy.size), ([256, 1024, 1], [256, 1024, 1]));
    let mean = |values: &[f32]| values.iter().sum::<f32>() / values.len() as f32;
    let differences =
        |values: &[f32]| mean(&values.iter().zip(&whole.values).map(|(a, b)| (a - b).abs()).collect::<Vec<_>>());
    let upside_down: Vec<f32> = lossy.values.chunks(256).rev().flatten().copied().collect();
    let (same, other) = (differences(&lossy.values), differences(&upside_down));
    // Both have lost something: 4.249 is what libjpeg-turbo and OpenJPEG say too.
    assert!((same - 4.249).abs() < 0.01, "{same}");
    assert!(mean(&whole.values) > 1.0 && same < 0.3 * other, "{same} {other}");
}
