//! What stands by for its turn: racks of sterile containers, the warming cabinet, lead aprons, the heart–lung machine,
//! spare infusion stands.

use super::{WIDTH, Workshop, anaesthesia, parts};
use crate::kit::{noise::*, *};
use glam::{vec2, vec3};

/// Everything that waits.
pub fn stores(shop: &Workshop) -> Solid {
    let stand = anaesthesia::infusion_stand(shop, 1);
    union([
        container_rack(shop, 1).turn_z(90.0).at(vec3(0.02, 2.55, 0.0)),
        container_rack(shop, 2).turn_z(90.0).at(vec3(0.02, 3.80, 0.0)),
        warming_cabinet(shop).turn_z(-90.0).at(vec3(WIDTH - 0.01, 7.25, 0.0)),
        aprons(shop).turn_z(180.0).at(vec3(4.65, 0.0, 0.0)),
        heart_lung_machine(shop).turn_z(-12.0).at(vec3(5.85, 6.55, 0.0)),
        stand.turn_z(-70.0).at(vec3(9.75, 0.75, 0.0)),
        stand.turn_z(-110.0).at(vec3(10.2, 1.1, 0.0)),
    ])
}

/// A rack of sterile containers in five tiers, two to a tier and some on top of them; its back at y = 0.
fn container_rack(shop: &Workshop, seed: u32) -> Solid {
    let paints = &shop.paints;
    let (half, depth) = (0.6, 0.5);
    let post = cylinder(0.02, 2.05).at(vec3(half - 0.02, -0.03, 0.0)).and(cylinder(0.02, 2.05).at(vec3(
        half - 0.02,
        -depth + 0.02,
        0.0,
    )));
    let board = cuboid(vec3(-half, -depth, 0.0), vec3(half, -0.01, shop.sheet(0.02)));
    let tiers = row(5, vec3(0.0, 0.0, 0.45), &board.z(0.12));
    let draw = |i: u32| unit(hash(seed * 64 + i));
    let places = (0..5u32).flat_map(|tier| (0..2u32).map(move |side| (tier, side)));
    let containers = places.filter(|&(tier, side)| draw(tier * 2 + side) > 0.08).map(|(tier, side)| {
        let high = mix(0.13, 0.26, draw(20 + tier * 2 + side));
        let turn = 6.0 * (draw(40 + tier * 2 + side) - 0.5);
        let at = vec3(-0.29 + 0.58 * side as f32, -0.26, 0.12 + 0.45 * tier as f32 + shop.sheet(0.02));
        let lower = container(shop, high).turn_z(turn);
        let stacked = high < 0.18;
        (if stacked { lower.and(container(shop, 0.13).turn_z(-turn).z(high + 0.005)) } else { lower }).at(at)
    });
    union([post.both_x().and(tiers).paint(&paints.steel), union(containers)])
}

/// A sterile container: a metal tub with a coloured lid, handles, a label and a seal.
fn container(shop: &Workshop, height: f32) -> Solid {
    let paints = &shop.paints;
    let tub = rounded_cuboid(vec3(-0.26, -0.17, 0.0), vec3(0.26, 0.17, height * 0.8), 0.02).paint(&paints.brushed);
    let lid = rounded_cuboid(vec3(-0.27, -0.18, height * 0.76), vec3(0.27, 0.18, height), 0.02).paint(&paints.bins);
    let thick = 0.8 * shop.voxel;
    let label = cuboid(vec3(-0.2, -0.17 - thick, 0.3 * height), vec3(-0.04, -0.15, 0.65 * height)).paint(&paints.gauze);
    let seal = cuboid(vec3(-0.03, -0.19, 0.6 * height), vec3(0.03, -0.15, 0.85 * height)).paint(&paints.grey);
    let rod = shop.rod(0.008);
    let handle = bars(
        &[
            vec3(0.08, -0.17, 0.55 * height),
            vec3(0.08, -0.205, 0.45 * height),
            vec3(0.2, -0.205, 0.45 * height),
            vec3(0.2, -0.17, 0.55 * height),
        ],
        rod,
    );
    union([tub, lid, label, seal, handle.paint(&paints.steel)])
}

