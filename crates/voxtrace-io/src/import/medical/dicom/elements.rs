//! Data elements of a DICOM file (PS3.5, section 7, and PS3.10, section 7): tags with values, nested in sequences. What is
//! not used is gone over, so that a file costs no more memory than its pixels.

use super::syntax::Syntax;
use super::tag;
use super::values::Elements;
use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, Limits};

/// Longest value that is kept.
const LONGEST_VALUE: u32 = 1 << 20;
/// The length of what ends with a delimiter.
const UNDEFINED: u32 = u32::MAX;
/// Bytes taken at once of pixels.
const PIECE: u64 = 1 << 20;

/// The pixels as they are in the file.
#[derive(Clone, Debug)]
pub(super) enum Pixels {
    /// Passed over, or not there.
    Absent,
    /// All frames, one after the other; `tag` says of which kind, and `are_words` whether bytes are turned in pairs in big endian.
    Plain { tag: u32, bytes: Vec<u8>, are_words: bool },
    /// A table of offsets and pieces of compressed data.
    Pieces(Vec<Vec<u8>>),
}

/// The elements of a file.
#[derive(Clone, Debug)]
pub(super) struct File {
    pub syntax: Syntax,
    pub main: Elements,
    /// What holds for all frames, and for each alone (PS3.3, C.7.6.16).
    pub shared: Elements,
    pub frames: Vec<Elements>,
    pub pixels: Pixels,
    /// Planes of overlays: drawings over the pixels (PS3.3, C.9).
    pub overlays: u32,
    /// Where the pixels begin.
    pub pixels_at: u64,
    /// Files that a directory of a medium names, each by its folders and its own name.
    pub referenced: Vec<Vec<String>>,
}

/// Whose elements are read.
#[derive(Clone, Copy, PartialEq)]
enum Owner {
    Main,
    Shared,
    Frame(usize),
    /// A record of a directory of a medium.
    Record,
    Nobody,
}

struct Reader<'i, 'a> {
    input: &'i mut Input<'a>,
    file: File,
    is_explicit: bool,
    big_endian: bool,
    wants_pixels: bool,
    has_met_pixels: bool,
    limits: Limits,
}

/// Tag, and length where the value does not end with a delimiter; whether it is a sequence.
struct Head {
    tag: u32,
    length: u32,
    is_sequence: bool,
    is_unknown: bool,
    is_words: bool,
}

impl File {
    /// Reads a file's elements; without pixels it ends before them.
    pub fn read(mut input: Input, limits: &Limits, wants_pixels: bool) -> Result<Self, ImportError> {
        let path = input.path();
        let head = input.peek(132)?;
        let has_preamble = head.len() == 132 && head.ends_with(b"DICM");
        // Files older than the preamble begin with group 8, in either byte order.
        let is_turned = matches!(head, [0, 8, 0, 0..=0x1f, ..]);
        if !has_preamble && !is_turned && !matches!(head, [8, 0, 0..=0x1f, 0, ..]) {
            return Err(ImportError::malformed(path, 0, "the file does not begin as DICOM does"));
        }
        let mut meta = Elements::default();
        let syntax = if has_preamble {
            input.skip(132, "the preamble")?;
            let named = read_meta(&mut input, limits, &mut meta)?;
            // Some writers name a syntax with kinds of values and then write none.
            let is_other = named.is_explicit && !named.big_endian && !named.is_deflated && !has_kind(&mut input)?;
            Syntax { is_explicit: named.is_explicit && !is_other, ..named }
        } else {
            let syntax = if is_turned || has_kind(&mut input)? { Syntax::EXPLICIT } else { Syntax::IMPLICIT };
            Syntax { big_endian: is_turned, ..syntax }
        };
        if syntax.is_deflated {
            input = crate::import::source::inflate::inflate(input, limits);
        }
        let file = Self {
            syntax,
            main: Elements { big_endian: syntax.big_endian, ..Elements::default() },
            shared: Elements { big_endian: syntax.big_endian, ..Elements::default() },
            frames: Vec::new(),
            pixels: Pixels::Absent,
            overlays: 0,
            pixels_at: 0,
            referenced: Vec::new(),
        };
        let mut reader = Reader::new(&mut input, file, wants_pixels, limits);
        reader.elements(None, Owner::Main, limits.depth)?;
        let mut file = reader.file;
        if file.pixels_at == 0 {
            file.pixels_at = input.offset();
        }
        Ok(file)
    }

