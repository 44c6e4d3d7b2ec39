//! Levels of detail of native files: each is what a plain second implementation makes of the one below it, voxel by voxel.

use std::collections::HashMap;
use std::path::Path;
use voxtrace::glam::{DVec3, IVec3, Mat3, Vec3};
use voxtrace::packed::{LevelCount, Levels, add_levels};
use voxtrace::{Camera, Material, PackedScene, Ray, Scene, Transform, VoxelGrid};
use voxtrace_core::walk;
use voxtrace_tests::random::Random;

/// A voxel as it is compared: its material, and how full it is.
#[derive(Clone, Copy, Debug)]
struct Voxel {
    material: Material,
    coverage: u32,
}

type Voxels = HashMap<IVec3, Voxel>;

/// Opaque materials, glass, lamps, a fog and a flame.
fn materials() -> Vec<Material> {
    let mut materials: Vec<Material> =
        (0..12).map(|i| Material::diffuse(Vec3::new(0.07 * i as f32, 0.9 - 0.05 * i as f32, 0.3))).collect();
    materials.extend([
        Material::metal(Vec3::new(0.9, 0.6, 0.3), 0.2),
        Material::glass(1.5, 0.0),
        Material::glass(1.3, 0.0).tinted(Vec3::new(0.5, 0.7, 0.9), 3.0),
        Material::emissive(Vec3::new(30.0, 20.0, 10.0)),
        Material::diffuse(Vec3::new(0.5, 0.2, 0.1)).glowing(3.0),
        Material::cloud(Vec3::splat(0.8), 0.3, 0.2),
        Material::flame(Vec3::new(5.0, 2.0, 1.0), 0.4),
    ]);
    materials
}

/// Walls, panes with bars, lamps, and dust of all materials.
fn scene() -> Scene {
    let mut random = Random(5);
    let mut grid = VoxelGrid::new();
    for a in -41..37 {
        for b in -30..33 {
            grid.set(IVec3::new(a, b, -17), random.below(12) as u16);
            grid.set(IVec3::new(a, 5, b), if a % 7 == 0 { 12 } else { 13 + (a & 1) as u16 });
            if a % 5 == 0 && b % 3 == 0 {
                grid.set(IVec3::new(a, b, 35), 15 + (a & 1) as u16);
            }
        }
    }
    for _ in 0..6000 {
        let at = IVec3::new(random.below(60) as i32 - 20, random.below(50) as i32 - 60, random.below(40) as i32 - 20);
        grid.set(at, random.below(19) as u16);
    }
    let mut other = VoxelGrid::new();
    (0..400).for_each(|i| _ = other.set(IVec3::new(i % 20 + 3, i / 20 + 101, i % 3), (i % 19) as u16));
    let mut scene = Scene::from_grid("levels", grid, materials());
    let linear = Mat3::from_axis_angle(Vec3::new(0.3, 0.5, 0.8).normalize(), 0.7) * 0.3;
    scene.add_instance(other, Transform { linear, translation: Vec3::new(90.0, 5.0, 7.0) });
    scene.cameras = vec![Camera::look_at(Vec3::new(90.0, -80.0, 40.0), Vec3::ZERO)];
    scene
}

/// The voxels of each grid of a packed scene.
fn voxels_of(packed: &PackedScene) -> Vec<Voxels> {
    let scene = packed.to_scene();
    let of_grid = |(index, grid): (usize, &std::sync::Arc<VoxelGrid>)| {
        let place = &packed.grids()[index];
        let voxels = grid.sorted_bricks().into_iter().flat_map(|(at, brick)| {
            brick.voxels().map(move |(local, material)| (at * 8 + local, material)).collect::<Vec<_>>()
        });
        let voxel = |(at, material): (IVec3, u16)| {
            let coverage = packed.geometry().coverage_at(place, at).expect("it is there");
            (at, Voxel { material: scene.materials[usize::from(material)], coverage: (coverage * 16.0) as u32 })
        };
        voxels.map(voxel).collect()
    };
    scene.grids.iter().enumerate().map(of_grid).collect()
}

