//! The cells of a benchmark: which traversals with which primitives are measured on each scene.

use voxtrace_vulkan::{DeviceInfo, Primitive, Traversal, missing};

/// A cell that does not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CellError {
    /// No traversal has this name.
    #[error("{_0:?} is no traversal: {all}", all = Traversal::ALL.map(Traversal::name).join(", "))]
    UnknownTraversal(String),
    /// The traversal of this name finds voxels without primitives.
    #[error("{0} has no primitives")]
    NoPrimitives(&'static str),
    /// No primitive has this name.
    #[error("{_0:?} is no primitive: all, {all}", all = Primitive::ALL.map(Primitive::name).join(", "))]
    UnknownPrimitive(String),
}

/// One way to find voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    pub traversal: Traversal,
    /// `None` for traversals without acceleration structures.
    pub primitive: Option<Primitive>,
}

impl Cell {
    /// The cell that the others are compared with: the study's exact method.
    pub const REFERENCE: Self = Self { traversal: Traversal::Pipeline, primitive: Some(Primitive::VoxelExact) };
    /// The study's approximate method.
    pub const APPROXIMATE: Self = Self { traversal: Traversal::Pipeline, primitive: Some(Primitive::VoxelApprox) };
    const CPU: Self = Self { traversal: Traversal::Cpu, primitive: None };

    /// As it is written with `--cells`.
    pub fn name(self) -> String {
        match self.primitive {
            Some(primitive) => format!("{}:{}", self.traversal.name(), primitive.name()),
            None => self.traversal.name().to_owned(),
        }
    }
}

/// All primitives of a traversal, or the one cell of a traversal without.
fn of_traversal(traversal: Traversal) -> Vec<Cell> {
    match traversal.uses_primitives() {
        true => Primitive::ALL.map(|primitive| Cell { traversal, primitive: Some(primitive) }).to_vec(),
        false => vec![Cell { traversal, primitive: None }],
    }
}

/// `TRAVERSAL`, `TRAVERSAL:PRIMITIVE` or `TRAVERSAL:all`.
pub fn parse(text: &str) -> Result<Vec<Cell>, CellError> {
    let (traversal, primitive) = text.split_once(':').map_or((text, None), |(a, b)| (a, Some(b)));
    let Some(traversal) = Traversal::ALL.into_iter().find(|known| known.name() == traversal) else {
        return Err(CellError::UnknownTraversal(traversal.to_owned()));
    };
    match primitive {
        Some(_) if !traversal.uses_primitives() => Err(CellError::NoPrimitives(traversal.name())),
        Some("all" | "*") => Ok(of_traversal(traversal)),
        None if traversal.uses_primitives() => Ok(vec![Cell { traversal, primitive: Some(Primitive::default()) }]),
        None => Ok(of_traversal(traversal)),
        Some(name) => match Primitive::ALL.into_iter().find(|known| known.name() == name) {
            Some(primitive) => Ok(vec![Cell { traversal, primitive: Some(primitive) }]),
            None => Err(CellError::UnknownPrimitive(name.to_owned())),
        },
    }
}

/// The plan where none is asked for: the study's two cells on a device, and with `is_full` everything else that it
/// offers, and the CPU; the CPU alone without a device.
pub fn planned(device: Option<&DeviceInfo>, is_full: bool) -> Vec<Cell> {
    let Some(device) = device else { return vec![Cell::CPU] };
    let mut cells = vec![Cell::REFERENCE, Cell::APPROXIMATE];
    if is_full {
        let offered = [Traversal::Pipeline, Traversal::Query, Traversal::Walk].into_iter();
        let offered = offered.filter(|&traversal| missing(device, traversal).is_none());
        cells
            .extend(offered.flat_map(of_traversal).filter(|cell| ![Cell::REFERENCE, Cell::APPROXIMATE].contains(cell)));
        cells.push(Cell::CPU);
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_read_as_it_is_written_and_all_means_every_primitive() {
        for cell in [Cell::REFERENCE, Cell::APPROXIMATE, Cell::CPU] {
            assert_eq!(parse(&cell.name()), Ok(vec![cell]));
        }
        assert_eq!(parse("query").unwrap()[0].name(), "query:brick");
        assert_eq!(parse("query:all").map(|cells| cells.len()), Ok(Primitive::ALL.len()));
        for wrong in ["", "gpu", "walk:brick", "query:voxel"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
