//! What to install where Vulkan is missing: for the system that this is, and what of it is not there.

use std::path::Path;

/// The system, as far as it matters to what is installed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct System {
    /// As in `std::env::consts::OS`.
    pub os: String,
    /// `ID` and `ID_LIKE` of `/etc/os-release`, on Linux.
    pub distribution: String,
    /// Whether this is a container.
    pub is_container: bool,
    /// PCI numbers of the makers of the graphics cards that the kernel knows.
    pub vendors: Vec<u32>,
    /// Whether Mesa's drivers are installed.
    pub has_mesa: bool,
}

/// PCI number of NVIDIA.
const NVIDIA: u32 = 0x10de;

/// What of Vulkan is missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The loader.
    Loader,
    /// A driver, or a device that one finds.
    Driver,
}

impl System {
    /// This one, with the libraries of the drivers that are installed.
    pub fn this<'a>(libraries: impl Iterator<Item = &'a str>) -> Self {
        let release = std::fs::read_to_string("/etc/os-release").unwrap_or_default();
        let is_container = ["/.dockerenv", "/run/.containerenv"].iter().any(|path| Path::new(path).exists());
        Self {
            os: std::env::consts::OS.into(),
            distribution: distribution(&release),
            is_container,
            vendors: vendors(Path::new("/sys/class/drm")),
            has_mesa: has_mesa(libraries),
        }
    }

    /// What to do, one line each.
    pub fn remedies(&self, missing: Missing) -> Vec<String> {
        match self.os.as_str() {
            "windows" => vec![
                "the graphics driver of AMD, Intel or NVIDIA brings everything; Windows' own basic driver has no Vulkan".into(),
            ],
            "macos" => {
                vec!["brew install vulkan-loader molten-vk (compute walk only; without it the CPU traces)".into()]
            }
            "linux" => self.on_linux(missing),
            _ => vec!["a Vulkan loader, and the driver of the graphics card".into()],
        }
    }

    fn on_linux(&self, missing: Missing) -> Vec<String> {
        let has_nvidia = self.vendors.contains(&NVIDIA);
        // Where no card is known, either driver may be meant.
        let (may_be_mesa, wants_nvidia) =
            (!has_nvidia || self.vendors.len() > 1, has_nvidia || self.vendors.is_empty());
        let wants_mesa = may_be_mesa && !self.has_mesa;
        let is = |names: &[&str]| self.distribution.split_whitespace().any(|name| names.contains(&name));
        let (install, loader, mesa, nvidia) = if is(&["debian", "ubuntu"]) {
            ("sudo apt install", "libvulkan1", "mesa-vulkan-drivers", "nvidia-driver, on Ubuntu nvidia-driver-NNN")
        } else if is(&["fedora", "rhel"]) {
            ("sudo dnf install", "vulkan-loader", "mesa-vulkan-drivers", "akmod-nvidia from RPM Fusion")
        } else if is(&["arch"]) {
            ("sudo pacman -S", "vulkan-icd-loader", "vulkan-radeon or vulkan-intel", "nvidia-utils")
        } else if is(&["suse", "opensuse"]) {
            ("sudo zypper install", "libvulkan1", "Mesa-vulkan-drivers", "the drivers of NVIDIA's own repository")
        } else {
            ("install", "the Vulkan loader", "Mesa's Vulkan drivers", "NVIDIA's driver")
        };
        let loader = (missing == Missing::Loader).then_some(loader);
        let packages: Vec<&str> = loader.into_iter().chain(wants_mesa.then_some(mesa)).collect();
        let mut lines = Vec::new();
        if !packages.is_empty() {
            let whose = if wants_mesa { " (AMD, Intel, software)" } else { "" };
            lines.push(format!("{install} {}{whose}", packages.join(" ")));
        }
        if wants_nvidia {
            let card = if has_nvidia { "NVIDIA" } else { "for a card of NVIDIA" };
            lines.push(format!("{card}: the package {nvidia}"));
        }
        if self.vendors.is_empty() && missing == Missing::Driver {
            lines.insert(0, "the kernel knows no graphics card".into());
        }
        if self.is_container {
            let nvidia = if wants_nvidia { ", and for NVIDIA set NVIDIA_DRIVER_CAPABILITIES=all" } else { "" };
            lines.push(format!("this is a container: pass the GPU through{nvidia}"));
        }
        lines
    }
}

