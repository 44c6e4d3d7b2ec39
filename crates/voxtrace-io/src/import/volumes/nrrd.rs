//! NRRD, "nearly raw raster data" (Kindlmann, "Definition of NRRD File Format", teem): text header, then samples raw, gzip or
//! as text, in the same file or in one beside it.

mod data_files;

use crate::import::reader::{ImportOptions, Kind, Magic, Reader};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, Sample, channels, checked_size, detached, entries, place};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use data_files::{DataFiles, Samples};
use glam::{DAffine3, DMat3, DVec3};
use std::borrow::Cow;
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("NRRD", Kind::Volume, &["nrrd", "nhdr"], "volume, and .nhdr: raw, gzip or text", |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(stored(input, &folder, options)?.read(options)?.into())
    })
    .with_magic(&[Magic::first(b"NRRD000")])
    .with_large_volumes(|source, options| {
        let (input, folder) = source.into_input()?;
        stored(input, &folder, options)?.large()
    });

/// Most axes that a file may have.
const MOST_AXES: usize = 16;

/// A NRRD file.
fn stored<'a>(mut input: Input<'a>, folder: &Folder, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let header = Header::read(&mut input)?;
    let end = input.offset();
    let malformed = |what: &str| ImportError::malformed(path, end, what);
    let unsupported = |what: String| ImportError::at(path, end, ImportErrorKind::Unsupported(what));
    let sizes = header.sizes.as_deref().ok_or_else(|| malformed("a NRRD header without sizes"))?;
    // Axes with a direction are space; others are time points or components.
    let is_space = |axis: usize| match (&header.directions, header.kinds.get(axis).map(String::as_str)) {
        (Some(directions), _) => directions.get(axis).is_some_and(Option::is_some),
        (None, Some(kind)) => matches!(kind, "domain" | "space" | "???" | "none"),
        (None, None) => true,
    };
    let first = (0..sizes.len()).find(|&axis| is_space(axis)).unwrap_or(0);
    let space: Vec<usize> = (first..sizes.len()).take_while(|&axis| is_space(axis)).take(3).collect();
    let product = |sizes: &[u64]| sizes.iter().try_fold(1u64, |all, &size| all.checked_mul(size)).unwrap_or(u64::MAX);
    let size = std::array::from_fn(|n| space.get(n).map_or(1, |&axis| sizes[axis]));
    let size = checked_size(path, input.offset(), size, limits)?;
    let components = usize::try_from(product(&sizes[..first])).unwrap_or(usize::MAX).max(1);
    let after = first + space.len();
    let volumes = product(&sizes[after..]);
    let numbers = Planes::of(&header, sizes, first, after).map_err(unsupported)?;
    let kind = header.kind.as_deref().ok_or_else(|| malformed("a NRRD header without a type"))?;
    let sample = sample_of(kind).ok_or_else(|| unsupported(format!("samples of type {kind:?}")))?;
    let layout = Layout { sample, big_endian: header.big_endian, size, components, rescale: (1.0, 0.0) };

    let samples = Samples::of(&header, product(sizes).saturating_mul(sample.size() as u64));
    let samples = samples.map_err(unsupported)?;
    let files = header.files.names(limits).map_err(malformed)?;
    let mut own = path.to_path_buf();
    let (mut input, start) = match &files[..] {
        [] => samples.open(input, limits)?,
        [name] => {
            (input, own) = detached(path, end, folder, name, limits)?;
            samples.open(input, limits)?
        }
        _ => (samples.join(path, end, &files, folder, limits)?, 0),
    };
    let is_text = samples.is_text;
    // Sequences of 3D Slicer have time as their first axis, so that the time points of a place lie side by side.
    let is_time = match header.kinds.first().map(String::as_str) {
        Some("time") => first == 1,
        Some("list") => first == 1 && volumes == 1,
        _ => false,
    };
    let (mut channel, mut note) = (options.channel, None);
    let mut behind = Cow::Borrowed(options);
    if is_time {
        // Each time point has one number at a place, whichever way it is asked for.
        let number = options.time.or(options.channel);
        channels::chosen(options.time.and(options.channel), 1, "channel").map_err(unsupported)?;
        let (place, said) = channels::entry(number, components, "time point", "--time").map_err(unsupported)?;
        (channel, note, behind.to_mut().time) = (Some(place as u32 + 1), said, None);
    }
    let (planes, of_volumes) = match numbers {
        Some(numbers) => {
            channel = None;
            let (skipped, planes, notes) = numbers.chosen(options).map_err(unsupported)?;
            if skipped > 0 && is_text {
                return Err(unsupported("time points and channels of samples that are text".into()));
            }
            entries::skip_volumes(&mut input, &layout, skipped as u64)?;
            (planes, notes)
        }
        None => (1, entries::skip_to_time(&mut input, &layout, volumes, is_text, &behind)?.into_iter().collect()),
    };
    let mut frame = Volume { size, ..Volume::new([1; 3], Vec::new()) };
    frame.notes.extend(note.into_iter().chain(of_volumes));
    header.place(&mut frame, &space);
    let file = (files.len() < 2).then_some(PackedFile { path: own, packing: samples.packing, start });
    Ok(Stored { input, layout, is_text, frame, file, planes, channel })
}

