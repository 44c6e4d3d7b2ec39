//! `convert` and `voxelize` to files of other programs: meshes, Qubicle, Minecraft, heightmaps.

use crate::common::{Folder, room};
use voxtrace::Transform;
use voxtrace::glam::{Quat, Vec3};
use voxtrace::import::{self, ImportOptions};

/// A room whose block is an instance of its own, turned by 35 degrees.
fn turned(folder: &Folder) {
    let mut scene = room();
    scene.instances[0].name = "floor".into();
    let block = room();
    let instance = scene.add_instance(
        voxtrace::VoxelGrid::clone(&block.grids[0]),
        Transform::from_rotation(Quat::from_rotation_z(35f32.to_radians())).translated(Vec3::new(60.0, 0.0, 0.0)),
    );
    scene.instances[instance].name = "turned".into();
    voxtrace::PackedScene::pack(&scene).unwrap().save(&folder.path("turned.vxt")).unwrap();
}

fn count(folder: &Folder, name: &str) -> u64 {
    let scene = import::open(&folder.path(name), &ImportOptions::default()).unwrap();
    scene.instances.iter().map(|instance| scene.grids[instance.grid].count()).sum()
}

#[test]
fn a_scene_is_written_in_every_format_that_formats_names_and_read_again() {
    let folder = Folder::new();
    let formats: serde_json::Value = serde_json::from_str(&folder.succeed(&["formats", "--json"])).unwrap();
    let written = formats["formats"].as_array().unwrap().iter().filter(|format| format["write"] == true);
    let names: Vec<&str> = written.map(|format| format["extension"].as_str().unwrap()).collect();
    for extension in ["vox", "vxt", "glb", "obj", "ply", "qb", "schem", "asc", "png"] {
        assert!(names.contains(&extension), "{names:?}");
        let name = format!("out.{extension}");
        let said = folder.succeed(&["convert", "room.vox", &name]);
        let expected = if extension == "obj" { "out.obj\nout.mtl\n".into() } else { format!("{name}\n") };
        assert_eq!(said, expected);
        folder.succeed(&["info", &name]);
        // The same bytes again, and over its own file.
        let before = folder.bytes(&name);
        folder.succeed(&["convert", "room.vox", &name]);
        assert_eq!(folder.bytes(&name), before, "{name}");
    }
    assert_eq!((count(&folder, "out.qb"), count(&folder, "out.schem")), (800, 800));
    folder.succeed(&["voxelize", "out.glb", "-o", "again.vxt", "--voxel-size", "1", "--fill", "--surface", "thin"]);
    assert_eq!(count(&folder, "again.vxt"), 800);
    folder.succeed(&["voxelize", "out.schem", "-o", "again.ply"]);
    assert!(folder.exists("again.ply"));
    let unknown = folder.fail(&["convert", "room.vox", "a.xyz"], 2);
    assert!(unknown.contains(".vxt, .vox, .glb, .obj, .ply, .qb, .schem, .asc, .png"), "{unknown}");
}

#[test]
fn a_turned_instance_is_refused_with_what_helps_and_written_when_it_is_baked_or_straightened() {
    let folder = Folder::new();
    turned(&folder);
    for name in ["a.vox", "a.qb", "a.schem", "a.asc"] {
        let error = folder.fail(&["convert", "turned.vxt", name], 4);
        assert!(error.contains("--bake") && error.contains("--straighten"), "{error}");
        assert!(!folder.exists(name));
        folder.succeed(&["convert", "turned.vxt", name, "--bake"]);
    }
    // The block and the lamp have about as many voxels as before, and straightened exactly as many.
    let (baked, all) = (count(&folder, "a.vox"), 1600);
    assert!(baked.abs_diff(all) < all / 20, "{baked}");
    folder.succeed(&["convert", "turned.vxt", "b.vox", "--straighten"]);
    assert_eq!(count(&folder, "b.vox"), all);
    folder.succeed(&["convert", "turned.vxt", "a.glb"]);
    folder.succeed(&["voxelize", "turned.vxt", "-o", "c.vox", "--bake", "--flatten"]);
    let flat = import::open(&folder.path("c.vox"), &ImportOptions::default()).unwrap();
    assert_eq!((flat.instances.len(), count(&folder, "c.vox")), (1, baked));
    let refused = folder.fail(&["convert", "turned.vxt", "d.vox", "--flatten"], 3);
    assert!(refused.contains("does not stand on the lattice") && refused.contains("--bake"), "{refused}");
}

