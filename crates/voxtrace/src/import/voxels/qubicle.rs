//! Qubicle Binary, `.qb` (specification by Minddesk): several matrices of colours, plain or as runs. y is up. The header says
//! where z points: to the viewer where it says 0, away from him where it says 1. The specification calls these left- and
//! right-handed, but figures whose left and right limbs have names, and letters, come out mirrored if it is taken at its word.

use super::paints::Paints;
use super::slab::Slabs;
use super::{Voxels, checked_size};
use crate::grid::MAX_COORDINATE;
use crate::import::input::Input;
use crate::import::{ImportError, Limits};
use crate::scene::Scene;
use crate::transform::Transform;
use glam::{IVec3, Vec3};

/// Marks a run in compressed data.
const RUN: u32 = 2;
/// Ends a layer in compressed data.
const NEXT_LAYER: u32 = 6;
/// Bytes that a matrix takes at least.
const SMALLEST: u64 = 25;

struct Header {
    is_bgra: bool,
    /// Whether z points away from the viewer.
    is_away: bool,
    is_compressed: bool,
}

/// Reads a Qubicle Binary file.
pub(super) fn read(mut input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    number(&mut input)?;
    let mut flags = [false; 4];
    for (flag, what) in flags.iter_mut().zip(["colour format", "orientation", "compression", "mask"]) {
        let offset = input.offset();
        *flag = match number(&mut input)? {
            0 => false,
            1 => true,
            other => {
                return Err(ImportError::malformed(
                    path,
                    offset,
                    format!("the {what} {other}, which is neither 0 nor 1"),
                ));
            }
        };
    }
    let header = Header { is_bgra: flags[0], is_away: flags[1], is_compressed: flags[2] };
    let count = u64::from(number(&mut input)?);
    let least = count * SMALLEST;
    if input.remaining().is_some_and(|remaining| remaining < least) {
        return Err(ImportError::truncated(path, input.offset(), format!("{count} matrices")));
    }
    if count > limits.items {
        return Err(ImportError::limit(path, Some(20), "matrices", count, limits.items));
    }
    let (mut scene, mut paints, mut places) = (Scene::new(""), Paints::default(), 0);
    for _ in 0..count {
        matrix(&mut input, &header, limits, &mut places, &mut paints, &mut scene)?;
    }
    scene.materials = paints.finish();
    Ok(Voxels { scene, notes: Vec::new() })
}

fn number(input: &mut Input) -> Result<u32, ImportError> {
    let bytes = input.take(4, "a number")?;
    Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
}

fn matrix(
    input: &mut Input,
    header: &Header,
    limits: &Limits,
    places: &mut u64,
    paints: &mut Paints,
    scene: &mut Scene,
) -> Result<(), ImportError> {
    let path = input.path();
    let length = usize::from(input.take(1, "a name")?[0]);
    let name = String::from_utf8_lossy(input.take(length, "a name")?).into_owned();
    let offset = input.offset();
    let mut numbers = [0; 6];
    for value in &mut numbers {
        *value = number(input)?;
    }
    let [width, height, depth, x, y, z] = numbers;
    let position = [x, y, z].map(|value| value as i32);
    if let Some(far) = position.iter().find(|at| at.unsigned_abs() > MAX_COORDINATE as u32) {
        return Err(ImportError::malformed(path, offset, format!("a matrix at {far}, too far away")));
    }
    let size = checked_size(path, offset, [width, depth, height].map(u64::from), limits)?;
    *places += size.to_array().iter().map(|&edge| edge as u64).product::<u64>();
    if *places > limits.voxels {
        return Err(ImportError::limit(path, Some(offset), "places of voxels", *places, limits.voxels));
    }
    let mut slabs = Slabs::new(path, offset, size, 1)?;
    let mut set = |place: u64, z: u32, color: u32| {
        let [first, green, third, mask] = color.to_le_bytes();
        if mask == 0 {
            return;
        }
        let rgb = if header.is_bgra { [third, green, first] } else { [first, green, third] };
        // The viewer looks along our +y.
        let y = if header.is_away { z } else { depth - 1 - z };
        let (x, up) = (place % u64::from(width), place / u64::from(width));
        slabs.set(IVec3::new(x as i32, y as i32, up as i32), paints.material(rgb));
    };
    let layer = u64::from(width) * u64::from(height);
    for z in 0..depth {
        if !header.is_compressed {
            for place in 0..layer {
                set(place, z, number(input)?);
            }
            continue;
        }
        let mut place = 0;
        loop {
            let offset = input.offset();
            let (count, color) = match number(input)? {
                NEXT_LAYER => break,
                RUN => (u64::from(number(input)?), number(input)?),
                color => (1, color),
            };
            if place + count > layer {
                let what = format!("a layer with more than its {layer} voxels");
                return Err(ImportError::malformed(path, offset, what));
            }
            (place..place + count).for_each(|place| set(place, z, color));
            place += count;
        }
    }
    let [x, up, z] = position.map(|at| at as f32);
    let y = if header.is_away { z } else { -z - depth as f32 };
    let instance = scene.add_instance(slabs.finish(), Transform::from_translation(Vec3::new(x, y, up)));
    scene.instances[instance].name = name;
    Ok(())
}
