//! STL, the format of triangles alone, as text and as binary (3D Systems, "StereoLithography Interface Specification", 1988); of binary files
//! the colours too that VisCAM and SolidView, or Materialise Magics, put where the attribute of a triangle was meant to be.

use crate::import::reader::{Geometry, Kind, LargeContent, Reader, Recognition};
use crate::import::source::input::{Input, without_mark};
use glam::{Vec3, Vec4};
use std::path::{Path, PathBuf};
use voxtrace_scene::material::{linear_color, srgb_from_linear};
use voxtrace_voxelize::mesh::source::{SourceColors, TriangleSource};
use voxtrace_voxelize::mesh::{Mesh, MeshMaterial};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("STL", Kind::Mesh, &["stl"], "mesh, text or binary", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(Geometry::Mesh(read(input, &options.limits)?).into())
    })
    // The words of a text are weaker than any name.
    .with_recognition(|clues| if begins(clues.head) { Recognition::Likely } else { Recognition::Unknown })
    .with_large(|source, _, _| {
        Ok(StlTriangles::open(source.path())?.map(|source| {
            let size = source.size_bytes();
            LargeContent::of_triangles(source, size)
        }))
    });

/// Bytes before the triangles of a binary file: 80 of text and their number.
const HEADER: usize = 84;
/// Bytes of a triangle: normal, three corners, attribute.
const RECORD: usize = 50;
/// Triangles taken at once.
const CHUNK: usize = 4096;

/// Reads an STL file.
fn read(mut input: Input, limits: &Limits) -> Result<Mesh, ImportError> {
    let mut mesh = Mesh::new("");
    if is_text(&mut input)? {
        read_text(&mut input, limits, &mut mesh)?;
    } else {
        read_binary(&mut input, limits, &mut mesh)?;
    }
    if mesh.positions.is_empty() {
        let kind = ImportErrorKind::Unsupported("an STL file without a triangle".into());
        return Err(ImportError::at(input.path(), input.offset(), kind));
    }
    Ok(mesh)
}

/// Whether a file without an extension begins as one of text does.
fn begins(head: &[u8]) -> bool {
    let head = without_mark(head).trim_ascii_start();
    head.starts_with(b"solid") && head.windows(5).any(|word| word == b"facet")
}

fn is_text(input: &mut Input) -> Result<bool, ImportError> {
    let total = input.remaining();
    let head = input.peek(HEADER)?;
    let count = head.get(80..HEADER).map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    // Some binary files begin with `solid` too, so a length that fits decides first.
    let fits = |(count, total): (u32, u64)| HEADER as u64 + RECORD as u64 * u64::from(count) == total;
    let fits = count.zip(total).is_some_and(fits);
    // A length that is unknown, or that bytes behind the triangles add to, says nothing; but the count of a binary file has a zero byte.
    Ok(without_mark(head).trim_ascii_start().starts_with(b"solid") && !fits && !head.contains(&0))
}

fn read_binary(input: &mut Input, limits: &Limits, mesh: &mut Mesh) -> Result<(), ImportError> {
    let (mut left, paint) = announced(input, limits)?;
    let mut has_attributes = false;
    if input.remaining().is_some() {
        mesh.positions.reserve_exact(left * 3);
    }
    while left > 0 {
        let now = left.min(CHUNK);
        has_attributes |= take_triangles(input, now, paint, mesh)?;
        left -= now;
    }
    if let (Paint::Magics(color), false) = (paint, has_attributes) {
        mesh.colors.fill(linear_color(color).extend(1.0));
    }
    if !mesh.colors.is_empty() {
        mesh.materials[0].base_color = Vec4::ONE;
    }
    Ok(())
}

/// What the attributes of triangles say about colours.
#[derive(Clone, Copy)]
enum Paint {
    /// Red, green and blue from the 10th, the 5th and the lowest bit on, where the highest one is set.
    VisCam,
    /// Red, green and blue from the lowest, the 5th and the 10th bit on. Where the highest one is set, the header says the colour; since some
    /// programs (VCGlib) set it always, only where all the others are alike.
    Magics([u8; 3]),
    /// The colour of such a header, of all triangles: where every attribute is 0, nobody has written any.
    All([u8; 3]),
}

impl Paint {
    fn of(header: &[u8]) -> Self {
        let at = header.windows(6).position(|word| word == b"COLOR=");
        let color = at.and_then(|at| header[at + 6..].first_chunk());
        color.map_or(Self::VisCam, |&color| Self::Magics(color))
    }

