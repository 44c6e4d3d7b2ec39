//! The parts of a scene as a tree, for people: layers, groups, models and objects, searched by name, isolated, and found from a picked voxel. Rows
//! are made once for what is searched and opened; a list of them shows those that are in sight.

use crate::navigation::Motion;
use crate::session::Session;
use crate::tr;
use std::collections::{BTreeMap, HashSet};
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

/// Makes rows.
struct Maker<'a> {
    outline: &'a Outline,
    opened: &'a HashSet<Part>,
    search: String,
    rows: Vec<Row>,
}

impl Maker<'_> {
    fn fits(&self, part: Part) -> bool {
        self.search.is_empty() || name_of(self.outline, part).to_lowercase().contains(&self.search)
    }

    /// A part with its objects, some of which may lie in groups. While one searches, everything that fits stands open.
    fn part(&mut self, part: Part, depth: usize, objects: &[usize]) {
        let fits = self.fits(part);
        let below: Vec<usize> = match fits {
            true => objects.to_vec(),
            false => objects.iter().copied().filter(|&object| self.fits(Part::Object(object))).collect(),
        };
        if below.is_empty() {
            return;
        }
        self.rows.push(Row { part, depth, objects: objects.len(), has_more: true });
        if self.opened.contains(&part) || (!self.search.is_empty() && !fits) {
            self.objects(depth + 1, &below);
        }
    }

    fn objects(&mut self, depth: usize, objects: &[usize]) {
        let rows = objects.iter().map(|&object| Row { part: Part::Object(object), depth, objects: 1, has_more: false });
        self.rows.extend(rows);
    }

    /// What is not in any part of the first level.
    fn rest(&mut self, objects: impl Iterator<Item = usize>) {
        let fitting: Vec<usize> = objects.filter(|&object| self.fits(Part::Object(object))).collect();
        self.objects(0, &fitting);
    }
}

/// The rows of a tree.
fn rows(outline: &Outline, models: &[Option<usize>], key: &Key, opened: &HashSet<Part>) -> Vec<Row> {
    let mut maker = Maker { outline, opened, search: key.search.to_lowercase(), rows: Vec::new() };
    let all = 0..outline.objects.len();
    let mut members: BTreeMap<Part, Vec<usize>> = BTreeMap::new();
    let layer_of = |object: usize| outline.objects[object].layer.map(Part::Layer);
    let group_of = |object: usize| outline.objects[object].group.map(Part::Group);
    let model_of = |object: usize| models.get(object).copied().flatten().map(Part::Model);
    let mut gather = |part_of: &dyn Fn(usize) -> Option<Part>| {
        for object in all.clone() {
            if let Some(part) = part_of(object) {
                members.entry(part).or_default().push(object);
            }
        }
    };
    let part_of: &dyn Fn(usize) -> Option<Part> = match key.order {
        Order::All => {
            gather(&layer_of);
            &group_of
        }
        Order::Layers => &layer_of,
        Order::Groups => &group_of,
        Order::Models => &model_of,
        Order::Objects => &|_| None,
    };
    gather(part_of);
    let has_groups = matches!(key.order, Order::All | Order::Groups);
    let flat = members.iter().filter(|(part, _)| !(has_groups && matches!(part, Part::Group(_))));
    flat.for_each(|(&part, objects)| maker.part(part, 0, objects));
    if has_groups {
        groups(&mut maker, &members, None, 0);
    }
    let is_rest = |object: &usize| key.order == Order::All || part_of(*object).is_none();
    maker.rest(all.filter(is_rest));
    maker.rows
}

/// Groups lie in each other.
fn groups(maker: &mut Maker, members: &BTreeMap<Part, Vec<usize>>, parent: Option<usize>, depth: usize) {
    let outline = maker.outline;
    for (number, _) in outline.groups.iter().enumerate().filter(|(number, group)| {
        // A parent comes before its groups: no circle.
        group.parent.filter(|parent| parent < number) == parent
    }) {
        let part = Part::Group(number);
        let all: Vec<usize> = (0..outline.objects.len())
            .filter(|&object| outline.is_in_group(&outline.objects[object], number))
            .collect();
        let is_found = maker.fits(part) || all.iter().any(|&object| maker.fits(Part::Object(object)));
        if all.is_empty() || !is_found {
            continue;
        }
        maker.rows.push(Row { part, depth, objects: all.len(), has_more: true });
        if maker.opened.contains(&part) || (!maker.search.is_empty() && !maker.fits(part)) {
            groups(maker, members, Some(number), depth + 1);
            let own = members.get(&part).cloned().unwrap_or_default();
            let fits = maker.fits(part);
            let own: Vec<usize> = own.into_iter().filter(|&object| fits || maker.fits(Part::Object(object))).collect();
            maker.objects(depth + 1, &own);
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

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::packed::Object;
    use voxtrace::scene::Group;

    fn outline() -> Outline {
        let object = |name: &str, layer, group| Object { name: name.into(), layer, group, is_hidden: false };
        Outline {
            objects: vec![
                object("oak", Some(0), Some(1)),
                object("fir", Some(0), Some(1)),
                object("house", Some(1), Some(0)),
                object("", None, None),
            ],
            layers: vec!["trees".into(), String::new()],
            groups: vec![
                Group { name: "village".into(), parent: None },
                Group { name: "wood".into(), parent: Some(0) },
            ],
        }
    }

    fn texts(order: Order, search: &str, opened: &[Part]) -> Vec<String> {
        let outline = outline();
        let key = Key { scene: 0, search: search.into(), order, opened: opened.to_vec() };
        let rows = rows(&outline, &[Some(4), Some(4), Some(7), None], &key, &opened.iter().copied().collect());
        rows.iter()
            .map(|row| format!("{}{} ({})", "-".repeat(row.depth), name_of(&outline, row.part), row.objects))
            .collect()
    }

    #[test]
    fn the_tree_begins_with_what_was_chosen_and_opens_what_was_opened() {
        let all = texts(Order::All, "", &[]);
        let rest = ["object 0: oak (1)", "object 1: fir (1)", "object 2: house (1)", "object 3 (1)"];
        assert_eq!(all[..3], ["layer 0: trees (2)", "layer 1 (1)", "group 0: village (3)"]);
        assert_eq!(all[3..], rest);
        assert_eq!(texts(Order::Objects, "", &[]), rest);
        let opened = [Part::Group(0), Part::Group(1)];
        let expected = [
            "group 0: village (3)",
            "-group 1: wood (2)",
            "--object 0: oak (1)",
            "--object 1: fir (1)",
            "-object 2: house (1)",
            "object 3 (1)",
        ];
        assert_eq!(texts(Order::Groups, "", &opened), expected);
        assert_ne!(texts(Order::Groups, "", &opened[..1]), expected, "the comparison sees what is closed");
        assert_eq!(texts(Order::Models, "", &[]), ["model 4 (2)", "model 7 (1)", "object 3 (1)"]);
    }

    #[test]
    fn a_search_shows_what_fits_and_what_it_lies_in() {
        assert_eq!(texts(Order::Layers, "FIR", &[]), ["layer 0: trees (2)", "-object 1: fir (1)"]);
        let nested = ["group 0: village (3)", "-group 1: wood (2)", "--object 1: fir (1)"];
        assert_eq!(texts(Order::Groups, "fir", &[]), nested);
        assert_eq!(texts(Order::Layers, "trees", &[]), ["layer 0: trees (2)"], "what is found need not be open");
        assert!(texts(Order::All, "nobody", &[]).is_empty());
    }
}
