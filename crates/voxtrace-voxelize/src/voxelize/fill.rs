//! The inside of closed surfaces: along each line of voxels parallel to z the surface is crossed going in and coming out, and
//! what lies between is inside where the crossings do not cancel (the winding number). A line that does not come out again,
//! where the surface is open, is left alone.

use super::bins::TILE;
use super::placement::Placement;
use super::thin::Shadow;
use super::triangle::Triangle;
use crate::mesh::Mesh;
use glam::IVec3;

/// Lines of a column of tiles.
const LINES: usize = (TILE * TILE) as usize;

/// A run of inner voxels along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Run {
    /// Lowest voxel, and one past the highest.
    pub voxels: (i32, i32),
    /// Triangle at which the line goes in, and the depth there: the look of the inside is that of the surface.
    pub triangle: usize,
    pub depth: f64,
}

/// The inner voxels of a column of tiles.
pub(super) struct Column {
    runs: Vec<Vec<Run>>,
}

impl Column {
    /// Follows the lines of the column at `tile` (its z does not matter) through the triangles that reach into it, each of
    /// which comes once.
    pub fn of(mesh: &Mesh, placement: &Placement, tile: IVec3, triangles: &[usize]) -> Self {
        let [x, y] = [tile.x * TILE, tile.y * TILE];
        let mut crossings: Vec<Vec<(f64, i32, usize)>> = vec![Vec::new(); LINES];
        for &index in triangles {
            let triangle = Triangle::of(mesh, placement, index);
            let Some(shadow) = triangle.and_then(|triangle| Shadow::of(&triangle, 2)) else { continue };
            shadow.for_each_line([x, y], [x + TILE, y + TILE], |line, depth| {
                crossings[((line[1] - y) * TILE + line[0] - x) as usize].push((depth, shadow.facing, index));
            });
        }
        Self { runs: crossings.into_iter().map(runs_of).collect() }
    }

    /// Lowest and one past the highest inner voxel.
    pub fn extent(&self) -> Option<(i32, i32)> {
        let runs = || self.runs.iter().flatten();
        Some((runs().map(|run| run.voxels.0).min()?, runs().map(|run| run.voxels.1).max()?))
    }

    /// The runs inside a tile of the column: place of the line in the tile, and the run cut to the tile.
    pub fn runs_in(&self, tile: IVec3) -> impl Iterator<Item = ([i32; 2], Run)> + '_ {
        let (low, high) = (tile.z * TILE, (tile.z + 1) * TILE);
        self.runs.iter().enumerate().flat_map(move |(line, runs)| {
            let at = [line as i32 % TILE, line as i32 / TILE];
            let cut =
                runs.iter().map(move |run| Run { voxels: (run.voxels.0.max(low), run.voxels.1.min(high)), ..*run });
            cut.filter(|run| run.voxels.0 < run.voxels.1).map(move |run| (at, run))
        })
    }
}

/// The runs between the crossings of a line: depth, +1 where the surface looks up, triangle.
fn runs_of(mut crossings: Vec<(f64, i32, usize)>) -> Vec<Run> {
    if crossings.iter().map(|crossing| crossing.1).sum::<i32>() != 0 {
        return Vec::new();
    }
    crossings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
    let (mut runs, mut winding, mut entry) = (Vec::<Run>::new(), 0, (0.0, 0));
    for (depth, facing, triangle) in crossings {
        let before = winding;
        winding -= facing;
        if before == 0 {
            entry = (depth, triangle);
        } else if winding == 0 {
            // Voxels whose middle is inside.
            let first = (entry.0 - 0.5).ceil() as i32;
            let end = (depth - 0.5).ceil() as i32;
            if first < end {
                runs.push(Run { voxels: (first, end), triangle: entry.1, depth: entry.0 });
            }
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_between_going_in_and_coming_out_is_inside() {
        let runs = |crossings: &[(f64, i32)]| -> Vec<(i32, i32)> {
            let numbered = crossings.iter().enumerate().map(|(index, &(depth, facing))| (depth, facing, index));
            runs_of(numbered.collect()).iter().map(|run| run.voxels).collect()
        };
        assert_eq!(runs(&[(7.25, 1), (2.0, -1)]), [(2, 7)]);
        assert_eq!(runs(&[(2.6, -1), (7.75, 1), (10.0, -1), (12.0, 1)]), [(3, 8), (10, 12)]);
        // A box in a box, turned alike and inside out.
        assert_eq!(runs(&[(1.0, -1), (3.0, -1), (5.0, 1), (9.0, 1)]), [(1, 9)]);
        assert_eq!(runs(&[(1.0, -1), (3.0, 1), (5.0, -1), (9.0, 1)]), [(1, 3), (5, 9)]);
        assert_eq!(runs(&[(1.0, 1), (9.0, -1)]), [(1, 9)]);
        // An open surface.
        assert_eq!(runs(&[(1.0, -1)]), []);
    }
}
