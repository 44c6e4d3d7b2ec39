//! Which format a file or a folder has: told once, when it is opened, by its first bytes, or where they say nothing by its
//! extension.

use super::reader::clues::{FileClues, FolderClues, HEAD, Recognition};
#[cfg(feature = "mesh")]
use super::reader::tiled_mesh;
use super::reader::{Data, ImportOptions, Kind, LargeGeometry, LargeVolume, Reader, TiledCloud};
use super::readers::Readers;
use super::source::Source;
use super::source::guard::guarded;
use super::source::input::beyond;
use super::{finish, load::Loaded};
use crate::output::FILM_MAGIC;
use std::fs::File;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Most samples along an axis of a volume that stays in its file: rows of them are in memory.
const LONGEST_AXIS: u64 = 1 << 20;

/// What is said of a film where a scene is to be, whatever the file is called.
const OF_FILM: &str = "a film (.vxf), which holds the samples of a picture and no scene";

/// A file, a folder or bytes whose format is known, to be read.
pub struct Opened<'t, 'a> {
    reader: &'t Reader,
    source: Source<'a>,
    options: &'a ImportOptions,
}

impl<'t> Readers<'t> {
    /// Opens a file or a folder and tells its format.
    ///
    /// # Errors
    /// If it cannot be opened or has no known format.
    pub fn open<'a>(self, path: &'a Path, options: &'a ImportOptions) -> Result<Opened<'t, 'a>, ImportError> {
        self.opened(Source::open(path, &options.limits)?, options)
    }

    /// As [`Self::open`], of an open file of which `head` was read already, all from its start on.
    ///
    /// # Errors
    /// As [`Self::open`].
    #[doc(hidden)]
    pub fn open_begun<'a>(
        self,
        head: Vec<u8>,
        file: File,
        path: &'a Path,
        options: &'a ImportOptions,
    ) -> Result<Opened<'t, 'a>, ImportError> {
        self.opened(Source::of_begun(head, file, path, &options.limits)?, options)
    }

    /// Tells the format of bytes in memory; `path` names them in errors and tells their format by its extension where the
    /// first bytes do not. Files that they refer to are not looked for.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_bytes<'a>(
        self,
        bytes: &'a [u8],
        path: &'a Path,
        options: &'a ImportOptions,
    ) -> Result<Opened<'t, 'a>, ImportError> {
        self.opened(Source::of_bytes(bytes, path, &options.limits)?, options)
    }

    /// Opens several files that are to be one: meshes of any formats, or tiles of a scan, and folders of those. One alone is opened as [`Self::open`]
    /// does. Errors name the file that they are about, or the first.
    ///
    /// # Errors
    /// If one of them cannot be opened, or they are neither all meshes nor all tiles of one format that has tiles.
    pub fn open_all<'a>(self, paths: &'a [PathBuf], options: &'a ImportOptions) -> Result<Opened<'t, 'a>, ImportError> {
        let [first, others @ ..] = paths else {
            let none = ImportErrorKind::UnknownFormat("no file is named".into());
            return Err(ImportError::of_file(Path::new(""), none));
        };
        let opened = self.open(first, options)?;
        if others.is_empty() {
            return Ok(opened);
        }
        let reader = opened.reader;
        if reader.kind == Kind::Mesh {
            for path in others {
                if self.open(path, options)?.reader.kind != Kind::Mesh {
                    let what = "it is no mesh, and several files are read as one only where all are";
                    return Err(ImportError::of_file(path, ImportErrorKind::OtherTiles(what.into())));
                }
            }
            return Ok(Opened { reader, source: Source::of_files(first, paths.to_vec()), options });
        }
        let mut files = Vec::new();
        for path in paths {
            let opened = self.open(path, options)?;
            if !opened.reader.takes_tiles || opened.reader != reader {
                let kinds: Vec<&str> = self.iter().filter(|known| known.takes_tiles).map(|known| known.name).collect();
                let what = format!(
                    "several files are read as one only where all are meshes or all are {}",
                    kinds.join(" or all are ")
                );
                return Err(ImportError::of_file(path, ImportErrorKind::OtherTiles(what)));
            }
            let tiles = opened.source.tiles(reader.extensions, &options.limits)?;
            files.extend(tiles.unwrap_or_else(|| vec![path.clone()]));
        }
        Ok(Opened { reader, source: Source::of_files(first, files), options })
    }

    fn opened<'a>(self, mut source: Source<'a>, options: &'a ImportOptions) -> Result<Opened<'t, 'a>, ImportError> {
        let path = source.path();
        let (reader, is_film) = match source.as_input() {
            Some(input) => {
                let length = input.remaining();
                let head = input.peek(HEAD)?;
                let is_film = head.starts_with(FILM_MAGIC) && options.raw.is_none();
                (self.of_file(&FileClues { path, head, length, options }), is_film)
            }
            None => (self.of_folder(&FolderClues::new(path, &options.limits))?, false),
        };
        if is_film {
            return Err(ImportError::of_file(path, ImportErrorKind::Unsupported(OF_FILM.into())));
        }
        let reader = reader.ok_or_else(|| self.unknown(&source))?;
        Ok(Opened { reader, source, options })
    }

    /// The reader of a file.
    pub fn of_file(self, clues: &FileClues) -> Option<&'t Reader> {
        let with = |wanted| {
            let recognizes = |reader: &&Reader| reader.recognize.is_some_and(|recognize| recognize(clues) == wanted);
            self.iter().find(recognizes)
        };
        with(Recognition::Sure)
            .or_else(|| self.iter().find(|reader| reader.magic.iter().any(|magic| magic.is_in(clues.head))))
            .or_else(|| self.iter().find(|reader| reader.extension_of(clues.path).is_some()))
            .or_else(|| with(Recognition::Likely))
    }

    /// The reader of a folder.
    fn of_folder(self, clues: &FolderClues) -> Result<Option<&'t Reader>, ImportError> {
        for reader in self.iter() {
            if let Some(recognize) = reader.recognize_folder
                && recognize(clues)?
            {
                return Ok(Some(reader));
            }
        }
        Ok(None)
    }

    fn unknown(self, source: &Source) -> ImportError {
        if source.is_folder() {
            let what = "no file in the folder is a slice, a tile of points or a region of a world";
            return ImportError::of_file(source.path(), ImportErrorKind::UnknownFormat(what.into()));
        }
        let extensions: Vec<String> = self.extensions().into_iter().map(|extension| format!(".{extension}")).collect();
        let what = format!("{} are read", extensions.join(", "));
        ImportError::at(source.path(), 0, ImportErrorKind::UnknownFormat(what))
    }
}

