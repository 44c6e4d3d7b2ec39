//! Where scenes come from: a file, or a built-in scene, whose name stands wherever a file may.

use crate::edits::EditArgs;
use crate::failure::Failure;
use crate::mesh::MeshArgs;
use crate::parse;
use crate::read_failure::{import_failure, native_failure};
use crate::report::Report;
use crate::volume::VolumeArgs;
use crate::voxels::HeightArgs;
use std::path::Path;
use voxtrace::import::{self, opened};
use voxtrace::packed::FileError;
use voxtrace::{PackedScene, Scene, scenes};

/// A scene on the command line.
#[derive(clap::Args, Clone, Debug)]
pub struct SceneArgs {
    /// A file (`voxtrace formats` lists the kinds) or the name of a built-in scene
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Size of a built-in scene, for example 500000, 500k or 13.6M voxels
    #[arg(long, value_name = "N", value_parser = parse::voxels)]
    pub voxels: Option<u64>,
    #[command(flatten)]
    pub mesh: MeshArgs,
    #[command(flatten)]
    pub volume: VolumeArgs,
    #[command(flatten)]
    pub heights: HeightArgs,
    #[command(flatten)]
    pub edits: EditArgs,
    #[command(flatten)]
    pub native: NativeArgs,
}

/// How voxtrace's own files are opened.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct NativeArgs {
    /// Read a .vxt file into memory instead of mapping it, so that other programs may change it meanwhile
    #[arg(long)]
    pub in_memory: bool,
}

impl NativeArgs {
    fn open(self, path: &Path) -> Result<PackedScene, FileError> {
        if self.in_memory { PackedScene::read(path) } else { PackedScene::open(path) }
    }
}

/// A scene as it was found: to be edited, or packed already.
pub enum Loaded {
    Scene(Box<Scene>),
    Packed(Box<PackedScene>),
}

impl Loaded {
    /// The scene as tracers want it.
    pub fn into_packed(self) -> Result<PackedScene, Failure> {
        match self {
            Self::Packed(packed) => Ok(*packed),
            Self::Scene(scene) => {
                PackedScene::pack(&scene).map_err(|error| Failure::input(format!("{}: {error}", scene.name)))
            }
        }
    }

    /// The scene as it can be edited and written to other formats.
    pub fn into_scene(self) -> Scene {
        match self {
            Self::Packed(packed) => packed.to_scene(),
            Self::Scene(scene) => *scene,
        }
    }
}

/// Whether a path names voxtrace's own scene format.
pub fn is_native(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vxt"))
}

impl SceneArgs {
    /// Whether the scene is a built-in one.
    fn is_builtin(&self) -> bool {
        scenes::NAMES.contains(&self.scene.as_str())
    }

    /// Notes the file as one that is read, so that no output takes its place.
    pub fn note(&self) {
        if !self.is_builtin() {
            opened::note(Path::new(&self.scene));
        }
    }

    /// The name that outputs are called after.
    pub fn stem(&self) -> String {
        let stem = Path::new(&self.scene).file_stem();
        let stem = stem.map_or_else(|| self.scene.clone(), |stem| stem.to_string_lossy().into_owned());
        // `head.nii.gz` is `head`.
        stem.strip_suffix(".nii").map_or(stem.clone(), str::to_owned)
    }

    /// Reads or generates the scene, with the edits that are asked for.
    pub fn load(&self, report: &mut Report) -> Result<Loaded, Failure> {
        let loaded = self.load_as_it_is(report)?;
        if !self.edits.changes_voxels(&self.mesh) {
            return Ok(loaded);
        }
        let mut scene = loaded.into_scene();
        self.edits.apply(&mut scene, &self.mesh, report)?;
        Ok(Loaded::Scene(scene.into()))
    }

    fn load_as_it_is(&self, report: &mut Report) -> Result<Loaded, Failure> {
        if self.is_builtin() {
            let scene = scenes::generate(&self.scene, self.voxels).map_err(Failure::usage)?;
            return Ok(Loaded::Scene(scene.into()));
        }
        if self.voxels.is_some() {
            let message = format!("--voxels sizes built-in scenes, and {:?} is none", self.scene);
            return Err(Failure::usage(message).hint(format!("the built-in scenes are {}", scenes::NAMES.join(", "))));
        }
        self.note();
        let path = Path::new(&self.scene);
        if is_native(path) {
            return (self.native.open(path))
                .map(|packed| Loaded::Packed(packed.into()))
                .map_err(|error| native_failure(&error));
        }
        let options = self.volume.import_options(&self.mesh);
        let format = import::detect(path, &options).map_err(|error| import_failure(&error))?;
        let scene = if format.is_geometry() {
            self.mesh.scene(path, self.edits.most_colors(), report)?
        } else if format.is_volume() {
            self.volume.scene(path, &self.mesh, report)?
        } else if format.is_voxels() {
            self.heights.scene(path, &self.mesh, self.volume.shell, report)?
        } else {
            import::open(path, &options).map_err(|error| import_failure(&error))?
        };
        Ok(Loaded::Scene(scene.into()))
    }
}
