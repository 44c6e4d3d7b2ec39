//! The surgeon's tools: the Mayo stand, draped instrument tables with trays, bowls and instruments, buckets, steps.

use super::{Workshop, anaesthesia, parts};
use crate::kit::{noise::*, *};
use glam::vec3;

/// Instrument tables and what stands around the operating table.
pub fn tools(shop: &Workshop) -> Solid {
    union([
        mayo_stand(shop).turn_z(-84.0).at(vec3(4.62, 5.12, 0.0)),
        back_table(shop, 1).turn_z(-52.0).at(vec3(2.55, 3.35, 0.0)),
        back_table(shop, 2).turn_z(8.0).at(vec3(4.2, 5.95, 0.0)),
        basin_stand(shop).at(vec3(1.95, 4.7, 0.0)),
        bucket(shop).at(vec3(5.95, 3.3, 0.0)),
        bucket(shop).at(vec3(6.2, 5.4, 0.0)),
        step(shop).turn_z(4.0).at(vec3(5.0, 3.5, 0.0)),
        step(shop).turn_z(-8.0).at(vec3(5.55, 5.2, 0.0)),
        anaesthesia::stool(shop).at(vec3(3.6, 3.72, 0.0)),
        anaesthesia::stool(shop).at(vec3(8.6, 4.45, 0.0)),
    ])
}

/// A stand whose tray reaches over the patient's legs: foot towards −x, tray towards +x.
fn mayo_stand(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let leg = bars(&[vec3(0.0, 0.0, 0.09), vec3(0.0, 0.22, 0.08), vec3(0.55, 0.26, 0.08)], 0.02).both_y();
    let wheels =
        parts::castor(shop, 0.08).at(vec3(0.55, 0.26, 0.0)).and(parts::castor(shop, 0.08).at(vec3(0.0, 0.2, 0.0)));
    let post = cylinder(0.024, 0.75).z(0.08).and(cylinder(0.017, 1.18).z(0.08));
    let arm = bars(&[vec3(0.0, 0.0, 1.24), vec3(0.1, 0.0, 1.27), vec3(0.8, 0.0, 1.27)], 0.018);
    let frame = union([leg, post, arm]).paint(&paints.steel);
    let tray = tray(shop, 0.66, 0.46, 5).turn_z(90.0).at(vec3(0.55, 0.0, 1.285));
    let cover = parts::folds(shop, 0.44, 0.30, &paints.blue_cloth, 31).turn_z(90.0).at(vec3(0.30, -0.22, 1.30));
    union([frame, wheels.both_y(), tray, cover])
}

/// A table, 1.5 m × 0.65 m, under a blue drape, set with instruments.
fn back_table(shop: &Workshop, seed: u32) -> Solid {
    let paints = &shop.paints;
    let (half, depth, top) = (0.75, 0.33, 0.94);
    let sheet = rounded_cuboid(vec3(-half, -depth, top - 0.04), vec3(half, depth, top), 0.02).paint(&paints.blue_cloth);
    let cloth = &paints.blue_cloth;
    let long = |k: u32| parts::folds(shop, 2.0 * half, 0.52, cloth, seed * 8 + k).at(vec3(-half, -depth, top - 0.005));
    let short = |k: u32| {
        parts::folds(shop, 2.0 * depth, 0.56, cloth, seed * 8 + k).turn_z(90.0).at(vec3(-half, -depth, top - 0.005))
    };
    let leg = bar(vec3(half - 0.08, depth - 0.08, 0.08), vec3(half - 0.08, depth - 0.08, top - 0.05), 0.02);
    let legs = leg.both_x().both_y().paint(&paints.steel);
    let on_top = union([
        tray(shop, 0.52, 0.36, seed * 4 + 1).at(vec3(-0.45, -0.10, top)),
        tray(shop, 0.46, 0.34, seed * 4 + 2).at(vec3(0.10, -0.12, top)),
        bowl(0.10, 0.09).at(vec3(0.46, 0.18, top)).paint(&paints.steel),
        bowl(0.13, 0.07).at(vec3(0.55, -0.13, top)).paint(&paints.brushed),
        bowl(0.075, 0.07).at(vec3(0.23, 0.21, top)).paint(&paints.blue),
        swabs(shop, 5).at(vec3(-0.02, 0.20, top)),
        kidney_dish(shop).turn_z(20.0).at(vec3(-0.30, 0.20, top)),
        jar(shop).at(vec3(-0.60, 0.22, top)),
        loose(shop, seed * 4 + 3).at(vec3(0.42, 0.0, top)),
    ]);
    union([sheet, long(1), long(2).mirror_y(), short(3), short(4).mirror_x(), legs, on_top])
        .and(parts::castors(shop, 1.3, 0.5, 0.08))
}

