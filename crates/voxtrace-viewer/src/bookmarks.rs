//! Cameras that somebody keeps by the numbers 1 to 9, in a file beside the scene, `SCENE.cameras.toml`. Each is a table `[bookmarks.N]`
//! with the lines of a camera file; what else the file holds is kept, save comments.

use crate::camera_toml;
use std::io::{self, Read, Write};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use toml::{Table, Value};
use voxtrace::Camera;
use voxtrace_core::atomic_file::write_atomically;

/// The numbers of bookmarks.
pub const SLOTS: RangeInclusive<u8> = 1..=9;
/// The table of all of them.
const KEY: &str = "bookmarks";
/// Largest file that is read.
const MOST_BYTES: u64 = 1 << 20;
/// First line of a file that we write.
const HEADER: &str = "# Cameras kept by voxtrace; each table has the lines of a camera file.\n\n";

/// Why bookmarks cannot be read or kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BookmarkError {
    /// The operating system cannot read the file.
    #[error("cannot read the bookmarks {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file is there, but is not one of bookmarks. It is never written over.
    #[error("the bookmarks {} are damaged: {reason}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The operating system cannot write the file.
    #[error("cannot keep the bookmarks {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// There is no such number.
    #[error("there is no bookmark {0}, only 1 to 9")]
    Number(u8),
    /// A camera that cannot send rays.
    #[error("the camera cannot be kept: {0}")]
    Camera(String),
}

/// The bookmarks of one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Bookmarks {
    path: PathBuf,
    cameras: [Option<Camera>; 9],
}

impl Bookmarks {
    /// Where the bookmarks of a scene's file are: `rooms/church.vxt` has `rooms/church.cameras.toml`, and so has `rooms/church.vox`.
    /// `None` where the path has no name.
    pub fn beside(scene: &Path) -> Option<PathBuf> {
        let stem = scene.file_stem()?.to_string_lossy().into_owned();
        // `head.nii.gz` is `head`, as for pictures.
        let stem = stem.strip_suffix(".nii").unwrap_or(&stem);
        Some(scene.with_file_name(format!("{stem}.cameras.toml")))
    }

    /// Where the bookmarks of a built-in scene are, in the folder of the settings.
    pub fn of_built_in(name: &str, folder: &Path) -> PathBuf {
        folder.join(format!("{name}.cameras.toml"))
    }

    /// Reads the bookmarks at `path`; where no file is, there are none yet.
    ///
    /// # Errors
    /// [`BookmarkError::Read`] and [`BookmarkError::Damaged`].
    pub fn open(path: &Path) -> Result<Self, BookmarkError> {
        let table = read(path)?;
        let mut cameras = <[Option<Camera>; 9]>::default();
        for (camera, number) in cameras.iter_mut().zip(SLOTS) {
            *camera = camera_of(&table, number).map_err(|reason| damaged(path, reason))?;
        }
        Ok(Self { path: path.to_path_buf(), cameras })
    }

    /// The camera of a number.
    pub fn get(&self, number: u8) -> Option<&Camera> {
        self.cameras.get(usize::from(number.checked_sub(1)?))?.as_ref()
    }

    /// The numbers that have a camera, and these.
    pub fn iter(&self) -> impl Iterator<Item = (u8, &Camera)> {
        SLOTS.zip(&self.cameras).filter_map(|(number, camera)| camera.as_ref().map(|camera| (number, camera)))
    }

    /// Keeps a camera under a number, in the file too. What others wrote there meanwhile stays.
    ///
    /// # Errors
    /// Those of [`Self::open`], [`BookmarkError::Write`], and [`BookmarkError::Number`] and [`BookmarkError::Camera`] for what cannot
    /// be kept. The file and the bookmarks are as they were then.
    pub fn store(&mut self, number: u8, camera: &Camera) -> Result<(), BookmarkError> {
        let mut probe = Table::new();
        camera_toml::write(camera, &mut probe);
        camera_toml::read(&probe).map_err(BookmarkError::Camera)?;
        self.change(number, |bookmarks| {
            let entry = bookmarks.entry(number.to_string()).or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(entry) = entry {
                camera_toml::write(camera, entry);
            }
        })
    }

    /// Forgets the camera of a number, in the file too. Errors are those of [`Self::store`].
    pub fn remove(&mut self, number: u8) -> Result<(), BookmarkError> {
        self.change(number, |bookmarks| drop(bookmarks.remove(&number.to_string())))
    }

    fn change(&mut self, number: u8, change: impl FnOnce(&mut Table)) -> Result<(), BookmarkError> {
        if !SLOTS.contains(&number) {
            return Err(BookmarkError::Number(number));
        }
        // Opening says whether the file as it is now may be written over.
        Self::open(&self.path)?;
        let mut table = read(&self.path)?;
        if let Value::Table(bookmarks) = table.entry(KEY).or_insert_with(|| Value::Table(Table::new())) {
            change(bookmarks);
        }
        let text = format!("{HEADER}{table}");
        write_atomically(&self.path, |file| file.write_all(text.as_bytes()))
            .map_err(|source| BookmarkError::Write { path: self.path.clone(), source })?;
        *self = Self::open(&self.path)?;
        Ok(())
    }
}

fn damaged(path: &Path, reason: String) -> BookmarkError {
    BookmarkError::Damaged { path: path.to_path_buf(), reason }
}

