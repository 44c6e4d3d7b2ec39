//! What a reader of a format is, and what it gives. Each format has one, in the table of `readers`; nothing else knows of it.

pub(crate) mod clues;
mod data;
mod epsg_feet;
mod filtered_points;
pub(crate) mod geo_keys;
mod geometry;
mod large;
mod large_content;
mod large_volume;
pub(crate) mod local_origin;
pub(crate) mod map_units;
mod not_shown;
mod options;
mod point_filter;
mod raw_shape;
#[cfg(feature = "points")]
pub(crate) mod same_system;
mod tiled_cloud;
#[cfg(feature = "mesh")]
pub(crate) mod tiled_mesh;
mod up_axis;
mod wkt;

pub use clues::{FileClues, FolderClues, Recognition};
pub use data::{Data, Voxels};
pub use geometry::Geometry;
pub use large::LargeGeometry;
pub use large_volume::LargeVolume;
pub use not_shown::parts_not_shown;
pub use options::{BlockOptions, BlockSize, ClipChoice, Height, HeightOptions, ImportOptions};
pub use point_filter::{ClassSet, MapBounds, PointFilter};
pub use raw_shape::RawShape;
pub use tiled_cloud::TiledCloud;
#[cfg(feature = "mesh")]
pub use tiled_mesh::TiledMesh;

pub(crate) use large_content::LargeContent;
pub(crate) use not_shown::NotShown;
#[cfg(feature = "points")]
pub(crate) use point_filter::none_left;
#[cfg(any(feature = "medical", feature = "rasters", feature = "volumes"))]
pub(crate) use raw_shape::Sample;

use super::source::Source;
use std::path::Path;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::volume::large::SampleSource;

/// A format that is read: how it is told, and the function that reads it.
#[derive(Clone, Copy, Debug)]
pub struct Reader {
    /// What people call the format.
    pub name: &'static str,
    /// What its files hold.
    pub kind: Kind,
    /// Extensions of its files without the dot, lower case, the one to name it by first.
    pub extensions: &'static [&'static str],
    /// Bytes that files of this format alone have; any of them is enough.
    pub magic: &'static [Magic],
    /// What it is, for people: one line.
    pub about: &'static str,
    /// The axis that points up in its files, which readers turn to z; `None` where nobody can ask for another one.
    pub up_axis: Option<UpAxis>,
    /// Reads a file, bytes, or a folder.
    pub read: Read,
    /// Tells a file by more than a name and first bytes.
    pub recognize: Option<fn(&FileClues) -> Recognition>,
    /// Tells a folder.
    pub recognize_folder: Option<RecognizeFolder>,
    /// Opens what stays in its file while it is voxelized.
    pub(crate) open_large: Option<OpenLarge>,
    /// As [`Self::open_large`], for volumes.
    pub(crate) open_large_volume: Option<OpenLargeVolume>,
    /// Whether it takes several files as one.
    pub(crate) takes_tiles: bool,
    /// Whether it leaves out the points that are not asked for by itself.
    pub(crate) filters_points: bool,
    /// Of what its files may have several, of which options choose one.
    #[doc(hidden)]
    pub several: &'static [Several],
}

/// Of what a file of a volume may have several, of which [`ImportOptions`] choose one.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Several {
    /// [`ImportOptions::series`].
    Series,
    /// [`ImportOptions::channel`].
    Channels,
    /// [`ImportOptions::time`].
    TimePoints,
}

/// Whether a folder is one of the format.
pub type RecognizeFolder = fn(&FolderClues) -> Result<bool, ImportError>;