/// A rimmed tray on a green towel, set with instruments side by side across its width.
fn tray(shop: &Workshop, width: f32, depth: f32, seed: u32) -> Solid {
    let paints = &shop.paints;
    let (w, d) = (width * 0.5, depth * 0.5);
    let floor = shop.sheet(0.014);
    let dish = rounded_cuboid(vec3(-w, -d, 0.0), vec3(w, d, 0.05), 0.012);
    let dish = dish.minus(cuboid(vec3(-w + 0.02, -d + 0.02, floor), vec3(w - 0.02, d - 0.02, 0.3)));
    let towel = block(width - 0.07, depth - 0.07, 0.01).z(floor).paint(&paints.green_cloth);
    let step = 0.052_f32.max(3.2 * shop.voxel);
    let count = ((width - 0.09) / step) as u32;
    let set = (0..count).map(|i| {
        let turn = 8.0 * signed(hash(seed * 64 + i));
        let x = -0.5 * step * (count - 1) as f32 + step * i as f32;
        instrument(shop, depth * 0.72, hash(seed * 64 + i + 32)).turn_z(turn).at(vec3(x, 0.0, floor + 0.02))
    });
    union([dish.paint(&paints.brushed), towel, union(set)])
}

/// An instrument of about `length` along y, lying on the origin: clamp, scissors, forceps, scalpel or retractor.
fn instrument(shop: &Workshop, length: f32, choice: u32) -> Solid {
    let paints = &shop.paints;
    let (rod, l) = (shop.rod(0.0065), length * 0.5);
    let rings = |spread: f32| {
        let eye = torus(0.022_f32.max(2.0 * rod), rod).at(vec3(spread, -l + 0.02, 0.0));
        let shaft = bar(vec3(spread, -l + 0.045, 0.0), vec3(0.0, 0.25 * l, 0.0), rod);
        eye.and(shaft).both_x()
    };
    let solid = match choice % 5 {
        0 => rings(0.020).and(bar(vec3(0.0, 0.25 * l, 0.0), vec3(0.012, l, 0.004), rod)),
        1 => rings(0.026).and(bar(vec3(0.0, 0.25 * l, 0.0), vec3(0.016, 0.9 * l, 0.0), rod).both_x()),
        2 => bar(vec3(0.0, -l, 0.004), vec3(0.014, 0.0, 0.008), rod).and(bar(
            vec3(0.014, 0.0, 0.008),
            vec3(0.0, l, 0.0),
            rod,
        )),
        3 => {
            let handle = bar(vec3(0.0, -l, 0.0), vec3(0.0, 0.3 * l, 0.0), rod * 1.25).paint(&paints.blue);
            return handle.and(bar(vec3(0.0, 0.3 * l, 0.0), vec3(0.004, 0.8 * l, 0.0), rod).paint(&paints.steel));
        }
        _ => bars(&[vec3(0.0, -l, 0.0), vec3(0.0, 0.7 * l, 0.0), vec3(0.0, l, 0.03)], rod)
            .and(block(0.03, 0.09, 0.02).at(vec3(0.0, -0.7 * l, -0.008))),
    };
    solid.paint(&paints.steel)
}

/// Instruments that were put down where there was room.
fn loose(shop: &Workshop, seed: u32) -> Solid {
    union((0..3).map(|i| {
        let draw = |k: u32| signed(hash(seed * 16 + i * 4 + k));
        let place = vec3(0.04 * draw(0) + 0.05 * i as f32, 0.03 * draw(1), 0.012);
        instrument(shop, 0.17, hash(seed + i)).turn_z(70.0 * draw(2)).at(place)
    }))
}

/// An open bowl.
fn bowl(radius: f32, height: f32) -> Solid {
    let r = radius;
    revolve(&[(0.5 * r, 0.0), (0.85 * r, 0.4 * height), (r, height), (r + 0.012, height)])
        .minus(ellipsoid(vec3(r - 0.018, r - 0.018, height * 0.8)).z(height))
}

