//! The volume as DICOM: several frames in one file, in each way in which frames and pixels are written, and as a series.

use super::{ORIGIN, SIZE, SPACING, values};
use flate2::{Compression, write::DeflateEncoder};
use std::io::Write;

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Explicit, little endian; places and sizes in functional groups of no stated length.
    Groups,
    /// Implicit, little endian; frames at offsets from the first.
    Dose,
    BigEndian,
    RunLengths,
    Deflated,
    /// Implicit, little endian; places and sizes in functional groups of stated lengths.
    Lengths,
}

impl Kind {
    fn syntax(self) -> &'static str {
        match self {
            Self::Groups => "1.2.840.10008.1.2.1",
            Self::Dose | Self::Lengths => "1.2.840.10008.1.2",
            Self::BigEndian => "1.2.840.10008.1.2.2",
            Self::RunLengths => "1.2.840.10008.1.2.5",
            Self::Deflated => "1.2.840.10008.1.2.1.99",
        }
    }
}

/// Elements one after the other.
struct Writer {
    bytes: Vec<u8>,
    is_explicit: bool,
    big_endian: bool,
}

impl Writer {
    fn short(&mut self, value: u16) {
        self.bytes.extend(if self.big_endian { value.to_be_bytes() } else { value.to_le_bytes() });
    }

    fn long(&mut self, value: u32) {
        self.bytes.extend(if self.big_endian { value.to_be_bytes() } else { value.to_le_bytes() });
    }

    fn tag(&mut self, tag: u32) {
        self.short((tag >> 16) as u16);
        self.short(tag as u16);
    }

    fn head(&mut self, tag: u32, kind: &str, length: u32) {
        self.tag(tag);
        if !self.is_explicit {
            self.long(length);
            return;
        }
        self.bytes.extend(kind.as_bytes());
        if ["OB", "OW", "SQ", "UN"].contains(&kind) {
            self.short(0);
            self.long(length);
        } else {
            self.short(length as u16);
        }
    }

    fn text(&mut self, tag: u32, kind: &str, text: &str) {
        let padding = if kind == "UI" { '\0' } else { ' ' };
        let text = if text.len() % 2 == 1 { format!("{text}{padding}") } else { text.into() };
        self.head(tag, kind, text.len() as u32);
        self.bytes.extend(text.into_bytes());
    }

    fn number(&mut self, tag: u32, value: u16) {
        self.head(tag, "US", 2);
        self.short(value);
    }

    /// A sequence of no stated length; each item writes itself.
    fn sequence(&mut self, tag: u32, items: usize, mut write: impl FnMut(&mut Self, usize)) {
        self.head(tag, "SQ", u32::MAX);
        for item in 0..items {
            self.tag(0xfffe_e000);
            self.long(u32::MAX);
            write(self, item);
            self.tag(0xfffe_e00d);
            self.long(0);
        }
        self.tag(0xfffe_e0dd);
        self.long(0);
    }

    /// A sequence of one item, both of stated lengths.
    fn item(&mut self, tag: u32, write: impl FnOnce(&mut Self)) {
        let mut inner = Self { bytes: Vec::new(), ..*self };
        write(&mut inner);
        self.items(tag, vec![inner.bytes]);
    }

    /// A sequence of stated length with these items.
    fn items(&mut self, tag: u32, items: Vec<Vec<u8>>) {
        let length: usize = items.iter().map(|item| 8 + item.len()).sum();
        self.head(tag, "SQ", length as u32);
        for item in items {
            self.tag(0xfffe_e000);
            self.long(item.len() as u32);
            self.bytes.extend(item);
        }
    }

    fn pixel_head(&mut self, frames: usize, slope: bool) {
        self.number(0x0028_0002, 1);
        self.text(0x0028_0004, "CS", "MONOCHROME2");
        if frames > 1 {
            self.text(0x0028_0008, "IS", &frames.to_string());
        }
        self.number(0x0028_0010, SIZE[1] as u16);
        self.number(0x0028_0011, SIZE[0] as u16);
        self.text(0x0028_0030, "DS", &format!("{}\\{}", SPACING[1], SPACING[0]));
        self.number(0x0028_0100, 16);
        self.number(0x0028_0101, 16);
        self.number(0x0028_0102, 15);
        self.number(0x0028_0103, u16::from(!slope));
        if slope {
            self.text(0x0028_1052, "DS", "-1024");
            self.text(0x0028_1053, "DS", "0.5");
        }
    }
}

/// Preamble and group 2.
fn start(syntax: &str) -> Vec<u8> {
    let mut bytes = vec![0; 128];
    bytes.extend(b"DICM");
    let mut writer = Writer { bytes, is_explicit: true, big_endian: false };
    writer.text(0x0002_0010, "UI", syntax);
    writer.bytes
}

fn place(z: f64) -> String {
    format!("{}\\{}\\{}", ORIGIN[0], ORIGIN[1], ORIGIN[2] + z * SPACING[2])
}

