//! `voxtrace tiles` of meshes: commands look through some files each, and then each voxelizes a share of the space that they take together.

use super::{Stage, TilesArgs, plan, read};
use crate::failure::Failure;
use crate::mesh::watched;
use crate::read_failure::import_failure;
use crate::report::Report;
use voxtrace::import::{Kind, READERS, TiledMesh};
use voxtrace::voxelize::large::MeshTiles;
use voxtrace::voxelize::{VoxelizeError, VoxelizeOptions};

/// A survey of several.
pub fn joined(found: &[Vec<u8>]) -> Result<Vec<u8>, VoxelizeError> {
    let surveys = found.iter().map(|found| MeshTiles::from_bytes(found)).collect::<Result<Vec<_>, _>>()?;
    Ok(MeshTiles::join(surveys)?.to_bytes())
}

impl TilesArgs {
    /// Whether the inputs are meshes, by the first.
    pub fn is_mesh(&self) -> Result<bool, Failure> {
        let options = self.mesh.import_options();
        let opened = READERS.open(&self.inputs[0], &options).map_err(|error| import_failure(&error))?;
        Ok(opened.reader().kind == Kind::Mesh)
    }

    pub fn run_mesh(&self, report: &mut Report) -> Result<(), Failure> {
        self.mesh.refuse_choice_of_points(&self.inputs[0])?;
        if self.mesh.fills() {
            return Err(Failure::usage("--fill wants the whole mesh in memory").hint("use `voxtrace voxelize`"));
        }
        if self.read_once || self.stage == Stage::Expect {
            return Err(Failure::usage("--read-once and `expect` are about scans; meshes are looked through first"));
        }
        let options = self.mesh.import_options();
        let mesh = TiledMesh::open(self.inputs.clone(), &options).map_err(|error| import_failure(&error))?;
        match self.stage {
            Stage::Plan => {
                let parts = self.part_count()?;
                plan::print_mesh(&mesh.shares(parts), parts, &self.out)
            }
            Stage::Survey => {
                let files = self.files()?;
                let found = watched("survey", report, |progress| mesh.survey(files, progress));
                self.write(&found.map_err(|error| self.failure(error))?.to_bytes())
            }
            Stage::Voxelize => {
                let missing = || Failure::usage("--share K/N is missing: which share of the space this is for");
                let share = self.share.ok_or_else(missing)?;
                let (survey, how) = self.mesh_survey(&mesh, report)?;
                let limits = &options.limits;
                let made = watched("voxelize", report, |progress| {
                    mesh.voxelize(&survey, share, &how, limits, &self.out, progress)
                });
                made.map(drop).map_err(|error| self.failure(error))
            }
            _ => {
                let (survey, how) = self.mesh_survey(&mesh, report)?;
                let limits = &options.limits;
                let written = watched("merge", report, |progress| {
                    mesh.merge(&survey, self.part.len(), &self.part, &how, limits, &self.out, progress)
                });
                let written = written.map_err(|error| self.failure(error))?;
                self.end(written, report)
            }
        }
    }

    /// The survey of all files, and how they become voxels.
    fn mesh_survey(&self, mesh: &TiledMesh, report: &Report) -> Result<(MeshTiles, VoxelizeOptions), Failure> {
        let missing = || Failure::usage("--survey is missing: the survey of all files, which `tiles join` writes");
        let bytes = read(self.survey.as_deref().ok_or_else(missing)?)?;
        let mut survey = MeshTiles::from_bytes(&bytes).map_err(|error| self.failure(error))?;
        let (unit, notes) = mesh.check(&survey).map_err(|error| self.failure(error))?;
        if self.stage == Stage::Merge {
            notes.iter().for_each(|note| report.warn(note));
        }
        let unit = self.mesh.settled(unit);
        survey.set_unit(unit);
        let options = self.mesh.voxelize_options(unit, VoxelizeOptions::default().max_materials);
        Ok((survey, VoxelizeOptions { memory_budget: self.memory_budget, ..options }))
    }
}
