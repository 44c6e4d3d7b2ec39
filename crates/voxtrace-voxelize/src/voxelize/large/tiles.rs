//! What several processes find out about the files of a mesh, each about some of them, and bring together. As bytes it travels from process to
//! process.

use super::{ReadMesh, Survey};
use crate::fields::{FieldReader, FieldWriter};
use crate::mesh::joined::{Joined, Part};
use crate::mesh::source::Sample;
use crate::mesh::{Mesh, MeshMaterial, TextureUse, Wrap};
use crate::voxelize::fingerprint::of_description;
use crate::voxelize::large_points::check_files;
use crate::voxelize::{VoxelizeError, VoxelizeProgress};
use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};
use std::ops::Range;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_scene::{Camera, camera::Lens};

/// First bytes of a survey. To be changed with what follows them.
const MAGIC: &[u8; 8] = b"voxmesh\x01";

/// A file of a mesh that was looked through.
#[derive(Clone, Debug)]
struct MeshTile {
    part: Part,
    survey: Survey,
}

/// Files of a mesh that were looked through: some, or all.
#[derive(Clone, Debug)]
pub struct MeshTiles {
    /// What tells the files and how they are read from others.
    key: u128,
    /// Number of files of the mesh.
    count: u32,
    /// Those that were looked through, in their order.
    tiles: Vec<(u32, MeshTile)>,
}

fn wrong<T>(what: impl Into<String>) -> Result<T, VoxelizeError> {
    Err(VoxelizeError::Parts(what.into()))
}

impl MeshTile {
    /// Looks through the mesh of a file.
    fn of(mesh: &Mesh) -> Self {
        let mut survey = Survey::empty();
        for triangle in 0..mesh.triangle_count() {
            survey.add(&mesh.corners(triangle).map(|corner| mesh.positions[corner]));
        }
        Self { part: Part::of(mesh), survey }
    }
}

impl MeshTiles {
    /// Looks through `files` of `count`; `stamp` tells them from others, and how they are read.
    ///
    /// # Errors
    /// If there are no such files, one cannot be read, or it was cancelled.
    pub fn of(
        (count, stamp, mut read): (usize, &str, Box<ReadMesh<'_>>),
        files: Range<usize>,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        check_files(&files, count)?;
        progress.begin(files.len() as u64);
        let mut tiles = Vec::new();
        for file in files {
            tiles.push((file as u32, MeshTile::of(&read(file)?)));
            progress.add(1);
            if progress.is_cancelled() {
                return Err(VoxelizeError::Cancelled);
            }
        }
        Ok(Self { key: of_description(&stamp), count: count as u32, tiles })
    }

    /// What several processes have found.
    ///
    /// # Errors
    /// If they looked through other files, or through one twice.
    pub fn join(surveys: impl IntoIterator<Item = Self>) -> Result<Self, VoxelizeError> {
        let mut surveys = surveys.into_iter();
        let Some(mut all) = surveys.next() else { return wrong("no survey is given") };
        for other in surveys {
            if (other.key, other.count) != (all.key, all.count) {
                return wrong("two surveys are of other files, or with other options");
            }
            all.tiles.extend(other.tiles);
        }
        all.tiles.sort_by_key(|(number, _)| *number);
        match all.tiles.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => wrong(format!("file {} is in two surveys", pair[0].0)),
            None => Ok(all),
        }
    }

    /// Checks that all files were looked through, and that they are those of `stamp`.
    ///
    /// # Errors
    /// If not, or no file has a triangle.
    pub fn check(&self, stamp: &str) -> Result<(), VoxelizeError> {
        if self.key != of_description(&stamp) {
            return wrong("the survey is of other files, or with other options");
        }
        let missing =
            (0..self.count).find(|file| self.tiles.binary_search_by_key(file, |(number, _)| *number).is_err());
        if let Some(file) = missing {
            return wrong(format!("file {file} of {} is in no survey", self.count));
        }
        let is_empty = self.tiles.iter().all(|(_, tile)| tile.survey.triangles() == 0);
        if is_empty { Err(VoxelizeError::Empty) } else { Ok(()) }
    }

    /// Whether bytes are such a survey, by the first of them.
    pub fn is_in(bytes: &[u8]) -> bool {
        bytes.starts_with(MAGIC)
    }

    /// Says what the unit of all positions is.
    pub fn set_unit(&mut self, unit: LengthUnit) {
        self.tiles.iter_mut().for_each(|(_, tile)| tile.part.frame.unit = unit);
    }

