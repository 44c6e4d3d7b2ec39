//! The panel of parts: layers, groups and objects by name, each shown or hidden.

use super::counted;
use crate::keys::Action;
use crate::session::Session;
use egui::{Checkbox, CollapsingHeader, ScrollArea, Ui};
use voxtrace::packed::Outline;

/// Points of a list before it scrolls.
const HEIGHT: f32 = 180.0;

/// How many objects of a part there are, and how many of them are seen.
#[derive(Clone, Copy, Default)]
struct Seen {
    all: usize,
    visible: usize,
}

pub fn parts(ui: &mut Ui, session: &mut Session) {
    let Some(open) = &session.open else { return };
    let outline = std::sync::Arc::clone(&open.outline);
    if outline.objects.len() < 2 && outline.layers.is_empty() && outline.groups.is_empty() {
        return;
    }
    let hidden = open.is_visible.iter().filter(|is_visible| !**is_visible).count();
    let title = if hidden > 0 { format!("Parts ({hidden} hidden)") } else { "Parts".into() };
    CollapsingHeader::new(title).id_salt("parts").show(ui, |ui| {
        let (layers, groups) = counts(&outline, session);
        let layer_names = outline.layers.iter().zip(layers).enumerate().filter(|(_, (_, seen))| seen.all > 0);
        for (index, (name, seen)) in layer_names {
            part(ui, session, &called(name, "layer", index), seen, |outline, object| {
                outline.objects[object].layer == Some(index)
            });
        }
        for (index, (group, seen)) in outline.groups.iter().zip(groups).enumerate() {
            part(ui, session, &called(&group.name, "group", index), seen, |outline, object| {
                outline.is_in_group(&outline.objects[object], index)
            });
        }
        ui.label(counted(outline.objects.len() as u64, "object"));
        let (height, count) = (ui.spacing().interact_size.y, outline.objects.len());
        ScrollArea::vertical().id_salt("objects").max_height(HEIGHT).show_rows(ui, height, count, |ui, rows| {
            for index in rows {
                let is_visible = session.open.as_ref().is_some_and(|open| open.is_visible.get(index) == Some(&true));
                let seen = Seen { all: 1, visible: usize::from(is_visible) };
                part(ui, session, &called(&outline.objects[index].name, "object", index), seen, |_, object| {
                    object == index
                });
            }
        });
        let hides = |open: &crate::open::Open| !open.changes().0.hidden.is_empty();
        if session.open.as_ref().is_some_and(hides) && ui.button("show what was hidden here").clicked() {
            session.act(Action::ShowAll, None);
        }
    });
}

/// A part's name with its number, as `--hide` takes both.
fn called(name: &str, kind: &str, index: usize) -> String {
    if name.is_empty() { format!("{kind} {index}") } else { format!("{kind} {index}: {name}") }
}

/// A box that shows a part or hides it.
fn part(ui: &mut Ui, session: &mut Session, name: &str, seen: Seen, holds: impl Fn(&Outline, usize) -> bool) {
    let mut is_visible = seen.visible > 0;
    let is_some = seen.visible > 0 && seen.visible < seen.all;
    if ui.add(Checkbox::new(&mut is_visible, name).indeterminate(is_some)).changed() {
        let Some(open) = &session.open else { return };
        let objects: Vec<usize> =
            (0..open.outline.objects.len()).filter(|&object| holds(&open.outline, object)).collect();
        // What is seen in part is seen whole after a click.
        session.set_visible(&objects, is_some || is_visible);
    }
}

/// What is seen of each layer and of each group.
fn counts(outline: &Outline, session: &Session) -> (Vec<Seen>, Vec<Seen>) {
    let mut layers = vec![Seen::default(); outline.layers.len()];
    let mut groups = vec![Seen::default(); outline.groups.len()];
    let Some(open) = &session.open else { return (layers, groups) };
    for (object, &is_visible) in outline.objects.iter().zip(&open.is_visible) {
        let mut count = |seen: &mut Seen| {
            seen.all += 1;
            seen.visible += usize::from(is_visible);
        };
        object.layer.and_then(|layer| layers.get_mut(layer)).into_iter().for_each(&mut count);
        let mut around = object.group;
        while let Some(group) = around {
            groups.get_mut(group).into_iter().for_each(&mut count);
            around = outline.groups.get(group).and_then(|found| found.parent).filter(|&parent| parent < group);
        }
    }
    (layers, groups)
}
