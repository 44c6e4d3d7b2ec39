//! Vehicles: cabs, private cars, delivery vans, buses.

use super::site::Site;
use crate::kit::*;
use glam::vec3;

/// The vehicles, heading along +x, on the origin.
pub struct Cars {
    pub cab: Solid,
    pub private: Vec<Solid>,
    pub van: Solid,
    pub bus: Solid,
}

impl Cars {
    pub fn new(site: &Site) -> Self {
        let ramps = site.paints.ramps;
        let tones = [
            ramps.iron.even(0.35, 0.3),
            ramps.steel.even(0.5, 0.3),
            ramps.cream.even(0.8, 0.25),
            ramps.iron.even(0.75, 0.3),
            ramps.blue.even(0.4, 0.3),
            ramps.red.even(0.6, 0.3),
            ramps.steel.even(0.2, 0.3),
            ramps.copper.even(0.2, 0.3),
            ramps.cream.even(0.4, 0.25),
        ];
        let sign = cuboid(vec3(-0.35, -0.5, 1.4), vec3(0.15, 0.5, site.snap(1.5) + site.width(0.25)))
            .paint(&Paint::plain(ramps.cream.even(0.9, 0.2)));
        Self {
            cab: car(site, ramps.cab.even(0.55, 0.45)).and(sign),
            private: tones.into_iter().map(|tone| car(site, tone)).collect(),
            van: van(site),
            bus: bus(site),
        }
    }
}

/// A saloon car, 4.6 m long.
fn car(site: &Site, tone: Tone) -> Solid {
    let ramps = site.paints.ramps;
    let [sill, bonnet, top] = [0.3, 0.9, 1.5].map(|z| site.snap(z));
    let (half, narrow) = (site.snap(0.92), site.snap(0.92) - if site.voxel < 0.15 { 0.1 } else { 0.0 });
    let (rear, front) = (site.snap(-2.3), site.snap(2.3));
    let body = Profile::polygon(&[
        (rear, sill),
        (front, sill),
        (front, 0.72 * bonnet),
        (front - 0.25, bonnet),
        (rear + 0.1, bonnet),
        (rear, 0.9 * bonnet),
    ]);
    let cabin = Profile::polygon(&[(-1.8, bonnet - 0.1), (1.2, bonnet - 0.1), (0.4, top), (-1.2, top)]);
    let paint = Paint::new(move |p| {
        let at = p.at;
        let lamp = (0.55..0.85).contains(&at.z) && at.y.abs() > 0.45;
        if lamp && at.x > 2.0 {
            return ramps.cream.even(0.95, 0.1);
        }
        if lamp && at.x < -2.0 {
            return ramps.red.even(0.8, 0.2);
        }
        if at.z < 0.3 { ramps.iron.even(0.4, 0.3) } else { tone }
    });
    let windows = Paint::new(move |p| {
        let pillar = p.voxel < 0.2 && (p.at.x + 0.35).abs() < 0.06;
        if p.at.z > top - p.voxel.max(0.12) || pillar { tone } else { ramps.glass.even(0.3 + 0.2 * p.at.z, 0.25) }
    });
    let wheel = extrude(Profile::Disc(0.34), Axis::Y, -half, half);
    union([
        extrude(body, Axis::Y, -half, half).paint(&paint),
        extrude(cabin, Axis::Y, -narrow, narrow).paint(&windows),
        union([wheel.x(1.4), wheel.x(-1.4)]).z(0.34).paint(&site.paints.tyre),
    ])
}

fn van(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let side =
        Profile::polygon(&[(-3.0, 0.35), (3.0, 0.35), (3.0, 1.2), (2.3, 2.0), (1.6, 2.15), (1.5, 2.9), (-3.0, 2.9)]);
    let paint = Paint::new(move |p| {
        if p.at.z < 0.6 {
            ramps.iron.even(0.4, 0.3)
        } else if p.at.x > 1.6 && (1.2..1.9).contains(&p.at.z) {
            ramps.glass.even(0.4, 0.3)
        } else if p.at.x < 1.2 && (1.3..1.9).contains(&p.at.z) && p.at.x > -2.4 {
            [ramps.green, ramps.russet, ramps.blue][(p.chance() * 3.0) as usize].even(0.5, 0.3)
        } else {
            ramps.cream.even(0.7, 0.25)
        }
    });
    let wheel = extrude(Profile::Disc(0.42), Axis::Y, -1.0, 1.0);
    extrude(side, Axis::Y, -1.05, 1.05)
        .paint(&paint)
        .and(union([wheel.x(1.9), wheel.x(-1.9)]).z(0.42).paint(&site.paints.tyre))
}

fn bus(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let paint = Paint::new(move |p| {
        let at = p.at;
        if at.z < 0.6 {
            return ramps.iron.even(0.4, 0.3);
        }
        if (1.3..2.3).contains(&at.z) && noise::fraction(at.x / 1.5) * 1.5 > p.voxel {
            return ramps.glass.even(0.3, 0.3);
        }
        if at.x > 5.8 && at.z > 2.4 {
            return ramps.glow.even(0.5, 0.3);
        }
        if (0.9..1.25).contains(&at.z) { ramps.blue.even(0.6, 0.3) } else { ramps.cream.even(0.75, 0.25) }
    });
    let body = rounded_cuboid(vec3(-6.0, -1.25, 0.35), vec3(6.0, 1.25, 3.1), 0.2).paint(&paint);
    let wheel = extrude(Profile::Disc(0.5), Axis::Y, -1.22, 1.22);
    let cooler = block(2.0, 1.6, 0.4).at(vec3(-3.5, 0.0, 3.0)).paint(&site.paints.steel);
    union([body, cooler, union([wheel.x(3.6), wheel.x(-3.4)]).z(0.5).paint(&site.paints.tyre)])
}
