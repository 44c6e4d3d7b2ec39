//! Values of options: sizes, rectangles, durations, vectors, colours. Numbers that are not finite are refused.

use std::str::FromStr;
use voxtrace::Region;
use voxtrace::changes::SunSetting;
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::material::linear_color;
use voxtrace::scene::LengthUnit;
pub use voxtrace_bench::quantity::{Size, duration, size, voxels};

/// Most samples of a pixel: past this, the sums of very bright pixels may be clipped.
pub const MAX_SAMPLES: u32 = 1 << 20;

fn number<T: FromStr>(text: &str, what: &str) -> Result<T, String> {
    text.trim().parse().map_err(|_| format!("{text:?} is not {what}"))
}

/// A relative error: above 0, at most 1.
pub fn error(text: &str) -> Result<f64, String> {
    let error = f64::from(finite(text)?);
    if error > 0.0 && error <= 1.0 { Ok(error) } else { Err("an error is above 0 and at most 1".into()) }
}

/// A number that is neither infinite nor NaN.
pub fn finite(text: &str) -> Result<f32, String> {
    let value: f32 = number(text, "a number")?;
    if value.is_finite() { Ok(value) } else { Err(format!("{text:?} is not a finite number")) }
}

/// A finite number of at least 0.
pub fn positive(text: &str) -> Result<f32, String> {
    let value = finite(text)?;
    if value >= 0.0 { Ok(value) } else { Err(format!("{text} is less than 0")) }
}

/// A number from 0 to 1.
pub fn share(text: &str) -> Result<f32, String> {
    let value = finite(text)?;
    if (0.0..=1.0).contains(&value) { Ok(value) } else { Err(format!("{text} is not from 0 to 1")) }
}

/// Three distances, `0.5,0.5,2`, or one that holds for all axes.
pub fn spacing(text: &str) -> Result<DVec3, String> {
    let all: Result<Vec<f64>, _> = text.split(',').map(|word| word.trim().parse::<f64>()).collect();
    let all = all.unwrap_or_default();
    let spacing = match all[..] {
        [all] => DVec3::splat(all),
        [x, y, z] => DVec3::new(x, y, z),
        _ => return Err(format!("{text:?} is not three distances like 0.5,0.5,2")),
    };
    let is_good = spacing.to_array().iter().all(|distance| (1e-9..1e9).contains(distance));
    if is_good { Ok(spacing) } else { Err(format!("{text:?} has a distance that is not from 1e-9 to 1e9")) }
}

/// An angle of view in degrees.
pub fn field_of_view(text: &str) -> Result<f32, String> {
    let value = finite(text)?;
    if value > 0.0 && value < 180.0 { Ok(value) } else { Err(format!("{text} is not between 0 and 180 degrees")) }
}

/// A pixel `x,y`.
pub fn pixel(text: &str) -> Result<(u32, u32), String> {
    let expected = "a pixel x,y";
    let numbers: Vec<u32> = text.split(',').map(|part| number(part, expected)).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y] => Ok((x, y)),
        _ => Err(format!("{text:?} is not {expected}")),
    }
}

/// `x0,x1,y0,y1`.
pub fn crop(text: &str) -> Result<Region, String> {
    let expected = "a rectangle x0,x1,y0,y1 of pixels";
    let numbers: Vec<u32> = text.split(',').map(|part| number(part, expected)).collect::<Result<_, _>>()?;
    let [x0, x1, y0, y1] = numbers[..] else { return Err(format!("{text:?} is not {expected}")) };
    if x0 >= x1 || y0 >= y1 {
        return Err(format!("the rectangle {text} is empty: x0 < x1 and y0 < y1 must hold"));
    }
    Ok(Region { x0, y0, x1, y1 })
}

/// Samples of each pixel, 1 to [`MAX_SAMPLES`].
pub fn samples(text: &str) -> Result<u32, String> {
    match number(text, "a number of samples")? {
        0 => Err("a pixel needs at least one sample".into()),
        samples if samples > MAX_SAMPLES => Err(format!("at most {MAX_SAMPLES} samples are possible")),
        samples => Ok(samples),
    }
}

/// `x,y,z`.
pub fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f32> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err(format!("{text:?} is not three numbers x,y,z")),
    }
}

/// `#rrggbb` (sRGB), or three linear numbers `r,g,b`.
pub fn color(text: &str) -> Result<Vec3, String> {
    if let Some(digits) = text.strip_prefix('#') {
        let is_hex = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
        let value = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex);
        let value = value.ok_or_else(|| format!("{text:?} is not a colour like #88aaff"))?;
        let [_, red, green, blue] = value.to_be_bytes();
        return Ok(linear_color([red, green, blue]));
    }
    let color = vector(text).map_err(|_| format!("{text:?} is not a colour like #88aaff or 0.3,0.5,1"))?;
    if color.min_element() < 0.0 { Err("a colour has no channel below 0".into()) } else { Ok(color) }
}

