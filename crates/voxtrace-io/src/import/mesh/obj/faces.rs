//! The faces of an OBJ file: polygons whose corners are pairs of a position and a texture coordinate.

use glam::{Vec2, Vec3};
use rustc_hash::FxHashMap;
use voxtrace_voxelize::mesh::{Mesh, polygon::triangulate};

/// No texture coordinate.
const NONE: u32 = u32::MAX;

/// Triangles so far.
#[derive(Default)]
pub(super) struct Faces {
    /// Positions of the corners.
    triangles: Vec<[u32; 3]>,
    /// Texture coordinates of the corners; empty until the first one.
    coordinates: Vec<[u32; 3]>,
    materials: Vec<u16>,
    corners: Vec<[u32; 2]>,
    /// Corners whose texture coordinate the file has not.
    missing: usize,
    cut: Vec<[usize; 3]>,
}

impl Faces {
    /// Corners whose texture coordinate the file has not.
    pub fn missing(&self) -> usize {
        self.missing
    }

    /// Triangles so far.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Adds the face of a line; `count` are the positions and texture coordinates so far. False where it is no area.
    pub fn push(&mut self, line: &[u8], count: [usize; 2], positions: &[Vec3], material: u16) -> Result<bool, String> {
        self.corners.clear();
        for word in line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            if word.starts_with(b"#") {
                break;
            }
            let mut parts = word.split(|&byte| byte == b'/');
            let name = parts.next().unwrap_or_default();
            let position = index(name, count[0])?;
            let position =
                position.ok_or_else(|| format!("a face names {} of {}", String::from_utf8_lossy(name), count[0]))?;
            let coordinate = match parts.next() {
                Some(part) if !part.is_empty() => {
                    // Some programs name coordinates that they do not write.
                    let found = index(part, count[1])?;
                    self.missing += usize::from(found.is_none());
                    found.unwrap_or(NONE)
                }
                _ => NONE,
            };
            self.corners.push([position, coordinate]);
        }
        if self.corners.len() < 3 {
            return Ok(false);
        }
        self.cut.clear();
        if self.corners.len() == 3 {
            self.cut.push([0, 1, 2]);
        } else {
            let points: Vec<Vec3> = self.corners.iter().map(|corner| positions[corner[0] as usize]).collect();
            triangulate(&points, &mut self.cut);
        }
        let has_coordinates = self.corners.iter().any(|corner| corner[1] != NONE);
        if has_coordinates && self.coordinates.is_empty() {
            self.coordinates.resize(self.triangles.len(), [NONE; 3]);
        }
        for cut in &self.cut {
            let corners = cut.map(|corner| self.corners[corner]);
            if has_coordinates || !self.coordinates.is_empty() {
                self.coordinates.push(corners.map(|corner| corner[1]));
            }
            self.triangles.push(corners.map(|corner| corner[0]));
            self.materials.push(material);
        }
        Ok(true)
    }

    /// Puts the triangles into the mesh. Each pair of position and texture coordinate becomes a vertex, the first one of a
    /// position in its place and the others at the end.
    pub fn finish(self, uvs: &[Vec2], mesh: &mut Mesh) {
        mesh.triangles = self.triangles;
        if self.materials.iter().any(|&material| material != 0) {
            mesh.material_of = self.materials;
        }
        if self.coordinates.is_empty() {
            return;
        }
        let uv_of = |coordinate: u32| uvs.get(coordinate as usize).copied().unwrap_or(Vec2::ZERO);
        let mut first = vec![None; mesh.positions.len()];
        mesh.uvs = vec![Vec2::ZERO; mesh.positions.len()];
        let mut others: FxHashMap<[u32; 2], u32> = FxHashMap::default();
        for (triangle, coordinates) in mesh.triangles.iter_mut().zip(&self.coordinates) {
            for (corner, &coordinate) in triangle.iter_mut().zip(coordinates) {
                let position = *corner as usize;
                match first[position] {
                    None => {
                        first[position] = Some(coordinate);
                        mesh.uvs[position] = uv_of(coordinate);
                    }
                    Some(known) if known == coordinate => {}
                    Some(_) => {
                        *corner = *others.entry([*corner, coordinate]).or_insert_with(|| {
                            mesh.positions.push(mesh.positions[position]);
                            mesh.uvs.push(uv_of(coordinate));
                            if !mesh.colors.is_empty() {
                                mesh.colors.push(mesh.colors[position]);
                            }
                            (mesh.positions.len() - 1) as u32
                        });
                    }
                }
            }
        }
    }
}

/// An index from 0 on; the file counts from 1 on, or from −1 backwards.
fn index(word: &[u8], count: usize) -> Result<Option<u32>, String> {
    let text = std::str::from_utf8(word).unwrap_or_default();
    let number: i64 = text.parse().map_err(|_| format!("{:.40?} is no index", String::from_utf8_lossy(word)))?;
    let index = if number < 0 { number + count as i64 } else { number - 1 };
    Ok(u32::try_from(index).ok().filter(|&index| (index as usize) < count))
}
