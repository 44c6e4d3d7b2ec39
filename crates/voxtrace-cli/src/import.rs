//! Files on the command line: what a reader gives becomes a scene, and what there is to say about it is said.

use crate::blocks::BlockArgs;
use crate::edits::EditArgs;
use crate::failure::Failure;
use crate::heights::HeightArgs;
use crate::interrupt;
use crate::mesh::MeshArgs;
use crate::read_failure::import_failure;
use crate::report::Report;
use crate::volume::VolumeArgs;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use voxtrace::Volume;
use voxtrace::import::{
    ClipChoice, Content, Data, Geometry, ImportError, ImportOptions, Kind, Opened, READERS, Reader, parts_not_shown,
    read_while,
};
use voxtrace::points::PointCloud;
use voxtrace::volume::ValueStatistics;

/// What a file holds before it becomes voxels.
#[cfg_attr(not(feature = "view"), allow(dead_code, reason = "only the window looks at it"))]
pub enum Held<'a> {
    /// A volume in memory, and what its values are.
    Volume(Arc<Volume>, Arc<ValueStatistics>),
    /// Points.
    Points(&'a PointCloud),
}

/// How files become scenes.
#[derive(clap::Args, Clone, Debug)]
pub struct ImportArgs {
    #[command(flatten)]
    pub mesh: MeshArgs,
    #[command(flatten)]
    pub volume: VolumeArgs,
    #[command(flatten)]
    pub heights: HeightArgs,
    #[command(flatten)]
    pub blocks: BlockArgs,
    #[command(flatten)]
    pub edits: EditArgs,
    /// Refuse a file of which a part is damaged, instead of reading what is whole
    #[arg(long, help_heading = "Files")]
    strict: bool,
    /// Which of the animations of a mesh moves it.
    #[arg(skip)]
    pub animation: ClipChoice,
    /// How many shapes a second are made of what bends in it.
    #[arg(skip)]
    pub shape_rate: Option<f64>,
    /// A pipe that was begun.
    #[arg(skip)]
    pub begun: Begun,
}

/// What was read of a pipe from its start on, and the pipe.
type HeadAndPipe = (Vec<u8>, File);

/// A pipe of which something was read to see what it holds: whoever reads it goes on from there, once.
#[derive(Clone, Debug, Default)]
pub struct Begun(Arc<Mutex<Option<HeadAndPipe>>>);

impl Begun {
    /// An open pipe, and what was read of it from its start on.
    pub fn of(head: Vec<u8>, pipe: File) -> Self {
        Self(Arc::new(Mutex::new(Some((head, pipe)))))
    }

    fn take(&self) -> Option<HeadAndPipe> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

impl ImportArgs {
    /// How files are read, native ones into memory or not.
    pub fn options(&self, in_memory: bool) -> ImportOptions {
        let options = self.volume.import_options(&self.mesh);
        let shell = self.volume.shell();
        let (heights, blocks) = (self.heights.options(shell), self.blocks.options(shell));
        let (animation, shape_rate) = (self.animation.clone(), self.shape_rate);
        ImportOptions { heights, blocks, in_memory, strict: self.strict, animation, shape_rate, ..options }
    }

    /// Has an animation of a mesh move it, the first where none is named; so many shapes a second are made of what bends in it.
    pub fn play(&mut self, name: Option<&str>, shape_rate: f64) {
        self.animation = name.map_or(ClipChoice::First, |name| ClipChoice::Named(name.to_owned()));
        self.shape_rate = Some(shape_rate);
    }

    /// Has a still read of what can be played later.
    pub fn play_later(&mut self) {
        self.animation = ClipChoice::Later;
    }

    /// Keeps what is within volumes and heightmaps, unless an option says otherwise: cuts show it.
    pub fn keep_inside(&mut self) {
        self.volume.keeps_inside = true;
    }

