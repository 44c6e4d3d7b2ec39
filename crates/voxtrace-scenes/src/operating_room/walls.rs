//! What hangs on and lies in the walls: the sliding door, the scrub sinks in their niche, supply rails with sockets and
//! gas outlets, the X-ray light box, clock, notices, panels and small fittings.

use super::{ALCOVE, DEPTH, HEIGHT, WIDTH, Workshop, parts, screens};
use crate::kit::*;
use glam::{Vec3, vec2, vec3};

/// Middle of the door along the east wall.
const DOOR: f32 = 2.75;
const DOOR_WIDTH: f32 = 2.0;
const DOOR_HEIGHT: f32 = 2.28;
/// The niche of the sinks in the south wall: from and to, x.
const NICHE: (f32, f32) = (5.6, 7.6);

/// The doorway's part of the cavity.
pub fn door_alcove() -> Solid {
    cuboid(vec3(WIDTH - 0.3, DOOR - DOOR_WIDTH * 0.5, 0.0), vec3(WIDTH + ALCOVE, DOOR + DOOR_WIDTH * 0.5, DOOR_HEIGHT))
}

/// The part of the cavity above the sinks.
pub fn sink_niche() -> Solid {
    cuboid(vec3(NICHE.0, -ALCOVE, 0.55), vec3(NICHE.1, 0.3, 2.1))
}

/// All fittings.
pub fn fittings(shop: &Workshop) -> Solid {
    let north = |part: Solid, x: f32, z: f32| part.at(vec3(x, DEPTH, z));
    let east = |part: Solid, y: f32, z: f32| part.turn_z(-90.0).at(vec3(WIDTH, y, z));
    let south = |part: Solid, x: f32, z: f32| part.turn_z(180.0).at(vec3(x, 0.0, z));
    let west = |part: Solid, y: f32, z: f32| part.turn_z(90.0).at(vec3(0.0, y, z));
    union([
        door(shop),
        exit_sign(shop),
        sinks(shop),
        north(light_box(shop), 4.62, 1.52),
        north(clock(shop), 7.15, 2.72),
        north(supply_rail(shop, 2.9), 4.25, 1.12),
        north(notice_board(shop), 7.0, 1.35),
        east(control_panel(shop), 4.5, 1.35),
        east(dispenser(shop), 1.45, 1.25),
        east(glove_boxes(shop), 1.05, 1.25),
        east(phone(shop), 4.98, 1.4),
        west(supply_rail(shop, 1.4), 0.5, 1.12),
        south(supply_rail(shop, 2.2), 10.2, 1.12),
        south(phone(shop), 7.95, 1.4),
        north(camera_dome(shop), 10.5, HEIGHT - 0.2),
    ])
}

/// Two sliding leaves with windows in a steel frame, on a rail, with a kick plate.
fn door(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let (half, thick) = (DOOR_WIDTH * 0.5, 0.05);
    // A leaf looks towards −y and hangs between x = 0 and `half`; it is turned to the east wall below.
    let leaf = cuboid(vec3(0.012, 0.0, 0.02), vec3(half, thick, DOOR_HEIGHT)).paint(&paints.door);
    let window = Profile::rectangle(vec2(0.28, 1.02), vec2(0.74, 1.9));
    let pane = extrude(window.clone().offset(-0.02).offset(0.02), Axis::Y, -0.1, 0.016).paint(&paints.glass);
    let frame = extrude(window.outline(0.04), Axis::Y, -0.012, 0.03).paint(&paints.steel);
    let kick = cuboid(vec3(0.05, -0.008, 0.06), vec3(half - 0.03, 0.02, 0.34)).paint(&paints.brushed);
    let grip = bar(vec3(0.1, -0.05, 0.85), vec3(0.1, -0.05, 1.35), shop.rod(0.016)).paint(&paints.steel);
    let posts = bar(vec3(0.1, -0.05, 0.9), vec3(0.1, 0.0, 0.9), shop.rod(0.012));
    let posts = posts.and(bar(vec3(0.1, -0.05, 1.3), vec3(0.1, 0.0, 1.3), shop.rod(0.012))).paint(&paints.steel);
    let stripe = cuboid(vec3(0.012, -0.006, 1.97), vec3(half, 0.02, 2.05)).paint(&paints.teal);
    let leaf = union([leaf.minus(pane), frame, kick, grip, posts, stripe]);
    let jamb = cuboid(vec3(half, -0.14, 0.0), vec3(half + 0.09, 0.2, DOOR_HEIGHT + 0.08));
    let lintel = cuboid(vec3(-half - 0.09, -0.14, DOOR_HEIGHT), vec3(half + 0.09, 0.2, DOOR_HEIGHT + 0.1));
    let drive =
        rounded_cuboid(vec3(-half - 0.3, -0.26, DOOR_HEIGHT + 0.08), vec3(half + 0.3, 0.1, DOOR_HEIGHT + 0.30), 0.02);
    let eye = block(0.12, 0.04, 0.05).at(vec3(0.0, -0.27, DOOR_HEIGHT + 0.12)).paint(&paints.black);
    let drive = drive.paint(&paints.enamel).and(eye);
    let frame = jamb.both_x().and(lintel).paint(&paints.steel);
    union([leaf.both_x().y(0.045), frame, drive]).turn_z(-90.0).at(vec3(WIDTH + ALCOVE * 0.2, DOOR, 0.0))
}