/// All frames in one file.
pub fn file(kind: Kind) -> Vec<u8> {
    let is_explicit = !matches!(kind, Kind::Dose | Kind::Lengths);
    let big_endian = kind == Kind::BigEndian;
    let mut writer = Writer { bytes: Vec::new(), is_explicit, big_endian };
    writer.text(0x0008_0060, "CS", "CT");
    // A sequence that says nothing about pixels, with tags that look as if it did.
    writer.sequence(0x0008_1140, 1, |writer, _| writer.text(0x0020_0032, "DS", "1\\2\\3"));
    if kind == Kind::Dose {
        writer.text(0x0020_0032, "DS", &place(0.0));
        writer.text(0x0020_0037, "DS", "1\\0\\0\\0\\1\\0");
    }
    writer.pixel_head(SIZE[2], kind == Kind::BigEndian);
    if kind == Kind::Dose {
        let offsets: Vec<String> = (0..SIZE[2]).map(|z| (z as f64 * SPACING[2]).to_string()).collect();
        writer.text(0x3004_000c, "DS", &offsets.join("\\"));
    } else if kind == Kind::Lengths {
        writer.item(0x5200_9229, |writer| {
            writer.item(0x0020_9116, |writer| writer.text(0x0020_0037, "DS", "1\\0\\0\\0\\1\\0"));
        });
        let frames = (0..SIZE[2]).map(|z| {
            let mut frame = Writer { bytes: Vec::new(), is_explicit, big_endian };
            frame.item(0x0020_9113, |writer| writer.text(0x0020_0032, "DS", &place(z as f64)));
            frame.bytes
        });
        writer.items(0x5200_9230, frames.collect());
    } else {
        writer.sequence(0x5200_9229, 1, |writer, _| {
            writer.sequence(0x0020_9116, 1, |writer, _| writer.text(0x0020_0037, "DS", "1\\0\\0\\0\\1\\0"));
        });
        writer.sequence(0x5200_9230, SIZE[2], |writer, z| {
            writer.sequence(0x0020_9113, 1, |writer, _| writer.text(0x0020_0032, "DS", &place(z as f64)));
        });
    }
    match kind {
        Kind::RunLengths => {
            writer.head(0x7fe0_0010, "OB", u32::MAX);
            writer.tag(0xfffe_e000);
            writer.long(0);
            for frame in values().chunks(SIZE[0] * SIZE[1]) {
                let packed = run_lengths(frame);
                writer.tag(0xfffe_e000);
                writer.long(packed.len() as u32);
                writer.bytes.extend(packed);
            }
            writer.tag(0xfffe_e0dd);
            writer.long(0);
        }
        _ => {
            writer.head(0x7fe0_0010, "OW", (2 * values().len()) as u32);
            for value in values() {
                // The big-endian file is rescaled: by a half, less 1024.
                writer.short(if kind == Kind::BigEndian { ((value + 1024) * 2) as u16 } else { value as u16 });
            }
        }
    }
    let mut bytes = start(kind.syntax());
    if kind == Kind::Deflated {
        let mut encoder = DeflateEncoder::new(bytes, Compression::default());
        encoder.write_all(&writer.bytes).unwrap();
        return encoder.finish().unwrap();
    }
    bytes.extend(writer.bytes);
    bytes
}

/// Two segments: the high bytes and the low bytes, as runs where four are alike.
fn run_lengths(frame: &[i16]) -> Vec<u8> {
    let segment = |byte: usize| {
        let plane: Vec<u8> = frame.iter().map(|value| value.to_be_bytes()[byte]).collect();
        let mut packed = Vec::new();
        for bytes in plane.chunks(4) {
            if bytes.iter().all(|byte| *byte == bytes[0]) {
                packed.extend([(257 - bytes.len()) as u8, bytes[0]]);
            } else {
                packed.push((bytes.len() - 1) as u8);
                packed.extend(bytes);
            }
        }
        packed
    };
    let (high, low) = (segment(0), segment(1));
    let mut packed = vec![0; 64];
    packed[0] = 2;
    packed[4] = 64;
    packed[8..12].copy_from_slice(&(64 + high.len() as u32).to_le_bytes());
    packed.extend(high);
    packed.extend(low);
    packed
}

/// One file of a series.
pub fn slice(series: &str, number: u16, z: usize) -> Vec<u8> {
    let mut writer = Writer { bytes: start("1.2.840.10008.1.2.1"), is_explicit: true, big_endian: false };
    writer.text(0x0008_0060, "CS", "CT");
    writer.text(0x0008_103e, "LO", "a lump");
    writer.text(0x0020_000e, "UI", series);
    writer.text(0x0020_0011, "IS", &number.to_string());
    // Numbers run against the places.
    writer.text(0x0020_0013, "IS", &(100 - z).to_string());
    writer.text(0x0020_0032, "DS", &place(z as f64));
    writer.text(0x0020_0037, "DS", "1\\0\\0\\0\\1\\0");
    writer.pixel_head(1, false);
    let size = SIZE[0] * SIZE[1];
    writer.head(0x7fe0_0010, "OW", (2 * size) as u32);
    for value in &values()[z * size..(z + 1) * size] {
        writer.short(*value as u16);
    }
    writer.bytes
}
