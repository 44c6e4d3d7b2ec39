//! Which points of a cloud are read: those of some classes (ASPRS, "LAS Specification 1.4 R15", table 17), and those in a box
//! of the map.

use glam::{DAffine3, DVec3};
use std::fmt;
use std::str::FromStr;
use voxtrace_voxelize::points::PointCloud;

/// Which points are read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointFilter {
    /// Points of these classes; `None` takes all.
    pub classes: Option<ClassSet>,
    /// Points in this box of the map; `None` takes all.
    pub bounds: Option<MapBounds>,
}

/// A set of classes, 0 to 255.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClassSet([u64; 4]);

/// A box in the coordinates of the file's reference system, its faces included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapBounds {
    /// The corner with the least coordinates.
    pub low: DVec3,
    /// The corner with the largest.
    pub high: DVec3,
}

/// What people call classes, and their numbers.
const NAMES: [(&str, &[u8]); 22] = [
    ("never-classified", &[0]),
    ("unclassified", &[1]),
    ("ground", &[2]),
    ("low-vegetation", &[3]),
    ("medium-vegetation", &[4]),
    ("high-vegetation", &[5]),
    ("vegetation", &[3, 4, 5]),
    ("building", &[6]),
    ("low-noise", &[7]),
    ("high-noise", &[18]),
    ("noise", &[7, 18]),
    ("key-point", &[8]),
    ("water", &[9]),
    ("rail", &[10]),
    ("road", &[11]),
    ("overlap", &[12]),
    ("wire-guard", &[13]),
    ("wire", &[14]),
    ("tower", &[15]),
    ("wire-connector", &[16]),
    ("bridge", &[17]),
    ("snow", &[21]),
];

impl ClassSet {
    /// Adds a class.
    pub fn insert(&mut self, class: u8) {
        self.0[usize::from(class / 64)] |= 1 << (class % 64);
    }

    /// Whether a class is in it.
    pub fn contains(self, class: u8) -> bool {
        self.0[usize::from(class / 64)] >> (class % 64) & 1 == 1
    }

    /// What people call a class; `None` of those that are reserved or of the user's own.
    pub fn name_of(class: u8) -> Option<&'static str> {
        NAMES.iter().find(|(_, numbers)| *numbers == [class]).map(|(name, _)| *name)
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == [0; 4]
    }

    /// The set as bits.
    #[cfg(feature = "points")]
    pub(crate) fn words(self) -> [u64; 4] {
        self.0
    }

    /// The set of such bits.
    #[cfg(feature = "points")]
    pub(crate) fn of_words(words: [u64; 4]) -> Self {
        Self(words)
    }

    /// Adds those of another set.
    pub(crate) fn join(&mut self, other: Self) {
        self.0.iter_mut().zip(other.0).for_each(|(own, other)| *own |= other);
    }
}

impl fmt::Display for ClassSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers: Vec<String> = (0..=255).filter(|&class| self.contains(class)).map(|n| n.to_string()).collect();
        f.write_str(&numbers.join(", "))
    }
}

impl FromStr for ClassSet {
    type Err = String;

    /// Numbers and names, `2,building`; a name may stand for several, as `vegetation` does.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut set = Self::default();
        for word in text.split(',').map(str::trim) {
            let name = word.to_ascii_lowercase().replace(['_', ' '], "-");
            // Several of a thing are the thing.
            let is = |known: &str| name == known || name.strip_suffix('s') == Some(known);
            let named = NAMES.iter().find(|(known, _)| is(known)).map(|(_, numbers)| numbers.to_vec());
            let numbers = named.or_else(|| word.parse().ok().map(|number| vec![number]));
            let numbers = numbers.ok_or_else(|| {
                let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
                format!("{word:?} is no class: classes are numbers from 0 to 255, or {}", names.join(", "))
            })?;
            numbers.into_iter().for_each(|number| set.insert(number));
        }
        Ok(set)
    }
}

impl FromStr for MapBounds {
    type Err = String;

    /// `x0,y0,x1,y1`, of any height, or `x0,y0,z0,x1,y1,z1`.
    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Result<Vec<f64>, _> = text.split(',').map(|word| word.trim().parse::<f64>()).collect();
        let numbers = numbers.unwrap_or_default();
        let (low, high) = match numbers[..] {
            [x0, y0, x1, y1] => (DVec3::new(x0, y0, f64::NEG_INFINITY), DVec3::new(x1, y1, f64::INFINITY)),
            [x0, y0, z0, x1, y1, z1] => (DVec3::new(x0, y0, z0), DVec3::new(x1, y1, z1)),
            _ => return Err(format!("{text:?} is no box: x0,y0,x1,y1 or x0,y0,z0,x1,y1,z1")),
        };
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err(format!("{text:?} has a number that is not finite"));
        }
        // Also says no where they are equal: a box without an inside has no point of a scan.
        if low.cmplt(high).all() {
            Ok(Self { low, high })
        } else {
            Err(format!("the box {text} is empty: x0 < x1 and y0 < y1, and of heights z0 < z1, must hold"))
        }
    }
}

impl MapBounds {
    /// Whether a point lies in the box.
    pub fn contains(self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    /// Whether a box touches this one.
    pub(crate) fn touches(self, (low, high): (DVec3, DVec3)) -> bool {
        low.cmple(self.high).all() && high.cmpge(self.low).all()
    }
}

impl PointFilter {
    /// Whether any point may be left out.
    pub fn is_asked(self) -> bool {
        self.classes.is_some() || self.bounds.is_some()
    }

