//! Edits of regions give the grid that setting voxel by voxel gives.

use voxtrace::{
    VoxelGrid,
    glam::{DVec3, IVec3},
    grid::VoxelBox,
};

/// Random numbers that are the same on every run.
struct Random(u64);

impl Random {
    /// A number in `from..to`.
    fn between(&mut self, from: i32, to: i32) -> i32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + ((self.0 >> 33) % (to - from) as u64) as i32
    }

    fn voxel(&mut self, from: i32, to: i32) -> IVec3 {
        IVec3::new(self.between(from, to), self.between(from, to), self.between(from, to))
    }

    /// A box within ±24; one in six is empty or inside out along an axis.
    fn region(&mut self) -> VoxelBox {
        let min = self.voxel(-24, 20);
        let size = self.voxel(0, 26);
        let aligned = self.between(0, 3) == 0;
        let (min, size) = if aligned { (min >> 3 << 3, size >> 3 << 3) } else { (min, size) };
        VoxelBox { min, max: min + size - IVec3::new(0, 0, i32::from(self.between(0, 9) == 0)) }
    }

    fn grid(&mut self) -> VoxelGrid {
        let mut grid = VoxelGrid::new();
        for _ in 0..4_000 {
            grid.set(self.voxel(-24, 24), self.between(0, 300) as u16);
        }
        grid
    }
}

fn voxels_in(region: VoxelBox) -> impl Iterator<Item = IVec3> {
    let VoxelBox { min, max } = region;
    (min.z..max.z).flat_map(move |z| (min.y..max.y).flat_map(move |y| (min.x..max.x).map(move |x| IVec3::new(x, y, z))))
}

#[test]
fn filling_a_box_sets_its_voxels() {
    let mut random = Random(1);
    for _ in 0..60 {
        let (mut fast, region) = (random.grid(), random.region());
        let mut slow = fast.clone();
        voxels_in(region).for_each(|voxel| _ = slow.set(voxel, 7));
        fast.fill_box(region, 7);
        assert_eq!(fast, slow, "{region:?}");
        if slow.clear(region.max - 1).is_some() {
            assert_ne!(fast, slow, "one voxel less must show");
        }
    }
}

#[test]
fn clearing_a_box_empties_its_voxels_and_leaves_no_empty_brick() {
    let mut random = Random(2);
    for _ in 0..60 {
        let (mut fast, region) = (random.grid(), random.region());
        let mut slow = fast.clone();
        voxels_in(region).for_each(|voxel| _ = slow.clear(voxel));
        fast.clear_box(region);
        assert_eq!(fast, slow, "{region:?}");
    }
    let mut grid = random.grid();
    grid.clear_box(VoxelBox { min: IVec3::MIN, max: IVec3::MAX });
    assert!(grid.is_empty());
}

#[test]
fn filling_a_sphere_sets_the_voxels_whose_centers_lie_inside() {
    let mut random = Random(3);
    for _ in 0..40 {
        let mut fast = random.grid();
        let mut slow = fast.clone();
        let center = random.voxel(-100, 100).as_dvec3() / 8.0;
        let radius = f64::from(random.between(-4, 100)) / 8.0;
        let near = VoxelBox { min: IVec3::splat(-30), max: IVec3::splat(30) };
        for voxel in voxels_in(near) {
            if radius >= 0.0 && (voxel.as_dvec3() + 0.5 - center).length_squared() <= radius * radius {
                slow.set(voxel, 9);
            }
        }
        fast.fill_sphere(center, radius, 9);
        assert_eq!(fast, slow, "{center} {radius}");
    }
}

#[test]
fn clearing_a_sphere_empties_the_voxels_whose_centers_lie_inside() {
    let mut random = Random(5);
    for _ in 0..40 {
        let mut fast = random.grid();
        let mut slow = fast.clone();
        let center = random.voxel(-100, 100).as_dvec3() / 8.0;
        let radius = f64::from(random.between(-4, 100)) / 8.0;
        let near = VoxelBox { min: IVec3::splat(-30), max: IVec3::splat(30) };
        for voxel in voxels_in(near) {
            if radius >= 0.0 && (voxel.as_dvec3() + 0.5 - center).length_squared() <= radius * radius {
                slow.clear(voxel);
            }
        }
        fast.clear_sphere(center, radius);
        assert_eq!(fast, slow, "{center} {radius}");
    }
    let mut grid = random.grid();
    grid.set(IVec3::new(30, 0, 0), 1);
    grid.clear_sphere(DVec3::ZERO, 29.0);
    assert!(!grid.is_empty(), "a voxel outside stays");
    grid.clear_sphere(DVec3::ZERO, 1e12);
    assert!(grid.is_empty());
}

#[test]
fn a_large_sphere_has_its_volume() {
    let mut grid = VoxelGrid::new();
    grid.fill_sphere(DVec3::new(0.25, -0.5, 300.0), 100.0, 1);
    let volume = 4.0 / 3.0 * std::f64::consts::PI * 1e6;
    assert!((grid.count() as f64 / volume - 1.0).abs() < 1e-3, "{}", grid.count());
}

#[test]
fn copying_a_region_sets_and_clears_as_the_source_does() {
    let mut random = Random(4);
    for round in 0..80 {
        let (source, mut fast, region) = (random.grid(), random.grid(), random.region());
        let mut slow = fast.clone();
        // Every fourth copy moves by whole bricks.
        let shift = if round % 4 == 0 { random.voxel(-3, 3) * 8 } else { random.voxel(-20, 20) };
        for voxel in voxels_in(region) {
            match source.get(voxel) {
                Some(material) => slow.set(voxel + shift, material),
                None => slow.clear(voxel + shift),
            };
        }
        fast.copy_region(&source, region, region.min + shift);
        assert_eq!(fast, slow, "{region:?} by {shift}");
    }
}

#[test]
#[should_panic(expected = "out of range")]
fn a_box_beyond_the_largest_coordinate_is_refused() {
    VoxelGrid::new().fill_box(VoxelBox { min: IVec3::splat(1 << 20), max: IVec3::splat((1 << 20) + 1) }, 0);
}