    /// A value of a frame: its own, or what holds for all.
    pub fn of_frame<T>(&self, frame: usize, get: impl Fn(&Elements) -> Option<T>) -> Option<T> {
        let own = self.frames.get(frame).and_then(&get);
        own.or_else(|| get(&self.shared)).or_else(|| get(&self.main))
    }
}

/// Whether the next element names its kind of value.
fn has_kind(input: &mut Input) -> Result<bool, ImportError> {
    let head = input.peek(6)?;
    Ok(head.len() < 6 || head[4..].iter().all(u8::is_ascii_uppercase))
}

/// Reads group 2, which says how the rest is written.
fn read_meta(input: &mut Input, limits: &Limits, meta: &mut Elements) -> Result<Syntax, ImportError> {
    let file = File {
        syntax: Syntax::EXPLICIT,
        main: std::mem::take(meta),
        shared: Elements::default(),
        frames: Vec::new(),
        pixels: Pixels::Absent,
        overlays: 0,
        pixels_at: 0,
        referenced: Vec::new(),
    };
    let mut reader = Reader::new(input, file, false, limits);
    while reader.input.peek(2)? == [2, 0] {
        let head = reader.head()?;
        reader.value(&head, Owner::Main, limits.depth)?;
    }
    *meta = reader.file.main;
    let offset = input.offset();
    let name = meta.text(tag::TRANSFER_SYNTAX).unwrap_or(Syntax::NAME_OF_IMPLICIT);
    Syntax::named(name).map_err(|what| super::unsupported(input.path(), offset, what))
}

impl<'i, 'a> Reader<'i, 'a> {
    fn new(input: &'i mut Input<'a>, file: File, wants_pixels: bool, limits: &Limits) -> Self {
        let Syntax { is_explicit, big_endian, .. } = file.syntax;
        Self { input, file, is_explicit, big_endian, wants_pixels, has_met_pixels: false, limits: *limits }
    }

    fn malformed(&self, what: &str) -> ImportError {
        ImportError::malformed(self.input.path(), self.input.offset(), what)
    }

