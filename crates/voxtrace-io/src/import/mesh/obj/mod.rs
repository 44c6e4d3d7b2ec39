//! Wavefront OBJ with its materials in MTL ("Object Files", Advanced Visualizer manual, appendix B1). Read are faces, and of a file
//! without faces its vertices as points, with those along its lines; curves are left out.

mod faces;
mod material;

use crate::import::mesh::lines::Lines;
use crate::import::reader::Geometry;
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::reader::{self, Kind, NotShown};
use crate::import::source::folder::Folder;
use crate::import::source::input::{Input, beyond};
use faces::Faces;
use glam::{DVec3, Vec2, Vec3, Vec4};
use material::Library;
use rustc_hash::FxHashMap;
use std::path::Path;
use voxtrace_scene::material::linear_from_srgb;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::mesh::{Mesh, MeshMaterial};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: reader::Reader = reader::Reader::new(
    "OBJ",
    Kind::Mesh,
    &["obj"],
    "Wavefront mesh, with MTL materials and pictures; points where it has no faces",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(read(input, &folder, &options.limits)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y));

/// Most materials, the names that no library explains among them.
const MAX_MATERIALS: usize = 65_535;

/// Reads an OBJ file and the libraries and pictures that it names.
fn read(mut input: Input, folder: &Folder, limits: &Limits) -> Result<Geometry, ImportError> {
    let path = input.path();
    let mut reader = Reader {
        folder,
        limits,
        mesh: Mesh::new(""),
        local_origin: LocalOrigin::default(),
        colors: Vec::new(),
        uvs: Vec::new(),
        faces: Faces::default(),
        lines: Lines::default(),
        material_names: FxHashMap::default(),
        material: 0,
        library: Library::default(),
        skipped: 0,
        unread: NotShown::default(),
    };
    let mut joined = Vec::new();
    loop {
        let start = input.offset();
        let Some(line) = input.line()? else { break };
        // A line may go on in the next one.
        let mut line = line;
        if line.last() == Some(&b'\\') {
            joined.clear();
            joined.extend_from_slice(&line[..line.len() - 1]);
            while let Some(next) = input.line()? {
                joined.push(b' ');
                joined.extend_from_slice(next);
                if joined.last() != Some(&b'\\') {
                    break;
                }
                joined.pop();
                if joined.len() > 1 << 26 {
                    return Err(beyond(path, Some(start), "bytes in a line", joined.len() as u64, 1 << 26));
                }
            }
            line = &joined;
        }
        reader.line(line).map_err(|what| ImportError::malformed(path, start, what))?;
        let points = reader.mesh.positions.len().max(reader.faces.len()).max(reader.lines.len()) as u64;
        if points > limits.points {
            return Err(ImportError::limit(path, Some(start), "vertices, triangles or lines", points, limits.points));
        }
    }
    let end = input.offset();
    let mut geometry = reader.finish(path, end)?;
    // The format does not say it, but most programs that write it do so.
    geometry.make_z_up(UpAxis::Y);
    Ok(geometry)
}

struct Reader<'a> {
    folder: &'a Folder,
    limits: &'a Limits,
    mesh: Mesh,
    local_origin: LocalOrigin,
    /// Colours of the positions so far, as the file has them; empty until the first vertex that has one.
    colors: Vec<Option<Vec3>>,
    /// Texture coordinates as the file numbers them.
    uvs: Vec<Vec2>,
    faces: Faces,
    lines: Lines,
    material_names: FxHashMap<Vec<u8>, u16>,
    material: u16,
    library: Library,
    /// Faces with fewer than three corners.
    skipped: usize,
    /// Statements that nothing comes of.
    unread: NotShown,
}

