//! The tree over the emitters of a grid, changed in place. Which nodes there are follows from the emitters alone ([`crate::packed`]): within cubes of voxels it is a
//! trie over the bits of their Morton order that ends where eight are left, so emitters that come and go change the nodes above them; the tree over cubes is
//! made anew. So the tree is that of packing from scratch all the time: the same ways down with the same probabilities, in other places of the arrays.
//!
//! A left child follows its parent. So a way down to the left, from a root or a right child to a leaf, its spine, is one piece of the array. Where many
//! emitters are new, small trees over them are made side by side, as packing makes them, and put into the arrays as pieces.

use super::store::{Store, put};
use crate::packed::{
    Emitter, LEAF_EMITTERS, LightNode, Shape, append_lights, cube_of, deciding_axis, leaf_of, morton_order,
    tree_of_cubes,
};
use glam::IVec3;
use std::borrow::Cow;

/// Emitters of which the tree is one piece.
pub(super) const BLOCK: usize = 128;
/// A subtree is made anew where it has at most so many times the emitters that change below it.
const FEW: usize = 2;

/// What becomes of a voxel as an emitter.
#[derive(Clone, Copy, Debug)]
pub(super) struct EmitterChange {
    pub voxel: IVec3,
    /// Whether it is in the tree.
    pub was: bool,
    /// What it is now, if it emits.
    pub now: Option<Emitter>,
}

/// A spine that was taken out of the arrays: its nodes from the top, how many emitters are below each, the emitters of its leaf.
#[derive(Clone, Default)]
struct Opened {
    nodes: Vec<LightNode>,
    below: Vec<u32>,
    leaf: Vec<Emitter>,
}

/// A spine that is made: the right children from the top, which are in the arrays, and the emitters of its leaf.
#[derive(Default)]
struct Spine {
    rights: Vec<u32>,
    leaf: Vec<Emitter>,
}

/// How many emitters there are more.
fn growth(changes: &[EmitterChange]) -> i64 {
    changes.iter().map(|change| i64::from(change.now.is_some()) - i64::from(change.was)).sum()
}

/// The bit in which two voxels differ first, as a number that is higher for earlier ones; none where they are the same.
fn rank(a: IVec3, b: IVec3) -> Option<(u32, usize)> {
    deciding_axis(a, b).map(|(axis, bit)| (bit, axis))
}

