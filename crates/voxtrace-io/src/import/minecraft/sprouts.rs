//! How plants look on their crossed planes where no texture says it: drawn by us, pixel by pixel.

use super::blocks::Look;
use super::shapes::Sprout;

const LEAF: u32 = 0x4f8a2e;
const BARK: u32 = 0x6a5034;
const STALK: u32 = 0xd9cdb8;

/// What is at a place of a plane, `u` to the right and `v` up, each from 0 to 15.
pub(super) fn look(sprout: Sprout, name: &str, u: i32, v: i32, own: Look) -> Option<Look> {
    let green = Look { color: LEAF, light: 0, ..own };
    let is_stem = (7..9).contains(&u);
    match sprout {
        Sprout::Web => if name == "cobweb" { is_web(u, v) } else { is_strand(u, v) }.then_some(own),
        Sprout::Blades => (v < blade(u)).then_some(own),
        Sprout::Crop(height) => (u % 4 != 3 && v < height - (u * 7 + 3) % 4).then_some(own),
        Sprout::Flame => (v < 15 - (u - 7).abs() - (u * 5) % 4).then_some(own),
        Sprout::Sapling => {
            let is_crown = within(2 * u - 15, 2 * v - 19, 11);
            if is_crown { Some(own) } else { (is_stem && v < 6).then_some(Look { color: BARK, ..green }) }
        }
        Sprout::Mushroom => {
            let is_cap = (4..8).contains(&v) && (u - 7).abs() + (v - 4) < 6;
            if is_cap { Some(own) } else { (is_stem && v < 5).then_some(Look { color: STALK, ..green }) }
        }
        Sprout::Blossom => {
            let is_petal = within(2 * u - 15, 2 * v - 21, 6);
            let is_leaf = v < 5 && (v - (u - 7).abs()).abs() < 2;
            if is_petal { Some(own) } else { (is_stem && v < 10 || is_leaf).then_some(green) }
        }
    }
}

/// Whether a place is within a circle; all in half pixels.
fn within(x: i32, y: i32, radius: i32) -> bool {
    x * x + y * y < radius * radius
}

/// How high a blade of grass stands, every other one lower.
fn blade(u: i32) -> i32 {
    [4, 11, 0, 14, 8, 0, 12, 16, 6, 13, 0, 9, 15, 0, 10, 5][u.rem_euclid(16) as usize]
}

/// Strands up and down, with leaves.
fn is_strand(u: i32, v: i32) -> bool {
    let (strand, height) = (u % 5, (v + 3 * (u / 5)) % 6);
    strand == 2 || strand == 1 && height == 0 || strand == 3 && height == 3
}

/// Threads from the middle, and rings.
fn is_web(u: i32, v: i32) -> bool {
    let (x, y) = ((2 * u - 15).abs(), (2 * v - 15).abs());
    let ring = x.max(y);
    x == y || x < 2 || y < 2 || ring == 7 || ring == 13
}

#[cfg(test)]
mod tests {
    use super::super::blocks::Kind;
    use super::*;

    #[test]
    fn every_plant_has_its_colour_and_leaves_room_around_it() {
        let own = Look { color: 0xc43024, kind: Kind::Plain, light: 0 };
        for sprout in [
            Sprout::Blades,
            Sprout::Blossom,
            Sprout::Sapling,
            Sprout::Mushroom,
            Sprout::Crop(10),
            Sprout::Web,
            Sprout::Flame,
        ] {
            for name in ["poppy", "cobweb"] {
                let places = (0..256).map(|place| look(sprout, name, place % 16, place / 16, own));
                let found: Vec<_> = places.collect();
                let own_count = found.iter().flatten().filter(|look| look.color == own.color).count();
                let count = found.iter().flatten().count();
                assert!(own_count > 15 && count < 200, "{sprout:?} {name}: {own_count} of {count}");
            }
        }
    }
}
