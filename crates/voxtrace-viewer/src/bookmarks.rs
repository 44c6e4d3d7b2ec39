//! Cameras that somebody keeps by the numbers 1 to 9, in a file beside the scene, `SCENE.cameras.toml`. Each is a table `[bookmarks.N]`
//! with the lines of a camera file; what else the file holds is kept, save comments.

use crate::camera_toml;
use crate::kept_file::{self, KeptError};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use toml::{Table, Value};
use voxtrace::Camera;

/// The numbers of bookmarks.
pub const SLOTS: RangeInclusive<u8> = 1..=9;
/// The table of all of them, and what errors call them.
const KEY: &str = "bookmarks";
/// First line of a file that we write.
const HEADER: &str = "# Cameras kept by voxtrace; each table has the lines of a camera file.\n\n";

/// Why bookmarks cannot be read or kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BookmarkError {
    /// The file cannot be read or written, or is damaged.
    #[error(transparent)]
    File(#[from] KeptError),
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
        kept_file::beside(scene, "cameras.toml")
    }

    /// Where the bookmarks of a built-in scene are, in the folder of the settings.
    pub fn of_built_in(name: &str, folder: &Path) -> PathBuf {
        folder.join(format!("{name}.cameras.toml"))
    }

    /// Reads the bookmarks at `path`; where no file is, there are none yet.
    ///
    /// # Errors
    /// [`BookmarkError::File`].
    pub fn open(path: &Path) -> Result<Self, BookmarkError> {
        let table = kept_file::read(KEY, path)?;
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
    /// Those of [`Self::open`], and [`BookmarkError::Number`] and [`BookmarkError::Camera`] for what cannot
    /// be kept. The file and the bookmarks are as they were then.
    pub fn store(&mut self, number: u8, camera: &Camera) -> Result<(), BookmarkError> {
        let mut probe = Table::new();
        camera_toml::write(camera, &mut probe);
        camera_toml::read(&probe).map_err(BookmarkError::Camera)?;
        self.change(number, |bookmarks| {
            let entry = bookmarks.entry(number.to_string()).or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(entry) = entry {
                // Nothing stays of the lens that was kept before: a pinhole says none.
                if let Ok(before) = camera_toml::read(entry) {
                    before.lens.settings().into_iter().for_each(|(key, _)| _ = entry.remove(key));
                }
                entry.remove("lens");
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
        let mut table = kept_file::read(KEY, &self.path)?;
        if let Value::Table(bookmarks) = table.entry(KEY).or_insert_with(|| Value::Table(Table::new())) {
            change(bookmarks);
        }
        kept_file::write(KEY, &self.path, HEADER, &table)?;
        *self = Self::open(&self.path)?;
        Ok(())
    }
}

fn damaged(path: &Path, reason: String) -> BookmarkError {
    KeptError::Damaged { what: KEY, path: path.to_path_buf(), reason }.into()
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
    use voxtrace::camera::Lens;
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
    fn a_camera_takes_the_place_of_one_with_another_lens() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.cameras.toml");
        let mut bookmarks = Bookmarks::open(&path).unwrap();
        let thin = Lens::Thin { aperture: 1.5, focus: 9.0, blades: 5, blade_rotation: 10.0 };
        for lens in [thin, Lens::Pinhole, Lens::Orthographic { view_height: 20.0 }, Lens::Pinhole] {
            let kept = camera(1.0).with_lens(lens);
            bookmarks.store(1, &kept).unwrap();
            assert_eq!(Bookmarks::open(&path).unwrap().get(1), Some(&kept));
        }
        let text = fs::read_to_string(&path).unwrap();
        assert!(!["lens", "aperture", "view_height"].iter().any(|key| text.contains(key)), "{text}");
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
            assert!(
                matches!(error, BookmarkError::File(KeptError::Damaged { .. })) && !error.to_string().contains('\n'),
                "{error}"
            );
            assert!(bookmarks.store(1, &camera(1.0)).is_err() && bookmarks.remove(1).is_err());
            assert_eq!(fs::read(&path).unwrap(), damage);
        }
    }

    #[test]
    fn what_cannot_be_kept_is_refused_and_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut bookmarks = Bookmarks::open(&folder.path().join("none/a.cameras.toml")).unwrap();
        assert!(matches!(bookmarks.store(1, &camera(1.0)), Err(BookmarkError::File(KeptError::Write { .. }))));
        assert!(matches!(bookmarks.store(0, &camera(1.0)), Err(BookmarkError::Number(0))));
        assert!(matches!(bookmarks.remove(10), Err(BookmarkError::Number(10))));
        assert!(matches!(bookmarks.store(1, &camera(f32::NAN)), Err(BookmarkError::Camera(_))));
        assert_eq!(bookmarks.iter().count(), 0);
        assert_eq!(Bookmarks::beside(Path::new("a/head.nii.gz")), Some(PathBuf::from("a/head.cameras.toml")));
        assert_eq!(Bookmarks::beside(Path::new("..")), None);
        assert_eq!(Bookmarks::of_built_in("city", Path::new("s")), PathBuf::from("s/city.cameras.toml"));
    }
}
