//! How much light passes through an atmosphere, as a table by height and angle: Bruneton and Neyret, "Precomputed Atmospheric
//! Scattering", EGSR 2008, section 4, with the distances to the top as coordinates (Bruneton 2017).

use super::atmosphere::Atmosphere;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::Arc;

/// Radius of the ground, and of the top of the air, km.
pub const GROUND: f64 = 6360.0;
pub const TOP: f64 = 6460.0;
/// Columns and rows of the table, and the steps behind each entry, an even number.
const COLUMNS: usize = 256;
const ROWS: usize = 64;
const STEPS: u32 = 200;

/// One over the degrees of the series of e^x.
const INVERSES: [f64; 14] = {
    let (mut inverses, mut at) = ([0.0; 14], 0);
    while at < inverses.len() {
        inverses[at] = 1.0 / (at + 1) as f64;
        at += 1;
    }
    inverses
};

/// e^−x for `x` ≥ 0, the same on every machine, within 1e-14.
pub fn decay(x: f64) -> f64 {
    const LN_2: f64 = std::f64::consts::LN_2;
    if x.is_nan() || x > 700.0 {
        return 0.0;
    }
    let x = x.max(0.0);
    // x = n ln 2 + rest, |rest| ≤ ln 2 / 2; Taylor series.
    let n = (x / LN_2 + 0.5).floor();
    let rest = n * LN_2 - x;
    let series = INVERSES.iter().rev().fold(1.0, |sum, inverse| 1.0 + rest * inverse * sum);
    series * f64::from_bits((1023 - n as u64) << 52)
}

/// [`decay`] of each channel.
pub fn decay_of(x: DVec3) -> DVec3 {
    DVec3::new(decay(x.x), decay(x.y), decay(x.z))
}

/// Whether a ray from this distance to the planet's centre, at this cosine from the zenith, meets the ground.
pub fn hits_ground(radius: f64, cosine: f64) -> bool {
    cosine < 0.0 && radius * radius * (cosine * cosine - 1.0) + GROUND * GROUND >= 0.0
}

/// Length of such a ray to the top of the air, km.
pub fn way_to_top(radius: f64, cosine: f64) -> f64 {
    -radius * cosine + (radius * radius * (cosine * cosine - 1.0) + TOP * TOP).max(0.0).sqrt()
}

/// Values over the unit square, between which is interpolated.
#[derive(Clone)]
pub struct Table {
    columns: usize,
    values: Arc<[DVec3]>,
}

impl Table {
    /// The values at `columns` × `rows` points, the first and the last on the edges.
    pub fn new(columns: usize, rows: usize, value: impl Fn(f64, f64) -> DVec3 + Sync) -> Self {
        let share = |index: usize, count: usize| index as f64 / (count - 1).max(1) as f64;
        let at = |index: usize| value(share(index % columns, columns), share(index / columns, rows));
        let values: Vec<DVec3> = (0..columns * rows).into_par_iter().map(at).collect();
        Self { columns, values: values.into() }
    }

    /// The value at a place; places outside count as the nearest on the edge.
    pub fn at(&self, x: f64, y: f64) -> DVec3 {
        let rows = self.values.len() / self.columns;
        let place = |share: f64, count: usize| {
            let at = share.clamp(0.0, 1.0) * (count - 1) as f64;
            let low = (at as usize).min(count.saturating_sub(2));
            (low, (low + 1).min(count - 1), at - low as f64)
        };
        let ((left, right, across), (top, bottom, down)) = (place(x, self.columns), place(y, rows));
        let row = |y: usize| {
            let (a, b) = (self.values[y * self.columns + left], self.values[y * self.columns + right]);
            a + (b - a) * across
        };
        row(top) + (row(bottom) - row(top)) * down
    }
}

/// Transmittance from points of the air to its top.
#[derive(Clone)]
pub struct Transmittance(Table);

impl Transmittance {
    /// The table of an atmosphere.
    pub fn new(air: &Atmosphere) -> Self {
        let horizon = horizon();
        let entry = |x: f64, y: f64| {
            let rho = horizon * y;
            let radius = (rho * rho + GROUND * GROUND).sqrt();
            let (least, most) = (TOP - radius, rho + horizon);
            let way = least + x * (most - least);
            let cosine =
                if way > 0.0 { (horizon * horizon - rho * rho - way * way) / (2.0 * radius * way) } else { 1.0 };
            decay_of(depth(air, radius, cosine.clamp(-1.0, 1.0)))
        };
        Self(Table::new(COLUMNS, ROWS, entry))
    }

    /// Share of light that passes from a point to the top, on a way that does not meet the ground.
    pub fn to_top(&self, radius: f64, cosine: f64) -> DVec3 {
        let (radius, horizon) = (radius.clamp(GROUND, TOP), horizon());
        let rho = (radius * radius - GROUND * GROUND).max(0.0).sqrt();
        let (least, most) = (TOP - radius, rho + horizon);
        let x = if most > least { (way_to_top(radius, cosine) - least) / (most - least) } else { 0.0 };
        self.0.at(x, rho / horizon)
    }
}

/// Length of a ray along the ground to the top, km.
fn horizon() -> f64 {
    (TOP * TOP - GROUND * GROUND).sqrt()
}

/// Optical depth from a point to the top, by Simpson's rule.
fn depth(air: &Atmosphere, radius: f64, cosine: f64) -> DVec3 {
    let step = way_to_top(radius, cosine) / f64::from(STEPS);
    let at = |index: u32| {
        let way = f64::from(index) * step;
        let height = (radius * radius + way * way + 2.0 * radius * way * cosine).max(0.0).sqrt() - GROUND;
        let weight = [2.0, 4.0][index as usize % 2];
        air.at(height.max(0.0)).extinction * if index == 0 || index == STEPS { 1.0 } else { weight }
    };
    (0..=STEPS).map(at).sum::<DVec3>() * (step / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decay_agrees_with_the_library() {
        let error = |decay: fn(f64) -> f64| {
            let values = (0..=70_000).map(|step| f64::from(step) * 0.01);
            values.map(|x| (decay(x) / (-x).exp() - 1.0).abs()).fold(0.0, f64::max)
        };
        assert!(error(decay) < 1e-13, "{}", error(decay));
        assert!(error(|x| decay(x * (1.0 + 1e-13)) * (1.0 + 1e-12)) > 1e-13);
        assert_eq!((decay(0.0), decay(1e9), decay(f64::NAN)), (1.0, 0.0, 0.0));
    }

    #[test]
    fn straight_up_light_passes_by_the_columns_of_the_air() {
        let air = Atmosphere::EARTH;
        // Heights of the columns: 8 and 1.2 km, and half the base of the triangle of ozone.
        let depth = air.rayleigh * 8.0 + (air.mie + air.mie_absorption) * 1.2 + air.ozone * 15.0;
        let check = |air: &Atmosphere| {
            let through = Transmittance::new(air).to_top(GROUND, 1.0);
            (through / decay_of(depth) - 1.0).abs().max_element() < 0.01
        };
        assert!(check(&air), "{}", Transmittance::new(&air).to_top(GROUND, 1.0));
        assert!(!check(&Atmosphere { rayleigh: air.rayleigh * 1.1, ..air }));
    }
}
