//! Indices (appendices A.2 and A.3): triangles by the edges and vertices that were met last, and sequences as differences.

/// First bytes: a kind and a version.
const TRIANGLES: u8 = 0xe0;
const SEQUENCE: u8 = 0xd0;
/// Bytes at the end: of triangles a table of codes.
const TABLE: usize = 16;
const SEQUENCE_TAIL: usize = 4;
const SHORT: &str = "indices that end too early";

struct Data<'a> {
    bytes: std::slice::Iter<'a, u8>,
}

impl Data<'_> {
    fn byte(&mut self) -> Result<u8, &'static str> {
        self.bytes.next().copied().ok_or(SHORT)
    }

    /// A number in up to five bytes, seven bits in each, the lowest first.
    fn number(&mut self) -> Result<u32, &'static str> {
        let mut number = 0;
        for shift in (0..35).step_by(7) {
            let byte = self.byte()?;
            number |= u32::from(byte & 0x7f).wrapping_shl(shift);
            if byte < 0x80 {
                return Ok(number);
            }
        }
        Err("an index of more than five bytes")
    }

    /// An index by its difference from another.
    fn index_from(&mut self, last: u32) -> Result<u32, &'static str> {
        Ok(last.wrapping_add(signed(self.number()?)))
    }
}

/// Signs are in the lowest bit.
fn signed(number: u32) -> u32 {
    (number & 1).wrapping_neg() ^ (number >> 1)
}

/// The last sixteen of something.
struct Recent<T> {
    items: [T; 16],
    next: usize,
}

impl<T: Copy> Recent<T> {
    fn new(item: T) -> Self {
        Self { items: [item; 16], next: 0 }
    }

    fn push(&mut self, item: T) {
        self.items[self.next & 15] = item;
        self.next += 1;
    }

    /// The one that was pushed so many before the last one.
    fn before_last(&self, steps: usize) -> T {
        self.items[self.next.wrapping_sub(1 + steps) & 15]
    }
}

/// The corners of triangles, `count` in all.
pub(super) fn triangles(packed: &[u8], count: usize) -> Result<Vec<u32>, &'static str> {
    let version = packed.first().ok_or(SHORT)?.wrapping_sub(TRIANGLES);
    if version > 1 {
        return Err("triangles without their header");
    }
    let end = packed.len().checked_sub(TABLE).ok_or(SHORT)?;
    let (head, table) = packed.split_at(end);
    let codes = head.get(1..1 + count / 3).ok_or(SHORT)?;
    let mut data = Data { bytes: head[1 + codes.len()..].iter() };
    // Beyond these, the third corner is stored by itself.
    let last_known = if version == 1 { 13 } else { 15 };
    let (mut edges, mut vertices) = (Recent::new([u32::MAX; 2]), Recent::new(u32::MAX));
    let (mut next, mut last) = (0u32, 0u32);
    let fresh = |next: &mut u32| {
        let index = *next;
        *next = next.wrapping_add(1);
        index
    };
    let mut corners = Vec::with_capacity(count);
    for &code in codes {
        let (high, low) = (usize::from(code >> 4), code & 15);
        if high < 15 {
            // An edge of a triangle before, and a new corner.
            let [a, b] = edges.before_last(high);
            let c = match low {
                0 => fresh(&mut next),
                low if low < last_known => vertices.before_last(low.into()),
                15 => data.index_from(last)?,
                // One before or behind the last one that was stored.
                low => last.wrapping_add_signed(i32::from(low) - i32::from(low ^ 3)),
            };
            if low >= last_known {
                last = c;
            }
            corners.extend([a, b, c]);
            if low == 0 || low >= last_known {
                vertices.push(c);
            }
            edges.push([c, b]);
            edges.push([a, c]);
            continue;
        }
        let is_common = low < 14;
        let others = if is_common { table[usize::from(low)] } else { data.byte()? };
        let kinds = [if low == 15 { 15 } else { 0 }, others >> 4, others & 15];
        if !is_common && others == 0 {
            next = 0;
        }
        let mut triangle = [0; 3];
        // The first corner counts as pushed already.
        for (place, (corner, kind)) in triangle.iter_mut().zip(kinds).enumerate() {
            *corner = match kind {
                0 => fresh(&mut next),
                15 if !is_common => 0,
                kind if place > 0 => vertices.items[vertices.next.wrapping_sub(kind.into()) & 15],
                _ => 0,
            };
        }
        if !is_common {
            for (corner, _) in triangle.iter_mut().zip(kinds).filter(|(_, kind)| *kind == 15) {
                last = data.index_from(last)?;
                *corner = last;
            }
        }
        let [a, b, c] = triangle;
        corners.extend(triangle);
        for (place, (corner, kind)) in triangle.into_iter().zip(kinds).enumerate() {
            if place == 0 || kind == 0 || kind == 15 && !is_common {
                vertices.push(corner);
            }
        }
        edges.push([b, a]);
        edges.push([c, b]);
        edges.push([a, c]);
    }
    Ok(corners)
}

/// Indices that are no triangles.
pub(super) fn sequence(packed: &[u8], count: usize) -> Result<Vec<u32>, &'static str> {
    if packed.first().is_none_or(|&first| first.wrapping_sub(SEQUENCE) > 1) {
        return Err("indices without their header");
    }
    let end = packed.len().checked_sub(SEQUENCE_TAIL).filter(|&end| end > count).ok_or(SHORT)?;
    let mut data = Data { bytes: packed[1..end].iter() };
    // Two indices are followed at a time.
    let mut last = [0u32; 2];
    let mut index = || {
        let number = data.number()?;
        let last = &mut last[(number & 1) as usize];
        *last = last.wrapping_add(signed(number >> 1));
        Ok(*last)
    };
    (0..count).map(|_| index()).collect()
}
