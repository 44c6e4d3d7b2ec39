//! Triangle meshes, as importers make them and the voxelizer takes them: positions with an offset in f64, texture
//! coordinates, vertex colours and materials. Space is right-handed, z up.

mod changing;
pub mod joined;
pub mod polygon;
pub mod source;
mod texture;

pub use changing::{ChangingPart, PartShapes};
pub use texture::{Texture, Wrap};

use glam::{DAffine3, DMat3, DVec3, Vec2, Vec3, Vec4};
use std::sync::Arc;
use voxtrace_scene::Invalid;
use voxtrace_scene::animation::Clip;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::scene::LengthUnit;

/// Triangles with their materials and textures. [`Mesh::validate`] checks that the arrays are consistent; those of importers are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Name for people, for example the file's stem.
    pub name: String,
    /// Added to every position: large coordinates stay exact.
    pub offset: DVec3,
    /// Corners, without the offset.
    pub positions: Vec<Vec3>,
    /// Indices into `positions`; empty where every three positions in turn are a triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Texture coordinates of each position, origin at the top left of the picture; empty where there are none.
    pub uvs: Vec<Vec2>,
    /// Linear colour and alpha of each position; empty where there are none.
    pub colors: Vec<Vec4>,
    /// Index into `materials` of each triangle; empty where all have the first.
    pub material_of: Vec<u16>,
    /// Materials, at least one.
    pub materials: Vec<MeshMaterial>,
    /// Textures that materials refer to.
    pub textures: Vec<Texture>,
    /// Cameras of the file, in the mesh's units with the offset taken off.
    pub cameras: Vec<Camera>,
    /// Unit of the positions.
    pub unit: LengthUnit,
    /// Warnings of the reader, one sentence each, for people.
    pub notes: Vec<String>,
    /// Animations of the file, one of them with its motion where it was asked for; its instances are those of `moving`.
    pub clips: Vec<Clip>,
    /// What moves in that animation; none of it is in the arrays above.
    pub moving: Option<Box<MovingParts>>,
}

/// Parts of a mesh that move, each voxelized in its own space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MovingParts {
    /// Their arrays and offsets alone: materials and textures are those of the mesh.
    pub meshes: Vec<Mesh>,
    /// Which of them is seen where a node carries it, and its name.
    pub placed: Vec<(usize, String)>,
    /// Which of them change their shape.
    pub changing: Vec<ChangingPart>,
}

/// The material of triangles. Colours are linear.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMaterial {
    /// Name, empty where there is none.
    pub name: String,
    /// Base colour and alpha; multiplies texture and vertex colour.
    pub base_color: Vec4,
    /// Texture of base colour and alpha.
    pub base_texture: Option<TextureUse>,
    /// Grey texture of the alpha (its red channel is read), as some OBJ files have it.
    pub alpha_texture: Option<TextureUse>,
    /// Alpha test: where alpha is below this there is no surface; 0 keeps all.
    pub alpha_cutoff: f32,
    /// Emitted radiance.
    pub emission: Vec3,
    /// Texture that multiplies the emission.
    pub emission_texture: Option<TextureUse>,
    /// Roughness in [0, 1].
    pub roughness: f32,
    /// Metalness in [0, 1].
    pub metallic: f32,
    /// Texture whose green channel multiplies the roughness and whose blue one the metalness, by their bytes as they are.
    pub surface_texture: Option<TextureUse>,
    /// Transmission in [0, 1].
    pub transmission: f32,
    /// Index of refraction, ≥ 1.
    pub ior: f32,
    /// Weight of the coat over the diffuse surface, in [0, 1]; `None`: 1 unless the surface is as rough as can be.
    pub coat: Option<f32>,
    /// What the inside of a transparent mesh absorbs in a unit of the mesh, each channel ≥ 0; `None`: white light has the base colour after a
    /// few voxels.
    pub absorption: Option<Vec3>,
}

/// A reference to a texture, with sampler and transform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Index into [`Mesh::textures`].
    pub texture: u32,
    /// Wrap modes along u and v.
    pub wrap: [Wrap; 2],
    /// Whether to take the nearest texel instead of filtering bilinearly.
    pub nearest: bool,
    /// Rows of the 2×3 matrix from the mesh's texture coordinates to those of the texture.
    pub transform: [Vec3; 2],
}

