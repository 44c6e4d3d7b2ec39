//! Cameras that somebody keeps by the numbers 1 to 9, in a file beside the scene, `SCENE.cameras.toml`. Each is a table `[bookmarks.N]`
//! with the lines of a camera file, and with the file of the scene, how large its voxels were and where it began: where the same file is read with
//! another resolution, or another origin, the same place is found again by these. What else the file holds is kept, save comments.

use crate::camera_toml;
use crate::kept_file::{self, KeptError};
use crate::scale::Scale;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use toml::{Table, Value};
use voxtrace::Camera;
use voxtrace::glam::{DVec3, Vec3};

/// The numbers of bookmarks.
pub const SLOTS: RangeInclusive<u8> = 1..=9;
/// The table of all of them, and what errors call them.
const KEY: &str = "bookmarks";
/// First line of a file that we write.
const HEADER: &str = "# Cameras kept by voxtrace; each table has the lines of a camera file.\n\n";
/// Of the scene that a camera was kept in: the name of its file, the edge of a voxel, units, and the coordinates of the corner of its world, where it has
/// some. `church.vxt` and `church.vox` share their bookmarks, and their voxels need not be of one size, nor in one unit.
const SCENE: &str = "scene";
const VOXEL_SIZE: &str = "voxel_size";
const ORIGIN: &str = "origin";
/// Voxels that an origin, which is rounded, may lie beside the same one.
const SAME: f64 = 1e-3;

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

/// The scene that bookmarks are seen in.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The name of its file, without the folder; of a built-in scene its own.
    name: String,
    scale: Scale,
}

impl Seen {
    /// A scene by its source, with its scale.
    pub fn new(source: &str, scale: Scale) -> Self {
        let name = Path::new(source).file_name().map_or_else(|| source.into(), |name| name.to_string_lossy());
        Self { name: name.into_owned(), scale }
    }
}

/// The bookmarks of one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Bookmarks {
    path: PathBuf,
    /// The scene that they are seen in; `None`: they are as they stand in the file.
    scene: Option<Seen>,
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

    /// Reads the bookmarks at `path` as they stand there; where no file is, there are none yet.
    ///
    /// # Errors
    /// [`BookmarkError::File`].
    pub fn open(path: &Path) -> Result<Self, BookmarkError> {
        Self::read(path, None)
    }

    /// As [`Self::open`], in the voxels of a scene: those that were kept with another resolution of the same file stay in their place.
    ///
    /// # Errors
    /// Those of [`Self::open`].
    pub fn open_in(path: &Path, scene: Seen) -> Result<Self, BookmarkError> {
        Self::read(path, Some(scene))
    }

    fn read(path: &Path, scene: Option<Seen>) -> Result<Self, BookmarkError> {
        let table = kept_file::read(KEY, path)?;
        let mut cameras = <[Option<Camera>; 9]>::default();
        for (camera, number) in cameras.iter_mut().zip(SLOTS) {
            *camera = camera_of(&table, number, scene.as_ref()).map_err(|reason| damaged(path, reason))?;
        }
        Ok(Self { path: path.to_path_buf(), scene, cameras })
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
        let scene = self.scene.clone();
        self.change(number, |bookmarks| {
            let entry = bookmarks.entry(number.to_string()).or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(entry) = entry {
                // Nothing stays of the lens that was kept before: a pinhole says none.
                if let Ok(before) = camera_toml::read(entry) {
                    before.lens.settings().into_iter().for_each(|(key, _)| _ = entry.remove(key));
                }
                // Nor of the scene that it was kept in.
                ["lens", SCENE, VOXEL_SIZE, ORIGIN].iter().for_each(|key| _ = entry.remove(*key));
                camera_toml::write(camera, entry);
                if let Some(Seen { name, scale }) = &scene {
                    entry.insert(SCENE.into(), Value::String(name.clone()));
                    entry.insert(VOXEL_SIZE.into(), Value::Float(scale.voxel_size));
                    let origin = scale.coordinates(DVec3::ZERO).map(|origin| origin.to_array().map(Value::Float));
                    entry.extend(origin.map(|origin| (ORIGIN.to_owned(), Value::Array(origin.to_vec()))));
                }
            }
        })
    }

    /// Forgets the camera of a number, in the file too. Errors are those of [`Self::store`].
    pub fn remove(&mut self, number: u8) -> Result<(), BookmarkError> {
        self.change(number, |bookmarks| drop(bookmarks.remove(&number.to_string())))
    }

    /// Keeps those that were kept with another resolution once more, as they are in the scene: commands read them as they stand in the file. Errors are
    /// those of [`Self::store`].
    pub(crate) fn settle(&mut self) -> Result<(), BookmarkError> {
        let written = Self::open(&self.path)?;
        let moved = self.iter().filter(|(number, camera)| written.get(*number) != Some(*camera));
        let moved: Vec<(u8, Camera)> = moved.map(|(number, camera)| (number, camera.clone())).collect();
        moved.iter().try_for_each(|(number, camera)| self.store(*number, camera))
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
        *self = Self::read(&self.path, self.scene.clone())?;
        Ok(())
    }
}

fn damaged(path: &Path, reason: String) -> BookmarkError {
    KeptError::Damaged { what: KEY, path: path.to_path_buf(), reason }.into()
}

