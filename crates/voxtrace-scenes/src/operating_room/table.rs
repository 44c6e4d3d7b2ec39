//! The operating table in the middle of the room, the patient under the drapes, the screen at the head, arm boards.

use super::{TABLE, Workshop, parts};
use crate::kit::*;
use glam::{vec2, vec3};

/// Height of the cushions' upper side.
pub const TOP: f32 = 0.93;

/// Table and patient; x towards the head, in the room's coordinates.
pub fn table(shop: &Workshop) -> Solid {
    union([base(shop), sections(shop), patient(shop), head_end(shop), arm_boards(shop)]).at(TABLE)
}

/// The foot and the telescoping column.
fn base(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let foot = union([
        rounded_cuboid(vec3(-0.62, -0.27, 0.03), vec3(0.55, 0.27, 0.13), 0.04),
        rounded_cuboid(vec3(-0.30, -0.22, 0.10), vec3(0.30, 0.22, 0.22), 0.06),
    ]);
    let cover = |width: f32, from: f32, to: f32| parts::pillar(width, width * 0.8, to - from, 0.04).z(from);
    let column =
        union([cover(0.40, 0.2, 0.42), cover(0.36, 0.4, 0.56), cover(0.32, 0.54, 0.68), cover(0.44, 0.66, 0.78)]);
    let pedal = row(4, vec3(0.12, 0.0, 0.0), &block(0.08, 0.09, 0.05)).at(vec3(-0.18, -0.33, 0.01));
    let wheels = parts::castor(shop, 0.09).at(vec3(0.5, 0.24, 0.0)).both_x().both_y();
    union([foot.paint(&paints.brushed), column.paint(&paints.steel), pedal.paint(&paints.yellow), wheels])
}

/// Frame, side rails and cushions of head, back, seat and the two legs, with gaps at the joints.
fn sections(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let plate = |from: f32, to: f32, half: f32| {
        let frame = cuboid(vec3(from + 0.01, -half, 0.80), vec3(to - 0.01, half, 0.84)).paint(&paints.steel);
        let cushion = rounded_cuboid(vec3(from, -half - 0.01, 0.845), vec3(to, half + 0.01, TOP), 0.03);
        frame.and(cushion.paint(&paints.cushion))
    };
    let leg = plate(-1.06, -0.40, 0.12).y(0.145).both_y();
    let rail = |from: f32, to: f32| {
        let rail = cuboid(vec3(from, 0.31, 0.795), vec3(to, 0.335, 0.845));
        let spacer = cuboid(vec3(from + 0.06, 0.25, 0.81), vec3(from + 0.1, 0.32, 0.83));
        rail.and(spacer).both_y().paint(&paints.steel)
    };
    let joint = |x: f32| extrude(Profile::Disc(0.045), Axis::Y, -0.30, 0.30).at(vec3(x, 0.0, 0.79));
    let joints = union([joint(-0.40), joint(0.02), joint(0.74)]).paint(&paints.grey);
    union([plate(-0.38, 0.0, 0.27), plate(0.02, 0.72, 0.27), plate(0.75, 1.06, 0.15), leg, joints])
        .and(rail(-1.0, -0.44).and(rail(-0.36, 0.70)))
}

/// The draped patient: body, sheet with hanging folds, the window of the operation.
fn patient(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let blob = |x: f32, y: f32, z: f32, rx: f32, ry: f32, rz: f32| ellipsoid(vec3(rx, ry, rz)).at(vec3(x, y, z));
    let thigh = bar(vec3(-0.22, 0.12, 0.98), vec3(-0.62, 0.13, 1.0), 0.125);
    let shin = bar(vec3(-0.62, 0.13, 1.0), vec3(-1.0, 0.12, 0.97), 0.10);
    let foot = bar(vec3(-1.03, 0.11, 0.98), vec3(-1.08, 0.12, 1.13), 0.062);
    // A sheet stretched over two legs sags between them.
    let web = cuboid(vec3(-1.02, -0.12, 0.9), vec3(-0.2, 0.12, 1.02));
    let chest = blob(0.42, 0.0, 0.98, 0.44, 0.31, 0.19);
    let belly = blob(0.08, 0.0, 0.99, 0.36, 0.29, 0.175);
    let hips = blob(-0.18, 0.0, 0.97, 0.30, 0.30, 0.165);
    let arm = bar(vec3(0.45, 0.30, 0.97), vec3(0.05, 0.33, 0.95), 0.07);
    let sheet = rounded_cuboid(vec3(-1.15, -0.39, 0.915), vec3(0.70, 0.39, 0.955), 0.02);
    let body = union([thigh.and(shin).and(foot).and(arm).both_y(), web, chest, belly, hips, sheet]);
    let field = body.at(vec3(-0.12, 0.0, -0.955)).paint(&paints.field).at(vec3(0.12, 0.0, 0.955));
    let green = &paints.green_cloth;
    let side = parts::folds(shop, 1.85, 0.40, green, 1).at(vec3(-1.15, -0.385, 0.95));
    let other = parts::folds(shop, 1.85, 0.43, green, 2).at(vec3(-1.15, 0.385, 0.95));
    let end = parts::folds(shop, 0.78, 0.46, green, 3).turn_z(90.0).at(vec3(-1.15, -0.39, 0.95));
    union([field, side, other, end, retractors(shop).at(vec3(0.12, 0.0, 1.165))])
}