    /// sRGB, `None` where the triangle has no colour of its own.
    fn color(self, attribute: u16) -> Option<[u8; 3]> {
        let channels = [10, 5, 0].map(|shift| ((attribute >> shift & 31) * 255 / 31) as u8);
        match (self, attribute >> 15) {
            (Self::All(color), _) => Some(color),
            (Self::VisCam, 0) => None,
            (Self::VisCam, _) => Some(channels),
            (Self::Magics(color), 1) if matches!(attribute & 0x7fff, 0 | 0x7fff) => Some(color),
            (Self::Magics(_), _) => Some([channels[2], channels[1], channels[0]]),
        }
    }
}

/// Takes the header of a binary file and says how many triangles it announces, which are there, and how they are coloured.
fn announced(input: &mut Input, limits: &Limits) -> Result<(usize, Paint), ImportError> {
    let path = input.path();
    let head = input.take(HEADER, "the header of a binary STL file")?;
    let (count, paint) = (u32::from_le_bytes([head[80], head[81], head[82], head[83]]), Paint::of(&head[..80]));
    if u64::from(count) * 3 > limits.points {
        return Err(ImportError::limit(path, Some(80), "corners", u64::from(count) * 3, limits.points));
    }
    if input.remaining().is_some_and(|remaining| remaining < u64::from(count) * RECORD as u64) {
        let end = input.offset() + input.remaining().unwrap_or(0);
        return Err(ImportError::truncated(path, end, format!("the {count} triangles that the header announces")));
    }
    Ok((count as usize, paint))
}

/// The colour of triangles without one beside others that have one.
fn plain() -> Vec4 {
    linear_color(MeshMaterial::default().base_color.truncate().to_array().map(srgb_from_linear)).extend(1.0)
}

/// Takes triangles of a binary file, and says whether any has an attribute. Colours begin with the first triangle that has one.
fn take_triangles(input: &mut Input, count: usize, paint: Paint, mesh: &mut Mesh) -> Result<bool, ImportError> {
    let (path, start, plain) = (input.path(), input.offset(), plain());
    let mut has_attributes = false;
    let records = input.take(count * RECORD, "a triangle")?;
    for (index, record) in records.chunks_exact(RECORD).enumerate() {
        for corner in record[12..48].chunks_exact(12) {
            let number = |at: usize| f32::from_le_bytes([corner[at], corner[at + 1], corner[at + 2], corner[at + 3]]);
            let corner = Vec3::new(number(0), number(4), number(8));
            if !corner.is_finite() {
                let at = start + (index * RECORD) as u64;
                return Err(ImportError::malformed(path, at, "a corner that is not finite"));
            }
            mesh.positions.push(corner);
        }
        let attribute = u16::from_le_bytes([record[48], record[49]]);
        has_attributes |= attribute != 0;
        let color = paint.color(attribute);
        if color.is_some() || !mesh.colors.is_empty() {
            mesh.colors.resize(mesh.positions.len() - 3, plain);
            mesh.colors.extend([color.map_or(plain, |color| linear_color(color).extend(1.0)); 3]);
        }
    }
    Ok(has_attributes)
}

/// The triangles of a binary STL file larger than memory.
struct StlTriangles {
    path: PathBuf,
    count: usize,
    paint: Paint,
    is_colored: bool,
    frame: Mesh,
}

impl StlTriangles {
    /// Opens a file, if it is a binary one.
    pub fn open(path: &Path) -> Result<Option<Self>, ImportError> {
        let mut input = Input::open(path, &UNBOUNDED)?;
        if input.remaining().is_none() || is_text(&mut input)? {
            return Ok(None);
        }
        let (count, mut paint) = announced(&mut input, &UNBOUNDED)?;
        let (mut left, mut is_colored, mut has_attributes) = (count, false, false);
        while left > 0 && !(is_colored && has_attributes) {
            let now = left.min(CHUNK);
            let records = input.take(now * RECORD, "a triangle")?;
            let mut attributes =
                records.chunks_exact(RECORD).map(|record| u16::from_le_bytes([record[48], record[49]]));
            is_colored |= attributes.clone().any(|attribute| paint.color(attribute).is_some());
            has_attributes |= attributes.any(|attribute| attribute != 0);
            left -= now;
        }
        if let (Paint::Magics(color), false) = (paint, has_attributes) {
            paint = Paint::All(color);
        }
        let mut frame = Mesh::new("");
        if is_colored {
            frame.materials[0].base_color = Vec4::ONE;
        }
        Ok((count > 0).then(|| Self { path: path.into(), count, paint, is_colored, frame }))
    }

