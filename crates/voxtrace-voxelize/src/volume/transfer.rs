//! Transfer functions: from the value of a sample to a material or to nothing; presets for common kinds of data.

use super::ValueStatistics;
use glam::Vec3;
use std::collections::BTreeMap;
use voxtrace_scene::material::{Material, linear_color};

/// In place of a material: no voxel.
pub(super) const EMPTY: u16 = u16::MAX;
/// Materials along a ramp: few enough for a .vox file.
const LEVELS: usize = 240;

/// A transfer function: which values are shown, and in which colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    /// Name for people.
    pub name: String,
    /// The map from value to colour.
    pub ramp: Ramp,
    /// How much of what lies behind a surface it hides, in [0, 1]; multiplies the opacity of each label.
    pub opacity: f32,
}

/// The look of a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LabelColor {
    /// Linear Rec. 709.
    pub color: Vec3,
    /// In [0, 1]: 0 hides the label, 1 hides what is behind its surface.
    pub opacity: f32,
}

impl From<Vec3> for LabelColor {
    /// Opaque.
    fn from(color: Vec3) -> Self {
        Self { color, opacity: 1.0 }
    }
}

impl LabelColor {
    /// What is seen where `self` lies over `below`: Porter and Duff's operator (1984), colours not multiplied by opacity.
    pub(super) fn over(self, below: Self) -> Self {
        let share = below.opacity * (1.0 - self.opacity);
        let opacity = self.opacity + share;
        if opacity <= 0.0 {
            return self;
        }
        Self { color: (self.color * self.opacity + below.color * share) / opacity, opacity }
    }

    /// A surface that lets through what its opacity does not stop.
    pub(super) fn material(self) -> Material {
        let matte = Material::diffuse(self.color);
        if self.opacity >= 1.0 { matte } else { Material { transmission: 1.0 - self.opacity, ior: 1.0, ..matte } }
    }
}

/// A map from value to colour, linear Rec. 709.
#[derive(Clone, Debug, PartialEq)]
pub enum Ramp {
    /// Interpolates between stops of ascending value; shows values from `low` to `high`.
    Absolute {
        /// The least value shown.
        low: f32,
        /// The greatest value shown.
        high: f32,
        /// Values with their colours.
        stops: Vec<(f32, Vec3)>,
    },
    /// As [`Ramp::Absolute`] for data without a calibrated scale: stops lie from 0, the volume's threshold, to 1, its 99.9th
    /// percentile.
    Relative {
        /// Positions from 0 to 1 with their colours.
        stops: Vec<(f32, Vec3)>,
    },
    /// A label map: each whole value has a look; others are not shown.
    Labels(BTreeMap<i32, LabelColor>),
    /// As [`Ramp::Labels`], each value of the volume but 0 with a colour of its own.
    EveryLabel,
}

/// A named transfer function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// Bones of a CT, in Hounsfield units.
    CtBone,
    /// The skin in a CT, in Hounsfield units.
    CtSkin,
    /// Data without a calibrated scale: MRI, microscopy, simulations.
    Mri,
    /// Label maps.
    Labels,
    /// Level sets of OpenVDB, read as depth below the surface.
    Surface,
    /// Fog volumes: densities of smoke and clouds.
    Fog,
    /// A second scan over another, as a PET over a CT: from dark red over orange and yellow to white.
    Hot,
}

