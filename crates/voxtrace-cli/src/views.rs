//! Which pictures one run makes: cameras of the scene, from a file or from options, and the frames of a turntable or of a flight.

use crate::camera_file::{self, CameraFile};
use crate::failure::Failure;
use crate::lens::{ISOMETRIC, LensArgs, Projection};
use crate::parse::{self, Frames};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use voxtrace::camera::Flight;
use voxtrace::glam::Vec3;
use voxtrace::{Camera, PackedScene};

/// Name of the view that fits the whole scene.
const AUTO: &str = "auto";
/// Names of views that fit it from one side, and the directions towards their cameras.
const SIDES: [(&str, Vec3); 6] = [
    ("front", Vec3::NEG_Y),
    ("back", Vec3::Y),
    ("left", Vec3::NEG_X),
    ("right", Vec3::X),
    ("top", Vec3::Z),
    ("bottom", Vec3::NEG_Z),
];
/// Frames of a turn or a flight where none are given.
const DEFAULT_FRAMES: u32 = 120;

/// Options about the view.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "View")]
pub struct ViewArgs {
    /// Cameras of the scene by name, `all`, or one that shows everything: `auto`, or `front`, `back`, `left`, `right`, `top`, `bottom`
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub camera: Vec<String>,
    /// Camera from a TOML file: eye, target, up, fov_y (or x, y, z, pitch, yaw, fov)
    #[arg(long, value_name = "TOML", conflicts_with = "camera")]
    pub camera_file: Option<PathBuf>,
    #[command(flatten)]
    pub place: PlaceArgs,
    /// Turn the camera around its target, once in N frames [default with no value: the number of frames rendered]
    #[arg(long, value_name = "N", num_args = 0..=1, require_equals = true, default_missing_value = "0", value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    pub turntable: Option<u32>,
    /// Fly through the cameras of a TOML file, the tables [bookmarks.1] and on as the window keeps them, at constant speed
    #[arg(long, value_name = "TOML", conflicts_with_all = ["camera", "camera_file", "turntable", "eye", "target", "up"])]
    pub flight: Option<PathBuf>,
    /// Frames of the whole flight [default: the number of frames rendered]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), requires = "flight")]
    pub flight_frames: Option<u32>,
    /// Frames to render [default: one turn, or the whole flight; 1..120]
    #[arg(long, value_name = "A..B", value_parser = parse::frames)]
    pub frames: Option<Frames>,
    #[command(flatten)]
    pub lens: LensArgs,
}

/// Options that place one camera.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct PlaceArgs {
    /// Where the camera stands, in voxels, z up
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vector, allow_hyphen_values = true)]
    pub eye: Option<Vec3>,
    /// Point that the camera looks at, in voxels
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vector, allow_hyphen_values = true)]
    pub target: Option<Vec3>,
    /// Up direction of the camera
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::vector, allow_hyphen_values = true)]
    pub up: Option<Vec3>,
    /// Vertical field of view, degrees
    #[arg(long, value_name = "DEGREES", value_parser = parse::field_of_view)]
    pub fov: Option<f32>,
}

impl PlaceArgs {
    /// Whether they say where the camera stands and looks.
    fn says_place(&self) -> bool {
        [self.eye, self.target, self.up].iter().any(Option::is_some)
    }

    /// Whether they say anything.
    pub fn says_camera(&self) -> bool {
        self.says_place() || self.fov.is_some()
    }

    /// Puts a camera where they say; it must be one that sees something.
    pub fn apply(&self, camera: &mut Camera) -> Result<(), Failure> {
        camera.eye = self.eye.unwrap_or(camera.eye);
        camera.target = self.target.unwrap_or(camera.target);
        camera.up = self.up.unwrap_or(camera.up);
        camera.fov_y = self.fov.unwrap_or(camera.fov_y);
        check(camera)
    }
}

