//! From a scene to a saved picture in one expression.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use voxtrace_core::cuts::Cuts;
use voxtrace_core::denoise::{Features, denoise, denoise_while};
use voxtrace_core::dynamic::Patch;
use voxtrace_core::normals::Normals;
use voxtrace_core::packed::PackError;
use voxtrace_core::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, TraceError, Tracer};
use voxtrace_io::output::{Denoised, FilmFile, PictureFormat, PictureOptions, SceneStamp, ToneMap};
use voxtrace_scene::{Camera, Scene};

/// Renders pictures of one scene. It begins with the scene's first camera, or one that sees everything, 1280 × 720 pixels,
/// 64 samples a pixel, and the CPU; each method changes one of these.
///
/// ```
/// # fn main() -> Result<(), voxtrace::RenderError> {
/// # let folder = tempfile::tempdir().unwrap();
/// # let path = folder.path().join("a.png");
/// use voxtrace::{Renderer, scenes};
///
/// let scene = scenes::generate("church", Some(20_000)).expect("a built-in scene");
/// Renderer::new(&scene)?.camera("nave").size(160, 90).samples(4).render()?.save(&path)?;
/// # Ok(())
/// # }
/// ```
pub struct Renderer {
    scene: Arc<PackedScene>,
    tracer: Box<dyn Tracer>,
    frame: Frame,
    view: View,
    has_scene: bool,
    denoises: bool,
}

/// Which camera renders.
enum View {
    /// The scene's first, or where it has none, one that sees everything.
    Default,
    /// The scene's of this name.
    Named(String),
    /// One from outside.
    Given(Camera),
}

/// A picture could not be rendered or saved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The scene cannot be packed.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// The tracer failed.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The scene has no camera of that name.
    #[error("the scene has no camera {name:?}; there are {there_are}")]
    UnknownCamera {
        /// The name asked for.
        name: String,
        /// Names of the scene's cameras, with commas between them.
        there_are: String,
    },
    /// The file's name says no format that pictures are written in.
    #[error("{}: name it .png, .exr or .vxf", .0.display())]
    UnknownFormat(PathBuf),
    /// The file cannot be written.
    #[error("{}: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        #[source]
        error: std::io::Error,
    },
}

impl Renderer {
    /// A renderer of a scene, which it packs, with instances merged: [`PackedScene::pack_merged`].
    ///
    /// # Errors
    /// If the scene is larger than tracers can number.
    pub fn new(scene: &Scene) -> Result<Self, RenderError> {
        Ok(Self::of_packed(Arc::new(PackedScene::pack_merged(scene)?)))
    }

