//! The records of devices that are no part of the packed scene, the counters and the bindings. Shaders have all of them from here:
//! `cargo xtask shaders` makes `shaders/generated/shared.slang` of them (`docs/decisions/0041-one-table-of-records.md`).

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use voxtrace_core::BounceLimits;
use voxtrace_core::Frame;
use voxtrace_core::LightGroup;
use voxtrace_core::PackedScene;
use voxtrace_core::cuts::Cuts;
use voxtrace_core::light::{SunDisc, irradiance_of};
use voxtrace_core::shadow_catcher::ShadowCatcher;
use voxtrace_scene::camera::{Axes, CameraFrame, Fisheye, Orthographic, Panorama, Perspective, ThinLens};
use voxtrace_scene::sky::{Background, Gradient};

/// The input of one render call.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct FrameParams {
    /// Ray origin, world space.
    pub eye: Vec3,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Direction of the upper left corner of the picture.
    pub corner: Vec3,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// Step of one pixel to the right.
    pub pixel_x: Vec3,
    /// Which lens, one of `LENS_`: that of the pipeline, which is specialized for it.
    pub lens: u32,
    /// Step of one pixel down.
    pub pixel_y: Vec3,
    /// Which sky, one of `SKY_`: that of the pipeline, which is specialized for it.
    pub sky: u32,
    /// The part to render: x0, y0, x1, y1.
    pub region: [u32; 4],
    /// Most surfaces that scatter one path.
    pub max_bounces: u32,
    /// 1 where camera rays that meet nothing leave their sample black.
    pub is_transparent: u32,
    /// Number of the first sample of each pixel.
    pub first_sample: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Radiance straight down.
    pub sky_nadir: Vec3,
    /// Factor on the whole sky.
    pub sky_brightness: f32,
    /// Radiance straight up.
    pub sky_zenith: Vec3,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// Unit vector towards the sun's centre.
    pub sun_direction: Vec3,
    /// 1 − cos of the sun's angular radius.
    pub sun_one_minus_cos_theta_max: f32,
    /// Unit vector at right angles to the sun's direction.
    pub sun_tangent: Vec3,
    /// Sine of the sun's angular radius.
    pub sun_sin_radius: f32,
    /// Unit vector at right angles to both.
    pub sun_bitangent: Vec3,
    /// Luminance of the sun's irradiance, 0 where there is no sun.
    pub sun_irradiance: f32,
    /// Radiance of the sun's disc.
    pub sun_radiance: Vec3,
    /// Density of a uniform direction of the sun's disc.
    pub sun_pdf: f32,
    /// Thin lens: radius of the aperture along one direction. Parallel rays: their direction. Panorama: one over the width of the picture and over the
    /// height of one eye's, and half the distance of the eyes. Fisheye: the middle of the picture and the turns of a pixel.
    pub lens_x: Vec3,
    /// Number of nodes of the tree over the instances that emit.
    pub light_node_count: u32,
    /// Thin lens: radius of the aperture along the other direction.
    pub lens_y: Vec3,
    /// Thin lens: blades of the diaphragm, 0 for a round one.
    pub blades: u32,
    /// Environment map: sine and cosine of the angle by which it is turned clockwise.
    pub sky_turned: [f32; 2],
    /// Environment map: texels along an edge.
    pub sky_edge: u32,
    /// Luminance of the irradiance of a sky whose directions are chosen, 0 where none is.
    pub sky_irradiance: f32,
    /// Factor on the emission that is gathered: `light_intensity`, or 0 where emitters are left out, which changes nothing about their choice.
    pub emitter_intensity: f32,
    /// Most bounces of each kind, eight bits each: diffuse, glossy, transmitted, volume; 255 is no limit.
    pub bounce_limits: u32,
    /// Most radiance that one bounce adds of indirect light, infinite where it is not clamped.
    pub clamp_indirect: f32,
    /// Number of instances.
    pub instance_count: u32,
    /// Planes of the cuts: unit normals, which point to what is cut away, and offsets at which they cut.
    pub planes: [[f32; 4]; 12],
    /// How many of them there are.
    pub plane_count: u32,
    /// 1 where what is cut away takes part in the light.
    pub cuts_cast_shadows: u32,
    /// 1 where light passes clear glass straight.
    pub clear_shadows: u32,
    /// 1 where a camera does not see the disc of the sun.
    pub hides_sun_disc: u32,
    /// Material of the ground without end, `u32::MAX` where there is none.
    pub ground_material: u32,
    /// Where the ground shows shadows alone: [`ShadowCatcher::sun_share`].
    pub catcher_sun_share: f32,
    /// [`ShadowCatcher::cube_share`].
    pub catcher_cube_share: f32,
    /// Lines of a grid: how many voxels apart.
    pub grid_spacing: u32,
    /// Lines along the edges of shapes: reflectance.
    pub edge_color: Vec3,
    /// Their width, voxels, 0 where there are none.
    pub edge_width: f32,
    /// Lines of a grid: reflectance.
    pub grid_color: Vec3,
    /// Their width, voxels, 0 where there are none.
    pub grid_width: f32,
}

