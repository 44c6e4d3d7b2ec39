//! Normals of voxels in the packed arrays: one code for each voxel, in rank order, right before the materials of its brick and counted backwards from
//! there. So what reads materials does not know of them, and a scene without them has the bytes that it had.

use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
use super::{CELL_OCCUPIED, Geometry, PackError, PackedGrid};
use crate::normals::code::NORMAL_BITS;
use crate::normals::normals_of;
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::BRICK_SIZE;

/// Words of the normals of a brick of so many voxels.
pub(super) fn normal_words(voxels: u32) -> usize {
    (voxels * NORMAL_BITS).div_ceil(32) as usize
}

/// Words, and bits after them, from the code of the voxel of a rank to the materials of its brick. Twin in `shaders/normals.slang`.
#[inline]
fn distance(rank: u32) -> (u32, u32) {
    let bits = (rank + 1) * NORMAL_BITS;
    let words = bits.div_ceil(32);
    (words, words * 32 - bits)
}

/// Appends the codes of a brick, which its materials have to follow.
fn append_codes(codes: &[u16], words: &mut Vec<u32>) {
    let first = words.len();
    words.resize(first + normal_words(codes.len() as u32), 0);
    let end = words.len();
    for (rank, &code) in codes.iter().enumerate() {
        let (back, shift) = distance(rank as u32);
        let at = end - back as usize;
        let bits = u64::from(code) << shift;
        words[at] |= bits as u32;
        if shift + NORMAL_BITS > 32 {
            words[at + 1] |= (bits >> 32) as u32;
        }
    }
}

/// Whether a file's section about normals says that there are some.
pub(super) fn is_known_kind(section: &[u32]) -> Result<bool, Invalid> {
    if section == [NORMAL_BITS] { Ok(true) } else { Err("the normals of voxels are of another kind".into()) }
}

/// A brick as it lies in the arrays.
struct Placed {
    /// Index of its grid.
    grid: usize,
    /// In bricks, from the origin of its grid.
    at: IVec3,
    /// Position of its record, words.
    record: usize,
}

impl Geometry {
    /// Whether voxels have normals.
    pub fn has_normals(&self) -> bool {
        self.has_normals
    }

    /// The section of a file that says that voxels have normals.
    pub(super) fn normal_section(&self) -> Option<([u8; 4], u32, &'static [u8])> {
        const RECORD: &[u8] = &NORMAL_BITS.to_le_bytes();
        self.has_normals.then_some((*b"NORM", RECORD.len() as u32, RECORD))
    }

    /// Bytes of the normals.
    pub(super) fn normal_bytes(&self) -> u64 {
        if !self.has_normals {
            return 0;
        }
        self.placed_bricks().iter().map(|brick| 4 * normal_words(self.voxels_of(brick.record)) as u64).sum()
    }

    /// The code of the normal of a voxel that is there, in a geometry that has normals.
    pub(crate) fn normal_at(&self, grid: &PackedGrid, voxel: IVec3) -> Option<u32> {
        let (record, rank) = self.rank_at(grid, voxel)?;
        let (words, shift) = distance(rank);
        let word = u64::from(self.bricks[record + 1]) - u64::from(words);
        Some(bits_at(&self.brick_materials, word * 32 + u64::from(shift), NORMAL_BITS))
    }

    /// The same voxels with normals that are estimated from them.
    pub(crate) fn with_smooth_normals(&self) -> Result<Self, PackError> {
        let placed = self.placed_bricks();
        let mut codes: FxHashMap<usize, Vec<u16>> = FxHashMap::default();
        for of_grid in placed.chunk_by(|a, b| a.grid == b.grid) {
            let records: FxHashMap<IVec3, usize> = of_grid.iter().map(|brick| (brick.at, brick.record)).collect();
            let occupancy = records.iter().map(|(&at, &record)| (at, self.masks(record))).collect();
            codes.extend(normals_of(&occupancy).into_iter().map(|(at, codes)| (records[&at], codes)));
        }
        self.with_codes(placed, Some(&codes))
    }

    /// The same voxels without normals.
    pub(crate) fn without_normals(&self) -> Result<Self, PackError> {
        self.with_codes(self.placed_bricks(), None)
    }