    /// Bytes that the mesh would take in memory.
    pub fn size_bytes(&self) -> u64 {
        self.count as u64 * if self.is_colored { 84 } else { 36 }
    }
}

/// The file itself is the bound of what it can ask for.
const UNBOUNDED: Limits = Limits { bytes: u64::MAX, voxels: 0, points: u64::MAX, items: 0, depth: 0, ratio: 0 };

impl TriangleSource for StlTriangles {
    fn frame(&mut self) -> &mut Mesh {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.count as u64
    }

    fn colors(&self) -> SourceColors {
        if self.is_colored { SourceColors::Bytes } else { SourceColors::None }
    }

    fn has_uvs(&self) -> bool {
        false
    }

    fn release(&mut self) {}

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let mut input = Input::open(&self.path, &UNBOUNDED)?;
        let (mut left, _) = announced(&mut input, &UNBOUNDED)?;
        let mut piece = self.frame.clone();
        while left > 0 {
            let now = left.min(8 * CHUNK);
            piece.clear();
            take_triangles(&mut input, now, self.paint, &mut piece)?;
            if self.is_colored && piece.colors.is_empty() {
                piece.colors.resize(piece.positions.len(), plain());
            }
            left -= now;
            if !each(&piece) {
                break;
            }
        }
        Ok(())
    }
}

fn read_text(input: &mut Input, limits: &Limits, mesh: &mut Mesh) -> Result<(), ImportError> {
    let path = input.path();
    let mut corners = 0;
    loop {
        let start = input.offset();
        let Some(line) = input.line()? else { break };
        let malformed = |what: &str| ImportError::malformed(path, start, what);
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match words.next().map(<[u8]>::to_ascii_lowercase).as_deref() {
            Some(b"vertex") => {
                let mut number = || words.next().and_then(number);
                let corner = number().zip(number()).zip(number()).map(|((x, y), z)| Vec3::new(x, y, z));
                mesh.positions.push(corner.ok_or_else(|| malformed("a vertex without three finite numbers"))?);
                corners += 1;
                if mesh.positions.len() as u64 > limits.points {
                    let count = mesh.positions.len() as u64;
                    return Err(ImportError::limit(path, Some(start), "corners", count, limits.points));
                }
            }
            Some(b"facet" | b"endfacet") => {
                if corners % 3 != 0 {
                    return Err(malformed("a facet that has not three corners"));
                }
            }
            Some(b"solid" | b"endsolid" | b"outer" | b"endloop") | None => {}
            // Names and comments are free text in the wild; whatever stands where a triangle is due is not.
            Some(_) if corners % 3 != 0 => return Err(malformed("an unknown word inside a facet")),
            Some(_) => {}
        }
    }
    if corners % 3 != 0 {
        return Err(ImportError::truncated(path, input.offset(), "a facet"));
    }
    Ok(())
}

