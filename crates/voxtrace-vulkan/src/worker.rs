//! Tracing on one device for as long as it lives: scene, film and passes. Errors leave nothing in flight.

mod casting;
mod edits;
mod paging;
mod real_time;
mod rendering;
mod scene;
mod show;
mod waves;

use crate::accel::{Accel, AccelReport};
use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::capabilities::missing;
use crate::commands::{Finished, Job, Submitter, Then};
use crate::device::Device;
use crate::film::DeviceFilm;
use crate::method::{Settings, Traversal};
use crate::pages::Pages;
use crate::passes::Passes;
use crate::real_time::RealTime;
use crate::records::{Dispatch, FrameParams, binding};
use crate::scene::SceneBuffers;
use crate::schedule::{BatchSizer, TARGET_MS};
use crate::spirv;
use crate::statistics::Statistics;
use crate::transfer::Transfer;
use crate::variant::{Entry, Variant};
use crate::watch::Watch;
use crate::waves::Waves;
use ash::vk;
use bytemuck::bytes_of;
use gpu_allocator::MemoryLocation;
pub use show::Canvas;
use show::{Show, ShowPasses};
use std::sync::Arc;
use std::time::Instant;
use voxtrace_core::normals::Normals;
use voxtrace_core::shadow_catcher::ShadowCatcher;
use voxtrace_core::{Film, Frame, PackedScene, TraceError};
use voxtrace_realtime::Parts;
use voxtrace_scene::transform::Transform;

/// Samples that each part of a film in several parts gets in its turn, where all have `least`.
fn samples_of_a_turn(least: u32) -> u32 {
    if least == 0 { 1 } else { 4 }
}

/// Traces on one open device.
pub struct Worker {
    // Dropped first: it waits for the device.
    submitter: Submitter,
    passes: Passes,
    /// Of paths in waves, where the traversal has them.
    wave_passes: Option<Passes>,
    waves: Option<Waves>,
    /// Most paths of a wave, where it is said.
    most_paths: Option<u32>,
    /// A step of waves that is not done, for tests.
    left_out: Option<&'static str>,
    bindings: Bindings,
    transfer: Transfer,
    params: Buffer,
    nothing: Buffer,
    accel: Option<Accel>,
    scene: Option<SceneBuffers>,
    film: Option<DeviceFilm>,
    cast_buffers: Option<(Buffer, Buffer)>,
    show_passes: Option<ShowPasses>,
    /// Of real-time light, those that trace and the others.
    real_time_passes: Option<[Passes; 4]>,
    real_time: Option<RealTime>,
    real_time_parts: Parts,
    /// Whether its rays are traced exactly.
    is_real_time_exact: bool,
    /// Milliseconds of the picture that the last call of `render` wrote, where it did.
    shown_ms: Option<f64>,
    submit_ms: f64,
    /// Whether scenes may lie in pages.
    allows_pages: bool,
    /// Pixels that are traced together where the scene lies in pages.
    pixels_at_a_time: u64,
    render_batches: BatchSizer,
    cast_batches: BatchSizer,
    statistics: Statistics,
    settings: Settings,
    device: Arc<Device>,
}