impl Preset {
    /// All presets.
    pub const ALL: [Self; 7] =
        [Self::CtBone, Self::CtSkin, Self::Mri, Self::Labels, Self::Surface, Self::Fog, Self::Hot];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::CtBone => "ct-bone",
            Self::CtSkin => "ct-skin",
            Self::Mri => "mri",
            Self::Labels => "labels",
            Self::Surface => "surface",
            Self::Fog => "fog",
            Self::Hot => "hot",
        }
    }

    /// The transfer function.
    pub fn transfer(self) -> Transfer {
        let stops = |stops: &[(f32, [u8; 3])]| stops.iter().map(|&(at, color)| (at, linear_color(color))).collect();
        let ramp = match self {
            Self::CtBone => Ramp::Absolute {
                low: 250.0,
                high: f32::MAX,
                stops: stops(&[
                    (250.0, [201, 166, 124]),
                    (500.0, [226, 206, 168]),
                    (1200.0, [243, 234, 210]),
                    (2500.0, [255, 253, 248]),
                ]),
            },
            Self::CtSkin => Ramp::Absolute {
                low: -300.0,
                high: f32::MAX,
                stops: stops(&[
                    (-300.0, [214, 158, 128]),
                    (0.0, [228, 178, 148]),
                    (150.0, [201, 110, 92]),
                    (300.0, [239, 226, 196]),
                ]),
            },
            Self::Mri => Ramp::Relative {
                stops: stops(&[(0.0, [176, 146, 130]), (0.4, [216, 190, 170]), (1.0, [250, 240, 226])]),
            },
            Self::Labels => Ramp::EveryLabel,
            Self::Surface => Ramp::Absolute { low: 0.0, high: f32::MAX, stops: stops(&[(0.0, [204; 3])]) },
            Self::Fog => Ramp::Relative { stops: stops(&[(0.0, [232, 235, 240]), (1.0, [188, 192, 200])]) },
            Self::Hot => Ramp::Relative {
                stops: stops(&[
                    (0.0, [110, 8, 0]),
                    (0.35, [226, 52, 0]),
                    (0.7, [255, 196, 20]),
                    (1.0, [255, 255, 235]),
                ]),
            },
        };
        Transfer { name: self.name().into(), ramp, opacity: 1.0 }
    }
}

impl Transfer {
    /// A transfer function of opaque colours.
    pub fn new(name: impl Into<String>, ramp: Ramp) -> Self {
        Self { name: name.into(), ramp, opacity: 1.0 }
    }

    /// A colour of its own for each label, the same in every volume.
    pub fn of_labels(labels: &[i32]) -> Self {
        let colors = labels.iter().map(|&label| (label, label_color(label).into())).collect();
        Self::new(Preset::Labels.name(), Ramp::Labels(colors))
    }

    /// Whether values are labels, which must not be interpolated.
    pub fn is_labels(&self) -> bool {
        matches!(self.ramp, Ramp::Labels(_) | Ramp::EveryLabel)
    }

    /// Whether it goes by the scale of the values, [`ValueStatistics::threshold`] and [`ValueStatistics::bright`].
    pub fn is_relative(&self) -> bool {
        matches!(self.ramp, Ramp::Relative { .. })
    }

    /// Whether it has to know what values there are: their scale, or which labels.
    pub fn goes_by_values(&self) -> bool {
        self.is_relative() || matches!(self.ramp, Ramp::EveryLabel)
    }

    /// Which values are shown, for people.
    pub fn shown(&self) -> String {
        match &self.ramp {
            Ramp::Absolute { low, high, .. } if *high == f32::MAX => format!("what is {} or more", five_digits(*low)),
            Ramp::Absolute { low, high, .. } => format!("what is from {} to {}", five_digits(*low), five_digits(*high)),
            Ramp::Relative { .. } => "what is above the volume's threshold".into(),
            Ramp::Labels(colors) => format!("{} labels", colors.len()),
            Ramp::EveryLabel => "every whole number but 0".into(),
        }
    }

    /// Resolves what depends on the volume: the scale, the labels, and an overriding threshold.
    pub fn resolve(&mut self, values: &ValueStatistics, threshold: Option<f32>) {
        match &mut self.ramp {
            Ramp::Absolute { low, .. } => *low = threshold.unwrap_or(*low),
            Ramp::Relative { stops } => {
                let low = threshold.unwrap_or(values.threshold);
                let range = (values.bright - low).max(f32::MIN_POSITIVE);
                let stops = stops.iter().map(|&(at, color)| (low + at * range, color)).collect();
                self.ramp = Ramp::Absolute { low, high: f32::MAX, stops };
            }
            Ramp::EveryLabel => {
                let labels = values.labels.iter().flatten().copied().filter(|&label| label != 0);
                let labels = labels.filter(|&label| threshold.is_none_or(|threshold| label as f32 >= threshold));
                self.ramp = Ramp::Labels(labels.map(|label| (label, label_color(label).into())).collect());
            }
            Ramp::Labels(colors) => {
                colors.retain(|&label, _| threshold.is_none_or(|threshold| label as f32 >= threshold))
            }
        }
    }

