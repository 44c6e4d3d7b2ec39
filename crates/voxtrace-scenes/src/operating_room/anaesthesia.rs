//! The anaesthetist's workplace at the head of the table: the machine with ventilator and monitors, the drug trolley,
//! infusion stands with pumps, the stool.

use super::{TABLE, Workshop, parts};
use crate::kit::*;
use glam::{Vec3, vec3};

/// Where the machine stands.
const MACHINE: Vec3 = vec3(7.75, 5.25, 0.0);

/// Everything at the head end.
pub fn workplace(shop: &Workshop) -> Solid {
    union([
        machine(shop).turn_z(-62.0).at(MACHINE),
        breathing_hoses(shop),
        infusion_stand(shop, 3).turn_z(-40.0).at(vec3(6.95, 3.35, 0.0)),
        infusion_stand(shop, 2).turn_z(-120.0).at(vec3(6.75, 5.75, 0.0)),
        drug_trolley(shop).turn_z(-60.0).at(vec3(8.75, 6.65, 0.0)),
        stool(shop).at(vec3(7.25, 4.25, 0.0)),
        lines(shop),
    ])
}

/// The anaesthesia machine.
fn machine(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.36, -0.30, 0.14), vec3(0.36, 0.32, 0.86), 0.03).paint(&paints.enamel);
    let foot = rounded_cuboid(vec3(-0.40, -0.38, 0.09), vec3(0.40, 0.36, 0.17), 0.03).paint(&paints.grey);
    let drawers = parts::drawers(shop, 0.56, 0.50, 3, &paints.ivory).at(vec3(0.06, -0.30, 0.24));
    let top = rounded_cuboid(vec3(-0.40, -0.42, 0.86), vec3(0.40, 0.32, 0.90), 0.02).paint(&paints.brushed);
    let column = rounded_cuboid(vec3(-0.36, 0.02, 0.88), vec3(0.36, 0.34, 1.38), 0.03).paint(&paints.enamel);
    let shelf = rounded_cuboid(vec3(-0.40, -0.10, 1.38), vec3(0.40, 0.36, 1.42), 0.015).paint(&paints.grey);
    let rail = bar(vec3(0.42, -0.3, 0.8), vec3(0.42, 0.3, 0.8), shop.rod(0.014)).both_x().paint(&paints.steel);
    let vitals = parts::monitor(shop, 0.50, 0.34, &paints.screens.vitals(0.50, 0.34), &paints.ivory);
    let second = parts::monitor(shop, 0.34, 0.26, &paints.screens.text(0.34, 0.26), &paints.black);
    let ventilator = parts::monitor(shop, 0.32, 0.24, &paints.screens.ventilator(0.32, 0.24), &paints.grey);
    let neck = cylinder(0.035, 0.14).at(vec3(0.08, 0.12, 1.40)).paint(&paints.grey);
    let side_arm = bars(&[vec3(-0.36, 0.15, 1.1), vec3(-0.56, 0.0, 1.12), vec3(-0.62, -0.12, 1.2)], 0.025);
    let parts_above = union([
        vitals.turn_x(8.0).at(vec3(0.08, 0.02, 1.50)),
        second.turn_z(-30.0).at(vec3(-0.62, -0.14, 1.12)),
        ventilator.at(vec3(0.10, 0.0, 1.06)),
        neck,
        side_arm.paint(&paints.steel),
        modules(shop).at(vec3(-0.27, -0.02, 1.42)),
    ]);
    let bottles = parts::gas_bottle(shop, &paints.gauze, &paints.gauze).x(-0.17).y(0.44);
    let bottles = bottles.and(parts::gas_bottle(shop, &paints.gauze, &paints.blue).x(0.13).y(0.44));
    let wheels = parts::castors(shop, 0.68, 0.62, 0.12);
    union([body, foot, drawers, top, column, shelf, rail, parts_above, bottles, wheels])
        .and(vaporizers(shop).at(vec3(-0.24, 0.0, 1.02)))
        .and(absorber(shop).at(vec3(-0.44, -0.16, 0.62)))
        .and(worktop(shop).z(0.90))
}