impl Store<'_> {
    /// Applies changes, in Morton order, to the tree with this root. Returns the root of the new tree, `None` where nothing emits.
    pub fn update_lights(&mut self, root: Option<u32>, changes: &[EmitterChange]) -> Option<u32> {
        if changes.is_empty() {
            return root;
        }
        let mut opened = root.map(|root| self.take_apart(root)).unwrap_or_default();
        let mut changed = changes.chunk_by(|a, b| cube_of(a.voxel) == cube_of(b.voxel)).peekable();
        let (mut roots, mut spines) = (Vec::new(), Vec::new());
        let mut add = |store: &Self, cube: IVec3, spine: Spine| {
            if !spine.leaf.is_empty() {
                roots.push((cube, store.root_of(&spine)));
                spines.push(spine);
            }
        };
        // Cubes that are there and cubes that change, both in Morton order.
        opened.sort_unstable_by(|a, b| morton_order(a.0, b.0));
        for (cube, opened) in opened {
            while let Some(changes) = changed.next_if(|it| morton_order(cube_of(it[0].voxel), cube).is_lt()) {
                let spine = self.grown(&Opened::default(), changes);
                add(self, cube_of(changes[0].voxel), spine);
            }
            let changes = changed.next_if(|it| cube_of(it[0].voxel) == cube).unwrap_or_default();
            let spine = self.grown(&opened, changes);
            add(self, cube, spine);
        }
        for changes in changed {
            let spine = self.grown(&Opened::default(), changes);
            add(self, cube_of(changes[0].voxel), spine);
        }
        if spines.is_empty() {
            return None;
        }
        let spine = self.spine_over(&tree_of_cubes(&roots), 0, &spines);
        self.commit(&spine)
    }

    /// Takes the tree with this root out of the arrays, but for what is right of the spines of cubes. Returns these, with their cubes.
    fn take_apart(&mut self, root: u32) -> Vec<(IVec3, Opened)> {
        let (mut cubes, mut waiting) = (Vec::new(), vec![root]);
        while let Some(head) = waiting.pop() {
            let mut opened = self.open(head);
            let is_in_cube = |node: &LightNode| cube_of(node.min.as_ivec3()) == cube_of(node.max.as_ivec3() - 1);
            let above = opened.nodes.iter().take_while(|node| !is_in_cube(node)).count();
            waiting.extend(opened.nodes[..above].iter().filter(|node| node.count == 0).map(|node| node.index));
            if above < opened.nodes.len() {
                opened.nodes.drain(..above);
                opened.below.drain(..above);
                cubes.push((cube_of(opened.leaf[0].voxel), opened));
                continue;
            }
            // Trees of older files have leaves that reach over several cubes.
            for emitters in opened.leaf.chunk_by(|a, b| cube_of(a.voxel) == cube_of(b.voxel)) {
                let nodes = vec![leaf_of(emitters, 0)];
                let leaf = Opened { nodes, below: vec![emitters.len() as u32], leaf: emitters.to_vec() };
                cubes.push((cube_of(emitters[0].voxel), leaf));
            }
        }
        cubes
    }

    /// The spine of a cube, after changes of its emitters.
    fn grown(&mut self, opened: &Opened, changes: &[EmitterChange]) -> Spine {
        let mut spine = Spine::default();
        self.grow_spine(opened, 0, changes, &mut spine);
        spine
    }

    /// The first node of a spine that is not in the arrays yet.
    fn root_of(&self, spine: &Spine) -> LightNode {
        let over = |node, right: &u32| LightNode::over(&node, *right, &self.geometry.light_nodes[*right as usize]);
        spine.rights.iter().rev().fold(leaf_of(&spine.leaf, 0), over)
    }

    /// The spine that begins at a node of the tree over cubes, of which these are the spines. What is right of it is put into the arrays.
    fn spine_over(&mut self, shape: &[Shape], mut at: usize, spines: &[Spine]) -> Spine {
        let mut spine = Spine::default();
        loop {
            match shape[at] {
                Shape::Inner(right) => {
                    let right = self.spine_over(shape, right as usize, spines);
                    spine.rights.extend(self.commit(&right));
                    at += 1;
                }
                Shape::Leaf(cube) => {
                    let Spine { rights, leaf } = &spines[cube as usize];
                    spine.rights.extend_from_slice(rights);
                    spine.leaf.clone_from(leaf);
                    return spine;
                }
            }
        }
    }

    /// Applies changes within a cube, in Morton order, to the subtree with this root. Returns the root of the new one, `None` where nothing emits.
    fn update_cube(&mut self, root: Option<u32>, changes: &[EmitterChange]) -> Option<u32> {
        if changes.is_empty() {
            return root;
        }
        let mut spine = Spine::default();
        let opened = root.map(|root| self.open(root)).unwrap_or_default();
        self.grow_spine(&opened, 0, changes, &mut spine);
        self.commit(&spine)
    }

    /// Appends to `spine` what of the opened spine is from `from` on, changed. All changes belong below or beside it.
    fn grow_spine(&mut self, opened: &Opened, from: usize, changes: &[EmitterChange], spine: &mut Spine) {
        let (mut opened, mut from, mut changes) = (Cow::Borrowed(opened), from, changes);
        loop {
            if changes.is_empty() {
                let inner = opened.nodes.len().saturating_sub(1);
                spine.rights.extend(opened.nodes[from.min(inner)..inner].iter().map(|node| node.index));
                spine.leaf.clone_from(&opened.leaf);
                return;
            }
            let before = opened.below.get(from).copied().unwrap_or(0);
            let after = i64::from(before) + growth(changes);
            let is_leaf = from + 1 >= opened.nodes.len();
            if is_leaf || after <= LEAF_EMITTERS as i64 || before as usize <= FEW * changes.len() {
                let mut all = Vec::with_capacity(after.max(0) as usize);
                self.gather_opened(&opened, from, &mut all);
                self.build_spine(&merged(&all, changes), spine);
                return;
            }
            let node = opened.nodes[from];
            let inside = opened.nodes[from + 1].min.as_ivec3();
            let own = rank(inside, self.geometry.light_nodes[node.index as usize].min.as_ivec3());
            let (first, last) = (changes[0].voxel, changes[changes.len() - 1].voxel);
            let outside = rank(first, inside).max(rank(last, inside));
            if let Some((bit, axis)) = outside.filter(|&outside| Some(outside) > own) {
                // Some lie beside the spine: a new node above it, with them on one side.
                let side = |voxel: IVec3| voxel[axis] >> bit;
                let until = |most: i32| changes.partition_point(|change| side(change.voxel) <= most);
                let (low, same) = (until(side(inside) - 1), until(side(inside)));
                if low == 0 {
                    let right = self.build_tree(&new_ones(&changes[same..]));
                    spine.rights.extend(right);
                    changes = &changes[..same];
                    continue;
                }
                let mut right = Spine::default();
                self.grow_spine(&opened, from, &changes[low..], &mut right);
                spine.rights.extend(self.commit(&right));
                self.build_spine(&new_ones(&changes[..low]), spine);
                return;
            }
            let (bit, axis) = own.expect("two children lie on two sides");
            let left = inside[axis] >> bit;
            let (low, high) = changes.split_at(changes.partition_point(|change| change.voxel[axis] >> bit <= left));
            let below_left = i64::from(opened.below[from + 1]);
            if below_left + growth(low) == 0 {
                let mut gone = Vec::new();
                self.gather_opened(&opened, from + 1, &mut gone);
                opened = Cow::Owned(self.open(node.index));
                (from, changes) = (0, high);
            } else if i64::from(before) - below_left + growth(high) == 0 {
                let mut gone = Vec::new();
                self.gather(node.index, &mut gone);
                (from, changes) = (from + 1, low);
            } else {
                let right = self.update_cube(Some(node.index), high).expect("something is left");
                spine.rights.push(right);
                (from, changes) = (from + 1, low);
            }
        }
    }

    /// Takes the spine that begins at a node out of the arrays.
    fn open(&mut self, head: u32) -> Opened {
        let mut opened = Opened::default();
        let (nodes, emitters) = (&self.geometry.light_nodes, &self.geometry.emitters);
        for at in head as usize.. {
            opened.nodes.push(nodes[at]);
            opened.below.push(self.below[at]);
            if nodes[at].count > 0 {
                let first = nodes[at].index as usize;
                opened.leaf.extend_from_slice(&emitters[first..first + nodes[at].count as usize]);
                self.pools.emitters.give(nodes[at].index, nodes[at].count);
                break;
            }
        }
        self.pools.light_nodes.give(head, opened.nodes.len() as u32);
        opened
    }

    /// Appends the emitters below a node, which is given back with all below it.
    fn gather(&mut self, head: u32, emitters: &mut Vec<Emitter>) {
        let geometry = &*self.geometry;
        let (nodes, all) = (&*geometry.light_nodes, &*geometry.emitters);
        let mut waiting = vec![head];
        while let Some(head) = waiting.pop() {
            let mut at = head as usize;
            while nodes[at].count == 0 {
                waiting.push(nodes[at].index);
                at += 1;
            }
            let LightNode { index, count, .. } = nodes[at];
            emitters.extend_from_slice(&all[index as usize..(index + count) as usize]);
            self.pools.emitters.give(index, count);
            self.pools.light_nodes.give(head, at as u32 - head + 1);
        }
    }

    fn gather_opened(&mut self, opened: &Opened, from: usize, emitters: &mut Vec<Emitter>) {
        emitters.extend_from_slice(&opened.leaf);
        for node in opened.nodes[from.min(opened.nodes.len())..].iter().rev().filter(|node| node.count == 0) {
            self.gather(node.index, emitters);
        }
    }

    /// Appends the tree over emitters, which are in Morton order.
    fn build_spine(&mut self, emitters: &[Emitter], spine: &mut Spine) {
        let mut left = emitters;
        while left.len() > LEAF_EMITTERS {
            let (low, high) = halves(left);
            let right = self.build_tree(high);
            spine.rights.extend(right);
            left = low;
        }
        spine.leaf = left.to_vec();
    }

    /// The tree over emitters of a cube, in Morton order. Returns its root, `None` where nothing emits.
    fn build_tree(&mut self, emitters: &[Emitter]) -> Option<u32> {
        match emitters.len() {
            0 => None,
            1..=BLOCK => Some(self.put_block(block_of(emitters))),
            _ => {
                let mut spine = Spine::default();
                self.build_spine(emitters, &mut spine);
                self.commit(&spine)
            }
        }
    }

    /// Puts a tree into the arrays. Returns its root.
    fn put_block(&mut self, mut block: Block) -> u32 {
        let head = self.pools.light_nodes.take(block.nodes.len() as u32);
        let first = self.pools.emitters.take(block.emitters.len() as u32);
        block.emitters.iter_mut().for_each(|emitter| emitter.leaf += head);
        for node in &mut block.nodes {
            node.index += if node.count > 0 { first } else { head };
            node.parent = if node.parent == LightNode::NONE { node.parent } else { node.parent + head };
        }
        put(&mut self.geometry.emitters, self.pools.emitters.end(), first as usize, &block.emitters);
        self.dirty.emitters.mark(first as usize, block.emitters.len());
        self.put_nodes(head, &block.nodes, &block.below);
        head
    }

    fn put_nodes(&mut self, head: u32, nodes: &[LightNode], below: &[u32]) {
        let head = head as usize;
        put(&mut self.geometry.light_nodes, self.pools.light_nodes.end(), head, nodes);
        self.dirty.light_nodes.mark(head, nodes.len());
        self.below.resize(self.geometry.light_nodes.len(), 0);
        self.below[head..head + nodes.len()].copy_from_slice(below);
    }

    /// Puts a spine into the arrays. Returns its first node, which is a root until it is given a parent; `None` where nothing emits.
    fn commit(&mut self, spine: &Spine) -> Option<u32> {
        if spine.leaf.is_empty() {
            return None;
        }
        let length = spine.rights.len() + 1;
        let head = self.pools.light_nodes.take(length as u32);
        let first = self.pools.emitters.take(spine.leaf.len() as u32);
        let mut leaf = spine.leaf.clone();
        leaf.iter_mut().for_each(|emitter| emitter.leaf = head + length as u32 - 1);
        put(&mut self.geometry.emitters, self.pools.emitters.end(), first as usize, &leaf);
        self.dirty.emitters.mark(first as usize, leaf.len());
        let mut nodes = vec![leaf_of(&leaf, first as usize); length];
        let mut below = vec![leaf.len() as u32; length];
        for at in (0..length - 1).rev() {
            let right = spine.rights[at];
            nodes[at] = LightNode::over(&nodes[at + 1], right, &self.geometry.light_nodes[right as usize]);
            below[at] = below[at + 1] + self.below[right as usize];
            nodes[at + 1].parent = head + at as u32;
            self.set_parent(right, head + at as u32);
        }
        self.put_nodes(head, &nodes, &below);
        Some(head)
    }

    fn set_parent(&mut self, node: u32, parent: u32) {
        if self.geometry.light_nodes[node as usize].parent != parent {
            self.geometry.light_nodes.as_mut()[node as usize].parent = parent;
            self.dirty.light_nodes.mark(node as usize, 1);
        }
    }
}

