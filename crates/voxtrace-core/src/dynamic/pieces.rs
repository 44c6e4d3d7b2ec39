//! Pieces that come off: what a cut leaves without a connection becomes a grid and instances of its own, with what a game's physics needs to move
//! them, and may come back. Nothing here moves by itself.

use super::plan::{Change, brick_box, check_range, code_of, within_range};
use super::sketch::Sketch;
use super::{Clip, DynamicScene, Edit, EditError, Edited};
use crate::packed::{Lattice, LightNode, PackedGrid, PackedInstance, Section};
use glam::{DMat3, DVec3, IVec3, Mat3};
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, block_bit, block_index};
use voxtrace_scene::grid::{VoxelBox, VoxelGrid, brick_of, local_of};
use voxtrace_scene::ray::FACES;
use voxtrace_scene::transform::Transform;

/// How far from the lattice, in voxels, what is put back may lie.
const SLACK: f32 = 0.01;

/// Voxels of a grid that are connected across faces, and with nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    grid: u32,
    voxels: VoxelGrid,
}

/// Mass, centre of mass and inertia, in the space of a grid: lengths are edges of voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// The sum of the voxels' densities.
    pub mass: f64,
    /// Centre of mass.
    pub center: DVec3,
    /// Inertia tensor about the centre, of solid voxels.
    pub inertia: DMat3,
}

impl Piece {
    /// The grid of which it is a part.
    pub fn grid(&self) -> u32 {
        self.grid
    }

    /// Its voxels, where they are in that grid, with their materials.
    pub fn voxels(&self) -> &VoxelGrid {
        &self.voxels
    }

    /// Its mass and where it lies; `density` is the mass of a voxel of a material.
    pub fn mass_properties(&self, density: impl Fn(u16) -> f64) -> MassProperties {
        // About a voxel in its middle, so that nothing large is taken from something as large.
        let bounds = self.voxels.bounds().unwrap_or(VoxelBox { min: IVec3::ZERO, max: IVec3::ONE });
        let about = ((bounds.min + bounds.max) / 2).as_dvec3();
        let (mut mass, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for (voxel, material) in self.voxels.voxels() {
            let (own, at) = (density(material), voxel.as_dvec3() + 0.5 - about);
            mass += own;
            first += at * own;
            second += DMat3::from_cols(at * at.x, at * at.y, at * at.z) * own;
        }
        let middle = if mass > 0.0 { first / mass } else { DVec3::ZERO };
        // Covariance about the middle, and 1/12 along each axis of each cube itself.
        let moved = DMat3::from_cols(middle * middle.x, middle * middle.y, middle * middle.z) * mass;
        let covariance = second - moved + DMat3::IDENTITY * (mass / 12.0);
        let trace = covariance.x_axis.x + covariance.y_axis.y + covariance.z_axis.z;
        MassProperties { mass, center: about + middle, inertia: DMat3::IDENTITY * trace - covariance }
    }
}

/// Voxels that a search has been at.
#[derive(Default)]
struct Seen(FxHashMap<IVec3, [u64; 8]>);

impl Seen {
    /// Whether a voxel was there already; it is now.
    fn insert(&mut self, voxel: IVec3) -> bool {
        let local = local_of(voxel);
        let block = &mut self.0.entry(brick_of(voxel)).or_default()[block_index(local)];
        let bit = 1 << block_bit(local);
        std::mem::replace(block, *block | bit) & bit != 0
    }
}

impl DynamicScene {
    /// The pieces of a grid that have a voxel in a box, around a cut, say, and at most so many voxels: what is larger is taken for the body that
    /// they came off. Voxels that touch by edges or corners alone are not connected. In the order of their lowest voxels. Takes time with the voxels
    /// of the pieces, and with `most` for each part of the body in the box.
    ///
    /// # Errors
    /// [`EditError::NoGrid`] where there is no such grid.
    pub fn loose_pieces(&self, grid: u32, within: VoxelBox, most: u64) -> Result<Vec<Piece>, EditError> {
        self.check_grid(grid)?;
        let (geometry, packed) = (self.geometry(), &self.geometry().grids[grid as usize]);
        let mut starts = Vec::new();
        for at in geometry.bricks_in(grid as usize, brick_box(within_range(within))) {
            let Some(record) = geometry.find_brick(packed, at * BRICK_SIZE) else { continue };
            let brick = geometry.decode_brick(packed, record);
            starts.extend(brick.voxels().map(|(local, _)| at * BRICK_SIZE + local));
        }
        starts.retain(|&voxel| within.contains(voxel));
        starts.sort_unstable_by_key(|voxel| (voxel.z, voxel.y, voxel.x));
        let (mut seen, mut sketch) = (Seen::default(), Sketch::new(self, grid));
        let mut pieces = Vec::new();
        for start in starts {
            if !seen.insert(start) {
                pieces.extend(connected(&mut sketch, &mut seen, start, most).map(|voxels| Piece { grid, voxels }));
            }
        }
        Ok(pieces)
    }

