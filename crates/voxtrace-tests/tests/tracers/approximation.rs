//! The claims of `docs/approximation.md`: when the nearest-centre rule finds the first voxel, and when it does not.

use voxtrace::glam::{DVec3, IVec3, Mat3, Vec2, Vec3};
use voxtrace::{Hit, Instance, Material, PackedScene, Ray, Scene, Transform, VoxelGrid, scenes};
use voxtrace_core::nearest_centre::{cast_batch, centre_distance};
use voxtrace_core::walk;
use voxtrace_tests::random::Random;
use voxtrace_tests::scenes::noise;

fn packed(grid: VoxelGrid) -> PackedScene {
    let largest = grid.voxels().map(|(_, material)| material).max().unwrap_or(0);
    let materials = vec![Material::default(); usize::from(largest) + 1];
    PackedScene::pack(&Scene::from_grid("test", grid, materials)).unwrap()
}

/// Where a ray is inside a box, in double precision: it enters before it leaves, and leaves after its start.
fn inside(ray: &Ray, low: DVec3, high: DVec3) -> Option<(f64, f64)> {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (a, b) = ((low - origin) / direction, (high - origin) / direction);
    let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
    (enter < leave && leave > 0.0).then_some((enter, leave))
}

/// Voxels whose box, larger by `margin`, the ray meets, and their distance by `rule`; the nearest of them.
fn nearest(voxels: &[IVec3], ray: &Ray, margin: f64, rule: impl Fn(DVec3) -> DVec3) -> Option<IVec3> {
    let met = voxels.iter().filter(|voxel| {
        let low = voxel.as_dvec3();
        inside(ray, low - margin, low + 1.0 + margin).is_some()
    });
    let distance = |voxel: &IVec3| (rule(voxel.as_dvec3()) - ray.origin.as_dvec3()).length();
    met.copied().min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

fn centre(low: DVec3) -> DVec3 {
    low + 0.5
}

/// A noisy block and rays through it: from outside and, every fourth, from inside.
fn block_and_rays(count: usize) -> (Vec<IVec3>, PackedScene, Vec<Ray>) {
    let grid = noise(IVec3::ZERO, 9, 0.4, 3, 5);
    let voxels: Vec<IVec3> = grid.voxels().map(|(voxel, _)| voxel).collect();
    let mut random = Random(3);
    let rays = (0..count)
        .map(|index| match index % 4 {
            0 => Ray::new(random.point(Vec3::ZERO, Vec3::splat(9.0)), random.direction()),
            _ => {
                let from = random.direction() * 40.0 + 4.5;
                Ray::new(from, (random.point(Vec3::ZERO, Vec3::splat(9.0)) - from).normalize())
            }
        })
        .collect();
    (voxels, packed(grid), rays)
}

fn differing(a: &[Hit], b: &[Hit]) -> usize {
    a.iter().zip(b).filter(|(a, b)| (a.instance, a.voxel) != (b.instance, b.voxel)).count()
}

#[test]
fn of_voxels_that_a_ray_meets_the_first_has_the_nearest_centre() {
    let (voxels, scene, rays) = block_and_rays(20_000);
    for ray in &rays {
        let hit = walk::cast(&scene, ray);
        let found = nearest(&voxels, ray, 0.0, centre);
        assert_eq!(found, (!hit.is_miss()).then_some(hit.voxel), "{ray:?}");
    }
    // Planted: the centre's far side instead of the centre.
    let wrong = |ray: &Ray| nearest(&voxels, ray, 0.0, |low| low + 0.5 - 3.0 * ray.direction.as_dvec3().signum());
    let count =
        rays.iter().filter(|ray| wrong(ray).is_some_and(|voxel| voxel != walk::cast(&scene, ray).voxel)).count();
    assert!(count > 100, "{count}");
}

#[test]
fn without_a_margin_the_emulation_is_the_exact_walk() {
    let (_, scene, rays) = block_and_rays(4_000);
    let mut hits = vec![Hit::MISS; rays.len()];
    cast_batch(&scene, &rays, 0.0, &mut hits);
    let exact: Vec<Hit> = rays.iter().map(|ray| walk::cast(&scene, ray)).collect();
    assert_eq!(hits, exact);
}

#[test]
fn a_box_that_the_ray_misses_by_a_little_wins_with_a_nearer_centre() {
    let grid = {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::new(5, 0, 0), 0);
        grid.set(IVec3::new(4, 1, 0), 0);
        grid
    };
    let scene = packed(grid);
    // Passes 1/200 of a voxel below the second voxel, and meets the first.
    let ray = Ray::new(Vec3::new(-3.0, 0.995, 0.5), Vec3::X);
    let cast = |margin| {
        let mut hits = [Hit::MISS];
        cast_batch(&scene, &[ray], margin, &mut hits);
        hits[0].voxel
    };
    assert_eq!(cast(0.0), IVec3::new(5, 0, 0));
    assert_eq!(cast(1.0 / 512.0), IVec3::new(5, 0, 0));
    assert_eq!(cast(1.0 / 128.0), IVec3::new(4, 1, 0));
    // Beyond the silhouette a voxel appears where there is none on the way.
    let beside = Ray::new(Vec3::new(-3.0, -0.001, 0.5), Vec3::X);
    let mut hits = [Hit::MISS];
    cast_batch(&scene, &[beside], 1.0 / 128.0, &mut hits);
    assert!(walk::cast(&scene, &beside).is_miss() && !hits[0].is_miss());
}

