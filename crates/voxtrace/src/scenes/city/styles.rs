//! The kinds of buildings of a Manhattan street, each a family of façades drawn by dice.

use super::{
    facade::{Band, Cornice, Facade, Street},
    house::House,
    paints::{curtain, roofing, trim, wall},
    roofs,
    site::{Dice, Site},
};
use crate::scenes::kit::*;
use glam::{Vec2, vec2, vec3};

/// A kind of building.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A row house with a stoop.
    Brownstone,
    /// A brick walk-up with shops and a fire escape.
    Tenement,
    /// A cast-iron or stone loft with great windows.
    Loft,
    /// An apartment house of the 1920s.
    Apartments,
    /// A stepped tower of the 1930s.
    Deco,
    /// A glass tower.
    Glass,
}

impl Kind {
    /// An ordinary frontage, metres.
    pub fn frontage(self, dice: &mut Dice) -> f32 {
        match self {
            Self::Brownstone => dice.between(6.2, 7.2),
            Self::Tenement => dice.between(8.0, 10.5),
            Self::Loft => dice.between(11.0, 16.0),
            Self::Apartments => dice.between(17.0, 23.0),
            Self::Deco => dice.between(22.0, 27.0),
            Self::Glass => dice.between(20.0, 25.0),
        }
    }

    /// The street façade with `floors` floors, or as many as the kind has if 0.
    pub fn facade(self, site: &Site, dice: &mut Dice, floors: u32) -> Facade {
        let ramps = site.paints.ramps;
        let band = |floors: u32, storey: f32, width: f32, height: f32, sill: f32| Band {
            floors: floors.max(1),
            storey,
            window: vec2(width, height),
            sill,
            per_bay: 1,
            arched: false,
            belt: false,
        };
        let belted = |band: Band| Band { belt: true, ..band };
        let count = |dice: &mut Dice, low: usize, high: usize| {
            if floors > 0 { floors } else { (low + dice.below(high - low + 1)) as u32 }
        };
        let base = Facade {
            wall: wall(ramps.brick, 0.5),
            trim: trim(ramps.limestone, 0.6),
            frame: ramps.cream.even(0.6, 0.25),
            bay: 2.6,
            recess: 0.3,
            bands: Vec::new(),
            sills: true,
            lintels: false,
            piers: 0.0,
            cornice: Cornice::Coping,
            street: Street::Nothing,
            fire_escape: false,
            lit: 0.012,
        };
        let level = dice.between(0.34, 0.66);
        match self {
            Self::Brownstone => {
                let ramp = [ramps.brownstone, ramps.brownstone, ramps.brick, ramps.limestone][dice.below(4)];
                let floors = count(dice, 4, 4);
                let parlour = Band { sill: 2.4, ..band(1, 5.2, 1.15, 2.3, 2.4) };
                Facade {
                    wall: wall(ramp, level),
                    trim: trim(ramp, level + 0.12),
                    frame: ramps.iron.even(0.6, 0.3),
                    bay: 2.1,
                    bands: vec![parlour, band(floors - 2, 3.4, 1.1, 1.9, 0.8), band(1, 2.9, 1.1, 1.5, 0.7)],
                    lintels: true,
                    cornice: Cornice::Bracketed,
                    street: Street::Stoop,
                    ..base
                }
            }
            Self::Tenement => {
                let ramp = [ramps.brick, ramps.brick, ramps.buff, ramps.brick, ramps.cream, ramps.grey][dice.below(6)];
                let trims = [ramps.limestone, ramps.cream, ramps.copper, ramps.brownstone][dice.below(4)];
                let floors = count(dice, 5, 6);
                Facade {
                    wall: wall(ramp, level),
                    trim: trim(trims, 0.55),
                    bay: dice.between(2.1, 2.5),
                    bands: vec![
                        belted(band(1, 4.4, 1.0, 2.0, 1.0)),
                        band(floors - 2, 3.3, 1.05, 1.85, 0.8),
                        Band { arched: dice.chance(0.4), ..band(1, 3.6, 1.05, 1.7, 0.8) },
                    ],
                    lintels: true,
                    cornice: Cornice::Bracketed,
                    street: Street::Shops,
                    fire_escape: true,
                    ..base
                }
            }
            Self::Loft => {
                let ramp = [ramps.cream, ramps.limestone, ramps.buff, ramps.grey, ramps.brownstone, ramps.brick]
                    [dice.below(6)];
                let floors = count(dice, 6, 8);
                Facade {
                    wall: wall(ramp, level + 0.1),
                    trim: trim(if dice.chance(0.3) { ramps.copper } else { ramp }, level + 0.2),
                    frame: ramps.copper.even(0.25, 0.25),
                    bay: dice.between(2.8, 3.6),
                    recess: 0.6,
                    bands: vec![
                        belted(band(1, 5.0, 2.0, 3.0, 0.8)),
                        belted(band(2, 4.0, 2.2, 2.7, 0.7)),
                        band(floors - 4, 3.7, 2.2, 2.4, 0.7),
                        Band { arched: true, ..belted(band(1, 4.6, 2.0, 2.1, 0.7)) },
                    ],
                    piers: 0.3,
                    cornice: Cornice::Plain,
                    street: Street::Shops,
                    ..base
                }
            }
            Self::Apartments => {
                let ramp = [ramps.buff, ramps.brick, ramps.limestone, ramps.cream, ramps.brick][dice.below(5)];
                let floors = count(dice, 10, 12);
                let pairs = |band: Band| Band { per_bay: 2, ..band };
                Facade {
                    wall: wall(ramp, level),
                    trim: trim(if ramp == ramps.limestone { ramps.cream } else { ramps.limestone }, 0.62),
                    bay: dice.between(3.9, 4.6),
                    bands: vec![
                        belted(pairs(band(1, 4.8, 1.2, 2.6, 1.1))),
                        belted(pairs(band(2, 3.5, 1.2, 2.0, 0.8))),
                        pairs(band(floors - 5, 3.3, 1.15, 1.8, 0.8)),
                        belted(pairs(band(1, 3.4, 1.15, 1.8, 0.8))),
                        Band { arched: true, ..pairs(band(1, 3.9, 1.15, 1.7, 0.8)) },
                    ],
                    cornice: Cornice::Bracketed,
                    street: Street::Lobby,
                    ..base
                }
            }
            Self::Deco => {
                let ramp = [ramps.buff, ramps.limestone, ramps.cream, ramps.grey][dice.below(4)];
                let floors = count(dice, 14, 18);
                Facade {
                    wall: wall(ramp, level + 0.08),
                    trim: trim(ramps.limestone, 0.7),
                    frame: ramps.iron.even(0.5, 0.3),
                    bay: dice.between(2.7, 3.1),
                    recess: 0.6,
                    bands: vec![belted(band(1, 5.4, 1.6, 3.4, 1.0)), band(floors - 1, 3.4, 1.5, 2.0, 0.8)],
                    sills: false,
                    piers: 0.45,
                    street: Street::Lobby,
                    ..base
                }
            }
            Self::Glass => Facade {
                wall: trim(ramps.steel, 0.5),
                trim: trim(ramps.steel, 0.4),
                bands: vec![band(1, 6.0, 0.0, 0.0, 0.0), band(count(dice, 14, 18), 3.7, 0.0, 0.0, 0.0)],
                bay: 1.8,
                street: Street::Lobby,
                ..base
            },
        }
    }
}