/// Three vaporizers with coloured dials, and the flow meters beside them.
fn vaporizers(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let one = |paint: &Paint| {
        let body = rounded_cuboid(vec3(-0.045, -0.09, 0.0), vec3(0.045, 0.04, 0.20), 0.015).paint(&paints.ivory);
        let dial = cylinder(0.042, 0.05).at(vec3(0.0, -0.03, 0.20)).paint(paint);
        let band = cuboid(vec3(-0.047, -0.094, 0.05), vec3(0.047, 0.0, 0.09)).paint(paint);
        union([body, dial, band])
    };
    union([one(&paints.yellow), one(&paints.violet).x(0.11)])
}

/// Plug-in modules beside the monitor.
fn modules(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let rack = rounded_cuboid(vec3(-0.10, 0.0, 0.0), vec3(0.10, 0.24, 0.34), 0.01).paint(&paints.grey);
    let module = cuboid(vec3(-0.085, -0.015, 0.0), vec3(0.085, 0.1, 0.085)).paint(&paints.ivory);
    let plug =
        |x: f32, paint: &Paint| extrude(Profile::Disc(0.018), Axis::Y, -0.04, 0.0).at(vec3(x, 0.0, 0.04)).paint(paint);
    let module = union([module, plug(-0.05, &paints.green), plug(0.0, &paints.blue), plug(0.05, &paints.red)]);
    rack.and(row(3, vec3(0.0, 0.0, 0.105), &module).z(0.02))
}

/// The carbon dioxide absorber with its canister, valves and the bellows under their dome.
fn absorber(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let canister = cylinder(0.085, 0.20).paint(&paints.gauze).and(cylinder(0.092, 0.03).z(0.20).paint(&paints.grey));
    let block_ = rounded_cuboid(vec3(-0.11, -0.10, 0.22), vec3(0.13, 0.10, 0.34), 0.02).paint(&paints.grey);
    let valve = |x: f32| cylinder(0.035, 0.06).at(vec3(x, -0.03, 0.33)).paint(&paints.glass);
    let rings: Vec<(f32, f32)> =
        (0..7).flat_map(|i| [(0.075, 0.032 * i as f32), (0.098, 0.032 * i as f32 + 0.016)]).collect();
    let bellows = revolve(&rings).z(0.38).paint(&paints.black);
    let bag = ellipsoid(vec3(0.085, 0.075, 0.14)).at(vec3(-0.2, -0.06, 0.05)).paint(&paints.green);
    let neck = bars(&[vec3(-0.1, -0.02, 0.28), vec3(-0.2, -0.06, 0.26), vec3(-0.2, -0.06, 0.17)], 0.025);
    union([canister, block_, valve(-0.05), valve(0.06), bellows.x(0.02).y(0.02), bag, neck.paint(&paints.grey)])
}

/// What lies on the machine's top: syringes in a dish, a laryngoscope, a roll of tape, a clip board.
fn worktop(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let dish = rounded_cuboid(vec3(-0.14, -0.10, 0.0), vec3(0.14, 0.10, 0.05), 0.02);
    let dish = dish.minus(cuboid(vec3(-0.12, -0.08, 0.025), vec3(0.12, 0.08, 0.2))).paint(&paints.steel);
    let rod = shop.rod(0.011);
    let syringe = bar(vec3(-0.08, 0.0, 0.0), vec3(0.05, 0.01, 0.0), rod).paint(&paints.gauze);
    let plunger = bar(vec3(0.05, 0.01, 0.0), vec3(0.10, 0.013, 0.0), shop.rod(0.007)).paint(&paints.blue);
    let syringes = row(3, vec3(0.0, 0.045, 0.0), &syringe.and(plunger)).at(vec3(0.0, -0.045, 0.04));
    let tape = torus(0.035, 0.02).at(vec3(0.26, -0.3, 0.02)).paint(&paints.gauze);
    let board = block(0.22, 0.30, shop.sheet(0.012)).turn_z(12.0).at(vec3(0.24, -0.2, 0.0)).paint(&paints.blue);
    let paper = block(0.19, 0.25, 0.01).turn_z(12.0).at(vec3(0.24, -0.21, shop.sheet(0.012))).paint(&paints.gauze);
    let scope = bars(&[vec3(-0.33, -0.36, 0.02), vec3(-0.25, -0.3, 0.02)], 0.017);
    let scope = scope.and(bar(vec3(-0.25, -0.3, 0.02), vec3(-0.32, -0.24, 0.03), shop.rod(0.012))).paint(&paints.steel);
    union([dish.and(syringes).at(vec3(-0.08, -0.25, 0.0)), tape, board, paper, scope])
}