    /// Makes a piece a grid of its own, with an instance at each instance of the grid that it came off. Returns the new instances, in the order of those.
    /// What was edited before cannot be undone any more.
    ///
    /// # Errors
    /// [`EditError::PieceChanged`] where its voxels are not there as they were; [`EditError::Full`]. Nothing has changed then.
    pub fn detach(&mut self, piece: &Piece) -> Result<Vec<u32>, EditError> {
        self.check_grid(piece.grid)?;
        let is_there = |(voxel, material): (IVec3, u16)| self.voxel(piece.grid, voxel) == Some(material);
        let Some(bounds) = piece.voxels.bounds().filter(|_| piece.voxels.voxels().all(is_there)) else {
            return Err(EditError::PieceChanged);
        };
        let mut sketch = Sketch::new(self, piece.grid);
        piece.voxels.voxels().for_each(|(voxel, _)| sketch.set(voxel, None));
        let removed = sketch.changes();
        let bits = self.geometry().grids[piece.grid as usize].material_bits;
        let added: Vec<Change> =
            piece.voxels.sorted_bricks().into_iter().map(|(at, brick)| (at, code_of(brick, bits))).collect();
        self.check_room(self.bricks.len() as u32, &added)?;
        self.apply(piece.grid, removed)?;
        let grid = self.add_grid(bounds.min, bits);
        self.apply(grid, added)?;
        self.history.clear();
        let mut instances = self.scene.placement.instances().to_vec();
        let next = instances.iter().map(|instance| instance.scene_instance + 1).max().unwrap_or(0);
        let own = |instance: &&PackedInstance| instance.grid == piece.grid;
        let new: Vec<PackedInstance> = (instances.iter().filter(own).zip(next..))
            .map(|(instance, number)| PackedInstance::new(grid, instance.world_from_grid, number))
            .collect();
        let first = instances.len() as u32;
        let numbers = (first..first + new.len() as u32).collect();
        instances.extend(new);
        self.place(instances).expect("they stand where others do");
        Ok(numbers)
    }

    /// Puts the voxels of an instance back into the grid of another one, where it stands on its lattice by now, to a hundredth of a voxel, whole turns,
    /// mirrors and steps away; they replace what is there. The instance is gone: the last one takes its number. What was edited before cannot be
    /// undone any more.
    ///
    /// # Errors
    /// [`EditError::NoInstance`]; [`EditError::NotOnLattice`]; as [`Self::edit`] where voxels would lie too far out. Nothing has changed then.
    pub fn attach(&mut self, instance: u32, to: u32) -> Result<Edited, EditError> {
        let mut instances = self.scene.placement.instances().to_vec();
        let count = instances.len();
        let find = |index: u32| instances.get(index as usize).ok_or(EditError::NoInstance { instance: index, count });
        let (from, to) = (*find(instance)?, *find(to)?);
        if from.grid == to.grid {
            return Err(EditError::NotOnLattice);
        }
        let lattice = on_lattice(&to.grid_from_world.after(&from.world_from_grid)).ok_or(EditError::NotOnLattice)?;
        let mut voxels = VoxelGrid::new();
        for (voxel, material) in self.geometry().unpack_grid(&self.geometry().grids[from.grid as usize]).voxels() {
            let voxel = lattice.voxel(voxel);
            check_range(VoxelBox { min: voxel, max: voxel + 1 })?;
            voxels.set(voxel, material);
        }
        let bounds = voxels.bounds().unwrap_or(VoxelBox { min: IVec3::ZERO, max: IVec3::ZERO });
        Clip::check_size(bounds.size())?;
        let mut clip = VoxelGrid::new();
        voxels.voxels().for_each(|(voxel, material)| _ = clip.set(voxel - bounds.min, material));
        let clip = Arc::new(Clip::new(clip, bounds.size()));
        let edited = self.edit(to.grid, &Edit::Paste { clip, at: bounds.min, with_empty: false })?;
        instances.swap_remove(instance as usize);
        if !instances.iter().any(|other| other.grid == from.grid) {
            // Its places are free for others.
            let bricks = self.geometry().bricks_of(&self.geometry().grids[from.grid as usize]);
            let origin = self.geometry().grids[from.grid as usize].origin / BRICK_SIZE;
            self.apply(from.grid, bricks.into_iter().map(|at| (at + origin, None)).collect())?;
        }
        self.history.clear();
        self.place(instances).expect("they stand where they stood");
        Ok(edited)
    }

