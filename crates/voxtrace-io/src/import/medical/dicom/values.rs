//! Values of a DICOM file by tag: text, numbers as text, and words (PS3.5, section 6.2).

use std::collections::BTreeMap;

/// Values by tag, as bytes of the file.
#[derive(Clone, Debug, Default)]
pub(super) struct Elements {
    pub(super) values: BTreeMap<u32, Vec<u8>>,
    pub(super) big_endian: bool,
}

impl Elements {
    /// A value as text, without the padding.
    pub fn text(&self, tag: u32) -> Option<&str> {
        let text = std::str::from_utf8(self.values.get(&tag)?).ok()?;
        Some(text.trim_matches(['\0', ' ']))
    }

    /// Numbers written as text, up to the first that is none.
    pub fn decimals(&self, tag: u32) -> Option<Vec<f64>> {
        let numbers = self.text(tag)?.split('\\').map_while(|word| word.trim().parse::<f64>().ok());
        Some(numbers.filter(|number| number.is_finite()).collect())
    }

    /// The first number written as text.
    pub fn decimal(&self, tag: u32) -> Option<f64> {
        self.decimals(tag)?.first().copied()
    }

    /// A number of 16 bits.
    pub fn short(&self, tag: u32) -> Option<u16> {
        self.shorts(tag)?.first().copied()
    }

    /// Numbers of 16 bits.
    pub fn shorts(&self, tag: u32) -> Option<Vec<u16>> {
        let number = |&bytes| if self.big_endian { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) };
        Some(self.values.get(&tag)?.as_chunks().0.iter().map(number).collect())
    }

    /// A value as it is in the file.
    pub fn bytes(&self, tag: u32) -> Option<&[u8]> {
        self.values.get(&tag).map(Vec::as_slice)
    }
}
