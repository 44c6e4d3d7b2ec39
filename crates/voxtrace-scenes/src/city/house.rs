//! Houses: a footprint raised to a height, its façades, its roof behind a parapet.

use super::{
    facade::Facade,
    roofs,
    site::{Dice, Site, place},
};
use crate::kit::*;
use glam::{Vec2, Vec3, vec2, vec3};

/// A house of any footprint.
pub struct House<'a> {
    /// Corners, counter-clockwise, metres.
    pub corners: Vec<Vec2>,
    /// The façade of the wall that begins at each corner.
    pub walls: Vec<Option<&'a Facade>>,
    /// Where it begins: 0 on the ground, a roof for the upper tiers of a tower.
    pub foot: f32,
    /// Height of its parapet above the foot.
    pub height: f32,
    pub paint: Paint,
    pub roof: Paint,
    pub parapet: f32,
    pub seed: u32,
}

impl House<'_> {
    /// A rectangle from (0, 0): the front is y = 0.
    pub fn rectangle(size: Vec2) -> Vec<Vec2> {
        vec![vec2(0.0, 0.0), vec2(size.x, 0.0), size, vec2(0.0, size.y)]
    }

    /// The house without anything on its roof.
    pub fn build(&self, site: &Site) -> Solid {
        let profile = footprint(&self.corners);
        let top = site.snap(self.height);
        let roof = site.snap(self.height - self.parapet);
        let body = extrude(profile.clone(), Axis::Z, -6.0, top);
        let well = extrude(profile.offset(-site.width(0.5)), Axis::Z, roof, top + 4.0);
        let (mut cuts, mut parts) = (vec![well.paint(&self.roof)], Vec::new());
        let count = self.corners.len();
        for (i, wall) in self.walls.iter().enumerate() {
            let Some(facade) = wall else { continue };
            let (from, to) = (self.corners[i], self.corners[(i + 1) % count]);
            let dressing = facade.dress(site, (to - from).length(), self.seed.wrapping_add(i as u32));
            let map = |solids: Vec<Solid>| solids.into_iter().map(move |solid| place(&solid, from, to - from));
            cuts.extend(map(dressing.cuts));
            parts.extend(map(dressing.parts));
        }
        parts.push(body.paint(&self.paint).minus(union(cuts)));
        let house = union(parts);
        if self.foot == 0.0 {
            house
        } else {
            house.within(half_space(vec3(0.0, 0.0, -1.0), Vec3::NEG_Z)).z(site.snap(self.foot))
        }
    }

    /// The house with tanks, stair houses and machines on its roof.
    pub fn furnished(&self, site: &Site, min: Vec2, max: Vec2) -> Solid {
        let mut dice = Dice::new(self.seed);
        let roof = self.foot + site.snap(self.height - self.parapet);
        self.build(site).and(roofs::furniture(site, &mut dice, min, max).z(roof))
    }
}

/// The plane figure of a footprint; a box where it is one, which is quicker.
pub fn footprint(corners: &[Vec2]) -> Profile {
    match *corners {
        [a, b, c, d] if a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x => Profile::rectangle(a, c),
        _ => Profile::polygon(&corners.iter().map(|at| (at.x, at.y)).collect::<Vec<_>>()),
    }
}
