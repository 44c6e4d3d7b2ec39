//! What is known of each pixel: means over the paths and rays of the frames that it remembers.

use crate::path::Sample;
use crate::real_time::LEAST_LOOKS;
use glam::Vec3;
use voxtrace_core::math::luminance;

/// Added to albedos before they divide, so that black surfaces do not make noise of nothing.
pub(crate) const LEAST_ALBEDO: f32 = 0.003;
/// How many times the products of their means moments are at most where light was found again: what half floats say, less some.
pub(crate) const MOST_BEYOND: f32 = 60_000.0;
/// Steps of each part of a normal on either side of zero.
const NORMAL_STEPS: f32 = 511.0;
/// Added before parts of normals become whole: no half, which means of two, four and more normals often are, so that no rounding decides.
const NORMAL_ROUNDING: f32 = 0.501;
/// Least sum of an albedo's channels that says how much light falls on a surface.
const LEAST_SUM: f32 = 0.0003;

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// Rays of the camera that it remembers: of them are `direct`, `albedo`, `normal`, `place`, `roughness` and `coverage`.
    pub looks: f32,
    /// Paths that it remembers: of them are `light`, `shaded` and `moments`.
    pub paths: f32,
    /// Radiance that is seen directly.
    pub direct: Vec3,
    /// Share of light that what is seen scatters.
    pub albedo: Vec3,
    /// Normals, world space, in ten bits an axis: shorter than one where the pixel shows several.
    pub normal: Vec3,
    /// Where surfaces are, world space.
    pub place: Vec3,
    /// Variance of those places along the normal, square world units.
    pub roughness: f32,
    /// Share of the rays that met a surface.
    pub coverage: f32,
    /// Radiance of light that surfaces scatter.
    pub light: Vec3,
    /// Share of light that they scatter: of the same paths.
    pub shaded: Vec3,
    /// Of the luminances l of light and a of `shaded`: l², l · a, a².
    pub moments: Vec3,
    /// Instance of the surface that was seen last.
    pub instance: u32,
    /// What the frame before showed there, a colour of nine bits a channel and their exponent; 0 where nothing.
    pub shown: u32,
    /// Whether none of the rays that it remembers met an instance that had moved.
    pub is_at_rest: bool,
}

impl Memory {
    /// Takes what another ray of the camera saw.
    pub fn look(&mut self, sample: &Sample) {
        self.looks += 1.0;
        let share = 1.0 / self.looks;
        self.direct += (sample.direct - self.direct) * share;
        self.albedo += (sample.albedo - self.albedo) * share;
        let Some(shown) = &sample.shown else {
            self.coverage -= self.coverage * share;
            return;
        };
        let covered = self.coverage * (self.looks - 1.0) + 1.0;
        self.coverage = covered * share;
        let (share, before) = (1.0 / covered, self.place);
        self.normal = in_ten_bits(self.normal + (shown.normal - self.normal) * share);
        self.place += (shown.place - self.place) * share;
        self.instance = shown.instance;
        if covered > 1.0 {
            let along = self.normal.dot(shown.place - before);
            let square = along * along / self.normal.length_squared().max(1e-6) * (1.0 - share);
            self.roughness += (square - self.roughness) * share;
        }
    }

    /// Takes what another path found, its ray of the camera included; remembers `most` paths at most.
    pub fn add(&mut self, sample: &Sample, most: f32) {
        self.look(sample);
        self.paths = (self.paths + 1.0).min(most);
        let share = 1.0 / self.paths;
        let (l, a) = (luminance(sample.light), luminance(sample.albedo));
        self.light += (sample.light - self.light) * share;
        self.shaded += (sample.albedo - self.shaded) * share;
        self.moments += (Vec3::new(l * l, l * a, a * a) - self.moments) * share;
    }

    /// The light that falls on what is seen; of what media scatter, all of it. A channel that is hardly sent back says nothing about the light:
    /// there it is what all channels together say. Else the filter would darken others by it.
    pub fn irradiance(&self) -> Vec3 {
        let grey = self.light.element_sum() / self.shaded.element_sum().max(LEAST_SUM);
        (self.light + LEAST_ALBEDO * grey) / (self.shaded + LEAST_ALBEDO)
    }

    /// Variance of the luminance of [`Self::irradiance`], a ratio of means (Cochran, "Sampling Techniques", 1977, chapter 6).
    pub fn variance(&self) -> f32 {
        let (ratio, albedo) = (luminance(self.irradiance()), luminance(self.shaded) + LEAST_ALBEDO);
        let square = self.moments.x - 2.0 * ratio * self.moments.y + ratio * ratio * self.moments.z;
        square.max(0.0) / (albedo * albedo * (self.paths - 1.0).max(0.5))
    }

    /// The pixel's radiance where `irradiance` falls on what is seen.
    pub fn radiance(&self, irradiance: Vec3) -> Vec3 {
        if self.coverage > 0.0 {
            let shown = irradiance * (self.albedo + LEAST_ALBEDO);
            // The sum over the channels has the grey light of each, too.
            let grey = shown.element_sum() / (self.albedo.element_sum().max(LEAST_SUM) + 3.0 * LEAST_ALBEDO);
            (self.direct + shown - LEAST_ALBEDO * grey).max(Vec3::ZERO)
        } else {
            self.direct + self.light
        }
    }

