//! The emitters of each grid and the tree over them, which all instances of the grid share, in the space of the grid. Below, within
//! cubes of two to the power of [`CUBE_SHIFT`] voxels, it halves the Morton order of the emissive voxels (Karras, "Maximizing Parallelism in the Construction
//! of BVHs, Octrees, and k-d Trees", HPG 2012), so that edits change little of it; above, planes between cubes are those of the least cost: power times
//! the square of how far it is spread, which is what a choice among far nodes gets wrong. A node's powers along the six axes stand in for the cone of normals of Conty Estevez
//! and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting" (HPG 2018), whose trees have such a cost, too.
//!
//! What is called in several places is kept out of line: the module for pages, which is optimized for speed here, has few bytes to spare.

use super::sah_tree::{Boxes, Shape};
use super::{Emitter, Geometry, LEAF_EMITTERS, LightNode, MAX_INSTANCE_DEPTH, PackedGrid, PackedMaterial};
use crate::math::luminance;
use crate::surface::faces_of;
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use std::cmp::Ordering;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::ray::FACES;
use voxtrace_scene::scene::Scene;

/// The width of cubes of voxels, whose emitters have a subtree of their own, is two to the power of this.
pub(crate) const CUBE_SHIFT: i32 = 4;

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
    append_tree(&emitters[first..], first, nodes);
    link(root, nodes, emitters);
}

/// Emitters, and a tree over those of each grid, that follow from the emitters alone, whatever tree a scene has: that of files before there were cubes.
/// What stands for the lights of a scene in its hash.
pub(super) fn halved(emitters: &[Emitter]) -> (Vec<Emitter>, Vec<LightNode>) {
    let (mut emitters, mut nodes) = (emitters.to_vec(), Vec::new());
    let mut first = 0;
    for of_grid in emitters.chunk_by(|a, b| a.grid == b.grid) {
        split(of_grid, first, &mut nodes);
        first += of_grid.len();
    }
    link(0, &mut nodes, &mut emitters);
    (emitters, nodes)
}

/// The cube of a voxel.
pub(crate) fn cube_of(voxel: IVec3) -> IVec3 {
    voxel >> CUBE_SHIFT
}

/// What a node sends along all six directions.
fn power_of(node: &LightNode) -> f32 {
    node.power.iter().sum()
}

/// The square of how far what emits is spread over a box of this size.
fn spread_of(size: Vec3) -> f32 {
    size.length_squared()
}

/// The shape of the tree of least cost over these nodes, which planes part by their `places`, and by these alone where it is `by_planes`.
pub(super) fn tree_over(nodes: &[LightNode], places: &[Vec3], by_planes: bool) -> Vec<Shape> {
    let boxes: Vec<(Vec3, Vec3)> = nodes.iter().map(|node| (node.min, node.max)).collect();
    let weights: Vec<f32> = nodes.iter().map(power_of).collect();
    let (boxes, weights, most_levels) = (&boxes, &weights, MAX_INSTANCE_DEPTH);
    Boxes { boxes, places, weights, measure: spread_of, most_levels, by_planes }.tree()
}

/// The shape of the tree over cubes: for each, where it is and the root of its subtree.
pub(crate) fn tree_of_cubes(cubes: &[(IVec3, LightNode)]) -> Vec<Shape> {
    let low = cubes.iter().fold(IVec3::MAX, |low, (cube, _)| low.min(*cube));
    let places: Vec<Vec3> = cubes.iter().map(|(cube, _)| (cube - low).as_vec3()).collect();
    let roots: Vec<LightNode> = cubes.iter().map(|(_, root)| *root).collect();
    // A way down finds an emitter by which side it is on.
    tree_over(&roots, &places, true)
}

/// Appends the tree over `emitters`, the first of which has the number `first`, of one grid.
fn append_tree(emitters: &[Emitter], first: usize, nodes: &mut Vec<LightNode>) {
    // The voxels of a cube follow each other in Morton order.
    let (mut start, mut roots, mut trees) = (first, Vec::new(), Vec::new());
    for cube in emitters.chunk_by(|a, b| cube_of(a.voxel) == cube_of(b.voxel)) {
        let mut tree = Vec::new();
        split(cube, start, &mut tree);
        roots.push((cube_of(cube[0].voxel), tree[0]));
        trees.push(tree);
        start += cube.len();
    }
    let shape = tree_of_cubes(&roots);
    append_shape(&shape, 0, &trees, nodes);
}

