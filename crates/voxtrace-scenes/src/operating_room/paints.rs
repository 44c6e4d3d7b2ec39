//! The theatre's colours: ramps of tile, steel, enamel, cloth and plastics, the lights, and the paints made of them.

use super::{
    fabric, screens,
    tiles::{ceiling_tiles, floor_tiles, wall_tiles},
};
use crate::kit::{noise::*, patterns::*, *};
use glam::Vec3;

/// Radiance of a lens of the surgical lamps, before the scene's light intensity.
const LENS: f32 = 50.0;
/// Radiance of the bright ceiling lights.
const STRIP_LIGHT: f32 = 24.0;
/// Radiance of the dimmed ceiling lights.
const DIM_LIGHT: f32 = 0.25;
/// Radiance of the light box behind the films.
const LIGHT_BOX: f32 = 0.16;

/// Every paint of the theatre.
pub struct Paints {
    pub room: Paint,
    pub strip_light: Paint,
    pub dim_light: Paint,
    pub diffuser: Paint,
    pub plaster: Paint,
    pub steel: Paint,
    pub brushed: Paint,
    pub enamel: Paint,
    pub ivory: Paint,
    pub grey: Paint,
    pub black: Paint,
    pub cushion: Paint,
    pub green_cloth: Paint,
    pub blue_cloth: Paint,
    pub field: Paint,
    pub skin: Paint,
    pub gauze: Paint,
    pub teal: Paint,
    pub door: Paint,
    pub glass: Paint,
    pub yellow: Paint,
    pub red: Paint,
    pub orange: Paint,
    pub violet: Paint,
    pub blue: Paint,
    pub green: Paint,
    pub boxes: Paint,
    pub bins: Paint,
    pub folders: Paint,
    pub dial: Paint,
    pub poster: Paint,
    pub lens: Paint,
    pub lamp_shell: Paint,
    pub films: Paint,
    pub exit_sign: Paint,
    pub lamp_green: Paint,
    pub lamp_red: Paint,
    pub screens: screens::Colors,
}

/// The colours, each a ramp of shades.
#[derive(Clone, Copy)]
struct Ramps {
    white: Ramp,
    mint: Ramp,
    teal: Ramp,
    floor: Ramp,
    steel: Ramp,
    enamel: Ramp,
    grey: Ramp,
    black: Ramp,
    green: Ramp,
    blue: Ramp,
    skin: Ramp,
    yellow: Ramp,
    red: Ramp,
    card: Ramp,
    pale: Ramp,
    violet: Ramp,
    orange: Ramp,
    glass: Ramp,
    door: Ramp,
    ivory: Ramp,
    lens: Ramp,
    strip: Ramp,
    dim: Ramp,
    film: Ramp,
    exit: Ramp,
    ember: Ramp,
}

impl Ramps {
    /// Enters the ramps into the palette.
    fn new(palette: &mut Palette) -> Self {
        Self {
            white: palette.ramp(&[[186, 186, 178], [217, 217, 209], [240, 240, 234]], 14),
            mint: palette.ramp(&[[112, 152, 140], [152, 189, 174], [186, 215, 202]], 13),
            teal: palette.ramp(&[[30, 92, 96], [56, 126, 128], [94, 160, 160]], 12),
            floor: palette.ramp(&[[88, 98, 104], [132, 142, 146], [172, 178, 178]], 13),
            steel: palette.ramp(&[[84, 88, 93], [144, 148, 152], [208, 211, 214]], 13),
            enamel: palette.ramp(&[[176, 178, 176], [210, 211, 208], [240, 240, 237]], 13),
            grey: palette.ramp(&[[56, 59, 64], [92, 95, 101], [134, 137, 142]], 12),
            black: palette.ramp(&[[13, 13, 15], [30, 30, 33], [56, 56, 60]], 12),
            green: palette.ramp(&[[14, 66, 52], [32, 108, 86], [66, 146, 120]], 12),
            blue: palette.ramp(&[[26, 62, 114], [50, 98, 156], [96, 144, 194]], 12),
            skin: palette.ramp(&[[122, 62, 30], [178, 108, 64], [222, 168, 128]], 8),
            yellow: palette.ramp(&[[158, 116, 14], [212, 168, 30], [242, 210, 80]], 8),
            red: palette.ramp(&[[104, 14, 16], [166, 32, 30], [206, 74, 60]], 8),
            card: palette.ramp(&[[128, 104, 74], [178, 154, 120], [216, 198, 168]], 10),
            pale: palette.ramp(&[[132, 162, 188], [170, 196, 214], [208, 224, 234]], 8),
            violet: palette.ramp(&[[62, 36, 104], [100, 66, 148], [146, 112, 184]], 6),
            orange: palette.ramp(&[[166, 74, 16], [214, 112, 34], [240, 152, 74]], 6),
            glass: palette.ramp(&[[8, 12, 18], [18, 25, 33], [34, 44, 54]], 10),
            door: palette.ramp(&[[76, 116, 138], [110, 150, 170], [150, 184, 198]], 12),
            ivory: palette.ramp(&[[184, 176, 152], [214, 207, 186], [236, 231, 214]], 8),
            lens: palette.glow(&[[255, 238, 214], [255, 247, 232]], 2, LENS),
            strip: palette.glow(&[[248, 250, 255], [255, 253, 248]], 3, STRIP_LIGHT),
            dim: palette.glow(&[[248, 250, 255], [255, 253, 248]], 2, DIM_LIGHT),
            film: palette.glow(&[[16, 20, 26], [92, 106, 122], [226, 236, 248]], 6, LIGHT_BOX),
            exit: palette.glow(&[[30, 220, 110]], 1, 0.14),
            ember: palette.glow(&[[255, 50, 30]], 1, 0.2),
        }
    }
}

