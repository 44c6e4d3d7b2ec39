//! The films of one scene in one size. Noisy ones are kept as films, exactly; those to compare with as EXR of 16-bit floats, whose steps of 2⁻¹¹ are
//! far below their noise: they are small enough to be carried from the machine that made them.

use super::{Args, Outcome};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::difference::Shown;
use voxtrace::import::{Content, ImportOptions, load};
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp, ToneMap};
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, Tracer};
use voxtrace_tests::still_lifes;
use voxtrace_vulkan::{Request, Traversal, choose};

/// Seed of the pictures of many samples: another one, so that they do not contain the noise that they measure.
const REFERENCE_SEED: u32 = 1;
/// Samples rendered at a time.
const STEP: u32 = 32;
/// How often a film in the making is kept.
const KEEP_EVERY: Duration = Duration::from_secs(60);

pub struct Films<'a> {
    args: &'a Args,
    pub name: &'a str,
    pub scene: Arc<PackedScene>,
    /// That of the noisy picture.
    pub frame: Frame,
}

impl<'a> Films<'a> {
    pub fn of(args: &'a Args, name: &'a str, (width, height): (u32, u32)) -> Outcome<Self> {
        let scene = scene(args, name)?;
        let camera = scene.cameras.first().ok_or("a scene without a camera")?.clone();
        let frame = Frame::new(camera, width, height).samples(args.samples);
        Ok(Self { args, name, scene, frame: frame.max_bounces(still_lifes::max_bounces(name)) })
    }

    fn path(&self, what: &str) -> PathBuf {
        let (Frame { width, height, .. }, voxels) = (&self.frame, self.args.voxels);
        let voxels = voxels.map_or(String::new(), |voxels| format!("-{voxels}"));
        self.args.cache.join(format!("{}{voxels}-{width}x{height}-{what}", self.name))
    }

    fn tracer(&self, is_fast: bool) -> Outcome<Box<dyn Tracer + Send>> {
        let mut tracer: Box<dyn Tracer + Send> = match &self.args.renderer.device {
            None => Box::new(CpuTracer::new(None)),
            device => {
                let request =
                    Request { device: device.clone(), traversal: Some(Traversal::Walk), ..Request::default() };
                let choice = choose(&Request { is_fast, ..request })?;
                eprintln!("{}", choice.reason);
                choice.tracer
            }
        };
        tracer.set_scene(&self.scene)?;
        Ok(tracer)
    }

    fn save(&self, frame: &Frame, film: Film, path: &Path) -> Outcome<()> {
        let options = PictureOptions { sixteen_bits: true, ..PictureOptions::default() };
        let file = FilmFile { frame: frame.clone(), scene: SceneStamp::of(&self.scene), film };
        Ok(file.save_picture(path, &options)?)
    }

    /// The film to denoise, which knows how it stood halfway.
    pub fn noisy(&self) -> Outcome<Film> {
        let path = self.path(&format!("{}.vxf", self.args.samples));
        if let Ok(file) = FilmFile::open(&path) {
            return Ok(file.film);
        }
        let mut tracer = self.tracer(false)?;
        let mut film = Film::new(1, 1, self.frame.region, 0);
        tracer.render(&self.frame.clone().samples(self.args.samples / 2), &Progress::default())?;
        tracer.read(&mut film)?;
        let half = film.pixels.clone();
        tracer.render(&self.frame, &Progress::default())?;
        tracer.read(&mut film)?;
        film.earlier = Some(half);
        self.save(&self.frame, film.clone(), &path)?;
        Ok(film)
    }

    /// Four times the samples.
    pub fn more(&self) -> Outcome<Shown> {
        self.shown(&self.frame.clone().samples(4 * self.args.samples), false)
    }

    /// The picture to compare with.
    pub fn reference(&self) -> Outcome<Shown> {
        self.shown(&self.frame.clone().samples(self.args.reference).seed(REFERENCE_SEED), self.args.renderer.fast)
    }

    /// The picture of a frame, kept as EXR; while it is made, as a film.
    fn shown(&self, frame: &Frame, is_fast: bool) -> Outcome<Shown> {
        let path = self.path(&format!("{}.exr", frame.samples));
        if !path.exists() {
            let unfinished = path.with_extension("part.vxf");
            let film = self.film(frame, is_fast, &unfinished)?;
            self.save(frame, film, &path)?;
            _ = std::fs::remove_file(unfinished);
        }
        Ok(Shown::open(&path, &ToneMap::default())?)
    }

    fn film(&self, frame: &Frame, is_fast: bool, unfinished: &Path) -> Outcome<Film> {
        let start = Instant::now();
        let mut tracer = self.tracer(is_fast)?;
        let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
        if let Ok(file) = FilmFile::open(unfinished) {
            film = file.film;
            tracer.resume(&file.frame, film.clone())?;
        }
        let (mut done, mut kept) = (film.sample_range().0, Instant::now());
        while done < frame.samples {
            done = (done + STEP).min(frame.samples);
            let part = frame.clone().samples(done);
            tracer.render(&part, &Progress::default())?;
            if done == frame.samples || kept.elapsed() > KEEP_EVERY {
                tracer.read(&mut film)?;
            }
            if done < frame.samples && kept.elapsed() > KEEP_EVERY {
                self.save(&part, film.clone(), unfinished)?;
                kept = Instant::now();
                eprintln!("{}: {done} of {} samples", unfinished.display(), frame.samples);
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        eprintln!("{}, {}×{}, {done} samples: {seconds:.1} s", self.name, frame.width, frame.height);
        Ok(film)
    }
}

/// A scene, kept packed.
fn scene(args: &Args, name: &str) -> Outcome<Arc<PackedScene>> {
    let path = super::common::packed_scene(&args.cache, name, args.voxels)?;
    match load(&path, &ImportOptions::default())?.content {
        Content::Packed(packed) => Ok(Arc::new(*packed)),
        Content::Scene(scene) => Ok(Arc::new(PackedScene::pack(&scene)?)),
    }
}
