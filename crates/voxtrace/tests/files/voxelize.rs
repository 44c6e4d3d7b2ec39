//! Voxels of meshes against the surface that they stand for: exact tests of triangle and voxel, analytic spheres, tori and
//! boxes, known texels, and a flood that must not get in.

use crate::meshes::{Random, cuboid, indexed, sphere, torus};
use crate::voxelized::{color_at, options, scene_of, textured_cube, voxels_of};
use std::collections::BTreeSet;
use voxtrace::glam::{DVec3, IVec3, Mat3, Vec2, Vec3};
use voxtrace::import::Limits;
use voxtrace::mesh::Mesh;
use voxtrace::voxelize::{
    Scale, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress, estimate, voxelize, voxelize_to_file,
    voxelize_with_progress,
};
use voxtrace::{PackedScene, Scene};

/// By how much a triangle and a voxel overlap along the axis that separates them most, negative where one does
/// (Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", 2001): the slow reference.
fn overlap(corners: [DVec3; 3], voxel: [i32; 3]) -> f64 {
    let middle = IVec3::from_array(voxel).as_dvec3() + 0.5;
    let corners = corners.map(|corner| corner - middle);
    let edges = [corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]];
    let units = [DVec3::X, DVec3::Y, DVec3::Z];
    let crossed = units.iter().flat_map(|&unit| edges.iter().map(move |&edge| unit.cross(edge)));
    let axes = crossed.chain(units).chain([edges[0].cross(edges[1])]);
    axes.filter(|axis| axis.length() > 1e-12)
        .map(|axis| {
            let axis = axis.normalize();
            let reach = 0.5 * axis.abs().element_sum();
            let along = corners.map(|corner| corner.dot(axis));
            let low = along.iter().copied().fold(f64::INFINITY, f64::min);
            let high = along.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            (reach - low).min(high + reach)
        })
        .fold(f64::INFINITY, f64::min)
}

