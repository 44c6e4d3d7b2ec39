//! Films of parts of one picture become the film of all of them.

use crate::film::{Film, Pixel};
use crate::region::Region;

/// Films of parts of a picture cannot be joined.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinError {
    /// The films are of pictures of different sizes.
    #[error("the films are of pictures of different sizes")]
    Size,
    /// The films begin with different samples.
    #[error("the films begin with different samples, {0} and {1}")]
    FirstSample(u32, u32),
    /// Only some of the films have light groups, or they differ.
    #[error("the films have different light groups")]
    Groups,
    /// Part of the rectangle around all films is in none of them.
    #[error("no film has the pixel {0},{1}, which lies between the others")]
    Gap(u32, u32),
}

impl Film {
    /// The film of the rectangle around all parts: each of its pixels from the part that has most of its samples, the first of several. AOVs
    /// and earlier states are those of all parts, if all have them.
    ///
    /// # Errors
    /// [`JoinError`] where the parts do not fit together or leave a gap.
    ///
    /// # Panics
    /// If there is no part.
    pub fn join(parts: &[&Self]) -> Result<Self, JoinError> {
        let first = parts.first().expect("at least one film");
        let names = |film: &Self| film.groups.iter().map(|(group, _)| *group).collect::<Vec<_>>();
        for part in parts {
            if (part.width, part.height) != (first.width, first.height) {
                return Err(JoinError::Size);
            }
            if part.first_sample != first.first_sample {
                return Err(JoinError::FirstSample(first.first_sample, part.first_sample));
            }
            if names(part) != names(first) {
                return Err(JoinError::Groups);
            }
        }
        let around = |a: Region, b: &Region| Region {
            x0: a.x0.min(b.x0),
            y0: a.y0.min(b.y0),
            x1: a.x1.max(b.x1),
            y1: a.y1.max(b.y1),
        };
        let region = parts.iter().map(|part| &part.region).fold(first.region, around);
        let owners = owners(parts, region)?;
        let mut film = Self::new(first.width, first.height, region, first.first_sample);
        film.pixels = owners.iter().map(|&(part, index)| parts[part].pixels[index]).collect();
        let aovs = |&(part, index): &(usize, usize)| parts[part].aovs.as_ref().map(|aovs| aovs[index]);
        film.aovs = owners.iter().map(aovs).collect();
        let earlier = |&(part, index): &(usize, usize)| parts[part].earlier.as_ref().map(|earlier| earlier[index]);
        film.earlier = owners.iter().map(earlier).collect();
        film.groups = (0..first.groups.len())
            .map(|number| {
                let pixel = |&(part, index): &(usize, usize)| -> Pixel { parts[part].groups[number].1[index] };
                (first.groups[number].0, owners.iter().map(pixel).collect())
            })
            .collect();
        Ok(film)
    }
}

/// For each pixel of a region the part that it is taken from, and its index there.
fn owners(parts: &[&Film], region: Region) -> Result<Vec<(usize, usize)>, JoinError> {
    let mut owners: Vec<Option<(usize, usize)>> = vec![None; region.pixels()];
    for (number, part) in parts.iter().enumerate() {
        let width = part.region.width() as usize;
        for (index, pixel) in part.pixels.iter().enumerate() {
            let (x, y) = (part.region.x0 as usize + index % width, part.region.y0 as usize + index / width);
            let place = (y - region.y0 as usize) * region.width() as usize + x - region.x0 as usize;
            let is_more = owners[place].is_none_or(|(other, at)| parts[other].pixels[at].samples < pixel.samples);
            if is_more {
                owners[place] = Some((number, index));
            }
        }
    }
    let gap = |place: usize| {
        let (x, y) = (place as u32 % region.width(), place as u32 / region.width());
        JoinError::Gap(region.x0 + x, region.y0 + y)
    };
    owners.into_iter().enumerate().map(|(place, owner)| owner.ok_or_else(|| gap(place))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// A film whose pixels tell where they are.
    fn film(x: [u32; 2], y: [u32; 2], samples: u32) -> Film {
        let region = Region { x0: x[0], y0: y[0], x1: x[1], y1: y[1] };
        let mut film = Film::new(20, 10, region, 3);
        for (index, pixel) in film.pixels.iter_mut().enumerate() {
            let (x, y) = (x[0] + index as u32 % region.width(), y[0] + index as u32 / region.width());
            (0..samples).for_each(|_| pixel.add(Vec3::new(x as f32, y as f32, 1.0), true));
        }
        film
    }

    #[test]
    fn parts_that_fill_a_rectangle_become_its_film_in_any_order() {
        let parts = [film([2, 9], [1, 4], 2), film([9, 20], [1, 8], 2), film([2, 9], [4, 8], 2)];
        let wanted = film([2, 20], [1, 8], 2);
        for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
            assert_eq!(Film::join(&order.map(|part| &parts[part])).unwrap(), wanted);
        }
        // One sample more in a part is another film; where parts overlap it is taken.
        let more = film([4, 6], [2, 3], 5);
        let joined = Film::join(&[&wanted, &more]).unwrap();
        assert_ne!(joined, wanted);
        assert_eq!((joined.sample_range(), Film::join(&[&more, &wanted]).unwrap()), ((2, 5), joined));
    }

    #[test]
    fn gaps_and_strangers_are_refused() {
        let (left, right) = (film([0, 9], [0, 4], 1), film([10, 12], [0, 4], 1));
        assert_eq!(Film::join(&[&left, &right]), Err(JoinError::Gap(9, 0)));
        assert_eq!(Film::join(&[&left, &film([9, 10], [1, 4], 1)]), Err(JoinError::Gap(9, 0)));
        let later = Film { first_sample: 4, ..film([9, 10], [0, 4], 1) };
        assert_eq!(Film::join(&[&left, &later]), Err(JoinError::FirstSample(3, 4)));
        let larger = Film { width: 30, ..film([9, 10], [0, 4], 1) };
        assert_eq!(Film::join(&[&left, &larger]), Err(JoinError::Size));
    }
}
