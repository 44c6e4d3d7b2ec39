//! Quantities as people write them, in plans and on command lines: sizes of pictures, durations, numbers of voxels.

use std::str::FromStr;
use std::time::Duration;

/// Most pixels along one edge of a picture.
const MAX_EDGE: u32 = 65_536;

/// Width and height of a picture.
pub type Size = (u32, u32);

/// A text that is not the quantity it should be; says which text and what it should be.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct QuantityError(String);

/// A count and what is counted, in the singular where it is one: `1 instance`, `12 instances`.
pub fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn number<T: FromStr>(text: &str, what: &str) -> Result<T, QuantityError> {
    text.trim().parse().map_err(|_| QuantityError(format!("{text:?} is not {what}")))
}

/// `WxH`, at least 1 and at most 65,536 pixels along an edge.
///
/// # Errors
/// A text that is none.
pub fn size(text: &str) -> Result<Size, QuantityError> {
    let expected = "a size like 1280x720";
    let (width, height) =
        text.split_once(['x', 'X', '×']).ok_or_else(|| QuantityError(format!("{text:?} is not {expected}")))?;
    let (width, height) = (number(width, expected)?, number(height, expected)?);
    if width == 0 || height == 0 {
        return Err(QuantityError("a picture has at least one pixel".into()));
    }
    if width > MAX_EDGE || height > MAX_EDGE {
        return Err(QuantityError(format!("a picture has at most {MAX_EDGE} pixels along an edge")));
    }
    Ok((width, height))
}

/// `30`, `30s`, `1.5m`, `1h30m`, `250ms`.
///
/// # Errors
/// A text that is none.
pub fn duration(text: &str) -> Result<Duration, QuantityError> {
    let wrong = || QuantityError(format!("{text:?} is not a duration like 30s, 5m or 1h30m"));
    let mut rest = text.trim();
    let mut seconds = 0.0;
    while !rest.is_empty() {
        let digits = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        let value: f64 = rest[..digits].parse().map_err(|_| wrong())?;
        let unit = &rest[digits..];
        let letters = unit.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(unit.len());
        seconds += value
            * match &unit[..letters] {
                "" | "s" => 1.0,
                "ms" => 0.001,
                "m" | "min" => 60.0,
                "h" => 3600.0,
                _ => return Err(wrong()),
            };
        rest = &unit[letters..];
    }
    match Duration::try_from_secs_f64(seconds) {
        Ok(duration) if !duration.is_zero() => Ok(duration),
        _ => Err(wrong()),
    }
}

/// A number of voxels: `500000`, `500k`, `13.6M`, `1G`.
///
/// # Errors
/// A text that is none.
pub fn voxels(text: &str) -> Result<u64, QuantityError> {
    let (digits, factor) = match text.trim().char_indices().last() {
        Some((at, 'k' | 'K')) => (&text.trim()[..at], 1e3),
        Some((at, 'M' | 'm')) => (&text.trim()[..at], 1e6),
        Some((at, 'G' | 'g')) => (&text.trim()[..at], 1e9),
        _ => (text.trim(), 1.0),
    };
    let value: f64 = number(digits, "a number of voxels")?;
    let count = (value * factor).round();
    if (1.0..1e15).contains(&count) {
        Ok(count as u64)
    } else {
        Err(QuantityError(format!("{text:?} is not a number of voxels")))
    }
}

/// Seconds as people read them.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.round().min(1e9) as u64;
    match (whole / 3600, whole / 60 % 60, whole % 60) {
        (0, 0, _) if seconds < 9.95 => format!("{seconds:.1} s"),
        (0, 0, s) => format!("{s} s"),
        (0, m, s) => format!("{m} min {s:02} s"),
        (h, m, _) => format!("{h} h {m:02} min"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_and_absurd_ones_refused() {
        assert_eq!(size("1280x720"), Ok((1280, 720)));
        assert_eq!(size("1X2"), Ok((1, 2)));
        for wrong in ["", "1280", "x", "0x5", "5x0", "-1x5", "1.5x2", "65537x1", "99999999999x1", "1x2x3"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn durations_add_up_their_units() {
        assert_eq!(duration("30"), Ok(Duration::from_secs(30)));
        assert_eq!(duration("250ms"), Ok(Duration::from_millis(250)));
        assert_eq!(duration("1h30m"), Ok(Duration::from_secs(5400)));
        assert_eq!(duration("1.5m"), Ok(Duration::from_secs(90)));
        for wrong in ["", "0", "s", "5 apples", "-1s", "NaN", "inf", "1e400h", "5x", "1..5"] {
            assert!(duration(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_of_voxels_have_their_bounds() {
        assert_eq!(voxels("500000"), Ok(500_000));
        assert_eq!((voxels("500k"), voxels("13.6M"), voxels("1G")), (Ok(500_000), Ok(13_600_000), Ok(1_000_000_000)));
        for wrong in ["0", "-5", "1e30", "nan", "inf", "", "x"] {
            assert!(voxels(wrong).is_err(), "{wrong}");
        }
    }
}