impl Worker {
    /// A worker on a device.
    ///
    /// # Errors
    /// [`TraceError::Unsupported`] where the device lacks the traversal; what the driver answers.
    pub fn new(device: Arc<Device>, settings: Settings) -> Result<Self, TraceError> {
        let name = settings.traversal.name();
        if let Some(reason) = missing(device.info(), settings.traversal) {
            return Err(TraceError::Unsupported(format!("{} has no traversal {name}: {reason}", device.info().name)));
        }
        let submitter = Submitter::new(&device)?;
        let bindings = Bindings::new(&device)?;
        bindings.bind_submitter(&submitter);
        let usage = vk::BufferUsageFlags::UNIFORM_BUFFER | vk::BufferUsageFlags::STORAGE_BUFFER;
        let size = size_of::<FrameParams>() as u64;
        let params = Buffer::new(&device, "frame parameters", size, usage, MemoryLocation::CpuToGpu)?;
        bindings.bind(binding::FRAME, &params);
        bindings.bind(binding::FRAME_STORAGE, &params);
        bindings.bind(binding::REAL_TIME, &params);
        let nothing = Buffer::storage(&device, "placeholder", 0)?;
        for place in [
            binding::PIXELS,
            binding::RAYS,
            binding::HITS,
            binding::PRIMITIVES,
            binding::ENTRIES,
            binding::PAGES,
            binding::PATHS,
            binding::QUEUES,
            binding::MEMORY,
            binding::SCRATCH,
            binding::CELL_KEYS,
            binding::CELL_ROWS,
            binding::MOTIONS,
        ] {
            bindings.bind(place, &nothing);
        }
        let (matte, materials) = match settings.traversal {
            Traversal::Pipeline => (spirv::PIPELINE, spirv::PIPELINE_MATERIALS),
            Traversal::Query => (spirv::QUERY, spirv::QUERY_MATERIALS),
            _ => (spirv::WALK, spirv::WALK_MATERIALS),
        };
        let (matte, materials) = if settings.is_exact { (matte, materials) } else { (matte.fast(), materials.fast()) };
        let has_waves = settings.traversal == Traversal::Walk;
        let (waves, waves_of_materials) = match settings.is_exact {
            true => (spirv::WAVES, spirv::WAVES_MATERIALS),
            false => (spirv::WAVES.fast(), spirv::WAVES_MATERIALS.fast()),
        };
        Ok(Self {
            submitter,
            wave_passes: has_waves.then(|| Passes::new(&device, &bindings, waves).with_materials(waves_of_materials)),
            waves: None,
            most_paths: None,
            left_out: None,
            passes: Passes::new(&device, &bindings, matte).with_materials(materials),
            bindings,
            transfer: Transfer::new(&device),
            params,
            nothing,
            accel: None,
            scene: None,
            film: None,
            cast_buffers: None,
            show_passes: None,
            real_time_passes: None,
            real_time: None,
            real_time_parts: Parts::ALL,
            is_real_time_exact: false,
            shown_ms: None,
            submit_ms: TARGET_MS,
            allows_pages: true,
            pixels_at_a_time: u64::MAX,
            render_batches: BatchSizer::default(),
            cast_batches: BatchSizer::default(),
            statistics: Statistics::default(),
            settings,
            device,
        })
    }

    /// Whether the film is one of this frame, which goes on with it.
    pub fn has_film_of(&self, frame: &Frame) -> bool {
        self.film.as_ref().is_some_and(|film| frame.continues(&film.frame))
    }

    /// Samples that every pixel of the film has at least.
    pub fn samples(&self) -> u32 {
        let parts = self.film.iter().flat_map(|film| &film.parts);
        parts.map(|part| part.samples).min().unwrap_or(0)
    }

    /// What the acceleration structures of the scene take, `None` where there are none.
    pub fn accel_report(&self) -> Option<AccelReport> {
        self.accel.as_ref().map(Accel::report)
    }