    /// Opens a file, or several that are to be one, and tells their format.
    pub fn open_all<'a>(
        &self,
        paths: &'a [PathBuf],
        options: &'a ImportOptions,
    ) -> Result<Opened<'static, 'a>, Failure> {
        let opened = match self.begun.take() {
            Some((head, pipe)) => READERS.open_begun(head, pipe, &paths[0], options),
            None => READERS.open_all(paths, options),
        };
        self.checked(opened, &paths[0])
    }

    fn checked<'a>(
        &self,
        opened: Result<Opened<'static, 'a>, ImportError>,
        path: &Path,
    ) -> Result<Opened<'static, 'a>, Failure> {
        let opened = opened.map_err(|error| import_failure(&error))?;
        // Others are, or may be, heightmaps.
        if matches!(opened.reader().kind, Kind::Scene | Kind::Packed | Kind::Mesh | Kind::Points) {
            self.heights.refuse(&path.display().to_string())?;
        }
        if opened.reader().kind == Kind::Volume {
            // A wrong name is told before hours of reading.
            let transfer = self.volume.transfer()?;
            self.volume.overlays.check(transfer.is_some())?;
        } else {
            self.volume.overlays.refuse(path)?;
        }
        Ok(opened)
    }

    /// Reads a file and says what was left out.
    pub fn read(&self, opened: Opened, path: &Path, report: &Report) -> Result<Data, Failure> {
        let reader = opened.reader();
        let (kind, has_blocks) = (reader.kind, reader.name.starts_with("Minecraft"));
        let data = read_while(interrupt::watch(), || opened.read());
        // What a decoder makes of a reading that was stopped tells nothing.
        interrupt::check()?;
        let mut data = data.map_err(|error| import_failure(&error))?;
        if !matches!(data, Data::Geometry(Geometry::Points(_))) {
            self.mesh.refuse_choice_of_points(path)?;
        }
        for note in data.notes() {
            report.warn(&format!("{}: {note}", path.display()));
        }
        if matches!(kind, Kind::Scene | Kind::Packed) {
            let why = format!("{} says itself which way is up and how large its voxels are", path.display());
            warn_of_needless(self.mesh.only_for_foreign(), &why, report);
            let why = format!("the voxels of {} are taken as they are", path.display());
            warn_of_needless(self.volume.shell_asked(), &why, report);
        }
        match &data {
            Data::Geometry(Geometry::Mesh(_)) => self.warn_of_kind(Kind::Mesh, reader, path, report),
            Data::Geometry(Geometry::Points(_)) => self.warn_of_kind(Kind::Points, reader, path, report),
            Data::Volume(_) => self.warn_of_kind(Kind::Volume, reader, path, report),
            _ => {}
        }
        if !has_blocks {
            let why = format!("{} holds no blocks of Minecraft", path.display());
            warn_of_needless(self.blocks.asked(), &why, report);
        }
        report.leave_out(parts_not_shown(data.notes()));
        if let Data::Geometry(geometry) = &mut data {
            geometry.set_unit(self.mesh.settled(geometry.unit()));
        }
        Ok(data)
    }

    /// Says which options change nothing of what becomes voxels, as they are about something of another kind, or about parts that files of the format
    /// have not.
    pub fn warn_of_kind(&self, kind: Kind, reader: &Reader, path: &Path, report: &Report) {
        let (mesh, volume, path) = (&self.mesh, &self.volume, path.display());
        let of_volumes = || volume.only_for_volumes().chain(volume.shell_asked());
        match kind {
            Kind::Mesh => {
                let why = format!("{path} is a mesh");
                warn_of_needless(mesh.only_for_points().chain(of_volumes()), &why, report);
            }
            Kind::Points => {
                let why = format!("{path} holds points");
                warn_of_needless(mesh.only_for_meshes().chain(of_volumes()), &why, report);
            }
            Kind::Volume => {
                let why = format!("{path} is a volume");
                warn_of_needless(mesh.only_for_meshes().chain(mesh.only_for_points()), &why, report);
                let why = format!("{path} ({}) has none to choose from", reader.name);
                warn_of_needless(volume.only_for_several(reader.several), &why, report);
            }
            _ => {}
        }
    }

    /// Makes a scene of what a file holds.
    pub fn scene(&self, data: Data, path: &Path, report: &mut Report) -> Result<Content, Failure> {
        if matches!(data, Data::Packed(_) | Data::Voxels(_)) {
            let needless = self.mesh.only_for_others().chain(self.volume.only_for_volumes());
            warn_of_needless(needless, &format!("the voxels of {} are taken as they are", path.display()), report);
        }
        let scene = match data {
            Data::Packed(packed) => return Ok(Content::Packed(packed)),
            Data::Voxels(voxels) => voxels.scene,
            Data::Geometry(geometry) => self.mesh.scene(&geometry, path, self.edits.most_colors(), report)?,
            Data::Volume(volume) => return self.content_of(&volume, &volume.statistics(), path, report),
            _ => return Err(Failure::other(format!("{}: another kind of content", path.display()))),
        };
        Ok(Content::Scene(scene.into()))
    }

    /// Says which options change nothing of a built-in scene.
    pub fn warn_of_built_in(&self, name: &str, report: &Report) {
        let of_files = self.mesh.only_for_others().chain(self.volume.only_for_volumes());
        let needless = of_files.chain(self.volume.shell_asked()).chain(self.mesh.only_for_foreign());
        let needless = needless.chain(self.blocks.asked());
        warn_of_needless(needless, &format!("{name} is made, and not read from a file"), report);
    }

    /// Loads a scene from a file, or from several that are one, as it is; `keep` gets what it holds.
    pub fn load_keeping(
        &self,
        paths: &[PathBuf],
        in_memory: bool,
        keep: &mut dyn FnMut(Held),
        report: &mut Report,
    ) -> Result<Content, Failure> {
        let options = self.options(in_memory);
        let (opened, path) = (self.open_all(paths, &options)?, paths[0].as_path());
        match self.read(opened, path, report)? {
            Data::Volume(volume) => {
                let values = Arc::new(volume.statistics());
                let volume = Arc::new(volume);
                keep(Held::Volume(Arc::clone(&volume), Arc::clone(&values)));
                self.content_of(&volume, &values, path, report)
            }
            data => {
                if let Data::Geometry(Geometry::Points(cloud)) = &data {
                    keep(Held::Points(cloud));
                }
                self.scene(data, path, report)
            }
        }
    }

    /// Makes a scene of a volume whose values are known.
    pub fn content_of(
        &self,
        volume: &Volume,
        values: &ValueStatistics,
        path: &Path,
        report: &mut Report,
    ) -> Result<Content, Failure> {
        // Colours of a transfer function that was chosen come before those of the samples.
        let plain = (self.volume.has_transfer() && !volume.colors.is_empty())
            .then(|| Volume { colors: Vec::new(), ..volume.clone() });
        let scene = self.volume.scene(plain.as_ref().unwrap_or(volume), values, path, &self.mesh, report)?;
        Ok(Content::Scene(scene.into()))
    }

    /// Does the edits that are asked for.
    pub fn edit(&self, content: Content, report: &Report) -> Result<Content, Failure> {
        if !self.edits.changes_voxels(&self.mesh) {
            return Ok(content);
        }
        let mut scene = content.into_scene();
        self.edits.apply(&mut scene, &self.mesh, report)?;
        Ok(Content::Scene(scene.into()))
    }
}

/// Says which options change nothing, and why. Once is enough: a benchmark loads a scene again and again.
pub fn warn_of_needless(options: impl Iterator<Item = &'static str>, why: &str, report: &Report) {
    let options: Vec<&str> = options.collect();
    let verb = if options.len() == 1 { "changes" } else { "change" };
    let warning = format!("{} {verb} nothing: {why}", options.join(", "));
    if !options.is_empty() && !report.warnings().contains(&warning) {
        report.warn(&warning);
    }
}
