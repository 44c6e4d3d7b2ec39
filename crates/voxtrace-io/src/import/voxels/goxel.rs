//! Goxel's `.gox` (the comment at the head of its `gox.c`): chunks of a name, a length, bytes and a sum that nobody checks. Cubes of 16³ voxels are
//! pictures of 64 x 64 texels, PNG; layers say where which of them stand. z is up. Layers above hide those below.

use crate::import::grids::paints::Paints;
use crate::import::images::texture;
use crate::import::reader::{Kind, Magic, Reader, Voxels};
use crate::import::source::input::Input;
use glam::IVec3;
use std::path::Path;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelGrid};
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("Goxel", Kind::Voxels, &["gox"], "voxels of Goxel, its layers as one", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, &options.limits)?.into())
    })
    .with_magic(&[Magic::first(MAGIC)]);

/// First bytes of a file.
const MAGIC: &[u8] = b"GOX ";
/// Voxels along the edge of a cube, and in it.
const EDGE: i32 = 16;
const VOXELS: usize = 4096;
/// Opacity from which on a voxel is one, as Goxel draws them.
const OPAQUE: u8 = 127;

/// A cube of voxels: RGBA, x fastest, then y, then z.
type Cube = Vec<[u8; 4]>;

/// Cubes of a layer, by their number and the corner that they stand at.
struct Layer {
    cubes: Vec<(usize, IVec3)>,
    is_visible: bool,
    /// Whether it is a copy of another layer, or a shape: Goxel makes their voxels anew, and files have none.
    is_derived: bool,
}

/// Reads a file of Goxel.
fn read(mut input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    let head = input.take(8, "the header")?;
    let version = u32::from_le_bytes([head[4], head[5], head[6], head[7]]);
    if !head.starts_with(MAGIC) {
        return Err(ImportError::malformed(path, 0, "the file does not begin with GOX"));
    }
    if !(1..=99).contains(&version) {
        let what = format!("version {version} of the .gox format");
        return Err(ImportError::at(path, 4, ImportErrorKind::Unsupported(what)));
    }
    let (mut cubes, mut layers) = (Vec::<Cube>::new(), Vec::new());
    // The last chunk ends with the file.
    while !input.peek(1)?.is_empty() {
        let start = input.offset();
        let head = input.take(8, "a chunk")?;
        let (name, length) = ([head[0], head[1], head[2], head[3]], [head[4], head[5], head[6], head[7]]);
        let length = u32::from_le_bytes(length) as usize;
        if (cubes.len() + layers.len()) as u64 >= limits.items {
            return Err(ImportError::limit(path, Some(start), "chunks", limits.items + 1, limits.items));
        }
        let bytes = input.take(length, "a chunk")?;
        match &name {
            b"BL16" => cubes.push(cube(bytes, path, start, limits)?),
            b"LAYR" => layers.push(layer(bytes, path, start, version)?),
            _ => {}
        }
        input.take(4, "a chunk")?;
    }
    if layers.is_empty() {
        return Err(ImportError::malformed(path, input.offset(), "a file without a layer"));
    }
    let hidden = layers.iter().filter(|layer| !layer.is_visible && !layer.cubes.is_empty()).count();
    let (mut grid, mut paints, mut count) = (VoxelGrid::default(), Paints::default(), 0u64);
    let end = input.offset();
    for (number, corner) in layers.iter().filter(|layer| layer.is_visible).flat_map(|layer| &layer.cubes) {
        let cube = cubes.get(*number).ok_or_else(|| {
            ImportError::malformed(path, end, format!("a layer has cube {number} of {}", cubes.len()))
        })?;
        for (at, &[red, green, blue, _]) in cube.iter().enumerate().filter(|(_, texel)| texel[3] >= OPAQUE) {
            let at = at as i32;
            let place = *corner + IVec3::new(at % EDGE, at / EDGE % EDGE, at / (EDGE * EDGE));
            grid.set(place, paints.material([red, green, blue]));
            count += 1;
            if count > limits.voxels {
                return Err(ImportError::limit(path, Some(end), "voxels", count, limits.voxels));
            }
        }
    }
    let mut notes = if hidden > 0 { vec![format!("{hidden} hidden layers are left out")] } else { Vec::new() };
    let derived = layers.iter().filter(|layer| layer.is_visible && layer.is_derived && layer.cubes.is_empty()).count();
    if derived > 0 {
        let what = "layers that are copies of others or shapes are left out, as the file has no voxels of them";
        notes.push(format!("{derived} {what}: make them layers of their own in Goxel"));
    }
    Ok(Voxels { scene: Scene::from_grid("", grid, paints.finish()), notes })
}

