//! Where reports of the driver probes, and thumbnails, are kept: the folder that `VOXTRACE_CACHE` names, else `voxtrace` in the user's cache
//! folder (XDG_CACHE_HOME, ~/.cache, or what the system has instead).

use etcetera::BaseStrategy;
use std::path::PathBuf;
use voxtrace_vulkan::probe::Cache;

/// The cache; `None` where the system tells of no folder.
pub fn cache() -> Option<Cache> {
    folder().map(|folder| Cache::new(&folder))
}

/// The folder of what the program keeps between runs.
pub fn folder() -> Option<PathBuf> {
    let of_user = || etcetera::choose_base_strategy().ok().map(|strategy| strategy.cache_dir().join("voxtrace"));
    let named = std::env::var_os("VOXTRACE_CACHE").filter(|folder| !folder.is_empty()).map(PathBuf::from);
    named.or_else(of_user)
}
