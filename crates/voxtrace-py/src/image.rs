//! `Image`: a rendered picture as arrays and files.

use crate::errors::{argument, of_film, of_writing, other};
use crate::forks::detach;
use crate::interrupt::run_while;
use crate::scene::PyScene;
use numpy::ndarray::{Array, Array2};
use numpy::{IntoPyArray, PyArray2, PyArray3, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use voxtrace::denoise::Features;
use voxtrace::film::{AovPixel, Pixel};
use voxtrace::glam::Vec3;
use voxtrace::output::{Denoised, FilmFile, Operator, SceneStamp, ToneBytes, ToneMap};
use voxtrace::{Film, Picture, RenderError};
use voxtrace_oidn::{Oidn, OidnError};

/// A picture taken apart: its film, what traced it, and where its noise was removed the name of the filter and the radiance that it left.
type Pickled<'py> = (Bound<'py, PyBytes>, String, Option<(String, Bound<'py, PyArray2<f32>>)>);

/// A rendered picture. In a notebook it shows itself.
#[pyclass(name = "Image", module = "voxtrace", frozen)]
pub struct PyImage {
    pub picture: Picture,
    /// What traced, and why that.
    #[pyo3(get)]
    device: String,
}

/// Names of filters that remove noise.
const VOXTRACE: &str = "voxtrace";
const OIDN: &str = "oidn";

impl PyImage {
    pub fn new(picture: Picture, device: String) -> Self {
        Self { picture, device }
    }

    fn film(&self) -> &Film {
        self.picture.film()
    }

    /// Height and width, pixels.
    pub fn size(&self) -> (usize, usize) {
        let region = self.film().region;
        (region.height() as usize, region.width() as usize)
    }

    /// Mean radiance of each pixel, without its noise where that was removed.
    fn means(&self) -> Vec<Vec3> {
        match self.picture.denoised() {
            Some(denoised) => denoised.radiance.clone(),
            None => self.film().pixels.iter().map(Pixel::mean).collect(),
        }
    }

    /// What a screen shows of each pixel: red, green, blue and straight alpha, sRGB; and whether any of it may be transparent.
    pub fn shown(&self) -> (Vec<u8>, bool) {
        let tone = ToneBytes::new(ToneMap::default());
        let is_transparent = self.picture.film_file().frame.transparent;
        let pixel = |(radiance, pixel): (Vec3, &Pixel)| {
            let alpha = if is_transparent { pixel.alpha() } else { 1.0 };
            let [red, green, blue] = tone.of(if alpha > 0.0 { radiance / alpha } else { Vec3::ZERO });
            [red, green, blue, (alpha * 255.0).round() as u8]
        };
        (self.means().into_iter().zip(&self.film().pixels).flat_map(pixel).collect(), is_transparent)
    }

    /// An array of so many numbers a pixel.
    fn array<'py, T: numpy::Element, const N: usize>(
        &self,
        py: Python<'py>,
        values: impl Iterator<Item = [T; N]> + Send,
    ) -> PyResult<Bound<'py, PyArray3<T>>> {
        let (height, width) = self.size();
        let values: Vec<T> = py.detach(|| values.flatten().collect());
        Ok(Array::from_shape_vec((height, width, N), values).map_err(argument)?.into_pyarray(py))
    }
}

#[pymethods]
impl PyImage {
    /// Height and width, pixels.
    #[getter]
    fn shape(&self) -> (usize, usize) {
        self.size()
    }