#[test]
fn the_emulation_finds_what_a_search_through_all_boxes_finds() {
    let (voxels, scene, rays) = block_and_rays(20_000);
    for margin in [1.0 / 512.0, 1.0 / 64.0] {
        let mut hits = vec![Hit::MISS; rays.len()];
        cast_batch(&scene, &rays, margin, &mut hits);
        let found = |ray: &Ray| nearest(&voxels, ray, margin.into(), centre);
        let other =
            rays.iter().zip(&hits).filter(|(ray, hit)| found(ray) != (!hit.is_miss()).then_some(hit.voxel)).count();
        let wrong = rays
            .iter()
            .filter(|ray| {
                found(ray) != {
                    let hit = walk::cast(&scene, ray);
                    (!hit.is_miss()).then_some(hit.voxel)
                }
            })
            .count();
        assert!(wrong > 20 && other * 20 <= wrong, "{margin}: {other} differ, {wrong} wrong");
    }
}

#[test]
fn the_larger_the_margin_the_more_voxels_are_wrong() {
    let scene = PackedScene::pack(&scenes::generate("city", Some(150_000)).unwrap()).unwrap();
    let camera = scene.cameras[0].frame(320, 180);
    let rays: Vec<Ray> =
        (0..320 * 180).map(|i| camera.central_ray(Vec2::new((i % 320) as f32 + 0.5, (i / 320) as f32 + 0.5))).collect();
    let exact: Vec<Hit> = rays.iter().map(|ray| walk::cast(&scene, ray)).collect();
    let wrong = [0.0, 1.0 / 512.0, 1.0 / 128.0, 1.0 / 32.0].map(|margin| {
        let mut hits = vec![Hit::MISS; rays.len()];
        cast_batch(&scene, &rays, margin, &mut hits);
        differing(&hits, &exact)
    });
    assert_eq!(wrong[0], 0);
    assert!(wrong[1] > 50 && wrong[2] > 3 * wrong[1] && wrong[3] > 3 * wrong[2], "{wrong:?}");
}

#[test]
fn a_merged_box_hides_voxels_unless_the_voxel_is_found_by_position() {
    // A driver makes one box of two voxels and says the number of the first.
    let (first, second) = (IVec3::ZERO, IVec3::X);
    let merged = (DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0));
    let ray = Ray::new(Vec3::new(1.5, 0.5, 9.0), Vec3::NEG_Z);
    assert!(inside(&ray, merged.0, merged.1).is_some());
    // The approximate rule believes it: the wrong voxel. The exact test does not: a hole.
    assert!(inside(&ray, first.as_dvec3(), first.as_dvec3() + 1.0).is_none());
    // Walking the box finds the right one.
    let grid = {
        let mut grid = VoxelGrid::new();
        grid.set(first, 0);
        grid.set(second, 0);
        grid
    };
    assert_eq!(walk::cast(&packed(grid), &ray).voxel, second);
}

