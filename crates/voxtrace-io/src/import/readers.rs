//! The table of formats: one line each. Everything that is known of a format stands in its own folder, in the [`Reader`] there.

use super::reader::Reader;

/// Readers of formats, in the order in which they are asked.
#[derive(Clone, Copy, Debug)]
pub struct Readers<'a>(pub &'a [&'a Reader]);

/// All readers of this build.
pub static READERS: Readers = Readers(&[
    &super::vox::READER,
    &super::native::READER,
    #[cfg(feature = "mesh")]
    &super::mesh::gltf::READER,
    #[cfg(feature = "mesh")]
    &super::mesh::obj::READER,
    #[cfg(feature = "mesh")]
    &super::mesh::ply::READER,
    #[cfg(feature = "mesh")]
    &super::mesh::stl::READER,
    #[cfg(feature = "points")]
    &super::points::las::READER,
    #[cfg(feature = "points")]
    &super::points::xyz::READER,
    #[cfg(feature = "points")]
    &super::points::pcd::READER,
    #[cfg(feature = "points")]
    &super::points::e57::READER,
    #[cfg(feature = "minecraft")]
    &super::minecraft::BUILDS,
    #[cfg(feature = "minecraft")]
    &super::minecraft::WORLDS,
    #[cfg(feature = "voxels")]
    &super::voxels::qubicle::READER,
    #[cfg(feature = "voxels")]
    &super::voxels::slab6::READER,
    #[cfg(feature = "voxels")]
    &super::voxels::voxlap::READER,
    #[cfg(feature = "voxels")]
    &super::voxels::goxel::READER,
    #[cfg(feature = "voxels")]
    &super::voxels::binvox::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::nrrd::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::metaimage::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::npy::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::npz::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::raw::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::vdb::READER,
    #[cfg(feature = "volumes")]
    &super::volumes::zarr::READER,
    #[cfg(feature = "rasters")]
    &super::rasters::heightmap::READER,
    #[cfg(feature = "rasters")]
    &super::rasters::slices::READER,
    #[cfg(feature = "medical")]
    &super::medical::nifti::READER,
    #[cfg(feature = "medical")]
    &super::medical::mgh::READER,
    #[cfg(feature = "medical")]
    &super::medical::parrec::READER,
    #[cfg(feature = "medical")]
    &super::medical::dicom::READER,
]);

impl<'a> Readers<'a> {
    /// Each of them.
    pub fn iter(self) -> impl Iterator<Item = &'a Reader> {
        self.0.iter().copied()
    }

    /// Every extension once, in the order of the table.
    pub fn extensions(self) -> Vec<&'static str> {
        let mut found = Vec::new();
        for extension in self.iter().flat_map(|reader| reader.extensions) {
            if !found.contains(extension) {
                found.push(*extension);
            }
        }
        found
    }
}

#[cfg(all(test, feature = "medical", feature = "volumes"))]
mod tests {
    use super::*;
    use crate::import::reader::{Kind, Several};

    #[test]
    fn the_table_says_of_what_files_may_have_several() {
        let with = |wanted: Several| {
            let readers = READERS.iter().filter(|reader| reader.several.contains(&wanted));
            readers.map(|reader| reader.name).collect::<Vec<_>>()
        };
        assert_eq!(with(Several::Series), ["NumPy archive", "DICOM"]);
        let (channels, times) = (with(Several::Channels), with(Several::TimePoints));
        assert!(channels.contains(&"NRRD") && !channels.contains(&"DICOM") && !channels.contains(&"OpenVDB"));
        assert!(times.contains(&"DICOM") && !times.contains(&"raw samples"), "{times:?}");
        assert!(READERS.iter().all(|reader| reader.kind == Kind::Volume || reader.several.is_empty()));
    }
}