/// Numbers of one place that lie in volumes of their own: those of a vector or colour whose axis comes behind the axes of space.
struct Planes {
    count: usize,
    time_points: usize,
    /// Whether those of a time point lie one behind the other, and not the time points of a number.
    are_together: bool,
}

impl Planes {
    /// Those of a file whose axes of space are `first..after`, if it has any.
    fn of(header: &Header, sizes: &[u64], first: usize, after: usize) -> Result<Option<Self>, String> {
        let is_number = |axis: usize| first == 0 && header.kinds.get(axis).is_some_and(|kind| holds_numbers(kind));
        // An axis of one entry parts nothing.
        let axes = (after..sizes.len()).filter(|&axis| sizes[axis] != 1);
        let axes: Vec<(bool, u64)> = axes.map(|axis| (is_number(axis), sizes[axis])).collect();
        let product = |of_numbers: bool| {
            let sizes = axes.iter().filter(|(is_number, _)| *is_number == of_numbers);
            let all = sizes.fold(1u64, |all, (_, size)| all.saturating_mul(*size));
            usize::try_from(all).unwrap_or(usize::MAX)
        };
        let (count, time_points) = (product(true), product(false));
        if count <= 1 {
            return Ok(None);
        }
        let are_together = axes.is_sorted_by(|(a, _), (b, _)| a >= b);
        if !are_together && !axes.is_sorted_by(|(a, _), (b, _)| a <= b) {
            return Err("axes of vectors or colours with others between them".into());
        }
        Ok(Some(Self { count, time_points, are_together }))
    }

    /// How many volumes lie before the first that is asked for, how many are read, and what there is to say.
    fn chosen(&self, options: &ImportOptions) -> Result<(usize, usize, Vec<String>), String> {
        let (point, note) = channels::entry(options.time, self.time_points, "time point", "--time")?;
        if self.are_together {
            let plane = channels::chosen(options.channel, self.count, "channel")?;
            let planes = if plane.is_some() { 1 } else { self.count };
            let before = point.saturating_mul(self.count).saturating_add(plane.unwrap_or(0));
            return Ok((before, planes, note.into_iter().collect()));
        }
        let (plane, of_planes) = channels::entry(options.channel, self.count, "channel", "--channel")?;
        let before = plane.saturating_mul(self.time_points).saturating_add(point);
        Ok((before, 1, note.into_iter().chain(of_planes).collect()))
    }
}

/// Whether an axis of this kind has the numbers of one place (teem, "Definition of NRRD File Format", section 5), not places or times.
fn holds_numbers(kind: &str) -> bool {
    const ENDINGS: [&str; 5] = ["vector", "color", "matrix", "gradient", "normal"];
    ENDINGS.iter().any(|ending| kind.ends_with(ending)) || matches!(kind, "complex" | "quaternion" | "point")
}

fn sample_of(kind: &str) -> Option<Sample> {
    Some(match kind {
        "signed char" | "int8" | "int8_t" => Sample::I8,
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Sample::U8,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Sample::I16,
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Sample::U16,
        "int" | "signed int" | "int32" | "int32_t" => Sample::I32,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Sample::U32,
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Sample::I64,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => Sample::U64,
        "float" => Sample::F32,
        "double" => Sample::F64,
        _ => return None,
    })
}

/// What of a header is used.
#[derive(Default)]
struct Header {
    kind: Option<String>,
    /// What each axis is: `RGB-color`, `vector`, `list`, `domain`.
    kinds: Vec<String>,
    sizes: Option<Vec<u64>>,
    encoding: Option<String>,
    big_endian: bool,
    spacings: Vec<f64>,
    /// For each axis a vector, or `none`.
    directions: Option<Vec<Option<DVec3>>>,
    origin: Option<DVec3>,
    space: String,
    /// Units of the space's axes, and of the axes that have spacings.
    space_units: Vec<String>,
    units: Vec<String>,
    files: DataFiles,
    line_skip: u64,
    byte_skip: i64,
}

