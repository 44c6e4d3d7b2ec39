//! Measuring in the picture: points that snap to voxels, distances, heights, angles, paths, areas, and the volume of what hangs together.
//! All of it is in voxels of the world; [`crate::scale`] makes units of them.

pub mod component;
pub mod csv;
pub mod file;
mod hands;
pub mod snap;
pub mod values;

pub use component::{Component, Flood};
pub use hands::kind_name;
pub use snap::{Snap, Snapped};
pub use values::Value;

use file::MeasureFile;
use std::collections::BTreeMap;
use voxtrace::glam::{DAffine3, DVec3};

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Between two points.
    Distance,
    /// How much higher one of two points is.
    Height,
    /// At the second of three points.
    Angle,
    /// Along a line through points.
    Path,
    /// Within a line through points.
    Area,
    /// Of the voxels that hang together with one.
    Component,
}

impl Kind {
    /// All of them, in the order of buttons.
    pub const ALL: [Self; 6] = [Self::Distance, Self::Height, Self::Angle, Self::Path, Self::Area, Self::Component];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Height => "height",
            Self::Angle => "angle",
            Self::Path => "path",
            Self::Area => "area",
            Self::Component => "component",
        }
    }

    /// The kind of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Fewest points, and most; `None` where there may be any number.
    pub fn points(self) -> (usize, Option<usize>) {
        match self {
            Self::Distance | Self::Height => (2, Some(2)),
            Self::Angle => (3, Some(3)),
            Self::Path => (2, None),
            Self::Area => (3, None),
            Self::Component => (1, Some(1)),
        }
    }

    /// The next one, in a circle.
    pub fn next(self) -> Self {
        let here = Self::ALL.iter().position(|&kind| kind == self).unwrap_or(0);
        Self::ALL[(here + 1) % Self::ALL.len()]
    }
}

/// Something that was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// What somebody calls it.
    pub name: String,
    /// Whether it is not drawn.
    pub is_hidden: bool,
    /// What is measured.
    pub kind: Kind,
    /// Its points, world space, voxels; of a component where it was clicked.
    pub points: Vec<DVec3>,
    /// What was found of a component.
    pub component: Option<Component>,
}

impl Measure {
    /// Brings it into a world with voxels of another size, or of another place.
    pub(crate) fn transform(&mut self, new_from_old: &DAffine3) {
        self.points.iter_mut().for_each(|point| *point = new_from_old.transform_point3(*point));
        if let Some(component) = &mut self.component {
            let volume = new_from_old.matrix3.determinant().abs();
            component.volume *= volume;
            component.exposed *= volume.cbrt().powi(2);
            component.corner = new_from_old.transform_point3(component.corner);
            component.edges = component.edges.map(|edge| new_from_old.transform_vector3(edge));
        }
    }

    /// A box around it, world space.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let corners = self.component.iter().flat_map(|component| component.corners());
        let all = self.points.iter().copied().chain(corners);
        all.map(|point| (point, point)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }
}

/// What is being measured, and what was.
#[derive(Default)]
pub struct Measuring {
    /// What a click measures; `None` where it picks.
    pub tool: Option<Kind>,
    /// What points snap to.
    pub snap: Snap,
    /// Whether a component ends where its material does.
    pub by_material: bool,
    /// Points of the measurement under way.
    pub points: Vec<DVec3>,
    /// What was measured, by numbers.
    pub list: BTreeMap<u32, Measure>,
    /// The one that is drawn brighter.
    pub selected: Option<u32>,
    /// A name while it is typed: whose, and what.
    pub typed: Option<(u32, String)>,
    /// Voxels that are being counted.
    pub flood: Option<Flood>,
    /// Whether the panel is to open.
    pub opens: bool,
    /// The last tool.
    last: Option<Kind>,
    file: Option<MeasureFile>,
}
