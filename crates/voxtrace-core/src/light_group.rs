//! Light groups: the light of the sun, of the sky and of emitters apart, for compositing. A frame of one group follows the same paths as
//! one of all light, with the same random numbers, and gathers that light alone: the samples of the groups add up to those of the whole.

use std::borrow::Cow;
use voxtrace_scene::sky::Sky;

/// Whose light a frame gathers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum LightGroup {
    /// All light: the picture.
    #[default]
    All = 0,
    /// The sun's disc. A sun that is part of an environment map belongs to the sky.
    Sun = 1,
    /// The sky without its sun.
    Sky = 2,
    /// Emissive materials.
    Emitters = 3,
}

impl LightGroup {
    /// The groups that add up to all light.
    pub const PARTS: [Self; 3] = [Self::Sun, Self::Sky, Self::Emitters];

    /// Name of its layer in pictures.
    pub fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Sun => "sun",
            Self::Sky => "sky",
            Self::Emitters => "emitters",
        }
    }

    /// Whether the light of `part` is gathered.
    pub fn has(self, part: Self) -> bool {
        self == Self::All || self == part
    }

    /// The sky whose light is gathered: black where it is not the sky's.
    pub(crate) fn sky(self, sky: &Sky) -> Cow<'_, Sky> {
        if self.has(Self::Sky) { Cow::Borrowed(sky) } else { Cow::Owned(sky.clone().with_brightness(0.0)) }
    }
}