/// A kidney dish: a bent trough.
fn kidney_dish(shop: &Workshop) -> Solid {
    let bend: Vec<(f32, f32)> = (0..=6)
        .map(|i| {
            let (sin, cos) = sin_cos_degrees(-60.0 + 20.0 * i as f32);
            (sin * 0.11, cos * 0.11 - 0.11)
        })
        .collect();
    let shape = Profile::stroke(&bend, 0.12);
    let inner = shape.clone().offset(-0.018);
    let dish = extrude(shape, Axis::Z, 0.0, 0.05).minus(extrude(inner, Axis::Z, 0.022, 0.3));
    let swab = ellipsoid(vec3(0.035, 0.03, 0.02)).at(vec3(0.02, -0.01, 0.035));
    dish.paint(&shop.paints.steel)
        .and(swab.paint(&shop.paints.gauze))
        .and(ellipsoid(vec3(0.028, 0.025, 0.02)).at(vec3(-0.04, -0.02, 0.032)).paint(&shop.paints.red))
}

/// A stack of folded swabs.
fn swabs(shop: &Workshop, count: u32) -> Solid {
    let thick = 0.016_f32.max(1.5 * shop.voxel);
    let swab = |i: u32| {
        let turn = 14.0 * signed(hash(500 + i));
        rounded_cuboid(vec3(-0.055, -0.055, 0.0), vec3(0.055, 0.055, thick), 0.006).turn_z(turn).z(thick * i as f32)
    };
    union((0..count).map(swab)).paint(&shop.paints.gauze)
}

/// A jar of disinfectant with forceps standing in it.
fn jar(shop: &Workshop) -> Solid {
    let glass = cylinder(0.05, 0.13).minus(cylinder(0.032, 0.2).z(0.03)).paint(&shop.paints.orange);
    let forceps = bar(vec3(0.0, 0.0, 0.03), vec3(0.03, 0.02, 0.24), shop.rod(0.007));
    glass
        .and(forceps.and(bar(vec3(0.0, 0.0, 0.03), vec3(-0.02, 0.03, 0.22), shop.rod(0.007))).paint(&shop.paints.steel))
}

/// Two basins in a wheeled stand, one above the other's rim.
fn basin_stand(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let basin = bowl(0.19, 0.13).paint(&paints.brushed);
    let hoop = torus(0.2, 0.014).z(0.12).paint(&paints.steel);
    let water = cylinder(0.15, 0.03).z(0.05).paint(&paints.blue);
    let one = union([basin, hoop, water]).z(0.78);
    let post = bars(&[vec3(0.0, 0.0, 0.1), vec3(0.0, 0.0, 0.84), vec3(0.2, 0.0, 0.89)], 0.017);
    let both = one.at(vec3(0.4, 0.0, 0.0)).both_x().and(post.both_x().paint(&paints.steel));
    both.and(parts::star_base(shop, 0.3, 0.1))
}

/// A kick bucket: a steel pail in a ring on castors.
fn bucket(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let pail = cone(0.13, 0.175, 0.26).minus(cone(0.11, 0.16, 0.26).z(0.025)).z(0.09).paint(&paints.brushed);
    let bumper = torus(0.2, 0.028).z(0.16).paint(&paints.black);
    let bag = ellipsoid(vec3(0.12, 0.12, 0.06)).z(0.2).paint(&paints.gauze);
    let stained = ellipsoid(vec3(0.05, 0.045, 0.03)).at(vec3(0.03, 0.02, 0.25)).paint(&paints.red);
    let wheels = ring(4, &parts::castor(shop, 0.08).x(0.19));
    union([pail, bumper, bag, stained, wheels])
}

/// A foot step with a rubber top.
fn step(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let top = rounded_cuboid(vec3(-0.30, -0.17, 0.15), vec3(0.30, 0.17, 0.19), 0.015).paint(&paints.black);
    let edge = cuboid(vec3(-0.30, -0.175, 0.13), vec3(0.30, 0.175, 0.16)).paint(&paints.steel);
    let leg = bar(vec3(0.26, 0.14, 0.14), vec3(0.29, 0.16, 0.012), 0.018).both_x().both_y();
    union([top, edge, leg.paint(&paints.steel)])
}