/// A steel cabinet that keeps blankets and fluids warm: two doors with panes, clear as a scan leaves them.
fn warming_cabinet(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let (half, depth, height) = (0.55, 0.58, 1.92);
    let wall = shop.sheet(0.03);
    let shell = rounded_cuboid(vec3(-half, -depth, 0.06), vec3(half, 0.05, height), 0.012).paint(&paints.brushed);
    let inside = |low: f32, high: f32| {
        cuboid(vec3(-half + wall + 0.04, -depth - 0.1, low), vec3(half - wall - 0.04, -wall, high))
    };
    let frame = |low: f32, high: f32| {
        let opening = Profile::rectangle(vec2(-half + 0.05, low), vec2(half - 0.05, high)).outline(0.05);
        let frame = extrude(opening, Axis::Y, -depth - 0.02, -depth + 0.02).paint(&paints.steel);
        let rod = shop.rod(0.014);
        let at = |x: f32, z: f32| vec3(half - 0.06, -depth - 0.02 - x, z);
        let middle = (low + high) * 0.5;
        let handle = bars(
            &[at(0.0, middle - 0.12), at(0.05, middle - 0.1), at(0.05, middle + 0.1), at(0.0, middle + 0.12)],
            rod,
        );
        frame.and(handle.paint(&paints.black))
    };
    // Folded blankets below, bottles above.
    let draw = |i: u32| unit(hash(700 + i));
    let blankets = (0..2u32).flat_map(|pile| (0..9u32).map(move |i| (pile, i))).map(|(pile, i)| {
        let wide = 0.40 + 0.04 * draw(pile * 16 + i);
        let paint = if pile == 0 { &paints.blue_cloth } else { &paints.gauze };
        let fold = rounded_cuboid(vec3(-wide * 0.5, -0.2, 0.0), vec3(wide * 0.5, 0.2, 0.062), 0.028);
        fold.paint(paint).at(vec3(-0.23 + 0.46 * pile as f32, -0.32, 0.21 + 0.064 * i as f32))
    });
    let board = cuboid(vec3(-half + 0.03, -depth + 0.05, 0.0), vec3(half - 0.03, -0.02, shop.sheet(0.02)));
    let bottles = (0..2u32).flat_map(|shelf| (0..2u32).flat_map(move |r| (0..8u32).map(move |i| (shelf, r, i))));
    let bottles = bottles.filter(|&(shelf, r, i)| draw(64 + shelf * 32 + r * 8 + i) > 0.15).map(|(shelf, r, i)| {
        let paint = [&paints.gauze, &paints.ivory, &paints.blue][(shelf + i / 3) as usize % 3];
        let at = vec3(-0.39 + 0.112 * i as f32, -0.42 + 0.14 * r as f32, 1.04 + shop.sheet(0.02) + 0.36 * shelf as f32);
        parts::bottle(0.048, 0.25).paint(paint).at(at)
    });
    let panel = parts::monitor(shop, 0.16, 0.06, &paints.screens.text(0.16, 0.06), &paints.black);
    let feet = block(0.08, 0.08, 0.1).at(vec3(0.48, -0.5, 0.0)).both_x().paint(&paints.black);
    union([
        shell.minus(inside(0.18, 0.88)).minus(inside(1.04, 1.76)),
        frame(0.18, 0.88),
        frame(1.04, 1.76),
        union(blankets),
        board.z(1.40).paint(&paints.steel),
        union(bottles),
        panel.at(vec3(0.0, -depth - 0.03, 1.81)),
        feet,
        parts::boxes(shop, 1.0, 0.45, 0.34, &paints.boxes, 801).at(vec3(-0.5, -0.52, height)),
    ])
}

/// Lead aprons on a wall rack, one beside the other.
fn aprons(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let rail = bar(vec3(-0.75, -0.22, 1.98), vec3(0.75, -0.22, 1.98), shop.rod(0.018));
    let bracket = bar(vec3(0.68, -0.22, 1.98), vec3(0.68, 0.03, 2.05), shop.rod(0.016)).both_x();
    let colors = [&paints.blue_cloth, &paints.violet, &paints.green_cloth, &paints.teal, &paints.red, &paints.blue];
    let hung = colors.into_iter().enumerate().map(|(i, paint)| {
        let long = 0.86 + 0.12 * unit(hash(900 + i as u32));
        let half_coat =
            Profile::polygon(&[(0.0, -0.06), (0.09, -0.02), (0.21, -0.08), (0.25, -0.3), (0.24, -long), (0.0, -long)]);
        let coat = extrude(half_coat.mirrored().offset(0.005), Axis::Y, -0.035, 0.035);
        let belt = cuboid(vec3(-0.252, -0.05, -0.52), vec3(0.252, 0.05, -0.48)).paint(&paints.black);
        let hanger = bars(&[vec3(-0.2, 0.0, -0.06), vec3(0.0, 0.0, 0.04), vec3(0.2, 0.0, -0.06)], shop.rod(0.012));
        let all = union([coat.paint(paint), belt, hanger.paint(&paints.steel)]);
        all.turn_z(62.0 + 14.0 * unit(hash(910 + i as u32))).at(vec3(-0.6 + 0.24 * i as f32, -0.26, 1.97))
    });
    union([rail.and(bracket).paint(&paints.steel), union(hung)])
}

