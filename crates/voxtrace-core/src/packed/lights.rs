//! The emitters of a scene and the tree over them: for each instance a tree that halves the Morton order of its emissive
//! voxels (Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees", HPG 2012), and over
//! their roots a tree by medians. A node's powers along the six axes stand in for the cone of normals of Conty Estevez
//! and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting" (HPG 2018).

use super::{Emitter, LEAF_EMITTERS, LightNode, PackedInstance, PackedScene};
use crate::math::luminance;
use crate::surface::{faces_of, world_normal};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::ray::FACES;
use voxtrace_scene::scene::Scene;

/// An emissive voxel of a grid: where it is, its free faces and its material.
type GridEmitter = (IVec3, u32, u16);

/// Finds the emitters of the packed `instances` of `scene` and builds the tree over them; both are empty where nothing
/// emits. Emitters are ordered by instance and [`morton_order`].
pub(super) fn lights_of(scene: &Scene, instances: &[PackedInstance]) -> (Vec<Emitter>, Vec<LightNode>) {
    let luminances: Vec<f32> = scene.materials.iter().map(|material| luminance(material.emission)).collect();
    let grid_of = |instance: &PackedInstance| scene.instances[instance.scene_instance as usize].grid;
    let mut used: Vec<usize> = instances.iter().map(grid_of).collect();
    used.sort_unstable();
    used.dedup();
    let of_grid: FxHashMap<usize, Vec<GridEmitter>> =
        used.into_iter().map(|grid| (grid, grid_emitters(&scene.grids[grid], &luminances))).collect();

    let (mut emitters, mut subtrees) = (Vec::new(), Vec::new());
    for (index, instance) in instances.iter().enumerate() {
        let first = emitters.len();
        emitters.extend(of_grid[&grid_of(instance)].iter().map(|&(voxel, faces, material)| Emitter {
            voxel,
            instance: index as u32,
            faces,
            material: material.into(),
            luminance: luminances[usize::from(material)],
            leaf: 0,
        }));
        if emitters.len() > first {
            let mut nodes = Vec::new();
            split(instance, &emitters[first..], first, &mut nodes);
            subtrees.push(nodes);
        }
    }
    let mut nodes = Vec::new();
    if !subtrees.is_empty() {
        join(&mut subtrees.iter().collect::<Vec<_>>(), &mut nodes);
    }
    link(&mut nodes, &mut emitters);
    (emitters, nodes)
}

/// As [`lights_of`], for a packed scene of one grid and one instance that has no emitters yet; `emitting` are the voxels
/// whose material emits.
pub(super) fn lights_of_grid(scene: &PackedScene, emitting: Vec<(IVec3, u16)>) -> (Vec<Emitter>, Vec<LightNode>) {
    let (grid, instance) = (&scene.grids[0], &scene.instances[0]);
    let is_free = |voxel: IVec3| scene.material_at(grid, voxel).is_none();
    let mut emitters: Vec<Emitter> = emitting
        .into_par_iter()
        .map(|(voxel, material)| Emitter {
            voxel,
            instance: 0,
            faces: FACES.iter().map(|&face| u32::from(is_free(voxel + face.normal())) << face as u32).sum(),
            material: material.into(),
            luminance: luminance(scene.materials[usize::from(material)].emission),
            leaf: 0,
        })
        .filter(|emitter| emitter.faces != 0)
        .collect();
    emitters.par_sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
    let mut nodes = Vec::new();
    if !emitters.is_empty() {
        split(instance, &emitters, 0, &mut nodes);
    }
    link(&mut nodes, &mut emitters);
    (emitters, nodes)
}

/// The emissive voxels with a free face, in [`morton_order`].
fn grid_emitters(grid: &VoxelGrid, luminances: &[f32]) -> Vec<GridEmitter> {
    let emits = |material: u16| luminances[usize::from(material)] > 0.0;
    let mut emitters: Vec<GridEmitter> = grid
        .sorted_bricks()
        .into_par_iter()
        .filter(|(_, brick)| brick.materials().iter().any(|&material| emits(material)))
        .flat_map_iter(|(at, brick)| {
            let emissive = brick.voxels().filter(move |&(_, material)| emits(material));
            emissive.map(move |(local, material)| {
                (at * BRICK_SIZE + local, free_faces(grid, at * BRICK_SIZE, brick, local), material)
            })
        })
        .filter(|&(_, faces, _)| faces != 0)
        .collect();
    emitters.par_sort_unstable_by(|a, b| morton_order(a.0, b.0));
    emitters
}

