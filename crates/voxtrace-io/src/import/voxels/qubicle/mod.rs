//! Models of Qubicle (Minddesk) in its four formats: binary `.qb`, tree `.qbt`, project `.qbcl`, exchange `.qef`. All hold boxes
//! of colours, called matrices. y is up, and z points to the viewer where a file does not say otherwise.

mod binary;
mod exchange;
mod matrix;
mod project;
mod tree;

use crate::import::reader::Voxels;
use crate::import::reader::{Kind, Magic, Reader};
use crate::import::source::input::Input;
use matrix::{Matrix, Model};
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "Qubicle",
    Kind::Voxels,
    &["qb", "qbt", "qbcl", "qef"],
    "Qubicle model, and .qbt, .qbcl, .qef: matrices of colours",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, &options.limits)?.into())
    },
)
.with_magic(&[Magic::first(TREE), Magic::first(PROJECT), Magic::first(EXCHANGE)])
.with_up_axis(Some(UpAxis::Y));

/// First bytes of a `.qbt`.
const TREE: &[u8] = b"QB 2";
/// First bytes of a `.qbcl`.
const PROJECT: &[u8] = b"QBCL";
/// First bytes of a `.qef`.
const EXCHANGE: &[u8] = b"Qubicle Exchange Format";

/// Reads a model in whichever of the formats its first bytes say; `.qb` has none of its own.
fn read(mut input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let mut model = Model::new(input.path(), limits);
    let head = input.peek(EXCHANGE.len())?;
    if head.starts_with(TREE) {
        tree::read(&mut input, &mut model)?;
    } else if head.starts_with(PROJECT) {
        project::read(&mut input, &mut model)?;
    } else if head.starts_with(EXCHANGE) {
        exchange::read(&mut input, &mut model)?;
    } else {
        binary::read(&mut input, &mut model)?;
    }
    Ok(model.finish())
}

fn number(input: &mut Input) -> Result<u32, ImportError> {
    let bytes = input.take(4, "a number")?;
    Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
}

fn numbers<const N: usize>(input: &mut Input) -> Result<[u32; N], ImportError> {
    let mut numbers = [0; N];
    for value in &mut numbers {
        *value = number(input)?;
    }
    Ok(numbers)
}

/// A text behind its length.
fn text(input: &mut Input) -> Result<String, ImportError> {
    let length = number(input)? as usize;
    Ok(String::from_utf8_lossy(input.take(length, "a name")?).into_owned())
}
