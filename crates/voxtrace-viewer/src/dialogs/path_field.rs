//! A field for a path, with what stands in its folder: in place of the system's dialogs, which not every desktop has.

use std::path::{Path, PathBuf};

/// Most entries of a folder that are looked at.
const MOST_READ: usize = 4096;
/// Most entries that are offered.
pub const MOST_OFFERED: usize = 12;

/// The text of a path, and what could follow.
#[derive(Clone, Debug, Default)]
pub struct PathField {
    /// What was typed.
    pub text: String,
    /// The ending of the files that are offered; of all where it is empty.
    ending: &'static str,
    /// What was typed when `offers` were read.
    read_for: Option<String>,
    offers: Vec<Offer>,
    /// Whether the field was shown since the program changed its text: before, the keyboard goes to its end.
    pub is_settled: bool,
    /// Whether it has the keyboard.
    pub is_focused: bool,
}

/// Something in the folder.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Offer {
    /// Whether it is no folder: those come first.
    pub is_file: bool,
    /// Its name, a folder's with a slash.
    pub name: String,
    /// The text that names it.
    pub text: String,
}

impl PathField {
    /// A field that holds a path.
    pub fn new(path: &Path) -> Self {
        Self { text: path.display().to_string(), ..Self::default() }
    }

    /// A field that holds a path, and offers files with an ending.
    pub fn of_ending(path: &Path, ending: &'static str) -> Self {
        Self { ending, ..Self::new(path) }
    }

    /// The path: what was typed, from the user's folder where it begins with `~/`; the last one where several stand
    /// behind each other. `None` where nothing was typed.
    pub fn path(&self) -> Option<PathBuf> {
        let text = self.text.trim();
        // What desktops copy, where spaces and whatever is not ASCII are written as bytes.
        let decoded = text.rsplit_once("file://").map(|(_, path)| percent_decoded(path));
        let text = decoded.as_deref().unwrap_or(text);
        // A whole path that was typed or pasted behind the folder that stood there: that folder does not count.
        let text = text.rfind("//").map_or(text, |double| &text[double + 1..]);
        let text = text.rfind("/~/").map_or(text, |home| &text[home + 1..]);
        if text.is_empty() {
            return None;
        }
        let of_home = |rest: &str| etcetera::home_dir().ok().map(|home| home.join(rest));
        match text.strip_prefix("~/") {
            Some(rest) => of_home(rest).or_else(|| Some(text.into())),
            None if text == "~" => of_home("").or_else(|| Some(text.into())),
            None => Some(text.into()),
        }
    }

    /// Takes another text.
    pub fn set(&mut self, text: &str) {
        text.clone_into(&mut self.text);
        self.is_settled = false;
    }

    /// What in the folder begins as the last part of the text does: folders first, in alphabetical order. Read when the text changes.
    pub fn offers(&mut self) -> &[Offer] {
        if self.read_for.as_deref() != Some(self.text.as_str()) {
            self.read_for = Some(self.text.clone());
            self.offers = self.read();
        }
        &self.offers
    }

    /// Takes what all offers have in common, or the only one. Returns whether the text grew.
    pub fn complete(&mut self) -> bool {
        let mut texts = self.offers().iter().map(|offer| offer.text.as_str());
        let Some(first) = texts.next() else { return false };
        let common = texts.fold(first, |common, text| &common[..shared_length(common, text)]).to_owned();
        let grows = common.len() > self.text.len();
        if grows {
            self.set(&common);
        }
        grows
    }

    /// Takes a Tab. Returns whether the keyboard stays: where the path grew, or something else could still follow.
    pub fn take_tab(&mut self) -> bool {
        let text = self.text.clone();
        self.complete() || self.offers().iter().any(|offer| offer.text != text)
    }

