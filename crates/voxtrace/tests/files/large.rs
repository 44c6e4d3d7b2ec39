//! Meshes that stay in their file while they become voxels: the same bytes as from memory, whatever the budget.

use glam::Vec3;
use std::path::{Path, PathBuf};
use voxtrace::import::{self, ImportErrorKind, ImportOptions, LargeGeometry, Limits};
use voxtrace::mesh::UpAxis;
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress, voxelize_to_file};

/// Corners of a bumpy ball, and its faces: triangles below, quadrilaterals above.
fn ball(rows: u32) -> (Vec<Vec3>, Vec<Vec<u32>>) {
    let columns = 2 * rows;
    let point = |i: u32, j: u32| {
        let (longitude, latitude) =
            (i as f32 / columns as f32 * std::f32::consts::TAU, (j as f32 / rows as f32 - 0.5) * std::f32::consts::PI);
        let radius = 30.0 + 4.0 * (5.0 * longitude).sin() * (7.0 * latitude).cos();
        radius * Vec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin())
    };
    let corners = (0..=rows).flat_map(|j| (0..columns).map(move |i| point(i, j))).collect();
    let mut faces = Vec::new();
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let index = |i: u32, j: u32| j * columns + i % columns;
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        if 2 * j < rows {
            faces.extend([vec![a, b, c], vec![a, c, d]]);
        } else {
            faces.push(vec![a, b, c, d]);
        }
    }
    (corners, faces)
}

#[derive(Clone, Copy, PartialEq)]
enum Look {
    Plain,
    Colors,
    Alpha,
    /// Bytes that are written as floating-point numbers.
    Floats,
    Texture,
    /// Of faces instead of vertices.
    FaceColors,
    FaceTexture,
}

/// A binary PLY file, big endian where there is an alpha channel.
fn ply(folder: &Path, look: Look) -> PathBuf {
    let (corners, faces) = ball(60);
    let is_big = look == Look::Alpha;
    let order = if is_big { "big" } else { "little" };
    let mut head = format!("ply\nformat binary_{order}_endian 1.0\n");
    if matches!(look, Look::Texture | Look::FaceTexture) {
        head += "comment TextureFile picture.png\n";
        let mut encoder = png::Encoder::new(std::fs::File::create(folder.join("picture.png")).unwrap(), 64, 64);
        encoder.set_color(png::ColorType::Rgb);
        let texels: Vec<u8> = (0..64 * 64u32).flat_map(|at| [at as u8, (at >> 4) as u8, 200]).collect();
        encoder.write_header().unwrap().write_image_data(&texels).unwrap();
    }
    // More than a block of the cache of vertices.
    head += &format!("element vertex {}\nproperty float x\nproperty float y\nproperty double z\n", corners.len());
    head += match look {
        Look::Plain | Look::FaceColors | Look::FaceTexture => "",
        Look::Colors => "property uchar red\nproperty uchar green\nproperty uchar blue\n",
        Look::Alpha => "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
        Look::Floats => "property float red\nproperty float green\nproperty float blue\n",
        Look::Texture => "property float s\nproperty float t\n",
    };
    head += "element thing 2\nproperty list uchar short parts\n";
    head += &format!("element face {}\nproperty int number\nproperty list uchar uint vertex_indices\n", faces.len());
    head += match look {
        Look::FaceColors => "property uchar red\nproperty ushort green\nproperty uchar blue\n",
        Look::FaceTexture => "property list uchar float texcoord\n",
        _ => "",
    };
    head += "end_header\n";
    let mut bytes = head.into_bytes();
    let mut put = |value: &[u8]| {
        if is_big { bytes.extend(value.iter().rev()) } else { bytes.extend(value) }
    };
    for corner in &corners {
        // Far from the origin, so that there is an offset.
        put(&(corner.x + 5000.0).to_le_bytes());
        put(&corner.y.to_le_bytes());
        put(&f64::from(corner.z).to_le_bytes());
        let byte = |value: f32| [(value * 4.0 + 128.0) as u8];
        match look {
            Look::Plain | Look::FaceColors | Look::FaceTexture => {}
            Look::Colors | Look::Alpha => {
                corner.to_array().iter().for_each(|&value| put(&byte(value)));
                if look == Look::Alpha {
                    put(&byte(corner.x));
                }
            }
            Look::Floats => {
                let bytes = corner.to_array().map(|value| f32::from(byte(value)[0]));
                bytes.iter().for_each(|value| put(&value.to_le_bytes()));
            }
            Look::Texture => [corner.x, corner.z].iter().for_each(|value| put(&(value / 20.0).to_le_bytes())),
        }
    }
    put(&[1]);
    put(&7i16.to_le_bytes());
    put(&[0]);
    for face in &faces {
        put(&9i32.to_le_bytes());
        put(&[face.len() as u8]);
        face.iter().for_each(|corner| put(&corner.to_le_bytes()));
        let middle = corners[face[0] as usize];
        match look {
            Look::FaceColors => {
                put(&[(middle.x * 4.0 + 128.0) as u8]);
                put(&((middle.y * 900.0 + 32_768.0) as u16).to_le_bytes());
                put(&[200]);
            }
            Look::FaceTexture => {
                put(&[2 * face.len() as u8]);
                let places =
                    face.iter().map(|&at| corners[at as usize]).flat_map(|corner| [corner.x, corner.z - middle.y]);
                places.for_each(|value| put(&(value / 20.0).to_le_bytes()));
            }
            _ => {}
        }
    }
    let path = folder.join("ball.ply");
    std::fs::write(&path, bytes).unwrap();
    path
}

