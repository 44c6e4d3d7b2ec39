//! What lies over a volume: label maps and further scans, each with a transfer function of its own, at their own places. Voxels are those of the
//! volume's grid; where several show something the colours are composed by Porter and Duff's operator "over" ("Compositing Digital Images", 1984).

use super::own_colors::OwnColors;
use super::resample::Axis;
use super::slab::LayerBricks;
use super::transfer::{EMPTY, LabelColor, Lookup};
use super::{Placement, Transfer, Volume, VolumeError};
use glam::{DAffine3, DVec3, IVec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use voxtrace_scene::brick::Brick;
use voxtrace_scene::material::{MAX_MATERIALS, Material};
use voxtrace_scene::scene::Unit;

/// How near to a sample, in samples, a place counts as its own.
const SAME_PLACE: f64 = 1e-6;

/// A volume that lies over another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlay {
    /// The volume, whose [`Volume::world_from_index`] says where it lies. Where one of the two has no unit and both have equally many samples, these lie in
    /// the same places.
    pub volume: Arc<Volume>,
    /// What of it is shown, resolved ([`Transfer::resolve`]). Labels are taken from the nearest sample; other values are interpolated linearly.
    pub transfer: Transfer,
}

/// A volume with what lies over it, on the volume's grid.
pub(super) struct Layers<'a> {
    pub volume: &'a Volume,
    pub axes: &'a [Axis; 3],
    pub lookup: &'a Lookup,
    /// The volume's own colours.
    pub colors: Option<OwnColors<'a>>,
    pub overlays: Vec<Placed<'a>>,
}

/// An overlay on the grid of the volume below it.
pub(super) struct Placed<'a> {
    overlay: &'a Overlay,
    lookup: Lookup,
    /// From the middles of voxels, by their coordinates, to indices of samples.
    index_from_voxel: DAffine3,
    /// Whether values are those of the nearest sample.
    nearest: bool,
    /// Voxels in a row of the grid.
    wide: usize,
    /// Whether a voxel was found that shows it.
    is_seen: AtomicBool,
}

/// Which look each layer has at a voxel, as one number; the topmost layer counts least.
type Stack = u64;

/// Bricks with their places.
type Bricks = Vec<(IVec3, Brick)>;

/// The stacks that occur, each with its place in the order in which they were found.
#[derive(Default)]
pub(super) struct Looks(HashMap<Stack, u16>, Vec<Stack>);

impl Looks {
    /// The place of a stack. A layer of bricks cannot have more of them than the materials of [`Layers::settled`]; that many share the last one until it
    /// says so.
    pub fn place_of(&mut self, stack: Stack) -> u16 {
        let Self(places, order) = self;
        *places.entry(stack).or_insert_with(|| {
            order.push(stack);
            (order.len() - 1).min(usize::from(u16::MAX)) as u16
        })
    }
}

impl<'a> Layers<'a> {
    pub fn new(
        volume: &'a Volume,
        placement: &'a Placement,
        lookup: &'a Lookup,
        overlays: &'a [Overlay],
    ) -> Result<Self, VolumeError> {
        let overlays = overlays.iter().map(|overlay| Placed::new(overlay, volume, placement));
        let colors = OwnColors::of(volume, &placement.axes);
        Ok(Self { volume, axes: &placement.axes, lookup, colors, overlays: overlays.collect::<Result<_, _>>()? })
    }

    /// Whether materials are those of the transfer function.
    pub fn are_plain(&self) -> bool {
        self.overlays.is_empty() && self.colors.is_none()
    }

    /// Whether nothing behind a voxel shines through it.
    pub fn is_opaque(&self) -> bool {
        self.lookup.is_opaque() && self.overlays.iter().all(|overlay| overlay.lookup.is_opaque())
    }

    /// The looks of all layers at a voxel, `below` that of the volume itself. What an opaque look hides does not count.
    pub fn stack(&self, below: u16, voxel: [usize; 3]) -> Stack {
        let place = |material: u16| if material == EMPTY { 0 } else { u64::from(material) + 1 };
        let own = match &self.colors {
            Some(colors) if below != EMPTY => {
                let taps = std::array::from_fn(|axis| &self.axes[axis].taps[voxel[axis]]);
                u64::from(colors.key(self.axes, taps)) + 1
            }
            _ => place(below),
        };
        self.overlays.iter().fold(own, |below, overlay| {
            let material = overlay.lookup.material(overlay.value(voxel));
            let is_opaque = overlay.lookup.colors().get(usize::from(material)).is_some_and(|look| look.opacity >= 1.0);
            let below = if is_opaque { 0 } else { below };
            below * overlay.radix() + place(material)
        })
    }

