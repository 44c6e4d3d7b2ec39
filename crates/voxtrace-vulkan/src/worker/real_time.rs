//! Frames of real-time light.

use super::Worker;
use crate::capabilities::DeviceKind;
use crate::commands::Job;
use crate::passes::{Passes, WORKGROUP};
use crate::picture::Picture;
use crate::real_time::{Kind, RealTime, RealTimeFrame, Step, slots, squares};
use crate::records::{Dispatch, FrameParams, RealTimeParams, binding, real_time};
use crate::spirv;
use crate::variant::{Entry, Variant};
use glam::{Mat3, Vec3};
use std::sync::Arc;
use voxtrace_core::{Frame, PackedScene, Region, TraceError};
use voxtrace_realtime::{CANDIDATES, LightCache, MOST_PATHS, Parts, Rate};
use voxtrace_scene::camera::{CameraFrame, Orthographic, Perspective};
use voxtrace_scene::transform::Transform;

impl Worker {
    /// Traces the next frame of real-time light and writes it to a picture.
    pub fn show_real_time(
        &mut self,
        frame: &Frame,
        rate: Rate,
        picture: &Picture,
    ) -> Result<RealTimeFrame, TraceError> {
        frame.check()?;
        let scene = Arc::clone(self.scene()?);
        if picture.size() != (frame.width, frame.height) || !Arc::ptr_eq(picture.device(), &self.device) {
            return Err(TraceError::BadFrame("the picture has another size or lies on another device".into()));
        }
        if self.scene.as_ref().is_some_and(|buffers| buffers.pages.is_some()) {
            let reason = "real-time light needs the whole scene on the device, and this one is larger than its memory";
            return Err(TraceError::Unsupported(reason.into()));
        }
        let tiles = u64::from(frame.width.div_ceil(8)) * u64::from(frame.height.div_ceil(8));
        if tiles > u64::from(self.device.info().limits.max_workgroups) {
            let name = &self.device.info().name;
            return Err(TraceError::BadFrame(format!("{name} makes no real-time pictures as large as this")));
        }
        self.submitter.wait_for_quiet()?;
        let mut state = match self.real_time.take() {
            Some(state) => state,
            None => RealTime::new(&self.device, self.real_time_parts)?,
        };
        let parts = state.parts;
        let frames = parts.frames_of_picture(state.before.as_ref().map(|before| &before.frame), frame);
        let mut result = Err(TraceError::NoScene);
        for number in 1..=frames {
            // Of frames that are not shown nothing is filtered.
            state.parts.filter = parts.filter && number == frames;
            let next = self.real_time_frame(&mut state, &scene, frame, rate, picture);
            state.parts = parts;
            result = next.map(|next| match result {
                Ok(before) => next.after(before),
                Err(_) => next,
            });
            if result.is_err() {
                break;
            }
            state.end(frame);
        }
        self.stop_showing();
        if result.is_ok() {
            self.real_time = Some(state);
        } else {
            self.unbind_real_time();
        }
        result
    }

    fn real_time_frame(
        &mut self,
        state: &mut RealTime,
        scene: &PackedScene,
        frame: &Frame,
        rate: Rate,
        picture: &Picture,
    ) -> Result<RealTimeFrame, TraceError> {
        let whole = Region { x0: 0, y0: 0, x1: frame.width, y1: frame.height };
        let params = FrameParams::of_frame(scene, &frame.clone().region(whole));
        let (tracing, in_waves) = self.tracing_variant(&params, frame)?;
        state.set_size(frame.width, frame.height, in_waves)?;
        let of_frame = real_time_params(state, scene, frame, &params, rate);
        let steps = steps_of(&of_frame, (frame.width, frame.height), in_waves);
        let variants = self.prepare_real_time(tracing, &steps)?;
        let motions = motions(state, scene);
        state.write(&of_frame, &motions)?;
        self.set_params(&params);
        state.bind(&self.bindings, &self.nothing);
        self.bindings.bind(binding::HITS, picture.to_write());
        let Some(passes) = &self.real_time_passes else { return Err(TraceError::NoScene) };
        let record = |commands, offset| {
            state.record(&steps, passes, variants, &self.bindings, (commands, offset));
        };
        let tiles = frame.width.div_ceil(8) * frame.height.div_ceil(8);
        let dispatch = Dispatch { count: tiles * WORKGROUP, ..Dispatch::default() };
        let step = "real-time light";
        let job = Job { step, work: 0, dispatch, workgroups: Some(tiles), record: &record, then: None };
        let gpu_ms = self.submitter.run(&job)?.gpu_ms;
        Ok(RealTimeFrame { gpu_ms, frames: 1, passes: state.milliseconds(&steps)?, bytes: state.bytes() })
    }

