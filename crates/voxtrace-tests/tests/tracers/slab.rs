//! Slabs of scattering media against a Monte Carlo of their own: photons in double precision, without voxels, tracers and the library's mathematics.

use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Frame, Material, Scene, Sky, VoxelGrid};
use voxtrace_tests::estimate::{Estimate, radiance};

/// Photons of one slab.
const PHOTONS: u32 = 400_000;

/// Uniform numbers in (0, 1): SplitMix64 (Steele, Lea and Flood 2014).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ word >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ word >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((word ^ word >> 31) >> 11) as f64 / (1u64 << 53) as f64 + 1e-17
    }
}

/// Cosine with the way before that a scattering of mean cosine `g` gives (Henyey and Greenstein 1941).
fn scattered(g: f64, u: f64) -> f64 {
    if g == 0.0 {
        return 2.0 * u - 1.0;
    }
    let quotient = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
    (1.0 + g * g - quotient * quotient) / (2.0 * g)
}

/// Shares of light at right angles that a slab of so many mean free paths sends back and lets through, what is not scattered included.
fn photons(depth: f64, albedo: f64, g: f64) -> [f64; 2] {
    let mut numbers = Numbers(7);
    let [mut reflected, mut transmitted] = [0.0; 2];
    for _ in 0..PHOTONS {
        let (mut at, mut cos, mut weight) = (0.0, 1.0f64, 1.0);
        loop {
            at -= cos * numbers.next().ln();
            if at < 0.0 {
                reflected += weight;
                break;
            } else if at > depth {
                transmitted += weight;
                break;
            }
            weight *= albedo;
            let (turn, around) = (scattered(g, numbers.next()), std::f64::consts::TAU * numbers.next());
            // The height alone matters: the new cosine with the normal.
            cos = cos * turn + ((1.0 - cos * cos) * (1.0 - turn * turn)).max(0.0).sqrt() * around.cos();
            cos = cos.clamp(-1.0, 1.0);
            if weight < 1e-7 {
                break;
            }
        }
    }
    [reflected, transmitted].map(|sum| sum / f64::from(PHOTONS))
}

/// The same of voxels, with a white sky and black ground, and with a black sky and glowing ground.
fn voxels(thickness: i32, depth: f32, albedo: f32, g: f32) -> [Estimate; 2] {
    let cloud = Material::cloud(Vec3::splat(albedo), depth / thickness as f32, g);
    let black = Material::diffuse(Vec3::ZERO);
    let of = |ground: Material, sky: Sky| {
        let mut grid = VoxelGrid::new();
        let layer = |bottom, top| VoxelBox { min: IVec3::new(-150, -150, bottom), max: IVec3::new(150, 150, top) };
        grid.fill_box(layer(-thickness, 0), 0);
        grid.fill_box(layer(-thickness - 1, -thickness), 1);
        let scene = Scene { sky, ..Scene::from_grid("slab", grid, vec![cloud, ground]) };
        let camera = Camera::look_at(Vec3::new(0.2, 0.3, 10.0), Vec3::new(0.2, 0.3, 0.0));
        let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
        radiance(&scene, &Frame::new(camera, 8, 8).samples(128).max_bounces(300), 1)[0]
    };
    [of(black, Sky::uniform(Vec3::ONE)), of(Material { emission: Vec3::ONE, ..black }, Sky::black())]
}

#[test]
fn slabs_of_voxels_reflect_and_transmit_as_photons_in_double_precision_do() {
    for (depth, albedo, g) in [(1.0, 1.0, 0.0), (2.0, 0.9, 0.75), (3.0, 0.8, -0.5)] {
        let expected = photons(depth.into(), albedo.into(), g.into());
        // The same angle with another sign sends light elsewhere.
        let fault = photons(depth.into(), albedo.into(), 0.3 - f64::from(g));
        for ((found, expected), fault) in voxels(8, depth, albedo, g).into_iter().zip(expected).zip(fault) {
            // Standard errors of both.
            let noise = found.standard_error.hypot((expected * (1.0 - expected) / f64::from(PHOTONS)).sqrt());
            let tolerance = 4.5 * noise + 0.002 * expected;
            assert!((found.mean - expected).abs() < tolerance, "{depth} {albedo} {g}: {found:?} {expected}");
            assert!((found.mean - fault).abs() > tolerance, "{depth} {albedo} {g}: {found:?} is also {fault}");
        }
    }
}

#[test]
fn the_photons_themselves_are_those_of_published_values() {
    // Van de Hulst, "Multiple Light Scattering" (1980); table 1 of Wang, Jacques and Zheng, 1995.
    let [reflected, transmitted] = photons(2.0, 0.9, 0.75);
    assert!((reflected - 0.09739).abs() < 0.0015 && (transmitted - 0.66096).abs() < 0.003, "{reflected} {transmitted}");
    let [reflected, _] = photons(2.0, 0.9, 0.7);
    assert!((reflected - 0.09739).abs() > 0.005, "the comparison sees another phase function: {reflected}");
    assert!((photons(1.0, 0.0, 0.0)[1] - (-1.0f64).exp()).abs() < 0.003);
}