/// A heart–lung machine: four roller pumps on a console, a mast with a reservoir and an oxygenator, screens, tubes.
fn heart_lung_machine(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let base = rounded_cuboid(vec3(-0.62, -0.26, 0.13), vec3(0.62, 0.26, 0.52), 0.03).paint(&paints.enamel);
    let stripe = cuboid(vec3(-0.625, -0.265, 0.30), vec3(0.625, 0.265, 0.35)).paint(&paints.blue);
    let deck = cuboid(vec3(-0.64, -0.28, 0.52), vec3(0.64, 0.28, 0.55)).paint(&paints.brushed);
    let body = rounded_cuboid(vec3(-0.13, -0.2, 0.0), vec3(0.13, 0.22, 0.26), 0.025).paint(&paints.ivory);
    let race = torus(0.10, 0.022).at(vec3(0.0, -0.04, 0.275)).paint(&paints.gauze);
    let rotor = cylinder(0.06, 0.06).at(vec3(0.0, -0.04, 0.26)).paint(&paints.steel);
    let screen = parts::monitor(shop, 0.14, 0.07, &paints.screens.text(0.14, 0.07), &paints.grey);
    let knob = extrude(Profile::Disc(0.026), Axis::Y, -0.25, -0.15).at(vec3(0.06, 0.0, 0.06)).paint(&paints.black);
    let pump = union([body, race, rotor, screen.at(vec3(-0.01, -0.215, 0.15)), knob]);
    let pumps = row(4, vec3(0.3, 0.0, 0.0), &pump).at(vec3(-0.45, 0.0, 0.55));
    let mast = cylinder(0.022, 1.25).at(vec3(-0.5, 0.24, 0.5)).both_x();
    let beam = bar(vec3(-0.55, 0.24, 1.7), vec3(0.55, 0.24, 1.7), shop.rod(0.02));
    let shelf = cuboid(vec3(-0.5, 0.1, 1.32), vec3(0.1, 0.3, 1.35));
    let frame = union([mast, beam, shelf]).paint(&paints.steel);
    let reservoir = union([
        revolve(&[(0.03, -0.14), (0.09, -0.05), (0.12, 0.12), (0.12, 0.24)]).paint(&paints.gauze),
        revolve(&[(0.035, -0.13), (0.094, -0.05), (0.115, 0.06)]).paint(&paints.red),
        cylinder(0.13, 0.04).z(0.24).paint(&paints.blue),
    ]);
    let oxygenator = cylinder(0.06, 0.22).paint(&paints.red).and(cylinder(0.066, 0.04).z(0.2).paint(&paints.grey));
    let vitals = parts::monitor(shop, 0.36, 0.24, &paints.screens.ventilator(0.36, 0.24), &paints.grey);
    let tube = |x: f32, paint: &Paint| {
        let path = [
            vec3(x, -0.04, 0.86),
            vec3(x + 0.06, -0.22, 1.0),
            vec3(0.2, -0.2, 1.12),
            vec3(0.36, -0.06, 1.1),
            vec3(0.4, -0.02, 1.2),
        ];
        parts::hose(&path, shop.rod(0.013)).paint(paint)
    };
    let lines = union([
        tube(-0.45, &paints.red),
        tube(-0.15, &paints.blue),
        tube(0.15, &paints.red),
        tube(0.45, &paints.gauze),
    ]);
    union([base, stripe, deck, pumps, frame, reservoir.at(vec3(0.38, 0.04, 1.3)), oxygenator.at(vec3(0.2, 0.12, 0.86))])
        .and(vitals.at(vec3(-0.2, 0.16, 1.40)))
        .and(lines)
        .and(parts::castors(shop, 1.1, 0.42, 0.13))
}
