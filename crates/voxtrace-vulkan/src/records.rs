//! The records of devices that are no part of the packed scene, the counters and the bindings. Shaders have all of them from here:
//! `cargo xtask shaders` makes `shaders/generated/shared.slang` of them (`docs/decisions/0041-one-table-of-records.md`).

use bytemuck::{Pod, Zeroable};

pub use voxtrace_core::frame_params::{
    FrameParams, LENS_FISHEYE, LENS_ORTHOGRAPHIC, LENS_PANORAMA, LENS_PINHOLE, LENS_THIN, SKY_ENVIRONMENT, SKY_GRADIENT,
};
pub use voxtrace_realtime::RealTimeParams;

/// The part of the work that one dispatch does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Dispatch {
    /// First pixel of the region, row by row, or first ray.
    pub first: u32,
    /// How many of them.
    pub count: u32,
    /// Most samples to add to each pixel.
    pub samples: u32,
    /// Samples that each pixel should have in all.
    pub samples_target: u32,
    /// Fills up the second row of 16 bytes.
    pub padding: [u32; 3],
    /// Written to the counters when the dispatch has run.
    pub sequence: u32,
}

/// A step of a wave of paths: see `shaders/pass/waves.slang`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct WaveStep {
    /// Number of the round.
    pub round: u32,
    /// Place of the wave's counts among the queues, words.
    pub counts: u32,
    /// Paths that have room.
    pub capacity: u32,
    /// Rounds of a wave.
    pub rounds: u32,
    /// Samples of each pixel in it, at most.
    pub samples: u32,
}

/// How the picture of a film is laid over another one: the push constants of `shaders/pass/blend.slang`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct BlendParams {
    /// Pixels of the film's picture.
    pub width: u32,
    /// Pixels of the film's picture.
    pub height: u32,
    /// Pixels of the one under it.
    pub under_width: u32,
    /// Pixels of the one under it.
    pub under_height: u32,
    /// How much of the film is seen, 0 to 1.
    pub film_weight: f32,
}

/// Words of the counts of one round of a wave.
pub const WAVE_ROUND_WORDS: u32 = 16;
/// Words of all counts, before the queues.
pub const WAVE_COUNTS_WORDS: u32 = 1 << 14;

/// A ray of the driver probes and what its shaders do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct ProbeRay {
    /// Where it starts, world space.
    pub origin: [f32; 3],
    /// Begin of the segment, in lengths of the direction.
    pub t_min: f32,
    /// Direction, of any length.
    pub direction: [f32; 3],
    /// End of the segment.
    pub t_max: f32,
    /// Ray flags of the trace.
    pub flags: u32,
    /// Which instances it sees.
    pub mask: u32,
    /// What the shader reports for a candidate.
    pub report: u32,
    /// Where in the log the numbers of its candidates begin.
    pub log_first: u32,
    /// How many candidates have room there.
    pub log_capacity: u32,
    /// Makes the record a multiple of 16 bytes.
    pub padding: [u32; 3],
}

/// What a ray of the driver probes met. [`Self::NOTHING`] stands for no number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct ProbeAnswer {
    /// Candidates, repeats included.
    pub candidates: u32,
    /// 1 where the hit shader ran, 0 where the miss shader did.
    pub is_hit: u32,
    /// Distance of the hit, in lengths of the direction.
    pub t: f32,
    /// Primitive of the hit.
    pub primitive: u32,
    /// Geometry of the hit.
    pub geometry: u32,
    /// Instance of the hit.
    pub instance: u32,
    /// What the hit attribute says is the primitive.
    pub attribute: u32,
    /// What the hit attribute says is the distance.
    pub attribute_t: f32,
    /// Nearest primitive that any-hit shaders kept.
    pub kept: u32,
    /// Its distance.
    pub kept_t: f32,
    /// The attribute of the hit accepted last, for the rule that restores it.
    pub accepted: u32,
    /// Its distance.
    pub accepted_t: f32,
}

