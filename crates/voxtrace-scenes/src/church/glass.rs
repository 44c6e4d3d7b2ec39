//! Stained glass: panes that glow with the daylight behind them, drawn in lead and colour. Pattern coordinates are
//! those of the window: x across, z up from the sill.

use crate::kit::{noise::*, *};
use glam::{IVec3, Vec2, vec2};

/// Widths of the windows' lights that the patterns are drawn for, metres.
pub const EAST_LIGHT: f32 = 1.0;
/// See [`EAST_LIGHT`].
pub const AISLE_LIGHT: f32 = 1.0;

/// Ramps of glass.
#[derive(Clone, Copy)]
pub struct Colors {
    ruby: Ramp,
    blue: Ramp,
    sky: Ramp,
    gold: Ramp,
    green: Ramp,
    violet: Ramp,
    white: Ramp,
    flesh: Ramp,
    lead: Ramp,
}

impl Colors {
    /// Glass in front of a daylight of this radiance.
    pub fn new(palette: &mut Palette, daylight: f32) -> Self {
        Self {
            ruby: palette.glow(&[[150, 8, 12], [235, 34, 24]], 4, daylight),
            blue: palette.glow(&[[14, 36, 150], [38, 84, 225]], 5, daylight),
            sky: palette.glow(&[[70, 130, 220], [130, 185, 250]], 4, daylight),
            gold: palette.glow(&[[225, 140, 22], [255, 205, 84]], 4, daylight),
            green: palette.glow(&[[16, 98, 44], [70, 168, 82]], 4, daylight),
            violet: palette.glow(&[[86, 24, 120], [150, 70, 180]], 3, daylight),
            white: palette.glow(&[[196, 196, 170], [244, 240, 214]], 5, daylight),
            flesh: palette.glow(&[[226, 160, 120], [250, 205, 165]], 2, daylight),
            lead: palette.ramp(&[[14, 14, 16], [40, 40, 42]], 3),
        }
    }

    /// A pane that glows on its face alone: what nobody sees need not be a light.
    fn pane(self, pattern: impl Fn(&SurfacePoint) -> Tone + Send + Sync + 'static) -> Paint {
        Paint::new(move |p| if p.depth > p.voxel { self.lead() } else { pattern(p) })
    }

    fn lead(self) -> Tone {
        self.lead.even(0.5, 0.5)
    }

    /// Standing figures under canopies, one in each light, on a blue ground; flowers of colour in the tracery.
    pub fn saints(self) -> Paint {
        self.pane(move |p| {
            let (x, z) = (p.at.x, p.at.z);
            let line = came(p);
            let light = floor(x / EAST_LIGHT + 0.5);
            let u = x - light as f32 * EAST_LIGHT;
            if z > 5.35 {
                return self.foliage(vec2(x, z), line);
            }
            let robes = [self.ruby, self.green, self.violet, self.gold, self.blue];
            let robe = robes[(light + 2).rem_euclid(5) as usize];
            let mantle = robes[(light + 4).rem_euclid(5) as usize];
            let ground = if light & 1 == 0 { self.blue } else { self.ruby };
            self.saint(vec2(u, z), line, [robe, mantle, ground])
        })
    }