/// One picture of a run.
#[derive(Clone, Debug)]
pub struct View {
    pub camera: Camera,
    /// The camera's name, where several cameras make the outputs' names ambiguous.
    pub camera_suffix: Option<String>,
    /// Number of the frame of an animation.
    pub frame: Option<u32>,
}

impl View {
    /// The view's name for people.
    pub fn name(&self) -> String {
        match self.frame {
            Some(frame) => format!("{} {frame:04}", self.camera.name),
            None => self.camera.name.clone(),
        }
    }
}

impl ViewArgs {
    /// No option about the view.
    #[cfg(feature = "view")]
    pub fn none() -> Self {
        Self {
            camera: Vec::new(),
            camera_file: None,
            place: PlaceArgs::default(),
            turntable: None,
            flight: None,
            flight_frames: None,
            frames: None,
            lens: LensArgs::default(),
        }
    }

    /// Whether any option says where to look from.
    pub fn says_camera(&self) -> bool {
        !self.camera.is_empty()
            || self.camera_file.is_some()
            || self.flight.is_some()
            || self.place.says_camera()
            || self.lens.says_lens()
    }

    /// Whether there is one view, whatever the scene.
    pub fn is_one(&self) -> bool {
        self.turntable.is_none()
            && self.flight.is_none()
            && self.camera.len() <= 1
            && self.camera.first().is_none_or(|name| name != "all")
    }

    /// The numbers of the frames of an animation; none of stills.
    pub fn frames(&self) -> Option<RangeInclusive<u32>> {
        let usual = match (self.turntable, &self.flight) {
            (Some(0), _) => DEFAULT_FRAMES,
            (Some(turn), _) => turn,
            (None, Some(_)) => self.flight_frames.unwrap_or(DEFAULT_FRAMES),
            (None, None) => return None,
        };
        Some(self.frames.clone().unwrap_or(1..=usual))
    }

    /// Reads the camera file, if there is one.
    pub fn camera_file(&self) -> Result<Option<CameraFile>, Failure> {
        self.camera_file.as_deref().map(camera_file::open).transpose()
    }

    /// Refuses frames of nothing.
    pub fn check_frames(&self) -> Result<(), Failure> {
        if self.frames.is_some() && self.turntable.is_none() && self.flight.is_none() {
            return Err(Failure::usage("--frames counts those of --turntable or --flight").hint("say which of them"));
        }
        Ok(())
    }

    /// The views of a run, for pictures of `width` × `height` pixels: `framed` is what a camera sees that sees everything, `scene` what is
    /// there to focus on.
    pub fn views(
        &self,
        framed: &PackedScene,
        scene: &PackedScene,
        file: Option<&CameraFile>,
        (width, height): (u32, u32),
    ) -> Result<Vec<View>, Failure> {
        if let Some(path) = &self.flight {
            let mut views = self.flown(path)?;
            views.iter_mut().try_for_each(|view| self.lens.apply(&mut view.camera, scene, (width, height)))?;
            return Ok(views);
        }
        let aspect = width as f32 / height as f32;
        let mut cameras = match file {
            Some(file) => vec![file.camera.clone()],
            None => self.named_cameras(framed, aspect)?,
        };
        if cameras.len() > 1 && self.place.says_place() {
            return Err(Failure::usage("--eye, --target and --up place one camera, but several were named"));
        }
        for camera in &mut cameras {
            self.place.apply(camera)?;
            self.lens.apply(camera, scene, (width, height))?;
        }
        let suffix = |camera: &Camera| (cameras.len() > 1).then(|| camera.name.clone());
        let still = |camera: &Camera| View { camera: camera.clone(), camera_suffix: suffix(camera), frame: None };
        let views = cameras.iter().map(still);
        let (Some(turn), Some(frames)) = (self.turntable, self.frames()) else { return Ok(views.collect()) };
        let turn = if turn > 0 { turn } else { *frames.end() };
        let turned = |view: &View, frame| View {
            camera: view.camera.turned(frame, turn),
            frame: Some(frame),
            camera_suffix: view.camera_suffix.clone(),
        };
        Ok(views.flat_map(|view| frames.clone().map(move |frame| turned(&view, frame))).collect())
    }

