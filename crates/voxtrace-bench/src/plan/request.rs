//! What somebody asks a benchmark for: options and a plan's file, and the defaults of what neither says.

use super::cell::{self, Cell, CellError};
use super::file::{PlanFile, SceneEntry};
use super::settings::{LEAST_FRAMES, Plan, STUDY_SIZE, usual_sweep};
use crate::quantity::Size;
use std::path::PathBuf;
use std::time::Duration;
use voxtrace::{Integrator, scenes};
use voxtrace_vulkan::probe::Cache;
use voxtrace_vulkan::{DeviceInfo, DeviceKind, Traversal};

/// Frames of the study.
const FRAMES: u32 = 4096;
const WARM_UP: u32 = 20;
const QUICK_FRAMES: u32 = 256;
const QUICK_LIMIT: Duration = Duration::from_secs(4);
/// Longest time of a cell on the CPU or a device in software, where none is asked for.
const SOFTWARE_LIMIT: Duration = Duration::from_secs(60);
/// The same of the CPU beside a GPU.
const BESIDE_LIMIT: Duration = Duration::from_secs(20);
/// Voxels of the built-in scenes with `quick` on a device in software, which takes no more than about four million.
const QUICK_SOFTWARE_VOXELS: u64 = 500_000;
/// Size of the pictures with `quick` on a device in software.
const QUICK_SOFTWARE_SIZE: Size = (495, 270);
const SEED: u32 = 1;

/// Most surfaces that scatter a path, by `essay` as the study, by `path` as `render`.
fn usual_bounces(integrator: Integrator) -> u32 {
    match integrator {
        Integrator::Essay => 3,
        Integrator::Path => 8,
    }
}

/// Leaves out repetitions: what is there twice is measured once.
fn keep_first<T: Copy + PartialEq>(list: &mut Vec<T>) {
    let mut seen = Vec::new();
    list.retain(|item| {
        !seen.contains(item) && {
            seen.push(*item);
            true
        }
    });
}

/// What is asked for; what is `None` or empty has a default that suits the device.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// Files or names of built-in scenes; empty for the three of the study.
    pub scenes: Vec<SceneEntry>,
    /// What to measure: TRAVERSAL, TRAVERSAL:PRIMITIVE or TRAVERSAL:all; empty for the study's two methods.
    pub cells: Vec<String>,
    /// Every traversal and primitive that the device offers, and the CPU, where no cells are named.
    pub full: bool,
    /// About a minute in all.
    pub quick: bool,
    /// Go on with the benchmark in the folder.
    pub resume: bool,
    /// Shaders that give the CPU's bits.
    pub precise: bool,
    /// Frames of each cell.
    pub frames: Option<u32>,
    /// Frames before the first that counts.
    pub warm_up: Option<u32>,
    /// Most time of each cell's frames.
    pub time_limit: Option<Duration>,
    /// Size of the picture.
    pub size: Option<Size>,
    /// Most surfaces that scatter one path.
    pub max_bounces: Option<u32>,
    /// How the light along a camera ray is computed; `None` for the study's `essay`.
    pub integrator: Option<Integrator>,
    /// Voxels of the built-in scenes.
    pub voxels: Option<u64>,
    /// Trees, rocks and lamps of the built-in scene `forest`.
    pub instances: Option<u32>,
    /// Sizes of the built-in scenes for frame time and memory against voxels; zeros are left out.
    pub sweep: Option<Vec<u64>>,
    /// Device by its number or a part of its name.
    pub device: Option<String>,
    /// Folder of the report, made if it is not there.
    pub output: PathBuf,
    /// Where reports of the driver probes are kept.
    pub probes: Option<Cache>,
    /// The command that asks, as it would be typed again; for the report.
    pub command: Option<String>,
    /// The commit that the program was built from, where it is known; for the report.
    pub commit: Option<String>,
    /// What tells the host's options about scenes (how they are read, seen and lit) from others; a benchmark that goes on needs the same.
    pub scene_options: Option<String>,
    /// Whether the driver is not probed: it says more about the driver than about the scene.
    pub skip_probes: bool,
}