/// Whether libraries of drivers are Mesa's for a card.
fn has_mesa<'a>(mut libraries: impl Iterator<Item = &'a str>) -> bool {
    libraries.any(|library| ["libvulkan_radeon", "libvulkan_intel"].iter().any(|name| library.contains(name)))
}

/// The names of a distribution and of those that it is like.
fn distribution(release: &str) -> String {
    let value = |name: &str| {
        let line = release.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('='))?;
        Some(line.trim().trim_matches('"').to_owned())
    };
    [value("ID"), value("ID_LIKE")].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// The makers of the cards below a folder of the kernel's.
fn vendors(folder: &Path) -> Vec<u32> {
    let vendor = |entry: std::fs::DirEntry| {
        let text = std::fs::read_to_string(entry.path().join("device/vendor")).ok()?;
        u32::from_str_radix(text.trim().strip_prefix("0x")?, 16).ok()
    };
    let mut all: Vec<u32> = std::fs::read_dir(folder).into_iter().flatten().flatten().filter_map(vendor).collect();
    all.sort_unstable();
    all.dedup();
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linux(distribution: &str, vendors: &[u32]) -> System {
        System {
            os: "linux".into(),
            distribution: distribution.into(),
            is_container: false,
            vendors: vendors.into(),
            has_mesa: false,
        }
    }

    #[test]
    fn only_what_is_missing_on_this_system_is_named() {
        const AMD: u32 = 0x1002;
        let debian = linux("debian", &[AMD]).remedies(Missing::Loader);
        assert_eq!(debian, ["sudo apt install libvulkan1 mesa-vulkan-drivers (AMD, Intel, software)"]);
        let driver = linux("ubuntu debian", &[AMD]).remedies(Missing::Driver);
        assert_eq!(driver, ["sudo apt install mesa-vulkan-drivers (AMD, Intel, software)"]);
        let nvidia = linux("fedora", &[NVIDIA]).remedies(Missing::Driver);
        assert_eq!(nvidia, ["NVIDIA: the package akmod-nvidia from RPM Fusion"]);
        assert_eq!(linux("arch", &[AMD, NVIDIA]).remedies(Missing::Driver).len(), 2);
        // What is there already is not named.
        let has_mesa = has_mesa(["libGLX_nvidia.so.0", "/usr/lib/libvulkan_radeon.so"].into_iter());
        assert_eq!(System { has_mesa, ..linux("debian", &[AMD]) }.remedies(Missing::Driver), [] as [String; 0]);
        let none = System { has_mesa, ..linux("debian", &[]) }.remedies(Missing::Driver);
        assert!(none.len() == 2 && none[0] == "the kernel knows no graphics card", "{none:?}");
        let inside = System { is_container: true, ..linux("debian", &[]) }.remedies(Missing::Loader);
        assert!(inside.len() == 3 && inside[2].contains("NVIDIA_DRIVER_CAPABILITIES"), "{inside:?}");
        for (os, word) in [("windows", "Windows"), ("macos", "brew"), ("freebsd", "loader")] {
            let said = System { os: os.into(), ..System::default() }.remedies(Missing::Loader);
            assert!(said.len() == 1 && said[0].contains(word), "{said:?}");
            // Nothing of other systems.
            assert!(!said[0].contains("apt"), "{said:?}");
        }
    }

    #[test]
    fn what_linux_says_of_itself_is_read() {
        let release = "PRETTY_NAME=\"Linux Mint\"\nID=linuxmint\nID_LIKE=\"ubuntu debian\"\n";
        assert_eq!(distribution(release), "linuxmint ubuntu debian");
        assert_eq!(distribution(""), "");
        let folder = tempfile::tempdir().unwrap();
        for (card, vendor) in
            [("card0", "0x10de\n"), ("card1", "0x1002\n"), ("renderD128", "0x10de\n"), ("version", "")]
        {
            std::fs::create_dir_all(folder.path().join(card).join("device")).unwrap();
            std::fs::write(folder.path().join(card).join("device/vendor"), vendor).unwrap();
        }
        assert_eq!(vendors(folder.path()), [0x1002, 0x10de]);
        assert_eq!(vendors(&folder.path().join("none")), [] as [u32; 0]);
    }
}