    pub(super) fn lookup(&self) -> Lookup {
        let mut lookup = match &self.ramp {
            Ramp::Absolute { low, high, stops } => Lookup::along(*low, *high, stops),
            Ramp::Relative { stops } => Lookup::along(0.0, f32::MAX, stops),
            Ramp::Labels(colors) => {
                let seen = colors.iter().filter(|(_, look)| look.opacity > 0.0).take(usize::from(EMPTY));
                let (labels, colors) = seen.map(|(&label, &look)| (label, look)).unzip();
                Lookup { colors, kind: Kind::Labels(labels) }
            }
            Ramp::EveryLabel => Lookup { colors: Vec::new(), kind: Kind::Labels(Vec::new()) },
        };
        lookup.colors.iter_mut().for_each(|look| look.opacity = (look.opacity * self.opacity).clamp(0.0, 1.0));
        lookup
    }
}

/// The colour of a label: hues a golden angle apart, with three saturations in turn.
fn label_color(label: i32) -> Vec3 {
    let hue = (f64::from(label) * 0.618_033_988_749_895).rem_euclid(1.0) as f32 * 6.0;
    let (strength, value) = [(0.55, 0.85), (0.75, 0.6), (0.35, 0.9)][label.rem_euclid(3) as usize];
    let channel = |shift: f32| {
        let at = (hue + shift).rem_euclid(6.0);
        let pure = (at.min(4.0 - at)).clamp(0.0, 1.0);
        ((1.0 - strength * pure) * value * 255.0) as u8
    };
    linear_color([channel(5.0), channel(3.0), channel(1.0)])
}

/// A transfer function as a lookup table.
pub(super) struct Lookup {
    colors: Vec<LabelColor>,
    kind: Kind,
}

enum Kind {
    /// Shows values from `low` to `high`; colour i of the table stands for the value `first` + i / `factor`.
    Ramp {
        low: f32,
        high: f32,
        first: f32,
        factor: f32,
    },
    Labels(Vec<i32>),
}

impl Lookup {
    fn along(low: f32, high: f32, stops: &[(f32, Vec3)]) -> Self {
        let (first, last) = (stops.first().map_or(low, |stop| stop.0), stops.last().map_or(low, |stop| stop.0));
        let range = (last - first).max(0.0);
        let levels = if range > 0.0 { LEVELS } else { 1 };
        let color = |level: usize| color_at(stops, first + range * (level as f32 + 0.5) / levels as f32).into();
        let factor = if range > 0.0 { levels as f32 / range } else { 0.0 };
        Self { colors: (0..levels).map(color).collect(), kind: Kind::Ramp { low, high, first, factor } }
    }

    /// For each value whether it is shown.
    pub fn see(&self, values: &[f32], seen: &mut [bool]) {
        match &self.kind {
            // False for what is not a number.
            Kind::Ramp { low, high, .. } => {
                seen.iter_mut().zip(values).for_each(|(seen, value)| *seen = (value >= low) & (value <= high))
            }
            Kind::Labels(_) => {
                seen.iter_mut().zip(values).for_each(|(seen, &value)| *seen = self.material(value) != EMPTY)
            }
        }
    }

    /// The least and the greatest value shown; `None` of labels.
    pub fn interval(&self) -> Option<[f32; 2]> {
        match self.kind {
            Kind::Ramp { low, high, .. } => Some([low, high]),
            Kind::Labels(_) => None,
        }
    }

    /// The material of a value, or [`EMPTY`].
    pub fn material(&self, value: f32) -> u16 {
        match &self.kind {
            Kind::Ramp { low, high, first, factor } => {
                // False for what is not a number.
                let is_seen = value >= *low && value <= *high;
                if is_seen { (((value - first) * factor) as usize).min(self.colors.len() - 1) as u16 } else { EMPTY }
            }
            Kind::Labels(labels) if value.fract() == 0.0 => {
                labels.binary_search(&(value as i32)).map_or(EMPTY, |at| at as u16)
            }
            Kind::Labels(_) => EMPTY,
        }
    }