impl Paints {
    /// The paints, and the palette that they use.
    pub fn new() -> (Self, Palette) {
        let mut palette = Palette::default();
        let ramps = Ramps::new(&mut palette);
        let screens = screens::Colors::new(&mut palette, ramps.glass);
        (Self::of_ramps(ramps, screens), palette)
    }

    fn of_ramps(ramps: Ramps, screens: screens::Colors) -> Self {
        let Ramps {
            white,
            mint,
            teal,
            floor,
            steel,
            enamel,
            grey,
            black,
            green,
            blue,
            skin,
            yellow,
            red,
            violet,
            orange,
            glass,
            door,
            ivory,
            lens,
            strip,
            dim,
            film,
            exit,
            ember,
            ..
        } = ramps;
        Self {
            room: room(white, mint, teal, floor),
            strip_light: Paint::new(move |p| fabric::strip_light(p, black, strip)),
            dim_light: Paint::new(move |p| fabric::dim_light(p, white, dim)),
            diffuser: Paint::new(move |p| fabric::diffuser(p, enamel, grey)),
            plaster: clouded(white.even(0.6, 0.5), 0.12, 0.8),
            steel: clouded(steel.even(0.58, 0.5), 0.2, 0.25),
            brushed: brushed(steel),
            enamel: clouded(enamel.even(0.6, 0.5), 0.12, 0.5),
            ivory: clouded(ivory.even(0.55, 0.5), 0.12, 0.5),
            grey: clouded(grey.even(0.5, 0.5), 0.12, 0.3),
            black: clouded(black.even(0.45, 0.5), 0.12, 0.3),
            cushion: clouded(black.even(0.55, 0.5), 0.25, 0.2),
            green_cloth: cloth(green, 0.5),
            blue_cloth: cloth(blue, 0.5),
            field: surgical_field(green, blue, skin, red),
            skin: clouded(skin.even(0.8, 0.4), 0.12, 0.1),
            gauze: cloth(white, 0.7),
            teal: clouded(teal.even(0.5, 0.5), 0.12, 0.4),
            door: clouded(door.even(0.5, 0.5), 0.12, 0.6),
            glass: panes(glass),
            yellow: clouded(yellow.even(0.55, 0.5), 0.12, 0.3),
            red: clouded(red.even(0.5, 0.5), 0.12, 0.3),
            orange: Paint::plain(orange.even(0.5, 0.5)),
            violet: Paint::plain(violet.even(0.5, 0.5)),
            blue: clouded(blue.even(0.5, 0.5), 0.1, 0.3),
            green: Paint::plain(green.even(0.6, 0.5)),
            boxes: boxes(&ramps),
            bins: bins(&ramps),
            folders: folders(&ramps),
            dial: Paint::new(move |p| screens::clock_face(p, white, black, red)),
            poster: Paint::new(move |p| screens::notice(p, white, grey, blue, orange)),
            lens: lamp_lens(lens, black),
            // Dark around the lenses: white so near to them would be a lamp too.
            lamp_shell: Paint::new(move |p| if p.at.z < 0.02 { black.even(0.3, 0.5) } else { enamel.even(0.6, 0.5) }),
            films: Paint::new(move |p| screens::films(p, film, steel)),
            exit_sign: Paint::new(move |p| screens::exit_sign(p, exit, white)),
            lamp_green: Paint::plain(exit.even(0.5, 0.0)),
            lamp_red: Paint::plain(ember.even(0.5, 0.0)),
            screens,
        }
    }
}

/// Labelled boxes of ten kinds.
fn boxes(ramps: &Ramps) -> Paint {
    let &Ramps { white, teal, black, green, blue, yellow, red, card, pale, violet, orange, .. } = ramps;
    one_of(vec![
        labelled(white, blue),
        labelled(card, black),
        labelled(pale, blue),
        labelled(white, green),
        labelled(blue, white),
        labelled(white, orange),
        labelled(violet, white),
        labelled(card, red),
        labelled(white, teal),
        labelled(yellow, black),
    ])
}

