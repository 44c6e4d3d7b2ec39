//! The table of formats: how files are told apart, and that a format is one line in it.

use std::fs;
use std::path::Path;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::import::{
    self, Content, Data, FileClues, Geometry, ImportErrorKind, ImportOptions, Kind, Magic, READERS, Reader, Readers,
    Recognition, Source, Voxels,
};
use voxtrace::mesh::UpAxis;
use voxtrace::packed::PackedScene;
use voxtrace::{Material, Scene, VoxelGrid};

fn name(head: &[u8], path: &str) -> Option<&'static str> {
    let options = ImportOptions::default();
    let clues = FileClues { path: Path::new(path), head, length: Some(head.len() as u64), options: &options };
    READERS.of_file(&clues).map(|reader| reader.name)
}

#[test]
fn first_bytes_come_before_the_extension() {
    for (head, path, wanted) in [
        (&b"glTF\x02\0\0\0"[..], "scene.obj", Some("glTF")),
        (b"ply\nformat", "scan", Some("PLY")),
        (b"VOX \xc8\0\0\0", "x.stl", Some("MagicaVoxel")),
        (b"VOXTRACE", "x.vox", Some("voxtrace")),
        (b"{\"asset\"", "a.GLTF", Some("glTF")),
        (b"v 0 0 0", "a.Obj", Some("OBJ")),
        (b"solid", "a.stl", Some("STL")),
        (b"solid a\n facet normal 0 0 1", "a", Some("STL")),
        (b"solid a\n facet normal 0 0 1", "a.xyz", Some("XYZ")),
        (b"solid ground", "a", None),
        (b"LASF\0\0", "tile.bin", Some("LAS")),
        (b"1 2 3", "a.XYZ", Some("XYZ")),
        (b"1 2 3", "a.asc", Some("XYZ")),
        (b"1 2 3\n4 5 6\n", "a", Some("XYZ")),
        (b"ncols 4\nnrows 3\n", "a.asc", Some("heightmap")),
        (b"NCOLS 4\nNROWS 3\n", "a.xyz", Some("heightmap")),
        (b"\xef\xbb\xbfncols 4\nnrows 3\n", "a.asc", Some("heightmap")),
        (b"\xef\xbb\xbf1 2 3", "a.asc", Some("XYZ")),
        (b"OFF\n8 6 0\n", "a.off", None),
        (b"Kvxl\x05\0\0\0", "a", Some("Voxlap")),
        (b"GOX \x02\0\0\0", "a.vox", Some("Goxel")),
        (b"\x1f\x8b", "head.1.NII.gz", Some("NIfTI")),
        (b"\x1f\x8b", "a.gz", None),
        (b"", "nii.gz", None),
        (b"NRRD0005\n", "scan", Some("NRRD")),
        (b"", "a.jpg", None),
        (b"", "noextension", None),
        (b"", "a.vox", Some("MagicaVoxel")),
    ] {
        assert_eq!(name(head, path), wanted, "{path}");
    }
    // Preambles of DICOM have 128 bytes.
    let dicom = [&[0; 128][..], b"DICM"].concat();
    assert_eq!((name(&dicom, "a.png"), name(&dicom[1..], "a")), (Some("DICOM"), None));
    // One voxel of Slab6, whose length tells it.
    let slab6 = [&[1, 0, 0, 0].repeat(3)[..], &[7], &[0; 768]].concat();
    assert_eq!((name(&slab6, "a.vox"), name(&slab6[1..], "a.vox")), (Some("Slab6"), Some("MagicaVoxel")));
    let options = ImportOptions { raw: Some("1x1x1".parse().unwrap()), ..ImportOptions::default() };
    assert_eq!(READERS.open_bytes(b"glTF", Path::new("a.glb"), &options).unwrap().reader().name, "raw samples");
}

#[test]
fn each_format_has_a_name_a_line_and_an_extension_of_its_own() {
    let mut names: Vec<_> = READERS.iter().map(|reader| reader.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), READERS.iter().count());
    for reader in READERS.iter() {
        assert!(
            !reader.about.is_empty()
                && reader.extensions.iter().all(|extension| *extension == extension.to_lowercase())
        );
        for other in READERS.iter().filter(|other| *other != reader) {
            let shared = reader.extensions.iter().find(|extension| other.extensions.contains(extension));
            // Slab6 is told from MagicaVoxel by the length.
            assert!(shared.is_none_or(|extension| *extension == "vox"), "{} {}: {shared:?}", reader.name, other.name);
        }
        // Whoever has an axis takes it to be another one.
        assert_eq!(reader.up_axis.is_none(), matches!(reader.kind, Kind::Scene | Kind::Packed), "{}", reader.name);
    }
}

