//! Where Open Image Denoise is looked for.

use std::path::{Path, PathBuf};

/// The variable that says where the library is: the file, or a folder that holds it.
pub const VARIABLE: &str = "VOXTRACE_OIDN";

/// Names of the library, the current one first.
#[cfg(windows)]
const NAMES: [&str; 1] = ["OpenImageDenoise.dll"];
#[cfg(target_os = "macos")]
const NAMES: [&str; 2] = ["libOpenImageDenoise.2.dylib", "libOpenImageDenoise.dylib"];
#[cfg(not(any(windows, target_os = "macos")))]
const NAMES: [&str; 2] = ["libOpenImageDenoise.so.2", "libOpenImageDenoise.so"];

/// Folders below `site-packages` in which wheels carry it.
const IN_SITE_PACKAGES: [&str; 2] = ["pyoidn/oidn/lib", "pyoidn/oidn/bin"];

/// Whether the variable says where it is: then it is looked for nowhere else.
pub fn is_named() -> bool {
    std::env::var_os(VARIABLE).is_some_and(|value| !value.is_empty())
}

/// Files to try, in this order, those in the `site-packages` of `packages` before others. A bare name stands for the places where the system looks for libraries.
pub fn places(packages: &[PathBuf]) -> Vec<PathBuf> {
    if let Some(named) = std::env::var_os(VARIABLE).filter(|value| !value.is_empty()) {
        return below(Path::new(&named));
    }
    let mut places: Vec<PathBuf> = packages.iter().flat_map(|folder| in_site_packages(folder)).collect();
    places.extend(NAMES.map(PathBuf::from));
    let folder = |variable: &str| std::env::var_os(variable).map(PathBuf::from);
    let own = std::env::current_exe().ok().and_then(|path| Some(path.parent()?.to_owned()));
    places.extend(own.into_iter().flat_map(|folder| NAMES.map(|name| folder.join(name))));
    let local = folder("HOME").map(|home| home.join(".local"));
    let roots = [folder("VIRTUAL_ENV"), folder("CONDA_PREFIX"), local, Some("/usr/local".into()), Some("/usr".into())];
    for root in roots.into_iter().flatten() {
        places.extend(site_packages(&root).iter().flat_map(|folder| in_site_packages(folder)));
    }
    places
}

/// The library in a folder, or the file itself.
fn below(named: &Path) -> Vec<PathBuf> {
    if !named.is_dir() {
        return vec![named.to_owned()];
    }
    let folders = [named.to_owned(), named.join("lib"), named.join("bin")];
    let mut found: Vec<PathBuf> = folders.iter().flat_map(|folder| NAMES.map(|name| folder.join(name))).collect();
    found.extend(in_site_packages(named));
    found.retain(|path| path.exists());
    // Loading it then says that it is not there.
    if found.is_empty() { vec![named.join(NAMES[0])] } else { found }
}

/// The libraries that wheels have put into a `site-packages`.
fn in_site_packages(folder: &Path) -> Vec<PathBuf> {
    let paths = IN_SITE_PACKAGES.iter().flat_map(|below| NAMES.map(|name| folder.join(below).join(name)));
    paths.filter(|path| path.exists()).collect()
}

/// The `site-packages` of an installation of Python, those of the newest version first.
fn site_packages(root: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(root.join("lib")) else {
        return vec![root.join("Lib/site-packages")];
    };
    let mut versions: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    versions.retain(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("python3")));
    versions.sort();
    let packages = versions.iter().rev();
    packages.flat_map(|version| ["site-packages", "dist-packages"].map(|name| version.join(name))).collect()
}