/// A binary STL file, with colours as VisCAM writes them, but for the first triangles, or without.
fn stl(folder: &Path, is_colored: bool) -> PathBuf {
    let (corners, faces) = ball(60);
    let triangles: Vec<[u32; 3]> = faces.iter().flat_map(|f| (2..f.len()).map(|i| [f[0], f[i - 1], f[i]])).collect();
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for (number, triangle) in triangles.into_iter().enumerate() {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flat_map(|&at| corners[at as usize].to_array()).flat_map(f32::to_le_bytes));
        let color = if is_colored && number > 700 { 0x8000 | number as u16 } else { 0 };
        bytes.extend(color.to_le_bytes());
    }
    let path = folder.join(if is_colored { "colored.stl" } else { "ball.stl" });
    std::fs::write(&path, bytes).unwrap();
    path
}

/// The file that comes of a mesh that is read at once.
fn from_memory(path: &Path, import: &ImportOptions, options: &VoxelizeOptions) -> Vec<u8> {
    let mesh = import::read_mesh(path, import).unwrap();
    let out = path.with_extension("memory.vxt");
    voxelize_to_file(mesh, options, &Limits::default(), &out, &VoxelizeProgress::default()).unwrap();
    std::fs::read(out).unwrap()
}

fn open(path: &Path, import: &ImportOptions) -> LargeGeometry {
    import::open_large(path, import, 1).unwrap().expect("the file is not read piece by piece")
}

#[test]
fn a_mesh_that_stays_in_its_file_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let looks =
        [Look::Plain, Look::Colors, Look::Alpha, Look::Floats, Look::Texture, Look::FaceColors, Look::FaceTexture];
    let mut files: Vec<PathBuf> = Vec::new();
    for look in looks {
        let own = folder.path().join((look as u8).to_string());
        std::fs::create_dir(&own).unwrap();
        files.push(ply(&own, look));
    }
    files.extend([false, true].map(|is_colored| stl(folder.path(), is_colored)));
    for path in files {
        for (rule, scale, up) in [
            (SurfaceRule::Conservative, Scale::Resolution(250), None),
            (SurfaceRule::Thin, Scale::VoxelSize(0.4), Some(UpAxis::MinusX)),
        ] {
            let import = ImportOptions { up, ..ImportOptions::default() };
            let options = VoxelizeOptions { rule, scale, ..VoxelizeOptions::default() };
            let expected = from_memory(&path, &import, &options);
            for memory_budget in [Some(1), Some(1 << 20), None] {
                let out = path.with_extension("large.vxt");
                let options = VoxelizeOptions { memory_budget, ..options };
                let mut large = open(&path, &import);
                let progress = VoxelizeProgress::default();
                let written = large.voxelize_to_file(&options, &Limits::default(), &out, &progress).unwrap();
                assert!(std::fs::read(&out).unwrap() == expected, "{} {rule:?} {memory_budget:?}", path.display());
                assert_eq!((progress.done(), progress.total()), (2 * large.count(), 2 * large.count()));
                let estimate = large.estimate(&options).unwrap();
                let ratio = estimate.voxels as f64 / written.voxels as f64;
                assert!((0.9..1.2).contains(&ratio), "{rule:?}: {ratio}");
            }
        }
        let own = path.parent().unwrap();
        let names: Vec<_> = std::fs::read_dir(own).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert!(names.iter().all(|name| !name.to_string_lossy().starts_with('.')), "{names:?}");
    }
}

