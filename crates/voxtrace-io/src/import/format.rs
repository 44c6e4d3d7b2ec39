//! Which format a file has, told by its first bytes, or where they say nothing by its extension.

use super::volume::{dicom, vdb};
use super::voxels::{self, BINVOX_MAGIC};
use super::{e57, gltf, las, stl};
use std::path::Path;
use voxtrace_core::packed;

/// A kind of file that is read as a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// MagicaVoxel scene; also what Slab6 writes under that extension.
    Vox,
    /// voxtrace's own packed scene.
    Native,
    /// Minecraft build: `.schem`, `.schematic`, `.litematic`.
    Schematic,
    /// Region of a Minecraft world, or a folder of them.
    Region,
    /// Model of Qubicle: `.qb`, `.qbt`, `.qbcl`, `.qef`.
    Qubicle,
    /// Voxels without colours.
    Binvox,
    /// Heights, as a picture or a grid.
    Heightmap,
    /// glTF 2.0, text or binary.
    Gltf,
    /// Wavefront OBJ with MTL; points where it has no faces.
    Obj,
    /// Stanford polygons.
    Ply,
    /// Triangles of stereolithography.
    Stl,
    /// Points of a laser scan, LAS or LAZ.
    Las,
    /// Points as text.
    Xyz,
    /// Points of the Point Cloud Library.
    Pcd,
    /// Points of laser scanners on the ground.
    E57,
    /// NIfTI-1 or -2 volume.
    Nifti,
    /// NRRD volume.
    Nrrd,
    /// MetaImage volume.
    MetaImage,
    /// NumPy array.
    Npy,
    /// DICOM: a file, or a folder with a series.
    Dicom,
    /// Pages of a TIFF, or a folder of PNG or TIFF pictures.
    Slices,
    /// OpenVDB: level sets and densities.
    Vdb,
    /// Zarr and OME-Zarr: a folder.
    Zarr,
    /// Samples without a header.
    Raw,
}

/// The first bytes that [`Format::detect`] wants to see.
pub const HEAD: usize = 132;

impl Format {
    /// All of them.
    pub const ALL: [Self; 24] = [
        Self::Vox,
        Self::Native,
        Self::Schematic,
        Self::Region,
        Self::Qubicle,
        Self::Binvox,
        Self::Heightmap,
        Self::Gltf,
        Self::Obj,
        Self::Ply,
        Self::Stl,
        Self::Las,
        Self::Xyz,
        Self::Pcd,
        Self::E57,
        Self::Nifti,
        Self::Nrrd,
        Self::MetaImage,
        Self::Npy,
        Self::Dicom,
        Self::Slices,
        Self::Vdb,
        Self::Zarr,
        Self::Raw,
    ];

