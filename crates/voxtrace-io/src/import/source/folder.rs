//! Files beside a file: a name in a scene is looked for under the scene's own folder and nowhere else, whatever it says.

use super::opened;
use super::watch::Watch;
#[cfg(feature = "mesh")]
use super::watch::Watched;
use std::fs::File;
use std::io::Read;
use std::path::{Component, Path, PathBuf};
use voxtrace_voxelize::Limits;

/// The folder of a scene, if it has one: scenes in memory have none.
pub(crate) struct Folder {
    root: Option<PathBuf>,
    limit: u64,
}

/// Why a file beside a scene is not read.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Refused {
    /// The name leads out of the folder.
    #[error("{0:?} leads out of the scene's folder")]
    Outside(String),
    /// The scene is in memory.
    #[error("{0:?} lies in another file, but the scene is in memory")]
    NoFolder(String),
    /// The file is larger than allowed.
    #[error("{name:?} has more than the allowed {limit} bytes")]
    TooLong { name: String, limit: u64 },
    /// The operating system refused.
    #[error("{name:?}: {error}")]
    Io { name: String, error: std::io::Error },
}

impl Folder {
    /// The folder that holds `file`.
    pub fn of(file: &Path, limits: &Limits) -> Self {
        let parent = file.parent().unwrap_or(Path::new(""));
        let root = if parent.as_os_str().is_empty() { Path::new(".") } else { parent };
        Self { root: Some(root.into()), limit: limits.bytes }
    }

    /// A folder by its own path.
    pub fn at(folder: &Path, limits: &Limits) -> Self {
        Self { root: Some(folder.into()), limit: limits.bytes }
    }

    /// No folder: every name is refused.
    pub fn none() -> Self {
        Self { root: None, limit: 0 }
    }

    /// Reads the file that a URI names: percent signs are decoded first, and only then is the path judged.
    pub fn read_uri(&self, uri: &str) -> Result<Vec<u8>, Refused> {
        let outside = || Refused::Outside(uri.into());
        let name = percent_decoded(uri).ok_or_else(outside)?;
        if has_scheme(&name) {
            return Err(outside());
        }
        self.read(&name)
    }

    /// Where the file lies that a URI names, judged as by [`Self::read_uri`].
    #[cfg(feature = "mesh")]
    pub fn path_of_uri(&self, uri: &str) -> Result<PathBuf, Refused> {
        let outside = || Refused::Outside(uri.into());
        let name = percent_decoded(uri).filter(|name| !has_scheme(name)).ok_or_else(outside)?;
        self.path_of(&name)
    }

    /// Opens the file that a URI names, judged as by [`Self::read_uri`], and says how many bytes it has; `None` where it is no plain file, which can be
    /// read but once.
    #[cfg(feature = "mesh")]
    pub fn open_uri(&self, uri: &str) -> Result<Option<(Watched<File>, u64)>, Refused> {
        let io = |error| Refused::Io { name: uri.into(), error };
        let path = self.path_of_uri(uri)?;
        if !std::fs::metadata(&path).map_err(io)?.is_file() {
            return Ok(None);
        }
        let file = File::open(&path).map_err(io)?;
        let length = file.metadata().map_err(io)?.len();
        if length > self.limit {
            return Err(Refused::TooLong { name: uri.into(), limit: self.limit });
        }
        Ok(Some((Watched { inner: file, watch: Watch::of_thread() }, length)))
    }

    /// Reads the file of a relative path; both slashes separate folders.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, Refused> {
        let io = |error| Refused::Io { name: name.into(), error };
        let mut bytes = Vec::new();
        let (file, _) = self.open(name)?;
        file.take(self.limit.saturating_add(1)).read_to_end(&mut bytes).map_err(io)?;
        if bytes.len() as u64 > self.limit {
            return Err(Refused::TooLong { name: name.into(), limit: self.limit });
        }
        Ok(bytes)
    }

    /// Opens the file of a relative path, and says where it is.
    pub fn open(&self, name: &str) -> Result<(File, PathBuf), Refused> {
        let path = self.path_of(name)?;
        let file = File::open(&path).map_err(|error| Refused::Io { name: name.into(), error })?;
        Ok((file, path))
    }

    /// Where the file of a relative path lies: in the folder, also behind links.
    fn path_of(&self, name: &str) -> Result<PathBuf, Refused> {
        let outside = || Refused::Outside(name.into());
        let relative = within(name).ok_or_else(outside)?;
        let root = self.root.as_ref().ok_or_else(|| Refused::NoFolder(name.into()))?;
        let io = |error| Refused::Io { name: name.into(), error };
        Watch::of_thread().check().map_err(io)?;
        opened::note(&root.join(&relative));
        // A link inside the folder may not lead out of it either.
        let real_root = root.canonicalize().map_err(io)?;
        let path = root.join(relative).canonicalize().map_err(io)?;
        if !path.starts_with(real_root) {
            return Err(outside());
        }
        Ok(path)
    }
}

