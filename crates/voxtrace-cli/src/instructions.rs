//! The option that names the vector instructions of the CPU.

use crate::failure::Failure;
use voxtrace::Instructions;

/// [`Instructions`] as an option.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum InstructionsArg {
    /// x86-64 with AVX-512 F, DQ, BW and VL
    Avx512,
    /// x86-64 with AVX2 and BMI
    Avx2,
    /// 64-bit ARM
    Neon,
    /// Arrays of sixteen, in whatever registers every processor has
    Portable,
    /// Ray after ray
    Scalar,
}

impl InstructionsArg {
    /// Lets everything of this process trace with them.
    pub fn force(self) -> Result<(), Failure> {
        let instructions = match self {
            Self::Avx512 => Instructions::Avx512,
            Self::Avx2 => Instructions::Avx2,
            Self::Neon => Instructions::Neon,
            Self::Portable => Instructions::Portable,
            Self::Scalar => Instructions::Scalar,
        };
        if instructions.force() {
            return Ok(());
        }
        let name = instructions.name();
        let hint = "leave --instructions (or VOXTRACE_INSTRUCTIONS) out: those that it is fastest with are used then";
        Err(Failure::usage(format!("this processor has no {name}")).hint(hint))
    }
}
