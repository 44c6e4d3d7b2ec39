//! The rows of the tree of parts: what stands on its first level, what is open, and what a search finds.

use super::{Key, Order, Part, Row, name_of};
use std::collections::{BTreeMap, HashSet};
use voxtrace::packed::Outline;

/// Makes rows.
struct Maker<'a> {
    outline: &'a Outline,
    opened: &'a HashSet<Part>,
    search: String,
    /// Whether all objects follow below: then a search shows each of them there alone.
    is_flat: bool,
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
        if below.is_empty() || (!fits && self.is_flat) {
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
pub(super) fn rows(outline: &Outline, models: &[Option<usize>], key: &Key, opened: &HashSet<Part>) -> Vec<Row> {
    let mut maker = Maker {
        outline,
        opened,
        search: key.search.to_lowercase(),
        is_flat: key.order == Order::All,
        rows: Vec::new(),
    };
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
        let is_found = maker.fits(part) || !maker.is_flat && all.iter().any(|&object| maker.fits(Part::Object(object)));
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