    /// What is seen of a stack.
    fn look(&self, mut stack: Stack) -> LabelColor {
        let mut seen: Option<LabelColor> = None;
        let mut lay_under = |look: Option<LabelColor>| {
            let Some(look) = look else { return };
            seen = Some(seen.map_or(look, |above| above.over(look)));
        };
        for overlay in self.overlays.iter().rev() {
            let place = (stack % overlay.radix()).checked_sub(1);
            lay_under(place.map(|place| overlay.lookup.colors()[place as usize]));
            stack /= overlay.radix();
        }
        let looks = self.lookup.colors();
        let opacity = looks.first().map_or(1.0, |look| look.opacity);
        lay_under(stack.checked_sub(1).map(|place| match &self.colors {
            Some(colors) => colors.look(place as u32, opacity),
            None => looks[place as usize],
        }));
        seen.unwrap_or(LabelColor { color: glam::Vec3::ZERO, opacity: 1.0 })
    }

    /// The bricks of all layers with the materials of the scene.
    pub fn settled(&self, found: Vec<LayerBricks>) -> Result<(Bricks, Vec<Material>), VolumeError> {
        if self.are_plain() {
            let materials = self.lookup.colors().iter().map(|look| look.material()).collect();
            return Ok((found.into_iter().flat_map(|layer| layer.bricks).collect(), materials));
        }
        if let Some(unseen) = self.overlays.iter().find(|overlay| !overlay.is_seen.load(Ordering::Relaxed)) {
            let transfer = &unseen.overlay.transfer;
            return Err(VolumeError::EmptyOverlay {
                overlay: unseen.overlay.volume.name.clone(),
                volume: self.volume.name.clone(),
                transfer: transfer.name.clone(),
                shown: transfer.shown(),
            });
        }
        let stacks: BTreeMap<Stack, ()> =
            found.iter().flat_map(|layer| layer.looks.1.iter().map(|&stack| (stack, ()))).collect();
        if stacks.len() > MAX_MATERIALS {
            let (needed, limit) = (stacks.len() as u64, MAX_MATERIALS as u64);
            return Err(VolumeError::TooLarge { what: "colours of volumes over each other", needed, limit });
        }
        let place: HashMap<Stack, u16> = stacks.keys().copied().zip(0..).collect();
        let renamed = |layer: LayerBricks| -> Bricks {
            let names: Vec<u16> = layer.looks.1.iter().map(|stack| place[stack]).collect();
            let rename = |brick: &Brick| {
                let materials = brick.materials().iter().map(|&name| names[usize::from(name)]).collect();
                Brick::new(*brick.occupancy(), materials)
            };
            layer.bricks.iter().map(|(at, brick)| (*at, rename(brick))).collect()
        };
        let bricks: Vec<_> = found.into_par_iter().map(renamed).collect();
        let materials = stacks.keys().map(|&stack| self.look(stack).material()).collect();
        Ok((bricks.into_iter().flatten().collect(), materials))
    }
}

impl<'a> Placed<'a> {
    fn new(overlay: &'a Overlay, below: &Volume, placement: &Placement) -> Result<Self, VolumeError> {
        let volume = &*overlay.volume;
        volume.validate().map_err(VolumeError::BadVolume)?;
        let shape = |[x, y, z]: [usize; 3]| format!("{x} x {y} x {z}");
        let has_no_place = volume.unit == Unit::Voxel || below.unit == Unit::Voxel;
        let world_from_index = if !has_no_place {
            let factor = metres(volume.unit) / metres(below.unit);
            DAffine3::from_scale(DVec3::splat(factor)) * volume.world_from_index
        } else if volume.size == below.size {
            below.world_from_index
        } else if volume.unit == below.unit && volume.world_from_index != DAffine3::IDENTITY {
            volume.world_from_index
        } else {
            let (overlay, volume_name) = (volume.name.clone(), below.name.clone());
            let (there, here) = (shape(volume.size), shape(below.size));
            return Err(VolumeError::NoPlace { overlay, volume: volume_name, there, here });
        };
        let index_from_grid = world_from_index.inverse() * placement.coordinates_from_grid;
        let counts = DVec3::from_array(std::array::from_fn(|axis| placement.axes[axis].count() as f64));
        let (low, high) = bounds(&index_from_grid, DVec3::ZERO, counts);
        let size = DVec3::from_array(volume.size.map(|size| size as f64));
        if high.cmple(DVec3::splat(-0.5)).any() || low.cmpge(size - 0.5).any() {
            let place = |world_from: &DAffine3, low, high| {
                let (low, high) = bounds(world_from, low, high);
                let text = |at: DVec3| format!("{},{},{}", at.x as f32, at.y as f32, at.z as f32);
                format!("from {} to {}", text(low), text(high))
            };
            return Err(VolumeError::Apart {
                overlay: volume.name.clone(),
                volume: below.name.clone(),
                there: place(&world_from_index, DVec3::splat(-0.5), size - 0.5),
                here: place(&placement.coordinates_from_grid, DVec3::ZERO, counts),
            });
        }
        Ok(Self {
            overlay,
            lookup: overlay.transfer.lookup(),
            index_from_voxel: index_from_grid * DAffine3::from_translation(DVec3::splat(0.5)),
            nearest: overlay.transfer.is_labels(),
            wide: placement.axes[0].count(),
            is_seen: AtomicBool::new(false),
        })
    }