    /// The variant of steps that trace, and whether paths are traced in waves.
    fn tracing_variant(&self, params: &FrameParams, frame: &Frame) -> Result<(Variant, bool), TraceError> {
        let variant = self.variant(Entry::RealTime(""), (params.lens, params.sky), Some(frame))?;
        // Shadows alone are the film's.
        let tracing = Variant { is_exact: self.is_real_time_exact, has_catcher: false, ..variant };
        // In software more shaders only take longer to compile.
        let is_software = self.device.info().kind == DeviceKind::Cpu;
        let in_waves = self.most_paths.map_or(!is_software, |most| most > 0);
        Ok((tracing, in_waves && !tracing.has_materials))
    }

    /// Makes the programs of steps. Returns the variants of each [`Kind`].
    fn prepare_real_time(&mut self, tracing: Variant, steps: &[Step]) -> Result<[Variant; 3], TraceError> {
        let is_exact = self.is_real_time_exact;
        let gathering = Variant { has_materials: false, ..tracing };
        let passes = self.real_time_passes.get_or_insert_with(|| {
            let module = |module: spirv::Module| if is_exact { module } else { module.fast() };
            let tracing = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME));
            let waves = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME_WAVES));
            let gathering = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME_PIXELS));
            [tracing.with_materials(module(spirv::REALTIME_MATERIALS)), waves, gathering]
        });
        let variants = [tracing, tracing, gathering];
        for step in steps {
            let which = Kind::of(step.name) as usize;
            passes[which].prepare(variants[which].real_time(step.name))?;
        }
        Ok(variants)
    }

    /// Gives back what real-time light took. Nothing may be in flight.
    pub fn forget_real_time(&mut self) {
        if self.real_time.take().is_some() {
            self.unbind_real_time();
        }
    }

    fn unbind_real_time(&self) {
        let places = [
            binding::MEMORY,
            binding::SCRATCH,
            binding::CELL_KEYS,
            binding::CELL_ROWS,
            binding::MOTIONS,
            binding::REST,
        ];
        places.into_iter().for_each(|place| self.bindings.bind(place, &self.nothing));
        self.bindings.bind(binding::REAL_TIME, &self.params);
    }

    /// Which parts of real-time light are used from now on, and whether its rays are traced exactly.
    pub fn set_real_time(&mut self, parts: Parts, is_exact: bool) {
        self.forget_real_time();
        (self.real_time_parts, self.is_real_time_exact, self.real_time_passes) = (parts, is_exact, None);
    }

    /// The words of the buffers of real-time light: memory, scratch memory, keys and rows of cells. For tests.
    pub fn real_time_words(&mut self) -> Result<[Vec<u32>; 4], TraceError> {
        let state = self.real_time.take().ok_or(TraceError::NoFilm)?;
        let (memory, scratch) = state.pixel_buffers().ok_or(TraceError::NoFilm)?;
        let mut words = [memory, scratch, &state.cell_keys, &state.cell_rows].map(|buffer| (buffer, Vec::new()));
        for (buffer, words) in &mut words {
            words.resize(buffer.size as usize / 4, 0);
            self.transfer.download(&mut self.submitter, buffer, 0, bytemuck::cast_slice_mut(words))?;
        }
        let words = words.map(|(_, words)| words);
        self.real_time = Some(state);
        Ok(words)
    }
}

/// What the steps of a frame read.
fn real_time_params(
    state: &RealTime,
    scene: &PackedScene,
    frame: &Frame,
    params: &FrameParams,
    rate: Rate,
) -> RealTimeParams {
    let parts = state.parts;
    let before = state.before.as_ref().filter(|before| {
        // A camera of another kind is not found again: pipelines are made for one.
        let lens = FrameParams::default().with_camera(&before.frame.camera.frame(1, 1)).lens;
        parts.memory && before.frame.seed == frame.seed && lens == params.lens
    });
    let is_same_view = before.is_some_and(|before| before.frame.camera == frame.camera);
    let is_still = is_same_view && !state.has_changed;
    let mut flags = 0;
    let mut flag = |is_set: bool, flag: u32| flags |= if is_set { flag } else { 0 };
    flag(parts.cache, real_time::CACHE);
    flag(parts.filter, real_time::FILTER);
    flag(parts.candidates, real_time::LOOKS);
    flag(before.is_some(), real_time::KNOWS);
    flag(is_still, real_time::STILL);
    flag(is_same_view && state.transforms.is_none(), real_time::SAME_VIEW);
    flag(rate == Rate::Half, real_time::HALF);
    flag(before.is_some() && state.has_changed, real_time::FINDS_AGAIN);
    let camera = before.map_or(&frame.camera, |before| &before.frame.camera);
    let then = camera.frame(frame.width, frame.height);
    let (place_flags, before_origin, rows) = places_of(&then);
    let of_before = FrameParams::default().with_camera(&then);
    let size = (frame.width, frame.height);
    RealTimeParams {
        eye: frame.camera.eye,
        view_angle: voxtrace_realtime::view_angle(&frame.camera),
        before_eye: of_before.eye,
        number: state.number,
        before_corner: of_before.corner,
        candidates: if parts.candidates { CANDIDATES } else { 1 },
        before_pixel_x: of_before.pixel_x,
        flags: flags | place_flags,
        before_pixel_y: of_before.pixel_y,
        most_paths: MOST_PATHS[usize::from(is_still)],
        before_lens_x: of_before.lens_x,
        before_blades: of_before.blades,
        before_lens_y: of_before.lens_y,
        cell_samples: state.cell_samples,
        before_place: camera.eye,
        motions: if state.transforms.is_some() { scene.instances().len() as u32 } else { 0 },
        before_rows: rows.map(|row| row.extend(0.0).to_array()),
        before_origin,
        pixels: frame.width * frame.height,
        slots: slots(size, state.in_waves),
        cells: if parts.cache { LightCache::MOST_CHOSEN as u32 } else { 0 },
        squares: squares(size),
        again: if flags & real_time::FINDS_AGAIN != 0 { squares(size) } else { 0 },
    }
}

