//! Random edits against the same edits of an editable grid, which is packed from scratch.

pub(super) mod plain;

use super::history::Entry;
use super::store::BrickCode;
use super::{DynamicScene, Edit, EditError};
use crate::frame::{Frame, Integrator};
use crate::packed::lights_tests::with_halved_trees;
use crate::packed::{CELL_OCCUPIED, PackedScene};
use crate::tracer::{Progress, TraceError, Tracer};
use crate::{CpuTracer, Film};
use glam::{DVec3, IVec3, Vec3};
use plain::{Random, edit_plainly, random_edit};
use std::sync::Arc;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelBox};
use voxtrace_scene::{Camera, Hit, Material, Ray, Scene, Shape, Transform, VoxelGrid};

fn materials() -> Vec<Material> {
    let lamp = |r: f32| Material::emissive(Vec3::new(r, 1.0, 0.5));
    vec![Material::diffuse(Vec3::splat(0.7)), lamp(3.0), Material::glass(1.5, 0.1), lamp(0.5), Material::default()]
}

/// A floor, a box and some lamps, twice, the second one turned.
fn example() -> Scene {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-40, -40, -3), max: IVec3::new(40, 40, 0) }, 0);
    grid.fill_box(VoxelBox { min: IVec3::new(-9, 3, 0), max: IVec3::new(8, 17, 22) }, 4);
    for lamp in 0..40 {
        grid.set(IVec3::new(lamp * 7 % 60 - 30, lamp * 13 % 50 - 25, 20 + lamp % 3), 1);
    }
    let mut scene = Scene { materials: materials(), ..Scene::from_grid("edited", grid, Vec::new()) };
    let mut small = VoxelGrid::new();
    small.set(IVec3::new(3, 4, 5), 3);
    let linear = glam::Mat3::from_rotation_x(0.3) * 2.0;
    scene.add_instance(small, Transform { linear, translation: Vec3::new(3.0, 70.0, 20.0) });
    scene
}

/// Rays from around the middle, in all directions.
fn rays(random: &mut Random, count: usize, reach: i32) -> Vec<Ray> {
    let ray = |_| {
        let origin = random.point(reach).as_vec3();
        let mut direction = random.point(reach).as_vec3() + 0.01;
        if random.below(4) == 0 {
            direction[random.below(3) as usize] = 0.0;
        }
        Ray::new(origin, direction)
    };
    (0..count).map(ray).collect()
}

/// Hits by what does not depend on the order of instances in memory.
fn hits(tracer: &mut dyn Tracer, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(rays, &mut hits).unwrap();
    hits
}

fn film(tracer: &mut dyn Tracer) -> Film {
    let camera = Camera::look_at(Vec3::new(60.0, -50.0, 45.0), Vec3::ZERO);
    let frame = Frame { integrator: Integrator::Path, samples: 2, ..Frame::new(camera, 48, 32) };
    tracer.render(&frame, &Progress::default()).unwrap();
    let mut film = Film::new(48, 32, frame.region, 0);
    tracer.read(&mut film).unwrap();
    film
}

fn saved(scene: &PackedScene) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    scene.save(&path).unwrap();
    std::fs::read(path).unwrap()
}

/// A scene that is edited, the same one as it is edited plainly, and a tracer that follows.
struct Pair {
    dynamic: DynamicScene,
    plain: Scene,
    /// Grids after each edit, and those of the edits that were undone.
    done: Vec<Arc<VoxelGrid>>,
    undone: Vec<Arc<VoxelGrid>>,
    tracer: CpuTracer,
}