impl<'t> Opened<'t, '_> {
    /// The reader of its format.
    pub fn reader(&self) -> &'t Reader {
        self.reader
    }

    /// Reads it: named, in the unit and with the axis up that the options ask for.
    ///
    /// # Errors
    /// If it is not what its format says, or goes beyond the limits.
    pub fn read(mut self) -> Result<Data, ImportError> {
        #[cfg(feature = "mesh")]
        if let Some(files) = self.meshes()? {
            return tiled_mesh::read(&files, self.options);
        }
        let (path, reader, options) = (self.source.path(), self.reader, self.options);
        if let Some(input) = self.source.as_input().filter(|_| reader.kind != Kind::Packed) {
            input.set_limit(&options.limits)?;
        }
        let read = || Ok((reader.read)(self.source, options));
        let data = guarded(read).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
        finish::finish(data, reader, path, options)
    }

    /// The files of several meshes that are one.
    #[cfg(feature = "mesh")]
    fn meshes(&self) -> Result<Option<Vec<PathBuf>>, ImportError> {
        let files = (self.reader.kind == Kind::Mesh).then(|| self.source.tiles(&[], &self.options.limits));
        files.transpose().map(Option::flatten)
    }

    /// Reads it and makes a scene of it.
    ///
    /// # Errors
    /// As [`Self::read`]; also if there is nothing to be seen, or more than allowed.
    pub fn load(self) -> Result<Loaded, ImportError> {
        let (path, options) = (self.source.path(), self.options);
        Loaded::of(self.read()?, path, options)
    }

    /// Opens a mesh or points without reading them into memory, if they would take more than a third of `budget` there and
    /// are in one of the formats for which that is possible: binary PLY, binary STL, binary glTF whose arrays are plain, LAS,
    /// LAZ; or if they are meshes of several files, which are read one at a time. `None` where not.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    pub fn open_large(&mut self, budget: u64) -> Result<Option<LargeGeometry>, ImportError> {
        let (path, options) = (self.source.path(), self.options);
        #[cfg(feature = "mesh")]
        if let Some(files) = self.meshes()? {
            let found = tiled_mesh::open_large(&files, budget, options)?;
            return found.map(|found| LargeGeometry::new(found, path, &files, self.reader, options)).transpose();
        }
        let is_file = !self.source.is_in_memory() && self.source.as_input().is_some_and(|i| i.remaining().is_some());
        let tiles =
            if self.reader.takes_tiles { self.source.tiles(self.reader.extensions, &options.limits)? } else { None };
        let is_large = is_file || tiles.is_some();
        let Some(open_large) = self.reader.open_large.filter(|_| is_large) else { return Ok(None) };
        let found = open_large(&self.source, budget, options)?.filter(|found| found.size_bytes > budget / 3);
        let files = tiles.unwrap_or_else(|| vec![path.into()]);
        found.map(|found| LargeGeometry::new(found, path, &files, self.reader, options)).transpose()
    }

    /// Opens files of points that several processes are to voxelize: those of a folder, several that were named, or one. LAS and LAZ are
    /// such.
    ///
    /// # Errors
    /// If they cannot be read, are not what they say, or have no points or another format.
    pub fn open_tiled(&mut self) -> Result<TiledCloud, ImportError> {
        let (path, options) = (self.source.path(), self.options);
        let tiles =
            if self.reader.takes_tiles { self.source.tiles(self.reader.extensions, &options.limits)? } else { None };
        let files = tiles.unwrap_or_else(|| vec![path.into()]);
        let points = self.open_large(0)?.and_then(LargeGeometry::into_points);
        let cloud = points.map(|points| TiledCloud::new(points, &files, options)).transpose()?.flatten();
        cloud.ok_or_else(|| {
            let what = "several processes voxelize meshes, and points of LAS and LAZ files, and there are none of them";
            ImportError::of_file(path, ImportErrorKind::OtherTiles(what.into()))
        })
    }

    /// Opens a volume without reading its samples into memory, if they would take more than a third of `budget` there and lie in a format for
    /// which that is possible: raw, NRRD, MetaImage, NumPy and NIfTI of one number at each place, pages of a TIFF, Zarr and N5. `None` where not.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    pub fn open_large_volume(&mut self, budget: u64) -> Result<Option<LargeVolume>, ImportError> {
        let (path, reader) = (self.source.path(), self.reader);
        let is_piped = self.source.as_input().is_some_and(|input| input.remaining().is_none());
        let Some(open) = reader.open_large_volume.filter(|_| !self.source.is_in_memory() && !is_piped) else {
            return Ok(None);
        };
        // Nothing is kept but a few layers, however many there are.
        let limits = Limits { bytes: u64::MAX, points: u64::MAX, ..self.options.limits };
        let options = ImportOptions { limits, ..self.options.clone() };
        let Some(mut source) = open(Source::open(path, &limits)?, &options)? else { return Ok(None) };
        if let Some(&size) = source.frame().size.iter().find(|&&size| size as u64 > LONGEST_AXIS) {
            return Err(beyond(path, None, "samples along an axis", size as u64, LONGEST_AXIS));
        }
        let samples = source.frame().size.iter().map(|&size| size as u64).fold(1, u64::saturating_mul);
        if samples.saturating_mul(size_of::<f32>() as u64) <= budget / 3 {
            return Ok(None);
        }
        let turn = reader.up_axis.zip(options.up);
        *source.frame_mut() = finish::volume_frame(source.frame().clone(), turn, reader, path, &options)?;
        LargeVolume::new(source, path, budget).map(Some)
    }
}
