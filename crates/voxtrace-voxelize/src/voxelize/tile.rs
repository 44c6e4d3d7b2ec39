//! Voxelizes one tile of the grid: the triangles that reach into it are clipped to its voxels, and each voxel sums the area and
//! the appearance of the pieces inside it.

use super::SurfaceRule;
use super::appearance::{AppearanceKey, appearance_key, emission_bits, rgb_bits};
use super::binning::TILE;
use super::color_histogram::ColorHistogram;
use super::fill::Column;
use super::mesh_appearance::{MeshAppearance, TriangleAppearance};
use super::placement::Placement;
use super::polygon::{Pieces, Polygon, TOUCH, for_each_cell};
use super::six_separating;
use super::spill::TileRecords;
use super::triangle::Triangle;
use crate::mesh::Mesh;
use glam::{DVec2, IVec3, Vec4};
use voxtrace_scene::brick::{BRICK_SIZE, bits, block_bit, block_index};

/// Bricks along one edge of a tile.
const BRICKS: i32 = TILE / BRICK_SIZE;
/// Bits of a brick's coordinate in its tile.
const BRICK_BITS: u32 = BRICKS.trailing_zeros();
const _: () = assert!(BRICKS == 1 << BRICK_BITS);
/// Bricks of a tile.
const BRICK_COUNT: usize = (BRICKS * BRICKS * BRICKS) as usize;
/// No slot.
const NONE: u8 = u8::MAX;
/// Weight of the appearance at a point, so small that pieces with an area outweigh it.
const POINT_WEIGHT: f64 = 1e-6;

/// What is the same for all tiles.
pub(super) struct TileJob<'a> {
    pub mesh: &'a Mesh,
    pub placement: &'a Placement,
    pub appearance: &'a MeshAppearance<'a>,
    pub rule: SurfaceRule,
    pub histogram: &'a ColorHistogram,
}

/// The sums of a brick.
struct BrickSums {
    /// Voxels that the surface crosses (26-separating).
    crossed: [u64; 8],
    /// Voxels of the thin surface (6-separating).
    chosen: [u64; 8],
    /// Linear colour times area, and area.
    colors: Vec<Vec4>,
    /// Emission times area.
    emissions: Vec<Vec4>,
    /// The BSDF class that leads by area, and its lead (Boyer and Moore's majority vote, weighted by area).
    classes: Vec<(f32, u8)>,
}

/// The sums of a tile.
struct TileSums {
    slots: [u8; BRICK_COUNT],
    used: usize,
    bricks: Vec<BrickSums>,
}

/// Buffers that a thread reuses from tile to tile.
pub(super) struct Scratch {
    pieces: Pieces,
    sums: TileSums,
}

impl Scratch {
    pub fn new() -> Self {
        Self { pieces: Pieces::new(), sums: TileSums { slots: [NONE; BRICK_COUNT], used: 0, bricks: Vec::new() } }
    }
}

/// Whether a voxel, counted from the corner of its tile, is inside it.
fn is_in_tile(local: IVec3) -> bool {
    local.cmpge(IVec3::ZERO).all() && local.cmplt(IVec3::splat(TILE)).all()
}