    /// The frames of a flight through the cameras of a file.
    fn flown(&self, path: &Path) -> Result<Vec<View>, Failure> {
        let mut cameras = camera_file::open_all(path)?;
        // Options that place a camera are refused beside a flight: the field of view is left.
        cameras.iter_mut().try_for_each(|camera| self.place.apply(camera))?;
        let flight =
            Flight::through(&cameras).map_err(|reason| Failure::input(format!("{}: {reason}", path.display())))?;
        let frames = self.frames().unwrap_or(1..=DEFAULT_FRAMES);
        let all = self.flight_frames.unwrap_or(*frames.end());
        if *frames.end() > all {
            return Err(Failure::usage(format!("frame {} is behind the end of a flight of {all}", frames.end())));
        }
        let view = |frame| View { camera: flight.frame(frame, all), camera_suffix: None, frame: Some(frame) };
        Ok(frames.map(view).collect())
    }

    fn named_cameras(&self, scene: &PackedScene, aspect: f32) -> Result<Vec<Camera>, Failure> {
        // A turntable turns around the middle of the scene, whatever is seen of it from one side.
        let is_still = self.turntable.is_none();
        let fitted = || match self.lens.projection {
            _ if !is_still => scene.overview(aspect),
            // Parallel rays show what the field of view shows at the target, where it is said.
            _ if self.place.says_camera() => scene.portrait(aspect),
            Some(Projection::Orthographic) => scene.parallel_portrait(aspect),
            Some(Projection::Isometric) => scene.parallel_portrait_from(ISOMETRIC, aspect),
            _ => scene.portrait(aspect),
        };
        let auto = || Camera { name: AUTO.into(), ..fitted() };
        if self.camera.is_empty() {
            return Ok(vec![scene.cameras.first().cloned().unwrap_or_else(auto)]);
        }
        let mut cameras: Vec<Camera> = Vec::new();
        for name in &self.camera {
            let named = scene.cameras.iter().filter(|camera| name == "all" || camera.name == *name);
            let before = cameras.len();
            cameras.extend(named.cloned());
            if cameras.len() == before {
                let side = SIDES.iter().find(|(side, _)| side == name);
                match (name.as_str(), side) {
                    (AUTO | "all", _) => cameras.push(auto()),
                    (_, Some(&(_, towards_camera))) => {
                        cameras.push(Camera { name: name.clone(), ..scene.overview_from(towards_camera, aspect) });
                    }
                    _ => return Err(unknown_camera(name, scene)),
                }
            }
        }
        Ok(cameras)
    }
}

fn unknown_camera(name: &str, scene: &PackedScene) -> Failure {
    let names: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).chain([AUTO, "all"]).collect();
    let failure = Failure::usage(format!("the scene has no camera {name:?}"));
    if ["iso", "isometric"].contains(&name) {
        return failure.hint("--projection isometric shows all of it so");
    }
    let sides = SIDES.map(|(side, _)| side).join(", ");
    failure.hint(format!("it has {}; every scene has {sides}", names.join(", ")))
}

fn check(camera: &Camera) -> Result<(), Failure> {
    let is_finite = camera.eye.is_finite() && camera.target.is_finite() && camera.up.is_finite();
    if !(is_finite && camera.fov_y > 0.0 && camera.fov_y < 180.0) {
        return Err(Failure::usage(format!("camera {:?} is not finite or has no field of view", camera.name)));
    }
    if camera.eye == camera.target {
        return Err(Failure::usage("the camera stands on its target").hint("move --eye or --target"));
    }
    if camera.up == Vec3::ZERO {
        return Err(Failure::usage("the camera's up is no direction").hint("--up 0,0,1 is usual"));
    }
    Ok(())
}