impl Request {
    /// Takes from a plan what is not asked for otherwise.
    pub fn follow(&mut self, plan: PlanFile) {
        if self.scenes.is_empty() {
            self.scenes = plan.scenes;
        }
        if self.cells.is_empty() && !self.full {
            self.cells = plan.cells;
        }
        self.frames = self.frames.or(plan.frames);
        self.warm_up = self.warm_up.or(plan.warm_up);
        self.time_limit = self.time_limit.or(plan.time_limit);
        self.size = self.size.or(plan.size);
        self.max_bounces = self.max_bounces.or(plan.max_bounces);
        self.integrator = self.integrator.or(plan.integrator);
        self.voxels = self.voxels.or(plan.voxels);
        self.instances = self.instances.or(plan.instances);
        self.sweep = self.sweep.take().or(plan.sweep);
        self.device = self.device.take().or(plan.device);
        self.precise |= plan.precise;
    }

    /// The scenes that are asked for.
    pub(crate) fn entries(&self) -> Vec<SceneEntry> {
        match self.scenes.is_empty() {
            true => scenes::STUDY_NAMES.map(SceneEntry::named).to_vec(),
            false => self.scenes.clone(),
        }
    }

    /// The cells that are named, in their order, repetitions included.
    pub(crate) fn named_cells(&self) -> Result<Vec<Cell>, CellError> {
        let cells: Result<Vec<_>, _> = self.cells.iter().map(|cell| cell::parse(cell)).collect();
        Ok(cells?.concat())
    }

    /// Whether the cells that are named need no device.
    pub(crate) fn is_cpu_alone(&self) -> bool {
        let wants_gpu = self.cells.iter().any(|cell| !cell.starts_with(Traversal::Cpu.name()));
        self.device.is_none() && !self.cells.is_empty() && !wants_gpu
    }

    /// The plan on a device; `named` are the cells that are asked for.
    pub(crate) fn plan(&self, named: Vec<Cell>, device: Option<&DeviceInfo>) -> Plan {
        let mut cells = if named.is_empty() { cell::planned(device, self.full) } else { named };
        keep_first(&mut cells);
        let is_hardware = device.is_some_and(|device| device.kind != DeviceKind::Cpu);
        let is_slow = device.is_some() && !is_hardware;
        let (width, height) = self.size.unwrap_or(if self.quick && is_slow { QUICK_SOFTWARE_SIZE } else { STUDY_SIZE });
        let usual = || usual_sweep(is_hardware).filter(|_| !self.quick).collect();
        let mut sweep: Vec<u64> = self.sweep.clone().unwrap_or_else(usual);
        sweep.retain(|&size| size > 0);
        keep_first(&mut sweep);
        let integrator = self.integrator.unwrap_or(Integrator::Essay);
        Plan {
            scenes: self.entries().iter().map(SceneEntry::title).collect(),
            cells,
            voxels: self.voxels.or((self.quick && is_slow).then_some(QUICK_SOFTWARE_VOXELS)),
            instances: self.instances,
            sweep,
            frames: self.frames.unwrap_or(if self.quick { QUICK_FRAMES } else { FRAMES }),
            warm_up: self.warm_up.unwrap_or(WARM_UP),
            time_limit_s: self.limit().map(|limit| limit.as_secs_f64()),
            width,
            height,
            max_bounces: self.max_bounces.unwrap_or_else(|| usual_bounces(integrator)),
            integrator,
            seed: SEED,
            is_exact: self.precise,
            scene_options: self.scene_options.clone(),
        }
    }

