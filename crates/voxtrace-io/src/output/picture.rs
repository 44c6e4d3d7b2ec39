//! A film as a file for people or programs, in the format that the file's name says.

use super::{ExrOptions, FilmFile, Metadata, PngDepth, PngOptions, ToneMap, exr, png};
use glam::Vec3;
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;

/// Formats that a film is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// `.png`: tone-mapped, for people.
    Png,
    /// `.exr`: linear radiance and AOVs, for compositing.
    Exr,
    /// `.vxf`: the film itself, which a later render continues.
    Film,
}

impl PictureFormat {
    /// The format that a file's extension names; `None` for any other extension.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "png" => Some(Self::Png),
            "exr" => Some(Self::Exr),
            "vxf" => Some(Self::Film),
            _ => None,
        }
    }
}

/// How a film becomes a picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct PictureOptions {
    /// From radiance to the screen (PNG only).
    pub tone_map: ToneMap,
    /// 16 bits a channel in place of the usual number: 8 for PNG, 32 for EXR.
    pub sixteen_bits: bool,
}

/// A film's picture without its noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Denoised {
    /// Mean radiance of each pixel of the film, linear.
    pub radiance: Vec<Vec3>,
    /// Name of the filter, for the picture's metadata.
    pub filter: &'static str,
}

impl FilmFile {
    /// Encodes the film as PNG or EXR.
    ///
    /// # Errors
    /// What the writer reports; [`io::ErrorKind::Unsupported`] for [`PictureFormat::Film`], which [`Self::save`] writes.
    pub fn encode(&self, out: impl Write, format: PictureFormat, options: &PictureOptions) -> io::Result<()> {
        self.encode_denoised(out, format, options, None)
    }

    /// As [`Self::encode`], with the colours of `denoised` where there is one; an EXR keeps those of the film beside them.
    ///
    /// # Errors
    /// As [`Self::encode`]; [`io::ErrorKind::InvalidInput`] where `denoised` has other pixels than the film.
    pub fn encode_denoised(
        &self,
        out: impl Write,
        format: PictureFormat,
        options: &PictureOptions,
        denoised: Option<&Denoised>,
    ) -> io::Result<()> {
        self.encode_while(out, format, options, denoised, &|| true)
    }

    /// As [`Self::encode_denoised`], as long as it is wanted.
    fn encode_while(
        &self,
        out: impl Write,
        format: PictureFormat,
        options: &PictureOptions,
        denoised: Option<&Denoised>,
        wanted: &(dyn Fn() -> bool + Sync),
    ) -> io::Result<()> {
        if denoised.is_some_and(|denoised| denoised.radiance.len() != self.film.pixels.len()) {
            return Err(io::ErrorKind::InvalidInput.into());
        }
        let metadata = Metadata::new(&self.frame, &self.scene, &self.film);
        let metadata = match denoised {
            Some(denoised) => metadata.with_filter(denoised.filter),
            None => metadata,
        };
        let denoised = denoised.map(|denoised| &denoised.radiance[..]);
        let alpha = self.frame.transparent;
        match format {
            PictureFormat::Png => {
                let depth = if options.sixteen_bits { PngDepth::Sixteen } else { PngDepth::Eight };
                let options = PngOptions { tone_map: options.tone_map, depth, alpha };
                png::write(out, &self.film, denoised, &options, &metadata)
            }
            PictureFormat::Exr => {
                let options = ExrOptions { half: options.sixteen_bits, alpha };
                exr::write(out, &self.film, denoised, &options, &metadata, wanted)
            }
            PictureFormat::Film => Err(io::ErrorKind::Unsupported.into()),
        }
    }

    /// Writes the film as a picture, atomically: the file is whole or what it was before.
    ///
    /// # Errors
    /// What the operating system reports; [`io::ErrorKind::InvalidFilename`] where the extension names no format of
    /// [`PictureFormat`].
    pub fn save_picture(&self, path: &Path, options: &PictureOptions) -> io::Result<()> {
        self.save_denoised(path, options, None)
    }

    /// As [`Self::save_picture`], with the colours of `denoised` where there is one; a film stays as it is.
    ///
    /// # Errors
    /// As [`Self::save_picture`] and [`Self::encode_denoised`].
    pub fn save_denoised(&self, path: &Path, options: &PictureOptions, denoised: Option<&Denoised>) -> io::Result<()> {
        self.save_denoised_while(path, options, denoised, &|| true)
    }

    /// As [`Self::save_denoised`], as long as it is `wanted`, which says no for good: once it is not, saving ends soon, and the file is what it was before.
    /// Only the compression of a PNG is not interrupted.
    ///
    /// # Errors
    /// As [`Self::save_denoised`], and one of [`io::ErrorKind::Other`] once it is not wanted.
    pub fn save_denoised_while(
        &self,
        path: &Path,
        options: &PictureOptions,
        denoised: Option<&Denoised>,
        wanted: &(dyn Fn() -> bool + Sync),
    ) -> io::Result<()> {
        match PictureFormat::of(path).ok_or(io::ErrorKind::InvalidFilename)? {
            PictureFormat::Film => {
                let bytes = self.to_bytes();
                write_atomically_while(path, wanted, |out| out.write_all(&bytes))
            }
            format => {
                write_atomically_while(path, wanted, |out| self.encode_while(out, format, options, denoised, wanted))
            }
        }
    }
}
