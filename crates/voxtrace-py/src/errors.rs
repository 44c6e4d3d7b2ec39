//! Exceptions of the package. Each says what is wrong and where; attributes say the same to programs.

use pyo3::PyTypeInfo;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyOSError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Display;
use voxtrace::TraceError;
use voxtrace::import::ImportError;
use voxtrace::voxelize::VoxelizeError;

pyo3::create_exception!(
    voxtrace,
    VoxtraceError,
    PyException,
    "What voxtrace could not do. Attributes: `path` (str or None), `offset` (bytes from the start of the file, or None) and `hint` (str or None)."
);
pyo3::create_exception!(voxtrace, ReadError, VoxtraceError, "A file could not be read as a scene or a volume.");
pyo3::create_exception!(voxtrace, DeviceError, VoxtraceError, "A device lacks something, or failed.");

/// An exception of a kind with the attributes that all of ours have.
fn exception<E: PyTypeInfo>(
    py: Python<'_>,
    text: String,
    path: Option<String>,
    offset: Option<u64>,
    hint: Option<&str>,
) -> PyErr {
    let error = PyErr::from_type(E::type_object(py), text);
    let value = error.value(py);
    let set = value.setattr("path", path).and(value.setattr("offset", offset)).and(value.setattr("hint", hint));
    set.err().unwrap_or(error)
}

/// A file that cannot be read. One that is not there, or may not be opened, is an `OSError` as Python's own.
pub fn of_reading(py: Python<'_>, error: &ImportError) -> PyErr {
    use voxtrace::import::ImportErrorKind;
    let path = error.path.display().to_string();
    match &error.kind {
        ImportErrorKind::Stopped => PyKeyboardInterrupt::new_err(()),
        ImportErrorKind::Io(cause) if cause.raw_os_error().is_some() => {
            let text = std::io::Error::from_raw_os_error(cause.raw_os_error().unwrap_or(0)).to_string();
            let text = text.split(" (os error").next().unwrap_or_default().to_owned();
            PyOSError::new_err((cause.raw_os_error(), text, path))
        }
        ImportErrorKind::UnknownFormat(_) => {
            let hint = "`voxtrace formats` lists what can be read";
            exception::<ReadError>(py, error.to_string(), Some(path), error.offset, Some(hint))
        }
        _ => exception::<ReadError>(py, error.to_string(), Some(path), error.offset, None),
    }
}

/// Bytes that are no film.
pub fn of_film(py: Python<'_>, error: impl Display) -> PyErr {
    exception::<ReadError>(py, error.to_string(), None, None, None)
}

/// Bytes that are no scene.
pub fn of_packed(py: Python<'_>, error: impl Display) -> PyErr {
    exception::<ReadError>(py, error.to_string(), None, None, Some("they are those of a .vxt file"))
}

/// What a tracer could not do.
pub fn of_tracing(py: Python<'_>, error: &TraceError) -> PyErr {
    match error {
        TraceError::BadFrame(_) | TraceError::Placement(_) => PyValueError::new_err(error.to_string()),
        _ => exception::<DeviceError>(py, error.to_string(), None, None, None),
    }
}

/// Anything else that voxtrace refuses.
pub fn other(py: Python<'_>, error: impl Display) -> PyErr {
    exception::<VoxtraceError>(py, error.to_string(), None, None, None)
}

/// What voxelizing could not do.
pub fn raised(py: Python<'_>, error: VoxelizeError) -> PyErr {
    match error {
        VoxelizeError::Import(error) => of_reading(py, &error),
        VoxelizeError::Cancelled => PyKeyboardInterrupt::new_err(()),
        VoxelizeError::BadScale(_) | VoxelizeError::Missing(_) | VoxelizeError::TooThin(_) => argument(error),
        error => other(py, error),
    }
}

/// An argument that cannot be.
pub fn argument(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A file that the system does not let us write.
pub fn of_writing(path: &std::path::Path, error: &std::io::Error) -> PyErr {
    match error.raw_os_error() {
        Some(number) => {
            let text = error.to_string();
            let text = text.split(" (os error").next().unwrap_or_default().to_owned();
            PyOSError::new_err((number, text, path.display().to_string()))
        }
        None => argument(format!("{}: {error}", path.display())),
    }
}