    /// Extensions, lower case.
    pub fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Vox => &["vox"],
            Self::Native => &["vxt"],
            Self::Schematic => &["schem", "schematic", "litematic"],
            Self::Region => &["mca"],
            Self::Qubicle => &["qb", "qbt", "qbcl", "qef"],
            Self::Binvox => &["binvox"],
            Self::Heightmap => &["png", "asc", "dem"],
            Self::Gltf => &["glb", "gltf"],
            Self::Obj => &["obj"],
            Self::Ply => &["ply"],
            Self::Stl => &["stl"],
            Self::Las => &["las", "laz"],
            Self::Xyz => &["xyz", "csv", "pts"],
            Self::Pcd => &["pcd"],
            Self::E57 => &["e57"],
            Self::Nifti => &["nii", "nii.gz"],
            Self::Nrrd => &["nrrd", "nhdr"],
            Self::MetaImage => &["mha", "mhd"],
            Self::Npy => &["npy"],
            Self::Dicom => &["dcm"],
            Self::Slices => &["tif", "tiff"],
            Self::Vdb => &["vdb"],
            Self::Zarr => &["zarr"],
            Self::Raw => &["raw"],
        }
    }

    /// What it is, for people.
    pub fn about(self) -> &'static str {
        match self {
            Self::Vox => "MagicaVoxel scene, or voxels of Slab6",
            Self::Native => "voxtrace scene, packed, opened without copying",
            Self::Schematic => "Minecraft build: colours by the names of the blocks",
            Self::Region => "region of a Minecraft world, or its folder",
            Self::Qubicle => "Qubicle model: matrices of colours",
            Self::Binvox => "voxels without colours",
            Self::Heightmap => "heights: one picture, an ESRI grid or a model of the USGS",
            Self::Gltf => "glTF 2.0 mesh with materials, pictures, nodes and cameras",
            Self::Obj => "Wavefront mesh with MTL materials and pictures, or points",
            Self::Ply => "Stanford mesh with colours or a picture, or points",
            Self::Stl => "mesh without colours",
            Self::Las => "points of a laser scan: colours, intensities, classes",
            Self::Xyz => "points as text",
            Self::Pcd => "points of the Point Cloud Library: text, binary or compressed",
            Self::E57 => "points of laser scanners, each scan at its pose",
            Self::Nifti => "volume of medicine, plain or gzip",
            Self::Nrrd => "volume, with its samples inside or beside it",
            Self::MetaImage => "volume, with its samples inside or beside it",
            Self::Npy => "NumPy array of up to three axes",
            Self::Dicom => "pictures of a scanner: one file, or a folder with a series",
            Self::Slices => "slices: pages of a TIFF, or a folder of PNG or TIFF pictures",
            Self::Vdb => "OpenVDB: a level set or densities",
            Self::Zarr => "a folder of Zarr 2 or 3, or OME-Zarr",
            Self::Raw => "samples without a header, with --raw-shape",
        }
    }

    /// Whether it holds a mesh or points, which are voxelized.
    pub fn is_geometry(self) -> bool {
        !matches!(self, Self::Vox | Self::Native) && !self.is_volume() && !self.is_voxels()
    }

    /// Whether it holds a volume, which becomes voxels through a transfer function.
    pub fn is_volume(self) -> bool {
        matches!(
            self,
            Self::Nifti
                | Self::Nrrd
                | Self::MetaImage
                | Self::Npy
                | Self::Dicom
                | Self::Slices
                | Self::Vdb
                | Self::Zarr
                | Self::Raw
        )
    }

    /// Whether it holds voxels that are taken as they are.
    pub fn is_voxels(self) -> bool {
        matches!(self, Self::Schematic | Self::Region | Self::Qubicle | Self::Binvox | Self::Heightmap)
    }

    /// The format of a file from its first bytes (64 are enough) and its name; `None` where neither is known.
    pub fn detect(head: &[u8], path: &Path) -> Option<Self> {
        if head.starts_with(b"VOX ") {
            return Some(Self::Vox);
        }
        if head.starts_with(&packed::MAGIC) {
            return Some(Self::Native);
        }
        if head.starts_with(BINVOX_MAGIC) {
            return Some(Self::Binvox);
        }
        if voxels::is_qubicle(head) {
            return Some(Self::Qubicle);
        }
        if head.starts_with(gltf::MAGIC) {
            return Some(Self::Gltf);
        }
        if head.starts_with(b"ply\n") || head.starts_with(b"ply\r") {
            return Some(Self::Ply);
        }
        if head.starts_with(las::MAGIC) {
            return Some(Self::Las);
        }
        if head.starts_with(e57::MAGIC) {
            return Some(Self::E57);
        }
        if head.starts_with(b"# .PCD v") {
            return Some(Self::Pcd);
        }
        if head.starts_with(vdb::MAGIC) {
            return Some(Self::Vdb);
        }
        if head.starts_with(b"NRRD000") {
            return Some(Self::Nrrd);
        }
        if head.starts_with(b"\x93NUMPY") {
            return Some(Self::Npy);
        }
        if head.get(128..).is_some_and(|head| head.starts_with(dicom::MAGIC)) {
            return Some(Self::Dicom);
        }
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        let ends_with = |extension: &&str| name.strip_suffix(extension).is_some_and(|stem| stem.ends_with('.'));
        let by_name = Self::ALL.into_iter().find(|format| format.extensions().iter().any(ends_with));
        // The words of a text are weaker than any extension.
        by_name.or_else(|| stl::begins(head).then_some(Self::Stl))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_format_holds_both_geometry_and_a_volume() {
        for format in Format::ALL {
            assert!(!(format.is_geometry() && format.is_volume()), "{format:?}");
        }
        assert!(Format::Nifti.is_volume() && Format::Ply.is_geometry() && !Format::Vox.is_geometry());
    }

    #[test]
    fn first_bytes_come_before_the_extension() {
        let detect = |head: &[u8], name: &str| Format::detect(head, Path::new(name));
        assert_eq!(detect(b"glTF\x02\0\0\0", "scene.obj"), Some(Format::Gltf));
        assert_eq!(detect(b"ply\nformat", "scan"), Some(Format::Ply));
        assert_eq!(detect(b"VOX \xc8\0\0\0", "x.stl"), Some(Format::Vox));
        assert_eq!(detect(b"VOXTRACE", "x.vox"), Some(Format::Native));
        assert_eq!(detect(b"{\"asset\"", "a.GLTF"), Some(Format::Gltf));
        assert_eq!(detect(b"v 0 0 0", "a.Obj"), Some(Format::Obj));
        assert_eq!(detect(b"solid", "a.stl"), Some(Format::Stl));
        assert_eq!(detect(b"solid a\n facet normal 0 0 1", "a"), Some(Format::Stl));
        assert_eq!(detect(b"solid ground", "a"), None);
        assert_eq!(detect(b"LASF\0\0", "tile.bin"), Some(Format::Las));
        assert_eq!(detect(b"1 2 3", "a.XYZ"), Some(Format::Xyz));
        assert_eq!(detect(b"\x1f\x8b", "head.1.NII.gz"), Some(Format::Nifti));
        assert_eq!((detect(b"\x1f\x8b", "a.gz"), detect(b"", "nii.gz")), (None, None));
        assert_eq!(detect(b"NRRD0005\n", "scan"), Some(Format::Nrrd));
        assert_eq!((detect(b"", "a.jpg"), detect(b"", "noextension")), (None, None));
    }
}