    /// The numbers of the files that were looked through, and the units of their positions.
    #[doc(hidden)]
    pub fn units(&self) -> impl Iterator<Item = (usize, LengthUnit)> + '_ {
        self.tiles.iter().map(|(number, tile)| (*number as usize, tile.part.frame.unit))
    }

    /// Number of triangles of the files that were looked through.
    pub fn triangles(&self) -> u64 {
        self.tiles.iter().map(|(_, tile)| tile.survey.triangles()).sum()
    }

    /// The meshes of all files as one, without their triangles.
    ///
    /// # Errors
    /// If they cannot be one.
    pub fn joined(&self) -> Result<Joined, VoxelizeError> {
        Joined::of(self.tiles.iter().map(|(_, tile)| &tile.part)).map_err(VoxelizeError::BadMesh)
    }

    /// The survey of all files together, in the coordinates of the whole.
    pub fn survey(&self, joined: &Joined) -> Survey {
        let mut all = Survey::empty();
        for (number, (_, tile)) in self.tiles.iter().enumerate() {
            let own = tile.survey.moved(|position| joined.position(number, position));
            (all.low, all.high) = (all.low.min(own.low), all.high.max(own.high));
            (0..2).for_each(|sum| all.areas[sum] += own.areas[sum]);
            all.sample.join(&own.sample);
        }
        all
    }

    /// Number of triangles of each file.
    pub(super) fn counts(&self) -> impl Iterator<Item = u64> + '_ {
        self.tiles.iter().map(|(_, tile)| tile.survey.triangles())
    }

    /// The bounds of the triangles of each file, in the coordinates of the whole; `None` where it has none.
    pub(super) fn bounds<'a>(&'a self, joined: &'a Joined) -> impl Iterator<Item = Option<(Vec3, Vec3)>> + 'a {
        self.tiles.iter().enumerate().map(|(number, (_, tile))| {
            let place = |position| joined.position(number, position);
            (tile.survey.triangles() > 0).then(|| (place(tile.survey.low), place(tile.survey.high)))
        })
    }

    /// The survey as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = FieldWriter::new(MAGIC);
        out.value(self.key);
        out.value(self.count);
        out.value(self.tiles.len() as u32);
        for (number, tile) in &self.tiles {
            out.value(*number);
            tile.write(&mut out);
        }
        out.finish()
    }

    /// The survey of such bytes.
    ///
    /// # Errors
    /// If they are none, or damaged.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, VoxelizeError> {
        let read = || {
            let mut from = FieldReader::open(bytes, MAGIC)?;
            let (key, count, own) = (from.value()?, from.value()?, from.value::<u32>()?);
            let tiles: Option<Vec<_>> = (0..own).map(|_| Some((from.value()?, MeshTile::read(&mut from)?))).collect();
            Some(Self { key, count, tiles: tiles? })
        };
        read().map_or_else(|| wrong("no survey of meshes of this version, or damaged"), Ok)
    }
}

impl Survey {
    /// The same in other coordinates, which are moved.
    fn moved(&self, place: impl Fn(Vec3) -> Vec3) -> Self {
        let points = self.sample.points().iter().map(|&point| place(point)).collect();
        let sample = Sample::of_parts(points, self.sample.stride(), self.sample.seen());
        Self { low: place(self.low), high: place(self.high), areas: self.areas, sample: sample.unwrap_or_default() }
    }
}

impl MeshTile {
    fn write(&self, out: &mut FieldWriter) {
        let Self { part, survey } = self;
        let Mesh { name, offset, materials, cameras, unit, notes, .. } = &part.frame;
        out.values(name.as_bytes());
        out.value(*offset);
        out.value(unit.metres().unwrap_or(f64::NAN));
        out.value(notes.len() as u32);
        notes.iter().for_each(|note| out.values(note.as_bytes()));
        out.values(&materials.iter().map(MaterialRecord::of).collect::<Vec<_>>());
        out.value(cameras.len() as u32);
        for camera in cameras {
            out.values(camera.name.as_bytes());
            out.value(CameraRecord::of(camera));
        }
        out.value(part.textures as u64);
        out.value([u8::from(part.has_uvs), u8::from(part.has_colors)]);
        out.values(&part.used.iter().map(|&used| u8::from(used)).collect::<Vec<_>>());
        out.value([survey.low, survey.high]);
        out.value(survey.areas);
        out.value([survey.sample.stride(), survey.sample.seen()]);
        out.values(survey.sample.points());
    }