/// Where a colour at the begin of a text ends: it is one word, or three.
pub fn end_of_color(text: &str) -> usize {
    let words = if text.starts_with('#') { 1 } else { 3 };
    text.match_indices(',').nth(words - 1).map_or(text.len(), |(at, _)| at)
}

/// `bearing,height` or `bearing,height,strength`.
pub fn sun(text: &str) -> Result<SunSetting, String> {
    let numbers: Vec<f32> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    let sun = match numbers[..] {
        [bearing, height] => SunSetting { bearing, height, strength: 3.0 },
        [bearing, height, strength] => SunSetting { bearing, height, strength },
        _ => return Err(format!("{text:?} is not bearing,height or bearing,height,strength")),
    };
    if !(-90.0..=90.0).contains(&sun.height) || sun.strength < 0.0 {
        return Err("the sun's height is from -90 to 90 degrees, its strength at least 0".into());
    }
    Ok(sun)
}

/// Frames of an animation, both ends included.
pub type Frames = std::ops::RangeInclusive<u32>;

/// `1..240` or `1-240`, both included, or one number.
pub fn frames(text: &str) -> Result<Frames, String> {
    let expected = "frames like 1..240";
    if text.contains(',') {
        return Err(format!("{text:?} is a list; a run makes one range of {expected}"));
    }
    let (first, last) = text.split_once("..").or(text.split_once('-')).unwrap_or((text, text));
    let (first, last): (u32, u32) = (number(first, expected)?, number(last, expected)?);
    if first == 0 || first > last || last > 1_000_000 {
        return Err(format!("{text:?} is not {expected}: the first is at least 1 and not after the last"));
    }
    Ok(first..=last)
}

/// A length: a number with its unit, or in the file's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    pub value: f64,
    pub unit: Option<LengthUnit>,
}

impl Length {
    /// The length in a unit; a file without one is taken to be in metres.
    pub fn in_unit(self, unit: LengthUnit) -> f64 {
        let metres = |unit: LengthUnit| unit.metres().unwrap_or(1.0);
        match self.unit {
            None => self.value,
            Some(own) if own == unit => self.value,
            // Powers of ten are divided by: 20 mm are 0.02 m to the last bit.
            Some(own) if metres(own) < metres(unit) => self.value / (metres(unit) / metres(own)),
            Some(own) => self.value * (metres(own) / metres(unit)),
        }
    }
}

/// `0.02`, `0.02m`, `2cm`, `20mm`, `2ft`.
pub fn length(text: &str) -> Result<Length, String> {
    let text = text.trim();
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '-');
    // No unit, but `nan` or a word.
    let digits = if digits.is_empty() { text } else { digits };
    let unit = match &text[digits.len()..] {
        "" => None,
        symbol => Some(unit(symbol)?),
    };
    let value = number::<f64>(digits, "a length like 0.02, 2cm or 2ft")?;
    let is_length = value.is_finite() && value > 0.0;
    if is_length { Ok(Length { value, unit }) } else { Err(format!("{text} is no length above 0")) }
}

/// `m`, `mm`, `cm`, `km`, `ft`, `us-ft`.
pub fn unit(text: &str) -> Result<LengthUnit, String> {
    LengthUnit::of_symbol(text.trim()).ok_or_else(|| {
        let symbols = LengthUnit::SYMBOLS.map(|(symbol, _)| symbol).join(", ");
        format!("{text:?} is no unit of length; {symbols} are")
    })
}

/// `1000000`, `500MB`, `1GB`, `2GiB`.
pub fn bytes(text: &str) -> Result<u64, String> {
    let value = number_of_bytes(text)?.round();
    if (1.0..1e18).contains(&value) { Ok(value as u64) } else { Err(format!("{text:?} is not a number of bytes")) }
}

/// As [`bytes`], or `0`.
pub fn bytes_or_none(text: &str) -> Result<u64, String> {
    if number_of_bytes(text)? == 0.0 { Ok(0) } else { bytes(text) }
}