impl Reader<'_> {
    fn line(&mut self, line: &[u8]) -> Result<(), String> {
        let line = line.trim_ascii();
        let (word, rest) = line.split_at(line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len()));
        match word {
            b"v" => self.vertex(rest),
            b"vt" => self.texture_coordinate(rest),
            b"f" | b"fo" => {
                let count = [self.mesh.positions.len(), self.uvs.len()];
                if !self.faces.push(rest, count, &self.mesh.positions, self.material)? {
                    self.skipped += 1;
                }
                Ok(())
            }
            b"l" => {
                self.lines.push(rest, self.mesh.positions.len());
                Ok(())
            }
            b"usemtl" => self.use_material(rest.trim_ascii()),
            b"curv" | b"curv2" => self.not_shown("free-form curve"),
            b"surf" => self.not_shown("free-form surface"),
            b"call" | b"csh" => self.not_shown("call of another file"),
            b"mtllib" => {
                let name = String::from_utf8_lossy(rest.trim_ascii()).into_owned();
                self.library.read(&name, self.folder, self.limits, &mut self.mesh);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn not_shown(&mut self, kind: &str) -> Result<(), String> {
        self.unread.count(kind, 1);
        Ok(())
    }

    fn vertex(&mut self, rest: &[u8]) -> Result<(), String> {
        let mut numbers = [0.0; 8];
        let count = numbers_of(rest, &mut numbers)?;
        if count < 3 {
            return Err("a vertex without three numbers".into());
        }
        let position = self.local_origin.localized(DVec3::new(numbers[0], numbers[1], numbers[2]));
        if !position.is_finite() {
            return Err("a vertex that is not finite".into());
        }
        let index = self.mesh.positions.len();
        self.mesh.positions.push(position);
        // Three numbers more are a colour; a fourth number alone is a weight.
        if count >= 6 {
            self.colors.resize(index, None);
            self.colors.push(Some(DVec3::new(numbers[3], numbers[4], numbers[5]).as_vec3()));
        } else if !self.colors.is_empty() {
            self.colors.push(None);
        }
        Ok(())
    }

    fn texture_coordinate(&mut self, rest: &[u8]) -> Result<(), String> {
        let mut numbers = [0.0; 8];
        if numbers_of(rest, &mut numbers)? < 1 {
            return Err("a texture coordinate without a number".into());
        }
        self.uvs.push(Vec2::new(numbers[0] as f32, 1.0 - numbers[1] as f32));
        Ok(())
    }

    fn use_material(&mut self, name: &[u8]) -> Result<(), String> {
        if let Some(&index) = self.material_names.get(name) {
            self.material = index;
            return Ok(());
        }
        // The first material stands for faces before any name.
        let index = self.mesh.materials.len();
        if index >= MAX_MATERIALS {
            return Err(format!("more than {MAX_MATERIALS} materials"));
        }
        let name_text = String::from_utf8_lossy(name).into_owned();
        self.mesh.materials.push(MeshMaterial { name: name_text, ..MeshMaterial::default() });
        self.material_names.insert(name.to_vec(), index as u16);
        self.material = index as u16;
        Ok(())
    }

    fn finish(mut self, path: &Path, end: u64) -> Result<Geometry, ImportError> {
        let mut mesh = self.mesh;
        mesh.offset = self.local_origin.offset();
        let has_colors = !self.colors.is_empty();
        self.colors.resize(if has_colors { mesh.positions.len() } else { 0 }, None);
        mesh.colors = linear_colors(&self.colors);
        let missing = self.faces.missing();
        self.faces.finish(&self.uvs, &mut mesh);
        if missing > 0 {
            mesh.notes.push(format!("{missing} corners name texture coordinates that the file has not"));
        }
        if mesh.triangles.is_empty() {
            // Faces that are all broken are no cloud of points.
            if self.skipped > 0 || mesh.positions.is_empty() {
                let what = "an OBJ file without a face or a point";
                return Err(ImportError::at(path, end, ImportErrorKind::Unsupported(what.into())));
            }
            let most = self.limits.points;
            let limit = |count| ImportError::limit(path, Some(end), "points on lines", count, most);
            self.lines.draw(&mut mesh, self.limits).map_err(limit)?;
            mesh.notes.push(format!("no faces: the vertices and {} lines are taken for points", self.lines.len()));
            return Ok(Geometry::Points(PointCloud::from_corners(mesh)));
        }
        for material in &mut mesh.materials {
            match self.library.materials.get(&material.name) {
                Some(known) => material.clone_from(known),
                None if has_colors => material.base_color = Vec4::ONE,
                None => {}
            }
        }
        let mut unread = self.unread;
        unread.count("line", self.lines.len() as u64);
        self.library.unread_maps.iter().for_each(|(map, count)| unread.count(&format!("texture of {map}"), *count));
        mesh.notes.extend(unread.note());
        if self.skipped > 0 {
            mesh.notes.push(format!("{} faces with fewer than three corners are left out", self.skipped));
        }
        Ok(Geometry::Mesh(mesh))
    }
}

/// The numbers of a line, as many as there is room for, and how many they are. What is no number is an error, except after
/// the third one.
fn numbers_of(rest: &[u8], numbers: &mut [f64]) -> Result<usize, String> {
    let mut count = 0;
    for word in rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).take(numbers.len()) {
        match std::str::from_utf8(word).ok().and_then(|word| word.parse().ok()) {
            Some(number) => numbers[count] = number,
            None if count >= 3 || word.starts_with(b"#") => break,
            None => return Err(format!("{:.40?} is no number", String::from_utf8_lossy(word))),
        }
        count += 1;
    }
    Ok(count)
}