impl Header {
    fn read(input: &mut Input) -> Result<Self, ImportError> {
        let path = input.path();
        if !input.peek(7)?.starts_with(b"NRRD000") {
            return Err(ImportError::malformed(path, 0, "the file does not begin as NRRD does"));
        }
        input.line()?;
        let mut header = Self::default();
        loop {
            let start = input.offset();
            // A detached header may end with the file.
            let Some(line) = input.line()? else { break };
            if line.is_empty() && !header.files.is_list() {
                break;
            }
            let line = String::from_utf8_lossy(line).into_owned();
            if header.files.add(&line) {
                // The names are the last thing of a header.
            } else if !line.starts_with('#') {
                header.field(path, start, &line)?;
            }
        }
        Ok(header)
    }

    fn field(&mut self, path: &Path, start: u64, line: &str) -> Result<(), ImportError> {
        let malformed = |what: String| ImportError::malformed(path, start, what);
        // `key:=value` is free text.
        let Some((key, value)) = line.split_once(':').filter(|(_, value)| !value.starts_with('=')) else {
            return if line.contains(":=") {
                Ok(())
            } else {
                Err(malformed("a line of the header without a colon".into()))
            };
        };
        let (key, value) = (key.trim().to_ascii_lowercase(), value.trim());
        let wrong = || malformed(format!("{key}: {value:?} makes no sense"));
        match key.as_str() {
            "type" => self.kind = Some(value.to_ascii_lowercase()),
            "kinds" => self.kinds = value.split_whitespace().map(str::to_ascii_lowercase).collect(),
            "encoding" => self.encoding = Some(value.to_ascii_lowercase()),
            "endian" => self.big_endian = value.eq_ignore_ascii_case("big"),
            "space units" => self.space_units = texts(value),
            "units" => self.units = texts(value),
            "space" => self.space = value.to_ascii_lowercase(),
            "data file" | "datafile" => self.files = DataFiles::of(value),
            "line skip" | "lineskip" => self.line_skip = value.parse().map_err(|_| wrong())?,
            "byte skip" | "byteskip" => self.byte_skip = value.parse().map_err(|_| wrong())?,
            "sizes" => {
                let sizes: Result<Vec<u64>, _> = value.split_whitespace().map(str::parse).collect();
                let sizes = sizes.ok().filter(|sizes| (1..=MOST_AXES).contains(&sizes.len()));
                self.sizes = Some(sizes.ok_or_else(wrong)?);
            }
            "spacings" => {
                let spacings: Result<Vec<f64>, _> = value.split_whitespace().map(str::parse).collect();
                self.spacings = spacings.map_err(|_| wrong())?;
            }
            "space directions" => self.directions = Some(vectors(value).ok_or_else(wrong)?),
            "space origin" => self.origin = vectors(value).ok_or_else(wrong)?.first().copied().flatten(),
            _ => {}
        }
        Ok(())
    }

    fn place(&self, volume: &mut Volume, space: &[usize]) {
        let spacing = |n: usize| space.get(n).and_then(|&axis| self.spacings.get(axis)).copied();
        let spacing = DVec3::from_array([0, 1, 2].map(|n| spacing(n).filter(|s| s.is_finite()).unwrap_or(1.0)));
        let Some(directions) = &self.directions else {
            let unit = millimetres(space.iter().filter_map(|&axis| self.units.get(axis)));
            let spacing = spacing * unit.unwrap_or(1.0);
            if unit.is_some() {
                volume.unit = Unit::Millimetre;
            }
            place(volume, DAffine3::from_mat3(DMat3::from_diagonal(spacing)), spacing);
            return;
        };
        let direction = |n: usize| space.get(n).and_then(|&axis| directions.get(axis)).copied().flatten();
        let axes = [0, 1, 2].map(direction);
        // A slice alone has no third axis: what is perpendicular.
        let x = axes[0].unwrap_or(DVec3::X);
        let y = axes[1].unwrap_or_else(|| x.any_orthogonal_vector());
        let z = axes[2].unwrap_or_else(|| x.cross(y).normalize_or(DVec3::Z));
        // Left, posterior, superior are our axes; right and anterior point the other way.
        let is_opposite =
            |long: &str, short: char, at: usize| self.space.contains(long) || self.space.chars().nth(at) == Some(short);
        let is_named = !self.space.is_empty() && !self.space.starts_with("scanner") && !self.space.starts_with("3d");
        let turn = DVec3::new(
            if is_named && is_opposite("right", 'r', 0) { -1.0 } else { 1.0 },
            if is_named && is_opposite("anterior", 'a', 1) { -1.0 } else { 1.0 },
            if is_named
                && (self.space.contains("inferior") || self.space.chars().nth(2) == Some('i') && self.space.len() <= 4)
            {
                -1.0
            } else {
                1.0
            },
        );
        let unit = millimetres(self.space_units.iter());
        if is_named || unit.is_some() {
            volume.unit = Unit::Millimetre;
        }
        let unit = unit.unwrap_or(1.0);
        let axes = DAffine3 { matrix3: DMat3::from_cols(x, y, z), translation: self.origin.unwrap_or(DVec3::ZERO) };
        let lengths = DVec3::new(x.length(), y.length(), z.length()) * unit;
        place(volume, DAffine3::from_mat3(DMat3::from_diagonal(turn * unit)) * axes, lengths);
    }
}

