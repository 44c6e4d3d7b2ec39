//! Frames of real-time light.

use super::Worker;
use crate::capabilities::DeviceKind;
use crate::commands::Job;
use crate::passes::{Passes, WORKGROUP};
use crate::picture::Picture;
use crate::real_time::left::Left;
use crate::real_time::{Count, Kind, RealTime, RealTimeFrame, Step};
use crate::records::{Dispatch, FrameParams, binding};
use crate::spirv;
use crate::variant::{Entry, Variant};
use std::sync::Arc;
use voxtrace_core::{Frame, PackedScene, Region, TraceError};
use voxtrace_realtime::{LightCache, Parts, Rate, RealTimeParams, flag, squares};

/// What all frames of a picture have.
struct Prepared {
    params: FrameParams,
    tracing: Variant,
    /// Whether paths are traced in waves.
    in_waves: bool,
}

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
        frame.check_in(&scene)?;
        if picture.size() != (frame.width, frame.height) || !Arc::ptr_eq(picture.device(), &self.device) {
            return Err(TraceError::BadFrame("the picture has another size or lies on another device".into()));
        }
        if self.scene.as_ref().is_some_and(|buffers| buffers.pages.is_some()) {
            let reason = "real-time light needs the whole scene on the device, and this one is larger than its memory";
            return Err(TraceError::Unsupported(reason.into()));
        }
        if most_workgroups((frame.width, frame.height), rate) > u64::from(self.device.info().limits.max_workgroups) {
            let name = &self.device.info().name;
            return Err(TraceError::Unsupported(format!("{name} makes no real-time pictures as large as this")));
        }
        self.submitter.wait_for_quiet()?;
        let mut state = match self.real_time.take() {
            Some(state) => state,
            None => match RealTime::new(&self.device, self.real_time_parts) {
                // What films keep of paths makes room.
                Err(TraceError::OutOfMemory { .. }) if self.waves.is_some() => {
                    self.drop_waves();
                    RealTime::new(&self.device, self.real_time_parts)?
                }
                result => result?,
            },
        };
        state.set_instances(scene.instances().len());
        let parts = state.frames.parts;
        // First: of pixels of another size nothing is known, and their first picture has the paths of several frames.
        let prepared = match self.make_room(&mut state, &scene, frame) {
            Ok(prepared) => prepared,
            Err(error) => {
                self.unbind_real_time();
                return Err(error);
            }
        };
        let frames = state.frames.frames_of_picture(frame);
        if frames > 1 {
            state.left.begin_anew();
        }
        let mut result = Err(TraceError::NoScene);
        for number in 1..=frames {
            // Of frames that are not shown nothing is filtered.
            state.frames.parts.filter = parts.filter && number == frames;
            let next = self.real_time_frame(&mut state, &scene, frame, (rate, &prepared), picture);
            state.frames.parts = parts;
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

    /// Makes room for the pixels of a picture. Where there was room for others, nothing is known of pixels any more.
    fn make_room(&mut self, state: &mut RealTime, scene: &PackedScene, frame: &Frame) -> Result<Prepared, TraceError> {
        let whole = Region { x0: 0, y0: 0, x1: frame.width, y1: frame.height };
        let params = FrameParams::of_frame(scene, &frame.clone().region(whole));
        let (tracing, in_waves) = self.tracing_variant(&params, frame)?;
        state.left.most = self.most_paths.unwrap_or(u32::MAX);
        let waves = (in_waves, in_waves && tracing.has_materials);
        match state.set_size(frame.width, frame.height, waves) {
            // As for films, what these keep of paths makes room.
            Err(TraceError::OutOfMemory { .. }) if self.waves.is_some() => {
                self.drop_waves();
                state.set_size(frame.width, frame.height, waves)?;
            }
            result => result?,
        }
        Ok(Prepared { params, tracing, in_waves })
    }

    fn real_time_frame(
        &mut self,
        state: &mut RealTime,
        scene: &PackedScene,
        frame: &Frame,
        (rate, prepared): (Rate, &Prepared),
        picture: &Picture,
    ) -> Result<RealTimeFrame, TraceError> {
        let &Prepared { params, tracing, in_waves } = prepared;
        let mut of_frame = state.frames.params(scene, frame, rate, (in_waves, true));
        let leaves = in_waves && tracing.has_materials && state.left.in_waves();
        if leaves {
            of_frame.flags |= flag::LEAVES;
        }
        let size = (frame.width, frame.height);
        let only_waves = in_waves && (leaves || !tracing.has_materials);
        let steps = steps_of(&of_frame, rate, size, only_waves, state.left.rounds());
        let variants = self.prepare_real_time(tracing, &steps)?;
        let motions = state.frames.motions(scene);
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
        let result = self.submitter.run(&job);
        // Films have their paths there.
        match &self.waves {
            Some(waves) => waves.bind(&self.bindings),
            None => {
                [binding::PATHS, binding::QUEUES].into_iter().for_each(|place| self.bindings.bind(place, &self.nothing))
            }
        }
        let gpu_ms = result?.gpu_ms;
        let passes = state.milliseconds(&steps)?;
        if in_waves && tracing.has_materials {
            let paths = threads_that_trace(rate, size) + of_frame.squares;
            let of_paths =
                |name: &str| matches!(Kind::of(name), Kind::Tracing | Kind::Waves | Kind::Left) && name != "remember";
            let ms = passes.iter().filter(|(name, _)| of_paths(name)).map(|(_, ms)| ms).sum();
            state.left.learn(paths, leaves, (!passes.is_empty()).then_some(ms));
        }
        Ok(RealTimeFrame { gpu_ms, frames: 1, passes, bytes: state.bytes() })
    }

    /// The variant of steps that trace, and whether paths are traced in waves.
    fn tracing_variant(&self, params: &FrameParams, frame: &Frame) -> Result<(Variant, bool), TraceError> {
        let variant = self.variant(Entry::RealTime(""), (params.lens, params.sky), Some(frame))?;
        // Shadows alone are the film's.
        let tracing = Variant { is_exact: self.is_real_time_exact, has_catcher: false, ..variant };
        // In software more shaders only take longer to compile.
        let is_software = self.device.info().kind == DeviceKind::Cpu;
        let in_waves = self.most_paths.map_or(!is_software, |most| most > 0);
        // Waves know matte things alone. Paths that meet others leave them; what else concerns all paths they do not know.
        let is_plain = !(tracing.has_cuts || tracing.has_normals || tracing.has_lines || frame.has_path_limits());
        Ok((tracing, in_waves && (is_plain || !tracing.has_materials)))
    }

    /// Makes the programs of steps. Returns the variants of each [`Kind`].
    fn prepare_real_time(&mut self, tracing: Variant, steps: &[Step]) -> Result<[Variant; 4], TraceError> {
        let is_exact = self.is_real_time_exact;
        let gathering = Variant { has_materials: false, ..tracing };
        let passes = self.real_time_passes.get_or_insert_with(|| {
            let module = |module: spirv::Module| if is_exact { module } else { module.fast() };
            let tracing = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME));
            let waves = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME_WAVES));
            let left = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME_LEFT));
            let gathering = Passes::new(&self.device, &self.bindings, module(spirv::REALTIME_PIXELS));
            [tracing.with_materials(module(spirv::REALTIME_MATERIALS)), waves, left, gathering]
        });
        let variants = [tracing, tracing, tracing, gathering];
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

