//! Steps of undo that hold several edits: the stroke of a brush, or the same on both sides of a plane.

use super::{DynamicScene, Edit, EditError, Edited};

impl DynamicScene {
    /// As [`Self::edit`], and one step of undo with the edit before it, where that was one of the same grid, changed something and was not undone.
    ///
    /// # Errors
    /// As [`Self::edit`].
    pub fn edit_on(&mut self, grid: u32, edit: &Edit) -> Result<Edited, EditError> {
        let changes = self.plan(grid, edit)?;
        let (edited, entry) = self.apply(grid, changes)?;
        if !entry.bricks.is_empty() {
            self.history.join(entry);
        }
        Ok(edited)
    }

    /// How many steps can be undone by now, and how many redone: the oldest are forgotten where they take too many bytes.
    pub fn undo_steps(&self) -> (usize, usize) {
        self.history.lengths()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamic::tests::plain::Random;
    use crate::packed::PackedScene;
    use glam::{DVec3, IVec3};
    use voxtrace_scene::grid::VoxelBox;
    use voxtrace_scene::{Material, Scene, Shape, VoxelGrid};

    fn scene() -> DynamicScene {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(40, 40, 4) }, 0);
        let scene = Scene::from_grid("steps", grid, vec![Material::default(); 3]);
        DynamicScene::new(PackedScene::pack(&scene).unwrap()).unwrap()
    }

    fn ball(random: &mut Random, material: Option<u16>) -> Edit {
        let center = DVec3::new(random.below(40).into(), random.below(40).into(), random.below(9).into());
        Edit::Fill { shape: Shape::Sphere { center, radius: 3.5 }, material }
    }

    #[test]
    fn edits_that_are_joined_are_undone_and_redone_together() {
        let (mut scene, mut random) = (scene(), Random(3));
        let before = scene.compact().content_hash();
        scene.edit(0, &ball(&mut random, Some(1))).unwrap();
        let first = scene.compact().content_hash();
        scene.edit(0, &ball(&mut random, Some(2))).unwrap();
        for index in 0..40 {
            scene.edit_on(0, &ball(&mut random, [None, Some(1), Some(2)][index % 3])).unwrap();
        }
        let after = scene.compact().content_hash();
        assert_eq!(scene.undo_steps(), (2, 0));
        assert!(before != first && first != after);
        for _ in 0..3 {
            scene.undo().unwrap().unwrap();
            assert_eq!((scene.compact().content_hash(), scene.undo_steps()), (first, (1, 1)));
            scene.redo().unwrap().unwrap();
            assert_eq!((scene.compact().content_hash(), scene.undo_steps()), (after, (2, 0)));
        }
        scene.undo().unwrap();
        scene.undo().unwrap();
        assert_eq!(scene.compact().content_hash(), before);
        // With nothing to join it is a step of its own, and so it is after something was undone.
        scene.edit_on(0, &ball(&mut random, None)).unwrap();
        assert_eq!(scene.undo_steps(), (1, 0));
        scene.validate().unwrap();
        scene.set_undo_limit(1);
        assert_eq!((scene.undo_steps(), scene.undo_size_bytes()), ((0, 0), 0));
    }

    #[test]
    fn an_edit_that_changes_nothing_is_no_step_but_begins_one() {
        let mut scene = scene();
        let dab = |x: i32| {
            let region = VoxelBox { min: IVec3::new(x, 0, 9), max: IVec3::new(x + 1, 1, 10) };
            Edit::Fill { shape: Shape::Box(region), material: Some(1) }
        };
        scene.edit(0, &dab(0)).unwrap();
        let first = scene.compact().content_hash();
        // A stroke that sets out where all is as it shall be.
        assert_eq!(scene.edit(0, &dab(0)).unwrap().bricks, 0);
        assert_eq!(scene.undo_steps(), (1, 0));
        (1..4).for_each(|x| _ = scene.edit_on(0, &dab(x)).unwrap());
        assert_eq!(scene.undo_steps(), (2, 0));
        scene.undo().unwrap();
        assert_eq!(scene.compact().content_hash(), first, "the stroke before is still there");
        // And one whose first edit cannot be.
        scene.edit(0, &dab(4)).unwrap();
        scene.edit(0, &dab(i32::MAX - 1)).unwrap_err();
        scene.edit_on(0, &dab(5)).unwrap();
        assert_eq!(scene.undo_steps(), (3, 0));
    }

    #[test]
    fn what_is_added_leaves_what_is_there() {
        let (mut added, mut plain) = (scene(), scene());
        let shape = Shape::Sphere { center: DVec3::new(20.0, 20.0, 4.0), radius: 9.0 };
        added.edit(0, &Edit::Add { shape, material: 2 }).unwrap();
        plain.edit(0, &Edit::Fill { shape, material: Some(2) }).unwrap();
        assert_ne!(added.compact().content_hash(), plain.compact().content_hash(), "the ball reaches into the floor");
        let floor = VoxelBox { min: IVec3::ZERO, max: IVec3::new(40, 40, 4) };
        plain.edit(0, &Edit::Fill { shape: Shape::Box(floor), material: Some(0) }).unwrap();
        assert_eq!(added.compact().content_hash(), plain.compact().content_hash());
        added.validate().unwrap();
    }
}
