//! What a camera's lens does: how places in the picture and directions belong together.

/// How a camera maps what it sees to its picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Lens {
    /// All rays start at the eye, everything is in focus.
    #[default]
    Pinhole,
    /// A thin lens: what lies off the plane in focus is blurred (Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984).
    Thin {
        /// Radius of the aperture, world units, > 0.
        aperture: f32,
        /// Distance of the plane in focus from the eye, along the view, world units, > 0.
        focus: f32,
        /// Blades of the diaphragm, 3 or more; 0 for a round one.
        blades: u32,
        /// Turns the diaphragm counterclockwise, degrees.
        blade_rotation: f32,
    },
    /// Parallel rays: nothing gets smaller with its distance. They start on the plane through the eye.
    Orthographic {
        /// Height of what the picture shows, world units, > 0.
        view_height: f32,
    },
    /// All directions around the eye by longitude (360 degrees from left to right, the view's in the middle) and latitude (180 degrees), the
    /// equirectangular projection.
    Panorama {
        /// Distance between two eyes, world units, ≥ 0. If it is not 0, the upper half of the picture is the left eye's and the lower half the
        /// right eye's ("Rendering Omni-directional Stereo Content", Google 2015).
        eye_distance: f32,
    },
    /// A fisheye whose picture's radius grows with the angle to the view (equidistant).
    Fisheye {
        /// Angle that the height of the picture shows, degrees, in (0, 360].
        fisheye_angle: f32,
    },
}

/// Names of the lenses, as options and files have them.
const NAMES: [&str; 5] = ["pinhole", "thin-lens", "orthographic", "panorama", "fisheye"];

/// The largest number of blades.
const MAX_BLADES: u32 = 64;

impl Lens {
    /// The lens's name: `pinhole`, `thin-lens`, `orthographic`, `panorama` or `fisheye`.
    pub fn name(&self) -> &'static str {
        NAMES[self.number() as usize]
    }

    /// The lens as numbers: which one, and what it is set to, in the order of [`Self::settings`].
    pub fn to_numbers(&self) -> (u32, [f32; 4]) {
        let mut numbers = [0.0; 4];
        for (number, (_, value)) in numbers.iter_mut().zip(self.settings()) {
            *number = value;
        }
        (self.number(), numbers)
    }

    /// The lens of [`Self::to_numbers`], `None` where there is no such lens.
    pub fn from_numbers(lens: u32, numbers: [f32; 4]) -> Option<Self> {
        let [a, b, c, d] = numbers;
        let lens = match lens {
            0 => Self::Pinhole,
            1 => Self::Thin { aperture: a, focus: b, blades: c as u32, blade_rotation: d },
            2 => Self::Orthographic { view_height: a },
            3 => Self::Panorama { eye_distance: a },
            4 => Self::Fisheye { fisheye_angle: a },
            _ => return None,
        };
        lens.check().is_ok().then_some(lens)
    }

    /// The lens's settings by the names that options and files have for them.
    pub fn settings(&self) -> Vec<(&'static str, f32)> {
        match *self {
            Self::Pinhole => vec![],
            Self::Thin { aperture, focus, blades, blade_rotation } => vec![
                ("aperture", aperture),
                ("focus", focus),
                ("blades", blades as f32),
                ("blade_rotation", blade_rotation),
            ],
            Self::Orthographic { view_height } => vec![("view_height", view_height)],
            Self::Panorama { eye_distance } => vec![("eye_distance", eye_distance)],
            Self::Fisheye { fisheye_angle } => vec![("fisheye_angle", fisheye_angle)],
        }
    }

    /// The lens with the name `name` and the settings that `setting` gives.
    ///
    /// # Errors
    /// In words: an unknown name, a setting that is missing or out of range.
    pub fn from_settings(name: &str, setting: impl Fn(&str) -> Option<f32>) -> Result<Self, String> {
        let required = |key: &str| setting(key).ok_or_else(|| format!("a {name} needs `{key}`"));
        let lens = match name {
            "pinhole" => Self::Pinhole,
            "thin-lens" => Self::Thin {
                aperture: required("aperture")?,
                focus: required("focus")?,
                blades: blades_of(setting("blades").unwrap_or(0.0))?,
                blade_rotation: setting("blade_rotation").unwrap_or(0.0),
            },
            "orthographic" => Self::Orthographic { view_height: required("view_height")? },
            "panorama" => Self::Panorama { eye_distance: setting("eye_distance").unwrap_or(0.0) },
            "fisheye" => Self::Fisheye { fisheye_angle: setting("fisheye_angle").unwrap_or(180.0) },
            other => return Err(format!("there is no lens {other:?}: there are {}", NAMES.join(", "))),
        };
        lens.check()?;
        Ok(lens)
    }

    /// The same lens in a world that is `factor` times as large.
    #[must_use]
    pub fn scaled(self, factor: f32) -> Self {
        match self {
            Self::Pinhole | Self::Fisheye { .. } => self,
            Self::Thin { aperture, focus, blades, blade_rotation } => {
                Self::Thin { aperture: aperture * factor, focus: focus * factor, blades, blade_rotation }
            }
            Self::Orthographic { view_height } => Self::Orthographic { view_height: view_height * factor },
            Self::Panorama { eye_distance } => Self::Panorama { eye_distance: eye_distance * factor },
        }
    }

    /// Checks the settings.
    ///
    /// # Errors
    /// Says which one is out of range.
    pub fn check(&self) -> Result<(), &'static str> {
        let is_length = |value: f32| value > 0.0 && value.is_finite();
        match *self {
            Self::Pinhole => Ok(()),
            Self::Thin { aperture, focus, blades, blade_rotation } => {
                if !is_length(aperture) {
                    Err("the aperture is not a length greater than 0")
                } else if !is_length(focus) {
                    Err("the distance in focus is not a length greater than 0")
                } else if blades == 1 || blades == 2 || blades > MAX_BLADES {
                    Err("a diaphragm has 3 to 64 blades, or 0 where it is round")
                } else if !blade_rotation.is_finite() {
                    Err("the rotation of the blades is not finite")
                } else {
                    Ok(())
                }
            }
            Self::Orthographic { view_height } if !is_length(view_height) => {
                Err("the height of the view is not a length greater than 0")
            }
            Self::Panorama { eye_distance } if !(eye_distance >= 0.0 && eye_distance.is_finite()) => {
                Err("the distance of the eyes is not a length")
            }
            Self::Fisheye { fisheye_angle } if !(fisheye_angle > 0.0 && fisheye_angle <= 360.0) => {
                Err("the angle of a fisheye is not in (0, 360] degrees")
            }
            _ => Ok(()),
        }
    }

    fn number(&self) -> u32 {
        match self {
            Self::Pinhole => 0,
            Self::Thin { .. } => 1,
            Self::Orthographic { .. } => 2,
            Self::Panorama { .. } => 3,
            Self::Fisheye { .. } => 4,
        }
    }
}

