//! Faults of drivers, simulated: what is built, or what comes back, is not what was asked for. Each must make its probe fail.

use super::boxes::Aabb;

/// A fault to plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plant {
    /// Boxes that touch become one wide box in pairs, under the number of the first: what the study saw.
    MergedBoxes,
    /// Every eleventh box gives no candidate.
    LostBoxes,
    /// The hit attribute is that of the candidate that came last.
    LastAttribute,
    /// Instances stand one unit beside their place.
    ShiftedInstances,
}

/// Stands for a box that is not there, out of sight. An inactive one would be in the way of drivers that P6 is about.
const GONE: Aabb = Aabb { min: [-1e4; 3], max: [-9.9e3; 3] };

impl Plant {
    /// What is built instead of `boxes`.
    pub(super) fn boxes(self, boxes: &[Aabb]) -> Vec<Aabb> {
        let mut built = boxes.to_vec();
        match self {
            Self::MergedBoxes => {
                let mut index = 0;
                while index + 1 < built.len() {
                    if let Some(joined) = built[index].joined(built[index + 1]) {
                        (built[index], built[index + 1]) = (joined, GONE);
                        index += 1;
                    }
                    index += 1;
                }
            }
            Self::LostBoxes => built.iter_mut().step_by(11).for_each(|aabb| *aabb = GONE),
            Self::LastAttribute | Self::ShiftedInstances => {}
        }
        built
    }

    pub(super) fn transform(self, mut transform: [f32; 12]) -> [f32; 12] {
        if self == Self::ShiftedInstances {
            transform[3] += 1.0;
        }
        transform
    }
}