    fn read(&self) -> Vec<Offer> {
        let (folder, beginning) = match self.text.rfind(['/', std::path::MAIN_SEPARATOR]) {
            Some(slash) => self.text.split_at(slash + 1),
            None => ("", self.text.as_str()),
        };
        let place = Self { text: folder.into(), ..Self::default() }.path().unwrap_or_else(|| ".".into());
        let Ok(entries) = std::fs::read_dir(place) else { return Vec::new() };
        let offer = |entry: std::fs::DirEntry| {
            let name = entry.file_name().into_string().ok()?;
            let is_hidden = name.starts_with('.') && !beginning.starts_with('.');
            if is_hidden || !name.starts_with(beginning) {
                return None;
            }
            // Links count as what they lead to.
            let is_file = !entry.path().is_dir();
            if is_file && !name.ends_with(self.ending) {
                return None;
            }
            let name = if is_file { name } else { name + "/" };
            Some(Offer { is_file, text: format!("{folder}{name}"), name })
        };
        let mut offers: Vec<Offer> = entries.take(MOST_READ).flatten().filter_map(offer).collect();
        offers.sort();
        offers
    }
}

/// A path of an URL with its bytes in place of `%20` and the like; as it is where these are no text.
fn percent_decoded(path: &str) -> String {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digits = after.get(..2).filter(|_| first == b'%').and_then(|digits| str::from_utf8(digits).ok());
        let byte =
            digits.filter(|digits| !digits.starts_with('+')).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(byte.unwrap_or(first));
        rest = if byte.is_some() { &after[2..] } else { after };
    }
    String::from_utf8(bytes).unwrap_or_else(|_| path.to_owned())
}

/// Bytes that two texts begin with alike, up to the end of a character.
fn shared_length(one: &str, other: &str) -> usize {
    one.char_indices()
        .zip(other.chars())
        .find(|((_, own), other)| own != other)
        .map_or(one.len().min(other.len()), |((place, _), _)| place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_completed_from_its_folder_folders_first() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["scans", "scenes", ".hidden"] {
            std::fs::create_dir(folder.path().join(name)).unwrap();
        }
        for name in ["scène.vox", "a.vxt"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let at = |rest: &str| PathField { text: format!("{}/{rest}", folder.path().display()), ..PathField::default() };
        let names = |field: &mut PathField| field.offers().iter().map(|offer| offer.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&mut at("")), ["scans/", "scenes/", "a.vxt", "scène.vox"]);
        assert_eq!(names(&mut at(".")), [".hidden/"]);
        let mut field = at("s");
        assert!(field.complete() && field.text.ends_with("/sc"), "{}", field.text);
        assert!(!field.complete(), "more is not common to them");
        field.text.push_str("en");
        assert!(field.complete() && field.text.ends_with("/scenes/"), "{}", field.text);
        assert_eq!(names(&mut field), Vec::<String>::new());
        assert!(!at("nowhere/").complete());
        // Of files those alone that are asked for.
        let mut scenes = PathField { ending: ".vxt", ..at("") };
        assert_eq!(names(&mut scenes), ["scans/", "scenes/", "a.vxt"]);
    }

    #[test]
    fn the_users_folder_has_its_short_name_and_what_a_desktop_copies_is_a_path() {
        let path = |text: &str| PathField { text: text.into(), ..PathField::default() }.path();
        let home = etcetera::home_dir().unwrap();
        assert_eq!((path("~/a.vox"), path("~")), (Some(home.join("a.vox")), Some(home)));
        assert_eq!(path(" file:///b/c d.ply "), Some("/b/c d.ply".into()));
        assert_eq!(path("file:///b/c%20d%C3%A9.ply"), Some("/b/c dé.ply".into()));
        assert_eq!(path("file:///b/100%.ply"), Some("/b/100%.ply".into()));
        assert_eq!(path("/b/c%20d.ply"), Some("/b/c%20d.ply".into()), "a path as it is");
        // Behind the folder that stood there.
        assert_eq!(path("/here//b/c.vox"), Some("/b/c.vox".into()));
        assert_eq!(path("/here/~/a.vox"), path("~/a.vox"));
        assert_eq!(path("/here/file:///b/c.vox"), Some("/b/c.vox".into()));
        assert_eq!(path("/here/~b/c.vox"), Some("/here/~b/c.vox".into()));
        assert_eq!((path("  "), path("x~/y")), (None, Some("x~/y".into())));
    }
}
