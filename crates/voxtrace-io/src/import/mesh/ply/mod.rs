//! PLY, the Stanford polygon format, as text and as binary of both byte orders (Turk, "The PLY Polygon File Format", 1994).
//! Read are positions, colours and texture coordinates of vertices, or those of faces, faces and triangle strips, and Gaussian splats.

mod faces;
mod header;
mod large;
mod points;
mod splats;
mod values;
mod vertex_cache;
mod vertices;

use crate::import::images::texture;
use crate::import::reader::Geometry;
use crate::import::reader::{ImportOptions, Kind, LargeContent, Magic, NotShown, Reader};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use faces::{Looks, Wanted};
use glam::Vec4;
use header::{Element, Header};
use values::Values;
use voxtrace_voxelize::mesh::{Mesh, MeshMaterial, TextureUse};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "PLY",
    Kind::Mesh,
    &["ply"],
    "Stanford mesh, points or Gaussian splats, text or binary, with colours or a picture",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(read(input, &folder, options)?.into())
    },
)
.with_magic(&[Magic::first(b"ply\n"), Magic::first(b"ply\r")])
.with_large(|source, budget, options| {
    let (path, limits) = (source.path(), &options.limits);
    if let Some(source) = large::PlyTriangles::open(path, budget, limits)? {
        let size = source.size_bytes();
        return Ok(Some(LargeContent::of_triangles(source, size)));
    }
    Ok(points::PlyPoints::open(path)?.map(|source| {
        let size = source.size_bytes();
        LargeContent::of_points(source, size)
    }))
});

/// Reads a PLY file: a mesh, or without any face a cloud of points.
fn read(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Geometry, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let header = Header::read(&mut input, limits)?;
    let mut mesh = Mesh::new("");
    let mut values = Values::new(input, header.encoding);
    let (wanted, mut looks) = (Wanted::of(&header), Looks::default());
    mesh.notes.extend(not_shown(header.elements.iter()));
    mesh.notes.extend(faces::unread_colors(header.elements.iter(), wanted));
    for element in &header.elements {
        values.check_count(element)?;
        if element.name == "vertex" && element.find(&["packed_position"]).is_some() {
            let what = "compressed Gaussian splats; save them as plain PLY, as SuperSplat and splat-transform do";
            return Err(ImportError::at(path, values.offset(), ImportErrorKind::Unsupported(what.into())));
        }
        if let Some(columns) = splats::columns(element).filter(|_| element.name == "vertex" && !header.has_faces()) {
            return Ok(Geometry::Points(splats::read(&mut values, element, &columns, options)?));
        }
        match element.name.as_str() {
            "vertex" => vertices::read(&mut values, element, &mut mesh)?,
            "face" | "tristrips" => faces::read(&mut values, element, wanted, limits, &mut mesh, &mut looks)?,
            _ => skip(&mut values, element)?,
        }
    }
    let end = values.offset();
    let vertices = mesh.positions.len();
    if let Some(at) = mesh.triangles.as_flattened().iter().find(|&&corner| corner as usize >= vertices) {
        let what = format!("a face has corner {at}, but there are {vertices} vertices");
        return Err(ImportError::malformed(path, end, what));
    }
    if mesh.triangles.is_empty() {
        if mesh.positions.is_empty() {
            return Err(ImportError::at(path, end, ImportErrorKind::Unsupported("a PLY file without a vertex".into())));
        }
        return Ok(Geometry::Points(PointCloud::from_corners(mesh)));
    }
    let has_uvs = !mesh.uvs.is_empty() || looks.has_uvs();
    looks.spread(&mut mesh);
    set_look(&mut mesh, &header.textures, has_uvs, folder, limits);
    Ok(Geometry::Mesh(mesh))
}

/// Says how the surface looks: by pictures of these names, by colours, or plain. Each picture is a material.
fn set_look(mesh: &mut Mesh, textures: &[String], has_uvs: bool, folder: &Folder, limits: &Limits) {
    mesh.materials.resize_with(textures.len().max(1), MeshMaterial::default);
    let mut taken = 0;
    for (at, name) in textures.iter().enumerate() {
        if let Some(before) = textures[..at].iter().position(|before| before == name) {
            mesh.materials[at] = mesh.materials[before].clone();
            continue;
        }
        if !has_uvs {
            mesh.notes
                .push(format!("the texture {name:?} is left out: neither vertices nor faces have coordinates on it"));
            continue;
        }
        match folder
            .read(name)
            .map_err(|refused| refused.to_string())
            .and_then(|file| texture::decode_another(&file, &mut taken, limits).map_err(|refused| refused.to_string()))
        {
            Ok(texture) => {
                mesh.materials[at].base_texture = Some(TextureUse::new(mesh.textures.len() as u32));
                mesh.materials[at].base_color = Vec4::ONE;
                mesh.textures.push(texture);
            }
            Err(fault) => mesh.notes.push(format!("the texture is left out: {fault}")),
        }
    }
    let count = mesh.materials.len();
    mesh.material_of.iter_mut().filter(|at| usize::from(**at) >= count).for_each(|at| *at = 0);
    if !mesh.colors.is_empty() {
        mesh.materials.iter_mut().for_each(|material| material.base_color = Vec4::ONE);
    }
}