    /// A round's share of the frames of a cell and of their time, of so many rounds. On a device without a time limit the share is of the
    /// minute that software has.
    pub fn share(&self, rounds: u32) -> (u32, Duration) {
        let frames = self.frames.unwrap_or(if self.quick { QUICK_FRAMES } else { FRAMES });
        (frames.div_ceil(rounds), self.limit().unwrap_or(SOFTWARE_LIMIT) / rounds)
    }

    /// Whether the size of the pictures is to be found: of a quick benchmark on the processor, which says none.
    pub(crate) fn chooses_size(&self, named: &[Cell], device: Option<&DeviceInfo>) -> bool {
        let mut cells = if named.is_empty() { cell::planned(device, self.full) } else { named.to_vec() }.into_iter();
        self.quick && self.size.is_none() && cells.all(|cell| cell.traversal == Traversal::Cpu)
    }

    /// Frames of a cell that there must be although its time is over.
    pub(crate) fn least_frames(&self, frames: u32) -> u32 {
        if self.quick && self.time_limit.is_none() { LEAST_FRAMES.min(frames) } else { 1 }
    }

    fn limit(&self) -> Option<Duration> {
        self.time_limit.or(self.quick.then_some(QUICK_LIMIT))
    }

    /// Most time of the frames of a cell that is measured beside, or on, a device.
    pub(crate) fn limit_of(&self, cell: Cell, device: Option<&DeviceInfo>) -> Option<Duration> {
        let is_software = device.is_none_or(|device| device.kind == DeviceKind::Cpu);
        let own = match cell.traversal {
            Traversal::Cpu if !is_software => Some(BESIDE_LIMIT),
            _ => is_software.then_some(SOFTWARE_LIMIT),
        };
        self.limit().or(own)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_for_has_the_last_word_over_a_plan_and_a_plan_over_defaults() {
        let plan = PlanFile { frames: Some(7), warm_up: Some(1), cells: vec!["walk".into()], ..PlanFile::default() };
        let mut request = Request { frames: Some(3), sweep: Some(vec![0]), ..Request::default() };
        request.follow(plan);
        assert_eq!(request.cells, ["walk"]);
        let plan = request.plan(request.named_cells().unwrap(), None);
        assert_eq!((plan.frames, plan.warm_up, plan.max_bounces), (3, 1, 3));
        assert_eq!(plan.integrator, Integrator::Essay);
        assert_eq!((plan.scenes.len(), plan.sweep.len(), (plan.width, plan.height)), (3, 0, STUDY_SIZE));
    }

    #[test]
    fn a_plan_s_integrator_brings_its_own_bounces_and_an_option_overrides_it() {
        let plan = || PlanFile { integrator: Some(Integrator::Path), ..PlanFile::default() };
        let of = |mut request: Request| {
            request.follow(plan());
            let plan = request.plan(Vec::new(), None);
            (plan.integrator, plan.max_bounces)
        };
        assert_eq!(of(Request::default()), (Integrator::Path, 8));
        assert_eq!(of(Request { max_bounces: Some(2), ..Request::default() }), (Integrator::Path, 2));
        assert_eq!(of(Request { integrator: Some(Integrator::Essay), ..Request::default() }), (Integrator::Essay, 3));
    }

    #[test]
    fn a_cell_that_is_named_twice_is_measured_once_and_an_unknown_one_is_refused() {
        let request =
            |cells: &[&str]| Request { cells: cells.iter().map(ToString::to_string).collect(), ..Request::default() };
        let twice = request(&["cpu", "walk", "cpu"]);
        assert_eq!(twice.plan(twice.named_cells().unwrap(), None).cells.len(), 2);
        let sizes = Request { sweep: Some(vec![7000, 5000, 0, 7000]), ..Request::default() };
        assert_eq!(sizes.plan(Vec::new(), None).sweep, [7000, 5000], "or some of it would never be measured");
        assert!(request(&["cpu", "gpu"]).named_cells().is_err());
        assert!(request(&["cpu"]).is_cpu_alone() && !twice.is_cpu_alone() && !request(&[]).is_cpu_alone());
    }
}
