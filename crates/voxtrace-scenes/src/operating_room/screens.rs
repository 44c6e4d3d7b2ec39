//! What is drawn rather than built: monitors with vital signs, X-ray films, the clock, signs and notices. Drawings lie
//! in the plane (x, z) of the panel that they are on.

use crate::kit::{noise::*, *};
use glam::{IVec3, Vec2, vec2};

/// Radiance of lines on screens, before the scene's light intensity.
const LINES: f32 = 0.16;
/// Radiance of pictures on screens.
const PICTURE: f32 = 0.11;

/// The lights of screens: lines in five colours, pictures in shades of grey and flesh.
#[derive(Clone, Copy)]
pub struct Colors {
    dark: Ramp,
    green: Ramp,
    cyan: Ramp,
    red: Ramp,
    yellow: Ramp,
    white: Ramp,
    scan: Ramp,
    flesh: Ramp,
}

/// How deep a screen lies behind its frame: enough that the frame's inner edge is told from the screen.
pub fn recess(voxel: f32) -> f32 {
    (0.8 * voxel).max(0.008)
}

/// A curve by its corners: (phase in [0, 1], height in [0, 1]).
type Curve = &'static [(f32, f32)];
/// A row of a monitor: colour, curve, its periods across the screen, the digits beside it.
type Trace = (Ramp, Curve, f32, &'static [u8]);

/// One beat of the electrocardiogram: (phase, height) from one beat to the next.
const HEART: Curve = &[
    (0.0, 0.3),
    (0.12, 0.3),
    (0.17, 0.42),
    (0.22, 0.3),
    (0.3, 0.3),
    (0.33, 0.18),
    (0.37, 1.0),
    (0.41, 0.02),
    (0.45, 0.3),
    (0.58, 0.3),
    (0.67, 0.5),
    (0.76, 0.3),
    (1.0, 0.3),
];
const PULSE: Curve = &[(0.0, 0.05), (0.2, 0.95), (0.36, 0.5), (0.44, 0.6), (1.0, 0.05)];
const BREATH: Curve = &[(0.0, 0.05), (0.12, 0.05), (0.2, 0.75), (0.58, 0.95), (0.64, 0.05), (1.0, 0.05)];
const FLOW: Curve = &[(0.0, 0.5), (0.05, 0.95), (0.35, 0.8), (0.38, 0.05), (0.6, 0.42), (1.0, 0.5)];

impl Colors {
    /// The colours, and what dark screens are made of.
    pub fn new(palette: &mut Palette, dark: Ramp) -> Self {
        let mut line = |color| palette.glow(&[color], 1, LINES);
        let [green, cyan, red] = [[40, 255, 90], [60, 220, 255], [255, 60, 50]].map(&mut line);
        let [yellow, white] = [[255, 220, 50], [235, 240, 255]].map(&mut line);
        let scan = palette.glow(&[[26, 30, 36], [130, 140, 150], [236, 242, 250]], 5, PICTURE);
        let flesh = palette.glow(&[[70, 14, 10], [190, 66, 48], [250, 170, 130]], 5, PICTURE);
        Self { dark, green, cyan, red, yellow, white, scan, flesh }
    }

    /// A patient monitor, `width` × `height`: four curves, each with its number.
    pub fn vitals(self, width: f32, height: f32) -> Paint {
        let rows: [Trace; 4] = [
            (self.green, HEART, 4.0, &[7, 2]),
            (self.red, PULSE, 4.0, &[1, 1, 8]),
            (self.cyan, PULSE, 4.0, &[9, 8]),
            (self.yellow, BREATH, 1.7, &[3, 6]),
        ];
        self.curves(width, height, rows)
    }

    /// A ventilator's screen: pressure, flow, volume, and the gas.
    pub fn ventilator(self, width: f32, height: f32) -> Paint {
        let rows: [Trace; 4] = [
            (self.yellow, BREATH, 2.3, &[1, 6]),
            (self.cyan, FLOW, 2.3, &[1, 2]),
            (self.green, PULSE, 2.3, &[4, 8, 0]),
            (self.white, FLOW, 2.3, &[4, 0]),
        ];
        self.curves(width, height, rows)
    }

    fn curves(self, width: f32, height: f32, rows: [Trace; 4]) -> Paint {
        self.on_screen(move |p, at| {
            let band = height / 4.0;
            let row = (3 - floor(at.y / band).clamp(0, 3)) as usize;
            let (ramp, curve, beats, digits) = rows[row];
            let (u, v) = (at.x / width + 0.5, at.y - band * (3 - row) as f32);
            let half = 0.5 * p.voxel;
            if u < 0.66 {
                let height_at = |x: f32| sample(curve, fraction((x / width + 0.5) * beats)) * band * 0.72 + band * 0.12;
                let (a, b) = (height_at(at.x - half), height_at(at.x + half));
                let lit = v > a.min(b) - half && v < a.max(b) + half && u > 0.03;
                return lit.then_some(ramp.even(0.5, 0.0));
            }
            let pixel = (band / 7.0).max(p.voxel);
            number(digits, vec2(at.x - width * 0.19, v - band * 0.12) / pixel).then_some(ramp.even(0.5, 0.0))
        })
    }

    /// The camera's picture inside the patient: a round field of flesh with instruments.
    pub fn endoscope(self, width: f32, height: f32) -> Paint {
        self.on_screen(move |p, at| {
            let c = at - vec2(0.0, height * 0.5);
            let radius = c.length() / (0.48 * height);
            if radius > 1.0 {
                let text = at.x < -0.32 * width
                    && floor(at.y / 0.03) % 2 == 1
                    && !p.hash.is_multiple_of(3)
                    && at.y > 0.6 * height;
                return text.then_some(self.white.even(0.5, 0.0));
            }
            let shade = 0.85 - 0.5 * radius + 0.4 * fractal_noise(glam::vec3(at.x, 0.0, at.y) / 0.09, 3, 91);
            let tool = (c.x - 0.8 * c.y - 0.05 * height).abs() < 0.05 * height && c.y > -0.1 * height;
            Some(if tool { self.scan.even(0.8, 0.3) } else { self.flesh.even(shade, 0.3) })
        })
    }

    /// A fluoroscope's picture: a round grey field with a bone.
    pub fn fluoroscope(self, width: f32, height: f32) -> Paint {
        self.on_screen(move |_, at| {
            let c = at - vec2(-0.04 * width, height * 0.5);
            let radius = c.length() / (0.46 * height);
            if radius > 1.0 {
                return (at.x > 0.4 * width && floor(at.y / 0.035) % 2 == 0).then_some(self.white.even(0.5, 0.0));
            }
            let axis = c.x - 0.35 * c.y;
            let width_here = 0.10 + 0.09 * smooth_step(0.1, 0.45, (c.y / height).abs());
            let bone = axis.abs() < width_here * height;
            let rim = axis.abs() > (width_here - 0.045) * height;
            let level = if bone { if rim { 0.85 } else { 0.62 } } else { 0.3 };
            Some(self.scan.even(level + 0.2 * value_noise(glam::vec3(at.x, 0.0, at.y) / 0.05, 92), 0.25))
        })
    }

    /// An ultrasound picture: a fan.
    pub fn ultrasound(self, width: f32, height: f32) -> Paint {
        self.on_screen(move |_, at| {
            let c = vec2(at.x, height * 1.02 - at.y);
            let radius = c.length() / height;
            if c.x.abs() > 0.75 * c.y || !(0.12..0.95).contains(&radius) {
                let bar = at.x < -0.44 * width && (0.2..0.8).contains(&(at.y / height));
                return bar.then_some(self.scan.even(at.y / height, 0.1));
            }
            let echo = fractal_noise(glam::vec3(c.x / 0.05, radius / 0.05, 0.0), 2, 93);
            let cyst = (at - vec2(0.03, 0.45 * height)).length() < 0.14 * height;
            Some(self.scan.even(if cyst { 0.05 } else { 0.5 + 0.5 * echo - 0.2 * radius }, 0.3))
        })
    }

    /// Lines of text and a bar of buttons: pumps, generators, computers.
    pub fn text(self, width: f32, height: f32) -> Paint {
        self.on_screen(move |p, at| {
            let line = p.voxel.max(0.014);
            let (i, j) = (floor(at.x / line), floor(at.y / (2.0 * line)));
            let (u, v) = (at.x / width + 0.5, at.y / height);
            if v > 0.82 {
                return Some(self.cyan.even(0.5, 0.0));
            }
            let written = fraction(at.y / (2.0 * line)) < 0.5
                && (0.06..0.3 + 0.6 * unit(hash3(IVec3::new(0, j, 1), p.seed))).contains(&u)
                && !hash3(IVec3::new(i, j, 0), p.seed).is_multiple_of(4);
            let ramp = if j % 3 == 0 { self.green } else { self.white };
            written.then_some(ramp.even(0.5, 0.0))
        })
    }

    /// A dark screen, lit where `lit` says so; the recess's sides are dark as well.
    fn on_screen(self, lit: impl Fn(&SurfacePoint, Vec2) -> Option<Tone> + Send + Sync + 'static) -> Paint {
        Paint::new(move |p| {
            let behind = p.at.y > recess(p.voxel) - 0.3 * p.voxel;
            let tone = if behind { lit(p, vec2(p.at.x, p.at.z)) } else { None };
            tone.unwrap_or(self.dark.even(0.4, 0.5))
        })
    }
}

/// The height of a curve of straight pieces.
fn sample(curve: Curve, phase: f32) -> f32 {
    let next = curve.iter().position(|point| point.0 > phase).unwrap_or(curve.len() - 1).max(1);
    let (a, b) = (curve[next - 1], curve[next]);
    mix(a.1, b.1, ((phase - a.0) / (b.0 - a.0)).clamp(0.0, 1.0))
}

/// Whether a place, in pixels from the lower left corner, is on a row of digits of 3 × 5 pixels.
fn number(digits: &[u8], at: Vec2) -> bool {
    const FONT: [u16; 10] = [
        0b111_101_101_101_111,
        0b010_110_010_010_111,
        0b111_001_111_100_111,
        0b111_001_111_001_111,
        0b101_101_111_001_001,
        0b111_100_111_001_111,
        0b111_100_111_101_111,
        0b111_001_010_010_010,
        0b111_101_111_101_111,
        0b111_101_111_001_111,
    ];
    let (i, j) = (floor(at.x), floor(at.y));
    if i < 0 || !(0..5).contains(&j) || i % 4 == 3 {
        return false;
    }
    let Some(&digit) = digits.get((i / 4) as usize) else { return false };
    FONT[usize::from(digit)] >> (j * 3 + 2 - i % 4) & 1 == 1
}

/// A row of X-ray films, 38 cm apart, on a light box whose lower left corner is the origin.
pub fn films(p: &SurfacePoint, film: Ramp, frame: Ramp) -> Tone {
    if p.at.y < recess(p.voxel) - 0.3 * p.voxel {
        return frame.tone(0.5);
    }
    let column = floor(p.at.x / 0.38);
    let c = vec2((fraction(p.at.x / 0.38) - 0.5) * 0.38, p.at.z - 0.26);
    if c.x.abs() > 0.165 || c.y.abs() > 0.215 {
        return film.even(1.0, 0.05);
    }
    let grain = 0.08 * value_noise(p.at / 0.03, 94);
    let level = if column % 2 == 0 {
        // A chest: two dark lungs crossed by ribs, the spine and the heart between them.
        let lung = vec2((c.x.abs() - 0.075) / 0.062, (c.y - 0.01) / 0.15).length();
        let rib = fraction((c.y + 0.6 * c.x * c.x / 0.1 + 0.5) / 0.042) < 0.35;
        let heart = vec2((c.x + 0.025) / 0.06, (c.y + 0.06) / 0.075).length() < 1.0;
        if c.x.abs() < 0.018 {
            0.86
        } else if heart {
            0.7
        } else if lung < 1.0 {
            if rib { 0.42 } else { 0.16 }
        } else {
            0.55 - 0.25 * smooth_step(0.11, 0.16, c.x.abs())
        }
    } else {
        // A knee: two long bones with thickened ends.
        let gap = (c.y - 0.01).abs();
        let half = 0.034 + 0.03 * (1.0 - smooth_step(0.0, 0.09, gap));
        let fibula = c.y < -0.03 && (c.x - 0.085).abs() < 0.013;
        if gap < 0.008 {
            0.25
        } else if c.x.abs() < half {
            if c.x.abs() > half - 0.016 { 0.9 } else { 0.7 }
        } else if fibula {
            0.7
        } else {
            0.34 - 0.28 * smooth_step(0.09, 0.15, c.x.abs())
        }
    };
    film.even(level + grain, 0.1)
}

/// A clock of 18 cm radius around the origin: twelve strokes, at ten past ten.
pub fn clock_face(p: &SurfacePoint, face: Ramp, ink: Ramp, second: Ramp) -> Tone {
    let at = vec2(p.at.x, p.at.z);
    let line = 0.55 * p.voxel.max(0.012);
    let hand = |x: f32, z: f32| {
        let end = vec2(x, z);
        let along = (at.dot(end) / end.length_squared()).clamp(0.0, 1.0);
        (at - end * along).length() < line
    };
    let radius = at.length();
    let hour = fraction(turns(at.x, at.y) * 12.0 + 0.5) - 0.5;
    let stroke = radius > 0.118 && radius < 0.155 && hour.abs() * radius * std::f32::consts::FRAC_PI_6 < line;
    if p.at.y > -0.5 * p.voxel || radius > 0.165 || stroke || hand(-0.07, 0.043) || hand(0.104, 0.06) {
        ink.even(0.3, 0.5)
    } else if hand(0.02, -0.12) {
        second.even(0.5, 0.5)
    } else {
        face.even(0.8, 0.4)
    }
}

/// A board with a table: a heading, ruled lines, entries in two inks. The origin is the lower left corner.
pub fn notice(p: &SurfacePoint, paper: Ramp, ink: Ramp, blue: Ramp, orange: Ramp) -> Tone {
    let line = p.voxel.max(0.012);
    let (column, row) = (floor(p.at.x / 0.3), floor(p.at.z / 0.11));
    let (u, v) = (fraction(p.at.x / 0.3) * 0.3, fraction(p.at.z / 0.11) * 0.11);
    let cell = hash3(IVec3::new(column, row, 0), p.seed);
    let length = 0.08 + 0.18 * unit(cell);
    let letter = !hash3(IVec3::new(floor(p.at.x / line), row, floor(p.at.z / line)), 95).is_multiple_of(3);
    if v < line || u < line {
        ink.even(0.6, 0.4)
    } else if (0.035..0.075).contains(&v) && u > 0.03 && u < length && letter && !cell.is_multiple_of(5) {
        if cell.is_multiple_of(3) { orange.even(0.5, 0.5) } else { blue.even(0.45, 0.5) }
    } else {
        paper.even(0.78, 0.45)
    }
}

/// A running figure, more or less, beside an arrow: white on green light. The origin is the middle.
pub fn exit_sign(p: &SurfacePoint, light: Ramp, white: Ramp) -> Tone {
    let at = vec2(p.at.x, p.at.z);
    let head = (at - vec2(-0.10, 0.055)).length() < 0.022;
    let body = (at.x + 0.10 + 0.3 * at.y).abs() < 0.02 && at.y.abs() < 0.035;
    let legs = (at.x + 0.10).abs() < 0.05 && (-0.075..-0.03).contains(&at.y) && (at.x + 0.10).abs() > 0.02;
    let shaft = at.y.abs() < 0.014 && (0.0..0.12).contains(&at.x);
    let tip = at.y.abs() < 0.17 - at.x && at.x > 0.10;
    if head || body || legs || shaft || tip { white.even(0.9, 0.2) } else { light.even(0.5, 0.0) }
}
