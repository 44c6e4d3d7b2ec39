//! What hangs together with a voxel, across faces and within its object: counted brick by brick on a thread, eight words of 64 voxels at a
//! time. Where the scene is cut open, voxels whose middle is cut away count as gone.

use super::values::Value;
use crate::scale::Quantity;
use crate::threads;
use crate::tr;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::packed::{PackedGrid, PackedInstance};
use voxtrace::{Hit, PackedScene};

/// Most bricks that are remembered: a gibibyte.
const MOST_BRICKS: usize = 4 << 20;
/// The six directions, as neighbours of a brick.
const SIDES: [IVec3; 6] = [IVec3::NEG_X, IVec3::X, IVec3::NEG_Y, IVec3::Y, IVec3::NEG_Z, IVec3::Z];
/// Bits of a layer at its least x, its greatest, and the same of y.
const X_LOW: u64 = 0x0101_0101_0101_0101;
const X_HIGH: u64 = X_LOW << 7;
const Y_LOW: u64 = 0xff;
const Y_HIGH: u64 = Y_LOW << 56;

/// What was found of a component.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Voxels.
    pub voxels: u64,
    /// Cubic voxels of the world.
    pub volume: f64,
    /// Area of the faces with nothing before them, square voxels of the world.
    pub exposed: f64,
    /// A corner of the box around it, world space.
    pub corner: DVec3,
    /// The edges of that box from there.
    pub edges: [DVec3; 3],
}

impl Component {
    /// Its numbers.
    pub fn values(&self) -> Vec<Value> {
        let [x, y, z] = self.edges.map(|edge| edge.length());
        let value = |name, quantity, number| Value { name, quantity, number };
        vec![
            value("volume", Quantity::Volume, self.volume),
            value("voxels", Quantity::Count, self.voxels as f64),
            value("exposed area", Quantity::Area, self.exposed),
            value("size x", Quantity::Length, x),
            value("size y", Quantity::Length, y),
            value("size z", Quantity::Length, z),
        ]
    }

    /// Corners of the box around it.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        (0..8).map(|number| {
            let along = |axis: usize| if number >> axis & 1 == 1 { self.edges[axis] } else { DVec3::ZERO };
            self.corner + along(0) + along(1) + along(2)
        })
    }
}

/// Voxels that are being counted on a thread.
pub struct Flood {
    /// Where it was clicked, world space.
    pub point: DVec3,
    found: Arc<AtomicU64>,
    is_over: Arc<AtomicBool>,
    result: Receiver<Result<Component, String>>,
}

impl Drop for Flood {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
    }
}

impl Flood {
    /// Begins at the voxel of a hit.
    pub fn start(scene: Arc<PackedScene>, hit: Hit, point: DVec3, by_material: bool) -> Self {
        let (found, is_over) = (Arc::<AtomicU64>::default(), Arc::<AtomicBool>::default());
        let (sender, result) = channel();
        let (of_thread, over) = (Arc::clone(&found), Arc::clone(&is_over));
        std::thread::spawn(move || {
            threads::yield_to_window();
            let counted = catch_unwind(AssertUnwindSafe(|| component_of(&scene, &hit, by_material, &of_thread, &over)));
            // The window may be closed.
            let _ = sender.send(counted.unwrap_or_else(|_| Err(tr!("said.voxels_not_counted").into())));
        });
        Self { point, found, is_over, result }
    }

    /// Voxels found so far.
    pub fn found(&self) -> u64 {
        self.found.load(Ordering::Relaxed)
    }

    /// What came of it, once it is done.
    pub fn take(&self) -> Option<Result<Component, String>> {
        match self.result.try_recv() {
            Ok(result) => Some(result),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(tr!("said.voxels_not_counted").into())),
        }
    }
}

/// What hangs together with the voxel of a hit, of its material alone if `by_material`. `found` tells how far it is, and `is_over` ends it.
///
/// # Errors
/// One line: it is too large, or was ended.
pub fn component_of(
    scene: &PackedScene,
    hit: &Hit,
    by_material: bool,
    found: &AtomicU64,
    is_over: &AtomicBool,
) -> Result<Component, String> {
    // Of the clicked object alone, also where objects were merged.
    let apart = scene.is_merged().then(|| threads::aside(|| scene.split()));
    let whole = apart.as_ref().unwrap_or(scene);
    let instance = *whole.instances().get(hit.instance as usize).ok_or(tr!("measure.gone"))?;
    let grid = whole.grids()[instance.grid as usize];
    let material = by_material.then(|| scene.material_index(hit));
    let mut search = Search { scene: whole, cuts: scene, grid, instance, material, cells: HashMap::new() };
    search.run(hit.voxel, found, is_over)?;
    Ok(search.summed())
}