fn read(path: &Path) -> Result<Table, BookmarkError> {
    let mut text = String::new();
    let file = match std::fs::File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Table::new()),
        file => file,
    };
    match file.and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text)) {
        Ok(bytes) if bytes as u64 > MOST_BYTES => Err(damaged(path, format!("it has more than {MOST_BYTES} bytes"))),
        Ok(_) => text.parse().map_err(|error: toml::de::Error| damaged(path, error.message().to_owned())),
        Err(error) if error.kind() == io::ErrorKind::InvalidData => Err(damaged(path, "it is no text".into())),
        Err(source) => Err(BookmarkError::Read { path: path.to_path_buf(), source }),
    }
}

fn camera_of(table: &Table, number: u8) -> Result<Option<Camera>, String> {
    let Some(bookmarks) = table.get(KEY) else { return Ok(None) };
    let bookmarks = bookmarks.as_table().ok_or_else(|| format!("`{KEY}` is no table"))?;
    let Some(entry) = bookmarks.get(&number.to_string()) else { return Ok(None) };
    let entry = entry.as_table().ok_or_else(|| format!("bookmark {number} is no table"))?;
    camera_toml::read(entry).map(Some).map_err(|reason| format!("bookmark {number}: {reason}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use voxtrace::glam::Vec3;

    fn camera(x: f32) -> Camera {
        Camera { name: format!("at {x}"), fov_y: 33.3, ..Camera::look_at(Vec3::new(x, 0.1, -7.7), Vec3::ZERO) }
    }

    #[test]
    fn what_is_stored_is_read_again_to_the_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = Bookmarks::beside(&folder.path().join("church.vxt")).unwrap();
        assert_eq!(path, folder.path().join("church.cameras.toml"));
        let mut bookmarks = Bookmarks::open(&path).unwrap();
        assert!(!path.exists() && bookmarks.iter().count() == 0, "reading makes no file");
        bookmarks.store(3, &camera(0.3)).unwrap();
        bookmarks.store(9, &camera(0.9)).unwrap();
        bookmarks.store(3, &camera(3.3)).unwrap();
        let read = Bookmarks::open(&path).unwrap();
        assert_eq!(read, bookmarks);
        assert_eq!(read.iter().collect::<Vec<_>>(), [(3, &camera(3.3)), (9, &camera(0.9))]);
        assert_ne!(read.get(3), Some(&camera(0.3)), "the comparison sees another camera");
        bookmarks.remove(3).unwrap();
        assert_eq!((bookmarks.get(3), bookmarks.get(0), bookmarks.get(10)), (None, None, None));
        assert_eq!(Bookmarks::open(&path).unwrap().get(9), Some(&camera(0.9)));
    }

    #[test]
    fn keys_that_nobody_knows_and_what_another_window_wrote_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.cameras.toml");
        let text = "mood = \"calm\"\n[tour]\nspeed = 0.25\n[bookmarks]\norder = [1, 2]\n\
                    [bookmarks.2]\neye = [1, 2, 3]\ntarget = [0, 0, 0]\nnote = \"door\"";
        fs::write(&path, text).unwrap();
        let (mut one, mut other) = (Bookmarks::open(&path).unwrap(), Bookmarks::open(&path).unwrap());
        one.store(1, &camera(1.0)).unwrap();
        other.store(2, &camera(2.0)).unwrap();
        assert_eq!(other.get(1), Some(&camera(1.0)));
        let table: Table = fs::read_to_string(&path).unwrap().parse().unwrap();
        assert_eq!(table["mood"].as_str(), Some("calm"));
        assert_eq!(table["tour"]["speed"].as_float(), Some(0.25));
        assert_eq!(table["bookmarks"]["order"].as_array().map(Vec::len), Some(2));
        assert_eq!(table["bookmarks"]["2"]["note"].as_str(), Some("door"));
    }

    #[test]
    fn a_damaged_file_is_one_error_and_is_never_written_over() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.cameras.toml");
        let mut bookmarks = Bookmarks::open(&path).unwrap();
        let damages: [&[u8]; 6] = [
            b"[bookmarks",
            b"bookmarks = 3",
            b"[bookmarks]\n1 = 2",
            b"[bookmarks.4]\neye = [1, 2]\ntarget = [0, 0, 0]",
            b"\xff\xfe",
            &[b'#'; (1 << 20) + 1],
        ];
        for damage in damages {
            fs::write(&path, damage).unwrap();
            let error = Bookmarks::open(&path).unwrap_err();
            assert!(matches!(error, BookmarkError::Damaged { .. }) && !error.to_string().contains('\n'), "{error}");
            assert!(bookmarks.store(1, &camera(1.0)).is_err() && bookmarks.remove(1).is_err());
            assert_eq!(fs::read(&path).unwrap(), damage);
        }
    }

    #[test]
    fn what_cannot_be_kept_is_refused_and_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut bookmarks = Bookmarks::open(&folder.path().join("none/a.cameras.toml")).unwrap();
        assert!(matches!(bookmarks.store(1, &camera(1.0)), Err(BookmarkError::Write { .. })));
        assert!(matches!(bookmarks.store(0, &camera(1.0)), Err(BookmarkError::Number(0))));
        assert!(matches!(bookmarks.remove(10), Err(BookmarkError::Number(10))));
        assert!(matches!(bookmarks.store(1, &camera(f32::NAN)), Err(BookmarkError::Camera(_))));
        assert_eq!(bookmarks.iter().count(), 0);
        assert_eq!(Bookmarks::beside(Path::new("a/head.nii.gz")), Some(PathBuf::from("a/head.cameras.toml")));
        assert_eq!(Bookmarks::beside(Path::new("..")), None);
        assert_eq!(Bookmarks::of_built_in("city", Path::new("s")), PathBuf::from("s/city.cameras.toml"));
    }
}
