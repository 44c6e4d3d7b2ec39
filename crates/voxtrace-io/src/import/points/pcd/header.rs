//! The header of a PCD file: lines of a word and what it means.

use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Most bytes of a point.
const LARGEST: usize = 1 << 16;

/// Longest word of a header that is gone over, and most such words.
const LONGEST_WORD: usize = 40;
const MOST_UNKNOWN: usize = 64;

/// The origin as a viewpoint, not turned: a place and a quaternion, w first.
const USUAL_VIEWPOINT: [f64; 7] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// How the points are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Data {
    Text,
    Binary,
    Compressed,
}

/// One number of a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Field {
    name: String,
    kind: u8,
    size: usize,
    /// Byte of a point at which it stands, its column in a text, and bytes of all numbers of this field.
    pub offset: usize,
    pub column: usize,
    pub stride: usize,
}

impl Field {
    /// Its value from its first byte on.
    pub fn number(&self, bytes: &[u8]) -> f64 {
        macro_rules! number {
            ($type:ty) => {
                bytes.first_chunk().map_or(f64::NAN, |bytes| <$type>::from_le_bytes(*bytes) as f64)
            };
        }
        match (self.kind, self.size) {
            (b'F', 8) => number!(f64),
            (b'F', _) => number!(f32),
            (b'I', 1) => number!(i8),
            (b'I', 2) => number!(i16),
            (b'I', 8) => number!(i64),
            (b'I', _) => number!(i32),
            (_, 1) => number!(u8),
            (_, 2) => number!(u16),
            (_, 8) => number!(u64),
            _ => number!(u32),
        }
    }

    /// Whether it is a floating-point number.
    pub fn is_real(&self) -> bool {
        self.kind == b'F'
    }

    /// The bits of a packed colour.
    pub fn bits(&self, value: f64) -> u32 {
        if self.kind == b'F' { (value as f32).to_bits() } else { value as i64 as u32 }
    }
}

/// What a header says.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub points: u64,
    /// Bytes of a point, and numbers on a line.
    pub size: usize,
    pub columns: usize,
    pub data: Data,
    pub position: [Field; 3],
    /// Packed, or a number each.
    pub color: Option<Field>,
    pub rgb: Option<[Field; 3]>,
    pub intensity: Option<Field>,
    pub label: Option<Field>,
    /// From where the points were seen, where that is not the origin: for people.
    pub viewpoint: Option<String>,
    /// Words of the header that are not known: for people.
    pub unknown: Vec<String>,
}