/// The path below a folder that `name` says, `None` where it is absolute or climbs.
fn within(name: &str) -> Option<PathBuf> {
    let name = name.replace('\\', "/");
    let is_drive = name.as_bytes().get(1) == Some(&b':');
    if name.is_empty() || name.starts_with('/') || is_drive || name.contains('\0') {
        return None;
    }
    let path = PathBuf::from(name);
    path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)).then_some(path)
}

/// Whether a name begins as a URI with a scheme does (RFC 3986, section 3.1).
fn has_scheme(name: &str) -> bool {
    name.split_once(':').is_some_and(|(scheme, _)| {
        scheme.starts_with(|c: char| c.is_ascii_alphabetic())
            && scheme.chars().all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c))
    })
}

/// Text with its %xx decoded (RFC 3986, section 2.1), `None` where that is no UTF-8 or ends in the middle.
fn percent_decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        if *first == b'%' {
            let digits = std::str::from_utf8(rest.get(..2)?).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok().filter(|_| !digits.starts_with('+'))?);
            rest = &rest[2..];
        } else {
            bytes.push(*first);
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lead_out_of_the_folder_are_refused_in_every_spelling() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("scene");
        std::fs::create_dir_all(inner.join("textures")).unwrap();
        std::fs::write(outer.path().join("secret"), "secret").unwrap();
        std::fs::write(inner.join("textures/a b.png"), "picture").unwrap();
        let folder = Folder::of(&inner.join("scene.gltf"), &Limits::default());

        for good in ["textures/a b.png", "textures/a%20b.png", "./textures/a%20b.png", "textures\\a b.png"] {
            assert_eq!(folder.read_uri(good).unwrap(), b"picture", "{good}");
        }
        let absolute = outer.path().join("secret").display().to_string();
        let file = format!("file://{absolute}");
        for bad in [
            "../secret",
            "..\\secret",
            "%2e%2e/secret",
            "%2E%2E%2Fsecret",
            "textures/../../secret",
            "textures/%2e%2e/%2e%2e/secret",
            absolute.as_str(),
            file.as_str(),
            "FILE:secret",
            "http://localhost/secret",
            "C:/secret",
            "",
            "%",
            "%zz",
            "a%00b",
        ] {
            assert!(matches!(folder.read_uri(bad), Err(Refused::Outside(_))), "{bad}");
        }
        assert!(matches!(folder.read_uri("missing"), Err(Refused::Io { .. })));
        assert!(matches!(Folder::none().read_uri("a.png"), Err(Refused::NoFolder(_))));
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_folder_is_refused() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("scene");
        std::fs::create_dir(&inner).unwrap();
        std::fs::write(outer.path().join("secret"), "secret").unwrap();
        std::os::unix::fs::symlink("../secret", inner.join("link")).unwrap();
        let folder = Folder::of(&inner.join("scene.gltf"), &Limits::default());
        assert!(matches!(folder.read("link"), Err(Refused::Outside(_))));
    }

    #[test]
    fn a_file_beyond_the_limit_is_refused() {
        let outer = tempfile::tempdir().unwrap();
        std::fs::write(outer.path().join("five"), "12345").unwrap();
        let limits = Limits { bytes: 4, ..Limits::default() };
        let folder = Folder::of(&outer.path().join("scene.obj"), &limits);
        assert!(matches!(folder.read("five"), Err(Refused::TooLong { limit: 4, .. })));
    }
}
