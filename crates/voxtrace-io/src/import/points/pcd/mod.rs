//! PCD 0.5 to 0.7, the files of the Point Cloud Library ("The PCD (Point Cloud Data) file format", pointclouds.org): text,
//! binary, and binary compressed by LZF. Read are positions, colours, intensities and labels. The viewpoint says from where
//! the points were seen, which does not move them.

mod header;
mod lzf;

use super::whole_intensities;
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::reader::{Geometry, Kind, Magic, Reader};
use crate::import::source::input::Input;
use glam::DVec3;
use header::{Data, Field, Header};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("PCD", Kind::Points, &["pcd"], "points of the Point Cloud Library", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(Geometry::Points(read(input, &options.limits)?).into())
    })
    .with_magic(&[Magic::first(b"# .PCD v")]);

/// Bytes of points taken at once.
const PIECE: usize = 1 << 20;

/// Reads the points of a PCD file.
fn read(mut input: Input, limits: &Limits) -> Result<PointCloud, ImportError> {
    let path = input.path();
    let header = Header::read(&mut input)?;
    let at = input.offset();
    if header.points > limits.points {
        return Err(ImportError::limit(path, Some(at), "points", header.points, limits.points));
    }
    let mut points = Points::new(&header);
    match header.data {
        Data::Text => points.add_text(&mut input)?,
        Data::Binary => {
            let size = header.points.saturating_mul(header.size as u64);
            if let Some(remaining) = input.remaining().filter(|&remaining| remaining < size) {
                return Err(ImportError::truncated(path, at + remaining, format!("the {} points", header.points)));
            }
            let mut left = header.points;
            while left > 0 {
                let now = left.min((PIECE / header.size).max(1) as u64);
                let bytes = input.take(now as usize * header.size, "the points")?;
                for record in bytes.chunks_exact(header.size) {
                    points.add(|field| field.number(&record[field.offset..]));
                }
                left -= now;
            }
        }
        Data::Compressed => {
            let sizes = input.take(8, "the sizes of the points")?;
            let word = |at: usize| u32::from_le_bytes([sizes[at], sizes[at + 1], sizes[at + 2], sizes[at + 3]]);
            let (packed, size) = (word(0), u64::from(word(4)));
            if size != header.points.saturating_mul(header.size as u64) {
                return Err(ImportError::malformed(path, at, "the compressed points are not those of the header"));
            }
            let most = limits.bytes.min((16 << 20).max(u64::from(packed).saturating_mul(limits.ratio)));
            if size > most {
                return Err(ImportError::limit(path, Some(at), "bytes of points", size, most));
            }
            let bytes = input.rest()?;
            let end = at + 8 + bytes.len() as u64;
            let packed = bytes.get(..packed as usize);
            let packed = packed.ok_or_else(|| ImportError::truncated(path, end, "the compressed points"))?;
            let unpacked = lzf::unpack(packed, size as usize);
            let unpacked =
                unpacked.ok_or_else(|| ImportError::malformed(path, at + 8, "the compressed points are broken"))?;
            // Each field stands by itself: all x, then all y.
            let count = header.points as usize;
            for point in 0..count {
                points.add(|field| field.number(&unpacked[field.offset * count + point * field.stride..]));
            }
        }
    }
    Ok(points.finish())
}

/// Points so far.
struct Points<'a> {
    header: &'a Header,
    local_origin: LocalOrigin,
    cloud: PointCloud,
    intensities: Vec<f32>,
    /// Red, green and blue as the file has them.
    colors: Vec<[f32; 3]>,
    left_out: u64,
}

impl<'a> Points<'a> {
    fn new(header: &'a Header) -> Self {
        let (local_origin, cloud) = (LocalOrigin::default(), PointCloud::default());
        Self { header, local_origin, cloud, intensities: Vec::new(), colors: Vec::new(), left_out: 0 }
    }

    /// Adds a point whose fields are read by `number`.
    fn add(&mut self, number: impl Fn(&Field) -> f64) {
        let header = self.header;
        let placed = self.local_origin.localized(DVec3::from_array(header.position.each_ref().map(&number)));
        // What a sensor does not see is not a number.
        if !placed.is_finite() {
            self.left_out += 1;
            return;
        }
        self.cloud.positions.push(placed);
        if let Some(field) = &header.color {
            let [blue, green, red, _] = field.bits(number(field)).to_le_bytes();
            self.cloud.colors.push([red, green, blue]);
        }
        if let Some(rgb) = &header.rgb {
            // What is no number is dark.
            self.colors.push(rgb.each_ref().map(|field| (number(field) as f32).max(0.0)));
        }
        if let Some(field) = &header.intensity {
            self.intensities.push(number(field) as f32);
        }
        if let Some(field) = &header.label {
            self.cloud.classes.push(number(field).clamp(0.0, 255.0) as u8);
        }
    }

    fn add_text(&mut self, input: &mut Input) -> Result<(), ImportError> {
        let (header, path) = (self.header, input.path());
        let mut row = Vec::new();
        for _ in 0..header.points {
            let start = input.offset();
            let Some(line) = input.line()? else {
                return Err(ImportError::truncated(path, start, format!("the {} points", header.points)));
            };
            let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            row.clear();
            row.extend(words.map_while(|word| std::str::from_utf8(word).ok()?.parse::<f64>().ok()));
            if row.len() < header.columns {
                let what = format!("a line of {} numbers where {} are needed", row.len(), header.columns);
                return Err(ImportError::malformed(path, start, what));
            }
            self.add(|field| row[field.column]);
        }
        Ok(())
    }