/// A small tree by itself.
struct Block {
    nodes: Vec<LightNode>,
    below: Vec<u32>,
    emitters: Vec<Emitter>,
}

fn block_of(emitters: &[Emitter]) -> Block {
    let mut block = Block { nodes: Vec::with_capacity(emitters.len()), below: Vec::new(), emitters: Vec::new() };
    append_lights(emitters.to_vec(), &mut block.emitters, &mut block.nodes);
    block.below = counts_below(&block.nodes);
    block
}

/// Emitters that become a left and a right child.
fn halves(emitters: &[Emitter]) -> (&[Emitter], &[Emitter]) {
    let (low, high) = (emitters[0].voxel, emitters[emitters.len() - 1].voxel);
    let (axis, bit) = deciding_axis(low, high).expect("no emitter is there twice");
    emitters.split_at(emitters.partition_point(|emitter| emitter.voxel[axis] >> bit == low[axis] >> bit))
}

/// The emitters that come, none of which was there.
fn new_ones(changes: &[EmitterChange]) -> Vec<Emitter> {
    changes.iter().filter_map(|change| change.now).collect()
}

/// Emitters with changes, both in Morton order.
fn merged(emitters: &[Emitter], changes: &[EmitterChange]) -> Vec<Emitter> {
    let mut merged = Vec::with_capacity(emitters.len() + changes.len());
    let mut rest = emitters.iter().peekable();
    for change in changes {
        while let Some(emitter) = rest.next_if(|emitter| morton_order(emitter.voxel, change.voxel).is_lt()) {
            merged.push(*emitter);
        }
        rest.next_if(|emitter| emitter.voxel == change.voxel);
        merged.extend(change.now);
    }
    merged.extend(rest);
    merged
}

/// How many emitters are below each node.
pub(super) fn counts_below(nodes: &[LightNode]) -> Vec<u32> {
    let mut below = vec![0; nodes.len()];
    // Children come after their parents where nothing was changed yet.
    for (at, node) in nodes.iter().enumerate().rev() {
        below[at] = if node.count > 0 { node.count } else { below[at + 1] + below[node.index as usize] };
    }
    below
}
