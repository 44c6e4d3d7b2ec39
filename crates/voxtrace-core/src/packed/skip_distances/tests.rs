//! Skip distances against their definition, cell by cell.

use super::super::pack::levels_of;
use super::*;
use std::collections::HashMap;

/// Edges of the largest empty cubes along one octant, by their definition.
struct Definition<'a> {
    levels: &'a [Level],
    step: IVec3,
    known: HashMap<(usize, IVec3), i32>,
}

impl Definition<'_> {
    /// Whether a cell of a level is occupied; `None` where the level has no node there.
    fn is_occupied(&self, depth: usize, cell: IVec3) -> Option<bool> {
        let level = &self.levels[depth];
        if level.is_top() {
            return level.top_index(cell).map(|index| level.occupied[index]);
        }
        level.index_of.get(&(cell >> 2)).map(|&node| level.occupied[node as usize * 64 + cell_index(cell & 3)])
    }

    fn run(&mut self, depth: usize, cell: IVec3) -> i32 {
        let most = i32::from(MAX_RUN);
        if let Some(&run) = self.known.get(&(depth, cell)) {
            return run;
        }
        let run = match self.is_occupied(depth, cell) {
            Some(true) => 0,
            Some(false) => {
                let offsets = (1..8).map(|i| self.step * IVec3::new(i & 1, i >> 1 & 1, i >> 2));
                let offsets: Vec<IVec3> = offsets.collect();
                let least = offsets.into_iter().map(|offset| self.run(depth, cell + offset)).min().unwrap();
                most.min(least + 1)
            }
            None if depth == 0 => most,
            None => {
                let (mut coarse, mut scale, mut above) = (cell >> 2, 4, depth - 1);
                while above > 0 && self.is_occupied(above, coarse).is_none() {
                    (coarse, scale, above) = (coarse >> 2, scale * 4, above - 1);
                }
                let end = (mirrored(coarse, self.step) + self.run(above, coarse)) * scale;
                (end - mirrored(cell, self.step)).min_element().clamp(0, most)
            }
        };
        self.known.insert((depth, cell), run);
        run
    }
}

fn by_definition(levels: &[Level]) -> Vec<Vec<u32>> {
    let cell_at = |level: &Level, index: usize| {
        let of = |index: usize, width: i32, height: i32| {
            let index = index as i32;
            IVec3::new(index % width, index / width % height, index / (width * height))
        };
        if level.is_top() {
            return of(index, level.size.x, level.size.y);
        }
        level.nodes[index / 64] * 4 + of(index % 64, 4, 4)
    };
    let mut words: Vec<Vec<u32>> = levels.iter().map(|level| vec![0; level.occupied.len()]).collect();
    for octant in 0..8 {
        let mut definition = Definition { levels, step: octant_step(octant), known: HashMap::new() };
        for (depth, level) in levels.iter().enumerate() {
            // From far to near, so that no recursion is deep.
            let mut cells: Vec<usize> = (0..level.occupied.len()).collect();
            cells.sort_by_key(|&cell| -mirrored(cell_at(level, cell), definition.step).element_sum());
            for cell in cells {
                let run = definition.run(depth, cell_at(level, cell));
                let code = SKIP_DISTANCES.iter().rposition(|&distance| i32::from(distance) <= run).unwrap_or(0);
                words[depth][cell] |= (code as u32) << (3 * octant);
            }
        }
    }
    words
}

/// Bricks in clumps, so that there are empty regions of many sizes.
fn bricks(seed: u64, extent: IVec3, clumps: usize, in_clump: usize, spread: i32) -> Vec<IVec3> {
    let mut state = seed;
    let mut below = |limit: i32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) % limit as u64) as i32
    };
    let mut bricks = vec![IVec3::ZERO, extent - 1];
    for _ in 0..clumps {
        let middle = IVec3::new(below(extent.x), below(extent.y), below(extent.z));
        for _ in 0..in_clump {
            let offset = IVec3::new(below(spread), below(spread), below(spread));
            bricks.push((middle + offset).min(extent - 1));
        }
    }
    bricks.sort_unstable_by_key(|at| (at.z, at.y, at.x));
    bricks.dedup();
    bricks
}

#[test]
fn skip_distances_are_those_of_their_definition() {
    let cases = [
        (IVec3::ONE, 0, 0, 1, 1),
        (IVec3::new(5, 3, 9), 2, 10, 3, 1),
        (IVec3::new(40, 37, 18), 6, 60, 5, 2),
        (IVec3::new(100, 90, 20), 3, 25, 4, 2),
        (IVec3::new(300, 20, 250), 4, 20, 6, 3),
        (IVec3::new(700, 600, 900), 3, 12, 30, 3),
        (IVec3::new(1500, 4, 4), 30, 4, 4, 2),
        // More nodes than one task works on.
        (IVec3::new(200, 200, 60), 2500, 2, 3, 2),
    ];
    let mut most_nodes = 0;
    for (seed, (extent, clumps, in_clump, spread, least_levels)) in (1..).zip(cases) {
        let bricks = bricks(seed, extent, clumps, in_clump, spread);
        let levels = levels_of(&bricks, extent * 8);
        assert!(levels.len() >= least_levels, "{extent}: {} levels", levels.len());
        most_nodes = most_nodes.max(levels[levels.len() - 1].nodes.len());
        let (found, wanted) = (skip_distances_of(&levels), by_definition(&levels));
        for (depth, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
            let differs = found.iter().zip(wanted).position(|(found, wanted)| found != wanted);
            assert_eq!((found.len(), differs), (wanted.len(), None), "{extent}, level {depth}");
        }
    }
    assert!(most_nodes > CHUNK, "{most_nodes}");
}
