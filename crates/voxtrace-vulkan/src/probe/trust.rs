//! What the probes mean for tracing: which primitives a traversal can be trusted with. The order to fall back in is: boxes known
//! by their number (`brick`, `voxel-exact`), position (`grid`: one box an instance, the shader walks), triangles, the compute walk,
//! the CPU.

use super::report::{Outcome, ProbeReport};
use crate::method::{Primitive, Traversal};

/// Probes that must not fail for a primitive.
fn needed(primitive: Primitive) -> &'static [&'static str] {
    match primitive {
        // Which box it is comes from its number.
        Primitive::VoxelExact | Primitive::VoxelApprox | Primitive::Brick => {
            &["P1", "P2", "P3", "P4", "P7", "P9", "P12", "P14", "P15", "P18"]
        }
        // A box for each instance cannot be merged with another: the instance must be right, and the box found at all.
        Primitive::Grid => &["P4", "P7", "P9", "P18"],
        // Triangles may not be merged in any of the interfaces; the probes know of them only what they share with boxes.
        Primitive::Triangle => &["P7", "P9"],
    }
}

/// The order to try primitives in.
const FALL_BACK: [Primitive; 3] = [Primitive::Brick, Primitive::Grid, Primitive::Triangle];

impl ProbeReport {
    /// Why a traversal should not be trusted with a primitive, `None` where nothing speaks against it.
    pub fn distrusts(&self, traversal: Traversal, primitive: Primitive) -> Option<String> {
        if !traversal.uses_primitives() {
            return None;
        }
        needed(primitive).iter().find_map(|id| {
            let finding = self.finding(id, traversal)?;
            (finding.outcome == Outcome::Fails).then(|| format!("probe {id}: {}", finding.says))
        })
    }

    /// The first primitive in the order to fall back in that a traversal can be trusted with; `None` says: take the walk.
    pub fn trusted(&self, traversal: Traversal) -> Option<Primitive> {
        FALL_BACK.into_iter().find(|&primitive| self.distrusts(traversal, primitive).is_none())
    }

    /// One line for people: what the probes found, and what follows.
    pub fn verdict(&self) -> String {
        let failed: Vec<&str> =
            self.probes.iter().filter(|row| row.outcome == Outcome::Fails).map(|row| row.id.as_str()).collect();
        let mut text = match (self.traversals.is_empty(), failed.as_slice()) {
            (true, []) => return "no ray tracing to probe: the compute walk traces".into(),
            (true, _) => "the probes do not run".to_owned(),
            (false, []) => "all that is promised holds".to_owned(),
            (false, [one]) => format!("{one} fails"),
            (false, [all @ .., last]) => format!("{} and {last} fail", all.join(", ")),
        };
        for traversal in [Traversal::Pipeline, Traversal::Query] {
            if !self.traversals.iter().any(|name| name == traversal.name()) {
                continue;
            }
            let name = traversal.name();
            text += &match (self.trusted(traversal), self.distrusts(traversal, Primitive::Brick)) {
                (Some(Primitive::Brick), _) => format!("; {name} can be trusted with every primitive"),
                (Some(primitive), Some(why)) => format!("; {name} falls back to {} ({why})", primitive.name()),
                (_, why) => format!("; {name} falls back to the compute walk ({})", why.unwrap_or_default()),
            };
        }
        text
    }
}
