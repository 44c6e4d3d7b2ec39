//! From the places of voxels to the world: OpenVDB's maps that are affine.

use super::cursor::Cursor;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_voxelize::ImportError;

const WHAT: &str = "the place of a grid";

/// Reads a map, or says the kind of one that is none of these and bends space.
pub(super) fn read(cursor: &mut Cursor) -> Result<Result<DAffine3, String>, ImportError> {
    let kind = cursor.text(WHAT)?;
    Ok(Ok(match kind.as_str() {
        "UniformScaleMap" | "ScaleMap" => scale(cursor, DVec3::ZERO)?,
        "UniformScaleTranslateMap" | "ScaleTranslateMap" => {
            let translation = vector(cursor)?;
            scale(cursor, translation)?
        }
        "TranslationMap" => DAffine3::from_translation(vector(cursor)?),
        "AffineMap" | "UnitaryMap" => {
            // Points are rows there: each row of the matrix is an axis of ours.
            let mut rows = [DVec3::ZERO; 4];
            for row in &mut rows {
                *row = vector(cursor)?;
                cursor.f64(WHAT)?;
            }
            DAffine3 { matrix3: DMat3::from_cols(rows[0], rows[1], rows[2]), translation: rows[3] }
        }
        _ => return Ok(Err(kind)),
    }))
}

fn scale(cursor: &mut Cursor, translation: DVec3) -> Result<DAffine3, ImportError> {
    let scale = vector(cursor)?;
    // Size of a voxel, its inverse, and two more that follow from it.
    for _ in 0..4 {
        vector(cursor)?;
    }
    Ok(DAffine3 { matrix3: DMat3::from_diagonal(scale), translation })
}

fn vector(cursor: &mut Cursor) -> Result<DVec3, ImportError> {
    Ok(DVec3::new(cursor.f64(WHAT)?, cursor.f64(WHAT)?, cursor.f64(WHAT)?))
}