/// Texts in quotes, one for each axis.
fn texts(text: &str) -> Vec<String> {
    text.split('"').skip(1).step_by(2).take(MOST_AXES).map(str::to_owned).collect()
}

/// Millimetres of the unit that all axes have; `None` where they have several, or one that is no length.
fn millimetres<'a>(units: impl Iterator<Item = &'a String>) -> Option<f64> {
    let of_unit = |unit: &String| {
        Some(match unit.trim().to_lowercase().as_str() {
            "nm" | "nanometer" | "nanometers" => 1e-6,
            "um" | "µm" | "μm" | "micron" | "microns" | "micrometer" | "micrometers" => 1e-3,
            "mm" | "millimeter" | "millimeters" => 1.0,
            "cm" | "centimeter" | "centimeters" => 10.0,
            "m" | "meter" | "meters" => 1e3,
            _ => return None,
        })
    };
    let all: Option<Vec<f64>> = units.map(of_unit).collect();
    all.filter(|all| all.windows(2).all(|pair| pair[0] == pair[1]))?.first().copied()
}

/// `(1,0,0) none (0,1)`: vectors of up to three numbers.
fn vectors(text: &str) -> Option<Vec<Option<DVec3>>> {
    let mut found = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() && found.len() < MOST_AXES {
        if let Some(after) = rest.strip_prefix("none") {
            found.push(None);
            rest = after.trim_start();
            continue;
        }
        let (inside, after) = rest.strip_prefix('(')?.split_once(')')?;
        let mut vector = DVec3::ZERO;
        for (n, number) in inside.split(',').enumerate() {
            let number: f64 = number.trim().parse().ok()?;
            if n < 3 {
                vector[n] = number;
            }
        }
        found.push(vector.is_finite().then_some(vector));
        rest = after.trim_start();
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_axes_are_the_lengths_that_they_say() {
        let read = |fields: &str| {
            let text =
                format!("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 1 1\nencoding: raw\n{fields}\n\n\u{1}\u{2}");
            let (options, path) = (ImportOptions::default(), Path::new("a.nrrd"));
            let input = Input::of_bytes(text.as_bytes(), path, &options.limits).unwrap();
            let volume = stored(input, &Folder::none(), &options).unwrap().read(&options).unwrap();
            let place = volume.world_from_index;
            (volume.unit, place.matrix3.x_axis.x, place.translation.x)
        };
        let directions = "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (10,0,0)\nspace";
        assert_eq!(read(&format!("{directions}: LPS")), (Unit::Millimetre, 2.0, 10.0));
        let (unit, step, origin) = read(&format!("{directions}: RAS\nspace units: \"um\" \"um\" \"um\""));
        assert!(unit == Unit::Millimetre && (step + 0.002).abs() < 1e-12 && (origin + 0.01).abs() < 1e-12);
        let several = format!("{directions} dimension: 3\nspace units: \"mm\" \"mm\" \"cm\"");
        assert_eq!(read(&several), (Unit::Voxel, 2.0, 10.0));
        assert_eq!(read("spacings: 2 2 2\nunits: \"cm\" \"cm\" \"cm\""), (Unit::Millimetre, 20.0, 0.0));
        assert_eq!(read("spacings: 2 2 2\nunits: \"pixel\" \"pixel\" \"pixel\""), (Unit::Voxel, 2.0, 0.0));
    }

    #[test]
    fn time_as_the_first_axis_is_chosen_like_time_as_the_last() {
        let read_channel = |kind: &str, time, channel| {
            let text = format!(
                "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 3 2 1 1\nencoding: raw\nkinds: {kind} domain domain domain\n\n\
                \u{1}\u{2}\u{3}\u{4}\u{5}\u{6}"
            );
            let options = ImportOptions { time, channel, ..ImportOptions::default() };
            let path = Path::new("a.nrrd");
            let input = Input::of_bytes(text.as_bytes(), path, &options.limits).unwrap();
            stored(input, &Folder::none(), &options).and_then(|stored| stored.read(&options))
        };
        let read = |kind: &str, time| read_channel(kind, time, None);
        for kind in ["list", "time"] {
            let first = read(kind, None).unwrap();
            assert_eq!((first.values, first.colors.len(), first.size), (vec![1.0, 4.0], 0, [2, 1, 1]));
            assert!(first.notes[0].contains("the first of 3 time points"), "{:?}", first.notes);
            let third = read(kind, Some(3)).unwrap();
            assert_eq!((third.values, third.notes.len()), (vec![3.0, 6.0], 0));
            assert!(read(kind, Some(4)).unwrap_err().to_string().contains("no time point 4"));
            assert_eq!(read_channel(kind, None, Some(3)).unwrap().values, [3.0, 6.0]);
            assert_eq!(read_channel(kind, Some(3), Some(1)).unwrap().values, [3.0, 6.0]);
            assert!(read_channel(kind, Some(3), Some(2)).unwrap_err().to_string().contains("no channel 2"));
        }
        assert_eq!(read("RGB-color", None).unwrap().colors, [[1, 2, 3], [4, 5, 6]]);
    }

    #[test]
    fn axes_behind_those_of_space_are_numbers_of_a_place_or_times_by_their_kinds() {
        let read = |sizes: &str, kinds: &str, time, channel| {
            let dimension = sizes.split(' ').count();
            let head = format!("NRRD0004\ntype: uint8\ndimension: {dimension}\nsizes: {sizes}\nencoding: raw\n");
            let bytes = [format!("{head}kinds: {kinds}\n\n").as_bytes(), &(1..=12).collect::<Vec<u8>>()].concat();
            let options = ImportOptions { time, channel, ..ImportOptions::default() };
            let path = Path::new("a.nrrd");
            let input = Input::of_bytes(&bytes, path, &options.limits).unwrap();
            let read = stored(input, &Folder::none(), &options).and_then(|stored| stored.read(&options));
            read.map_err(|error| error.to_string())
        };
        let color = "domain domain domain RGB-color";
        let found = read("2 1 1 3", color, None, None).unwrap();
        assert_eq!((found.colors, found.size, found.notes.len()), (vec![[1, 3, 5], [2, 4, 6]], [2, 1, 1], 0));
        assert_eq!(read("2 1 1 3", color, None, Some(3)).unwrap().values, [5.0, 6.0]);
        assert!(read("2 1 1 3", color, None, Some(4)).unwrap_err().contains("no channel 4"));
        assert!(read("2 1 1 3", color, Some(2), None).unwrap_err().contains("no time point 2"));
        // Of a picture, too.
        assert_eq!(read("2 1 3", "domain domain RGB-color", None, None).unwrap().colors, [[1, 3, 5], [2, 4, 6]]);
        let length = |a: f32, b: f32| (a * a + b * b).sqrt();
        let vectors = read("2 1 1 2", "space space space vector", None, None).unwrap();
        assert_eq!(vectors.values, [length(1.0, 3.0), length(2.0, 4.0)]);
        // Lists and times are chosen by --time, wherever they are.
        for kind in ["list", "time", "none", "???"] {
            let kinds = format!("domain domain domain {kind}");
            let first = read("2 1 1 3", &kinds, None, None).unwrap();
            assert!(
                first.values == [1.0, 2.0] && first.notes[0].contains("3 time points"),
                "{kind}: {:?}",
                first.notes
            );
            assert_eq!(read("2 1 1 3", &kinds, Some(3), None).unwrap().values, [5.0, 6.0], "{kind}");
        }
        let inner = "domain domain domain RGB-color list";
        assert_eq!(read("2 1 1 3 2", inner, Some(2), None).unwrap().colors, [[7, 9, 11], [8, 10, 12]]);
        assert_eq!(read("2 1 1 3 2", inner, Some(2), Some(1)).unwrap().values, [7.0, 8.0]);
        let outer = "domain domain domain time vector";
        assert_eq!(read("2 1 1 2 3", outer, Some(2), Some(3)).unwrap().values, [11.0, 12.0]);
        let first = read("2 1 1 2 3", outer, None, None).unwrap();
        assert_eq!((first.values, first.notes.len()), (vec![1.0, 2.0], 2));
        let alone = read("2 1 1 3 1 2", "domain domain domain vector list vector", None, Some(6)).unwrap();
        assert_eq!(alone.values, [11.0, 12.0]);
        let between = read("1 1 1 2 2 3", "domain domain domain vector list vector", None, None);
        assert!(between.unwrap_err().contains("axes of vectors or colours with others between them"));
    }
}
