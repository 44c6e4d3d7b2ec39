//! Points as text, one a line: `.xyz`, `.csv`, `.pts`, `.txt`, `.asc`. Columns are told by a line of names where there is one, else
//! by their number; commas, semicolons, tabs and spaces part them. Numbers with decimal commas are told by what parts them.

use super::whole_intensities;
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::reader::{FileClues, Geometry, Kind, Reader, Recognition};
use crate::import::source::input::{Input, without_mark};
use glam::DVec3;
use std::borrow::Cow;
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "XYZ",
    Kind::Points,
    EXTENSIONS,
    "points as text, and .csv, .pts; .txt, .asc by content",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(Geometry::Points(read(input, &options.limits)?).into())
    },
)
.with_recognition(recognize);

/// Extensions, the one to name the format by first.
const EXTENSIONS: &[&str] = &["xyz", "csv", "pts"];
/// Extensions of many things, grids of heights among them: only what is in the file tells points.
const SHARED: [&str; 2] = ["asc", "txt"];

/// Most columns that are looked at.
const COLUMNS: usize = 64;

/// Which column holds what.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Columns {
    position: [usize; 3],
    color: Option<[usize; 3]>,
    intensity: Option<usize>,
    class: Option<usize>,
}

/// A text of rows of three and more numbers, perhaps behind their names, is one of points, whatever it is called.
fn recognize(clues: &FileClues) -> Recognition {
    let own = clues.path.extension().unwrap_or_default();
    let is_shared = SHARED.iter().any(|extension| own.eq_ignore_ascii_case(extension));
    let (mut row, mut rows, mut is_first, mut has_names) = (Vec::new(), 0, true, false);
    let mut has_counts = false;
    let is_whole = clues.length.is_some_and(|length| length == clues.head.len() as u64);
    let ends = clues.head.iter().filter(|&&byte| byte == b'\n').count();
    // The last line may be cut off; the names of many columns are.
    let lines =
        without_mark(clues.head).split(|&byte| byte == b'\n').take(if is_whole { usize::MAX } else { ends.max(1) });
    for line in lines.map(<[u8]>::trim_ascii).filter(|line| !line.is_empty()) {
        let comment = comment_of(line);
        let is_row = parse(&plain(line), &mut row, true);
        if is_row && row.len() >= 3 {
            rows += 1;
        } else if !is_row || !row.is_empty() {
            has_names |= is_first && Columns::named(comment.unwrap_or(line)).is_some();
            has_counts |= is_first && is_row && row.len() == 1;
            let is_count = has_counts && is_row && is_count(&row);
            if comment.is_none() && !is_count && !(is_first && (row.len() == 1 || has_names)) {
                return Recognition::Unknown;
            }
        }
        is_first &= comment.is_some();
    }
    match (rows > 0 || has_names, is_shared) {
        (false, _) => Recognition::Unknown,
        (true, true) => Recognition::Sure,
        (true, false) => Recognition::Likely,
    }
}

