//! Which instances have moved since the camera stands. Pixels that show none of them keep what they know while these move on, as in pictures in which nothing moves.

use voxtrace_core::packed::PackedInstance;
use voxtrace_scene::transform::Transform;

/// Where an instance stood, and which grid it showed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stood {
    /// Its grid to the world.
    pub world_from_grid: Transform,
    grid: u32,
}

impl Stood {
    /// Of an instance.
    pub fn of(instance: &PackedInstance) -> Self {
        Self { world_from_grid: instance.world_from_grid, grid: instance.grid }
    }
}

/// Of each instance, whether it stands elsewhere or shows another grid.
pub(crate) fn moved<'a>(stood: &'a [Stood], now: &'a [PackedInstance]) -> impl ExactSizeIterator<Item = bool> {
    stood.iter().zip(now).map(|(stood, now)| *stood != Stood::of(now))
}

/// The instances that have moved since the camera stands and voxels, materials and lights are what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Movers {
    /// Of each instance, whether it has moved, or became another grid; empty where none has.
    moved: Vec<bool>,
    /// Whether pixels that show none of them keep what they know in this frame.
    keep: bool,
}

impl Movers {
    /// Those of a frame after one with these. `moved` says of each instance whether it moved in between, and has none where none did. `is_same` says whether the camera
    /// stands where it did and nothing but instances changed.
    ///
    /// Where the camera moved pixels begin anew; where another instance begins to move they do too, as any of them may know it.
    pub fn after(&self, moved: impl ExactSizeIterator<Item = bool>, is_same: bool) -> Self {
        let mut next = if is_same { self.moved.clone() } else { Vec::new() };
        next.resize(next.len().max(moved.len()), false);
        let mut are_known = true;
        for (has_moved, moved) in next.iter_mut().zip(moved) {
            are_known &= *has_moved || !moved;
            *has_moved |= moved;
        }
        if !next.contains(&true) {
            next.clear();
        }
        Self { moved: next, keep: is_same && are_known }
    }

    /// Whether pixels that show none of them keep what they know.
    pub fn keep(&self) -> bool {
        self.keep
    }

    /// Of each instance, whether it is one of them; empty where none is.
    pub fn moved(&self) -> &[bool] {
        &self.moved
    }

    /// Whether an instance is one of them.
    pub fn have(&self, instance: u32) -> bool {
        self.moved.get(instance as usize).copied().unwrap_or(false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// Those after each of some frames: what moved, and whether the camera stands.
    fn after(frames: &[([bool; 3], bool)]) -> Movers {
        frames.iter().fold(Movers::default(), |movers, (moved, is_same)| movers.after(moved.iter().copied(), *is_same))
    }

    #[test]
    fn pixels_keep_what_they_know_while_the_same_instances_move() {
        const NONE: [bool; 3] = [false; 3];
        const FIRST: [bool; 3] = [true, false, false];
        const SECOND: [bool; 3] = [false, true, false];
        let keep = |frames: &[([bool; 3], bool)]| after(frames).keep();
        assert!(!keep(&[(FIRST, true)]), "it begins to move");
        assert!(keep(&[(FIRST, true), (FIRST, true)]));
        assert!(keep(&[(FIRST, true), (NONE, true), (FIRST, true)]), "it stops and goes on");
        assert!(!keep(&[(FIRST, true), (SECOND, true)]), "another one begins");
        assert!(keep(&[(FIRST, true), (SECOND, true), (FIRST, true), (SECOND, true)]), "they take turns");
        assert!(!keep(&[(FIRST, true), (FIRST, false)]) && !keep(&[(FIRST, false), (NONE, false), (FIRST, true)]));
        // None where nothing moved is said by no entry, too.
        assert_eq!(after(&[(FIRST, true)]).after([].into_iter(), true).moved(), FIRST);
        assert!(after(&[(FIRST, true), (NONE, false)]).moved().is_empty());
    }

    #[test]
    fn what_becomes_another_grid_moves_too() {
        let at = |grid: u32, x: f32| PackedInstance::new(grid, Transform::from_translation(Vec3::X * x), 0);
        let stood = [at(0, 0.0), at(0, 1.0), at(1, 2.0)].map(|instance| Stood::of(&instance));
        let found = |now: &[PackedInstance]| moved(&stood, now).collect::<Vec<_>>();
        assert_eq!(found(&[at(0, 0.0), at(1, 1.0), at(1, 3.0)]), [false, true, true]);
        assert_eq!(found(&[at(0, 0.0), at(0, 1.0), at(1, 2.0)]), [false; 3]);
    }
}
