//! Binary PLY clouds larger than memory: vertices are read some at a time.

use super::header::{Element, Encoding, Header};
use super::large::unbounded;
use super::splats;
use super::values::Values;
use super::vertices::{Columns, FullIntensity, append};
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::source::input::Input;
use glam::DVec3;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::points::source::PointSource;
use voxtrace_voxelize::points::{Attributes, PointCloud};

/// Vertices taken at once.
const BATCH: u64 = 1 << 16;

/// The vertices of a binary PLY file without faces.
pub(crate) struct PlyPoints {
    path: PathBuf,
    encoding: Encoding,
    element: Element,
    /// Where the first one begins.
    start: u64,
    has_colors: bool,
    full: FullIntensity,
    frame: PointCloud,
}

impl PlyPoints {
    /// Opens a file, if it is one whose points can be read so: binary, without faces, vertices first and without lists.
    pub fn open(path: &Path) -> Result<Option<Self>, ImportError> {
        let limits = unbounded();
        let mut input = Input::open(path, &limits)?;
        let header = Header::read(&mut input, &limits)?;
        let start = input.offset();
        let has_faces = header.has_faces();
        let has_length = input.remaining().is_some();
        let Some(element) = header.elements.into_iter().next().filter(|element| element.name == "vertex") else {
            return Ok(None);
        };
        // Splats are measured by all of them.
        let is_splats = splats::columns(&element).is_some();
        let has_lists = element.properties.iter().any(|property| property.list.is_some());
        let Some(columns) = Columns::of(&element) else { return Ok(None) };
        if header.encoding == Encoding::Text || has_faces || has_lists || is_splats || !has_length || element.count == 0
        {
            return Ok(None);
        }
        let mut values = Values::new(input, header.encoding);
        values.check_count(&element)?;
        let full = FullIntensity::of_element(&mut values, &element)?;
        let (path, encoding, has_colors) = (path.into(), header.encoding, columns.color.is_some());
        Ok(Some(Self { path, encoding, element, start, has_colors, full, frame: PointCloud::default() }))
    }

    /// Bytes that the cloud would take in memory, while it is read.
    pub fn size_bytes(&self) -> u64 {
        self.element.count * if self.has_colors { 31 } else { 12 }
    }
}

impl PointSource for PlyPoints {
    fn frame(&mut self) -> &mut PointCloud {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.element.count
    }

    fn attributes(&self) -> Attributes {
        Attributes { colors: self.has_colors, ..Attributes::default() }
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        None
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        let limits = unbounded();
        let mut values = Values::new(Input::open_at(&self.path, self.start, &limits)?, self.encoding);
        let (mut local_origin, mut left) = (LocalOrigin::default(), self.element.count);
        while left > 0 {
            let now = left.min(BATCH);
            let mut mesh = Mesh::new("");
            append(&mut values, &Element { count: now, ..self.element.clone() }, &mut local_origin, &mut mesh)?;
            self.full.make_linear(&mut mesh.colors);
            mesh.offset = local_origin.offset();
            self.frame.offset = mesh.offset;
            left -= now;
            if !each(&PointCloud::from_corners(mesh)) {
                break;
            }
        }
        Ok(())
    }
}
