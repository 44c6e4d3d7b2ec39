//! `voxtrace compare A B`: two reports of `bench`, or two pictures, side by side.

use crate::failure::{Failure, reason};
use crate::import::warn_of_needless;
use crate::outputs;
use crate::picture::{OperatorArg, exposure, tone_options};
use crate::report::Report;
use serde_json::{Value, json};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use voxtrace::difference::{self, Difference, PIXELS_PER_DEGREE, Shown, ShownError};
use voxtrace::import::opened;
use voxtrace::output::ToneMap;
use voxtrace_bench::{CompareError, CompareErrorKind, Comparison};

/// Put two reports of `bench`, or two pictures, side by side
#[derive(clap::Args, Clone, Debug)]
pub struct CompareArgs {
    /// Folder of a report, or its results.json; or a picture: PNG, EXR or film
    #[arg(value_name = "A")]
    a: PathBuf,
    /// The other report or picture
    #[arg(value_name = "B")]
    b: PathBuf,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
    /// Write where two pictures differ (FLIP, from black to pale yellow) as a PNG
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Exposure in stops (EXR and films)
    #[arg(long, value_name = "STOPS", default_value = "0", value_parser = exposure, allow_hyphen_values = true)]
    exposure: f32,
    /// Tone mapping operator (EXR and films)
    #[arg(long, value_name = "OPERATOR", default_value = "agx")]
    tone_map: OperatorArg,
}

impl CompareArgs {
    pub fn run(self, report: &Report) -> Result<(), Failure> {
        let (a, b) = (Side::of(&self.a)?, Side::of(&self.b)?);
        match [a.is_picture(), b.is_picture()] {
            [true, true] => self.pictures([a, b], report),
            [false, false] if self.output.is_none() => {
                let comparison = Comparison::open(&self.a, &self.b)?;
                self.warn_of_needless("reports have no pictures to show", report);
                crate::stdout::print(&if self.json { format!("{:#}\n", comparison.json()) } else { comparison.text() });
                Ok(())
            }
            [is_a, _] => {
                let other = if is_a { &self.b } else { &self.a };
                // What is not there is no file of another kind.
                std::fs::metadata(other)
                    .map_err(|error| Failure::input(format!("cannot read {}: {}", other.display(), reason(&error))))?;
                Err(Failure::input(format!("{}: this is no PNG, EXR or film", other.display()))
                    .hint("compare two pictures, or two reports of `voxtrace bench` without -o"))
            }
        }
    }

    fn pictures(&self, [a, b]: [Side; 2], report: &Report) -> Result<(), Failure> {
        [&self.a, &self.b].into_iter().for_each(|path| opened::note(path));
        if let Some(path) = &self.output {
            if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("png")) {
                return Err(Failure::usage(format!("{}: the map is a PNG", path.display())).hint("name it .png"));
            }
            outputs::check(path)?;
        }
        let tone_map = ToneMap { operator: self.tone_map.operator(), exposure: self.exposure };
        if a.is_png() && b.is_png() {
            self.warn_of_needless("both pictures are PNG, which are shown as they are", report);
        }
        let (a, b) = (a.open(&tone_map)?, b.open(&tone_map)?);
        let difference = Difference::of(&a, &b)
            .map_err(|error| Failure::mismatch(error).hint("render both with the same --size and --crop"))?;
        if let Some(path) = &self.output {
            outputs::write(path, |out| difference.write_map(out))?;
            // What reads JSON expects nothing else on stdout.
            match self.json {
                true => report.wrote_silently(path),
                false => report.wrote(path),
            }
        }
        crate::stdout::print(&if self.json {
            format!("{:#}\n", self.as_json(&difference))
        } else {
            self.as_text(&difference)
        });
        Ok(())
    }

    /// Says which options mean nothing to what is compared.
    fn warn_of_needless(&self, why: &str, report: &Report) {
        warn_of_needless(tone_options(self.exposure, self.tone_map), why, report);
    }

    fn as_text(&self, difference: &Difference) -> String {
        let psnr = difference.psnr();
        let psnr = if psnr.is_finite() { format!("{psnr:.2} dB") } else { "infinite: no difference".into() };
        format!(
            "A                 {}\nB                 {}\nsize              {} x {}\nPSNR              {psnr}\n\
             RMSE              {:.5}\nFLIP              {:.4} in the mean, {:.4} at most\n",
            self.a.display(),
            self.b.display(),
            difference.width,
            difference.height,
            difference.rmse,
            difference.mean_flip(),
            difference.max_flip()
        )
    }

    fn as_json(&self, difference: &Difference) -> Value {
        let psnr = difference.psnr();
        json!({
            "a": self.a.display().to_string(),
            "b": self.b.display().to_string(),
            "width": difference.width,
            "height": difference.height,
            "psnr_db": psnr.is_finite().then_some(psnr),
            "rmse": difference.rmse,
            "flip": {
                "mean": difference.mean_flip(),
                "max": difference.max_flip(),
                "pixels_per_degree": PIXELS_PER_DEGREE,
            },
            "map": self.output.as_ref().map(|path| path.display().to_string()),
        })
    }
}

/// One of the two that are compared.
struct Side<'a> {
    path: &'a Path,
    /// The picture that came through a pipe, which gives its bytes once.
    piped: Option<Vec<u8>>,
}

impl<'a> Side<'a> {
    /// What a name is of. Pipes are read here, and may be pictures alone.
    fn of(path: &'a Path) -> Result<Self, Failure> {
        if !std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir()) {
            return Ok(Self { path, piped: None });
        }
        let unreadable =
            |error: std::io::Error| Failure::input(format!("cannot read {}: {}", path.display(), reason(&error)));
        let (mut pipe, mut bytes) = (File::open(path).map_err(unreadable)?, Vec::new());
        (&mut pipe).take(8).read_to_end(&mut bytes).map_err(unreadable)?;
        if !difference::begins_as_picture(&bytes) {
            let what = format!("cannot compare {}: what comes through a pipe is no PNG, EXR or film", path.display());
            return Err(
                Failure::input(what).hint("reports are files in a folder; write what comes out of it to a file")
            );
        }
        pipe.read_to_end(&mut bytes).map_err(unreadable)?;
        Ok(Self { path, piped: Some(bytes) })
    }

    fn is_picture(&self) -> bool {
        self.piped.is_some() || difference::is_picture(self.path)
    }

    /// Whether a picture is a PNG, by its first bytes.
    fn is_png(&self) -> bool {
        let mut head = [0; 8];
        let read = match &self.piped {
            Some(bytes) => bytes.as_slice().read_exact(&mut head),
            None => File::open(self.path).and_then(|mut file| file.read_exact(&mut head)),
        };
        read.is_ok() && head == *b"\x89PNG\r\n\x1a\n"
    }

    fn open(self, tone_map: &ToneMap) -> Result<Shown, Failure> {
        let shown = match self.piped {
            Some(bytes) => Shown::from_bytes(bytes, tone_map),
            None => Shown::open(self.path, tone_map),
        };
        shown.map_err(|error| {
            let reason = if let ShownError::Io(error) = &error { reason(error) } else { error.to_string() };
            Failure::input(format!("cannot read {}: {reason}", self.path.display()))
        })
    }
}

impl From<CompareError> for Failure {
    fn from(error: CompareError) -> Self {
        let failure = Self::input(&error);
        match error.kind {
            CompareErrorKind::Io(_) | CompareErrorKind::NoReport => {
                failure.hint("name the folder of a report of `voxtrace bench`, or a picture")
            }
            CompareErrorKind::Schema(_) => failure.hint("run the benchmark again"),
            _ => failure,
        }
    }
}
