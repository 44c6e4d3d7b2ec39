//! A mesh of many files that many processes voxelize: each a share of the space that it takes, into a part; and the scene of all parts, which is
//! that of one process, byte for byte.
//!
//! Processes share space, not files: what colour a voxel has depends on all triangles in it, in their order, so that one process has to have
//! them all. A share is a box, and its process reads the files whose triangles may reach into it.

use super::{MeshTiles, Plan, Work};
use crate::import_error::ImportError;
use crate::limits::Limits;
use crate::mesh::Mesh;
use crate::mesh::joined::{Joined, has_changed};
use crate::mesh::source::{SourceColors, TriangleSource};
use crate::voxelize::color_histogram::ColorHistogram;
use crate::voxelize::spill::SpillBuffer;
use crate::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written, binning, check_limits, fingerprint};
use glam::Vec3;
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::TemporaryFile;
use voxtrace_scene::scene::LengthUnit;

/// Triangles of a piece.
const PIECE: usize = 1 << 16;

/// Reads the mesh of a file, told by its number.
pub type ReadMesh<'a> = dyn FnMut(usize) -> Result<Mesh, ImportError> + Send + 'a;

/// The triangles of files, one file in memory at a time. Textures stay, once they were read.
pub struct MeshFiles<'a> {
    joined: Joined,
    /// Triangles of each file.
    counts: Vec<u64>,
    /// Whether a file is read.
    chosen: Vec<bool>,
    read: Box<ReadMesh<'a>>,
}

impl<'a> MeshFiles<'a> {
    /// All files of a survey.
    ///
    /// # Errors
    /// As [`MeshTiles::joined`].
    pub fn new(tiles: &MeshTiles, read: Box<ReadMesh<'a>>) -> Result<Self, VoxelizeError> {
        let joined = tiles.joined()?;
        Ok(Self { chosen: vec![true; joined.count()], counts: tiles.counts().collect(), joined, read })
    }

    /// What the files have in common.
    pub fn joined(&self) -> &Joined {
        &self.joined
    }

    /// Gives the whole a name and a unit.
    pub fn rename(&mut self, name: &str, unit: LengthUnit) {
        (self.joined.frame.name, self.joined.frame.unit) = (name.into(), unit);
    }
}

impl TriangleSource for MeshFiles<'_> {
    fn frame(&mut self) -> &mut Mesh {
        &mut self.joined.frame
    }

    fn count(&self) -> u64 {
        self.counts.iter().sum()
    }

    fn colors(&self) -> SourceColors {
        if self.joined.has_colors { SourceColors::Linear } else { SourceColors::None }
    }

    fn has_uvs(&self) -> bool {
        self.joined.has_uvs
    }

    fn materials(&self) -> Option<Vec<bool>> {
        Some(self.joined.used.clone())
    }

    fn release(&mut self) {}

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let mut piece = Mesh { offset: self.joined.frame.offset, ..Mesh::default() };
        for number in (0..self.chosen.len()).filter(|&number| self.chosen[number]) {
            let mesh = (self.read)(number)?;
            let name = PathBuf::from(&mesh.name);
            let (count, expected) = (mesh.triangle_count(), self.counts[number]);
            let mesh = match self.joined.take(number, mesh) {
                Ok(mesh) if count as u64 == expected => Ok(mesh),
                Ok(mesh) => Err(has_changed(&mesh.name)),
                Err(fault) => Err(fault),
            };
            let mesh = mesh.map_err(|fault| ImportError::malformed(&name, 0, fault))?;
            for start in (0..count).step_by(PIECE) {
                piece.clear();
                for triangle in start..(start + PIECE).min(count) {
                    let corners = mesh.corners(triangle);
                    piece.positions.extend(corners.map(|corner| mesh.positions[corner]));
                    if !mesh.uvs.is_empty() {
                        piece.uvs.extend(corners.map(|corner| mesh.uvs[corner]));
                    }
                    if !mesh.colors.is_empty() {
                        piece.colors.extend(corners.map(|corner| mesh.colors[corner]));
                    }
                    piece.material_of.push(mesh.material_of[triangle]);
                }
                if !each(&piece) {
                    return Ok(());
                }
            }
        }
        Ok(())
    }
}

