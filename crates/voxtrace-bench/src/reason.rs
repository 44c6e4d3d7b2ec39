//! Errors of the operating system as people read them.

use std::io;

/// An operating system error without its number, beginning in lower case. Names of files in it stay as they are.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut letters = text.chars();
    match letters.next() {
        // Not an abbreviation, and not a name that it begins with.
        Some(first) if error.raw_os_error().is_some() => first.to_lowercase().chain(letters).collect(),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_keep_their_letters() {
        let own = io::Error::other("Castle.OBJ: this run reads it");
        assert_eq!(reason(&own), "Castle.OBJ: this run reads it");
        let missing = std::fs::read("/nowhere/Castle.OBJ").unwrap_err();
        let text = reason(&missing);
        assert!(!text.contains("os error") && text.chars().next().is_some_and(char::is_lowercase), "{text}");
    }
}
