//! The rays to measure: those that the renderer casts for one sample of each pixel of the scene's first camera. Camera rays go
//! through tiles of 32×32 pixels, block by block; two sets of cosine-weighted bounces follow, each from the hits of the set before.

use clap::ValueEnum;
use voxtrace::{Hit, PackedScene, Ray, glam::Vec2};
use voxtrace_core::math::cosine_hemisphere;
use voxtrace_core::sampler::Sampler;
use voxtrace_core::surface::Surface;
use voxtrace_core::walk;

/// Edge of a tile of the CPU tracer, pixels.
const TILE: u32 = 32;
/// Rays that the renderer casts at a time.
pub const WAVE: usize = 4096;

/// The order of the pixels of a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Order {
    /// Blocks of 8×8 pixels, in these blocks of 4×4, as the renderer goes through a tile.
    #[default]
    Blocks,
    /// Rows of 32.
    Rows,
}

impl Order {
    /// Column and row of the pixel with this number.
    fn pixel(self, number: u32) -> (u32, u32) {
        match self {
            Self::Rows => (number % TILE, number / TILE),
            Self::Blocks => {
                let (large, small, inner) = (number >> 6, number >> 4 & 3, number & 15);
                let x = large % (TILE / 8) * 8 + small % 2 * 4 + inner % 4;
                let y = large / (TILE / 8) * 8 + small / 2 * 4 + inner / 4;
                (x, y)
            }
        }
    }
}

/// Rays of one kind.
pub struct RaySet {
    /// Name in the report.
    pub name: &'static str,
    /// The rays in the order in which the renderer casts them.
    pub rays: Vec<Ray>,
    /// Whether neighbours in the order are neighbours in direction.
    #[cfg_attr(not(feature = "embree"), expect(dead_code, reason = "only Embree takes the hint"))]
    pub is_coherent: bool,
}

/// Camera rays, about `count`, and the two bounces after them.
pub fn ray_sets(scene: &PackedScene, count: usize, order: Order) -> [RaySet; 3] {
    let rows = ((count as f32 * 9.0 / 16.0).sqrt() / TILE as f32).round().max(1.0) as u32;
    let columns = (count as f32 / rows as f32 / (TILE * TILE) as f32).round().max(1.0) as u32;
    let (width, height) = (columns * TILE, rows * TILE);
    let camera = scene.cameras[0].frame(width, height);
    let mut samplers = Vec::new();
    let mut primary = Vec::new();
    for tile in 0..rows * columns {
        for place in 0..TILE * TILE {
            let (column, row) = order.pixel(place);
            let (x, y) = (tile % columns * TILE + column, tile / columns * TILE + row);
            let sampler = Sampler { seed: 0, pixel: y * width + x, sample: 0 };
            let [u, v, ..] = sampler.independent(0);
            samplers.push(sampler);
            primary.push(camera.central_ray(Vec2::new(x as f32 + u, y as f32 + v)));
        }
    }
    let first = bounce(scene, &primary, &mut samplers, 1);
    let second = bounce(scene, &first, &mut samplers, 2);
    [
        RaySet { name: "primary", rays: primary, is_coherent: true },
        RaySet { name: "first bounce", rays: first, is_coherent: false },
        RaySet { name: "second bounce", rays: second, is_coherent: false },
    ]
}

/// The rays that leave the surfaces which `rays` meet; `samplers` keeps those of the paths that go on.
fn bounce(scene: &PackedScene, rays: &[Ray], samplers: &mut Vec<Sampler>, dimension: u32) -> Vec<Ray> {
    let mut hits = vec![Hit::MISS; rays.len()];
    walk::cast_batch(scene, rays, &mut hits);
    let mut left = Vec::with_capacity(samplers.len());
    let mut bounced = Vec::with_capacity(rays.len());
    for ((ray, hit), sampler) in rays.iter().zip(&hits).zip(&*samplers) {
        if !hit.is_miss() {
            let surface = Surface::new(scene, ray, hit);
            let [u, v, ..] = sampler.independent(dimension);
            bounced.push(Ray::new(surface.origin, surface.world_direction(cosine_hemisphere(u, v))));
            left.push(*sampler);
        }
    }
    *samplers = left;
    bounced
}
