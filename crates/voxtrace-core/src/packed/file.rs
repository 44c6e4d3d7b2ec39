//! The native file, `.vxt`: the sections of a packed scene as they are in memory, so that opening one is mapping it.
//! `docs/format.md` is the specification.

use super::file_error::{FileError, FileErrorKind, damaged};
use super::instance_record::InstanceRecord;
use super::lights::halved;
use super::material_records::{MaterialRecords, MediumRecord};
use super::parts::kept_instances;
use super::section_reader::{Reader, geometry_and_placement};
use super::{
    Outline, PackedScene,
    bytes::Bytes,
    levels,
    settings::{EnvironmentSections, LensRecord, Settings},
    streamed,
};
use crate::atomic_file::write_atomically_while;
use bytemuck::{Pod, Zeroable};
use std::fs::File;
use std::io::{self, Seek, Write};
use std::path::Path;
use std::sync::Arc;
use voxtrace_scene::georeference::Georeference;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// First bytes of every file.
pub const MAGIC: [u8; 8] = *b"VOXTRACE";
/// Version of the format that is written; all up to it are read.
pub const VERSION: u32 = 2;
/// Version of files for streaming, which have the scene and its levels in compressed chunks: see [`super::streamed`].
pub const STREAMED_VERSION: u32 = 3;
/// Sections start at multiples of this many bytes.
pub(super) const ALIGNMENT: usize = 64;

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Header {
    pub magic: [u8; 8],
    pub version: u32,
    pub section_count: u32,
    /// Of the section table.
    pub table_checksum: u64,
    pub reserved: [u64; 5],
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct TableEntry {
    /// Four letters.
    pub tag: [u8; 4],
    /// Bytes of one record.
    pub record_size: u32,
    pub offset: u64,
    pub size: u64,
    /// XXH3-64 of the section's bytes.
    pub checksum: u64,
}

/// A section to write: its tag, the bytes of one record, and all bytes.
pub(super) type SectionBytes<'a> = ([u8; 4], u32, &'a [u8]);

/// The section of some records.
pub(super) fn section_of<'a, T: Pod>(tag: &[u8; 4], records: &'a [T]) -> SectionBytes<'a> {
    (*tag, size_of::<T>() as u32, bytemuck::cast_slice(records))
}

/// Tags and record sizes in the order in which they are written.
fn sections<'a>(
    scene: &'a PackedScene,
    settings: &'a Settings,
    instances: &'a [InstanceRecord],
    materials: &'a MaterialRecords,
) -> [SectionBytes<'a>; 12] {
    let (geometry, placement) = (&scene.geometry, &scene.placement);
    [
        section_of(b"SETT", std::slice::from_ref(&settings.record)),
        section_of(b"CAMS", &settings.cameras),
        section_of(b"TEXT", &settings.text),
        section_of(b"GRID", &geometry.grids),
        section_of(b"INST", instances),
        section_of(b"INOD", &placement.instance_nodes),
        section_of(b"MATS", &materials.surfaces),
        section_of(b"EMIT", &geometry.emitters),
        section_of(b"LNOD", &geometry.light_nodes),
        section_of(b"CELL", &geometry.cells),
        section_of(b"BRIK", &geometry.bricks),
        section_of(b"BMAT", &geometry.brick_materials),
    ]
}