    /// The look of each material.
    pub fn colors(&self) -> &[LabelColor] {
        &self.colors
    }

    /// Whether what is behind its voxels is hidden.
    pub fn is_opaque(&self) -> bool {
        self.colors.iter().all(|look| look.opacity >= 1.0)
    }
}

fn color_at(stops: &[(f32, Vec3)], value: f32) -> Vec3 {
    let after = stops.partition_point(|stop| stop.0 <= value);
    match (after.checked_sub(1).and_then(|before| stops.get(before)), stops.get(after)) {
        (Some(a), Some(b)) => a.1.lerp(b.1, ((value - a.0) / (b.0 - a.0).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0)),
        (Some(only), None) | (None, Some(only)) => only.1,
        (None, None) => Vec3::splat(0.8),
    }
}

/// A value of five digits that matter, for people: thresholds that follow from the values have more.
fn five_digits(value: f32) -> f32 {
    let size = f64::from(value.abs()).log10().floor();
    if !size.is_finite() {
        return value;
    }
    let scale = 10f64.powi(4 - size as i32);
    ((f64::from(value) * scale).round() / scale) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_is_said_with_few_digits() {
        let of =
            |low, high| Transfer { ramp: Ramp::Absolute { low, high, stops: Vec::new() }, ..Preset::Fog.transfer() };
        assert_eq!(of(649.208_86, f32::MAX).shown(), "what is 649.21 or more");
        assert_eq!(of(-0.001_234_567, 250.0).shown(), "what is from -0.0012346 to 250");
        assert_eq!(of(0.0, 3e9).shown(), "what is from 0 to 3000000000");
    }

    #[test]
    fn a_ramp_shows_what_is_between_its_ends_and_nothing_that_is_no_number() {
        let lookup = Preset::CtBone.transfer().lookup();
        assert_eq!((lookup.material(249.9), lookup.material(f32::NAN)), (EMPTY, EMPTY));
        assert_eq!(lookup.material(250.0), 0);
        assert_eq!(usize::from(lookup.material(1e30)), lookup.colors.len() - 1);
        let colors: Vec<f32> = lookup.colors.iter().map(|look| look.color.y).collect();
        assert!(colors.is_sorted() && colors.len() <= 255);
    }

    #[test]
    fn neighbouring_labels_have_colours_that_differ() {
        for label in 1..200 {
            assert!(label_color(label).distance(label_color(label + 1)) > 0.1, "{label}");
        }
    }

    #[test]
    fn labels_without_a_colour_are_not_seen() {
        let hidden = LabelColor { color: Vec3::Z, opacity: 0.0 };
        let ramp = Ramp::Labels([(3, Vec3::X.into()), (5, hidden), (9, Vec3::Y.into())].into());
        let lookup = Transfer::new("own", ramp).lookup();
        let found = [0.0, 3.0, 3.5, 5.0, 9.0, 10.0].map(|value| lookup.material(value));
        assert_eq!(found, [EMPTY, 0, EMPTY, EMPTY, 1, EMPTY]);
    }

    #[test]
    fn a_look_over_another_hides_as_much_as_its_opacity() {
        let half = LabelColor { color: Vec3::X, opacity: 0.5 };
        let both = half.over(Vec3::Y.into());
        assert_eq!((both.color, both.opacity), (Vec3::new(0.5, 0.5, 0.0), 1.0));
        let both = half.over(LabelColor { color: Vec3::Y, opacity: 0.5 });
        assert!((both.opacity - 0.75).abs() < 1e-6 && (both.color.x - 2.0 / 3.0).abs() < 1e-6, "{both:?}");
        assert_eq!(LabelColor::from(Vec3::Z).over(half), Vec3::Z.into());
        let material = half.material();
        assert_eq!((material.transmission, material.ior), (0.5, 1.0));
        assert_eq!(LabelColor::from(Vec3::Z).material(), Material::diffuse(Vec3::Z));
    }
}