fn blades_of(number: f32) -> Result<u32, String> {
    let is_whole = number >= 0.0 && number <= MAX_BLADES as f32 && number.fract() == 0.0;
    if is_whole { Ok(number as u32) } else { Err(format!("{number} is no number of blades")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENSES: [Lens; 5] = [
        Lens::Pinhole,
        Lens::Thin { aperture: 0.5, focus: 20.0, blades: 6, blade_rotation: 15.0 },
        Lens::Orthographic { view_height: 12.5 },
        Lens::Panorama { eye_distance: 0.64 },
        Lens::Fisheye { fisheye_angle: 220.0 },
    ];

    #[test]
    fn a_lens_is_the_same_again_after_numbers_and_after_settings() {
        for lens in LENSES {
            let (number, numbers) = lens.to_numbers();
            assert_eq!(Lens::from_numbers(number, numbers), Some(lens));
            assert_ne!(Lens::from_numbers((number + 1) % 5, [1.0, 1.0, 0.0, 0.0]), Some(lens));
            let settings = lens.settings();
            let find = |key: &str| settings.iter().find(|(name, _)| *name == key).map(|&(_, value)| value);
            assert_eq!(Lens::from_settings(lens.name(), find), Ok(lens));
        }
        assert_eq!(Lens::from_numbers(5, [1.0; 4]), None);
    }

    #[test]
    fn settings_out_of_range_are_refused_with_a_reason() {
        let fails = |name: &str, value: f32| Lens::from_settings(name, |_| Some(value)).unwrap_err();
        assert!(fails("thin-lens", 0.0).contains("aperture"));
        assert!(fails("thin-lens", 2.0).contains("blades"));
        assert!(fails("orthographic", -1.0).contains("height"));
        assert!(fails("panorama", f32::NAN).contains("eyes"));
        assert!(fails("fisheye", 361.0).contains("360"));
        assert!(fails("tilt-shift", 1.0).contains("pinhole"));
        assert!(Lens::from_settings("thin-lens", |_| None).unwrap_err().contains("`aperture`"));
    }
}
