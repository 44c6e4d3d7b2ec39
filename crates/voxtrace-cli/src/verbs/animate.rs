//! `voxtrace animate`: from a scene that moves to frames and clips. Each frame is a picture as `render` makes it.

use super::render::RenderArgs;
use crate::animation::{Director, MotionArgs, Script, is_script};
use crate::clip::{Clip, ClipArgs};
use crate::failure::{Failure, Kind};
use crate::outputs;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::output::PictureFormat;

const OUTPUT_HELP: &str = "Clip to write: .mp4, .gif, .png or .apng; or frames, with #### where their number goes: shot_####.png, .exr or .vxf; \
    may be repeated";
const FRAMES_HELP: &str = "Frames to render, from 1 on [default: all of the animation]";

/// Render the frames of an animation, as pictures or as a clip
///
/// SCENE is a scene or an animation in TOML (docs/animation.md), which names its scene. Outputs with #### are frames (.png, .exr, .vxf);
/// others are clips: .mp4, .gif, .png (animated).
#[derive(clap::Args, Clone, Debug)]
// What some options of `render` mean there.
#[command(
    mut_arg("output", |output| output.help(OUTPUT_HELP)),
    mut_arg("frames", |frames| frames.help(FRAMES_HELP)),
    mut_arg("exposure", |exposure| exposure.help("Exposure in stops (PNG and clips)")),
    mut_arg("tone_map", |operator| operator.help("Tone mapping operator (PNG and clips)"))
)]
pub struct AnimateArgs {
    #[command(flatten)]
    motion: MotionArgs,
    #[command(flatten)]
    clip: ClipArgs,
    #[command(flatten, next_help_heading = None)]
    render: RenderArgs,
}

impl AnimateArgs {
    /// Renders every frame, and makes clips of them.
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        if self.render.picture.output.is_empty() {
            return Err(
                Failure::usage("animate needs an output").hint("-o shot_####.png, clip.mp4, clip.gif or clip.png")
            );
        }
        let path = PathBuf::from(self.render.scene.scene());
        let script = is_script(&path).then(|| Script::open(&path)).transpose()?;
        if let Some(script) = &script {
            let scene = script.scene.clone();
            let scene = scene.ok_or_else(|| {
                Failure::input(format!("{}: `scene` is missing", path.display()))
                    .hint("it names a file beside this one, or a built-in scene")
            })?;
            self.render.scene.scenes = vec![scene];
        }
        let is_known =
            |path: &PathBuf| Clip::is_clip(path) || PictureFormat::of(path).is_some() || path.as_os_str() == "-";
        if let Some(unknown) = self.render.picture.output.iter().find(|path| !is_known(path)) {
            let failure = Failure::usage(format!("{}: unknown kind of clip or picture", unknown.display()));
            return Err(failure.hint("name it clip.mp4, clip.gif or clip.png, or frames shot_####.png, .exr or .vxf"));
        }
        let frames_of = |path: &PathBuf| !Clip::is_clip(path);
        let (mut frames, clips): (Vec<PathBuf>, Vec<PathBuf>) =
            self.render.picture.output.drain(..).partition(frames_of);
        outputs::refuse_twice(&clips.iter().map(PathBuf::as_path).collect::<Vec<_>>())?;
        self.clip.check(&clips, self.render.size_of_pictures())?;
        self.clip.warn_of_needless(&clips, report);
        // Before frames are made; what the scene names is known later, and asked about before a clip is written.
        self.render.scene.note();
        clips.iter().try_for_each(|clip| outputs::check(clip))?;
        let director = Director { script, args: self.motion.clone() };
        let text = director.script.as_ref().map(|script| &script.text);
        let last = director.last_of_range(&self.render.view);
        let settings = format!("{}\n{:?}\n{last:?}\n{text:?}", self.render.settings(), self.motion);
        let mut clip = Clip::new(clips, &frames);
        if let Some(folder) = clip.folder() {
            frames.push(clip.pattern().to_owned());
            // Frames on their way to a clip are only made once.
            self.render.files.skip_existing |= frames.len() == 1;
            report.leave_unnamed(folder.to_owned());
            let made = clip.make_folder(&settings, Path::new(self.render.scene.scene()), report);
            if made.is_err() {
                clip.drop_empty_folder();
            }
            made?;
        }
        self.render.picture.output = frames;
        self.render.scene.import.play(director.clip(), director.shape_rate());
        let rendered = self.render.clone().run_directed(Some(&director), &mut |stage| clip.learn(stage), report);
        clip.note_inputs();
        if rendered.is_err() {
            clip.drop_empty_folder();
        }
        rendered.map_err(|failure| match clip.folder() {
            Some(folder) if failure.kind == Kind::Interrupted => {
                let hint = format!("the same command goes on with the frames in {}", folder.display());
                failure.hint(hint)
            }
            _ => failure,
        })?;
        clip.encode(&self.clip, report)
    }
}
