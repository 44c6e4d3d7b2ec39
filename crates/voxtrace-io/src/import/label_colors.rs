//! Tables of label colours as programs for scans write them: FreeSurfer's lookup tables (`FreeSurferColorLUT.txt`), 3D Slicer's `.ctbl` and `.csv`,
//! ITK-SNAP's label descriptions, `dseg.tsv` of BIDS, and plain CSV. The form is told by the lines, not by the name.

use super::source::opened;
use glam::Vec3;
use std::collections::BTreeMap;
use std::path::Path;
use voxtrace_scene::material::linear_color;
use voxtrace_voxelize::volume::LabelColor;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Most bytes of a table.
const MOST_BYTES: u64 = 16 << 20;

/// Reads a table of label colours.
///
/// Understood are lines of `index name red green blue alpha` (FreeSurfer, where every alpha is 0, and 3D Slicer, where 0 hides), of `index red green blue
/// alpha visible mesh "name"` (ITK-SNAP), and values apart by commas, semicolons or tabs: under a line with names of columns, or `value,#rrggbb` or `value,red,green,blue`,
/// both with an opacity from 0 to 1 behind them. Channels are sRGB from 0 to 255. What follows a `#` at the begin of a line is a comment.
///
/// # Errors
/// If the file cannot be read, or holds no such table; the error has the byte of the faulty line.
pub fn read_label_colors(path: &Path) -> Result<BTreeMap<i32, LabelColor>, ImportError> {
    opened::note(path);
    let io = |error| ImportError::io(path, error);
    let size = std::fs::metadata(path).map_err(io)?.len();
    if size > MOST_BYTES {
        return Err(ImportError::limit(path, None, "bytes of a table of label colours", size, MOST_BYTES));
    }
    let bytes = std::fs::read(path).map_err(io)?;
    label_colors_from_bytes(&bytes, path)
}

/// As [`read_label_colors`], from bytes in memory; `path` names them in errors.
///
/// # Errors
/// As [`read_label_colors`].
pub fn label_colors_from_bytes(bytes: &[u8], path: &Path) -> Result<BTreeMap<i32, LabelColor>, ImportError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| ImportError::malformed(path, error.valid_up_to() as u64, "the table is no text"))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let start = bytes.len() - text.len();
    let (mut rows, mut columns, mut offset) = (Vec::new(), None, start);
    for line in text.split_inclusive('\n') {
        let at = offset as u64;
        offset += line.len();
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') || line.starts_with("//") {
            continue;
        }
        let malformed = |what: String| ImportError::malformed(path, at, format!("the line {line:?}: {what}"));
        // What stands behind the first value; names may hold any of them.
        let Some(apart) = line.chars().find(|next| ",;\t ".contains(*next)).filter(|&next| next != ' ') else {
            rows.push(by_spaces(line).map_err(malformed)?);
            continue;
        };
        let cells = cells_of(line, apart);
        let is_number = cells[0].parse::<f64>().is_ok();
        if rows.is_empty() && columns.is_none() && !is_number {
            columns = Some(Columns::of(&cells).map_err(malformed)?);
        } else if let Some(columns) = &columns {
            rows.push(columns.row(&cells).map_err(malformed)?);
        } else if apart == '\t' && cells[1].parse::<f64>().is_err() && !cells[1].starts_with('#') {
            rows.push(by_spaces(line).map_err(malformed)?);
        } else {
            rows.push(plain(&cells).map_err(malformed)?);
        }
    }
    if rows.is_empty() {
        let kind = ImportErrorKind::Malformed("the table has no line with a label and its colour".into());
        return Err(ImportError::of_file(path, kind));
    }
    // FreeSurfer's tables say 0 for every label, and mean opaque.
    let is_free_surfer =
        rows.iter().all(|row| row.alpha.is_none_or(|alpha| alpha == 0.0)) && rows.iter().all(|row| row.is_lut);
    let look = |row: &Row| {
        let opacity = if is_free_surfer { 1.0 } else { row.alpha.unwrap_or(1.0) };
        (row.label, LabelColor { color: row.color, opacity })
    };
    Ok(rows.iter().map(look).collect())
}

/// The values of a line, which may stand in quotes.
fn cells_of(line: &str, apart: char) -> Vec<String> {
    let mut is_quoted = false;
    let cells = line.split(|next| {
        is_quoted ^= next == '"';
        next == apart && !is_quoted
    });
    cells.map(|cell| cell.trim().trim_matches('"').to_owned()).collect()
}

/// One label.
struct Row {
    label: i32,
    color: Vec3,
    /// Its opacity, if the line says one.
    alpha: Option<f32>,
    /// Whether the line is as FreeSurfer writes them.
    is_lut: bool,
}

