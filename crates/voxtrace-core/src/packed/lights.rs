//! The emitters of each grid and the tree over them, which all instances of the grid share: a tree that halves the Morton
//! order of the emissive voxels (Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees", HPG
//! 2012), in the space of the grid. A node's powers along the six axes stand in for the cone of normals of Conty Estevez
//! and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting" (HPG 2018).

use super::{Emitter, Geometry, LEAF_EMITTERS, LightNode, PackedGrid, PackedMaterial};
use crate::math::luminance;
use crate::surface::faces_of;
use glam::IVec3;
use rayon::prelude::*;
use std::cmp::Ordering;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::ray::FACES;
use voxtrace_scene::scene::Scene;

/// Luminance of what the surface of a material emits.
pub(super) fn surface_luminance(material: &Material) -> f32 {
    if material.is_without_surface() { 0.0 } else { luminance(material.emission) }
}

/// Whether a voxel of a material covers the faces of a lamp beside it: light leaves through glass and clouds.
pub(crate) fn covers(transmission: f32, metallic: f32) -> bool {
    transmission <= 0.0 || metallic >= 1.0
}

/// Finds the emitters of `grids` of a scene, in their order, and builds the tree over those of each. Emitters are ordered by
/// grid and [`morton_order`].
pub(super) fn lights_of(scene: &Scene, grids: &[usize]) -> (Vec<Emitter>, Vec<LightNode>) {
    let luminances: Vec<f32> = scene.materials.iter().map(surface_luminance).collect();
    let covers: Vec<bool> =
        scene.materials.iter().map(|material| covers(material.transmission, material.metallic)).collect();
    let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
    for (index, &grid) in grids.iter().enumerate() {
        let found = grid_emitters(&scene.grids[grid], index as u32, &luminances, &covers);
        append_lights(found, &mut emitters, &mut nodes);
    }
    (emitters, nodes)
}

/// As [`lights_of`], for grid `index` of a geometry that has no emitters of it yet; `emitting` are the voxels whose material emits.
pub(super) fn append_lights_of_grid(
    geometry: &Geometry,
    index: usize,
    emitting: Vec<(IVec3, u16)>,
    emitters: &mut Vec<Emitter>,
    nodes: &mut Vec<LightNode>,
) {
    let grid = &geometry.grids[index];
    let is_free = |voxel: IVec3| geometry.is_free(grid, voxel);
    let mut found: Vec<Emitter> = emitting
        .into_par_iter()
        .map(|(voxel, material)| Emitter {
            voxel,
            grid: index as u32,
            faces: FACES.iter().map(|&face| u32::from(is_free(voxel + face.normal())) << face as u32).sum(),
            material: material.into(),
            luminance: luminance(geometry.materials[usize::from(material)].surface_emission()),
            leaf: 0,
        })
        .filter(|emitter| emitter.faces != 0)
        .collect();
    found.par_sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
    append_lights(found, emitters, nodes);
}

impl Geometry {
    /// Whether a voxel of a grid is empty, or one that light enters.
    pub(crate) fn is_free(&self, grid: &PackedGrid, voxel: IVec3) -> bool {
        self.material_at(grid, voxel).is_none_or(|material| {
            let PackedMaterial { transmission, metallic, .. } = self.materials[material as usize];
            !covers(transmission, metallic)
        })
    }
}

/// Appends the emitters of one grid, which are in [`morton_order`] and none twice, and the tree over them.
pub(crate) fn append_lights(found: Vec<Emitter>, emitters: &mut Vec<Emitter>, nodes: &mut Vec<LightNode>) {
    if found.is_empty() {
        return;
    }
    let (first, root) = (emitters.len(), nodes.len());
    emitters.extend(found);
    split(&emitters[first..], first, nodes);
    link(root, nodes, emitters);
}

/// The emissive voxels with a free face, in [`morton_order`].
fn grid_emitters(grid: &VoxelGrid, index: u32, luminances: &[f32], covers: &[bool]) -> Vec<Emitter> {
    let emits = |material: u16| luminances[usize::from(material)] > 0.0;
    let mut emitters: Vec<Emitter> = grid
        .sorted_bricks()
        .into_par_iter()
        .filter(|(_, brick)| brick.materials().iter().any(|&material| emits(material)))
        .flat_map_iter(|(at, brick)| {
            let emissive = brick.voxels().filter(move |&(_, material)| emits(material));
            emissive.map(move |(local, material)| Emitter {
                voxel: at * BRICK_SIZE + local,
                grid: index,
                faces: free_faces(grid, (at * BRICK_SIZE, brick, local), covers),
                material: material.into(),
                luminance: luminances[usize::from(material)],
                leaf: 0,
            })
        })
        .filter(|emitter| emitter.faces != 0)
        .collect();
    emitters.par_sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
    emitters
}

