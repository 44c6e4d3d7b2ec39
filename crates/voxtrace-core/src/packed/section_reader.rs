//! Reading the sections of a native file, or of a level in it: found by their tags, with their checksums and sizes checked; and the voxels that they make up, checked whole.

use super::bytes::{Access, Bytes};
use super::file::{ALIGNMENT, Header, MAGIC, STREAMED_VERSION, TableEntry};
use super::file_error::{FileErrorKind, damaged};
use super::instance_record::InstanceRecord;
use super::material_records::{MaterialRecords, MediumRecord};
use super::parts::Parts;
use super::settings::EnvironmentSections;
use super::version_1::geometry_of_version_1;
use super::{Geometry, PackedInstance, Placement, Section, coverage, normals};
use bytemuck::Pod;
use std::ops::Range;
use std::sync::Arc;
use voxtrace_scene::Invalid;
use voxtrace_scene::georeference::Georeference;
use xxhash_rust::xxh3::xxh3_64;

/// The voxels of a file or of one of its levels, and where they stand.
pub(super) fn geometry_and_placement(reader: &Reader) -> Result<(Geometry, Placement), FileErrorKind> {
    reader.bytes.expect(Access::FromStartToEnd);
    let has = |tag: &[u8; 4], is_known: fn(&[u32]) -> Result<bool, Invalid>| {
        Ok::<bool, FileErrorKind>(reader.has(tag) && is_known(&reader.section(tag)?).map_err(FileErrorKind::Invalid)?)
    };
    let media = if reader.has(b"MEDI") { reader.section::<MediumRecord>(b"MEDI")?.to_vec() } else { Vec::new() };
    let materials = MaterialRecords::materials(&reader.section(b"MATS")?, &media).map_err(FileErrorKind::Invalid)?;
    let geometry = Geometry {
        grids: reader.section(b"GRID")?,
        materials: materials.into(),
        emitters: reader.section(b"EMIT")?,
        light_nodes: reader.section(b"LNOD")?,
        cells: reader.section(b"CELL")?,
        bricks: reader.section(b"BRIK")?,
        brick_materials: reader.section(b"BMAT")?,
        has_normals: has(b"NORM", normals::is_known_kind)?,
        has_coverage: has(b"COVR", coverage::is_known_kind)?,
        ..Geometry::default()
    };
    let records = reader.section::<InstanceRecord>(b"INST")?;
    let instances: Vec<PackedInstance> = records.iter().map(InstanceRecord::instance).collect();
    let geometry = if reader.version == 1 { geometry_of_version_1(geometry, &instances) } else { Ok(geometry) };
    let geometry = geometry.map_err(FileErrorKind::Invalid)?;
    reader.bytes.expect(Access::InOrder);
    geometry.validate_grids().map_err(FileErrorKind::Invalid)?;
    reader.bytes.expect(Access::HereAndThere);
    geometry.validate_lights().map_err(FileErrorKind::Invalid)?;
    let geometry = geometry.finished();
    let nodes = reader.section(b"INOD")?;
    let placement = Placement::of_file(&geometry, instances, nodes).map_err(FileErrorKind::Invalid)?;
    let geometry = Geometry { parts: reader.parts(&placement)?, ..geometry };
    geometry.validate_parts(&placement).map_err(FileErrorKind::Invalid)?;
    Ok((geometry, placement))
}

/// The version of a file and its table.
fn read_table(bytes: &[u8]) -> Result<(u32, Vec<TableEntry>), FileErrorKind> {
    let start = size_of::<Header>();
    if bytes.len() < start {
        return Err(damaged("the header is cut off", bytes.len() as u64));
    }
    let header: Header = bytemuck::pod_read_unaligned(&bytes[..start]);
    if header.magic != MAGIC {
        return Err(FileErrorKind::NotVoxtrace);
    }
    if !(1..=STREAMED_VERSION).contains(&header.version) {
        return Err(FileErrorKind::Version(header.version));
    }
    let table = (header.section_count as usize)
        .checked_mul(size_of::<TableEntry>())
        .and_then(|size| bytes.get(start..start.checked_add(size)?))
        .ok_or_else(|| damaged("the section table is cut off", bytes.len() as u64))?;
    if xxh3_64(table) != header.table_checksum {
        return Err(damaged("the checksum of the section table does not match", start as u64));
    }
    let entries = table.chunks_exact(size_of::<TableEntry>()).map(bytemuck::pod_read_unaligned);
    Ok((header.version, entries.collect()))
}

/// The sections of a file, or of a level in it.
pub(super) struct Reader {
    bytes: Arc<Bytes>,
    /// Where its first byte is.
    start: usize,
    /// One past its last.
    end: usize,
    version: u32,
    table: Vec<TableEntry>,
}

