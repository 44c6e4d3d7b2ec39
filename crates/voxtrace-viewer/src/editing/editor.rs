//! The thread that owns the scene while it is edited: jobs in, patches and what undo can take back out. The window never waits for it.

use super::job::{Done, Job, Step, Steps, Told};
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::time::{Duration, Instant};
use voxtrace::PackedScene;
use voxtrace::changes::{MaterialChange, SceneChanges};
use voxtrace::dynamic::{Clip, DynamicScene, Edit, EditError};
use voxtrace::packed::PackedMaterial;

/// Bytes that undo and redo keep.
pub const UNDO_BYTES: u64 = 256 << 20;
/// Jobs that wait are done together for so long, then what they changed is told.
const BETWEEN_PATCHES: Duration = Duration::from_millis(15);

/// The thread.
pub struct Editor {
    jobs: Sender<Job>,
    told: Receiver<Told>,
}

impl Editor {
    /// Begins to edit a scene with changed materials. `wake` is called on the thread whenever it told something.
    pub fn start(scene: Arc<PackedScene>, materials: Vec<MaterialChange>, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        Self::owning(wake, move |jobs, tell| run(&scene, materials, jobs, tell))
    }

    /// Goes on with a scene that was begun in the window, which shows it as `base`.
    pub fn begun(scene: DynamicScene, base: Arc<PackedScene>, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        Self::owning(wake, move |jobs, tell| {
            if tell(Told::Ready { base, is_same: true }) {
                work(Work::new(scene), jobs, tell);
            }
        })
    }

    /// The thread, which tells by the function that it is given as long as somebody hears it.
    fn owning(
        wake: Arc<dyn Fn() + Send + Sync>,
        run: impl FnOnce(&Receiver<Job>, &dyn Fn(Told) -> bool) + Send + 'static,
    ) -> Self {
        let (jobs, of_window) = channel();
        let (sender, told) = channel();
        std::thread::spawn(move || {
            threads::yield_to_window();
            let tell = |told| {
                // The window may be closed, or show another scene.
                let is_heard = sender.send(told).is_ok();
                wake();
                is_heard
            };
            let end = catch_unwind(AssertUnwindSafe(|| run(&of_window, &tell)));
            if end.is_err() {
                tell(Told::Failed(tr!("edit.fault").into()));
            }
        });
        Self { jobs, told }
    }

    /// Asks for something to be done.
    pub fn send(&self, job: Job) {
        // Where the thread has ended, it has told why.
        let _ = self.jobs.send(job);
    }

    /// What was told, oldest first.
    pub fn take(&self) -> Option<Told> {
        self.told.try_recv().ok()
    }
}

fn run(scene: &Arc<PackedScene>, materials: Vec<MaterialChange>, jobs: &Receiver<Job>, tell: &dyn Fn(Told) -> bool) {
    let base = match threads::aside(|| based(scene, materials)) {
        Ok(base) => base,
        Err(error) => {
            tell(Told::Failed(error));
            return;
        }
    };
    let own = match threads::aside(|| DynamicScene::new((*base).clone())) {
        Ok(dynamic) => Work::new(dynamic),
        Err(EditError::SmoothNormals) => {
            tell(Told::Failed(tr!("edit.smooth_normals").into()));
            return;
        }
        Err(error) => {
            tell(Told::Failed(error.to_string()));
            return;
        }
    };
    let is_same = Arc::ptr_eq(&base, scene);
    if tell(Told::Ready { base, is_same }) {
        work(own, jobs, tell);
    }
}

/// Does jobs until there is nobody who gives them.
fn work(mut work: Work, jobs: &Receiver<Job>, tell: &dyn Fn(Told) -> bool) {
    while let Ok(job) = jobs.recv() {
        let since = Instant::now();
        let mut next = Some(job);
        while let Some(job) = next {
            if let Some(copied) = threads::aside(|| work.carry_out(job))
                && !tell(copied)
            {
                return;
            }
            next = match jobs.try_recv() {
                Ok(job) if since.elapsed() < BETWEEN_PATCHES => Some(job),
                Ok(job) => {
                    if !tell(work.told()) {
                        return;
                    }
                    threads::aside(|| work.carry_out(job)).into_iter().for_each(|copied| _ = tell(copied));
                    None
                }
                Err(TryRecvError::Empty | TryRecvError::Disconnected) => None,
            };
        }
        if !tell(work.told()) {
            return;
        }
    }
}