/// Bit f is set where nothing that covers it is at face f of the voxel `local` of `brick`, whose lowest voxel is `corner`.
fn free_faces(grid: &VoxelGrid, (corner, brick, local): (IVec3, &Brick, IVec3), covers: &[bool]) -> u32 {
    let is_free = |neighbour: IVec3| {
        let inside = neighbour.cmpge(IVec3::ZERO).all() && neighbour.cmplt(IVec3::splat(BRICK_SIZE)).all();
        let material = if inside { brick.get(neighbour) } else { grid.get(corner + neighbour) };
        material.is_none_or(|material| !covers[usize::from(material)])
    };
    FACES.iter().map(|&face| u32::from(is_free(local + face.normal())) << face as u32).sum()
}

/// The order of two voxels along the Z-curve, z above y above x, found without interleaving bits: the axis whose
/// coordinates differ in the highest bit decides (Chan, "Closest-Point Problems Simplified on the RAM", SODA 2002).
pub fn morton_order(a: IVec3, b: IVec3) -> Ordering {
    match deciding_axis(a, b) {
        Some((axis, _)) => a[axis].cmp(&b[axis]),
        None => Ordering::Equal,
    }
}

/// The axis and the bit in which two voxels differ first along the Z-curve. Flipping the sign bit makes the order of
/// unsigned words that of the coordinates and does not change where two of them differ.
pub(crate) fn deciding_axis(a: IVec3, b: IVec3) -> Option<(usize, u32)> {
    let mut deciding = (0, 0);
    for axis in [2, 1, 0] {
        let differ = (a[axis] ^ b[axis]) as u32;
        // The highest bit of `differ` is above that of `deciding.1`.
        if deciding.1 < differ && deciding.1 < (deciding.1 ^ differ) {
            deciding = (axis, differ);
        }
    }
    (deciding.1 != 0).then(|| (deciding.0, deciding.1.ilog2()))
}

/// Appends the tree over `emitters`, the first of which has the number `first`, of one grid.
fn split(emitters: &[Emitter], first: usize, nodes: &mut Vec<LightNode>) {
    if emitters.len() <= LEAF_EMITTERS {
        nodes.push(leaf_of(emitters, first));
        return;
    }
    let (low, high) = (emitters[0].voxel, emitters[emitters.len() - 1].voxel);
    let (axis, bit) = deciding_axis(low, high).expect("voxels of one grid differ");
    let middle = emitters.partition_point(|emitter| emitter.voxel[axis] >> bit == low[axis] >> bit);
    let node = nodes.len();
    nodes.push(LightNode::EMPTY);
    split(&emitters[..middle], first, nodes);
    let right = nodes.len();
    split(&emitters[middle..], first + middle, nodes);
    nodes[node] = LightNode::over(&nodes[node + 1], right as u32, &nodes[right]);
}

/// A leaf of emitters, the first of which has the number `first`.
pub(crate) fn leaf_of(emitters: &[Emitter], first: usize) -> LightNode {
    let mut node = LightNode { index: first as u32, count: emitters.len() as u32, ..LightNode::EMPTY };
    for emitter in emitters {
        let low = emitter.voxel.as_vec3();
        (node.min, node.max) = (node.min.min(low), node.max.max(low + 1.0));
        for face in faces_of(emitter.faces) {
            node.power[face as usize] += emitter.luminance;
        }
    }
    node
}

impl LightNode {
    /// An inner node, whose `right` child has a number of its own.
    pub(crate) fn over(left: &Self, right: u32, right_node: &Self) -> Self {
        Self {
            min: left.min.min(right_node.min),
            max: left.max.max(right_node.max),
            power: std::array::from_fn(|side| left.power[side] + right_node.power[side]),
            index: right,
            ..Self::EMPTY
        }
    }
}

/// Tells each node from `root` on its parent and each emitter its leaf.
fn link(root: usize, nodes: &mut [LightNode], emitters: &mut [Emitter]) {
    for at in root..nodes.len() {
        let (index, count) = (nodes[at].index as usize, nodes[at].count as usize);
        if count == 0 {
            nodes[at + 1].parent = at as u32;
            nodes[index].parent = at as u32;
        } else {
            emitters[index..index + count].iter_mut().for_each(|emitter| emitter.leaf = at as u32);
        }
    }
}

