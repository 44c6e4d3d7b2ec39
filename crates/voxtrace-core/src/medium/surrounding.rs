//! The medium around all else, as fog is: what stands in it is a scene of its own, in which rays are traced together.

use super::Inside;
use super::walk::WayOut;
use crate::cuts::Span;
use crate::packed::PackedScene;
use crate::walk::{self, WalkCounts};
use voxtrace_scene::ray::{Hit, Ray};

/// An instance of a medium that comes after all others, as that of fog does: what they hold is never in it.
pub struct Surrounding {
    instance: u32,
    /// The others.
    others: PackedScene,
}

impl Surrounding {
    /// That of a scene, if it has one.
    pub fn of(scene: &PackedScene) -> Option<Self> {
        let last = scene.placement.instances.len().checked_sub(1).filter(|&last| last > 0)?;
        let placed = &scene.placement.instances[last];
        let grid = &scene.geometry.grids[placed.grid as usize];
        let material = scene.geometry.material_at(grid, grid.min)?;
        let is_medium = scene.geometry.materials[material as usize].transmission > 0.0;
        is_medium.then(|| Self { instance: last as u32, others: scene.with_first(last) })
    }

    /// Whether this is what something is in.
    #[inline]
    pub fn is_around(&self, inside: &Inside) -> bool {
        inside.instance == self.instance
    }
}

/// Rays in such a medium.
#[derive(Default)]
pub struct RaysWithin {
    segments: Vec<Segment>,
    before: Vec<Ray>,
    hits: Vec<Hit>,
}

struct Segment {
    place: usize,
    ray: Ray,
    span: Span,
    inside: Inside,
    way: WayOut,
}

impl RaysWithin {
    /// Takes another ray, whose hit belongs to `place`.
    pub fn push(&mut self, scene: &PackedScene, place: usize, ray: &Ray, inside: &Inside, is_clipped: bool) {
        let span = scene.cuts.span_of(ray, is_clipped);
        let way = WayOut::of(scene, &span.up_to_its_end(ray), inside);
        self.before.push(way.before);
        self.segments.push(Segment { place, ray: *ray, span, inside: *inside, way });
    }