impl Pair {
    fn new() -> Self {
        let plain = example();
        let packed = PackedScene::pack(&plain).unwrap();
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&Arc::new(packed.clone())).unwrap();
        let dynamic = DynamicScene::new(packed).unwrap();
        Self { dynamic, plain, done: Vec::new(), undone: Vec::new(), tracer }
    }

    fn step(&mut self, random: &mut Random, reach: i32) {
        match random.below(12) {
            0 => {
                let undone = self.dynamic.undo().unwrap().is_some();
                assert_eq!(undone, !self.done.is_empty());
                if let Some(before) = self.done.pop() {
                    self.undone.push(std::mem::replace(&mut self.plain.grids[0], before));
                }
            }
            1 => {
                let redone = self.dynamic.redo().unwrap().is_some();
                assert_eq!(redone, !self.undone.is_empty());
                if let Some(after) = self.undone.pop() {
                    self.done.push(std::mem::replace(&mut self.plain.grids[0], after));
                }
            }
            2 => _ = self.dynamic.repair(random.below(4) as usize),
            3 if random.below(12) == 0 && self.plain.materials.len() < 16 => {
                let emission = Vec3::splat(random.below(2) as f32 * 2.0);
                let material = Material { emission, ..Material::diffuse(Vec3::splat(0.3)) };
                let material = if random.below(4) == 0 { Material::glass(1.3, 0.0) } else { material };
                assert_eq!(usize::from(self.dynamic.add_material(&material).unwrap()), self.plain.materials.len());
                self.plain.materials.push(material);
            }
            _ => {
                let far = if random.below(40) == 0 { 20 * reach } else { reach };
                let edit = random_edit(random, far, self.plain.materials.len() as u32);
                let before = Arc::clone(&self.plain.grids[0]);
                edit_plainly(Arc::make_mut(&mut self.plain.grids[0]), &edit);
                let count = before.count() as i64;
                let edited = self.dynamic.edit(0, &edit).unwrap();
                assert_eq!(edited.voxels, self.plain.grids[0].count() as i64 - count, "{edit:?}");
                assert_eq!(edited.bricks == 0, *before == *self.plain.grids[0]);
                if edited.bricks > 0 {
                    self.undone.clear();
                    self.done.push(before);
                }
            }
        }
    }

    fn compare(&mut self, random: &mut Random) {
        self.dynamic.validate().unwrap();
        self.tracer.patch(&self.dynamic.take_patch()).unwrap();
        let packed = Arc::new(PackedScene::pack(&self.plain).unwrap());
        let mut fresh = CpuTracer::new(None);
        fresh.set_scene(&packed).unwrap();
        let rays = rays(random, 4000, 90);
        let (own, expected) = (hits(&mut self.tracer, &rays), hits(&mut fresh, &rays));
        assert_eq!(own, expected);
        assert!(film(&mut self.tracer) == film(&mut fresh), "films");
        assert!(saved(&self.dynamic.compact()) == saved(&packed), "files");
        let emissive = |scene: &PackedScene| scene.statistics().emissive_voxels;
        assert_eq!(emissive(self.dynamic.scene()), emissive(&packed));
    }
}

#[test]
fn edits_of_all_kinds_leave_the_scene_that_packing_makes() {
    for seed in 0..4 {
        let mut random = Random(seed);
        let mut pair = Pair::new();
        pair.compare(&mut random);
        for round in 0..12 {
            (0..25).for_each(|_| pair.step(&mut random, 60));
            if round % 3 == 2 {
                pair.dynamic.settle();
            }
            pair.compare(&mut random);
        }
    }
}

#[test]
fn ten_thousand_edits_and_a_million_rays() {
    let (mut random, mut pair) = (Random(99), Pair::new());
    for _ in 0..40 {
        (0..250).for_each(|_| pair.step(&mut random, 90));
        pair.compare(&mut random);
    }
    let mut fresh = CpuTracer::new(None);
    fresh.set_scene(&Arc::new(PackedScene::pack(&pair.plain).unwrap())).unwrap();
    let rays = rays(&mut random, 1_000_000, 110);
    assert!(hits(&mut pair.tracer, &rays) == hits(&mut fresh, &rays));
}

#[test]
fn a_tree_over_emitters_of_an_older_file_becomes_that_of_packing() {
    let mut plain = example();
    let packed = with_halved_trees(&PackedScene::pack(&plain).unwrap());
    let mut dynamic = DynamicScene::new(packed).unwrap();
    assert!(dynamic.validate().is_err(), "it is another tree");
    let shape = Shape::Sphere { center: DVec3::new(11.0, 3.0, 21.0), radius: 4.0 };
    let fill = |material| Edit::Fill { shape, material };
    for material in [Some(1), None] {
        dynamic.edit(0, &fill(material)).unwrap();
        dynamic.validate().unwrap();
        edit_plainly(Arc::make_mut(&mut plain.grids[0]), &fill(material));
    }
    assert_eq!(dynamic.scene().content_hash(), PackedScene::pack(&plain).unwrap().content_hash());
}

