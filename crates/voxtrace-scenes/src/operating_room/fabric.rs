//! The room itself: the cavity with its door alcove and light recesses, the laminar-flow field and the fittings of the
//! ceiling.

use super::{DEPTH, HEIGHT, TABLE, WIDTH, Workshop, walls};
use crate::kit::{noise::*, *};
use glam::{Vec3, vec2, vec3};

/// Depth of the ceiling lights above the ceiling.
pub const LIGHT_RECESS: f32 = 0.02;
/// Half the edge of the laminar-flow field.
const FIELD: f32 = 1.55;
/// How far the laminar-flow field hangs below the ceiling.
pub const FIELD_DROP: f32 = 0.09;

/// Walls, floor, ceiling.
pub fn fabric(shop: &Workshop) -> Solid {
    let cavity = union([
        cuboid(Vec3::ZERO, vec3(WIDTH, DEPTH, HEIGHT)),
        walls::door_alcove(),
        walls::sink_niche(),
        lights(shop),
    ]);
    union([around(cavity).paint(&shop.paints.room), laminar_field(shop), plinth(shop), ceiling_fittings(shop)])
}

/// The recesses of the ceiling lights: four long ones around the field, the others along the walls. Those to the north
/// and east are dimmed, as surgeons like it who look at screens; the others are pairs of bright strips.
fn lights(shop: &Workshop) -> Solid {
    let recess = |length: f32, paint: &Paint| block(length, 0.27, 0.5 + LIGHT_RECESS).z(HEIGHT - 0.5).paint(paint);
    let (bright, dim) = (&shop.paints.strip_light, &shop.paints.dim_light);
    let out = FIELD + 0.32;
    let long = |paint: &Paint| recess(2.4, paint).y(-out);
    let around_field =
        long(bright).and(long(bright).turn_z(-90.0)).and(long(dim).turn_z(90.0)).and(long(dim).turn_z(180.0));
    let (south, north) = (1.0, DEPTH - 0.95);
    let along_walls = [
        (1.7, south, bright),
        (5.35, south, bright),
        (9.15, south, bright),
        (1.25, TABLE.y, bright),
        (1.7, north, bright),
        (5.35, north, dim),
        (9.15, north, dim),
        (9.75, TABLE.y, dim),
    ];
    let along_walls = along_walls.map(|(x, y, paint)| recess(1.2, paint).at(vec3(x, y, 0.0)));
    around_field.at(TABLE).and(union(along_walls))
}

/// Two strips of light along x in a dark panel: white so near to them would be a lamp too.
pub fn strip_light(p: &SurfacePoint, black: Ramp, light: Ramp) -> Tone {
    let lit = (p.at.y.abs() - 0.065).abs() < 0.016_f32.max(0.6 * p.voxel);
    if lit && at_the_bottom(p) { light.even(0.5, 0.5) } else { black.even(0.3, 0.5) }
}

/// A panel that shines faintly all over.
pub fn dim_light(p: &SurfacePoint, white: Ramp, light: Ramp) -> Tone {
    if at_the_bottom(p) { light.even(0.5, 0.5) } else { white.even(0.75, 0.5) }
}

/// Whether a place in a light's recess is on its (upper) bottom, not on its sides.
fn at_the_bottom(p: &SurfacePoint) -> bool {
    p.world.z > HEIGHT + LIGHT_RECESS - 0.3 * p.voxel
}

/// The supply-air field over the table: a frame, woven diffusers, a skirt of short panes.
fn laminar_field(shop: &Workshop) -> Solid {
    let frame = block(2.0 * FIELD, 2.0 * FIELD, FIELD_DROP).z(HEIGHT - FIELD_DROP);
    let recess = block(2.0 * FIELD - 0.2, 2.0 * FIELD - 0.2, 0.5).z(HEIGHT - FIELD_DROP - 0.47);
    let bars = cuboid(vec3(-FIELD, -0.03, 0.0), vec3(FIELD, 0.03, 0.05)).z(HEIGHT - FIELD_DROP);
    let cross = |i: f32| bars.y(i * 0.97);
    let grid = union([cross(-0.5), cross(0.5), cross(-0.5).turn_z(90.0), cross(0.5).turn_z(90.0)]);
    let pane = shop.sheet(0.015);
    let skirt = cuboid(vec3(-FIELD, FIELD - pane, HEIGHT - FIELD_DROP - 0.12), vec3(FIELD, FIELD, HEIGHT - 0.02));
    let skirt = ring(4, &skirt).paint(&shop.paints.enamel);
    let field = frame.minus(recess).paint(&shop.paints.diffuser);
    union([field, grid.paint(&shop.paints.steel), skirt]).at(vec3(TABLE.x, TABLE.y, 0.0))
}

