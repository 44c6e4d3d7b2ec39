//! Façades: bands of floors with window grids, sills, lintels, belts, piers, cornices and shops. A façade lies in the
//! plane y = 0 with the street towards −y, from x = 0 on, z up.

use super::{
    paints::{Panes, glazing},
    site::{Dice, Site},
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// Floors of one kind.
#[derive(Clone)]
pub struct Band {
    pub floors: u32,
    /// From floor to floor.
    pub storey: f32,
    /// Width and height of a window; width 0 for none.
    pub window: Vec2,
    /// Foot of the window above the floor.
    pub sill: f32,
    /// Windows in a bay.
    pub per_bay: u32,
    pub arched: bool,
    /// A string course above the band.
    pub belt: bool,
}

/// What closes a wall above.
#[derive(Clone, Copy, PartialEq)]
pub enum Cornice {
    Coping,
    Plain,
    Bracketed,
}

/// What is at the street.
#[derive(Clone, Copy, PartialEq)]
pub enum Street {
    /// Windows like above.
    Nothing,
    /// Shop windows, a sign above each, awnings over some.
    Shops,
    /// A stair to a raised door.
    Stoop,
    /// A door with a canopy.
    Lobby,
}

/// The design of a façade.
#[derive(Clone)]
pub struct Facade {
    pub wall: Paint,
    pub trim: Paint,
    pub frame: Tone,
    pub bay: f32,
    pub recess: f32,
    /// From the lowest; the first stands on the ground.
    pub bands: Vec<Band>,
    pub sills: bool,
    pub lintels: bool,
    /// How far piers between the bays stand out; 0 for none.
    pub piers: f32,
    pub cornice: Cornice,
    pub street: Street,
    pub fire_escape: bool,
    pub lit: f32,
}

/// What a façade takes from a wall, and what it puts on it.
#[derive(Default)]
pub struct Dressing {
    pub cuts: Vec<Solid>,
    pub parts: Vec<Solid>,
}

impl Facade {
    /// Height of all bands and the parapet.
    pub fn height(&self) -> f32 {
        self.bands.iter().map(|band| band.storey * band.floors as f32).sum::<f32>() + 1.2
    }

    /// The façade on a wall of a width.
    pub fn dress(&self, site: &Site, width: f32, seed: u32) -> Dressing {
        let mut dice = Dice::new(seed);
        let mut out = Dressing::default();
        let bays = ((width - 0.8) / self.bay + 0.3).max(1.0) as u32;
        let bay = (width - 0.8) / bays as f32;
        let recess = site.width(self.recess);
        let mut z = 0.0;
        for (i, band) in self.bands.iter().enumerate() {
            let top = z + band.storey * band.floors as f32;
            if i == 0 && self.street == Street::Shops {
                self.shops(site, &mut dice, bays, bay, band.storey, &mut out);
            } else if band.window.x > 0.0 {
                self.windows(site, &mut dice, (bays, bay), band, z, recess, &mut out);
            }
            if band.belt {
                let (low, high) = (site.snap(top - 0.25), site.snap(top - 0.25) + site.width(0.35));
                let belt = Profile::rectangle(vec2(-site.width(0.3), low), vec2(0.6, high));
                out.parts.push(extrude(belt, Axis::X, 0.0, width).paint(&self.trim));
            }
            z = top;
        }
        let base = self.bands.first().map_or(0.0, |band| band.storey);
        if self.piers > 0.0 {
            let half = site.width(0.16 * bay) * 0.5;
            let us = (0..=bays).map(|i| site.center(0.4 + bay * i as f32, 2.0 * half)).collect();
            let (low, high) = (if self.street == Street::Shops { base } else { -1.0 }, z + 0.6);
            let piers = Profile::Rectangle(vec2(half, (high - low) * 0.5)).grid(us, vec![(high + low) * 0.5]);
            let slab = cuboid(vec3(-0.1, -4.0, -1.0), vec3(width + 0.1, 4.0, z + 3.0));
            out.parts.push(extrude(piers, Axis::Y, -site.width(self.piers), 0.6).within(slab).paint(&self.wall));
        }
        match self.street {
            Street::Stoop => out.parts.push(self.stoop(site, 0.4 + bay * 0.5)),
            Street::Lobby => self.lobby(site, width * 0.5, &mut out),
            Street::Shops | Street::Nothing => {}
        }
        if self.fire_escape {
            let column = 0.4 + bay * (bays / 2) as f32;
            out.parts.push(fire_escape(site, column, bay, base, z - 1.5, self.bands.last().map_or(3.0, |b| b.storey)));
        }
        self.cornice(site, width, z + 1.2, bay, &mut out);
        out
    }

    #[expect(clippy::too_many_arguments, reason = "all of them differ between bands")]
    fn windows(
        &self,
        site: &Site,
        dice: &mut Dice,
        (bays, bay): (u32, f32),
        band: &Band,
        z: f32,
        recess: f32,
        out: &mut Dressing,
    ) {
        let size = vec2(site.width(band.window.x), site.width(band.window.y));
        let pitch = bay / band.per_bay as f32 * if band.per_bay > 1 { 0.86 } else { 1.0 };
        let us: Vec<f32> = (0..bays)
            .flat_map(|i| {
                let middle = 0.4 + bay * (i as f32 + 0.5);
                (0..band.per_bay).map(move |k| middle + pitch * (k as f32 - 0.5 * (band.per_bay - 1) as f32))
            })
            .map(|u| site.center(u, size.x))
            .collect();
        let foot = |j: u32| z + band.storey * j as f32 + band.sill;
        let vs: Vec<f32> = (0..band.floors).map(|j| site.center(foot(j) + 0.5 * size.y, size.y)).collect();
        let panes = Panes {
            first: vec2(0.4, foot(0)),
            pitch: vec2(bay / band.per_bay as f32, band.storey),
            size,
            recess,
            frame: self.frame,
            lit: self.lit,
            seed: dice.seed(),
        };
        let glass = glazing(panes, self.wall.clone(), site.paints.ramps);
        let mut figure = Profile::Rectangle(size * 0.5).grid(us.clone(), vs.clone());
        if band.arched {
            let tops = vs.iter().map(|v| v + 0.5 * size.y).collect();
            figure = figure.and(Profile::Disc(0.5 * size.x).grid(us.clone(), tops));
        }
        out.cuts.push(extrude(figure, Axis::Y, -1.5, recess).paint(&glass));
        let bar = |half: Vec2, dv: f32| Profile::Rectangle(half).grid(us.clone(), vs.iter().map(|v| v + dv).collect());
        let stick = site.width(0.28);
        if self.sills {
            let half = vec2(0.5 * size.x + site.snap(0.2), 0.5 * stick);
            let sills = bar(half, -0.5 * (size.y + stick));
            out.parts.push(extrude(sills, Axis::Y, -site.width(0.25).min(stick), 0.5).paint(&self.trim));
        }
        if self.lintels && !band.arched {
            let half = vec2(0.5 * size.x + site.snap(0.25), 0.5 * site.width(0.4));
            let lintels = bar(half, 0.5 * size.y + half.y);
            // Flush with the wall: only their colour shows, a voxel deep.
            out.parts.push(extrude(lintels, Axis::Y, -site.width(0.1).min(0.4), 0.5).paint(&self.trim));
        }
    }

    fn cornice(&self, site: &Site, width: f32, top: f32, bay: f32, out: &mut Dressing) {
        let top = site.snap(top);
        let (section, over) = match self.cornice {
            Cornice::Coping => {
                let edge = site.width(0.3);
                (Profile::rectangle(vec2(-edge, top - site.width(0.3)), vec2(0.7, top + 0.05)), edge)
            }
            Cornice::Plain => (
                Profile::polygon(&[
                    (0.6, top - 1.2),
                    (-0.3, top - 1.2),
                    (-0.4, top - 0.6),
                    (-0.8, top - 0.2),
                    (-0.8, top + 0.1),
                    (0.6, top + 0.1),
                ]),
                0.7,
            ),
            Cornice::Bracketed => (
                Profile::polygon(&[
                    (0.6, top - 0.9),
                    (-0.6, top - 0.8),
                    (-1.0, top - 0.3),
                    (-1.1, top + 0.15),
                    (0.6, top + 0.15),
                ]),
                1.0,
            ),
        };
        out.parts.push(extrude(section, Axis::X, -over, width + over).paint(&self.trim));
        if self.cornice == Cornice::Bracketed {
            let step = bay / (bay / 1.3).max(1.0) as u32 as f32;
            let half = 0.5 * site.width(0.32);
            let count = (width / step) as u32;
            let us = (0..=count).map(|i| site.center(0.35 + step * i as f32, 2.0 * half)).collect();
            let brackets = Profile::Rectangle(vec2(half, 0.6)).grid(us, vec![top - 1.2]);
            let slab = cuboid(vec3(0.0, -3.0, 0.0), vec3(width, 3.0, top + 1.0));
            out.parts.push(extrude(brackets, Axis::Y, -0.65, 0.5).within(slab).paint(&self.trim));
            let frieze =
                Profile::rectangle(vec2(-site.width(0.2), site.snap(top - 2.2)), vec2(0.5, site.snap(top - 1.9)));
            out.parts.push(extrude(frieze, Axis::X, 0.0, width).paint(&self.trim));
        }
    }
}

/// Platforms with rails at each floor and the ladders between them.
fn fire_escape(site: &Site, x: f32, bay: f32, base: f32, top: f32, storey: f32) -> Solid {
    let (half, out) = ((0.62 * bay).max(1.3), -1.25);
    let thick = site.width(0.2);
    let (half, out) = (site.snap(half), site.snap(out));
    let x = site.snap(x);
    let mut levels = Vec::new();
    let mut z = base + 0.2;
    while z < top {
        levels.push(site.center(z, thick));
        z += storey;
    }
    let at = |dz: f32| levels.iter().map(|z| z + dz).collect::<Vec<_>>();
    let floor = Profile::Rectangle(vec2(half, 0.5 * thick)).grid(vec![x], at(0.0));
    let rail = Profile::Rectangle(vec2(half, 0.5 * thick)).grid(vec![x], at(site.snap(1.0)));
    let posts = Profile::Rectangle(vec2(0.5 * thick, 0.5))
        .grid([-half, 0.0, half].map(|u| site.center(x + u, thick)).into(), at(0.5));
    let ladders = levels.windows(2).enumerate().map(|(i, pair)| {
        let side = if i % 2 == 0 { 0.75 * half } else { -0.75 * half };
        bar(vec3(x - side, -0.6, pair[0]), vec3(x + side * 0.6, -0.6, pair[1]), 0.5 * site.thick(0.15))
    });
    union([
        extrude(floor, Axis::Y, out, 0.2),
        extrude(rail, Axis::Y, out, out + thick),
        extrude(posts, Axis::Y, out, out + thick),
        union(ladders),
    ])
    .paint(&site.paints.iron)
}
