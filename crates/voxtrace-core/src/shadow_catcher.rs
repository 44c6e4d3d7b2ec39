//! A ground that shows nothing but the shadows on it, so that a picture can be laid over another (the shadow catcher of compositors).
//!
//! Where a camera ray meets the upper side of the ground, the sample is black, and covered or not: one direction is chosen in proportion to the
//! light that sun and sky send to bare ground from there (luminance times cosine), and what lies on that ray covers the sample. The mean is the
//! share of that light that the scene keeps from the ground, 1 − L₁ / L₀, as a number of samples: no quotient of noisy sums, nothing at all where
//! nothing is in the way, and films add up as they do.
//!
//! Light of lamps, and what objects reflect to the ground, do not count. Seen in mirrors, through glass, from below or within a medium, the
//! ground is one as any other. `docs/decisions/0060-shadow-catcher.md`. Twin of `shaders/shadow_catcher.slang`.

use crate::frame::Frame;
use crate::integrator::{Path, ShadowRay};
use crate::light::SunDisc;
use crate::math::{luminance, sincos_turns};
use crate::packed::PackedScene;
use crate::surface::Surface;
use glam::Vec3;
use std::f32::consts::PI;
use voxtrace_scene::ray::{Face, Hit, Ray};
use voxtrace_scene::sky::{Background, Gradient, Sky};

/// The ground's upper side.
const FACE_UP: u32 = 5;
const _: () = assert!(FACE_UP == Face::PosZ as u32);

/// Steps by which the height of a direction is found: as many as a fraction has bits.
const HEIGHT_STEPS: u32 = 24;

/// The ground of a scene, where a frame asks for its shadows alone.
#[derive(Clone, Copy, Debug)]
pub struct ShadowCatcher<'a> {
    /// Its material, which nothing else has.
    pub material: u32,
    /// Probability with which a direction is one of the sun: its share in the luminance of the light on the ground. Below 0 where there is none.
    pub sun_share: f32,
    /// Of a gradient: share of z³ in the distribution of a direction's height z, where z² has the rest. It is below 0 where the horizon is the
    /// brighter end.
    pub cube_share: f32,
    sun: Option<SunDisc>,
    sky: &'a Sky,
}

impl<'a> ShadowCatcher<'a> {
    /// `None` where the frame shows the ground as it is, and where the scene has none.
    pub fn new(scene: &'a PackedScene, frame: &Frame) -> Option<Self> {
        let material = scene.ground.filter(|_| frame.shadow_catcher)?;
        let (sky, sun) = (&scene.sky, SunDisc::new(&scene.sky));
        // A disc above the horizon sends what its centre would.
        let of_sun = sun.map_or(0.0, |sun| sun.irradiance * sun.direction.z.max(0.0));
        let (of_sky, cube_share) = match sky.background() {
            Background::Gradient(gradient) => light_of_gradient(gradient),
            Background::Environment(environment) => (environment.map().from_above().irradiance as f32, 0.0),
        };
        let of_sky = of_sky * sky.brightness();
        let sun_share = if of_sun + of_sky > 0.0 { of_sun / (of_sun + of_sky) } else { -1.0 };
        Some(Self { material: material.into(), sun_share, cube_share, sun, sky })
    }

    /// Whether a camera ray, whose hit this is, met the ground's upper side.
    #[inline]
    pub fn is_met(&self, scene: &PackedScene, hit: &Hit) -> bool {
        hit.face == FACE_UP && scene.material_beyond(hit) == Some(self.material)
    }

    /// The ray that says whether a sample is covered, where a camera ray met the ground; `None` where no light falls on it, which nothing can keep
    /// from it then.
    pub(crate) fn shadow_ray(&self, scene: &PackedScene, path: &Path, ray: &Ray, hit: &Hit) -> Option<ShadowRay> {
        let [choice, ..] = path.sampler.stratified(path.dimension_scatter());
        let direction = self.direction(choice, path.sampler.stratified(path.dimension_light()))?;
        let origin = Surface::new(scene, ray, hit).origin;
        let is_clipped = scene.cuts.clips_after(hit);
        Some(ShadowRay { ray: Ray::new(origin, direction), inside: None, is_clipped, radiance: Vec3::ONE })
    }

    /// What decides whether a sample is covered, of whose ray a part comes through.
    pub(crate) fn threshold(path: &Path) -> f32 {
        path.sampler.stratified(path.dimension_scatter())[1]
    }

