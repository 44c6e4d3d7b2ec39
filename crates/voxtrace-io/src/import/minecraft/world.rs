//! The folder of a world: all its regions in one scene.

use super::build::{self, is_damage};
use super::region;
use crate::import::reader::{ImportOptions, Voxels};
use crate::import::source::folder::Folder;
use crate::import::source::input::{Input, beyond};
use glam::IVec2;
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Where a world has the regions of its first dimension: since 26.1, and before.
const REGIONS: [&str; 2] = ["dimensions/minecraft/overworld/region", "region"];
/// Most regions that a world may reach along x or z: 2¹⁹ blocks.
const FARTHEST: i32 = 1023;

/// Where a region lies by its file's name, `r.X.Z.mca` (`.mcr` before 1.2): (x, z) in regions.
pub(super) fn place_of(path: &Path) -> Option<IVec2> {
    let name = path.file_name()?.to_str()?;
    let name = name.strip_prefix("r.")?;
    let (x, z) = name.strip_suffix(".mca").or_else(|| name.strip_suffix(".mcr"))?.split_once('.')?;
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
    let inner = REGIONS.map(|inner| folder.join(inner)).into_iter().filter(|inner| inner.is_dir());
    let mut found = Vec::new();
    for folder in inner.chain([folder.to_path_buf()]) {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            if let Some(place) = place_of(&path) {
                found.push((place, path));
            }
        }
        // One of them may be there and empty.
        if !found.is_empty() {
            break;
        }
    }
    // A world that was brought to 1.2 keeps its old files beside the new ones.
    if found.iter().any(|(_, path)| path.extension().is_some_and(|extension| extension == "mca")) {
        found.retain(|(_, path)| path.extension().is_some_and(|extension| extension == "mca"));
    }
    found.sort_by_key(|(place, _)| (place.y, place.x));
    Ok(found)
}

/// Reads all regions of a world's folder.
pub(super) fn read_world(folder: &Path, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let limits = &options.limits;
    let regions = regions(folder).map_err(|error| ImportError::io(folder, error))?;
    let places = || regions.iter().map(|(place, _)| *place);
    let (Some(min), Some(max)) = (places().reduce(IVec2::min), places().reduce(IVec2::max)) else {
        let kind = ImportErrorKind::Unsupported("a folder without regions (r.X.Z.mca)".into());
        return Err(ImportError::of_file(folder, kind));
    };
    if (max - min).max_element() > FARTHEST {
        let far = u64::from((max - min).max_element().unsigned_abs());
        return Err(beyond(folder, None, "regions along an axis", far + 1, FARTHEST as u64 + 1));
    }
    let (mut scene, mut blocks) = (Scene::new(""), build::blocks(options)?);
    let (mut count, mut faults) = (0, Vec::new());
    for (place, path) in &regions {
        let input = Input::open(path, limits)?;
        let grid = match region::read(input, &Folder::of(path, limits), options, *place, min, &mut blocks) {
            Err(error) if is_damage(&error) && !options.strict => {
                faults.push(error);
                continue;
            }
            other => other?,
        };
        count += grid.count();
        if count > limits.voxels {
            return Err(ImportError::limit(path, None, "voxels", count, limits.voxels));
        }
        if !grid.is_empty() {
            scene.add_instance(grid, Transform::IDENTITY);
        }
    }
    let left_out = faults.len();
    if let Some(fault) = faults.into_iter().next() {
        if left_out == regions.len() {
            return Err(fault);
        }
        blocks.notes.push(format!("{left_out} of the {} regions are left out: {fault}", regions.len()));
    }
    Ok(blocks.finish(scene))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_world_has_its_regions_where_its_version_puts_them() {
        for inner in REGIONS {
            let folder = tempfile::tempdir().unwrap();
            std::fs::create_dir_all(folder.path().join(inner)).unwrap();
            assert!(!holds_regions(folder.path()), "{inner}");
            std::fs::write(folder.path().join(inner).join("r.0.-1.mca"), []).unwrap();
            assert!(holds_regions(folder.path()) && holds_regions(&folder.path().join(inner)), "{inner}");
            assert_eq!(regions(folder.path()).unwrap()[0].0, IVec2::new(0, -1));
        }
    }

    #[test]
    fn a_region_is_placed_by_its_name() {
        let place = |name: &str| place_of(Path::new(name)).map(|place| place.to_array());
        assert_eq!(place("world/region/r.-3.12.mca"), Some([-3, 12]));
        assert_eq!(place("r.0.-1.mcr"), Some([0, -1]));
        for other in ["r.1.mca", "r.1.2.mcx", "x.1.2.mca", "r.1.2.3.mca", "r.99999999.0.mca"] {
            assert_eq!(place(other), None, "{other}");
        }
    }
}