fn cube(bytes: &[u8], path: &Path, at: u64, limits: &Limits) -> Result<Cube, ImportError> {
    let picture =
        texture::decode(bytes, limits).map_err(|refused| refused.into_import_error(path).with_offset(Some(at)))?;
    let texels = picture.texels();
    if texels.len() != VOXELS {
        return Err(ImportError::malformed(path, at, format!("a cube of {} voxels, not {VOXELS}", texels.len())));
    }
    Ok(texels.to_vec())
}

/// A layer: the number of cubes, for each its number, its place and a number that says nothing, then names with values.
fn layer(bytes: &[u8], path: &Path, at: u64, version: u32) -> Result<Layer, ImportError> {
    let fault = || ImportError::malformed(path, at, "a layer that ends too early");
    let (&count, mut rest) = bytes.split_first_chunk().ok_or_else(fault)?;
    let mut cubes = Vec::new();
    for _ in 0..u32::from_le_bytes(count) {
        let (cube, others) = rest.split_first_chunk::<20>().ok_or_else(fault)?;
        rest = others;
        let words: [[u8; 4]; 5] = std::array::from_fn(|word| std::array::from_fn(|byte| cube[4 * word + byte]));
        let mut corner = IVec3::from_array([1, 2, 3].map(|word| i32::from_le_bytes(words[word])));
        if version == 1 {
            // Cubes were placed by their middle.
            corner = corner.saturating_sub(IVec3::splat(EDGE / 2));
        }
        if corner.clamp(IVec3::splat(-MAX_COORDINATE), IVec3::splat(MAX_COORDINATE - EDGE)) != corner {
            let what = format!("a cube at {corner}, beyond {MAX_COORDINATE}");
            return Err(ImportError::malformed(path, at, what));
        }
        cubes.push((u32::from_le_bytes(words[0]) as usize, corner));
    }
    let visible = entry(rest, b"visible");
    let is_copy = entry(rest, b"base_id").is_some_and(|id| id.iter().any(|&byte| byte != 0));
    let is_derived = is_copy || entry(rest, b"shape").is_some();
    Ok(Layer { cubes, is_visible: visible.is_none_or(|value| value.first() != Some(&0)), is_derived })
}

/// The value of a name; each is behind its length, and a length of 0 is the end.
fn entry<'a>(mut rest: &'a [u8], wanted: &[u8]) -> Option<&'a [u8]> {
    let mut take = || -> Option<&'a [u8]> {
        let (length, after) = rest.split_first_chunk()?;
        let (text, after) = after.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        rest = after;
        Some(text)
    };
    loop {
        let name = take().filter(|name| !name.is_empty())?;
        let value = take()?;
        if name == wanted {
            return Some(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_whose_voxels_the_file_has_not_are_told() {
        let entry = |name: &str, value: &[u8]| {
            [&(name.len() as u32).to_le_bytes()[..], name.as_bytes(), &(value.len() as u32).to_le_bytes(), value]
                .concat()
        };
        let layer = |entries: &[Vec<u8>]| {
            let bytes = [&0u32.to_le_bytes()[..], &entries.concat()].concat();
            [&b"LAYR"[..], &(bytes.len() as u32).to_le_bytes(), &bytes, &[0; 4]].concat()
        };
        let empty = layer(&[entry("name", b"empty"), entry("base_id", &[0; 4])]);
        let copy = layer(&[entry("base_id", &[3, 0, 0, 0]), entry("visible", &[1])]);
        let hidden = layer(&[entry("base_id", &[3, 0, 0, 0]), entry("visible", &[0])]);
        let shape = layer(&[entry("shape", b"sphere")]);
        let notes = |layers: &[&Vec<u8>]| {
            let layers = layers.iter().flat_map(|layer| layer.iter().copied());
            let bytes: Vec<u8> = b"GOX \x02\0\0\0".iter().copied().chain(layers).collect();
            let limits = Limits::default();
            read(Input::of_bytes(&bytes, Path::new("a.gox"), &limits).unwrap(), &limits).unwrap().notes
        };
        assert!(notes(&[&empty, &hidden]).is_empty());
        let told = notes(&[&empty, &copy, &hidden, &shape]);
        assert!(told.len() == 1 && told[0].starts_with("2 layers that are copies"), "{told:?}");
    }
}