/// The scene as it is edited: with instances apart and other materials.
fn based(scene: &Arc<PackedScene>, materials: Vec<MaterialChange>) -> Result<Arc<PackedScene>, String> {
    let mut base = if scene.is_merged() { Arc::new(scene.split()) } else { Arc::clone(scene) };
    if !materials.is_empty() {
        let changes = SceneChanges { materials, hidden: Vec::new() };
        base = Arc::new(changes.apply(&base).map_err(|error| error.to_string())?);
    }
    Ok(base)
}

/// The scene with its steps.
struct Work {
    scene: DynamicScene,
    steps: Steps,
    next_serial: u64,
    /// Whether nothing has changed yet of the step that was begun last.
    is_fresh: bool,
    /// Whether the window has a copy of its own.
    is_known: bool,
    /// What was copied last.
    clip: Option<Arc<Clip>>,
    done: Done,
}

impl Work {
    fn new(mut scene: DynamicScene) -> Self {
        scene.set_undo_limit(UNDO_BYTES);
        let steps = Steps::default();
        Self { scene, steps, next_serial: 1, is_fresh: true, is_known: false, clip: None, done: Done::default() }
    }

    /// Does a job. Returns what is to be told at once.
    fn carry_out(&mut self, job: Job) -> Option<Told> {
        if !matches!(job, Job::Copy { .. } | Job::Turn { .. }) {
            self.make_known();
        }
        let result = match job {
            Job::Edit { grid, edits, name, joins } => self.edit(grid, &edits, name, joins),
            Job::Undo(count) => self.travel(count, true),
            Job::Redo(count) => self.travel(count, false),
            Job::Materials(materials) => {
                if let Err(error) = self.change_materials(materials) {
                    self.done.error = Some(error);
                }
                Ok(())
            }
            Job::AddMaterial(material) => self.scene.add_material(&material).map(|added| self.done.added = Some(added)),
            Job::Copy { grid, region, is_move } => match self.scene.copy(grid, region) {
                Ok(clip) => {
                    let (count, clip) = (clip.voxels().voxels().count() as u64, Arc::new(clip));
                    self.clip = Some(Arc::clone(&clip));
                    return Some(Told::Copied { clip, count, grid, region, is_move });
                }
                Err(error) => Err(error),
            },
            Job::Turn { axis, is_mirror } => {
                let clip = self.clip.as_ref()?;
                let turned = Arc::new(if is_mirror { clip.mirrored(axis) } else { clip.turned(axis, 1) });
                self.clip = Some(Arc::clone(&turned));
                return Some(Told::Turned(turned));
            }
        };
        if let Err(error) = result {
            self.done.error = Some(error.to_string());
        }
        self.reconcile();
        None
    }

    /// Before the first edit the window gets the scene as it is, in arrays of its own.
    fn make_known(&mut self) {
        if !std::mem::replace(&mut self.is_known, true) {
            self.done.base = Some(Arc::new(self.scene.scene().unshared()));
        }
    }

    fn edit(&mut self, grid: u32, edits: &[Edit], name: &'static str, joins: bool) -> Result<(), EditError> {
        self.is_fresh |= !joins;
        for edit in edits {
            let edited = match self.is_fresh {
                true => self.scene.edit(grid, edit)?,
                false => self.scene.edit_on(grid, edit)?,
            };
            if edited.bricks == 0 {
                continue;
            }
            if std::mem::take(&mut self.is_fresh) {
                self.steps.undone.clear();
                self.steps.done.push(Step { name, voxels: 0, serial: self.next_serial });
                self.next_serial += 1;
            }
            if let Some(step) = self.steps.done.last_mut() {
                step.voxels += edited.voxels;
            }
        }
        Ok(())
    }

    fn travel(&mut self, count: usize, is_back: bool) -> Result<(), EditError> {
        self.is_fresh = true;
        for _ in 0..count {
            let did = if is_back { self.scene.undo()? } else { self.scene.redo()? };
            if did.is_none() {
                break;
            }
            let (from, to) = match is_back {
                true => (&mut self.steps.done, &mut self.steps.undone),
                false => (&mut self.steps.undone, &mut self.steps.done),
            };
            to.extend(from.pop());
        }
        Ok(())
    }