#[test]
fn an_oblique_scan_is_written_as_vox_when_its_tilt_is_dropped_or_baked() {
    let folder = Folder::new();
    // A bright box in a scan of 40³ samples of 2 mm that is tilted by 20 degrees about x.
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let values: Vec<u8> = (0..64_000)
        .map(|i| [i % 40, i / 40 % 40, i / 1600])
        .map(|at| if at.iter().all(|place| (10..30).contains(place)) { 200 } else { 0 })
        .collect();
    let head = format!(
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 40\nencoding: raw\nspace: left-posterior-superior\n\
         space directions: (2,0,0) (0,{},{}) (0,{},{})\nspace origin: (-100.5,30,12)\n\n",
        2.0 * cos,
        2.0 * sin,
        -2.0 * sin,
        2.0 * cos
    );
    std::fs::write(folder.path("tilted.nrrd"), [head.as_bytes(), &values].concat()).unwrap();
    let scan = ["tilted.nrrd", "--shell=false"];
    let refused = folder.fail(&[&["convert"], &scan[..], &["a.vox"]].concat(), 4);
    assert!(refused.contains("--straighten") && refused.contains("--bake"), "{refused}");
    folder.succeed(&[&["convert"], &scan[..], &["straight.vox", "--straighten"]].concat());
    assert_eq!(count(&folder, "straight.vox"), 8000);
    folder.succeed(&[&["convert"], &scan[..], &["baked.vox", "--bake"]].concat());
    assert!(count(&folder, "baked.vox").abs_diff(8000) < 200, "{}", count(&folder, "baked.vox"));
    // Straightened, the voxels still know where they were in the patient.
    folder.succeed(&[&["convert"], &scan[..], &["straight.vxt", "--straighten"]].concat());
    let georeference = |name: &str| -> Vec<f64> {
        let info: serde_json::Value = serde_json::from_str(&folder.succeed(&["info", name, "--json"])).unwrap();
        assert_eq!((info["unit"].as_str(), info["voxel_size"].as_f64()), (Some("mm"), Some(2.0)));
        let rows = info["georeference"]["coordinates_from_world"].as_array().unwrap().clone();
        rows.iter().flat_map(|row| row.as_array().unwrap().clone()).map(|value| value.as_f64().unwrap()).collect()
    };
    let straight = georeference("straight.vxt");
    assert!((straight[5] - 2.0 * cos).abs() < 1e-6 && (straight[9] - 2.0 * sin).abs() < 1e-6, "{straight:?}");
}

#[test]
fn materials_of_others_beside_an_obj_are_not_written_over() {
    let folder = Folder::new();
    std::fs::write(folder.path("a.mtl"), "newmtl wood\n").unwrap();
    let refused = folder.fail(&["convert", "room.vox", "a.obj"], 4);
    assert!(refused.contains("a.mtl belongs to it") && refused.contains("name another file"), "{refused}");
    assert_eq!((folder.bytes("a.mtl"), folder.exists("a.obj")), (b"newmtl wood\n".to_vec(), false));
    folder.succeed(&["convert", "room.vox", "b.obj"]);
    folder.succeed(&["convert", "room.vox", "b.obj"]);
    // A scene is not written over itself, nor are its own materials.
    assert!(folder.fail(&["convert", "b.obj", "b.obj"], 4).contains("this run reads it"));
    std::fs::copy(folder.path("b.obj"), folder.path("c.obj")).unwrap();
    assert!(folder.fail(&["convert", "c.obj", "b.obj"], 4).contains("this run reads it"));
}

#[cfg(target_os = "linux")]
#[test]
fn an_obj_and_its_materials_stay_together_where_there_is_no_room_for_one_of_them() {
    let folder = Folder::new();
    for (mesh, full, kept) in [("a.obj", "a.obj", "a.mtl"), ("b.obj", "b.mtl", "b.obj")] {
        folder.succeed(&["convert", "room.vox", mesh]);
        let old = [&folder.bytes(kept)[..], b"# of the old mesh\n"].concat();
        std::fs::write(folder.path(kept), &old).unwrap();
        std::fs::remove_file(folder.path(full)).unwrap();
        std::os::unix::fs::symlink("/dev/full", folder.path(full)).unwrap();
        let said = folder.fail(&["convert", "room.vox", mesh], 4);
        assert!(said.contains(&format!("cannot write {full}: no space left on device")), "{said}");
        assert_eq!(folder.bytes(kept), old);
    }
    // Nothing is left behind.
    let mut names = std::fs::read_dir(folder.path("")).unwrap().map(|entry| entry.unwrap().file_name());
    assert!(names.all(|name| !name.to_string_lossy().ends_with(".tmp")));
}