#[test]
fn a_budget_that_holds_the_mesh_or_a_format_without_numbers_of_bytes_is_read_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let path = ply(folder.path(), Look::Plain);
    assert!(import::open_large(&path, &ImportOptions::default(), 1 << 30).unwrap().is_none());
    let text = folder.path().join("text.stl");
    std::fs::write(&text, "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n").unwrap();
    assert!(import::open_large(&text, &ImportOptions::default(), 1).unwrap().is_none());
}

#[test]
fn a_file_that_ends_early_or_names_corners_that_are_not_there_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = ply(folder.path(), Look::Colors);
    let whole = std::fs::read(&path).unwrap();
    let result = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        let large = import::open_large(&path, &ImportOptions::default(), 1);
        large.map_err(VoxelizeError::from).and_then(|large| {
            let options = VoxelizeOptions::default();
            let progress = VoxelizeProgress::default();
            let out = folder.path().join("out.vxt");
            large.unwrap().voxelize_to_file(&options, &Limits::default(), &out, &progress).map(drop)
        })
    };
    result(&whole).unwrap();
    for cut in [1, 7, 1000, whole.len() / 2, whole.len() - 1000] {
        let error = result(&whole[..whole.len() - cut]).unwrap_err();
        let VoxelizeError::Import(error) = error else { panic!("{cut}: {error}") };
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{cut}: {error}");
    }
    let mut wrong = whole.clone();
    let at = wrong.len() - 1;
    wrong[at] = 1;
    let error = result(&wrong).unwrap_err().to_string();
    assert!(error.contains("a face has corner") && error.contains("at byte"), "{error}");
    let mut infinite = whole;
    let at = infinite.windows(10).position(|bytes| bytes == b"end_header").unwrap() + 11 + 5000 * 19;
    infinite[at..at + 4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert!(result(&infinite).unwrap_err().to_string().contains("not finite"));
}

#[test]
fn a_survey_and_the_work_can_be_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let path = stl(folder.path(), false);
    let progress = VoxelizeProgress::default();
    progress.cancel();
    let mut large = open(&path, &ImportOptions::default());
    assert!(matches!(large.survey(&VoxelizeOptions::default(), &progress), Err(VoxelizeError::Cancelled)));
    let out = folder.path().join("out.vxt");
    let result = large.voxelize_to_file(&VoxelizeOptions::default(), &Limits::default(), &out, &progress);
    assert!(matches!(result, Err(VoxelizeError::Cancelled)) && !out.exists());
}

