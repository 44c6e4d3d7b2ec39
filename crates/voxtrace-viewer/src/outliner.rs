//! The parts of a scene as a tree, for people: layers, groups, models and objects, searched by name, isolated, and found from a picked voxel. Rows
//! are made once for what is searched and opened; a list of them shows those that are in sight.

mod rows;

use crate::navigation::Motion;
use crate::session::Session;
use crate::tr;
use rows::rows;
use std::collections::HashSet;
use std::sync::Arc;
use voxtrace::PackedScene;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::packed::Outline;

/// What is shown around a part, voxels.
const AROUND: f32 = 2.0;

/// A part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Part {
    /// A layer, by its number.
    Layer(usize),
    /// A group, by its number.
    Group(usize),
    /// All objects of one model, by the number of its grid.
    Model(usize),
    /// An object.
    Object(usize),
}

/// What stands on the first level of the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Order {
    /// Layers and groups, then all objects.
    #[default]
    All,
    /// Layers, in them objects.
    Layers,
    /// Groups, in them groups and objects.
    Groups,
    /// Models, in them objects.
    Models,
    /// Objects alone.
    Objects,
}

impl Order {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::All, Self::Layers, Self::Groups, Self::Models, Self::Objects];
}

/// A line of the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Which part.
    pub part: Part,
    /// How far in it stands.
    pub depth: usize,
    /// How many objects it has.
    pub objects: usize,
    /// Whether something stands below it.
    pub has_more: bool,
}

/// The tree with what somebody does there.
#[derive(Default)]
pub struct Outliner {
    /// What is searched for, in names and numbers.
    pub search: String,
    /// What stands on the first level.
    pub order: Order,
    /// Parts whose own parts are shown.
    pub opened: HashSet<Part>,
    /// The part that was clicked.
    pub selected: Option<Part>,
    /// Whether the list is to move to the one that is selected.
    pub scrolls: bool,
    /// What was seen before a part was isolated.
    before: Option<Vec<bool>>,
    rows: Option<(Key, Arc<Tree>)>,
}

/// What rows are made of.
#[derive(Clone, PartialEq)]
struct Key {
    scene: usize,
    search: String,
    order: Order,
    opened: Vec<Part>,
}

/// Rows, and the model of each object.
pub struct Tree {
    /// The rows that are shown.
    pub rows: Vec<Row>,
    models: Arc<Vec<Option<usize>>>,
}

/// The model of each object: the number of its grid among those that there are, `None` where it is not read.
pub fn models(scene: &PackedScene, outline: &Outline) -> Vec<Option<usize>> {
    let mut models = vec![None; outline.objects.len()];
    for instance in scene.instances() {
        if let Some(model) = models.get_mut(instance.scene_instance as usize) {
            *model = Some(instance.grid as usize);
        }
    }
    models
}

/// A part's name with its number, as `--hide` takes both.
pub fn name_of(outline: &Outline, part: Part) -> String {
    let named = |kind: &str, number: usize, name: &str| match name.is_empty() {
        true => format!("{kind} {number}"),
        false => format!("{kind} {number}: {name}"),
    };
    match part {
        Part::Layer(number) => named("layer", number, outline.layers.get(number).map_or("", String::as_str)),
        Part::Group(number) => {
            named("group", number, outline.groups.get(number).map_or("", |group| group.name.as_str()))
        }
        Part::Model(number) => named(tr!("outliner.model"), number, ""),
        Part::Object(number) => {
            named("object", number, outline.objects.get(number).map_or("", |object| object.name.as_str()))
        }
    }
}

impl Session {
    /// The rows of the tree, as they are searched, ordered and opened now.
    pub fn outline_rows(&mut self) -> Option<Arc<Tree>> {
        let open = self.open.as_mut()?;
        let outliner = &mut self.outliner;
        let mut opened: Vec<Part> = outliner.opened.iter().copied().collect();
        opened.sort();
        let scene = Arc::as_ptr(&open.original) as usize;
        let key = Key { scene, search: outliner.search.trim().to_owned(), order: outliner.order, opened };
        if let Some((own, tree)) = outliner.rows.as_ref().filter(|(own, _)| *own == key) {
            let _ = own;
            return Some(Arc::clone(tree));
        }
        let known = outliner.rows.as_ref().filter(|(own, _)| own.scene == key.scene);
        let is_known = |tree: &&Tree| !tree.models.is_empty() || key.order != Order::Models;
        let models = match known.map(|(_, tree)| &**tree).filter(is_known) {
            Some(tree) => Arc::clone(&tree.models),
            // Of merged objects it has to be looked whose each was.
            None if key.order == Order::Models => Arc::new(models(&open.apart_for_bounds(), &open.outline)),
            None => Arc::default(),
        };
        let rows = rows(&open.outline, &models, &key, &outliner.opened);
        let tree = Arc::new(Tree { rows, models });
        outliner.rows = Some((key, Arc::clone(&tree)));
        Some(tree)
    }

