//! Where scenes come from: a file, or a built-in scene, whose name stands wherever a file may.

use crate::failure::Failure;
use crate::import::{Held, ImportArgs};
use crate::interrupt;
use crate::levels;
use crate::normals::{NormalsArg, with_normals};
use crate::parse;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::import::{Content, opened};
use voxtrace::packed::PackError;
use voxtrace::{PackedScene, scenes};

/// A scene on the command line.
#[derive(clap::Args, Clone, Debug)]
pub struct SceneArgs {
    /// A file (`voxtrace formats` lists the kinds) or the name of a built-in scene. Several LAS or LAZ files are one cloud, several meshes one mesh
    #[arg(value_name = "SCENE", required = true)]
    pub scenes: Vec<String>,
    /// Size of a built-in scene, for example 500000, 500k or 13.6M voxels
    #[arg(long, value_name = "N", value_parser = parse::voxels)]
    pub voxels: Option<u64>,
    /// Trees, rocks and lamps of the built-in scene `forest`, up to a million [default: 10000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(scenes::MAX_INSTANCES)), conflicts_with = "voxels")]
    pub instances: Option<u32>,
    #[command(flatten)]
    pub import: ImportArgs,
    #[command(flatten)]
    pub memory: MemoryArgs,
}

/// How scenes lie in memory.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct MemoryArgs {
    /// Read a .vxt file into memory instead of mapping it, so that other programs may change it meanwhile
    #[arg(long)]
    pub in_memory: bool,
    /// Show a level of detail of a .vxt file: 1 has voxels twice as wide as the scene, 2 four times; `voxtrace info` lists those that there are
    #[arg(long, value_name = "K")]
    pub level: Option<u32>,
    /// Keep all instances apart, instead of making one grid of those that stand on the lattice of voxels, which is faster
    #[arg(long)]
    pub keep_instances: bool,
    /// Normals that surfaces are shaded with [default: those of the .vxt file, else faces]
    #[arg(long, value_name = "NORMALS")]
    pub normals: Option<NormalsArg>,
}

impl MemoryArgs {
    /// The same, with instances kept apart where that is needed.
    pub fn keeping_instances(self, is_needed: bool) -> Self {
        Self { keep_instances: self.keep_instances || is_needed, ..self }
    }
}

/// The packed scene, with instances merged unless they are to be kept apart.
pub fn into_packed(content: Content, memory: MemoryArgs) -> Result<PackedScene, Failure> {
    with_normals(packed_as_it_is(content, memory.keep_instances)?, memory.normals)
}

fn packed_as_it_is(content: Content, keep_instances: bool) -> Result<PackedScene, Failure> {
    let scene = match content {
        Content::Packed(packed) if keep_instances => return Ok(packed.split()),
        // What a file has is not packed anew.
        Content::Packed(packed) => return Ok(*packed),
        Content::Scene(scene) => scene,
    };
    let wanted = interrupt::watch();
    let packed = match keep_instances {
        true => PackedScene::pack_while(&scene, &wanted),
        false => PackedScene::pack_merged_while(&scene, &wanted),
    };
    packed.map_err(|error| match error {
        PackError::Stopped => interrupt::failure(),
        error => Failure::input(format!("{}: {error}", scene.name)),
    })
}

/// Whether a path names voxtrace's own scene format.
pub fn is_native(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vxt"))
}

impl SceneArgs {
    /// The scene, or the first of its files.
    pub fn scene(&self) -> &str {
        &self.scenes[0]
    }

    /// The same, and how many more there are.
    pub fn shown(&self) -> String {
        first_and_more(self.scene(), self.scenes.len())
    }

    /// Whether the scene is a built-in one.
    fn is_builtin(&self) -> bool {
        self.scenes.len() == 1 && scenes::NAMES.contains(&self.scene())
    }

    /// Notes the files as those that are read, so that no output takes their place.
    pub fn note(&self) {
        if !self.is_builtin() {
            self.scenes.iter().for_each(|scene| opened::note(Path::new(scene)));
        }
    }