const SIDES: [IVec3; 6] = [IVec3::X, IVec3::NEG_X, IVec3::Y, IVec3::NEG_Y, IVec3::Z, IVec3::NEG_Z];

fn blocks_light(material: &Material) -> bool {
    material.transmission <= 0.0 || material.metallic >= 1.0
}

fn children(voxels: &Voxels, at: IVec3) -> Vec<(IVec3, Voxel)> {
    let corners = (0..8).map(|i| at * 2 + IVec3::new(i & 1, i >> 1 & 1, i >> 2));
    corners.filter_map(|corner| Some((corner, *voxels.get(&corner)?))).collect()
}

fn free_faces(voxels: &Voxels, at: IVec3) -> u32 {
    SIDES.iter().filter(|&&side| voxels.get(&(at + side)).is_none_or(|voxel| !blocks_light(&voxel.material))).count()
        as u32
}

fn surface_emission(material: &Material) -> Vec3 {
    if material.is_without_surface() { Vec3::ZERO } else { material.emission }
}

/// Whether a block lets no light through, by lines across it.
fn is_opaque(children: &[(IVec3, Voxel)]) -> bool {
    let opaque: Vec<&(IVec3, Voxel)> = children.iter().filter(|(_, voxel)| blocks_light(&voxel.material)).collect();
    let shuts = (0..3).any(|axis| {
        let mut lines: Vec<[i32; 2]> =
            (opaque.iter()).map(|(at, _)| [at[(axis + 1) % 3], at[(axis + 2) % 3]]).collect();
        lines.sort_unstable();
        lines.dedup();
        lines.len() == 4
    });
    shuts
        || opaque.len() * 2 >= children.len()
        || opaque.iter().any(|(_, voxel)| surface_emission(&voxel.material) != Vec3::ZERO)
}

/// A material without what is mixed.
fn kind_of(material: &Material) -> Material {
    let emission = if material.is_without_surface() { material.emission } else { Vec3::ZERO };
    Material { base_color: Vec3::ZERO, emission, ..*material }
}

/// Whether `found` is the level above `below`, but for the rounding of colours and emission.
fn compare(below: &Voxels, found: &Voxels) -> Result<(), String> {
    let mut places: Vec<IVec3> = below.keys().map(|at| IVec3::new(at.x >> 1, at.y >> 1, at.z >> 1)).collect();
    places.sort_unstable_by_key(|at| at.to_array());
    places.dedup();
    if places.len() != found.len() {
        return Err(format!("{} voxels instead of {}", found.len(), places.len()));
    }
    for at in places {
        let voxel = found.get(&at).ok_or_else(|| format!("nothing at {at}"))?;
        compare_voxel(below, at, voxel).map_err(|fault| format!("{at}: {fault}, {voxel:?}"))?;
    }
    Ok(())
}

