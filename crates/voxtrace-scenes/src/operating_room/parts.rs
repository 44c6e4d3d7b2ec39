//! Parts that many things share: monitors, castors, hoses, bottles, drawers, boxes in rows. Furniture stands on the origin
//! and looks towards −y.

use super::{Workshop, screens};
use crate::kit::{noise::*, *};
use glam::{Vec3, vec2, vec3};

/// A flat monitor whose picture, `width` × `height`, has the middle of its lower edge at the origin.
pub fn monitor(shop: &Workshop, width: f32, height: f32, picture: &Paint, case: &Paint) -> Solid {
    let frame = 0.022_f32.max(1.4 * shop.voxel);
    let (half, thick) = (width * 0.5 + frame, 0.055_f32.max(4.0 * shop.voxel));
    let body = rounded_cuboid(vec3(-half, 0.0, -frame), vec3(half, thick, height + frame), 0.012).paint(case);
    let recess = screens::recess(shop.voxel);
    let screen = cuboid(vec3(-width * 0.5, -0.2, 0.0), vec3(width * 0.5, recess, height)).paint(picture);
    let back = rounded_cuboid(
        vec3(-half * 0.6, thick - 0.01, 0.1 * height),
        vec3(half * 0.6, thick + 0.05, 0.9 * height),
        0.02,
    );
    body.minus(screen).and(back.paint(case))
}

