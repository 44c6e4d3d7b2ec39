//! Units of length of what a scene is made of. A scene itself has metres, millimetres or none ([`Unit`]).

use crate::scene::Unit;

/// A unit of length: how many metres it is, if that is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LengthUnit {
    metres: Option<f64>,
}

impl LengthUnit {
    /// Nobody says.
    pub const UNKNOWN: Self = Self { metres: None };
    /// Metres.
    pub const METRE: Self = Self { metres: Some(1.0) };
    /// Millimetres.
    pub const MILLIMETRE: Self = Self { metres: Some(0.001) };
    /// Centimetres.
    pub const CENTIMETRE: Self = Self { metres: Some(0.01) };
    /// Kilometres.
    pub const KILOMETRE: Self = Self { metres: Some(1000.0) };
    /// International feet.
    pub const FOOT: Self = Self { metres: Some(0.3048) };
    /// Feet of the surveys of the United States.
    pub const US_SURVEY_FOOT: Self = Self { metres: Some(1200.0 / 3937.0) };

    /// Units with the symbols that people write.
    pub const SYMBOLS: [(&'static str, Self); 6] = [
        ("m", Self::METRE),
        ("mm", Self::MILLIMETRE),
        ("cm", Self::CENTIMETRE),
        ("km", Self::KILOMETRE),
        ("ft", Self::FOOT),
        ("us-ft", Self::US_SURVEY_FOOT),
    ];

    /// A unit of so many metres; unknown where that is no length between a micrometre and a thousand kilometres.
    pub fn of_metres(metres: f64) -> Self {
        // What is written with ten digits is the unit that has a name.
        let named =
            Self::SYMBOLS.iter().find(|(_, unit)| unit.metres.is_some_and(|own| (metres / own - 1.0).abs() < 1e-9));
        let own = Self { metres: Some(metres).filter(|metres| (1e-6..=1e6).contains(metres)) };
        named.map_or(own, |&(_, unit)| unit)
    }

    /// The unit that a symbol of [`Self::SYMBOLS`] names.
    pub fn of_symbol(symbol: &str) -> Option<Self> {
        Self::SYMBOLS.iter().find(|(own, _)| *own == symbol).map(|&(_, unit)| unit)
    }

    /// How many metres it is, if that is known.
    pub fn metres(self) -> Option<f64> {
        self.metres
    }

    /// The unit that a scene has whose source is measured in this one.
    pub fn of_scene(self) -> Unit {
        match self.metres {
            None => Unit::Voxel,
            Some(_) if self == Self::MILLIMETRE => Unit::Millimetre,
            Some(_) => Unit::Metre,
        }
    }

    /// How many of the units of [`Self::of_scene`] it is; 1 where it is unknown.
    pub fn in_scene(self) -> f64 {
        if self == Self::MILLIMETRE { 1.0 } else { self.metres.unwrap_or(1.0) }
    }

    /// Its symbol after a space, for numbers; empty where it is unknown.
    pub fn suffix(self) -> String {
        let Some(metres) = self.metres else { return String::new() };
        let symbol = Self::SYMBOLS.iter().find(|(_, unit)| *unit == self);
        symbol.map_or_else(|| format!(" x {metres} m"), |(symbol, _)| format!(" {symbol}"))
    }
}

impl From<Unit> for LengthUnit {
    fn from(unit: Unit) -> Self {
        match unit {
            Unit::Voxel => Self::UNKNOWN,
            Unit::Metre => Self::METRE,
            Unit::Millimetre => Self::MILLIMETRE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_metres_symbols_and_a_unit_of_the_scene() {
        for (symbol, unit) in LengthUnit::SYMBOLS {
            assert_eq!(LengthUnit::of_symbol(symbol), Some(unit));
            assert_eq!(unit.suffix(), format!(" {symbol}"));
            let (factor, metres) = (unit.in_scene(), unit.metres().unwrap());
            assert_eq!(if unit.of_scene() == Unit::Millimetre { factor * 0.001 } else { factor }, metres);
        }
        assert_eq!(LengthUnit::of_metres(0.304_800_609_6), LengthUnit::US_SURVEY_FOOT);
        assert_ne!(LengthUnit::of_metres(0.3048), LengthUnit::US_SURVEY_FOOT);
        assert_eq!(LengthUnit::of_metres(0.304_797_265_4).suffix(), " x 0.3047972654 m");
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(LengthUnit::of_metres(wrong), LengthUnit::UNKNOWN);
        }
        assert_eq!((LengthUnit::UNKNOWN.of_scene(), LengthUnit::UNKNOWN.in_scene()), (Unit::Voxel, 1.0));
        assert_eq!(LengthUnit::of_symbol("yd"), None);
    }
}
