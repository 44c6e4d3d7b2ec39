//! The header of a PLY file: elements, each a table, and their properties, the columns.

use super::faces::column_of;
use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Most pictures that are shown.
const MOST_TEXTURES: usize = 1024;

/// How values are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Text,
    Little,
    Big,
}

/// Type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn of(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Largest value of a whole number, 1 for the others: what stands for full intensity.
    pub fn full(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32_767.0,
            Self::U16 => 65_535.0,
            Self::I32 => 2_147_483_647.0,
            Self::U32 => 4_294_967_295.0,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// A column of an element.
#[derive(Clone, Debug)]
pub(crate) struct Property {
    pub name: String,
    /// Type of the value, or of the list's values.
    pub kind: Kind,
    /// Type of the count, for a list.
    pub list: Option<Kind>,
}

/// A table.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
}

impl Element {
    /// Position of the first property that has one of the names.
    pub fn find(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|property| names.contains(&property.name.as_str()))
    }
}

/// The header.
pub(crate) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Pictures that comments name; several only where faces say which of them they show.
    pub textures: Vec<String>,
}

impl Header {
    /// Whether there are faces or strips of triangles.
    pub fn has_faces(&self) -> bool {
        self.elements.iter().any(|element| element.count > 0 && column_of(element).is_some())
    }

    pub fn read(input: &mut Input, limits: &Limits) -> Result<Self, ImportError> {
        let path = input.path();
        if input.peek(4)?.get(..3) != Some(b"ply") {
            return Err(ImportError::at(
                path,
                0,
                ImportErrorKind::UnknownFormat("a PLY file begins with `ply`".into()),
            ));
        }
        let (mut encoding, mut elements, mut textures) = (None, Vec::<Element>::new(), Vec::new());
        loop {
            let start = input.offset();
            let malformed = |what: String| ImportError::malformed(path, start, what);
            let line = input.line()?.map(|line| String::from_utf8_lossy(line).into_owned());
            let line = line.ok_or_else(|| ImportError::truncated(path, start, "the header"))?;
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            match words[..] {
                ["format", name, "1.0"] => {
                    encoding = Some(match name {
                        "ascii" => Encoding::Text,
                        "binary_little_endian" => Encoding::Little,
                        "binary_big_endian" => Encoding::Big,
                        _ => return Err(malformed(format!("the format {name:?} is unknown"))),
                    });
                }
                ["element", name, count] => {
                    let count = count.parse().map_err(|_| malformed(format!("{count:?} is no number of items")))?;
                    if count > limits.points {
                        return Err(ImportError::limit(
                            path,
                            Some(start),
                            format!("items of {name}"),
                            count,
                            limits.points,
                        ));
                    }
                    elements.push(Element { name: name.into(), count, properties: Vec::new() });
                }
                ["property", "list", count, kind, name] => {
                    let list = Kind::of(count).ok_or_else(|| malformed(format!("the type {count:?} is unknown")))?;
                    push(&mut elements, kind, name, Some(list)).map_err(malformed)?;
                }
                ["property", kind, name] => push(&mut elements, kind, name, None).map_err(malformed)?,
                ["comment", "TextureFile", ..] => {
                    let name = line.split_once("TextureFile").map(|(_, name)| name.trim().to_owned());
                    textures.extend(name.filter(|_| textures.len() < MOST_TEXTURES));
                }
                ["end_header"] => break,
                ["ply" | "comment" | "obj_info", ..] | [] => {}
                _ => return Err(malformed(format!("a header line that is none: {line:.60}"))),
            }
            if elements.len() as u64 > limits.items {
                return Err(ImportError::limit(path, Some(start), "elements", elements.len() as u64, limits.items));
            }
        }
        let encoding =
            encoding.ok_or_else(|| ImportError::malformed(path, input.offset(), "the format line is missing"))?;
        if !elements.iter().any(|element| element.find(&["texnumber"]).is_some()) {
            textures.drain(..textures.len().saturating_sub(1));
        }
        Ok(Self { encoding, elements, textures })
    }
}

fn push(elements: &mut [Element], kind: &str, name: &str, list: Option<Kind>) -> Result<(), String> {
    let kind = Kind::of(kind).ok_or_else(|| format!("the type {kind:?} is unknown"))?;
    let element = elements.last_mut().ok_or("a property before the first element")?;
    if element.properties.len() >= 1024 {
        return Err("more than 1,024 properties".into());
    }
    element.properties.push(Property { name: name.into(), kind, list });
    Ok(())
}
