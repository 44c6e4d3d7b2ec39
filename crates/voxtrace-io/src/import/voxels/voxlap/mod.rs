//! Ken Silverman's other formats: `.kvx` of the Build engine (slab6.txt), `.kv6` of Slab6 and Voxlap (voxlap5.txt), and `.vxl`, the maps of Voxlap
//! and of Ace of Spades. All hold columns of the voxels that can be seen; z points down and y to the viewer.

mod kv6;
mod kvx;
mod map;

use crate::import::grids::checked_size;
use crate::import::grids::paints::Paints;
use crate::import::grids::slab::Slabs;
use crate::import::reader::{Kind, Magic, Reader, Voxels};
use glam::IVec3;
use std::path::Path;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of these formats.
pub(crate) const READER: Reader = Reader::new(
    "Voxlap",
    Kind::Voxels,
    &["kv6", "kvx", "vxl"],
    "voxels of Slab6, and .kvx of Build, .vxl: maps of Ace of Spades",
    |source, options| {
        let (path, limits) = (source.path(), &options.limits);
        let is = |extension: &str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(extension));
        let bytes = source.into_bytes()?;
        let file = File { bytes: &bytes, path };
        let read = match () {
            () if bytes.starts_with(kv6::MAGIC) => kv6::read,
            () if bytes.starts_with(&map::MAGIC) || is("vxl") => map::read,
            () if is("kv6") => kv6::read,
            () => kvx::read,
        };
        Ok(read(&file, limits)?.into())
    },
)
.with_magic(&[Magic::first(kv6::MAGIC), Magic::first(&map::MAGIC)])
.with_up_axis(Some(UpAxis::MinusZ));

/// The bytes of a file.
struct File<'a> {
    bytes: &'a [u8],
    path: &'a Path,
}

impl<'a> File<'a> {
    /// So many bytes from a place on.
    fn part(&self, at: usize, count: usize, what: &str) -> Result<&'a [u8], ImportError> {
        let part = at.checked_add(count).and_then(|end| self.bytes.get(at..end));
        part.ok_or_else(|| ImportError::truncated(self.path, self.bytes.len() as u64, what))
    }

    fn array<const N: usize>(&self, at: usize, what: &str) -> Result<[u8; N], ImportError> {
        let mut array = [0; N];
        array.copy_from_slice(self.part(at, N, what)?);
        Ok(array)
    }

    /// A whole number of 32 bits.
    fn word(&self, at: usize, what: &str) -> Result<u32, ImportError> {
        self.array(at, what).map(u32::from_le_bytes)
    }

    fn malformed(&self, at: usize, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.path, at as u64, what)
    }

    /// Three sizes.
    fn size(&self, at: usize, limits: &Limits) -> Result<IVec3, ImportError> {
        let mut size = [0; 3];
        for (axis, edge) in size.iter_mut().enumerate() {
            *edge = self.word(at + 4 * axis, "the sizes")?.into();
        }
        checked_size(self.path, at as u64, size, limits)
    }
}

/// A model in the making, whose voxels come in order along an axis of the file.
struct Model {
    size: IVec3,
    slabs: Slabs,
    paints: Paints,
}

impl Model {
    fn new(file: &File, size: IVec3, axis: usize) -> Result<Self, ImportError> {
        Ok(Self { size, slabs: Slabs::new(file.path, 0, size, axis)?, paints: Paints::default() })
    }

    /// Sets a voxel within the size, by its place in the file.
    fn set(&mut self, [x, y, z]: [i32; 3], color: [u8; 3]) {
        let material = self.paints.material(color);
        self.slabs.set(IVec3::new(x, self.size.y - 1 - y, self.size.z - 1 - z), material);
    }

    fn finish(self) -> Voxels {
        Voxels { scene: Scene::from_grid("", self.slabs.finish(), self.paints.finish()), notes: Vec::new() }
    }
}
