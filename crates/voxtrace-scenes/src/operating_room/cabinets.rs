//! Storage: the glazed cabinets of the north wall, open wire shelving, the counter of the south wall.

use super::{DEPTH, WIDTH, Workshop, anaesthesia, parts};
use crate::kit::*;
use glam::{vec2, vec3};

/// Everything that stores things.
pub fn cabinets(shop: &Workshop) -> Solid {
    let north = |part: Solid, x: f32| part.at(vec3(x, DEPTH - 0.01, 0.0));
    union([
        north(glazed(shop, 1, 0.0), 0.98),
        north(glazed(shop, 2, 0.35), 2.06),
        north(glazed(shop, 3, 0.0), 3.13),
        north(glazed(shop, 4, 0.2), 9.02),
        north(glazed(shop, 5, 0.0), 10.1),
        shelving(shop, 1.5, 11).turn_z(90.0).at(vec3(0.02, 5.35, 0.0)),
        shelving(shop, 1.3, 12).turn_z(90.0).at(vec3(0.02, 6.85, 0.0)),
        shelving(shop, 1.3, 13).turn_z(-90.0).at(vec3(WIDTH - 0.02, 5.85, 0.0)),
        counter(shop).turn_z(180.0).at(vec3(2.35, 0.01, 0.0)),
        shelving(shop, 1.3, 14).turn_z(180.0).at(vec3(8.8, 0.02, 0.0)),
    ])
}

/// A cabinet, 1.06 m wide and 2.15 m high, its back at y = 0: drawers below, shelves behind sliding panes above. The
/// panes are clear, and a scan sees through them; `open` is how far the right-hand frame is slid aside.
fn glazed(shop: &Workshop, seed: u32, open: f32) -> Solid {
    let paints = &shop.paints;
    let (half, depth, height, low) = (0.53, 0.46, 2.15, 0.72);
    let wall = shop.sheet(0.025);
    let shell = cuboid(vec3(-half, -depth, 0.0), vec3(half, 0.05, height)).paint(&paints.enamel);
    let inside = cuboid(vec3(-half + wall, -depth - 0.1, low), vec3(half - wall, -wall, height - 0.06));
    let lower = parts::drawers(shop, 1.02, 0.56, 2, &paints.enamel).x(0.0).at(vec3(0.0, -depth, 0.1));
    let foot = cuboid(vec3(-half - 0.1, -depth - 0.1, -0.1), vec3(half + 0.1, -depth + 0.05, 0.08));
    let shelf = cuboid(vec3(-half + 0.01, -depth + 0.05, 0.0), vec3(half - 0.01, -0.01, shop.sheet(0.02)));
    let step = (height - 0.06 - low) / 4.0;
    let shelves = row(3, vec3(0.0, 0.0, step), &shelf.z(low + step)).paint(&paints.steel);
    let contents = (0..4).map(|i| {
        let z = low + step * i as f32 + if i == 0 { 0.0 } else { shop.sheet(0.02) };
        let length = 2.0 * (half - wall);
        let items = parts::boxes(shop, length, 0.36, step - 0.05, &paints.boxes, seed * 16 + i);
        items.at(vec3(-half + wall, -depth + 0.06, z))
    });
    let pane = |x: f32, y: f32| {
        let frame =
            Profile::rectangle(vec2(x, low + 0.01), vec2(x + half - 0.01, height - 0.07)).offset(-0.02).outline(0.04);
        extrude(frame, Axis::Y, y, y + shop.sheet(0.02)).paint(&paints.steel)
    };
    let grip = bar(vec3(0.04, -depth - 0.02, 1.2), vec3(0.04, -depth - 0.02, 1.5), shop.rod(0.012)).x(-open);
    let cornice =
        rounded_cuboid(vec3(-half - 0.01, -depth - 0.02, height - 0.03), vec3(half + 0.01, 0.05, height + 0.03), 0.01);
    let on_top =
        parts::boxes(shop, 0.95, 0.4, 0.32, &paints.boxes, seed * 16 + 9).at(vec3(-0.48, -0.44, height + 0.03));
    union([
        shell.minus(inside).minus(foot),
        lower,
        shelves,
        union(contents),
        pane(-half + 0.005, -depth + 0.0),
        pane(0.005 - open, -depth - 0.025),
        grip.paint(&paints.grey),
        cornice.paint(&paints.enamel),
        on_top,
    ])
}

