//! Paints: procedural solid textures. A paint is a function of the place on the surface that returns a ramp of the palette and a
//! level on it; each voxel then deviates from that level at random, as in a photogrammetry scan.

use super::{
    noise::{signed, unit},
    program::{Leaf, PlacedPaint},
};
use glam::{Vec2, Vec3, vec2};
use std::sync::Arc;
use voxtrace_scene::material::{Material, linear_color};

/// The materials of a scene, built from ramps.
#[derive(Clone, Debug, Default)]
pub struct Palette {
    materials: Vec<Material>,
}

/// Neighbouring shades of the palette, dark to light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ramp {
    first: u16,
    shades: u16,
}

impl Palette {
    /// A ramp of `shades` colours through the sRGB `stops`, dark to light, each a little off in hue as the colours of
    /// a scan are. Sixteen shades or fewer keep a brick of one surface within 4 bits a voxel.
    pub fn ramp(&mut self, stops: &[[u8; 3]], shades: u16) -> Ramp {
        let first = self.materials.len() as u16;
        for shade in 0..shades {
            let along = f32::from(shade) / f32::from(shades - 1).max(1.0) * (stops.len() - 1) as f32;
            let stop = (along as usize).min(stops.len().saturating_sub(2));
            let (a, b) = (stops[stop], stops[(stop + 1).min(stops.len() - 1)]);
            let share = along - stop as f32;
            let color = std::array::from_fn(|channel| {
                let hash = super::noise::hash(u32::from(first + shade) * 3 + channel as u32);
                let value = f32::from(a[channel]) + (f32::from(b[channel]) - f32::from(a[channel])) * share;
                (value * (1.0 + 0.025 * signed(hash)) + 0.5) as u8
            });
            self.materials.push(Material::diffuse(linear_color(color)));
        }
        Ramp { first, shades }
    }

    /// A ramp of `shades` emitters through the sRGB `stops`, each times `radiance`.
    pub fn glow(&mut self, stops: &[[u8; 3]], shades: u16, radiance: f32) -> Ramp {
        let ramp = self.ramp(stops, shades);
        for material in &mut self.materials[usize::from(ramp.first)..] {
            *material = Material::emissive(material.base_color * radiance);
        }
        ramp
    }

    /// The materials, in the order that ramps number them.
    pub fn into_materials(self) -> Vec<Material> {
        self.materials
    }
}

/// The value of a paint: a ramp, the level on it in [0, 1] (dark to light), and how far single voxels deviate.
#[derive(Clone, Copy, Debug)]
pub struct Tone {
    /// Where the colours come from.
    pub ramp: Ramp,
    /// Position on the ramp.
    pub level: f32,
    /// Largest deviation of a voxel from `level`.
    pub grain: f32,
}

/// Deviation of voxels on ordinary surfaces: wide enough that a brick shows most shades of a ramp of sixteen.
pub const SCAN_GRAIN: f32 = 0.5;

impl Ramp {
    /// A level on this ramp with the ordinary deviation of a scan.
    pub fn tone(self, level: f32) -> Tone {
        Tone { ramp: self, level, grain: SCAN_GRAIN }
    }

    /// A level on this ramp with a deviation of `grain`.
    pub fn even(self, level: f32, grain: f32) -> Tone {
        Tone { ramp: self, level, grain }
    }
}

impl Tone {
    /// The same tone, lighter by `by` (darker if negative).
    pub fn lighter(self, by: f32) -> Self {
        Self { level: self.level + by, ..self }
    }

    /// The material of the voxel that drew `hash`.
    #[inline]
    pub(crate) fn material(self, hash: u32) -> u16 {
        // Two draws make a triangle; mixing in a flat draw fills the ends of the ramp.
        let (a, b) = (signed(hash << 16), signed(hash & 0xffff_0000));
        let level = self.level + self.grain * (0.4 * a + 0.6 * b);
        let shade = (level * f32::from(self.ramp.shades)) as i32;
        self.ramp.first + shade.clamp(0, i32::from(self.ramp.shades) - 1) as u16
    }
}

type Pattern = dyn Fn(&SurfacePoint) -> Tone + Send + Sync;

/// A procedural texture of a surface. Cheap to clone.
#[derive(Clone)]
pub struct Paint(Arc<Pattern>);

impl Paint {
    /// A paint from a function that is called for each voxel.
    pub fn new(pattern: impl Fn(&SurfacePoint) -> Tone + Send + Sync + 'static) -> Self {
        Self(Arc::new(pattern))
    }

    /// A paint of one constant tone.
    pub fn plain(tone: Tone) -> Self {
        Self::new(move |_| tone)
    }

    /// Evaluates the paint at a place: for paints composed of other paints.
    pub fn tone(&self, point: &SurfacePoint) -> Tone {
        (self.0)(point)
    }

    pub(super) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl std::fmt::Debug for Paint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Paint")
    }
}

/// The place on a surface at which a paint is evaluated.
pub struct SurfacePoint<'a> {
    /// Position, metres, in the coordinates of the solid where it was painted.
    pub at: Vec3,
    /// Position, metres, in the coordinates of the whole scene.
    pub world: Vec3,
    /// A number of its own for each painted solid, so that copies can differ.
    pub seed: u32,
    /// A random number of the voxel.
    pub hash: u32,
    /// Edge of a voxel, metres.
    pub voxel: f32,
    /// Depth of the voxel's centre below the uneven surface, metres; beyond one voxel it is hidden.
    pub depth: f32,
    pub(super) distance: f32,
    pub(super) leaf: &'a Leaf,
    pub(super) placed: &'a PlacedPaint,
    pub(super) inside_out: bool,
}

impl SurfacePoint<'_> {
    /// The outward unit normal in the coordinates of [`Self::at`], by finite differences: several evaluations of the distance.
    pub fn normal(&self) -> Vec3 {
        let (leaf, step) = (self.leaf, self.voxel * 0.25);
        let here = if self.inside_out { -self.distance } else { self.distance };
        let slope = |axis: Vec3| leaf.distance(self.world + axis * step) - here;
        let slopes = Vec3::new(slope(Vec3::X), slope(Vec3::Y), slope(Vec3::Z));
        let normal = (self.placed.placement.linear.transpose() * slopes).normalize_or(Vec3::Z);
        if self.inside_out { -normal } else { normal }
    }

    /// Position on the surface unfolded along the axis that the normal is nearest to: (x, y) on floors, (along the
    /// wall, z) on walls.
    pub fn unfold(&self) -> Vec2 {
        let n = self.normal().abs();
        if n.z > n.x.max(n.y) {
            vec2(self.at.x, self.at.y)
        } else if n.x > n.y {
            vec2(self.at.y, self.at.z)
        } else {
            vec2(self.at.x, self.at.z)
        }
    }

    /// A number in [0, 1) for the painted solid, the same at each of its voxels.
    pub fn chance(&self) -> f32 {
        unit(super::noise::hash(self.seed ^ 0x5bd1_e995))
    }
}
