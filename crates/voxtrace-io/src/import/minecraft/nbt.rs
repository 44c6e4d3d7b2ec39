//! Named binary tags, the tree that all Minecraft files are made of (wiki.vg, "NBT"; big-endian, in files of the Bedrock edition little-endian). Subtrees that say nothing
//! about blocks are skipped, so that memory goes to blocks alone.

use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, Limits};

/// Bytes of an array that are read at once: a count that lies costs no more than this.
const PIECE: usize = 1 << 20;

/// Names of subtrees that say nothing about blocks. Some hold much, and whatever players put into chests.
const SKIPPED: [&str; 29] = [
    "Biomes",
    "BiomeData",
    "BiomePalette",
    "BlockEntities",
    "BlockLight",
    "CarvingMasks",
    "Entities",
    "Heightmaps",
    "Lights",
    "LiquidTicks",
    "LiquidsToBeTicked",
    "Metadata",
    "PendingBlockTicks",
    "PendingFluidTicks",
    "PostProcessing",
    "SkyLight",
    "Structures",
    "TileEntities",
    "TileTicks",
    "ToBeTicked",
    "biomes",
    "block_entities",
    "block_position_data",
    "block_ticks",
    "blending_data",
    "entities",
    "fluid_ticks",
    "nbt",
    "structures",
];

/// The name under which the number of entities that were skipped stands.
const ENTITIES: &str = "Entities";

/// A tag's value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Tag {
    /// Any whole number.
    Whole(i64),
    /// Any number with a point; none says anything about blocks.
    Real,
    Bytes(Vec<u8>),
    Text(String),
    List(Vec<Tag>),
    Compound(Compound),
    /// An array, or a list of such numbers.
    Ints(Vec<i32>),
    Longs(Vec<u64>),
}

/// Named tags.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Compound(Vec<(String, Tag)>);

impl Compound {
    #[cfg(test)]
    pub fn of(entries: Vec<(String, Tag)>) -> Self {
        Self(entries)
    }

    /// All entries in the order of the file.
    pub fn entries(&self) -> impl Iterator<Item = (&str, &Tag)> {
        self.0.iter().map(|(name, tag)| (name.as_str(), tag))
    }

    pub fn get(&self, name: &str) -> Option<&Tag> {
        self.entries().find(|(other, _)| *other == name).map(|(_, tag)| tag)
    }

    pub fn whole(&self, name: &str) -> Option<i64> {
        match self.get(name)? {
            Tag::Whole(value) => Some(*value),
            _ => None,
        }
    }

    pub fn bytes(&self, name: &str) -> Option<&[u8]> {
        match self.get(name)? {
            Tag::Bytes(bytes) => Some(bytes),
            _ => None,
        }
    }

    pub fn longs(&self, name: &str) -> Option<&[u64]> {
        match self.get(name)? {
            Tag::Longs(longs) => Some(longs),
            _ => None,
        }
    }

    pub fn ints(&self, name: &str) -> Option<&[i32]> {
        match self.get(name)? {
            Tag::Ints(ints) => Some(ints),
            _ => None,
        }
    }

    pub fn text(&self, name: &str) -> Option<&str> {
        match self.get(name)? {
            Tag::Text(text) => Some(text),
            _ => None,
        }
    }

    pub fn compound(&self, name: &str) -> Option<&Compound> {
        match self.get(name)? {
            Tag::Compound(compound) => Some(compound),
            _ => None,
        }
    }

    /// Entities that were skipped, of this compound and those within.
    pub fn entities(&self) -> u64 {
        let own = self.0.iter().map(|(name, tag)| match tag {
            Tag::Whole(count) if name == ENTITIES => (*count).max(0) as u64,
            Tag::Compound(inner) => inner.entities(),
            _ => 0,
        });
        own.sum()
    }

    pub fn list(&self, name: &str) -> Option<&[Tag]> {
        match self.get(name)? {
            Tag::List(list) => Some(list),
            _ => None,
        }
    }
}

/// Which byte of a number comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// The highest, as in the Java edition.
    Big,
    /// The lowest, as in the Bedrock edition.
    Little,
}

