//! The scene that is shown, with what was changed about it: materials, and which parts are seen.

use crate::motion::Plays;
use crate::render_settings::RenderSettings;
use crate::skies::MadeSky;
use crate::threads;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};
use voxtrace::changes::{ChangeError, MaterialChange, PartName, SceneChanges, visible_parts};
use voxtrace::packed::{Outline, PackedGrid};
use voxtrace::{Hit, PackedScene};

/// The scene that is shown.
pub struct Open {
    /// Its path or name.
    pub source: String,
    /// As it was read.
    pub original: Arc<PackedScene>,
    /// That with all instances apart, once they are needed so: to hide some, or to draw lines.
    pub(crate) apart: Option<Arc<PackedScene>>,
    /// With other materials and without what is hidden.
    pub alone: Arc<PackedScene>,
    /// That on a ground and in fog, where there are any.
    pub changed: Arc<PackedScene>,
    /// That in the light of the settings, with their cuts.
    pub lit: Arc<PackedScene>,
    /// The scene alone in the same light, with the same cuts: what can be picked, and what is written to a file.
    pub pickable: Arc<PackedScene>,
    /// The box whose walls take voxels, of a scene that was begun here.
    pub canvas: Option<voxtrace::grid::VoxelBox>,
    /// Whether its file is read otherwise where the scene is cut: with what nobody sees inside.
    pub depends_on_cuts: bool,
    /// What its file brings along that plays.
    pub plays: Plays,
    /// Voxels of its grids, each once.
    pub voxels: u64,
    /// Its parts, with what its file hides.
    pub outline: Arc<Outline>,
    /// For each object whether it is to be seen.
    pub is_visible: Vec<bool>,
    /// Materials that were changed, by their number.
    pub materials: BTreeMap<usize, MaterialChange>,
    /// Those of them that the scene has by now, because it is edited.
    pub baked: BTreeMap<usize, MaterialChange>,
    used: Arc<OnceLock<Vec<usize>>>,
    is_used_asked: Cell<bool>,
}

impl Open {
    /// A scene as it was read.
    pub fn new(source: String, scene: Arc<PackedScene>) -> Self {
        let voxels = scene.grids().iter().map(PackedGrid::voxel_count).sum();
        let outline = Arc::clone(&scene.outline);
        Self {
            source,
            canvas: None,
            depends_on_cuts: false,
            plays: Plays::Nothing,
            voxels,
            is_visible: outline.objects.iter().map(|object| !object.is_hidden).collect(),
            outline,
            alone: Arc::clone(&scene),
            changed: Arc::clone(&scene),
            lit: Arc::clone(&scene),
            pickable: Arc::clone(&scene),
            original: scene,
            apart: None,
            materials: BTreeMap::new(),
            baked: BTreeMap::new(),
            used: Arc::default(),
            is_used_asked: Cell::new(false),
        }
    }

    /// The same scene read again, with parts that its file hides; what was changed stays.
    pub fn read_again(self, scene: Arc<PackedScene>) -> Self {
        let Self { source, outline, is_visible, materials, depends_on_cuts, plays, .. } = self;
        // The file may have become another one.
        match scene.outline.objects.len() == outline.objects.len() {
            true => Self { outline, is_visible, materials, depends_on_cuts, plays, ..Self::new(source, scene) },
            false => Self { depends_on_cuts, plays, ..Self::new(source, scene) },
        }
    }

    /// What was changed, and the parts that are shown although the file hides them.
    pub fn changes(&self) -> (SceneChanges, Vec<PartName>) {
        let (hidden, shown) = visible_parts(&self.outline, &self.is_visible);
        let mut materials = self.baked.clone();
        materials.extend(self.materials.iter().map(|(number, change)| (*number, *change)));
        (SceneChanges { materials: materials.into_values().collect(), hidden }, shown)
    }

    /// Whether objects are to be seen that the file hides and that were not read.
    pub fn lacks_objects(&self) -> bool {
        let read = self.original.outline.objects.iter();
        read.zip(&self.is_visible).any(|(object, &is_visible)| is_visible && object.is_hidden)
    }

    /// Hides again what the file hides, was to be seen and cannot be read.
    pub fn hide_unread(&mut self) {
        for (object, is_visible) in self.original.outline.objects.iter().zip(&mut self.is_visible) {
            *is_visible &= !object.is_hidden;
        }
    }

    /// Makes the scene with the changes, without anything around it, and with its instances apart where it `has_lines`. What is shown stays.
    ///
    /// # Errors
    /// [`ChangeError`] where the scene has no such material or part.
    pub fn update(&mut self, has_lines: bool) -> Result<(), ChangeError> {
        let materials = self.materials.values().copied().collect();
        let changes = SceneChanges { hidden: self.hidden_parts(), materials };
        let scene = if has_lines || !changes.hidden.is_empty() { self.apart() } else { Arc::clone(&self.original) };
        self.alone = match changes.is_empty() {
            true => scene,
            false => Arc::new(threads::aside(|| changes.apply(&scene))?),
        };
        Ok(())
    }

    /// What is hidden of what was read: an object that the file hides may have been shown, and hidden again.
    pub(crate) fn hidden_parts(&self) -> Vec<PartName> {
        visible_parts(&self.original.outline, &self.is_visible).0
    }

    /// The scene as it was read, with all instances apart.
    fn apart(&mut self) -> Arc<PackedScene> {
        if !self.original.is_merged() {
            return Arc::clone(&self.original);
        }
        let apart = || Arc::new(threads::aside(|| self.original.split()));
        Arc::clone(self.apart.get_or_insert_with(apart))
    }

    /// The scene with all instances apart, whose boxes are those of its objects.
    pub(crate) fn apart_for_bounds(&mut self) -> Arc<PackedScene> {
        self.apart()
    }

    /// Puts the scene into the light of the settings, under a sky that was made for them.
    pub fn set_light(&mut self, settings: &RenderSettings, made: Option<&MadeSky>) {
        self.lit = Arc::new(settings.lit(&self.changed, made));
        self.pickable = match Arc::ptr_eq(&self.changed, &self.alone) {
            true => Arc::clone(&self.lit),
            false => Arc::new(settings.lit(&self.alone, made)),
        };
    }

    /// Numbers of the materials that a voxel has, once they are known. A thread finds them when they are first asked for: it takes a look at
    /// every brick.
    pub fn used_materials(&self) -> Option<&[usize]> {
        if !self.is_used_asked.replace(true) {
            let (used, geometry) = (Arc::clone(&self.used), Arc::clone(self.original.geometry()));
            std::thread::spawn(move || {
                let is_used = threads::aside(|| geometry.used_materials());
                // Nobody else sets it.
                let _ = used.set((0..is_used.len()).filter(|&number| is_used[number]).collect());
            });
        }
        self.used.get().map(Vec::as_slice)
    }

    /// A hit of an object as the scene has it now, `None` where the object is not seen any more.
    pub(crate) fn hit_of_object(&self, hit: &Hit, object: usize) -> Option<Hit> {
        if self.object_of(hit) == Some(object) {
            return Some(*hit);
        }
        let mut hits = (0..self.pickable.instance_count()).map(|instance| Hit { instance: instance as u32, ..*hit });
        hits.find(|hit| self.object_of(hit) == Some(object))
    }

    /// The object that a hit met, by its number in the scene.
    pub fn object_of(&self, hit: &Hit) -> Option<usize> {
        ((hit.instance as usize) < self.pickable.instance_count()).then(|| self.pickable.scene_instance(hit))
    }
}