/// A brick: eight layers of 64 voxels each, x fastest.
type Layers = [u64; 8];

/// What is known of a brick.
#[derive(Clone, Default)]
struct Cell {
    /// Voxels that are there.
    solid: Layers,
    /// Those of them that may belong to the component.
    allowed: Layers,
    /// Those that do.
    reached: Layers,
    /// Those from which it spreads next.
    pending: Layers,
}

struct Search<'a> {
    scene: &'a PackedScene,
    /// Whose cuts hold.
    cuts: &'a PackedScene,
    grid: PackedGrid,
    instance: PackedInstance,
    material: Option<u32>,
    cells: HashMap<IVec3, Cell>,
}

impl Search<'_> {
    fn run(&mut self, from: IVec3, found: &AtomicU64, is_over: &AtomicBool) -> Result<(), String> {
        let (brick, local) = (from >> 3, from & 7);
        self.cell(brick).pending[local.z as usize] |= 1 << (local.x + 8 * local.y);
        let mut queue = vec![brick];
        while let Some(brick) = queue.pop() {
            if is_over.load(Ordering::Relaxed) {
                return Err(tr!("measure.stopped").into());
            }
            if self.cells.len() > MOST_BRICKS {
                let most = crate::scale::grouped(found.load(Ordering::Relaxed) as f64, 0);
                return Err(tr!("measure.too_many", most = most));
            }
            let cell = self.cell(brick);
            let new = spread(std::mem::take(&mut cell.pending), &cell.allowed, &cell.reached);
            if new == [0; 8] {
                continue;
            }
            for (reached, new) in cell.reached.iter_mut().zip(new) {
                *reached |= new;
            }
            found.fetch_add(new.iter().map(|layer| u64::from(layer.count_ones())).sum(), Ordering::Relaxed);
            for (side, step) in SIDES.into_iter().enumerate() {
                let over = over_side(&new, side);
                if over == [0; 8] {
                    continue;
                }
                let cell = self.cell(brick + step);
                let mut is_new = 0;
                for (layer, over) in over.into_iter().enumerate() {
                    let seeds = over & cell.allowed[layer] & !cell.reached[layer];
                    cell.pending[layer] |= seeds;
                    is_new |= seeds;
                }
                if is_new != 0 {
                    queue.push(brick + step);
                }
            }
        }
        Ok(())
    }

    /// What is known of a brick, which is looked up first.
    fn cell(&mut self, at: IVec3) -> &mut Cell {
        match self.cells.entry(at) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let mut cell = Cell::default();
                let geometry = self.scene.geometry();
                if let Some(record) = geometry.find_brick(&self.grid, at * 8) {
                    cell.solid = layers_of(geometry.bricks(), record);
                    let (cuts, world) = (&self.cuts.cuts, &self.instance.world_from_grid);
                    if !cuts.is_none() {
                        let keeps = |local: IVec3| cuts.keeps(world.point((at * 8 + local).as_vec3() + 0.5));
                        cell.solid = filtered(&cell.solid, keeps);
                    }
                    cell.allowed = match self.material {
                        None => cell.solid,
                        Some(own) => {
                            filtered(&cell.solid, |local| geometry.material_at(&self.grid, at * 8 + local) == Some(own))
                        }
                    };
                }
                entry.insert(cell)
            }
        }
    }

    /// The sums over all that was reached.
    fn summed(&self) -> Component {
        let (mut voxels, mut faces) = (0u64, 0u64);
        let (mut min, mut max) = (IVec3::MAX, IVec3::MIN);
        for (at, cell) in self.cells.iter().filter(|(_, cell)| cell.reached != [0; 8]) {
            voxels += cell.reached.iter().map(|layer| u64::from(layer.count_ones())).sum::<u64>();
            let (low, high) = extent(&cell.reached);
            (min, max) = (min.min(*at * 8 + low), max.max(*at * 8 + high));
            for (side, step) in SIDES.into_iter().enumerate() {
                let solid = self.cells.get(&(*at + step)).map_or([0; 8], |cell| cell.solid);
                let before = before_side(&cell.solid, &solid, side);
                faces +=
                    (0..8).map(|layer| u64::from((cell.reached[layer] & !before[layer]).count_ones())).sum::<u64>();
            }
        }
        let world = self.instance.world_from_grid;
        let (scale, low, high) = (f64::from(world.scale()), min.as_vec3(), (max + 1).as_vec3());
        let corner = world.point(low).as_dvec3();
        let edges = [0, 1, 2].map(|axis| {
            let mut end = low;
            end[axis] = high[axis];
            world.point(end).as_dvec3() - corner
        });
        Component {
            voxels,
            volume: voxels as f64 * scale.powi(3),
            exposed: faces as f64 * scale.powi(2),
            corner,
            edges,
        }
    }
}

