//! How often a path may be scattered in each way, beside its bounces in all: by matte surfaces, by reflection, through glass, within media
//! (as in Blender's Cycles, and as MagicaVoxel's `_bounce` has it).

/// Bits that the count of one kind takes.
const BITS: u32 = 8;

/// Most bounces of each kind; 255, the default, is no limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BounceLimits {
    /// By matte surfaces, with their coats.
    pub diffuse: u8,
    /// By metals, and by glass that reflects.
    pub glossy: u8,
    /// Through glass: each boundary that refracts counts.
    pub transmitted: u8,
    /// Within media.
    pub volume: u8,
}

/// How a bounce scattered a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(crate) enum BounceKind {
    /// By a matte surface.
    Diffuse = 0,
    /// By reflection.
    Glossy = 1,
    /// Through a boundary that refracts.
    Transmitted = 2,
    /// Within a medium.
    Volume = 3,
}

impl BounceLimits {
    /// No limit of a kind.
    pub const UNLIMITED: u8 = u8::MAX;

    /// All four as one number, diffuse lowest.
    pub fn to_bits(self) -> u32 {
        u32::from_le_bytes([self.diffuse, self.glossy, self.transmitted, self.volume])
    }

    /// The reverse of [`Self::to_bits`].
    pub fn from_bits(bits: u32) -> Self {
        let [diffuse, glossy, transmitted, volume] = bits.to_le_bytes();
        Self { diffuse, glossy, transmitted, volume }
    }

    /// Whether a path with these `counts` of bounces may not be scattered in this way any more.
    #[inline]
    pub(crate) fn is_reached(limits: u32, counts: u32, kind: BounceKind) -> bool {
        let place = BITS * kind as u32;
        let limit = limits >> place & 255;
        limit < 255 && counts >> place & 255 >= limit
    }

    /// `counts` with one bounce more. Kinds without a limit are not counted: their number may be large.
    #[inline]
    pub(crate) fn counted(limits: u32, counts: u32, kind: BounceKind) -> u32 {
        let place = BITS * kind as u32;
        if limits >> place & 255 < 255 { counts + (1 << place) } else { counts }
    }
}

impl Default for BounceLimits {
    fn default() -> Self {
        Self::from_bits(u32::MAX)
    }
}
