//! The kinds of buildings of a Manhattan street, each a family of façades with random parameters.

use super::{
    facade::{Band, Cornice, Facade, Street},
    paints::{trim, wall},
    site::{Dice, Site},
};
use glam::vec2;

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
        // How light its wall is, within the ramp of its colour.
        let level = dice.between(0.34, 0.66);
        match self {
            Self::Brownstone => brownstone(site, dice, floors, level),
            Self::Tenement => tenement(site, dice, floors, level),
            Self::Loft => loft(site, dice, floors, level),
            Self::Apartments => apartments(site, dice, floors, level),
            Self::Deco => deco(site, dice, floors, level),
            Self::Glass => glass(site, dice, floors),
        }
    }
}

/// What most façades have in common.
pub fn common(site: &Site) -> Facade {
    let ramps = site.paints.ramps;
    Facade {
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
    }
}

/// A band of at least one floor, with one window a bay.
fn band(floors: u32, storey: f32, width: f32, height: f32, sill: f32) -> Band {
    let floors = floors.max(1);
    Band { floors, storey, window: vec2(width, height), sill, per_bay: 1, arched: false, belt: false }
}

fn belted(band: Band) -> Band {
    Band { belt: true, ..band }
}

/// The number of floors that is wanted, or one from `low` to `high` where that is 0.
fn count(wanted: u32, dice: &mut Dice, low: usize, high: usize) -> u32 {
    if wanted > 0 { wanted } else { (low + dice.below(high - low + 1)) as u32 }
}

fn brownstone(site: &Site, dice: &mut Dice, floors: u32, level: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.brownstone, ramps.brownstone, ramps.brick, ramps.limestone][dice.below(4)];
    let floors = count(floors, dice, 4, 4);
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
        ..common(site)
    }
}

fn tenement(site: &Site, dice: &mut Dice, floors: u32, level: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.brick, ramps.brick, ramps.buff, ramps.brick, ramps.cream, ramps.grey][dice.below(6)];
    let trims = [ramps.limestone, ramps.cream, ramps.copper, ramps.brownstone][dice.below(4)];
    let floors = count(floors, dice, 5, 6);
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
        ..common(site)
    }
}

fn loft(site: &Site, dice: &mut Dice, floors: u32, level: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.cream, ramps.limestone, ramps.buff, ramps.grey, ramps.brownstone, ramps.brick][dice.below(6)];
    let floors = count(floors, dice, 6, 8);
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
        ..common(site)
    }
}

fn apartments(site: &Site, dice: &mut Dice, floors: u32, level: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.buff, ramps.brick, ramps.limestone, ramps.cream, ramps.brick][dice.below(5)];
    let floors = count(floors, dice, 10, 12);
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
        ..common(site)
    }
}

fn deco(site: &Site, dice: &mut Dice, floors: u32, level: f32) -> Facade {
    let ramps = site.paints.ramps;
    let ramp = [ramps.brick, ramps.limestone, ramps.cream, ramps.grey][dice.below(4)];
    let floors = count(floors, dice, 14, 18);
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
        ..common(site)
    }
}

fn glass(site: &Site, dice: &mut Dice, floors: u32) -> Facade {
    let ramps = site.paints.ramps;
    Facade {
        wall: trim(ramps.steel, 0.5),
        trim: trim(ramps.steel, 0.4),
        bands: vec![band(1, 6.0, 0.0, 0.0, 0.0), band(count(floors, dice, 14, 18), 3.7, 0.0, 0.0, 0.0)],
        bay: 1.8,
        street: Street::Lobby,
        ..common(site)
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
