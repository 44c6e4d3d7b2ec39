//! The results of one scene as Markdown and as JSON.

use crate::contender::Contender;
use crate::rounds::{Measured, spread};
use serde_json::{Value, json};
use std::fmt::Write;

/// Index of the contender that the others are compared with: the walk that the renderer uses.
const OURS: usize = 1;

/// Everything measured on one scene.
pub struct Report<'a> {
    /// Name of the scene.
    pub scene: &'a str,
    /// Voxels in it.
    pub voxels: u64,
    /// Names of the sets of rays and how many rays they have.
    pub sets: Vec<(&'static str, usize)>,
    /// Names of the contenders.
    pub contenders: &'a [Box<dyn Contender + 'a>],
    /// The measurements, by set and contender.
    pub measured: Vec<Vec<Measured>>,
}

impl Report<'_> {
    /// The share of rays for which a contender met another voxel than the reference.
    pub fn mismatch_share(&self, contender: usize) -> f64 {
        let mismatches: usize = self.measured.iter().map(|set| set[contender].mismatches).sum();
        mismatches as f64 / self.sets.iter().map(|(_, rays)| rays).sum::<usize>() as f64
    }

    /// How many times as fast as a contender the renderer's walk is: median, least and most of the rounds.
    fn ratio(&self, set: usize, contender: usize) -> [f64; 3] {
        let of = |contender: usize| &self.measured[set][contender].mrays;
        spread(of(OURS).iter().zip(of(contender)).map(|(ours, theirs)| ours / theirs))
    }

    fn bytes_per_voxel(&self, bytes: u64) -> f64 {
        bytes as f64 / self.voxels as f64
    }

    fn bytes(&self, contender: usize) -> u64 {
        self.contenders[contender].memory().iter().map(|(_, bytes)| bytes).sum()
    }

    /// Tables of speed and ratio, lists of memory.
    pub fn markdown(&self) -> Result<String, std::fmt::Error> {
        let mut text = String::new();
        let out = &mut text;
        let rays: Vec<String> = self.sets.iter().map(|(name, count)| format!("{} {name}", grouped(*count))).collect();
        writeln!(out, "### {}, {} voxels\n", self.scene, grouped(self.voxels as usize))?;
        writeln!(out, "Rays: {}. Mrays/s on one core, median of {} rounds.\n", rays.join(", "), self.rounds())?;
        let names: Vec<&str> = self.sets.iter().map(|(name, _)| *name).collect();
        writeln!(out, "| | {} | bytes per voxel |\n|---{}|---:|", names.join(" | "), "|---:".repeat(names.len()))?;
        for (index, contender) in self.contenders.iter().enumerate() {
            write!(out, "| {} ", contender.name())?;
            for set in &self.measured {
                let [median, ..] = spread(set[index].mrays.iter().copied());
                write!(out, "| {median:.2} ")?;
            }
            writeln!(out, "| {:.2} |", self.bytes_per_voxel(self.bytes(index)))?;
        }
        writeln!(out, "\n`walk::cast_batch` is faster by, median (least to most) of the rounds:\n")?;
        writeln!(out, "| than | {} |\n|---{}|", names.join(" | "), "|---:".repeat(names.len()))?;
        for (index, contender) in self.contenders.iter().enumerate().filter(|(index, _)| *index != OURS) {
            write!(out, "| {} ", contender.name())?;
            for set in 0..self.sets.len() {
                let [median, least, most] = self.ratio(set, index);
                write!(out, "| {median:.2} ({least:.2} to {most:.2}) ")?;
            }
            writeln!(out, "|")?;
        }
        writeln!(out)?;
        for (index, contender) in self.contenders.iter().enumerate() {
            let memory: Vec<String> = (contender.memory().iter())
                .map(|(kind, bytes)| format!("{kind} {:.3}", self.bytes_per_voxel(*bytes)))
                .collect();
            writeln!(out, "- {}: {}.", contender.name(), contender.build())?;
            writeln!(out, "  Bytes per voxel: {}.", memory.join(", "))?;
            let ways: Vec<&str> = self.measured.iter().map(|set| set[index].way).collect();
            let mismatches: Vec<String> = self.measured.iter().map(|set| grouped(set[index].mismatches)).collect();
            write!(
                out,
                "  Rays cast by: {}. Other voxel than `walk::cast`: {} rays",
                ways.join(", "),
                mismatches.join(" + ")
            )?;
            writeln!(out, " ({:.4} %).", 100.0 * self.mismatch_share(index))?;
        }
        Ok(text)
    }

    /// The same for programs, with every round.
    pub fn json(&self) -> Value {
        let contender = |index: usize| {
            let contender = &self.contenders[index];
            let memory = contender.memory().into_iter().map(|(kind, bytes)| (kind.to_owned(), bytes.into()));
            let rays = self.sets.iter().zip(&self.measured).enumerate().map(|(set, ((name, count), measured))| {
                let measured = &measured[index];
                json!({
                    "kind": name,
                    "rays": count,
                    "cast_by": measured.way,
                    "mrays_per_s": spread(measured.mrays.iter().copied())[0],
                    "mrays_per_s_by_round": measured.mrays,
                    "cast_batch_is_faster_by": self.ratio(set, index)[0],
                    "other_voxel": measured.mismatches,
                })
            });
            json!({
                "name": contender.name(),
                "rays": rays.collect::<Vec<_>>(),
                "bytes": memory.collect::<serde_json::Map<_, _>>(),
                "bytes_per_voxel": self.bytes_per_voxel(self.bytes(index)),
                "build": contender.build(),
            })
        };
        json!({
            "scene": self.scene,
            "voxels": self.voxels,
            "contenders": (0..self.contenders.len()).map(contender).collect::<Vec<_>>(),
        })
    }

    fn rounds(&self) -> usize {
        self.measured[0][0].mrays.len()
    }
}

/// A number with commas between groups of three digits.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
