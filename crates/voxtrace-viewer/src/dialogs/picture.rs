//! Rendering a picture to a file.

use super::{PathField, Quality, quality};
use crate::export::{Existing, ExportRequest, Job, free_name};
use crate::render_command::RenderCommand;
use crate::session::Session;
use crate::tr;
use std::path::{Path, PathBuf};
use voxtrace::output::PictureFormat;

/// Kinds of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// `.png`
    Png,
    /// `.exr`
    Exr,
}

impl PictureKind {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Png, Self::Exr];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Exr => "EXR",
        }
    }

    /// The ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
        }
    }
}

/// What somebody has chosen.
#[derive(Clone, Debug)]
pub struct PictureDialog {
    /// Where it is written.
    pub path: PathField,
    /// Size, samples, background.
    pub quality: Quality,
    /// Also albedo, normal, depth, instance and voxel of each pixel (EXR).
    pub aovs: bool,
    /// 16 bits a channel in place of 8 (PNG) or 32 (EXR).
    pub sixteen_bits: bool,
    /// Whether a file that is there is written over.
    pub replaces: bool,
    /// The path that `replaces` was said of.
    replaces_what: String,
}

impl PictureDialog {
    /// What the dialog begins with: a free name beside the scene, the window's size.
    pub fn new(session: &Session) -> Self {
        let path = free_name(&session.usual_folder(), &session.stem());
        Self {
            path: PathField::new(&path),
            quality: Quality::of(session, quality::PICTURE, 256),
            aovs: false,
            sixteen_bits: false,
            replaces: false,
            replaces_what: String::new(),
        }
    }

    /// The kind that the file's name says.
    pub fn kind(&self) -> Option<PictureKind> {
        match PictureFormat::of(Path::new(self.path.text.trim()))? {
            PictureFormat::Png => Some(PictureKind::Png),
            PictureFormat::Exr => Some(PictureKind::Exr),
            _ => None,
        }
    }

    /// Gives the file's name the ending of a kind.
    pub fn set_kind(&mut self, kind: PictureKind) {
        let path = PathBuf::from(self.path.text.trim()).with_extension(kind.extension());
        self.path.text = path.display().to_string();
        self.take_kind_of_path();
    }

    /// Drops what the kind of file cannot hold.
    pub fn take_kind_of_path(&mut self) {
        self.aovs &= self.kind() == Some(PictureKind::Exr);
    }

    /// Whether the file is there already. What was said of another file does not count for this one.
    pub fn is_there(&mut self) -> bool {
        if self.replaces_what != self.path.text {
            (self.replaces, self.replaces_what) = (false, self.path.text.clone());
        }
        self.path.path().is_some_and(|path| path.exists())
    }

    /// The file, if nothing is missing.
    ///
    /// # Errors
    /// One line: what is missing yet, or a size that `render` refuses too.
    pub fn check(&mut self, session: &Session) -> Result<PathBuf, String> {
        let path = self.path.path().ok_or(tr!("dialogs.name_a_file"))?;
        if self.kind().is_none() {
            return Err(tr!("dialogs_picture.endings").into());
        }
        if self.is_there() && !self.replaces {
            return Err(tr!("dialogs.file_there").into());
        }
        self.quality.check(session.navigator.camera())?;
        Ok(std::path::absolute(&path).unwrap_or(path))
    }

    /// What is to be rendered.
    ///
    /// # Errors
    /// As [`Self::check`].
    pub fn request(&mut self, session: &Session) -> Result<ExportRequest, String> {
        let path = self.check(session)?;
        let frame = self.quality.frame(session, session.render_camera())?.aovs(self.aovs);
        Ok(ExportRequest {
            jobs: vec![Job { frame, path }],
            tone_map: session.render_settings.tone_map,
            sixteen_bits: self.sixteen_bits,
            existing: if self.replaces { Existing::Replace } else { Existing::Refuse },
        })
    }

    /// The command that renders the same file.
    pub fn command(&self, session: &Session) -> Option<RenderCommand> {
        Some(RenderCommand {
            size: self.quality.size.into(),
            samples: self.quality.samples,
            transparent: self.quality.transparent,
            aovs: self.aovs,
            sixteen_bits: self.sixteen_bits,
            outputs: vec![self.path.path()?],
            ..session.render_command()?
        })
    }
}
