//! Meshes that trimesh, DracoPy and meshopt, other programs' libraries, have written, read by the importers; skipped where no
//! Python has them and pillow.

mod written;

use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, ImportOptions};
use voxtrace::material::srgb_from_linear;
use voxtrace::mesh::UpAxis;
use voxtrace::voxelize::{Scale, VoxelizeOptions};
use written::Written;

static WRITTEN: Written = Written::by("meshes.py", "trimesh, pillow, DracoPy and meshopt");

fn open(path: &Path, scale: Scale) -> Scene {
    // trimesh writes the same coordinates into every file, so a glTF's are taken as they are too.
    let voxelize = VoxelizeOptions { scale, ..VoxelizeOptions::default() };
    import::open(path, &ImportOptions { up: Some(UpAxis::Z), voxelize, ..ImportOptions::default() }).unwrap()
}

fn colors(scene: &Scene) -> Vec<(IVec3, [u8; 3])> {
    let color = |material: u16| scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
    scene.grids[0].voxels().map(|(voxel, material)| (voxel, color(material))).collect()
}

#[test]
fn one_shape_in_six_files_of_trimesh_has_the_same_voxels() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mut first: Option<Vec<IVec3>> = None;
    for name in ["shape.glb", "shape.obj", "shape_text.ply", "shape_binary.ply", "shape_text.stl", "shape_binary.stl"] {
        let scene = open(&folder.join(name), Scale::Resolution(200));
        let voxels: Vec<IVec3> = scene.grids[0].voxels().map(|(voxel, _)| voxel).collect();
        assert!(voxels.len() > 20_000, "{name}: {}", voxels.len());
        let expected = first.get_or_insert_with(|| voxels.clone());
        assert!(*expected == voxels, "{name}: {} voxels, not {}", voxels.len(), expected.len());
    }
    // Another size is told apart.
    let scene = open(&folder.join("shape.obj"), Scale::Resolution(201));
    assert!(first.unwrap() != scene.grids[0].voxels().map(|(voxel, _)| voxel).collect::<Vec<_>>());
}

#[test]
fn compressed_gltf_files_have_the_voxels_and_colours_of_the_plain_one() {
    let Some(folder) = WRITTEN.folder() else { return };
    let read = |name: &str| open(&folder.join(name), Scale::Resolution(200));
    let plain = read("shape.glb");
    // Colours of vertices are linear.
    let color = [200, 100, 50].map(|byte: u8| srgb_from_linear(f32::from(byte) / 255.0));
    let has_color = |scene: &Scene| colors(scene).iter().all(|&(_, found)| found == color);
    // Meshopt keeps every bit.
    for name in ["meshopt.glb", "meshopt_filtered.glb"] {
        let scene = read(name);
        assert!(scene.grids[0].voxels().map(|(voxel, _)| voxel).eq(plain.grids[0].voxels().map(|(voxel, _)| voxel)));
        assert!(has_color(&scene), "{name}");
    }
    // Draco rounds coordinates to 22 bits: a voxel that is touched may not be any more.
    for name in ["draco_1.glb", "draco_7.glb", "draco_10.glb"] {
        let scene = read(name);
        let (found, wanted) = (&scene.grids[0], &plain.grids[0]);
        let kept = found.voxels().filter(|&(voxel, _)| wanted.get(voxel).is_some()).count() as u64;
        let (least, most) = (wanted.count() * 998 / 1000, wanted.count() * 1002 / 1000);
        assert!(kept >= least && found.count() <= most, "{name}: {kept} of {}, {}", wanted.count(), found.count());
        assert!(has_color(&scene), "{name}");
    }
}

#[test]
fn colours_of_vertices_are_those_that_trimesh_wrote() {
    let Some(folder) = WRITTEN.folder() else { return };
    let scene = open(&folder.join("colored.ply"), Scale::Resolution(60));
    assert!(colors(&scene).iter().all(|&(_, color)| color == [200, 100, 50]));
}

#[test]
fn colours_of_faces_are_those_that_trimesh_wrote() {
    let Some(folder) = WRITTEN.folder() else { return };
    for name in ["painted_binary.ply", "painted_text.ply"] {
        let scene = open(&folder.join(name), Scale::Resolution(60));
        let found = colors(&scene);
        // Along y the torus takes the first 52 voxels, and the box those from 55 on.
        let first = found.iter().map(|(voxel, _)| voxel.y).min().unwrap();
        let is_box = |voxel: &IVec3| voxel.y - first > 53;
        let wanted = |voxel: &IVec3| if is_box(voxel) { [40, 90, 220] } else { [200, 100, 50] };
        assert!(found.iter().any(|(voxel, _)| is_box(voxel)), "{name}");
        assert!(found.iter().all(|(voxel, color)| *color == wanted(voxel)), "{name}");
    }
}

#[test]
fn texels_of_a_square_are_where_trimesh_put_them() {
    let Some(folder) = WRITTEN.folder() else { return };
    for name in ["square.glb", "square.obj"] {
        let scene = open(&folder.join(name), Scale::VoxelSize(1.0));
        let found = colors(&scene);
        assert_eq!(found.len(), 16, "{name}");
        // On the diagonal two triangles sample beside the middle of the texel.
        for (voxel, [red, green, blue]) in found.into_iter().filter(|(voxel, _)| voxel.x != voxel.y) {
            // The first row of a picture is at the top: v = 1, y = 4.
            let expected = [voxel.x * 60, (3 - voxel.y) * 60, 200];
            let error = (i32::from(red) - expected[0]).abs().max((i32::from(green) - expected[1]).abs());
            assert!(error <= 1 && (i32::from(blue) - 200).abs() <= 1, "{name} {voxel}: {red} {green} {blue}");
        }
    }
}
