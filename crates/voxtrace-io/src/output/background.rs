//! A film in front of a colour that only the camera sees.

use super::{Denoised, FilmFile};
use glam::Vec3;
use voxtrace_core::film::{MAX_SAMPLE_RADIANCE, RADIANCE_ONE};

impl FilmFile {
    /// The film, and its picture without noise where there is one, before a background of radiance `color` (linear, each channel ≥ 0): samples
    /// that met nothing have that, and none is transparent any more. The film must have been made transparent, or the sky is added twice.
    pub fn over(&self, color: Vec3, denoised: Option<&Denoised>) -> (Self, Option<Denoised>) {
        let mut file = self.clone();
        file.frame.transparent = false;
        let color = color.clamp(Vec3::ZERO, Vec3::splat(MAX_SAMPLE_RADIANCE));
        let units = color.to_array().map(|channel| (f64::from(channel) * RADIANCE_ONE).round() as u64);
        for pixels in [Some(&mut file.film.pixels), file.film.earlier.as_mut()].into_iter().flatten() {
            for pixel in pixels {
                let missed = u64::from(pixel.samples.saturating_sub(pixel.covered));
                for (sum, unit) in pixel.radiance.iter_mut().zip(units) {
                    *sum = sum.saturating_add(unit.saturating_mul(missed));
                }
                pixel.covered = pixel.samples;
            }
        }
        let denoised = denoised.map(|denoised| {
            let behind = self.film.pixels.iter().map(|pixel| match pixel.samples {
                0 => Vec3::ZERO,
                samples => color * (1.0 - pixel.covered as f32 / samples as f32),
            });
            let radiance = denoised.radiance.iter().zip(behind).map(|(own, behind)| *own + behind).collect();
            Denoised { radiance, ..*denoised }
        });
        (file, denoised)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::SceneStamp;
    use voxtrace_core::film::Pixel;
    use voxtrace_core::{Film, Frame, Integrator, PackedScene, Region};
    use voxtrace_scene::{Camera, Scene};

    #[test]
    fn what_met_nothing_has_the_colour_and_what_met_something_its_own() {
        let camera = Camera::look_at(Vec3::ZERO, Vec3::X);
        let frame = Frame::new(camera, 2, 1).integrator(Integrator::Path).samples(4).transparent(true);
        let mut film = Film::new(2, 1, Region::full(2, 1), 0);
        for (pixel, is_met) in [(0, [true; 4]), (1, [true, false, false, false])] {
            let samples: &mut Pixel = &mut film.pixels[pixel];
            is_met
                .into_iter()
                .for_each(|is_met| samples.add(if is_met { Vec3::splat(0.5) } else { Vec3::ZERO }, is_met));
        }
        let scene = SceneStamp::of(&PackedScene::pack(&Scene::default()).unwrap());
        let file = FilmFile { frame, scene, film };
        let denoised = Denoised { radiance: vec![Vec3::splat(0.5), Vec3::splat(0.125)], filter: "voxtrace" };
        let (over, denoised) = file.over(Vec3::new(1.0, 0.0, 2.0), Some(&denoised));
        assert_eq!(over.film.pixels[0], file.film.pixels[0]);
        assert_eq!(over.film.pixels[1].mean(), Vec3::new(0.875, 0.125, 1.625));
        assert_ne!(over.film.pixels[1].mean(), file.film.pixels[1].mean());
        assert_eq!(denoised.unwrap().radiance, [Vec3::splat(0.5), Vec3::new(0.875, 0.125, 1.625)]);
        assert!(!over.frame.transparent && over.film.pixels.iter().all(|pixel| pixel.covered == 4));
        // What is not transparent has nothing behind it.
        assert_eq!(over.over(Vec3::ONE, None).0.film, over.film);
    }
}