/// Reads the points of a text.
fn read(mut input: Input, limits: &Limits) -> Result<PointCloud, ImportError> {
    let path = input.path();
    let is_pts = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pts"));
    let mut cloud = PointCloud::default();
    let mut local_origin = LocalOrigin::default();
    let (mut columns, mut is_in_comment, mut is_counted) = (None::<Columns>, false, false);
    let mut colors: Vec<[f32; 3]> = Vec::new();
    let mut intensities: Vec<f32> = Vec::new();
    let (mut row, mut left_out) = (Vec::with_capacity(COLUMNS), 0u64);
    let mut is_fraction = true;
    // Points that the last count announces, and those behind it.
    let (mut announced, mut in_block) = (None::<f64>, 0u64);
    loop {
        let start = input.offset();
        let Some(line) = input.line()? else { break };
        let text = &*plain(line.trim_ascii());
        let comment = comment_of(text);
        if text.is_empty() {
            continue;
        }
        let has_names = columns.is_some() && !is_counted;
        if comment.is_some() || !parse(text, &mut row, has_names) {
            if columns.is_none() && cloud.positions.is_empty() {
                (columns, is_in_comment) = (Columns::named(comment.unwrap_or(text)), comment.is_some());
                if comment.is_some() || columns.is_some() {
                    continue;
                }
            } else if comment.is_some() {
                continue;
            }
            let what = if columns.is_none() && cloud.positions.is_empty() {
                "a first line that is neither numbers nor names of columns with x, y and z among them"
            } else {
                "a line that is not numbers"
            };
            return Err(ImportError::malformed(path, start, what));
        }
        // Spreadsheets end in rows of nothing but commas.
        if row.is_empty() {
            continue;
        }
        let has_end = text.ends_with(b",") || text.ends_with(b";");
        // Some programs say first how many points follow, and again before the points of each further scan.
        let is_first = row.len() == 1 && cloud.positions.is_empty();
        if is_first || (is_pts || announced.is_some()) && !has_end && is_count(&row) {
            (announced, in_block) = (Some(row[0]), 0);
            continue;
        }
        in_block += 1;
        let is_short = |columns: Columns| row.len() <= columns.highest() && !has_end;
        // A comment with these words in it need not be their names.
        if is_in_comment && cloud.positions.is_empty() && columns.is_some_and(is_short) {
            columns = None;
            parse(text, &mut row, false);
        }
        is_counted |= columns.is_none();
        let columns = *columns.get_or_insert_with(|| Columns::counted(&row, is_pts));
        let highest = columns.highest();
        if row.len() <= highest && has_end {
            row.resize(highest + 1, f64::NAN);
        }
        if row.len() <= highest {
            let what = format!("a line of {} numbers where {} are needed", row.len(), highest + 1);
            return Err(ImportError::malformed(path, start, what));
        }
        let placed = local_origin.localized(DVec3::from_array(columns.position.map(|column| row[column])));
        if !placed.is_finite() {
            left_out += 1;
            continue;
        }
        if cloud.positions.len() as u64 == limits.points {
            return Err(ImportError::limit(path, Some(start), "points", limits.points + 1, limits.points));
        }
        cloud.positions.push(placed);
        if let Some(color) = columns.color {
            // An empty cell is dark.
            let color = color.map(|column| row[column] as f32).map(|value| if value.is_nan() { 0.0 } else { value });
            is_fraction &= color.iter().all(|&value| value <= 1.0);
            colors.push(color);
        }
        if let Some(column) = columns.intensity {
            intensities.push(row[column] as f32);
        }
        if let Some(column) = columns.class {
            cloud.classes.push(row[column].clamp(0.0, 255.0).round() as u8);
        }
    }
    if cloud.positions.is_empty() {
        return Err(ImportError::malformed(path, input.offset(), "a text without a point"));
    }
    if let Some(count) = announced.filter(|&count| count > 0.0 && in_block == 0) {
        return Err(ImportError::truncated(
            path,
            input.offset(),
            format!("the {count} points that its last count announces"),
        ));
    }
    if left_out > 0 {
        cloud.notes.push(format!("{left_out} points that are not finite are left out"));
    }
    cloud.colors = bytes_of(&colors, is_fraction);
    cloud.intensities = whole_intensities(&intensities);
    if cloud.intensities.iter().all(|&value| value == 0) {
        cloud.intensities = Vec::new();
    }
    cloud.offset = local_origin.offset();
    Ok(cloud)
}

/// Whether a line says how many points follow.
fn is_count(row: &[f64]) -> bool {
    matches!(*row, [count] if count >= 0.0 && count.fract() == 0.0)
}

/// What stands behind the mark of a comment.
fn comment_of(text: &[u8]) -> Option<&[u8]> {
    [&b"#"[..], b"//"].iter().find_map(|mark| text.strip_prefix(*mark))
}

/// Colours as bytes: shares of one, or numbers of 8 or of 16 bits.
fn bytes_of(colors: &[[f32; 3]], is_fraction: bool) -> Vec<[u8; 3]> {
    let largest = colors.iter().flatten().fold(0.0f32, |largest, &value| largest.max(value));
    let full = if is_fraction {
        1.0
    } else if largest <= 255.0 {
        255.0
    } else {
        65_535.0
    };
    let byte = |value: f32| (value / full * 255.0).round() as u8;
    colors.iter().map(|color| color.map(byte)).collect()
}

