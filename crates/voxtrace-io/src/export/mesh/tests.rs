use super::*;
use glam::{Quat, Vec3};
use voxtrace_scene::grid::{VoxelBox, VoxelGrid};
use voxtrace_scene::{Material, Transform};

#[test]
fn a_mirrored_instance_turns_its_faces_outwards_too() {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(1, 2, 3), max: IVec3::new(4, 7, 5) }, 0);
    for mirror in [1.0, -1.0] {
        let mut scene = Scene::from_grid("box", grid.clone(), vec![Material::default()]);
        let turned = Transform::from_rotation(Quat::from_rotation_x(0.4)).translated(Vec3::new(9.0, -3.0, 0.5));
        let mut placed = turned.scaled(2.0);
        placed.linear.x_axis *= mirror;
        scene.instances[0].world_from_grid = placed;
        let surfaces = Surfaces::of(&scene, &|| true).unwrap();
        let (instance, rectangles) = surfaces.instances().next().unwrap();
        assert_eq!(rectangles.len(), 6);
        let middle = placed.point(Vec3::new(2.5, 4.5, 4.0)).as_dvec3();
        for rectangle in rectangles {
            let [a, b, c, d] = Surfaces::corners(instance, rectangle).map(|corner| Surfaces::place(instance, corner));
            let (normal, centre) = ((b - a).cross(c - a), (a + b + c + d) / 4.0);
            assert!(normal.dot(centre - middle) > 0.0);
            // Seen the other way round it would look inwards.
            assert!((c - a).cross(b - a).dot(centre - middle) < 0.0);
        }
    }
}

#[test]
fn hidden_instances_have_no_surface_and_are_said_to_be_left_out() {
    let mut grid = VoxelGrid::new();
    grid.set(IVec3::ZERO, 0);
    let mut scene = Scene::from_grid("two", grid.clone(), vec![Material::default()]);
    scene.add_instance(grid, Transform::from_translation(Vec3::X));
    assert_eq!((Surfaces::of(&scene, &|| true).unwrap().instances().count(), left_out(&scene)), (2, Vec::new()));
    scene.instances[1].hidden = true;
    assert_eq!(Surfaces::of(&scene, &|| true).unwrap().instances().count(), 1);
    assert_eq!(left_out(&scene), ["hidden instances (1)"]);
}

#[test]
fn what_is_written_many_at_a_time_keeps_its_order() {
    let numbers: Vec<u32> = (0..40_000).collect();
    let mut written = Vec::new();
    write_each(&mut written, &numbers, |bytes, number| bytes.write_all(&number.to_le_bytes())).unwrap();
    assert!(written.as_chunks().0.iter().map(|&bytes| u32::from_le_bytes(bytes)).eq(numbers));
}

#[test]
fn a_glb_of_thousands_of_instances_is_whole() {
    let mut grid = VoxelGrid::new();
    grid.set(IVec3::ZERO, 0);
    let mut scene = Scene::from_grid("många", grid.clone(), vec![Material::default()]);
    for place in 1..3000 {
        scene.add_instance(grid.clone(), Transform::from_translation(Vec3::X * 2.0 * place as f32));
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("many.glb");
    write_glb(&path, &scene, &|| true).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let json_size = word(12);
    assert_eq!((word(8), json_size % 4), (bytes.len(), 0));
    assert!(json_size > 1 << 16, "{json_size}");
    let document: serde_json::Value = serde_json::from_slice(&bytes[20..20 + json_size]).unwrap();
    assert_eq!(document["nodes"].as_array().unwrap().len(), 3001);
    assert_eq!(document["buffers"][0]["byteLength"], word(20 + json_size));
    assert_eq!(bytes.len(), 28 + json_size + word(20 + json_size));
}
