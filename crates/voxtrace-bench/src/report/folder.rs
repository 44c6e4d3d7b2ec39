//! The folder of a report and its files: what is measured stands there at once, whatever happens to the next cell.

use super::{charts, figures, html, tables};
use crate::error::BenchError;
use crate::measure::{Conformance, Reference};
use crate::numbers::{FrameLine, write_csv};
use crate::results::{Emulation, Figures, Results, Row, SceneFacts};
use rayon::prelude::*;
use std::io;
use std::path::Path;
use voxtrace::import::opened::Inputs;
use voxtrace::output::write_atomically;
use voxtrace::{Film, Hit, PackedScene};
use voxtrace_core::nearest_centre;
use voxtrace_vulkan::Primitive;

/// How much larger boxes are where the nearest-centre rule is emulated, voxels.
const EMULATED_MARGIN: f32 = 1.0 / 128.0;

/// A folder that is there.
pub struct ReportFolder<'a> {
    path: &'a Path,
}

impl<'a> ReportFolder<'a> {
    /// The folder, made if it is not there.
    pub fn new(path: &'a Path) -> Result<Self, BenchError> {
        std::fs::create_dir_all(path).map_err(|error| BenchError::output(path, error))?;
        Ok(Self { path })
    }

    /// Writes the frames of a cell.
    pub fn write_row(&self, row: &mut Row, stem: &str) -> Result<(), BenchError> {
        let base = base_name(row.scene, stem, &row.cell.name());
        row.csv = self.write_frames(format!("{base}.csv"), &row.measured.frames)?;
        row.primary_csv = self.write_frames(format!("{base}-primary.csv"), &row.measured.primary)?;
        Ok(())
    }

    /// Writes the pictures of a cell: its film, and where it finds wrong voxels, those.
    pub fn write_figures(
        &self,
        row: &mut Row,
        stem: &str,
        scene: &PackedScene,
        reference: &Reference,
        film: Option<&Film>,
        hits: &[Hit],
    ) -> Result<(), BenchError> {
        let base = base_name(row.scene, stem, &row.cell.name());
        let is_approximate = row.cell.primitive == Some(Primitive::VoxelApprox);
        if let Some(film) = film {
            row.figures.render = Some(self.write_picture(format!("{base}.jpg"), &figures::render(film))?);
        }
        if !hits.is_empty() && (is_approximate || row.measured.conformance.is_some_and(|found| !found.holds(false))) {
            (row.figures.voxels, row.figures.difference) = self.write_voxels(&base, scene, reference, hits)?;
        }
        Ok(())
    }

    /// Adds the picture of the right voxels, and with `emulates` what the study's approximate rule would find.
    pub fn add_figures(
        &self,
        index: usize,
        facts: &mut SceneFacts,
        scene: &PackedScene,
        reference: &Reference,
        emulates: bool,
    ) -> Result<(), BenchError> {
        let base = base_name(index, &facts.name, "exact");
        let picture = figures::voxels(scene, reference, &reference.hits);
        facts.exact_figure = Some(self.write_picture(format!("{base}-voxels.jpg"), &picture)?);
        if emulates {
            let mut hits = vec![Hit::MISS; reference.rays.len()];
            let pieces = reference.rays.par_chunks(1 << 14).zip(hits.par_chunks_mut(1 << 14));
            pieces.for_each(|(rays, hits)| nearest_centre::cast_batch(scene, rays, EMULATED_MARGIN, hits));
            scene.turn_to_parts(&mut hits);
            let base = base_name(index, &facts.name, "emulated");
            let (voxels, difference) = self.write_voxels(&base, scene, reference, &hits)?;
            facts.emulation = Some(Emulation {
                margin: EMULATED_MARGIN.into(),
                conformance: Conformance::of(scene, reference, &hits),
                figures: Figures { render: None, voxels, difference },
            });
        }
        Ok(())
    }

    /// Writes `results.json` and `report.md`.
    pub fn write_results(&self, results: &Results) -> Result<(), BenchError> {
        let json = format!("{:#}\n", results.json());
        self.write_text("results.json", &json)?;
        self.write_text("report.md", &tables::report(results))
    }

    /// Writes the page and its charts.
    pub fn write_page(&self, results: &Results) -> Result<(), BenchError> {
        for (name, plot) in charts::all(results) {
            self.write_text(&name, &plot.svg(true))?;
        }
        self.write_text("report.html", &html::page(results, self.path))
    }

    fn write_voxels(
        &self,
        base: &str,
        scene: &PackedScene,
        reference: &Reference,
        hits: &[Hit],
    ) -> Result<(Option<String>, Option<String>), BenchError> {
        let voxels = self.write_picture(format!("{base}-voxels.jpg"), &figures::voxels(scene, reference, hits))?;
        let difference = self.write_picture(format!("{base}-wrong.png"), &figures::difference(reference, hits))?;
        Ok((Some(voxels), Some(difference)))
    }

    fn write_picture(&self, name: String, picture: &figures::Picture) -> Result<String, BenchError> {
        let path = self.path.join(&name);
        write(&path, |out| match name.ends_with(".jpg") {
            true => picture.write_jpeg(out),
            false => picture.write_png(out),
        })
        .map_err(|error| BenchError::output(&path, error))?;
        Ok(name)
    }

    fn write_frames(&self, name: String, frames: &[FrameLine]) -> Result<Option<String>, BenchError> {
        if frames.is_empty() {
            return Ok(None);
        }
        let path = self.path.join(&name);
        write(&path, |out| write_csv(frames, out)).map_err(|error| BenchError::output(&path, error))?;
        Ok(Some(name))
    }

    fn write_text(&self, name: &str, text: &str) -> Result<(), BenchError> {
        let path = self.path.join(name);
        let write_text = |out: &mut io::BufWriter<std::fs::File>| io::Write::write_all(out, text.as_bytes());
        write(&path, write_text).map_err(|error| BenchError::output(&path, error))
    }
}

/// Writes a file whole or not at all, and never over one that this run reads.
fn write(path: &Path, write: impl FnOnce(&mut io::BufWriter<std::fs::File>) -> io::Result<()>) -> io::Result<()> {
    Inputs::now().refuse(path).map_err(io::Error::other)?;
    write_atomically(path, write)
}

/// What the files of a cell are called.
fn base_name(scene: usize, stem: &str, cell: &str) -> String {
    format!("{}-{stem}-{}", scene + 1, cell.replace(':', "-"))
}