/// What stands between commas and semicolons, which may be nothing.
fn cells(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(|byte| matches!(byte, b',' | b';')).map(<[u8]>::trim_ascii)
}

fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(|byte| matches!(byte, b' ' | b'\t')).filter(|word| !word.is_empty())
}

/// A line with decimal points: where semicolons or spaces part numbers, a comma between two digits is a decimal one.
fn plain(text: &[u8]) -> Cow<'_, [u8]> {
    if !text.contains(&b',') || text.contains(&b'.') {
        return text.into();
    }
    let parts = || text.split(|byte| matches!(byte, b' ' | b'\t' | b';')).filter(|part| !part.is_empty());
    let is_number = |part: &[u8]| {
        let mut halves = part.split(|&byte| byte == b',');
        let digits = |half: &[u8]| half.first().is_some_and(u8::is_ascii_digit);
        let (whole, after) = (halves.next().unwrap_or_default(), halves.next());
        let whole = whole.strip_prefix(b"-").or(whole.strip_prefix(b"+")).unwrap_or(whole);
        digits(whole) && after.is_none_or(digits) && halves.next().is_none()
    };
    if parts().count() < 3 || !parts().all(is_number) {
        return text.into();
    }
    text.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect::<Vec<u8>>().into()
}

/// The numbers of a line, `false` where anything else stands there. Empty cells are left out, those at the end always; where
/// `keeps_empty`, one before them is no number, but keeps its column.
fn parse(text: &[u8], row: &mut Vec<f64>, keeps_empty: bool) -> bool {
    row.clear();
    let mut filled = 0;
    for cell in cells(text) {
        if cell.is_empty() && keeps_empty {
            row.push(f64::NAN);
        }
        for word in words(cell).take(COLUMNS.saturating_sub(row.len())) {
            let bare = word.strip_prefix(b"\"").and_then(|word| word.strip_suffix(b"\"")).unwrap_or(word);
            if bare.is_empty() {
                row.extend(keeps_empty.then_some(f64::NAN));
                continue;
            }
            let number = std::str::from_utf8(bare).ok().and_then(|word| word.parse::<f64>().ok());
            let Some(number) = number else { return false };
            row.push(number);
            filled = row.len();
        }
        if row.len() >= COLUMNS {
            break;
        }
    }
    row.truncate(filled);
    true
}

impl Columns {
    /// The columns of a line of names; `None` where x, y and z are not among them.
    fn named(text: &[u8]) -> Option<Self> {
        // Where something else parts them, names may have spaces in them, and the one of an index is often empty.
        let parted: Vec<&[u8]> = if text.iter().any(|byte| matches!(byte, b',' | b';')) {
            cells(text).take(COLUMNS).collect()
        } else if text.contains(&b'\t') {
            let words = text.split(|&byte| byte == b'\t').map(<[u8]>::trim_ascii);
            words.filter(|word| !word.is_empty()).take(COLUMNS).collect()
        } else {
            words(text).take(COLUMNS).collect()
        };
        // Spaces may part them as well.
        Self::of_names(&parted).or_else(|| {
            let all: Vec<&[u8]> = cells(text).flat_map(words).take(COLUMNS).collect();
            Self::of_names(&all)
        })
    }

    fn of_names(words: &[&[u8]]) -> Option<Self> {
        let name = |word: &&[u8]| String::from_utf8_lossy(word).trim_matches('"').to_ascii_lowercase();
        let names: Vec<String> = words.iter().map(name).collect();
        let find = |wanted: &[&str]| names.iter().position(|name| wanted.contains(&name.as_str()));
        let three = |x: Option<usize>, y: Option<usize>, z: Option<usize>| Some([x?, y?, z?]);
        Some(Self {
            position: three(
                find(&["x", "easting", "east"]),
                find(&["y", "northing", "north"]),
                find(&["z", "height", "elevation"]),
            )?,
            color: three(find(&["r", "red"]), find(&["g", "green"]), find(&["b", "blue"])),
            intensity: find(&["i", "intensity", "reflectance"]),
            class: find(&["c", "class", "classification"]),
        })
    }

