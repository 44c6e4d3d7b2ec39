//! The whole input of one render call. A picture depends on the `Frame` and the packed scene alone.

use crate::bounce_limits::BounceLimits;
use crate::film::Film;
use crate::light_group::LightGroup;
use crate::lines::Lines;
use crate::packed::PackedScene;
pub use crate::region::Region;
use crate::trace_error::TraceError;
use voxtrace_scene::camera::Camera;

/// Most pixels of the region of a frame, and so of a film: 16,384², 8 GiB of sums.
pub const MAX_PIXELS: u64 = 1 << 28;

/// Most bounces of a path: what tracers count exceeds it by a little and must fit 32 bits, and hardly any path comes near it.
const MOST_BOUNCES: u32 = u16::MAX as u32;

/// What to render: view, size, samples and how light is computed. [`Frame::new`] makes one, its methods change it:
///
/// ```
/// use voxtrace_core::{Frame, Integrator};
/// use voxtrace_scene::{Camera, glam::Vec3};
///
/// let camera = Camera::look_at(Vec3::new(0.0, -50.0, 20.0), Vec3::ZERO);
/// let frame = Frame::new(camera, 1280, 720).samples(64).seed(7).max_bounces(4);
/// assert_eq!((frame.region.pixels(), frame.integrator), (1280 * 720, Integrator::Path));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Frame {
    /// The view.
    pub camera: Camera,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// The part to render.
    pub region: Region,
    /// Number of the first sample of each pixel.
    pub first_sample: u32,
    /// Samples of each pixel: the picture holds the samples `first_sample .. first_sample + samples`.
    pub samples: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Most surfaces that scatter one path, so that it has at most one ray more than that (the study: 3 and 4); 0 gives a
    /// picture of the sky and the lights alone. At most 65,535.
    pub max_bounces: u32,
    /// How light is computed.
    pub integrator: Integrator,
    /// Whether a camera ray that meets no voxel leaves its sample black rather than the colour of the sky, so that the
    /// picture can be laid over another with [`crate::film::Pixel::alpha`].
    pub transparent: bool,
    /// Whether to fill the film's AOVs (albedo, normal, depth, instance and voxel) as well.
    pub aovs: bool,
    /// Whose light is gathered: all of it, or that of one group.
    pub light_group: LightGroup,
    /// Most bounces of each kind, beside `max_bounces`.
    pub bounce_limits: BounceLimits,
    /// Most radiance, in each channel, that one bounce may add of light that does not arrive directly: brighter light is darkened in its own
    /// hue, so that the picture is too dark there. Infinite: everything is kept.
    pub clamp_indirect: f32,
    /// Whether light passes clear glass straight and less what it reflects and absorbs, once a surface that is no mirror has scattered the path: lights
    /// are found through glass then, and what glass would focus is not.
    pub clear_shadows: bool,
    /// Whether the ground of [`crate::surroundings::Ground`] shows nothing but the shadows on it, from above: black, and alpha is the share of the
    /// light of sun and sky (its luminance) that the scene keeps from bare ground. What lamps and objects send there does not count. Mirrors and glass
    /// show the ground as it is. Needs `transparent` and [`Integrator::Path`].
    pub shadow_catcher: bool,
    /// Lines on the faces of voxels; [`Integrator::Path`] draws them, on scenes whose instances were kept apart ([`PackedScene::split`]).
    pub lines: Lines,
}

impl Frame {
    /// The whole picture of `width` × `height` pixels: one sample a pixel from the first on, seed 0, up to 8 bounces by
    /// [`Integrator::Path`], the sky as background and no AOVs.
    pub fn new(camera: Camera, width: u32, height: u32) -> Self {
        Self {
            camera,
            width,
            height,
            region: Region::full(width, height),
            first_sample: 0,
            samples: 1,
            seed: 0,
            max_bounces: 8,
            integrator: Integrator::Path,
            transparent: false,
            aovs: false,
            light_group: LightGroup::All,
            bounce_limits: BounceLimits::default(),
            clamp_indirect: f32::INFINITY,
            clear_shadows: false,
            shadow_catcher: false,
            lines: Lines::default(),
        }
    }