/// Invocations that follow the paths of pixels, a tile of 8 x 8 or, at half the rate, 16 x 8 to a workgroup.
fn threads_that_trace(rate: Rate, (width, height): (u32, u32)) -> u32 {
    let columns = if rate == Rate::Half { 16 } else { 8 };
    width.div_ceil(columns) * height.div_ceil(8) * WORKGROUP
}

/// Most workgroups of a step: of one for all tiles of pixels, or of the one that follows all paths, those of the frame before among them.
fn most_workgroups(size: (u32, u32), rate: Rate) -> u64 {
    let tiles = u64::from(size.0.div_ceil(8)) * u64::from(size.1.div_ceil(8));
    let tiles_that_trace = u64::from(threads_that_trace(rate, size) / WORKGROUP);
    let others = LightCache::MOST_CHOSEN as u64 + 2 * u64::from(squares(size));
    tiles.max(tiles_that_trace + others.div_ceil(u64::from(WORKGROUP)))
}

/// The steps of a frame.
fn steps_of(
    params: &RealTimeParams,
    rate: Rate,
    (width, height): (u32, u32),
    in_waves: bool,
    rounds: u32,
) -> Vec<Step> {
    let has = |flag: u32| params.flags & flag != 0;
    let pixels = width.div_ceil(8) * height.div_ceil(8) * WORKGROUP;
    let that_trace = threads_that_trace(rate, (width, height));
    let cells = LightCache::CAPACITY as u32;
    let RealTimeParams { cells: tracing_cells, squares, again, .. } = *params;
    let mut steps = Vec::new();
    if in_waves {
        let all = Count::Of(tracing_cells + that_trace + squares);
        let first = [("trace_camera", Count::Of(that_trace + squares))];
        let all_do = ["trace_first", "trace_light", "trace_rays", "trace_ends"].map(|name| (name, all));
        let others = ["trace_on", "trace_on_rays", "trace_on", "trace_on_rays", "trace_rest"];
        let others = others.map(|name| (name, Count::Rest));
        let left = std::iter::once(("list_left", all)).chain(Left::steps(rounds));
        let left = left.filter(|_| has(flag::LEAVES));
        let named = first.into_iter().chain(all_do).chain(others).chain(left);
        steps.extend(named.map(|(name, count)| Step { name, count }));
        if again > 0 {
            let name = if has(flag::LEAVES) { "trace_before" } else { "trace_again" };
            steps.push(Step { name, count: Count::Of(again) });
        }
    } else {
        steps.push(Step { name: "trace", count: Count::Of(tracing_cells + that_trace + squares + again) });
    }
    if has(flag::CACHE) {
        steps.insert(0, Step { name: "choose_cells", count: Count::Of(cells) });
    }
    let mut add = |name, count| steps.push(Step { name, count: Count::Of(count) });
    if has(flag::FINDS_AGAIN) {
        add("compare_found", squares);
        add("doubt", pixels);
    }
    if has(flag::KNOWS) && !has(flag::SAME_VIEW) {
        add("reproject", pixels);
    }
    add("remember", that_trace);
    if has(flag::HALF) {
        add("remember_others", pixels);
    }
    if has(flag::CACHE) {
        add("end_cells", cells);
    }
    if has(flag::FILTER) {
        for name in FILTER_STEPS {
            add(name, pixels);
        }
    }
    add("show_picture", pixels);
    steps
}