impl TextureUse {
    /// A repeating texture without a transform.
    pub fn new(texture: u32) -> Self {
        Self { texture, wrap: [Wrap::Repeat; 2], nearest: false, transform: [Vec3::X, Vec3::Y] }
    }

    /// Applies the transform to texture coordinates.
    pub fn place(&self, uv: Vec2) -> Vec2 {
        let [u, v] = self.transform.map(|row| row.dot(uv.extend(1.0)));
        Vec2::new(u, v)
    }
}

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// +x.
    X,
    /// +y.
    Y,
    /// +z.
    Z,
    /// −x.
    MinusX,
    /// −y.
    MinusY,
    /// −z.
    MinusZ,
}

impl UpAxis {
    /// The axis whose turn takes that of this one back.
    #[must_use]
    pub fn inverse(self) -> Self {
        match self {
            Self::X => Self::MinusX,
            Self::MinusX => Self::X,
            Self::Y => Self::MinusY,
            Self::MinusY => Self::Y,
            Self::Z | Self::MinusZ => self,
        }
    }

    /// A vector after the quarter turns that take this axis to +z.
    pub fn to_z_up(self, vector: Vec3) -> Vec3 {
        Vec3::from_array(self.to_z_up_array(vector.to_array()))
    }

    /// As [`Self::to_z_up`], in f64.
    pub fn to_z_up_f64(self, vector: DVec3) -> DVec3 {
        DVec3::from_array(self.to_z_up_array(vector.to_array()))
    }

    /// As [`Self::to_z_up`], for any number type.
    pub fn to_z_up_array<T: std::ops::Neg<Output = T>>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Self::X => [-z, y, x],
            Self::Y => [x, -z, y],
            Self::Z => [x, y, z],
            Self::MinusX => [z, y, -x],
            Self::MinusY => [x, z, -y],
            Self::MinusZ => [x, -y, -z],
        }
    }
}

impl Default for MeshMaterial {
    fn default() -> Self {
        Self {
            name: String::new(),
            base_color: Vec4::new(0.8, 0.8, 0.8, 1.0),
            base_texture: None,
            alpha_texture: None,
            alpha_cutoff: 0.0,
            emission: Vec3::ZERO,
            emission_texture: None,
            roughness: 1.0,
            metallic: 0.0,
            surface_texture: None,
            transmission: 0.0,
            ior: 1.5,
            coat: None,
            absorption: None,
        }
    }
}