    /// What the device did in the last call of `render`, `cast` or `set_placement`.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// A frame may ask for the module that knows all materials, and more about paths, whatever the scene holds.
    fn variant(&self, entry: Entry, (lens, sky): (u32, u32), frame: Option<&Frame>) -> Result<Variant, TraceError> {
        let scene = self.scene()?;
        let has_catcher = frame.is_some_and(|frame| ShadowCatcher::new(scene, frame).is_some());
        let has_lines = frame.is_some_and(|frame| !frame.lines.is_none());
        let is_clamped = frame.is_some_and(|frame| frame.clamp_indirect < f32::INFINITY);
        let knows_paths = has_catcher || has_lines || is_clamped;
        let is_exact = self.settings.is_exact;
        let primitive = self.primitive();
        let is_single = matches!(scene.instances(), [only] if only.grid_from_world == Transform::IDENTITY);
        let top_shift = self.scene.as_ref().map_or(0, |buffers| buffers.top_shift);
        let is_edited = self.scene.as_ref().is_some_and(|buffers| buffers.is_edited);
        let has_pages = self.scene.as_ref().is_some_and(|buffers| buffers.pages.is_some());
        let cells_have_blocks = self.scene.as_ref().is_some_and(|buffers| buffers.cells_have_blocks);
        let has_cuts = !scene.cuts.is_none();
        // No other pass asks what voxels are made of.
        let follows_paths = matches!(entry, Entry::RenderPath | Entry::RealTime(_));
        let has_normals = (entry == Entry::RenderEssay || follows_paths) && scene.normals() == Normals::Smooth;
        let has_materials = has_cuts || has_normals || (follows_paths && (knows_paths || !scene.is_matte()));
        Ok(Variant {
            entry,
            is_exact,
            is_single,
            top_shift,
            cells_have_blocks,
            primitive,
            lens,
            sky,
            has_materials,
            has_cuts,
            has_catcher,
            has_lines,
            has_normals,
            cells_skip: has_pages || is_edited,
            has_pages,
        })
    }

    fn scene(&self) -> Result<&Arc<PackedScene>, TraceError> {
        self.scene.as_ref().map(|buffers| &buffers.scene).ok_or(TraceError::NoScene)
    }

    /// Writes what all dispatches of a call read. Nothing may be in flight.
    fn set_params(&mut self, params: &FrameParams) {
        self.params.mapped_mut()[..size_of::<FrameParams>()].copy_from_slice(bytes_of(params));
    }

    /// Submits one launch of a prepared variant, and with it the showing of the film that it ends.
    fn submit(
        &mut self,
        step: &'static str,
        variant: Variant,
        dispatch: Dispatch,
        work: u64,
        show: Option<Show>,
    ) -> Result<Option<Finished>, TraceError> {
        let (bindings, passes) = (&self.bindings, &self.passes);
        let waves = self.waves.as_ref().zip(self.wave_passes.as_ref()).filter(|_| variant.is_in_waves());
        let record = |commands, offset| match waves {
            Some((waves, steps)) => {
                waves.record((steps, bindings), variant, (commands, offset), &dispatch);
            }
            None => passes.launch(variant, bindings, commands, offset, dispatch.count),
        };
        // Of waves each sample counts.
        let workgroups = match waves {
            Some(_) => dispatch.count.wrapping_mul(dispatch.samples),
            None => passes.proof(variant, dispatch.count),
        };
        let show = show.zip(self.show_passes.as_ref());
        let record_show = |commands, offset| {
            if let Some((show, passes)) = show {
                show.record((bindings, &self.device), passes, commands, offset);
            }
        };
        let then = show.map(|(show, passes)| Then {
            dispatch: show.dispatch(),
            workgroups: show.proof(passes),
            record: &record_show,
        });
        self.submitter.submit(&Job { step, work, dispatch, workgroups: Some(workgroups), record: &record, then })
    }
}

/// As in [`voxtrace_core::Tracer`].
impl Worker {
    /// Adds the samples that the frame lacks, until `until`, and shows the film on a canvas with the last ones, if that can be: see
    /// [`Self::take_shown`]. Returns whether it has them all or `progress` is cancelled.
    pub fn render(
        &mut self,
        frame: &Frame,
        progress: &mut Watch,
        until: Instant,
        canvas: Option<Canvas>,
    ) -> Result<bool, TraceError> {
        frame.check()?;
        self.scene()?;
        // A film of another frame goes before there is memory for the next one.
        let mut film = match self.film.take().filter(|film| frame.continues(&film.frame)) {
            Some(film) => film,
            None => self.new_film(frame)?,
        };
        film.frame = frame.clone();
        // A long call comes here in pieces, which are counted together.
        if !progress.is_begun() {
            self.statistics = Statistics::default();
        }
        let result = self.render_film(&mut film, frame, progress, until, canvas);
        self.stop_showing();
        self.film = Some(film);
        result
    }

