//! Materials that get another colour while a scene is edited: nothing but their records changes.

use super::DynamicScene;
use crate::packed::PackedMaterial;
use std::sync::Arc;

impl DynamicScene {
    /// Gives a material another colour. Returns whether that was done: not where there is no such material, and not where it would emit something
    /// else or let light through otherwise, for which emitters would have to be found anew.
    #[doc(hidden)]
    pub fn recolor(&mut self, index: u16, material: PackedMaterial) -> bool {
        let Some(own) = self.geometry().materials.get(usize::from(index)).copied() else { return false };
        let is_color_alone = own == PackedMaterial { base_color: own.base_color, ..material };
        if is_color_alone && own != material {
            let geometry = Arc::make_mut(&mut self.scene.geometry);
            geometry.materials.as_mut()[usize::from(index)] = material;
            geometry.is_edited = true;
            self.dirty.palette.mark(index.into(), 1);
        }
        is_color_alone
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use glam::{IVec3, Vec3};
    use voxtrace_scene::{Material, Scene, VoxelGrid};

    #[test]
    fn a_material_of_another_colour_is_that_of_packing_and_what_glows_is_left_alone() {
        let mut grid = VoxelGrid::new();
        (0..9).for_each(|x| _ = grid.set(IVec3::new(x, 0, 0), (x % 2) as u16));
        let mut plain = Scene::from_grid("row", grid, vec![Material::default(), Material::emissive(Vec3::splat(2.0))]);
        let packed = PackedScene::pack(&plain).unwrap();
        let (mut scene, mut follower) = (DynamicScene::new(packed.clone()).unwrap(), packed);
        let red = |material: &PackedMaterial| PackedMaterial { base_color: Vec3::X, ..*material };
        let own = scene.scene().materials()[0];
        assert!(scene.recolor(0, red(&own)));
        follower.apply_patch(&scene.take_patch()).unwrap();
        plain.materials[0].base_color = Vec3::X;
        let anew = PackedScene::pack(&plain).unwrap();
        assert_eq!(scene.compact().content_hash(), anew.content_hash());
        assert_eq!(follower.content_hash(), anew.content_hash());
        assert!(!scene.recolor(0, PackedMaterial { emission: Vec3::ONE, ..own }) && !scene.recolor(7, own));
        scene.validate().unwrap();
    }
}