/// Writes sections as a file of their own, or as one within another.
pub(super) fn write_sections(writer: &mut impl Write, sections: &[SectionBytes]) -> io::Result<()> {
    let mut offset = size_of::<Header>() + sections.len() * size_of::<TableEntry>();
    let mut table = Vec::new();
    for (tag, record_size, bytes) in sections {
        offset = offset.next_multiple_of(ALIGNMENT);
        table.push(TableEntry {
            tag: *tag,
            record_size: *record_size,
            offset: offset as u64,
            size: bytes.len() as u64,
            checksum: xxh3_64(bytes),
        });
        offset += bytes.len();
    }
    let table_bytes = bytemuck::cast_slice(&table);
    let header = Header {
        magic: MAGIC,
        version: VERSION,
        section_count: table.len() as u32,
        table_checksum: xxh3_64(table_bytes),
        reserved: [0; 5],
    };
    writer.write_all(bytemuck::bytes_of(&header))?;
    writer.write_all(table_bytes)?;
    let mut written = size_of::<Header>() + table_bytes.len();
    for (entry, (.., bytes)) in table.iter().zip(sections) {
        writer.write_all(&[0; ALIGNMENT][..entry.offset as usize - written])?;
        writer.write_all(bytes)?;
        written = entry.offset as usize + bytes.len();
    }
    Ok(())
}

