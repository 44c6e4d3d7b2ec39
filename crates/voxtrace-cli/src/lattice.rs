//! What is done to the instances of a scene before it is written: straightened, baked into the lattice of voxels, made one grid.

use crate::failure::Failure;
use crate::report::Report;
use voxtrace::Scene;
use voxtrace::bake::{self, BakeError};
use voxtrace::import::Limits;
use voxtrace::straighten::straighten;
use voxtrace_bench::quantity::counted;

/// What to say where something does not stand on the lattice.
pub const OFF_LATTICE_HINT: &str = "--bake samples what is turned or scaled anew, --straighten drops the tilt of a scan; \
     .vxt, .glb, .obj and .ply hold any scene";

/// Options about instances, for what is written.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
#[command(next_help_heading = "Instances")]
pub struct LatticeArgs {
    /// Turn what is tilted, as oblique scans are, to the nearest quarter turn; no voxel is sampled anew
    #[arg(long)]
    straighten: bool,
    /// Sample what is turned, scaled or between voxels anew on the lattice, for formats of whole voxels
    #[arg(long)]
    bake: bool,
    /// Make one grid of all that is visible
    #[arg(long)]
    flatten: bool,
}

impl LatticeArgs {
    /// Whether anything is to be done, for which the scene must be in memory.
    pub fn is_asked(self) -> bool {
        self.straighten || self.bake || self.flatten
    }

    /// Does it.
    pub fn apply(self, scene: &mut Scene, limits: &Limits, report: &Report) -> Result<(), Failure> {
        if self.straighten {
            let count = straighten(scene);
            report.remark(&format!("{} straightened", counted(count as u64, "instance")));
        }
        if self.bake {
            let baked = bake::bake(scene, limits).map_err(|error| bake_failure(scene, &error))?;
            report.remark(&format!("{} sampled anew", counted(baked.instances as u64, "instance")));
            if baked.stilled > 0 {
                report.remark(&format!("{} of them moved, and stand still now", baked.stilled));
            }
        }
        if self.flatten {
            bake::flatten(scene).map_err(|error| bake_failure(scene, &error))?;
        }
        Ok(())
    }
}

fn bake_failure(scene: &Scene, error: &BakeError) -> Failure {
    let failure = Failure::input(format!("{}: {error}", scene.name));
    match error {
        BakeError::OffLattice { .. } => failure.hint(OFF_LATTICE_HINT),
        BakeError::TooLarge { .. } => failure.hint("--trusted lifts the limit"),
        _ => failure,
    }
}