/// Reads what there is, within the limits of the options.
pub type Read = fn(Source<'_>, &ImportOptions) -> Result<Data, ImportError>;

/// Opens a file, or several, for work in so many bytes of memory; `None` where it has to be read as a whole.
pub(crate) type OpenLarge = fn(&Source<'_>, u64, &ImportOptions) -> Result<Option<LargeContent>, ImportError>;

/// Opens a volume whose samples stay where they are; `None` where it has to be read as a whole.
pub(crate) type OpenLargeVolume = fn(Source<'_>, &ImportOptions) -> Result<Option<Box<dyn SampleSource>>, ImportError>;

/// What files of a format hold. A reader may give something else where a file is an exception: points where there are no faces,
/// heights where there is one picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// A scene that says everything about itself: options about units and axes do not change it.
    Scene,
    /// A packed scene, which is opened as it is, whatever its length.
    Packed,
    /// Voxels that are taken as they are.
    Voxels,
    /// A mesh, which is voxelized.
    Mesh,
    /// Points, which are voxelized.
    Points,
    /// A volume, which becomes voxels through a transfer function.
    Volume,
}

/// Bytes at a place of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Magic {
    /// Bytes before them.
    pub offset: usize,
    /// The bytes.
    pub bytes: &'static [u8],
}

impl Magic {
    /// Bytes at the start of a file.
    pub const fn first(bytes: &'static [u8]) -> Self {
        Self { offset: 0, bytes }
    }

    /// Whether a file that begins so has them.
    pub fn is_in(&self, head: &[u8]) -> bool {
        head.get(self.offset..).is_some_and(|head| head.starts_with(self.bytes))
    }
}

impl Reader {
    /// A reader that is told by the extension alone, of a format with z up.
    pub const fn new(
        name: &'static str,
        kind: Kind,
        extensions: &'static [&'static str],
        about: &'static str,
        read: Read,
    ) -> Self {
        Self {
            name,
            kind,
            extensions,
            magic: &[],
            about,
            up_axis: Some(UpAxis::Z),
            read,
            recognize: None,
            recognize_folder: None,
            open_large: None,
            open_large_volume: None,
            takes_tiles: false,
            filters_points: false,
            several: match kind {
                Kind::Volume => &[Several::Channels, Several::TimePoints],
                _ => &[],
            },
        }
    }

    /// Sets [`Self::magic`].
    #[must_use]
    pub const fn with_magic(self, magic: &'static [Magic]) -> Self {
        Self { magic, ..self }
    }

    /// Sets [`Self::up_axis`].
    #[must_use]
    pub const fn with_up_axis(self, up_axis: Option<UpAxis>) -> Self {
        Self { up_axis, ..self }
    }

    /// Sets [`Self::recognize`].
    #[must_use]
    pub const fn with_recognition(self, recognize: fn(&FileClues) -> Recognition) -> Self {
        Self { recognize: Some(recognize), ..self }
    }

    /// Sets [`Self::recognize_folder`].
    #[must_use]
    pub const fn with_folders(self, recognize: RecognizeFolder) -> Self {
        Self { recognize_folder: Some(recognize), ..self }
    }

    /// Sets what opens files larger than memory.
    #[must_use]
    pub(crate) const fn with_large(self, open_large: OpenLarge) -> Self {
        Self { open_large: Some(open_large), ..self }
    }

    /// Sets [`Self::several`].
    #[must_use]
    pub(crate) const fn with_several(self, several: &'static [Several]) -> Self {
        Self { several, ..self }
    }

    /// As [`Self::with_large`], for volumes.
    #[must_use]
    pub(crate) const fn with_large_volumes(self, open: OpenLargeVolume) -> Self {
        Self { open_large_volume: Some(open), ..self }
    }

    /// Sets [`Self::takes_tiles`] and [`Self::filters_points`].
    #[cfg(feature = "points")]
    #[must_use]
    pub(crate) const fn with_tiles_and_filter(self) -> Self {
        Self { takes_tiles: true, filters_points: true, ..self }
    }

    /// The extension of the format that a name ends with, the longest where several do.
    pub fn extension_of(&self, path: &Path) -> Option<&'static str> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        let ends = |extension: &&&str| name.strip_suffix(**extension).is_some_and(|stem| stem.ends_with('.'));
        self.extensions.iter().filter(ends).max_by_key(|extension| extension.len()).copied()
    }
}

impl PartialEq for Reader {
    /// Formats have different names.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}
