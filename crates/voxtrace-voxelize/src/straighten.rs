//! Straightening: instances that are tilted against the lattice of the world, as oblique scans are, are turned to the nearest way to stand on
//! it. No voxel is sampled anew; the georeference tells where they were.

use glam::{DAffine3, DMat3, DVec3, Mat3};
use voxtrace_core::packed::Lattice;
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;

/// Turns every tilted instance, hidden ones too, to the nearest quarter turn or mirror about the middle of its voxels, which move by less than
/// a voxel besides. Its scale stays, and what moves keeps its first frame. Returns how many there were. Where all are turned alike, as the
/// one instance of a scan is, the scene's georeference is turned with them; else it is dropped.
pub fn straighten(scene: &mut Scene) -> usize {
    let mut straightened = 0;
    let mut old_from_new = Vec::new();
    for instance in &mut scene.instances {
        let old = instance.world_from_grid;
        let is_on_lattice = |placed: &Transform| Lattice::of(placed).is_some();
        if is_on_lattice(&old) && instance.keyframes.iter().all(|key| is_on_lattice(&key.world_from_grid)) {
            old_from_new.push(DAffine3::IDENTITY);
            continue;
        }
        let bounds = scene.grids[instance.grid].bounds();
        let middle = bounds.map_or(DVec3::ZERO, |bounds| (bounds.min + bounds.max).as_dvec3() * 0.5);
        let new = straight(&old, middle);
        instance.world_from_grid = new;
        instance.keyframes.clear();
        straightened += 1;
        old_from_new.push(affine(&old) * affine(&new).inverse());
    }
    if straightened > 0 {
        let first = old_from_new[0];
        let is_alike = old_from_new.iter().all(|other| other.abs_diff_eq(first, 1e-4));
        scene.georeference = scene
            .georeference
            .take()
            .filter(|_| is_alike)
            .map(|place| Georeference { coordinates_from_world: place.coordinates_from_world * first, ..place });
        scene.attachments.clear();
        scene.clips.clear();
    }
    straightened
}

fn affine(transform: &Transform) -> DAffine3 {
    DAffine3 { matrix3: transform.linear.as_dmat3(), translation: transform.translation.as_dvec3() }
}

/// The nearest placement whose axes are those of the world, with `middle`, a point of the grid, where it was but for less than a voxel.
fn straight(placed: &Transform, middle: DVec3) -> Transform {
    let scale = placed.scale();
    let axes = nearest_axes(&placed.linear.as_dmat3());
    // A scale that is 1 but for rounding would take voxels off the lattice.
    let scale = if (scale - 1.0).abs() < 1e-4 { 1.0 } else { scale };
    let linear = axes * scale;
    let corner = affine(placed).transform_point3(middle) - linear.as_dmat3() * middle;
    Transform { linear, translation: corner.round().as_vec3() }
}

/// The signed permutation whose columns are nearest to those of a matrix.
fn nearest_axes(linear: &DMat3) -> Mat3 {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let fit = |order: &[usize; 3]| (0..3).map(|column| linear.col(column)[order[column]].abs()).sum::<f64>();
    let mut best = ORDERS[0];
    for order in ORDERS {
        if fit(&order) > fit(&best) + 1e-9 {
            best = order;
        }
    }
    let mut columns = [[0.0; 3]; 3];
    for (column, along) in best.into_iter().enumerate() {
        columns[column][along] = if linear.col(column)[along] < 0.0 { -1.0 } else { 1.0 };
    }
    Mat3::from_cols_array_2d(&columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{IVec3, Quat, Vec3};
    use voxtrace_scene::Material;
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::transform::Axis;

    fn scan(world_from_grid: Transform) -> Scene {
        let mut grid = VoxelGrid::new();
        for i in 0..1000 {
            grid.set(IVec3::new(i % 10, i / 10 % 10, i / 100) + 20, 0);
        }
        let mut scene = Scene::from_grid("scan", grid, vec![Material::default()]);
        scene.instances[0].world_from_grid = world_from_grid;
        scene.georeference = Some(Georeference::of_grid(DVec3::new(500.0, -20.0, 3.0), 0.7, "scanner"));
        scene
    }

    #[test]
    fn a_tilted_scan_stands_on_the_lattice_near_where_it_was_and_keeps_its_coordinates() {
        let tilts = [(Vec3::X, 17.0), (Vec3::new(1.0, 2.0, 0.5), -31.0), (Vec3::Z, 44.0)];
        for (about, degrees) in tilts {
            for turns in 0..4 {
                let tilt = Quat::from_axis_angle(about.normalize(), f32::to_radians(degrees));
                let turned = Transform::from_rotation(tilt).after(&Transform::from_quarter_turns(Axis::Y, turns));
                let old = turned.translated(Vec3::new(0.3, 7.8, -40.4));
                let mut scene = scan(old);
                let before = scene.georeference.clone().unwrap();
                assert_eq!(straighten(&mut scene), 1);
                let new = scene.instances[0].world_from_grid;
                assert!(Lattice::of(&new).is_some(), "{new:?}");
                assert_eq!(new.linear, Transform::from_quarter_turns(Axis::Y, turns).linear);
                let middle = Vec3::splat(25.0);
                assert!(new.point(middle).distance(old.point(middle)) < 0.9, "{new:?}");
                let after = scene.georeference.unwrap();
                for voxel in [Vec3::ZERO, Vec3::new(20.0, 29.0, 24.5)] {
                    let place = |place: &Georeference, world: Vec3| {
                        place.coordinates_from_world.transform_point3(world.as_dvec3())
                    };
                    let error = place(&before, old.point(voxel)).distance(place(&after, new.point(voxel)));
                    assert!(error < 1e-4, "{error}");
                    // Without the turn the coordinates would be others.
                    assert!(place(&before, old.point(voxel)).distance(place(&before, new.point(voxel))) > 0.1);
                }
            }
        }
    }

    #[test]
    fn what_is_straight_stays_and_instances_turned_apart_lose_their_coordinates() {
        let mut straight = scan(Transform::from_quarter_turns(Axis::Z, 1));
        let before = straight.clone();
        assert_eq!((straighten(&mut straight), straight), (0, before));
        let mut two = scan(Transform::from_rotation(Quat::from_rotation_z(0.3)).scaled(2.0));
        two.add_instance(VoxelGrid::new(), Transform::IDENTITY);
        assert_eq!(straighten(&mut two), 1);
        assert_eq!(two.georeference, None);
        assert!((two.instances[0].world_from_grid.scale() - 2.0).abs() < 1e-6);
    }
}