/// The wall towards the yards: plain brick, small windows, iron stairs now and then.
pub fn rear(site: &Site, dice: &mut Dice, height: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.brick, ramps.buff, ramps.grey, ramps.brick][dice.below(4)];
    let floors = ((height - 2.0) / 3.4).max(1.0) as u32;
    Facade {
        wall: wall(ramp, 0.4),
        trim: trim(ramps.concrete, 0.4),
        frame: ramps.cream.even(0.4, 0.25),
        bay: dice.between(3.0, 3.8),
        recess: 0.3,
        bands: vec![Band {
            floors,
            storey: (height - 1.2) / floors as f32,
            window: vec2(1.1, 1.7),
            sill: 0.9,
            per_bay: 1,
            arched: false,
            belt: false,
        }],
        sills: false,
        lintels: false,
        piers: 0.0,
        cornice: Cornice::Coping,
        street: Street::Nothing,
        fire_escape: dice.chance(0.5) && height < 26.0,
        lit: 0.01,
    }
}

/// A stepped tower on a lot from (0, 0) to `lot`: a base as wide as the lot, tiers that step back, a crown.
pub fn stepped_tower(site: &Site, dice: &mut Dice, lot: Vec2, floors: u32, blind: [bool; 4]) -> Solid {
    let ramps = site.paints.ramps;
    let low = Kind::Deco.facade(site, dice, (floors as f32 * 0.55) as u32);
    let roof = roofing(ramps.tar, 0.5);
    let mut parts = Vec::new();
    let (mut min, mut max, mut foot) = (Vec2::ZERO, lot, 0.0);
    let tiers = 4;
    for tier in 0..tiers {
        let upper = Facade {
            bands: vec![Band {
                floors: (floors as f32 * [0.55, 0.24, 0.14, 0.07][tier]).max(1.0) as u32,
                ..low.bands[1].clone()
            }],
            street: Street::Nothing,
            ..low.clone()
        };
        let facade = if tier == 0 { &low } else { &upper };
        let height = facade.height();
        let size = max - min;
        let walls = (0..4).map(|i| (tier > 0 || !blind[i]).then_some(facade)).collect();
        let house = House {
            corners: vec![min, vec2(max.x, min.y), max, vec2(min.x, max.y)],
            walls,
            foot,
            height,
            paint: facade.wall.clone(),
            roof: roof.clone(),
            parapet: 1.2,
            seed: dice.seed(),
        };
        parts.push(house.build(site));
        foot = site.snap(foot + site.snap(height) - site.snap(1.2));
        if tier + 1 == tiers || size.min_element() < 9.0 {
            break;
        }
        let step = if tier == 0 { vec2(0.14, 0.14) } else { vec2(0.15, 0.13) } * size;
        min = vec2(site.snap(min.x + step.x), site.snap(min.y + step.y));
        max = vec2(site.snap(max.x - step.x), site.snap(max.y - step.y));
    }
    // The crown: ribs around a lantern with a copper cap.
    let middle = (min + max) * 0.5;
    let half = (max - min).min_element() * 0.5;
    let crown = union([
        block(1.5 * half, 1.5 * half, 3.0).paint(&low.wall),
        block(1.1 * half, 1.1 * half, 5.2).paint(&low.trim),
        ring(4, &block(0.5, 1.9 * half, 4.2).x(0.62 * half)).paint(&low.wall),
        cone(0.72 * half, 0.2, 3.4).z(5.1).paint(&site.paints.copper),
        cylinder(site.voxel.max(0.15), 5.0).z(8.0).paint(&site.paints.steel),
    ]);
    parts.push(crown.at(vec3(middle.x, middle.y, foot)));
    union(parts)
}

