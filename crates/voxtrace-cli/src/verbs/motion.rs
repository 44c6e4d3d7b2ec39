//! Scenes that move in the window, as `animate` moves them: keyframes or an animation of their file, or an animation's TOML.

use crate::animation::{Director, MotionArgs, Script};
use crate::failure::Failure;
use crate::views::ViewArgs;
use std::path::Path;
use std::sync::Arc;
use voxtrace::animation::{keyframe_count, playing};
use voxtrace::changes::PartName;
use voxtrace::import::Content;
use voxtrace::packed::Outline;
use voxtrace::{PackedScene, Placement};
use voxtrace_viewer::{Motion, Plays};

/// What moves, and the names of the objects without what was packed beside them.
pub struct InMotion {
    pub motion: Arc<Motion>,
    outline: Outline,
}

/// What a file brings along that plays.
pub fn plays_of(content: &Content) -> Plays {
    let Content::Scene(scene) = content else { return Plays::Nothing };
    let clip = scene.clips.first().map_or(Plays::Nothing, |clip| Plays::Clip(clip.seconds));
    match (playing(scene), keyframe_count(scene)) {
        (Some((seconds, _)), _) => Plays::Clip(seconds),
        (None, 0) => clip,
        (None, frames) => Plays::Keyframes(frames),
    }
}

/// What is known of what moves before the scene is read; `script` is the TOML that says what else does.
pub fn director_of(script: Option<&Path>) -> Result<Director, Failure> {
    Ok(Director { script: script.map(Script::open).transpose()?, args: MotionArgs::default() })
}

/// The content in which everything is that ever moves, with instances apart; `None` where the camera alone does.
pub fn in_motion(
    content: Content,
    director: &Director,
    shown: &[PartName],
) -> Result<(Content, Option<InMotion>), Failure> {
    let has_own_rate = director.script.as_ref().is_some_and(|script| script.key_fps.is_some());
    // A clip without an end is as long as the window says.
    let view = ViewArgs { turntable: Some(0), frames: Some(1..=240), ..ViewArgs::none() };
    let (content, cast) = director.cast(content, &view, shown)?;
    if !cast.is_moving && cast.animation.sun.is_none() && cast.animation.sky_brightness.is_none() {
        return Ok((content, None));
    }
    let bends = playing(&cast.base).is_some_and(|(_, motion)| !motion.shapes.is_empty());
    let shape_rate = bends.then(|| director.shape_rate());
    let motion = Motion { base: cast.base, animation: cast.animation, has_own_rate, shape_rate };
    Ok((content, Some(InMotion { motion: Arc::new(motion), outline: cast.outline })))
}

impl InMotion {
    /// The packed scene at time 0.
    pub fn begun(&self, packed: PackedScene) -> Result<PackedScene, Failure> {
        let now = self.motion.animation.scene_at(&self.motion.base, 0.0);
        let placement = Placement::of_scene(packed.geometry(), &now).map_err(Failure::other)?;
        let mut packed = packed.with_placement(&placement).map_err(Failure::other)?;
        packed.outline = Arc::new(self.outline.clone());
        Ok(packed)
    }
}

#[cfg(test)]
mod tests {
    use crate::verbs::beside;
    use crate::verbs::view::ViewerArgs;
    use clap::Parser;
    use std::path::Path;
    use std::sync::Arc;
    use voxtrace::glam::{IVec3, Vec3};
    use voxtrace::output::FilmFile;
    use voxtrace::scene::Keyframe;
    use voxtrace::{
        Camera, CpuTracer, Film, Instance, Material, Progress, Region, Scene, Tracer, Transform, VoxelGrid,
    };
    use voxtrace_viewer::load::Loading;
    use voxtrace_viewer::navigation::Motion;
    use voxtrace_viewer::session::{Command, Session};
    use voxtrace_viewer::{Loader, Reading, Wanted};
    use voxtrace_vulkan::Traversal;

    #[derive(Parser)]
    struct Words {
        #[command(flatten)]
        view: ViewerArgs,
    }