impl Mesh {
    /// A mesh without triangles, of one plain material.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), materials: vec![MeshMaterial::default()], ..Self::default() }
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        if self.triangles.is_empty() { self.positions.len() / 3 } else { self.triangles.len() }
    }

    /// Indices of the corners of a triangle.
    #[inline]
    pub fn corners(&self, triangle: usize) -> [usize; 3] {
        match self.triangles.get(triangle) {
            Some(&[a, b, c]) => [a as usize, b as usize, c as usize],
            None => [3 * triangle, 3 * triangle + 1, 3 * triangle + 2],
        }
    }

    /// The material of a triangle.
    pub fn material(&self, triangle: usize) -> usize {
        self.material_of.get(triangle).map_or(0, |&material| usize::from(material))
    }

    /// The box around all corners of triangles, offset included; `None` where there are no triangles.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        if self.triangles.is_empty() {
            for &position in &self.positions[..3 * self.triangle_count()] {
                (min, max) = (min.min(position), max.max(position));
            }
        }
        for &corner in self.triangles.as_flattened() {
            let position = self.positions[corner as usize];
            (min, max) = (min.min(position), max.max(position));
        }
        (min.x <= max.x).then(|| (min.as_dvec3() + self.offset, max.as_dvec3() + self.offset))
    }

    /// Turns the mesh so that what was along `up` points along +z.
    pub fn make_z_up(&mut self, up: UpAxis) {
        self.positions.iter_mut().for_each(|position| *position = up.to_z_up(*position));
        self.offset = up.to_z_up_f64(self.offset);
        for camera in &mut self.cameras {
            (camera.eye, camera.target, camera.up) =
                (up.to_z_up(camera.eye), up.to_z_up(camera.target), up.to_z_up(camera.up));
        }
        let turn = DMat3::from_cols(up.to_z_up_f64(DVec3::X), up.to_z_up_f64(DVec3::Y), up.to_z_up_f64(DVec3::Z));
        for motion in self.clips.iter_mut().filter_map(|clip| clip.motion.as_mut()) {
            let motion = Arc::make_mut(motion);
            motion.world_from_file = DAffine3::from_mat3(turn) * motion.world_from_file;
        }
    }

    /// Drops all triangles and keeps the rest.
    pub fn clear(&mut self) {
        self.positions.clear();
        self.triangles.clear();
        self.uvs.clear();
        self.colors.clear();
        self.material_of.clear();
    }

    /// Bytes that the arrays take.
    pub fn size_bytes(&self) -> u64 {
        let textures: usize = self.textures.iter().map(Texture::size_bytes).sum();
        let arrays = size_of_val(&*self.positions)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.uvs)
            + size_of_val(&*self.colors)
            + size_of_val(&*self.material_of);
        (arrays + textures) as u64
    }

    /// Checks that every index lies inside its array and every position is finite.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        let vertices = self.positions.len();
        let is_per_vertex = |count: usize| count == 0 || count == vertices;
        if !is_per_vertex(self.uvs.len()) || !is_per_vertex(self.colors.len()) {
            return Err("texture coordinates or colours are not one for each position".into());
        }
        if !self.material_of.is_empty() && self.material_of.len() != self.triangle_count() {
            return Err("materials are not one for each triangle".into());
        }
        if self.materials.is_empty() {
            return Err("there is no material".into());
        }
        if let Some(at) = self.positions.iter().position(|position| !position.is_finite()) {
            return Err(format!("position {at} is not finite").into());
        }
        if !self.offset.is_finite() {
            return Err("the offset is not finite".into());
        }
        let inside = |corner: &u32| (*corner as usize) < vertices;
        if let Some(at) = self.triangles.iter().position(|corners| !corners.iter().all(inside)) {
            return Err(format!("triangle {at} has a corner that is missing").into());
        }
        if self.material_of.iter().any(|&material| usize::from(material) >= self.materials.len()) {
            return Err("a triangle has a material that is missing".into());
        }
        let textures = |m: &MeshMaterial| [m.base_texture, m.alpha_texture, m.emission_texture, m.surface_texture];
        let uses = self.materials.iter().flat_map(textures);
        if uses.flatten().any(|texture| texture.texture as usize >= self.textures.len()) {
            return Err("a material has a texture that is missing".into());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quad() -> Mesh {
        Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 2.0, 3.0), Vec3::Y],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            material_of: vec![0, 0],
            offset: DVec3::new(1e7, 0.0, 0.0),
            ..Mesh::new("quad")
        }
    }

    #[test]
    fn the_bounds_hold_the_offset() {
        assert_eq!(quad().bounds(), Some((DVec3::new(1e7, 0.0, 0.0), DVec3::new(1e7 + 1.0, 2.0, 3.0))));
        assert_eq!(Mesh::new("empty").bounds(), None);
    }

    #[test]
    fn each_axis_turns_up_without_a_mirror() {
        use UpAxis::{MinusX, MinusY, MinusZ, X, Y, Z};
        let axes = [X, Y, Z, MinusX, MinusY, MinusZ];
        for (up, axis) in axes.into_iter().zip([Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z]) {
            assert_eq!(up.to_z_up(axis), Vec3::Z, "{up:?}");
            let turned = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| up.to_z_up(axis));
            assert_eq!(turned[0].cross(turned[1]), turned[2], "{up:?}");
        }
        let mut mesh = quad();
        mesh.make_z_up(Y);
        assert_eq!((mesh.positions[2], mesh.offset.x), (Vec3::new(1.0, -3.0, 2.0), 1e7));
        mesh.make_z_up(MinusY);
        assert_eq!(mesh, quad());
    }

    #[test]
    fn faults_are_found() {
        quad().validate().unwrap();
        type Fault = fn(&mut Mesh);
        let faults: [Fault; 7] = [
            |mesh| mesh.triangles[1][2] = 4,
            |mesh| mesh.positions[3].y = f32::NAN,
            |mesh| mesh.uvs.push(Vec2::ZERO),
            |mesh| mesh.material_of[0] = 1,
            |mesh| _ = mesh.material_of.pop(),
            |mesh| mesh.materials.clear(),
            |mesh| mesh.materials[0].base_texture = Some(TextureUse::new(0)),
        ];
        for (which, fault) in faults.into_iter().enumerate() {
            let mut mesh = quad();
            fault(&mut mesh);
            assert!(mesh.validate().is_err(), "fault {which}");
        }
    }
}
