//! The manifests by which Vulkan's loader finds drivers, where it looks for them on Linux (Khronos: "Vulkan Loader and Driver
//! Interface", driver discovery). Elsewhere only those that the variables name.

use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// A driver's manifest.
pub struct Manifest {
    pub path: PathBuf,
    /// The driver's library.
    pub library: Option<String>,
    /// Why the loader cannot use it.
    pub fault: Option<String>,
}

impl Manifest {
    fn read(path: PathBuf) -> Self {
        let fault = |fault: String| Self { path: path.clone(), library: None, fault: Some(fault) };
        voxtrace::import::opened::note(&path);
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) => return fault(crate::reason::reason(&error)),
        };
        let Ok(value) = serde_json::from_str::<Value>(&text) else { return fault("it is no JSON".into()) };
        let Some(library) = value["ICD"]["library_path"].as_str().map(str::to_owned) else {
            return fault("it names no library".into());
        };
        // A name without a folder is the linker's to find; a relative one counts from the manifest.
        let beside = path.parent().unwrap_or(Path::new("")).join(&library);
        let is_gone = library.contains('/') && !beside.exists();
        Self { fault: is_gone.then(|| format!("{library} is not there")), library: Some(library), path }
    }

    pub fn to_json(&self) -> Value {
        // A path may be no Unicode, which JSON has to be.
        json!({ "manifest": self.path.display().to_string(), "library": self.library, "fault": self.fault })
    }
}

/// The variable that is set, even to nothing, and whose manifests stand for all that are installed.
pub fn variable() -> Option<&'static str> {
    ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"].into_iter().find(|name| std::env::var_os(name).is_some())
}

/// All that the loader would look at, in its order.
pub fn found() -> Vec<Manifest> {
    let mut paths = match variable().and_then(std::env::var_os) {
        Some(named) => std::env::split_paths(&named).flat_map(named_by).collect(),
        None => folders().iter().flat_map(|folder| in_folder(folder)).collect::<Vec<_>>(),
    };
    if let Some(more) = std::env::var_os("VK_ADD_DRIVER_FILES") {
        paths.extend(std::env::split_paths(&more).flat_map(named_by));
    }
    let mut seen = std::collections::BTreeSet::new();
    paths.retain(|path| seen.insert(path.clone()));
    paths.into_iter().map(Manifest::read).collect()
}

fn folders() -> Vec<PathBuf> {
    if !cfg!(target_os = "linux") {
        return Vec::new();
    }
    let of = |name: &str, default: &str| {
        let value = std::env::var(name).ok().filter(|value| !value.is_empty());
        std::env::split_paths(&value.unwrap_or_else(|| default.into())).collect::<Vec<_>>()
    };
    let home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    let under = |tail: &str| home.join(tail).display().to_string();
    let mut all = of("XDG_CONFIG_HOME", &under(".config"));
    all.extend(of("XDG_CONFIG_DIRS", "/etc/xdg"));
    all.extend(["/usr/local/etc", "/etc"].map(PathBuf::from));
    all.extend(of("XDG_DATA_HOME", &under(".local/share")));
    all.extend(of("XDG_DATA_DIRS", "/usr/local/share:/usr/share"));
    all.into_iter().map(|folder| folder.join("vulkan/icd.d")).collect()
}

/// The manifests that a path in a variable stands for: itself, also where it is not there, or all in the folder.
fn named_by(path: PathBuf) -> Vec<PathBuf> {
    match path.is_dir() {
        true => in_folder(&path),
        false => Some(path).filter(|path| !path.as_os_str().is_empty()).into_iter().collect(),
    }
}

/// The manifests in a folder, none where it is not there.
fn in_folder(folder: &Path) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    all.sort();
    all
}
