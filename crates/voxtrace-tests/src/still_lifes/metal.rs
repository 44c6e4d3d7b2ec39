//! A hall of polished tiles with a mirror on its side: a golden vase, a fluted column of bronze, gears of steel, balls of copper and chrome,
//! iron ingots, under lamps of several colours.

use super::{Builder, one_of, tile};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::scenes::kit::noise::{fraction, turns};
use voxtrace::{Camera, Material, Scene, Sky};

/// A linear colour of sRGB bytes.
fn color(srgb: [u8; 3]) -> Vec3 {
    Material::from_srgb(srgb).base_color
}

pub fn scene() -> Scene {
    let mut builder = Builder::default();
    hall(&mut builder);
    things(&mut builder);
    let mut scene = builder.into_scene("metal");
    scene.sky = Sky::gradient(Vec3::splat(0.05), Vec3::new(0.25, 0.3, 0.4));
    let (eye, target) = (Vec3::new(150.0, -175.0, 100.0), Vec3::new(160.0, 110.0, 44.0));
    scene.cameras.push(Camera { name: "hall".into(), fov_y: 36.0, ..Camera::look_at(eye, target) });
    scene
}

fn hall(builder: &mut Builder) {
    let black = builder.shades([44, 46, 52], |material| Material { specular: 1.0, roughness: 0.12, ..material });
    let white = builder.shades([205, 200, 190], |material| Material { specular: 1.0, roughness: 0.12, ..material });
    let walls = builder.shades([112, 106, 118], |material| material);
    let mirror = builder.material(Material::metal(Vec3::splat(0.92), 0.0));
    let frame = builder.material(Material::metal(color([210, 170, 90]), 0.3));
    let lamps = [[9.0, 7.2, 5.0], [4.0, 6.0, 9.0], [9.0, 4.0, 3.0]]
        .map(|radiance| builder.material(Material::emissive(Vec3::from_array(radiance))));
    builder.fill(Vec3::new(0.0, -40.0, -4.0), Vec3::new(320.0, 220.0, 0.0), |at| {
        let (cell, is_gap) = tile(at.truncate(), Vec2::splat(24.0), 1.0);
        (!is_gap || at.z < -1.0).then(|| one_of(if (cell.x + cell.y) % 2 == 0 { black } else { white }, cell))
    });
    // The wall behind, with three lamps; the one on the right with a mirror in a gilt frame.
    builder.fill(Vec3::new(0.0, 220.0, -4.0), Vec3::new(320.0, 226.0, 190.0), |at| {
        let panel = fraction(at.x / 106.7) * 106.7 - 53.0;
        let is_lamp = panel.abs() < 12.0 && (50.0..165.0).contains(&at.z) && at.y < 222.0;
        let (cell, is_gap) = tile(Vec2::new(at.x, at.z), Vec2::new(40.0, 26.0), 2.0);
        let lamp = lamps[(at.x / 106.7) as usize % 3];
        (!is_gap || at.y > 222.0).then(|| if is_lamp { lamp } else { one_of(walls, cell) })
    });
    builder.fill(Vec3::new(314.0, -40.0, 0.0), Vec3::new(320.0, 220.0, 190.0), |at| {
        let edge = ((at.y - 100.0).abs() - 84.0).max((at.z - 84.0).abs() - 66.0);
        Some(match edge {
            _ if edge < 0.0 => mirror,
            _ if edge < 7.0 => frame,
            _ => one_of(walls, (at / 12.0).floor().as_ivec3()),
        })
    });
    // A lamp that hangs over it all.
    let hung = lamps[0];
    builder.fill(Vec3::new(100.0, 40.0, 196.0), Vec3::new(220.0, 100.0, 199.0), |at| {
        Some(if at.z < 197.0 { hung } else { frame })
    });
}

