//! Georeference: the place of a scene in the coordinates of its source (a map, a survey, a patient). These are too large or too
//! precise for the f32 of rays, so they are kept as a transform in f64 beside the scene.

use glam::{DAffine3, DMat3, DVec3};

/// The transform from a scene to the coordinates of its source.
#[derive(Clone, Debug, PartialEq)]
pub struct Georeference {
    /// From the scene's world space, in voxels, to source coordinates, in the unit of their reference system; axes are turned so that z is up.
    pub coordinates_from_world: DAffine3,
    /// The coordinate reference system as the file states it: WKT, `EPSG:` and a number, or words; empty where it says none.
    pub crs: String,
}

impl Georeference {
    /// Twelve numbers: the columns of the linear part, then the translation.
    pub fn to_array(&self) -> [f64; 12] {
        self.coordinates_from_world.to_cols_array()
    }

    /// From the numbers of [`Self::to_array`]; `None` where one is not finite or they have no inverse.
    pub fn from_array(numbers: [f64; 12], crs: String) -> Option<Self> {
        let coordinates_from_world = DAffine3::from_cols_array(&numbers);
        let determinant = coordinates_from_world.matrix3.determinant();
        let is_good = coordinates_from_world.is_finite() && determinant.is_finite() && determinant != 0.0;
        is_good.then_some(Self { coordinates_from_world, crs })
    }

    /// Of a grid at the world's origin: its lowest corner, and the edge of a voxel.
    pub fn of_grid(origin: DVec3, voxel_size: f64, crs: &str) -> Self {
        let matrix3 = DMat3::from_diagonal(DVec3::splat(voxel_size));
        Self { coordinates_from_world: DAffine3 { matrix3, translation: origin }, crs: crs.into() }
    }

    /// The name of the reference system: of WKT its first words in quotes; empty where there is none.
    pub fn crs_name(&self) -> &str {
        self.crs.split('"').nth(1).unwrap_or(&self.crs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_have_no_inverse_are_refused_and_names_are_short() {
        let good =
            Georeference::of_grid(DVec3::new(691_000.5, -2.0, 3.0), 0.25, "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[]]");
        assert_eq!(good.crs_name(), "WGS 84 / UTM zone 32N");
        assert_eq!(Georeference::from_array(good.to_array(), good.crs.clone()), Some(good.clone()));
        assert_eq!(good.coordinates_from_world.transform_point3(DVec3::ONE).x, 691_000.75);
        assert!(Georeference::from_array([0.0; 12], String::new()).is_none());
        assert!(Georeference::from_array([f64::NAN; 12], String::new()).is_none());
        assert_eq!(Georeference { crs: "EPSG:32632".into(), ..good }.crs_name(), "EPSG:32632");
    }
}
