//! What a page shows about a scene beside its picture.

use crate::places::{Place, format_of};
use crate::scenes::Opened;
use serde::Serialize;
use voxtrace::Camera;
use voxtrace::glam::Vec3;
use voxtrace::scene::Unit;

/// Bytes of a packed scene that a page takes and traces itself; of larger ones it gets pictures.
pub const LARGEST_FOR_PAGES: u64 = 192 << 20;

/// A scene as JSON. Places are in world units, z up.
#[derive(Debug, Serialize)]
pub struct Info {
    /// The scene's own name.
    pub name: String,
    pub format: &'static str,
    /// Bytes of the file; of a folder none.
    pub file_bytes: Option<u64>,
    /// Bytes of the packed scene.
    pub bytes: u64,
    pub voxels: u64,
    pub models: u64,
    pub instances: u64,
    pub materials: u64,
    pub emissive_voxels: u64,
    /// Voxels along x, y and z.
    pub size: [u64; 3],
    /// World units of a voxel's edge, and what unit that is.
    pub voxel_size: f64,
    pub unit: Option<&'static str>,
    pub bounds: Option<[[f32; 3]; 2]>,
    pub cameras: Vec<String>,
    /// A hash of everything that a picture depends on.
    pub content_hash: String,
    pub notes: Vec<String>,
    /// Whether a page may take the scene and trace it itself.
    pub fits_pages: bool,
}

impl Info {
    pub fn of(place: &Place, opened: &Opened) -> Self {
        let Opened { scene, notes, bytes, .. } = opened;
        let statistics = scene.statistics();
        Self {
            name: scene.name.clone(),
            // A folder may be called like a file.
            format: format_of(&place.path).filter(|_| place.metadata.is_file()).unwrap_or("folder"),
            file_bytes: place.metadata.is_file().then_some(place.metadata.len()),
            bytes: *bytes,
            voxels: statistics.voxels,
            models: statistics.models,
            instances: statistics.instances,
            materials: statistics.materials,
            emissive_voxels: statistics.emissive_voxels,
            size: statistics.size.map(Into::into),
            voxel_size: scene.voxel_size,
            unit: match scene.unit {
                Unit::Voxel => None,
                Unit::Metre => Some("m"),
                Unit::Millimetre => Some("mm"),
            },
            bounds: scene.bounds().map(|(least, most)| [least, most].map(|corner: Vec3| corner.to_array())),
            cameras: scene.cameras.iter().map(|camera: &Camera| camera.name.clone()).collect(),
            content_hash: format!("{:016x}", scene.content_hash()),
            notes: notes.clone(),
            fits_pages: *bytes <= LARGEST_FOR_PAGES,
        }
    }
}