    /// One light: border, canopy, figure, base; z runs from 0 to about 5.
    fn saint(self, at: Vec2, line: f32, [robe, mantle, ground]: [Ramp; 3]) -> Tone {
        let (u, z) = (at.x.abs(), at.y);
        // Border of coloured squares.
        if u > 0.36 {
            let square = z / 0.16;
            return if u < 0.36 + line || fraction(square) * 0.16 < line {
                self.lead()
            } else if floor(square) & 1 == 0 {
                self.gold.even(0.6, 0.4)
            } else {
                self.ruby.even(0.5, 0.5)
            };
        }
        // Base panel with a lozenge.
        if z < 0.95 {
            let lozenge = u / 0.34 + (z - 0.5).abs() / 0.4;
            return if (lozenge - 0.8).abs() < line * 2.6 || z > 0.95 - line {
                self.lead()
            } else if lozenge < 0.4 {
                self.gold.even(0.7, 0.4)
            } else if lozenge < 0.8 {
                robe.even(0.5, 0.5)
            } else {
                self.white.even(0.4, 0.4)
            };
        }
        // Canopy: a gable of white and gold with pinnacles.
        let gable = 4.9 - u * 1.9;
        if z > 4.15 {
            let arch = vec2(u, (z - 4.15).max(0.0)).length();
            return if (z - gable).abs() < line * 2.0 || (arch - 0.27).abs() < line {
                self.lead()
            } else if arch < 0.27 {
                ground.even(0.4, 0.5)
            } else if z < gable {
                if fraction((z + u) / 0.12) < 0.5 { self.gold.even(0.6, 0.4) } else { self.white.even(0.6, 0.4) }
            } else {
                self.quarry(at, 0.2, line, self.sky)
            };
        }
        // The figure: halo, head, shoulders, robe with a mantle and a light tunic down the middle.
        let head = vec2(u, z - 3.62);
        if head.length() < 0.115 {
            return if z > 3.67 { self.gold.even(0.2, 0.2) } else { self.flesh.even(0.5, 0.5) };
        }
        let halo = head.length();
        if halo < 0.24 {
            return if halo > 0.24 - line { self.lead() } else { self.gold.even(0.85, 0.3) };
        }
        let body = if z > 3.2 { 0.22 - (z - 3.2) * 0.5 } else { 0.22 + (3.2 - z) * 0.03 };
        if z < 3.5 && u < body {
            let fold = fraction((at.x + 0.06 * value_noise(glam::vec3(at.x * 6.0, z * 1.3, 0.0), 41)) / 0.11);
            let edge = 0.085 + 0.04 * value_noise(glam::vec3(z * 1.7, 3.0, 0.0), 42);
            return if body - u < line || (u - edge).abs() < line * 0.8 {
                self.lead()
            } else if z < 1.12 {
                self.green.even(0.4, 0.5)
            } else if u < edge {
                // Hands, a book, the tunic's hem.
                if (2.62..2.78).contains(&z) && u < 0.09 {
                    self.flesh.even(0.5, 0.5)
                } else if (2.3..2.62).contains(&z) {
                    self.gold.even(0.5, 0.4)
                } else {
                    self.white.even(0.75 - 0.5 * fold, 0.3)
                }
            } else if z < 2.4 - u {
                robe.even(0.85 - 0.7 * fold, 0.3)
            } else {
                mantle.even(0.85 - 0.7 * fold, 0.3)
            };
        }
        self.quarry(at, 0.24, line, ground)
    }

    /// Lozenges of one colour.
    fn quarry(self, at: Vec2, size: f32, line: f32, color: Ramp) -> Tone {
        let uv = vec2(at.x + at.y * 0.7, at.x - at.y * 0.7) / size;
        let inside = vec2(fraction(uv.x), fraction(uv.y));
        if inside.min_element() * size < line * 1.2 {
            return self.lead();
        }
        let cell = hash3(IVec3::new(floor(uv.x), floor(uv.y), 5), 43);
        color.even(0.5 + 0.4 * signed(cell), 0.25)
    }

    /// Cells of many colours, mostly blue and ruby, for tracery.
    fn foliage(self, at: Vec2, line: f32) -> Tone {
        let (cell, edge) = cells(at, 0.21);
        if edge < line {
            return self.lead();
        }
        let ramp = match cell % 10 {
            0..3 => self.blue,
            3..6 => self.ruby,
            6 => self.gold,
            7 => self.sky,
            8 => self.green,
            _ => self.white,
        };
        ramp.even(0.5 + 0.3 * signed(hash(cell)), 0.3)
    }

