//! Random edits, and the same edits voxel by voxel.

use crate::dynamic::{Clip, Edit};
use glam::{DVec3, IVec3};
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::ray::FACES;
use voxtrace_scene::{Axis, Face, Shape, VoxelGrid};

/// Uniform numbers.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, most: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as u32) % most
    }

    pub fn between(&mut self, low: i32, high: i32) -> i32 {
        low + self.below((high - low) as u32) as i32
    }

    pub fn voxel(&mut self, reach: i32) -> IVec3 {
        IVec3::from_array([(); 3].map(|()| self.between(-reach, reach)))
    }

    pub fn point(&mut self, reach: i32) -> DVec3 {
        self.voxel(reach * 8).as_dvec3() / 8.0
    }
}

/// A random edit of voxels not farther out than `reach`, with so many materials.
pub fn random_edit(random: &mut Random, reach: i32, materials: u32) -> Edit {
    let material = |random: &mut Random| random.below(materials) as u16;
    let some = (random.below(3) > 0).then(|| material(random));
    let shape = match random.below(8) {
        0..4 => {
            // Often at the border of a brick.
            let at = random.voxel(reach);
            let at = if random.below(2) == 0 { (at & !7) - (random.below(2) as i32) } else { at };
            Shape::Box(VoxelBox { min: at, max: at + 1 })
        }
        4 => {
            let min = random.voxel(reach - 14);
            Shape::Box(VoxelBox { min, max: min + (random.voxel(7) + 7) })
        }
        5..7 => Shape::Sphere { center: random.point(reach - 14), radius: f64::from(random.below(100)) / 8.0 },
        _ => {
            let from = random.point(reach - 24);
            Shape::Capsule { from, to: from + random.point(10), radius: f64::from(random.below(60)) / 8.0 }
        }
    };
    let region = |random: &mut Random, size: i32| {
        let min = random.voxel(reach - size);
        VoxelBox { min, max: min + (random.voxel(size / 2) + size / 2) }
    };
    match random.below(14) {
        10 => {
            let mut clip = VoxelGrid::new();
            (0..30).for_each(|_| _ = clip.set(random.voxel(5) + 5, random.below(materials) as u16));
            let clip = Clip::new(clip, IVec3::new(10, 11, 12)).turned(Axis::Y, random.below(4) as i32);
            let clip = if random.below(2) == 0 { clip.mirrored(Axis::X) } else { clip };
            Edit::Paste { clip: clip.into(), at: random.voxel(reach - 14), with_empty: random.below(2) == 0 }
        }
        11 => {
            let layer = region(random, 12);
            Edit::Extrude { layer, face: FACES[random.below(6) as usize], distance: random.between(-4, 6) }
        }
        13 => Edit::Add { shape, material: material(random) },
        12 => Edit::Flood { start: random.voxel(reach), material: some, within: region(random, 30), most: 1 << 20 },
        0 => Edit::Paint { shape, material: material(random) },
        1 => {
            let min = random.voxel(reach);
            let within = (random.below(8) > 0).then_some(VoxelBox { min, max: min + 20 });
            Edit::Replace { within, from: material(random), to: some }
        }
        _ => Edit::Fill { shape, material: some },
    }
}

/// The same edit, voxel by voxel.
pub fn edit_plainly(grid: &mut VoxelGrid, edit: &Edit) {
    let mut set = |voxel: IVec3, material: Option<u16>| match material {
        Some(material) => _ = grid.set(voxel, material),
        None => _ = grid.clear(voxel),
    };
    let inside = |shape: &Shape| {
        let bounds = shape.bounds().unwrap_or(VoxelBox { min: IVec3::ZERO, max: IVec3::ZERO });
        let (shape, size) = (*shape, bounds.size());
        (0..size.element_product())
            .map(move |i| bounds.min + IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y)))
            .filter(move |&voxel| shape.contains(voxel))
    };
    match edit {
        Edit::Paste { clip, at, with_empty } => {
            for voxel in inside(&Shape::Box(VoxelBox { min: IVec3::ZERO, max: clip.size() })) {
                let material = clip.voxels().get(voxel);
                if material.is_some() || *with_empty {
                    set(*at + voxel, material);
                }
            }
        }
        Edit::Extrude { layer, face, distance } => {
            let was = grid.clone();
            for voxel in inside(&Shape::Box(*layer)).filter(|&voxel| was.get(voxel).is_some()) {
                for step in 1..=*distance {
                    // The nearest voxel of the layer below counts, for what is there itself too.
                    let to = voxel + face.normal() * step;
                    let below = (0..=step).map(|step| to - face.normal() * step);
                    let nearest = below.filter(|&at| layer.contains(at)).find_map(|at| was.get(at));
                    grid.set(to, nearest.expect("the voxel itself"));
                }
                for step in 0..-*distance {
                    grid.clear(voxel - face.normal() * step);
                }
            }
        }
        Edit::Flood { start, material, within, .. } => {
            let was = grid.get(*start);
            if was == *material || !within.contains(*start) {
                return;
            }
            // Sweeps over the whole box until nothing is new.
            let mut reached: std::collections::HashSet<IVec3> = [*start].into();
            loop {
                let is_new = |voxel: &IVec3| {
                    let is_beside = |face: &Face| reached.contains(&(*voxel + face.normal()));
                    grid.get(*voxel) == was && !reached.contains(voxel) && FACES.iter().any(is_beside)
                };
                let new: Vec<IVec3> = inside(&Shape::Box(*within)).filter(is_new).collect();
                if new.is_empty() {
                    break;
                }
                reached.extend(new);
            }
            reached.into_iter().for_each(|voxel| match material {
                Some(material) => _ = grid.set(voxel, *material),
                None => _ = grid.clear(voxel),
            });
        }
        Edit::Fill { shape, material } => inside(shape).for_each(|voxel| set(voxel, *material)),
        Edit::Add { shape, material } => {
            for voxel in inside(shape).filter(|&voxel| grid.get(voxel).is_none()).collect::<Vec<_>>() {
                grid.set(voxel, *material);
            }
        }
        Edit::Paint { shape, material } => {
            for voxel in inside(shape).filter(|&voxel| grid.get(voxel).is_some()).collect::<Vec<_>>() {
                grid.set(voxel, *material);
            }
        }
        Edit::Replace { within, from, to } => {
            let found: Vec<IVec3> = (grid.voxels())
                .filter(|(voxel, material)| material == from && within.is_none_or(|within| within.contains(*voxel)))
                .map(|(voxel, _)| voxel)
                .collect();
            found.into_iter().for_each(|voxel| match to {
                Some(to) => _ = grid.set(voxel, *to),
                None => _ = grid.clear(voxel),
            });
        }
    }
}