    /// The same voxels with other codes, by the positions of the bricks' records, none at all for `None`; where a brick is missing its faces count.
    fn with_codes(
        &self,
        mut placed: Vec<Placed>,
        codes: Option<&FxHashMap<usize, Vec<u16>>>,
    ) -> Result<Self, PackError> {
        placed.sort_unstable_by_key(|brick| brick.record);
        placed.dedup_by_key(|brick| brick.record);
        let mut bricks = self.bricks.to_vec();
        let mut words = Vec::with_capacity(self.brick_materials.len());
        for brick in &placed {
            let voxels = self.voxels_of(brick.record);
            if let Some(codes) = codes {
                let of_brick = codes.get(&brick.record).cloned().unwrap_or_else(|| vec![0; voxels as usize]);
                append_codes(&of_brick, &mut words);
            }
            let start = self.bricks[brick.record + 1] as usize;
            bricks[brick.record + 1] = words.len() as u32;
            let materials = self.material_words(&self.grids[brick.grid], brick.record, voxels);
            words.extend_from_slice(&self.brick_materials[start..start + materials]);
            if words.len() as u64 / 2 >= u64::from(CELL_OCCUPIED) {
                return Err(PackError::TooLarge(words.len() as u64 / 2, "materials and normals"));
            }
        }
        let changed = Self {
            bricks: bricks.into(),
            brick_materials: words.into(),
            has_normals: codes.is_some(),
            has_coverage: false,
            ..self.clone()
        };
        Ok(changed.finished())
    }

    /// Gives the bricks of the grids from `first` on, which have no normals yet, those of their faces, as the others have normals.
    pub(super) fn with_face_normals_from(self, first: usize) -> Result<Self, PackError> {
        let placed = self.placed_bricks();
        let (own, added): (Vec<_>, Vec<_>) = placed.into_iter().partition(|brick| brick.grid < first);
        let codes = (own.par_iter())
            .map(|brick| {
                let voxels = self.voxels_of(brick.record);
                let code = |rank: u32| {
                    let (words, shift) = distance(rank);
                    let word = u64::from(self.bricks[brick.record + 1]) - u64::from(words);
                    bits_at(&self.brick_materials, word * 32 + u64::from(shift), NORMAL_BITS) as u16
                };
                (brick.record, (0..voxels).map(code).collect())
            })
            .collect();
        let placed = own.into_iter().chain(added).collect();
        self.with_codes(placed, Some(&codes))
    }

    /// All bricks, grid by grid.
    fn placed_bricks(&self) -> Vec<Placed> {
        let of_grid = |(index, grid): (usize, &PackedGrid)| {
            let bricks = self.bricks_of(grid);
            let place = move |at: IVec3| {
                let record = self.find_brick(grid, grid.origin + at * BRICK_SIZE)?;
                Some(Placed { grid: index, at, record })
            };
            bricks.into_par_iter().filter_map(place).collect::<Vec<_>>()
        };
        self.grids.iter().enumerate().flat_map(of_grid).collect()
    }

    /// Which voxels of a brick there are.
    pub(crate) fn masks(&self, record: usize) -> [u64; 8] {
        let (mut masks, mut next) = ([0; 8], record + 2);
        for (block, mask) in masks.iter_mut().enumerate().filter(|(block, _)| self.bricks[record] >> block & 1 == 1) {
            debug_assert!(block < 8);
            *mask = u64::from(self.bricks[next]) | u64::from(self.bricks[next + 1]) << 32;
            next += 2;
        }
        masks
    }

    pub(crate) fn voxels_of(&self, record: usize) -> u32 {
        self.masks(record).iter().map(|mask| mask.count_ones()).sum()
    }

    /// Words of a brick's palette and indices.
    pub(crate) fn material_words(&self, grid: &PackedGrid, record: usize, voxels: u32) -> usize {
        let header = self.bricks[record];
        let (index_bits, palette) = (header >> HEADER_INDEX_BITS & 0xff, header >> HEADER_PALETTE);
        (palette * grid.material_bits + voxels * index_bits).div_ceil(32) as usize
    }
}