/// Two corrugated hoses from the machine to the mask.
fn breathing_hoses(shop: &Workshop) -> Solid {
    let mask = TABLE + vec3(0.875, 0.0, 1.20);
    let machine = |dy: f32| vec3(7.28, 5.32 + dy, 0.98);
    let hose = |dy: f32, sag: f32| {
        let middle = (mask + machine(dy)) * 0.5 + vec3(0.05, dy, sag);
        let path = [
            mask,
            mask + vec3(0.05, 0.02 + dy * 0.3, 0.07),
            middle,
            machine(dy) + vec3(-0.12, -0.04, 0.07),
            machine(dy),
        ];
        parts::hose(&path, 0.021)
    };
    let filter = cylinder(0.035, 0.05).at(mask).paint(&shop.paints.green);
    union([hose(0.0, 0.12).paint(&shop.paints.gauze), hose(0.09, -0.02).paint(&shop.paints.blue), filter])
}

/// A stand with bags, bottles and `pumps` infusion pumps on its pole.
pub fn infusion_stand(shop: &Workshop, pumps: u32) -> Solid {
    let paints = &shop.paints;
    let rod = shop.rod(0.014);
    let pole = cylinder(rod, 2.06).and(cylinder(rod * 1.6, 0.9).z(0.1)).paint(&paints.steel);
    let hook = bars(&[vec3(0.0, 0.0, 2.05), vec3(0.12, 0.0, 2.05), vec3(0.19, 0.0, 2.09)], shop.rod(0.01));
    let hooks = ring(4, &hook).paint(&paints.steel);
    let bag = rounded_cuboid(vec3(-0.065, -0.028, -0.24), vec3(0.065, 0.028, 0.0), 0.026);
    let bag =
        bag.paint(&paints.gauze).and(cuboid(vec3(-0.045, -0.032, -0.16), vec3(0.045, 0.0, -0.07)).paint(&paints.blue));
    let blood = rounded_cuboid(vec3(-0.06, -0.026, -0.20), vec3(0.06, 0.026, 0.0), 0.024).paint(&paints.red);
    let bottle = parts::bottle(0.045, 0.22).turn_x(180.0).paint(&paints.ivory);
    let hung =
        union([bag.at(vec3(0.15, 0.0, 2.03)), blood.at(vec3(-0.15, 0.0, 2.03)), bottle.at(vec3(0.0, 0.15, 2.03))]);
    let pump = rounded_cuboid(vec3(-0.15, -0.13, 0.0), vec3(0.15, 0.03, 0.14), 0.015).paint(&paints.ivory);
    let screen = parts::monitor(shop, 0.13, 0.07, &paints.screens.text(0.13, 0.07), &paints.grey);
    let syringe = bar(vec3(-0.1, -0.145, 0.115), vec3(0.04, -0.145, 0.115), shop.rod(0.014)).paint(&paints.gauze);
    let knobs = row(3, vec3(0.035, 0.0, 0.0), &block(0.022, 0.03, 0.022)).at(vec3(0.07, -0.135, 0.03));
    let light = block(0.02, 0.03, 0.02).at(vec3(0.12, -0.135, 0.09)).paint(&paints.lamp_green);
    let pump = union([pump, screen.at(vec3(-0.06, -0.145, 0.025)), syringe, knobs.paint(&paints.grey), light]);
    let line = [
        vec3(0.15, 0.0, 1.79),
        vec3(0.14, -0.05, 1.6),
        vec3(0.11, -0.12, 1.35),
        vec3(0.16, -0.2, 1.0),
        vec3(0.05, -0.22, 0.8),
    ];
    let drip = parts::hose(&line, shop.rod(0.006)).paint(&paints.gauze);
    union([
        parts::star_base(shop, 0.30, 0.12),
        pole,
        hooks,
        hung,
        row(pumps, vec3(0.0, 0.0, 0.165), &pump).z(1.02),
        drip,
    ])
}