    /// A renderer of a scene that is packed already, for example opened from a `.vxt` file, or with instances kept apart.
    pub fn of_packed(scene: Arc<PackedScene>) -> Self {
        let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.portrait(16.0 / 9.0));
        let tracer = Box::new(CpuTracer::new(None));
        Self {
            scene,
            tracer,
            frame: Frame::new(camera, 1280, 720).samples(64),
            view: View::Default,
            has_scene: false,
            denoises: false,
        }
    }

    /// Traces on another device, for example `voxtrace_vulkan`'s tracer.
    #[must_use]
    pub fn tracer(mut self, tracer: Box<dyn Tracer>) -> Self {
        (self.tracer, self.has_scene) = (tracer, false);
        self
    }

    /// Looks through the scene's camera of this name.
    #[must_use]
    pub fn camera(mut self, name: impl Into<String>) -> Self {
        self.view = View::Named(name.into());
        self
    }

    /// Looks through a camera of the caller's.
    #[must_use]
    pub fn view(mut self, camera: Camera) -> Self {
        self.view = View::Given(camera);
        self
    }

    /// Shades surfaces with these normals; without it with those that the scene has, for most those of the faces of voxels.
    ///
    /// # Errors
    /// If the scene has no room for them.
    pub fn normals(mut self, normals: Normals) -> Result<Self, RenderError> {
        if normals != self.scene.normals() {
            (self.scene, self.has_scene) = (Arc::new(self.scene.with_normals(normals)?), false);
        }
        Ok(self)
    }

    /// Size of the picture, pixels.
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.frame = self.frame.size(width, height);
        self
    }

    /// Samples of each pixel.
    #[must_use]
    pub fn samples(mut self, samples: u32) -> Self {
        self.frame = self.frame.samples(samples);
        self
    }

    /// Seed of the random numbers: the same seed gives the same picture, bit for bit.
    #[must_use]
    pub fn seed(mut self, seed: u32) -> Self {
        self.frame = self.frame.seed(seed);
        self
    }

    /// Most surfaces that scatter one path.
    #[must_use]
    pub fn max_bounces(mut self, bounces: u32) -> Self {
        self.frame = self.frame.max_bounces(bounces);
        self
    }

    /// How light is computed.
    #[must_use]
    pub fn integrator(mut self, integrator: Integrator) -> Self {
        self.frame = self.frame.integrator(integrator);
        self
    }

    /// Whether the background is left transparent.
    #[must_use]
    pub fn transparent(mut self, transparent: bool) -> Self {
        self.frame = self.frame.transparent(transparent);
        self
    }

    /// Whether albedo, normal, depth, instance and voxel of each pixel are written too (EXR).
    #[must_use]
    pub fn aovs(mut self, aovs: bool) -> Self {
        self.frame = self.frame.aovs(aovs);
        self
    }

    /// Whether the noise is removed from pictures: by [`voxtrace_core::denoise`], with the same bits on every device. Films keep it.
    #[must_use]
    pub fn denoise(mut self, denoises: bool) -> Self {
        self.denoises = denoises;
        self
    }

    /// Shows only what these cuts keep; what they cut is shown filled.
    #[must_use]
    pub fn cuts(mut self, cuts: Cuts) -> Self {
        Arc::make_mut(&mut self.scene).cuts = cuts;
        self.has_scene = false;
        self
    }

    /// The packed scene, to cast rays into and to look things up in.
    pub fn scene(&self) -> &Arc<PackedScene> {
        &self.scene
    }

    /// Follows edits of the scene: see [`DynamicScene::take_patch`](crate::dynamic::DynamicScene::take_patch). The first patch copies the scene, unless
    /// nobody else has it.
    ///
    /// # Errors
    /// If the patch was made for another state of the scene, with nothing changed, or the tracer fails: the edits are followed all the same, and the tracer
    /// gets the whole scene with the next picture.
    pub fn patch(&mut self, patch: &Patch) -> Result<(), RenderError> {
        Arc::make_mut(&mut self.scene).apply_patch(patch).map_err(TraceError::from)?;
        // Where the tracer fails, it may have another scene.
        if std::mem::take(&mut self.has_scene) {
            self.tracer.patch(patch)?;
            self.has_scene = true;
        }
        Ok(())
    }

    /// Renders a picture.
    ///
    /// # Errors
    /// If the scene has no camera of the name asked for, or the tracer fails.
    pub fn render(&mut self) -> Result<Picture, RenderError> {
        let frame = self.frame.clone().camera(self.find_camera()?);
        if !self.has_scene {
            self.tracer.set_scene(&self.scene)?;
            self.has_scene = true;
        }
        let picture = Picture::trace(&mut *self.tracer, &self.scene, frame, self.denoises, &Progress::default())?;
        Ok(picture.expect("nobody cancels it"))
    }

    fn find_camera(&self) -> Result<Camera, RenderError> {
        let cameras = &self.scene.cameras;
        match &self.view {
            View::Given(camera) => Ok(camera.clone()),
            View::Default => {
                let aspect = self.frame.width as f32 / self.frame.height.max(1) as f32;
                Ok(cameras.first().cloned().unwrap_or_else(|| self.scene.portrait(aspect)))
            }
            View::Named(name) => cameras.iter().find(|camera| camera.name == *name).cloned().ok_or_else(|| {
                let names: Vec<&str> = cameras.iter().map(|camera| camera.name.as_str()).collect();
                let there_are = if names.is_empty() { "none".into() } else { names.join(", ") };
                RenderError::UnknownCamera { name: name.clone(), there_are }
            }),
        }
    }
}

/// A rendered picture.
#[derive(Clone, Debug)]
pub struct Picture {
    file: FilmFile,
    denoised: Option<Denoised>,
    tone_map: ToneMap,
}

