//! Parts against the walk over whole instances, and the rows of devices against the boxes that they were made of.

use super::device::{DEVICE_LEAF, DEVICE_MISSING, MOST_WAITING};
use super::*;
use crate::packed::{InstancePart, PackedScene};
use crate::{Instructions, walk};
use glam::Mat3;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::scene::{Instance, Scene};

/// A hillside that is one grid, and things on it that are turned, mirrored and stand in each other.
fn hillside() -> PackedScene {
    let mut scene = Scene { materials: vec![Material::default(); 3], ..Scene::new("hillside") };
    let (mut ground, mut thing) = (VoxelGrid::new(), VoxelGrid::new());
    for x in 0..160 {
        for y in 0..160 {
            let height = (x * 7 + y * 3) / 40 + (x * 31 + y * 17) % 5;
            (0..3).for_each(|depth| _ = ground.set(IVec3::new(x, y, height - depth), 1));
        }
    }
    for at in 0..400 {
        thing.set(IVec3::new(at * 7 % 23 - 11, at * 5 % 19 - 9, at / 8), 2);
    }
    scene.add_instance(ground, Transform::IDENTITY);
    scene.add_instance(thing, Transform { translation: Vec3::new(40.0, 40.0, 20.0), ..Transform::IDENTITY });
    for index in 1..30 {
        let mirror = Mat3::from_diagonal(Vec3::new(if index % 2 == 0 { -1.0 } else { 1.0 }, 1.0, 1.0));
        let linear = Mat3::from_rotation_z(index as f32 * 0.7) * mirror * (0.7 + 0.02 * index as f32);
        let translation = Vec3::new((index * 53 % 150) as f32, (index * 37 % 150) as f32, 20.0);
        scene.instances.push(Instance::new(1, Transform { linear, translation }));
    }
    PackedScene::pack(&scene).unwrap()
}

/// Rays from places on the lattice along its axes and diagonals, which pass through edges and corners, and others.
fn rays() -> Vec<Ray> {
    let number = |index: u32, part: u32| (index.wrapping_mul(0x9e37_79b9) ^ part.wrapping_mul(0x85eb_ca6b)) >> 9;
    (0..20_000)
        .map(|index| {
            let at = |part: u32, size: u32| (number(index, part) % size) as f32 - 20.0;
            let step = |part: u32| (number(index, part) % 3) as f32 - 1.0;
            let origin = Vec3::new(at(1, 200), at(2, 200), at(3, 120));
            match index % 2 {
                0 => Ray::new(origin, Vec3::new(step(4), step(5), step(6) - 0.5 * (index % 4 / 2) as f32)),
                _ => Ray::new(origin + 0.3, Vec3::new(at(7, 41), at(8, 43), at(9, 47)) + 0.1),
            }
        })
        .collect()
}

#[test]
fn hits_are_those_of_whole_instances_where_large_grids_are_many_parts() {
    let scene = hillside();
    let parts = scene.placement.parts(&scene.geometry);
    let of_ground = parts.leaves().iter().filter(|leaf: &&InstancePart| leaf.instance == 0).count();
    assert!(of_ground > 20 && parts.leaves().len() > 60, "{of_ground} of {}", parts.leaves().len());
    let rays = rays();
    let expected: Vec<Hit> = rays.iter().map(|ray| walk::cast(&scene, ray)).collect();
    assert!(expected.iter().filter(|hit| !hit.is_miss()).count() > 5000);
    for instructions in Instructions::ALL.into_iter().filter(|tried| tried.is_available()) {
        let mut hits = vec![Hit::MISS; rays.len()];
        walk::cast_batch_with(instructions, &scene, &rays, &mut hits);
        let wrong = hits.iter().zip(&expected).filter(|(hit, expected)| hit != expected).count();
        assert_eq!(wrong, 0, "{}", instructions.name());
    }
}

#[test]
fn every_part_is_in_the_rows_of_devices_once_and_in_every_box_above_it() {
    let scene = hillside();
    let parts = scene.placement.parts(&scene.geometry);
    let rows = parts.device_rows(&scene.placement);
    let boxes = boxes_of(&parts.planned.plan.parts, parts.leaves(), scene.instances());
    let mut found = Vec::new();
    let everywhere = (Vec3::NEG_INFINITY, Vec3::INFINITY);
    let mut open = vec![(0usize, vec![everywhere], 0)];
    while let Some((node, above, waiting)) = open.pop() {
        let base = Vec3::from_array(std::array::from_fn(|axis| f32::from_bits(rows[node][axis])));
        let children: Vec<usize> = (0..4).filter(|&child| rows[node + 1][child] != DEVICE_MISSING).collect();
        let waiting = waiting + children.len() - 1;
        assert!(waiting < MOST_WAITING);
        for child in children {
            let side = |axis: usize, half: u32| f32::from_bits(rows[node + 2 + axis][child] << (16 * half) & !0xffff);
            let low = base + Vec3::from_array(std::array::from_fn(|axis| side(axis, 1)));
            let high = base + Vec3::from_array(std::array::from_fn(|axis| side(axis, 0)));
            let above = [&above[..], &[(low, high)]].concat();
            match rows[node + 1][child] {
                word if word & DEVICE_LEAF == 0 => open.push((word as usize, above, waiting)),
                word => {
                    let [instance, _, part, _] = rows[(word & !DEVICE_LEAF) as usize];
                    let corner = |row: [u32; 4]| IVec3::new(row[0] as i32, row[1] as i32, row[2] as i32);
                    let (min, max) = (corner(rows[part as usize]), corner(rows[part as usize + 1]));
                    let is_leaf =
                        |leaf: &InstancePart| leaf.instance == instance && parts.bounds(leaf.part) == Some((min, max));
                    let leaf = parts.leaves().iter().position(is_leaf).expect("the part is the instance's");
                    // But for the margin of the boxes, a hundred thousandth of the coordinates.
                    let (least, most) = (boxes[leaf].0 + 1e-3, boxes[leaf].1 - 1e-3);
                    assert!(above.iter().all(|(low, high)| low.cmple(least).all() && high.cmpge(most).all()));
                    found.push(leaf);
                }
            }
        }
    }
    found.sort_unstable();
    assert!(found.into_iter().eq(0..parts.leaves().len()));
}
