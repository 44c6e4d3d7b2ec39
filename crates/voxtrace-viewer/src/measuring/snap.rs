//! Where on the voxel under the cursor a point is put: on its face, an edge, a corner, the middle of the face or of the voxel. On the face of
//! a cut the polygon in which the plane meets the voxel takes the place of the face.

use crate::projection::Projection;
use voxtrace::glam::{DVec3, IVec3, Vec2, Vec3};
use voxtrace::{Hit, PackedScene, Ray};

/// Pixels from which a corner or a middle draws the point to itself.
const CORNER_PIXELS: f32 = 10.0;
/// The same of an edge.
const EDGE_PIXELS: f32 = 7.0;

/// What a point snaps to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Snap {
    /// Whatever of corner, middle of the face and edge is near in the picture, else nothing.
    #[default]
    Auto,
    /// Where the ray meets the face.
    Face,
    /// The nearest point of an edge.
    Edge,
    /// The nearest corner.
    Corner,
    /// The middle of the face.
    FaceCentre,
    /// The middle of the voxel.
    VoxelCentre,
}

impl Snap {
    /// All of them, in the order of lists.
    pub const ALL: [Self; 6] = [Self::Auto, Self::Face, Self::Edge, Self::Corner, Self::FaceCentre, Self::VoxelCentre];
}

/// A point of the scene under the cursor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapped {
    /// World space, voxels.
    pub point: DVec3,
    /// What it lies on; never [`Snap::Auto`].
    pub on: Snap,
    /// The voxel.
    pub hit: Hit,
}

/// The point that a hit of `ray` is taken for. `cursor` and `projection` say how near in the picture things are.
pub fn snapped(scene: &PackedScene, ray: &Ray, hit: Hit, snap: Snap, projection: &Projection, cursor: Vec2) -> Snapped {
    let (polygon, met) = (outline(scene, &hit), ray.at(hit.t).as_dvec3());
    let at = |point: DVec3, on| Snapped { point, on, hit };
    let free = at(met, Snap::Face);
    let voxel_centre = || {
        let instance = scene.instance(&hit);
        at(instance.world_from_grid.point(hit.voxel.as_vec3() + 0.5).as_dvec3(), Snap::VoxelCentre)
    };
    if snap == Snap::VoxelCentre {
        return voxel_centre();
    }
    if polygon.len() < 3 {
        return free;
    }
    let centre = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
    let nearest = |points: &mut dyn Iterator<Item = DVec3>| {
        points.min_by(|a, b| a.distance_squared(met).total_cmp(&b.distance_squared(met))).unwrap_or(met)
    };
    let corner = nearest(&mut polygon.iter().copied());
    let sides = (0..polygon.len()).map(|index| (polygon[index], polygon[(index + 1) % polygon.len()]));
    let edge = nearest(&mut sides.map(|(from, to)| on_line(from, to, met)));
    let pixels = |point: DVec3| projection.place(point.as_vec3()).map_or(f32::INFINITY, |place| place.distance(cursor));
    match snap {
        Snap::Face => free,
        Snap::Edge => at(edge, Snap::Edge),
        Snap::Corner => at(corner, Snap::Corner),
        Snap::FaceCentre => at(centre, Snap::FaceCentre),
        _ if pixels(corner) <= CORNER_PIXELS => at(corner, Snap::Corner),
        _ if pixels(centre) <= CORNER_PIXELS => at(centre, Snap::FaceCentre),
        _ if pixels(edge) <= EDGE_PIXELS => at(edge, Snap::Edge),
        _ => free,
    }
}

fn on_line(from: DVec3, to: DVec3, point: DVec3) -> DVec3 {
    let along = to - from;
    from + along * ((point - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
}

/// Corners of what a hit met, in order around it, world space.
pub fn outline(scene: &PackedScene, hit: &Hit) -> Vec<DVec3> {
    let instance = scene.instance(hit);
    let world = |corner: IVec3| instance.world_from_grid.point((hit.voxel + corner).as_vec3()).as_dvec3();
    let Some(plane) = hit.cut().and_then(|index| scene.cuts.planes().get(index)) else {
        let (face, axis) = (hit.face(), hit.face().axis());
        return [(0, 0), (1, 0), (1, 1), (0, 1)]
            .map(|(u, v)| {
                let mut corner = IVec3::ZERO;
                corner[axis] = face as i32 & 1;
                (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (u, v);
                world(corner)
            })
            .to_vec();
    };
    // Planes cut a little before themselves; what is measured lies on the plane that somebody chose.
    let (normal, edge) = (plane.normal().as_dvec3(), f64::from(plane.edge()));
    let shift = normal * (f64::from(plane.offset()) - edge);
    let corner = |number: i32| IVec3::new(number & 1, number >> 1 & 1, number >> 2);
    let pairs = (0..8)
        .flat_map(|from| [1, 2, 4].into_iter().filter(move |bit| from & bit == 0).map(move |bit| (from, from | bit)));
    let met = pairs.filter_map(|(from, to)| {
        let (from, to) = (world(corner(from)), world(corner(to)));
        let (a, b) = (normal.dot(from) - edge, normal.dot(to) - edge);
        ((a <= 0.0) != (b <= 0.0)).then(|| from + (to - from) * (a / (a - b)) + shift)
    });
    around(met.collect(), plane.normal())
}

/// Points of a convex polygon in order around their middle.
fn around(mut points: Vec<DVec3>, normal: Vec3) -> Vec<DVec3> {
    let middle = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    let x = normal.any_orthogonal_vector().as_dvec3();
    let y = normal.as_dvec3().cross(x);
    let angle = |point: &DVec3| (*point - middle).dot(y).atan2((*point - middle).dot(x));
    points.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    points
}