/// The lit sign over the door.
fn exit_sign(shop: &Workshop) -> Solid {
    let sign = block(0.36, 0.05, 0.2).z(-0.1).paint(&shop.paints.exit_sign);
    let back = block(0.40, 0.05, 0.24).at(vec3(0.0, 0.03, -0.12)).paint(&shop.paints.enamel);
    sign.and(back).turn_z(-90.0).at(vec3(WIDTH - 0.03, DOOR, DOOR_HEIGHT + 0.5))
}

/// Steel scrub sinks for two, with taps, a mirror, soap.
fn sinks(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let (low, high) = NICHE;
    let middle = (low + high) * 0.5;
    let half = (high - low) * 0.5 - 0.03;
    // Modelled towards −y, the wall at y = 0.
    let trough = rounded_cuboid(vec3(-half, -0.5, 0.62), vec3(half, 0.2, 0.95), 0.03);
    let bowl = rounded_cuboid(vec3(0.08, -0.45, 0.70), vec3(half - 0.06, 0.02, 1.2), 0.06).both_x();
    let trough = trough.minus(bowl).paint(&paints.brushed);
    let splash = cuboid(vec3(-half, 0.07, 0.9), vec3(half, 0.2, 1.22)).paint(&paints.brushed);
    let mirror = cuboid(vec3(-half + 0.1, 0.09, 1.32), vec3(half - 0.1, 0.2, 2.0)).paint(&paints.glass);
    let rod = shop.rod(0.014);
    let spout = [
        vec3(0.0, 0.08, 1.08),
        vec3(0.0, -0.05, 1.12),
        vec3(0.0, -0.14, 1.22),
        vec3(0.0, -0.24, 1.2),
        vec3(0.0, -0.27, 1.1),
    ];
    let lever = bar(vec3(0.1, -0.02, 1.14), vec3(0.16, -0.26, 1.16), rod);
    let tap = union([parts::hose(&spout, rod * 1.2), lever, cylinder(0.03, 0.08).at(vec3(0.1, 0.02, 1.07))]);
    let soap = rounded_cuboid(vec3(-0.06, -0.03, 1.25), vec3(0.06, 0.1, 1.5), 0.02).paint(&paints.enamel);
    let soap = soap.and(bar(vec3(0.0, -0.05, 1.24), vec3(0.0, -0.02, 1.3), rod).paint(&paints.grey));
    let station = tap.paint(&paints.steel).and(soap.at(vec3(-0.28, 0.04, 0.0)));
    let drain = bars(&[vec3(0.46, -0.2, 0.66), vec3(0.46, -0.2, 0.4), vec3(0.46, 0.05, 0.36)], 0.03).both_x();
    let legs = drain.paint(&paints.steel);
    let all = union([trough, splash, mirror, station.x(0.46), station.x(-0.46), legs]);
    all.turn_z(180.0).at(vec3(middle, 0.0, 0.0))
}