/// Wire shelving, 1.9 m high, `length` long, with boxes, bins and folders; its back at y = 0.
fn shelving(shop: &Workshop, length: f32, seed: u32) -> Solid {
    let paints = &shop.paints;
    let (half, depth) = (length * 0.5, 0.48);
    let rod = shop.rod(0.012);
    let post = cylinder(0.016, 1.9).at(vec3(half - 0.02, -0.02, 0.0)).and(cylinder(0.016, 1.9).at(vec3(
        half - 0.02,
        -depth,
        0.0,
    )));
    let wires = row(9, vec3(0.0, -0.0575, 0.0), &bar(vec3(-half, -0.02, 0.0), vec3(half, -0.02, 0.0), rod));
    let edge = bar(vec3(-half + 0.02, -0.02, 0.0), vec3(-half + 0.02, -depth, 0.0), rod).both_x();
    let tier = wires.and(edge).and(bar(vec3(-half, -depth, 0.05), vec3(half, -depth, 0.05), rod));
    let tiers = row(5, vec3(0.0, 0.0, 0.42), &tier.z(0.16));
    let at = |items: Solid, i: u32| items.at(vec3(-half + 0.04, -depth + 0.02, 0.16 + rod + 0.42 * i as f32));
    let inner = length - 0.08;
    let pack = |i: u32| parts::boxes(shop, inner, 0.42, 0.34, &paints.boxes, seed * 32 + i);
    let bins = |high: f32| {
        let count = (inner / 0.2) as u32;
        parts::bins(shop, count, inner / count as f32, 0.36, high)
    };
    let folders = |i: u32| {
        let folder = |k: u32| {
            let deep = 0.24 + 0.02 * (k * 7 % 3) as f32;
            block(0.055, deep, 0.29).paint(&paints.folders).at(vec3(0.06 + 0.066 * k as f32, 0.16, 0.0))
        };
        let count = (inner / 0.066 - 2.0) as u32;
        union((0..count).filter(|k| !(k * 5 + i).is_multiple_of(11)).map(folder))
    };
    let fourth = if seed.is_multiple_of(2) { folders(seed) } else { bins(0.18) };
    union([
        post.both_x().and(tiers).paint(&paints.steel),
        at(pack(0), 0),
        at(bins(0.2), 1),
        at(pack(2), 2),
        at(fourth, 3),
        at(pack(4), 4),
    ])
}

/// A counter with cupboards, a computer and papers; its back at y = 0, 2.6 m long.
fn counter(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let half = 1.3;
    let body = cuboid(vec3(-half, -0.56, 0.08), vec3(half, 0.05, 0.86)).paint(&paints.enamel);
    let knee = cuboid(vec3(-0.35, -0.7, -0.1), vec3(0.35, -0.1, 0.80));
    let foot = cuboid(vec3(-half + 0.02, -0.5, -0.05), vec3(half - 0.02, 0.05, 0.1)).paint(&paints.grey);
    let top = rounded_cuboid(vec3(-half - 0.01, -0.6, 0.86), vec3(half + 0.01, 0.05, 0.90), 0.012).paint(&paints.door);
    let unit = parts::drawers(shop, 0.46, 0.76, 4, &paints.enamel).at(vec3(0.59, -0.56, 0.09));
    let other = parts::drawers(shop, 0.46, 0.76, 2, &paints.enamel).at(vec3(1.06, -0.56, 0.09));
    let screen = parts::monitor(shop, 0.46, 0.28, &paints.screens.text(0.46, 0.28), &paints.black);
    let stand = cylinder(0.025, 0.2).and(block(0.22, 0.16, 0.02)).paint(&paints.black);
    let computer = union([screen.at(vec3(0.0, -0.24, 1.06)), stand.at(vec3(0.0, -0.17, 0.90))]);
    let desk = union([
        computer,
        parts::keyboard(shop).at(vec3(0.0, -0.44, 0.90)),
        ellipsoid(vec3(0.03, 0.05, 0.02)).at(vec3(0.3, -0.44, 0.91)).paint(&paints.black),
        parts::boxes(shop, 0.8, 0.3, 0.3, &paints.boxes, 301).at(vec3(0.45, -0.4, 0.90)),
        parts::boxes(shop, 0.7, 0.3, 0.26, &paints.folders, 302).at(vec3(-1.2, -0.36, 0.90)),
        block(0.21, 0.3, 0.03).turn_z(9.0).at(vec3(-0.42, -0.4, 0.90)).paint(&paints.gauze),
    ]);
    let wall_box = cuboid(vec3(-half, -0.34, 1.55), vec3(half, 0.05, 2.2)).paint(&paints.enamel);
    let niche = cuboid(vec3(-half + 0.03, -0.5, 1.58), vec3(-0.02, -0.03, 2.17));
    let wall_box = wall_box.minus(niche.clone()).minus(niche.x(half - 0.01));
    let wall_contents = [0.0, half - 0.01].into_iter().enumerate().map(|(i, x)| {
        let items = |k: u32| parts::boxes(shop, 1.24, 0.26, 0.26, &paints.boxes, 310 + 2 * i as u32 + k);
        let board = cuboid(vec3(0.0, -0.02, 0.0), vec3(1.25, 0.28, shop.sheet(0.02))).paint(&paints.steel);
        union([items(0), board.z(0.28), items(1).z(0.28 + shop.sheet(0.02))]).at(vec3(-half + 0.03 + x, -0.31, 1.58))
    });
    union([
        body.minus(knee),
        foot.minus(cuboid(vec3(-0.35, -0.7, -0.1), vec3(0.35, -0.1, 0.80))),
        top,
        unit.clone(),
        unit.mirror_x(),
        other.clone(),
        other.mirror_x(),
        desk,
        wall_box,
        union(wall_contents),
        anaesthesia::stool(shop).at(vec3(0.1, -0.75, 0.0)),
    ])
}