    /// Another view.
    #[must_use]
    pub fn camera(self, camera: Camera) -> Self {
        Self { camera, ..self }
    }

    /// Another size, pixels; the whole picture is rendered.
    #[must_use]
    pub fn size(self, width: u32, height: u32) -> Self {
        Self { width, height, region: Region::full(width, height), ..self }
    }

    /// Renders a part of the picture only.
    #[must_use]
    pub fn region(self, region: Region) -> Self {
        Self { region, ..self }
    }

    /// Begins with another sample, so that parts of one picture come from several machines.
    #[must_use]
    pub fn first_sample(self, first_sample: u32) -> Self {
        Self { first_sample, ..self }
    }

    /// Samples of each pixel.
    #[must_use]
    pub fn samples(self, samples: u32) -> Self {
        Self { samples, ..self }
    }

    /// Seed of the random numbers.
    #[must_use]
    pub fn seed(self, seed: u32) -> Self {
        Self { seed, ..self }
    }

    /// Most surfaces that scatter one path, up to 65,535.
    #[must_use]
    pub fn max_bounces(self, max_bounces: u32) -> Self {
        Self { max_bounces, ..self }
    }

    /// How light is computed.
    #[must_use]
    pub fn integrator(self, integrator: Integrator) -> Self {
        Self { integrator, ..self }
    }

    /// Whether the background stays transparent.
    #[must_use]
    pub fn transparent(self, transparent: bool) -> Self {
        Self { transparent, ..self }
    }

    /// Whether to fill the film's AOVs.
    #[must_use]
    pub fn aovs(self, aovs: bool) -> Self {
        Self { aovs, ..self }
    }

    /// Gathers the light of one group alone: a film of its own for [`Film::groups`].
    #[must_use]
    pub fn light_group(self, light_group: LightGroup) -> Self {
        Self { light_group, ..self }
    }

    /// Most bounces of each kind, beside those in all.
    #[must_use]
    pub fn bounce_limits(self, bounce_limits: BounceLimits) -> Self {
        Self { bounce_limits, ..self }
    }

    /// Clamps what each bounce adds of indirect light, which biases the picture.
    #[must_use]
    pub fn clamp_indirect(self, clamp_indirect: f32) -> Self {
        Self { clamp_indirect, ..self }
    }

    /// Lets light pass clear glass straight, which biases the picture.
    #[must_use]
    pub fn clear_shadows(self, clear_shadows: bool) -> Self {
        Self { clear_shadows, ..self }
    }

    /// Shows nothing of the ground but the shadows on it.
    #[must_use]
    pub fn shadow_catcher(self, shadow_catcher: bool) -> Self {
        Self { shadow_catcher, ..self }
    }

    /// Draws lines on the faces of voxels.
    #[must_use]
    pub fn lines(self, lines: Lines) -> Self {
        Self { lines, ..self }
    }

    /// Whether this frame asks for more samples of the picture that `last` asked for.
    pub fn continues(&self, last: &Self) -> bool {
        *last == Self { samples: last.samples, ..self.clone() }
    }

    /// Checks that the frame can be rendered.
    ///
    /// # Errors
    /// [`TraceError::BadFrame`] for an empty region or one of more than [`MAX_PIXELS`], numbers that overflow or a camera that is not finite.
    pub fn check(&self) -> Result<(), TraceError> {
        let bad = |reason: &str| Err(TraceError::BadFrame(reason.into()));
        let region = self.region;
        if region.pixels() == 0 {
            return bad("the region is empty");
        }
        if region.x1 > self.width || region.y1 > self.height {
            return bad("the region reaches beyond the picture");
        }
        if self.width.checked_mul(self.height).is_none() {
            return bad("the picture has more than 2³² pixels");
        }
        if region.pixels() as u64 > MAX_PIXELS {
            return bad("more than 2²⁸ pixels are to be rendered at once; render regions of the picture");
        }
        if self.first_sample.checked_add(self.samples).is_none() {
            return bad("sample numbers exceed 2³²");
        }
        if self.max_bounces > MOST_BOUNCES {
            return bad("a path has at most 65,535 bounces");
        }
        if self.light_group != LightGroup::All && self.integrator == Integrator::Essay {
            return bad("the integrator essay knows no light groups");
        }
        if self.clamp_indirect.is_nan() || self.clamp_indirect <= 0.0 {
            return bad("indirect light is clamped to a number above 0");
        }
        if self.has_path_limits() && self.integrator == Integrator::Essay {
            return bad("the integrator essay knows neither kinds of bounces nor indirect light");
        }
        if self.clear_shadows && self.integrator == Integrator::Essay {
            return bad("the integrator essay casts no rays to lights, which could be clear");
        }
        if self.shadow_catcher && (!self.transparent || self.integrator == Integrator::Essay) {
            return bad("a ground that shows shadows alone needs a transparent background and the integrator path");
        }
        if !self.lines.is_none() && self.integrator == Integrator::Essay {
            return bad("the integrator essay draws no lines on voxels");
        }
        self.lines.check().and_then(|()| self.camera.check()).or_else(bad)
    }

