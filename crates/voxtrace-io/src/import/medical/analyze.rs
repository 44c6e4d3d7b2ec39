//! Headers of Analyze 7.5 (Mayo Clinic, "ANALYZE 7.5 File Format"), with what SPM keeps in them: a scale and an origin. The samples lie in a
//! file beside the header. Axes point to the left, to the front and to the head, which is what programs take for granted: nothing in the
//! file says it.

use super::nifti::{Fields, Header};
use glam::{DAffine3, DMat3, DVec3};

/// What a header of 348 bytes without the sign of NIfTI says. Bytes of the fields that both have are those of NIfTI.
pub(super) fn settle(header: &mut Header, fields: &Fields) {
    let scale = f64::from(fields.f32(112));
    let (scl_slope, scl_inter) = if scale.is_finite() && scale > 0.0 { (scale, 0.0) } else { (0.0, 0.0) };
    (header.scl_slope, header.scl_inter, header.unit_size, header.intent) = (scl_slope, scl_inter, 1.0, 0);
    header.start = u64::try_from(f64::from(fields.f32(108)).abs() as i64).unwrap_or(0);
    let origin = DVec3::from_array([0, 1, 2].map(|axis| fields.int(253 + 2 * axis, 2) as f64));
    let size = DVec3::from_array(header.size.map(|size| size as f64));
    let is_said = origin != DVec3::ZERO && origin.cmpgt(-size).all() && origin.cmplt(size * 2.0).all();
    // SPM counts from 1 on.
    let origin = if is_said { origin - 1.0 } else { (size - 1.0) / 2.0 };
    // In the axes of NIfTI, right, front and head.
    let matrix3 = DMat3::from_diagonal(header.spacing * DVec3::new(-1.0, 1.0, 1.0));
    header.nifti_from_index = DAffine3 { matrix3, translation: matrix3 * -origin };
}
