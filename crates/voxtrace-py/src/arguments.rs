//! Arguments as people write them: three numbers in anything that has three, colours as pickers show them or linear, matrices.

use crate::errors::argument;
use numpy::ndarray::{ArrayView, Dimension};
use numpy::{Element, PyArray, PyArrayMethods, PyReadonlyArray, dtype};
use pyo3::exceptions::{PyIndexError, PyOverflowError};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::fmt::Display;
use voxtrace::Transform;
use voxtrace::glam::{DVec3, IVec3, Mat3, Vec3};
use voxtrace::material::linear_color;

/// Three finite numbers, of a tuple, a list or an array.
#[derive(Clone, Copy)]
pub struct Three(pub DVec3);

impl Three {
    /// In single precision.
    pub fn single(self) -> Vec3 {
        self.0.as_vec3()
    }
}

impl<'py> FromPyObject<'_, 'py> for Three {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let numbers = numbers::<3>(&object)?;
        Ok(Self(DVec3::from_array(numbers)))
    }
}

/// The voxel that numbers name, the nearest there can be where they are larger; `None` where they are not whole.
pub fn whole(numbers: DVec3) -> Option<IVec3> {
    let rounded = numbers.round();
    (rounded - numbers).abs().cmple(DVec3::splat(1e-9)).all().then(|| rounded.as_ivec3())
}

/// The number of something that there may not be, from 0 on.
#[derive(Clone, Copy)]
pub struct Index(pub usize);

impl<'py> FromPyObject<'_, 'py> for Index {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        object.extract().map(Self).map_err(|error: PyErr| match error.is_instance_of::<PyOverflowError>(object.py()) {
            true if object.lt(0).unwrap_or(false) => {
                PyIndexError::new_err(format!("{} is the number of nothing: they begin at 0", *object))
            }
            true => PyIndexError::new_err(format!("{} is the number of nothing: there cannot be so many", *object)),
            false => error,
        })
    }
}

/// A whole number that an argument may have no room for: [`Self::of`] says then which argument that is, and what it takes.
#[derive(Clone, Debug)]
pub enum Number<T> {
    /// It fits.
    Fits(T),
    /// It does not: the number, as people read it.
    OutOfRange(String),
}

/// Types of whole numbers.
pub trait Whole: Copy + PartialOrd + Display {
    /// The largest number.
    const MOST: Self;
}

impl Whole for u16 {
    const MOST: Self = Self::MAX;
}

impl Whole for u32 {
    const MOST: Self = Self::MAX;
}

impl Whole for u64 {
    const MOST: Self = Self::MAX;
}

impl Whole for usize {
    const MOST: Self = Self::MAX;
}

impl Whole for i64 {
    const MOST: Self = Self::MAX;
}

impl<'a, 'py, T: FromPyObject<'a, 'py>> FromPyObject<'a, 'py> for Number<T> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        object.extract::<T>().map(Self::Fits).or_else(|error| {
            let error: PyErr = error.into();
            match error.is_instance_of::<PyOverflowError>(object.py()) {
                true => Ok(Self::OutOfRange(object.str()?.to_string())),
                false => Err(error),
            }
        })
    }
}

impl<T: Whole> Number<T> {
    /// The number, which is at least `least`, of the argument of this name.
    ///
    /// # Errors
    /// `ValueError` for another one.
    pub fn of(self, name: &str, least: T) -> PyResult<T> {
        let given = match self {
            Self::Fits(number) if number >= least => return Ok(number),
            Self::Fits(number) => number.to_string(),
            Self::OutOfRange(number) => number,
        };
        Err(argument(format!("{name} is a whole number from {least} to {}, not {given}", T::MOST)))
    }
}

/// As [`Number::of`], where there may be none.
pub fn number_of<T: Whole>(number: Option<Number<T>>, name: &str, least: T) -> PyResult<Option<T>> {
    number.map(|number| number.of(name, least)).transpose()
}

/// Width and height of a picture, `size` of its arguments.
#[derive(Clone, Copy)]
pub struct Size(pub u32, pub u32);

impl<'py> FromPyObject<'_, 'py> for Size {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let (width, height): (Number<u32>, Number<u32>) = object.extract()?;
        Ok(Self(width.of("the width of size", 0)?, height.of("the height of size", 0)?))
    }
}

/// Pixels of a picture, `region` of its arguments.
#[derive(Clone, Copy)]
pub struct Pixels(pub [u32; 4]);

impl<'py> FromPyObject<'_, 'py> for Pixels {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let [x0, y0, x1, y1]: [Number<u32>; 4] = object.extract()?;
        let number = |number: Number<u32>, name: &str| number.of(&format!("{name} of region"), 0);
        Ok(Self([number(x0, "x0")?, number(y0, "y0")?, number(x1, "x1")?, number(y1, "y1")?]))
    }
}