impl PackedScene {
    /// Saves the scene. The file at `path` is replaced whole or not at all.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn save(&self, path: &Path) -> Result<(), FileError> {
        self.save_while(path, &|| true)
    }

    /// As [`Self::save`], as long as it is `wanted`, which says no for good: once it is not, saving ends soon, with an error, and the old file is whole.
    ///
    /// # Errors
    /// What the operating system reports, and an error of [`io::ErrorKind::Other`] once it is not wanted.
    pub fn save_while(&self, path: &Path, wanted: &(dyn Fn() -> bool + Sync)) -> Result<(), FileError> {
        if self.geometry.is_edited {
            return self.compacted().save_while(path, wanted);
        }
        write_atomically_while(path, wanted, |writer| self.write(writer))
            .map_err(|error| FileError { path: path.into(), kind: error.into() })
    }

    /// The bytes of the file that [`Self::save`] writes, for where there are no files.
    pub fn to_bytes(&self) -> Vec<u8> {
        if self.geometry.is_edited {
            return self.compacted().to_bytes();
        }
        let mut bytes = Vec::new();
        self.write(&mut bytes).expect("memory takes all that is written");
        bytes
    }

    fn write(&self, writer: &mut impl Write) -> io::Result<()> {
        self.write_with(writer, &[])
    }

    /// Writes the scene with levels of detail, which are as files of their own.
    pub(super) fn write_with(&self, writer: &mut impl Write, levels: &[Arc<Bytes>]) -> io::Result<()> {
        let (settings, instances) = (Settings::of(self), InstanceRecord::all_of(&self.placement));
        let materials = MaterialRecords::of(&self.geometry.materials);
        let mut sections = sections(self, &settings, &instances, &materials).to_vec();
        let matrix = self.georeference.as_ref().map(Georeference::to_array);
        if let (Some(georeference), Some(matrix)) = (&self.georeference, &matrix) {
            sections.push((*b"GEOR", size_of_val(matrix) as u32, bytemuck::cast_slice(matrix)));
            sections.push((*b"GCRS", 1, georeference.crs.as_bytes()));
        }
        if !settings.lenses.is_empty() {
            sections.push((*b"LENS", size_of::<LensRecord>() as u32, bytemuck::cast_slice(&settings.lenses)));
        }
        if !materials.media.is_empty() {
            sections.push((*b"MEDI", size_of::<MediumRecord>() as u32, bytemuck::cast_slice(&materials.media)));
        }
        sections.extend(settings.environment.iter().flat_map(EnvironmentSections::parts));
        sections.extend(self.geometry.normal_section());
        sections.extend(self.geometry.coverage_section());
        sections.extend((1..).zip(levels).map(|(level, bytes)| (levels::tag_of(level), 1, &***bytes)));
        sections.extend(self.geometry.parts.iter().flat_map(|parts| parts.sections()));
        write_sections(writer, &sections)
    }

    /// Opens a scene by mapping its file into memory. Checksums and the scene's structure are verified, so tracing it
    /// afterwards cannot fail. Nobody may write into the file or shorten it while the scene is in use: what is read then
    /// was never verified, and the process may be ended. Replacing it, as saving does, is fine. Where that cannot be
    /// promised, [`Self::read`] is the way.
    ///
    /// # Errors
    /// [`FileError`] when the file cannot be read, is damaged, or is not what a voxtrace wrote.
    pub fn open(path: &Path) -> Result<Self, FileError> {
        Self::open_with(path, |file, _| Bytes::map(file))
    }

    /// Opens a scene by reading its file into memory. What happens to the file afterwards does not matter; else as
    /// [`Self::open`].
    ///
    /// # Errors
    /// As [`Self::open`], also where memory does not suffice.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        Self::open_with(path, |mut file, length| Bytes::read(&mut file, length))
    }

    /// As [`Self::open`], for a file that is open already.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn map_file(file: &File) -> Result<Self, FileErrorKind> {
        Self::of_file(file, |file, _| Bytes::map(file))
    }

    /// As [`Self::read`], for a file that is open already; it is read from its start.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_file(mut file: &File) -> Result<Self, FileErrorKind> {
        file.rewind()?;
        Self::of_file(file, |mut file, length| Bytes::read(&mut file, length))
    }

    fn open_with(path: &Path, bytes_of: impl Fn(&File, u64) -> io::Result<Bytes>) -> Result<Self, FileError> {
        let opened = File::open(path).map_err(FileErrorKind::from);
        opened.and_then(|file| Self::of_file(&file, bytes_of)).map_err(|kind| FileError { path: path.into(), kind })
    }

    fn of_file(file: &File, bytes_of: impl Fn(&File, u64) -> io::Result<Bytes>) -> Result<Self, FileErrorKind> {
        // An empty file cannot be mapped; it is damaged anyway.
        let length = file.metadata()?.len();
        if length < size_of::<Header>() as u64 {
            return Err(FileErrorKind::Damaged { what: "the header is cut off".into(), offset: length });
        }
        Self::from_file(bytes_of(file, length)?)
    }

    /// Opens a scene from the bytes of a file, which are copied.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FileErrorKind> {
        Self::from_file(Bytes::copy_of(bytes)?)
    }

    fn from_file(bytes: Bytes) -> Result<Self, FileErrorKind> {
        Self::of_shared(Arc::new(bytes))
    }

    /// The scene in the bytes of a file.
    pub(super) fn of_shared(bytes: Arc<Bytes>) -> Result<Self, FileErrorKind> {
        let length = bytes.len();
        let reader = Reader::new(bytes, 0..length)?;
        if reader.is_streamed() {
            return streamed::scene_of(&reader, 0);
        }
        // What is in levels is looked at when they are asked for; a file that is cut off is refused.
        levels::ranges_of(&reader)?;
        let settings = Self::settings_of(&reader)?;
        let (geometry, placement) = geometry_and_placement(&reader)?;
        let outline = Arc::new(Outline::of_instances(&kept_instances(&geometry, &placement)));
        Ok(Self { geometry: Arc::new(geometry), placement, outline, ..settings })
    }

    /// A scene without voxels, but with all else that a file says.
    pub(super) fn settings_of(reader: &Reader) -> Result<Self, FileErrorKind> {
        let settings = Settings {
            record: *reader.section(b"SETT")?.first().ok_or_else(|| damaged("the settings are missing", 0))?,
            cameras: reader.section(b"CAMS")?.to_vec(),
            lenses: if reader.has(b"LENS") { reader.section(b"LENS")?.to_vec() } else { Vec::new() },
            text: reader.section(b"TEXT")?.to_vec(),
            environment: reader.environment()?,
        };
        let mut scene = Self::empty();
        settings.apply(&mut scene).map_err(|fault| FileErrorKind::Invalid(fault.into()))?;
        scene.georeference = reader.georeference()?;
        Ok(scene)
    }

    /// A hash of everything that a picture of the scene depends on: the same scene has the same hash, packed or opened,
    /// on every machine. The hierarchy over instances is left out, as rays find the same through any; for the trees over emitters stand those that follow
    /// from the emitters alone, as light is the same on average by any.
    pub fn content_hash(&self) -> u64 {
        if self.geometry.is_edited {
            return self.compacted().content_hash();
        }
        let (emitters, light_nodes) = halved(&self.geometry.emitters);
        let (settings, instances) = (Settings::of(self), InstanceRecord::all_of(&self.placement));
        let materials = MaterialRecords::of(&self.geometry.materials);
        let mut hash = Xxh3::new();
        let of_parts = self.geometry.parts.iter().flat_map(|parts| parts.sections());
        let of_normals = self.geometry.normal_section();
        let sections = sections(self, &settings, &instances, &materials)
            .into_iter()
            .filter(|(tag, ..)| tag != b"INOD")
            .map(|section| match &section.0 {
                b"EMIT" => section_of(b"EMIT", &emitters),
                b"LNOD" => section_of(b"LNOD", &light_nodes),
                _ => section,
            });
        for (tag, record_size, bytes) in sections.chain(of_parts).chain(of_normals) {
            hash.update(&tag);
            hash.update(&record_size.to_le_bytes());
            hash.update(&(bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        }
        hash.update(bytemuck::cast_slice(&settings.lenses));
        hash.update(bytemuck::cast_slice(&materials.media));
        for (.., bytes) in settings.environment.iter().flat_map(EnvironmentSections::parts) {
            hash.update(bytes);
        }
        hash.digest()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::walk;
    use glam::{IVec3, Mat3, Vec3};
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::ray::Ray;
    use voxtrace_scene::scene::Scene;
    use voxtrace_scene::transform::Transform;

    /// Few voxels and every kind of record, so that the interpreter Miri gets through them too.
    #[test]
    fn a_scene_that_was_written_is_read_from_memory_traced_and_unpacked() {
        let mut grid = VoxelGrid::new();
        for (at, material) in [([0, 0, 0], 0), ([1, 0, 0], 1), ([40, 3, -5], 2), ([90, 90, 7], 1)] {
            grid.set(IVec3::from(at), material);
        }
        let glow = Material::emissive(Vec3::new(1.0, 0.5, 0.25));
        let materials = vec![Material::diffuse(Vec3::ONE), glow, Material::default()];
        let mut scene = Scene::from_grid("few", grid.clone(), materials);
        let turned = Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z) * 2.0;
        scene.add_instance(grid, Transform { linear: turned, translation: Vec3::new(30.0, 0.5, 1.0) });
        let packed = PackedScene::pack(&scene).unwrap();
        let mut bytes = Vec::new();
        packed.write(&mut bytes).unwrap();
        let opened = PackedScene::from_bytes(&bytes).unwrap();
        bytes.fill(0xff);
        assert_eq!(opened.content_hash(), packed.content_hash());
        assert_eq!(opened.to_scene(), packed.to_scene());
        let rays = [
            Ray::new(Vec3::new(0.5, 0.5, 30.0), Vec3::NEG_Z),
            Ray::new(Vec3::new(-20.0, -9.0, 3.0), Vec3::new(1.0, 0.45, -0.13)),
            Ray::new(Vec3::new(28.5, 1.0, -30.0), Vec3::new(0.01, 0.02, 1.0)),
        ];
        let hits = rays.map(|ray| walk::cast(&opened, &ray));
        assert_eq!(hits, rays.map(|ray| walk::cast(&packed, &ray)));
        assert!(hits.iter().filter(|hit| !hit.is_miss()).all(|hit| opened.material_index(hit) < 3));
        assert!(hits.iter().any(|hit| !hit.is_miss()));
        let table = 64..64 + 32 * 12;
        packed.write(&mut { &mut bytes[..] }).unwrap();
        // Miri takes seconds for the sums of each.
        for at in (0..24).chain(table).step_by(if cfg!(miri) { 67 } else { 5 }) {
            let mut damaged = bytes.clone();
            damaged[at] ^= 0x41;
            assert!(PackedScene::from_bytes(&damaged).is_err(), "byte {at}");
        }
    }
}
