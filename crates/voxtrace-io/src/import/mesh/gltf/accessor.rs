//! Accessors: arrays of vectors within buffers, interleaved, normalized or sparse (glTF 2.0, section 3.6.2).

use super::Fault;
use super::buffers::{Buffers, Part};
use super::document::{Accessor, Document};
use super::file_part::Window;
use std::borrow::Cow;
use voxtrace_voxelize::Limits;

const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// Reads accessors of a document.
pub(super) struct Accessors<'a> {
    pub document: &'a Document,
    pub buffers: &'a Buffers<'a>,
    pub limits: &'a Limits,
}

impl<'a> Accessors<'a> {
    fn accessor(&self, index: usize) -> Result<&'a Accessor, Fault> {
        let accessor = self.document.accessors.get(index);
        let accessor = accessor.ok_or_else(|| Fault::malformed(format!("accessor {index} is missing")))?;
        if accessor.count as u64 > self.limits.points {
            return Err(Fault::limit("items of an accessor", accessor.count as u64, self.limits.points));
        }
        Ok(accessor)
    }

    /// An accessor, which must be of one of `kinds`.
    pub fn of_kinds(&self, index: usize, kinds: &[&str]) -> Result<&'a Accessor, Fault> {
        let accessor = self.accessor(index)?;
        if !kinds.contains(&accessor.kind.as_str()) {
            return Err(Fault::malformed(format!(
                "accessor {index} holds {}, not {}",
                accessor.kind,
                kinds.join(" or ")
            )));
        }
        Ok(accessor)
    }

    /// Calls `each` with every vector, filled up with `missing` to four numbers. The accessor must be of one of `kinds`.
    pub fn vectors(
        &self,
        index: usize,
        kinds: &[&str],
        missing: f32,
        mut each: impl FnMut([f32; 4]),
    ) -> Result<usize, Fault> {
        let accessor = self.of_kinds(index, kinds)?;
        let width =
            width_of(&accessor.kind).ok_or_else(|| Fault::malformed(format!("accessor {index} has no type")))?;
        let read = |element: &[u8], kind: u32| -> Result<[f32; 4], Fault> {
            let mut vector = [missing; 4];
            let size = size_of_component(kind)?;
            for (value, bytes) in vector.iter_mut().zip(element.chunks_exact(size)).take(width) {
                *value = component(bytes, kind, accessor.normalized);
            }
            Ok(vector)
        };
        let kind = accessor.component_type;
        let zero = { [0.0, 0.0, 0.0, missing] };
        let mut replaced = self.sparse(index, accessor, width)?;
        let mut elements = self.elements(index, accessor, width)?;
        for item in 0..accessor.count {
            if let Some(element) = replaced.as_mut().and_then(|replaced| replaced.next_at(item)) {
                each(read(element, kind)?);
                continue;
            }
            match &mut elements {
                Some(elements) => each(read(elements.at(item)?, kind)?),
                None => each(zero),
            }
        }
        Ok(accessor.count)
    }

    /// The first `most` matrices of an accessor, column by column.
    pub fn matrices(&self, index: usize, most: usize) -> Result<Vec<[f32; 16]>, Fault> {
        let accessor = self.of_kinds(index, &["MAT4"])?;
        if accessor.component_type != FLOAT {
            return Err(Fault::malformed(format!("accessor {index} holds matrices that are no floats")));
        }
        let mut replaced = self.sparse(index, accessor, 16)?;
        let mut elements = self.elements(index, accessor, 16)?;
        let matrix = |item: usize| -> Result<[f32; 16], Fault> {
            let own = replaced.as_mut().and_then(|replaced| replaced.next_at(item));
            let element = match (own, &mut elements) {
                (Some(own), _) => Some(own),
                (None, Some(elements)) => Some(elements.at(item)?),
                (None, None) => None,
            };
            let number = |n: usize| element.map_or(0.0, |bytes| component(&bytes[4 * n..], FLOAT, false));
            Ok(std::array::from_fn(number))
        };
        (0..accessor.count.min(most)).map(matrix).collect()
    }

    /// The whole numbers of an accessor of scalars.
    pub fn indices(&self, index: usize) -> Result<Vec<u32>, Fault> {
        let mut indices = Vec::new();
        self.each_index(index, |number| {
            indices.push(number);
            Ok(())
        })?;
        Ok(indices)
    }

    /// Calls `each` with every whole number of an accessor of scalars.
    pub fn each_index(&self, index: usize, mut each: impl FnMut(u32) -> Result<(), Fault>) -> Result<(), Fault> {
        let accessor = self.accessor(index)?;
        let kind = accessor.component_type;
        if accessor.kind != "SCALAR" || !is_whole(kind) {
            return Err(Fault::malformed(format!("accessor {index} holds no indices")));
        }
        if accessor.sparse.is_some() {
            return Err(Fault::unsupported("sparse indices"));
        }
        let elements = self.elements(index, accessor, 1)?;
        let mut elements = elements.ok_or_else(|| Fault::malformed(format!("accessor {index} has no buffer view")))?;
        (0..accessor.count).try_for_each(|item| each(whole(elements.at(item)?, kind)))
    }

    /// The elements of an accessor, `None` where they are all zero.
    fn elements(&self, index: usize, accessor: &Accessor, width: usize) -> Result<Option<Elements<'a>>, Fault> {
        let Some(view) = accessor.buffer_view else {
            // Zeros cost no bytes of the file: they are not to become gigabytes.
            if accessor.count as u64 > self.limits.items {
                return Err(Fault::limit("zeros of an accessor", accessor.count as u64, self.limits.items));
            }
            return Ok(None);
        };
        let size = size_of_component(accessor.component_type)? * width;
        let (part, stride) = self.buffers.view(view)?;
        let stride = stride.unwrap_or(size);
        if stride < size {
            return Err(Fault::malformed(format!("accessor {index} has elements larger than their stride")));
        }
        Elements::new(&part, accessor.byte_offset, stride, size, accessor.count)
            .map(Some)
            .ok_or_else(|| Fault::malformed(format!("accessor {index} goes beyond its buffer view")))
    }

    /// Elements that replace others; `None` where it has none.
    fn sparse(&self, index: usize, accessor: &Accessor, width: usize) -> Result<Option<Replaced<'a>>, Fault> {
        let Some(sparse) = &accessor.sparse else { return Ok(None) };
        let fault = |what: &str| Fault::malformed(format!("the sparse part of accessor {index} {what}"));
        let kind = sparse.indices.component_type;
        if !is_whole(kind) || sparse.count > accessor.count {
            return Err(fault("is impossible"));
        }
        let of_view = |view: usize, offset: usize, size: usize| {
            let part = self.buffers.view(view)?.0;
            let part = size.checked_mul(sparse.count).and_then(|length| part.slice(offset, length));
            part.ok_or_else(|| fault("goes beyond its buffer view"))?.bytes()
        };
        let size = size_of_component(kind)?;
        let indices = of_view(sparse.indices.buffer_view, sparse.indices.byte_offset, size)?;
        let places: Vec<usize> = indices.chunks_exact(size).map(|bytes| whole(bytes, kind) as usize).collect();
        let size = size_of_component(accessor.component_type)? * width;
        let values = of_view(sparse.values.buffer_view, sparse.values.byte_offset, size)?;
        if !places.is_sorted_by(|a, b| a < b) || places.last().is_some_and(|&last| last >= accessor.count) {
            return Err(fault("has indices out of order"));
        }
        Ok(Some(Replaced { places, values, size, next: 0 }))
    }
}

