//! What was measured, one line each in a file to which runs add: one that was stopped, or that measures a part alone, goes on there. The last step makes the
//! table of the documentation of it.

use super::Outcome;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::PathBuf;

/// One line: what was measured, and what came out. Numbers that do not apply are not finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub scene: String,
    pub situation: String,
    /// Number of the frame, or `mean`.
    pub frame: String,
    pub parts: String,
    /// PSNR in dB, mean FLIP, ratio of all light, mean difference of frames that follow each other.
    pub values: [f64; 4],
}

/// The file, and what it holds.
pub struct Results {
    path: PathBuf,
    pub lines: Vec<Line>,
}

impl Line {
    fn parse(text: &str) -> Option<Self> {
        let fields: Vec<&str> = text.split('\t').collect();
        let [scene, situation, frame, parts, values @ ..] = fields.as_slice() else { return None };
        let values: Vec<f64> = values.iter().map(|value| value.parse().ok()).collect::<Option<_>>()?;
        let [scene, situation, frame, parts] = [scene, situation, frame, parts].map(|field| (*field).to_owned());
        Some(Self { scene, situation, frame, parts, values: values.try_into().ok()? })
    }

    fn text(&self) -> String {
        let Self { scene, situation, frame, parts, values: [psnr, flip, energy, flicker] } = self;
        format!("{scene}\t{situation}\t{frame}\t{parts}\t{psnr:.3}\t{flip:.4}\t{energy:.4}\t{flicker:.5}")
    }
}

impl Results {
    /// The file at `path`, new or as it is.
    pub fn open(path: PathBuf) -> Outcome<Self> {
        let text = if path.exists() { std::fs::read_to_string(&path)? } else { String::new() };
        // The last line of a run that was stopped may be half a line: it is measured again.
        Ok(Self { path, lines: text.lines().filter_map(Line::parse).collect() })
    }

    /// Whether a situation was measured to its end, whose mean is what is kept last.
    pub fn has(&self, scene: &str, situation: &str, parts: &str) -> bool {
        let is_last = |line: &Line| line.frame == "mean" && line.parts == parts;
        self.lines.iter().any(|line| line.scene == scene && line.situation == situation && is_last(line))
    }

    /// Keeps another line.
    pub fn add(&mut self, line: Line) -> Outcome<()> {
        println!("{}", line.text());
        let mut file = OpenOptions::new().create(true).append(true).open(&self.path)?;
        writeln!(file, "{}", line.text())?;
        self.lines.push(line);
        Ok(())
    }

    /// The table: a row for each scene, situation and parts, with the frames side by side.
    pub fn table(&self) -> String {
        let mut rows: BTreeMap<usize, (&Line, BTreeMap<&str, [f64; 4]>)> = BTreeMap::new();
        let same = |a: &Line, b: &Line| (&a.scene, &a.situation, &a.parts) == (&b.scene, &b.situation, &b.parts);
        for line in &self.lines {
            let first = self.lines.iter().position(|other| same(line, other)).unwrap_or(0);
            rows.entry(first).or_insert((line, BTreeMap::new())).1.insert(&line.frame, line.values);
        }
        let mut rows: Vec<_> = rows.into_values().collect();
        let place = |names: &[&str], name: &str| names.iter().position(|other| *other == name).unwrap_or(names.len());
        rows.sort_by_key(|(line, _)| {
            (place(&SCENES, &line.scene), place(&SITUATIONS, &line.situation), place(&PARTS, &line.parts))
        });
        let mut table = String::from(
            "| scene | situation | parts | 1: dB, FLIP | 4 | 16 | 64 | mean: dB, FLIP | light | flicker |\n|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n",
        );
        for (line, frames) in rows {
            let cell = |frame: &str| {
                let values = frames.get(frame).filter(|values| values[0].is_finite());
                values.map_or(String::new(), |[psnr, flip, ..]| format!("{psnr:.1}, {flip:.2}"))
            };
            let [one, four, sixteen, last, mean] = ["1", "4", "16", "64", "mean"].map(cell);
            // The light of frame 16, or of all frames.
            let light = frames.get("16").or_else(|| frames.get("mean")).map_or(f64::NAN, |values| values[2]);
            let flicker = frames.get("mean").map_or(f64::NAN, |values| values[3]);
            let number = |value: f64, digits: usize| {
                if value.is_finite() { format!("{value:.digits$}") } else { String::new() }
            };
            let (light, flicker) = (number(light, 3), number(flicker, 4));
            let Line { scene, situation, parts, .. } = line;
            _ = writeln!(
                table,
                "| {scene} | {situation} | {parts} | {one} | {four} | {sixteen} | {last} | {mean} | {light} | {flicker} |"
            );
        }
        table
    }
}

/// The order of the table.
const SCENES: [&str; 5] = ["church", "operating-room", "city", "forest", "glass"];
const SITUATIONS: [&str; 5] = ["cut", "way", "edit", "dimmed", "moving"];
const PARTS: [&str; 7] = ["raw", "temporal", "cache", "filter", "all", "denoise", "oidn"];
