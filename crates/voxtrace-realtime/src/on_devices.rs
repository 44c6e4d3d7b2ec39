//! What devices are told of a frame of real-time light: the record that shaders read (`shaders/realtime_frame.slang`), and what a host keeps from frame to
//! frame to fill it. Vulkan and pages have both from here.

use crate::antialiasing::Rest;
use crate::confidence::STRIDE;
use crate::half_rate::Rate;
use crate::light_cache::LightCache;
use crate::movers::{Movers, Stood, moved};
use crate::real_time::{LEAST_LOOKS, MOST_LOOKS, MOST_PATHS, Parts, SAMPLES_WHILE_MOVING, view_angle};
use bytemuck::{Pod, Zeroable};
use glam::{Mat3, Vec3};
use voxtrace_core::Frame;
use voxtrace_core::frame_params::FrameParams;
use voxtrace_core::packed::{PackedInstance, PackedScene};
use voxtrace_scene::camera::{CameraFrame, Orthographic, Perspective};
use voxtrace_scene::transform::Transform;

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
    /// Flags: [`flag`].
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
    /// Number of motions of instances; 0 where none has moved since the camera stands.
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
    /// In pages: factor on what is shown.
    pub exposure: f32,
    /// In pages: the number of the tone curve.
    pub curve: u32,
    /// Share of the newest picture in what is shown.
    pub share: f32,
    /// Fills up the row of 16 bytes.
    pub padding: u32,
}

/// Flags of [`RealTimeParams`].
pub mod flag {
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
    /// Paths in waves leave them where they meet other than matte things.
    pub const LEAVES: u32 = 1024;
    /// Pixels that show nothing that has moved keep what they know.
    pub const KEEPS: u32 = 2048;
    /// Candidates are weighed by how often rays to lights arrive.
    pub const VISIBILITY: u32 = 4096;
}

/// What a host keeps from frame to frame.
pub struct FramesOnDevice {
    /// Which parts are used.
    pub parts: Parts,
    /// Number of the next frame.
    number: u32,
    before: Option<Frame>,
    /// Whether light may have changed since the last frame.
    has_changed: bool,
    /// Samples that cells remember at most, since something changed.
    cell_samples: f32,
    /// Where instances were at the last frame, where they are elsewhere now.
    stood: Option<Vec<Stood>>,
    /// Whether something else changed since the last frame.
    is_edited: bool,
    /// Those that have moved since the camera stands.
    movers: Movers,
    /// Since something moved.
    rest: Rest,
}

impl FramesOnDevice {
    /// Before the first frame.
    pub fn new(parts: Parts) -> Self {
        Self {
            parts,
            number: 0,
            before: None,
            has_changed: false,
            cell_samples: f32::INFINITY,
            stood: None,
            is_edited: false,
            movers: Movers::default(),
            rest: Rest::LONG,
        }
    }

    /// Voxels, materials or lights of the scene are others now.
    pub fn change(&mut self) {
        (self.has_changed, self.is_edited) = (true, true);
        self.cell_samples = 0.0;
    }

    /// Instances stand elsewhere now; `before` is where they stood.
    pub fn move_instances(&mut self, before: &[PackedInstance]) {
        self.has_changed = true;
        self.cell_samples = self.cell_samples.min(SAMPLES_WHILE_MOVING);
        self.stood.get_or_insert_with(|| before.iter().map(Stood::of).collect());
    }

    /// Nothing is known any more. Cells of the light cache are the host's to clear.
    pub fn forget(&mut self) {
        *self = Self { number: self.number, ..Self::new(self.parts) };
    }

    /// Nothing is known of pixels any more.
    pub fn forget_pixels(&mut self) {
        self.before = None;
    }

    /// How many frames' paths the next picture has.
    pub fn frames_of_picture(&self, frame: &Frame) -> u32 {
        self.parts.frames_of_picture(self.before.as_ref(), frame)
    }

    /// What the steps of the next frame read: to be asked once a frame. `in_waves`: whether paths of squares and cells have slots behind those of the pixels. `squares`: whether paths
    /// without the cache are followed again, by which changes of light are noticed.
    pub fn params(
        &mut self,
        scene: &PackedScene,
        frame: &Frame,
        rate: Rate,
        (in_waves, has_squares): (bool, bool),
    ) -> RealTimeParams {
        let parts = self.parts;
        let stood = self.stood.as_deref().unwrap_or_default();
        let is_same_view = self.before_of(frame).is_some_and(|before| before.camera == frame.camera);
        self.movers = self.movers.after(moved(stood, scene.instances()), is_same_view && !self.is_edited);
        let before = self.before_of(frame);
        let is_still = is_same_view && !self.has_changed;
        let mut flags = 0;
        let mut flag = |is_set: bool, flag: u32| flags |= if is_set { flag } else { 0 };
        flag(parts.cache, flag::CACHE);
        flag(parts.filter, flag::FILTER);
        flag(parts.candidates, flag::LOOKS);
        flag(parts.weigh(), flag::VISIBILITY);
        flag(before.is_some(), flag::KNOWS);
        flag(is_still, flag::STILL);
        flag(is_same_view && self.stood.is_none(), flag::SAME_VIEW);
        flag(rate == Rate::Half, flag::HALF);
        flag(before.is_some() && self.has_changed && has_squares, flag::FINDS_AGAIN);
        flag(self.movers.keep(), flag::KEEPS);
        let camera = before.map_or(&frame.camera, |before| &before.camera);
        let then = camera.frame(frame.width, frame.height);
        let (place_flags, before_origin, rows) = places_of(&then);
        let of_before = FrameParams::default().with_camera(&then);
        let size = (frame.width, frame.height);
        let squares = if has_squares { squares(size) } else { 0 };
        RealTimeParams {
            eye: frame.camera.eye,
            view_angle: view_angle(&frame.camera),
            before_eye: of_before.eye,
            number: self.number,
            before_corner: of_before.corner,
            candidates: parts.candidates(),
            before_pixel_x: of_before.pixel_x,
            flags: flags | place_flags,
            before_pixel_y: of_before.pixel_y,
            most_paths: MOST_PATHS[usize::from(is_still)],
            before_lens_x: of_before.lens_x,
            before_blades: of_before.blades,
            before_lens_y: of_before.lens_y,
            cell_samples: self.cell_samples,
            before_place: camera.eye,
            motions: self.movers.moved().len().min(scene.instances().len()) as u32,
            before_rows: rows.map(|row| row.extend(0.0).to_array()),
            before_origin,
            pixels: frame.width * frame.height,
            slots: slots(size, in_waves),
            cells: if parts.cache { LightCache::MOST_CHOSEN as u32 } else { 0 },
            squares,
            again: if flags & flag::FINDS_AGAIN != 0 { squares } else { 0 },
            exposure: 1.0,
            curve: 0,
            share: self.rest_after(frame).share(),
            padding: 0,
        }
    }