impl TileJob<'_> {
    /// Voxelizes the triangles of a tile, then the interior spans of its column if there is one, and encodes its bricks.
    pub fn tile(
        &self,
        tile: IVec3,
        triangles: impl Iterator<Item = usize>,
        column: Option<&Column>,
        scratch: &mut Scratch,
    ) -> TileRecords {
        for index in triangles {
            // Binning leaves out triangles without an area.
            let Some(triangle) = Triangle::of(self.mesh, self.placement, index) else { continue };
            if self.appearance.uniform.is_some() {
                self.plain_triangle(tile, &triangle, scratch);
            } else if let Some(surface) = self.appearance.triangle(index, &triangle) {
                self.triangle(tile, &triangle, &surface, scratch);
            }
        }
        if let Some(column) = column {
            self.fill(tile, column, &mut scratch.sums);
        }
        self.encode(tile, &mut scratch.sums)
    }

    /// The triangle, clipped to the tile.
    fn inside(tile: IVec3, triangle: &Triangle) -> Polygon {
        let mut polygon = triangle.polygon();
        for axis in 0..3 {
            let from = f64::from(tile[axis] * TILE);
            let to = from + f64::from(TILE);
            if !polygon.is_between(axis, from, to) {
                polygon.clip(axis, from, to);
            }
        }
        polygon
    }

    /// A triangle of a mesh with one appearance: only occupancy is needed.
    fn plain_triangle(&self, tile: IVec3, triangle: &Triangle, scratch: &mut Scratch) {
        let corner = tile * TILE;
        let Scratch { pieces, sums } = scratch;
        if self.rule == SurfaceRule::Thin {
            six_separating::for_each_voxel(triangle, corner, corner + TILE, |voxel, _| {
                let (brick, block, bit) = sums.voxel(voxel - corner, self);
                brick.chosen[block] |= 1 << bit;
            });
            return;
        }
        for_each_cell(&Self::inside(tile, triangle), TOUCH, pieces, |cell, _| {
            let local = IVec3::from_array(cell).wrapping_sub(corner);
            if is_in_tile(local) {
                let (brick, block, bit) = sums.voxel(local, self);
                brick.crossed[block] |= 1 << bit;
            }
        });
    }

    fn triangle(&self, tile: IVec3, triangle: &Triangle, surface: &TriangleAppearance, scratch: &mut Scratch) {
        let corner = tile * TILE;
        let [u, v] = surface.axes();
        let Scratch { pieces, sums } = scratch;
        for_each_cell(&Self::inside(tile, triangle), TOUCH, pieces, |cell, piece| {
            let local = IVec3::from_array(cell).wrapping_sub(corner);
            if !is_in_tile(local) {
                return;
            }
            let (flat_area, centroid) = area_and_centroid(piece, u, v);
            let area = flat_area * surface.stretch;
            let Some(appearance) = surface.at(centroid, area) else { return };
            let (brick, block, bit) = sums.voxel(local, self);
            brick.crossed[block] |= 1 << bit;
            // A piece whose area rounds to 0 still has a colour.
            brick.add(block, bit, appearance, area.max(1e-12) as f32);
        });
        if self.rule == SurfaceRule::Thin {
            six_separating::for_each_voxel(triangle, corner, corner + TILE, |voxel, point| {
                let (brick, block, bit) = sums.voxel(voxel - corner, self);
                // Pieces have given the voxel its appearance already; the point matters only where alpha may remove it.
                if !surface.has_holes && brick.crossed[block] >> bit & 1 != 0 {
                    brick.chosen[block] |= 1 << bit;
                } else if let Some(appearance) = surface.at(DVec2::new(point[u], point[v]), POINT_WEIGHT) {
                    brick.chosen[block] |= 1 << bit;
                    brick.add(block, bit, appearance, POINT_WEIGHT as f32);
                }
            });
        }
    }

    /// Takes the interior voxels, with the appearance of the surface where their line enters.
    fn fill(&self, tile: IVec3, column: &Column, sums: &mut TileSums) {
        let corner = tile * TILE;
        for ([x, y], span) in column.spans_in(tile) {
            let appearance = || {
                let triangle = Triangle::of(self.mesh, self.placement, span.triangle)?;
                let surface = self.appearance.triangle(span.triangle, &triangle)?;
                let point = [f64::from(corner.x + x) + 0.5, f64::from(corner.y + y) + 0.5, span.depth];
                let [u, v] = surface.axes();
                surface.at(DVec2::new(point[u], point[v]), 1.0)
            };
            let appearance = if self.appearance.uniform.is_some() { None } else { appearance() };
            for z in span.voxels.0..span.voxels.1 {
                let (brick, block, bit) = sums.voxel(IVec3::new(x, y, z - corner.z), self);
                let is_surface = brick.crossed[block] >> bit & 1 != 0;
                match appearance {
                    Some(appearance) if !is_surface => brick.add(block, bit, appearance, 1.0),
                    // Where alpha removes the surface, its interior is empty too.
                    None if !is_surface && self.appearance.uniform.is_none() => continue,
                    _ => {}
                }
                brick.crossed[block] |= 1 << bit;
                brick.chosen[block] |= 1 << bit;
            }
        }
    }

    fn encode(&self, tile: IVec3, sums: &mut TileSums) -> TileRecords {
        let mut records = TileRecords::default();
        let (mut keys, mut tally): (Vec<AppearanceKey>, _) = (Vec::new(), self.histogram.tally());
        for index in 0..BRICK_COUNT {
            let slot = std::mem::replace(&mut sums.slots[index], NONE);
            if slot == NONE {
                continue;
            }
            let brick = &mut sums.bricks[usize::from(slot)];
            let occupancy = match self.rule {
                SurfaceRule::Conservative => brick.crossed,
                SurfaceRule::Thin => brick.chosen,
            };
            keys.clear();
            match self.appearance.uniform {
                Some(key) => keys.push(key),
                None => brick.append_keys(&occupancy, &mut keys),
            }
            let count = occupancy.iter().map(|mask| mask.count_ones()).sum::<u32>();
            if count > 0 {
                tally.add(&keys, if self.appearance.uniform.is_some() { count } else { 1 });
                let at =
                    IVec3::new(index as i32 % BRICKS, index as i32 / BRICKS % BRICKS, index as i32 / (BRICKS * BRICKS));
                records.push(tile * BRICKS + at, &occupancy, &keys);
            }
            brick.clear();
        }
        sums.used = 0;
        records
    }
}

