//! Colour quantization: from appearances to materials. Each appearance is a material of its own as long as there are few
//! enough. Else colours are quantized in Oklab by median cut (Heckbert, "Color Image Quantization for Frame Buffer Display",
//! SIGGRAPH 1982) and, for small palettes, some iterations of k-means (Lloyd, 1982).

use super::appearance::{AppearanceKey, BsdfClass, appearance_key, coarser_emission, material_of, material_with};
use super::color_histogram::{BINS, ColorHistogram, bin_of, color_of_bin};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::collections::BinaryHeap;
use voxtrace_scene::material::Material;
use voxtrace_scene::oklab::{linear_of, oklab_of};

/// Palettes up to this size are refined by k-means, and may be dithered.
pub(super) const SMALL: usize = 1024;
/// Iterations of k-means.
const REFINEMENTS: usize = 12;
/// At most one in so many materials emits, where others are needed too.
const EMISSIVE_SHARE: usize = 4;

/// The materials of a scene, and the map from appearances to them.
pub(super) struct Palette {
    pub materials: Vec<Material>,
    /// Whether every appearance is a material of its own.
    pub is_exact: bool,
    plain: NonEmissive,
    emissive: FxHashMap<AppearanceKey, u16>,
    /// Bits that colour and emission of an emissive appearance lose before the lookup.
    lost: u32,
}

/// The materials of appearances that do not emit.
enum NonEmissive {
    /// No quantization: an appearance's material is how many others come before it in ascending order. By class.
    Exact(Vec<ColorRanks>),
    /// By class and histogram bin: the nearest material, the one to dither with, and that one's share in 1/255.
    Bins(Vec<Vec<(u16, u16, u8)>>),
}

impl Palette {
    /// Chooses at most `most` materials; `dither` mixes two materials where none fits, up to [`SMALL`] materials.
    pub fn of(histogram: &ColorHistogram, classes: &[BsdfClass], most: usize, dither: bool) -> Self {
        let emissive = histogram.emissive();
        let room = if histogram.appearance_count() > 0 { (most / EMISSIVE_SHARE).max(1) } else { most };
        let (lost, emissive) =
            fit_emissive(&emissive, room.max(most.saturating_sub(histogram.appearance_count() as usize)));
        let mut materials: Vec<Material> = Vec::new();
        let room = most - emissive.len().min(most);
        let plain = if histogram.appearance_count() <= room as u64 {
            let keys = histogram.appearances();
            materials.extend(keys.iter().map(|&key| material_of(key, classes)));
            NonEmissive::Exact(ColorRanks::of(&keys))
        } else {
            quantized(histogram, classes, room, dither, &mut materials)
        };
        let is_exact = lost == 0 && matches!(plain, NonEmissive::Exact(_));
        let first = materials.len();
        materials.extend(emissive.iter().map(|&key| material_of(key, classes)));
        let emissive = emissive.iter().enumerate().map(|(index, &key)| (key, (first + index) as u16)).collect();
        Self { materials, is_exact, plain, emissive, lost }
    }

    /// The material of an appearance; the voxel's place chooses between two when dithering.
    pub fn index(&self, key: AppearanceKey, voxel: IVec3) -> u16 {
        if key >> 32 != 0 {
            return self.emissive.get(&coarser(key, self.lost)).copied().unwrap_or(0);
        }
        match &self.plain {
            // The histogram has seen every appearance.
            NonEmissive::Exact(classes) => classes[(key >> 24 & 0xff) as usize].rank(key as u32),
            NonEmissive::Bins(classes) => {
                let bins = &classes[(key >> 24 & 0xff) as usize];
                let (nearest, second, share) = bins.get(bin_of(key as u32)).copied().unwrap_or_default();
                if u32::from(share) > threshold(voxel) { second } else { nearest }
            }
        }
    }
}

/// Distinct colours of a class, as a bitmap with counts: the number of a colour is found at once.
#[derive(Clone, Default)]
struct ColorRanks(Vec<RankWord>);

/// Which of 64 colours there are, and how many come before them.
#[derive(Clone, Copy, Default)]
struct RankWord {
    colors: u64,
    before: u32,
}

impl ColorRanks {
    /// Of ascending keys that do not emit; by class.
    fn of(keys: &[AppearanceKey]) -> Vec<Self> {
        let class_of = |key: AppearanceKey| (key >> 24 & 0xff) as usize;
        let mut classes = vec![Self::default(); keys.last().map_or(0, |&key| class_of(key) + 1)];
        for &key in keys {
            let words = &mut classes[class_of(key)].0;
            words.resize(1 << 18, RankWord::default());
            words[(key as u32 & 0xff_ffff) as usize / 64].colors |= 1 << (key % 64);
        }
        let mut before = 0;
        for word in classes.iter_mut().flat_map(|class| &mut class.0) {
            word.before = before;
            before += word.colors.count_ones();
        }
        classes
    }