/// A light box for four X-ray films; the origin is its lower left corner on the wall.
fn light_box(shop: &Workshop) -> Solid {
    let (width, height, thick) = (4.0 * 0.38, 0.52, 0.10);
    let recess = screens::recess(shop.voxel);
    let case = rounded_cuboid(vec3(-0.05, -thick, -0.06), vec3(width + 0.05, 0.05, height + 0.05), 0.012);
    let films = cuboid(vec3(0.0, -1.0, 0.0), vec3(width, recess, height)).paint(&shop.paints.films);
    let clips = cuboid(vec3(0.0, -thick - 0.012, height - 0.012), vec3(width, -thick + 0.02, height + 0.03));
    let switches = row(4, vec3(0.38, 0.0, 0.0), &block(0.05, 0.04, 0.03).at(vec3(0.19, -thick, -0.05)));
    let case = case.paint(&shop.paints.enamel).minus(films.y(-thick));
    union([case, clips.paint(&shop.paints.steel), switches.paint(&shop.paints.grey)])
}

/// A round clock; the origin is its middle on the wall.
fn clock(shop: &Workshop) -> Solid {
    let plate = |radius, out: f32| extrude(Profile::Disc(radius), Axis::Y, -out, 0.05);
    let rim = extrude(Profile::Disc(0.18).outline(0.03_f32.max(1.5 * shop.voxel)), Axis::Y, -0.065, 0.05);
    plate(0.18, 0.04).paint(&shop.paints.dial).and(rim.paint(&shop.paints.black))
}

/// A medical supply rail along x: a channel with sockets and gas outlets, and a rail below with baskets on it.
fn supply_rail(shop: &Workshop, length: f32) -> Solid {
    let paints = &shop.paints;
    let out = 0.07;
    let channel = rounded_cuboid(vec3(0.0, -out, 0.0), vec3(length, 0.05, 0.24), 0.015).paint(&paints.ivory);
    let face = |part: Solid, x: f32, z: f32| part.at(vec3(x, -out, z));
    let sockets = (0..(length / 0.62) as u32).map(|i| face(parts::socket(shop), 0.2 + 0.62 * i as f32, 0.14));
    let collars = [&paints.blue, &paints.yellow, &paints.black, &paints.gauze];
    let outlets = (0..(length / 0.62) as usize).map(|i| {
        let outlet = |k: usize| parts::gas_outlet(shop, collars[(i * 2 + k) % 4]);
        face(outlet(0), 0.42 + 0.62 * i as f32, 0.13).and(face(outlet(1), 0.56 + 0.62 * i as f32, 0.13))
    });
    let rail = cuboid(vec3(0.0, -out - 0.035, -0.16), vec3(length, -out - 0.012, -0.11));
    let bracket = cuboid(vec3(0.0, -out - 0.02, -0.17), vec3(0.04, 0.02, -0.10));
    let rail = rail.and(row(3, vec3(length * 0.48, 0.0, 0.0), &bracket)).paint(&paints.steel);
    union([channel, union(sockets), union(outlets), rail, flow_meter(shop).at(vec3(length * 0.3, -out - 0.06, -0.2))])
}

/// An oxygen flow meter with its humidifier bottle, hung on a rail.
fn flow_meter(shop: &Workshop) -> Solid {
    let bottle = parts::bottle(0.045, 0.16).z(-0.12).paint(&shop.paints.blue);
    let tube = cylinder(0.02, 0.22).z(0.05).paint(&shop.paints.gauze);
    union([bottle, tube, ball(0.028).z(0.28).paint(&shop.paints.green)])
}

