//! What of a render can be shared among machines as ranges of samples.

use super::{DEFAULT_SAMPLES, RenderArgs};
use crate::failure::Failure;
use std::path::Path;

/// A picture to be made in parts.
pub struct Shared {
    pub first_sample: u32,
    pub samples: u32,
    pub outputs: Vec<String>,
    /// What names of its parts begin with: the first output without its extension.
    pub stem: String,
}

impl RenderArgs {
    /// The picture that is to be made in parts; options that need all of it at once are refused.
    pub(in crate::verbs) fn shared(&self) -> Result<Shared, Failure> {
        let refuse = |is_there: bool, option: &str, hint: &str| match is_there {
            true => Err(Failure::usage(format!("{option} needs the whole picture, and plan makes parts")).hint(hint)),
            false => Ok(()),
        };
        if !self.view.is_one() {
            return Err(Failure::usage("plan shares one picture")
                .hint("one plan for each --camera; the frames of a turntable or flight are shared by --frames"));
        }
        refuse(self.quality.time_limit.is_some(), "--time-limit", "--spp N says how many samples there are")?;
        refuse(self.quality.noise.is_some(), "--noise", "--spp N says how many samples there are")?;
        refuse(self.quality.denoise.is_some(), "--denoise", "--cluster removes noise of a picture that many machines make")?;
        refuse(self.surroundings.has_background(), "--background", "--transparent leaves room for one")?;
        refuse(self.film.resume.is_some(), "--resume", "--first-sample N begins behind a film of N samples, which merge takes")?;
        refuse(self.film.checkpoint.is_some(), "--checkpoint", "each part writes its film")?;
        refuse(self.tracer.has_cluster(), "--cluster", "render takes it")?;
        let mut outputs = Vec::new();
        for path in &self.picture.output {
            let text = path.to_str().ok_or_else(|| Failure::usage(format!("{} is not Unicode", path.display())))?;
            outputs.push(text.to_owned());
        }
        if outputs.is_empty() {
            outputs.push(format!("{}.png", self.scene.stem()));
        }
        let stem = Path::new(&outputs[0]).with_extension("").to_string_lossy().into_owned();
        let samples = self.quality.spp.unwrap_or(DEFAULT_SAMPLES);
        Ok(Shared { first_sample: self.film.first_sample.unwrap_or(0), samples, outputs, stem })
    }
}