/// A format that only this test knows: `toy`, then a voxel for each byte that is not a space, along y, which is up.
static TOY: Reader = Reader::new("Toy", Kind::Voxels, &["toy"], "voxels in a row", read_toy)
    .with_magic(&[Magic::first(b"toy ")])
    .with_up_axis(Some(UpAxis::Y))
    .with_recognition(|clues| if clues.head == b"a row" { Recognition::Likely } else { Recognition::Unknown })
    .with_folders(|clues| Ok(clues.files()?.iter().any(|file| file.ends_with("row.toy"))));

fn read_toy(source: Source<'_>, _: &ImportOptions) -> Result<Data, import::ImportError> {
    let bytes = match source.is_folder() {
        true => {
            fs::read(source.path().join("row.toy")).map_err(|error| import::ImportError::io(source.path(), error))?
        }
        false => source.into_bytes()?,
    };
    let mut grid = VoxelGrid::new();
    for (at, _) in bytes.iter().enumerate().filter(|(_, byte)| **byte != b' ') {
        grid.set(IVec3::new(0, 0, at as i32), 0);
    }
    let notes = vec!["a toy".to_owned()];
    Ok(Voxels { scene: Scene::from_grid("", grid, vec![Material::default()]), notes }.into())
}

#[test]
fn a_format_is_one_line_in_the_table_and_nothing_else_has_to_know_it() {
    let readers: Vec<&Reader> = READERS.iter().chain([&TOY]).collect();
    let table = Readers(&readers);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("row.toy");
    let options = ImportOptions::default();
    // Nothing knows it that is not told.
    fs::write(&path, "toy x").unwrap();
    assert!(matches!(import::load(&path, &options).unwrap_err().kind, ImportErrorKind::UnknownFormat(_)));
    // By its name, its first bytes, a hunch, and as a folder.
    let voxels = |loaded: import::Loaded| loaded.content.into_scene().grids[0].count();
    let loaded = table.open(&path, &options).unwrap().load().unwrap();
    assert_eq!((loaded.notes.as_slice(), voxels(loaded.clone())), (&["a toy".to_owned()][..], 4));
    for (bytes, name, count) in [(&b"xx"[..], "b.TOY", 2), (b"toy ", "unnamed", 3), (b"a row", "unnamed", 4)] {
        let opened = table.open_bytes(bytes, Path::new(name), &options).unwrap();
        assert_eq!((opened.reader(), voxels(opened.load().unwrap())), (&TOY, count));
    }
    assert_eq!(voxels(table.open(folder.path(), &options).unwrap().load().unwrap()), 4);
    // Named, turned and in the unit that is asked for, as all are.
    let options = ImportOptions { up: Some(UpAxis::Z), unit: Some(voxtrace::scene::LengthUnit::METRE), ..options };
    let scene = table.open(&path, &options).unwrap().load().unwrap().content.into_scene();
    assert_eq!((scene.name.as_str(), scene.unit), ("row", voxtrace::scene::Unit::Metre));
    let up = scene.instances[0].world_from_grid.linear * Vec3::Z;
    assert_eq!(up, UpAxis::Z.to_z_up(UpAxis::MinusY.to_z_up(Vec3::Z)));
    // In the list of extensions, and in what is said where none fits.
    assert_eq!(table.extensions().last(), Some(&"toy"));
    let error = table.open_bytes(b"", Path::new("a.jpg"), &options).map(|_| ()).unwrap_err();
    assert!(error.to_string().contains(".toy are read"), "{error}");
}

#[test]
fn the_same_load_takes_files_and_bytes_and_keeps_the_notes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    let text = "ply\nformat ascii 1.0\ncomment TextureFile gone.png\nelement vertex 3\nproperty float x\nproperty float y\n\
        property float z\nproperty float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
        0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n";
    fs::write(&path, text).unwrap();
    let options = ImportOptions::default();
    let (file, memory) =
        (import::load(&path, &options).unwrap(), import::load_bytes(text.as_bytes(), &path, &options).unwrap());
    assert_eq!(file.notes.len(), 1, "{:?}", file.notes);
    assert_eq!(memory.notes.len(), 1, "{:?}", memory.notes);
    let (file, memory) = (file.content.into_scene(), memory.content.into_scene());
    assert_eq!(file, memory);
    assert!(matches!(import::read(&path, &options).unwrap(), Data::Geometry(Geometry::Mesh(_))));

    // A native file stays as it is packed, also out of memory, where it need not be aligned.
    let native = folder.path().join("a.vxt");
    PackedScene::pack(&file).unwrap().save(&native).unwrap();
    let bytes = [b" ".as_slice(), &fs::read(&native).unwrap()].concat();
    let hash = |content: Content| match content {
        Content::Packed(packed) => packed.content_hash(),
        Content::Scene(_) => panic!("unpacked"),
    };
    let (of_file, of_bytes) = (import::load(&native, &options), import::load_bytes(&bytes[1..], &native, &options));
    assert_eq!(hash(of_file.unwrap().content), hash(of_bytes.unwrap().content));
    let error = import::load_bytes(&bytes[1..bytes.len() - 9], &native, &options).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Native(_)), "{error}");
}
