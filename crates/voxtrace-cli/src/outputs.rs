//! Files to write. None may be a file that the same run reads, by whatever path, and a default name
//! may not replace a file that voxtrace did not write (docs/decisions/0037-outputs-and-inputs.md).

use crate::failure::{Failure, Kind};
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, BufWriter, Read};
use std::path::{Path, PathBuf};
use voxtrace::import::opened::{self, Inputs, IsInput};
use voxtrace::output::{check_writable, write_atomically};

/// Bytes at the start of a picture that hold the name of the program that wrote it.
const HEAD: u64 = 1 << 16;

/// Refuses to replace the film that is being continued by something that is no film.
pub fn refuse_same(path: &Path, film: &Path) -> Result<(), Failure> {
    if opened::is_same(path, film) {
        let failure =
            Failure::new(Kind::Output, format!("cannot write {}: it is the film to continue", path.display()));
        return Err(failure.hint("name another file"));
    }
    Ok(())
}

/// Refuses to write where this run reads, as far as that is known by now.
pub fn refuse_inputs(path: &Path) -> Result<(), Failure> {
    refuse(&Inputs::now(), path)
}

/// As [`refuse_inputs`], for many outputs.
pub fn refuse(inputs: &Inputs, path: &Path) -> Result<(), Failure> {
    inputs.refuse(path).map_err(|error| {
        let failure = Failure::new(Kind::Output, format!("cannot write {}: {error}", path.display()));
        failure.hint(match error {
            IsInput::Folder(_) => "name a file outside of it",
            _ => "a scene, and what it names, is never written over; name another file",
        })
    })
}

/// Refuses, before the long work starts, what cannot be written or is read.
pub fn check(path: &Path) -> Result<(), Failure> {
    refuse_inputs(path)?;
    check_writable(path).map_err(|error| Failure::output(path, &error))
}

/// Refuses two outputs that are one file: `a.png`, `./a.png` and `b/../a.png` are.
pub fn refuse_twice(paths: &[&Path]) -> Result<(), Failure> {
    let place = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = folder.canonicalize().or_else(|_| std::path::absolute(folder)).unwrap_or_else(|_| folder.into());
        folder.join(path.file_name().unwrap_or_default())
    };
    let mut known = BTreeSet::new();
    match paths.iter().find(|path| !known.insert(place(path))) {
        Some(path) => Err(Failure::usage(format!("{} is written twice", path.display())).hint("name each output once")),
        None => Ok(()),
    }
}

/// Writes a file that this run does not read, whole or not at all.
pub fn write(path: &Path, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> Result<(), Failure> {
    refuse_inputs(path)?;
    write_atomically(path, write).map_err(|error| Failure::output(path, &error))
}

/// Refuses to replace a file of another program under a default name.
pub fn refuse_foreign(path: &Path, force: bool) -> Result<(), Failure> {
    if force || !path.is_file() || is_ours(path) {
        return Ok(());
    }
    let message = format!("{} is there already, and voxtrace did not write it", path.display());
    Err(Failure::new(Kind::Output, message).hint("name the output with -o, or say --force"))
}

/// Refuses to replace a file of another program under a name that follows from that of an output.
pub fn refuse_foreign_companion(path: &Path, out: &Path) -> Result<(), Failure> {
    if !path.is_file() || is_ours(path) {
        return Ok(());
    }
    let message = format!(
        "cannot write {}: {} belongs to it, is there already, and voxtrace did not write it",
        out.display(),
        path.display()
    );
    Err(Failure::new(Kind::Output, message).hint("name another file"))
}

/// Whether a file says that voxtrace wrote it.
pub fn is_ours(path: &Path) -> bool {
    let mut head = Vec::new();
    if File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head)).is_err() {
        return false;
    }
    let holds = |text: &[u8]| head.windows(text.len()).any(|part| part == text);
    let is_picture = head.starts_with(b"\x89PNG\r\n\x1a\n") || head.starts_with(&[0x76, 0x2f, 0x31, 0x01]);
    head.starts_with(&voxtrace::packed::MAGIC)
        || head.starts_with(voxtrace::output::FILM_MAGIC)
        || head.starts_with(voxtrace::export::MTL_HEAD.as_bytes())
        || (is_picture && holds(b"voxtrace.scene_hash"))
}

/// The name of a picture that was broken off: `shot_0003.part.png`.
pub fn part_path(path: &Path) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let extension = path.extension().map_or(String::new(), |extension| format!(".{}", extension.to_string_lossy()));
    path.with_file_name(format!("{stem}.part{extension}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_output_is_named_once_by_whatever_path() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("b")).unwrap();
        let twice = |names: &[&str]| {
            let paths: Vec<PathBuf> = names.iter().map(|name| folder.path().join(name)).collect();
            refuse_twice(&paths.iter().map(PathBuf::as_path).collect::<Vec<_>>()).is_err()
        };
        assert!(twice(&["a.png", "b.png", "a.png"]) && twice(&["a.png", "./a.png"]) && twice(&["b/../a.png", "a.png"]));
        assert!(!twice(&["a.png", "b/a.png", "a.exr", "none/a.png"]) && !twice(&[]));
    }

    #[test]
    fn the_part_of_a_picture_keeps_its_kind() {
        assert_eq!(part_path(Path::new("a.b/shot_0003.png")), Path::new("a.b/shot_0003.part.png"));
        assert_eq!(part_path(Path::new("shot.tar.exr")), Path::new("shot.tar.part.exr"));
    }
}
