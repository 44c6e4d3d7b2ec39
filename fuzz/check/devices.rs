//! What must hold for any scene that is opened, forged or not, on a Vulkan device: every tracer of it traces and renders the scene,
//! and meets voxels that are there; shared by the fuzz target and the tests.

use super::check::Traced;
use std::sync::Arc;
use voxtrace::{Frame, Hit, Integrator, PackedScene, Progress, Tracer};
use voxtrace_vulkan::{Device, Primitive, Settings, Traversal, VulkanTracer, missing};

/// Tracers of a device.
pub struct Tracers(Vec<(Settings, VulkanTracer)>);

impl Tracers {
    /// One for each shader that has a stack or walks through a hierarchy of its own. Software devices compile every variant of
    /// a shader for seconds.
    pub fn few(device: &Arc<Device>) -> Self {
        Self::with(device, &[(Traversal::Walk, Primitive::Brick), (Traversal::Query, Primitive::Triangle)])
    }

    /// Those of the kinds given that the device has what it takes for.
    ///
    /// # Panics
    /// If one cannot be made.
    pub fn with(device: &Arc<Device>, kinds: &[(Traversal, Primitive)]) -> Self {
        let found = kinds.iter().filter(|(traversal, _)| missing(device.info(), *traversal).is_none());
        let tracer = |&(traversal, primitive): &(Traversal, Primitive)| {
            let settings = Settings { traversal, primitive, is_exact: true };
            (settings, VulkanTracer::new(Arc::clone(device), settings).expect("a tracer"))
        };
        Self(found.map(tracer).collect())
    }

    /// Traces the rays of a scene with each tracer, and with the compute walk a small picture. Hands out what was met, with the tracer's kind.
    ///
    /// # Panics
    /// If a tracer fails or meets what is not there.
    pub fn check(&mut self, traced: &Traced) -> Vec<(Settings, Vec<Hit>)> {
        let scene = Arc::new(traced.scene.clone());
        let frame = small_frame(&scene);
        let mut all = Vec::new();
        for (kind, tracer) in &mut self.0 {
            tracer.set_scene(&scene).unwrap_or_else(|error| panic!("{kind:?}: {error}"));
            let mut hits = vec![Hit::MISS; traced.rays.len()];
            tracer.cast_into(&traced.rays, &mut hits).unwrap_or_else(|error| panic!("{kind:?}: {error}"));
            for (ray, hit) in traced.rays.iter().zip(&hits).filter(|(_, hit)| !hit.is_miss()) {
                assert!(is_there(&scene, hit), "{kind:?}: {ray:?} met {hit:?}");
            }
            // Light is the same code however rays find voxels.
            if kind.traversal == Traversal::Walk {
                tracer.render(&frame, &Progress::default()).unwrap_or_else(|error| panic!("{kind:?}: {error}"));
            }
            all.push((*kind, hits));
        }
        all
    }
}

fn is_there(scene: &PackedScene, hit: &Hit) -> bool {
    let hit = scene.hit_of_packed(hit);
    let instance = scene.instances().get(hit.instance as usize);
    instance.is_some_and(|instance| {
        scene.geometry().material_at(&scene.grids()[instance.grid as usize], hit.voxel).is_some()
    })
}

/// Light and materials are looked up too, so that what they say is used.
fn small_frame(scene: &PackedScene) -> Frame {
    let (width, height) = (16, 8);
    Frame::new(scene.overview(width as f32 / height as f32), width, height)
        .samples(1)
        .seed(1)
        .max_bounces(3)
        .integrator(Integrator::Path)
        .aovs(true)
}