    /// A grid without voxels, whose cells begin at the brick of a voxel. Returns its number.
    fn add_grid(&mut self, near: IVec3, material_bits: u32) -> u32 {
        let mut store = self.store();
        let top_offset = store.put_cells(&[0; 64]) as u32;
        let geometry = store.geometry;
        let origin = brick_of(near) * BRICK_SIZE;
        let new = PackedGrid {
            origin,
            top_shift: 3,
            top_size: IVec3::ONE,
            top_offset,
            min: origin,
            voxels: [0; 2],
            max: origin,
            material_bits,
        };
        let mut grids = geometry.grids.to_vec();
        grids.push(new);
        geometry.grids = Section::from(grids);
        geometry.light_roots = geometry.light_roots.iter().copied().chain([LightNode::NONE]).collect();
        if let Some(&last) = geometry.scene_grids.last() {
            geometry.scene_grids = geometry.scene_grids.iter().copied().chain([last + 1]).collect();
        }
        self.bricks.push(0);
        self.is_loose.push(false);
        self.is_placement_stale = true;
        (self.bricks.len() - 1) as u32
    }
}

/// The voxels that are connected with one, which was seen; `None` where they are more than `most` or are connected with what was seen before, which was.
fn connected(sketch: &mut Sketch, seen: &mut Seen, start: IVec3, most: u64) -> Option<VoxelGrid> {
    let (mut waiting, mut own) = (vec![start], FxHashSet::from_iter([start]));
    let mut voxels = VoxelGrid::new();
    while let Some(voxel) = waiting.pop() {
        let Some(material) = sketch.get(voxel) else { continue };
        voxels.set(voxel, material);
        if own.len() as u64 > most {
            return None;
        }
        for beside in FACES.iter().map(|face| voxel + face.normal()) {
            if own.contains(&beside) || sketch.get(beside).is_none() {
                continue;
            }
            // Only parts of a body were left before all that is connected with them was found.
            if seen.insert(beside) {
                return None;
            }
            own.insert(beside);
            waiting.push(beside);
        }
    }
    Some(voxels)
}

/// What a transform does to voxels where it is, but for rounding, one of the lattice.
fn on_lattice(transform: &Transform) -> Option<Lattice> {
    let linear = Mat3::from_cols_array(&transform.linear.to_cols_array().map(f32::round));
    let translation = transform.translation.round();
    let is_near = linear.abs_diff_eq(transform.linear, SLACK / 100.0)
        && (translation - transform.translation).abs().max_element() <= SLACK;
    Lattice::of(&Transform { linear, translation }).filter(|_| is_near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamic::tests::plain::Random;
    use crate::packed::PackedScene;
    use glam::Vec3;
    use voxtrace_scene::{Instance, Material, Scene, Shape};

    fn scene_of(grid: VoxelGrid) -> Scene {
        let materials = vec![Material::default(), Material::emissive(Vec3::ONE), Material::default()];
        Scene::from_grid("pieces", grid, materials)
    }

    /// A table with lamps on it, and dust.
    fn table() -> VoxelGrid {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::new(-30, -30, 0), max: IVec3::new(30, 30, 4) }, 0);
        grid.fill_box(VoxelBox { min: IVec3::new(-2, -2, -20), max: IVec3::new(2, 2, 0) }, 2);
        grid.fill_box(VoxelBox { min: IVec3::new(9, 9, 4), max: IVec3::new(12, 12, 9) }, 1);
        let mut random = Random(5);
        (0..80).for_each(|_| _ = grid.set(random.voxel(12) + IVec3::new(0, 0, 20), random.below(3) as u16));
        grid
    }