/// What all processes that voxelize shares of a mesh agree on.
struct Shared {
    plan: Plan,
    /// The work that parts are.
    key: u128,
}

impl Shared {
    fn of(
        (tiles, stamp): (&MeshTiles, &str),
        source: &mut MeshFiles,
        shares: usize,
        options: &VoxelizeOptions,
    ) -> Result<Self, VoxelizeError> {
        tiles.check(stamp)?;
        if options.fill {
            return Err(VoxelizeError::Parts("shares of a mesh are not filled".into()));
        }
        let survey = tiles.survey(&source.joined);
        let plan = Plan::of(source, &survey, options, shares)?;
        let key = fingerprint::of_description(&(stamp, survey.summary(), options, shares));
        Ok(Self { plan, key })
    }
}

/// Voxelizes the share with the number `share.0` of `share.1` into the part `path`, which is there whole or not at all; returns how many files were
/// read. Where there is little to share the last shares are empty. `stamp` tells the files from others.
///
/// # Errors
/// If the survey is not of all files or of others, there is no such share, a file cannot be read or has changed, there are more voxels than allowed,
/// the part cannot be written, or it was cancelled.
pub fn voxelize_mesh_tiles(
    (tiles, stamp, read): (&MeshTiles, &str, Box<ReadMesh<'_>>),
    share: (usize, usize),
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<usize, VoxelizeError> {
    let mut source = MeshFiles::new(tiles, read)?;
    let Shared { plan, key } = Shared::of((tiles, stamp), &mut source, share.1, options)?;
    if share.0 >= share.1 {
        return Err(VoxelizeError::Parts(format!("there is no share {} of {}", share.0, share.1)));
    }
    let parts = plan.partition.share(share.0);
    // As much further as snapping to the lattice may move a corner, and the voxels that touch it.
    let tile = |corner: Vec3, by: i32| {
        ((plan.placement.voxels(corner) + f64::from(by)) / f64::from(binning::TILE)).floor().as_ivec3()
    };
    let reaches = |bounds: Option<(Vec3, Vec3)>| {
        bounds.is_some_and(|(low, high)| plan.partition.reaches(&plan.tiles, (tile(low, -2), tile(high, 2)), &parts))
    };
    let chosen: Vec<bool> = tiles.bounds(&source.joined).map(reaches).collect();
    let all = chosen.iter().zip(tiles.counts()).filter(|(is_chosen, _)| **is_chosen).map(|(_, count)| count).sum();
    let read = chosen.iter().filter(|is_chosen| **is_chosen).count();
    source.chosen = chosen;
    let temporary = TemporaryFile::beside(path)?;
    let mut spill = SpillBuffer::of_part(temporary.try_clone()?, key)?;
    progress.begin(2 * all);
    // Which colours there are is asked when all parts are there.
    let histogram = ColorHistogram::default();
    let work = Work { plan: &plan, options, limits, path, histogram: &histogram, progress };
    work.voxelize(&mut source, parts.clone(), all, &mut spill)?;
    spill.end_part(u64::from(parts.start)..u64::from(parts.end))?;
    temporary.replace(path)?;
    Ok(read)
}

/// Makes a native file of the parts of all of so many shares, in any order: the bytes that [`crate::voxelize::voxelize_to_file`] writes of the meshes of all files
/// as one. No file is read.
///
/// # Errors
/// If a part is missing, damaged or of other work, there are more voxels than allowed, the file cannot be written, or it was cancelled.
pub fn merge_mesh_tiles(
    (tiles, stamp): (&MeshTiles, &str),
    shares: usize,
    parts: &[PathBuf],
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let mut source = MeshFiles::new(tiles, Box::new(|_| Ok(Mesh::default())))?;
    let Shared { plan, key } = Shared::of((tiles, stamp), &mut source, shares, options)?;
    let histogram = ColorHistogram::default();
    let work = (key, plan.partition.part_count() as u64, "parts of the grid");
    let mut spill = SpillBuffer::of_parts(parts, work, (&histogram, 1), path, progress)?;
    check_limits(&spill, limits, progress)?;
    if spill.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    let scene = plan.scene(&mut source);
    plan.finish(&mut source, &histogram, options).write(scene, &mut spill, path, progress)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{MeshMaterial, Texture, TextureUse};
    use crate::voxelize::{Scale, voxelize_large_to_file, voxelize_to_file};
    use glam::{DVec3, Vec2, Vec4};
    use std::fs;

    const STAMP: &str = "six sheets";

    /// A wavy sheet of a tile: some with textures, one of roughness and metalness among them, some with colours, some with another offset.
    fn sheet(number: usize) -> Mesh {
        const SIDE: usize = 24;
        let (column, row) = (number % 3, number / 3);
        let offset = DVec3::new(4e5, 6e6, 100.0) + if number == 4 { DVec3::new(8.0, -16.0, 0.5) } else { DVec3::ZERO };
        let shift = (DVec3::new(4e5, 6e6, 100.0) - offset).as_vec3();
        let mut mesh = Mesh { offset, ..Mesh::new(format!("tile {number}")) };
        for y in 0..=SIDE {
            for x in 0..=SIDE {
                let flat = Vec2::new((column * SIDE + x) as f32, (row * SIDE + y) as f32) * 0.6;
                let height = 3.0 * (flat.x * 0.23).sin() * (flat.y * 0.31).cos();
                mesh.positions.push(flat.extend(height) + shift);
                if number.is_multiple_of(2) {
                    mesh.uvs.push(Vec2::new(x as f32, y as f32) / SIDE as f32);
                }
                if number == 3 {
                    mesh.colors.push(Vec4::new(x as f32 / SIDE as f32, 0.5, 0.25, 1.0));
                }
            }
        }
        for y in 0..SIDE {
            for x in 0..SIDE {
                let at = (y * (SIDE + 1) + x) as u32;
                let above = at + SIDE as u32 + 1;
                mesh.triangles.extend([[at, at + 1, above], [at + 1, above + 1, above]]);
                mesh.material_of.extend([(x % 2) as u16; 2]);
            }
        }
        let texels = (0..64u8).map(|at| [at * 4, 255 - at * 2, number as u8 * 20, 255]).collect();
        let surface = (0..16u8).map(|at| [0, at * 16, 255 * (at % 2), 255]).collect();
        mesh.textures = vec![Texture::new(8, 8, texels).unwrap(), Texture::new(4, 4, surface).unwrap()];
        let textured = MeshMaterial {
            base_texture: Some(TextureUse::new(0)),
            surface_texture: (number == 2).then(|| TextureUse::new(1)),
            base_color: Vec4::ONE,
            metallic: 1.0,
            ..MeshMaterial::default()
        };
        let glowing = MeshMaterial { emission: Vec3::new(0.0, 0.5, 2.0), ..MeshMaterial::default() };
        mesh.materials = vec![textured, if number == 5 { glowing } else { MeshMaterial::default() }];
        mesh
    }

    fn survey() -> MeshTiles {
        let found = |files: std::ops::Range<usize>| {
            let read: Box<ReadMesh> = Box::new(|number| Ok(sheet(number)));
            MeshTiles::of((6, STAMP, read), files, &VoxelizeProgress::default()).unwrap()
        };
        MeshTiles::join([found(4..6), found(0..4)].map(|found| MeshTiles::from_bytes(&found.to_bytes()).unwrap()))
            .unwrap()
    }

    #[test]
    fn shares_of_any_number_make_the_file_of_the_mesh_in_memory() {
        let folder = tempfile::tempdir().unwrap();
        let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
        let tiles = survey();
        let whole = tiles.joined().unwrap().whole((0..6).map(sheet)).unwrap();
        for options in [
            VoxelizeOptions { scale: Scale::VoxelSize(0.11), ..VoxelizeOptions::default() },
            VoxelizeOptions {
                scale: Scale::Resolution(300),
                rule: crate::voxelize::SurfaceRule::Thin,
                max_materials: 200,
                memory_budget: Some(1 << 20),
                ..VoxelizeOptions::default()
            },
        ] {
            let path = folder.path().join("whole.vxt");
            voxelize_to_file(whole.clone(), &options, &limits, &path, &progress).unwrap();
            let expected = fs::read(&path).unwrap();

            let mut files = MeshFiles::new(&tiles, Box::new(|number| Ok(sheet(number)))).unwrap();
            let survey = tiles.survey(files.joined());
            let path = folder.path().join("large.vxt");
            voxelize_large_to_file((&mut files, "tiles"), &survey, &options, &limits, &path, &progress).unwrap();
            assert!(fs::read(&path).unwrap() == expected, "out of core");

            for shares in [1, 2, 5, 9, 300] {
                let mut fewest = usize::MAX;
                let mut parts: Vec<PathBuf> = (0..shares)
                    .map(|share| {
                        let path = folder.path().join(format!("{share}-{shares}.part"));
                        let read: Box<ReadMesh> = Box::new(|number| Ok(sheet(number)));
                        let of = (share, shares);
                        let read = voxelize_mesh_tiles((&tiles, STAMP, read), of, &options, &limits, &path, &progress);
                        fewest = fewest.min(read.unwrap());
                        path
                    })
                    .collect();
                assert!(shares < 5 || fewest <= 2, "{fewest} files are read for the smallest of {shares} shares");
                parts.reverse();
                let path = folder.path().join("merged.vxt");
                let merge = |parts: &[PathBuf], shares, options: &VoxelizeOptions| {
                    merge_mesh_tiles((&tiles, STAMP), shares, parts, options, &limits, &path, &progress)
                };
                merge(&parts, shares, &options).unwrap();
                assert!(fs::read(&path).unwrap() == expected, "{shares} shares");
                if shares == 5 {
                    let told = |result: Result<Written, VoxelizeError>| result.unwrap_err().to_string();
                    assert!(told(merge(&parts[1..], shares, &options)).contains("are in no part"));
                    assert!(
                        told(merge(&[&parts[..], &parts[..1]].concat(), shares, &options)).contains("in another part")
                    );
                    assert!(told(merge(&parts, 4, &options)).contains("no part of these parts of the grid"));
                    let other = VoxelizeOptions { dither: true, ..options };
                    assert!(told(merge(&parts, shares, &other)).contains("no part of these parts of the grid"));
                }
            }
        }
    }

    #[test]
    fn files_that_have_changed_and_shares_that_are_not_there_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let options = VoxelizeOptions { scale: Scale::VoxelSize(0.11), ..VoxelizeOptions::default() };
        let (tiles, path) = (survey(), folder.path().join("part"));
        let told = |share: (usize, usize), change: fn(&mut Mesh)| {
            let read: Box<ReadMesh> = Box::new(move |number| {
                let mut mesh = sheet(number);
                if number == 4 {
                    change(&mut mesh);
                }
                Ok(mesh)
            });
            let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
            let made = voxelize_mesh_tiles((&tiles, STAMP, read), share, &options, &limits, &path, &progress);
            made.map_or_else(|error| error.to_string(), |files| format!("{files} files"))
        };
        let changes: [fn(&mut Mesh); 3] = [
            |mesh| _ = (mesh.triangles.pop(), mesh.material_of.pop()),
            |mesh| mesh.offset.x += 1.0,
            |mesh| _ = mesh.textures.pop(),
        ];
        for (number, change) in changes.into_iter().enumerate() {
            let said = told((0, 1), change);
            assert!(said.contains("tile 4 has changed"), "change {number}: {said}");
        }
        assert_eq!(told((3, 3), |_| {}), "there is no share 3 of 3");
        assert_eq!(told((0, 1), |_| {}), "6 files");
    }
}
