//! What a file asks for, or holds, that scenes do not have: counted by kind, and told in one line, which begins so that programs find it among the
//! notes of a reader.

/// The beginning of the note.
const BEGINNING: &str = "not shown: ";
/// Most kinds that the line names.
const MOST: usize = 16;

/// Parts of a file that are not shown, by kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct NotShown(Vec<(String, Option<u64>)>);

impl NotShown {
    /// Adds so many of a kind, which is named in the singular.
    pub fn count(&mut self, kind: &str, count: u64) {
        if count == 0 {
            return;
        }
        match self.0.iter_mut().find(|(known, _)| known == kind) {
            Some((_, known)) => *known = Some(known.unwrap_or(0).saturating_add(count)),
            None => self.0.push((kind.to_owned(), Some(count))),
        }
    }

    /// Adds what has a name and is there or not.
    pub fn name(&mut self, name: &str) {
        if !self.0.iter().any(|(known, _)| known == name) {
            self.0.push((name.to_owned(), None));
        }
    }

    /// The line; `None` where all is shown.
    pub fn note(&self) -> Option<String> {
        let phrase = |(kind, count): &(String, Option<u64>)| match count {
            None => kind.clone(),
            Some(1) => format!("1 {kind}"),
            Some(count) => match kind.strip_suffix('y').filter(|stem| !stem.ends_with(['a', 'e', 'o', 'u'])) {
                Some(stem) => format!("{count} {stem}ies"),
                None => format!("{count} {kind}s"),
            },
        };
        let mut phrases: Vec<String> = self.0.iter().take(MOST).map(phrase).collect();
        let more = self.0.len().saturating_sub(MOST);
        if more > 0 {
            phrases.push(format!("{more} more kinds"));
        }
        // What comes from files may hold whatever it likes, but no line of its own.
        let phrases = phrases.iter().map(|phrase| phrase.replace([',', '\n', '\r'], " "));
        let text = phrases.collect::<Vec<_>>().join(", ");
        (!text.is_empty()).then(|| format!("{BEGINNING}{text}"))
    }
}

/// What the notes of a reader say that a file asks for, or holds, and is not shown: one phrase each, for example `2 animations`.
pub fn parts_not_shown(notes: &[String]) -> Vec<String> {
    let lists = notes.iter().filter_map(|note| note.strip_prefix(BEGINNING));
    lists.flat_map(|list| list.split(", ")).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_counted_and_told_in_one_line() {
        let mut parts = NotShown::default();
        assert_eq!(parts.note(), None);
        parts.count("skin", 0);
        parts.count("animation", 1);
        parts.count("entity", 2);
        parts.count("animation", 1);
        parts.count("light", 1);
        parts.count("overlay", 3);
        parts.name("KHR_\nof, tomorrow");
        parts.name("KHR_\nof, tomorrow");
        let note = parts.note().unwrap();
        assert_eq!(note, "not shown: 2 animations, 2 entities, 1 light, 3 overlays, KHR_ of  tomorrow");
        let notes = ["a point is left out".to_owned(), note];
        assert_eq!(
            parts_not_shown(&notes),
            ["2 animations", "2 entities", "1 light", "3 overlays", "KHR_ of  tomorrow"]
        );
        (0..20).for_each(|index| parts.name(&format!("part {index}")));
        assert!(parts.note().unwrap().ends_with(", 9 more kinds"), "{:?}", parts.note());
    }
}