impl TileSums {
    /// The brick, the block in it and the bit in that, of a voxel of the tile.
    #[inline(always)]
    fn voxel(&mut self, local: IVec3, job: &TileJob) -> (&mut BrickSums, usize, u32) {
        let at: IVec3 = local >> 3;
        let index = (at.x | at.y << BRICK_BITS | at.z << (2 * BRICK_BITS)) as usize;
        let mut slot = self.slots[index];
        if slot == NONE {
            slot = self.used as u8;
            self.slots[index] = slot;
            self.used += 1;
            if self.bricks.len() < self.used {
                self.bricks.push(BrickSums::new(job.appearance));
            }
        }
        let inside: IVec3 = local & (BRICK_SIZE - 1);
        (&mut self.bricks[usize::from(slot)], block_index(inside), block_bit(inside))
    }
}

impl BrickSums {
    fn new(appearance: &MeshAppearance) -> Self {
        let size = |needed: bool| if needed { 512 } else { 0 };
        let is_colored = appearance.uniform.is_none();
        Self {
            crossed: [0; 8],
            chosen: [0; 8],
            colors: vec![Vec4::ZERO; size(is_colored)],
            emissions: vec![Vec4::ZERO; size(is_colored && appearance.emits)],
            classes: vec![(0.0, 0); size(is_colored && appearance.classes.len() > 1)],
        }
    }

    fn clear(&mut self) {
        (self.crossed, self.chosen) = ([0; 8], [0; 8]);
        self.colors.fill(Vec4::ZERO);
        self.emissions.fill(Vec4::ZERO);
        self.classes.fill((0.0, 0));
    }

    #[inline(always)]
    fn add(&mut self, block: usize, bit: u32, appearance: super::mesh_appearance::Appearance, area: f32) {
        let class = appearance.class;
        let at = block * 64 + bit as usize;
        self.colors[at] += appearance.color.extend(1.0) * area;
        if let Some(emission) = self.emissions.get_mut(at) {
            *emission += appearance.emission.extend(0.0) * area;
        }
        if let Some((lead, leader)) = self.classes.get_mut(at) {
            if *leader == class {
                *lead += area;
            } else if *lead < area {
                (*lead, *leader) = (area - *lead, class);
            } else {
                *lead -= area;
            }
        }
    }

    /// Appends the appearance keys of the voxels of a mask, in rank order.
    fn append_keys(&self, occupancy: &[u64; 8], keys: &mut Vec<AppearanceKey>) {
        for (block, &mask) in occupancy.iter().enumerate() {
            for bit in bits(mask) {
                let at = block * 64 + bit as usize;
                let sum = self.colors[at];
                let rgb = rgb_bits(sum.truncate() / sum.w);
                let emission = self.emissions.get(at).map_or(0, |emission| emission_bits(emission.truncate() / sum.w));
                let class = self.classes.get(at).map_or(0, |class| class.1);
                keys.push(appearance_key(rgb, class, emission));
            }
        }
    }
}

/// Area and centroid of a polygon projected along the third axis. Without an area the centroid is the first corner.
#[inline(always)]
fn area_and_centroid(piece: &Polygon, u: usize, v: usize) -> (f64, DVec2) {
    let corners = piece.corners();
    let Some(first) = corners.first() else { return (0.0, DVec2::ZERO) };
    let origin = DVec2::new(first[u], first[v]);
    let flat = |corner: &[f64; 3]| DVec2::new(corner[u], corner[v]) - origin;
    let (mut twice_area, mut moment) = (0.0, DVec2::ZERO);
    let mut last = flat(&corners[1 % corners.len()]);
    for corner in &corners[2.min(corners.len())..] {
        let point = flat(corner);
        let part = last.perp_dot(point);
        twice_area += part;
        moment += (last + point) * part;
        last = point;
    }
    if twice_area == 0.0 {
        return (0.0, origin);
    }
    (twice_area.abs() * 0.5, origin + moment / (3.0 * twice_area))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn area_and_centroid_are_those_of_the_projection() {
        let square = Polygon::new(&[[1.0, 5.0, 2.0], [3.0, 6.0, 2.0], [3.0, 7.0, 4.0], [1.0, 8.0, 4.0]]);
        let (area, centroid) = area_and_centroid(&square, 0, 2);
        assert!((area - 4.0).abs() < 1e-12 && (centroid - DVec2::new(2.0, 3.0)).length() < 1e-12, "{area} {centroid}");
        assert_eq!(area_and_centroid(&Polygon::new(&[[1.0, 2.0, 3.0]; 3]), 0, 1), (0.0, DVec2::new(1.0, 2.0)));
    }
}