    /// Forgets what was seen, but not the light that falls there: where the view moves, what is seen is looked at anew, so that nothing blurs it.
    pub fn look_anew(self) -> Self {
        Self { looks: 0.0, coverage: 0.0, roughness: 0.0, is_at_rest: false, ..self }
    }

    /// The light that is known, without what was seen.
    pub fn light_alone(&self) -> Self {
        let Self { paths, light, shaded, moments, .. } = *self;
        Self { paths, light, shaded, moments, ..Self::default() }
    }

    /// Bounds the moments by the means. Light of a pixel that had next to no weight is nearly nothing, and its square is not as small.
    pub fn bounded(self) -> Self {
        let (l, a) = (luminance(self.light), luminance(self.shaded));
        Self { moments: self.moments.min(Vec3::new(l * l, l * a, a * a) * MOST_BEYOND), ..self }
    }

    /// Whether frames before this one have seen what it remembers, and nothing in it has moved since.
    pub(crate) fn is_kept(&self) -> bool {
        self.is_at_rest && self.looks > LEAST_LOOKS
    }

    /// Forgets all but `paths` paths.
    pub fn doubt(&mut self, paths: f32) {
        self.paths = self.paths.min(paths);
    }

    /// Makes the light that is known darker by a factor.
    pub fn darken(&mut self, scale: f32) {
        self.light *= scale;
        self.moments *= Vec3::new(scale * scale, scale, 1.0);
    }
}

/// A normal, of length one at most, as ten bits an axis say it, which is how rows of devices keep it. Means of normals are this after each ray, so that wherever they
/// are kept in between the same pixels show the same.
pub(crate) fn in_ten_bits(normal: Vec3) -> Vec3 {
    (normal.clamp(Vec3::NEG_ONE, Vec3::ONE) * NORMAL_STEPS + NORMAL_ROUNDING).floor() * (1.0 / NORMAL_STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Shown;

    /// What a pixel shows whose path a medium scattered, and of whose rays that only look three met a surface behind it.
    fn radiance(albedo_of_medium: f32) -> f32 {
        let scattered = Sample { light: Vec3::ONE, albedo: Vec3::splat(albedo_of_medium), ..Sample::default() };
        let shown = Shown { normal: Vec3::Z, place: Vec3::ZERO, instance: 0 };
        let surface = Sample { albedo: Vec3::splat(0.5), shown: Some(shown), ..Sample::default() };
        let mut memory = Memory::default();
        memory.add(&scattered, 32.0);
        (0..3).for_each(|_| memory.look(&surface));
        memory.radiance(memory.irradiance()).x
    }

    #[test]
    fn light_that_a_medium_scatters_does_not_shine_on_the_surface_behind_it() {
        assert!((0.5..1.0).contains(&radiance(1.0)), "{}", radiance(1.0));
        // A planted fault: without an albedo of the medium, all of its light came from the surface's.
        assert!(radiance(0.0) > 100.0);
    }

    #[test]
    fn means_of_normals_depend_on_no_rounding() {
        let normals = [Vec3::Z, Vec3::NEG_Y, Vec3::Z, Vec3::X, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_X, Vec3::Z];
        // The same rounded a little otherwise, and by halves, which is the planted fault.
        let mean = |off: f32, rounded: fn(Vec3) -> Vec3| {
            let of = |sum: (f32, Vec3), normal: &Vec3| {
                let count = sum.0 + 1.0;
                (count, rounded(sum.1 + (normal - sum.1) / count + off))
            };
            normals
                .iter()
                .scan((0.0, Vec3::ZERO), |sum, normal| (*sum = of(*sum, normal), Some(sum.1)).1)
                .collect::<Vec<_>>()
        };
        let by_halves = |normal: Vec3| (normal * NORMAL_STEPS + 0.5).floor() / NORMAL_STEPS;
        assert_eq!(mean(1e-7, in_ten_bits), mean(-1e-7, in_ten_bits));
        assert_ne!(mean(1e-7, by_halves), mean(-1e-7, by_halves));
        for step in -511..=511 {
            let normal = Vec3::splat(step as f32 / NORMAL_STEPS);
            assert!(
                in_ten_bits(normal).abs_diff_eq(normal, 1e-7)
                    && in_ten_bits(in_ten_bits(normal)) == in_ten_bits(normal)
            );
        }
    }

    #[test]
    fn white_light_is_alike_on_saturated_surfaces_and_comes_back_as_it_was() {
        let irradiance = |albedo: Vec3| {
            let memory = Memory { coverage: 1.0, light: 2.0 * albedo, shaded: albedo, albedo, ..Memory::default() };
            let irradiance = memory.irradiance();
            assert!((memory.radiance(irradiance) - memory.light).abs().max_element() < 1e-5, "{albedo}");
            irradiance
        };
        let albedos = [[0.8, 0.0, 0.0], [0.0, 0.0, 0.8], [0.5, 0.004, 0.2], [0.7, 0.7, 0.7]].map(Vec3::from_array);
        for albedo in albedos {
            assert!((irradiance(albedo) - 2.0).abs().max_element() < 0.01, "{albedo}: {}", irradiance(albedo));
        }
        // A planted fault: each channel by itself has no light where the surface is black in it.
        let alone = 2.0 * albedos[0] / (albedos[0] + LEAST_ALBEDO);
        assert!((alone - 2.0).abs().max_element() > 1.0);
    }
}
