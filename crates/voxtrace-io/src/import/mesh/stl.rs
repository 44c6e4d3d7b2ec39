//! STL, the format of triangles alone, as text and as binary (3D Systems, "StereoLithography Interface Specification", 1988).

use crate::import::reader::{Geometry, Kind, LargeContent, Reader, Recognition};
use crate::import::source::input::Input;
use glam::Vec3;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::mesh::source::{SourceColors, TriangleSource};
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
    let head = head.trim_ascii_start();
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
    Ok(head.trim_ascii_start().starts_with(b"solid") && !fits && !head.contains(&0))
}

fn read_binary(input: &mut Input, limits: &Limits, mesh: &mut Mesh) -> Result<(), ImportError> {
    let mut left = announced(input, limits)?;
    if input.remaining().is_some() {
        mesh.positions.reserve_exact(left * 3);
    }
    while left > 0 {
        let now = left.min(CHUNK);
        take_triangles(input, now, mesh)?;
        left -= now;
    }
    Ok(())
}

/// Takes the header of a binary file and says how many triangles it announces, which are there.
fn announced(input: &mut Input, limits: &Limits) -> Result<usize, ImportError> {
    let path = input.path();
    let head = input.take(HEADER, "the header of a binary STL file")?;
    let count = u32::from_le_bytes([head[80], head[81], head[82], head[83]]);
    if u64::from(count) * 3 > limits.points {
        return Err(ImportError::limit(path, Some(80), "corners", u64::from(count) * 3, limits.points));
    }
    if input.remaining().is_some_and(|remaining| remaining < u64::from(count) * RECORD as u64) {
        let end = input.offset() + input.remaining().unwrap_or(0);
        return Err(ImportError::truncated(path, end, format!("the {count} triangles that the header announces")));
    }
    Ok(count as usize)
}

/// Takes triangles of a binary file.
fn take_triangles(input: &mut Input, count: usize, mesh: &mut Mesh) -> Result<(), ImportError> {
    let (path, start) = (input.path(), input.offset());
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
    }
    Ok(())
}

/// The triangles of a binary STL file larger than memory.
struct StlTriangles {
    path: PathBuf,
    count: usize,
    frame: Mesh,
}

impl StlTriangles {
    /// Opens a file, if it is a binary one.
    pub fn open(path: &Path) -> Result<Option<Self>, ImportError> {
        let mut input = Input::open(path, &UNBOUNDED)?;
        if input.remaining().is_none() || is_text(&mut input)? {
            return Ok(None);
        }
        let count = announced(&mut input, &UNBOUNDED)?;
        Ok((count > 0).then(|| Self { path: path.into(), count, frame: Mesh::new("") }))
    }

    /// Bytes that the mesh would take in memory.
    pub fn size_bytes(&self) -> u64 {
        self.count as u64 * 36
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
        SourceColors::None
    }

    fn has_uvs(&self) -> bool {
        false
    }

    fn release(&mut self) {}

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let mut input = Input::open(&self.path, &UNBOUNDED)?;
        let mut left = announced(&mut input, &UNBOUNDED)?;
        let mut piece = self.frame.clone();
        while left > 0 {
            let now = left.min(8 * CHUNK);
            piece.clear();
            take_triangles(&mut input, now, &mut piece)?;
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