/// Elements that replace others, which are taken in ascending order.
struct Replaced<'a> {
    places: Vec<usize>,
    values: Cow<'a, [u8]>,
    size: usize,
    next: usize,
}

impl Replaced<'_> {
    /// What stands in the place of an item, if the next one that is replaced is this.
    fn next_at(&mut self, item: usize) -> Option<&[u8]> {
        let at = self.next;
        self.places.get(at).filter(|&&place| place == item)?;
        self.next += 1;
        self.values.get(at * self.size..(at + 1) * self.size)
    }
}

/// Elements of one size at equal distances, which are taken in ascending order.
enum Elements<'a> {
    Memory { bytes: &'a [u8], stride: usize, size: usize },
    File(Window<'a>),
}

impl<'a> Elements<'a> {
    /// `None` where they go beyond the bytes.
    fn new(part: &Part<'a>, offset: usize, stride: usize, size: usize, count: usize) -> Option<Self> {
        let needed = match count {
            0 => 0,
            _ => stride.checked_mul(count - 1)?.checked_add(size)?,
        };
        Some(match part.slice(offset, needed)? {
            Part::Memory(bytes) => Self::Memory { bytes, stride, size },
            Part::File(part, range) => Self::File(Window::new(part, range.start, [stride, size, count])),
        })
    }

    #[inline]
    fn at(&mut self, item: usize) -> Result<&[u8], Fault> {
        match self {
            Self::Memory { bytes, stride, size } => {
                let start = item * *stride;
                Ok(&bytes[start..start + *size])
            }
            Self::File(window) => window.at(item),
        }
    }
}

pub(super) fn width_of(kind: &str) -> Option<usize> {
    Some(match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        _ => return None,
    })
}

/// Whether components of a kind can be indices.
pub(super) fn is_whole(kind: u32) -> bool {
    [UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT].contains(&kind)
}

pub(super) fn size_of_component(kind: u32) -> Result<usize, Fault> {
    match kind {
        BYTE | UNSIGNED_BYTE => Ok(1),
        SHORT | UNSIGNED_SHORT => Ok(2),
        UNSIGNED_INT | FLOAT => Ok(4),
        _ => Err(Fault::malformed(format!("the component type {kind} is unknown"))),
    }
}

pub(super) fn component(bytes: &[u8], kind: u32, is_normalized: bool) -> f32 {
    let value = match kind {
        BYTE => f32::from(bytes[0] as i8),
        UNSIGNED_BYTE => f32::from(bytes[0]),
        SHORT => f32::from(i16::from_le_bytes([bytes[0], bytes[1]])),
        UNSIGNED_SHORT => f32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        UNSIGNED_INT => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as f32,
        _ => f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    };
    if is_normalized { normalized(value, kind) } else { value }
}

/// A whole number of a kind of components as a share of the largest one; floats stay.
pub(super) fn normalized(value: f32, kind: u32) -> f32 {
    let full = match kind {
        BYTE => 127.0,
        UNSIGNED_BYTE => 255.0,
        SHORT => 32_767.0,
        UNSIGNED_SHORT => 65_535.0,
        UNSIGNED_INT => 4_294_967_295.0,
        _ => return value,
    };
    (value / full).max(-1.0)
}

pub(super) fn whole(bytes: &[u8], kind: u32) -> u32 {
    match kind {
        UNSIGNED_BYTE => bytes[0].into(),
        UNSIGNED_SHORT => u16::from_le_bytes([bytes[0], bytes[1]]).into(),
        _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
    }
}