/// Reads a file's root, a named compound. What stands after it is left.
pub(super) fn read(input: &mut Input, limits: &Limits) -> Result<Compound, ImportError> {
    read_in(Order::Big, input, limits)
}

/// As [`read`], in an order of bytes.
pub(super) fn read_in(order: Order, input: &mut Input, limits: &Limits) -> Result<Compound, ImportError> {
    let mut reader = Reader { input, items: 0, limits, order };
    if reader.bytes::<1>()? != [10] {
        return Err(reader.malformed("the file does not begin with a compound of tags"));
    }
    reader.text()?;
    reader.compound(1)
}

struct Reader<'r, 'i> {
    input: &'r mut Input<'i>,
    items: u64,
    limits: &'r Limits,
    order: Order,
}

impl Order {
    /// The bytes of a number, the highest first.
    fn highest_first<const N: usize>(self, mut bytes: [u8; N]) -> [u8; N] {
        if self == Self::Little {
            bytes.reverse();
        }
        bytes
    }
}

impl Reader<'_, '_> {
    fn malformed(&self, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.input.path(), self.input.offset(), what)
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ImportError> {
        let bytes = self.input.take(N, "a tag")?;
        Ok(self.order.highest_first(std::array::from_fn(|n| bytes[n])))
    }

    fn text(&mut self) -> Result<String, ImportError> {
        let length = u16::from_be_bytes(self.bytes()?);
        Ok(String::from_utf8_lossy(self.input.take(length.into(), "a text")?).into_owned())
    }

    /// The number of elements of an array or a list.
    fn count(&mut self) -> Result<u64, ImportError> {
        let count = i32::from_be_bytes(self.bytes()?);
        u64::try_from(count).map_err(|_| self.malformed(format!("an array of {count} elements")))
    }

    /// The elements of an array, `N` bytes each.
    fn array<const N: usize, T>(&mut self, of: impl Fn([u8; N]) -> T) -> Result<Vec<T>, ImportError> {
        let mut left = self.count()?;
        let (path, offset, order) = (self.input.path(), self.input.offset(), self.order);
        if left * N as u64 > self.limits.bytes {
            return Err(ImportError::limit(path, Some(offset), "bytes", left * N as u64, self.limits.bytes));
        }
        let mut values = Vec::new();
        while left > 0 {
            let now = left.min((PIECE / N) as u64) as usize;
            let bytes = self.input.take(now * N, "an array")?;
            let refused = |_| ImportError::io(path, std::io::ErrorKind::OutOfMemory.into());
            values.try_reserve(now).map_err(refused)?;
            values.extend(bytes.as_chunks::<N>().0.iter().map(|&bytes| of(order.highest_first(bytes))));
            left -= now as u64;
        }
        Ok(values)
    }

    fn compound(&mut self, depth: u32) -> Result<Compound, ImportError> {
        let mut entries = Vec::new();
        loop {
            let [kind] = self.bytes()?;
            if kind == 0 {
                return Ok(Compound(entries));
            }
            let name = self.text()?;
            if kind == 9 && matches!(name.as_str(), "Entities" | "entities") {
                // Their number stands for them.
                let mut count = 0;
                self.skip_list(depth, |_| count += 1)?;
                entries.push((ENTITIES.to_owned(), Tag::Whole(count)));
            } else if SKIPPED.contains(&name.as_str()) {
                self.skip(kind, depth)?;
            } else {
                let tag = self.tag(kind, depth)?;
                entries.push((name, tag));
            }
        }
    }

    /// Refuses what nests too deeply; recursion ends here.
    fn deeper(&self, depth: u32) -> Result<u32, ImportError> {
        if depth >= self.limits.depth {
            let (path, offset) = (self.input.path(), Some(self.input.offset()));
            let most = u64::from(self.limits.depth);
            return Err(ImportError::limit(path, offset, "depth of nested tags", most + 1, most));
        }
        Ok(depth + 1)
    }

