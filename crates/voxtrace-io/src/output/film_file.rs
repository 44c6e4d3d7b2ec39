//! The film file (`.vxf`): a film with its exact sums, the frame that asked for it and a stamp of its scene, so that a
//! later run, or another machine, continues it bit for bit. `docs/film-format.md` describes every byte.

use super::write_atomically;
use glam::Vec3;
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::BounceLimits;
use voxtrace_core::Film;
use voxtrace_core::Frame;
use voxtrace_core::PackedScene;
use voxtrace_core::Region;
use voxtrace_core::cuts::{Cuts, Plane};
use voxtrace_core::lines::{Line, Lines};
use voxtrace_scene::Camera;
use voxtrace_scene::Sky;

/// Which scene a film shows, in which light.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneStamp {
    /// Name for people. It is a part of the hash: a scene by another name has another one.
    pub name: String,
    /// [`PackedScene::content_hash`] before options changed its light.
    pub content_hash: u64,
    /// Light from outside.
    pub sky: Sky,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// What of it is shown.
    pub cuts: Cuts,
}

impl SceneStamp {
    /// The stamp of a scene. Where options change the scene's light or its cuts, set those of the stamp after that: the hash is
    /// that of the scene itself.
    pub fn of(scene: &PackedScene) -> Self {
        Self {
            name: scene.name.clone(),
            content_hash: scene.content_hash(),
            sky: scene.sky.clone(),
            light_intensity: scene.light_intensity,
            cuts: scene.cuts.clone(),
        }
    }
}

/// A film that can be continued or merged.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmFile {
    /// What was asked for; `samples` may be more than the film holds yet.
    pub frame: Frame,
    /// Of which scene.
    pub scene: SceneStamp,
    /// What there is.
    pub film: Film,
}

/// A film file could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FilmFileError {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// Not a film file, or of a version that this build does not know.
    #[error("{0}")]
    Format(String),
    /// The content is not what was written.
    #[error("damaged: {what} (at byte {offset})")]
    Damaged {
        /// What is wrong.
        what: &'static str,
        /// Where.
        offset: u64,
    },
}

impl FilmFile {
    /// Writes the file atomically: a crash in between leaves the old one whole.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        let bytes = self.to_bytes();
        write_atomically(path, |file| file.write_all(&bytes))
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`FilmFileError`] if it cannot be read, is no film file or damaged.
    pub fn open(path: &Path) -> Result<Self, FilmFileError> {
        Self::from_bytes(&std::fs::read(path)?)
    }

    /// Why a film that `self` holds is not one of `frame` and `scene`, in words; `None` if it is. The number of samples
    /// and the AOVs, which any run can add, do not count.
    pub fn difference(&self, frame: &Frame, scene: &SceneStamp) -> Option<String> {
        let (ours, theirs) = (&self.frame, frame);
        let pairs: [(&str, String, String); 19] = [
            ("scene", hash_text(&self.scene), hash_text(scene)),
            ("sky", format!("{:?}", self.scene.sky), format!("{:?}", scene.sky)),
            ("light intensity", self.scene.light_intensity.to_string(), scene.light_intensity.to_string()),
            ("cuts", cuts_text(&self.scene.cuts), cuts_text(&scene.cuts)),
            ("size", size_text(ours), size_text(theirs)),
            ("crop", crop_text(ours.region), crop_text(theirs.region)),
            ("camera", view_text(&ours.camera), view_text(&theirs.camera)),
            ("lens", lens_text(&ours.camera), lens_text(&theirs.camera)),
            ("seed", ours.seed.to_string(), theirs.seed.to_string()),
            ("first sample", ours.first_sample.to_string(), theirs.first_sample.to_string()),
            ("integrator", ours.integrator.name().into(), theirs.integrator.name().into()),
            ("maximum of bounces", ours.max_bounces.to_string(), theirs.max_bounces.to_string()),
            ("bounces by kind", kinds_text(ours), kinds_text(theirs)),
            ("clamp of indirect light", ours.clamp_indirect.to_string(), theirs.clamp_indirect.to_string()),
            ("clear shadows", ours.clear_shadows.to_string(), theirs.clear_shadows.to_string()),
            ("light of", ours.light_group.name().into(), theirs.light_group.name().into()),
            ("shadow catcher", ours.shadow_catcher.to_string(), theirs.shadow_catcher.to_string()),
            ("lines", lines_text(&ours.lines), lines_text(&theirs.lines)),
            ("transparency", ours.transparent.to_string(), theirs.transparent.to_string()),
        ];
        let (what, ours, theirs) = pairs.into_iter().find(|(_, ours, theirs)| ours != theirs)?;
        if what == "sky" {
            // Whole skies are no words.
            return Some("sky of the film, another one asked for".into());
        }
        Some(format!("{what} {ours} in the film, {theirs} asked for"))
    }
}

fn hash_text(scene: &SceneStamp) -> String {
    format!("{:016x}", scene.content_hash)
}

/// Lines on voxels, for people: `none`, or width and linear colour of those along edges, of those of a grid, and their spacing.
pub(super) fn lines_text(lines: &Lines) -> String {
    let line = |line: &Line| format!("{},{},{},{}", line.width, line.color.x, line.color.y, line.color.z);
    let edges = lines.edges.as_ref().map(|edges| format!("edges {}", line(edges)));
    let grid = lines.grid.as_ref().map(|grid| format!("grid {},{}", line(&grid.line), grid.spacing));
    let texts: Vec<String> = edges.into_iter().chain(grid).collect();
    if texts.is_empty() { "none".into() } else { texts.join(" ") }
}

/// The planes of cuts, for people: `none`, or `nx,ny,nz,d` of each, and whether what is cut away casts shadows.
pub(super) fn cuts_text(cuts: &Cuts) -> String {
    if cuts.is_none() {
        return "none".into();
    }
    let plane = |plane: &Plane| {
        let normal = plane.normal();
        format!("{},{},{},{}", normal.x, normal.y, normal.z, plane.offset())
    };
    let planes: Vec<String> = cuts.planes().iter().map(plane).collect();
    planes.join(" ") + if cuts.casts_shadows() { " with shadows" } else { "" }
}

fn size_text(frame: &Frame) -> String {
    format!("{}x{}", frame.width, frame.height)
}

/// Limits of diffuse, glossy, transmitted bounces and those in volumes, as far as there are any.
pub(super) fn kinds_text(frame: &Frame) -> String {
    let BounceLimits { diffuse, glossy, transmitted, volume } = frame.bounce_limits;
    let text = |limit: u8| if limit == BounceLimits::UNLIMITED { "-".into() } else { limit.to_string() };
    [diffuse, glossy, transmitted, volume].map(text).join(",")
}

/// Where a camera stands and looks, as the options of `render` say it.
fn view_text(camera: &Camera) -> String {
    let vector = |vector: Vec3| vector.to_array().map(|number| number.to_string()).join(",");
    let (eye, target, up) = (vector(camera.eye), vector(camera.target), vector(camera.up));
    format!("--eye {eye} --target {target} --up {up} --fov {}", camera.fov_y)
}

/// A lens and its settings.
fn lens_text(camera: &Camera) -> String {
    let settings = camera.lens.settings();
    let settings = settings.iter().map(|(name, value)| format!(", {} {value}", name.replace('_', " ")));
    camera.lens.name().to_owned() + &settings.collect::<String>()
}

fn crop_text(Region { x0, y0, x1, y1 }: Region) -> String {
    format!("{x0},{x1},{y0},{y1}")
}
