//! The CPU tracer: all cores, tile by tile, in waves of rays. The reference for every other tracer.

mod in_media;
mod ray_counts;
mod shadow_rays;
mod tile;
mod wave;

use crate::aov;
use crate::dynamic::Patch;
use crate::film::{AovPixel, Film};
use crate::frame::{Frame, Integrator};
use crate::held_film::HeldFilm;
use crate::light::Lights;
use crate::medium::Surrounding;
use crate::packed::{PackedScene, Placement};
use crate::shadow_catcher::ShadowCatcher;
use crate::tracer::{Progress, TraceError, Tracer};
use crate::walk;
use rayon::prelude::*;
use std::ops::Add;
use std::sync::{Arc, OnceLock};
use voxtrace_scene::camera::CameraFrame;
use voxtrace_scene::ray::{Hit, Ray};
use wave::Wave;

pub use ray_counts::RayCounts;

/// Rays that one thread casts at a time.
const RAYS_AT_A_TIME: usize = 1024;
/// Paths that a tile follows at a time, so that their state stays in the second-level cache.
const PATHS_AT_A_TIME: usize = 4096;

/// Traces on the processor. The picture does not depend on the number of threads or the size of the tiles.
pub struct CpuTracer {
    pool: Option<rayon::ThreadPool>,
    tile_size: u32,
    has_whole_tiles: Option<bool>,
    scene: Option<Arc<PackedScene>>,
    /// That of the scene, once it was asked for.
    surrounding: OnceLock<Option<Surrounding>>,
    film: HeldFilm,
    rays: RayCounts,
}

impl CpuTracer {
    /// A tracer of `threads` threads; `None`, or where the system gives no threads, uses rayon's global pool.
    pub fn new(threads: Option<usize>) -> Self {
        let pool = threads.and_then(|count| rayon::ThreadPoolBuilder::new().num_threads(count).build().ok());
        Self {
            pool,
            tile_size: 32,
            has_whole_tiles: None,
            scene: None,
            surrounding: OnceLock::new(),
            film: HeldFilm::default(),
            rays: RayCounts::default(),
        }
    }

    /// The same tracer with square tiles of `tile_size` pixels, at least 1.
    pub fn with_tile_size(self, tile_size: u32) -> Self {
        Self { tile_size: tile_size.max(1), ..self }
    }

    /// The same tracer, which after the first sample gives each tile all its samples before it goes on to the next, or does not. By itself it does so where the
    /// scene is larger than memory: what a tile's rays come to is then read from the disk once, not once for each few samples.
    #[doc(hidden)]
    pub fn with_whole_tiles(self, has_whole_tiles: bool) -> Self {
        Self { has_whole_tiles: Some(has_whole_tiles), ..self }
    }

    /// The rays of the last call of [`Tracer::render`], and the walks that traced them.
    pub fn ray_counts(&self) -> RayCounts {
        self.rays
    }

    /// The vector instructions that it uses on this machine, for reports.
    pub fn simd_name() -> &'static str {
        walk::Instructions::chosen().name()
    }

    fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// The scene that was set, as edits have made it.
    ///
    /// # Errors
    /// [`TraceError::NoScene`] before a scene was set.
    #[doc(hidden)]
    pub fn scene(&self) -> Result<Arc<PackedScene>, TraceError> {
        self.scene.clone().ok_or(TraceError::NoScene)
    }
}

impl Tracer for CpuTracer {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.scene = Some(Arc::clone(scene));
        self.surrounding = OnceLock::new();
        self.film.forget();
        Ok(())
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        self.scene = Some(Arc::new(self.scene()?.with_placement(placement)?));
        self.surrounding = OnceLock::new();
        self.film.forget();
        Ok(())
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        let scene = self.scene.as_mut().ok_or(TraceError::NoScene)?;
        if !patch.is_empty() {
            // It shares the arrays, which would be copied.
            self.surrounding = OnceLock::new();
            Arc::make_mut(scene).apply_patch(patch)?;
            self.film.forget();
        }
        Ok(())
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        let scene = self.scene()?;
        assert_eq!(rays.len(), hits.len(), "one hit for each ray");
        self.install(|| {
            let chunks = rays.par_chunks(RAYS_AT_A_TIME).zip(hits.par_chunks_mut(RAYS_AT_A_TIME));
            chunks.for_each(|(rays, hits)| {
                walk::cast_batch(&scene, rays, hits);
            });
            scene.turn_to_parts(hits);
        });
        Ok(())
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        frame.check()?;
        let scene = self.scene()?;
        frame.check_in(&scene)?;
        let mut film = self.film.begin(frame);
        let camera = frame.camera.frame(frame.width, frame.height);
        let has_whole_tiles = self.has_whole_tiles.unwrap_or_else(|| scene.is_larger_than_memory());
        self.rays = self.install(|| {
            let mut rays = RayCounts::default();
            if frame.aovs && film.aovs.is_none() {
                film.aovs = Some(aov_pixels(&scene, frame, &camera));
            }
            let has_media = frame.integrator == Integrator::Path && scene.has_media();
            let sky = frame.light_group.sky(&scene.sky);
            let lights = Lights::new(&scene).of_group(frame.light_group, &sky);
            let catcher = ShadowCatcher::new(&scene, frame);
            let surrounding = if has_media { self.surrounding.get_or_init(|| Surrounding::of(&scene)) } else { &None };
            let surrounding = surrounding.as_ref();
            let context =
                wave::RenderContext { scene: &scene, lights, frame, camera: &camera, has_media, surrounding, catcher };
            loop {
                let least = film.sample_range().0;
                if progress.is_cancelled() || least >= frame.samples {
                    break;
                }
                let next = target_after(least, frame, self.tile_size);
                let last = if has_whole_tiles && least > 0 { frame.samples } else { next };
                let targets = Targets { next, step: next - least, last };
                rays = rays + add_pass(&context, &mut film, self.tile_size, targets, progress);
            }
            rays
        });
        self.film.hold(frame, film);
        Ok(())
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        self.film.read(film)
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        self.film.resume(frame, film)
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        // A placement that does not fit leaves the film.
        let placed = placement.map(|placement| self.scene()?.with_placement(placement).map_err(TraceError::from));
        let placed = placed.transpose()?;
        let film = self.film.take_for(frame)?;
        if let Some(scene) = placed {
            self.scene = Some(Arc::new(scene));
            self.surrounding = OnceLock::new();
        }
        self.film.hold(frame, film);
        Ok(())
    }
}