/// A glass tower on a lot: a lobby, a shaft with fins between the panes, machines behind a screen on top.
pub fn glass_tower(site: &Site, dice: &mut Dice, lot: Vec2, floors: u32) -> Solid {
    let ramps = site.paints.ramps;
    let (bay, storey, lobby) = (1.8, 3.7, site.snap(6.0));
    let height = site.snap(lobby + storey * floors as f32);
    let skin = curtain(ramps, bay, storey, dice.between(0.4, 0.55), dice.seed());
    let metal = trim(ramps.steel, dice.between(0.25, 0.7));
    let inset = site.snap(1.6);
    let (min, max) = (Vec2::splat(inset), lot - inset);
    let roof = roofing(ramps.tar, 0.7);
    let (rim, floor) = (site.width(0.6), height - site.width(2.2));
    let well = cuboid(vec3(min.x + rim, min.y + rim, floor), vec3(max.x - rim, max.y - rim, height + 5.0));
    let shaft = cuboid(vec3(min.x, min.y, lobby), vec3(max.x, max.y, height)).paint(&skin).minus(well.paint(&roof));
    let warm = Paint::new(move |p| if p.at.z > 4.2 { ramps.glow.even(0.4, 0.4) } else { ramps.glass.even(0.5, 0.3) });
    let core = cuboid(vec3(min.x + 2.2, min.y + 2.2, -2.0), vec3(max.x - 2.2, max.y - 2.2, lobby + 1.0)).paint(&warm);
    let mut parts = vec![shaft, core];
    let fin = site.width(0.16);
    let size = max - min;
    for (from, along, width) in [
        (min, Vec2::X, size.x),
        (vec2(max.x, min.y), Vec2::Y, size.y),
        (max, -Vec2::X, size.x),
        (vec2(min.x, max.y), -Vec2::Y, size.y),
    ] {
        let count = (width / bay) as u32;
        let us: Vec<f32> = (0..=count).map(|i| site.center(width * i as f32 / count as f32, fin)).collect();
        let fins =
            Profile::Rectangle(vec2(0.5 * fin, 0.5 * (height - lobby))).grid(us.clone(), vec![0.5 * (height + lobby)]);
        let columns: Vec<f32> = us.iter().copied().step_by(3).collect();
        let legs = Profile::Rectangle(vec2(0.4, 0.5 * lobby + 1.0)).grid(columns, vec![0.5 * lobby]);
        let edge = |z: f32| Profile::rectangle(vec2(-0.4, z), vec2(0.5, z + 0.8));
        let side = union([
            extrude(fins, Axis::Y, -fin, 0.4),
            extrude(legs, Axis::Y, 0.2, 1.0),
            extrude(edge(lobby - 0.4), Axis::X, -0.3, width + 0.3),
            extrude(edge(height - 0.6), Axis::X, -0.3, width + 0.3),
        ]);
        parts.push(super::site::place(&side, from, along).paint(&metal));
    }
    let things = roofs::furniture(site, dice, min + 2.0, max - 2.0).z(floor);
    parts.push(things);
    union(parts)
}
