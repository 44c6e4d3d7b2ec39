//! Huffman codes and the bits that they are made of (ITU-T T.81, annexes C and F).

/// Huffman codes: of each length the first code, the number of its value, and how many there are (T.81, annex C).
pub(super) struct Codes {
    pub lengths: [(u32, usize, u32); 16],
    pub values: Vec<u8>,
}

pub(super) fn huffman_codes(mut segment: &[u8], tables: &mut [[Option<Codes>; 4]; 2]) -> Result<(), String> {
    while let Some((&head, rest)) = segment.split_first() {
        let counts: [u8; 16] = *rest.first_chunk().ok_or("a short table of codes")?;
        let count: usize = counts.iter().map(|&count| usize::from(count)).sum();
        let values = rest.get(16..16 + count).ok_or("a short table of codes")?;
        let (mut code, mut first) = (0u32, 0);
        let lengths = counts.map(|count| {
            code <<= 1;
            let length = (code, first, count.into());
            code += u32::from(count);
            first += usize::from(count);
            length
        });
        let table = tables.get_mut(usize::from(head >> 4)).and_then(|tables| tables.get_mut(usize::from(head & 15)));
        *table.ok_or("a fifth table of codes")? = Some(Codes { lengths, values: values.to_vec() });
        segment = &rest[16 + count..];
    }
    Ok(())
}

/// Bits, the highest first; a zero byte behind a byte of ones is stuffing.
pub(super) struct Bits<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
    pub waiting: u64,
    pub count: u32,
}

impl Bits<'_> {
    pub fn take(&mut self, count: u32) -> Result<u32, String> {
        while self.count < count {
            let byte = match self.bytes.get(self.at..) {
                Some([0xff, 0, ..]) => {
                    self.at += 2;
                    0xff
                }
                // A marker, or the end.
                Some([0xff, ..] | []) | None => return Err("the samples end too early".into()),
                Some(&[byte, ..]) => {
                    self.at += 1;
                    byte
                }
            };
            self.waiting = self.waiting << 8 | u64::from(byte);
            self.count += 8;
        }
        self.count -= count;
        Ok((self.waiting >> self.count & ((1 << count) - 1)) as u32)
    }

    /// A value by its code.
    pub fn value(&mut self, codes: &Codes) -> Result<u8, String> {
        let mut code = 0;
        for &(first, number, count) in &codes.lengths {
            code = code << 1 | self.take(1)?;
            if code >= first && code - first < count {
                return Ok(codes.values[number + (code - first) as usize]);
            }
        }
        Err("a code that is none".into())
    }

    /// A number of so many bits; its first bit is 0 where it is negative.
    pub fn signed(&mut self, size: u32) -> Result<i32, String> {
        if size == 0 {
            return Ok(0);
        }
        if size > 16 {
            return Err("a coefficient that is too large".into());
        }
        let bits = self.take(size)? as i32;
        Ok(if bits >> (size - 1) == 0 { bits - (1 << size) + 1 } else { bits })
    }

    /// Goes on behind the next restart marker.
    pub fn restart(&mut self) -> Result<(), String> {
        (self.waiting, self.count) = (0, 0);
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let marker = rest.windows(2).position(|pair| pair[0] == 0xff && (0xd0..=0xd7).contains(&pair[1]));
        self.at += marker.ok_or("a restart that is missing")? + 2;
        Ok(())
    }
}
