//! From the arrays of an edited scene to those of packing it from scratch.

use super::DynamicScene;
use crate::packed::{
    Emitter, Geometry, LightNode, PackedInstance, PackedScene, Placement, append_lights, morton_order, pack_grid,
};
use rayon::prelude::*;
use std::sync::Arc;

impl DynamicScene {
    /// The scene without free places: what packing the edited scene from scratch gives, byte for byte. Grids in which nothing is left are gone,
    /// with their instances.
    pub fn compact(&self) -> PackedScene {
        self.scene.compacted()
    }
}

impl PackedScene {
    /// As [`DynamicScene::compact`].
    pub(crate) fn compacted(&self) -> Self {
        let own = &*self.geometry;
        let kept: Vec<usize> = (0..own.grids.len()).filter(|&grid| own.grids[grid].voxels != [0, 0]).collect();
        let pack = |&grid: &usize| {
            let packed = &own.grids[grid];
            pack_grid(&own.unpack_grid(packed), packed.material_bits, &|| Ok(())).expect("nobody stops it")
        };
        let parts: Vec<_> = kept.par_iter().map(pack).collect();
        let (mut cells, mut bricks, mut brick_materials, mut grids) = (vec![], vec![], vec![], vec![]);
        for part in parts {
            let appended = part.append(&mut cells, &mut bricks, &mut brick_materials, &mut grids);
            appended.expect("no larger than with free places");
        }
        let (mut emitters, mut light_nodes) = (Vec::new(), Vec::new());
        for (index, &grid) in kept.iter().enumerate() {
            let mut found = own.emitters_below(grid as u32);
            found.iter_mut().for_each(|emitter| emitter.grid = index as u32);
            append_lights(found, &mut emitters, &mut light_nodes);
        }
        let scene_grid = |grid: &usize| own.scene_grids.get(*grid).copied().unwrap_or(*grid as u32);
        let geometry = Geometry {
            cells: cells.into(),
            bricks: bricks.into(),
            brick_materials: brick_materials.into(),
            grids: grids.into(),
            materials: own.materials.clone(),
            emitters: emitters.into(),
            light_nodes: light_nodes.into(),
            scene_grids: kept.iter().map(scene_grid).collect(),
            ..Geometry::default()
        }
        .finished();
        let instance = |instance: &PackedInstance| {
            let grid = kept.binary_search(&(instance.grid as usize)).ok()?;
            Some(PackedInstance { grid: grid as u32, ..*instance })
        };
        let instances = self.placement.instances().iter().filter_map(instance).collect();
        Self { placement: Placement::of_sound(&geometry, instances), geometry: Arc::new(geometry), ..self.clone() }
    }
}

impl Geometry {
    /// The emitters of a grid, in Morton order.
    fn emitters_below(&self, grid: u32) -> Vec<Emitter> {
        let mut emitters = Vec::new();
        let mut waiting: Vec<u32> = self.light_root(grid).into_iter().collect();
        while let Some(at) = waiting.pop() {
            let LightNode { index, count, .. } = self.light_nodes[at as usize];
            if count == 0 {
                waiting.extend([index, at + 1]);
            } else {
                emitters.extend_from_slice(&self.emitters[index as usize..(index + count) as usize]);
            }
        }
        emitters.sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
        emitters
    }
}
