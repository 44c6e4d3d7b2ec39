//! The folder of a world: all its regions in one scene.

use super::palette::Palette;
use super::region;
use crate::import::reader::Voxels;
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use glam::IVec2;
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Most regions that a world may reach along x or z: 2¹⁹ blocks.
const FARTHEST: i32 = 1023;

/// Where a region lies by its file's name, `r.X.Z.mca`: (x, z) in regions.
pub(super) fn place_of(path: &Path) -> Option<IVec2> {
    let name = path.file_name()?.to_str()?;
    let (x, z) = name.strip_prefix("r.")?.strip_suffix(".mca")?.split_once('.')?;
    let place = IVec2::new(x.parse().ok()?, z.parse().ok()?);
    // A world ends at 30 million blocks.
    let end = IVec2::splat(60_000);
    (place.cmple(end) & place.cmpge(-end)).all().then_some(place)
}

/// Whether a folder is a world, or the folder of its regions.
pub(super) fn holds_regions(folder: &Path) -> bool {
    regions(folder).is_ok_and(|regions| !regions.is_empty())
}

/// The regions of a world, by z, then x.
fn regions(folder: &Path) -> std::io::Result<Vec<(IVec2, PathBuf)>> {
    let inner = folder.join("region");
    let folder = if inner.is_dir() { &inner } else { folder };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if let Some(place) = place_of(&path) {
            found.push((place, path));
        }
    }
    found.sort_by_key(|(place, _)| (place.y, place.x));
    Ok(found)
}

/// Reads all regions of a world's folder.
pub(super) fn read_world(folder: &Path, limits: &Limits) -> Result<Voxels, ImportError> {
    let regions = regions(folder).map_err(|error| ImportError::io(folder, error))?;
    let places = || regions.iter().map(|(place, _)| *place);
    let (Some(min), Some(max)) = (places().reduce(IVec2::min), places().reduce(IVec2::max)) else {
        let kind = ImportErrorKind::Unsupported("a folder without regions (r.X.Z.mca)".into());
        return Err(ImportError::of_file(folder, kind));
    };
    if (max - min).max_element() > FARTHEST {
        let far = u64::from((max - min).max_element().unsigned_abs());
        return Err(ImportError::limit(folder, None, "regions along an axis", far + 1, FARTHEST as u64 + 1));
    }
    let (mut scene, mut palette) = (Scene::new(""), Palette::default());
    let mut count = 0;
    for (place, path) in &regions {
        let input = Input::open(path, limits)?;
        let grid = region::read(input, &Folder::of(path, limits), limits, *place, min, &mut palette)?;
        count += grid.count();
        if count > limits.voxels {
            return Err(ImportError::limit(path, None, "voxels", count, limits.voxels));
        }
        if !grid.is_empty() {
            scene.add_instance(grid, Transform::IDENTITY);
        }
    }
    Ok(palette.finish(scene))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_is_placed_by_its_name() {
        let place = |name: &str| place_of(Path::new(name)).map(|place| place.to_array());
        assert_eq!(place("world/region/r.-3.12.mca"), Some([-3, 12]));
        for other in ["r.1.mca", "r.1.2.mcr", "x.1.2.mca", "r.1.2.3.mca", "r.99999999.0.mca"] {
            assert_eq!(place(other), None, "{other}");
        }
    }
}