/// Linear colours of vertices, white where the file has none. Signals are shares, but bytes where they are as large as those: some programs
/// write them so.
fn linear_colors(colors: &[Option<Vec3>]) -> Vec<Vec4> {
    let channels = || colors.iter().flatten().flat_map(|color| color.to_array());
    let largest = channels().fold(0.0, f32::max);
    // Colours that are brighter than white are shares yet, and a stray value is none of a byte.
    let are_bytes = (16.0..256.0).contains(&largest) && channels().all(|channel| channel.fract() == 0.0);
    let full = if are_bytes { 255.0 } else { 1.0 };
    let linear = |color: Vec3| Vec3::from((color / full).to_array().map(linear_from_signal)).extend(1.0);
    colors.iter().map(|color| color.map_or(Vec4::ONE, linear)).collect()
}

/// Linear value of an sRGB signal in [0, 1].
fn linear_from_signal(signal: f32) -> f32 {
    linear_from_srgb((signal.clamp(0.0, 1.0) * 255.0).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_any(text: &str) -> Result<Geometry, ImportError> {
        let limits = Limits::default();
        read(Input::of_bytes(text.as_bytes(), Path::new("a.obj"), &limits)?, &Folder::none(), &limits)
    }

    fn read_text(text: &str) -> Result<Mesh, ImportError> {
        match read_any(text)? {
            Geometry::Mesh(mesh) => Ok(mesh),
            Geometry::Points(_) => panic!("points"),
        }
    }

    fn read_points(text: &str) -> PointCloud {
        match read_any(text).unwrap() {
            Geometry::Mesh(_) => panic!("a mesh"),
            Geometry::Points(cloud) => cloud,
        }
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn the_first_vertex_is_read_behind_the_mark_of_a_text() {
        let read = |mark: &str| read_text(&format!("{mark}{SQUARE}f 1 2 3")).unwrap();
        assert_eq!(read("\u{feff}"), read(""));
    }

    #[test]
    fn faces_name_corners_from_the_front_or_the_back() {
        let expected = [[0, 1, 2], [0, 2, 3]];
        for face in ["f 1 2 3 4", "f -4 -3 -2 -1", "f 1// 2// 3// 4//", "f 1//9 2//9 3//9 4//9", "f 1 2 \\\n 3 4"] {
            assert_eq!(read_text(&format!("{SQUARE}{face}")).unwrap().triangles, expected, "{face}");
        }
    }

    #[test]
    fn a_position_with_two_texture_coordinates_becomes_two_vertices() {
        let mesh = read_text(&format!("{SQUARE}vt 0 0\nvt 0.5 0.25\nf 1/1 2/2 3/1\nf 1/2 3/1 4/1")).unwrap();
        assert_eq!((mesh.positions.len(), mesh.uvs.len()), (5, 5));
        let corners = mesh.corners(1);
        assert_eq!(mesh.positions[corners[0]], Vec3::ZERO);
        assert_eq!(mesh.uvs[corners[0]], Vec2::new(0.5, 0.75));
        assert_eq!(mesh.uvs[mesh.corners(0)[0]], Vec2::new(0.0, 1.0));
        mesh.validate().unwrap();
    }

    #[test]
    fn texture_coordinates_and_normals_that_the_file_has_not_are_left_out() {
        let whole = read_text(&format!("{SQUARE}f 1 2 3 4")).unwrap();
        for (face, notes) in
            [("f 1/1/1 2/2/2 3/3/3 4/4/4", 1), ("f 1//1 2//2 3//3 4//4", 0), ("f 1/-1 2/-2 3/-3 4/-4", 1)]
        {
            let mesh = read_text(&format!("{SQUARE}{face}")).unwrap();
            assert_eq!((&mesh.triangles, mesh.notes.len()), (&whole.triangles, notes), "{face}");
            assert!(mesh.uvs.iter().all(|&uv| uv == Vec2::ZERO), "{face}");
        }
        // Those that are there stay.
        let mesh = read_text(&format!("{SQUARE}vt 0.5 0.25\nf 1/1 2/2 3/9 4")).unwrap();
        assert_eq!((mesh.uvs[0], mesh.uvs[1]), (Vec2::new(0.5, 0.75), Vec2::ZERO));
        assert_eq!(mesh.notes, ["2 corners name texture coordinates that the file has not"]);
    }

    #[test]
    fn colours_of_vertices_are_srgb() {
        let mesh = read_text("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3").unwrap();
        assert_eq!(mesh.colors.len(), 3);
        assert_eq!(mesh.colors[1], Vec4::ONE);
        assert!((mesh.colors[0] - Vec4::new(1.0, 0.2158, 0.0, 1.0)).abs().max_element() < 1e-3);
    }

    #[test]
    fn colours_of_vertices_may_be_written_as_bytes() {
        let colors = |lines: [&str; 3]| {
            let text = lines.map(|color| format!("v 0 0 0 {color}\n")).concat();
            read_text(&(text + "f 1 2 3")).unwrap().colors
        };
        assert_eq!(colors(["255 51 0", "0 0 102", ""]), colors(["1 0.2 0", "0 0 0.4", "1 1 1"]));
        // Colours brighter than white, and a stray number, are no bytes.
        assert_eq!(colors(["1.5 0.2 0", "0 0 0.4", ""]), colors(["1 0.2 0", "0 0 0.4", ""]));
        assert_eq!(colors(["1e9 0.2 0", "0 0 0.4", ""]), colors(["1 0.2 0", "0 0 0.4", ""]));
        assert_eq!(colors(["nan 0.2 0", "0 0 0.4", ""]), colors(["0 0.2 0", "0 0 0.4", ""]));
    }

    #[test]
    fn each_material_is_used_where_it_is_named() {
        let mesh =
            read_text(&format!("{SQUARE}f 1 2 3\nusemtl red\nf 1 2 3\nusemtl two words\nf 1 2 3\nusemtl red\nf 1 2 4"));
        let mesh = mesh.unwrap();
        assert_eq!(mesh.material_of, [0, 1, 2, 1]);
        assert_eq!(mesh.materials[2].name, "two words");
    }

    #[test]
    fn what_is_wrong_is_told_with_the_byte_of_its_line() {
        let at = |bad: &str| (format!("{SQUARE}{bad}"), SQUARE.len() as u64);
        for bad in
            ["f 1 2 5", "f 0 1 2", "f -9 1 2", "f 1 2 x", "f 1/x 2/1 3/1", "v 1 2", "v nan 0 0", "v 0 1e60 0", "vt x"]
        {
            let (text, offset) = at(bad);
            assert_eq!(read_text(&text).unwrap_err().offset, Some(offset), "{bad}");
        }
        assert!(read_any("").is_err() && read_any("v 0 0 0\nf 1 1").is_err());
    }

    #[test]
    fn vertices_without_faces_are_points_with_their_colours() {
        let cloud = read_points("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1\nvn 0 0 1\n");
        assert_eq!(cloud.positions, [Vec3::ZERO, Vec3::X]);
        assert_eq!(cloud.colors, [[255, 128, 0], [0, 0, 255]]);
        assert_eq!(read_points(SQUARE).colors, [] as [[u8; 3]; 0]);
    }

    #[test]
    fn lines_without_faces_are_points_along_them() {
        let cloud = read_points(&format!("{SQUARE}l 1 2/7 -2\nl 4 9 1\n"));
        // Two sides of the square; the third line breaks at a vertex that is not there.
        let on_sides = cloud.positions[4..].iter().all(|at| at.y == 0.0 || at.x == 1.0);
        assert!(on_sides && cloud.positions.len() > 2000, "{}", cloud.positions.len());
        let mut along: Vec<f32> = cloud.positions.iter().filter(|at| at.y == 0.0).map(|at| at.x).collect();
        along.sort_by(f32::total_cmp);
        assert!(along.windows(2).all(|pair| pair[1] - pair[0] < 1.1 / 1024.0));
    }
}