    /// A black film, for which paths make room.
    fn new_film(&mut self, frame: &Frame) -> Result<DeviceFilm, TraceError> {
        match DeviceFilm::new(&self.device, &mut self.submitter, frame) {
            Err(TraceError::OutOfMemory { .. }) if self.waves.is_some() => {
                self.drop_waves();
                DeviceFilm::new(&self.device, &mut self.submitter, frame)
            }
            result => result,
        }
    }

    fn render_film(
        &mut self,
        film: &mut DeviceFilm,
        frame: &Frame,
        progress: &mut Watch,
        until: Instant,
        canvas: Option<Canvas>,
    ) -> Result<bool, TraceError> {
        if frame.aovs && film.aovs.is_none() {
            film.aovs = Some(self.aov_pixels(frame)?);
            self.statistics = Statistics::default();
        }
        let show = self.show_with_samples(film, canvas)?;
        // Several parts take turns, so that none is black when the work is broken off.
        let is_one = film.parts.len() == 1;
        loop {
            let least = film.parts.iter().map(|part| part.samples).min().unwrap_or(frame.samples);
            if least >= frame.samples || progress.is_cancelled() {
                return Ok(true);
            }
            let step = if is_one { frame.samples } else { samples_of_a_turn(least) };
            let target = least.saturating_add(step).min(frame.samples);
            for index in 0..film.parts.len() {
                if !self.render_part(film, (index, target), frame, progress, until, show)? {
                    return Ok(false);
                }
            }
        }
    }

    /// Lets submits take about so many milliseconds from now on.
    pub fn set_submit_ms(&mut self, submit_ms: f64) {
        self.submit_ms = submit_ms;
        (self.render_batches, self.cast_batches) = (BatchSizer::new(submit_ms), BatchSizer::new(submit_ms));
    }

    /// Leaves out a step of waves from now on, for tests.
    #[cfg(feature = "faults")]
    pub fn leave_out(&mut self, step: &'static str) {
        self.left_out = Some(step);
    }

    /// Empties the next pages, for tests.
    #[cfg(feature = "faults")]
    pub fn empty_pages(&mut self, count: usize) {
        let pages = self.scene.as_mut().and_then(|buffers| buffers.pages.as_mut());
        pages.into_iter().for_each(|pages| pages.emptied = count);
    }

    /// Pages of the scene that are marked, for tests.
    #[cfg(feature = "faults")]
    pub fn marked_pages(&mut self) -> Result<usize, TraceError> {
        let pages = self.scene.as_ref().and_then(|buffers| buffers.pages.as_ref());
        pages.map_or(Ok(0), |pages| pages.marked(&mut self.submitter, &mut self.transfer))
    }

    /// Whether scenes that do not fit lie there in pages.
    pub fn allow_pages(&mut self, allows_pages: bool) {
        self.allows_pages = allows_pages;
    }

    /// Bytes of the scene, and how much of it has room, where it lies on the device in pages.
    pub fn room(&self) -> Option<(u64, u64)> {
        let buffers = self.scene.as_ref()?;
        buffers.pages.as_ref().map(|pages| (Pages::bytes_of(buffers.scene.geometry()), pages.pool.size))
    }

    /// Bytes of pages of the scene that were uploaded and how often, `None` where it lies on the device whole.
    pub fn paged(&self) -> Option<(u64, u64)> {
        self.scene.as_ref()?.pages.as_ref().map(Pages::loaded)
    }

    pub fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        let ours = self.film.as_ref().ok_or(TraceError::NoFilm)?;
        ours.download(&mut self.submitter, &mut self.transfer, film)
    }

    pub fn resume(&mut self, frame: &Frame, film: &Film) -> Result<(), TraceError> {
        self.film = None;
        let mut ours = self.new_film(frame)?;
        ours.upload(&mut self.submitter, &mut self.transfer, film)?;
        self.film = Some(ours);
        Ok(())
    }
}
