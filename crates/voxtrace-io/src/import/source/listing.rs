//! The files of a folder in the order in which people count: `slice2.png` comes before `slice10.png`.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// The files in a folder whose names do not begin with a dot, in natural order. Folders in it are left out.
pub(crate) fn files(folder: &Path, limits: &Limits) -> Result<Vec<PathBuf>, ImportError> {
    listed(folder, folder, 0, limits, &mut 0)
}

/// As [`files`], with those of folders in it, which come behind, down to the depth of the limits. Links to folders are not followed.
#[cfg(feature = "medical")]
pub(crate) fn files_below(folder: &Path, limits: &Limits) -> Result<Vec<PathBuf>, ImportError> {
    listed(folder, folder, limits.depth, limits, &mut 0)
}

fn listed(
    root: &Path,
    folder: &Path,
    depth: u32,
    limits: &Limits,
    count: &mut u64,
) -> Result<Vec<PathBuf>, ImportError> {
    let io = |error| ImportError::io(folder, error);
    let (mut found, mut below) = (Vec::new(), Vec::new());
    for entry in std::fs::read_dir(folder).map_err(io)? {
        let entry = entry.map_err(io)?;
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        if depth > 0 && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            below.push(entry.path());
        } else if entry.path().is_file() {
            found.push(entry.path());
        } else {
            continue;
        }
        *count += 1;
        if *count > limits.items {
            return Err(ImportError::limit(root, None, "files in the folder", *count, limits.items));
        }
    }
    let name = |path: &PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let by_name = |a: &PathBuf, b: &PathBuf| natural(&name(a), &name(b));
    found.sort_by(by_name);
    below.sort_by(by_name);
    for folder in below {
        // A folder that nobody may read has nothing to say.
        let is_closed = |error: &ImportError| matches!(&error.kind, ImportErrorKind::Io(_));
        match listed(root, &folder, depth - 1, limits, count) {
            Err(error) if is_closed(&error) => {}
            files => found.extend(files?),
        }
    }
    Ok(found)
}

/// Those of them with one of these extensions, which are in lower case.
pub(crate) fn files_with(folder: &Path, extensions: &[&str], limits: &Limits) -> Result<Vec<PathBuf>, ImportError> {
    let mut files = files(folder, limits)?;
    let extension = |path: &PathBuf| path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    files.retain(|path| extensions.contains(&&*extension(path)));
    Ok(files)
}

/// Runs of digits as numbers, everything else as it is.
fn natural(a: &str, b: &str) -> Ordering {
    let (mut a_rest, mut b_rest) = (a.as_bytes(), b.as_bytes());
    while let (Some(x), Some(y)) = (a_rest.first(), b_rest.first()) {
        let order = if x.is_ascii_digit() && y.is_ascii_digit() {
            let (x, y) = (take_number(&mut a_rest), take_number(&mut b_rest));
            // Without leading zeros, more digits are more.
            x.len().cmp(&y.len()).then_with(|| x.cmp(y))
        } else {
            (a_rest, b_rest) = (&a_rest[1..], &b_rest[1..]);
            x.cmp(y)
        };
        if order != Ordering::Equal {
            return order;
        }
    }
    a_rest.len().cmp(&b_rest.len()).then_with(|| a.cmp(b))
}

/// Takes the digits in front, and gives them without leading zeros.
fn take_number<'a>(rest: &mut &'a [u8]) -> &'a [u8] {
    let end = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(end);
    *rest = after;
    let zeros = digits.iter().position(|&digit| digit != b'0').unwrap_or(digits.len());
    &digits[zeros..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_sorted_as_people_count() {
        let mut names = ["b1", "a10", "a9", "a010b", "a", "a99999999999999999999999", "a2x", "a2"];
        names.sort_by(|a, b| natural(a, b));
        assert_eq!(names, ["a", "a2", "a2x", "a9", "a10", "a010b", "a99999999999999999999999", "b1"]);
    }

    #[test]
    fn hidden_files_and_folders_are_left_out_and_the_limit_holds() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["2.png", "10.png", ".hidden"] {
            std::fs::write(folder.path().join(name), "x").unwrap();
        }
        std::fs::create_dir(folder.path().join("1.png")).unwrap();
        let found = files(folder.path(), &Limits::default()).unwrap();
        let names: Vec<_> = found.iter().map(|path| path.file_name().unwrap().to_str().unwrap()).collect();
        assert_eq!(names, ["2.png", "10.png"]);
        assert!(files(folder.path(), &Limits { items: 1, ..Limits::default() }).is_err());
    }

    #[cfg(feature = "medical")]
    #[test]
    fn files_of_folders_below_come_behind_those_above() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["b/2/x", "b/10/x", ".no/x", "a"] {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "x").unwrap();
        }
        let names = |limits| {
            let found = files_below(folder.path(), &limits).map_err(|_| ())?;
            let own = found.iter().map(|path| path.strip_prefix(folder.path()).unwrap().to_string_lossy().into_owned());
            Ok::<Vec<String>, ()>(own.collect())
        };
        assert_eq!(names(Limits::default()).unwrap(), ["a", "b/2/x", "b/10/x"]);
        assert_eq!(names(Limits { depth: 1, ..Limits::default() }).unwrap(), ["a"]);
        assert!(names(Limits { items: 3, ..Limits::default() }).is_err());
    }
}