/// The note about elements that nothing comes of; other values of vertices and faces are many, and every program has its own.
fn not_shown<'e>(elements: impl Iterator<Item = &'e Element>) -> Option<String> {
    let mut parts = NotShown::default();
    let is_read = |element: &&Element| matches!(element.name.as_str(), "vertex" | "face" | "tristrips");
    let others = elements.filter(|element| !is_read(element));
    others.for_each(|element| parts.count(&element.name, element.count));
    parts.note()
}

/// Reads over an element that nothing is known about.
fn skip(values: &mut Values, element: &Element) -> Result<(), ImportError> {
    for _ in 0..element.count {
        for property in &element.properties {
            let count = match property.list {
                Some(count) => values.count(count)?,
                None => 1,
            };
            for _ in 0..count {
                values.number(property.kind)?;
            }
        }
        values.end_of_item()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec2, Vec3};
    use std::path::Path;

    fn read_bytes(bytes: &[u8]) -> Result<Mesh, ImportError> {
        let options = ImportOptions::default();
        match read(Input::of_bytes(bytes, Path::new("a.ply"), &options.limits)?, &Folder::none(), &options)? {
            Geometry::Mesh(mesh) => Ok(mesh),
            Geometry::Points(_) => panic!("points where a mesh was expected"),
        }
    }

    const HEADER: &str = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n\
        property uchar green\nproperty uchar blue\nproperty float s\nproperty float t\nelement extra 1\n\
        property list uchar short things\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

    fn sample(format: &str) -> Vec<u8> {
        let mut bytes = format!("ply\nformat {format} 1.0\ncomment any\n{HEADER}").into_bytes();
        let corners = [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        if format == "ascii" {
            for [x, y] in corners {
                bytes.extend(format!("{x} {y} 0.5 255 0 0 {x} {y}\n").bytes());
            }
            bytes.extend(b"2 7 8\n4 0 1 2 3\n");
            return bytes;
        }
        let is_big = format.contains("big");
        let float = |value: f32| if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
        let int = |value: i32| if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
        for [x, y] in corners {
            bytes.extend([x, y, 0.5].map(float).as_flattened());
            bytes.extend([255, 0, 0]);
            bytes.extend([x, y].map(float).as_flattened());
        }
        bytes.extend([2, 0, 7, 0, 8, 4]);
        bytes.extend([0, 1, 2, 3].map(int).as_flattened());
        bytes
    }

    #[test]
    fn text_and_both_byte_orders_give_the_same_mesh() {
        let mesh = read_bytes(&sample("ascii")).unwrap();
        assert_eq!(mesh.positions[2], Vec3::new(1.0, 1.0, 0.5));
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh.colors[3], Vec4::new(1.0, 0.0, 0.0, 1.0));
        // The format counts v from the bottom, we from the top.
        assert_eq!(mesh.uvs[1], Vec2::new(1.0, 1.0));
        mesh.validate().unwrap();
        for format in ["binary_little_endian", "binary_big_endian"] {
            assert_eq!(read_bytes(&sample(format)).unwrap(), mesh, "{format}");
        }
    }

    #[test]
    fn a_file_cut_at_any_byte_is_an_error_that_says_where() {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let whole = sample(format);
            // The last line of a text needs no end.
            let needed = if format == "ascii" { whole.len() - 1 } else { whole.len() };
            for end in 0..needed {
                let error = read_bytes(&whole[..end]).unwrap_err();
                assert!(error.offset.is_some_and(|offset| offset <= end as u64), "{format} {end}: {error}");
            }
        }
    }

    #[test]
    fn strips_of_triangles_turn_every_second_one() {
        let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
            element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
            0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n";
        assert_eq!(read_bytes(text.as_bytes()).unwrap().triangles, [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
    }

    #[test]
    fn coordinates_in_doubles_keep_what_singles_lose() {
        let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
            element face 1\nproperty list uchar int vertex_index\nend_header\n\
            691000.125 0 0\n691000.126 0 0\n691000.125 1 0\n3 0 1 2\n";
        let mesh = read_bytes(text.as_bytes()).unwrap();
        assert_eq!(mesh.offset, DVec3::new(691_000.0, 0.0, 0.0));
        assert!((mesh.positions[1].x - 0.126).abs() < 1e-6);
    }

    #[test]
    fn faces_look_as_they_say_where_vertices_do_not() {
        let read = |vertex: &str, color: &str| {
            let text = format!(
                "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex 4\nproperty float x\nproperty float y\n\
                property float z\n{vertex}element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n\
                property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n\
                0 0 0{color}\n1 0 0{color}\n1 1 0{color}\n0 1 0{color}\n\
                4 0 1 2 3 8 0 0 1 0 1 0.25 0 1 255 0 0\n3 0 1 2 6 0.5 0 1 0.5 0 1 0 0 255\n"
            );
            let mesh = read_bytes(text.as_bytes()).unwrap();
            mesh.validate().unwrap();
            mesh
        };
        let mesh = read("", "");
        let corners = |at: [[f32; 2]; 9]| at.map(|[x, y]| Vec3::new(x, y, 0.0));
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let all: Vec<_> = square.iter().chain(&square[..3]).copied().collect();
        assert_eq!((mesh.triangles.len(), &mesh.positions[..]), (0, &corners(all.try_into().unwrap())[..]));
        let uvs = [
            [0.0, 1.0],
            [1.0, 1.0],
            [1.0, 0.75],
            [0.0, 1.0],
            [1.0, 0.75],
            [0.0, 0.0],
            [0.5, 1.0],
            [1.0, 0.5],
            [0.0, 0.0],
        ];
        assert_eq!(mesh.uvs, uvs.map(Vec2::from));
        let (red, blue) = (Vec4::new(1.0, 0.0, 0.0, 1.0), Vec4::new(0.0, 0.0, 1.0, 1.0));
        assert_eq!(mesh.colors, [red, red, red, red, red, red, blue, blue, blue]);
        // The picture is not there, which is said.
        assert_eq!(mesh.notes.len(), 1, "{:?}", mesh.notes);
        let own = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float t\n";
        let mesh = read(own, " 255 255 255 0 0");
        assert_eq!((mesh.triangles.len(), mesh.colors.len(), mesh.colors[0]), (3, 4, Vec4::ONE));
    }

    #[test]
    fn colours_of_faces_have_the_names_of_those_of_vertices_or_are_told() {
        let read = |kind: &str, prefix: &str| {
            let color: String =
                ["red", "green", "blue"].iter().map(|name| format!("property {kind} {prefix}{name}\n")).collect();
            let text = format!(
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
                property list uchar int vertex_indices\n{color}end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 0 255\n"
            );
            read_bytes(text.as_bytes()).unwrap()
        };
        for prefix in ["", "diffuse_"] {
            let mesh = read("uchar", prefix);
            assert_eq!((mesh.colors, mesh.notes.len()), (vec![Vec4::new(0.0, 0.0, 1.0, 1.0); 3], 0), "{prefix}");
        }
        let mesh = read("float", "");
        assert!(mesh.colors.is_empty() && mesh.notes[0].contains("colours of faces are left out"), "{:?}", mesh.notes);
    }

    #[test]
    fn a_mesh_of_coloured_faces_is_known_to_take_as_much_as_it_does() {
        let header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
            element face 9\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
            end_header\n";
        let mut bytes = header.as_bytes().to_vec();
        bytes.extend([0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|number| number.to_le_bytes()));
        for _ in 0..9 {
            bytes.push(3);
            bytes.extend([0i32, 1, 2].iter().flat_map(|corner| corner.to_le_bytes()));
            bytes.extend([1, 2, 3]);
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.ply");
        std::fs::write(&path, &bytes).unwrap();
        let large = large::PlyTriangles::open(&path, 1 << 20, &Limits::default()).unwrap().unwrap();
        let mesh = read_bytes(&bytes).unwrap();
        assert_eq!(mesh.colors.len(), 27);
        assert!(large.size_bytes() >= mesh.size_bytes(), "{} {}", large.size_bytes(), mesh.size_bytes());
    }

    #[test]
    fn each_face_has_the_picture_of_its_number() {
        let folder = tempfile::tempdir().unwrap();
        for (name, color) in [("a.png", [255, 0, 0]), ("b.png", [0, 255, 0])] {
            let mut encoder = png::Encoder::new(std::fs::File::create(folder.path().join(name)).unwrap(), 1, 1);
            encoder.set_color(png::ColorType::Rgb);
            encoder.write_header().unwrap().write_image_data(&color).unwrap();
        }
        let read = |number: &str| {
            let text = format!(
                "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\nelement vertex 3\nproperty float x\n\
                property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 4\n\
                property list uchar int vertex_indices\nproperty int {number}\nend_header\n\
                0 0 0 0 0\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2 1\n3 0 1 2 0\n3 0 1 2 -1\n3 0 1 2 9\n"
            );
            let options = ImportOptions::default();
            let input = Input::of_bytes(text.as_bytes(), Path::new("a.ply"), &options.limits).unwrap();
            match read(input, &Folder::at(folder.path(), &options.limits), &options).unwrap() {
                Geometry::Mesh(mesh) => mesh,
                Geometry::Points(_) => panic!("points where a mesh was expected"),
            }
        };
        let mesh = read("texnumber");
        assert_eq!(mesh.material_of, [1, 0, 0, 0]);
        let texel = |mesh: &Mesh, material: usize| {
            let texture = mesh.materials[material].base_texture.unwrap().texture;
            mesh.textures[texture as usize].texels()[0]
        };
        assert_eq!([texel(&mesh, 0), texel(&mesh, 1)], [[255, 0, 0, 255], [0, 255, 0, 255]]);
        // Where faces do not say it, it is the last one.
        let mesh = read("flags");
        assert_eq!((mesh.material_of.len(), mesh.materials.len(), texel(&mesh, 0)), (0, 1, [0, 255, 0, 255]));
    }

    #[test]
    fn a_texture_without_coordinates_is_told() {
        let text = "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex 3\nproperty float x\nproperty float y\n\
            property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        let notes = read_bytes(text.as_bytes()).unwrap().notes;
        assert!(notes.len() == 1 && notes[0].contains("\"wood.png\" is left out"), "{notes:?}");
    }

    #[test]
    fn colours_in_floats_are_shares_or_written_as_bytes() {
        let with = |kind: &str, colors: [[&str; 4]; 3]| {
            let mut text = String::from("ply\nformat ascii 1.0\nelement vertex 3\n");
            for name in ["x", "y", "z"] {
                text += &format!("property float {name}\n");
            }
            for name in ["red", "green", "blue", "alpha"] {
                text += &format!("property {kind} {name}\n");
            }
            text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
            for (place, color) in ["0 0 0", "1 0 0", "0 1 0"].iter().zip(colors) {
                text += &format!("{place} {}\n", color.join(" "));
            }
            read_bytes((text + "3 0 1 2\n").as_bytes()).unwrap().colors
        };
        let bytes = [["1", "0", "0", "255"], ["127", "64", "255", "51"], ["0", "2", "255", "0"]];
        let expected = with("uchar", bytes);
        assert!(expected[1].x < 0.25 && expected[1].w == 0.2, "{expected:?}");
        for kind in ["float", "double"] {
            assert_eq!(with(kind, bytes), expected, "{kind}");
        }
        // Shares stay what they are beside one that is a little too bright, and opacities are measured apart from colours.
        let white = Vec4::ONE;
        let shares = [["1", "1", "1", "1"], ["1.25", "1", "1", "1"], ["0", "0", "0", "0.5"]];
        assert_eq!(with("float", shares), [white, white, Vec4::new(0.0, 0.0, 0.0, 0.5)]);
        let mixed = [["255", "255", "255", "1"], ["255", "255", "255", "0.5"], ["nan", "0", "0", "1"]];
        assert_eq!(with("float", mixed), [white, Vec4::new(1.0, 1.0, 1.0, 0.5), Vec4::new(0.0, 0.0, 0.0, 1.0)]);
    }

    #[test]
    fn absurd_numbers_are_errors() {
        let with = |from: &str, to: &str| String::from_utf8(sample("ascii")).unwrap().replacen(from, to, 1);
        for (from, to) in [
            ("vertex 4", "vertex 4000000"),
            ("face 1", "face 99999999999999999999"),
            ("4 0 1 2 3", "4 0 1 2 4"),
            ("4 0 1 2 3", "4 0 1 2 -3"),
            ("4 0 1 2 3", "400000000 0 1"),
            ("1 1 0.5", "1 nan 0.5"),
            ("1 1 0.5", "1 1e60 0.5"),
            ("ascii 1.0", "ascii 2.0"),
            ("property float z", "property float w"),
            ("property float z", "property quaternion z"),
        ] {
            let text = with(from, to);
            assert!(read_bytes(text.as_bytes()).is_err(), "{to}");
        }
        let error = read_bytes(
            b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000\n\
            property float x\nproperty float y\nproperty float z\nend_header\n",
        )
        .unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
    }
}