fn camera_of(table: &Table, number: u8, scene: Option<&Seen>) -> Result<Option<Camera>, String> {
    let Some(bookmarks) = table.get(KEY) else { return Ok(None) };
    let bookmarks = bookmarks.as_table().ok_or_else(|| format!("`{KEY}` is no table"))?;
    let Some(entry) = bookmarks.get(&number.to_string()) else { return Ok(None) };
    let entry = entry.as_table().ok_or_else(|| format!("bookmark {number} is no table"))?;
    let camera = camera_toml::read(entry).map_err(|reason| format!("bookmark {number}: {reason}"))?;
    Ok(Some(match scene {
        Some(scene) => placed(camera, entry, scene),
        None => camera,
    }))
}

/// A camera in the voxels of a scene, from those that it was kept in.
fn placed(camera: Camera, entry: &Table, scene: &Seen) -> Camera {
    let scale = &scene.scale;
    // The voxels of another file say nothing about those of this one.
    if entry.get(SCENE).and_then(Value::as_str) != Some(&scene.name) {
        return camera;
    }
    let number = |value: &Value| value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64));
    let number = |value: &Value| number(value).filter(|number| number.is_finite());
    // Who wrote it by hand meant the scene as it is.
    let Some(size) = entry.get(VOXEL_SIZE).and_then(number).filter(|size| *size > 0.0) else { return camera };
    let factor = size / scale.voxel_size;
    let origin = entry.get(ORIGIN).and_then(Value::as_array);
    let origin = origin.and_then(|numbers| numbers.iter().map(number).collect::<Option<Vec<f64>>>());
    let origin = origin.and_then(|numbers| Some(DVec3::from_array(numbers.try_into().ok()?)));
    let shift = scale.georeference.as_ref().zip(origin);
    let shift = shift.map(|(own, origin)| own.coordinates_from_world.inverse().transform_point3(origin));
    let shift = shift.filter(|shift| shift.length() > SAME).unwrap_or_default();
    // To the bit where nothing moved.
    if factor == 1.0 && shift == DVec3::ZERO {
        return camera;
    }
    let moved = |point: Vec3| (point.as_dvec3() * factor + shift).as_vec3();
    let (eye, target, lens) = (moved(camera.eye), moved(camera.target), camera.lens.scaled(factor as f32));
    Camera { eye, target, lens, ..camera }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use voxtrace::camera::Lens;
    use voxtrace::georeference::Georeference;
    use voxtrace::scene::Unit;

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
    fn with_another_resolution_or_origin_cameras_stay_in_their_place() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.cameras.toml");
        let of_size = |voxel_size| Scale { voxel_size, unit: Unit::Metre, georeference: None };
        let seen = |scale| Seen::new("rooms/a.vxt", scale);
        let scale = |size| seen(of_size(size));
        let at = |size, origin| {
            let georeference = Some(Georeference::of_grid(DVec3::splat(origin), size, "EPSG:25832"));
            seen(Scale { georeference, ..of_size(size) })
        };
        let lens = Lens::Orthographic { view_height: 20.0 };
        let kept = Camera { eye: Vec3::new(2.0, 4.0, 6.0), ..camera(1.0) }.with_lens(lens);
        Bookmarks::open_in(&path, scale(0.5)).unwrap().store(1, &kept).unwrap();
        assert_eq!(Bookmarks::open_in(&path, scale(0.5)).unwrap().get(1), Some(&kept), "to the bit");
        let mut finer = Bookmarks::open_in(&path, scale(0.25)).unwrap();
        let twice = Camera { eye: Vec3::new(4.0, 8.0, 12.0), ..kept.clone() };
        let twice = twice.with_lens(Lens::Orthographic { view_height: 40.0 });
        assert_eq!(finer.get(1), Some(&twice));
        assert_eq!(Bookmarks::open(&path).unwrap().get(1), Some(&kept), "reading changes no file");
        // Commands read the file as it is: it is brought into the voxels of the scene for them.
        finer.settle().unwrap();
        assert_eq!((finer.get(1), Bookmarks::open(&path).unwrap().get(1)), (Some(&twice), Some(&twice)));
        assert_eq!(Bookmarks::open_in(&path, scale(0.5)).unwrap().get(1), Some(&kept));
        Bookmarks::open_in(&path, at(0.5, 1000.0)).unwrap().store(2, &kept).unwrap();
        let moved = Bookmarks::open_in(&path, at(0.25, 990.0)).unwrap().get(2).cloned().unwrap();
        assert_eq!(moved.eye, Vec3::new(44.0, 48.0, 52.0), "10 further on, and half as large");
        assert_eq!(Bookmarks::open_in(&path, at(0.5, 1000.0)).unwrap().get(2), Some(&kept), "to the bit");
        // Another file beside it has its own voxels: there the camera is as it stands.
        let other = Seen::new("rooms/a.vox", Scale { voxel_size: 1.0, unit: Unit::Voxel, georeference: None });
        let mut other = Bookmarks::open_in(&path, other).unwrap();
        assert_eq!((other.get(1), other.get(2)), (Some(&twice), Some(&kept)));
        let text = fs::read_to_string(&path).unwrap();
        other.settle().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), text, "nothing is kept anew");
        // Of a camera from elsewhere nothing is known.
        Bookmarks::open(&path).unwrap().store(2, &kept).unwrap();
        assert_eq!(Bookmarks::open_in(&path, at(0.25, 990.0)).unwrap().get(2), Some(&kept));
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