/// A ring of retractors around the incision, clamps on the edge of the window.
fn retractors(shop: &Workshop) -> Solid {
    let rod = shop.rod(0.008);
    let blade = bar(vec3(0.0, 0.03, 0.005), vec3(0.0, 0.11, 0.03), rod).and(bar(
        vec3(0.0, 0.11, 0.03),
        vec3(0.0, 0.17, 0.0),
        rod,
    ));
    let clamp =
        bar(vec3(0.0, 0.0, 0.0), vec3(0.02, 0.11, 0.012), rod).and(torus(0.022, rod).at(vec3(0.03, 0.14, 0.014)));
    let corner = clamp.at(vec3(0.17, 0.12, -0.01));
    union([blade.x(0.04).both_x().both_y(), corner.both_x().both_y()]).paint(&shop.paints.brushed)
}

/// The screen between surgeon and anaesthetist: a cloth over a bar on two posts; behind it the patient's head with cap,
/// mask and breathing hose.
fn head_end(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let rod = shop.rod(0.014);
    let post = bar(vec3(0.72, 0.33, 0.82), vec3(0.72, 0.40, 1.46), rod).both_y();
    let top = bar(vec3(0.72, -0.62, 1.46), vec3(0.72, 0.62, 1.46), rod);
    let cloth = parts::folds(shop, 1.24, 0.56, &paints.green_cloth, 4).turn_z(90.0).at(vec3(0.72, -0.62, 1.48));
    let pillow = ellipsoid(vec3(0.16, 0.17, 0.06)).at(vec3(0.93, 0.0, 0.97)).paint(&paints.gauze);
    let face = ellipsoid(vec3(0.12, 0.085, 0.10)).at(vec3(0.92, 0.0, 1.08)).paint(&paints.skin);
    let cap = ellipsoid(vec3(0.085, 0.10, 0.108)).at(vec3(0.985, 0.0, 1.07)).paint(&paints.green);
    let neck = bar(vec3(0.72, 0.0, 1.02), vec3(0.86, 0.0, 1.04), 0.062).paint(&paints.skin);
    let mask = cone(0.055, 0.03, 0.05).at(vec3(0.875, 0.0, 1.155)).paint(&paints.teal);
    union([post.and(top).paint(&paints.steel), cloth, pillow, face, cap, neck, mask])
}

/// Arm boards to both sides, one with the patient's arm on it.
fn arm_boards(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let board = cuboid(vec3(-0.07, 0.0, 0.86), vec3(0.07, 0.62, 0.89)).paint(&paints.steel);
    let pad = rounded_cuboid(vec3(-0.085, 0.02, 0.89), vec3(0.085, 0.64, 0.95), 0.025).paint(&paints.cushion);
    let hinge = cylinder(0.04, 0.14).at(vec3(0.0, 0.02, 0.76)).paint(&paints.grey);
    let board = union([board, pad, hinge]);
    let forearm = bars(&[vec3(0.0, 0.05, 1.0), vec3(0.0, 0.36, 0.99)], 0.052).paint(&paints.green_cloth);
    let hand = ellipsoid(vec3(0.035, 0.085, 0.03)).at(vec3(0.0, 0.50, 0.99)).paint(&paints.skin);
    let wrist = bar(vec3(0.0, 0.36, 0.99), vec3(0.0, 0.45, 0.985), 0.033).paint(&paints.skin);
    let strap = extrude(Profile::Rectangle(vec2(0.09, 0.052)), Axis::Y, 0.24, 0.29).z(0.985).paint(&paints.blue);
    let with_arm = union([board.clone(), forearm, hand, wrist, strap]);
    union([with_arm.turn_z(-22.0).at(vec3(0.58, 0.33, 0.0)), board.mirror_y().turn_z(16.0).at(vec3(0.58, -0.33, 0.0))])
}