/// The layers of a packed brick: a header, whose low bits are the blocks of 4³ voxels that there are, then two words for each of these.
fn layers_of(bricks: &[u32], record: usize) -> Layers {
    let mut layers = [0; 8];
    let blocks = (0..8).filter(|block| bricks[record] >> block & 1 == 1);
    for (index, block) in blocks.enumerate() {
        let word = |offset: usize| u64::from(bricks[record + 2 + 2 * index + offset]);
        let mask = word(0) | word(1) << 32;
        for row in 0..16 {
            let (y, z) = (row & 3 | (block >> 1 & 1) << 2, row >> 2 | (block >> 2) << 2);
            layers[z] |= (mask >> (4 * row) & 0xf) << (8 * y + 4 * (block & 1));
        }
    }
    layers
}

/// Those voxels of a brick that something holds for.
fn filtered(layers: &Layers, holds: impl Fn(IVec3) -> bool) -> Layers {
    let mut kept = *layers;
    for (z, layer) in kept.iter_mut().enumerate() {
        for bit in voxtrace::brick::bits(*layer) {
            let local = IVec3::new((bit & 7) as i32, (bit >> 3) as i32, z as i32);
            *layer &= !(u64::from(!holds(local)) << bit);
        }
    }
    kept
}

/// All that hangs together with some voxels of a brick and was not reached before.
fn spread(seeds: Layers, allowed: &Layers, reached: &Layers) -> Layers {
    let mut now: Layers = std::array::from_fn(|layer| seeds[layer] & allowed[layer] & !reached[layer]);
    loop {
        let mut next = now;
        for layer in 0..8 {
            let own = now[layer];
            let flat = (own & !X_HIGH) << 1 | (own & !X_LOW) >> 1 | own << 8 | own >> 8;
            let below = if layer > 0 { now[layer - 1] } else { 0 };
            let above = if layer < 7 { now[layer + 1] } else { 0 };
            next[layer] |= (flat | below | above) & allowed[layer] & !reached[layer];
        }
        if next == now {
            return now;
        }
        now = next;
    }
}

/// Voxels of the neighbour on a side that touch voxels of a brick.
fn over_side(own: &Layers, side: usize) -> Layers {
    let mut over = [0; 8];
    for layer in 0..8 {
        match side {
            0 => over[layer] = (own[layer] & X_LOW) << 7,
            1 => over[layer] = (own[layer] & X_HIGH) >> 7,
            2 => over[layer] = (own[layer] & Y_LOW) << 56,
            3 => over[layer] = (own[layer] & Y_HIGH) >> 56,
            _ => {}
        }
    }
    match side {
        4 => over[7] = own[0],
        5 => over[0] = own[7],
        _ => {}
    }
    over
}

/// For each voxel of a brick whether the one on its side is solid; `beyond` are the voxels of the neighbour there.
fn before_side(own: &Layers, beyond: &Layers, side: usize) -> Layers {
    std::array::from_fn(|layer| match side {
        0 => (own[layer] & !X_HIGH) << 1 | (beyond[layer] & X_HIGH) >> 7,
        1 => (own[layer] & !X_LOW) >> 1 | (beyond[layer] & X_LOW) << 7,
        2 => own[layer] << 8 | (beyond[layer] & Y_HIGH) >> 56,
        3 => own[layer] >> 8 | (beyond[layer] & Y_LOW) << 56,
        4 => {
            if layer > 0 {
                own[layer - 1]
            } else {
                beyond[7]
            }
        }
        _ => {
            if layer < 7 {
                own[layer + 1]
            } else {
                beyond[0]
            }
        }
    })
}

/// The lowest and the highest voxel of a brick that has some.
fn extent(layers: &Layers) -> (IVec3, IVec3) {
    let all = layers.iter().fold(0, |all, layer| all | layer);
    let rows: u32 = (0..8).fold(0, |rows, y| rows | u32::from(all >> (8 * y) & 0xff != 0) << y);
    let columns = (0..8).fold(0, |columns, y| columns | (all >> (8 * y) & 0xff) as u32);
    let stack = (0..8).fold(0, |stack, z| stack | u32::from(layers[z] != 0) << z);
    let low = |bits: u32| bits.trailing_zeros() as i32;
    let high = |bits: u32| 31 - bits.leading_zeros() as i32;
    (IVec3::new(low(columns), low(rows), low(stack)), IVec3::new(high(columns), high(rows), high(stack)))
}

#[cfg(test)]
mod tests;
