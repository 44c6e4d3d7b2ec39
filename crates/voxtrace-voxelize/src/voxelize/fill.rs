//! Solid voxelization of closed surfaces by scan conversion: along each line of voxels parallel to z the signed crossings of the
//! surface are counted, and what lies between is inside where the winding number is not zero. A line whose crossings do not
//! cancel meets an open surface and is not filled.

use super::binning::TILE;
use super::placement::Placement;
use super::six_separating::ProjectedTriangle;
use super::triangle::Triangle;
use crate::mesh::Mesh;
use glam::IVec3;

/// Lines of a column of tiles.
const LINES: usize = (TILE * TILE) as usize;

/// A span of interior voxels along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Lowest voxel, and one past the highest.
    pub voxels: (i32, i32),
    /// Triangle at which the line enters, and the depth there: the interior takes the appearance of the surface.
    pub triangle: usize,
    pub depth: f64,
}

/// The interior voxels of a column of tiles.
pub(super) struct Column {
    spans: Vec<Vec<Span>>,
    /// Lines that meet an open surface.
    pub open_lines: u64,
}

impl Column {
    /// Intersects the lines of the column at `tile` (its z does not matter) with the triangles that reach into it; `triangles`
    /// has no duplicates.
    pub fn of(mesh: &Mesh, placement: &Placement, tile: IVec3, triangles: &[usize]) -> Self {
        let [x, y] = [tile.x * TILE, tile.y * TILE];
        let mut crossings: Vec<Vec<(f64, i32, usize)>> = vec![Vec::new(); LINES];
        for &index in triangles {
            let triangle = Triangle::of(mesh, placement, index);
            let Some(projected) = triangle.and_then(|triangle| ProjectedTriangle::of(&triangle, 2)) else { continue };
            projected.for_each_line([x, y], [x + TILE, y + TILE], |line, depth| {
                crossings[((line[1] - y) * TILE + line[0] - x) as usize].push((depth, projected.facing, index));
            });
        }
        let open_lines = crossings.iter().filter(|crossings| is_open(crossings)).count() as u64;
        Self { spans: crossings.into_iter().map(spans_of).collect(), open_lines }
    }

    /// Lowest and one past the highest interior voxel.
    pub fn extent(&self) -> Option<(i32, i32)> {
        let spans = || self.spans.iter().flatten();
        Some((spans().map(|span| span.voxels.0).min()?, spans().map(|span| span.voxels.1).max()?))
    }

    /// The spans inside a tile of the column: place of the line in the tile, and the span clipped to the tile.
    pub fn spans_in(&self, tile: IVec3) -> impl Iterator<Item = ([i32; 2], Span)> + '_ {
        let (low, high) = (tile.z * TILE, (tile.z + 1) * TILE);
        self.spans.iter().enumerate().flat_map(move |(line, spans)| {
            let at = [line as i32 % TILE, line as i32 / TILE];
            let cut = spans
                .iter()
                .map(move |span| Span { voxels: (span.voxels.0.max(low), span.voxels.1.min(high)), ..*span });
            cut.filter(|span| span.voxels.0 < span.voxels.1).map(move |span| (at, span))
        })
    }
}

/// Whether a line goes into a surface and not out of it, or the other way round.
fn is_open(crossings: &[(f64, i32, usize)]) -> bool {
    crossings.iter().map(|crossing| crossing.1).sum::<i32>() != 0
}

/// The spans between the crossings of a line. A crossing is the depth, +1 where the surface faces up and −1 where it faces down,
/// and the triangle.
fn spans_of(mut crossings: Vec<(f64, i32, usize)>) -> Vec<Span> {
    if is_open(&crossings) {
        return Vec::new();
    }
    crossings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
    let (mut spans, mut winding, mut entry) = (Vec::<Span>::new(), 0, (0.0, 0));
    for (depth, facing, triangle) in crossings {
        let before = winding;
        winding -= facing;
        if before == 0 {
            entry = (depth, triangle);
        } else if winding == 0 {
            // Voxels whose centre is inside.
            let first = (entry.0 - 0.5).ceil() as i32;
            let end = (depth - 0.5).ceil() as i32;
            if first < end {
                spans.push(Span { voxels: (first, end), triangle: entry.1, depth: entry.0 });
            }
        }
    }
    spans
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_between_going_in_and_coming_out_is_inside() {
        let spans = |crossings: &[(f64, i32)]| -> Vec<(i32, i32)> {
            let numbered = crossings.iter().enumerate().map(|(index, &(depth, facing))| (depth, facing, index));
            spans_of(numbered.collect()).iter().map(|span| span.voxels).collect()
        };
        assert_eq!(spans(&[(7.25, 1), (2.0, -1)]), [(2, 7)]);
        assert_eq!(spans(&[(2.6, -1), (7.75, 1), (10.0, -1), (12.0, 1)]), [(3, 8), (10, 12)]);
        // A box in a box, turned alike and inside out.
        assert_eq!(spans(&[(1.0, -1), (3.0, -1), (5.0, 1), (9.0, 1)]), [(1, 9)]);
        assert_eq!(spans(&[(1.0, -1), (3.0, 1), (5.0, -1), (9.0, 1)]), [(1, 3), (5, 9)]);
        assert_eq!(spans(&[(1.0, 1), (9.0, -1)]), [(1, 9)]);
        // An open surface.
        assert_eq!(spans(&[(1.0, -1)]), []);
    }
}
