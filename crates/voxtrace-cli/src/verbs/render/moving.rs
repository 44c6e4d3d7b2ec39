//! Frames of an animation: the scene is put in motion, and stands for each frame where it is then.

use super::denoise::Filter;
use super::files::Job;
use super::{RenderArgs, Resumed};
use crate::animation::{Cast, Director, Setting, Stage};
use crate::camera_file::CameraFile;
use crate::failure::Failure;
use crate::interrupt;
use crate::parse::Size;
use crate::report::Report;
use crate::session::trace_failure;
use crate::views::ViewArgs;
use std::path::Path;
use std::sync::Arc;
use voxtrace::glam::Vec3;
use voxtrace::motion::MovingTracer;
use voxtrace::output::SceneStamp;
use voxtrace::{Camera, PackedScene, Tracer};

impl RenderArgs {
    /// The films to go on with.
    pub(super) fn open_films(&self, film: &Path, director: Option<&Director>) -> Result<Resumed, Failure> {
        let frames = director.map(|director| director.frames_to_resume(&self.view)).transpose()?;
        Resumed::open(film, frames.or_else(|| self.view.frames()))
    }

    /// Puts a scene in motion.
    pub(super) fn stage(
        &self,
        cast: Cast,
        director: &Director,
        framed: &PackedScene,
        scene: &mut PackedScene,
        camera_file: Option<&CameraFile>,
        size: Size,
    ) -> Result<Stage, Failure> {
        if self.view.camera.len() > 1 || self.view.camera.first().is_some_and(|name| name == "all") {
            return Err(Failure::usage("an animation has one camera, but several were named"));
        }
        // A turntable begins with the camera itself; without one, nothing is turned.
        let one = |name: Option<&str>| {
            let named = name.map_or_else(|| self.view.camera.clone(), |name| vec![name.to_owned()]);
            let view = ViewArgs { camera: named, frames: Some(1..=1), flight: None, ..self.view.clone() };
            let file = camera_file.filter(|_| name.is_none());
            let views = view.views(framed, framed, file, size)?;
            let first: Option<Camera> = views.into_iter().next().map(|view| view.camera);
            first.ok_or_else(|| Failure::usage("an animation has one camera"))
        };
        let with_lens = |mut camera: Camera| {
            camera.fov_y = self.view.place.fov.unwrap_or(camera.fov_y);
            self.view.lens.apply(&mut camera, framed, size)?;
            Ok(camera)
        };
        let setting = Setting {
            view: &self.view,
            hidden: self.changes.hidden(),
            framed,
            camera: &one,
            with_lens: &with_lens,
            scene_file: self.scene.file(),
            is_physical: self.light.is_physical(),
        };
        cast.stage(director, &setting, scene)
    }
}

impl RenderArgs {
    /// Renders pictures, one after the other, those of an animation as its stage has them.
    pub(super) fn render_all(
        &self,
        jobs: &[Job],
        stage: Option<&Stage>,
        (scene, stamp): (PackedScene, SceneStamp),
        background: Option<Vec3>,
        mut resume: Option<Resumed>,
        report: &mut Report,
    ) -> Result<(), Failure> {
        let filter = self.quality.denoise.map(Filter::open).transpose()?;
        let scene = Arc::new(scene);
        let mut tracer = MovingTracer::new(self.tracer.open(&scene, report)?);
        for (number, job) in jobs.iter().enumerate() {
            interrupt::check()?;
            // Another process may have made it meanwhile.
            if self.files.skips(job) {
                let names: Vec<String> = job.outputs.iter().map(|path| path.display().to_string()).collect();
                report.remark(&format!("{}: left out, {} is there", job.name, names.join(", ")));
                continue;
            }
            let frame = stage.zip(job.number);
            let shown = frame.map(|(stage, frame)| set_shot(stage, frame, &mut tracer, &scene, &stamp)).transpose()?;
            let (scene, stamp) = shown.as_ref().map_or((&*scene, &stamp), |(scene, stamp)| (scene, stamp));
            let film = resume.as_mut().map(|resume| resume.film(job.number)).transpose()?.flatten();
            let start = film.map(|film| self.check_film(job, film, stamp)).transpose()?;
            report.follow(jobs[number + 1..].iter().filter(|job| !self.files.skips(job)).count());
            self.render(&mut tracer, job, start, (scene, stamp), (filter.as_ref(), background), report)?;
        }
        Ok(())
    }
}

/// Puts things where they are in a frame. Returns the scene as it is then, and the stamp of its films.
fn set_shot(
    stage: &Stage,
    frame: u32,
    tracer: &mut MovingTracer,
    scene: &PackedScene,
    stamp: &SceneStamp,
) -> Result<(PackedScene, SceneStamp), Failure> {
    let (scene, stamp) = stage.scene_of(frame, scene, stamp)?;
    if stage.moves_light() {
        tracer.set_scene(&Arc::new(scene.clone())).map_err(trace_failure)?;
    }
    tracer.set_shot(stage.shot(frame)).map_err(trace_failure)?;
    Ok((scene, stamp))
}