/// The sky is a gradient.
pub const SKY_GRADIENT: u32 = 0;
/// The sky is an environment map.
pub const SKY_ENVIRONMENT: u32 = 1;

/// The lens sends all rays through one point.
pub const LENS_PINHOLE: u32 = 0;
/// A thin lens.
pub const LENS_THIN: u32 = 1;
/// Parallel rays; `corner` is where the ray of the upper left corner starts.
pub const LENS_ORTHOGRAPHIC: u32 = 2;
/// Longitude and latitude; `corner`, `pixel_x` and `pixel_y` are the directions forward, right and up.
pub const LENS_PANORAMA: u32 = 3;
/// An equidistant fisheye; directions as for `LENS_PANORAMA`.
pub const LENS_FISHEYE: u32 = 4;

impl FrameParams {
    /// What casting needs: the scene without a view.
    pub fn of_scene(scene: &PackedScene) -> Self {
        let background = match scene.sky.background() {
            Background::Gradient(Gradient { nadir, zenith }) => {
                Self { sky: SKY_GRADIENT, sky_nadir: *nadir, sky_zenith: *zenith, ..Self::default() }
            }
            Background::Environment(environment) => Self {
                sky: SKY_ENVIRONMENT,
                sky_turned: environment.turned().to_array(),
                sky_edge: environment.map().edge(),
                sky_irradiance: irradiance_of(&scene.sky),
                ..Self::default()
            },
        };
        let params = Self {
            instance_count: scene.instances().len() as u32,
            light_node_count: scene.placement().light_nodes().len() as u32,
            sky_brightness: scene.sky.brightness(),
            light_intensity: scene.light_intensity,
            emitter_intensity: scene.light_intensity,
            ..background.with_cuts(&scene.cuts)
        };
        let Some(sun) = SunDisc::new(&scene.sky) else { return params };
        Self {
            sun_direction: sun.direction,
            sun_one_minus_cos_theta_max: sun.one_minus_cos_theta_max,
            sun_tangent: sun.tangent,
            sun_sin_radius: sun.sin_radius,
            sun_bitangent: sun.bitangent,
            sun_irradiance: sun.irradiance,
            sun_radiance: sun.radiance,
            sun_pdf: sun.pdf,
            hides_sun_disc: (!sun.is_visible).into(),
            ..params
        }
    }

    fn with_cuts(mut self, cuts: &Cuts) -> Self {
        for (row, plane) in self.planes.iter_mut().zip(cuts.planes()) {
            *row = plane.normal().extend(plane.edge()).to_array();
        }
        Self { plane_count: cuts.planes().len() as u32, cuts_cast_shadows: cuts.casts_shadows().into(), ..self }
    }

    /// What a frame of the scene needs.
    pub fn of_frame(scene: &PackedScene, frame: &Frame) -> Self {
        let region = frame.region;
        Self {
            width: frame.width,
            height: frame.height,
            first_sample: frame.first_sample,
            seed: frame.seed,
            region: [region.x0, region.y0, region.x1, region.y1],
            // Where everything is matte all bounces are diffuse.
            max_bounces: match frame.bounce_limits.diffuse {
                limit if limit < BounceLimits::UNLIMITED && scene.is_matte() => frame.max_bounces.min(limit.into()),
                _ => frame.max_bounces,
            },
            bounce_limits: frame.bounce_limits.to_bits(),
            clamp_indirect: frame.clamp_indirect,
            clear_shadows: frame.clear_shadows.into(),
            is_transparent: frame.transparent.into(),
            ground_material: scene.ground_material().unwrap_or(u32::MAX),
            ..Self::of_scene(scene).of_group(frame.light_group)
        }
        .with_catcher(ShadowCatcher::new(scene, frame))
        .with_lines(&frame.lines)
        .with_camera(&frame.camera.frame(frame.width, frame.height))
    }

    fn with_catcher(self, catcher: Option<ShadowCatcher>) -> Self {
        let Some(ShadowCatcher { sun_share, cube_share, .. }) = catcher else { return self };
        Self { catcher_sun_share: sun_share, catcher_cube_share: cube_share, ..self }
    }

