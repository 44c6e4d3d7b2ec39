//! Qubicle Exchange Format, `.qef` (specification by Minddesk, version 0.2): lines of text with the size, the colours, and a voxel each.
//! Here the second coordinate points to the viewer and the third one up.

use super::{Matrix, Model};
use crate::import::source::input::Input;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_voxelize::ImportError;

/// Reads a Qubicle Exchange file.
pub(super) fn read(input: &mut Input, model: &mut Model) -> Result<(), ImportError> {
    let path = input.path();
    // Format, version, site.
    for _ in 0..3 {
        input.line()?;
    }
    let offset = input.offset();
    let [width, depth, height] = whole(&needed(input, "the size")?)
        .ok_or_else(|| ImportError::malformed(path, offset, "a size without three whole numbers"))?;
    let matrix = Matrix { name: String::new(), size: [width, height, depth], position: [0; 3], is_away: false };
    model.check(&matrix, offset)?;
    let offset = input.offset();
    let [count] = whole(&needed(input, "the number of colours")?)
        .ok_or_else(|| ImportError::malformed(path, offset, "no number of colours"))?;
    if u64::from(count) > model.limits.items {
        return Err(ImportError::limit(path, Some(offset), "colours", count.into(), model.limits.items));
    }
    let mut materials = Vec::new();
    for _ in 0..count {
        let offset = input.offset();
        let color = color(&needed(input, "the colours")?);
        let color = color.ok_or_else(|| ImportError::malformed(path, offset, "a colour without three numbers"))?;
        materials.push(model.paints.material(color));
    }
    let mut grid = VoxelGrid::new();
    let mut lines = 0;
    loop {
        let offset = input.offset();
        let Some(line) = input.line()? else { break };
        if line.trim_ascii().is_empty() {
            continue;
        }
        // As many lines as places, however often one is named.
        lines += 1;
        if lines > model.limits.voxels {
            return Err(ImportError::limit(path, Some(offset), "voxels", lines, model.limits.voxels));
        }
        let malformed = |what: &str| ImportError::malformed(path, offset, what);
        // The fifth number says which faces are seen.
        let [x, z, up, color] = whole(line).ok_or_else(|| malformed("a voxel without four whole numbers"))?;
        if x >= width || z >= depth || up >= height {
            return Err(malformed("a voxel beyond the size"));
        }
        let material = materials.get(color as usize).ok_or_else(|| malformed("a voxel of no colour that there is"))?;
        grid.set(matrix.place(x, up, z), *material);
    }
    model.add(matrix, grid);
    Ok(())
}

fn needed(input: &mut Input, what: &str) -> Result<Vec<u8>, ImportError> {
    let (path, offset) = (input.path(), input.offset());
    let line = input.line()?.ok_or_else(|| ImportError::truncated(path, offset, what))?;
    Ok(line.to_vec())
}

fn words(line: &[u8]) -> impl Iterator<Item = &str> {
    let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    words.map(|word| std::str::from_utf8(word).unwrap_or_default())
}

/// The first whole numbers of a line.
fn whole<const N: usize>(line: &[u8]) -> Option<[u32; N]> {
    let mut words = words(line);
    let mut numbers = [0; N];
    for number in &mut numbers {
        *number = words.next()?.parse().ok()?;
    }
    Some(numbers)
}

/// The colour of a line, from numbers between 0 and 1.
fn color(line: &[u8]) -> Option<[u8; 3]> {
    let mut words = words(line);
    let mut color = [0; 3];
    for channel in &mut color {
        let value: f32 = words.next()?.parse().ok()?;
        *channel = (value.clamp(0.0, 1.0) * 255.0).round() as u8;
    }
    Some(color)
}