/// Checks that emitters and trees hold together: every index lies inside its array, every node is reached from a root and
/// finds its way back, and each grid has one root at most.
///
/// # Errors
/// One sentence about the first fault.
pub(super) fn validate_lights(geometry: &Geometry) -> Result<(), Invalid> {
    let (nodes, emitters) = (&*geometry.light_nodes, &*geometry.emitters);
    let leaf_of = |emitter: &Emitter| nodes.get(emitter.leaf as usize).filter(|leaf| leaf.count > 0);
    let order = |a: &Emitter, b: &Emitter| a.grid.cmp(&b.grid).then_with(|| morton_order(a.voxel, b.voxel));
    for (index, emitter) in emitters.iter().enumerate() {
        let is_inside = (emitter.material as usize) < geometry.materials.len()
            && (emitter.grid as usize) < geometry.grids.len()
            && emitter.faces >> 6 == 0;
        if is_inside && !(emitter.luminance > 0.0 && emitter.luminance.is_finite()) {
            return Err(format!("emitter {index} has a luminance of {}", emitter.luminance).into());
        }
        let is_in_leaf = leaf_of(emitter).is_some_and(|leaf| {
            let first = leaf.index as usize;
            (first..first + leaf.count as usize).contains(&index) && emitters[first].grid == emitter.grid
        });
        if !is_inside || !is_in_leaf {
            return Err(format!("emitter {index} points outside").into());
        }
        if index > 0 && order(&emitters[index - 1], emitter) != Ordering::Less {
            return Err(format!("emitter {index} is out of order").into());
        }
    }
    for (at, node) in nodes.iter().enumerate() {
        let (index, count) = (node.index as usize, node.count as usize);
        let is_sound = match count {
            // The left child follows its parent, the right one comes later: the tree has no cycle.
            0 => index > at + 1 && index < nodes.len(),
            _ => count <= LEAF_EMITTERS && index + count <= emitters.len() && emitters[index].leaf as usize == at,
        };
        if !is_sound || !finds_root(nodes, at) {
            return Err(format!("node {at} of the trees over emitters points outside").into());
        }
    }
    validate_roots(nodes, emitters)?;
    // Light from where nothing glows would be light from nowhere.
    let is_there = |emitter: &Emitter| {
        let grid = &geometry.grids[emitter.grid as usize];
        let is_within = emitter.voxel.cmpge(grid.min).all() && emitter.voxel.cmplt(grid.max).all();
        is_within && geometry.material_at(grid, emitter.voxel) == Some(emitter.material)
    };
    match emitters.par_iter().position_first(|emitter| !is_there(emitter)) {
        Some(index) => Err(format!("emitter {index} is no voxel of its material").into()),
        None => Ok(()),
    }
}

/// Checks that all emitters of a tree are of one grid, and that grids come in their order.
fn validate_roots(nodes: &[LightNode], emitters: &[Emitter]) -> Result<(), Invalid> {
    let mut grids = vec![0; nodes.len()];
    for (at, node) in nodes.iter().enumerate().rev() {
        grids[at] = if node.count > 0 { emitters[node.index as usize].grid } else { grids[at + 1] };
        if node.count == 0 && grids[node.index as usize] != grids[at] {
            return Err(format!("node {at} of the trees over emitters is of two grids").into());
        }
    }
    let roots = || nodes.iter().zip(&grids).filter(|(node, _)| node.parent == LightNode::NONE).map(|(_, grid)| grid);
    if roots().zip(roots().skip(1)).any(|(before, grid)| before >= grid) {
        return Err("a grid has more than one tree over its emitters".into());
    }
    Ok(())
}