/// So many finite numbers.
pub fn numbers<const N: usize>(object: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let wrong = || {
        argument(format!(
            "{N} numbers are wanted, not {}",
            object.repr().map_or(String::new(), |text| text.to_string())
        ))
    };
    let mut numbers = [0.0; N];
    let mut count = 0;
    for item in object.try_iter().map_err(|_| wrong())? {
        let number: f64 = item?.extract().map_err(|_| wrong())?;
        if !number.is_finite() || count == N {
            return Err(wrong());
        }
        numbers[count] = number;
        count += 1;
    }
    if count == N { Ok(numbers) } else { Err(wrong()) }
}

/// Numbers in anything that numpy takes, as an array of this type and of so many axes.
pub struct Numbers<'py, T: Element, D: Dimension>(PyReadonlyArray<'py, T, D>);

impl<T: Element, D: Dimension> Numbers<'_, T, D> {
    pub fn as_array(&self) -> ArrayView<'_, T, D> {
        self.0.as_array()
    }
}

impl<'py, T: Element + 'py, D: Dimension + 'py> FromPyObject<'_, 'py> for Numbers<'py, T, D> {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let given = object.py().import("numpy")?.call_method1("asanyarray", (&*object,))?;
        if given.getattr("dtype")?.getattr("kind")?.extract::<char>()? == 'c' {
            return Err(argument(format!("real numbers are wanted, not {}", given.getattr("dtype")?)));
        }
        let array = readable(&given, dtype::<T>(object.py()).as_any())?;
        let Ok(found) = array.cast::<PyArray<T, D>>() else {
            let axes = D::NDIM.map_or(String::new(), |axes| format!("{axes} axes"));
            return Err(argument(format!("an array of {axes} is wanted, not of shape {}", array.getattr("shape")?)));
        };
        Ok(Self(found.readonly()))
    }
}

/// An array of a type of numpy, that array itself where it is one and lies as Rust reads it. Numbers that are not aligned, as those are that a packed record has
/// behind a byte, are copied.
pub fn readable<'py>(object: &Bound<'py, PyAny>, kind: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    object.py().import("numpy")?.call_method1("require", (object, kind, "A"))
}

/// A colour: `"#rrggbb"` as pickers show it (sRGB), or three linear numbers.
#[derive(Clone, Copy)]
pub struct Color(pub Vec3);

impl<'py> FromPyObject<'_, 'py> for Color {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let Ok(text) = object.cast::<PyString>() else {
            let color = object.extract::<Three>()?.single();
            return match color.is_finite() {
                true => Ok(Self(color)),
                false => Err(argument(format!("a colour of {} is beyond single precision", *object))),
            };
        };
        let text = text.to_str()?.to_owned();
        let is_hexadecimal = |digits: &&str| digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let digits = text.strip_prefix('#').filter(is_hexadecimal);
        let value = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let value = value.ok_or_else(|| argument(format!("{text:?} is no colour like \"#d8c7a0\"")))?;
        Ok(Self(linear_color([(value >> 16) as u8, (value >> 8) as u8, value as u8])))
    }
}

impl Color {
    /// As light.
    pub fn radiance(self) -> PyResult<Vec3> {
        match self.0.min_element() >= 0.0 {
            true => Ok(self.0),
            false => Err(argument(format!("channels of light are ≥ 0, not {}", self.0))),
        }
    }

    /// As the share of the light that comes back.
    pub fn reflectance(self) -> PyResult<Vec3> {
        if self.0.min_element() >= 0.0 && self.0.max_element() <= 1.0 {
            return Ok(self.0);
        }
        let text = format!(
            "channels of a colour are in [0, 1], not {}: bytes of sRGB are \"#d8c7a0\", or a palette of type uint8",
            self.0
        );
        Err(argument(text))
    }
}

/// A placement: 4 × 4 or 3 × 4 numbers, row by row, that turn, mirror, scale evenly and move.
#[derive(Clone, Copy)]
pub struct Matrix(pub Transform);

impl<'py> FromPyObject<'_, 'py> for Matrix {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let rows: Vec<[f64; 4]> = object.try_iter()?.map(|row| numbers::<4>(&row?)).collect::<PyResult<_>>()?;
        transform_of(&rows).map(Self)
    }
}

/// The transform of three or four rows.
pub fn transform_of(rows: &[[f64; 4]]) -> PyResult<Transform> {
    let is_affine = rows.get(3).is_none_or(|row| *row == [0.0, 0.0, 0.0, 1.0]);
    if !(3..=4).contains(&rows.len()) || !is_affine {
        return Err(argument("a transform has 4 × 4 numbers, the last row 0, 0, 0, 1, or 3 × 4"));
    }
    let column = |at: usize| Vec3::new(rows[0][at] as f32, rows[1][at] as f32, rows[2][at] as f32);
    let transform = Transform { linear: Mat3::from_cols(column(0), column(1), column(2)), translation: column(3) };
    if !transform.is_similarity() {
        return Err(argument("a transform turns, mirrors, scales evenly and moves; this one shears, or is not finite"));
    }
    Ok(transform)
}

/// The rows of a transform, 4 × 4.
pub fn rows_of(transform: &Transform) -> [[f64; 4]; 4] {
    let (linear, translation) = (transform.linear, transform.translation);
    let row = |at: usize| [linear.x_axis[at], linear.y_axis[at], linear.z_axis[at], translation[at]].map(f64::from);
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}
