//! Scenes that voxtrace has written, read by other programs' libraries: meshes by trimesh, a schematic by nbtlib. Needs a Python with them,
//! else it is skipped.

use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use voxtrace::export::writer_of;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::ray::FACES;
use voxtrace::{Axis, Material, Scene, Transform, VoxelGrid};
use voxtrace_test_support::{Need, skip_without};

/// sRGB colours that are those of blocks, so that a schematic has them, too.
const COLORS: [([u8; 3], &str); 3] = [
    ([0x7d, 0x7d, 0x7d], "minecraft:stone"),
    ([0xa1, 0x27, 0x22], "minecraft:red_wool"),
    ([0xa2, 0x83, 0x4f], "minecraft:oak_planks"),
];

/// A flight of steps in three colours, and the same again, turned on its side.
fn scene() -> Scene {
    let mut grid = VoxelGrid::new();
    for i in 0..12 * 9 * 7 {
        let voxel = IVec3::new(i % 12, i / 12 % 9, i / 108);
        if voxel.z <= voxel.x / 2 {
            grid.set(voxel, (voxel.x / 5) as u16);
        }
    }
    let materials = COLORS.iter().map(|(color, _)| Material::from_srgb(*color)).collect();
    let mut scene = Scene::from_grid("steps", grid.clone(), materials);
    let turned = Transform::from_quarter_turns(Axis::X, 1).translated(Vec3::new(-20.0, 3.0, 8.0));
    scene.add_instance(grid, turned);
    scene
}

/// The voxels in the world with their materials.
fn voxels(scene: &Scene) -> BTreeMap<[i32; 3], u16> {
    let placed = scene.instances.iter().flat_map(|instance| {
        let place = move |voxel: IVec3| instance.world_from_grid.point(voxel.as_vec3() + 0.5).floor().as_ivec3();
        scene.grids[instance.grid].voxels().map(move |(voxel, material)| (place(voxel).to_array(), material))
    });
    placed.collect()
}

/// What the script says of the files in a folder; `None` where no Python can run it.
fn read_by_others(folder: &Path) -> Option<Value> {
    let python = std::env::var_os("VOXTRACE_PYTHON").unwrap_or_else(|| "python3".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("python/read_written.py");
    let output = Command::new(python).arg(script).arg(folder).output();
    let failure = match output {
        Ok(output) if output.status.success() => return Some(serde_json::from_slice(&output.stdout).unwrap()),
        Ok(output) => String::from_utf8_lossy(&output.stderr).into_owned(),
        Err(error) => error.to_string(),
    };
    let is_missing = failure.contains("ModuleNotFoundError") || failure.contains("No such file");
    assert!(is_missing, "other programs cannot read what was written: {failure}");
    skip_without(Need::Python, &format!("no Python with trimesh and nbtlib ({})", failure.lines().last().unwrap()));
    None
}

fn vector(value: &Value) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|axis| value[axis].as_f64().unwrap()))
}

#[test]
fn trimesh_finds_extent_volume_area_and_colours_and_nbtlib_every_block() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene();
    for name in ["scene.glb", "scene.obj", "scene.ply", "scene.schem"] {
        let path = folder.path().join(name);
        let lost = writer_of(&path).unwrap().write(&path, &scene).unwrap();
        assert_eq!(lost, [] as [String; 0], "{name}");
    }
    let Some(found) = read_by_others(folder.path()) else { return };
    let voxels = voxels(&scene);
    let (mut area, mut by_color) = (0.0, [0.0; 3]);
    for (at, &material) in &voxels {
        let is_seen = |normal: &IVec3| !voxels.contains_key(&(IVec3::from_array(*at) + *normal).to_array());
        let faces = FACES.iter().map(|face| face.normal()).filter(is_seen).count() as f64;
        area += faces;
        by_color[usize::from(material)] += faces;
    }
    let low = voxels.keys().fold(IVec3::MAX, |low, &at| low.min(at.into())).as_dvec3();
    let high = voxels.keys().fold(IVec3::MIN, |high, &at| high.max(at.into())).as_dvec3() + 1.0;
    for (name, is_linear, is_y_up) in
        [("scene.glb", true, true), ("scene.obj", false, true), ("scene.ply", false, false)]
    {
        let said = &found[name];
        let turn = |p: DVec3| if is_y_up { DVec3::new(p.x, p.z, -p.y) } else { p };
        assert_eq!(vector(&said["low"]), turn(low).min(turn(high)), "{name}");
        assert_eq!(vector(&said["high"]), turn(low).max(turn(high)), "{name}");
        // A face that looks inwards would take from the volume.
        assert!((said["volume"].as_f64().unwrap() - voxels.len() as f64).abs() < 1e-6, "{name}: {}", said["volume"]);
        assert!((said["area"].as_f64().unwrap() - area).abs() < 1e-6, "{name}: {} {area}", said["area"]);
        let colors = by_color.iter().zip(&scene.materials).zip(COLORS);
        let sum: DVec3 = colors
            .map(|((faces, material), (srgb, _))| {
                let shown = DVec3::from_array(srgb.map(f64::from));
                *faces * if is_linear { material.base_color.as_dvec3() * 255.0 } else { shown }
            })
            .sum();
        // trimesh rounds colours to bytes.
        let error = (vector(&said["color"]) - sum).abs().max_element();
        assert!(error < 0.6 * area, "{name}: {} {sum}", said["color"]);
        assert!(sum.max_element() > 20.0 * area, "{sum}");
    }
    let build = &found["scene.schem"];
    let wanted: BTreeMap<String, &str> = (voxels.iter())
        .map(|(&[x, y, z], &material)| {
            let [x, y, z] = [x - low.x as i32, z - low.z as i32, high.y as i32 - 1 - y];
            (format!("{x} {y} {z}"), COLORS[usize::from(material)].1)
        })
        .collect();
    let blocks = build["blocks"].as_object().unwrap();
    let blocks: BTreeMap<String, &str> = blocks.iter().map(|(at, name)| (at.clone(), name.as_str().unwrap())).collect();
    assert_eq!((build["version"].as_i64(), blocks), (Some(2), wanted));
}
