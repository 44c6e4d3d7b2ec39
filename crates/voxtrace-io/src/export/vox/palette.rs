//! The materials of a scene as the 255 entries of a .vox palette. Up to 255 materials keep their order; more are reduced by
//! median cut over the entries, weighted by their voxels, and a few steps of k-means (Heckbert 1982; Lloyd 1982).

use super::entry::{Entry, srgb_of};
use crate::import::vox::Body;
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use voxtrace_scene::material::linear_color;
use voxtrace_scene::oklab::{linear_of, oklab_of};
use voxtrace_scene::scene::Scene;

/// Entries of a palette; index 0 is empty space.
pub const MOST_ENTRIES: usize = 255;
/// Steps of k-means after the median cut.
const REFINEMENTS: usize = 4;
/// Numbers that place an entry among others: Oklab colour, emission, roughness, metalness, transmission, refraction.
const FEATURES: usize = 8;

/// The palette of a scene and where each of its materials went.
#[derive(Clone, Debug)]
pub struct Palette {
    entries: Vec<Entry>,
    /// Colour index of each material, 1 to 255.
    indices: Vec<u8>,
}

impl Palette {
    /// The palette of a scene.
    pub fn of(scene: &Scene) -> Self {
        let entries: Vec<Entry> =
            scene.materials.iter().map(|material| Entry::of(material, scene.light_intensity)).collect();
        if entries.len() <= MOST_ENTRIES {
            return Self { indices: (0..entries.len()).map(|index| index as u8 + 1).collect(), entries };
        }
        let weights = voxel_counts(scene, entries.len());
        let mut distinct: BTreeMap<_, (Entry, u64)> = BTreeMap::new();
        for (entry, &weight) in entries.iter().zip(&weights).filter(|(_, weight)| **weight > 0) {
            distinct.entry(entry.key()).or_insert((*entry, 0)).1 += weight;
        }
        let points: Vec<Point> = distinct.values().map(|&(entry, weight)| Point::new(entry, weight)).collect();
        let clusters = reduced(&points);
        let entries_of_clusters: Vec<Entry> = clusters.iter().map(|cluster| mean_entry(&points, cluster)).collect();
        let mut index_of_key = BTreeMap::new();
        for (index, cluster) in clusters.iter().enumerate() {
            index_of_key.extend(cluster.iter().map(|&point| (points[point].entry.key(), index as u8 + 1)));
        }
        // A material without a voxel is nowhere to be seen and may be anything.
        let indices = entries.iter().map(|entry| index_of_key.get(&entry.key()).copied().unwrap_or(1)).collect();
        Self { entries: entries_of_clusters, indices }
    }

    /// The colour index of a material; materials that the scene has not are the first one.
    pub fn index(&self, material: u16) -> u8 {
        self.indices.get(usize::from(material)).copied().unwrap_or(1)
    }

    /// The RGBA chunk's colours.
    pub fn colors(&self) -> Box<[[u8; 4]; 256]> {
        let mut colors = Box::new([[0; 4]; 256]);
        for (color, Entry { color: [r, g, b], .. }) in colors.iter_mut().zip(&self.entries) {
            *color = [*r, *g, *b, 255];
        }
        colors
    }

    /// The MATL chunks.
    pub fn materials(&self) -> impl Iterator<Item = Body<'static>> + '_ {
        (1..).zip(&self.entries).map(|(id, entry)| entry.chunk(id))
    }
}

/// Voxels of each material, each grid counted once.
fn voxel_counts(scene: &Scene, materials: usize) -> Vec<u64> {
    let count = |grid: &std::sync::Arc<voxtrace_scene::VoxelGrid>| {
        let mut counts = vec![0; materials];
        for (_, brick) in grid.sorted_bricks() {
            for &material in brick.materials() {
                if let Some(count) = counts.get_mut(usize::from(material)) {
                    *count += 1;
                }
            }
        }
        counts
    };
    let sum = |mut a: Vec<u64>, b: Vec<u64>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        a
    };
    scene.grids.par_iter().map(count).reduce(|| vec![0; materials], sum)
}

/// An entry among the others.
struct Point {
    entry: Entry,
    weight: f64,
    features: [f64; FEATURES],
}

