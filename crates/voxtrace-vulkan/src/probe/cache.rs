//! Reports that are kept: one file for each device, driver and version of the probes, in the user's cache folder. What does not
//! fit or cannot be read is not there.

use super::report::ProbeReport;
use super::{Effort, PROBE_VERSION};
use crate::capabilities::DeviceInfo;
use std::io;
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::write_atomically;

/// The folder of reports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cache {
    folder: PathBuf,
}

/// What the cache knows about a device.
#[derive(Clone, Debug, PartialEq)]
pub enum Cached {
    /// Its report.
    Report(Box<ProbeReport>),
    /// Nothing.
    Nothing,
    /// A file that is of no use, and why; it counts as nothing.
    Unusable(String),
}

impl Cached {
    /// The report.
    pub fn report(self) -> Option<ProbeReport> {
        match self {
            Self::Report(report) => Some(*report),
            Self::Nothing | Self::Unusable(_) => None,
        }
    }
}

impl Cache {
    /// A cache in this folder, which is made when something is stored.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf() }
    }

    /// Where the reports of a device lie.
    pub fn path(&self, info: &DeviceInfo) -> PathBuf {
        // Names may hold anything; FNV-1a of everything that a report depends on (Fowler, Noll, Vo).
        let key = format!("{}\n{}\n{}\n{PROBE_VERSION}", info.name, info.driver, info.api_version);
        let hash = key
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
        self.folder.join(format!("probes-{hash:016x}.json"))
    }

    /// What is known about a device.
    pub fn load(&self, info: &DeviceInfo) -> Cached {
        let path = self.path(info);
        let unusable = |why: String| Cached::Unusable(format!("{} is ignored: {why}", path.display()));
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Cached::Nothing,
            Err(error) => return unusable(error.to_string()),
        };
        match serde_json::from_str::<ProbeReport>(&text) {
            Ok(report) if report.is_of(info) => Cached::Report(Box::new(report)),
            Ok(_) => unusable("it is about another device, driver or version of the probes".into()),
            Err(error) => unusable(format!("it is no report of the probes ({error})")),
        }
    }

    /// Keeps a whole report. A quick one does not replace a full one that found the same outcomes.
    ///
    /// # Errors
    /// What the file system answers.
    pub fn store(&self, info: &DeviceInfo, report: &ProbeReport) -> io::Result<()> {
        if let Cached::Report(old) = self.load(info) {
            let outcomes = |report: &ProbeReport| report.probes.iter().map(|row| row.outcome).collect::<Vec<_>>();
            let is_less = report.effort == Effort::Quick.name() && old.effort == Effort::Full.name();
            if is_less && outcomes(&old) == outcomes(report) {
                return Ok(());
            }
        }
        std::fs::create_dir_all(&self.folder)?;
        let text = serde_json::to_string_pretty(report)?;
        write_atomically(&self.path(info), |out| io::Write::write_all(out, text.as_bytes()))
    }
}