#[test]
fn planted_faults_are_caught() {
    type Fault = fn(&mut DynamicScene);
    let faults: [(&str, Fault); 7] = [
        ("reaches over something", |scene| {
            // The empty cell above the floor: as if the longest distances had stayed when something came.
            let (position, shift) =
                scene.geometry().cell_of_brick(&scene.scene.grids()[0], IVec3::new(3, 3, 1)).unwrap();
            assert!(scene.geometry().cells[position] & CELL_OCCUPIED == 0 && shift == 3);
            scene.store().set_cell(position, 0xff_ffff);
        }),
        ("not that of its voxels", |scene| {
            let root = scene.geometry().light_root(0).unwrap();
            Arc::make_mut(&mut scene.scene.geometry).light_nodes.as_mut()[root as usize].power[3] += 1.0;
        }),
        ("over emitters is not", |scene| {
            // A lamp that the tree does not have.
            let dark = std::mem::replace(&mut scene.glow, super::emitters::Glow::of(&[scene.scene.materials()[0]; 5]));
            let shape = Shape::Box(VoxelBox { min: IVec3::splat(30), max: IVec3::splat(31) });
            scene.edit(0, &Edit::Fill { shape, material: Some(1) }).unwrap();
            scene.glow = dark;
        }),
        ("were counted", |scene| scene.bricks[0] += 1),
        ("used twice", |scene| scene.pools.bricks.give(0, 2)),
        ("lost", |scene| _ = scene.pools.materials.take(1)),
        ("another geometry", |scene| Arc::make_mut(&mut scene.scene.geometry).fingerprint += 1),
    ];
    for (fault, plant) in faults {
        let mut pair = Pair::new();
        let shape = Shape::Sphere { center: DVec3::new(20.0, 20.0, 9.0), radius: 5.0 };
        pair.dynamic.edit(0, &Edit::Fill { shape, material: None }).unwrap();
        let ball = Shape::Sphere { center: DVec3::new(-20.0, 20.0, 9.0), radius: 5.0 };
        pair.dynamic.edit(0, &Edit::Fill { shape: ball, material: Some(3) }).unwrap();
        pair.dynamic.validate().unwrap();
        plant(&mut pair.dynamic);
        let found = pair.dynamic.validate().expect_err(fault).to_string();
        assert!(found.contains(fault), "{fault}: {found}");
    }
}

#[test]
fn a_stale_brick_and_a_stale_skip_distance_give_other_hits() {
    let at = IVec3::new(0, 0, 50);
    let shape = Shape::Box(VoxelBox { min: at, max: at + 1 });
    let fill = Edit::Fill { shape, material: Some(0) };
    let down = [Ray::new(Vec3::new(0.5, 0.5, 90.0), Vec3::NEG_Z)];
    let mut pair = Pair::new();
    pair.dynamic.edit(0, &fill).unwrap();
    let whole = pair.dynamic.take_patch();
    let hit_of = |patch: &super::Patch| {
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&Arc::new(PackedScene::pack(&pair.plain).unwrap())).unwrap();
        tracer.patch(patch).unwrap();
        hits(&mut tracer, &down)[0].voxel
    };
    assert_eq!(hit_of(&whole), at);
    // The brick was written, the cells around it were not: rays leap over it.
    let record = whole.changed_bricks[0].cell.unwrap();
    let mut stale = whole.clone();
    let own =
        whole.cells.parts().flat_map(|(start, words)| (start..).zip(words)).find(|(_, word)| **word == record).unwrap();
    stale.cells = super::ArrayPatch { length: whole.cells.length, ranges: vec![(own.0, 1)], records: vec![record] };
    assert_ne!(hit_of(&stale), at, "a stale skip distance");
    let emptied = super::ArrayPatch { length: whole.bricks.length, ..Default::default() };
    assert_ne!(hit_of(&super::Patch { bricks: emptied, ..whole }), at, "a stale brick");
}

