//! What the probes found on one device: the form in which it is printed, cached, and put into reports.

use super::{Effort, PROBE_VERSION};
use crate::capabilities::DeviceInfo;
use crate::method::Traversal;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the form; it grows when a reader of the old one would misread.
pub const SCHEMA: u32 = 1;

/// What a probe says. Ordered: the later ones matter more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// There is nothing to ask here; the sentence says why.
    NotApplicable,
    /// What the specification promises was found.
    Holds,
    /// No promise is at stake; the numbers are what it is about.
    Reported,
    /// A promise is broken, or the driver answered with an error.
    Fails,
}

impl Outcome {
    /// For people.
    pub fn name(self) -> &'static str {
        match self {
            Self::NotApplicable => "not applicable",
            Self::Holds => "holds",
            Self::Reported => "reported",
            Self::Fails => "FAILS",
        }
    }
}

/// What a probe found by one traversal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// `pipeline` or `query`; `None` where it makes no difference.
    pub traversal: Option<String>,
    /// The outcome.
    pub outcome: Outcome,
    /// Rays, or whatever else was tried.
    pub rays: u64,
    /// Those among them that came out wrong.
    pub wrong: u64,
    /// Other numbers by name.
    pub counts: BTreeMap<String, u64>,
    /// One sentence.
    pub says: String,
}

impl Finding {
    /// A finding without numbers of its own.
    pub fn new(traversal: Option<Traversal>, outcome: Outcome, says: impl Into<String>) -> Self {
        let traversal = traversal.map(|traversal| traversal.name().to_owned());
        Self { traversal, outcome, rays: 0, wrong: 0, counts: BTreeMap::new(), says: says.into() }
    }

    /// Holds where nothing is wrong, else fails.
    pub fn judged(traversal: Traversal, rays: u64, wrong: u64, says: impl Into<String>) -> Self {
        let outcome = if wrong == 0 { Outcome::Holds } else { Outcome::Fails };
        Self { rays, wrong, ..Self::new(Some(traversal), outcome, says) }
    }

    /// With another number.
    pub fn with(mut self, name: &str, count: u64) -> Self {
        self.counts.insert(name.into(), count);
        self
    }
}

/// One probe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbeRow {
    /// `P1` to `P19`.
    pub id: String,
    /// What it looks at.
    pub name: String,
    /// What must hold.
    pub expects: String,
    /// The worst of the traversals' outcomes.
    pub outcome: Outcome,
    /// Sum over the traversals.
    pub rays: u64,
    /// Sum over the traversals.
    pub wrong: u64,
    /// One sentence, or one for each traversal where they differ.
    pub says: String,
    /// By each traversal.
    pub findings: Vec<Finding>,
    /// Time that it took.
    pub milliseconds: f64,
}

impl ProbeRow {
    pub(super) fn new(id: &str, name: &str, expects: &str, findings: Vec<Finding>, milliseconds: f64) -> Self {
        let outcome = findings.iter().map(|finding| finding.outcome).max().unwrap_or(Outcome::NotApplicable);
        let are_alike = findings.windows(2).all(|pair| pair[0].says == pair[1].says);
        let says = match findings.as_slice() {
            [first, ..] if are_alike => first.says.clone(),
            all => {
                let name = |finding: &Finding| finding.traversal.clone().unwrap_or_default();
                let told: Vec<String> =
                    all.iter().map(|finding| format!("{}: {}", name(finding), finding.says)).collect();
                told.join("; ")
            }
        };
        Self {
            id: id.into(),
            name: name.into(),
            expects: expects.into(),
            outcome,
            rays: findings.iter().map(|finding| finding.rays).sum(),
            wrong: findings.iter().map(|finding| finding.wrong).sum(),
            says,
            findings,
            milliseconds,
        }
    }
}

/// All probes on one device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbeReport {
    /// [`SCHEMA`].
    pub schema: u32,
    /// [`PROBE_VERSION`].
    pub probe_version: u32,
    /// Version of the program.
    pub voxtrace: String,
    /// Name of the device.
    pub device: String,
    /// Kind of the device.
    pub kind: String,
    /// Name and version of its driver.
    pub driver: String,
    /// Version of Vulkan.
    pub vulkan: String,
    /// `quick` or `full`.
    pub effort: String,
    /// Traversals that were probed.
    pub traversals: Vec<String>,
    /// Time of everything, opening of the device and compiling included, seconds.
    pub seconds: f64,
    /// P1 to P19, in order.
    pub probes: Vec<ProbeRow>,
}

impl ProbeReport {
    pub(super) fn new(info: &DeviceInfo, effort: Effort) -> Self {
        Self {
            schema: SCHEMA,
            probe_version: PROBE_VERSION,
            voxtrace: env!("CARGO_PKG_VERSION").into(),
            device: info.name.clone(),
            kind: info.kind.name().into(),
            driver: info.driver.clone(),
            vulkan: info.api_version.clone(),
            effort: effort.name().into(),
            traversals: Vec::new(),
            seconds: 0.0,
            probes: Vec::new(),
        }
    }

    /// Whether it was made on this device with this driver by these probes.
    pub fn is_of(&self, info: &DeviceInfo) -> bool {
        let ours = (SCHEMA, PROBE_VERSION, &info.name, &info.driver, &info.api_version);
        (self.schema, self.probe_version, &self.device, &self.driver, &self.vulkan) == ours
    }

    /// A probe by its number, for example `P13`.
    pub fn probe(&self, id: &str) -> Option<&ProbeRow> {
        self.probes.iter().find(|row| row.id == id)
    }

    /// What a probe found by a traversal.
    pub fn finding(&self, id: &str, traversal: Traversal) -> Option<&Finding> {
        let name = Some(traversal.name());
        self.probe(id)?
            .findings
            .iter()
            .find(|finding| finding.traversal.is_none() || finding.traversal.as_deref() == name)
    }

    /// A name for files: the device and the version of its driver, for example `lavapipe-25.0.7`.
    pub fn file_stem(&self) -> String {
        // Mesa calls its software device llvmpipe in OpenGL and Vulkan alike, people call the Vulkan one lavapipe.
        let device = self.device.split('(').next().unwrap_or_default().trim().replace("llvmpipe", "lavapipe");
        let version = self.driver.split(|c: char| !c.is_ascii_digit() && c != '.').find(|part| {
            let numbers: Vec<&str> = part.split('.').collect();
            numbers.len() >= 2 && numbers.iter().all(|number| !number.is_empty())
        });
        let text = [device.as_str(), version.unwrap_or("unknown")].join("-").to_lowercase();
        let plain = |c: char| if c.is_ascii_alphanumeric() || c == '.' { c } else { '-' };
        let text: String = text.chars().map(plain).collect();
        text.split('-').filter(|part| !part.trim_matches('.').is_empty()).collect::<Vec<_>>().join("-")
    }
}