    fn tag(&mut self, kind: u8, depth: u32) -> Result<Tag, ImportError> {
        self.items += 1;
        if self.items > self.limits.items {
            let (path, offset) = (self.input.path(), Some(self.input.offset()));
            return Err(ImportError::limit(path, offset, "tags", self.items, self.limits.items));
        }
        Ok(match kind {
            1 => Tag::Whole(i8::from_be_bytes(self.bytes()?).into()),
            2 => Tag::Whole(i16::from_be_bytes(self.bytes()?).into()),
            3 => Tag::Whole(i32::from_be_bytes(self.bytes()?).into()),
            4 => Tag::Whole(i64::from_be_bytes(self.bytes()?)),
            5 | 6 => {
                self.skip(kind, depth)?;
                Tag::Real
            }
            7 => Tag::Bytes(self.array(|[byte]| byte)?),
            8 => Tag::Text(self.text()?),
            9 => {
                let depth = self.deeper(depth)?;
                let [kind] = self.bytes()?;
                if kind == 3 {
                    return Ok(Tag::Ints(self.array(i32::from_be_bytes)?));
                }
                let count = self.count()?;
                // A list of nothing may say that it is of kind 0, and takes no bytes however many there are.
                let count = if kind == 0 { 0 } else { count };
                let mut list = Vec::new();
                for _ in 0..count {
                    list.push(self.tag(kind, depth)?);
                }
                Tag::List(list)
            }
            10 => Tag::Compound({
                let depth = self.deeper(depth)?;
                self.compound(depth)?
            }),
            11 => Tag::Ints(self.array(i32::from_be_bytes)?),
            12 => Tag::Longs(self.array(u64::from_be_bytes)?),
            kind => return Err(self.malformed(format!("a tag of the unknown kind {kind}"))),
        })
    }

    /// Goes over a list, and calls `each` after each of its elements.
    fn skip_list(&mut self, depth: u32, mut each: impl FnMut(u64)) -> Result<(), ImportError> {
        let depth = self.deeper(depth)?;
        let [kind] = self.bytes()?;
        let count = self.count()?;
        for index in 0..if kind == 0 { 0 } else { count } {
            self.skip(kind, depth)?;
            each(index);
        }
        Ok(())
    }