#[test]
fn edits_reach_the_ends_of_the_coordinates_and_no_farther() {
    let mut pair = Pair::new();
    let corner = |far: IVec3| Edit::Fill { shape: Shape::Box(VoxelBox { min: far, max: far + 1 }), material: Some(3) };
    for far in
        [IVec3::splat(MAX_COORDINATE), IVec3::splat(-MAX_COORDINATE), IVec3::new(MAX_COORDINATE, -3, -MAX_COORDINATE)]
    {
        edit_plainly(Arc::make_mut(&mut pair.plain.grids[0]), &corner(far));
        pair.dynamic.edit(0, &corner(far)).unwrap();
        assert_eq!(pair.dynamic.voxel(0, far), Some(3));
    }
    pair.compare(&mut Random(1));
    let beyond = IVec3::new(MAX_COORDINATE + 1, 0, 0);
    assert_eq!(pair.dynamic.edit(0, &corner(beyond)), Err(EditError::OutOfRange(beyond)));
    let endless = Shape::Sphere { center: DVec3::ZERO, radius: 4e5 };
    let too_large = pair.dynamic.edit(0, &Edit::Fill { shape: endless, material: Some(0) });
    assert!(matches!(too_large, Err(EditError::TooLarge { .. })), "{too_large:?}");
    let nowhere = Shape::Sphere { center: DVec3::NAN, radius: 1.0 };
    assert_eq!(pair.dynamic.edit(0, &Edit::Fill { shape: nowhere, material: None }), Err(EditError::NotFinite));
    assert_eq!(pair.dynamic.edit(2, &corner(beyond)), Err(EditError::NoGrid { grid: 2, count: 2 }));
    let paint = Edit::Paint { shape: endless, material: 9 };
    assert_eq!(pair.dynamic.edit(0, &paint), Err(EditError::NoMaterial { material: 9, count: 5 }));
    // Everything: it ends at the coordinates, and the grid with its instance is gone.
    pair.dynamic
        .edit(0, &Edit::Fill { shape: Shape::Sphere { center: DVec3::ZERO, radius: 1e9 }, material: None })
        .unwrap();
    pair.dynamic.validate().unwrap();
    let left = pair.dynamic.compact();
    assert_eq!((left.grids().len(), left.instances().len()), (1, 1));
    *Arc::make_mut(&mut pair.plain.grids[0]) = VoxelGrid::new();
    assert!(saved(&left) == saved(&PackedScene::pack(&pair.plain).unwrap()));
}

#[test]
fn a_long_stroke_touches_few_bricks_of_its_box() {
    let mut pair = Pair::new();
    for (reach, radius) in [(100, 3.4), (5000, 1.2)] {
        let (from, to) = (DVec3::splat(f64::from(-reach)), DVec3::new(0.9, 0.7, 1.0) * f64::from(reach));
        let shape = Shape::Capsule { from, to, radius };
        let edited = pair.dynamic.edit(0, &Edit::Add { shape, material: 4 }).unwrap();
        // By every voxel near the line, a slice after the other.
        let (mut found, mut added) = (0, 0);
        for z in -reach - 4..reach + 4 {
            let at = from + (to - from) * ((f64::from(z - reach) / f64::from(2 * reach) + 1.0).clamp(0.0, 1.0));
            for (x, y) in (-9..9).flat_map(|y| (-9..9).map(move |x| (x, y))) {
                let voxel = at.floor().as_ivec3().with_z(z) + IVec3::new(x, y, 0);
                if shape.contains(voxel) {
                    found += 1;
                    added += i64::from(pair.plain.grids[0].get(voxel).is_none());
                    assert!(pair.dynamic.voxel(0, voxel).is_some(), "{voxel}");
                }
            }
        }
        assert!(found > 2 * reach && added == edited.voxels, "{found} {added} {edited:?}");
        pair.dynamic.validate().unwrap();
        pair.dynamic.undo().unwrap().unwrap();
    }
    let thick = Shape::Capsule { from: DVec3::splat(-5000.0), to: DVec3::splat(5000.0), radius: 900.0 };
    let too_large = pair.dynamic.edit(0, &Edit::Fill { shape: thick, material: Some(0) });
    assert!(matches!(too_large, Err(EditError::TooLarge { .. })), "{too_large:?}");
}

#[test]
fn boxes_may_have_corners_as_far_out_as_numbers_go() {
    let mut pair = Pair::new();
    let everywhere = VoxelBox { min: IVec3::MIN, max: IVec3::MAX };
    let lamps = pair.plain.grids[0].voxels().filter(|(_, material)| *material == 1).count() as i64;
    let edited = pair.dynamic.edit(0, &Edit::Replace { within: Some(everywhere), from: 1, to: None }).unwrap();
    assert!(lamps > 0 && edited.voxels == -lamps, "{edited:?}");
    let fill = |material| Edit::Fill { shape: Shape::Box(everywhere), material };
    assert_eq!(pair.dynamic.edit(0, &fill(Some(0))), Err(EditError::OutOfRange(IVec3::MIN)));
    assert!(matches!(pair.dynamic.copy(0, everywhere), Err(EditError::OutOfRange(_))));
    pair.dynamic.edit(0, &fill(None)).unwrap();
    assert_eq!(pair.dynamic.scene().grids()[0].voxel_count(), 0);
    pair.dynamic.validate().unwrap();
}