    /// Whether bounces of a kind are limited, or indirect light is.
    pub fn has_path_limits(&self) -> bool {
        self.bounce_limits != BounceLimits::default() || self.clamp_indirect < f32::INFINITY
    }

    /// Checks that lines are drawn on instances that were kept apart: a merged grid goes on where one of them ends.
    ///
    /// # Errors
    /// [`TraceError::BadFrame`] for lines on a scene whose instances were merged.
    #[doc(hidden)]
    pub fn check_in(&self, scene: &PackedScene) -> Result<(), TraceError> {
        if !self.lines.is_none() && scene.is_merged() {
            let reason = "lines on voxels need instances that are kept apart: split the scene, or pack it with them";
            return Err(TraceError::BadFrame(reason.into()));
        }
        Ok(())
    }

    /// Checks that `film` holds samples of this frame.
    ///
    /// # Errors
    /// [`TraceError::BadFrame`] where size, region or first sample differ.
    pub fn check_film(&self, film: &Film) -> Result<(), TraceError> {
        let ours = (self.width, self.height, self.region, self.first_sample);
        if (film.width, film.height, film.region, film.first_sample) != ours
            || film.pixels.len() != self.region.pixels()
        {
            return Err(TraceError::BadFrame("the film to resume shows another size, region or first sample".into()));
        }
        Ok(())
    }
}

/// How the light along a camera ray is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Integrator {
    /// Algorithm 1 of the study: no light sampling, the first emitter or the sky ends the path, which is black after
    /// `max_bounces` surfaces. For measuring.
    Essay = 0,
    /// Next-event estimation over emitters and sky with multiple importance sampling and Russian roulette.
    #[default]
    Path = 1,
}

impl Integrator {
    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Essay => "essay",
            Self::Path => "path",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn regions_have_a_limit_that_pictures_may_exceed() {
        let frame = Frame::new(Camera::look_at(Vec3::X, Vec3::ZERO), 60_000, 60_000);
        let says = |frame: &Frame, what: &str| frame.check().is_err_and(|error| error.to_string().contains(what));
        assert!(says(&frame, "2²⁸"));
        let square = Region { x0: 43_616, y0: 43_616, x1: 60_000, y1: 60_000 };
        assert_eq!(frame.clone().region(square).check(), Ok(()));
        assert!(says(&frame.clone().region(Region { x0: 43_615, ..square }), "2²⁸"));
        assert_eq!(frame.clone().size(16_384, 16_384).check(), Ok(()));
        assert!(says(&frame.size(65_536, 65_536).region(square), "2³²"));
    }

    #[test]
    fn bounces_have_a_limit_so_that_what_tracers_count_fits() {
        let frame = Frame::new(Camera::look_at(Vec3::X, Vec3::ZERO), 4, 4);
        assert_eq!(frame.clone().max_bounces(65_535).check(), Ok(()));
        for bounces in [65_536, u32::MAX - 63, u32::MAX] {
            let error = frame.clone().max_bounces(bounces).check().unwrap_err().to_string();
            assert!(error.contains("at most 65,535 bounces"), "{bounces}: {error}");
        }
    }
}