    /// A floor and a block above it; with keyframes the block goes along x for ten frames.
    fn scene(has_keyframes: bool) -> Scene {
        let (mut floor, mut block) = (VoxelGrid::new(), VoxelGrid::new());
        (0..256).for_each(|i| _ = floor.set(IVec3::new(i % 16, i / 16, 0), 0));
        (0..64).for_each(|i| _ = block.set(IVec3::new(i % 4, i / 4 % 4, i / 16), 1));
        let materials = vec![Material::diffuse(Vec3::splat(0.7)), Material::diffuse(Vec3::X * 0.8)];
        let mut scene = Scene { materials, ..Scene::new("moving") };
        scene.grids = vec![floor.into(), block.into()];
        let at = |x: f32| Transform::from_translation(Vec3::new(x, 6.0, 1.0));
        let mut moving = Instance::new(1, at(0.0));
        if has_keyframes {
            moving.keyframes =
                vec![Keyframe { end: at(10.0), ..Keyframe::still(0, 1, at(0.0)) }, Keyframe::still(10, 1, at(10.0))];
        }
        scene.instances = vec![Instance::new(0, Transform::IDENTITY), moving];
        scene.cameras = vec![Camera::look_at(Vec3::new(8.0, -22.0, 14.0), Vec3::new(8.0, 8.0, 2.0))];
        scene
    }

    fn opened(loader: &Arc<dyn Loader>, source: &Path, animation: Option<&Path>) -> Session {
        let mut session = Session::new(Traversal::Cpu);
        session.resize(24, 18);
        let reading = Reading { moves: true, animation: animation.map(Path::to_path_buf), ..Reading::default() };
        session.loading = Some(Loading::start(loader, &source.display().to_string(), reading, false, Arc::new(|| {})));
        while session.loading.is_some() {
            session.take_loaded();
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        session
    }

    /// The film of what a session shows, by the frame of a film that `animate` made.
    fn shown(session: &Session, file: &FilmFile) -> Film {
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&session.open.as_ref().unwrap().lit).unwrap();
        tracer.render(&file.frame, &Progress::default()).unwrap();
        let mut film = Film::new(0, 0, Region::full(0, 0), 0);
        tracer.read(&mut film).unwrap();
        film
    }

    /// Plays frames of a session, and compares each with that of `animate`, which renders the animation that the session keeps.
    fn plays_as_animate_renders(session: &mut Session, folder: &Path, frames: &[u32]) {
        let file = session.save_timeline().unwrap();
        let pattern = folder.join("f_####.vxf");
        let words = [
            "voxtrace",
            "animate",
            file.to_str().unwrap(),
            "-o",
            pattern.to_str().unwrap(),
            "--size",
            "24x18",
            "--spp",
            "2",
        ];
        let words: Vec<String> = words.into_iter().chain(["--traversal", "cpu"]).map(str::to_owned).collect();
        assert_eq!(beside::run(&words, Box::new(|_| {}), &Wanted::default()), Ok(()));
        let of = |frame: u32| FilmFile::open(&folder.join(format!("f_{frame:04}.vxf"))).unwrap();
        // The command that is copied makes the film of the window, from wherever its camera is.
        session.set_time_frame(frames[0]);
        session.move_by(Motion::Orbit { delta: (30.0, 4.0).into(), pivot: None });
        session.render_settings.samples = 2;
        let words = session.frame_command().unwrap().words().unwrap();
        let name = |word: String| {
            if word.ends_with("_####.png") { folder.join("w_####.vxf").display().to_string() } else { word }
        };
        let words: Vec<String> = words.into_iter().map(name).collect();
        assert_eq!(beside::run(&words, Box::new(|_| {}), &Wanted::default()), Ok(()));
        let file = FilmFile::open(&folder.join(format!("w_{:04}.vxf", frames[0]))).unwrap();
        let own = FilmFile { frame: session.view().frame(), ..file.clone() };
        assert_eq!((own.frame.seed, own.frame.camera.eye), (file.frame.seed, file.frame.camera.eye));
        assert!(shown(session, &own).pixels == file.film.pixels, "{words:?}");
        for &frame in frames {
            session.take_commands();
            session.set_time_frame(frame);
            assert!(session.take_commands().contains(&Command::SetScene), "{frame}");
            let file = of(frame);
            assert!(shown(session, &file).pixels == file.film.pixels, "frame {frame}");
            let other = of(if frame == frames[0] { frames[1] } else { frames[0] });
            let frame_of_other = FilmFile { frame: file.frame, ..other };
            assert!(shown(session, &frame_of_other).pixels != frame_of_other.film.pixels, "the comparison sees frames");
        }
    }