#[test]
fn what_becomes_empty_or_another_material_needs_no_room_and_what_cannot_be_undone_stays() {
    let mut scene = Pair::new().dynamic;
    let count = (1 << 21) + 1;
    let code = Some(BrickCode { record: Box::default(), materials: Box::default() });
    let (own, far) = (IVec3::new(0, 0, -1), IVec3::splat(9000));
    assert!(scene.voxel(0, IVec3::new(0, 0, -1)).is_some());
    assert_eq!(scene.check_room(0, &vec![(far, None); count]), Ok(()));
    assert_eq!(scene.check_room(0, &vec![(own, code.clone()); count]), Ok(()));
    // Neighbours share the nodes above them.
    let block = |index: usize| IVec3::new(index as i32 & 127, index as i32 >> 7 & 127, index as i32 >> 14) + far;
    let filled: Vec<_> = (0..count).map(|index| (block(index), code.clone())).collect();
    assert_eq!((scene.check_room(0, &filled), scene.check_room(7, &filled)), (Ok(()), Ok(())));
    drop(filled);
    // A grid of so many bricks that its top array cannot reach farther.
    let new = vec![(far, code)];
    assert_eq!(scene.check_room(0, &new), Ok(()));
    scene.bricks[0] = 1 << 29;
    assert_eq!(scene.check_room(0, &new), Err(EditError::Full));
    scene.history.push(Entry { grid: 0, bricks: new });
    assert_eq!((scene.undo(), scene.undo_steps()), (Err(EditError::Full), (1, 0)));
}

#[test]
fn materials_that_are_added_are_those_of_packing_also_where_a_byte_cannot_name_them() {
    let (mut random, mut pair) = (Random(17), Pair::new());
    for count in [60, 251 - 60 - 5, 5, 1, 1, 30] {
        let before = pair.plain.materials.len();
        for _ in 0..count {
            let number = pair.plain.materials.len();
            let material = Material { emission: Vec3::splat((number % 7 / 6) as f32), ..Material::default() };
            assert_eq!(usize::from(pair.dynamic.add_material(&material).unwrap()), number);
            pair.plain.materials.push(material);
        }
        let patch = pair.dynamic.take_patch();
        assert_eq!(patch.materials.length, pair.plain.materials.len());
        pair.tracer.patch(&patch).unwrap();
        if before <= 256 && pair.plain.materials.len() > 256 {
            // What was encoded with bytes cannot be put back.
            (pair.done, pair.undone) = (Vec::new(), Vec::new());
        }
        (0..40).for_each(|_| pair.step(&mut random, 40));
        pair.compare(&mut random);
    }
    assert_eq!(pair.dynamic.scene().grids()[0].material_bits, 16);
}

#[test]
fn patches_are_taken_in_their_order_and_undo_has_a_limit() {
    let mut pair = Pair::new();
    let fill = |x: i32| Edit::Fill {
        shape: Shape::Box(VoxelBox { min: IVec3::new(x, 0, 30), max: IVec3::new(x + 1, 1, 31) }),
        material: Some(0),
    };
    pair.dynamic.edit(0, &fill(0)).unwrap();
    let first = pair.dynamic.take_patch();
    assert!(!first.is_empty() && pair.dynamic.take_patch().is_empty());
    pair.dynamic.edit(0, &fill(1)).unwrap();
    let second = pair.dynamic.take_patch();
    assert_eq!(pair.tracer.patch(&second), Err(TraceError::OutOfStep(super::OutOfStep)));
    pair.tracer.patch(&first).unwrap();
    pair.tracer.patch(&second).unwrap();
    assert_eq!(pair.tracer.patch(&second), Err(TraceError::OutOfStep(super::OutOfStep)));
    // A tracer that begins with the scene as it is now follows from now on.
    let mut late = CpuTracer::new(None);
    assert_eq!(late.patch(&second), Err(TraceError::NoScene));
    late.set_scene(&Arc::new(pair.dynamic.scene().clone())).unwrap();
    pair.dynamic.edit(0, &fill(2)).unwrap();
    let third = pair.dynamic.take_patch();
    for tracer in [&mut late, &mut pair.tracer] {
        tracer.patch(&third).unwrap();
        let down = [Ray::new(Vec3::new(2.5, 0.5, 90.0), Vec3::NEG_Z)];
        assert_eq!(hits(tracer, &down)[0].voxel, IVec3::new(2, 0, 30));
    }
    let size = pair.dynamic.undo_size_bytes();
    pair.dynamic.set_undo_limit(size / 2);
    assert!(pair.dynamic.undo_size_bytes() <= size / 2);
    assert!(pair.dynamic.undo().unwrap().is_some() && pair.dynamic.undo().unwrap().is_none());
    assert!(matches!(
        DynamicScene::new(
            PackedScene::pack(&example()).unwrap().with_normals(crate::normals::Normals::Smooth).unwrap()
        ),
        Err(EditError::SmoothNormals)
    ));
}