/// A finite number in a text file.
pub(super) fn number(word: &[u8]) -> Option<f32> {
    std::str::from_utf8(word).ok()?.parse().ok().filter(|value: &f32| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn read_bytes(bytes: &[u8]) -> Result<Mesh, ImportError> {
        let limits = Limits::default();
        read(Input::of_bytes(bytes, Path::new("a.stl"), &limits)?, &limits)
    }

    fn binary(header: &[u8], corners: &[Vec3]) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, b' ');
        bytes.extend((corners.len() as u32 / 3).to_le_bytes());
        for triangle in corners.chunks(3) {
            bytes.extend([0; 12]);
            bytes.extend(triangle.iter().flat_map(|corner| corner.to_array()).flat_map(f32::to_le_bytes));
            bytes.extend([0; 2]);
        }
        bytes
    }

    const CORNERS: [Vec3; 3] = [Vec3::ZERO, Vec3::new(1.5, 0.0, 0.0), Vec3::new(0.0, 2.0, -1e-3)];

    #[test]
    fn text_and_binary_give_the_same_triangles() {
        let text = "solid a name\r\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   VERTEX 1.5e0 0 0\n\
                    \tvertex 0 2 -1e-3\n  endloop\n endfacet\nendsolid";
        assert_eq!(read_bytes(text.as_bytes()).unwrap().positions, CORNERS);
        assert_eq!(read_bytes(format!("\u{feff}{text}").as_bytes()).unwrap().positions, CORNERS);
        assert_eq!(read_bytes(&binary(b"any text", &CORNERS)).unwrap().positions, CORNERS);
        assert_eq!(read_bytes(&binary(b"solid that is binary", &CORNERS)).unwrap().positions, CORNERS);
    }

    #[test]
    fn a_binary_file_that_begins_as_a_text_is_one_also_where_its_length_does_not_say_so() {
        let limits = Limits::default();
        let bytes = binary(b"solid that is binary", &CORNERS);
        let piped = Input::of_decoder(Box::new(&bytes[..]), Path::new("-"), &limits);
        assert_eq!(read(piped, &limits).unwrap().positions, CORNERS);
        assert_eq!(read_bytes(&[&bytes[..], b"\n"].concat()).unwrap().positions, CORNERS, "bytes behind it");
        let error = read_bytes(&bytes[..100]).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
    }

    #[test]
    fn attributes_of_triangles_are_colours_as_their_programs_write_them() {
        let all = [CORNERS; 3].concat();
        let with = |header: &[u8], attributes: [u16; 3]| {
            let mut bytes = binary(header, &all);
            for (record, attribute) in bytes[HEADER..].chunks_exact_mut(RECORD).zip(attributes) {
                record[48..].copy_from_slice(&attribute.to_le_bytes());
            }
            bytes
        };
        let (plain, blue, red) = (plain(), Vec4::new(0.0, 0.0, 1.0, 1.0), Vec4::new(1.0, 0.0, 0.0, 1.0));
        let (header, black) = (linear_color([1, 2, 3]).extend(1.0), Vec4::new(0.0, 0.0, 0.0, 1.0));
        let magics = b"a program COLOR=\x01\x02\x03\xff";
        let cases: [(&[u8], [u16; 3], [Vec4; 3]); 5] = [
            (b"", [0, 0x801f, 0xfc00], [plain, blue, red]),
            (magics, [0x001f, 0x7c00, 0xffff], [red, blue, header]),
            (magics, [0x801f, 0xfc00, 0x8000], [red, blue, header]),
            (magics, [0, 0, 0x001f], [black, black, red]),
            (magics, [0, 0, 0], [header, header, header]),
        ];
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.stl");
        for (name, attributes, expected) in cases {
            let bytes = with(name, attributes);
            let mesh = read_bytes(&bytes).unwrap();
            assert_eq!(mesh.colors, expected.map(|color| [color; 3]).concat(), "{attributes:x?}");
            assert_eq!(mesh.materials[0].base_color, Vec4::ONE);
            std::fs::write(&path, bytes).unwrap();
            let mut large = StlTriangles::open(&path).unwrap().unwrap();
            assert_eq!(
                (large.colors(), large.frame().materials.clone()),
                (SourceColors::Bytes, mesh.materials.clone())
            );
            let mut pieces = 0;
            let mut each = |piece: &Mesh| {
                pieces += 1;
                piece.colors == mesh.colors || panic!("{:?}", piece.colors)
            };
            large.for_each(&mut each).unwrap();
            assert_eq!(pieces, 1);
        }
        // Without the bit of VisCAM they are something else.
        let mesh = read_bytes(&with(b"", [1, 2, 3])).unwrap();
        assert_eq!((mesh.colors.len(), mesh.materials), (0, Mesh::new("").materials));
    }

    #[test]
    fn a_count_beyond_the_file_is_told_before_memory_is_asked_for() {
        let mut bytes = binary(b"", &CORNERS);
        bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
        assert!(read_bytes(&bytes).is_err());
        bytes[80..84].copy_from_slice(&1_000_000u32.to_le_bytes());
        let error = read_bytes(&bytes).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
    }

    #[test]
    fn what_is_not_finite_or_not_whole_is_an_error_with_its_byte() {
        let mut bytes = binary(b"", &CORNERS);
        bytes[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
        assert_eq!(read_bytes(&bytes).unwrap_err().offset, Some(84));
        for text in [
            "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet",
            "solid\nvertex 0 0 0\nvertex 1 0 nan\nvertex 0 1 0",
            "solid\nvertex 0 0 0\nvertex 1 0",
            "solid\nendsolid",
            "solid",
            "",
        ] {
            let error = read_bytes(text.as_bytes()).unwrap_err();
            assert!(error.offset.is_some_and(|offset| offset <= text.len() as u64), "{text}: {error}");
        }
    }
}
