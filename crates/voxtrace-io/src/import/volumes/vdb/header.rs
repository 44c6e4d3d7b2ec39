//! The head of a file: versions, facts about the file, and for each grid where it lies.

use super::MAGIC;
use super::cursor::Cursor;
use super::grid::Grid;
use super::values::Number;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// The first version that compresses each grid in its own way, 2012.
const OLDEST: u32 = 222;
/// The last one that is known.
const NEWEST: u32 = 224;
/// Characters of the identifier.
const IDENTIFIER: u64 = 36;

/// The grids of numbers, and the names and kinds of others.
pub(super) fn read(cursor: &mut Cursor, limits: &Limits) -> Result<(Vec<Grid>, Vec<String>), ImportError> {
    if cursor.array::<8>("the head of the file")? != *MAGIC {
        return Err(ImportError::malformed(cursor.path, 0, "the file does not begin as OpenVDB's do"));
    }
    let unsupported = |what: String| ImportError::at(cursor.path, 8, ImportErrorKind::Unsupported(what));
    let version = cursor.u32("the head of the file")?;
    if !(OLDEST..=NEWEST).contains(&version) {
        return Err(unsupported(format!("version {version} of OpenVDB's files; {OLDEST} to {NEWEST} are read")));
    }
    let _library = cursor.array::<8>("the head of the file")?;
    let has_places = cursor.array::<1>("the head of the file")?[0] != 0;
    cursor.take(IDENTIFIER, "the head of the file")?;
    for_each_fact(cursor, limits, |_, _, _| {})?;
    let count = cursor.u32("the number of grids")?;
    if !has_places {
        return Err(unsupported("an OpenVDB file that was written as a stream".into()));
    }
    if u64::from(count) > limits.items {
        return Err(ImportError::limit(cursor.path, Some(cursor.at as u64), "grids", count.into(), limits.items));
    }
    let (mut grids, mut foreign) = (Vec::new(), Vec::new());
    for _ in 0..count {
        let what = "the head of a grid";
        // A number behind this sign tells grids of one name apart.
        let name = cursor.text(what)?.split('\x1e').next().unwrap_or_default().to_owned();
        let (kind, parent) = (cursor.text(what)?, cursor.text(what)?);
        let [start, blocks, end] = [cursor.i64(what)?, cursor.i64(what)?, cursor.i64(what)?];
        let grid = match Number::of_tree(&kind).filter(|_| parent.is_empty()) {
            Some(number) => {
                let mut cursor = *cursor;
                cursor.go(start)?;
                Grid::read(&mut cursor, name.clone(), number, blocks, limits)?
            }
            None => None,
        };
        match grid {
            Some(grid) => grids.push(grid),
            None => foreign.push(format!("{name} ({})", kind.trim_start_matches("Tree_"))),
        }
        if end < cursor.at as i64 {
            return Err(cursor.malformed("a grid that ends before it begins"));
        }
        cursor.go(end)?;
    }
    Ok((grids, foreign))
}

/// Gives name, kind and value of each fact of a file or a grid.
pub(super) fn for_each_fact(
    cursor: &mut Cursor,
    limits: &Limits,
    mut each: impl FnMut(&str, &str, &[u8]),
) -> Result<(), ImportError> {
    let what = "the facts about a grid or file";
    let count = cursor.u32(what)?;
    if u64::from(count) > limits.items {
        return Err(ImportError::limit(cursor.path, Some(cursor.at as u64), "facts", count.into(), limits.items));
    }
    for _ in 0..count {
        let (name, kind, length) = (cursor.text(what)?, cursor.text(what)?, cursor.u32(what)?);
        each(&name, &kind, cursor.take(length.into(), what)?);
    }
    Ok(())
}
