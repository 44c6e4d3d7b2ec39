//! The extension module `voxtrace._voxtrace`: the engine for Python. The package around it, `python/voxtrace`, has what is easier said in Python.
#![allow(missing_docs, reason = "docstrings stand at the methods")]

mod arguments;
mod camera;
mod clip;
mod editor;
mod errors;
mod forks;
mod found;
mod grid;
mod image;
mod interrupt;
mod material;
mod open;
mod pickle;
mod renderer;
mod scene;
mod sky;
mod tiled_mesh;
mod tiles;
mod transfer;
mod volume;
mod volume_parts;

use pyo3::prelude::*;

#[pymodule]
mod _voxtrace {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::camera::PyCamera;
    #[pymodule_export]
    use super::clip::save_clip;
    #[pymodule_export]
    use super::editor::PyEditor;
    #[pymodule_export]
    use super::errors::{DeviceError, ReadError, VoxtraceError};
    #[pymodule_export]
    use super::grid::PyVoxelGrid;
    #[pymodule_export]
    use super::image::PyImage;
    #[pymodule_export]
    use super::material::PyMaterial;
    #[pymodule_export]
    use super::open::{builtin, open, open_volume};
    #[pymodule_export]
    use super::renderer::PyRenderer;
    #[pymodule_export]
    use super::scene::{PyInstance, PyScene};
    #[pymodule_export]
    use super::sky::PySky;
    #[pymodule_export]
    use super::tiled_mesh::{PyTiledMesh, join_mesh_surveys};
    #[pymodule_export]
    use super::tiles::{PyTiledCloud, join_surveys};
    #[pymodule_export]
    use super::transfer::PyTransfer;
    #[pymodule_export]
    use super::volume::PyVolume;
    #[pymodule_export]
    use super::volume_parts::PyTiledVolume;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("BUILTIN_SCENES", voxtrace::scenes::NAMES.to_vec())
    }
}