#[cfg(test)]
mod tests {
    use crate::normals::Normals;
    use crate::normals::code::{NO_NORMAL, decode};
    use crate::packed::file::{Header, TableEntry};
    use crate::packed::{Geometry, PackedScene};
    use crate::surroundings::Ground;
    use glam::{IVec3, Vec3};
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::ray::FACES;
    use voxtrace_scene::scene::Scene;
    use voxtrace_scene::transform::Transform;
    use xxhash_rust::xxh3::xxh3_64;

    /// Balls of many materials.
    fn balls(places: &[IVec3]) -> Scene {
        let mut grid = VoxelGrid::new();
        for place in 0..24 * 24 * 24 {
            let voxel = IVec3::new(place % 24, place / 24 % 24, place / 576) - 12;
            if voxel.as_vec3().length() < 11.0 {
                grid.set(voxel, ((voxel.x * voxel.y + voxel.z).unsigned_abs() % 40) as u16);
            }
        }
        let mut scene = Scene { materials: vec![Material::diffuse(Vec3::ONE); 40], ..Scene::new("balls") };
        for place in places {
            scene.add_instance(grid.clone(), Transform::from_translation(place.as_vec3()));
        }
        scene
    }

    fn ball() -> PackedScene {
        PackedScene::pack(&balls(&[IVec3::ZERO])).unwrap()
    }

    fn words(scene: &PackedScene) -> [&[u32]; 3] {
        let geometry = scene.geometry();
        [geometry.cells(), geometry.bricks(), geometry.brick_materials()]
    }

    #[test]
    fn normals_change_no_material_and_leave_no_trace_when_they_are_taken_away() {
        let plain = ball();
        let smooth = plain.with_normals(Normals::Smooth).unwrap();
        assert_eq!((plain.normals(), smooth.normals()), (Normals::Faces, Normals::Smooth));
        assert_ne!(plain.content_hash(), smooth.content_hash());
        let mut seen = 0;
        for place in 0..24 * 24 * 24 {
            let voxel = IVec3::new(place % 24, place / 24 % 24, place / 576) - 12;
            let material = |scene: &PackedScene| scene.geometry.material_at(&scene.grids()[0], voxel);
            assert_eq!(material(&plain), material(&smooth), "{voxel}");
            let code = smooth.geometry.normal_at(&smooth.grids()[0], voxel).filter(|&code| code != NO_NORMAL);
            let is_there = |voxel: IVec3| plain.geometry.material_at(&plain.grids()[0], voxel).is_some();
            let is_seen = FACES.iter().any(|face| !is_there(voxel + face.normal()));
            assert_eq!(code.is_some(), is_there(voxel) && is_seen, "{voxel}");
            let Some(code) = code else { continue };
            let cos = decode(code).along.as_vec3().normalize().dot(voxel.as_vec3().normalize());
            assert!(cos > 0.99, "{voxel}: {cos}");
            seen += 1;
        }
        assert!(seen > 1000);
        smooth.validate().unwrap();
        let bytes = smooth.statistics().bytes.into_iter().find(|(kind, _)| *kind == "normals").unwrap().1;
        let per_voxel = bytes as f64 / smooth.statistics().voxels as f64;
        assert!((1.875..1.92).contains(&per_voxel), "{per_voxel}");
        let back = smooth.with_normals(Normals::Faces).unwrap();
        assert!(words(&back) == words(&plain) && back.content_hash() == plain.content_hash());
        let again = smooth.with_normals(Normals::Smooth).unwrap();
        assert!(words(&again) == words(&smooth) && again.content_hash() == smooth.content_hash());
    }

