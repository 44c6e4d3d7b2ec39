//! Scenes as workers hold them: built in, read from the bytes of a file, or packed by another worker.

use crate::error_of;
use std::path::Path;
use std::sync::Arc;
use voxtrace_core::PackedScene;
use voxtrace_io::import::{self, Content, FileClues, ImportError, ImportOptions, READERS, Readers};
use voxtrace_scene::{Camera, glam::Vec3};
use wasm_bindgen::prelude::*;

/// The name of the format of a file by its first bytes and its name, if this module reads it.
#[wasm_bindgen]
pub fn format_of(head: &[u8], length: f64, name: &str) -> Option<String> {
    let options = ImportOptions::default();
    let head = &head[..head.len().min(HEAD)];
    let clues = FileClues { path: Path::new(name), head, length: Some(length as u64), options: &options };
    let readers: Readers = READERS;
    readers.of_file(&clues).map(|reader| reader.name.to_owned())
}

/// First bytes that tell a format.
const HEAD: usize = 132;

/// A packed scene.
#[wasm_bindgen]
pub struct WebScene {
    scene: Arc<PackedScene>,
    notes: Vec<String>,
}

#[wasm_bindgen]
impl WebScene {
    /// A built-in scene of about `voxels` voxels; `forest` of as many instances.
    ///
    /// # Errors
    /// Where there is no scene of that name, or the number is out of range.
    #[cfg(feature = "scenes")]
    pub fn built_in(name: &str, voxels: Option<f64>) -> Result<Self, JsError> {
        let scene = match voxels {
            Some(instances) if name == voxtrace_scenes::FOREST => {
                voxtrace_scenes::generate_forest_while(instances as u32, &|| true)
            }
            voxels => voxtrace_scenes::generate(name, voxels.map(|voxels| voxels as u64)),
        };
        let packed = PackedScene::pack_merged(&scene.map_err(error_of)?).map_err(error_of)?;
        Ok(Self { scene: Arc::new(packed), notes: Vec::new() })
    }

    /// Another module has the built-in scenes.
    ///
    /// # Errors
    /// Always.
    #[cfg(not(feature = "scenes"))]
    pub fn built_in(_name: &str, _voxels: Option<f64>) -> Result<Self, JsError> {
        Err(JsError::new("this module has no built-in scenes"))
    }

    /// Reads the bytes of a file; `name` tells its format where they do not, and stands in errors.
    ///
    /// # Errors
    /// The library's own line, where it cannot be read.
    pub fn read(bytes: Vec<u8>, name: &str) -> Result<Self, JsError> {
        let options = ImportOptions { in_memory: true, ..ImportOptions::default() };
        let (scene, notes) = read_scene(&bytes, Path::new(name), &options).map_err(error_of)?;
        drop(bytes);
        let packed = match scene {
            Content::Packed(packed) => *packed,
            Content::Scene(scene) => PackedScene::pack_merged(&scene).map_err(error_of)?,
        };
        Ok(Self { scene: Arc::new(packed), notes })
    }

    /// The scene as the bytes of a native file, for other workers: they [`Self::read`] it without work of their own.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.scene.to_bytes()
    }

    /// Its name.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.scene.name.clone()
    }

    /// What its reader left out or put up with, a line each.
    #[wasm_bindgen(getter)]
    pub fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// Number of voxels, those of a model with several instances once.
    #[wasm_bindgen(getter)]
    pub fn voxels(&self) -> f64 {
        self.scene.voxel_count() as f64
    }

    /// Names of its cameras.
    #[wasm_bindgen(getter)]
    pub fn camera_names(&self) -> Vec<String> {
        self.scene.cameras.iter().map(|camera| camera.name.clone()).collect()
    }

    /// The numbers of one of its cameras: eye, target, up, vertical field of view in degrees. Without one of that number, those of a view that shows
    /// the whole scene in pictures of `aspect` = width / height.
    pub fn camera(&self, index: usize, aspect: f32) -> Vec<f32> {
        let camera = self.scene.cameras.get(index).cloned().unwrap_or_else(|| self.scene.portrait(aspect));
        numbers_of(&camera)
    }

    /// The least and the largest corner of the box around all voxels, world units.
    pub fn bounds(&self) -> Vec<f32> {
        let (min, max) = self.scene.bounds().unwrap_or((Vec3::ZERO, Vec3::ONE));
        [min.to_array(), max.to_array()].concat()
    }

    /// A hash of everything that a picture of the scene depends on, in hexadecimal digits.
    pub fn content_hash(&self) -> String {
        format!("{:016x}", self.scene.content_hash())
    }
}

impl WebScene {
    /// The scene itself.
    pub fn packed(&self) -> &Arc<PackedScene> {
        &self.scene
    }
}

/// A scene and the reader's notes.
#[cfg(any(feature = "readers", not(target_arch = "wasm32")))]
fn read_scene(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<(Content, Vec<String>), ImportError> {
    let loaded = import::load_bytes(bytes, path, options)?;
    Ok((loaded.content, loaded.notes))
}

/// As above, of files that have voxels: a small module has no voxelizer.
#[cfg(all(not(feature = "readers"), target_arch = "wasm32"))]
fn read_scene(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<(Content, Vec<String>), ImportError> {
    let data = import::read_bytes(bytes, path, options)?;
    let notes = data.notes().to_vec();
    match data {
        import::Data::Packed(packed) => Ok((Content::Packed(packed), notes)),
        import::Data::Voxels(voxels) => Ok((Content::Scene(Box::new(voxels.scene)), notes)),
        _ => Err(ImportError::of_file(path, import::ImportErrorKind::UnknownFormat("it has no voxels".into()))),
    }
}

fn numbers_of(camera: &Camera) -> Vec<f32> {
    let vectors = [camera.eye, camera.target, camera.up].map(|vector| vector.to_array());
    [vectors.concat(), vec![camera.fov_y]].concat()
}
