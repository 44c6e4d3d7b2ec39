//! Oklab, a perceptually uniform colour space: distances in it are close to perceived differences. Source: Björn Ottosson, "A perceptual
//! color space for image processing", 2020.

use glam::Vec3;

const LMS_FROM_RGB: [Vec3; 3] = [
    Vec3::new(0.412_221_47, 0.536_332_54, 0.051_445_993),
    Vec3::new(0.211_903_5, 0.680_699_5, 0.107_396_96),
    Vec3::new(0.088_302_46, 0.281_718_84, 0.629_978_7),
];
const LAB_FROM_ROOTS: [Vec3; 3] = [
    Vec3::new(0.210_454_26, 0.793_617_8, -0.004_072_047),
    Vec3::new(1.977_998_5, -2.428_592_2, 0.450_593_7),
    Vec3::new(0.025_904_037, 0.782_771_77, -0.808_675_77),
];
const ROOTS_FROM_LAB: [Vec3; 3] = [
    Vec3::new(1.0, 0.396_337_78, 0.215_803_76),
    Vec3::new(1.0, -0.105_561_346, -0.063_854_17),
    Vec3::new(1.0, -0.089_484_18, -1.291_485_5),
];
const RGB_FROM_LMS: [Vec3; 3] = [
    Vec3::new(4.076_741_7, -3.307_711_6, 0.230_969_94),
    Vec3::new(-1.268_438, 2.609_757_4, -0.341_319_38),
    Vec3::new(-0.004_196_086_3, -0.703_418_6, 1.707_614_7),
];

fn product(rows: [Vec3; 3], vector: Vec3) -> Vec3 {
    Vec3::from_array(rows.map(|row| row.dot(vector)))
}

/// Lightness, green–red and blue–yellow of a linear colour.
pub fn oklab_of(linear: Vec3) -> Vec3 {
    product(LAB_FROM_ROOTS, product(LMS_FROM_RGB, linear).map(f32::cbrt))
}

/// The linear colour of a point in Oklab, which may lie outside [0, 1].
pub fn linear_of(oklab: Vec3) -> Vec3 {
    product(RGB_FROM_LMS, product(ROOTS_FROM_LAB, oklab).map(|root| root * root * root))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_has_lightness_one_and_no_hue() {
        assert!((oklab_of(Vec3::ONE) - Vec3::X).length() < 1e-4, "{}", oklab_of(Vec3::ONE));
    }

    #[test]
    fn colors_come_back() {
        for color in [Vec3::new(0.2, 0.5, 0.9), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 0.3, 0.01), Vec3::ZERO] {
            assert!((linear_of(oklab_of(color)) - color).length() < 1e-4);
        }
    }
}