    /// For each instance four rows: three of the affine map to the world at the last frame from the world now, and one whose first number is 1 where it has moved
    /// since the camera stands. None where those of the frame before are as good: where nothing moves only that number is read.
    pub fn motions(&self, scene: &PackedScene) -> Vec<[f32; 4]> {
        let Some(stood) = &self.stood else { return Vec::new() };
        let rows = |((stood, now), has_moved): ((&Stood, &PackedInstance), &bool)| {
            let then = match stood.world_from_grid == now.world_from_grid {
                true => Transform::IDENTITY,
                false => stood.world_from_grid.after(&now.grid_from_world),
            };
            let [x, y, z] = [0, 1, 2].map(|axis| then.linear.row(axis).extend(then.translation[axis]).to_array());
            [x, y, z, [f32::from(*has_moved), 0.0, 0.0, 0.0]]
        };
        stood.iter().zip(scene.instances()).zip(self.movers.moved()).flat_map(rows).collect()
    }

    /// The frame before one of which something is known.
    fn before_of(&self, frame: &Frame) -> Option<&Frame> {
        // A camera of another kind is not found again: pipelines are made for one.
        let lens = |frame: &Frame| FrameParams::default().with_camera(&frame.camera.frame(1, 1)).lens;
        let is_known = |before: &&Frame| self.parts.memory && before.seed == frame.seed && lens(before) == lens(frame);
        self.before.as_ref().filter(is_known)
    }

    /// Since when nothing moves, after the next frame.
    fn rest_after(&self, frame: &Frame) -> Rest {
        let before = self.before.as_ref().filter(|before| before.seed == frame.seed);
        let is_same_view = before.is_some_and(|before| before.camera == frame.camera);
        let is_in_motion = before.is_some() && !(is_same_view && self.stood.is_none());
        self.rest.after(is_in_motion, is_same_view && !self.has_changed)
    }

    /// Ends a frame.
    pub fn end(&mut self, frame: &Frame) {
        self.rest = self.rest_after(frame);
        self.before = Some(frame.clone());
        (self.stood, self.has_changed, self.is_edited) = (None, false, false);
        self.cell_samples = f32::INFINITY;
        self.number = self.number.wrapping_add(1);
    }
}

/// Rays of a pixel that only look in a frame, at most, and the number before that of the first of them: for hosts that trace them apart.
pub fn looks_of(params: &RealTimeParams) -> (u32, u32) {
    let has = |flag: u32| params.flags & flag != 0;
    let seen = match (has(flag::KNOWS), has(flag::STILL)) {
        (false, _) => MOST_LOOKS,
        (true, false) => LEAST_LOOKS,
        // Frames before have looked.
        (true, true) => 1.0,
    };
    let most = if has(flag::LOOKS) { seen as u32 - 1 } else { 0 };
    (most, (MOST_LOOKS as u32).wrapping_mul(params.number))
}

/// How a camera sees places: as `position` of `reprojection` has it.
fn places_of(camera: &CameraFrame) -> (u32, Vec3, [Vec3; 3]) {
    let of_perspective = |perspective: &Perspective| {
        let Perspective { eye, corner, pixel_x, pixel_y } = *perspective;
        let inverse = Mat3::from_cols(pixel_x, pixel_y, corner).inverse();
        (flag::FINDS_PLACES | flag::PERSPECTIVE, eye, [inverse.row(0), inverse.row(1), inverse.row(2)])
    };
    match camera {
        CameraFrame::Perspective(perspective) => of_perspective(perspective),
        CameraFrame::ThinLens(lens) => of_perspective(&lens.perspective),
        CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, .. }) => {
            let row = |pixel: Vec3| pixel / pixel.length_squared();
            (flag::FINDS_PLACES, *corner, [row(*pixel_x), row(*pixel_y), Vec3::ZERO])
        }
        CameraFrame::Panorama(_) | CameraFrame::Fisheye(_) => (0, Vec3::ZERO, [Vec3::ZERO; 3]),
    }
}

/// Squares of pixels in a picture.
pub fn squares((width, height): (u32, u32)) -> u32 {
    width.div_ceil(STRIDE) * height.div_ceil(STRIDE)
}

/// Slots of the scratch memory: one for each pixel, and in waves one for each square and each cell of the light cache that traces.
pub fn slots((width, height): (u32, u32), in_waves: bool) -> u32 {
    let others = if in_waves { squares((width, height)) + LightCache::MOST_CHOSEN as u32 } else { 0 };
    width * height + others
}