impl Picture {
    /// Traces a picture of `scene`, which `tracer` has, and removes its noise if it `denoises`. `None` where `progress` was cancelled.
    ///
    /// # Errors
    /// What the tracer answers; [`TraceError::BadFrame`] before memory is taken for the picture.
    pub fn trace(
        tracer: &mut dyn Tracer,
        scene: &PackedScene,
        frame: Frame,
        denoises: bool,
        progress: &Progress,
    ) -> Result<Option<Self>, TraceError> {
        frame.check()?;
        let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
        let mut halfway = None;
        if denoises && frame.samples > 1 {
            render_into(&mut film, tracer, &frame.clone().samples(frame.samples / 2), progress)?;
            halfway = Some(film.pixels.clone());
        }
        render_into(&mut film, tracer, &frame, progress)?;
        if progress.is_cancelled() {
            return Ok(None);
        }
        film.earlier = halfway;
        let picture = Self::of_film(FilmFile { frame, scene: SceneStamp::of(scene), film });
        Ok(match denoises {
            true => picture.without_noise_while(scene, &|| !progress.is_cancelled()),
            false => Some(picture),
        })
    }

    /// Brightens the picture by a number of stops: each doubles its radiance on the way to the screen.
    #[must_use]
    pub fn exposure(mut self, stops: f32) -> Self {
        self.tone_map.exposure = stops;
        self
    }

    /// How radiance becomes a signal for the screen.
    #[must_use]
    pub fn tone_map(mut self, tone_map: ToneMap) -> Self {
        self.tone_map = tone_map;
        self
    }

    /// Radiance sums, sample counts and AOVs of its pixels.
    pub fn film(&self) -> &Film {
        &self.file.film
    }

    /// A picture of a film, with its noise.
    pub fn of_film(file: FilmFile) -> Self {
        Self { file, denoised: None, tone_map: ToneMap::default() }
    }

    /// The same picture without its noise, which `scene`, that of the film, tells from its details.
    #[must_use]
    pub fn without_noise(self, scene: &PackedScene) -> Self {
        let features = Features::of(scene, &self.file.frame, &self.file.film);
        let radiance = denoise(&self.file.film, &features);
        self.denoised_as(Denoised { radiance, filter: "voxtrace" })
    }

    /// As [`Self::without_noise`], as long as it is `wanted`, which is asked now and then, on several threads, and which says no for good; `None` then.
    #[must_use]
    pub fn without_noise_while(self, scene: &PackedScene, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Self> {
        let features = Features::of_while(scene, &self.file.frame, &self.file.film, wanted)?;
        let radiance = denoise_while(&self.file.film, &features, wanted)?;
        Some(self.denoised_as(Denoised { radiance, filter: "voxtrace" }))
    }

    /// The same picture as another filter made it: `denoised` has the radiance of each of its pixels.
    #[must_use]
    pub fn denoised_as(self, denoised: Denoised) -> Self {
        Self { denoised: Some(denoised), ..self }
    }

    /// The film with the frame and the scene that it is of.
    pub fn film_file(&self) -> &FilmFile {
        &self.file
    }

    /// The mean radiance of each pixel without its noise, where that was removed.
    pub fn denoised(&self) -> Option<&Denoised> {
        self.denoised.as_ref()
    }

    /// The tone map, with its exposure.
    pub fn tone(&self) -> ToneMap {
        self.tone_map
    }

    /// The picture as a PNG file of 8 bits a channel.
    ///
    /// # Panics
    /// Never: memory does not refuse to be written.
    pub fn to_png(&self) -> Vec<u8> {
        let options = PictureOptions { tone_map: self.tone_map, ..PictureOptions::default() };
        let mut bytes = Vec::new();
        let encoded = self.file.encode_denoised(&mut bytes, PictureFormat::Png, &options, self.denoised.as_ref());
        encoded.expect("memory does not refuse to be written");
        bytes
    }

    /// Writes the picture: `.png` for people, `.exr` with linear radiance, `.vxf` for the film itself. The file is whole or what
    /// it was before.
    ///
    /// # Errors
    /// If the name says no such format or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), RenderError> {
        self.save_while(path, &|| true)
    }

    /// As [`Self::save`], as long as it is `wanted`, which says no for good: once it is not, saving ends soon, and the file is what it was before. Only the
    /// compression of a PNG is not interrupted.
    ///
    /// # Errors
    /// As [`Self::save`], and [`RenderError::Io`] once it is not wanted.
    pub fn save_while(&self, path: impl AsRef<Path>, wanted: &(dyn Fn() -> bool + Sync)) -> Result<(), RenderError> {
        let path = path.as_ref();
        if PictureFormat::of(path).is_none() {
            return Err(RenderError::UnknownFormat(path.into()));
        }
        let options = PictureOptions { tone_map: self.tone_map, ..PictureOptions::default() };
        let saved = self.file.save_denoised_while(path, &options, self.denoised.as_ref(), wanted);
        saved.map_err(|error| RenderError::Io { path: path.into(), error })
    }
}