    /// How many appearances come before that of a colour, 0xRRGGBB.
    fn rank(&self, key: u32) -> u16 {
        let RankWord { colors, before } = self.0[(key & 0xff_ffff) as usize / 64];
        (before + (colors & ((1u64 << (key % 64)) - 1)).count_ones()) as u16
    }
}

/// An appearance without the lowest `lost` bits of its colour and emission.
fn coarser(key: AppearanceKey, lost: u32) -> AppearanceKey {
    if lost == 0 {
        return key;
    }
    let mask = u32::from(0xffu8 >> lost.min(7) << lost.min(7));
    let rgb = key as u32 & (mask | mask << 8 | mask << 16);
    appearance_key(rgb, (key >> 24 & 0xff) as u8, coarser_emission((key >> 32) as u32, lost))
}

/// The emissive appearances, ascending, with as many of their bits as leave at most `room` of them, and the bits lost.
fn fit_emissive(emissive: &[(AppearanceKey, u64)], room: usize) -> (u32, Vec<AppearanceKey>) {
    let mut keys = Vec::new();
    for lost in 0..=8 {
        keys = emissive.iter().map(|&(key, _)| coarser(key, lost)).collect();
        keys.sort_unstable();
        keys.dedup();
        if keys.len() <= room {
            return (lost, keys);
        }
    }
    keys.truncate(room);
    (8, keys)
}

/// The threshold of ordered dithering, 0 to 254: the R3 low-discrepancy sequence, which spreads neighbouring values far apart
/// (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
pub(super) fn threshold(voxel: IVec3) -> u32 {
    const STEPS: [u32; 3] = [3_518_319_155, 2_882_110_345, 2_360_945_575];
    let sum = voxel
        .to_array()
        .iter()
        .zip(STEPS)
        .fold(0u32, |sum, (&at, step)| sum.wrapping_add((at as u32).wrapping_mul(step)));
    ((u64::from(sum) * 255) >> 32) as u32
}

/// A histogram bin of a class, as a weighted point in Oklab.
struct Point {
    class: usize,
    bin: usize,
    color: Vec3,
    weight: f32,
}

fn quantized(
    histogram: &ColorHistogram,
    classes: &[BsdfClass],
    room: usize,
    dither: bool,
    materials: &mut Vec<Material>,
) -> NonEmissive {
    let mut points: Vec<Point> = (0..classes.len())
        .flat_map(|class| histogram.bins(class).into_iter().map(move |(bin, count)| (class, bin, count)))
        .map(|(class, bin, count)| {
            let linear = Vec3::from_array(color_of_bin(bin).map(linear_of_signal));
            // The square root keeps colours of small objects from being outweighed by large surfaces.
            Point { class, bin, color: oklab_of(linear), weight: (count as f32).sqrt() }
        })
        .collect();
    let room = room.max(classes.len());
    let clusters = median_cut(&mut points, room);
    let mut centers: Vec<(usize, Vec3)> =
        clusters.iter().map(|&(start, end)| (points[start].class, mean(&points[start..end]))).collect();
    if room <= SMALL {
        refine(&points, &mut centers);
    }
    materials.extend(centers.iter().map(|&(class, color)| {
        material_with(linear_of(color).clamp(Vec3::ZERO, Vec3::ONE), appearance_key(0, class as u8, 0), classes)
    }));

    let mut bins = vec![Vec::new(); classes.len()];
    let assigned: Vec<(u16, u16, u8)> = if room <= SMALL {
        points.par_iter().map(|point| nearest_two(point.class, point.color, &centers, dither)).collect()
    } else {
        let mut of_point = vec![(0, 0, 0); points.len()];
        for (index, &(start, end)) in clusters.iter().enumerate() {
            of_point[start..end].fill((index as u16, index as u16, 0));
        }
        of_point
    };
    for (point, entry) in points.iter().zip(assigned) {
        let bins = &mut bins[point.class];
        bins.resize(BINS, (0, 0, 0));
        bins[point.bin] = entry;
    }
    NonEmissive::Bins(bins)
}

fn linear_of_signal(signal: f32) -> f32 {
    if signal <= 0.04045 { signal / 12.92 } else { ((signal + 0.055) / 1.055).powf(2.4) }
}

