//! Atomic file writes: after a crash, a full disk or a power cut a file has its old content or its new one, never a part. New content
//! is written to a temporary file in the same folder, flushed to the disk, and renamed over the old file.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Temporary names tried before giving up; only files left by killed processes occupy any.
const MAX_ATTEMPTS: u32 = 1000;
/// Links to links that are followed, as systems do, where nothing is at their end.
const MAX_LINKS: u32 = 40;

/// Writes a file through `write`. When that or anything after it fails, the old file is untouched and nothing is left
/// behind. What is not a regular file (a pipe, a device) is written directly; a symbolic link is followed.
///
/// # Errors
/// What the operating system or `write` reports.
pub fn write_atomically(path: &Path, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let path = &follow_link(path);
    let old = existing(path)?;
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        let mut writer = BufWriter::new(OpenOptions::new().write(true).open(path)?);
        write(&mut writer)?;
        return writer.flush();
    }
    let temporary = TemporaryFile::create(path)?;
    let mut writer = BufWriter::with_capacity(1 << 20, temporary.file.try_clone()?);
    write(&mut writer)?;
    writer.flush()?;
    drop(writer);
    temporary.replace(path)
}

/// As [`write_atomically`], as long as it is `wanted`, which says no for good: once it is not, writing ends soon, with an error of
/// [`io::ErrorKind::Other`], the old file is untouched and nothing is left behind.
///
/// # Errors
/// As [`write_atomically`].
pub fn write_atomically_while(
    path: &Path,
    wanted: &dyn Fn() -> bool,
    write: impl FnOnce(&mut WriteWhile) -> io::Result<()>,
) -> io::Result<()> {
    write_atomically(path, |file| {
        let mut file = WriteWhile { inner: file, wanted, left: 0 };
        write(&mut file)?;
        file.check()
    })
}

/// Bytes that are written between two questions whether they are wanted.
const BETWEEN: usize = 1 << 16;

/// A file that is written as long as that is wanted.
pub struct WriteWhile<'a> {
    inner: &'a mut dyn Write,
    wanted: &'a dyn Fn() -> bool,
    /// Bytes until the next question.
    left: usize,
}

impl WriteWhile<'_> {
    /// Fails where nothing more is wanted.
    ///
    /// # Errors
    /// One of [`io::ErrorKind::Other`].
    pub fn check(&self) -> io::Result<()> {
        if (self.wanted)() { Ok(()) } else { Err(io::Error::other("stopped")) }
    }
}

impl Write for WriteWhile<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.left == 0 {
            self.check()?;
            self.left = BETWEEN;
        }
        let count = self.inner.write(&bytes[..bytes.len().min(self.left)])?;
        self.left -= count;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

/// Checks that `path` is a regular file, which [`TemporaryFile::replace`] may replace, or does not exist.
pub fn check_replaceable(path: &Path) -> io::Result<()> {
    match existing(&follow_link(path))? {
        Some(old) if !old.is_file() => {
            Err(io::Error::new(io::ErrorKind::Unsupported, "only a regular file can be written here"))
        }
        _ => Ok(()),
    }
}

/// Checks whether [`write_atomically`] could write `path` now, without touching an existing file.
///
/// # Errors
/// What the operating system reports.
pub fn check_writable(path: &Path) -> io::Result<()> {
    let path = &follow_link(path);
    match existing(path)? {
        Some(old) if !old.is_file() => OpenOptions::new().write(true).open(path).map(drop),
        _ => TemporaryFile::create(path).map(drop),
    }
}

/// The file that a symbolic link names, which need not exist yet, or the path itself.
pub fn follow_link(path: &Path) -> PathBuf {
    let mut path = path.to_path_buf();
    for _ in 0..MAX_LINKS {
        // What is there need not have a path of its own: a pipe behind `/dev/stdout` has none.
        if fs::metadata(&path).is_ok() {
            return fs::canonicalize(&path).unwrap_or(path);
        }
        let Ok(named) = fs::read_link(&path) else { break };
        path = path.parent().unwrap_or(Path::new("")).join(named);
    }
    path
}

