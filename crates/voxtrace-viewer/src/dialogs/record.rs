//! Recording the timeline: to a clip, or to numbered frames, by the program's own `animate`.

use super::{PathField, Quality, quality};
use crate::render_command::{RenderCommand, Sequence};
use crate::running::RunRequest;
use crate::session::Session;
use crate::tr;
use std::path::{Path, PathBuf};

/// What is recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecordKind {
    /// `.mp4`
    Mp4,
    /// `.gif`
    Gif,
    /// An animated `.png`
    Apng,
    /// Numbered `.png`
    PngFrames,
    /// Numbered `.exr`
    ExrFrames,
}

impl RecordKind {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Mp4, Self::Gif, Self::Apng, Self::PngFrames, Self::ExrFrames];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mp4 => "MP4",
            Self::Gif => "GIF",
            Self::Apng => tr!("dialogs_record.apng"),
            Self::PngFrames => tr!("dialogs_record.png"),
            Self::ExrFrames => tr!("dialogs_record.exr"),
        }
    }

    /// Whether each frame is a file.
    pub fn is_frames(self) -> bool {
        matches!(self, Self::PngFrames | Self::ExrFrames)
    }

    fn ending(self) -> &'static str {
        match self {
            Self::Mp4 => "mp4",
            Self::Gif => "gif",
            Self::Apng | Self::PngFrames => "png",
            Self::ExrFrames => "exr",
        }
    }
}

/// What somebody has chosen.
#[derive(Clone, Debug)]
pub struct RecordDialog {
    /// The clip, or the pattern of the frames' names: `shot_####.png`.
    pub path: PathField,
    /// Size, samples, background.
    pub quality: Quality,
    /// Of frames: whether those that are there stay, so that a row goes on.
    pub keeps: bool,
    /// Whether files that are there are written over.
    pub replaces: bool,
    replaces_what: String,
    /// Frames that are there, of how many of a pattern, when they were counted.
    counted: Option<((String, u32), u32)>,
}

impl RecordDialog {
    /// What the dialog begins with: a clip beside the scene, of the window's size.
    pub fn new(session: &Session) -> Self {
        let (folder, stem) = (session.usual_folder(), session.stem());
        let name =
            |number: u32| folder.join(if number < 2 { format!("{stem}.mp4") } else { format!("{stem}-{number}.mp4") });
        let free = (1..).map(name).find(|path| !path.exists()).unwrap_or_default();
        Self {
            path: PathField::new(&free),
            quality: Quality::of(session, quality::RECORD, 64),
            keeps: false,
            replaces: false,
            replaces_what: String::new(),
            counted: None,
        }
    }

    /// The kind that the file's name says.
    pub fn kind(&self) -> Option<RecordKind> {
        let text = self.path.text.trim();
        let path = Path::new(text);
        let counts = path.file_name().is_some_and(|name| name.to_string_lossy().contains('#'));
        let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
        let ending = if ending == "apng" { "png".to_owned() } else { ending };
        RecordKind::ALL.into_iter().find(|kind| kind.ending() == ending && kind.is_frames() == counts)
    }

    /// Gives the file's name what a kind needs.
    pub fn set_kind(&mut self, kind: RecordKind) {
        let path = PathBuf::from(self.path.text.trim());
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().trim_end_matches(['#', '_']).to_owned();
        let name = if kind.is_frames() { format!("{stem}_####") } else { stem };
        self.path.text = path.with_file_name(format!("{name}.{}", kind.ending())).display().to_string();
    }

    /// The file, or the pattern.
    fn path(&self) -> Option<PathBuf> {
        self.path.path().map(|path| std::path::absolute(&path).unwrap_or(path))
    }

    /// How many of the files are there already; frames are counted when the pattern or their number changes. What was said of others does not count for these.
    pub fn there(&mut self, frames: u32) -> u32 {
        if self.replaces_what != self.path.text {
            (self.replaces, self.keeps, self.replaces_what) = (false, false, self.path.text.clone());
        }
        let Some(path) = self.path() else { return 0 };
        if !self.kind().is_some_and(RecordKind::is_frames) {
            return u32::from(path.exists());
        }
        let key = (self.path.text.clone(), frames);
        if let Some((_, there)) = self.counted.as_ref().filter(|(counted, _)| *counted == key) {
            return *there;
        }
        let there = match path.parent().is_some_and(Path::is_dir) {
            true => (1..=frames.min(MOST_LOOKED_FOR)).filter(|&frame| numbered(&path, frame).exists()).count() as u32,
            // A folder that is not there has none.
            false => 0,
        };
        self.counted = Some((key, there));
        there
    }