fn mean(points: &[Point]) -> Vec3 {
    let (sum, weight) = points
        .iter()
        .fold((Vec3::ZERO, 0.0), |(sum, weight), point| (sum + point.color * point.weight, weight + point.weight));
    sum / weight
}

/// Median cut: splits the points into at most `room` clusters of one class each, reorders them by cluster and returns the
/// clusters' ranges.
fn median_cut(points: &mut [Point], room: usize) -> Vec<(usize, usize)> {
    points.sort_by_key(|point| (point.class, point.bin));
    let mut heap = BinaryHeap::new();
    let mut done = Vec::new();
    let spread = |points: &[Point]| {
        let center = mean(points);
        let squares = points.iter().fold(Vec3::ZERO, |sum, point| {
            let offset = point.color - center;
            sum + offset * offset * point.weight
        });
        (squares.max_element(), squares.max_position(), center)
    };
    let mut push = |heap: &mut BinaryHeap<_>, points: &[Point], start: usize, end: usize| {
        let (square, axis, center) = spread(&points[start..end]);
        if end - start > 1 && square > 0.0 {
            // Floats ≥ 0 have the order of their bits.
            heap.push((square.to_bits(), std::cmp::Reverse(start), end, axis, center[axis].to_bits()));
        } else {
            done.push((start, end));
        }
    };
    let mut count = 0;
    let mut start = 0;
    for class in points.chunk_by(|a, b| a.class == b.class) {
        push(&mut heap, points, start, start + class.len());
        (start, count) = (start + class.len(), count + 1);
    }
    while count < room {
        let Some((_, std::cmp::Reverse(start), end, axis, center)) = heap.pop() else { break };
        let center = f32::from_bits(center);
        let part = &mut points[start..end];
        part.sort_by(|a, b| a.color[axis].total_cmp(&b.color[axis]).then(a.bin.cmp(&b.bin)));
        let middle = part.partition_point(|point| point.color[axis] < center).clamp(1, part.len() - 1);
        push(&mut heap, points, start, start + middle);
        push(&mut heap, points, start + middle, end);
        count += 1;
    }
    done.extend(heap.into_iter().map(|(_, std::cmp::Reverse(start), end, ..)| (start, end)));
    done.sort_unstable();
    done
}

/// k-means: moves each centre to the mean of the points nearest to it.
fn refine(points: &[Point], centers: &mut [(usize, Vec3)]) {
    for _ in 0..REFINEMENTS {
        let nearest: Vec<usize> =
            points.par_iter().map(|point| nearest_two(point.class, point.color, centers, false).0.into()).collect();
        let mut sums = vec![(Vec3::ZERO, 0.0); centers.len()];
        for (point, &center) in points.iter().zip(&nearest) {
            sums[center].0 += point.color * point.weight;
            sums[center].1 += point.weight;
        }
        for (center, (sum, weight)) in centers.iter_mut().zip(sums) {
            if weight > 0.0 {
                center.1 = sum / weight;
            }
        }
    }
}