/// A white board, 1.5 m × 0.9 m, with the day's list; the origin is its lower left corner.
fn notice_board(shop: &Workshop) -> Solid {
    let (width, height) = (1.5, 0.88);
    let thick = 0.02_f32.max(1.2 * shop.voxel);
    let board = cuboid(vec3(0.0, -thick, 0.0), vec3(width, 0.05, height)).paint(&shop.paints.poster);
    let frame = Profile::rectangle(Vec3::ZERO.truncate(), vec2(width, height)).outline(0.03);
    let tray = block(0.6, 0.08, 0.02_f32.max(1.5 * shop.voxel)).at(vec3(width * 0.5, -0.04, -0.03));
    let pen = bar(vec3(-0.05, 0.0, 0.0), vec3(0.05, 0.0, 0.0), shop.rod(0.01)).at(vec3(width * 0.5, -0.05, 0.01));
    let pens = union([pen.paint(&shop.paints.red), pen.x(0.16).paint(&shop.paints.blue)]);
    union([board, extrude(frame, Axis::Y, -thick - 0.012, 0.03).and(tray).paint(&shop.paints.steel), pens])
}

/// The theatre's control panel: a screen and rows of buttons.
fn control_panel(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let plate = rounded_cuboid(vec3(-0.28, -0.05, -0.32), vec3(0.28, 0.05, 0.36), 0.012).paint(&paints.brushed);
    let screen = parts::monitor(shop, 0.36, 0.24, &paints.screens.text(0.36, 0.24), &paints.black);
    let button = extrude(Profile::Disc(0.02), Axis::Y, -0.07, 0.0);
    let column = |i: u32| row(3, vec3(0.0, 0.0, -0.07), &button).at(vec3(-0.2 + 0.08 * i as f32, 0.0, -0.08));
    let [a, b, c] = [&paints.enamel, &paints.lamp_green, &paints.yellow].map(|paint| column(0).paint(paint));
    let buttons = union([a.clone(), b.x(0.08), a.x(0.16), a.x(0.24), c.x(0.32), column(5).paint(&paints.red)]);
    union([plate, screen.at(vec3(0.0, -0.08, 0.06)), buttons])
}

/// A dispenser for disinfectant over a drip tray.
fn dispenser(shop: &Workshop) -> Solid {
    let body = rounded_cuboid(vec3(-0.06, -0.1, 0.0), vec3(0.06, 0.03, 0.26), 0.025).paint(&shop.paints.enamel);
    let lever = cuboid(vec3(-0.03, -0.2, 0.0), vec3(0.03, -0.08, 0.025_f32.max(1.5 * shop.voxel))).turn_x(-8.0);
    let tray = block(0.12, 0.14, 0.03).at(vec3(0.0, -0.09, -0.2)).paint(&shop.paints.steel);
    union([body, lever.paint(&shop.paints.blue), tray])
}

/// Three boxes of gloves in a wire rack.
fn glove_boxes(shop: &Workshop) -> Solid {
    let carton = block(0.24, 0.1, 0.12).y(-0.06).paint(&shop.paints.boxes);
    let glove = ellipsoid(vec3(0.06, 0.035, 0.03)).at(vec3(0.0, -0.115, 0.06)).paint(&shop.paints.gauze);
    let rack = cuboid(vec3(-0.13, -0.015, -0.02), vec3(0.13, 0.02, 0.42)).paint(&shop.paints.steel);
    row(3, vec3(0.0, 0.0, 0.135), &carton.and(glove)).and(rack)
}

/// A wall telephone with its coiled cord.
fn phone(shop: &Workshop) -> Solid {
    let body = rounded_cuboid(vec3(-0.09, -0.05, -0.12), vec3(0.09, 0.03, 0.12), 0.015).paint(&shop.paints.ivory);
    let grip = bar(vec3(-0.05, -0.075, -0.09), vec3(-0.05, -0.075, 0.09), 0.022);
    let cord = [
        vec3(-0.05, -0.07, -0.1),
        vec3(-0.04, -0.06, -0.3),
        vec3(0.0, -0.05, -0.42),
        vec3(0.05, -0.05, -0.3),
        vec3(0.05, -0.03, -0.1),
    ];
    union([body, grip.and(parts::hose(&cord, shop.rod(0.012))).paint(&shop.paints.black)])
}

/// A dome camera under a bracket.
fn camera_dome(shop: &Workshop) -> Solid {
    let arm = cuboid(vec3(-0.04, -0.25, 0.0), vec3(0.04, 0.05, 0.06)).paint(&shop.paints.enamel);
    arm.and(ball(0.09).at(vec3(0.0, -0.22, -0.02)).paint(&shop.paints.black))
}