impl ProbeAnswer {
    /// No primitive, geometry, instance or attribute.
    pub const NOTHING: u32 = u32::MAX;
}

/// Number of counters that the host knows by name. Those that are spread come after them.
pub const COUNTERS: usize = 16;
/// Places over which ray generation shaders, which have no workgroups, spread each of the counters of rays and of invocations. A
/// power of two.
pub const COUNTER_SLOTS: usize = 1024;
/// Words of the buffer of counters.
pub const COUNTER_WORDS: usize = COUNTERS + 4 * COUNTER_SLOTS;

/// Places in the buffer of counters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum Counter {
    /// The sequence number of the dispatch that ran last.
    Sequence = 0,
    /// Rays from the camera, and rays cast.
    CameraRays = 1,
    /// Rays that left a surface.
    BounceRays = 2,
    /// Rays towards lights.
    ShadowRays = 3,
    /// Workgroups, or invocations of a ray generation shader, that did all their work: the dispatch ran when all of them are counted.
    Workgroups = 4,
}

/// Places of the buffers in descriptor set 0.
pub mod binding {
    /// Top arrays and nodes.
    pub const CELLS: u32 = 0;
    /// Brick records.
    pub const BRICKS: u32 = 1;
    /// Materials of the voxels.
    pub const BRICK_MATERIALS: u32 = 2;
    /// Grids.
    pub const GRIDS: u32 = 3;
    /// Instances.
    pub const INSTANCES: u32 = 4;
    /// Hierarchy over the instances.
    pub const INSTANCE_NODES: u32 = 5;
    /// Materials.
    pub const MATERIALS: u32 = 6;
    /// Emitters.
    pub const EMITTERS: u32 = 7;
    /// Trees over the emitters of each grid.
    pub const LIGHT_NODES: u32 = 8;
    /// [`super::FrameParams`].
    pub const FRAME: u32 = 9;
    /// Sums of the film.
    pub const PIXELS: u32 = 10;
    /// Rays to cast.
    pub const RAYS: u32 = 11;
    /// Their hits.
    pub const HITS: u32 = 12;
    /// Acceleration structure over the instances.
    pub const TOP_LEVEL: u32 = 13;
    /// Records of the primitives of acceleration structures.
    pub const PRIMITIVES: u32 = 14;
    /// What the device counts.
    pub const COUNTERS: u32 = 15;
    /// [`super::Dispatch`].
    pub const DISPATCH: u32 = 16;
    /// Tree over the instances that emit.
    pub const TOP_LIGHT_NODES: u32 = 17;
    /// What the entries of the acceleration structure over the instances stand for.
    pub const ENTRIES: u32 = 18;
    /// Texels of the environment map.
    pub const ENVIRONMENT: u32 = 19;
    /// [`super::FrameParams`] again, where the shaders of a pass read it as storage.
    pub const FRAME_STORAGE: u32 = 20;
    /// Which pages of the scene are there, and where.
    pub const PAGES: u32 = 21;
    /// Paths under way.
    pub const PATHS: u32 = 22;
    /// Which of them each step of a wave takes.
    pub const QUEUES: u32 = 23;
    /// `RealTimeParams` of `voxtrace-realtime`.
    pub const REAL_TIME: u32 = 24;
    /// What real-time light knows of pixels.
    pub const MEMORY: u32 = 25;
    /// What it works with within a frame.
    pub const SCRATCH: u32 = 26;
    /// Which cells the light cache has.
    pub const CELL_KEYS: u32 = 27;
    /// What these know.
    pub const CELL_ROWS: u32 = 28;
    /// How instances moved since the frame before.
    pub const MOTIONS: u32 = 29;
    /// Paths of real-time light in waves that few steps could not end.
    pub const REST: u32 = 30;
    /// The last place.
    pub const LAST: u32 = REST;
}
