//! Names of files that are not there yet.

use std::io;
use std::path::{Path, PathBuf};

/// The file of a number: `a/church-001.png`.
fn numbered(folder: &Path, stem: &str, number: u32) -> PathBuf {
    folder.join(format!("{stem}-{number:03}.png"))
}

/// The first free name of a picture in a folder: `church-001.png` and on.
pub fn free_name(folder: &Path, stem: &str) -> PathBuf {
    let number = (1..).find(|&number| !numbered(folder, stem, number).exists()).unwrap_or(u32::MAX);
    numbered(folder, stem, number)
}

/// Gives a file that was written under another name in the same folder its own: the one that is wanted, or the next free one of its kind. A
/// file that is there is never written over, also where two windows want one name.
///
/// # Errors
/// What the operating system reports.
pub fn place(written: &Path, wanted: &Path) -> io::Result<PathBuf> {
    let stem = wanted.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let numbers = stem.rsplit_once('-').and_then(|(stem, number)| Some((stem, number.parse().ok()?)));
    let (stem, first) = numbers.unwrap_or((&stem, 1));
    let folder = wanted.parent().unwrap_or(Path::new(""));
    for number in first..=u32::MAX {
        let path = numbered(folder, stem, number);
        match std::fs::hard_link(written, &path) {
            Ok(()) => {
                std::fs::remove_file(written)?;
                return Ok(path);
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            // Not every file system has links. An empty file of ours keeps the name, and goes when it is taken.
            Err(_) => match std::fs::File::create_new(&path) {
                Ok(_) => {
                    let renamed = std::fs::rename(written, &path);
                    if renamed.is_err() {
                        // Nothing is behind the name.
                        let _ = std::fs::remove_file(&path);
                    }
                    return renamed.map(|()| path);
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            },
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_taken_once_however_often_it_is_wanted() {
        let folder = tempfile::tempdir().unwrap();
        let wanted = free_name(folder.path(), "my-room");
        assert_eq!(wanted, folder.path().join("my-room-001.png"));
        let placed = |text: &str| {
            let written = folder.path().join(".part");
            std::fs::write(&written, text).unwrap();
            let path = place(&written, &wanted).unwrap();
            assert!(!written.exists());
            path
        };
        for text in ["one", "two", "three"] {
            assert_eq!(std::fs::read_to_string(placed(text)).unwrap(), text);
        }
        let texts = (1..=3).map(|number| std::fs::read_to_string(numbered(folder.path(), "my-room", number)).unwrap());
        assert_eq!(texts.collect::<Vec<_>>(), ["one", "two", "three"], "none was written over");
        assert_eq!(free_name(folder.path(), "my-room"), folder.path().join("my-room-004.png"));
        assert!(place(&folder.path().join("nothing"), &wanted).is_err());
        assert_eq!(free_name(folder.path(), "my-room"), folder.path().join("my-room-004.png"), "no empty file is left");
    }
}
