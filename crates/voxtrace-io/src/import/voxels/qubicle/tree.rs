//! Qubicle Binary Tree, `.qbt` (specification by Minddesk, version 1): a palette or none, and a tree of matrices, groups of them
//! and compounds. A compound's own matrix has all of its parts together, so those are gone over.

use super::{Matrix, Model, number, numbers, text};
use crate::import::source::inflate::unzlib;
use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Bytes in front of the sections: magic, version, scale.
const HEAD: usize = 18;

/// Reads a Qubicle Binary Tree.
pub(super) fn read(input: &mut Input, model: &mut Model) -> Result<(), ImportError> {
    input.take(HEAD, "the head of a tree")?;
    section(input, b"COLORMAP")?;
    let (offset, count) = (input.offset(), number(input)?);
    // An index has one byte.
    if count > 256 {
        return Err(ImportError::malformed(model.path, offset, format!("a palette of {count} colours")));
    }
    let palette = input.take(4 * count as usize, "a palette")?.as_chunks().0.to_vec();
    section(input, b"DATATREE")?;
    let mut tree = Tree { model, palette };
    tree.node(input, 0, true)
}

fn section(input: &mut Input, name: &[u8; 8]) -> Result<(), ImportError> {
    let (path, offset) = (input.path(), input.offset());
    if input.take(8, "the name of a section")? != name {
        let what = format!("no section {} where it belongs", String::from_utf8_lossy(name));
        return Err(ImportError::malformed(path, offset, what));
    }
    Ok(())
}

struct Tree<'m, 'a> {
    model: &'m mut Model<'a>,
    /// Colours and an unused byte; empty where voxels have colours of their own.
    palette: Vec<[u8; 4]>,
}

impl Tree<'_, '_> {
    /// Reads a node, and adds what it holds to the scene if `is_seen`.
    fn node(&mut self, input: &mut Input, depth: u32, is_seen: bool) -> Result<(), ImportError> {
        self.model.enter_node(input.offset(), depth)?;
        let [kind, length] = numbers(input)?;
        match kind {
            0 => self.matrix(input, is_seen),
            1 => self.children(input, depth, is_seen),
            2 => {
                self.matrix(input, is_seen)?;
                self.children(input, depth, false)
            }
            _ => {
                self.model.notes.push(format!("a node of the unknown kind {kind} is left out"));
                input.skip(length.into(), "a node")
            }
        }
    }

    fn children(&mut self, input: &mut Input, depth: u32, is_seen: bool) -> Result<(), ImportError> {
        for _ in 0..number(input)? {
            self.node(input, depth + 1, is_seen)?;
        }
        Ok(())
    }

    fn matrix(&mut self, input: &mut Input, is_seen: bool) -> Result<(), ImportError> {
        let path = input.path();
        let name = text(input)?;
        let offset = input.offset();
        let position = numbers(input)?.map(|value: u32| value as i32);
        let scale: [u32; 3] = numbers(input)?;
        let _pivot: [u32; 3] = numbers(input)?;
        let size @ [width, height, depth] = numbers(input)?;
        let length = number(input)?;
        if !is_seen || size.contains(&0) {
            return input.skip(length.into(), "the voxels of a matrix");
        }
        if scale.iter().any(|&scale| scale > 1) {
            let note = "matrices with a scale of their own are read without it".to_owned();
            if !self.model.notes.contains(&note) {
                self.model.notes.push(note);
            }
        }
        let matrix = Matrix { name, size, position, is_away: false };
        let mut slabs = self.model.slabs(&matrix, offset, 0)?;
        let start = input.offset();
        let packed = input.take(length as usize, "the voxels of a matrix")?.to_vec();
        let mut data = unzlib(Input::of_owned(packed, path, self.model.limits), self.model.limits);
        for (x, z) in (0..width).flat_map(|x| (0..depth).map(move |z| (x, z))) {
            for up in 0..height {
                let place = |error: ImportError| error.with_offset(Some(start));
                let bytes = data.take(4, "the voxels of a matrix").map_err(place)?;
                let [first, green, blue, mask] = [bytes[0], bytes[1], bytes[2], bytes[3]];
                if mask == 0 {
                    continue;
                }
                let rgb = if self.palette.is_empty() {
                    [first, green, blue]
                } else {
                    let Some([red, green, blue, _]) = self.palette.get(usize::from(first)) else {
                        let kind = ImportErrorKind::Malformed(format!("the colour {first} is not in the palette"));
                        return Err(ImportError::at(path, start, kind));
                    };
                    [*red, *green, *blue]
                };
                slabs.set(matrix.place(x, up, z), self.model.paints.material(rgb));
            }
        }
        let grid = slabs.finish();
        self.model.add(matrix, grid);
        Ok(())
    }
}