/// Metadata of the file at `path`, if there is one and it may be replaced.
fn existing(path: &Path) -> io::Result<Option<Metadata>> {
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(metadata) if metadata.permissions().readonly() => Err(io::ErrorKind::PermissionDenied.into()),
        Ok(metadata) => Ok(Some(metadata)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// A temporary file, removed when dropped unless it has replaced another file.
pub struct TemporaryFile {
    file: File,
    path: Option<PathBuf>,
}

impl TemporaryFile {
    /// A temporary file in the folder of `path`.
    pub fn beside(path: &Path) -> io::Result<Self> {
        Self::create(&follow_link(path))
    }

    /// As [`Self::beside`], but without a name where the system allows it: then not even a killed process leaves it behind.
    pub fn nameless(path: &Path) -> io::Result<Self> {
        let mut file = Self::beside(path)?;
        if cfg!(unix)
            && let Some(path) = &file.path
        {
            fs::remove_file(path)?;
            file.path = None;
        }
        Ok(file)
    }

    /// Another handle of the open file.
    pub fn try_clone(&self) -> io::Result<File> {
        self.file.try_clone()
    }

    /// Flushes the file to the disk and renames it to `path`, replacing what is there.
    pub fn replace(self, path: &Path) -> io::Result<()> {
        let path = &follow_link(path);
        if let Some(old) = existing(path)? {
            self.file.set_permissions(old.permissions())?;
        }
        self.file.sync_all()?;
        self.rename(path)
    }

    /// The open file.
    pub fn file(&mut self) -> &mut File {
        &mut self.file
    }

    fn create(target: &Path) -> io::Result<Self> {
        let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?.to_string_lossy();
        for attempt in 0..MAX_ATTEMPTS {
            let path = target.with_file_name(format!(".{name}.{attempt}.tmp"));
            match OpenOptions::new().read(true).write(true).create_new(true).open(&path) {
                Ok(file) => return Ok(Self { file, path: Some(path) }),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    fn rename(mut self, target: &Path) -> io::Result<()> {
        if let Some(path) = &self.path {
            fs::rename(path, target)?;
            self.path = None;
            sync_folder(target);
        }
        Ok(())
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            // On an error the file stays; nothing better can be done here.
            let _ = fs::remove_file(path);
        }
    }
}

/// Makes the rename durable (fsync of the folder) where the system can; the content is on the disk either way.
fn sync_folder(target: &Path) {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn new_content_replaces_the_old_and_leaves_no_other_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        fs::write(&path, "old").unwrap();
        write_atomically(&path, |file| file.write_all(b"new")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert_eq!(names_in(folder.path()), ["a.txt"]);
    }

    #[test]
    fn a_writer_that_fails_half_way_leaves_the_old_file_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        fs::write(&path, "old").unwrap();
        let failed = write_atomically(&path, |file| {
            file.write_all(b"half")?;
            file.flush()?;
            // The reader in between sees the old content, and the temporary beside it.
            assert_eq!(fs::read_to_string(&path).unwrap(), "old");
            assert_eq!(names_in(folder.path()), [".a.txt.0.tmp", "a.txt"]);
            Err(io::ErrorKind::StorageFull.into())
        });
        assert_eq!(failed.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(names_in(folder.path()), ["a.txt"]);
    }

    #[test]
    fn what_nobody_wants_any_more_leaves_the_old_file_whole() {
        use std::cell::Cell;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let new = vec![7; 5 * BETWEEN + 3];
        // It says no from the question of this number on; the last one is asked once all is written.
        for asked in 0..8 {
            fs::write(&path, "old").unwrap();
            let questions = Cell::new(0);
            let wanted = || questions.replace(questions.get() + 1) < asked;
            let written = write_atomically_while(&path, &wanted, |file| file.write_all(&new));
            assert_eq!(written.is_ok(), asked == 7, "{asked}");
            if let Err(error) = written {
                assert_eq!((error.kind(), questions.get()), (io::ErrorKind::Other, asked + 1));
                assert_eq!(fs::read(&path).unwrap(), b"old");
            }
            assert_eq!(names_in(folder.path()), ["a.txt"]);
        }
        assert_eq!(fs::read(&path).unwrap(), new);
    }

    #[test]
    fn a_folder_that_does_not_exist_is_reported_before_and_while_writing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("none/a.txt");
        assert_eq!(check_writable(&path).unwrap_err().kind(), io::ErrorKind::NotFound);
        assert_eq!(write_atomically(&path, |_| Ok(())).unwrap_err().kind(), io::ErrorKind::NotFound);
        assert_eq!(check_writable(folder.path()).unwrap_err().kind(), io::ErrorKind::IsADirectory);
    }

    #[test]
    fn a_file_marked_read_only_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        fs::write(&path, "old").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert_eq!(check_writable(&path).unwrap_err().kind(), io::ErrorKind::PermissionDenied);
        assert_eq!(write_atomically(&path, |_| Ok(())).unwrap_err().kind(), io::ErrorKind::PermissionDenied);
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    }

    #[test]
    fn checking_touches_nothing_and_leftovers_of_a_killed_process_do_not_matter() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        fs::write(folder.path().join(".a.txt.0.tmp"), "left over").unwrap();
        check_writable(&path).unwrap();
        assert_eq!(names_in(folder.path()), [".a.txt.0.tmp"]);
        write_atomically(&path, |file| file.write_all(b"new")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
    }

    #[cfg(unix)]
    #[test]
    fn a_symbolic_link_stays_one_and_a_device_stays_a_device() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("file"), folder.path().join("link"));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_atomically(&link, |file| file.write_all(b"new")).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");

        // The file may be yet to come, in another folder, behind two links.
        fs::create_dir(folder.path().join("there")).unwrap();
        let (near, far) = (folder.path().join("near"), folder.path().join("far"));
        std::os::unix::fs::symlink("there/new", &far).unwrap();
        std::os::unix::fs::symlink("far", &near).unwrap();
        write_atomically(&near, |file| file.write_all(b"first")).unwrap();
        assert_eq!(fs::read_to_string(folder.path().join("there/new")).unwrap(), "first");
        assert!([near, far].iter().all(|link| fs::symlink_metadata(link).unwrap().is_symlink()));

        write_atomically(Path::new("/dev/null"), |file| file.write_all(b"new")).unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_pipe_behind_a_link_is_written() {
        use std::os::fd::AsRawFd;
        let (reader, writer) = io::pipe().unwrap();
        let path = format!("/proc/self/fd/{}", writer.as_raw_fd());
        write_atomically(Path::new(&path), |file| file.write_all(b"new")).unwrap();
        drop(writer);
        assert_eq!(io::read_to_string(reader).unwrap(), "new");
    }
}