/// Plastic bins of four colours.
fn bins(ramps: &Ramps) -> Paint {
    let &Ramps { blue, yellow, red, pale, .. } = ramps;
    one_of(vec![
        varied(blue.even(0.5, 0.5), 0.12),
        varied(yellow.even(0.5, 0.5), 0.12),
        varied(red.even(0.5, 0.5), 0.12),
        varied(pale.even(0.5, 0.5), 0.12),
    ])
}

/// Folders of five colours.
fn folders(ramps: &Ramps) -> Paint {
    let &Ramps { grey, green, blue, red, orange, .. } = ramps;
    one_of(vec![
        varied(red.even(0.5, 0.5), 0.15),
        varied(blue.even(0.4, 0.5), 0.15),
        varied(grey.even(0.5, 0.5), 0.15),
        varied(green.even(0.5, 0.5), 0.15),
        varied(orange.even(0.5, 0.5), 0.15),
    ])
}

/// Glass of doors and windows.
fn panes(glass: Ramp) -> Paint {
    Paint::new(move |p| {
        // The room mirrored in the panes, as a scan sees it: lighter above, slanting streaks.
        let streak = smooth_step(0.2, 0.5, value_noise(Vec3::splat((p.at.x + p.at.y + p.at.z) / 0.35), 61));
        glass.even(0.3 + 0.25 * streak, 0.5)
    })
}

/// A lens of the surgical lamps, which glows in front.
fn lamp_lens(lens: Ramp, black: Ramp) -> Paint {
    Paint::new(move |p| {
        if p.at.z > super::lamps::LENS_DEPTH - 0.3 * p.voxel { lens.even(0.5, 0.5) } else { black.even(0.1, 0.4) }
    })
}

/// Floor, walls and ceiling, told apart by where they look.
fn room(white: Ramp, mint: Ramp, teal: Ramp, floor: Ramp) -> Paint {
    Paint::new(move |p| {
        let n = p.normal();
        if n.z > 0.7 {
            floor_tiles(p, floor, teal)
        } else if n.z < -0.7 {
            ceiling_tiles(p, white)
        } else {
            wall_tiles(p, white, mint, teal)
        }
    })
}

/// Brushed metal: streaks along x.
fn brushed(ramp: Ramp) -> Paint {
    Paint::new(move |p| {
        let streak = value_noise(Vec3::new(p.at.x / 0.6, p.at.y / 0.025, p.at.z / 0.025), 62);
        ramp.even(0.62 + 0.2 * streak + 0.12 * value_noise(p.world / 0.35, 63), 0.45)
    })
}

/// Cloth with wrinkles.
fn cloth(ramp: Ramp, level: f32) -> Paint {
    Paint::new(move |p| {
        let warp = Vec3::splat(value_noise(p.world / 0.3, 64)) * 0.08;
        let ridge = 1.0 - value_noise((p.world + warp) / Vec3::new(0.22, 0.11, 0.30), 65).abs() * 2.4;
        ramp.even(level + 0.2 * ridge.max(-0.6) + 0.08 * value_noise(p.world / 0.7, 66), 0.45)
    })
}

/// The drape over the patient: green, a blue sheet with a window in it, in which disinfected skin shows around the
/// incision. In coordinates of the patient: x towards the head, the window around the origin.
fn surgical_field(green: Ramp, blue: Ramp, skin: Ramp, red: Ramp) -> Paint {
    let (green_cloth, blue_cloth) = (cloth(green, 0.5), cloth(blue, 0.55));
    Paint::new(move |p| {
        let (x, y) = (p.at.x.abs(), p.at.y.abs());
        let ragged = 0.012 * value_noise(p.at / 0.05, 67);
        if p.at.z < 0.0 || x > 0.40 || y > 0.36 {
            green_cloth.tone(p)
        } else if x + ragged > 0.17 || y > 0.13 {
            blue_cloth.tone(p)
        } else if x < 0.10 && y + ragged < 0.026 {
            red.tone(0.25 + 0.2 * value_noise(p.at / 0.03, 68))
        } else {
            let stain = smooth_step(0.05, 0.16, x.max(y) + 2.0 * ragged);
            skin.even(0.42 + 0.3 * stain, 0.4)
        }
    })
}

/// A cardboard box: a band and a label of another ramp on the sides.
fn labelled(ramp: Ramp, print: Ramp) -> Paint {
    Paint::new(move |p| {
        let shade = 0.12 * (p.chance() - 0.5);
        let (u, v) = (p.at.x / 0.03 + p.chance() * 7.0, p.at.z);
        let band = 0.03 + 0.05 * fraction(p.chance() * 17.0);
        let text =
            v > band + 0.03 && v < band + 0.05 && !hash3(glam::IVec3::new(floor(u), 0, 0), p.seed).is_multiple_of(3);
        if (v > band && v < band + 0.02) || text { print.even(0.45, 0.5) } else { ramp.even(0.58 + shade, 0.5) }
    })
}