fn compare_voxel(below: &Voxels, at: IVec3, found: &Voxel) -> Result<(), String> {
    let children = children(below, at);
    let is_opaque_block = is_opaque(&children);
    if blocks_light(&found.material) != is_opaque_block {
        return Err(format!("opaque: {is_opaque_block}"));
    }
    let sum: u32 = children.iter().map(|(_, voxel)| voxel.coverage).sum();
    let coverage = ((f64::from(sum) / 8.0 + 0.5).floor() as u32).max(1);
    if found.coverage != coverage {
        return Err(format!("coverage {coverage}"));
    }
    let mut counted: Vec<(Material, f64)> = (children.iter())
        .filter(|(_, voxel)| blocks_light(&voxel.material) == is_opaque_block)
        .map(|(at, voxel)| (voxel.material, f64::from(free_faces(below, *at))))
        .collect();
    if counted.iter().all(|(_, weight)| *weight == 0.0) {
        counted.iter_mut().for_each(|(_, weight)| *weight = 1.0);
    }
    // The kind with most weight; where several have as much, any of them.
    let weight_of = |kind: &Material| -> f64 {
        counted.iter().filter(|(material, _)| kind_of(material) == *kind).map(|(_, weight)| weight).sum()
    };
    let most = counted.iter().map(|(material, _)| weight_of(&kind_of(material))).fold(0.0, f64::max);
    let is_expected =
        counted.iter().map(|(material, _)| kind_of(material)).filter(|kind| weight_of(kind) == most).any(|kind| {
            let share = counted.iter().filter(|(material, _)| kind_of(material) == kind).count() as f32;
            let has_medium = kind.scattering > 0.0 || kind.absorption != Vec3::ZERO || kind.emission != Vec3::ZERO;
            let thicker = if has_medium { share / 4.0 } else { 1.0 };
            let expected = Material {
                emission: kind.emission * thicker,
                absorption: kind.absorption * thicker,
                scattering: kind.scattering * thicker,
                ..kind
            };
            kind_of(&found.material) == expected
        });
    if !is_expected {
        return Err("another kind of material".into());
    }
    let total: f64 = counted.iter().map(|(_, weight)| weight).sum();
    let color =
        counted.iter().map(|(material, weight)| material.base_color.as_dvec3() * *weight).sum::<DVec3>() / total;
    for axis in 0..3 {
        let error = (f64::from(found.material.base_color[axis]).sqrt() - color[axis].sqrt()).abs();
        if error > 0.5 / 127.0 + 1e-4 {
            return Err(format!("colour {color}"));
        }
    }
    let around = SIDES.iter().filter(|&&side| {
        let beside = self::children(below, at + side);
        beside.is_empty() || !is_opaque(&beside)
    });
    let area = 4.0 * around.count() as f64;
    let power: DVec3 = (children.iter())
        .map(|(at, voxel)| surface_emission(&voxel.material).as_dvec3() * f64::from(free_faces(below, *at)))
        .sum();
    let emission = if area > 0.0 { power / area } else { DVec3::ZERO };
    let has_surface = !found.material.is_without_surface();
    let of_surface = surface_emission(&found.material).as_dvec3();
    if has_surface && !(of_surface - emission).abs().cmple(emission * 0.016 + 1e-9).all() {
        return Err(format!("emission {emission}"));
    }
    Ok(())
}

fn saved(scene: &PackedScene, path: &Path, count: LevelCount) -> Levels {
    scene.save_with_levels(path, count, &mut |_| true).unwrap();
    Levels::open(path).unwrap()
}

#[test]
fn each_level_is_what_a_plain_second_implementation_makes_of_the_one_below() {
    let folder = tempfile::tempdir().unwrap();
    let packed = PackedScene::pack(&scene()).unwrap();
    let levels = saved(&packed, &folder.path().join("scene.vxt"), LevelCount::All);
    assert!(levels.count() >= 4, "{}", levels.count());
    let mut below = voxels_of(&packed);
    for level in 1..=levels.count() {
        let above = levels.scene(level).unwrap();
        above.validate().unwrap();
        let found = voxels_of(&above);
        assert_eq!(found.len(), 2);
        for (below, found) in below.iter().zip(&found) {
            compare(below, found).unwrap_or_else(|fault| panic!("level {level}: {fault}"));
        }
        assert_eq!(levels.summary(level).unwrap().voxels, found.iter().map(|grid| grid.len() as u64).sum::<u64>());
        assert_eq!((&above.cameras, &above.sky, &above.name), (&packed.cameras, &packed.sky, &packed.name));
        let (low, high) = packed.bounds().unwrap();
        let (from, to) = above.bounds().unwrap();
        let edge = Vec3::splat((1 << level) as f32);
        assert!(from.cmple(low + 1e-3).all() && to.cmpge(high - 1e-3).all(), "level {level}");
        assert!((low - from).cmple(edge * 1.8).all() && (to - high).cmple(edge * 1.8).all(), "level {level}");
        below = found;
    }
    assert!(below.iter().all(|grid| grid.len() <= 512));

    // Faults are seen.
    let (below, found) = (voxels_of(&packed).remove(0), voxels_of(&levels.scene(1).unwrap()).remove(0));
    let with = |at: IVec3, change: &dyn Fn(&mut Voxel)| {
        let mut changed = found.clone();
        changed.get_mut(&at).map(change).expect("it is there");
        compare(&below, &changed)
    };
    let floor = IVec3::new(3, 2, -9);
    with(floor, &|_| ()).unwrap();
    assert!(with(floor, &|voxel| voxel.material.base_color += 0.02).is_err());
    assert!(with(floor, &|voxel| voxel.coverage += 1).is_err());
    assert!(with(floor, &|voxel| voxel.material.roughness = 0.5).is_err());
    assert!(with(IVec3::new(0, 0, 17), &|voxel| voxel.material.emission *= 1.05).is_err());
    let mut less = found.clone();
    less.remove(&floor);
    assert!(compare(&below, &less).is_err());
}

