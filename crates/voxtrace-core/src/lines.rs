//! Lines on the faces of voxels: along the edges of shapes, and along a grid, as editors of voxels show their models. Where a line lies, an opaque
//! surface is matte and has the line's colour, for all light; lamps, glass and media keep what they are, and so do the faces of cuts and the
//! ground of [`crate::surroundings`], whose voxels are no scene's. Widths are in voxels, wherever an instance puts them.
//!
//! A line along an edge of a shape lies where the flat surface that was hit ends: it goes on where the next voxel of the same grid is opaque and what is
//! before it is not. `docs/decisions/0061-lines.md`. Twin of `shaders/lines.slang`.

use crate::packed::{PackedInstance, PackedMaterial, PackedScene};
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::{Hit, Ray};

/// Largest [`GridLines::spacing`].
pub const LARGEST_SPACING: u32 = 1 << 16;

/// How a line looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Width, voxels: half of it on each side of an edge.
    pub width: f32,
    /// Diffuse reflectance, linear, each channel in [0, 1].
    pub color: Vec3,
}

/// Lines between voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridLines {
    /// How they look.
    pub line: Line,
    /// Voxels from one line to the next, counted from the origin of their grid; 1 to 65536.
    pub spacing: u32,
}

/// The lines of a frame; none by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lines {
    /// Along the edges of shapes: at most a voxel wide. They lie over those of the grid.
    pub edges: Option<Line>,
    /// Along a grid: at most as wide as it is spaced.
    pub grid: Option<GridLines>,
}

impl Lines {
    /// Whether there are none.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.edges.is_none() && self.grid.is_none()
    }

    /// Checks widths, colours and spacing.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn check(&self) -> Result<(), &'static str> {
        let grid = self.grid.map(|grid| (grid.line, grid.spacing));
        if grid.is_some_and(|(_, spacing)| !(1..=LARGEST_SPACING).contains(&spacing)) {
            return Err("lines of a grid are 1 to 65536 voxels apart");
        }
        for (line, spacing) in self.edges.map(|line| (line, 1)).into_iter().chain(grid) {
            if !(line.width > 0.0 && line.width <= spacing as f32) {
                return Err(
                    "a line's width is above 0, and at most its distance to the next, which is a voxel for edges",
                );
            }
            if !(line.color.min_element() >= 0.0 && line.color.max_element() <= 1.0) {
                return Err("a line's colour is a reflectance: each channel is 0 to 1");
            }
        }
        Ok(())
    }

    /// Colour of the line at a `hit`, no miss, of `ray` on a surface of the material `index`; `None` where there is no line.
    #[inline]
    pub(crate) fn color_at(&self, scene: &PackedScene, index: u32, ray: &Ray, hit: &Hit) -> Option<Vec3> {
        if self.is_none() { None } else { self.find(scene, index, ray, hit) }
    }

    #[inline(never)]
    fn find(&self, scene: &PackedScene, index: u32, ray: &Ray, hit: &Hit) -> Option<Vec3> {
        let is_lined = hit.face < Hit::FIRST_CUT && scene.ground_material() != Some(index);
        if !is_lined || !takes_lines(&scene.materials()[index as usize]) {
            return None;
        }
        let instance = &scene.placement.instances[hit.instance as usize];
        let point =
            instance.grid_from_world.point(ray.origin) + instance.grid_from_world.direction(ray.direction) * hit.t;
        let at = (point - hit.voxel.as_vec3()).max(Vec3::ZERO).min(Vec3::ONE);
        let axis = hit.face().axis();
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        if let Some(line) = &self.edges {
            let half = line.width * 0.5;
            if ends_near(scene, instance, hit, [(u, side_near(at[u], half)), (v, side_near(at[v], half))]) {
                return Some(line.color);
            }
        }
        let GridLines { line, spacing } = self.grid?;
        let to_line =
            distance_to_line(hit.voxel[u], at[u], spacing).min(distance_to_line(hit.voxel[v], at[v], spacing));
        (to_line <= line.width * 0.5).then_some(line.color)
    }
}

/// Whether lines lie on a material: it is opaque and does not glow.
fn takes_lines(material: &PackedMaterial) -> bool {
    material.transmission <= 0.0 && material.emission.max_element() <= 0.0
}

/// Which side of its voxel, −1 or 1, a place in [0, 1] is nearer to than `half`; 0 for none.
#[inline]
fn side_near(at: f32, half: f32) -> i32 {
    if at < half.min(0.5) {
        -1
    } else if 1.0 - at < half {
        1
    } else {
        0
    }
}

/// Whether the flat surface of a hit ends on one of these sides of its voxel, each an axis and a side, or, near both, at the corner between.
fn ends_near(scene: &PackedScene, instance: &PackedInstance, hit: &Hit, sides: [(usize, i32); 2]) -> bool {
    let step = |(axis, side): (usize, i32)| {
        let mut step = IVec3::ZERO;
        step[axis] = side;
        step
    };
    let [u, v] = sides.map(step);
    let grid = &scene.geometry.grids[instance.grid as usize];
    let is_opaque = |voxel: IVec3| {
        let index = scene.geometry.material_at(grid, voxel);
        index.is_some_and(|index| scene.materials()[index as usize].transmission <= 0.0)
    };
    let goes_on = |step: IVec3| {
        let next = hit.voxel + step;
        is_opaque(next) && !is_opaque(next + hit.face().normal())
    };
    let (has_u, has_v) = (u != IVec3::ZERO, v != IVec3::ZERO);
    (has_u && !goes_on(u)) || (has_v && !goes_on(v)) || (has_u && has_v && !goes_on(u + v))
}

/// Distance, voxels, of a place in [0, 1] of a voxel from the nearest line of a grid across this axis.
#[inline]
fn distance_to_line(voxel: i32, at: f32, spacing: u32) -> f32 {
    // Of a negative number, devices do not say what is left.
    let after = if voxel >= 0 { voxel as u32 % spacing } else { spacing - 1 - !voxel as u32 % spacing };
    (after as f32 + at).min((spacing - 1 - after) as f32 + (1.0 - at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_line_is_as_far_as_all_planes_say() {
        for spacing in [1, 2, 3, 7] {
            for voxel in -20..20 {
                for at in [0.0, 0.25, 0.5, 0.875, 1.0] {
                    let place = voxel as f32 + at;
                    let planes = (-30..30).map(|plane| ((plane * spacing as i32) as f32 - place).abs());
                    let nearest = planes.fold(f32::INFINITY, f32::min);
                    assert_eq!(distance_to_line(voxel, at, spacing), nearest, "{voxel} {at} {spacing}");
                }
            }
        }
        let extremes = [i32::MIN, -1, 0, i32::MAX].map(|voxel| distance_to_line(voxel, 0.5, LARGEST_SPACING));
        assert!(extremes.iter().all(|&distance| distance == 0.5), "{extremes:?}");
    }

    #[test]
    fn a_place_is_near_a_side_or_none() {
        let sides = [0.0, 0.0999, 0.1001, 0.5, 0.8999, 0.9001, 1.0].map(|at| side_near(at, 0.1));
        assert_eq!(sides, [-1, -1, 0, 0, 0, 1, 1]);
        assert_eq!([0.0, 0.5, 1.0].map(|at| side_near(at, 0.0)), [0; 3], "no line has no side");
        assert_eq!([0.0, 0.49, 0.51, 1.0].map(|at| side_near(at, 0.5)), [-1, -1, 1, 1]);
    }
}