impl Point {
    fn new(entry: Entry, voxels: u64) -> Self {
        let color = oklab_of(linear_color(entry.color));
        // What emits is far from what does not, and a factor of ten apart is as far as black from white.
        let emission = if entry.emission > 0.0 { 10.0 + f64::from(entry.emission).log10() } else { 0.0 };
        let other = [entry.roughness, entry.metallic, entry.transmission, entry.ior].map(f64::from);
        let [lightness, a, b] = color.to_array().map(f64::from);
        let features = [lightness, a, b, emission, other[0], other[1], other[2], other[3]];
        // The square root keeps small things, such as a lamp, from drowning in walls.
        Self { entry, weight: (voxels as f64).sqrt(), features }
    }
}

/// The points in at most [`MOST_ENTRIES`] groups of indices, none empty.
fn reduced(points: &[Point]) -> Vec<Vec<usize>> {
    let mut clusters = vec![(0..points.len()).collect::<Vec<_>>()];
    let mut spreads = vec![widest_axis(points, &clusters[0])];
    while clusters.len() < MOST_ENTRIES {
        let widest = (0..clusters.len()).max_by(|&a, &b| spreads[a].1.total_cmp(&spreads[b].1).then(b.cmp(&a)));
        let Some(widest) = widest.filter(|&widest| spreads[widest].1 > 0.0) else { break };
        let axis = spreads[widest].0;
        let middle = mean(points, &clusters[widest])[axis];
        let (below, above): (Vec<_>, Vec<_>) =
            clusters[widest].iter().partition(|&&point| points[point].features[axis] < middle);
        if below.is_empty() || above.is_empty() {
            // Rounding can put the mean onto the lowest point: these differ by nothing that counts.
            spreads[widest].1 = 0.0;
            continue;
        }
        spreads[widest] = widest_axis(points, &below);
        spreads.push(widest_axis(points, &above));
        clusters[widest] = below;
        clusters.push(above);
    }
    for _ in 0..REFINEMENTS {
        let centers: Vec<_> = clusters.iter().map(|cluster| mean(points, cluster)).collect();
        let nearest: Vec<usize> = points.par_iter().map(|point| nearest_center(&centers, &point.features)).collect();
        let mut next = vec![Vec::new(); clusters.len()];
        nearest.into_iter().enumerate().for_each(|(point, cluster)| next[cluster].push(point));
        next.retain(|cluster| !cluster.is_empty());
        clusters = next;
    }
    clusters
}

fn nearest_center(centers: &[[f64; FEATURES]], features: &[f64; FEATURES]) -> usize {
    let distance = |center: &[f64; FEATURES]| center.iter().zip(features).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    let distances = centers.iter().map(distance).enumerate();
    distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index)
}

fn mean(points: &[Point], cluster: &[usize]) -> [f64; FEATURES] {
    let (mut sum, mut weight) = ([0.0; FEATURES], 0.0);
    for point in cluster.iter().map(|&point| &points[point]) {
        sum.iter_mut().zip(&point.features).for_each(|(sum, feature)| *sum += feature * point.weight);
        weight += point.weight;
    }
    sum.map(|sum| sum / weight)
}

/// The axis along which a cluster spreads most, and its weighted sum of squares there.
fn widest_axis(points: &[Point], cluster: &[usize]) -> (usize, f64) {
    let center = mean(points, cluster);
    let mut squares = [0.0; FEATURES];
    for point in cluster.iter().map(|&point| &points[point]) {
        for axis in 0..FEATURES {
            squares[axis] += (point.features[axis] - center[axis]).powi(2) * point.weight;
        }
    }
    let widest = squares.into_iter().enumerate().max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
    widest.unwrap_or((0, 0.0))
}

/// The entry that stands for a cluster; for a cluster of one, that one.
fn mean_entry(points: &[Point], cluster: &[usize]) -> Entry {
    if let &[only] = cluster {
        return points[only].entry;
    }
    let weight: f64 = cluster.iter().map(|&point| points[point].weight).sum();
    let average = |of: fn(&Entry) -> f32| {
        (cluster.iter().map(|&point| f64::from(of(&points[point].entry)) * points[point].weight).sum::<f64>() / weight)
            as f32
    };
    let center = mean(points, cluster);
    let color = srgb_of(linear_of(Vec3::new(center[0] as f32, center[1] as f32, center[2] as f32)));
    Entry {
        color,
        emission: average(|entry| entry.emission),
        roughness: average(|entry| entry.roughness),
        metallic: average(|entry| entry.metallic),
        transmission: average(|entry| entry.transmission),
        ior: average(|entry| entry.ior),
        medium: std::array::from_fn(|at| {
            let sum: f64 =
                cluster.iter().map(|&point| f64::from(points[point].entry.medium[at]) * points[point].weight).sum();
            (sum / weight) as f32
        }),
    }
}