    /// How many looks there are, none among them.
    fn radix(&self) -> u64 {
        self.lookup.colors().len() as u64 + 1
    }

    /// Sets the bits of a row's voxels that it shows.
    pub fn mark(&self, y: usize, z: usize, row: &mut [u64]) {
        let step = self.index_from_voxel.matrix3.x_axis;
        let start = self.index_from_voxel.transform_point3(DVec3::new(0.0, y as f64, z as f64));
        // Voxels whose middle may lie within the outermost samples' cells.
        let (mut first, mut last) = (0.0f64, self.wide as f64 - 1.0);
        for axis in 0..3 {
            let (low, high) = (-0.5 - SAME_PLACE, self.overlay.volume.size[axis] as f64 - 0.5 + SAME_PLACE);
            if step[axis].abs() < 1e-12 {
                if start[axis] < low || start[axis] > high {
                    return;
                }
                continue;
            }
            let (a, b) = ((low - start[axis]) / step[axis], (high - start[axis]) / step[axis]);
            (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
        }
        let mut is_seen = false;
        if first > last {
            return;
        }
        for x in first as usize..=(last.ceil() as usize).min(self.wide - 1) {
            if self.lookup.material(self.value([x, y, z])) != EMPTY {
                row[x / 64] |= 1 << (x % 64);
                is_seen = true;
            }
        }
        if is_seen {
            self.is_seen.store(true, Ordering::Relaxed);
        }
    }

    /// Its value in the middle of a voxel, not a number where it has none.
    fn value(&self, voxel: [usize; 3]) -> f32 {
        let at = self.index_from_voxel.transform_point3(DVec3::from_array(voxel.map(|at| at as f64)));
        let volume = &*self.overlay.volume;
        let size = DVec3::from_array(volume.size.map(|size| size as f64));
        if at.cmplt(DVec3::splat(-0.5 - SAME_PLACE)).any() || at.cmpgt(size - 0.5 + SAME_PLACE).any() {
            return f32::NAN;
        }
        let at = at.clamp(DVec3::ZERO, size - 1.0);
        let index = |[x, y, z]: [usize; 3]| x + volume.size[0] * (y + volume.size[1] * z);
        if self.nearest {
            // Halfway counts for the second sample, whatever is rounded.
            let nearest = (at + 0.5 + SAME_PLACE).min(size - 0.5).to_array().map(|at| at as usize);
            return volume.values[index(nearest)];
        }
        let near = at.round();
        let at = DVec3::select((at - near).abs().cmplt(DVec3::splat(SAME_PLACE)), near, at);
        let (first, share) = (at.floor(), at - at.floor());
        let first = first.to_array().map(|at| at as usize);
        let mut sum = 0.0;
        for corner in 0..8usize {
            let weight = (0..3).map(|axis| if corner >> axis & 1 != 0 { share[axis] } else { 1.0 - share[axis] });
            let weight: f64 = weight.product();
            // Samples without a weight may lie outside, or be no numbers.
            if weight > 0.0 {
                let place = std::array::from_fn(|axis| first[axis] + (corner >> axis & 1));
                sum += weight * f64::from(volume.values[index(place)]);
            }
        }
        sum as f32
    }
}

fn metres(unit: Unit) -> f64 {
    if unit == Unit::Millimetre { 1e-3 } else { 1.0 }
}

/// The box around the box from `low` to `high` in another space.
fn bounds(place: &DAffine3, low: DVec3, high: DVec3) -> (DVec3, DVec3) {
    let corners = (0..8).map(|corner| {
        let pick = |axis: usize| if corner >> axis & 1 != 0 { high[axis] } else { low[axis] };
        place.transform_point3(DVec3::new(pick(0), pick(1), pick(2)))
    });
    corners.fold((DVec3::MAX, DVec3::MIN), |(low, high), at| (low.min(at), high.max(at)))
}

#[cfg(test)]
mod tests;
