//! The option that names how light is computed.

use voxtrace::Integrator;

/// [`Integrator`] as an option.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum IntegratorArg {
    /// Path tracing with next-event estimation: for pictures
    Path,
    /// Path tracing by BSDF sampling alone, as in the study: for measuring
    Essay,
}

impl From<IntegratorArg> for Integrator {
    fn from(name: IntegratorArg) -> Self {
        match name {
            IntegratorArg::Path => Self::Path,
            IntegratorArg::Essay => Self::Essay,
        }
    }
}
