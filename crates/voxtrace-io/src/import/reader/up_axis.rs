//! Triangles and points of a file in which another axis is up.

use glam::DVec3;
use std::ops::Range;
use std::path::Path;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::mesh::source::{SourceColors, TriangleSource};
use voxtrace_voxelize::mesh::{Mesh, UpAxis};
use voxtrace_voxelize::points::source::{ExpectedTile, PointSource, TileFacts, TiledPoints};
use voxtrace_voxelize::points::{Attributes, PointCloud};

/// Triangles turned so that what was along an axis points up.
pub(crate) struct ZUpTriangles {
    source: Box<dyn TriangleSource>,
    up: UpAxis,
    piece: Mesh,
}

impl ZUpTriangles {
    pub fn new(mut source: Box<dyn TriangleSource>, up: UpAxis) -> Self {
        source.frame().make_z_up(up);
        let piece = Mesh { materials: source.frame().materials.clone(), ..Mesh::new("") };
        Self { source, up, piece }
    }
}

impl TriangleSource for ZUpTriangles {
    fn frame(&mut self) -> &mut Mesh {
        self.source.frame()
    }

    fn count(&self) -> u64 {
        self.source.count()
    }

    fn colors(&self) -> SourceColors {
        self.source.colors()
    }

    fn has_uvs(&self) -> bool {
        self.source.has_uvs()
    }

    fn materials(&self) -> Option<Vec<bool>> {
        self.source.materials()
    }

    fn release(&mut self) {
        self.source.release();
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let (turned, up) = (&mut self.piece, self.up);
        self.source.for_each(&mut |piece| {
            turned.clear();
            turned.positions.extend(piece.positions.iter().map(|&position| up.to_z_up(position)));
            turned.colors.extend_from_slice(&piece.colors);
            turned.uvs.extend_from_slice(&piece.uvs);
            turned.material_of.extend_from_slice(&piece.material_of);
            each(turned)
        })
    }
}

/// Points turned so that what was along an axis points up.
pub(crate) struct ZUpPoints {
    source: Box<dyn PointSource>,
    up: UpAxis,
    frame: PointCloud,
}

impl ZUpPoints {
    pub fn new(mut source: Box<dyn PointSource>, up: UpAxis) -> Self {
        let mut frame = source.frame().clone();
        frame.make_z_up(up);
        Self { source, up, frame }
    }
}

impl PointSource for ZUpPoints {
    fn frame(&mut self) -> &mut PointCloud {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.source.count()
    }

    fn attributes(&self) -> Attributes {
        self.source.attributes()
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        let (low, high) = self.source.announced_bounds()?;
        let (a, b) = (self.up.to_z_up_f64(low), self.up.to_z_up_f64(high));
        Some((a.min(b), a.max(b)))
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        let up = self.up;
        self.source.for_each(&mut |piece| {
            let mut turned = piece.clone();
            turned.make_z_up(up);
            each(&turned)
        })?;
        self.follow();
        Ok(())
    }

    fn tiled(&mut self) -> Option<&mut dyn TiledPoints> {
        self.source.tiled().is_some().then_some(self as &mut dyn TiledPoints)
    }
}

impl ZUpPoints {
    /// Takes over the offset and what there is to be said, once they are known.
    fn follow(&mut self) {
        let found = self.source.frame();
        self.frame.offset = DVec3::from_array(self.up.to_z_up_array(found.offset.to_array()));
        self.frame.notes.clone_from(&found.notes);
    }

    /// The files of the source, which has some where anybody asks.
    fn files(&mut self) -> Result<&mut dyn TiledPoints, ImportError> {
        self.source.tiled().ok_or_else(|| ImportError::io(Path::new(""), std::io::ErrorKind::Unsupported.into()))
    }
}

/// What is found out file by file is of the source's own axes, but for the points that are handed out.
impl TiledPoints for ZUpPoints {
    fn points_of_tiles(&mut self) -> Vec<u64> {
        self.files().map(|files| files.points_of_tiles()).unwrap_or_default()
    }

    fn origin(&mut self) -> Result<Option<DVec3>, ImportError> {
        self.files()?.origin()
    }

    fn survey_tile(
        &mut self,
        tile: usize,
        origin: Option<DVec3>,
        each: &mut dyn FnMut(&PointCloud) -> bool,
    ) -> Result<TileFacts, ImportError> {
        let up = self.up;
        self.files()?.survey_tile(tile, origin, &mut |piece| {
            let mut turned = piece.clone();
            turned.make_z_up(up);
            each(&turned)
        })
    }

    /// Scans lie as they are: of those few that are turned, all points are looked at first.
    fn expect(&mut self) -> Result<Option<Vec<ExpectedTile>>, ImportError> {
        Ok(None)
    }

    fn visit_tile(&mut self, tile: usize, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<TileFacts, ImportError> {
        let up = self.up;
        self.files()?.visit_tile(tile, &mut |piece| {
            let mut turned = piece.clone();
            turned.make_z_up(up);
            each(&turned)
        })
    }

    fn learn(&mut self, origin: Option<DVec3>, facts: &[TileFacts]) -> Result<(), ImportError> {
        self.files()?.learn(origin, facts)?;
        self.follow();
        Ok(())
    }

    fn choose(&mut self, tiles: Range<usize>) {
        if let Ok(files) = self.files() {
            files.choose(tiles);
        }
    }
}
