//! The atmosphere of a .vox file (`_atm`) as the Earth's in other measures. How MagicaVoxel computes it is not known; what the numbers
//! mean is approximate, and this is the table of it:
//!
//! | key | taken for | evidence |
//! |---|---|---|
//! | `_ray_k` | Rayleigh scattering of red, green and blue, linear; 255 is the Earth's of blue | 45, 104, 255 in every file that nobody changed: 5.8, 13.5 and 33.1 per 1000 km, the Earth's, over the last |
//! | `_ray_d`, `_mie_d` | density, of which 0.4 is the Earth's | 0.4 in every such file |
//! | `_mie_k` | scattering by haze; 255 is a clear day's | white in every file |
//! | `_mie_g` | mean cosine of its angle | 0.85 in every such file; Hillaire has 0.8 |
//! | `_o3_d`, `_o3_k` | absorption by ozone; 0.4 and 255 are the Earth's of green | green is the largest of 105, 255, 110, as it is for ozone; the density is 0 in most files |

use super::attributes::Attributes;
use glam::DVec3;
use voxtrace_scene::sky::Atmosphere;
use voxtrace_voxelize::ImportError;

/// The density that stands for the Earth's.
const EARTH: f64 = 0.4;
/// Densities beyond this are this.
const DENSEST: f64 = 100.0;

/// The atmosphere that an `_atm` chunk says.
pub fn air_of(attributes: &Attributes) -> Result<Atmosphere, ImportError> {
    let earth = Atmosphere::EARTH;
    let coefficients = |density: &str, color: &str, unsaid: (f64, [u8; 3]), largest: f64| {
        let density = attributes.float(density)?.unwrap_or(unsaid.0).clamp(0.0, DENSEST) / EARTH;
        let color = attributes.numbers::<u8, 3>(color)?.unwrap_or(unsaid.1).map(|channel| f64::from(channel) / 255.0);
        Ok::<_, ImportError>(DVec3::from_array(color) * density * largest)
    };
    let mie = coefficients("_mie_d", "_mie_k", (EARTH, [255; 3]), earth.mie.x)?;
    Ok(Atmosphere {
        rayleigh: coefficients("_ray_d", "_ray_k", (EARTH, [45, 104, 255]), earth.rayleigh.z)?,
        mie,
        mie_absorption: mie * (earth.mie_absorption.x / earth.mie.x),
        mie_g: attributes.float("_mie_g")?.unwrap_or(0.85).clamp(-0.99, 0.99),
        ozone: coefficients("_o3_d", "_o3_k", (0.0, [105, 255, 110]), earth.ozone.y)?,
        ..earth
    })
}
