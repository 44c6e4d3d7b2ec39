//! Qubicle Binary, `.qb` (specification by Minddesk): a matrix of colours for each visible instance, in runs. Qubicle's y is up, and z points
//! to the viewer, who looks along our +y.

use super::{
    ExportError, Wanted, bake_failure,
    flat_color::{lost_of, shown_srgb},
    go_on,
};
use glam::IVec3;
use rayon::prelude::*;
use std::io::Write;
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_core::packed::Lattice;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::scene::{Instance, Scene};
use voxtrace_voxelize::bake::BakeError;

const FORMAT: &str = ".qb";
/// Version 1.1.0.0.
const VERSION: u32 = 0x0101;
/// Marks a run, and the end of a layer.
const RUN: u32 = 2;
const NEXT_LAYER: u32 = 6;
/// Shorter runs take less room as they are.
const SHORTEST_RUN: u64 = 4;
/// Most bytes of a name.
const LONGEST_NAME: usize = 255;

/// Writes the visible instances of a scene as a Qubicle file. Returns what it does not hold.
pub fn write(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let colors: Vec<u32> = scene.materials.iter().map(color_of).collect();
    let visible: Vec<_> = scene.instances.iter().enumerate().filter(|(_, one)| scene.is_visible(one)).collect();
    let matrices: Result<Vec<_>, ExportError> =
        visible.par_iter().map(|&(index, instance)| matrix(scene, index, instance, &colors, wanted)).collect();
    go_on(wanted)?;
    let matrices: Vec<Vec<u8>> = matrices?.into_iter().flatten().collect();
    let count =
        u32::try_from(matrices.len()).map_err(|_| ExportError::TooLarge { format: FORMAT, what: "the instances" })?;
    write_atomically_while(path, wanted, |file| {
        // Version, RGBA, z to the viewer, in runs, no masks of faces, and how many.
        for number in [VERSION, 0, 0, 1, 0, count] {
            file.write_all(&number.to_le_bytes())?;
        }
        matrices.iter().try_for_each(|matrix| file.write_all(matrix))
    })
    .map_err(|error| ExportError::Io { path: path.into(), error })?;
    Ok(left_out(scene))
}

/// What of a scene formats of plain colours do not hold, one phrase each.
pub(super) fn left_out(scene: &Scene) -> Vec<String> {
    let instances = || scene.instances.iter();
    let counts = [
        ("hidden instances", instances().filter(|instance| !scene.is_visible(instance)).count()),
        ("movement of instances", instances().filter(|instance| instance.keyframes.len() > 1).count()),
    ];
    let counted = counts.into_iter().filter(|&(_, count)| count > 0);
    counted.map(|(what, count)| format!("{what} ({count})")).chain(lost_of(&scene.materials)).collect()
}

/// A colour with all faces visible.
fn color_of(material: &voxtrace_scene::Material) -> u32 {
    let [red, green, blue] = shown_srgb(material);
    u32::from_le_bytes([red, green, blue, 255])
}

/// The bytes of an instance, `None` where it has no voxel; some are missing where they are not wanted any more.
fn matrix(
    scene: &Scene,
    index: usize,
    instance: &Instance,
    colors: &[u32],
    wanted: Wanted,
) -> Result<Option<Vec<u8>>, ExportError> {
    let way = Lattice::of(&instance.world_from_grid).ok_or_else(|| {
        let off = BakeError::OffLattice { instance: index, name: instance.name.clone() };
        bake_failure(FORMAT, off)
    })?;
    let grid = &scene.grids[instance.grid];
    let Some(bounds) = grid.bounds() else { return Ok(None) };
    let (min, max) = way.bounds(bounds.min, bounds.max);
    if min.abs().max(max.abs()).max_element() > MAX_COORDINATE {
        return Err(ExportError::TooLarge { format: FORMAT, what: "the places of instances" });
    }
    let size = max - min;
    let mut name = instance.name.clone();
    while name.len() > LONGEST_NAME {
        name.pop();
    }
    let mut bytes = vec![name.len() as u8];
    bytes.extend(name.as_bytes());
    for number in [size.x, size.z, size.y, min.x, min.z, -max.y] {
        bytes.extend(number.to_le_bytes());
    }
    let layers = layers(grid.voxels().take_while(|_| wanted()), |voxel| way.voxel(voxel) - min, size, colors);
    let layers = layers.into_par_iter().map(|layer| if wanted() { layer } else { Vec::new() });
    bytes.par_extend(layers.flat_map_iter(|layer| runs(layer).into_iter().flat_map(u32::to_le_bytes)));
    Ok(Some(bytes))
}

/// The voxels of each layer of the file, from the one farthest from the viewer: place, row by row from below, and colour.
fn layers(
    voxels: impl Iterator<Item = (IVec3, u16)>,
    place: impl Fn(IVec3) -> IVec3,
    size: IVec3,
    colors: &[u32],
) -> Vec<Vec<(u64, u32)>> {
    let mut layers = vec![Vec::new(); size.y as usize];
    for (voxel, material) in voxels {
        let at = place(voxel);
        let along = u64::from(at.z as u32) * u64::from(size.x as u32) + u64::from(at.x as u32);
        layers[(size.y - 1 - at.y) as usize].push((along, colors[usize::from(material)]));
    }
    layers
}

/// A layer as runs of colours; what is behind the last voxel is empty.
fn runs(mut layer: Vec<(u64, u32)>) -> Vec<u32> {
    layer.sort_unstable();
    let mut numbers = Vec::new();
    let mut push = |count: u64, color: u32| {
        let mut left = count;
        while left >= SHORTEST_RUN {
            let part = left.min(u64::from(u32::MAX));
            numbers.extend([RUN, part as u32, color]);
            left -= part;
        }
        numbers.extend((0..left).map(|_| color));
    };
    let mut next = 0;
    for same in layer.chunk_by(|a, b| a.0 + 1 == b.0 && a.1 == b.1) {
        push(same[0].0 - next, 0);
        push(same.len() as u64, same[0].1);
        next = same[0].0 + same.len() as u64;
    }
    numbers.push(NEXT_LAYER);
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_say_how_often_a_colour_comes_and_what_is_empty_between() {
        let red = 0xff00_00ff;
        let layer: Vec<(u64, u32)> = [7, 0, 8, 9, 10, 11, 20].map(|place| (place, red)).to_vec();
        assert_eq!(runs(layer), [red, RUN, 6, 0, RUN, 5, red, RUN, 8, 0, red, NEXT_LAYER]);
        assert_eq!(runs(Vec::new()), [NEXT_LAYER]);
        assert_eq!(runs(vec![(2, red), (3, 9)]), [0, 0, red, 9, NEXT_LAYER]);
    }
}