/// The steps of the filter.
const FILTER_STEPS: [&str; 12] = [
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
    "filter_picture",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_step_has_more_workgroups_than_are_asked_of_the_device() {
        for size in [(1, 1), (61, 43), (1920, 1080), (2560, 1600), (3840, 2160)] {
            for rate in [Rate::Full, Rate::Half] {
                let squares = squares(size);
                let params = RealTimeParams {
                    // The rate is one of the flags.
                    flags: if rate == Rate::Half { u32::MAX } else { !flag::HALF },
                    cells: LightCache::MOST_CHOSEN as u32,
                    squares,
                    again: squares,
                    ..RealTimeParams::default()
                };
                let largest = |in_waves| {
                    let groups = |step: Step| match step.count {
                        Count::Of(count) => Some(u64::from(count.div_ceil(WORKGROUP))),
                        _ => None,
                    };
                    steps_of(&params, rate, size, in_waves, 4).into_iter().filter_map(groups).max().unwrap()
                };
                let (most, of_cells) = (most_workgroups(size, rate), LightCache::CAPACITY as u64 / 64);
                assert_eq!(largest(false), most.max(of_cells), "{size:?} {rate:?}");
                assert!(largest(true) <= most.max(of_cells), "{size:?} {rate:?}");
            }
        }
        // A device may launch no more than these: all tiles of pixels, but not with all paths that are followed beside theirs.
        let least_limit = 65_535;
        assert!(most_workgroups((2560, 1440), Rate::Full) <= least_limit);
        assert!(320 * 200 <= least_limit && most_workgroups((2560, 1600), Rate::Full) > least_limit);
        assert!(most_workgroups((2560, 1600), Rate::Half) <= least_limit);
    }
}
