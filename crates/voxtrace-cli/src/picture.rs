//! The files that a film is written to, and the options that say how.

use crate::clip::Clip;
use crate::failure::Failure;
use crate::outputs;
use crate::parse;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::output::{Denoised, FilmFile, Operator, PictureFormat, PictureOptions, ToneMap, check_writable};

/// How a film becomes pictures.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub struct PictureArgs {
    /// File to write: .png, .exr, or .vxf for the film itself; may be repeated
    #[arg(short, long = "output", value_name = "FILE")]
    pub output: Vec<PathBuf>,
    /// Exposure in stops (PNG only)
    #[arg(long, value_name = "STOPS", default_value = "0", value_parser = exposure, allow_hyphen_values = true)]
    pub exposure: f32,
    /// Tone mapping operator (PNG only)
    #[arg(long, value_name = "OPERATOR", default_value = "agx")]
    pub tone_map: OperatorArg,
    /// Bits of a channel: 8 or 16 for PNG, 16 or 32 for EXR [default: 8 for PNG, 32 for EXR]
    #[arg(long, value_name = "BITS", value_parser = ["8", "16", "32"])]
    pub bit_depth: Option<String>,
}

/// Parses an exposure.
pub fn exposure(text: &str) -> Result<f32, String> {
    let stops = parse::finite(text)?;
    if stops.abs() <= 64.0 { Ok(stops) } else { Err("from -64 to 64 stops are possible".into()) }
}

/// The options about tone mapping that say something else than they do by themselves.
pub fn tone_options(exposure: f32, tone_map: OperatorArg) -> impl Iterator<Item = &'static str> {
    let options = [(exposure != 0.0, "--exposure"), (tone_map != OperatorArg::Agx, "--tone-map")];
    options.into_iter().filter(|(is_asked, _)| *is_asked).map(|(_, option)| option)
}

/// [`Operator`] as an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum OperatorArg {
    /// S-curve over 16.5 stops, highlights desaturate as on film
    Agx,
    /// Base colours unchanged, highlights compressed (Khronos PBR Neutral)
    Neutral,
    /// L / (1 + L)
    Reinhard,
    /// Clipped at 1
    Linear,
}

impl OperatorArg {
    /// The operator that the option names.
    pub fn operator(self) -> Operator {
        match self {
            Self::Agx => Operator::Agx,
            Self::Neutral => Operator::Neutral,
            Self::Reinhard => Operator::Reinhard,
            Self::Linear => Operator::Linear,
        }
    }
}