    /// Keeps those points of a cloud that are asked for.
    ///
    /// # Errors
    /// A sentence, if the points have no classes and some are asked for, or none is left.
    pub(crate) fn apply(self, cloud: &mut PointCloud) -> Result<(), String> {
        if !self.is_asked() || cloud.positions.is_empty() {
            return Ok(());
        }
        if self.classes.is_some() && cloud.classes.is_empty() {
            return Err("the points have no classes to choose by".into());
        }
        let mut classes = ClassSet::default();
        cloud.classes.iter().for_each(|&class| classes.insert(class));
        let (count, bounds, map_from_cloud) = (cloud.positions.len() as u64, cloud.bounds(), cloud.crs_from_cloud);
        self.retain(cloud, map_from_cloud);
        if cloud.positions.is_empty() {
            return Err(none_left(count, bounds.map(|bounds| on_map(bounds, map_from_cloud)), classes));
        }
        Ok(())
    }

    /// Keeps those points that are asked for. A cloud without classes has none of any class.
    pub(crate) fn retain(self, cloud: &mut PointCloud, map_from_cloud: DAffine3) {
        let is_kept = |at: usize| {
            let place = || map_from_cloud.transform_point3(cloud.positions[at].as_dvec3() + cloud.offset);
            let has_class = |classes: ClassSet| cloud.classes.get(at).is_some_and(|&class| classes.contains(class));
            self.classes.is_none_or(has_class) && self.bounds.is_none_or(|bounds| bounds.contains(place()))
        };
        let kept: Vec<bool> = (0..cloud.positions.len()).map(is_kept).collect();
        retain(&mut cloud.positions, &kept);
        retain(&mut cloud.colors, &kept);
        retain(&mut cloud.intensities, &kept);
        retain(&mut cloud.classes, &kept);
    }
}

/// A box in the coordinates of the map.
pub(crate) fn on_map((low, high): (DVec3, DVec3), map_from_cloud: DAffine3) -> (DVec3, DVec3) {
    let corners = [low, high].map(|corner| map_from_cloud.transform_point3(corner));
    (corners[0].min(corners[1]), corners[0].max(corners[1]))
}

/// Keeps what is marked; an empty array stays so.
fn retain<T>(items: &mut Vec<T>, kept: &[bool]) {
    let mut marks = kept.iter();
    items.retain(|_| marks.next().copied().unwrap_or(false));
}

/// What is said where no point is left, with where the points are and their classes.
pub(crate) fn none_left(count: u64, span: Option<(DVec3, DVec3)>, classes: ClassSet) -> String {
    let span = span.filter(|(low, high)| low.is_finite() && high.is_finite());
    let span = span.map_or(String::new(), |(low, high)| {
        // To a millionth, as `info` tells coordinates.
        let text = |number: &f64| ((number * 1e6).round() / 1e6).to_string();
        let numbers: Vec<String> = [low.to_array(), high.to_array()].concat().iter().map(text).collect();
        format!(" lie in the box {}", numbers.join(","))
    });
    let are = if classes.is_empty() { String::new() } else { format!(" are of the classes {classes}") };
    let and = if span.is_empty() || are.is_empty() { "" } else { ", and" };
    let they = if span.is_empty() && are.is_empty() { "" } else { ": they" };
    format!("none of the {count} points is among those asked for{they}{span}{and}{are}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn classes_are_numbers_and_names_alone_or_for_several() {
        let set: ClassSet = "2, Building,vegetation,255".parse().unwrap();
        assert_eq!(set.to_string(), "2, 3, 4, 5, 6, 255");
        assert_eq!("high_vegetation,buildings".parse::<ClassSet>().unwrap().to_string(), "5, 6");
        assert!(!set.contains(0) && set.contains(255) && ClassSet::default().is_empty());
        for wrong in ["", "2,", "256", "-1", "house"] {
            assert!(wrong.parse::<ClassSet>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn boxes_have_four_numbers_or_six_and_an_inside() {
        let flat: MapBounds = "-1,0,1,2.5".parse().unwrap();
        assert!(flat.contains(DVec3::new(1.0, 2.5, -1e9)) && !flat.contains(DVec3::new(1.1, 0.0, 0.0)));
        let high: MapBounds = "0,0,5,1,1,6".parse().unwrap();
        assert!(high.contains(DVec3::splat(5.5).with_x(0.5).with_y(0.5)) && !high.contains(DVec3::splat(0.5)));
        for wrong in ["", "1,2,3", "0,0,0,0", "1,0,0,1", "0,0,nan,1", "0,0,5,1,1,5", "0,0,5,1,1,6,7"] {
            assert!(wrong.parse::<MapBounds>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_cloud_keeps_what_is_asked_for_and_says_what_it_has_where_that_is_nothing() {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::X * 2.0];
        let cloud = PointCloud {
            positions,
            classes: vec![1, 2, 2],
            intensities: vec![7, 8, 9],
            offset: DVec3::splat(1e6),
            ..PointCloud::default()
        };
        let mut kept = cloud.clone();
        let bounds = Some("1000000,999999,1000001,1000001".parse().unwrap());
        PointFilter { classes: Some("ground".parse().unwrap()), bounds }.apply(&mut kept).unwrap();
        assert_eq!((kept.positions, kept.intensities, kept.classes), (vec![Vec3::X], vec![8], vec![2]));
        let classes = Some("9".parse().unwrap());
        let none = PointFilter { classes, bounds: None }.apply(&mut cloud.clone()).unwrap_err();
        assert!(
            none.ends_with("1000000,1000000,1000000,1000002,1000000,1000000, and are of the classes 1, 2"),
            "{none}"
        );
        let bare = PointCloud { classes: Vec::new(), ..cloud };
        assert!(PointFilter { classes, bounds: None }.apply(&mut bare.clone()).unwrap_err().contains("no classes"));
    }
}