/// Does some work until so many of its pieces are done, then stops it. What it has to say, and whether it was stopped.
fn stopped(after: u64, work: impl FnOnce(&VoxelizeProgress) -> Result<(), VoxelizeError> + Send) -> (bool, String) {
    let progress = VoxelizeProgress::default();
    let result = std::thread::scope(|scope| {
        let worker = scope.spawn(|| work(&progress));
        while !worker.is_finished() {
            if progress.done() > after {
                progress.cancel();
            }
            std::thread::yield_now();
        }
        worker.join().unwrap()
    });
    match result {
        Ok(()) => (false, progress.take_notes().join("\n")),
        Err(VoxelizeError::Cancelled) => (true, progress.take_notes().join("\n")),
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn work_that_was_stopped_goes_on_and_ends_with_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let path = ply(folder.path(), Look::Colors);
    let options = VoxelizeOptions {
        scale: Scale::Resolution(400),
        memory_budget: Some(1),
        max_materials: 300,
        ..VoxelizeOptions::default()
    };
    let import = ImportOptions::default();
    let expected = from_memory(&path, &import, &VoxelizeOptions { memory_budget: None, ..options });
    let filled = VoxelizeOptions { fill: true, scale: Scale::Resolution(250), ..options };
    let expected_filled = from_memory(&path, &import, &VoxelizeOptions { memory_budget: None, ..filled });
    let mesh = import::read_mesh(&path, &import).unwrap();
    let (out, limits) = (folder.path().join("out.vxt"), Limits::default());
    let part = folder.path().join("out.vxt.part");
    let at_once = |options: VoxelizeOptions| {
        let (mesh, out) = (mesh.clone(), out.clone());
        move |progress: &VoxelizeProgress| voxelize_to_file(mesh, &options, &limits, &out, progress).map(drop)
    };
    let piecewise = || {
        let (mut large, out) = (open(&path, &import), out.clone());
        move |progress: &VoxelizeProgress| large.voxelize_to_file(&options, &limits, &out, progress).map(drop)
    };
    for kind in ["at once", "filled", "piecewise"] {
        let run = |after: u64| match kind {
            "at once" => stopped(after, at_once(options)),
            "filled" => stopped(after, at_once(filled)),
            _ => stopped(after, piecewise()),
        };
        let expected = if kind == "filled" { &expected_filled } else { &expected };
        // Sorting comes first, where it is piecewise: 14,400 triangles.
        let first = if kind == "piecewise" { 14_500 } else { 1 };
        // The work may be done before anybody stops it; then once more.
        let notes = (0..100).map(|_| run(first)).find(|(was_stopped, _)| *was_stopped).expect("never stopped").1;
        let _ = std::fs::remove_file(&out);
        assert!(part.exists(), "{kind}: {notes}");
        assert!(notes.contains("out.vxt.part: the same command goes on"), "{kind}: {notes}");

        // A byte in the middle is wrong, as after a crash of the machine: what comes before it is still good.
        let whole = std::fs::read(&part).unwrap();
        let mut damaged = whole.clone();
        damaged[whole.len() - 20] ^= 1;
        std::fs::write(&part, damaged).unwrap();
        let (was_stopped, notes) = run(u64::MAX);
        let is_said = notes.contains("its end was not whole") || notes.contains("nothing in");
        assert!(!was_stopped && is_said && !part.exists(), "{kind}: {notes}");
        assert!(std::fs::read(&out).unwrap() == *expected, "{kind}, damaged");

        // As it was left.
        std::fs::remove_file(&out).unwrap();
        std::fs::write(&part, &whole).unwrap();
        let (_, notes) = run(u64::MAX);
        assert!(
            notes.contains("going on from") && notes.contains("bricks are done") && !notes.contains("whole"),
            "{notes}"
        );
        assert!(std::fs::read(&out).unwrap() == *expected && !part.exists(), "{kind}");

        // Left by other work.
        std::fs::write(&part, &whole).unwrap();
        let other = VoxelizeOptions { rule: SurfaceRule::Thin, ..options };
        let (_, notes) = stopped(u64::MAX, at_once(other));
        assert!(notes.contains("left over from other work: starting over"), "{notes}");
        assert!(std::fs::read(&out).unwrap() != *expected && !part.exists(), "{kind}");
        std::fs::remove_file(&out).unwrap();
    }
}

#[test]
fn a_part_file_with_a_bent_brick_changes_nothing() {
    // What is checked is the work's own sum over each batch, so that a bent brick is done again and not drawn.
    let folder = tempfile::tempdir().unwrap();
    let path = stl(folder.path(), false);
    let options =
        VoxelizeOptions { scale: Scale::Resolution(500), memory_budget: Some(1), ..VoxelizeOptions::default() };
    let import = ImportOptions::default();
    let expected = from_memory(&path, &import, &VoxelizeOptions { memory_budget: None, ..options });
    let out = folder.path().join("out.vxt");
    let part = folder.path().join("out.vxt.part");
    let work = || {
        let (mut large, out) = (open(&path, &import), out.clone());
        move |progress: &VoxelizeProgress| {
            large.voxelize_to_file(&options, &Limits::default(), &out, progress).map(drop)
        }
    };
    // The work may be done before anybody stops it; then once more.
    assert!((0..100).any(|_| stopped(14_500, work()).0), "never stopped");
    let whole = std::fs::read(&part).unwrap();
    for share in [10, 40, 90] {
        let mut bent = whole.clone();
        bent[whole.len() * share / 100] ^= 0x40;
        std::fs::write(&part, bent).unwrap();
        stopped(u64::MAX, work());
        assert!(std::fs::read(&out).unwrap() == expected, "{share}");
    }
}