    /// Whether a sample is covered, of whose ray so much came through.
    pub(crate) fn is_covered(light: Vec3, threshold: f32) -> bool {
        threshold >= luminance(light)
    }

    /// A direction of the upper half in proportion to the light on the ground from there: `choice` is between sun and sky, `u` within them, each
    /// uniform in [0, 1). `None` where no light falls.
    #[inline]
    pub fn direction(&self, choice: f32, u: [f32; 4]) -> Option<Vec3> {
        if self.sun_share < 0.0 {
            return None;
        }
        match (&self.sun, self.sky.background()) {
            (Some(sun), _) if choice < self.sun_share => Some(of_sun(sun, u)),
            (_, Background::Environment(environment)) => Some(environment.choose_from_above(u)),
            (_, Background::Gradient(_)) => Some(self.of_gradient(u)),
        }
    }

    /// A direction of a gradient.
    fn of_gradient(&self, u: [f32; 4]) -> Vec3 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HEIGHT_STEPS {
            let middle = (low + high) * 0.5;
            if middle * middle * ((1.0 - self.cube_share) + self.cube_share * middle) <= u[2] {
                low = middle;
            } else {
                high = middle;
            }
        }
        let radius = ((1.0 - high) * (1.0 + high)).sqrt();
        let (sin, cos) = sincos_turns(u[3]);
        Vec3::new(radius * cos, radius * sin, high)
    }
}

/// A direction of the sun's disc: even in the disc as the ground sees it, flat.
fn of_sun(sun: &SunDisc, u: [f32; 4]) -> Vec3 {
    let radius = sun.sin_radius * u[2].sqrt();
    let (sin, cos) = sincos_turns(u[3]);
    let aside = sun.tangent * (radius * cos) + sun.bitangent * (radius * sin);
    let flat = sun.direction * (1.0 - sun.one_minus_cos_theta_max) + aside;
    let height = (1.0 - (flat.x * flat.x + flat.y * flat.y)).max(0.0).sqrt();
    Vec3::new(flat.x, flat.y, height)
}