/// A line whose values are apart by blanks.
fn by_spaces(line: &str) -> Result<Row, String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    // ITK-SNAP: the name comes last, in quotes.
    if line.ends_with('"') && words.len() >= 8 {
        let is_visible = number(words[5])? != 0.0;
        let alpha = if is_visible { share(words[4])? } else { 0.0 };
        return Ok(Row { label: label(words[0])?, color: channels(&words[1..4])?, alpha: Some(alpha), is_lut: false });
    }
    // Otherwise the name is whatever stands between the label and the last numbers.
    let numbers = words.iter().rev().take_while(|word| word.parse::<f64>().is_ok()).count();
    if words.len() < 5 || numbers < 3 {
        return Err("expected a label, its name, and red, green, blue and alpha".into());
    }
    let has_alpha = numbers >= 4 && words.len() >= 6 || words.len() == 5 && numbers == 5;
    let colors = &words[words.len() - if has_alpha { 4 } else { 3 }..];
    let alpha = colors.get(3).map(|word| byte(word)).transpose()?;
    Ok(Row { label: label(words[0])?, color: channels(&colors[..3])?, alpha, is_lut: true })
}

/// `value,#rrggbb` or `value,red,green,blue`, either with an opacity.
fn plain(cells: &[String]) -> Result<Row, String> {
    let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
    let (color, rest) = match cells[..] {
        [_, color, ref rest @ ..] if color.starts_with('#') => (hexadecimal(color)?, rest),
        [_, _, _, _, ref rest @ ..] => (channels(&cells[1..4])?, rest),
        _ => return Err("expected value,#rrggbb or value,red,green,blue".into()),
    };
    let alpha = match rest {
        [] => None,
        [opacity] => Some(share(opacity)?),
        _ => return Err("more values than a label, its colour and its opacity".into()),
    };
    Ok(Row { label: label(cells[0])?, color, alpha, is_lut: false })
}

/// Which column holds what.
struct Columns {
    label: usize,
    /// One column of `#rrggbb`, or those of red, green and blue.
    color: Vec<usize>,
    /// From 0 to 255.
    alpha: Option<usize>,
    /// From 0 to 1.
    opacity: Option<usize>,
}

impl Columns {
    fn of(cells: &[String]) -> Result<Self, String> {
        let names: Vec<String> = cells.iter().map(|cell| cell.to_lowercase().replace([' ', '_'], "")).collect();
        let find = |wanted: &[&str]| names.iter().position(|name| wanted.contains(&name.as_str()));
        let label = find(&["labelvalue", "value", "label", "index", "id", "idx", "no."]);
        let label = label.ok_or("no column is named value, label, index or id")?;
        let channels = [&["r", "red", "colorr"], &["g", "green", "colorg"], &["b", "blue", "colorb"]];
        let channels: Option<Vec<usize>> = channels.iter().map(|wanted| find(&wanted[..])).collect();
        let color = channels.or_else(|| find(&["color", "colour", "hex"]).map(|at| vec![at]));
        let color = color.ok_or("no columns are named color, or red, green and blue")?;
        Ok(Self { label, color, alpha: find(&["a", "alpha", "colora"]), opacity: find(&["opacity"]) })
    }

    fn row(&self, cells: &[String]) -> Result<Row, String> {
        let cell = |at: usize| cells.get(at).map(String::as_str).ok_or("it has fewer values than columns");
        let color = match self.color[..] {
            [one] => hexadecimal(cell(one)?)?,
            _ => channels(&self.color.iter().map(|&at| cell(at)).collect::<Result<Vec<_>, _>>()?)?,
        };
        let alpha = match (self.opacity, self.alpha) {
            (Some(at), _) => Some(share(cell(at)?)?),
            (None, Some(at)) => Some(byte(cell(at)?)?),
            (None, None) => None,
        };
        Ok(Row { label: label(cell(self.label)?)?, color, alpha, is_lut: false })
    }
}

fn number(word: &str) -> Result<f64, String> {
    word.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| format!("{word:?} is not a number"))
}

fn label(word: &str) -> Result<i32, String> {
    let value = number(word)?;
    let is_label = value.fract() == 0.0 && value.abs() <= f64::from(i32::MAX);
    if is_label { Ok(value as i32) } else { Err(format!("the label {word} is not a whole number")) }
}

/// A number from 0 to 1.
fn share(word: &str) -> Result<f32, String> {
    let value = number(word)?;
    if (0.0..=1.0).contains(&value) { Ok(value as f32) } else { Err(format!("the opacity {word} is not from 0 to 1")) }
}

/// A number from 0 to 255 as one from 0 to 1.
fn byte(word: &str) -> Result<f32, String> {
    let value = number(word)?;
    if (0.0..=255.0).contains(&value) {
        Ok((value / 255.0) as f32)
    } else {
        Err(format!("{word} is not from 0 to 255"))
    }
}

fn channels(words: &[&str]) -> Result<Vec3, String> {
    let channel = |at: usize| byte(words[at]).map(|share| (share * 255.0).round() as u8);
    Ok(linear_color([channel(0)?, channel(1)?, channel(2)?]))
}

