//! Qubicle project, `.qbcl` (files of version 2; Minddesk has not described it, what is here is what files hold): a picture, texts,
//! then a tree as in `.qbt`, whose voxels are columns with runs.

use super::{Matrix, Model, number, numbers, text};
use crate::import::source::inflate::unzlib;
use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Texts about the model: title, description, keywords, author, company, site, rights.
const TEXTS: usize = 7;
/// Bytes of two dates.
const DATES: u64 = 16;
/// Bytes of a group's place, which has no meaning for what is in it.
const GROUP: u64 = 36;
/// The mask that marks a run.
const RUN: u8 = 2;

/// Reads a Qubicle project.
pub(super) fn read(input: &mut Input, model: &mut Model) -> Result<(), ImportError> {
    let path = input.path();
    let [_magic, _program, version, wide, high] = numbers(input)?;
    if version != 2 {
        let kind = ImportErrorKind::Unsupported(format!("version {version} of .qbcl"));
        return Err(ImportError::at(path, 8, kind));
    }
    input.skip(u64::from(wide).saturating_mul(4 * u64::from(high)), "the picture of the model")?;
    for _ in 0..TEXTS {
        text(input)?;
    }
    input.skip(DATES, "the dates of the model")?;
    let mut project = Project { model, hidden: 0 };
    project.node(input, 0, true)?;
    let hidden = project.hidden;
    if hidden > 0 {
        model.notes.push(format!("{hidden} hidden matrices are left out"));
    }
    Ok(())
}

struct Project<'m, 'a> {
    model: &'m mut Model<'a>,
    /// Matrices that somebody has hidden.
    hidden: u64,
}

impl Project<'_, '_> {
    /// Reads a node, and adds what it holds to the scene if `is_seen`.
    fn node(&mut self, input: &mut Input, depth: u32, is_seen: bool) -> Result<(), ImportError> {
        let (path, offset) = (input.path(), input.offset());
        self.model.enter_node(offset, depth)?;
        let [kind, _] = numbers(input)?;
        let name = text(input)?;
        let is_visible = input.take(3, "the state of a node")?[0] != 0;
        if is_seen && !is_visible && kind != 1 {
            self.hidden += 1;
        }
        let is_seen = is_seen && is_visible;
        match kind {
            0 => self.matrix(input, name, is_seen),
            1 => {
                input.skip(GROUP, "the place of a group")?;
                self.children(input, depth, is_seen)
            }
            2 => {
                self.matrix(input, name, is_seen)?;
                // Its own matrix has them all.
                self.children(input, depth, false)
            }
            _ => Err(ImportError::malformed(path, offset, format!("a node of the unknown kind {kind}"))),
        }
    }

    fn children(&mut self, input: &mut Input, depth: u32, is_seen: bool) -> Result<(), ImportError> {
        for _ in 0..number(input)? {
            self.node(input, depth + 1, is_seen)?;
        }
        Ok(())
    }

    fn matrix(&mut self, input: &mut Input, name: String, is_seen: bool) -> Result<(), ImportError> {
        let offset = input.offset();
        let size = numbers(input)?;
        let position = numbers(input)?.map(|value: u32| value as i32);
        let _pivot: [u32; 3] = numbers(input)?;
        let length = number(input)?;
        if !is_seen {
            return input.skip(length.into(), "the voxels of a matrix");
        }
        let matrix = Matrix { name, size, position, is_away: false };
        self.voxels(input, matrix, offset, length as usize)
    }

    fn voxels(&mut self, input: &mut Input, matrix: Matrix, offset: u64, length: usize) -> Result<(), ImportError> {
        let (path, limits) = (input.path(), self.model.limits);
        let mut slabs = self.model.slabs(&matrix, offset, 0)?;
        let start = input.offset();
        let packed = input.take(length, "the voxels of a matrix")?.to_vec();
        let mut data = unzlib(Input::of_owned(packed, path, limits), limits);
        let [width, height, depth] = matrix.size;
        let mut take = |count: usize| -> Result<[u8; 4], ImportError> {
            let bytes = data.take(count, "the voxels of a matrix");
            let bytes = bytes.map_err(|error| error.with_offset(Some(start)))?;
            Ok(std::array::from_fn(|at| bytes.get(at).copied().unwrap_or(0)))
        };
        for (x, z) in (0..width).flat_map(|x| (0..depth).map(move |z| (x, z))) {
            let [low, high, ..] = take(2)?;
            let (mut words, mut up) = (u16::from_le_bytes([low, high]), 0);
            while words > 0 {
                let (mut color, mut count) = (take(4)?, 1);
                words -= 1;
                if color[3] == RUN {
                    count = u32::from(color[0]);
                    color = take(4)?;
                    words = words.saturating_sub(1);
                }
                if up + count > height {
                    let what = format!("a column with more than its {height} voxels");
                    return Err(ImportError::malformed(path, start, what));
                }
                let [red, green, blue, mask] = color;
                if mask != 0 {
                    let material = self.model.paints.material([red, green, blue]);
                    (up..up + count).for_each(|up| slabs.set(matrix.place(x, up, z), material));
                }
                up += count;
            }
        }
        let grid = slabs.finish();
        self.model.add(matrix, grid);
        Ok(())
    }
}