/// Appends the part of the tree over cubes that begins at a node of its shape.
fn append_shape(shape: &[Shape], at: usize, trees: &[Vec<LightNode>], nodes: &mut Vec<LightNode>) {
    let node = nodes.len();
    match shape[at] {
        Shape::Leaf(cube) => nodes.extend(trees[cube as usize].iter().map(|own| match own.count {
            0 => LightNode { index: own.index + node as u32, ..*own },
            _ => *own,
        })),
        Shape::Inner(right_shape) => {
            nodes.push(LightNode::EMPTY);
            append_shape(shape, at + 1, trees, nodes);
            let right = nodes.len();
            append_shape(shape, right_shape as usize, trees, nodes);
            nodes[node] = LightNode::over(&nodes[node + 1], right as u32, &nodes[right]);
        }
    }
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

/// Appends the tree that halves the Morton order of `emitters`, the first of which has the number `first`.
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
#[inline(never)]
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
    #[inline(never)]
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
#[inline(never)]
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
pub(crate) mod tests {
    use super::*;
    use crate::light::{EmitterTree, Receiver};
    use crate::packed::{PackedScene, Placement};
    use glam::Mat3;
    use std::sync::Arc;
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

    /// The scene with the trees of older files.
    pub(crate) fn with_halved_trees(packed: &PackedScene) -> PackedScene {
        let (emitters, nodes) = halved(packed.geometry().emitters());
        let geometry =
            Geometry { emitters: emitters.into(), light_nodes: nodes.into(), ..(**packed.geometry()).clone() };
        geometry.validate().unwrap();
        let geometry = geometry.finished();
        let placement = Placement::of_sound(&geometry, packed.placement().instances().to_vec());
        PackedScene { geometry: Arc::new(geometry), placement, ..packed.clone() }
    }

    /// Emissive voxels at these places, of one luminance.
    fn lit(places: impl IntoIterator<Item = IVec3>) -> PackedScene {
        let mut grid = VoxelGrid::new();
        places.into_iter().for_each(|place| _ = grid.set(place, 0));
        PackedScene::pack(&Scene::from_grid("lit", grid, vec![Material::emissive(Vec3::ONE)])).unwrap()
    }

    /// Two walls of windows, a floor with lamps between them, and places beside some of the lamps, with their normals.
    fn hall() -> (PackedScene, Vec<Receiver>) {
        let wall = |x: i32| (0..24).flat_map(move |y| (0..20).map(move |z| IVec3::new(x, 10 * y + z % 2, 20 + 2 * z)));
        let lamp = |at: IVec3| (0..27).map(move |i| at + IVec3::new(i % 3, i / 3 % 3, i / 9));
        let at = |i: i32| IVec3::new(37 * (i % 5) + 20, 41 * (i / 5) + 15, 2);
        let scene = lit(wall(0).chain(wall(200)).chain((0..30).flat_map(|i| lamp(at(i)))));
        let beside = |i: i32| {
            let point = at(i).as_vec3() + Vec3::new(5.0 + (i % 3) as f32, 1.5, -1.5);
            Receiver::on_surface(point, if i % 2 == 0 { Vec3::Z } else { Vec3::NEG_X })
        };
        (scene, (0..30).map(beside).collect())
    }

    /// How much the light that one chosen emitter gives varies: the variance over the square of the mean, the mean over the receivers.
    fn variance(scene: &PackedScene, receivers: &[Receiver]) -> f64 {
        let tree = EmitterTree { scene, intensity: 1.0 };
        let of = |receiver: &Receiver| {
            let (mut sum, mut squares, count) = (0.0, 0.0, 20_000);
            for i in 0..count {
                let u = [0.754_877_7, 0.569_840_3, 0.430_159_7, 0.324_717_9]
                    .map(|step| (f64::from(i) * step).fract() as f32);
                let sample = tree.sample(receiver, u).map_or(0.0, |light| f64::from(light.cos_theta / light.pdf));
                (sum, squares) = (sum + sample, squares + sample * sample);
            }
            squares * f64::from(count) / (sum * sum) - 1.0
        };
        receivers.iter().map(of).sum::<f64>() / receivers.len() as f64
    }

    #[test]
    fn lamps_beside_a_place_are_chosen_for_it() {
        let (scene, receivers) = hall();
        let (ours, before) = (variance(&scene, &receivers), variance(&with_halved_trees(&scene), &receivers));
        // Without the part that is by nearest emitters: 9.7 and 4.9.
        assert!(ours < 2.5 && before < 2.5, "{ours}, {before} by trees of older files");
    }

    #[test]
    fn two_children_lie_on_two_sides_of_a_plane_wherever_emitters_are() {
        let mut word = 1u32;
        let mut next = |below: i32| {
            word = word.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (word >> 8) as i32 % below
        };
        let scattered: Vec<IVec3> =
            (0..3000).map(|_| IVec3::new(next(900) - 450, next(60) - 30, next(300) - 150)).collect();
        // Each twice as far away as the one before: what makes chains.
        let chain = (0..20).map(|i| IVec3::new(1 << i, 0, 0)).collect();
        for places in [scattered, chain, vec![IVec3::ZERO]] {
            let scene = lit(places.iter().copied());
            scene.validate().unwrap();
            let nodes = scene.geometry().light_nodes();
            for (at, node) in nodes.iter().enumerate().filter(|(_, node)| node.count == 0) {
                let (left, right) = (&nodes[at + 1], &nodes[node.index as usize]);
                assert!(left.max.cmple(right.min).any() || right.max.cmple(left.min).any(), "{left:?} {right:?}");
            }
            // Within cubes it is the tree of older files.
            let in_cubes = |scene: &PackedScene| {
                let is_in_cube = |node: &&LightNode| {
                    node.count > 0 || cube_of(node.min.as_ivec3()) == cube_of(node.max.as_ivec3() - 1)
                };
                scene.geometry().light_nodes().iter().filter(is_in_cube).count()
            };
            assert!(in_cubes(&scene) >= in_cubes(&with_halved_trees(&scene)));
        }
    }

    #[test]
    fn a_scene_is_the_same_by_whatever_tree_its_lights_are_chosen() {
        let (scene, _) = hall();
        let before = with_halved_trees(&scene);
        assert_ne!(scene.geometry().light_nodes(), before.geometry().light_nodes());
        assert_eq!(scene.content_hash(), before.content_hash());
        // A planted fault: another light is another scene.
        let mut emitters = scene.geometry().emitters().to_vec();
        emitters[7].luminance *= 2.0;
        let geometry = Geometry { emitters: emitters.into(), ..(**scene.geometry()).clone() };
        assert_ne!(PackedScene { geometry: Arc::new(geometry), ..scene.clone() }.content_hash(), scene.content_hash());
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
