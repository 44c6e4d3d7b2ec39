//! Clouds of points: which attribute colours them, which classes are shown, and how many points make a voxel. Each is an option of `render`, too; the
//! file is read again with it, and the view stays in its place on the map.

use crate::session::{Command, Session};
use crate::{text_key, tr};
use std::sync::Arc;
use voxtrace::points::Attributes;

/// What the points of a file are.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PointsSeen {
    /// How many were read.
    pub count: u64,
    /// What each has besides its place.
    pub attributes: Attributes,
    /// The classes that occur, and how many points are of each.
    pub classes: Vec<(u8, u64)>,
}

/// The attributes that colour points, by the words of `--color-by`, with what they need and a line about each.
pub const COLORS: [(&str, &str); 5] = [
    ("auto", text_key!("points.auto")),
    ("rgb", text_key!("points.rgb")),
    ("height", text_key!("points.height")),
    ("intensity", text_key!("points.intensity")),
    ("classification", text_key!("points.classification")),
];

/// What was chosen about points.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PointsChoice {
    /// `--color-by`; `None`: as the command line says.
    pub color_by: Option<&'static str>,
    /// `--classes`, by number; `None`: as the command line says.
    pub classes: Option<Vec<u8>>,
    /// `--min-points`; `None`: as the command line says.
    pub min_points: Option<u32>,
    /// `--resolution`; `None`: as the command line says, or by how dense the points are.
    pub resolution: Option<u32>,
}

impl PointsChoice {
    /// The word of `--classes`.
    pub fn classes_word(&self) -> Option<String> {
        let numbers = |classes: &Vec<u8>| classes.iter().map(u8::to_string).collect::<Vec<_>>().join(",");
        self.classes.as_ref().map(numbers)
    }

    /// The options as words.
    fn words(&self) -> Vec<(&'static str, String)> {
        let options = [
            ("--color-by", self.color_by.map(str::to_owned)),
            ("--classes", self.classes_word()),
            ("--min-points", self.min_points.map(|points| points.to_string())),
            ("--resolution", self.resolution.map(|voxels| voxels.to_string())),
        ];
        options.into_iter().filter_map(|(option, word)| Some((option, word?))).collect()
    }

    /// The options with which a scene is read, with what was chosen in the place of what was given.
    pub(crate) fn over(&self, options: &[String]) -> Vec<String> {
        let words = self.words();
        let mut kept = Vec::new();
        let mut options = options.iter();
        while let Some(option) = options.next() {
            let is_ours = |(name, _): &(&str, String)| option == name || option.starts_with(&format!("{name}="));
            // The size of a voxel says the same as the number of voxels.
            let is_size =
                self.resolution.is_some() && (option == "--voxel-size" || option.starts_with("--voxel-size="));
            if !is_size && !words.iter().any(is_ours) {
                kept.push(option.clone());
            } else if !option.contains('=') {
                options.next();
            }
        }
        kept.extend(words.into_iter().flat_map(|(option, word)| [option.to_owned(), word]));
        kept
    }
}

/// The points of the scene that is open.
#[derive(Clone, Debug)]
pub struct Points {
    /// What they are: all that were read first.
    pub seen: Arc<PointsSeen>,
    /// What was chosen here.
    pub choice: PointsChoice,
    /// The choice that is shown: the other one's points may be on their way.
    pub(crate) shown: PointsChoice,
}

impl Points {
    /// Points that were opened as the command line says.
    pub fn new(seen: Arc<PointsSeen>) -> Self {
        Self { seen, choice: PointsChoice::default(), shown: PointsChoice::default() }
    }

    /// Whether points of a class are shown, as far as it is known here.
    pub fn shows(&self, class: u8) -> bool {
        self.choice.classes.as_ref().is_none_or(|classes| classes.contains(&class))
    }

    /// What shows a class, or hides it.
    pub fn with_class(&self, class: u8, is_shown: bool) -> PointsChoice {
        let all = self.seen.classes.iter().map(|(own, _)| *own);
        let classes: Vec<u8> =
            all.clone().filter(|&own| if own == class { is_shown } else { self.shows(own) }).collect();
        // All of them are no choice.
        PointsChoice { classes: (classes.len() < all.count()).then_some(classes), ..self.choice.clone() }
    }
}

impl Session {
    /// Takes what is known of the points of a scene that was opened; of one that is read again, other classes are no news.
    pub(crate) fn take_points(&mut self, seen: Option<Arc<PointsSeen>>, is_again: bool) {
        match (is_again, &mut self.points) {
            (true, Some(points)) => points.shown = points.choice.clone(),
            (true, None) => {}
            (false, points) => *points = seen.map(Points::new),
        }
    }

    /// What was chosen about points.
    pub fn chosen_points(&self) -> Option<PointsChoice> {
        self.points.as_ref().map(|points| points.choice.clone())
    }

    /// Reading the scene again was stopped, or failed: what is chosen of points and values is what is shown.
    pub(crate) fn keep_shown_choices(&mut self) {
        if let Some(points) = &mut self.points {
            points.choice = points.shown.clone();
        }
        self.keep_shown_values();
    }

    /// Reads the points again in another way; the view stays.
    pub fn set_points(&mut self, choice: PointsChoice) {
        let Some(before) = self.chosen_points() else { return };
        if choice.classes.as_ref().is_some_and(Vec::is_empty) {
            self.say(tr!("points.no_class_left"), false);
        } else if choice != before && !self.refuses_to_read_again() {
            if let Some(points) = &mut self.points {
                points.choice = choice;
            }
            self.ask(Command::LoadAgain);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_chosen_takes_the_place_of_what_was_given() {
        let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let (color_by, classes) = (Some("height"), Some(vec![2, 6]));
        let choice = PointsChoice { color_by, classes, ..PointsChoice::default() };
        let given = words("--classes=ground --voxel-size 1m --color-by rgb --min-points 2");
        assert_eq!(choice.over(&given), words("--voxel-size 1m --min-points 2 --color-by height --classes 2,6"));
        assert_eq!(PointsChoice::default().over(&given), given);
        let fewer = PointsChoice { resolution: Some(90), ..PointsChoice::default() };
        let sized = words("--classes=ground --color-by rgb --min-points 2 --resolution 90");
        assert_eq!(fewer.over(&given), sized, "the size of a voxel would say the same otherwise");
        assert_eq!(fewer.over(&words("--resolution=7 --voxel-size=2m")), words("--resolution 90"));
    }

    #[test]
    fn a_class_is_hidden_and_shown_again_and_all_of_them_are_no_choice() {
        let seen = PointsSeen { classes: vec![(1, 5), (2, 9), (6, 1)], ..PointsSeen::default() };
        let mut points = Points::new(Arc::new(seen));
        points.choice = points.with_class(2, false);
        assert_eq!(
            (points.choice.classes_word().as_deref(), points.shows(2), points.shows(6)),
            (Some("1,6"), false, true)
        );
        points.choice = points.with_class(2, true);
        assert_eq!(points.choice, PointsChoice::default());
    }
}
