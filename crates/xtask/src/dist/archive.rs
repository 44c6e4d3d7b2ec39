//! A `.tar.gz` whose bytes depend on what it holds alone: sorted names, no times, no owners.

use flate2::{Compression, write::GzEncoder};
use std::fs::File;
use std::io;
use std::path::Path;
use tar::{Builder, HeaderMode};

/// Packs a folder under the name `name`.
pub fn write(folder: &Path, name: &str, archive: &Path) -> io::Result<()> {
    let mut builder = Builder::new(GzEncoder::new(File::create(archive)?, Compression::best()));
    builder.mode(HeaderMode::Deterministic);
    append(&mut builder, folder, Path::new(name))?;
    builder.into_inner()?.finish()?.sync_all()
}

fn append<W: io::Write>(builder: &mut Builder<W>, folder: &Path, name: &Path) -> io::Result<()> {
    builder.append_dir(name, folder)?;
    let mut entries = std::fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let (path, name) = (entry.path(), name.join(entry.file_name()));
        if path.is_dir() {
            append(builder, &path, &name)?;
        } else {
            builder.append_path_with_name(&path, name)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::write;
    use std::fs;
    use std::io::Read;

    #[test]
    fn the_same_files_give_the_same_bytes_and_come_back() {
        let folder = tempfile::tempdir().unwrap();
        let archive = |files: [(&str, &str); 2], name: &str| {
            let source = folder.path().join(name);
            for (file, text) in files {
                let file = source.join(file);
                fs::create_dir_all(file.parent().unwrap()).unwrap();
                fs::write(file, text).unwrap();
            }
            let packed = folder.path().join(format!("{name}.tar.gz"));
            write(&source, "program", &packed).unwrap();
            fs::read(packed).unwrap()
        };
        let first = archive([("man/a.1", "page"), ("README.md", "text")], "first");
        assert!(archive([("README.md", "text"), ("man/a.1", "page")], "second") == first);
        assert!(archive([("README.md", "other"), ("man/a.1", "page")], "third") != first);

        let mut found = Vec::new();
        for entry in tar::Archive::new(flate2::read::GzDecoder::new(&first[..])).entries().unwrap() {
            let mut entry = entry.unwrap();
            let mut text = String::new();
            entry.read_to_string(&mut text).unwrap();
            found.push((entry.path().unwrap().to_string_lossy().trim_end_matches('/').to_owned(), text));
        }
        let wanted = [("program", ""), ("program/README.md", "text"), ("program/man", ""), ("program/man/a.1", "page")];
        assert_eq!(found, wanted.map(|(path, text)| (path.to_owned(), text.to_owned())));
    }
}