/// Whether a node is a root or a child of its parent, which comes before it.
pub(super) fn finds_root(nodes: &[LightNode], at: usize) -> bool {
    let parent = nodes[at].parent as usize;
    let is_child_of = |node: &LightNode| node.count == 0 && [parent + 1, node.index as usize].contains(&at);
    nodes[at].parent == LightNode::NONE || parent < at && is_child_of(&nodes[parent])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use glam::{Mat3, Vec3};
    use voxtrace_scene::material::Material;
    use voxtrace_scene::transform::Transform;

    /// Twelve lamps of 300 emissive voxels each, turned about z.
    fn lamps() -> PackedScene {
        let mut scene = Scene::from_grid("lamps", VoxelGrid::new(), vec![Material::emissive(Vec3::ONE); 2]);
        for lamp in 0..12 {
            let mut grid = VoxelGrid::new();
            for voxel in 0..300 {
                grid.set(IVec3::new(voxel % 20 - 9, voxel / 20, (voxel * 7 + lamp) % 3), (voxel % 2) as u16);
            }
            let turned = Mat3::from_rotation_z(lamp as f32 * 0.3);
            let translation = Vec3::new((lamp % 4) as f32 * 50.0, (lamp / 4) as f32 * 70.0, 9.0);
            scene.add_instance(grid, Transform { linear: turned, translation });
        }
        PackedScene::pack(&scene).unwrap()
    }

    #[test]
    fn every_emitter_is_in_the_tree_and_faults_are_found() {
        let scene = lamps();
        let geometry = &**scene.geometry();
        assert_eq!(geometry.emitters.len(), 12 * 300);
        geometry.validate().unwrap();
        type Fault = fn(&mut Vec<Emitter>, &mut Vec<LightNode>);
        let faults: [Fault; 12] = [
            |emitters, _| emitters[5].faces = 64,
            |emitters, _| emitters[5].material = 2,
            |emitters, _| emitters[5].grid = 12,
            |emitters, _| emitters[5].grid = 1,
            |emitters, _| emitters.swap(4, 5),
            |emitters, _| emitters.iter_mut().for_each(|emitter| emitter.grid = 0),
            |emitters, _| emitters[5].leaf = u32::MAX,
            |emitters, _| _ = emitters.pop(),
            |_, nodes| nodes[0].index = nodes.len() as u32,
            |_, nodes| nodes[9].parent = 9,
            |_, nodes| nodes.last_mut().unwrap().count = 9,
            |_, nodes| nodes[1].parent = LightNode::NONE,
        ];
        for (which, fault) in faults.into_iter().enumerate() {
            let (mut emitters, mut nodes) = (geometry.emitters.to_vec(), geometry.light_nodes.to_vec());
            fault(&mut emitters, &mut nodes);
            let broken = Geometry { emitters: emitters.into(), light_nodes: nodes.into(), ..geometry.clone() };
            assert!(broken.validate().is_err(), "fault {which}");
        }
    }

    #[test]
    fn the_root_holds_the_power_of_all_free_faces() {
        let mut grid = VoxelGrid::new();
        // A row of two: ten free faces, then one of them covered.
        grid.set(IVec3::new(7, 0, 0), 0);
        grid.set(IVec3::new(8, 0, 0), 0);
        grid.set(IVec3::new(8, 0, 1), 1);
        let materials = vec![Material::emissive(Vec3::splat(2.0)), Material::default()];
        let mut scene = Scene::from_grid("row", grid, materials);
        scene.instances[0].world_from_grid.linear = Mat3::from_diagonal(Vec3::splat(3.0));
        let packed = PackedScene::pack(&scene).unwrap();
        let check = |root: &LightNode, scale: f32| {
            let expected = [1.0, 1.0, 2.0, 2.0, 2.0, 1.0].map(|faces| faces * 2.0 * scale * scale);
            let is_near = |(power, expected): (&f32, f32)| (power - expected).abs() < 1e-3;
            assert!(root.power.iter().zip(expected).all(is_near), "{root:?}");
            let (min, max) = (Vec3::new(7.0, 0.0, 0.0), Vec3::new(9.0, 1.0, 1.0));
            assert_eq!((root.min, root.max), (min * scale, max * scale));
        };
        check(&packed.geometry().light_nodes()[0], 1.0);
        check(&packed.placement().light_nodes()[0], 3.0);
        // Glass covers nothing: the eleventh face, whether it is packed so or becomes glass.
        let power = |packed: &PackedScene| packed.geometry().light_nodes()[0].power[5];
        let mut glassy = scene.clone();
        glassy.materials[1] = Material::glass(1.5, 0.0);
        let glassy = PackedScene::pack(&glassy).unwrap();
        assert!((power(&glassy) - 4.0).abs() < 1e-3, "{}", power(&glassy));
        let of = |scene: &PackedScene| packed.geometry().with_materials(scene.materials().to_vec());
        let lights = |geometry: &Geometry| (geometry.emitters().to_vec(), geometry.light_nodes().to_vec());
        assert_eq!(lights(&of(&glassy)), lights(glassy.geometry()));
        let back = glassy.geometry().with_materials(packed.materials().to_vec());
        assert_eq!(lights(&back), lights(packed.geometry()));
    }

    #[test]
    fn the_morton_order_is_that_of_interleaved_bits() {
        let interleaved = |voxel: IVec3| {
            let biased = (voxel + (1 << 20)).as_i64vec3();
            (0..21).fold(0i64, |code, bit| {
                let digit = biased.x >> bit & 1 | (biased.y >> bit & 1) << 1 | (biased.z >> bit & 1) << 2;
                code | digit << (3 * bit)
            })
        };
        let mut word = 1u32;
        let mut voxel = |size: i32| {
            let mut coordinate = || {
                word = word.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
                (word >> 12) as i32 % size - size / 2
            };
            IVec3::new(coordinate(), coordinate(), coordinate())
        };
        for size in [3, 40, 1 << 19] {
            for _ in 0..2000 {
                let (a, b) = (voxel(size), voxel(size));
                assert_eq!(morton_order(a, b), interleaved(a).cmp(&interleaved(b)), "{a} {b}");
            }
        }
    }
}