    #[test]
    fn files_keep_normals_and_readers_that_do_not_know_them_see_the_faces() {
        let smooth = ball().with_normals(Normals::Smooth).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("ball.vxt");
        smooth.save(&path).unwrap();
        for opened in [PackedScene::open(&path).unwrap(), PackedScene::read(&path).unwrap()] {
            assert_eq!((opened.normals(), opened.content_hash()), (Normals::Smooth, smooth.content_hash()));
        }
        let bytes = std::fs::read(&path).unwrap();
        let renamed = with_section(&bytes, |tag, _| *tag = *b"ELSE");
        let old = PackedScene::from_bytes(&renamed).unwrap();
        assert_eq!(old.normals(), Normals::Faces);
        assert!(words(&old) == words(&smooth));
        let other = with_section(&bytes, |_, bits| bits[0] = 9);
        assert!(PackedScene::from_bytes(&other).unwrap_err().to_string().contains("another kind"));
        // A file that says that there are normals where there are none.
        ball().save(&path).unwrap();
        let without = PackedScene::open(&path).unwrap();
        let claims = Geometry { has_normals: true, ..Geometry::clone(without.geometry()) };
        assert!(claims.validate().is_err());
    }

    /// A file whose section NORM is changed, with checksums that fit.
    fn with_section(bytes: &[u8], change: impl Fn(&mut [u8; 4], &mut [u8])) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        let mut header: Header = bytemuck::pod_read_unaligned(&bytes[..size_of::<Header>()]);
        let table = size_of::<Header>()..size_of::<Header>() + header.section_count as usize * size_of::<TableEntry>();
        let mut entries: Vec<TableEntry> =
            bytes[table.clone()].chunks_exact(size_of::<TableEntry>()).map(bytemuck::pod_read_unaligned).collect();
        let entry = entries.iter_mut().find(|entry| entry.tag == *b"NORM").unwrap();
        let section = &mut bytes[entry.offset as usize..][..entry.size as usize];
        change(&mut entry.tag, section);
        entry.checksum = xxh3_64(section);
        bytes[table.clone()].copy_from_slice(bytemuck::cast_slice(&entries));
        header.table_checksum = xxh3_64(&bytes[table]);
        bytes[..size_of::<Header>()].copy_from_slice(bytemuck::bytes_of(&header));
        bytes
    }

    #[test]
    fn merged_instances_have_normals_together_and_keep_them_apart() {
        let scene = balls(&[IVec3::ZERO, IVec3::new(40, 3, 1)]);
        let merged = PackedScene::pack_merged(&scene).unwrap().with_normals(Normals::Smooth).unwrap();
        assert!(merged.is_merged());
        merged.validate().unwrap();
        let apart = PackedScene::pack(&scene).unwrap().with_normals(Normals::Smooth).unwrap();
        assert!(words(&merged.split()) == words(&apart) && merged.split().normals() == Normals::Smooth);
        // Coarse cells lie elsewhere in the voxels of what is moved, so that the last bits may be others.
        let along = |scene: &PackedScene, voxel: IVec3| {
            let code = scene.geometry.normal_at(&scene.grids()[0], voxel).unwrap();
            decode(code).along.as_vec3().normalize()
        };
        for voxel in [IVec3::new(6, 6, 6), IVec3::new(-10, 1, 2)] {
            let own = along(&apart, voxel);
            for place in [IVec3::ZERO, IVec3::new(40, 3, 1)] {
                assert!(along(&merged, voxel + place).dot(own) > 0.999, "{voxel} {place}");
            }
            assert!(
                along(&merged, voxel + IVec3::new(40, 3, 1)).dot(along(&apart, -voxel)) < 0.0,
                "the comparison sees turns"
            );
        }
    }

    #[test]
    fn a_ground_keeps_its_faces_and_the_scene_its_normals() {
        let smooth = ball().with_normals(Normals::Smooth).unwrap();
        let ground = Ground { height: None, color: Vec3::ONE };
        let on_ground = smooth.with_surroundings(Some(&ground), None).unwrap();
        on_ground.validate().unwrap();
        assert_eq!(on_ground.normals(), Normals::Smooth);
        let of_ball = |scene: &PackedScene, x: i32| scene.geometry.normal_at(&scene.grids()[0], IVec3::new(x, 0, 0));
        for x in -11..11 {
            assert_eq!(of_ball(&on_ground, x), of_ball(&smooth, x), "{x}");
        }
        let grid = &on_ground.grids()[1];
        assert_eq!(on_ground.geometry.normal_at(grid, grid.min), Some(NO_NORMAL));
    }
}