/// The woven diffuser: fine dark dots in rows.
pub fn diffuser(p: &SurfacePoint, cloth: Ramp, shadow: Ramp) -> Tone {
    let uv = vec2(p.at.x, p.at.y) / p.voxel.max(0.02);
    let dot = (floor(uv.x) + floor(uv.y)) & 1 == 0 && floor(uv.x) % 2 == 0;
    if dot && p.at.z > HEIGHT - FIELD_DROP + 0.01 {
        shadow.even(0.9, 0.4)
    } else {
        cloth.even(0.55 + 0.1 * value_noise(p.world / 0.5, 81), 0.5)
    }
}

/// The coved foot of the walls and the bumper rails that keep beds off the tiles.
fn plinth(shop: &Workshop) -> Solid {
    let out = 0.02_f32.max(1.1 * shop.voxel);
    let edge = |width: f32, low: f32, high: f32| {
        let inner = cuboid(vec3(width, width, low - 1.0), vec3(WIDTH - width, DEPTH - width, high + 1.0));
        cuboid(vec3(-0.05, -0.05, low), vec3(WIDTH + 0.05, DEPTH + 0.05, high)).minus(inner)
    };
    let door = walls::door_alcove().and(walls::sink_niche());
    let rails = edge(0.03_f32.max(out), 0.84, 0.98).paint(&shop.paints.grey);
    edge(out, -0.05, 0.09).paint(&shop.paints.teal).and(rails).minus(door)
}

/// Smoke detectors, sprinklers, loudspeakers, air inlets, and the service duct in the corner.
fn ceiling_fittings(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let detector = revolve(&[(0.03, -0.055), (0.05, -0.04), (0.06, 0.0), (0.06, 0.05)]).paint(&paints.enamel);
    let sprinkler =
        revolve(&[(0.035, -0.07), (0.035, -0.05), (0.015, -0.045), (0.015, -0.01), (0.04, 0.0), (0.04, 0.04)]);
    let speaker = cylinder(0.12, 0.06).z(-0.018).paint(&paints.enamel);
    let speaker = speaker.and(cylinder(0.095, 0.06).z(-0.03).paint(&paints.grey));
    let slat = cuboid(vec3(-0.27, -0.012, -0.02), vec3(0.27, 0.012, 0.03));
    let grille = block(0.6, 0.6, 0.06).z(-0.015).paint(&paints.enamel).minus(block(0.54, 0.54, 0.06).z(-0.06));
    let grille = grille.and(row(9, vec3(0.0, 0.06, 0.0), &slat).y(-0.24).paint(&paints.grey));
    let top = |part: &Solid, x: f32, y: f32| part.at(vec3(x, y, HEIGHT));
    union([
        top(&detector, 2.4, 6.2),
        top(&detector, 8.6, 2.5),
        top(&sprinkler.paint(&paints.steel), 2.0, 2.6),
        top(&sprinkler.paint(&paints.steel), 8.7, 6.3),
        top(&speaker, 3.2, 1.4),
        top(&speaker, 7.6, 7.5),
        top(&grille, 3.4, 7.55),
        top(&grille, 7.3, 1.0),
        top(&grille, 0.9, 2.6),
        top(&grille, 9.9, 6.6),
        service_duct(shop),
    ])
}

/// A boxed duct in the north-west corner with a return-air grille near the floor, and one in the south-east.
fn service_duct(shop: &Workshop) -> Solid {
    let duct = |x: f32, y: f32| {
        let sign = if x < WIDTH * 0.5 { 1.0 } else { -1.0 };
        let half = 0.21;
        let shaft = block(2.0 * half, 2.0 * half, HEIGHT + 0.2).z(-0.1).paint(&shop.paints.room);
        let opening = cuboid(vec3(-0.15, -half - 0.1, 0.22), vec3(0.15, -half + 0.05, 0.72)).paint(&shop.paints.black);
        let slat = cuboid(vec3(-0.16, -half - 0.005, 0.0), vec3(0.16, -half + shop.sheet(0.02), 0.02));
        let slats = row(9, vec3(0.0, 0.0, 0.056), &slat).z(0.235).paint(&shop.paints.enamel);
        let grille = shaft.minus(opening).and(slats);
        (if sign > 0.0 { grille } else { grille.turn_z(180.0) }).at(vec3(x, y, 0.0))
    };
    let inset = 0.19;
    duct(inset, DEPTH - inset).and(duct(WIDTH - inset, inset))
}