/// Luminance of the irradiance of a gradient of brightness 1 on the ground, and the share of it that grows with the cube of the height up to which
/// one looks: what the zenith has more than the horizon.
fn light_of_gradient(gradient: &Gradient) -> (f32, f32) {
    let zenith = luminance(gradient.zenith).max(0.0);
    let horizon = luminance(gradient.mean_radiance()).max(0.0);
    // Radiance a + b z: twice pi times the integral of z (a + b z).
    let (square, cube) = (horizon / 2.0, (zenith - horizon) / 3.0);
    let sum = square + cube;
    if sum > 0.0 { (2.0 * PI * sum, cube / sum) } else { (0.0, 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surroundings::Ground;
    use std::sync::Arc;
    use voxtrace_scene::camera::Camera;
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::scene::Scene;
    use voxtrace_scene::sky::{Environment, EnvironmentMap, Sun};

    fn on_ground(sky: Sky) -> PackedScene {
        let mut grid = VoxelGrid::new();
        grid.set(glam::IVec3::ZERO, 0);
        let scene = Scene { sky, ..Scene::from_grid("voxel", grid, vec![Material::default()]) };
        let ground = Ground { height: None, color: Vec3::ONE };
        PackedScene::pack(&scene).unwrap().with_surroundings(Some(&ground), None).unwrap()
    }

    fn frame() -> Frame {
        Frame::new(Camera::look_at(Vec3::ONE, Vec3::ZERO), 1, 1).transparent(true).shadow_catcher(true)
    }

    /// Means of x, y and z, and of z², of directions chosen evenly.
    fn moments(sky: Sky) -> [f64; 4] {
        let scene = on_ground(sky);
        let catcher = ShadowCatcher::new(&scene, &frame()).unwrap();
        let steps = 40u32;
        let at = |step: u32| (step as f32 + 0.5) / steps as f32;
        let mut sum = [0.0; 4];
        for index in 0..steps.pow(3) {
            let (choice, u, v) = (at(index % steps), at(index / steps % steps), at(index / steps / steps));
            let direction = catcher.direction(choice, [choice, u, u, v]).unwrap();
            assert!((direction.length() - 1.0).abs() < 1e-5 && direction.z >= 0.0, "{direction}");
            let z = f64::from(direction.z);
            let values = [direction.x.into(), direction.y.into(), z, z * z];
            sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value / f64::from(steps.pow(3)));
        }
        sum
    }

    fn is_near(found: [f64; 4], expected: [f64; 4]) -> bool {
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 3e-3)
    }

    #[test]
    fn directions_of_gradients_are_as_likely_as_their_light() {
        // Of radiance a + b z the mean of zⁿ is the integral of zⁿ z (a + b z) over that of z (a + b z).
        let mean = |a: f64, b: f64, n: f64| (a / (n + 2.0) + b / (n + 3.0)) / (a / 2.0 + b / 3.0);
        for (nadir, zenith) in [(1.0, 1.0), (0.0, 2.0), (2.0, 0.0), (0.5, 3.0)] {
            let (a, b) = ((nadir + zenith) / 2.0, (zenith - nadir) / 2.0);
            let found = moments(Sky::gradient(Vec3::splat(nadir as f32), Vec3::splat(zenith as f32)));
            let expected = |b: f64| [0.0, 0.0, mean(a, b, 1.0), mean(a, b, 2.0)];
            assert!(is_near(found, expected(b)), "{nadir} {zenith}: {found:?}");
            assert!(
                !is_near(found, expected(b + 0.2 * a)),
                "the comparison sees a sky that is a little brighter above"
            );
        }
    }

    #[test]
    fn sun_and_sky_are_chosen_by_their_light_on_the_ground() {
        let direction = Vec3::new(0.48, -0.6, 0.64);
        let sun = |radius: f32| Sun { direction, angular_radius: radius, irradiance: Vec3::splat(2.0) };
        // The mean of a narrow sun is its middle, and its share that of its irradiance times its cosine.
        let both = |share: f64| {
            let of_sun = direction.as_dvec3() * share;
            let of_sky = (1.0 - share) * 2.0 / 3.0;
            let squares = share * f64::from(direction.z).powi(2) + (1.0 - share) / 2.0;
            [of_sun.x, of_sun.y, of_sun.z + of_sky, squares]
        };
        let share = 2.0 * 0.64 / (2.0 * 0.64 + std::f64::consts::PI * 0.4);
        let found = moments(Sky::uniform(Vec3::splat(0.4)).with_sun(Some(sun(1e-3))));
        // The choice has forty steps.
        assert!(found.iter().zip(both(share)).all(|(found, expected)| (found - expected).abs() < 0.02), "{found:?}");
        assert!(found.iter().zip(both(share + 0.1)).any(|(found, expected)| (found - expected).abs() > 0.02));
        // A wide sun: even in what the ground sees of it. Where that is projected flat, its middle is the disc's.
        let wide = moments(Sky::uniform(Vec3::ZERO).with_sun(Some(sun(0.5))));
        let flat = direction.as_dvec3() * 0.5f64.cos();
        assert!((wide[0] - flat.x).abs() < 3e-3 && (wide[1] - flat.y).abs() < 3e-3, "{wide:?} {flat}");
        assert!((wide[0] - f64::from(direction.x)).abs() > 3e-3, "the middle of the disc on the sphere is another");
        let map = EnvironmentMap::new(32, &[Vec3::splat(0.4); 1024]).unwrap();
        let even = Sky::new(Background::Environment(Environment::new(Arc::new(map), 0.0)));
        let scenes = [even.clone(), Sky::uniform(Vec3::splat(0.4))].map(|sky| on_ground(sky.with_sun(Some(sun(0.01)))));
        let shares = scenes.each_ref().map(|scene| ShadowCatcher::new(scene, &frame()).unwrap().sun_share);
        assert!((shares[0] - shares[1]).abs() < 1e-3 && (f64::from(shares[1]) - share).abs() < 1e-4, "{shares:?}");
    }

    #[test]
    fn what_comes_through_says_how_many_samples_are_covered() {
        assert_eq!(luminance(Vec3::ONE), 1.0, "no number below 1 covers what comes through whole");
        let largest = 1.0 - 1.0 / 16_777_216.0;
        assert!(!ShadowCatcher::is_covered(Vec3::ONE, largest) && ShadowCatcher::is_covered(Vec3::ZERO, 0.0));
        assert!(ShadowCatcher::is_covered(Vec3::splat(0.5), 0.6) && !ShadowCatcher::is_covered(Vec3::splat(0.5), 0.4));
        let dark = on_ground(Sky::uniform(Vec3::ZERO));
        let catcher = ShadowCatcher::new(&dark, &frame()).unwrap();
        assert_eq!(catcher.direction(0.5, [0.5; 4]), None);
        assert!(ShadowCatcher::new(&dark, &frame().shadow_catcher(false)).is_none());
        assert!(frame().check().is_ok() && frame().transparent(false).check().is_err());
    }
}