/// Samples that every pixel has after the pass that begins when each has `least`. The first pass gives one, so that a picture
/// that is ended early is soon whole; later ones fill a tile's wave.
fn target_after(least: u32, frame: &Frame, tile_size: u32) -> u32 {
    let edge = |length: u32| length.min(tile_size) as usize;
    let pixels = edge(frame.region.width()) * edge(frame.region.height());
    let samples = if least == 0 { 1 } else { (PATHS_AT_A_TIME / pixels).max(1) as u32 };
    least.saturating_add(samples).min(frame.samples)
}

/// Samples that each pixel has one after the other, in steps that fill a tile's wave, before the next tile comes.
#[derive(Clone, Copy)]
struct Targets {
    next: u32,
    step: u32,
    last: u32,
}

/// Brings each pixel up to the last of the targets, tile by tile; pixels that an earlier pass left ahead wait for the others. Stops
/// between tiles, and between targets, when cancelled.
fn add_pass(
    context: &wave::RenderContext,
    film: &mut Film,
    tile_size: u32,
    Targets { next, step, last }: Targets,
    progress: &Progress,
) -> RayCounts {
    let tiles = tile::tiles_mut(&mut film.pixels, film.region, tile_size);
    let counts = tiles.into_par_iter().map_init(Wave::default, |wave, mut tile| {
        let (mut counts, mut target) = (RayCounts::default(), next);
        while !progress.is_cancelled() {
            let added = wave.render(context, &mut tile, target);
            progress.add(added.camera);
            counts = counts + added;
            if target == last {
                break;
            }
            target = target.saturating_add(step).min(last);
        }
        counts
    });
    counts.reduce(RayCounts::default, RayCounts::add)
}

/// What the rays through the middle of the region's pixels meet.
fn aov_pixels(scene: &PackedScene, frame: &Frame, camera: &CameraFrame) -> Vec<AovPixel> {
    let region = frame.region;
    let mut pixels = vec![AovPixel::MISS; region.pixels()];
    pixels.par_chunks_mut(region.width() as usize).enumerate().for_each(|(row, pixels)| {
        let rays = aov::rays_of_row(frame, camera, row as u32);
        let mut hits = vec![Hit::MISS; rays.len()];
        walk::cast_batch(scene, &rays, &mut hits);
        for (pixel, (ray, hit)) in pixels.iter_mut().zip(rays.iter().zip(&hits)) {
            *pixel = aov::aov_of(scene, &frame.lines, ray, hit);
        }
    });
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{IVec3, Vec3};
    use voxtrace_scene::{Camera, Material, Scene, VoxelGrid};

    fn row(length: i32) -> PackedScene {
        let mut grid = VoxelGrid::new();
        (0..length).for_each(|x| _ = grid.set(IVec3::new(x, 0, 0), 0));
        PackedScene::pack(&Scene::from_grid("row", grid, vec![Material::default()])).unwrap()
    }

    #[test]
    fn a_moment_that_is_refused_leaves_the_film() {
        let (scene, other) = (row(3), row(4));
        let frame = Frame::new(Camera::look_at(Vec3::new(9.0, 8.0, 7.0), Vec3::ZERO), 8, 6);
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&Arc::new(scene.clone())).unwrap();
        tracer.render(&frame, &Progress::default()).unwrap();
        let film = |tracer: &mut CpuTracer| {
            let mut film = Film::new(8, 6, frame.region, 0);
            tracer.read(&mut film).map(|()| film)
        };
        let before = film(&mut tracer).unwrap();
        let foreign = tracer.set_moment(Some(other.placement()), &frame);
        assert!(matches!(foreign, Err(TraceError::Placement(_))), "{foreign:?}");
        assert_eq!(film(&mut tracer).as_ref(), Ok(&before));
        let larger = tracer.set_moment(Some(scene.placement()), &frame.clone().size(9, 6));
        assert!(matches!(larger, Err(TraceError::BadFrame(_))), "{larger:?}");
        assert_eq!(film(&mut tracer).as_ref(), Ok(&before));
        tracer.set_moment(Some(scene.placement()), &frame).unwrap();
        assert_eq!(film(&mut tracer).as_ref(), Ok(&before));
    }
}