    /// Linear radiance, shape `(H, W, 3)`, float32; without its noise where that was removed.
    #[getter]
    fn radiance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        self.array(py, self.means().into_iter().map(|mean| mean.to_array()))
    }

    /// Mean of the samples as they are, shape `(H, W, 3)`, float32.
    #[getter]
    fn noisy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        self.array(py, self.film().pixels.iter().map(|pixel| pixel.mean().to_array()))
    }

    /// Share of the samples whose ray met a voxel, shape `(H, W)`, float32.
    #[getter]
    fn alpha<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let values = self.film().pixels.iter().map(Pixel::alpha).collect();
        Ok(Array::from_shape_vec(self.size(), values).map_err(argument)?.into_pyarray(py))
    }

    /// Sums of the samples' radiance in units of 2⁻³², shape `(H, W, 3)`, uint64: they are the same on every device, and films of other samples of the same
    /// frame can be added to them.
    #[getter]
    fn sums<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u64>>> {
        self.array(py, self.film().pixels.iter().map(|pixel| pixel.radiance))
    }

    /// What the ray through the middle of each pixel meets; noise-free, zeros where it is nothing (`"instance"`: 4294967295).
    ///
    /// `"albedo"` and `"normal"`: float32, `(H, W, 3)`; `"depth"`: float32, `(H, W, 1)`, world units; `"instance"`: uint32, `(H, W, 1)`; `"voxel"`: int32, `(H, W, 3)`.
    ///
    /// Raises `ValueError` for another name, or where `aovs=True` was not asked for.
    fn aov<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let Some(aovs) = &self.film().aovs else { return Err(argument("render with aovs=True to have them")) };
        let of = |value: fn(&AovPixel) -> [f32; 3]| self.array(py, aovs.iter().map(value)).map(Bound::into_any);
        match name {
            "albedo" => of(|pixel| pixel.albedo.to_array()),
            "normal" => of(|pixel| pixel.normal.to_array()),
            "depth" => self.array(py, aovs.iter().map(|pixel| [pixel.depth])).map(Bound::into_any),
            "instance" => self.array(py, aovs.iter().map(|pixel| [pixel.instance])).map(Bound::into_any),
            "voxel" => self.array(py, aovs.iter().map(|pixel| pixel.voxel.to_array())).map(Bound::into_any),
            other => Err(argument(format!(
                "{other:?} is none of \"albedo\", \"normal\", \"depth\", \"instance\" and \"voxel\""
            ))),
        }
    }

    /// What a screen shows: sRGB, shape `(H, W, 3)`, uint8. `exposure` in stops; `tone_map`: `"agx"`, `"neutral"`, `"reinhard"` or `"linear"`.
    #[pyo3(signature = (*, exposure=0.0, tone_map="agx"))]
    fn to_srgb<'py>(&self, py: Python<'py>, exposure: f32, tone_map: &str) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let tone = ToneBytes::new(tone_of(exposure, tone_map)?);
        self.array(py, self.means().into_iter().map(|mean| tone.of(mean)))
    }

    /// As numpy wants it: `to_srgb()`.
    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        &self,
        py: Python<'py>,
        dtype: Option<Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if copy == Some(false) {
            return Err(argument("the array of a picture is always made anew: it cannot be had with copy=False"));
        }
        let array = self.to_srgb(py, 0.0, "agx")?.into_any();
        match dtype {
            Some(dtype) => array.call_method1("astype", (dtype,)),
            None => Ok(array),
        }
    }

    /// Writes the picture: `.png`, `.exr` (linear, with AOVs) or `.vxf` (the film, which `voxtrace render --resume` goes on with). The file is whole or what
    /// it was before, also where Ctrl-C ends it; the compression of a PNG goes on to its end.
    ///
    /// Raises `ValueError` for another name, `OSError` where the file cannot be written.
    #[pyo3(signature = (path, *, exposure=0.0, tone_map="agx"))]
    fn save(&self, py: Python<'_>, path: PathBuf, exposure: f32, tone_map: &str) -> PyResult<()> {
        let picture = self.picture.clone().tone_map(tone_of(exposure, tone_map)?);
        run_while(py, |wanted| picture.save_while(&path, wanted))?.map_err(|error| match error {
            RenderError::Io { path, error } => of_writing(&path, &error),
            error => argument(error),
        })
    }

    /// The film as the bytes of a `.vxf` file; noise that was removed comes back with it.
    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &py.detach(|| self.picture.film_file().to_bytes()))
    }

    /// The picture of the bytes of a `.vxf` file.
    ///
    /// Raises `ReadError` where they are none.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, film: Vec<u8>) -> PyResult<Self> {
        let file = py.detach(|| FilmFile::from_bytes(&film)).map_err(|error| of_film(py, &error))?;
        Ok(Self::new(Picture::of_film(file), "a film".into()))
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    #[pyo3(signature = (film, device, denoised))]
    fn _of_parts(
        py: Python<'_>,
        film: &[u8],
        device: String,
        denoised: Option<(String, PyReadonlyArray2<'_, f32>)>,
    ) -> PyResult<Self> {
        let file = py.detach(|| FilmFile::from_bytes(film)).map_err(|error| of_film(py, &error))?;
        let picture = Picture::of_film(file);
        let Some((filter, radiance)) = denoised else { return Ok(Self::new(picture, device)) };
        if radiance.as_array().dim() != (picture.film().pixels.len(), 3) {
            return Err(argument("the picture without noise has other pixels than its film"));
        }
        let radiance = radiance.as_array().outer_iter().map(|pixel| Vec3::new(pixel[0], pixel[1], pixel[2])).collect();
        let filter = if filter == OIDN { OIDN } else { VOXTRACE };
        Ok(Self::new(picture.denoised_as(Denoised { radiance, filter }), device))
    }

    /// For pickle: what makes the same picture, without its noise where that was removed.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled<'py>)> {
        let denoised = self.picture.denoised().map(|denoised| {
            let values = py.detach(|| denoised.radiance.iter().flat_map(|radiance| radiance.to_array()).collect());
            let values = Array2::from_shape_vec((denoised.radiance.len(), 3), values).map_err(argument)?;
            Ok::<_, PyErr>((denoised.filter.to_owned(), values.into_pyarray(py)))
        });
        let parts = (self.to_bytes(py), self.device.clone(), denoised.transpose()?);
        Ok((py.get_type::<Self>().getattr("_of_parts")?, parts))
    }

    /// The same one: it is never changed.
    fn __copy__<'py>(slf: &Bound<'py, Self>) -> Bound<'py, Self> {
        slf.clone()
    }

    fn __deepcopy__<'py>(slf: &Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf.clone()
    }

    /// The picture of all samples of pictures of the same frame whose ranges of samples join, in any order: bit for bit what one run of all of them gives.
    /// `halfway`: it keeps what there was after half of the samples, as `denoise` wants it; a range has to end there.
    ///
    /// Raises `ValueError` where ranges overlap or leave a gap, or pictures are of different frames or scenes.
    #[staticmethod]
    #[pyo3(signature = (images, *, halfway=false))]
    fn merge(py: Python<'_>, images: Vec<PyRef<'_, Self>>, halfway: bool) -> PyResult<Self> {
        let device = images.first().map(|image| image.device.clone()).unwrap_or_default();
        let films: Vec<&FilmFile> = images.iter().map(|image| image.picture.film_file()).collect();
        detach(py, || merged(films, halfway))?.map(|film| Self::new(Picture::of_film(film), device))
    }

    /// The same picture without its noise; `scene` is that which was rendered. `filter`: `"voxtrace"`, as `render` does it, or `"oidn"`, Intel's Open Image Denoise,
    /// which the extra `denoise` of this package brings; its last bits may differ from machine to machine.
    ///
    /// Raises `ValueError` where the scene is another, and `VoxtraceError` where Open Image Denoise is not installed or fails; Ctrl-C ends it.
    #[pyo3(signature = (scene, filter="voxtrace"))]
    fn denoise(&self, py: Python<'_>, scene: &Bound<'_, PyScene>, filter: &str) -> PyResult<Self> {
        if ![VOXTRACE, OIDN].contains(&filter) {
            return Err(argument(format!("{filter:?} is neither \"voxtrace\" nor \"oidn\"")));
        }
        let packed = scene.try_borrow()?.packed(py, false)?;
        let file = self.picture.film_file().clone();
        if detach(py, || SceneStamp::of(&packed))?.content_hash != file.scene.content_hash {
            return Err(argument("the picture is of another scene"));
        }
        if filter == VOXTRACE {
            let picture = run_while(py, |wanted| Picture::of_film(file).without_noise_while(&packed, wanted))?;
            return Ok(Self::new(picture.ok_or_else(|| other(py, "stopped"))?, self.device.clone()));
        }
        let oidn = open_oidn(py)?;
        let made = run_while(py, |wanted| {
            let features = Features::of_while(&packed, &file.frame, &file.film, wanted);
            let features = features.ok_or(OidnError::Stopped)?.pixels;
            let color: Vec<Vec3> = file.film.pixels.iter().map(Pixel::mean).collect();
            let albedo: Vec<Vec3> = features.iter().map(|pixel| pixel.albedo).collect();
            let normal: Vec<Vec3> = features.iter().map(|pixel| pixel.normal).collect();
            let (height, width) = self.size();
            let radiance = oidn.denoise_while((width, height), &color, &albedo, &normal, wanted)?;
            Ok(Picture::of_film(file).denoised_as(Denoised { radiance, filter: OIDN }))
        })?;
        let picture = made.map_err(|error: OidnError| other(py, error))?;
        Ok(Self::new(picture, self.device.clone()))
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &detach(py, || self.picture.to_png())?))
    }

    fn __repr__(&self) -> String {
        let (height, width) = self.size();
        format!("<Image: {width} × {height}, {} samples>", self.film().sample_range().1)
    }
}

