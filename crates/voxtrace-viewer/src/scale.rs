//! Lengths, areas and volumes of a scene in its unit, and coordinates of its source, as people read them.

use voxtrace::PackedScene;
use voxtrace::georeference::Georeference;
use voxtrace::glam::{DAffine3, DVec3};
use voxtrace::scene::Unit;

/// How large the voxels of a scene are, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// Edge of a voxel of the world, units.
    pub voxel_size: f64,
    /// Unit of that.
    pub unit: Unit,
    /// The coordinates that the scene was made from.
    pub georeference: Option<Georeference>,
}

/// What a number counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Units.
    Length,
    /// Square units.
    Area,
    /// Cubic units.
    Volume,
    /// Degrees.
    Angle,
    /// Things.
    Count,
}

impl Scale {
    /// Of a scene.
    pub fn of(scene: &PackedScene) -> Self {
        Self { voxel_size: scene.voxel_size, unit: scene.unit, georeference: scene.georeference.clone() }
    }

    /// From the world of another scene of the same source, voxels, to that of this one: by its coordinates, else by the size of voxels.
    pub(crate) fn world_from_other(&self, other: &Self) -> DAffine3 {
        match (&self.georeference, &other.georeference) {
            (Some(own), Some(other)) => own.coordinates_from_world.inverse() * other.coordinates_from_world,
            _ => DAffine3::from_scale(DVec3::splat(other.voxel_size / self.voxel_size)),
        }
    }

    /// How many times as long a way is in a world that [`Self::world_from_other`] leads to.
    pub(crate) fn times_as_long(new_from_old: &DAffine3) -> f32 {
        new_from_old.matrix3.determinant().abs().cbrt() as f32
    }

    /// The short name of the unit, empty where a voxel is a voxel.
    pub fn symbol(&self) -> &'static str {
        match self.unit {
            Unit::Voxel => "",
            Unit::Metre => "m",
            Unit::Millimetre => "mm",
        }
    }

    /// A number of voxels, square voxels or cubic voxels in units; angles and counts stay.
    pub fn in_units(&self, quantity: Quantity, value: f64) -> f64 {
        let edge = if self.unit == Unit::Voxel { 1.0 } else { self.voxel_size };
        match quantity {
            Quantity::Length => value * edge,
            Quantity::Area => value * edge * edge,
            Quantity::Volume => value * edge * edge * edge,
            Quantity::Angle | Quantity::Count => value,
        }
    }

    /// A number in voxels, as people read it: with as many decimals as a hundredth of a voxel needs.
    pub fn text(&self, quantity: Quantity, value: f64) -> String {
        let number = self.in_units(quantity, value);
        let edge = if self.unit == Unit::Voxel { 1.0 } else { self.voxel_size };
        let decimals = |power: f64| (-(edge.powf(power) / 100.0).log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize;
        let (decimals, sign) = match quantity {
            Quantity::Length => (decimals(1.0), ""),
            Quantity::Area => (decimals(2.0), "²"),
            Quantity::Volume => (decimals(3.0), "³"),
            Quantity::Angle => return format!("{}°", grouped(number, 2)),
            Quantity::Count => return grouped(number, 0),
        };
        let symbol = if self.unit == Unit::Voxel { "vx" } else { self.symbol() };
        // Six digits of areas and volumes say enough.
        let digits = if number == 0.0 { 1.0 } else { number.abs().log10().floor() + 1.0 };
        let enough = if quantity == Quantity::Length { 9 } else { (6.0 - digits).clamp(0.0, 9.0) as usize };
        let decimals = decimals.min(enough);
        let text = format!("{} {symbol}{sign}", grouped(number, decimals));
        match (self.unit, quantity) {
            (Unit::Millimetre, Quantity::Volume) => format!("{text} ({} ml)", grouped(number / 1000.0, 3)),
            _ => text,
        }
    }

    /// A point of the world, voxels, in the unit of the scene, `None` where a voxel is a voxel.
    pub fn place(&self, point: DVec3) -> Option<DVec3> {
        (self.unit != Unit::Voxel).then(|| point * self.voxel_size)
    }

    /// A point of the world in the coordinates of the source.
    pub fn coordinates(&self, point: DVec3) -> Option<DVec3> {
        Some(self.georeference.as_ref()?.coordinates_from_world.transform_point3(point))
    }

    /// The unit of those coordinates with a space before it: that of the scene, unless they are degrees or feet.
    pub fn coordinates_symbol(&self) -> String {
        let step = self.georeference.as_ref().map(|of| of.coordinates_from_world.matrix3.x_axis.length());
        // Voxels of a scan may be a little longer along an axis; feet and degrees are quite different.
        let is_in_unit = step.is_some_and(|step| (step / self.voxel_size - 1.0).abs() < 0.05);
        if is_in_unit && self.unit != Unit::Voxel { format!(" {}", self.symbol()) } else { String::new() }
    }
}

/// A number with commas between groups of three digits, and without zeros at its end.
pub fn grouped(number: f64, decimals: usize) -> String {
    let text = format!("{:.*}", decimals, number);
    let (sign, text) = text.strip_prefix('-').map_or(("", text.as_str()), |rest| ("−", rest));
    let (whole, rest) = text.split_once('.').unwrap_or((text, ""));
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    let rest = rest.trim_end_matches('0');
    let is_zero = whole.chars().chain(rest.chars()).all(|digit| digit == '0');
    let sign = if is_zero { "" } else { sign };
    if rest.is_empty() { format!("{sign}{grouped}") } else { format!("{sign}{grouped}.{rest}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_in_the_unit_of_the_scene_and_as_exact_as_its_voxels() {
        let metres = Scale { voxel_size: 0.05, unit: Unit::Metre, georeference: None };
        assert_eq!(metres.text(Quantity::Length, 24.69), "1.2345 m");
        assert_eq!(metres.text(Quantity::Area, 400.0), "1 m²");
        assert_eq!(metres.text(Quantity::Volume, 16_000.0), "2 m³");
        assert_eq!(metres.text(Quantity::Area, 17_475.145), "43.6879 m²");
        assert_eq!(metres.text(Quantity::Length, 1e6), "50,000 m");
        let scan = Scale { voxel_size: 2.0, unit: Unit::Millimetre, georeference: None };
        assert_eq!(scan.text(Quantity::Volume, 1000.0), "8,000 mm³ (8 ml)");
        let voxels = Scale { voxel_size: 7.0, unit: Unit::Voxel, georeference: None };
        assert_eq!(voxels.text(Quantity::Length, -1.504), "−1.5 vx", "voxels are not 7 of anything");
        assert_eq!(voxels.text(Quantity::Angle, 90.0), "90°");
        assert_eq!((grouped(-0.0001, 2), grouped(1_234_567.25, 2)), ("0".into(), "1,234,567.25".into()));
    }
}