    /// Finds what [`crate::cuts::cast_inside`] finds for each of them, and forgets them.
    pub fn cast(&mut self, scene: &PackedScene, surrounding: &Surrounding, hits: &mut [Hit]) -> WalkCounts {
        self.hits.resize(self.before.len(), Hit::MISS);
        let counts = walk::cast_batch_whole(&surrounding.others, &self.before, &mut self.hits);
        for (Segment { place, ray, span, inside, way }, lower) in self.segments.iter().zip(&self.hits) {
            let hit = way.met(scene, &span.up_to_its_end(ray), inside, *lower);
            hits[*place] = span.left(hit, ray.t_min, ray.t_max, inside);
        }
        self.segments.clear();
        self.before.clear();
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cuts::{self, Cuts};
    use crate::surroundings::{Fog, Ground};
    use crate::{CpuTracer, Film, Frame, Placement, Progress, Tracer};
    use glam::{IVec3, Mat3, Vec3};
    use std::sync::Arc;
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::scene::Scene;
    use voxtrace_scene::transform::Transform;

    /// Grains, glass among them, turned ones among them, on a ground in fog.
    fn scene() -> PackedScene {
        let mut grid = VoxelGrid::new();
        for index in 0..400_i32 {
            let at = IVec3::new(index * 37 % 23, index * 71 % 29, index * 113 % 31);
            grid.set(at, (index % 2) as u16);
        }
        let materials = vec![Material::diffuse(Vec3::ONE), Material::glass(1.5, 0.0)];
        let mut scene = Scene::from_grid("grains", grid.clone(), materials);
        scene.add_instance(
            grid,
            Transform { linear: Mat3::from_rotation_z(0.7), translation: Vec3::new(9.0, -4.0, 2.0) },
        );
        let (ground, fog) =
            (Ground { height: None, color: Vec3::ONE }, Fog { density: 0.05, color: Vec3::ONE, anisotropy: 0.0 });
        PackedScene::pack(&scene).unwrap().with_surroundings(Some(&ground), Some(&fog)).unwrap()
    }

    /// Rays in the fog, with what they are in, whether they are clipped, and what [`cuts::cast_inside`] finds.
    fn rays(scene: &PackedScene, surrounding: &Surrounding) -> Vec<(Ray, Inside, bool, Hit)> {
        let number = |index: u32, of: u32| {
            let mixed = (index * 8 + of).wrapping_mul(0x9e37_79b9);
            ((mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca6b) >> 8) as f32 / (1 << 24) as f32
        };
        let vector = |index: u32, of: u32| Vec3::new(number(index, of), number(index, of + 1), number(index, of + 2));
        let ray = |index: u32| {
            let direction = vector(index, 3) - 0.5;
            let t_max = if index.is_multiple_of(3) { f32::INFINITY } else { 300.0 * number(index, 6) };
            Ray { t_max, ..Ray::new(vector(index, 0) * 50.0 - 10.0, direction) }
        };
        let rays = (0..4000).map(ray).filter_map(|ray| {
            let inside = scene.medium_at(ray.origin).filter(|inside| surrounding.is_around(inside))?;
            let is_clipped = ray.direction.x > 0.0;
            Some((ray, inside, is_clipped, cuts::cast_inside(scene, &ray, &inside, is_clipped)))
        });
        rays.collect()
    }

    fn together(scene: &PackedScene, surrounding: &Surrounding, rays: &[(Ray, Inside, bool, Hit)]) -> Vec<Hit> {
        let (mut within, mut hits) = (RaysWithin::default(), vec![Hit::MISS; rays.len()]);
        for (place, (ray, inside, is_clipped, _)) in rays.iter().enumerate() {
            within.push(scene, place, ray, inside, *is_clipped);
        }
        within.cast(scene, surrounding, &mut hits);
        hits
    }

    #[test]
    fn rays_in_fog_meet_together_what_they_meet_one_after_the_other() {
        let mut scene = scene();
        let cut = Cuts::default().plane(Vec3::new(1.0, 0.3, 0.0), 12.0).unwrap();
        for cuts in [Cuts::default(), cut] {
            scene.cuts = cuts;
            let surrounding = Surrounding::of(&scene).unwrap();
            let rays = rays(&scene, &surrounding);
            let wanted: Vec<Hit> = rays.iter().map(|(.., hit)| *hit).collect();
            let count = |holds: fn(&&Hit) -> bool| wanted.iter().filter(holds).count();
            assert!(rays.len() > 1000 && count(|hit| hit.is_miss()) > 100 && count(|hit| !hit.is_miss()) > 100);
            assert_eq!(count(|hit| hit.leaves_cut()) > 0, !scene.cuts.is_none());
            assert_eq!(together(&scene, &surrounding, &rays), wanted);
            // Without one of the things in the fog it is another picture.
            let fewer = Surrounding { others: scene.with_first(1), ..surrounding };
            assert_ne!(together(&scene, &fewer, &rays), wanted);
        }
    }

    #[test]
    fn things_that_move_in_fog_are_seen_where_they_are() {
        let scene = Arc::new(scene());
        let frame = Frame { samples: 2, ..Frame::new(scene.with_first(2).overview(1.0), 16, 16) };
        let film = |tracer: &mut CpuTracer| {
            tracer.render(&frame, &Progress::default()).unwrap();
            let mut film = Film::new(frame.width, frame.height, frame.region, 0);
            tracer.read(&mut film).unwrap();
            film
        };
        let mut tracer = CpuTracer::new(Some(1));
        tracer.set_scene(&scene).unwrap();
        let before = film(&mut tracer);
        let mut instances = scene.instances().to_vec();
        instances[0].world_from_grid.translation.z += 12.0;
        let moved = Arc::new(scene.with_placement(&Placement::new(&scene.geometry, instances).unwrap()).unwrap());
        tracer.set_placement(&moved.placement).unwrap();
        let after = film(&mut tracer);
        let mut fresh = CpuTracer::new(Some(1));
        fresh.set_scene(&moved).unwrap();
        assert!(after == film(&mut fresh) && after != before);
    }

    #[test]
    fn what_is_alone_or_no_medium_surrounds_nothing() {
        let scene = scene();
        assert!(Surrounding::of(&scene.with_first(scene.instances().len() - 1)).is_none());
        assert!(Surrounding::of(&PackedScene::empty()).is_none());
        let mut materials = scene.materials().to_vec();
        materials.last_mut().unwrap().transmission = 0.0;
        assert!(Surrounding::of(&scene.with_materials(materials)).is_none());
    }
}