/// A hose or cable through all points, smoothly (a Catmull–Rom spline).
pub fn hose(points: &[Vec3], radius: f32) -> Solid {
    const STEPS: usize = 7;
    let at = |i: usize| points[i.clamp(1, points.len()) - 1];
    let mut path = vec![points[0]];
    for i in 1..points.len() {
        let (a, b, c, d) = (at(i - 1), at(i), at(i + 1), at(i + 2));
        for step in 1..=STEPS {
            let t = step as f32 / STEPS as f32;
            let bend =
                (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * t * t + (b * 3.0 - a - c * 3.0 + d) * t * t * t;
            path.push(b + bend * 0.5);
        }
    }
    bars(&path, radius)
}

/// A cable on the floor through the points (x, y).
pub fn floor_cable(shop: &Workshop, points: &[(f32, f32)], radius: f32) -> Solid {
    let radius = shop.rod(radius);
    let points: Vec<Vec3> = points.iter().map(|&(x, y)| vec3(x, y, radius * 0.8)).collect();
    hose(&points, radius)
}

/// A castor, `height` high.
pub fn castor(shop: &Workshop, height: f32) -> Solid {
    let wheel = extrude(Profile::Disc(height * 0.42), Axis::X, -0.018, 0.018).z(height * 0.42);
    let fork = block(0.06, 0.05, height * 0.45).z(height * 0.6);
    wheel.paint(&shop.paints.black).and(fork.paint(&shop.paints.grey))
}

/// Castors under the corners of a rectangle.
pub fn castors(shop: &Workshop, width: f32, depth: f32, height: f32) -> Solid {
    castor(shop, height).at(vec3(width * 0.5, depth * 0.5, 0.0)).both_x().both_y()
}

/// A base of five feet with castors, as stools and stands have it; its hub is `height` high.
pub fn star_base(shop: &Workshop, reach: f32, height: f32) -> Solid {
    let rod = shop.rod(0.02);
    let leg = bar(vec3(0.0, 0.0, height), vec3(reach, 0.0, height * 0.75), rod).paint(&shop.paints.steel);
    let wheel = castor(shop, height * 0.75).at(vec3(reach, 0.0, 0.0));
    ring(5, &leg.and(wheel)).turn_z(11.0)
}

/// A stack of drawers, `count` high, each with a handle: the front of a cart.
pub fn drawers(shop: &Workshop, width: f32, height: f32, count: u32, paint: &Paint) -> Solid {
    let each = height / count as f32;
    let gap = (0.8 * shop.voxel).max(0.008);
    let (half, thick) = (width * 0.5 - gap, 0.02_f32.max(1.2 * shop.voxel));
    let front = cuboid(vec3(-half, -thick, gap), vec3(half, 0.02, each - gap)).paint(paint);
    let rod = shop.rod(0.009);
    let grip = vec3(width * 0.28, -thick - 2.2 * rod, each * 0.62);
    let handle = bar(vec3(-grip.x, grip.y, grip.z), grip, rod).paint(&shop.paints.steel);
    let posts = bar(grip, vec3(grip.x, 0.0, grip.z), rod).both_x().paint(&shop.paints.steel);
    row(count, vec3(0.0, 0.0, each), &union([front, handle, posts]))
}

/// A bottle, `height` high.
pub fn bottle(radius: f32, height: f32) -> Solid {
    let r = radius;
    revolve(&[
        (r * 0.9, 0.0),
        (r, 0.02 * height),
        (r, 0.62 * height),
        (r * 0.45, 0.78 * height),
        (r * 0.45, 0.9 * height),
        (r * 0.52, 0.9 * height),
        (r * 0.52, height),
    ])
}

/// A gas cylinder with its valve.
pub fn gas_bottle(shop: &Workshop, body: &Paint, shoulder: &Paint) -> Solid {
    let top = revolve(&[(0.115, 0.95), (0.112, 1.02), (0.08, 1.12), (0.035, 1.18), (0.035, 1.22)]).paint(shoulder);
    let valve = cylinder(0.03, 0.09).z(1.2).and(bar(vec3(-0.07, 0.0, 1.26), vec3(0.07, 0.0, 1.26), shop.rod(0.018)));
    union([cylinder(0.115, 0.96).paint(body), top, valve.paint(&shop.paints.brushed)])
}

/// Boxes side by side along x from 0 to `length`, up to `height` high and `depth` deep, all different; `seed` chooses.
pub fn boxes(shop: &Workshop, length: f32, depth: f32, height: f32, paint: &Paint, seed: u32) -> Solid {
    let draw = |i: u32, k: u32| unit(hash(seed.wrapping_mul(977) + i * 8 + k));
    let mut parts = Vec::new();
    let (mut x, mut i) = (0.01, 0);
    loop {
        let width = mix(0.07, 0.24, draw(i, 0) * draw(i, 1).max(0.3)).max(3.0 * shop.voxel);
        if x + width > length {
            break;
        }
        let (high, deep) = (mix(0.45, 0.97, draw(i, 2)) * height, mix(0.6, 0.95, draw(i, 3)) * depth);
        // Every box stands a little askew; now and then one is missing.
        if draw(i, 4) > 0.1 {
            let turn = (draw(i, 5) - 0.5) * 5.0;
            let middle = vec3(x + width * 0.5, 0.04 * depth + deep * 0.5 + 0.1 * depth * draw(i, 6), 0.0);
            let piece =
                |z: f32, high: f32, w: f32| block(w - 0.008, deep, high).paint(paint).turn_z(turn).at(middle).z(z);
            if high < 0.55 * height && draw(i, 7) > 0.4 {
                parts.push(piece(0.0, high * 0.9, width));
                parts.push(piece(high * 0.9, high * 0.8, width * 0.92));
            } else {
                parts.push(piece(0.0, high, width));
            }
        }
        x += width + 0.008;
        i += 1;
    }
    union(parts)
}

/// Open-fronted storage bins in a row along x.
pub fn bins(shop: &Workshop, count: u32, width: f32, depth: f32, height: f32) -> Solid {
    let wall = shop.sheet(0.012);
    let outer = block(width * 0.92, depth, height);
    let inner = block(width * 0.92 - 2.0 * wall, depth - 2.0 * wall, height).z(wall);
    let scoop = block(width, 0.1, height).turn_x(20.0).at(vec3(0.0, -depth * 0.5, height * 0.55));
    let label = cuboid(
        vec3(-width * 0.25, -depth * 0.5 - 0.5 * shop.voxel, height * 0.2),
        vec3(width * 0.25, -depth * 0.5 + 0.02, height * 0.42),
    );
    let filling =
        rounded_cuboid(vec3(-width * 0.36, -depth * 0.4, wall), vec3(width * 0.36, depth * 0.4, height * 0.62), 0.02);
    let bin = outer.minus(inner).minus(scoop).paint(&shop.paints.bins);
    let bin = union([bin, filling.paint(&shop.paints.boxes), label.paint(&shop.paints.gauze)]);
    row(count, vec3(width, 0.0, 0.0), &bin.at(vec3(width * 0.5, depth * 0.5, 0.0)))
}

/// A keyboard, 42 cm wide, lying on the origin.
pub fn keyboard(shop: &Workshop) -> Solid {
    let body = rounded_cuboid(vec3(-0.21, -0.07, 0.0), vec3(0.21, 0.07, 0.022), 0.008).paint(&shop.paints.grey);
    let key = block(0.03, 0.03, 0.02).z(0.012).paint(&shop.paints.black);
    let keys =
        union((0..3).map(|j| row(8, vec3(0.046, 0.0, 0.0), &key).at(vec3(-0.161, 0.042 * (j as f32 - 1.0), 0.0))));
    body.and(keys)
}

/// A socket plate, 16 cm × 8 cm, on a wall that looks towards −y; the origin is its middle.
pub fn socket(shop: &Workshop) -> Solid {
    let thick = 0.012_f32.max(1.1 * shop.voxel);
    let plate = rounded_cuboid(vec3(-0.08, -thick, -0.04), vec3(0.08, 0.03, 0.04), 0.006).paint(&shop.paints.enamel);
    let hole = extrude(Profile::Disc(0.024), Axis::Y, -0.1, 0.0).paint(&shop.paints.grey);
    plate.minus(hole.x(0.038).both_x())
}

/// A gas outlet with its coloured collar, on a wall that looks towards −y.
pub fn gas_outlet(shop: &Workshop, collar: &Paint) -> Solid {
    let round = |radius, out: f32| extrude(Profile::Disc(radius), Axis::Y, -out, 0.03);
    union([
        round(0.045, 0.02).paint(&shop.paints.enamel),
        round(0.032, 0.04).paint(collar),
        round(0.018_f32.max(shop.voxel), 0.065).paint(&shop.paints.steel),
    ])
}

/// Folds of a hanging cloth along x from 0 to `length`, hanging from z = 0 down to about −`drop`.
pub fn folds(shop: &Workshop, length: f32, drop: f32, paint: &Paint, seed: u32) -> Solid {
    let count = (length / 0.085) as u32;
    let step = length / count as f32;
    let fold = |i: u32| {
        let draw = |k: u32| unit(hash(seed.wrapping_mul(331) + i * 4 + k));
        let radius = mix(0.030, 0.052, draw(0)).max(shop.voxel);
        let (x, out) = ((i as f32 + 0.5) * step, 0.03 * (draw(1) - 0.7));
        bar(
            vec3(x, 0.0, -radius),
            vec3(x + 0.03 * (draw(2) - 0.5), out, radius - drop * mix(0.94, 1.0, draw(3))),
            radius,
        )
    };
    let sheet = cuboid(vec3(0.0, -0.02, -drop * 0.94), vec3(length, 0.02, 0.0));
    union((0..count).map(fold)).and(sheet).paint(paint)
}

/// An upright profile of rounded rectangle, `width` × `depth`, standing on the origin.
pub fn pillar(width: f32, depth: f32, height: f32, radius: f32) -> Solid {
    let section = Profile::Rectangle(vec2(width * 0.5 - radius, depth * 0.5 - radius)).offset(radius);
    extrude(section, Axis::Z, 0.0, height)
}