    fn read(from: &mut FieldReader) -> Option<Self> {
        let text = |from: &mut FieldReader| String::from_utf8(from.values()?).ok();
        let (name, offset) = (text(from)?, from.value()?);
        let metres: f64 = from.value()?;
        let unit = if metres.is_nan() { LengthUnit::UNKNOWN } else { LengthUnit::of_metres(metres) };
        let notes = (0..from.value::<u32>()?).map(|_| text(from)).collect::<Option<Vec<_>>>()?;
        let materials: Vec<MeshMaterial> =
            from.values::<MaterialRecord>()?.iter().map(MaterialRecord::material).collect();
        let cameras = (0..from.value::<u32>()?).map(|_| {
            let name = text(from)?;
            Some(from.value::<CameraRecord>()?.camera(name))
        });
        let cameras = cameras.collect::<Option<Vec<_>>>()?;
        let textures = usize::try_from(from.value::<u64>()?).ok()?;
        let [has_uvs, has_colors] = from.value::<[u8; 2]>()?.map(|flag| flag > 0);
        let used: Vec<bool> = from.values::<u8>()?.iter().map(|&used| used > 0).collect();
        let [low, high] = from.value()?;
        let areas = from.value()?;
        let [stride, seen] = from.value()?;
        let sample = Sample::of_parts(from.values()?, stride, seen)?;
        let frame = Mesh { name, offset, materials, cameras, unit, notes, ..Mesh::default() };
        Some(Self {
            part: Part { frame, textures, has_uvs, has_colors, used },
            survey: Survey { low, high, areas, sample },
        })
    }
}

/// A material without its name. What there may be and is not has a number that is none.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct MaterialRecord {
    base_color: Vec4,
    emission: Vec3,
    absorption: Vec3,
    alpha_cutoff: f32,
    roughness: f32,
    metallic: f32,
    transmission: f32,
    ior: f32,
    coat: f32,
    /// Of base colour, alpha, emission and surface.
    textures: [TextureRecord; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct TextureRecord {
    /// The largest number where there is no texture.
    texture: u32,
    /// Numbers of the modes along u and v, then 1 for the nearest texel, then 0.
    flags: [u8; 4],
    transform: [Vec3; 2],
}

const WRAPS: [Wrap; 3] = [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp];

impl TextureRecord {
    fn of(texture: Option<TextureUse>) -> Self {
        let Some(TextureUse { texture, wrap, nearest, transform }) = texture else {
            return Self { texture: u32::MAX, ..Self::zeroed() };
        };
        let mode = |wrap: Wrap| WRAPS.iter().position(|&known| known == wrap).unwrap_or(0) as u8;
        Self { texture, flags: [mode(wrap[0]), mode(wrap[1]), u8::from(nearest), 0], transform }
    }

    fn texture(&self) -> Option<TextureUse> {
        let wrap = [0, 1].map(|axis| WRAPS.get(usize::from(self.flags[axis])).copied().unwrap_or_default());
        let Self { texture, transform, .. } = *self;
        (texture != u32::MAX).then_some(TextureUse { texture, wrap, nearest: self.flags[2] > 0, transform })
    }
}

impl MaterialRecord {
    fn of(material: &MeshMaterial) -> Self {
        let MeshMaterial { base_color, emission, alpha_cutoff, roughness, metallic, transmission, ior, .. } = *material;
        let textures =
            [material.base_texture, material.alpha_texture, material.emission_texture, material.surface_texture];
        let (absorption, coat) = (material.absorption.unwrap_or(Vec3::NAN), material.coat.unwrap_or(f32::NAN));
        let textures = textures.map(TextureRecord::of);
        Self { base_color, emission, absorption, alpha_cutoff, roughness, metallic, transmission, ior, coat, textures }
    }

    fn material(&self) -> MeshMaterial {
        let Self { base_color, emission, alpha_cutoff, roughness, metallic, transmission, ior, .. } = *self;
        let [base_texture, alpha_texture, emission_texture, surface_texture] =
            self.textures.each_ref().map(TextureRecord::texture);
        MeshMaterial {
            name: String::new(),
            base_color,
            base_texture,
            alpha_texture,
            alpha_cutoff,
            emission,
            emission_texture,
            roughness,
            metallic,
            surface_texture,
            transmission,
            ior,
            coat: (!self.coat.is_nan()).then_some(self.coat),
            absorption: (!self.absorption.is_nan()).then_some(self.absorption),
        }
    }
}

/// A camera without its name. Files of meshes have pinholes and orthographic ones.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct CameraRecord {
    eye: Vec3,
    target: Vec3,
    up: Vec3,
    fov_y: f32,
    /// Of an orthographic camera; 0 for a pinhole.
    view_height: f32,
}

