//! Words of a command line: options with values, numbers that are read as the same bits, and quotes for a POSIX shell.

use super::quoted;
use voxtrace::camera::Lens;
use voxtrace::glam::Vec3;
use voxtrace::lines::{Line, Lines};

/// The words of a command.
pub struct Words(pub Vec<String>);

impl Words {
    /// An option with its value, if it has one.
    pub fn value(&mut self, option: &str, value: Option<String>) {
        match value {
            // Else it would look like an option.
            Some(value) if value.starts_with('-') => self.0.push(format!("{option}={value}")),
            Some(value) => self.0.extend([option.to_owned(), value]),
            None => {}
        }
    }

    /// All of it, quoted for a POSIX shell.
    pub fn line(&self) -> String {
        self.0.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
    }

    /// An option without a value, if it is set.
    pub fn flag(&mut self, option: &str, is_set: bool) {
        self.0.extend(is_set.then(|| option.to_owned()));
    }
}

/// The shortest decimal number that reads as the same bits.
pub fn number(value: f32) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// `x,y,z`.
pub fn vector(value: Vec3) -> String {
    value.to_array().map(number).join(",")
}

/// The options of a lens; a pinhole needs none where the camera `is_pinhole` by itself, and a thin lens is a pinhole with an aperture.
pub fn say_lens(lens: Lens, is_pinhole: bool, words: &mut Words) {
    let projection = match lens {
        Lens::Pinhole | Lens::Thin { .. } => (!is_pinhole).then_some("pinhole"),
        other => Some(other.name()),
    };
    words.value("--projection", projection.map(str::to_owned));
    for (setting, value) in lens.settings() {
        words.value(&format!("--{}", setting.replace('_', "-")), Some(number(value)));
    }
}

/// The options of lines on voxels.
pub fn say_lines(lines: &Lines, words: &mut Words) {
    let line = |line: Line| format!("{},{}", number(line.width), vector(line.color));
    words.0.extend(lines.edges.map(|edges| format!("--edges={}", line(edges))));
    words.0.extend(lines.grid.map(|grid| format!("--grid={},{}", line(grid.line), grid.spacing)));
}