/// Bytes with their unit, not rounded.
fn number_of_bytes(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let factor = match text[digits.len()..].to_ascii_lowercase().as_str() {
        "" | "b" => 1.0,
        "k" | "kb" => 1e3,
        "m" | "mb" => 1e6,
        "g" | "gb" => 1e9,
        "mib" => 1_048_576.0,
        "gib" => 1_073_741_824.0,
        _ => return Err(format!("{text:?} is not a number of bytes like 500MB or 1GB")),
    };
    Ok(number::<f64>(digits, "a number of bytes")? * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crop_names_its_edges_in_the_order_x0_x1_y0_y1() {
        assert_eq!(crop("1,2,3,4"), Ok(Region { x0: 1, x1: 2, y0: 3, y1: 4 }));
        for wrong in ["", "1,2,3", "1,2,3,4,5", "2,2,3,4", "1,2,4,3", "a,b,c,d", "-1,2,3,4"] {
            assert!(crop(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn what_is_not_a_finite_number_is_refused_everywhere() {
        for wrong in ["nan", "NaN", "inf", "-inf", "infinity", "1e99", "", "x"] {
            assert!(finite(wrong).is_err(), "{wrong}");
            assert!(vector(&format!("1,{wrong},2")).is_err(), "{wrong}");
            assert!(color(&format!("1,{wrong},2")).is_err(), "{wrong}");
            assert!(sun(&format!("1,{wrong}")).is_err(), "{wrong}");
            assert!(field_of_view(wrong).is_err() && positive(wrong).is_err(), "{wrong}");
        }
        assert_eq!(spacing("0.5, 0.1,2"), Ok(DVec3::new(0.5, 0.1, 2.0)));
        assert_eq!(spacing("3"), Ok(DVec3::splat(3.0)));
        assert!(["", "1,2", "1,2,0", "1,2,-3", "1,2,nan", "a"].iter().all(|wrong| spacing(wrong).is_err()));
        assert_eq!(vector("-1,2.5,3e2"), Ok(Vec3::new(-1.0, 2.5, 300.0)));
        assert!(vector("1,2").is_err() && vector("1,2,3,4").is_err());
    }

    #[test]
    fn colours_are_srgb_digits_or_linear_numbers() {
        assert_eq!(color("#ffffff"), Ok(Vec3::ONE));
        assert_eq!(color("#ff0000"), Ok(Vec3::X));
        assert_eq!(color("0.5,2,0"), Ok(Vec3::new(0.5, 2.0, 0.0)));
        for wrong in ["#fff", "#gggggg", "#1234567", "red", "-1,0,0", "#+1234f"] {
            assert!(color(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn frames_and_samples_have_their_bounds() {
        assert_eq!(frames("1..240"), Ok(1..=240));
        assert_eq!((frames("7"), frames("3-9")), (Ok(7..=7), Ok(3..=9)));
        assert!(frames("0..4").is_err() && frames("5..4").is_err() && frames("a..b").is_err());
        assert_eq!(samples("64"), Ok(64));
        assert!(samples("0").is_err() && samples("-1").is_err() && samples("1048577").is_err());
        assert!(field_of_view("0").is_err() && field_of_view("180").is_err() && field_of_view("90").is_ok());
    }

    #[test]
    fn lengths_have_units_or_those_of_the_file() {
        let within = |text: &str, unit| length(text).map(|length| length.in_unit(unit));
        assert_eq!(length("0.02"), Ok(Length { value: 0.02, unit: None }));
        assert_eq!(within("0.02", LengthUnit::FOOT), Ok(0.02));
        assert_eq!(within("2cm", LengthUnit::METRE), Ok(0.02));
        assert_eq!(within("2cm", LengthUnit::UNKNOWN), Ok(0.02));
        assert_eq!(within("20mm", LengthUnit::MILLIMETRE), Ok(20.0));
        assert_eq!(within("20mm", LengthUnit::METRE), Ok(0.02));
        assert_eq!(within("2ft", LengthUnit::FOOT), Ok(2.0));
        assert_eq!(within("2ft", LengthUnit::METRE), Ok(0.6096));
        assert!(within("3937us-ft", LengthUnit::METRE).is_ok_and(|metres| (metres - 1200.0).abs() < 1e-9));
        assert_eq!(within("1km", LengthUnit::MILLIMETRE), Ok(1e6));
        for wrong in ["", "m", "0", "-1m", "5yd", "5-ft", "2us-m", "nan", "inf"] {
            assert!(length(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn bytes_come_in_thousands_or_in_1024s() {
        assert_eq!((bytes("500MB"), bytes("1gb"), bytes("2GiB")), (Ok(500_000_000), Ok(1_000_000_000), Ok(2 << 30)));
        assert!(bytes("").is_err() && bytes("0").is_err() && bytes("1XB").is_err() && bytes("-1GB").is_err());
        assert_eq!((bytes_or_none("0"), bytes_or_none("0MB"), bytes_or_none("2kB")), (Ok(0), Ok(0), Ok(2000)));
        for wrong in ["", "0XB", "-1", "0.4", "nan"] {
            assert!(bytes_or_none(wrong).is_err(), "{wrong}");
        }
    }
}