#[test]
fn levels_are_the_same_bytes_whatever_the_threads_and_however_they_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let packed = PackedScene::pack(&scene()).unwrap();
    let written = |name: &str, threads: usize| {
        let path = folder.path().join(name);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| saved(&packed, &path, LevelCount::Some(3)));
        path
    };
    let one = written("one.vxt", 1);
    let bytes = std::fs::read(&one).unwrap();
    assert!(bytes == std::fs::read(written("three.vxt", 3)).unwrap());
    // Added later, and in the place of others.
    let later = folder.path().join("later.vxt");
    packed.save(&later).unwrap();
    assert!(bytes != std::fs::read(&later).unwrap());
    for count in [LevelCount::Some(1), LevelCount::Some(3)] {
        add_levels(&later, count, &mut |_| true).unwrap();
    }
    assert!(bytes == std::fs::read(&later).unwrap());
    // Who does not ask for levels sees the scene.
    let opened = PackedScene::open(&one).unwrap();
    assert_eq!(opened.content_hash(), packed.content_hash());
    assert_eq!(Levels::open(&one).unwrap().scene(0).unwrap().content_hash(), packed.content_hash());
    // A level that is saved as a scene is the level.
    let (level, alone) = (Levels::read(&one).unwrap().scene(2).unwrap(), folder.path().join("alone.vxt"));
    level.save(&alone).unwrap();
    assert_eq!(PackedScene::open(&alone).unwrap().content_hash(), level.content_hash());
    assert_eq!(voxels_of(&PackedScene::open(&alone).unwrap())[0].len(), voxels_of(&level)[0].len());
    // What is stopped changes nothing and leaves nothing.
    let before = std::fs::read_dir(folder.path()).unwrap().count();
    assert!(packed.save_with_levels(&one, LevelCount::All, &mut |progress| progress.level < 2).is_err());
    // Within a level, too.
    let mut is_first = true;
    assert!(packed.save_with_levels(&one, LevelCount::All, &mut |_| std::mem::take(&mut is_first)).is_err());
    assert!(bytes == std::fs::read(&one).unwrap());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), before);
}

#[test]
fn damage_in_a_level_is_an_error_of_that_level() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    let levels = saved(&PackedScene::pack(&scene()).unwrap(), &path, LevelCount::Some(2));
    assert!(levels.scene(3).is_err() && levels.scene(u32::MAX).is_err());
    let bytes = std::fs::read(&path).unwrap();
    let sizes = [1, 2].map(|level| levels.summary(level).unwrap().bytes as usize);
    // Levels come last, the second one behind the first.
    let starts = [bytes.len() - sizes[1] - (sizes[0].next_multiple_of(64)), bytes.len() - sizes[1]];
    for (level, (start, size)) in (1..).zip(starts.into_iter().zip(sizes)) {
        for at in (0..64).step_by(7).chain((64..size).step_by(size / 40)) {
            let mut damaged = bytes.clone();
            damaged[start + at] ^= 0x41;
            PackedScene::from_bytes(&damaged).unwrap();
            let levels = Levels::from_bytes(&damaged).unwrap();
            assert!(levels.scene(level).is_err(), "byte {at} of level {level}");
            assert!(levels.scene(3 - level).is_ok());
        }
    }
    for length in (0..bytes.len()).step_by(bytes.len() / 50) {
        assert!(Levels::from_bytes(&bytes[..length]).is_err(), "{length} bytes");
    }
}

