//! The marker segments of JPEG and its kin (ITU-T T.81, annex B).

/// Marker segments one after the other.
pub(super) struct Markers<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Markers<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    /// The byte that says which marker comes next.
    pub fn marker(&mut self) -> Result<u8, String> {
        if self.bytes.get(self.at) != Some(&0xff) {
            return Err("a marker is missing".into());
        }
        while self.bytes.get(self.at) == Some(&0xff) {
            self.at += 1;
        }
        let marker = *self.bytes.get(self.at).ok_or("the picture ends too early")?;
        self.at += 1;
        Ok(marker)
    }

    /// What a segment holds behind its length.
    pub fn segment(&mut self) -> Result<&'a [u8], String> {
        let rest = self.rest();
        let length = rest.first_chunk().map(|&length| usize::from(u16::from_be_bytes(length)));
        let segment = length.and_then(|length| rest.get(2..length)).ok_or("a segment goes beyond the picture")?;
        self.at += segment.len() + 2;
        Ok(segment)
    }

    /// Everything behind the last segment.
    pub fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Leaves so many bytes out.
    pub fn skip(&mut self, count: usize) {
        self.at = self.bytes.len().min(self.at + count);
    }
}

/// Whether a JPEG says that its colours are a brightness and two differences from it, by the segment of Adobe (T.872, 6.5.3).
pub(super) fn says_ycc(bytes: &[u8]) -> bool {
    const START: u8 = 0xd8;
    const ADOBE: u8 = 0xee;
    const SCAN: u8 = 0xda;
    let mut markers = Markers::new(bytes);
    while let Ok(marker) = markers.marker() {
        match marker {
            START => continue,
            SCAN => return false,
            _ => {}
        }
        match markers.segment() {
            Ok([b'A', b'd', b'o', b'b', b'e', _, _, _, _, _, _, transform]) if marker == ADOBE => {
                return *transform == 1;
            }
            Ok(_) => {}
            Err(_) => return false,
        }
    }
    false
}

/// The number in two bytes, the high one first.
pub(super) fn word(high: u8, low: u8) -> usize {
    u16::from_be_bytes([high, low]).into()
}