fn things(builder: &mut Builder) {
    let gold = builder.material(Material::metal(color([255, 196, 90]), 0.12));
    let copper = builder.material(Material::metal(color([240, 150, 115]), 0.35));
    let bronze = [0.3, 0.38, 0.46].map(|rough| builder.material(Material::metal(color([190, 140, 80]), rough)));
    let steel = builder.material(Material::metal(color([190, 192, 198]), 0.22));
    let chrome = builder.material(Material::metal(color([235, 236, 240]), 0.0));
    let iron = [0.45, 0.55, 0.65].map(|rough| builder.material(Material::metal(color([130, 126, 122]), rough)));
    let red = builder.material(Material { metallic: 0.5, ..Material::plastic(color([170, 30, 34]), 0.2) });
    let vase =
        [(0.0, 14.0), (5.0, 16.0), (9.0, 9.0), (22.0, 19.0), (44.0, 25.0), (62.0, 17.0), (72.0, 9.0), (84.0, 16.0)];
    builder.turned(Vec3::new(112.0, 96.0, 0.0), &vase, |at| {
        // Bands with a pattern of another metal.
        let is_band = (40.0..48.0).contains(&at.z) && fraction(turns(at.x, at.y) * 14.0) < 0.5;
        if is_band { chrome } else { gold }
    });
    let column = Vec3::new(252.0, 150.0, 0.0);
    builder.fill(column - Vec3::new(24.0, 24.0, 0.0), column + Vec3::new(24.0, 24.0, 130.0), |at| {
        let at = at - column;
        let flute = (fraction(turns(at.x, at.y) * 12.0) - 0.5).abs();
        let is_end = !(8.0..122.0).contains(&at.z);
        let radius = if is_end { 23.0 } else { 16.0 + 3.5 * (1.0 - 4.0 * (0.5 - flute) * (0.5 - flute)) };
        (at.truncate().length() < radius).then(|| one_of(bronze, IVec3::new(0, 0, (at.z / 9.0) as i32)))
    });
    for (middle, radius, material) in [
        (Vec3::new(192.0, 72.0, 26.0), 26.0, chrome),
        (Vec3::new(60.0, 52.0, 17.0), 17.0, copper),
        (Vec3::new(150.0, 28.0, 10.0), 10.0, red),
        (Vec3::new(238.0, 40.0, 12.0), 12.0, gold),
    ] {
        builder.ball(middle, radius, |_| material);
    }
    gear(builder, Vec3::new(66.0, 152.0, 45.0), 45.0, steel);
    gear(builder, Vec3::new(168.0, 176.0, 30.0), 30.0, copper);
    // Ingots, laid crosswise.
    for layer in 0..4 {
        for bar in 0..3 - layer / 2 {
            let (along, z) = (bar as f32 * 13.0, layer as f32 * 8.0);
            let (x, y) = if layer % 2 == 0 { (270.0, 66.0 + along) } else { (270.0 + along, 66.0) };
            let size = if layer % 2 == 0 { Vec3::new(36.0, 11.0, 7.0) } else { Vec3::new(11.0, 36.0, 7.0) };
            let corner = Vec3::new(x, y, z);
            builder.fill(corner, corner + size, |_| Some(one_of(iron, IVec3::new(layer, bar, 0))));
        }
    }
}

/// A toothed wheel that stands on its teeth.
fn gear(builder: &mut Builder, middle: Vec3, radius: f32, material: u16) {
    let reach = Vec3::new(radius, 6.0, radius);
    builder.fill(middle - reach, middle + reach, |at| {
        let at = at - middle;
        let (distance, turn) = (Vec2::new(at.x, at.z).length(), turns(at.x, at.z));
        let outer = if fraction(turn * 16.0) < 0.5 { radius } else { radius * 0.86 };
        let is_spoke = (fraction(turn * 5.0) - 0.5).abs() < 0.12;
        let is_ring = distance > radius * 0.62 || distance < radius * 0.26;
        let is_hole = distance < radius * 0.1;
        (distance < outer && !is_hole && (is_ring || is_spoke && at.y.abs() < 4.0)).then_some(material)
    });
}
