//! How much the probes try, and their version.

/// Version of the probes; it grows when what they find may differ from what older ones found.
pub const PROBE_VERSION: u32 = 1;

/// How much to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Below two seconds.
    Quick,
    /// All sizes.
    Full,
}

impl Effort {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }

    pub(super) fn pick<T>(self, quick: T, full: T) -> T {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}