fn format_of(path: &Path) -> Result<PictureFormat, Failure> {
    if path.as_os_str() == "-" {
        return Err(
            Failure::usage("pictures are not written to standard output").hint("name a file, for example a.png")
        );
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if let Some(at) = name.find('%') {
        let digits = name[at + 1..].trim_start_matches(|c: char| c.is_ascii_digit());
        if digits.starts_with('d') {
            let failure = Failure::usage(format!("{}: %d is not what frames are counted with", path.display()));
            return Err(failure.hint("write #### where the number of the frame goes"));
        }
    }
    PictureFormat::of(path).ok_or_else(|| {
        let hint = match Clip::is_clip(path) {
            true => "`voxtrace animate` writes clips; a picture is named .png, .exr or .vxf (the film itself)",
            false => "name it .png, .exr or .vxf (the film itself)",
        };
        Failure::usage(format!("{}: unknown kind of picture", path.display())).hint(hint)
    })
}

impl PictureArgs {
    /// Refuses what cannot be written, before the long work starts.
    pub fn check(&self, checkpoint: Option<&Path>) -> Result<(), Failure> {
        let formats = self.output.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
        let only =
            |format| formats.contains(&format) && formats.iter().all(|&f| f == format || f == PictureFormat::Film);
        match self.bit_depth.as_deref() {
            Some("32") if only(PictureFormat::Png) => Err(Failure::usage("a PNG has 8 or 16 bits a channel"))?,
            Some("8") if only(PictureFormat::Exr) => Err(Failure::usage("an EXR has 16 or 32 bits a channel"))?,
            _ => {}
        }
        let paths: Vec<&Path> = self.output.iter().map(PathBuf::as_path).chain(checkpoint).collect();
        for path in &paths {
            check_writable(path).map_err(|error| Failure::output(path, &error))?;
        }
        outputs::refuse_twice(&paths)
    }

    /// Whether a picture is written, not films alone.
    pub fn has_picture(&self) -> bool {
        self.output.iter().any(|path| PictureFormat::of(path).is_some_and(|format| format != PictureFormat::Film))
    }

    /// Says which options mean nothing to the files that are written, so that nobody takes them for done.
    pub fn warn_of_needless(&self, report: &Report) {
        let has_png = self.output.iter().any(|path| PictureFormat::of(path) == Some(PictureFormat::Png));
        for option in tone_options(self.exposure, self.tone_map).filter(|_| !has_png) {
            report.warn(&format!("{option} is for PNG, and there is none: add -o NAME.png"));
        }
        if self.bit_depth.is_some() && !self.has_picture() {
            report.warn("--bit-depth is for PNG and EXR, and there is none: add -o NAME.png or NAME.exr");
        }
    }

    /// Whether an output holds more than the picture: AOVs, and the light of groups.
    pub fn has_layers(&self) -> bool {
        self.output.iter().any(|path| PictureFormat::of(path).is_some_and(|format| format != PictureFormat::Png))
    }

    /// Writes a film to one file, in the format that its name says.
    pub fn write(
        &self,
        path: &Path,
        file: &FilmFile,
        denoised: Option<&Denoised>,
        report: &Report,
    ) -> Result<(), Failure> {
        let options =
            PictureOptions { tone_map: self.tone_map(), sixteen_bits: self.bit_depth.as_deref() == Some("16") };
        match format_of(path)? {
            PictureFormat::Film => file.save(path).map_err(|error| Failure::output(path, &error))?,
            format => outputs::write(path, |out| file.encode_denoised(out, format, &options, denoised))?,
        }
        report.wrote(path);
        Ok(())
    }

    fn tone_map(&self) -> ToneMap {
        ToneMap { operator: self.tone_map.operator(), exposure: self.exposure }
    }
}

/// The file for one of several views: `####` becomes the number of the frame, with zeros in front; a camera's name, or
/// a number without its `####`, goes before the extension.
pub fn path_of_view(pattern: &Path, camera: Option<&str>, frame: Option<u32>) -> PathBuf {
    let name = pattern.file_name().unwrap_or_default().to_string_lossy();
    let (mut stem, extension) = match name.rsplit_once('.') {
        Some((stem, extension)) => (stem.to_owned(), format!(".{extension}")),
        None => (name.into_owned(), String::new()),
    };
    if let Some(camera) = camera {
        // A camera's name comes from a file: what is no plain character must not leave the folder.
        let plain = |c: char| if c.is_alphanumeric() || matches!(c, '-' | '_') { c } else { '-' };
        stem = format!("{stem}_{}", camera.chars().map(plain).collect::<String>());
    }
    if let Some(frame) = frame {
        let digits = stem.chars().filter(|&c| c == '#').count();
        stem = match stem.find('#') {
            Some(at) => {
                let number = format!("{frame:0digits$}");
                format!("{}{number}{}", &stem[..at], stem[at..].trim_start_matches('#'))
            }
            None => format!("{stem}_{frame:04}"),
        };
    }
    pattern.with_file_name(stem + &extension)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(pattern: &str, camera: Option<&str>, frame: Option<u32>) -> String {
        path_of_view(Path::new(pattern), camera, frame).to_string_lossy().into_owned()
    }

    #[test]
    fn hashes_become_the_frame_and_cameras_come_before_the_extension() {
        assert_eq!(named("a/shot_####.png", None, Some(7)), "a/shot_0007.png");
        assert_eq!(named("a/##-shot.png", None, Some(123)), "a/123-shot.png");
        assert_eq!(named("shot.png", None, Some(7)), "shot_0007.png");
        assert_eq!(named("a.b/shot.tar.exr", Some("altar"), None), "a.b/shot.tar_altar.exr");
        assert_eq!(named("shot_####.png", Some("altar"), Some(3)), "shot_0003_altar.png");
        assert_eq!(named("shot.png", None, None), "shot.png");
    }

    #[test]
    fn a_camera_s_name_cannot_leave_the_folder() {
        assert_eq!(named("a/shot.png", Some("../../etc/x y"), None), "a/shot_------etc-x-y.png");
    }
}