/// The film of all samples of films.
fn merged(mut films: Vec<&FilmFile>, halfway: bool) -> PyResult<FilmFile> {
    films.sort_by_key(|file| file.film.first_sample);
    let half = films.iter().map(|file| file.frame.samples).sum::<u32>() / 2;
    let mut films = films.into_iter();
    let mut first = films.next().ok_or_else(|| argument("no picture to merge"))?.clone();
    let mut earlier = None;
    for other in films {
        if halfway && first.frame.samples == half {
            earlier = Some(first.film.pixels.clone());
        }
        let alike = other.frame.clone().first_sample(first.frame.first_sample).samples(first.frame.samples);
        if alike != first.frame || other.scene != first.scene {
            return Err(argument("the pictures are of different frames or scenes"));
        }
        first.film.merge(&other.film).map_err(argument)?;
        first.frame.samples += other.frame.samples;
    }
    first.film.earlier = earlier;
    Ok(first)
}

/// Open Image Denoise, of the package `pyoidn` where this Python has it.
fn open_oidn(py: Python<'_>) -> PyResult<Oidn> {
    let spec = py.import("importlib.util")?.call_method1("find_spec", ("pyoidn",))?;
    let mut packages = Vec::new();
    if !spec.is_none() {
        let folders: Vec<PathBuf> = spec.getattr("submodule_search_locations")?.extract()?;
        packages.extend(folders.iter().filter_map(|folder| folder.parent()).map(PathBuf::from));
    }
    Oidn::open_of(&packages).map_err(|error| match error {
        OidnError::NotFound(_) => other(py, format!("{error}; the extra `denoise` of this package brings it")),
        _ => other(py, error),
    })
}

/// A tone map by its name.
fn tone_of(exposure: f32, name: &str) -> PyResult<ToneMap> {
    let names = || Operator::ALL.map(Operator::name).join(", ");
    let operator = Operator::ALL.into_iter().find(|operator| operator.name() == name);
    let operator = operator.ok_or_else(|| argument(format!("{name:?} is none of {}", names())))?;
    if !exposure.is_finite() {
        return Err(argument("exposure is a finite number of stops"));
    }
    Ok(ToneMap { operator, exposure })
}
