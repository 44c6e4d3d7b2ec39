//! The panel of parts: a tree of layers, groups, models and objects, each shown, hidden, isolated or flown to.

use super::{Noun, counted, name_node};
use crate::keys::Action;
use crate::outliner::{Order, Part, Row, name_of};
use crate::scale::grouped;
use crate::session::Session;
use crate::tr;
use egui::{Button, Checkbox, CollapsingHeader, ComboBox, ScrollArea, TextEdit, Ui};
use std::collections::HashMap;

/// Points of the list before it scrolls.
const HEIGHT: f32 = 220.0;

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
    let title = if hidden > 0 {
        tr!("outliner.title_hidden", count = grouped(hidden as f64, 0))
    } else {
        tr!("outliner.title").to_owned()
    };
    CollapsingHeader::new(title).id_salt("parts").show(ui, |ui| {
        ui.label(counted(outline.objects.len() as u64, Noun::Object));
        top(ui, session);
        list(ui, session);
        selected(ui, session);
        ui.horizontal_wrapped(|ui| {
            if session.is_isolated() && ui.button(tr!("outliner.bring_back")).clicked() {
                session.bring_back();
            }
            let hides = |open: &crate::open::Open| !open.changes().0.hidden.is_empty();
            if session.open.as_ref().is_some_and(hides) && ui.button(tr!("outliner.show_all")).clicked() {
                session.act(Action::ShowAll, None);
            }
        });
    });
}

/// What is searched for, and what the tree begins with.
fn top(ui: &mut Ui, session: &mut Session) {
    let outliner = &mut session.outliner;
    let hint = tr!("outliner.search");
    let field = ui.add(TextEdit::singleline(&mut outliner.search).hint_text(hint).desired_width(f32::INFINITY));
    name_node(ui, &field, hint);
    ComboBox::from_label(tr!("outliner.order")).selected_text(order_name(outliner.order)).show_ui(ui, |ui| {
        for order in Order::ALL {
            ui.selectable_value(&mut outliner.order, order, order_name(order));
        }
    });
}

fn order_name(order: Order) -> &'static str {
    match order {
        Order::All => tr!("outliner.everything"),
        Order::Layers => tr!("outliner.layers"),
        Order::Groups => tr!("outliner.groups"),
        Order::Models => tr!("outliner.models"),
        Order::Objects => tr!("outliner.objects"),
    }
}

fn list(ui: &mut Ui, session: &mut Session) {
    let Some(tree) = session.outline_rows() else { return };
    let height = ui.spacing().interact_size.y;
    let mut area = ScrollArea::vertical().id_salt("objects").max_height(HEIGHT).min_scrolled_height(HEIGHT).auto_shrink([false, true]);
    let selected = session.outliner.selected;
    if std::mem::take(&mut session.outliner.scrolls)
        && let Some(index) = tree.rows.iter().position(|row| Some(row.part) == selected)
    {
        area = area.vertical_scroll_offset((index as f32 - 3.0).max(0.0) * (height + ui.spacing().item_spacing.y));
    }
    if tree.rows.is_empty() {
        ui.label(tr!("outliner.nothing_found"));
    }
    area.show_rows(ui, height, tree.rows.len(), |ui, rows| {
        let rows = &tree.rows[rows];
        let seen = seen(session, rows);
        for row in rows {
            line(ui, session, row, seen.get(&row.part).copied().unwrap_or_default());
        }
    });
}

/// What is seen of the parts in sight: all of them in one go over the objects.
fn seen(session: &mut Session, rows: &[Row]) -> HashMap<Part, Seen> {
    let mut all = HashMap::new();
    for row in rows {
        let objects = session.objects_of(row.part);
        let Some(open) = &session.open else { continue };
        let visible = objects.iter().filter(|&&object| open.is_visible.get(object) == Some(&true)).count();
        all.insert(row.part, Seen { all: objects.len(), visible });
    }
    all
}

fn line(ui: &mut Ui, session: &mut Session, row: &Row, seen: Seen) {
    let Some(open) = &session.open else { return };
    let name = name_of(&open.outline, row.part);
    ui.horizontal(|ui| {
        ui.add_space(14.0 * row.depth as f32);
        if row.has_more {
            let is_open = session.outliner.opened.contains(&row.part);
            let arrow = ui.small_button(if is_open { "⏷" } else { "⏵" });
            name_node(ui, &arrow, &tr!("outliner.open", name = name));
            if arrow.clicked() && !session.outliner.opened.remove(&row.part) {
                session.outliner.opened.insert(row.part);
            }
        }
        let mut is_visible = seen.visible > 0;
        let is_some = seen.visible > 0 && seen.visible < seen.all;
        let shown = ui.add(Checkbox::without_text(&mut is_visible).indeterminate(is_some));
        name_node(ui, &shown, &name);
        if shown.changed() {
            let objects = session.objects_of(row.part);
            // What is seen in part is seen whole after a click.
            session.set_visible(&objects, is_some || is_visible);
        }
        let text = if row.has_more { format!("{name} ({})", row.objects) } else { name.clone() };
        let is_selected = session.outliner.selected == Some(row.part);
        let label = ui.add(Button::selectable(is_selected, text).truncate());
        name_node(ui, &label, &tr!("outliner.select", name = name));
        if label.double_clicked() {
            session.show_part(row.part);
        } else if label.clicked() {
            session.outliner.selected = Some(row.part);
        }
    });
}

/// What can be done with the part that is selected, and with the one that was picked.
fn selected(ui: &mut Ui, session: &mut Session) {
    let selected = session.outliner.selected;
    ui.horizontal_wrapped(|ui| {
        if let Some(part) = selected {
            if ui.button(tr!("outliner.isolate")).clicked() {
                session.isolate(part);
            }
            if ui.button(tr!("outliner.zoom")).clicked() {
                session.show_part(part);
            }
        }
        if session.picked.is_some() && ui.button(tr!("outliner.find_picked")).clicked() {
            session.select_picked();
        }
    });
}
