//! A material that is changed: `NUMBER=COLOR[,EMISSION]`.

use super::{ChangeError, finite};
use crate::packed::PackedMaterial;
use glam::Vec3;
use std::fmt::{self, Display};
use std::str::FromStr;
use voxtrace_scene::material::linear_color;

/// Another base colour, and if so wished another emission, for a material.
///
/// As text: its number, `=`, the colour as `#rrggbb` (sRGB) or as three linear numbers `r,g,b` from 0 to 1, and after one more comma the
/// emission, as one number that multiplies the colour or as three linear numbers of radiance. Printed, it is read as the same bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialChange {
    /// Index of the material.
    pub number: usize,
    /// Diffuse reflectance, linear.
    pub base_color: Vec3,
    /// Emitted radiance, linear, before the scene's light intensity; `None`: as it is.
    pub emission: Option<Vec3>,
}

impl MaterialChange {
    /// Changes one of the materials of a scene.
    ///
    /// # Errors
    /// [`ChangeError::MissingMaterial`] where there is none of this number.
    pub fn apply(&self, materials: &mut [PackedMaterial]) -> Result<(), ChangeError> {
        let count = materials.len();
        let material = materials.get_mut(self.number);
        let material = material.ok_or(ChangeError::MissingMaterial { number: self.number, count })?;
        material.base_color = self.base_color;
        material.emission = self.emission.unwrap_or(material.emission);
        Ok(())
    }
}

impl FromStr for MaterialChange {
    type Err = ChangeError;

    fn from_str(text: &str) -> Result<Self, ChangeError> {
        let no_material = || ChangeError::NoMaterial(text.into());
        let (number, values) = text.split_once('=').ok_or_else(no_material)?;
        let number = number.trim().parse().map_err(|_| no_material())?;
        let (base_color, rest) = match values.trim().strip_prefix('#') {
            Some(rest) => {
                let (digits, rest) = rest.split_once(',').map_or((rest, None), |(digits, rest)| (digits, Some(rest)));
                let is_hex = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
                let value = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex).ok_or_else(no_material)?;
                let [_, red, green, blue] = value.to_be_bytes();
                (Some(linear_color([red, green, blue])), rest)
            }
            None => (None, Some(values)),
        };
        let numbers: Option<Vec<f32>> = rest.map_or(Some(Vec::new()), |rest| rest.split(',').map(finite).collect());
        let numbers = numbers.ok_or_else(no_material)?;
        let (base_color, emission) = match (base_color, &numbers[..]) {
            (Some(color), rest) => (color, rest),
            (None, &[red, green, blue, ..]) => (Vec3::new(red, green, blue), &numbers[3..]),
            (None, _) => return Err(no_material()),
        };
        let emission = match *emission {
            [] => None,
            [strength] => Some(base_color * strength),
            [red, green, blue] => Some(Vec3::new(red, green, blue)),
            _ => return Err(no_material()),
        };
        let is_color = base_color.min_element() >= 0.0 && base_color.max_element() <= 1.0;
        let is_emission = emission.is_none_or(|emission| emission.min_element() >= 0.0 && emission.is_finite());
        match is_color && is_emission {
            true => Ok(Self { number, base_color, emission }),
            false => Err(ChangeError::OutOfRange(text.into())),
        }
    }
}

impl Display for MaterialChange {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let bytes = self.base_color.to_array().map(voxtrace_scene::material::srgb_from_linear);
        let [red, green, blue] = bytes;
        match linear_color(bytes) == self.base_color {
            true => write!(f, "{}=#{red:02x}{green:02x}{blue:02x}", self.number)?,
            false => write!(f, "{}={},{},{}", self.number, self.base_color.x, self.base_color.y, self.base_color.z)?,
        }
        match self.emission {
            Some(emission) => write!(f, ",{},{},{}", emission.x, emission.y, emission.z),
            None => Ok(()),
        }
    }
}