/// Bit f is set where the neighbour at face f of the voxel `local` of `brick`, whose lowest voxel is `corner`, is empty.
fn free_faces(grid: &VoxelGrid, corner: IVec3, brick: &Brick, local: IVec3) -> u32 {
    let is_free = |neighbour: IVec3| {
        let inside = neighbour.cmpge(IVec3::ZERO).all() && neighbour.cmplt(IVec3::splat(BRICK_SIZE)).all();
        if inside { brick.get(neighbour).is_none() } else { grid.get(corner + neighbour).is_none() }
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
fn deciding_axis(a: IVec3, b: IVec3) -> Option<(usize, u32)> {
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

/// Appends the tree over `emitters`, the first of which has the number `first`, of one instance.
fn split(instance: &PackedInstance, emitters: &[Emitter], first: usize, nodes: &mut Vec<LightNode>) {
    if emitters.len() <= LEAF_EMITTERS {
        nodes.push(leaf(instance, emitters, first));
        return;
    }
    let (low, high) = (emitters[0].voxel, emitters[emitters.len() - 1].voxel);
    let (axis, bit) = deciding_axis(low, high).expect("voxels of one instance differ");
    let middle = emitters.partition_point(|emitter| emitter.voxel[axis] >> bit == low[axis] >> bit);
    let node = nodes.len();
    nodes.push(LightNode::EMPTY);
    split(instance, &emitters[..middle], first, nodes);
    let right = nodes.len();
    split(instance, &emitters[middle..], first + middle, nodes);
    nodes[node] = inner(nodes, node, right);
}

/// Appends the tree over whole subtrees.
fn join(subtrees: &mut [&Vec<LightNode>], nodes: &mut Vec<LightNode>) {
    let start = nodes.len();
    if let [only] = subtrees {
        nodes.extend(only.iter().map(|&node| match node.count {
            0 => LightNode { index: node.index + start as u32, ..node },
            _ => node,
        }));
        return;
    }
    let center = |nodes: &[LightNode]| nodes[0].min + nodes[0].max;
    let (low, high) = subtrees.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), nodes| {
        (low.min(center(nodes)), high.max(center(nodes)))
    });
    let axis = (high - low).max_position();
    // The sort is stable, so equal centres stay in the order of their instances.
    subtrees.sort_by(|a, b| center(a)[axis].total_cmp(&center(b)[axis]));
    let (left, right) = subtrees.split_at_mut(subtrees.len() / 2);
    nodes.push(LightNode::EMPTY);
    join(left, nodes);
    let at = nodes.len();
    join(right, nodes);
    nodes[start] = inner(nodes, start, at);
}

fn leaf(instance: &PackedInstance, emitters: &[Emitter], first: usize) -> LightNode {
    let linear = instance.world_from_grid.linear;
    let half = (linear.x_axis.abs() + linear.y_axis.abs() + linear.z_axis.abs()) * 0.5;
    let area = linear.x_axis.length_squared();
    let mut node = LightNode { index: first as u32, count: emitters.len() as u32, ..LightNode::EMPTY };
    for emitter in emitters {
        let center = instance.world_from_grid.point(emitter.voxel.as_vec3() + 0.5);
        (node.min, node.max) = (node.min.min(center - half), node.max.max(center + half));
        for face in faces_of(emitter.faces) {
            // A face that looks between the axes counts fully along each of them in turn: the sum is never less than
            // what it sends in any direction.
            let normal = world_normal(instance, face);
            for axis in 0..3 {
                let side = 2 * axis + usize::from(normal[axis] > 0.0);
                node.power[side] += normal[axis].abs() * area * emitter.luminance;
            }
        }
    }
    node
}

fn inner(nodes: &[LightNode], node: usize, right: usize) -> LightNode {
    let (left, right_node) = (&nodes[node + 1], &nodes[right]);
    LightNode {
        min: left.min.min(right_node.min),
        max: left.max.max(right_node.max),
        power: std::array::from_fn(|side| left.power[side] + right_node.power[side]),
        index: right as u32,
        ..LightNode::EMPTY
    }
}

/// Tells each node its parent and each emitter its leaf.
fn link(nodes: &mut [LightNode], emitters: &mut [Emitter]) {
    for at in 0..nodes.len() {
        let (index, count) = (nodes[at].index as usize, nodes[at].count as usize);
        if count == 0 {
            nodes[at + 1].parent = at as u32;
            nodes[index].parent = at as u32;
        } else {
            emitters[index..index + count].iter_mut().for_each(|emitter| emitter.leaf = at as u32);
        }
    }
}

/// Checks that emitters and tree hold together: every index lies inside its array, and every node is reached from the
/// root and finds its way back.
///
/// # Errors
/// One sentence about the first fault.
pub(super) fn validate_lights(scene: &PackedScene) -> Result<(), String> {
    let (nodes, emitters) = (&*scene.light_nodes, &*scene.emitters);
    let leaf_of = |emitter: &Emitter| nodes.get(emitter.leaf as usize).filter(|leaf| leaf.count > 0);
    for (index, emitter) in emitters.iter().enumerate() {
        let is_inside = (emitter.material as usize) < scene.materials.len()
            && (emitter.instance as usize) < scene.instances.len()
            && emitter.faces >> 6 == 0;
        let is_in_leaf = leaf_of(emitter).is_some_and(|leaf| {
            let first = leaf.index as usize;
            (first..first + leaf.count as usize).contains(&index) && emitters[first].instance == emitter.instance
        });
        if !is_inside || !is_in_leaf {
            return Err(format!("emitter {index} points outside"));
        }
    }
    for (at, node) in nodes.iter().enumerate() {
        let (index, count) = (node.index as usize, node.count as usize);
        let is_sound = match count {
            // The left child follows its parent, the right one comes later: the tree has no cycle.
            0 => index > at + 1 && index < nodes.len(),
            _ => count <= LEAF_EMITTERS && index + count <= emitters.len() && emitters[index].leaf as usize == at,
        };
        let is_child_of =
            |parent: &LightNode| parent.count == 0 && [node.parent + 1, parent.index].contains(&(at as u32));
        let finds_root = match at {
            0 => node.parent == LightNode::NONE,
            _ => (node.parent as usize) < at && is_child_of(&nodes[node.parent as usize]),
        };
        if !is_sound || !finds_root {
            return Err(format!("node {at} of the tree over emitters points outside"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Mat3;
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
        assert_eq!(scene.emitters.len(), 12 * 300);
        scene.validate().unwrap();
        type Fault = fn(&mut Vec<Emitter>, &mut Vec<LightNode>);
        let faults: [Fault; 8] = [
            |emitters, _| emitters[5].faces = 64,
            |emitters, _| emitters[5].material = 2,
            |emitters, _| emitters[5].instance = 12,
            |emitters, _| emitters[5].leaf = u32::MAX,
            |emitters, _| _ = emitters.pop(),
            |_, nodes| nodes[0].index = nodes.len() as u32,
            |_, nodes| nodes[9].parent = 9,
            |_, nodes| nodes.last_mut().unwrap().count = 9,
        ];
        for (which, fault) in faults.into_iter().enumerate() {
            let (mut emitters, mut nodes) = (scene.emitters.to_vec(), scene.light_nodes.to_vec());
            fault(&mut emitters, &mut nodes);
            let broken = PackedScene { emitters: emitters.into(), light_nodes: nodes.into(), ..scene.clone() };
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
        let root = packed.light_nodes[0];
        let expected = [1.0, 1.0, 2.0, 2.0, 2.0, 1.0].map(|faces| faces * 2.0 * 9.0);
        assert!(root.power.iter().zip(expected).all(|(power, expected)| (power - expected).abs() < 1e-3), "{root:?}");
        assert_eq!((root.min, root.max), (Vec3::new(21.0, 0.0, 0.0), Vec3::new(27.0, 3.0, 3.0)));
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