#[test]
fn voxels_of_different_sizes_are_ordered_wrongly_although_both_are_met() {
    let one = || {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        grid
    };
    let mut scene = Scene::from_grid("two sizes", one(), vec![Material::default()]);
    let small = Transform::from_translation(Vec3::new(8.0, 0.0, 0.0));
    let large = Transform { linear: Mat3::from_diagonal(Vec3::splat(8.0)), translation: Vec3::ZERO };
    scene.instances = vec![Instance::new(0, large), Instance::new(0, small)];
    let scene = PackedScene::pack(&scene).unwrap();
    // Cuts the corner of the large voxel and goes on into the small one behind it.
    let ray = Ray::new(Vec3::new(6.9, -1.0, 0.5), Vec3::new(1.0, 1.0, 0.0).normalize());
    let first = walk::cast(&scene, &ray);
    assert_eq!(first.instance, 0);
    let behind = Hit { instance: 1, ..first };
    assert!(inside(&ray, DVec3::new(8.0, 0.0, 0.0), DVec3::new(9.0, 1.0, 1.0)).is_some());
    assert!(centre_distance(&scene, &ray, &behind) < centre_distance(&scene, &ray, &first));
}

#[test]
fn the_lowest_corner_orders_neighbours_wrongly_where_the_ray_starts_beside_them() {
    let (voxels, scene, rays) = block_and_rays(40_000);
    let corner = |low: DVec3| low;
    let mut wrong = 0;
    for ray in &rays {
        let hit = walk::cast(&scene, ray);
        let Some(found) = nearest(&voxels, ray, 0.0, corner) else { continue };
        if found == hit.voxel {
            continue;
        }
        wrong += 1;
        // A neighbour wins that lies one row higher along an axis in whose row the ray starts, beyond the middle.
        let step = found - hit.voxel;
        let place = ray.origin - hit.voxel.as_vec3();
        let is_beside = |axis: usize| step[axis] == 1 && place[axis] > 0.5 && place[axis] <= 1.0;
        assert!((0..3).any(is_beside), "{ray:?} {step}");
    }
    assert!(wrong > 20, "{wrong}");
    // From a place outside all rows, in front and beside the block, it is right.
    let mut random = Random(9);
    for _ in 0..20_000 {
        let from = random.point(Vec3::splat(-40.0), Vec3::splat(-1.0));
        let ray = Ray::new(from, (random.point(Vec3::ZERO, Vec3::splat(9.0)) - from).normalize());
        let hit = walk::cast(&scene, &ray);
        assert_eq!(nearest(&voxels, &ray, 0.0, corner), (!hit.is_miss()).then_some(hit.voxel));
    }
}

/// The table of `docs/approximation.md`, there for the whole scenes: the share grows in proportion to the margin.
#[test]
fn the_share_of_wrong_voxels_grows_with_the_margin_in_the_built_in_scenes() {
    let (width, height) = (396, 216);
    for name in scenes::STUDY_NAMES {
        let scene = PackedScene::pack(&scenes::generate(name, Some(200_000)).unwrap()).unwrap();
        let camera = scene.cameras[0].frame(width, height);
        let middle = |i: u32| Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        let rays: Vec<Ray> = (0..width * height).map(|i| camera.central_ray(middle(i))).collect();
        let mut exact = vec![Hit::MISS; rays.len()];
        walk::cast_batch(&scene, &rays, &mut exact);
        let shares = [512.0, 128.0, 32.0].map(|size| {
            let mut hits = vec![Hit::MISS; rays.len()];
            cast_batch(&scene, &rays, 1.0 / size, &mut hits);
            differing(&hits, &exact) as f64 / rays.len() as f64
        });
        println!("{name}: {shares:.5?}");
        for pair in shares.windows(2) {
            let growth = pair[1] / pair[0];
            assert!((3.0..5.0).contains(&growth), "{name}: {growth} for a margin four times as large");
        }
    }
}