    fn skip(&mut self, kind: u8, depth: u32) -> Result<(), ImportError> {
        let bytes = match kind {
            1 => 1,
            2 => 2,
            3 | 5 => 4,
            4 | 6 => 8,
            7 => self.count()?,
            8 => u16::from_be_bytes(self.bytes()?).into(),
            9 => {
                self.skip_list(depth, |_| ())?;
                0
            }
            10 => {
                let depth = self.deeper(depth)?;
                loop {
                    let [kind] = self.bytes()?;
                    if kind == 0 {
                        break 0;
                    }
                    let name = u16::from_be_bytes(self.bytes()?);
                    self.input.skip(name.into(), "a name")?;
                    self.skip(kind, depth)?;
                }
            }
            11 => 4 * self.count()?,
            12 => 8 * self.count()?,
            kind => return Err(self.malformed(format!("a tag of the unknown kind {kind}"))),
        };
        self.input.skip(bytes, "a tag")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn parsed(bytes: &[u8]) -> Result<Compound, ImportError> {
        let limits = Limits::default();
        read(&mut Input::of_bytes(bytes, Path::new("a.nbt"), &limits).unwrap(), &limits)
    }

    /// A root around the bytes of its entries.
    fn root(entries: &[u8]) -> Vec<u8> {
        [b"\x0a\0\0", entries, b"\0"].concat()
    }

    #[test]
    fn every_kind_of_tag_is_read() {
        let entries = [
            &b"\x01\0\x01b\xfe"[..],
            b"\x02\0\x01s\x80\x00",
            b"\x04\0\x01l\x7f\0\0\0\0\0\0\x01",
            b"\x05\0\x01f\0\0\0\0\x06\0\x01d\0\0\0\0\0\0\0\0",
            b"\x07\0\x01a\0\0\0\x02\x05\xff",
            b"\x08\0\x01t\0\x03abc",
            b"\x09\0\x01L\x03\0\0\0\x02\0\0\0\x01\xff\xff\xff\xff",
            b"\x09\0\x01e\0\x7f\xff\xff\xff",
            b"\x0c\0\x01q\0\0\0\x01\x80\0\0\0\0\0\0\0",
            b"\x0b\0\x01i\0\0\0\x01\0\0\0\x09",
        ];
        let found = parsed(&root(&entries.concat())).unwrap();
        assert_eq!(
            (found.whole("b"), found.whole("s"), found.whole("l")),
            (Some(-2), Some(-32768), Some(0x7f << 56 | 1))
        );
        assert_eq!((found.bytes("a"), found.text("t")), (Some(&[5, 255][..]), Some("abc")));
        assert_eq!(found.ints("L"), Some(&[1, -1][..]));
        assert_eq!((found.list("e"), found.longs("q")), (Some(&[][..]), Some(&[1 << 63][..])));
        assert_eq!((found.get("i"), found.get("f")), (Some(&Tag::Ints(vec![9])), Some(&Tag::Real)));
        assert_eq!((found.whole("t"), found.get("nothing")), (None, None));
    }

    #[test]
    fn tags_of_the_bedrock_edition_have_their_lowest_byte_first() {
        let bytes = b"\x0a\0\0\x02\x01\0s\x02\x01\x0b\x01\0i\x01\0\0\0\x09\0\0\0\x08\x01\0t\x02\0ab\0";
        let limits = Limits::default();
        let mut input = Input::of_bytes(bytes, Path::new("a.mcstructure"), &limits).unwrap();
        let found = read_in(Order::Little, &mut input, &limits).unwrap();
        assert_eq!((found.whole("s"), found.ints("i"), found.text("t")), (Some(0x102), Some(&[9][..]), Some("ab")));
    }

    #[test]
    fn what_says_nothing_about_blocks_is_skipped_whatever_it_holds() {
        let inner = b"\x0a\0\x01x\x07\0\x01a\0\0\0\x02\x05\xff\x09\0\x01L\x0b\0\0\0\x01\0\0\0\x01\0\0\0\0\0";
        let entries = [b"\x0a\0\x08Entities", &inner[..], b"\0\x01\0\x05after\x07"].concat();
        let found = parsed(&root(&entries)).unwrap();
        assert_eq!((found.entries().count(), found.whole("after")), (1, Some(7)));
    }

    #[test]
    fn nests_that_are_too_deep_are_refused_in_lists_compounds_and_what_is_skipped() {
        for depth in [60, 5_000_000] {
            let lists = [&b"\x09\0\x01n"[..], &b"\x09\0\0\0\x01".repeat(depth), b"\x01\0\0\0\0"].concat();
            let compounds = [b"\x0a\0\x01n".repeat(depth), vec![0; depth]].concat();
            let skipped = [&b"\x0a\0\x08Entities"[..], &compounds, b"\0"].concat();
            for entries in [lists, compounds, skipped] {
                let result = parsed(&root(&entries));
                match result {
                    Ok(_) => assert_eq!(depth, 60),
                    Err(error) => assert!(depth > 60 && error.to_string().contains("depth"), "{error}"),
                }
            }
        }
    }

    #[test]
    fn counts_that_lie_cost_nothing() {
        for kind in [7, 9, 11, 12] {
            let count = if kind == 9 { &b"\x0a\x7f\xff\xff\xff"[..] } else { b"\x7f\xff\xff\xff" };
            let entries = [&[kind, 0, 1, b'n'][..], count, &[0; 3_000_000]].concat();
            assert!(parsed(&root(&entries)).is_err(), "{kind}");
        }
        assert!(parsed(&root(b"\x07\0\x01n\xff\xff\xff\xff")).unwrap_err().to_string().contains("-1 elements"));
        assert!(parsed(&root(b"\x0d\0\x01n")).unwrap_err().to_string().contains("unknown kind 13"));
        assert!(parsed(b"\x08\0\0").is_err() && parsed(b"").is_err());
    }
}