    #[test]
    fn key_frames_of_a_file_play_in_the_window_as_animate_renders_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("moving.vox");
        voxtrace::export::vox::write(&path, &scene(true)).unwrap();
        let loader: Arc<dyn Loader> = Arc::new(Words::parse_from(["view"]).view.into_loader());
        let mut session = opened(&loader, &path, None);
        assert!(session.has_motion());
        let frames = session.timeline.course.frames();
        assert!((10..=11).contains(&frames), "{frames}");
        plays_as_animate_renders(&mut session, folder.path(), &[9, 3, 6]);
    }

    /// A glTF file of a floor and a pyramid that goes along x for half a second and, where it `bends`, grows on its way.
    fn gltf(folder: &Path, bends: bool) -> std::path::PathBuf {
        let corners: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (times, weights) = ([0.0f32, 0.25, 0.5], [0.0f32, 2.0, 0.5]);
        let places: [[f32; 3]; 3] = [[-2.0, 0.0, 0.0], [1.0, 0.5, 0.0], [2.0, 0.0, 0.0]];
        let floats = corners.as_flattened().iter().chain(&times).chain(places.as_flattened()).chain(&weights);
        let faces: [u16; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
        let bytes = floats.flat_map(|n| n.to_le_bytes()).chain(faces.iter().flat_map(|n| n.to_le_bytes()));
        std::fs::write(folder.join("goer.bin"), bytes.collect::<Vec<u8>>()).unwrap();
        let (targets, channel) = match bends {
            true => (r#","targets":[{"POSITION":0}]"#, r#",{"sampler":1,"target":{"node":1,"path":"weights"}}"#),
            false => ("", ""),
        };
        let primitive = |targets: &str| format!(r#"{{"attributes":{{"POSITION":0}},"indices":4{targets}}}"#);
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0,1]}}],
            "nodes":[{{"mesh":0,"translation":[-3,-0.2,-2],"scale":[6,0.1,5]}},{{"mesh":1,"name":"goer"}}],
            "animations":[{{"name":"go","channels":[{{"sampler":0,"target":{{"node":1,"path":"translation"}}}}{channel}],
                "samplers":[{{"input":1,"output":2}},{{"input":1,"output":3}}]}}],
            "meshes":[{{"primitives":[{}]}},{{"primitives":[{}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}},
                {{"bufferView":1,"componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[0.5]}},
                {{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}},
                {{"bufferView":3,"componentType":5126,"count":3,"type":"SCALAR"}},
                {{"bufferView":4,"componentType":5123,"count":12,"type":"SCALAR"}}],
            "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}},
                {{"buffer":0,"byteOffset":60,"byteLength":36}},{{"buffer":0,"byteOffset":96,"byteLength":12}},
                {{"buffer":0,"byteOffset":108,"byteLength":24}}],
            "buffers":[{{"uri":"goer.bin","byteLength":132}}]}}"#,
            primitive(""),
            primitive(targets),
        );
        let path = folder.join("goer.gltf");
        std::fs::write(&path, text).unwrap();
        path
    }

    #[test]
    fn an_animation_of_gltf_plays_in_the_window_as_animate_renders_it() {
        let loader: Arc<dyn Loader> = Arc::new(Words::parse_from(["view"]).view.into_loader());
        for bends in [false, true] {
            let folder = tempfile::tempdir().unwrap();
            let path = gltf(folder.path(), bends);
            // As it is opened, it is a still; the timeline has it read again.
            let mut still = Session::new(Traversal::Cpu);
            still.loading =
                Some(Loading::start(&loader, &path.display().to_string(), Reading::default(), false, Arc::new(|| {})));
            while still.loading.is_some() {
                still.take_loaded();
                std::thread::sleep(std::time::Duration::from_millis(1));
            }
            assert!(!still.has_motion() && still.open.as_ref().unwrap().alone.instances().len() == 1);
            let said: Vec<String> = still.messages().map(|message| message.text.clone()).collect();
            assert!(said.iter().any(|said| said.contains("F8 and Space play it")), "{said:?}");
            assert!(!said.iter().any(|said| said.contains("not shown")), "what plays is shown: {said:?}");
            still.toggle_timeline();
            assert!(still.take_commands().contains(&Command::LoadAgain));

            let mut session = opened(&loader, &path, None);
            assert!(session.has_motion());
            assert_eq!((session.timeline.course.fps, session.timeline.course.frames()), (24.0, 12));
            // Shapes are those that were read, whatever the rate of frames.
            session.timeline.edit(|course| course.fps = 10.0);
            plays_as_animate_renders(&mut session, folder.path(), &[4, 2, 3]);
        }
    }

    #[test]
    fn a_toml_names_the_animation_that_plays_in_the_window() {
        let loader: Arc<dyn Loader> = Arc::new(Words::parse_from(["view"]).view.into_loader());
        let folder = tempfile::tempdir().unwrap();
        let (path, toml) = (gltf(folder.path(), false), folder.path().join("named.toml"));
        let open = |name: &str| {
            let text = format!("scene = \"goer.gltf\"\nseconds = 0.5\nanimation = \"{name}\"\n");
            std::fs::write(&toml, text).unwrap();
            let mut session = opened(&loader, &path, Some(&toml));
            let said: Vec<String> = session.messages().map(|message| message.text.clone()).collect();
            (session.has_motion(), said.join("\n"))
        };
        assert!(open("go").0 && open("1").0);
        let (has_motion, said) = open("walk");
        assert!(!has_motion && said.contains("there is no animation \"walk\""), "{said}");
    }

    #[test]
    fn objects_and_sun_of_an_animation_play_in_the_window_as_animate_renders_them() {
        let folder = tempfile::tempdir().unwrap();
        voxtrace::export::vox::write(&folder.path().join("room.vox"), &scene(false)).unwrap();
        let toml = folder.path().join("room.animation.toml");
        let text = "scene = \"room.vox\"\nfps = 5\nseconds = 2\nshutter = 0\n\
                    [camera]\npath = [{ at = 0, eye = [8, -22, 14], target = [8, 8, 2] }, { at = 2, eye = [20, -20, 14], target = [8, 8, 2] }]\n\
                    [[object]]\nname = \"1\"\nkeys = [{ at = 0 }, { at = 2, offset = [6, 0, 5], degrees = 90, axis = [0, 0, 1] }]\n\
                    [sun]\nkeys = [{ at = 0, bearing = 90, height = 10, strength = 3 }, { at = 2, bearing = 200, height = 60 }]\n";
        std::fs::write(&toml, text).unwrap();
        let loader: Arc<dyn Loader> = Arc::new(Words::parse_from(["view"]).view.into_loader());
        let mut session = opened(&loader, &folder.path().join("room.vox"), Some(&toml));
        assert!(session.has_motion() && session.timeline.course.keys.len() == 2);
        plays_as_animate_renders(&mut session, folder.path(), &[8, 2, 5]);
    }

    #[test]
    fn a_camera_alone_leaves_the_scene_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("room.vox");
        voxtrace::export::vox::write(&path, &scene(false)).unwrap();
        let loader: Arc<dyn Loader> = Arc::new(Words::parse_from(["view"]).view.into_loader());
        assert!(!opened(&loader, &path, None).has_motion());
    }
}