/// How a camera sees places: as `position` of `voxtrace-realtime` has it.
fn places_of(camera: &CameraFrame) -> (u32, Vec3, [Vec3; 3]) {
    let of_perspective = |perspective: &Perspective| {
        let Perspective { eye, corner, pixel_x, pixel_y } = *perspective;
        let inverse = Mat3::from_cols(pixel_x, pixel_y, corner).inverse();
        (real_time::FINDS_PLACES | real_time::PERSPECTIVE, eye, [inverse.row(0), inverse.row(1), inverse.row(2)])
    };
    match camera {
        CameraFrame::Perspective(perspective) => of_perspective(perspective),
        CameraFrame::ThinLens(lens) => of_perspective(&lens.perspective),
        CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, .. }) => {
            let row = |pixel: Vec3| pixel / pixel.length_squared();
            (real_time::FINDS_PLACES, *corner, [row(*pixel_x), row(*pixel_y), Vec3::ZERO])
        }
        CameraFrame::Panorama(_) | CameraFrame::Fisheye(_) => (0, Vec3::ZERO, [Vec3::ZERO; 3]),
    }
}

/// The world at the last frame from the world now, for each instance: three rows.
fn motions(state: &RealTime, scene: &PackedScene) -> Vec<[f32; 4]> {
    let Some(before) = &state.transforms else { return Vec::new() };
    let rows = |(before, now): (&Transform, &voxtrace_core::packed::PackedInstance)| {
        let has_moved = *before != now.world_from_grid;
        let then = if has_moved { before.after(&now.grid_from_world) } else { Transform::IDENTITY };
        [0, 1, 2].map(|axis| then.linear.row(axis).extend(then.translation[axis]).to_array())
    };
    before.iter().zip(scene.instances()).flat_map(rows).collect()
}

/// The steps of a frame.
fn steps_of(params: &RealTimeParams, (width, height): (u32, u32), in_waves: bool) -> Vec<Step> {
    let has = |flag: u32| params.flags & flag != 0;
    let pixels = width.div_ceil(8) * height.div_ceil(8) * WORKGROUP;
    let half = width.div_ceil(16) * height.div_ceil(8) * WORKGROUP;
    let that_trace = if has(real_time::HALF) { half } else { pixels };
    let cells = LightCache::CAPACITY as u32;
    let RealTimeParams { cells: tracing_cells, squares, again, .. } = *params;
    let mut steps = Vec::new();
    if in_waves {
        let all = tracing_cells + that_trace + squares;
        let counts = [that_trace + squares, all, all, all, all].map(Some);
        let names = ["trace_camera", "trace_first", "trace_light", "trace_rays", "trace_ends"];
        let first = names.into_iter().zip(counts);
        let others = ["trace_on", "trace_on_rays", "trace_on", "trace_on_rays", "trace_rest"].map(|name| (name, None));
        steps.extend(first.chain(others).map(|(name, count)| Step { name, count }));
        if again > 0 {
            steps.push(Step { name: "trace_again", count: Some(again) });
        }
    } else {
        steps.push(Step { name: "trace", count: Some(tracing_cells + that_trace + squares + again) });
    }
    if has(real_time::CACHE) {
        steps.insert(0, Step { name: "choose_cells", count: Some(cells) });
    }
    let mut add = |name, count| steps.push(Step { name, count: Some(count) });
    if has(real_time::FINDS_AGAIN) {
        add("compare_found", squares);
        add("doubt", pixels);
    }
    if has(real_time::KNOWS) && !has(real_time::SAME_VIEW) {
        add("reproject", pixels);
    }
    add("remember", that_trace);
    if has(real_time::HALF) {
        add("remember_others", pixels);
    }
    if has(real_time::CACHE) {
        add("end_cells", cells);
    }
    if has(real_time::FILTER) {
        for name in FILTER_STEPS {
            add(name, pixels);
        }
    }
    add("show_picture", pixels);
    steps
}

/// The steps of the filter.
const FILTER_STEPS: [&str; 11] = [
    "filter_begin",
    "filter_compare",
    "filter_noise",
    "filter_tolerance",
    "filter_level_0",
    "filter_level_1",
    "filter_level_2",
    "filter_level_3",
    "filter_level_4",
    "filter_end",
    "filter_across",
];