    /// Drops steps that were forgotten for their bytes.
    fn reconcile(&mut self) {
        let (undo, redo) = self.scene.undo_steps();
        let drop_oldest = |steps: &mut Vec<Step>, count: usize| {
            let forgotten = steps.len().saturating_sub(count);
            steps.drain(..forgotten).count() > 0
        };
        self.steps.has_forgotten |= drop_oldest(&mut self.steps.done, undo);
        drop_oldest(&mut self.steps.undone, redo);
        self.steps.bytes = self.scene.undo_size_bytes();
    }

    fn change_materials(&mut self, materials: Vec<MaterialChange>) -> Result<(), String> {
        let own = self.scene.scene().materials();
        let colors: Vec<(u16, PackedMaterial)> = (materials.iter())
            .filter_map(|change| {
                let own = own.get(change.number)?;
                let emission = change.emission.unwrap_or(own.emission);
                Some((change.number as u16, PackedMaterial { base_color: change.base_color, emission, ..*own }))
            })
            .collect();
        self.done.is_recolored = true;
        // Those of which more changes are left, and all are taken anew.
        if colors.into_iter().filter(|(number, material)| !self.scene.recolor(*number, *material)).count() == 0 {
            return Ok(());
        }
        let changes = SceneChanges { materials, hidden: Vec::new() };
        let compact = self.scene.compact();
        if compact.grids().len() < self.scene.scene().grids().len() {
            return Err(tr!("edit.glow_of_nothing").into());
        }
        let scene = changes.apply(&compact).map_err(|error| error.to_string())?;
        let mut dynamic = DynamicScene::new(scene).map_err(|error| error.to_string())?;
        dynamic.set_undo_limit(UNDO_BYTES);
        self.scene = dynamic;
        self.steps.has_forgotten |= !self.steps.done.is_empty();
        (self.steps.done, self.steps.undone, self.steps.bytes) = (Vec::new(), Vec::new(), 0);
        self.done = Done {
            is_recolored: true,
            base: Some(Arc::new(self.scene.scene().unshared())),
            is_other: true,
            ..Done::default()
        };
        Ok(())
    }

    /// What was done since this was asked last.
    fn told(&mut self) -> Told {
        let mut done = std::mem::take(&mut self.done);
        done.patch = Some(self.scene.take_patch()).filter(|patch| !patch.is_empty()).map(Arc::new);
        done.steps = self.steps.clone();
        Told::Done(Box::new(done))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;
    use std::path::Path;
    use voxtrace::glam::IVec3;
    use voxtrace::{Material, Scene, VoxelGrid};
    use voxtrace_vulkan::Traversal;

    #[test]
    fn after_a_fault_edits_can_be_saved_and_nobody_is_told_to_wait() {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let scene = Scene::from_grid("one", grid, vec![Material::default()]);
        let mut session = Session::new(Traversal::Cpu);
        session.show("one".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
        session.toggle_editing();
        let editing = session.editing.as_mut().unwrap();
        editing.editor = Some(Editor::owning(Arc::new(|| ()), |_, _| panic!("a fault that is planted")));
        editing.is_ready = true;
        editing.steps.done.push(Step { name: "place", voxels: 1, serial: 1 });
        let since = Instant::now();
        while session.editing.as_ref().is_some_and(|editing| editing.editor.is_some()) {
            assert!(since.elapsed() < Duration::from_secs(60), "nobody told of the fault");
            session.take_edited();
        }
        for _ in 0..2 {
            assert!(session.has_unsaved_edits() && !session.is_editing());
            let last = session.messages().last().unwrap();
            assert!(last.is_error && last.text.contains(tr!("edit.fault")), "{last:?}");
            session.dismiss_errors();
            session.toggle_editing();
        }
        // Once they are saved, nobody is asked to save them.
        session.begin_saving(Path::new("one.vxt"));
        session.end_saving(true);
        session.toggle_editing();
        let lines: Vec<String> = session.messages().map(|message| message.text.clone()).collect();
        assert!(
            !session.has_unsaved_edits() && lines.iter().all(|line| !line.contains(tr!("edit.fault"))),
            "{lines:?}"
        );
        assert!(lines.last().is_some_and(|line| line.contains(tr!("edit.fault_saved"))), "{lines:?}");
    }
}