impl Header {
    /// Reads up to the line of `DATA`.
    pub fn read(input: &mut Input) -> Result<Self, ImportError> {
        let path = input.path();
        let (mut names, mut sizes, mut kinds, mut counts) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (mut width, mut height, mut points, mut viewpoint) = (None, None, None, None);
        let mut unknown = Vec::new();
        loop {
            let start = input.offset();
            let malformed = |what: String| ImportError::malformed(path, start, what);
            let Some(line) = input.line()? else {
                return Err(ImportError::truncated(path, start, "the header"));
            };
            let line = std::str::from_utf8(line).map_err(|_| malformed("a header that is no text".into()))?;
            let mut words = line.split_ascii_whitespace();
            let Some(word) = words.next().filter(|word| !word.starts_with('#')) else { continue };
            let wrong = || malformed(format!("{line:?} makes no sense"));
            let numbers = |words: std::str::SplitAsciiWhitespace| -> Result<Vec<usize>, ImportError> {
                words.map(|word| word.parse().ok().filter(|&number| number <= LARGEST).ok_or_else(wrong)).collect()
            };
            let number =
                |word: Option<&str>| word.and_then(|word| word.parse::<u64>().ok()).ok_or_else(wrong).map(Some);
            match word.to_ascii_uppercase().as_str() {
                "VERSION" => {}
                "VIEWPOINT" => {
                    let words: Vec<&str> = words.collect();
                    let is_usual = words.iter().filter_map(|word| word.parse::<f64>().ok()).eq(USUAL_VIEWPOINT);
                    viewpoint = (!is_usual).then(|| words.join(" "));
                }
                "FIELDS" | "COLUMNS" => names = words.map(str::to_ascii_lowercase).collect(),
                "SIZE" => sizes = numbers(words)?,
                "TYPE" => kinds = words.map(|word| word.as_bytes()[0].to_ascii_uppercase()).collect(),
                "COUNT" => counts = numbers(words)?,
                "WIDTH" => width = number(words.next())?,
                "HEIGHT" => height = number(words.next())?,
                "POINTS" => points = number(words.next())?,
                "DATA" => {
                    let word = words.next().unwrap_or("nothing");
                    let data = match word.to_ascii_lowercase().as_str() {
                        "ascii" => Data::Text,
                        "binary" => Data::Binary,
                        "binary_compressed" => Data::Compressed,
                        _ => {
                            let kind = ImportErrorKind::Unsupported(format!("points written as {word:?}"));
                            return Err(ImportError::at(path, start, kind));
                        }
                    };
                    if counts.is_empty() {
                        counts = vec![1; names.len()];
                    }
                    let points = points.or_else(|| width?.checked_mul(height.unwrap_or(1)));
                    let points =
                        points.ok_or_else(|| malformed("a header that does not say how many points".into()))?;
                    let header = Self::of(&names, &sizes, &kinds, &counts, points, data).map_err(malformed)?;
                    return Ok(Self { viewpoint, unknown, ..header });
                }
                // Programs add words of their own, before the points.
                _ if word.len() <= LONGEST_WORD
                    && word.bytes().all(|byte| byte == b'_' || byte.is_ascii_alphanumeric()) =>
                {
                    unknown.push(word.to_owned());
                    if unknown.len() > MOST_UNKNOWN {
                        return Err(malformed(format!("{word:?} is no word of a PCD header")));
                    }
                }
                _ => return Err(malformed(format!("{word:?} is no word of a PCD header"))),
            }
        }
    }

    fn of(
        names: &[String],
        sizes: &[usize],
        kinds: &[u8],
        counts: &[usize],
        points: u64,
        data: Data,
    ) -> Result<Self, String> {
        if [sizes.len(), kinds.len(), counts.len()].iter().any(|&len| len != names.len()) {
            return Err("fields, sizes, types and counts that are not as many".into());
        }
        let (mut offset, mut column, mut fields) = (0usize, 0usize, Vec::new());
        for (n, name) in names.iter().enumerate() {
            let (size, kind, count) = (sizes[n], kinds[n], counts[n]);
            let is_known = matches!((kind, size), (b'F', 4 | 8) | (b'I' | b'U', 1 | 2 | 4 | 8));
            if !is_known || count == 0 {
                return Err(format!("the field {name:?} of {count} numbers of {size} bytes makes no sense"));
            }
            let stride = size * count;
            fields.push(Field { name: name.clone(), kind, size, offset, column, stride });
            (offset, column) = (offset + stride, column + count);
            if offset > LARGEST {
                return Err("points of more bytes than make sense".into());
            }
        }
        let find = |wanted: &[&str]| fields.iter().find(|field| wanted.contains(&field.name.as_str())).cloned();
        let (Some(x), Some(y), Some(z)) = (find(&["x"]), find(&["y"]), find(&["z"])) else {
            return Err("points without x, y and z".into());
        };
        let color = find(&["rgb", "rgba"]).filter(|field| field.size == 4);
        let apart = [find(&["r", "red"]), find(&["g", "green"]), find(&["b", "blue"])];
        let rgb = if let ([Some(r), Some(g), Some(b)], None) = (apart, &color) { Some([r, g, b]) } else { None };
        let (intensity, label) = (find(&["intensity", "intensities", "i"]), find(&["label", "classification"]));
        let (size, columns, position) = (offset, column, [x, y, z]);
        let (viewpoint, unknown) = (None, Vec::new());
        Ok(Self { points, size, columns, data, position, color, rgb, intensity, label, viewpoint, unknown })
    }
}
