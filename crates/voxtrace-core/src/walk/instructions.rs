//! The vector instructions that batches of rays are traced with. All find the same hits, to the bit.

use std::sync::atomic::{AtomicUsize, Ordering};

/// Those that were forced, as a number in [`Instructions::ALL`].
static FORCED: AtomicUsize = AtomicUsize::new(usize::MAX);

/// A set of vector instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// AVX-512 F, DQ, BW and VL: sixteen rays a register, camera rays in packets.
    Avx512,
    /// AVX2 with BMI: sixteen rays in two registers.
    Avx2,
    /// NEON of 64-bit ARM: sixteen rays in four registers.
    Neon,
    /// SIMD128 of WebAssembly: sixteen rays in four registers.
    Simd128,
    /// Sixteen rays in arrays, in whatever registers every processor of this kind has: what the others are compared with.
    Portable,
    /// Ray after ray.
    Scalar,
}

impl Instructions {
    /// All of them, the widest first.
    pub const ALL: [Self; 6] = [Self::Avx512, Self::Avx2, Self::Neon, Self::Simd128, Self::Portable, Self::Scalar];

    /// The ones that this processor is fastest with.
    pub fn best() -> Self {
        // Arrays are slower than ray after ray (0.75 of it on SSE2), and NEON was not measured on a processor that has it.
        let quicker = [Self::Avx512, Self::Avx2, Self::Simd128].into_iter().find(|quicker| quicker.is_available());
        quicker.unwrap_or(Self::Scalar)
    }

    /// The ones that were forced, else [`Self::best`].
    pub fn chosen() -> Self {
        Self::ALL.get(FORCED.load(Ordering::Relaxed)).copied().unwrap_or_else(Self::best)
    }

    /// Lets all batches of this process use these, to test and to measure them. Where the processor has them not, nothing is changed, and the
    /// answer is false.
    pub fn force(self) -> bool {
        if self.is_available() {
            FORCED.store(Self::ALL.iter().position(|&all| all == self).unwrap_or(usize::MAX), Ordering::Relaxed);
        }
        self.is_available()
    }

    /// Whether this processor has them.
    pub fn is_available(self) -> bool {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.is_available()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("avx512vl")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => {
                is_x86_feature_detected!("avx2")
                    && is_x86_feature_detected!("fma")
                    && is_x86_feature_detected!("bmi1")
                    && is_x86_feature_detected!("bmi2")
                    && is_x86_feature_detected!("lzcnt")
                    && is_x86_feature_detected!("popcnt")
            }
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx512 | Self::Avx2 => false,
            Self::Neon => cfg!(target_arch = "aarch64"),
            Self::Simd128 => cfg!(target_feature = "simd128"),
            // Pages get a small module, without a second copy of the walk.
            Self::Portable => cfg!(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128"))),
            Self::Scalar => true,
        }
    }

    /// Its name, for reports and the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Avx512 => "AVX-512",
            Self::Avx2 => "AVX2",
            Self::Neon => "NEON",
            Self::Simd128 => "SIMD128",
            Self::Portable => "portable",
            Self::Scalar => "scalar",
        }
    }
}