    fn cut(x: i32) -> Edit {
        let region = VoxelBox { min: IVec3::new(x, -99, -99), max: IVec3::new(x + 1, 99, 99) };
        Edit::Fill { shape: Shape::Box(region), material: None }
    }

    /// Connected voxels, the plain way.
    fn parts(grid: &VoxelGrid) -> Vec<VoxelGrid> {
        let mut left: std::collections::BTreeMap<[i32; 3], u16> =
            grid.voxels().map(|(voxel, material)| ([voxel.z, voxel.y, voxel.x], material)).collect();
        let mut parts = Vec::new();
        while let Some((&first, _)) = left.first_key_value() {
            let (mut part, mut waiting) = (VoxelGrid::new(), vec![first]);
            while let Some(at) = waiting.pop() {
                let Some(material) = left.remove(&at) else { continue };
                part.set(IVec3::new(at[2], at[1], at[0]), material);
                for axis in 0..3 {
                    for step in [-1, 1] {
                        let mut beside = at;
                        beside[axis] += step;
                        waiting.push(beside);
                    }
                }
            }
            parts.push(part);
        }
        parts
    }

    #[test]
    fn pieces_are_the_parts_that_are_not_connected() {
        let everywhere = VoxelBox { min: IVec3::splat(-200), max: IVec3::splat(200) };
        let mut scene = DynamicScene::new(PackedScene::pack(&scene_of(table())).unwrap()).unwrap();
        scene.edit(0, &cut(10)).unwrap();
        let mut expected = parts(&scene.scene().geometry().unpack_grid(&scene.scene().grids()[0]));
        let found = scene.loose_pieces(0, everywhere, u64::MAX).unwrap();
        let same = |found: &[Piece], expected: &[VoxelGrid]| {
            found.len() == expected.len()
                && found.iter().zip(expected).all(|(found, part)| found.voxels().voxels().eq(part.voxels()))
        };
        assert!(expected.len() > 30 && same(&found, &expected), "{} of {}", found.len(), expected.len());
        expected[3].set(IVec3::splat(90), 0);
        assert!(!same(&found, &expected), "a voxel too many is seen");
        // What is large is the body, and only what is near the cut is looked at.
        let near = VoxelBox { min: IVec3::new(9, -60, -60), max: IVec3::new(12, 60, 16) };
        let small = scene.loose_pieces(0, near, 5000).unwrap();
        let side = 19 * 60 * 4 + 3 * 5;
        assert!(
            small.iter().any(|piece| piece.voxels().count() == side),
            "the side of the table with its part of the lamp"
        );
        assert!(small.iter().all(|piece| piece.voxels().count() <= 5000));
        assert!(small.iter().all(|piece| piece.voxels().voxels().any(|(voxel, _)| near.contains(voxel))));
        assert!(found.iter().any(|piece| piece.voxels().count() > 5000), "the body");
    }

    #[test]
    fn mass_and_inertia_are_those_of_solid_bodies() {
        let mut voxels = VoxelGrid::new();
        let (min, size) = (IVec3::new(500, -7, 31), IVec3::new(12, 5, 3));
        voxels.fill_box(VoxelBox { min, max: min + size }, 1);
        let box_ = Piece { grid: 0, voxels }.mass_properties(|material| 2.0 + f64::from(material));
        let (mass, edges) = (3.0 * size.element_product() as f64, size.as_dvec3());
        let squares = edges * edges;
        let expected = DVec3::new(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y) * (mass / 12.0);
        assert_eq!((box_.mass, box_.center), (mass, min.as_dvec3() + edges / 2.0));
        assert!(box_.inertia.abs_diff_eq(DMat3::from_diagonal(expected), 1e-9), "{}", box_.inertia);
        assert!(!box_.inertia.abs_diff_eq(DMat3::from_diagonal(expected * 1.001), 1e-9));
        // Two bodies together, about their common centre (Steiner): products of inertia, too.
        let (a, b) = (IVec3::ZERO, IVec3::new(4, 2, -6));
        let mut two = VoxelGrid::new();
        two.set(a, 0);
        two.set(b, 1);
        let both = Piece { grid: 0, voxels: two }.mass_properties(|material| 1.0 + 2.0 * f64::from(material));
        let center = (a.as_dvec3() + b.as_dvec3() * 3.0) / 4.0 + 0.5;
        let of = |at: IVec3, mass: f64| {
            let d = at.as_dvec3() + 0.5 - center;
            let outer = DMat3::from_cols(d * d.x, d * d.y, d * d.z);
            (DMat3::IDENTITY * d.length_squared() - outer + DMat3::IDENTITY / 6.0) * mass
        };
        assert_eq!((both.mass, both.center), (4.0, center));
        assert!(both.inertia.abs_diff_eq(of(a, 1.0) + of(b, 3.0), 1e-9));
    }