/// The largest overlap of any triangle of the mesh with the voxel.
fn mesh_overlap(mesh: &Mesh, voxel: [i32; 3]) -> f64 {
    let triangles = (0..mesh.triangle_count()).map(|index| mesh.corners(index).map(|at| mesh.positions[at].as_dvec3()));
    triangles.map(|corners| overlap(corners, voxel)).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn random_triangles_take_exactly_the_voxels_that_they_cross() {
    // Corners are rounded to 1/4096 of a voxel; within that either answer is right.
    const LATTICE: f64 = 2e-3;
    let mut random = Random(1);
    for round in 0..400 {
        let size = [3.0, 12.0, 50.0][round % 3];
        let corners: Vec<Vec3> = (0..3).map(|_| random.point(size)).collect();
        let low = corners.iter().copied().reduce(Vec3::min).unwrap().floor();
        let mesh = Mesh { positions: corners.iter().map(|&corner| corner - low).collect(), ..Mesh::new("triangle") };
        let voxels = voxels_of(&scene_of(&mesh, SurfaceRule::Conservative));
        let high = mesh.positions.iter().copied().reduce(Vec3::max).unwrap().ceil().as_ivec3();
        for z in -1..=high.z {
            for y in -1..=high.y {
                for x in -1..=high.x {
                    let overlap = mesh_overlap(&mesh, [x, y, z]);
                    let is_set = voxels.contains(&[x, y, z]);
                    assert!(is_set || overlap < LATTICE, "round {round}: {x} {y} {z} is missing by {overlap}");
                    assert!(!is_set || overlap > -LATTICE, "round {round}: {x} {y} {z} is too much by {overlap}");
                }
            }
        }
    }
}

/// The voxels of a box around the mesh whose corners a signed distance puts on both sides by more than `margin`, and the
/// same for "crosses or nearly so".
fn check_against(mesh: &Mesh, margin: f32, distance: impl Fn(Vec3) -> f32) {
    for rule in [SurfaceRule::Conservative, SurfaceRule::Thin] {
        let voxels = voxels_of(&scene_of(mesh, rule));
        let (_, max) = mesh.bounds().unwrap();
        let high = max.ceil().as_ivec3();
        let mut expected = 0;
        for z in -1..=high.z {
            for y in -1..=high.y {
                for x in -1..=high.x {
                    let low = Vec3::new(x as f32, y as f32, z as f32);
                    let corners = (0..8).map(|corner| {
                        distance(low + Vec3::new((corner & 1) as f32, (corner >> 1 & 1) as f32, (corner >> 2) as f32))
                    });
                    let (inner, outer) = corners.fold((f32::MAX, f32::MIN), |(a, b), d| (a.min(d), b.max(d)));
                    let is_set = voxels.contains(&[x, y, z]);
                    if rule == SurfaceRule::Conservative && inner < -margin && outer > margin {
                        expected += 1;
                        assert!(is_set, "{x} {y} {z} is crossed but empty");
                    }
                    // Half the diagonal of a voxel for surfaces crossed anywhere, half its edge for thin ones.
                    let reach = if rule == SurfaceRule::Conservative { 3f32.sqrt() / 2.0 } else { 0.5 };
                    let middle = distance(low + 0.5).abs();
                    assert!(!is_set || middle <= reach + margin, "{rule:?}: {x} {y} {z} is {middle} away");
                }
            }
        }
        assert!(rule == SurfaceRule::Thin || expected > 500, "{expected}");
        assert!(voxels.len() > 500);
    }
}

#[test]
fn a_sphere_is_where_the_sphere_is() {
    let (center, radius) = (Vec3::new(20.3, 20.6, 20.4), 19.7);
    check_against(&sphere(center, radius, 200), 0.01, |point| point.distance(center) - radius);
}

#[test]
fn a_torus_is_where_the_torus_is() {
    let (center, ring, tube) = (Vec3::new(24.5, 24.2, 8.4), 16.0, 7.7);
    check_against(&torus(center, ring, tube, 200), 0.01, |point| {
        let from = point - center;
        Vec2::new(from.truncate().length() - ring, from.z).length() - tube
    });
}

#[test]
fn a_box_between_whole_coordinates_is_as_wide_as_it_says() {
    let voxels =
        voxels_of(&scene_of(&cuboid(Vec3::ZERO, Vec3::new(6.0, 5.0, 4.0), Mat3::IDENTITY), SurfaceRule::Conservative));
    let expected: BTreeSet<[i32; 3]> = (0..120)
        .map(|i| [i % 6, i / 6 % 5, i / 30])
        .filter(|&[x, y, z]| x == 0 || x == 5 || y == 0 || y == 4 || z == 0 || z == 3)
        .collect();
    assert_eq!(voxels, expected);
    // By resolution the box fills the grid from corner to corner.
    let mesh = cuboid(Vec3::new(0.1, 0.2, 0.3), Vec3::new(0.7, 0.7, 0.7), Mat3::IDENTITY);
    let scene = voxelize(&mesh, &options(Scale::Resolution(600)), &Limits::default()).unwrap();
    let bounds = scene.grids[0].bounds().unwrap();
    assert_eq!((bounds.min, bounds.max), (IVec3::ZERO, IVec3::new(600, 500, 400)));
}

#[test]
fn a_turned_box_takes_exactly_the_voxels_that_its_faces_cross() {
    let turn = Mat3::from_rotation_z(0.5) * Mat3::from_rotation_x(0.3);
    let mesh = cuboid(Vec3::splat(8.0), Vec3::splat(24.0), turn);
    let low = mesh.positions.iter().copied().reduce(Vec3::min).unwrap().floor();
    let mesh = indexed(mesh.positions.iter().map(|&p| p - low).collect(), mesh.triangles);
    let voxels = voxels_of(&scene_of(&mesh, SurfaceRule::Conservative));
    let (mut crossed, mut clear) = (0, 0);
    for index in 0..30 * 30 * 30 {
        let voxel = [index % 30, index / 30 % 30, index / 900];
        let overlap = mesh_overlap(&mesh, voxel);
        assert!(voxels.contains(&voxel) || overlap < 2e-3, "{voxel:?} is missing");
        assert!(!voxels.contains(&voxel) || overlap > -2e-3, "{voxel:?} is too much");
        crossed += i32::from(overlap > 0.0);
        clear += i32::from(overlap < -0.5);
    }
    assert!(crossed > 1000 && clear > 1000);
}

fn filled(mesh: &Mesh, rule: SurfaceRule) -> Scene {
    let options = VoxelizeOptions { rule, fill: true, ..options(Scale::VoxelSize(1.0)) };
    voxelize(mesh, &options, &Limits::default()).unwrap()
}

#[test]
fn a_filled_sphere_holds_exactly_the_voxels_inside_and_on_it() {
    let (center, radius) = (Vec3::new(40.3, 40.6, 40.4), 39.7);
    let mesh = sphere(center, radius, 200);
    for rule in [SurfaceRule::Conservative, SurfaceRule::Thin] {
        let (shell, solid) = (voxels_of(&scene_of(&mesh, rule)), voxels_of(&filled(&mesh, rule)));
        for index in 0..82 * 82 * 82 {
            let voxel = [index % 82, index / 82 % 82, index / (82 * 82)];
            let distance = (IVec3::from_array(voxel).as_vec3() + 0.5).distance(center) - radius;
            if distance.abs() > 0.02 {
                let expected = distance < 0.0 || shell.contains(&voxel);
                assert_eq!(solid.contains(&voxel), expected, "{rule:?} {voxel:?} {distance}");
            }
        }
    }
    // Half of the sphere is open: nothing is inside.
    let mut bowl = mesh;
    bowl.triangles.truncate(bowl.triangles.len() / 2);
    assert_eq!(voxels_of(&filled(&bowl, SurfaceRule::Thin)), voxels_of(&scene_of(&bowl, SurfaceRule::Thin)));
}

#[test]
fn surfaces_that_are_open_are_told_where_they_are_to_be_filled() {
    let notes = |mesh: &Mesh| {
        let progress = VoxelizeProgress::default();
        let options = VoxelizeOptions { fill: true, ..options(Scale::VoxelSize(1.0)) };
        voxelize_with_progress(mesh, &options, &Limits::default(), &progress).unwrap();
        progress.take_notes()
    };
    let mut mesh = cuboid(Vec3::ZERO, Vec3::splat(4.0), Mat3::IDENTITY);
    assert_eq!(notes(&mesh), [""; 0]);
    // One half of a face is gone that lies across the upright lines.
    let corner = |mesh: &Mesh, corner: u32| mesh.positions[corner as usize].z;
    let flat = mesh.triangles.iter().position(|corners| corners.iter().all(|&own| corner(&mesh, own) == 4.0));
    mesh.triangles.remove(flat.unwrap());
    let told = notes(&mesh);
    assert!(told.len() == 1 && told[0].contains("meet a surface that is not closed"), "{told:?}");
}

#[test]
fn a_filled_box_is_solid_in_the_colour_of_its_floor() {
    let (mesh, texel) = textured_cube();
    let scene = filled(&mesh, SurfaceRule::Conservative);
    assert_eq!(scene.grids[0].count(), 512);
    for i in 1..7u32 {
        assert_eq!(color_at(&scene, [i as i32, 2, 4]), Some(texel(4, i, 5)));
    }
    let box_of =
        |size| voxels_of(&filled(&cuboid(Vec3::ZERO, Vec3::splat(size), Mat3::IDENTITY), SurfaceRule::Conservative));
    assert_eq!(box_of(70.0).len(), 343_000);
}

#[test]
fn a_thin_sheet_is_one_voxel_thick_along_its_widest_axis() {
    let sheet = |slope: f32| {
        let corner = |x: f32, y: f32| Vec3::new(x, y, 0.5 + x * slope + 0.3 * y * slope);
        indexed(
            vec![corner(0.0, 0.0), corner(40.0, 0.0), corner(40.0, 40.0), corner(0.0, 40.0)],
            vec![[0, 1, 2], [0, 2, 3]],
        )
    };
    for slope in [0.0, 0.3, 0.7] {
        let voxels = voxels_of(&scene_of(&sheet(slope), SurfaceRule::Thin));
        for column in 0..1600 {
            let [x, y] = [column % 40, column / 40];
            let height = voxels.iter().filter(|voxel| voxel[0] == x && voxel[1] == y).count();
            // One for the line along z, and at most one more where a line along x or y crosses above or below.
            assert!(height == 1 || height == 2 && slope > 0.0, "{slope}: {x} {y} has {height}");
        }
        assert!(voxels.is_subset(&voxels_of(&scene_of(&sheet(slope), SurfaceRule::Conservative))));
    }
}

/// Whether a flood from the corner of the box, through the neighbours given, reaches the middle.
fn flood_reaches_middle(voxels: &BTreeSet<[i32; 3]>, size: i32, neighbours: &[IVec3]) -> bool {
    let mut seen = vec![false; (size * size * size) as usize];
    let mut pending = vec![IVec3::ZERO];
    while let Some(at) = pending.pop() {
        let inside = at.cmpge(IVec3::ZERO).all() && at.cmplt(IVec3::splat(size)).all();
        if !inside || voxels.contains(&(at - 2).to_array()) {
            continue;
        }
        let index = ((at.z * size + at.y) * size + at.x) as usize;
        if !std::mem::replace(&mut seen[index], true) {
            pending.extend(neighbours.iter().map(|&step| at + step));
        }
    }
    seen[(((size / 2) * size + size / 2) * size + size / 2) as usize]
}

#[test]
fn nothing_gets_into_a_closed_surface() {
    let all: Vec<IVec3> = (0..27).map(|i| IVec3::new(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)).collect();
    let faces: Vec<IVec3> = all.iter().copied().filter(|step| step.abs().element_sum() == 1).collect();
    for steps in [3, 8, 60] {
        let mesh = sphere(Vec3::splat(15.01), 14.97, steps);
        for (rule, neighbours) in [(SurfaceRule::Conservative, &all), (SurfaceRule::Thin, &faces)] {
            let mut voxels = voxels_of(&scene_of(&mesh, rule));
            assert!(!flood_reaches_middle(&voxels, 36, neighbours), "{rule:?} {steps}");
            // The flood does find a hole.
            let hole: Vec<[i32; 3]> =
                voxels.iter().copied().filter(|v| v[0] == 15 && v[1] == 15 && v[2] > 15).collect();
            hole.iter().for_each(|voxel| assert!(voxels.remove(voxel)));
            assert!(!hole.is_empty() && flood_reaches_middle(&voxels, 36, neighbours), "{rule:?} {steps}");
        }
    }
}

/// A cube from 0 to 8 whose faces each show a picture of 8 × 8 texels.
#[test]
fn a_scene_written_tile_by_tile_is_the_scene_that_is_packed_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let mut shining = torus(Vec3::new(40.5, 40.5, 20.5), 28.0, 11.0, 90);
    shining.colors = shining.positions.iter().map(|&position| (position / 90.0).extend(1.0)).collect();
    shining.materials[0].emission = Vec3::new(0.5, 1.0, 2.0);
    let meshes = [textured_cube().0, sphere(Vec3::splat(50.2), 49.0, 100), shining];
    for (index, mesh) in meshes.into_iter().enumerate() {
        for rule in [SurfaceRule::Conservative, SurfaceRule::Thin] {
            let plain = VoxelizeOptions { rule, ..options(Scale::Resolution(150)) };
            let scene = voxelize(&mesh, &plain, &Limits::default()).unwrap();
            let packed = PackedScene::pack(&scene).unwrap();
            for (memory_budget, fill) in [(None, false), (Some(1), false), (Some(1), true)] {
                let path = folder.path().join(format!("{index}.vxt"));
                let options = VoxelizeOptions { memory_budget, fill, ..plain };
                let (scene, packed) = if fill {
                    let scene = voxelize(&mesh, &VoxelizeOptions { fill, ..plain }, &Limits::default()).unwrap();
                    let packed = PackedScene::pack(&scene).unwrap();
                    (scene, packed)
                } else {
                    (scene.clone(), packed.clone())
                };
                let progress = VoxelizeProgress::default();
                let written = voxelize_to_file(mesh.clone(), &options, &Limits::default(), &path, &progress).unwrap();
                let opened = PackedScene::open(&path).unwrap();
                assert_eq!(opened.content_hash(), packed.content_hash(), "{index} {rule:?} {memory_budget:?}");
                assert_eq!(written.voxels, scene.grids[0].count());
                assert_eq!((progress.done() > 0, progress.done()), (true, progress.total()));
                let names: Vec<_> = std::fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
                assert!(names.iter().all(|name| !name.to_string_lossy().starts_with('.')), "{names:?}");
            }
        }
    }
}