/// For a colour in Oklab: the nearest centre of its class, the centre that mixes best with it (the same one without `dither`),
/// and that one's share in 1/255.
pub(super) fn nearest_two(class: usize, wanted: Vec3, centers: &[(usize, Vec3)], dither: bool) -> (u16, u16, u8) {
    let own = || centers.iter().enumerate().filter(|(_, center)| center.0 == class);
    let distance = |color: Vec3| color.distance_squared(wanted);
    let nearest = own().min_by(|a, b| distance(a.1.1).total_cmp(&distance(b.1.1)));
    let Some((nearest, &(_, first))) = nearest else { return (0, 0, 0) };
    let mut best = (nearest as u16, nearest as u16, 0);
    if !dither {
        return best;
    }
    let mut least = distance(first);
    for (index, &(_, color)) in own() {
        let way = color - first;
        let share = (wanted - first).dot(way) / way.length_squared();
        // Colours far apart would be visible as noise.
        if share > 0.0 && share <= 0.5 && way.length() < 0.25 {
            let mixed = distance(first + way * share);
            if mixed < least {
                least = mixed;
                best.1 = index as u16;
                best.2 = (share * 255.0).round() as u8;
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxelize::appearance::emission_bits;

    const PLAIN: BsdfClass =
        BsdfClass { roughness: 1.0, metallic: 0.0, transmission: 0.0, ior: 1.5, coat: None, absorption: None };

    fn ramp(count: u32) -> ColorHistogram {
        let histogram = ColorHistogram::default();
        for i in 0..count {
            let shade = i * 255 / (count - 1);
            histogram.add(&[appearance_key(shade << 16 | shade << 8 | (i % 256), 0, 0)], 1 + i);
        }
        histogram
    }

    #[test]
    fn few_appearances_become_materials_unchanged() {
        let histogram = ColorHistogram::default();
        let lamp = appearance_key(0x102030, 1, emission_bits(Vec3::new(5.0, 4.0, 3.0)));
        histogram.add(&[0xff0000, 0x00ff00, appearance_key(0xff0000, 1, 0), lamp], 1);
        let glossy = BsdfClass { roughness: 0.1, ..PLAIN };
        let palette = Palette::of(&histogram, &[PLAIN, glossy], 4, false);
        assert!(palette.is_exact);
        assert_eq!(palette.materials.len(), 4);
        let material = |key: AppearanceKey| palette.materials[usize::from(palette.index(key, IVec3::ZERO))];
        assert_eq!(material(0xff0000).base_color, Vec3::X);
        assert_eq!((material(appearance_key(0xff0000, 1, 0)).roughness, material(0xff0000).roughness), (0.1, 1.0));
        assert!((material(lamp).emission - Vec3::new(5.0, 4.0, 3.0)).abs().max_element() < 0.02);
    }

    #[test]
    fn colours_have_the_numbers_of_their_order_over_all_classes() {
        let keys: Vec<AppearanceKey> = (0..3u64)
            .filter(|class| *class != 1)
            .flat_map(|class| (0..9000u64).map(move |i| (class << 24) | (i * 1861 % (1 << 24))))
            .collect::<std::collections::BTreeSet<_>>()
            .into_iter()
            .collect();
        let classes = ColorRanks::of(&keys);
        assert_eq!((classes.len(), keys.len()), (3, 18_000));
        for (number, &key) in keys.iter().enumerate() {
            assert_eq!(usize::from(classes[(key >> 24) as usize].rank(key as u32)), number);
        }
    }

    #[test]
    fn many_appearances_become_as_many_materials_as_allowed_and_stay_near() {
        let histogram = ramp(2000);
        for room in [16, 255, 1500] {
            let palette = Palette::of(&histogram, &[PLAIN], room, false);
            assert!(palette.materials.len() <= room && palette.materials.len() > room / 2);
            assert!(!palette.is_exact);
            let keys = histogram.appearances();
            let worst = keys.iter().map(|&key| {
                let color = palette.materials[usize::from(palette.index(key, IVec3::ZERO))].base_color;
                oklab_of(color).distance(oklab_of(material_of(key, &[PLAIN]).base_color))
            });
            let worst = worst.fold(0.0, f32::max);
            assert!(worst < if room == 16 { 0.3 } else { 0.08 }, "{room}: {worst}");
        }
    }

    #[test]
    fn dithering_keeps_the_mean_of_a_colour_between_two_materials() {
        let histogram = ColorHistogram::default();
        for shade in [0x40, 0x41, 0x60, 0x62] {
            histogram.add(&[shade << 16 | shade << 8 | shade], 100_000);
        }
        histogram.add(&[0x494949], 1);
        let palette = Palette::of(&histogram, &[PLAIN], 2, true);
        let lightness =
            |voxel: IVec3| oklab_of(palette.materials[usize::from(palette.index(0x494949, voxel))].base_color).x;
        let voxels = (0..4096).map(|i| IVec3::new(i & 15, i >> 4 & 15, i >> 8));
        let mean = voxels.map(lightness).sum::<f32>() / 4096.0;
        let wanted = oklab_of(material_of(0x494949, &[PLAIN]).base_color).x;
        assert!((mean - wanted).abs() < 0.01, "{mean} {wanted}");
        let plain = Palette::of(&histogram, &[PLAIN], 2, false);
        assert_eq!(plain.index(0x494949, IVec3::ZERO), plain.index(0x494949, IVec3::new(5, 7, 9)));
    }

    #[test]
    fn too_many_emissions_lose_bits_before_they_lose_their_light() {
        let emissive: Vec<_> = (0..500)
            .map(|i| (appearance_key(i, 0, emission_bits(Vec3::new(1.0 + i as f32 / 500.0, 1.0, 0.5))), 1))
            .collect();
        let (lost, fitted) = fit_emissive(&emissive, 40);
        assert!(lost > 0 && fitted.len() <= 40 && !fitted.is_empty());
        assert!(fitted.iter().all(|key| key >> 32 != 0));
        assert_eq!(fit_emissive(&emissive, 500).0, 0);
    }
}
