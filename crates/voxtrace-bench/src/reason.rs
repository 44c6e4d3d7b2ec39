//! Errors of the operating system as people read them.

use std::io;

/// An operating system error without its number, in lower case.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_lowercase()
}