/// The drug trolley: drawers in colours, a worktop with bottles, a sharps bin.
fn drug_trolley(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.34, -0.24, 0.13), vec3(0.34, 0.24, 0.95), 0.02).paint(&paints.blue);
    let drawers = parts::drawers(shop, 0.62, 0.76, 5, &paints.enamel).at(vec3(0.0, -0.24, 0.16));
    let edge = Profile::Rectangle(glam::vec2(0.34, 0.24)).outline(0.03);
    let top = extrude(edge, Axis::Z, 0.95, 1.02).paint(&paints.grey);
    let vial = |x: f32, y: f32, paint: &Paint| parts::bottle(0.024, 0.10).at(vec3(x, y, 0.95)).paint(paint);
    let vials = (0..9).map(|i| {
        let paint = [&paints.gauze, &paints.orange, &paints.blue, &paints.ivory][i % 4];
        vial(-0.26 + 0.062 * (i % 5) as f32, 0.02 + 0.07 * (i / 5) as f32, paint)
    });
    let sharps = cone(0.075, 0.09, 0.2).paint(&paints.yellow).and(cylinder(0.085, 0.03).z(0.2).paint(&paints.red));
    let racks = parts::bins(shop, 5, 0.13, 0.12, 0.10).at(vec3(-0.325, 0.12, 1.30));
    let posts = cylinder(0.016, 0.62).at(vec3(0.32, 0.22, 0.95)).both_x();
    let shelf = cuboid(vec3(-0.34, 0.10, 1.27), vec3(0.34, 0.25, 1.30));
    let upper = posts.and(shelf).paint(&paints.steel);
    union([body, drawers, top, union(vials), sharps.at(vec3(0.22, -0.06, 0.95)), upper, racks])
        .and(parts::castors(shop, 0.56, 0.36, 0.13))
}

/// A round stool on five feet.
pub fn stool(shop: &Workshop) -> Solid {
    let seat = revolve(&[(0.15, 0.52), (0.185, 0.535), (0.19, 0.57), (0.17, 0.60), (0.0, 0.605)]);
    let foot_ring = torus(0.2, shop.rod(0.012)).z(0.24);
    let spokes = ring(3, &bar(vec3(0.02, 0.0, 0.24), vec3(0.2, 0.0, 0.24), shop.rod(0.01)));
    let stem = union([cylinder(0.026, 0.44).z(0.1), foot_ring, spokes]).paint(&shop.paints.steel);
    union([seat.paint(&shop.paints.cushion), stem, parts::star_base(shop, 0.28, 0.11)])
}

/// Cables and lines between machine, stands and patient.
fn lines(shop: &Workshop) -> Solid {
    let thin = shop.rod(0.008);
    let to_arm = [
        vec3(6.82, 3.28, 1.1),
        vec3(6.6, 3.35, 0.85),
        vec3(6.3, 3.55, 0.9),
        vec3(6.05, 3.75, 1.0),
        vec3(5.95, 3.95, 0.98),
    ];
    let leads =
        [vec3(7.4, 5.05, 1.5), vec3(7.2, 5.0, 1.15), vec3(6.9, 4.85, 0.95), vec3(6.55, 4.7, 0.9), vec3(6.2, 4.6, 0.98)];
    let supply = [vec3(7.95, 5.75, 0.5), vec3(7.85, 6.2, 0.25), vec3(7.6, 6.35, 0.6), vec3(7.45, 6.4, 1.2)];
    union([
        parts::hose(&to_arm, thin).paint(&shop.paints.gauze),
        parts::hose(&leads, thin).paint(&shop.paints.green),
        parts::hose(&supply, shop.rod(0.016)).paint(&shop.paints.blue),
        parts::hose(&supply.map(|p| p + vec3(0.06, 0.02, 0.0)), shop.rod(0.016)).paint(&shop.paints.yellow),
    ])
}