impl Reader {
    pub fn new(bytes: Arc<Bytes>, Range { start, end }: Range<usize>) -> Result<Self, FileErrorKind> {
        if cfg!(target_endian = "big") {
            return Err(FileErrorKind::Invalid("native files need a little-endian machine".into()));
        }
        let (version, table) = read_table(&bytes[start..end])?;
        Ok(Self { bytes, start, end, version, table })
    }

    /// Where a section is, if there is one, and its checksum, which is not looked at.
    pub fn unchecked_range(&self, tag: &[u8; 4]) -> Result<Option<(Range<usize>, u64)>, FileErrorKind> {
        let Some(entry) = self.table.iter().find(|entry| entry.tag == *tag) else { return Ok(None) };
        let range = usize::try_from(entry.offset).ok().zip(usize::try_from(entry.size).ok());
        let range = range
            .and_then(|(offset, size)| Some((self.start.checked_add(offset)?, size)))
            .and_then(|(start, size)| Some((start, start.checked_add(size)?)))
            .filter(|&(start, end)| end <= self.end && start.is_multiple_of(ALIGNMENT));
        let (start, end) = range.ok_or_else(|| {
            let name = String::from_utf8_lossy(tag);
            damaged(format!("section {name} goes beyond the end of the file, or is misaligned"), entry.offset)
        })?;
        Ok(Some((start..end, entry.checksum)))
    }

    /// Whether it is a file for streaming, whose sections are others.
    pub fn is_streamed(&self) -> bool {
        self.version == STREAMED_VERSION
    }

    /// Some of its bytes.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn bytes(&self, range: Range<usize>) -> &[u8] {
        &self.bytes[range]
    }

    /// Whether there is a section that files may do without.
    pub fn has(&self, tag: &[u8; 4]) -> bool {
        self.table.iter().any(|entry| entry.tag == *tag)
    }

    pub fn georeference(&self) -> Result<Option<Georeference>, FileErrorKind> {
        if !self.has(b"GEOR") {
            return Ok(None);
        }
        let invalid = |what: &str| FileErrorKind::Invalid(what.into());
        let matrix = self.section::<[f64; 12]>(b"GEOR")?;
        let crs = String::from_utf8(self.section(b"GCRS")?.to_vec());
        let crs = crs.map_err(|_| invalid("the reference system is not UTF-8"))?;
        let matrix = *matrix.first().ok_or_else(|| invalid("the georeference is empty"))?;
        let found = Georeference::from_array(matrix, crs);
        found.map(Some).ok_or_else(|| invalid("the georeference is not finite or flat"))
    }

    pub fn environment(&self) -> Result<Option<EnvironmentSections>, FileErrorKind> {
        if !self.has(b"ENVI") {
            return Ok(None);
        }
        let record = self.section(b"ENVI")?.first().copied();
        let record = record.ok_or_else(|| FileErrorKind::Invalid("the environment is empty".into()))?;
        Ok(Some(EnvironmentSections { record, texels: self.section(b"ENVT")? }))
    }

    /// What a merged grid was made of, which still has to be checked.
    pub fn parts(&self, placement: &Placement) -> Result<Option<Arc<Parts>>, FileErrorKind> {
        if !self.has(b"PART") {
            return Ok(None);
        }
        let owners = (self.section(b"POWN")?, self.section(b"PSHR")?);
        let parts = Parts::of_file(self.section(b"PART")?, owners, self.section(b"PCOV")?, placement);
        parts.map(|parts| Some(Arc::new(parts))).map_err(FileErrorKind::Invalid)
    }

    pub fn section<T: Pod>(&self, tag: &[u8; 4]) -> Result<Section<T>, FileErrorKind> {
        let Range { start, end } = self.sound_range(tag, size_of::<T>())?;
        let section = Section::from_shared(self.bytes.clone(), start, end);
        section.ok_or_else(|| section_fault(tag, "is misaligned", start as u64))
    }

    /// Where the records of a section lie, which have this size and the section's checksum.
    fn sound_range(&self, tag: &[u8; 4], record_size: usize) -> Result<Range<usize>, FileErrorKind> {
        let missing = || section_fault(tag, "is missing", size_of::<Header>() as u64);
        let entry = self.table.iter().find(|entry| entry.tag == *tag).ok_or_else(missing)?;
        let fault = |what: &str| section_fault(tag, what, entry.offset);
        if entry.record_size as usize != record_size {
            return Err(fault("has records of another size"));
        }
        let (range, _) = self.unchecked_range(tag)?.ok_or_else(|| fault("is missing"))?;
        if xxh3_64(&self.bytes[range.clone()]) != entry.checksum {
            return Err(fault("has a wrong checksum"));
        }
        Ok(range)
    }
}

fn section_fault(tag: &[u8; 4], what: &str, offset: u64) -> FileErrorKind {
    damaged(format!("section {} {what}", String::from_utf8_lossy(tag)), offset)
}