    #[test]
    fn a_piece_that_comes_off_is_packed_as_a_grid_of_its_own_and_comes_back() {
        let mut plain = scene_of(table());
        let turned = Transform { linear: Mat3::from_rotation_z(0.4) * 2.0, translation: Vec3::new(300.0, 5.0, 1.0) };
        plain.instances.push(Instance::new(0, turned));
        let mut scene = DynamicScene::new(PackedScene::pack(&plain).unwrap()).unwrap();
        let whole = scene.compact();
        let lamp = VoxelBox { min: IVec3::new(9, 9, 3), max: IVec3::new(12, 12, 4) };
        scene.edit(0, &Edit::Fill { shape: Shape::Box(lamp), material: None }).unwrap();
        let near = VoxelBox { min: lamp.min - 1, max: lamp.max + 1 };
        let pieces = scene.loose_pieces(0, near, 1000).unwrap();
        let [piece] = &pieces[..] else { panic!("{} pieces", pieces.len()) };
        assert_eq!(piece.voxels().count(), 45);
        let instances = scene.detach(piece).unwrap();
        assert_eq!(instances, [2, 3]);
        scene.validate().unwrap();
        assert_eq!(scene.detach(piece), Err(EditError::PieceChanged));
        // As if it had been a model from the first.
        let grid = Arc::make_mut(&mut plain.grids[0]);
        grid.clear_box(VoxelBox { min: lamp.min, max: IVec3::new(12, 12, 9) });
        plain.grids.push(Arc::new(piece.voxels().clone()));
        plain.instances.extend([Instance::new(1, Transform::IDENTITY), Instance::new(1, turned)]);
        let anew = PackedScene::pack(&plain).unwrap();
        let compact = scene.compact();
        assert_eq!(compact.content_hash(), anew.content_hash());
        assert_eq!(compact.instances(), anew.instances());
        assert_ne!(compact.content_hash(), whole.content_hash());
        // Away, and nearly back again, a quarter turned and elsewhere.
        let moved = |scene: &DynamicScene, transform: Transform| {
            let mut all = scene.scene().instances().to_vec();
            all[2] = PackedInstance::new(1, transform, 2);
            all
        };
        let away = Transform { linear: Mat3::from_rotation_x(0.3), translation: Vec3::new(0.0, 0.0, 70.0) };
        scene.place(moved(&scene, away)).unwrap();
        assert_eq!(scene.attach(2, 0), Err(EditError::NotOnLattice));
        scene.place(moved(&scene, Transform::from_translation(Vec3::new(600_000.0, 0.0, 0.0)))).unwrap();
        assert!(matches!(scene.attach(2, 0), Err(EditError::OutOfRange(_))));
        let linear = Mat3::from_rotation_z(std::f32::consts::FRAC_PI_2);
        let back = Transform { linear, translation: Vec3::new(21.0, 0.004, 0.0) };
        scene.place(moved(&scene, back)).unwrap();
        let before = scene.scene().instances().len();
        let edited = scene.attach(2, 0).unwrap();
        assert_eq!((edited.voxels, scene.scene().instances().len()), (45, before - 1));
        scene.validate().unwrap();
        let turned_voxel = |voxel: IVec3| IVec3::new(20 - voxel.y, voxel.x, voxel.z);
        assert!(piece.voxels().voxels().all(|(voxel, own)| scene.voxel(0, turned_voxel(voxel)) == Some(own)));
        // The other one stands where its grid's other instance does.
        let last = scene.scene().instances().iter().position(|instance| instance.grid == 1).unwrap() as u32;
        let other = (scene.scene().instances().iter()).position(|own| own.grid == 0 && own.world_from_grid == turned);
        scene.attach(last, other.unwrap() as u32).unwrap();
        scene.validate().unwrap();
        assert_eq!(scene.compact().grids().len(), 1);
        assert!(piece.voxels().voxels().all(|(voxel, own)| scene.voxel(0, voxel) == Some(own)));
        assert_eq!(scene.attach(0, 9), Err(EditError::NoInstance { instance: 9, count: 2 }));
    }
}