/// Renders a frame and reads its film, of no more samples than are asked for: a tracer keeps those that an earlier picture of the frame has.
fn render_into(film: &mut Film, tracer: &mut dyn Tracer, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
    tracer.render(frame, progress)?;
    tracer.read(film)?;
    if film.sample_range().1 > frame.samples && !progress.is_cancelled() {
        // Another frame makes it forget that one.
        let other = frame.clone().seed(!frame.seed).size(1, 1).samples(1);
        tracer.render(&other, &Progress::default())?;
        tracer.render(frame, progress)?;
        tracer.read(film)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_core::{DynamicScene, Edit, Placement};
    use voxtrace_scene::glam::{IVec3, Vec3};
    use voxtrace_scene::grid::VoxelBox;
    use voxtrace_scene::{Hit, Material, Ray, Shape, VoxelGrid};

    #[test]
    fn a_picture_does_not_depend_on_those_that_were_rendered_before() {
        let scene = voxtrace_scenes::generate("church", Some(20_000)).unwrap();
        let renderer = || Renderer::new(&scene).unwrap().size(24, 16).denoise(true);
        let bytes = |renderer: &mut Renderer| renderer.render().unwrap().film_file().to_bytes();
        let four = bytes(&mut renderer().samples(4));
        let mut again = renderer().samples(4);
        assert_eq!([bytes(&mut again), bytes(&mut again)], [four.clone(), four.clone()]);
        let mut fewer = renderer().samples(9);
        assert_ne!(bytes(&mut fewer), four, "the comparison sees samples");
        assert_eq!(bytes(&mut fewer.samples(4)), four);
    }

    #[test]
    fn a_picture_that_is_too_large_is_refused_before_memory_is_taken_for_it() {
        let scene = voxtrace_scenes::generate("church", Some(20_000)).unwrap();
        let rendered = Renderer::new(&scene).unwrap().size(65_535, 65_535).samples(1).render();
        assert!(matches!(rendered, Err(RenderError::Trace(TraceError::BadFrame(_)))));
    }

    /// The processor, but it cannot follow edits.
    struct Stubborn(CpuTracer);

    impl Tracer for Stubborn {
        fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
            self.0.set_scene(scene)
        }

        fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
            self.0.set_placement(placement)
        }

        fn patch(&mut self, _: &Patch) -> Result<(), TraceError> {
            Err(TraceError::OutOfMemory { needed: 2, available: 1 })
        }

        fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
            self.0.cast_into(rays, hits)
        }

        fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
            self.0.render(frame, progress)
        }

        fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
            self.0.read(film)
        }

        fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
            self.0.resume(frame, film)
        }

        fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
            self.0.set_moment(placement, frame)
        }
    }

    #[test]
    fn a_tracer_that_fails_to_follow_an_edit_has_it_in_the_next_picture() {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let scene = Scene::from_grid("one", grid, vec![Material::from_srgb([200, 90, 40])]);
        let mut edited = DynamicScene::new(PackedScene::pack_merged(&scene).unwrap()).unwrap();
        let camera = Camera::look_at(Vec3::new(12.0, 14.0, 9.0), Vec3::splat(1.5));
        let renderer = |packed: &PackedScene| {
            Renderer::of_packed(Arc::new(packed.clone())).view(camera.clone()).size(24, 16).samples(1)
        };
        let mut following = renderer(edited.scene()).tracer(Box::new(Stubborn(CpuTracer::new(None))));
        let before = following.render().unwrap();
        let region = VoxelBox { min: IVec3::ZERO, max: IVec3::splat(3) };
        edited.edit(0, &Edit::Fill { shape: Shape::Box(region), material: Some(0) }).unwrap();
        let patch = edited.take_patch();
        assert!(matches!(following.patch(&patch), Err(RenderError::Trace(TraceError::OutOfMemory { .. }))));
        let after = following.render().unwrap();
        assert_eq!(after.film(), renderer(edited.scene()).render().unwrap().film());
        assert_ne!(after.film(), before.film(), "the edit shows");
    }
}
