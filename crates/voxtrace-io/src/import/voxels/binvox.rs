//! binvox, runs of voxels without colours (Kazhdan and Min): lines of text, then pairs of a value and a count. y runs fastest,
//! then z, then x; y is up.

use crate::import::grids::checked_size;
use crate::import::grids::paints::Paints;
use crate::import::grids::slab::Slabs;
use crate::import::reader::Voxels;
use crate::import::reader::{Kind, Magic, Reader};
use crate::import::source::input::Input;
use glam::IVec3;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("binvox", Kind::Voxels, &["binvox"], "voxels without colours", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, &options.limits)?.into())
    })
    .with_magic(&[Magic::first(MAGIC)])
    .with_up_axis(Some(UpAxis::Y));

/// First bytes of a file.
const MAGIC: &[u8] = b"#binvox";
/// Most lines of a header.
const MOST_LINES: u32 = 100;

/// Reads a binvox file.
fn read(mut input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    if !input.line()?.is_some_and(|line| line.starts_with(MAGIC)) {
        return Err(ImportError::malformed(path, 0, "the file does not begin with #binvox"));
    }
    let mut size = None;
    let mut lines = 0;
    let size = loop {
        let offset = input.offset();
        let Some(line) = input.line()? else { return Err(ImportError::truncated(path, offset, "the header")) };
        let text = String::from_utf8_lossy(line.get(..line.len().min(256)).unwrap_or_default()).into_owned();
        let mut words = text.split_ascii_whitespace();
        lines += 1;
        match words.next() {
            Some("dim") => {
                let sizes: Option<Vec<u64>> = words.map(|word| word.parse().ok()).collect();
                let sizes = sizes.and_then(|sizes| <[u64; 3]>::try_from(sizes).ok());
                size = Some(sizes.ok_or_else(|| ImportError::malformed(path, offset, format!("the size {text:?}")))?);
            }
            Some("data") => break size.ok_or_else(|| ImportError::malformed(path, offset, "data without a size"))?,
            _ if lines > MOST_LINES => return Err(ImportError::malformed(path, offset, "a header without an end")),
            _ => {}
        }
    };
    // The first is along x, the second along z and the third along y, which is how the values run.
    let [width, depth, height] = size;
    let offset = input.offset();
    let size = checked_size(path, offset, size, limits)?;
    let mut slabs = Slabs::new(path, offset, size, 0)?;
    let mut paints = Paints::default();
    let places = width * depth * height;
    let mut place = 0;
    while place < places {
        let offset = input.offset();
        let pair = input.take(2, "the voxels")?;
        let (value, count) = (pair[0], u64::from(pair[1]));
        if count == 0 || place + count > places {
            let what = format!("a run of {count} voxels where {} are left", places - place);
            return Err(ImportError::malformed(path, offset, what));
        }
        if value != 0 {
            let material = paints.material(color_of(value));
            for place in place..place + count {
                let (y, z, x) = (place % height, place / height % depth, place / (height * depth));
                slabs.set(IVec3::new(x as i32, (depth - 1 - z) as i32, y as i32), material);
            }
        }
        place += count;
    }
    let mut scene = Scene::from_grid("", slabs.finish(), paints.finish());
    scene.instances[0].world_from_grid.translation.y = -(depth as f32);
    Ok(Voxels { scene, notes: Vec::new() })
}

/// Grey for the one value of version 1; a shade of its own for each other value of version 2.
fn color_of(value: u8) -> [u8; 3] {
    if value == 1 {
        return [0xcc; 3];
    }
    [37u8, 91, 149].map(|step| 64 + value.wrapping_mul(step) % 160)
}