    /// Pale lozenges with coloured borders and round medallions.
    pub fn medallions(self) -> Paint {
        self.pane(move |p| {
            let (x, z) = (p.at.x, p.at.z);
            let line = came(p);
            let light = floor(x / AISLE_LIGHT);
            let u = x - (light as f32 + 0.5) * AISLE_LIGHT;
            let pick = |offset: u32| {
                [self.ruby, self.blue, self.green, self.violet, self.gold][(hash(p.seed ^ offset) % 5) as usize]
            };
            if z > 2.35 {
                return self.foliage(vec2(x, z), line);
            }
            if u.abs() > 0.36 {
                let square = z / 0.14;
                return if u.abs() < 0.36 + line || fraction(square) * 0.14 < line {
                    self.lead()
                } else if floor(square) & 1 == 0 {
                    pick(1).even(0.5, 0.5)
                } else {
                    self.sky.even(0.5, 0.5)
                };
            }
            let c = vec2(u, (fraction(z / 0.95) - 0.5) * 0.95);
            let radius = c.length();
            let petals = radius * (1.0 + 0.18 * (c.x * c.x - c.y * c.y).abs() / (radius * radius).max(1e-6));
            if (radius - 0.31).abs() < line || (petals - 0.17).abs() < line {
                self.lead()
            } else if petals < 0.17 {
                if radius < 0.07 {
                    self.gold.even(0.8, 0.3)
                } else {
                    pick(2_u32.wrapping_add(light as u32)).even(0.5, 0.5)
                }
            } else if radius < 0.31 {
                pick(7).even(0.4, 0.4)
            } else {
                self.quarry(vec2(u, z), 0.17, line, self.white)
            }
        })
    }

    /// Plain pale lozenges with a sky-blue border line, some golden; `white` in place of white glass.
    pub fn quarries(self, white: Option<Ramp>) -> Paint {
        let white = white.unwrap_or(self.white);
        self.pane(move |p| {
            let line = came(p);
            let light = p.at.x.abs();
            let cell = hash3(IVec3::new(floor(p.at.x * 2.0), floor(p.at.z * 2.2), 6), p.seed) % 9;
            if (0.78..0.9).contains(&light) {
                return self.sky.even(0.6, 0.4);
            }
            let color = if cell == 0 { self.gold } else { white };
            self.quarry(vec2(p.at.x, p.at.z), 0.2, line, color)
        })
    }

    /// A rose: rings and petals around the origin.
    pub fn rose(self) -> Paint {
        self.pane(move |p| {
            let at = vec2(p.at.x, p.at.z);
            let line = came(p);
            let radius = at.length();
            let sector = turns(at.x, at.y) * 12.0;
            let ring = floor(radius / 0.36);
            let edge = (fraction(radius / 0.36) * 0.36).min(fraction(sector * 2.0) * radius * 0.26);
            if edge < line {
                return self.lead();
            }
            let ramps = [self.gold, self.ruby, self.blue, self.sky, self.ruby, self.blue, self.green];
            let ramp = ramps[((ring + (floor(sector * 2.0) & 1) * 2).rem_euclid(7)) as usize];
            ramp.even(0.5 + 0.3 * signed(hash3(IVec3::new(ring, floor(sector * 2.0), 7), 44)), 0.3)
        })
    }
}

/// Half the width of the lead between panes: about a voxel is seen of it, but at coarse voxels most of the glass stays.
fn came(p: &SurfacePoint) -> f32 {
    (0.62 * p.voxel).clamp(0.0075, 0.018)
}

/// Irregular cells of about `size` in the plane: a hash of the cell and the distance to its border.
fn cells(at: Vec2, size: f32) -> (u32, f32) {
    let at = at / size;
    let corner = IVec3::new(floor(at.x), floor(at.y), 0);
    let (mut nearest, mut second, mut id) = (f32::MAX, f32::MAX, 0);
    for i in 0..9 {
        let cell = corner + IVec3::new(i % 3 - 1, i / 3 - 1, 0);
        let draw = hash3(cell, 45);
        let point = vec2(cell.x as f32 + unit(draw), cell.y as f32 + unit(hash(draw)));
        let distance = (point - at).length();
        if distance < nearest {
            (second, nearest, id) = (nearest, distance, draw);
        } else if distance < second {
            second = distance;
        }
    }
    (hash(id ^ 0x51ed), (second - nearest) * 0.5 * size)
}