fn hexadecimal(text: &str) -> Result<Vec3, String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let is_hex = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    let value = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex);
    let value = value.ok_or_else(|| format!("{text:?} is not a colour like #88aaff"))?;
    let [_, red, green, blue] = value.to_be_bytes();
    Ok(linear_color([red, green, blue]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<(i32, [u8; 3], f32)>, String> {
        let table = label_colors_from_bytes(text.as_bytes(), Path::new("table")).map_err(|error| error.to_string())?;
        let srgb = |color: Vec3| color.to_array().map(voxtrace_scene::material::srgb_from_linear);
        Ok(table.into_iter().map(|(label, look)| (label, srgb(look.color), look.opacity)).collect())
    }

    #[test]
    fn tables_of_the_common_programs_are_read() {
        let wanted = vec![(2, [245, 245, 245], 1.0), (17, [220, 216, 20], 1.0)];
        for text in [
            // FreeSurfer.
            "#No. Label Name:   R   G   B   A\n\n2  Left-Cerebral-White-Matter  245 245 245 0\n17 Left-Hippocampus 220 216 20 0\n",
            // 3D Slicer.
            "# Color table file x.ctbl\n# 2 values\n2 white_matter 245 245 245 255\n17 hippocampus 220 216 20 255\r\n",
            "LabelValue,Name,Color_R,Color_G,Color_B,Color_A\n2,white matter,245,245,245,255\n17,\"hippocampus, left\",220,216,20,255\n",
            // ITK-SNAP.
            "# IDX -R- -G- -B- -A-- VIS MSH LABEL\n 2 245 245 245 1 1 1 \"white matter\"\n 17 220 216 20 1 1 1 \"Hippocampus, left 3\"\n",
            // BIDS.
            "index\tname\tcolor\n2\twhite matter\t#f5f5f5\n17\thippocampus\t#dcd814\n",
            "\u{feff}2,#f5f5f5\n17,#DCD814,1.0\n",
            "value;red;green;blue;opacity\n2;245;245;245;1\n17;220;216;20;1\n",
            "2,245,245,245\n17,220,216,20,1\n",
        ] {
            assert_eq!(read(text), Ok(wanted.clone()), "{text}");
        }
        let other = read("2 245 245 245 1 1 1 \"a\"\n17 220 216 21 1 1 1 \"b\"\n").unwrap();
        assert_ne!(other, wanted, "another colour is noticed");
    }

    #[test]
    fn opacities_are_those_of_each_program() {
        let opacity = |text: &str| read(text).unwrap().iter().map(|row| row.2).collect::<Vec<_>>();
        assert_eq!(opacity("0 background 0 0 0 0\n1 skin 9 9 9 51\n"), [0.0, 0.2]);
        assert_eq!(opacity("1 1 1 1 0.5 1 0 \"half\"\n2 1 1 1 1 0 0 \"hidden\"\n"), [0.5, 0.0]);
        assert_eq!(opacity("1,#ffffff,0.25\n2,#ffffff\n"), [0.25, 1.0]);
        assert_eq!(opacity("id,r,g,b,a\n1,1,1,1,0\n2,1,1,1,255\n"), [0.0, 1.0]);
    }

    #[test]
    fn what_is_no_table_is_refused_with_its_line() {
        for (text, reason) in [
            ("", "no line with a label"),
            ("# nothing\n", "no line with a label"),
            ("1 bone 256 0 0 0\n", "256 is not from 0 to 255"),
            ("1,#ff00\n", "not a colour"),
            ("1.5,#ff0000\n", "not a whole number"),
            ("1,#ff0000,2\n", "not from 0 to 1"),
            ("1,2\n", "expected value,#rrggbb"),
            ("bone is white\n", "expected a label"),
            ("name,color\nbone,#ffffff\n", "no column is named value"),
            ("value,name\n1,bone\n", "no columns are named color"),
            ("value,color\n1\n2,#ffffff\n", "expected a label"),
            ("value,r,g,b\n1,2\n", "fewer values than columns"),
            ("nan,#ffffff\n", "not a number"),
            ("1 1 1 1 1 1 \"a\"\n", "expected a label"),
        ] {
            let said = read(text).unwrap_err();
            assert!(said.contains(reason), "{text:?}: {said}");
        }
        assert!(read("1,#ffffff\n2,#fffff\n").unwrap_err().contains("at byte 10"));
        assert!(
            label_colors_from_bytes(&[b'1', b',', 0xff], Path::new("x")).unwrap_err().to_string().contains("no text")
        );
    }

    #[test]
    fn noise_is_an_error_or_a_table() {
        let mut state = 1u32;
        for length in 0..2000 {
            let mut next = || {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                b"0123456789,;\t \"#\nabcf.-"[(state >> 24) as usize % 23]
            };
            let bytes: Vec<u8> = (0..length % 90).map(|_| next()).collect();
            let _ = label_colors_from_bytes(&bytes, Path::new("noise"));
        }
    }
}