    /// The columns of a file without names, from its first line: after x, y and z stand an intensity, a colour, or in a
    /// `.pts` and where the fourth number cannot be a colour both.
    fn counted(row: &[f64], is_pts: bool) -> Self {
        let is_byte = |&value: &f64| (0.0..=255.0).contains(&value) && value.fract() == 0.0;
        let is_color = |at: usize| row.get(at..at + 3).is_some_and(|color| color.iter().all(is_byte));
        let (color, intensity) = match row.len() {
            0..=3 => (None, None),
            4 | 5 => (None, Some(3)),
            7.. if is_pts && is_color(4) => (Some([4, 5, 6]), Some(3)),
            _ if is_color(3) => (Some([3, 4, 5]), None),
            7.. if is_color(4) => (Some([4, 5, 6]), Some(3)),
            _ => (None, None),
        };
        Self { position: [0, 1, 2], color, intensity, class: None }
    }

    fn highest(&self) -> usize {
        let others = self.color.into_iter().flatten().chain(self.intensity).chain(self.class);
        self.position.into_iter().chain(others).max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn cloud(name: &str, text: &str) -> PointCloud {
        let limits = Limits::default();
        read(Input::of_bytes(text.as_bytes(), Path::new(name), &limits).unwrap(), &limits).unwrap()
    }

    #[test]
    fn names_tell_the_columns_in_any_order() {
        let points = cloud("a.csv", "class;Red;Green;Blue;z;y;x;Intensity\n6;255;0;10;3;2;1;700\n");
        assert_eq!(points.positions[0].to_array(), [1.0, 2.0, 3.0]);
        assert_eq!((points.colors[0], points.intensities[0], points.classes[0]), ([255, 0, 10], 700, 6));
        assert_eq!(cloud("a.txt", "//X Y Z R G B\n1 2 3 4 5 6\n").colors[0], [4, 5, 6]);
    }

    #[test]
    fn spreadsheets_mark_their_texts_and_put_numbers_into_quotes() {
        let named = cloud("a.csv", "\u{feff}X;Y;Z\r\n1,5;2;3\r\n4;5;6\r\n");
        assert_eq!((named.positions.len(), named.positions[0].to_array()), (2, [1.5, 2.0, 3.0]));
        assert_eq!(cloud("a.xyz", "\u{feff}1 2 3\n").positions[0].to_array(), [1.0, 2.0, 3.0]);
        let quoted = cloud("a.csv", "\"z\",\"y\",\"x\"\n\"1\",\"2.5\",\"3\"\n");
        assert_eq!(quoted.positions[0].to_array(), [3.0, 2.5, 1.0]);
    }

    #[test]
    fn empty_cells_keep_their_columns_and_names_their_spaces() {
        // As pandas writes it: the index has no name.
        let indexed = cloud("a.csv", ",x,y,z\n0,1,2,3\n1,4,5,6\n");
        assert_eq!(
            indexed.positions.iter().map(|at| at.to_array()).collect::<Vec<_>>(),
            [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
        );
        let spaced = "Point ID;X;Y;Z;Scan angle;Intensity\n7;1;2;3;;9\n\"\";4;5;6;1;\n8;7;;9;1;1\n;;;;;\n";
        let points = cloud("a.csv", spaced);
        assert_eq!((points.positions[1].to_array(), &points.intensities[..]), ([4.0, 5.0, 6.0], &[9, 0][..]));
        assert!(points.notes.len() == 1 && points.notes[0].contains("1 points"), "{:?}", points.notes);
        assert_eq!(cloud("a.txt", "Point ID\tX\tY\tZ\n7\t1\t2\t3\n").positions[0].to_array(), [1.0, 2.0, 3.0]);
        let told = cloud("a.xyz", "# the format: x y z r g b\n1 2 3 9 8 7\n");
        assert_eq!((told.positions[0].to_array(), &told.colors[..]), ([1.0, 2.0, 3.0], &[[9, 8, 7]][..]));
        // Names that spaces part too.
        for (names, row) in [
            ("x y z, r g b", "1 2 3, 9 8 7"),
            ("# x y z, r g b", "1 2 3 9 8 7"),
            ("X Y Z R G B;", "1 2 3 9 8 7;"),
            ("X\tY Z\tR G B", "1\t2 3\t9 8 7"),
        ] {
            let points = cloud("a.xyz", &format!("{names}\n{row}\n"));
            let found = (points.positions[0].to_array(), &points.colors[..]);
            assert_eq!(found, ([1.0, 2.0, 3.0], &[[9, 8, 7]][..]), "{names:?}");
        }
        // Commas at the end are no columns, and a colour that is missing does not make the others darker.
        let ended = cloud("a.xyz", "1,2,3,\n4,5,6,\n");
        assert_eq!((ended.positions.len(), ended.intensities.len()), (2, 0));
        assert_eq!(cloud("a.csv", "x,y,z,r,g,b\n1,2,3,0.5,1.0,\n4,5,6,,1,0\n").colors, [[128, 255, 0], [0, 255, 0]]);
    }

    #[test]
    fn without_names_their_number_tells_the_columns() {
        assert_eq!(cloud("a.xyz", "1 2 3 200 100 50\n").colors[0], [200, 100, 50]);
        assert_eq!(cloud("a.xyz", "1 2 3 0.5 -0.5 0.7\n").colors.len(), 0);
        let points = cloud("a.pts", "2\n1 2 3 12 200 100 50\n1 2 4 13 0 0 0\n");
        assert_eq!((points.colors[0], points.intensities[1], points.positions.len()), ([200, 100, 50], 13, 2));
        assert_eq!(cloud("a.csv", "x,y,z,r,g,b\n1,2,3,0.5,1.0,0\n").colors[0], [128, 255, 0]);
        assert_eq!(cloud("a.csv", "x,y,z,r,g,b\n1,2,3,65535,0,257\n").colors[0], [255, 0, 1]);
        // Separators too many are no columns.
        for text in [";1;2;3\n;4;5;6\n", "1,,2,,3\n4,,5,,6\n", "# of 2 scans: x y z\n;1;2;3\n;4;5;6\n"] {
            let points = cloud("a.csv", text);
            assert_eq!(points.positions.len(), 2, "{text:?}");
            assert_eq!(points.positions[1].to_array(), [4.0, 5.0, 6.0], "{text:?}");
        }
    }

    #[test]
    fn points_of_several_scans_have_a_count_each() {
        let several = "2\n1 2 3 12 200 100 50\n1 2 4 13 0 0 0\n0\n1\n1 2 5 14 9 8 7\n";
        for (name, text) in [("a.pts", several.to_owned()), ("a.txt", several.into()), ("a.pts", several[2..].into())] {
            let points = cloud(name, &text);
            assert_eq!(points.positions.iter().map(|at| at.z).collect::<Vec<_>>(), [3.0, 4.0, 5.0], "{name} {text:?}");
            if name == "a.pts" {
                assert_eq!((points.colors[2], points.intensities[2]), ([9, 8, 7], 14));
            }
        }
        let options = crate::import::ImportOptions::default();
        let (head, length) = (several.as_bytes(), Some(several.len() as u64));
        let told = recognize(&FileClues { path: Path::new("a.dat"), head, length, options: &options });
        assert_eq!(told, Recognition::Likely);
        // A row that was cut off is no count, nor is one without its points, or in a file that counts nothing.
        let limits = Limits::default();
        for (name, text, at) in
            [("a.pts", "1\n1 2 3\n4.5\n", 8), ("a.pts", "1\n1 2 3\n4", 9), ("a.xyz", "1 2 3\n4\n4 5 6\n", 6)]
        {
            let error = read(Input::of_bytes(text.as_bytes(), Path::new(name), &limits).unwrap(), &limits);
            assert_eq!(error.unwrap_err().offset, Some(at), "{text:?}");
        }
    }

    #[test]
    fn intensities_may_be_shares_of_one_or_below_zero() {
        assert_eq!(cloud("a.csv", "x,y,z,intensity\n1,2,3,0.1\n1,2,4,0.4\n").intensities, [6554, 26_214]);
        let signed = cloud("a.pts", "2\n1 2 3 -2048 9 9 9\n1 2 4 2047 9 9 9\n");
        assert_eq!(signed.intensities, [0, 65_535]);
    }

    #[test]
    fn decimal_commas_are_told_by_what_parts_numbers() {
        for text in
            ["691000,25;-2,5;3;7\n", "691000,25 -2,5\t3 7\n", "691000.25,-2.5,3,7\n", "x;y;z;i\n691000,25;-2,5;3;7\n"]
        {
            let points = cloud("a.txt", text);
            let place = points.positions[0].as_dvec3() + points.offset;
            assert_eq!((place, points.intensities[0]), (DVec3::new(691_000.25, -2.5, 3.0), 7), "{text:?}");
        }
        assert_eq!(cloud("a.csv", "1,2,3\n").positions[0].to_array(), [1.0, 2.0, 3.0]);
        assert_eq!(cloud("a.csv", "1, 2, 3\n").positions[0].to_array(), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_text_of_rows_is_told_from_others_whatever_its_name() {
        let options = crate::import::ImportOptions::default();
        let named = |name: &str, text: &str| {
            let (head, length) = (text.as_bytes(), Some(text.len() as u64));
            recognize(&FileClues { path: Path::new(name), head, length, options: &options })
        };
        let told = |text: &str| named("a.dat", text);
        for good in [
            "1 2 3\n4 5 6\n",
            "\u{feff}x y z\n1 2 3\n",
            "x y z\n1 2 3\n",
            "2\n1;2;3\n",
            "# scan\n1,5 2,5 3,5",
            "1\t2\t3\r\n",
        ] {
            assert_eq!(told(good), Recognition::Likely, "{good:?}");
            assert_eq!([named("a.ASC", good), named("a.txt", good)], [Recognition::Sure; 2], "{good:?}");
        }
        for other in
            ["", "1 2\n", "hello world\n", "OFF\n8 6 0\n1 2 3\n", "ncols 2\n", "\u{0}\u{1}", "1 2 3\n4 five 6\n"]
        {
            assert_eq!(told(other), Recognition::Unknown, "{other:?}");
        }
        // Names of more columns than are looked at.
        let names = format!("//X,Y,Z,{}\n1,2,3\n", "A_scalar_field,".repeat(9));
        let cut = FileClues {
            path: Path::new("a.txt"),
            head: &names.as_bytes()[..132],
            length: Some(200),
            options: &options,
        };
        assert_eq!(recognize(&cut), Recognition::Sure);
        // What is cut off in the middle of a number is no row.
        let cut = FileClues { path: Path::new("a"), head: b"1 2 3\n4 5", length: Some(12), options: &options };
        assert_eq!(recognize(&cut), Recognition::Likely);
    }

    #[test]
    fn lines_that_are_no_points_are_errors_that_say_where() {
        let limits = Limits::default();
        for (text, at) in
            [("1 2 3\n\"4,5\";6;7\n", 6), ("1 2 3\n4 five 6\n", 6), ("1 2 3\n4 5\n", 6), ("", 0), ("hello\n", 0)]
        {
            let error = read(Input::of_bytes(text.as_bytes(), Path::new("a.xyz"), &limits).unwrap(), &limits);
            assert_eq!(error.unwrap_err().offset, Some(at), "{text:?}");
        }
        let unnamed = read(Input::of_bytes(b"lon,lat,alt\n1,2,3\n", Path::new("a.csv"), &limits).unwrap(), &limits);
        assert!(unnamed.unwrap_err().to_string().contains("names of columns with x, y and z among them"));
        assert_eq!(cloud("a.xyz", "1 2 nan\n1 2 3\n").notes.len(), 1);
    }
}
