//! The cells of a benchmark: which traversals with which primitives are measured on each scene.

use voxtrace::Instructions;
use voxtrace_vulkan::{DeviceInfo, Primitive, Traversal, missing};

/// Vector instructions of the CPU, as cells name them.
const INSTRUCTIONS: [(&str, Instructions); 5] = [
    ("avx512", Instructions::Avx512),
    ("avx2", Instructions::Avx2),
    ("neon", Instructions::Neon),
    ("portable", Instructions::Portable),
    ("scalar", Instructions::Scalar),
];
/// How shaders round, as cells name it: whether they give the CPU's bits.
const SHADERS: [(&str, bool); 2] = [("fast", false), ("precise", true)];

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
    /// No vector instructions have this name.
    #[error("{_0:?} names no instructions of a CPU: all, {all}", all = INSTRUCTIONS.map(|(name, _)| name).join(", "))]
    UnknownInstructions(String),
}

/// One way to find voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    pub traversal: Traversal,
    /// `None` for traversals without acceleration structures.
    pub primitive: Option<Primitive>,
    /// Vector instructions that the CPU traces with, `None` for those of the process.
    pub instructions: Option<Instructions>,
    /// Whether shaders give the CPU's bits, `None` as the benchmark says.
    pub is_exact: Option<bool>,
}

impl Cell {
    /// The cell that the others are compared with: the study's exact method.
    pub const REFERENCE: Self = Self::new(Traversal::Pipeline, Some(Primitive::VoxelExact));
    /// The study's approximate method.
    pub const APPROXIMATE: Self = Self::new(Traversal::Pipeline, Some(Primitive::VoxelApprox));
    const CPU: Self = Self::new(Traversal::Cpu, None);

    /// A traversal with a primitive, or without, and nothing else said.
    pub const fn new(traversal: Traversal, primitive: Option<Primitive>) -> Self {
        Self { traversal, primitive, instructions: None, is_exact: None }
    }

    /// As it is written with `--cells`.
    pub fn name(self) -> String {
        let instructions = INSTRUCTIONS.iter().find(|known| Some(known.1) == self.instructions);
        let shaders = SHADERS.iter().find(|known| Some(known.1) == self.is_exact);
        let parts = [
            Some(self.traversal.name()),
            self.primitive.map(Primitive::name),
            instructions.map(|known| known.0),
            shaders.map(|known| known.0),
        ];
        parts.into_iter().flatten().collect::<Vec<_>>().join(":")
    }
}

/// All primitives of a traversal, or the one cell of a traversal without.
fn of_traversal(traversal: Traversal) -> Vec<Cell> {
    match traversal.uses_primitives() {
        true => Primitive::ALL.map(|primitive| Cell::new(traversal, Some(primitive))).to_vec(),
        false => vec![Cell::new(traversal, None)],
    }
}

/// `TRAVERSAL`, `TRAVERSAL:PRIMITIVE` or `TRAVERSAL:all`, on a device with `:fast` or `:precise` behind it; `cpu:INSTRUCTIONS`, or
/// `cpu:all` for those that this processor has.
pub fn parse(text: &str) -> Result<Vec<Cell>, CellError> {
    let (traversal, rest) = text.split_once(':').map_or((text, None), |(a, b)| (a, Some(b)));
    let Some(traversal) = Traversal::ALL.into_iter().find(|known| known.name() == traversal) else {
        return Err(CellError::UnknownTraversal(traversal.to_owned()));
    };
    if traversal == Traversal::Cpu {
        return rest.map_or(Ok(vec![Cell::CPU]), of_instructions);
    }
    let (shaders, primitive) = match rest.map(|rest| (rest, rest.rsplit_once(':').map_or(rest, |(_, last)| last))) {
        None => (None, None),
        Some((rest, last)) => match SHADERS.iter().find(|known| known.0 == last) {
            Some((_, is_exact)) => (Some(*is_exact), rest.strip_suffix(last).and_then(|rest| rest.strip_suffix(':'))),
            None => (None, Some(rest)),
        },
    };
    let cells = of_primitive(traversal, primitive)?;
    Ok(cells.into_iter().map(|cell| Cell { is_exact: shaders, ..cell }).collect())
}

/// The cells of the CPU by the name of instructions, or of all that this processor has.
fn of_instructions(name: &str) -> Result<Vec<Cell>, CellError> {
    let is_meant = |known: &(&str, Instructions)| match name {
        "all" | "*" => known.1.is_available(),
        name => known.0 == name,
    };
    let meant = INSTRUCTIONS.into_iter().filter(is_meant);
    let cells: Vec<Cell> =
        meant.map(|(_, instructions)| Cell { instructions: Some(instructions), ..Cell::CPU }).collect();
    if cells.is_empty() { Err(CellError::UnknownInstructions(name.to_owned())) } else { Ok(cells) }
}

fn of_primitive(traversal: Traversal, primitive: Option<&str>) -> Result<Vec<Cell>, CellError> {
    match primitive {
        Some(_) if !traversal.uses_primitives() => Err(CellError::NoPrimitives(traversal.name())),
        Some("all" | "*") => Ok(of_traversal(traversal)),
        None if traversal.uses_primitives() => Ok(vec![Cell::new(traversal, Some(Primitive::default()))]),
        None => Ok(of_traversal(traversal)),
        Some(name) => match Primitive::ALL.into_iter().find(|known| known.name() == name) {
            Some(primitive) => Ok(vec![Cell::new(traversal, Some(primitive))]),
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

    #[test]
    fn instructions_of_the_cpu_and_rounding_of_shaders_are_part_of_a_cell() {
        for name in ["cpu:avx512", "cpu:scalar", "walk:fast", "walk:precise", "query:brick:fast"] {
            let cells = parse(name).unwrap();
            assert_eq!((cells.len(), cells[0].name()), (1, name.to_owned()));
        }
        assert_ne!(parse("walk:fast"), parse("walk"));
        let all = parse("cpu:all").unwrap();
        assert!(all.iter().all(|cell| cell.instructions.is_some_and(Instructions::is_available)));
        assert!(all.len() >= 2 && all.last().unwrap().name() == "cpu:scalar");
        let precise = parse("pipeline:all:precise").unwrap();
        assert_eq!(precise.len(), Primitive::ALL.len());
        assert!(precise.iter().all(|cell| cell.is_exact == Some(true)));
        assert_eq!(parse("pipeline:fast").unwrap()[0].name(), "pipeline:brick:fast");
        for wrong in [
            "cpu:",
            "cpu:fast",
            "cpu:avx",
            "cpu:avx2:fast",
            "walk:",
            "walk:fast:",
            "walk:fast:precise",
            "query:fast:brick",
        ] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