    /// The same lights, chosen in the same way, of which those of a group alone shine.
    fn of_group(self, group: LightGroup) -> Self {
        let shining = |part: LightGroup| if group.has(part) { 1.0 } else { 0.0 };
        Self {
            sun_radiance: self.sun_radiance * shining(LightGroup::Sun),
            sky_brightness: self.sky_brightness * shining(LightGroup::Sky),
            emitter_intensity: self.emitter_intensity * shining(LightGroup::Emitters),
            ..self
        }
    }

    /// The same input with another camera.
    pub fn with_camera(self, camera: &CameraFrame) -> Self {
        let with =
            |lens, [eye, corner, pixel_x, pixel_y]: [Vec3; 4]| Self { lens, eye, corner, pixel_x, pixel_y, ..self };
        let of_axes = |lens, eye, Axes { forward, right, up }: Axes| with(lens, [eye, forward, right, up]);
        match *camera {
            CameraFrame::Perspective(Perspective { eye, corner, pixel_x, pixel_y }) => {
                with(LENS_PINHOLE, [eye, corner, pixel_x, pixel_y])
            }
            CameraFrame::ThinLens(ThinLens { perspective, lens_x, lens_y, blades }) => {
                let Perspective { eye, corner, pixel_x, pixel_y } = perspective;
                Self { lens_x, lens_y, blades, ..with(LENS_THIN, [eye, corner, pixel_x, pixel_y]) }
            }
            CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, forward }) => {
                Self { lens_x: forward, ..with(LENS_ORTHOGRAPHIC, [Vec3::ZERO, corner, pixel_x, pixel_y]) }
            }
            CameraFrame::Panorama(Panorama { eye, axes, inverse_size, half_eye_distance }) => {
                Self { lens_x: inverse_size.extend(half_eye_distance), ..of_axes(LENS_PANORAMA, eye, axes) }
            }
            CameraFrame::Fisheye(Fisheye { eye, axes, middle, turns_per_pixel }) => {
                Self { lens_x: middle.extend(turns_per_pixel), ..of_axes(LENS_FISHEYE, eye, axes) }
            }
        }
    }
}

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

/// The input of one frame of real-time light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct RealTimeParams {
    /// The camera's place, world space.
    pub eye: Vec3,
    /// What the picture's height sees, radians.
    pub view_angle: f32,
    /// The camera of the frame before, as [`FrameParams`] has it.
    pub before_eye: Vec3,
    /// Number of the frame.
    pub number: u32,
    /// The same.
    pub before_corner: Vec3,
    /// Lights of which the first surface of a path chooses one.
    pub candidates: u32,
    /// The same.
    pub before_pixel_x: Vec3,
    /// Flags: [`real_time`].
    pub flags: u32,
    /// The same.
    pub before_pixel_y: Vec3,
    /// Most paths that a pixel remembers.
    pub most_paths: f32,
    /// The same.
    pub before_lens_x: Vec3,
    /// The same.
    pub before_blades: u32,
    /// The same.
    pub before_lens_y: Vec3,
    /// Samples that cells of the light cache remember at most.
    pub cell_samples: f32,
    /// Its place, world space.
    pub before_place: Vec3,
    /// Number of motions of instances.
    pub motions: u32,
    /// Where the frame before saw a place p, world space: the products of these three with p − `before_origin`, the first two over the third
    /// where it is perspective.
    pub before_rows: [[f32; 4]; 3],
    /// The same.
    pub before_origin: Vec3,
    /// Pixels of the picture.
    pub pixels: u32,
    /// Slots of the scratch memory: those of the pixels, and where paths are traced in waves of other paths.
    pub slots: u32,
    /// Cells of the light cache that may trace.
    pub cells: u32,
    /// Squares of pixels, of each of which the path of one is followed again in the next frame.
    pub squares: u32,
    /// Those that are in this one.
    pub again: u32,
}

/// Flags of [`RealTimeParams`].
pub mod real_time {
    /// The light cache is used.
    pub const CACHE: u32 = 1;
    /// Rays that only look are used.
    pub const LOOKS: u32 = 2;
    /// Something is known of the frame before.
    pub const KNOWS: u32 = 4;
    /// Nothing moved or changed.
    pub const STILL: u32 = 8;
    /// The camera stands still and no instance moved.
    pub const SAME_VIEW: u32 = 16;
    /// The frame before saw places as a perspective or parallel camera does.
    pub const FINDS_PLACES: u32 = 32;
    /// Its rays went through one point.
    pub const PERSPECTIVE: u32 = 64;
    /// Every other pixel traces.
    pub const HALF: u32 = 128;
    /// Light is filtered.
    pub const FILTER: u32 = 256;
    /// Paths of the frame before are followed again.
    pub const FINDS_AGAIN: u32 = 512;
}

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
    /// [`super::RealTimeParams`].
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