    /// Where it is recorded, if nothing is missing.
    ///
    /// # Errors
    /// One line: what is missing yet.
    pub fn check(&mut self, session: &Session) -> Result<PathBuf, String> {
        let path = self.path().ok_or(tr!("dialogs.name_a_file"))?;
        let course = &session.timeline.course;
        if course.track().is_none() && !session.has_motion() {
            return Err(tr!("timeline.two_keys").into());
        }
        if self.kind().is_none() {
            return Err(tr!("dialogs_record.endings").into());
        }
        self.quality.check(session.navigator.camera())?;
        if self.there(course.frames()) > 0 && !self.replaces && !self.keeps {
            return Err(tr!("dialogs_record.there").into());
        }
        Ok(path)
    }

    /// The command that records a timeline that is kept in `file`.
    ///
    /// # Errors
    /// One line: what is missing yet, or why there is no such command.
    pub fn request(&mut self, session: &Session, file: PathBuf) -> Result<RunRequest, String> {
        // Frames may have come since they were counted.
        self.counted = None;
        let path = self.check(session)?;
        let command = self.command(session, file).ok_or(tr!("dialogs_record.no_scene"))?;
        let folders = path.parent().map(Path::to_path_buf).into_iter().collect();
        let words = command.words().map_err(|error| error.to_string())?;
        Ok(RunRequest { words, name: path.display().to_string(), folders, measures: false })
    }

    /// That command.
    pub fn command(&self, session: &Session, file: PathBuf) -> Option<RenderCommand> {
        Some(RenderCommand {
            size: self.quality.size.into(),
            samples: self.quality.samples,
            transparent: self.quality.transparent,
            sequence: Some(Sequence::Animation { file, keeps: self.keeps }),
            outputs: vec![self.path()?],
            ..session.render_command()?
        })
    }
}

/// Most frames that are looked for one by one.
const MOST_LOOKED_FOR: u32 = 10_000;

/// The file of a frame by a pattern with `#`.
fn numbered(pattern: &Path, frame: u32) -> PathBuf {
    let name = pattern.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let Some(first) = name.find('#') else { return pattern.to_path_buf() };
    let digits = name[first..].bytes().take_while(|&byte| byte == b'#').count();
    pattern.with_file_name(format!("{}{frame:0digits$}{}", &name[..first], &name[first + digits..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dialog(path: &Path) -> RecordDialog {
        RecordDialog {
            path: PathField::new(path),
            quality: Quality { size: [4, 3], samples: 1, transparent: false },
            keeps: false,
            replaces: false,
            replaces_what: String::new(),
            counted: None,
        }
    }

    #[test]
    fn frames_are_counted_once_for_each_pattern_and_number() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("shot_0003.png");
        std::fs::write(&file, "").unwrap();
        let mut dialog = dialog(&folder.path().join("shot_####.png"));
        assert_eq!(dialog.there(5), 1);
        std::fs::remove_file(&file).unwrap();
        assert_eq!(dialog.there(5), 1, "a window asks for each of its frames");
        assert_eq!((dialog.there(2), dialog.there(5)), (0, 0), "of another number they are counted anew");
        dialog.set_kind(RecordKind::Mp4);
        assert_eq!(dialog.there(5), 0);
        std::fs::write(folder.path().join("shot.mp4"), "").unwrap();
        assert_eq!(dialog.there(5), 1, "one file is looked for each time");
    }

    #[test]
    fn the_name_says_what_is_recorded() {
        let mut dialog = dialog(Path::new("/a/city.mp4"));
        for kind in RecordKind::ALL.into_iter().chain(RecordKind::ALL.into_iter().rev()) {
            dialog.set_kind(kind);
            assert_eq!(dialog.kind(), Some(kind), "{}", dialog.path.text);
        }
        assert_eq!(dialog.path.text, "/a/city.mp4");
        assert_eq!(numbered(Path::new("/a/shot_####.png"), 7), PathBuf::from("/a/shot_0007.png"));
    }
}