    /// The objects of a part.
    pub fn objects_of(&mut self, part: Part) -> Vec<usize> {
        if let Part::Object(number) = part {
            return vec![number];
        }
        let models = self.outline_rows().map(|tree| Arc::clone(&tree.models));
        let Some(open) = &self.open else { return Vec::new() };
        let outline = &open.outline;
        let is_in = |object: usize| match part {
            Part::Layer(number) => outline.objects[object].layer == Some(number),
            Part::Group(number) => outline.is_in_group(&outline.objects[object], number),
            Part::Model(number) => models.as_ref().is_some_and(|models| models.get(object) == Some(&Some(number))),
            Part::Object(number) => object == number,
        };
        (0..outline.objects.len()).filter(|&object| is_in(object)).collect()
    }

    /// Shows this part alone; asked again, what was seen before.
    pub fn isolate(&mut self, part: Part) {
        let objects: HashSet<usize> = self.objects_of(part).into_iter().collect();
        let Some(open) = &self.open else { return };
        let wanted: Vec<bool> = (0..open.is_visible.len()).map(|object| objects.contains(&object)).collect();
        if open.is_visible == wanted
            && let Some(before) = self.outliner.before.take()
        {
            return self.set_visibility(before);
        }
        // Another part in place of an isolated one: what is brought back stays what was there first.
        let before = open.is_visible.clone();
        self.outliner.before.get_or_insert(before);
        self.set_visibility(wanted);
        self.say(tr!("outliner.isolated", name = self.part_name(part)), false);
    }

    /// Shows the object that was picked, or that is under the cursor, alone; asked again, what was seen before.
    pub fn isolate_picked(&mut self, cursor: Option<voxtrace::glam::Vec2>) {
        if self.outliner.before.is_some() {
            return self.bring_back();
        }
        let picked = self.picked.clone().or_else(|| cursor.and_then(|cursor| self.pick(cursor)));
        let object = picked.zip(self.open.as_ref()).and_then(|(picked, open)| open.object_of(&picked.hit));
        match object.map(Part::Object).or(self.outliner.selected) {
            Some(part) => self.isolate(part),
            None => self.say(tr!("outliner.nothing_picked"), false),
        }
    }

    /// Whether a part is shown alone.
    pub fn is_isolated(&self) -> bool {
        self.outliner.before.is_some()
    }

    /// Shows what was seen before a part was isolated.
    pub fn bring_back(&mut self) {
        if let Some(before) = self.outliner.before.take() {
            self.set_visibility(before);
        }
    }

    fn part_name(&self, part: Part) -> String {
        self.open.as_ref().map(|open| name_of(&open.outline, part)).unwrap_or_default()
    }

    /// Shows these objects and no others.
    fn set_visibility(&mut self, wanted: Vec<bool>) {
        let Some(open) = self.open.as_mut().filter(|open| open.is_visible.len() == wanted.len()) else { return };
        open.is_visible = wanted;
        // A change of none: the scene follows what is seen now.
        self.set_visible(&[], true);
    }

    /// A box around a part, world space; `None` of one that is not read.
    pub fn part_bounds(&mut self, part: Part) -> Option<(Vec3, Vec3)> {
        let objects: HashSet<usize> = self.objects_of(part).into_iter().collect();
        let scene = self.open.as_mut()?.apart_for_bounds();
        let boxes = scene.instances().iter().filter(|instance| objects.contains(&(instance.scene_instance as usize)));
        let corners = boxes.flat_map(|instance| {
            let grid = &scene.grids()[instance.grid as usize];
            (0..8).map(move |corner| {
                let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                instance.world_from_grid.point((grid.min + (grid.max - grid.min) * pick).as_vec3())
            })
        });
        corners.map(|point| (point, point)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }

    /// Flies to a part.
    pub fn show_part(&mut self, part: Part) {
        match self.part_bounds(part) {
            Some((min, max)) => self.move_by(Motion::Frame { min: min - AROUND, max: max + AROUND }),
            None => self.say(tr!("outliner.not_read"), false),
        }
    }

    /// Selects the object of the picked voxel in the tree, with what it lies in opened.
    pub fn select_picked(&mut self) {
        let Some(open) = &self.open else { return };
        let Some(object) = self.picked.as_ref().and_then(|picked| open.object_of(&picked.hit)) else { return };
        let outline = Arc::clone(&open.outline);
        self.outliner.search.clear();
        self.outliner.selected = Some(Part::Object(object));
        self.outliner.scrolls = true;
        let Some(own) = outline.objects.get(object) else { return };
        let mut group = own.group;
        while let Some(number) = group {
            self.outliner.opened.insert(Part::Group(number));
            group = outline.groups.get(number).and_then(|found| found.parent).filter(|&parent| parent < number);
        }
        self.outliner.opened.extend(own.layer.map(Part::Layer));
        let model = self.outline_rows().and_then(|tree| tree.models.get(object).copied().flatten());
        self.outliner.opened.extend(model.map(Part::Model));
    }
}
