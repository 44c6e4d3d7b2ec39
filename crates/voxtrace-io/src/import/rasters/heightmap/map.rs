//! Where a heightmap lies outside of its scene.

use glam::{DAffine3, DMat3, DVec3};
use voxtrace_scene::georeference::Georeference;

/// The place of a heightmap on a map.
pub(super) struct Map {
    pub south_west: [f64; 2],
    /// How far points are apart, to the east and to the north.
    pub step: [f64; 2],
    /// The reference system, or empty.
    pub crs: String,
}

impl Map {
    /// From the scene's world to the map and to heights: `low` is in the middle of the lowest voxels, one of which is
    /// `height` high.
    pub fn georeference(&self, low: f64, height: f64) -> Georeference {
        let ([west, south], [east, north]) = (self.south_west, self.step);
        let matrix3 = DMat3::from_diagonal(DVec3::new(east, north, height));
        let translation = DVec3::new(west, south, low - 0.5 * height);
        Georeference { coordinates_from_world: DAffine3 { matrix3, translation }, crs: self.crs.clone() }
    }
}