#[test]
fn thin_walls_stay_shut_and_lamps_keep_their_power() {
    let mut grid = VoxelGrid::new();
    // A shell as thin as it can be, with panes around it, and a field of lamps far from each other.
    const RADIUS: f32 = 37.3;
    for i in 0..90 * 90 * 90 {
        let at = IVec3::new(i % 90, i / 90 % 90, i / 8100) - 45;
        let is_inside = |at: IVec3| (at.as_vec3() + 0.5).length() < RADIUS;
        if is_inside(at) && SIDES.iter().any(|&side| !is_inside(at + side)) {
            grid.set(at, 0);
        } else if !is_inside(at) && (at.as_vec3() + 0.5).length() < RADIUS + 1.5 {
            grid.set(at, 1);
        }
    }
    let lamps = [IVec3::new(200, 0, 0), IVec3::new(301, 7, -3), IVec3::new(250, 49, 18)];
    lamps.iter().for_each(|&at| _ = grid.set(at, 2));
    (0..32 * 32).for_each(|i| _ = grid.set(IVec3::new(400 + i % 32, i / 32, 0), 2));
    let lamp = Material::emissive(Vec3::new(8.0, 9.0, 10.0));
    let scene = Scene::from_grid("shell", grid, vec![Material::default(), Material::glass(1.5, 0.0), lamp]);
    let packed = PackedScene::pack(&scene).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let levels = saved(&packed, &folder.path().join("shell.vxt"), LevelCount::Some(4));
    let power = |scene: &PackedScene, level: u32| {
        let emitters = scene.geometry().emitters().iter();
        emitters.map(|e| f64::from(e.luminance) * f64::from(e.faces.count_ones())).sum::<f64>()
            * 4f64.powi(level as i32)
    };
    let mut random = Random(3);
    let directions: Vec<Vec3> = (0..4000)
        .map(|_| {
            Vec3::from_array([0; 3].map(|_| random.below(2001) as f32 - 1000.0)).try_normalize().unwrap_or(Vec3::X)
        })
        .collect();
    for level in 0..=4 {
        let scene = levels.scene(level).unwrap();
        for &direction in &directions {
            let mut ray = Ray::new(Vec3::new(0.3, 0.2, 0.1), direction);
            // Glass is passed.
            let hit = loop {
                let hit = walk::cast(&scene, &ray);
                assert!(!hit.is_miss(), "level {level}, {direction}");
                if blocks_light(&scene.to_material(&hit)) {
                    break hit;
                }
                ray.origin += direction * (hit.t + 0.01);
            };
            let distance = (ray.origin + direction * hit.t).length();
            assert!((distance - RADIUS).abs() < 3.0 + 2.0 * (1 << level) as f32, "level {level}: {distance}");
        }
        let (found, expected) = (power(&scene, level), power(&packed, 0));
        assert!((found / expected - 1.0).abs() < 0.02, "level {level}: power {found} instead of {expected}");
    }
}

/// The material at a hit, as one edits it.
trait ToMaterial {
    fn to_material(&self, hit: &voxtrace::Hit) -> Material;
}

impl ToMaterial for PackedScene {
    fn to_material(&self, hit: &voxtrace::Hit) -> Material {
        let packed = self.material(hit);
        Material { transmission: packed.transmission, metallic: packed.metallic, ..Material::default() }
    }
}
