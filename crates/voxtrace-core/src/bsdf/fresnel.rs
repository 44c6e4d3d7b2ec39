//! Fresnel's reflectance: the share of light that the boundary of two media reflects.

use glam::Vec3;

/// Reflectance of the boundary of two dielectrics, both polarizations alike. `cos_i`, in [0, 1], belongs to the side of the light, `eta` is
/// the index of refraction of the other side over that of this one (Pharr, Jakob and Humphreys 2023, section 9.3.5).
#[inline]
pub fn fresnel_dielectric(cos_i: f32, eta: f32) -> f32 {
    let Some(cos_t) = refracted_cosine(cos_i, eta) else { return 1.0 };
    let parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    (parallel * parallel + perpendicular * perpendicular) * 0.5
}

/// Reflectance of a boundary that light passes without refraction: from either side as from that of the lower index, as both faces of a pane have it.
#[inline]
pub fn straight_reflectance(cos_i: f32, eta: f32) -> f32 {
    fresnel_dielectric(cos_i, if eta < 1.0 { 1.0 / eta } else { eta })
}

/// Cosine of the refracted direction by Snell's law; `None` where all light is reflected.
#[inline]
pub fn refracted_cosine(cos_i: f32, eta: f32) -> Option<f32> {
    let squared = 1.0 - (1.0 - cos_i * cos_i) / (eta * eta);
    (squared > 0.0).then(|| squared.sqrt())
}

/// Reflectance of a metal whose reflectance at normal incidence is `f0` (Schlick, "An Inexpensive BRDF Model for Physically-based Rendering",
/// 1994).
#[inline]
pub fn fresnel_schlick(cos_i: f32, f0: Vec3) -> Vec3 {
    let rest = 1.0 - cos_i;
    let squared = rest * rest;
    f0 + (Vec3::ONE - f0) * (squared * squared * rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reflectance_is_that_of_the_closed_forms() {
        // Normal incidence: ((n − 1) / (n + 1))².
        for eta in [1.1f32, 1.33, 1.5, 2.42, 1.0 / 1.5] {
            let expected = ((eta - 1.0) / (eta + 1.0)).powi(2);
            assert!((fresnel_dielectric(1.0, eta) - expected).abs() < 1e-7, "{eta}");
            assert!((fresnel_dielectric(1.0, eta * 1.01) - expected).abs() > 1e-5, "a fault is seen");
        }
        // Total reflection beyond the critical angle, and none of it before.
        let critical = (1.0 - 1.0f32 / (1.5 * 1.5)).sqrt();
        assert_eq!(fresnel_dielectric(critical - 1e-4, 1.0 / 1.5), 1.0);
        assert!(fresnel_dielectric(critical + 1e-3, 1.0 / 1.5) < 1.0);
        // At Brewster's angle, tan = n, only one polarization is reflected: sin²(θi − θt) / 2.
        let (n, angle) = (1.5f64, 1.5f64.atan());
        let expected = (angle - (angle.sin() / n).asin()).sin().powi(2) / 2.0;
        assert!((f64::from(fresnel_dielectric(angle.cos() as f32, n as f32)) - expected).abs() < 1e-6);
        // The same from both sides along the refracted ray (Stokes).
        let cos_t = refracted_cosine(0.3, 1.5).unwrap();
        assert!((fresnel_dielectric(0.3, 1.5) - fresnel_dielectric(cos_t, 1.0 / 1.5)).abs() < 1e-6);
        assert_eq!(fresnel_schlick(1.0, Vec3::new(0.9, 0.5, 0.1)), Vec3::new(0.9, 0.5, 0.1));
        assert_eq!(fresnel_schlick(0.0, Vec3::new(0.9, 0.5, 0.1)), Vec3::ONE);
    }
}
