//! Options that choose the tracer.

use crate::cluster::ClusterTracer;
use crate::failure::Failure;
use crate::import::warn_of_needless;
use crate::parse;
use crate::report::Report;
use crate::session::trace_failure;
use std::sync::Arc;
use voxtrace::{PackedScene, Tracer};
use voxtrace_vulkan::{Primitive, Request, Traversal, choose_for};

/// What names the device where no option does.
pub const DEVICE_VARIABLE: &str = "VOXTRACE_DEVICE";

/// Options about the device and how it finds voxels.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Device")]
pub struct TracerArgs {
    /// How rays find voxels [default: walk on a GPU, cpu where there is none]
    #[arg(long, value_name = "NAME")]
    traversal: Option<TraversalArg>,
    /// What the acceleration structure holds, for the traversals query and pipeline [default: brick]
    #[arg(long, value_name = "NAME")]
    primitive: Option<PrimitiveArg>,
    /// Device by its number or a part of its name, as `voxtrace devices` lists them; several share the picture by their numbers, as 0,1 (or 0,1,cpu), or all GPUs by the word all
    #[arg(long, value_name = "DEVICE", env = DEVICE_VARIABLE, hide_env_values = true)]
    device: Option<String>,
    /// Relax the rules of rounding on the GPU: faster, but no longer bit for bit the CPU's picture
    #[arg(long)]
    fast: bool,
    /// Limit on GPU memory, for example 2GB; with --traversal walk larger scenes are traced page by page
    #[arg(long, value_name = "BYTES", value_parser = parse::bytes)]
    memory_budget: Option<u64>,
    /// Trace on the workers of a Dask cluster, for example tcp://scheduler:8786, by the Python package voxtrace with its extra `cluster` (docs/cluster.md)
    #[arg(long, value_name = "ADDRESS", conflicts_with_all = ["primitive", "fast", "memory_budget"])]
    cluster: Option<String>,
}

/// [`Traversal`] as an option.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum TraversalArg {
    /// Grid traversal on the CPU
    Cpu,
    /// Grid traversal in a compute shader
    Walk,
    /// Ray tracing hardware, by ray queries in a compute shader
    Query,
    /// Ray tracing hardware, by a ray tracing pipeline
    Pipeline,
}

impl From<TraversalArg> for Traversal {
    fn from(traversal: TraversalArg) -> Self {
        match traversal {
            TraversalArg::Cpu => Self::Cpu,
            TraversalArg::Walk => Self::Walk,
            TraversalArg::Query => Self::Query,
            TraversalArg::Pipeline => Self::Pipeline,
        }
    }
}

/// [`Primitive`] as an option.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum PrimitiveArg {
    /// A box around each voxel
    VoxelExact,
    /// A box around each voxel, with the study's approximate hits
    VoxelApprox,
    /// A box around each brick of 8x8x8 voxels
    Brick,
    /// A box around each instance
    Grid,
    /// Triangles of the visible faces
    Triangle,
}

impl TracerArgs {
    /// Opens the tracer with a scene, and says which one it is and why. Where the choice is ours and the scene is too large
    /// for the device, the CPU traces.
    pub fn open(&self, scene: &Arc<PackedScene>, report: &mut Report) -> Result<Box<dyn Tracer + Send>, Failure> {
        if let Some(address) = &self.cluster {
            let device = match self.traversal {
                Some(TraversalArg::Cpu) => "cpu",
                Some(_) => return Err(Failure::usage("with --cluster the only --traversal to choose is cpu")),
                None => self.device.as_deref().unwrap_or("auto"),
            };
            self.warn_of_needless(None, report);
            report.remark(&format!("tracing on the workers of {address}"));
            let mut tracer = ClusterTracer::new(address, device).map_err(trace_failure)?;
            tracer.set_scene(scene).map_err(trace_failure)?;
            return Ok(Box::new(tracer));
        }
        let choice = choose_for(&self.request(), scene).map_err(trace_failure)?;
        self.warn_of_needless(Some(choice.traversal), report);
        match &choice.warning {
            Some(warning) => report.warn(warning),
            None => report.remark(&choice.reason),
        }
        Ok(choice.tracer)
    }

    /// Says which options mean nothing to what traces, where that is known. What was not asked for by name may be another one on the next machine:
    /// there they are for the devices that it has.
    fn warn_of_needless(&self, traversal: Option<Traversal>, report: &Report) {
        if matches!(self.traversal, Some(TraversalArg::Cpu)) {
            // The variable is for all runs.
            let is_of_variable = self.device.as_deref() == std::env::var(DEVICE_VARIABLE).ok().as_deref();
            let asked = [
                (self.primitive.is_some(), "--primitive"),
                (self.device.is_some() && !is_of_variable, "--device"),
                (self.fast, "--fast"),
                (self.memory_budget.is_some(), "--memory-budget"),
            ];
            let needless = asked.into_iter().filter(|(is_asked, _)| *is_asked).map(|(_, name)| name);
            warn_of_needless(needless, "the CPU traces, as --traversal asks for", report);
        } else if self.primitive.is_some() && traversal.is_some_and(|traversal| !traversal.uses_primitives()) {
            warn_of_needless(std::iter::once("--primitive"), "it is for --traversal query and pipeline", report);
        }
    }

    /// What of it changes pictures, and not only the time that they take: whether rounding is relaxed and whether hits are approximate.
    pub fn changes_of_pictures(&self) -> (bool, bool) {
        (self.fast, matches!(self.primitive, Some(PrimitiveArg::VoxelApprox)))
    }

    /// Whether a cluster traces: it is not stopped half way.
    pub fn has_cluster(&self) -> bool {
        self.cluster.is_some()
    }

    /// What is asked for, where no cluster can trace.
    #[cfg(feature = "serve")]
    pub fn request_of_one_machine(&self) -> Result<Request, Failure> {
        match &self.cluster {
            Some(_) => Err(Failure::usage("--cluster is for `voxtrace render` and `voxtrace animate`")),
            None => Ok(self.request()),
        }
    }

    fn request(&self) -> Request {
        Request {
            traversal: self.traversal.map(Into::into),
            primitive: self.primitive.map(|primitive| match primitive {
                PrimitiveArg::VoxelExact => Primitive::VoxelExact,
                PrimitiveArg::VoxelApprox => Primitive::VoxelApprox,
                PrimitiveArg::Brick => Primitive::Brick,
                PrimitiveArg::Grid => Primitive::Grid,
                PrimitiveArg::Triangle => Primitive::Triangle,
            }),
            device: self.device.clone(),
            memory_budget: self.memory_budget,
            is_fast: self.fast,
            probes: crate::probes::cache(),
        }
    }
}