impl CameraRecord {
    fn of(camera: &Camera) -> Self {
        let view_height = if let Lens::Orthographic { view_height } = camera.lens { view_height } else { 0.0 };
        let Camera { eye, target, up, fov_y, .. } = *camera;
        Self { eye, target, up, fov_y, view_height }
    }

    fn camera(self, name: String) -> Camera {
        let Self { eye, target, up, fov_y, view_height } = self;
        let lens = if view_height > 0.0 { Lens::Orthographic { view_height } } else { Lens::Pinhole };
        Camera { name, eye, target, up, fov_y, lens }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Texture;
    use glam::{DVec3, Vec2};

    fn mesh() -> Mesh {
        let texture = TextureUse {
            texture: 1,
            wrap: [Wrap::Clamp, Wrap::Mirror],
            nearest: true,
            transform: [Vec3::new(2.0, 0.0, 0.5), Vec3::NEG_Y],
        };
        let material = MeshMaterial {
            base_texture: Some(texture),
            surface_texture: Some(TextureUse::new(0)),
            coat: Some(0.25),
            absorption: Some(Vec3::new(0.1, 0.2, 0.3)),
            emission: Vec3::ONE,
            ..MeshMaterial::default()
        };
        let (eye, target) = (Vec3::ONE, Vec3::ZERO);
        let flat = Camera { lens: Lens::Orthographic { view_height: 3.0 }, ..Camera::look_at(eye, target) };
        Mesh {
            offset: DVec3::new(5e5, -1.0, 0.25),
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            uvs: vec![Vec2::ZERO; 4],
            colors: vec![Vec4::ONE; 4],
            material_of: vec![1, 1],
            materials: vec![MeshMaterial::default(), material],
            textures: vec![Texture::new(1, 1, vec![[3; 4]]).unwrap(); 2],
            cameras: vec![Camera::look_at(eye, target), flat],
            unit: LengthUnit::of_symbol("mm").unwrap(),
            notes: vec!["a note".into()],
            ..Mesh::new("tile")
        }
    }

    fn survey(files: Range<usize>) -> MeshTiles {
        MeshTiles::of((4, "7", Box::new(|_| Ok(mesh()))), files, &VoxelizeProgress::default()).unwrap()
    }

    #[test]
    fn bytes_hold_all_that_there_is_to_know() {
        let all = MeshTiles::join([survey(2..4), survey(0..2)]).unwrap();
        let bytes = all.to_bytes();
        let read = MeshTiles::from_bytes(&bytes).unwrap();
        for ((_, a), (_, b)) in all.tiles.iter().zip(&read.tiles) {
            assert_eq!(a.part, b.part);
            assert_eq!(format!("{:?}", a.survey), format!("{:?}", b.survey));
        }
        assert_eq!((read.to_bytes() == bytes, read.triangles(), read.tiles.len()), (true, 8, 4));
        read.check("7").unwrap();
        for at in (0..bytes.len()).step_by(7) {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert!(MeshTiles::from_bytes(&damaged).is_err(), "{at}");
        }
    }

    #[test]
    fn surveys_that_do_not_belong_together_are_refused() {
        let told = |result: Result<MeshTiles, VoxelizeError>| result.unwrap_err().to_string();
        assert_eq!(told(MeshTiles::join([survey(0..2), survey(1..4)])), "file 1 is in two surveys");
        assert!(told(MeshTiles::join([survey(0..2), MeshTiles { key: 8, ..survey(2..4) }])).contains("other files"));
        assert_eq!(survey(1..4).check("7").unwrap_err().to_string(), "file 0 of 4 is in no survey");
        assert!(survey(0..4).check("8").unwrap_err().to_string().contains("other files"));
        let read: Box<ReadMesh> = Box::new(|_| Ok(mesh()));
        let beyond = MeshTiles::of((4, "7", read), 2..5, &VoxelizeProgress::default());
        assert_eq!(told(beyond), "there are no files 2..5 among 4");
    }
}