    fn finish(mut self) -> PointCloud {
        if let Some(viewpoint) = &self.header.viewpoint {
            let note = format!("points stay where they are in the file: the viewpoint {viewpoint} does not move them");
            self.cloud.notes.push(note);
        }
        if !self.header.unknown.is_empty() {
            let words = self.header.unknown.join(", ");
            self.cloud.notes.push(format!("words of the header that are not known are left out: {words}"));
        }
        if self.left_out > 0 {
            self.cloud.notes.push(format!("{} points that are not finite are left out", self.left_out));
        }
        if let Some(rgb) = &self.header.rgb {
            // Shares of one, perhaps rounded up, or numbers up to 255: the largest that is finite tells.
            let mut finite = self.colors.as_flattened().iter().filter(|value| value.is_finite());
            let are_shares = finite.all(|&value| value <= 1.001);
            let full = if are_shares && rgb.iter().all(Field::is_real) { 255.0 } else { 1.0 };
            let byte = |value: f32| (value * full).min(255.0).round() as u8;
            self.cloud.colors = self.colors.iter().map(|color| color.map(byte)).collect();
        }
        self.cloud.intensities = whole_intensities(&self.intensities);
        if self.cloud.intensities.iter().all(|&value| value == 0) {
            self.cloud.intensities = Vec::new();
        }
        if self.cloud.classes.iter().all(|&class| class == 0) {
            self.cloud.classes = Vec::new();
        }
        self.cloud.offset = self.local_origin.offset();
        self.cloud
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn cloud(bytes: &[u8]) -> Result<PointCloud, ImportError> {
        let limits = Limits::default();
        read(Input::of_bytes(bytes, Path::new("a.pcd"), &limits).unwrap(), &limits)
    }

    #[test]
    fn a_text_has_its_colour_as_a_number_or_as_the_bits_of_a_float() {
        let head = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb normal label\nSIZE 4 4 4 4 4 4\nTYPE F F F F F U\nCOUNT 1 1 1 1 3 1\n";
        let float = f32::from_bits(0x0064_c832);
        let text =
            format!("{head}WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3 {float:e} 0 0 1 6\nnan nan nan 0 0 0 0 0\n");
        let points = cloud(text.as_bytes()).unwrap();
        assert_eq!((points.positions[0].to_array(), points.colors[0]), ([1.0, 2.0, 3.0], [100, 200, 50]));
        assert_eq!((points.classes[0], points.notes.len()), (6, 1));
        let text = text.replace("TYPE F F F F", "TYPE F F F U").replace(&format!("{float:e}"), "6604850");
        assert_eq!(cloud(text.as_bytes()).unwrap().colors[0], [100, 200, 50]);
    }

    #[test]
    fn what_programs_write_otherwise_means_the_same() {
        let head = "VERSION .7\nFIELDS X y Z Red green blue\nSIZE 4 4 4 1 1 1\nTYPE f F F u U U\n";
        let text = format!("{head}Width 1\nSENSOR_ORIGIN 0 0 0\n# a comment\nPOINTS 1\nDATA ASCII\n1 2 3 100 200 50\n");
        let points = cloud(text.as_bytes()).unwrap();
        assert_eq!((points.positions[0].to_array(), points.colors[0]), ([1.0, 2.0, 3.0], [100, 200, 50]));
        assert_eq!(points.notes, ["words of the header that are not known are left out: SENSOR_ORIGIN"]);
        let shares = text.replace("TYPE f F F u U U", "TYPE F F F F F F").replace("100 200 50", "1 0.5 0");
        let shares = shares.replace("SIZE 4 4 4 1 1 1", "SIZE 4 4 4 4 4 4");
        assert_eq!(cloud(shares.as_bytes()).unwrap().colors[0], [255, 128, 0]);
        let rounded = shares.replace("POINTS 1", "POINTS 2") + "1 2 4 1.0000002 inf 0.5\n";
        assert_eq!(cloud(rounded.as_bytes()).unwrap().colors, [[255, 128, 0], [255, 255, 128]]);
        // Beside larger ones a dark colour stays dark.
        let bytes = shares.replace("POINTS 1", "POINTS 2") + "1 2 4 200 nan 300\n";
        assert_eq!(cloud(bytes.as_bytes()).unwrap().colors, [[1, 1, 0], [200, 0, 255]]);
        assert!(cloud(text.replace("SENSOR_ORIGIN", "SENSOR-ORIGIN").as_bytes()).is_err());
    }

    #[test]
    fn headers_that_contradict_themselves_are_refused() {
        let good =
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n";
        assert_eq!(cloud(good.as_bytes()).unwrap().positions.len(), 1);
        for (from, to) in [
            ("FIELDS x y z", "FIELDS x y w"),
            ("SIZE 4 4 4", "SIZE 4 4"),
            ("SIZE 4 4 4", "SIZE 4 3 4"),
            ("TYPE F F F", "TYPE F X F"),
            ("COUNT 1 1 1", "COUNT 1 1 99999999999"),
            ("COUNT 1 1 1", "COUNT 1 1 0"),
            ("POINTS 1", "POINTS 2"),
            ("POINTS 1", "POINTS 99999999999999999999"),
            ("POINTS 1", "POINTS -1"),
            ("DATA ascii", "DATA binary"),
            ("DATA ascii", "DATA binary_compressed"),
            ("DATA ascii", "DATA zip"),
            ("1 2 3", "1 2"),
            ("1 2 3", "1 two 3"),
        ] {
            assert!(cloud(good.replace(from, to).as_bytes()).is_err(), "{to}");
        }
    }
}