    fn short(&mut self) -> Result<u16, ImportError> {
        let bytes = self.input.take(2, "a data element")?;
        let bytes = [bytes[0], bytes[1]];
        Ok(if self.big_endian { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) })
    }

    fn long(&mut self) -> Result<u32, ImportError> {
        let bytes = self.input.take(4, "a data element")?;
        let bytes = [bytes[0], bytes[1], bytes[2], bytes[3]];
        Ok(if self.big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    }

    fn tag(&mut self) -> Result<u32, ImportError> {
        Ok(u32::from(self.short()?) << 16 | u32::from(self.short()?))
    }

    fn head(&mut self) -> Result<Head, ImportError> {
        let tag = self.tag()?;
        if matches!(tag, tag::ITEM | tag::ITEM_END | tag::SEQUENCE_END) || !self.is_explicit {
            let length = self.long()?;
            // Without kinds of values a sequence of a stated length is told by its tag alone.
            let is_group = matches!(tag, tag::SHARED_GROUPS | tag::FRAME_GROUPS) || tag::PLACE_GROUPS.contains(&tag);
            let is_sequence = is_group || length == UNDEFINED && tag != tag::PIXELS;
            return Ok(Head { tag, length, is_sequence, is_unknown: false, is_words: true });
        }
        let kind = self.input.take(2, "a data element")?;
        let kind = [kind[0], kind[1]];
        if !kind.iter().all(u8::is_ascii_uppercase) {
            return Err(self.malformed("a data element without a kind of value"));
        }
        let length = match &kind {
            b"OB" | b"OD" | b"OF" | b"OL" | b"OV" | b"OW" | b"SQ" | b"SV" | b"UC" | b"UN" | b"UR" | b"UT" | b"UV" => {
                self.short()?;
                self.long()?
            }
            _ => self.short()?.into(),
        };
        let is_unknown = &kind == b"UN";
        let is_sequence = &kind == b"SQ" || length == UNDEFINED && tag != tag::PIXELS;
        Ok(Head { tag, length, is_sequence, is_unknown, is_words: &kind == b"OW" })
    }

    /// Reads elements up to `end`, or where there is none to a delimiter, or in the file itself to its end.
    fn elements(&mut self, end: Option<u64>, owner: Owner, depth: u32) -> Result<(), ImportError> {
        let is_file = owner == Owner::Main;
        while !self.has_met_pixels && end.is_none_or(|end| self.input.offset() < end) {
            if is_file && self.input.peek(1)?.is_empty() {
                break;
            }
            let head = self.head()?;
            if head.tag == tag::ITEM_END && !is_file {
                break;
            }
            self.value(&head, owner, depth)?;
        }
        Ok(())
    }

    fn value(&mut self, head: &Head, owner: Owner, depth: u32) -> Result<(), ImportError> {
        let is_pixels = matches!(head.tag, tag::PIXELS | tag::FLOAT_PIXELS | tag::DOUBLE_PIXELS);
        if is_pixels && owner == Owner::Main {
            return self.pixels(head);
        }
        if head.is_sequence {
            return self.sequence(head, owner, depth);
        }
        if head.length == UNDEFINED {
            // Those of an icon, which end with a delimiter too (PS3.5, A.4).
            return self.skip_pieces();
        }
        let is_overlay = owner == Owner::Main && head.tag & 0xff01_ffff == 0x6000_3000;
        self.file.overlays += u32::from(is_overlay);
        let is_kept = owner != Owner::Nobody && tag::WANTED.contains(&head.tag) && head.length <= LONGEST_VALUE;
        if !is_kept {
            return self.input.skip(head.length.into(), "the value of a data element");
        }
        let value = self.input.take(head.length as usize, "the value of a data element")?.to_vec();
        let elements = match owner {
            Owner::Main => &mut self.file.main,
            Owner::Shared => &mut self.file.shared,
            Owner::Frame(frame) => match self.file.frames.get_mut(frame) {
                Some(elements) => elements,
                None => return Ok(()),
            },
            Owner::Record => return self.reference(&value),
            Owner::Nobody => return Ok(()),
        };
        elements.values.entry(head.tag).or_insert(value);
        Ok(())
    }

    fn sequence(&mut self, head: &Head, owner: Owner, depth: u32) -> Result<(), ImportError> {
        let Some(depth) = depth.checked_sub(1) else {
            let (path, at) = (self.input.path(), Some(self.input.offset()));
            return Err(ImportError::limit(path, at, "nesting", self.limits.depth.into(), self.limits.depth.into()));
        };
        // Only the groups of frames matter, and in them everything.
        let inner = match (owner, head.tag) {
            (Owner::Main, tag::SHARED_GROUPS) => Owner::Shared,
            (Owner::Main, tag::FRAME_GROUPS) => Owner::Frame(0),
            (Owner::Main, tag::DIRECTORY_RECORDS) => Owner::Record,
            (Owner::Record, _) => Owner::Nobody,
            (Owner::Main | Owner::Nobody, _) => Owner::Nobody,
            (owner, _) => owner,
        };
        let is_list = owner == Owner::Main && head.tag == tag::FRAME_GROUPS;
        if inner == Owner::Nobody && head.length != UNDEFINED {
            return self.input.skip(head.length.into(), "a sequence");
        }
        let was_explicit = self.is_explicit;
        // What a program did not know it wrote in the default syntax (PS3.5, 6.2.2).
        self.is_explicit &= !head.is_unknown;
        let end = (head.length != UNDEFINED).then(|| self.input.offset() + u64::from(head.length));
        while end.is_none_or(|end| self.input.offset() < end) {
            let item = self.tag()?;
            let length = self.long()?;
            match item {
                tag::SEQUENCE_END => break,
                tag::ITEM => {}
                _ => return Err(self.malformed("a sequence with something other than items")),
            }
            let inner = if is_list { Owner::Frame(self.new_frame()?) } else { inner };
            let end = (length != UNDEFINED).then(|| self.input.offset() + u64::from(length));
            self.elements(end, inner, depth)?;
        }
        self.is_explicit = was_explicit;
        Ok(())
    }

    /// Notes a file that a record names: parts of its path, between backslashes (PS3.3, F.3.2.2).
    fn reference(&mut self, value: &[u8]) -> Result<(), ImportError> {
        let count = self.file.referenced.len() as u64;
        if count >= self.limits.items {
            let (path, at) = (self.input.path(), Some(self.input.offset()));
            return Err(ImportError::limit(path, at, "files of the directory", count + 1, self.limits.items));
        }
        let parts = String::from_utf8_lossy(value);
        let parts = parts.split('\\').map(|part| part.trim_matches(['\0', ' ']).to_owned());
        self.file.referenced.push(parts.filter(|part| !part.is_empty()).collect());
        Ok(())
    }

    fn new_frame(&mut self) -> Result<usize, ImportError> {
        let count = self.file.frames.len();
        if count as u64 >= self.limits.items {
            let (path, at) = (self.input.path(), Some(self.input.offset()));
            return Err(ImportError::limit(path, at, "frames", count as u64 + 1, self.limits.items));
        }
        self.file.frames.push(Elements { big_endian: self.big_endian, ..Elements::default() });
        Ok(count)
    }

    fn pixels(&mut self, head: &Head) -> Result<(), ImportError> {
        self.has_met_pixels = true;
        self.file.pixels_at = self.input.offset();
        if !self.wants_pixels {
            return Ok(());
        }
        if head.length != UNDEFINED {
            let bytes = self.bytes(head.length.into())?;
            self.file.pixels = Pixels::Plain { tag: head.tag, bytes, are_words: head.is_words };
            return Ok(());
        }
        let mut pieces = Vec::new();
        while let Some(length) = self.piece()? {
            pieces.push(self.bytes(length.into())?);
        }
        self.file.pixels = Pixels::Pieces(pieces);
        Ok(())
    }

    /// The length of the next piece of compressed pixels; `None` behind the last.
    fn piece(&mut self) -> Result<Option<u32>, ImportError> {
        let item = self.tag()?;
        let length = self.long()?;
        match item {
            tag::SEQUENCE_END => Ok(None),
            tag::ITEM if length != UNDEFINED => Ok(Some(length)),
            _ => Err(self.malformed("compressed pixels with something other than items")),
        }
    }

    fn skip_pieces(&mut self) -> Result<(), ImportError> {
        while let Some(length) = self.piece()? {
            self.input.skip(length.into(), "a piece of compressed pixels")?;
        }
        Ok(())
    }

    /// Bytes of pixels, asked for as they come.
    fn bytes(&mut self, length: u64) -> Result<Vec<u8>, ImportError> {
        if let Some(remaining) = self.input.remaining().filter(|&remaining| remaining < length) {
            let end = self.input.offset() + remaining;
            return Err(ImportError::truncated(
                self.input.path(),
                end,
                format!("its pixels, which take {length} bytes"),
            ));
        }
        let mut bytes = Vec::with_capacity(if self.input.remaining().is_some() { length as usize } else { 0 });
        while (bytes.len() as u64) < length {
            let now = (length - bytes.len() as u64).min(PIECE) as usize;
            bytes.extend_from_slice(self.input.take(now, "its pixels")?);
        }
        Ok(bytes)
    }
}
