//! Results, on stdout.

use std::io::Write;

/// Prints to stdout. A reader that has gone away (`voxtrace … | head`) is no failure.
pub fn print(text: &str) {
    let mut stdout = std::io::stdout().lock();
    let _ = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
}
