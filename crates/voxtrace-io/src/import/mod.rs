//! Reading scenes from files. [`load`] is the one entry: voxel files become scenes as they are, meshes, clouds of points and
//! volumes are voxelized. Formats stand in the table of `readers`, each in the folder of its family.

mod detect;
mod finish;
#[cfg(any(feature = "minecraft", feature = "rasters", feature = "voxels"))]
mod grids;
mod images;
mod label_colors;
mod load;
#[cfg(feature = "medical")]
mod medical;
#[cfg(feature = "mesh")]
mod mesh;
#[cfg(feature = "minecraft")]
pub(crate) mod minecraft;
mod native;
mod panorama;
#[cfg(feature = "points")]
mod points;
#[cfg(feature = "rasters")]
mod rasters;
mod read;
mod reader;
mod readers;
#[cfg(any(feature = "medical", feature = "rasters", feature = "volumes"))]
mod samples;
mod source;
#[cfg(feature = "volumes")]
mod volumes;
pub mod vox;
#[cfg(feature = "voxels")]
mod voxels;

pub use detect::Opened;
#[cfg(feature = "textures")]
pub use images::texture::read_picture;
pub use label_colors::{label_colors_from_bytes, read_label_colors};
pub use load::{Content, Loaded};
pub use panorama::{environment_from_bytes, read_environment};
pub use read::{
    detect, geometry_from_bytes, load, load_bytes, mesh_from_bytes, open, open_large, open_large_volume, read,
    read_bytes, read_geometry, read_mesh, read_volume, read_voxels, volume_from_bytes, voxels_from_bytes,
};
#[doc(hidden)]
pub use reader::Several;
#[cfg(feature = "mesh")]
pub use reader::TiledMesh;
pub use reader::{
    BlockOptions, BlockSize, ClassSet, ClipChoice, Data, FileClues, FolderClues, Geometry, Height, HeightOptions,
    ImportOptions, Kind, LargeGeometry, LargeVolume, Magic, MapBounds, PointFilter, RawShape, Reader, Recognition,
    TiledCloud, Voxels, parts_not_shown,
};
pub use readers::{READERS, Readers};
pub use source::watch::read_while;
pub use source::{Source, opened};
pub use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};
