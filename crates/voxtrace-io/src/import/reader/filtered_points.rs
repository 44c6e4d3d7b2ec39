//! Those points of a file larger than memory that are asked for, where the reader of the file takes all.

use super::point_filter::{ClassSet, PointFilter, none_left, on_map};
use glam::{DAffine3, DVec3};
use std::path::{Path, PathBuf};
use voxtrace_voxelize::points::source::PointSource;
use voxtrace_voxelize::points::{Attributes, PointCloud};
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// The points of a source that are asked for.
pub(crate) struct FilteredPoints {
    source: Box<dyn PointSource>,
    path: PathBuf,
    filter: PointFilter,
}

impl FilteredPoints {
    /// `path` names the source in errors.
    pub fn new(source: Box<dyn PointSource>, path: &Path, filter: PointFilter) -> Self {
        Self { source, path: path.into(), filter }
    }
}

impl PointSource for FilteredPoints {
    fn frame(&mut self) -> &mut PointCloud {
        self.source.frame()
    }

    fn count(&self) -> u64 {
        self.source.count()
    }

    fn attributes(&self) -> Attributes {
        self.source.attributes()
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        self.source.announced_bounds()
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        let (mut count, mut kept, mut goes_on) = (0, 0, true);
        let (map_from_cloud, filter): (DAffine3, PointFilter) = (self.source.frame().crs_from_cloud, self.filter);
        let mut classes = ClassSet::default();
        self.source.for_each(&mut |piece| {
            count += piece.positions.len() as u64;
            piece.classes.iter().for_each(|&class| classes.insert(class));
            let mut piece = piece.clone();
            filter.retain(&mut piece, map_from_cloud);
            kept += piece.positions.len() as u64;
            goes_on = piece.positions.is_empty() || each(&piece);
            goes_on
        })?;
        if kept == 0 && count > 0 && goes_on {
            let span = self.source.announced_bounds().map(|bounds| on_map(bounds, map_from_cloud));
            let what = match filter.classes {
                Some(_) if classes.is_empty() => "the points have no classes to choose by".into(),
                _ => none_left(count, span, classes),
            };
            return Err(ImportError::of_file(&self.path, ImportErrorKind::NothingChosen(what)));
        }
        Ok(())
    }
}