    /// Refuses what stands behind the scene and is called like a picture: it is hardly a further tile.
    pub fn refuse_pictures(&self) -> Result<(), Failure> {
        let is_picture = |scene: &&String| {
            let extension = Path::new(scene).extension().unwrap_or_default().to_ascii_lowercase();
            ["png", "exr", "vxf"].iter().any(|known| extension == *known)
        };
        match self.scenes[1..].iter().find(is_picture) {
            Some(picture) => {
                let message = format!("{picture}: of the files behind {:?} only tiles are read", self.scene());
                Err(Failure::usage(message).hint(format!("-o {picture} names the picture")))
            }
            None => Ok(()),
        }
    }

    /// The file, where it is no built-in scene.
    pub fn file(&self) -> Option<&Path> {
        (!self.is_builtin()).then(|| Path::new(self.scene()))
    }

    /// The name that outputs are called after.
    pub fn stem(&self) -> String {
        let path = named(Path::new(self.scene()));
        let stem = path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned());
        // `head.nii.gz` is `head`.
        stem.strip_suffix(".nii").map_or(stem.clone(), str::to_owned)
    }

    /// Reads or generates the scene, with the edits that are asked for.
    pub fn load(&self, report: &mut Report) -> Result<Content, Failure> {
        self.load_keeping(&mut |_| (), report)
    }

    /// As [`Self::load`]; `keep` gets what its file holds.
    pub fn load_keeping(&self, keep: &mut dyn FnMut(Held), report: &mut Report) -> Result<Content, Failure> {
        let content = self.load_as_it_is(keep, report)?;
        self.import.edit(content, report)
    }

    fn load_as_it_is(&self, keep: &mut dyn FnMut(Held), report: &mut Report) -> Result<Content, Failure> {
        let scene = self.scene();
        if self.is_builtin() {
            if let Some(level) = self.memory.level {
                return levels::open(Path::new(scene), level, false).map(|scene| Content::Packed(scene.into()));
            }
            self.import.volume.overlays.refuse(Path::new(scene))?;
            self.import.mesh.refuse_choice_of_points(Path::new(scene))?;
            self.import.heights.refuse(scene)?;
            self.import.warn_of_built_in(scene, report);
            let made = match self.instances {
                Some(instances) if scene == scenes::FOREST => {
                    scenes::generate_forest_while(instances, &interrupt::watch())
                }
                Some(_) => Err(scenes::SceneError::NotOfInstances(scene.to_owned())),
                None => scenes::generate_while(scene, self.voxels, &interrupt::watch()),
            };
            return made.map(|scene| Content::Scene(scene.into())).map_err(|error| match error {
                scenes::SceneError::Stopped => interrupt::failure(),
                error => Failure::usage(error),
            });
        }
        if self.voxels.is_some() {
            let message = format!("--voxels sizes built-in scenes, and {scene:?} is none");
            return Err(Failure::usage(message).hint(format!("the built-in scenes are {}", scenes::NAMES.join(", "))));
        }
        if self.instances.is_some() {
            let message = format!("--instances is for the built-in scene forest, and {scene:?} is a file");
            return Err(Failure::usage(message));
        }
        self.note();
        if let Some(level) = self.memory.level {
            return levels::open(Path::new(scene), level, self.memory.in_memory)
                .map(|scene| Content::Packed(scene.into()));
        }
        let paths: Vec<PathBuf> = self.scenes.iter().map(|scene| named(Path::new(scene))).collect();
        self.import.load_keeping(&paths, self.memory.in_memory, keep, report)
    }
}

/// A path that ends in a name, which scenes and outputs are called after: folders such as `.` and `a/..` under their own.
pub fn named(path: &Path) -> PathBuf {
    let own = || std::fs::canonicalize(path).ok();
    path.file_name().is_none().then(own).flatten().unwrap_or_else(|| path.to_owned())
}

/// The first of so many files, and how many more there are.
pub fn first_and_more(first: &str, count: usize) -> String {
    match count {
        0 | 1 => first.to_owned(),
        count => format!("{first} and {} more", count - 1),
    }
}
