//! Names of the parts of a scene: a layer, a group, an object.

use super::{ChangeError, numbered};
use crate::packed::Outline;
use std::fmt::{self, Display};
use std::str::FromStr;

/// A part, by its name or else by its number.
///
/// As text: `layer:`, `group:` or `object:` and a name, which stands for all that have it, or a number from 0 on; or only a name, of
/// whatever kind, or the number of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartName {
    /// Anything of this name, else the object of this number.
    Any(String),
    /// A layer.
    Layer(String),
    /// A group with the groups in it.
    Group(String),
    /// An object: an instance of the scene.
    Object(String),
}

impl PartName {
    /// The objects that belong to the part, by their index.
    ///
    /// # Errors
    /// [`ChangeError::MissingPart`] where nothing has this name.
    pub fn objects(&self, outline: &Outline) -> Result<Vec<usize>, ChangeError> {
        let layers = || indices(outline.layers.iter().map(String::as_str));
        let groups = || indices(outline.groups.iter().map(|group| group.name.as_str()));
        let objects = || indices(outline.objects.iter().map(|object| object.name.as_str()));
        let found = match self {
            Self::Layer(name) => of_layers(outline, &named_or_numbered(name, layers())),
            Self::Group(name) => of_groups(outline, &named_or_numbered(name, groups())),
            Self::Object(name) => some(named_or_numbered(name, objects())),
            Self::Any(name) => {
                let (layers, groups) = (named(name, layers()), named(name, groups()));
                let mut found = named(name, objects());
                found.extend(of_layers(outline, &layers).unwrap_or_default());
                found.extend(of_groups(outline, &groups).unwrap_or_default());
                found.sort_unstable();
                found.dedup();
                let is_named = !(layers.is_empty() && groups.is_empty() && found.is_empty());
                if is_named { Some(found) } else { some(named_or_numbered(name, objects())) }
            }
        };
        found.ok_or_else(|| ChangeError::MissingPart { name: self.to_string(), has: contents(outline) })
    }
}

fn indices<'a>(names: impl Iterator<Item = &'a str>) -> Vec<(usize, &'a str)> {
    names.enumerate().collect()
}

fn named(name: &str, all: Vec<(usize, &str)>) -> Vec<usize> {
    all.into_iter().filter(|&(_, own)| own == name && !name.is_empty()).map(|(index, _)| index).collect()
}

fn named_or_numbered(name: &str, all: Vec<(usize, &str)>) -> Vec<usize> {
    let count = all.len();
    let found = named(name, all);
    if !found.is_empty() {
        return found;
    }
    name.parse().ok().filter(|&number| number < count).into_iter().collect()
}

fn some(found: Vec<usize>) -> Option<Vec<usize>> {
    (!found.is_empty()).then_some(found)
}

/// Objects of these layers; a layer may be empty. `None` without a layer.
fn of_layers(outline: &Outline, layers: &[usize]) -> Option<Vec<usize>> {
    let is_in = |object: &crate::packed::Object| object.layer.is_some_and(|layer| layers.contains(&layer));
    (!layers.is_empty()).then(|| (0..outline.objects.len()).filter(|&index| is_in(&outline.objects[index])).collect())
}

fn of_groups(outline: &Outline, groups: &[usize]) -> Option<Vec<usize>> {
    let is_in = |object| groups.iter().any(|&group| outline.is_in_group(object, group));
    (!groups.is_empty()).then(|| (0..outline.objects.len()).filter(|&index| is_in(&outline.objects[index])).collect())
}

/// What a scene has, for people.
fn contents(outline: &Outline) -> String {
    let mut names: Vec<String> = Vec::new();
    let mut add = |kind: &str, name: &str| {
        let text = format!("{kind}:{name}");
        if !name.is_empty() && !names.contains(&text) && names.len() < 12 {
            names.push(text);
        }
    };
    outline.layers.iter().for_each(|name| add("layer", name));
    outline.groups.iter().for_each(|group| add("group", &group.name));
    outline.objects.iter().for_each(|object| add("object", &object.name));
    let mut text = numbered(outline.objects.len(), "object");
    if !outline.layers.is_empty() {
        text += &format!(" and {}", numbered(outline.layers.len(), "layer").trim_start_matches("it has "));
    }
    if names.is_empty() { text + ", none of which has a name" } else { text + ", among them " + &names.join(", ") }
}

/// The shortest names that say which objects are seen and which are not: a layer or a group where all of it changes, else objects.
/// `is_visible` has an entry for each object; returned are the parts to hide and, of those that the file hides, the parts to show.
pub fn visible_parts(outline: &Outline, is_visible: &[bool]) -> (Vec<PartName>, Vec<PartName>) {
    let mut hidden = Vec::new();
    let mut shown = Vec::new();
    for (parts, wanted) in [(&mut hidden, false), (&mut shown, true)] {
        let differs = |index: usize| is_visible[index] == wanted && outline.objects[index].is_hidden == wanted;
        let mut left: Vec<bool> = (0..outline.objects.len()).map(differs).collect();
        let mut take = |objects: Option<Vec<usize>>, name: PartName| {
            let objects = objects.unwrap_or_default();
            let is_whole = objects.iter().all(|&index| is_visible[index] == wanted);
            if is_whole && objects.iter().any(|&index| left[index]) {
                objects.into_iter().for_each(|index| left[index] = false);
                parts.push(name);
            }
        };
        let layers = indices(outline.layers.iter().map(String::as_str));
        for &(index, name) in &layers {
            take(of_layers(outline, &[index]), PartName::Layer(short(index, name, &layers)));
        }
        let groups = indices(outline.groups.iter().map(|group| group.name.as_str()));
        for &(index, name) in &groups {
            take(of_groups(outline, &[index]), PartName::Group(short(index, name, &groups)));
        }
        let objects = indices(outline.objects.iter().map(|object| object.name.as_str()));
        let rest: Vec<usize> = (0..left.len()).filter(|&index| left[index]).collect();
        parts.extend(rest.into_iter().map(|index| PartName::Object(short(index, objects[index].1, &objects))));
    }
    (hidden, shown)
}

/// A name where no other part of the kind has it and it is no number, else the number.
fn short(index: usize, name: &str, all: &[(usize, &str)]) -> String {
    let is_clear = !name.is_empty() && name.trim() == name && name.parse::<usize>().is_err();
    match is_clear && all.iter().filter(|(_, other)| *other == name).count() == 1 {
        true => name.to_owned(),
        false => index.to_string(),
    }
}

impl FromStr for PartName {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let after = |prefix: &str| text.strip_prefix(prefix).map(str::to_owned);
        let named = after("layer:").map(Self::Layer).or_else(|| after("group:").map(Self::Group));
        let named = named.or_else(|| after("object:").map(Self::Object));
        Ok(named.unwrap_or_else(|| Self::Any(text.to_owned())))
    }
}

impl Display for PartName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Any(name) => f.write_str(name),
            Self::Layer(name) => write!(f, "layer:{name}"),
            Self::Group(name) => write!(f, "group:{name}"),
            Self::Object(name) => write!(f, "object:{name}"),
        }
    }
}