#[test]
fn the_voxels_do_not_depend_on_the_number_of_threads() {
    let (mesh, _) = textured_cube();
    let scene = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let options = VoxelizeOptions { max_materials: 100, dither: true, ..options(Scale::Resolution(100)) };
        pool.install(|| voxelize(&mesh, &options, &Limits::default()).unwrap())
    };
    assert!(scene(1) == scene(3));
}

#[test]
fn the_estimate_is_near() {
    for (mesh, slack) in [(sphere(Vec3::splat(50.2), 49.0, 100), 0.1), (textured_cube().0, 0.1)] {
        for rule in [SurfaceRule::Conservative, SurfaceRule::Thin] {
            let options = VoxelizeOptions { rule, ..options(Scale::Resolution(300)) };
            let estimated = estimate(&mesh, &options).unwrap().voxels as f64;
            let counted = voxelize(&mesh, &options, &Limits::default()).unwrap().grids[0].count() as f64;
            assert!((estimated / counted - 1.0).abs() < slack, "{rule:?}: {estimated} {counted}");
        }
    }
}

#[test]
fn faults_of_meshes_and_limits_are_errors() {
    let ball = sphere(Vec3::splat(5.0), 4.0, 8);
    let few = Limits { voxels: 100, ..Limits::default() };
    assert!(matches!(voxelize(&ball, &options(Scale::Resolution(50)), &few), Err(VoxelizeError::TooLarge { .. })));
    let fails = |mesh: &Mesh, scale| voxelize(mesh, &options(scale), &Limits::default()).unwrap_err();
    assert!(matches!(fails(&Mesh::new("empty"), Scale::Resolution(9)), VoxelizeError::Empty));
    let line = Mesh { positions: vec![Vec3::ZERO, Vec3::ONE, Vec3::splat(2.0)], ..Mesh::new("line") };
    assert!(matches!(fails(&line, Scale::Resolution(9)), VoxelizeError::Empty));
    let broken = Mesh { triangles: vec![[0, 1, 3]], ..line };
    assert!(matches!(fails(&broken, Scale::Resolution(9)), VoxelizeError::BadMesh(_)));
    let cancelled = VoxelizeProgress::default();
    cancelled.cancel();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.vxt");
    let result = voxelize_to_file(ball, &options(Scale::Resolution(50)), &Limits::default(), &path, &cancelled);
    assert!(matches!(result, Err(VoxelizeError::Cancelled)));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}
