//! The panel of editing: tools, brush, palette, symmetry, what is selected, and what can be undone.

use super::{Noun, counted, heading, name_node, slider};
use crate::editing::{Act, Brush, Editing, Tool, UNDO_BYTES};
use crate::keys::{Action, EditAction, EditAxis, key_of};
use crate::session::{Session, extent};
use crate::tr;
use egui::{Button, Color32, DragValue, RichText, ScrollArea, Sense, Stroke, StrokeKind, Ui, vec2};
use voxtrace::Material;
use voxtrace::material::srgb_from_linear;
use voxtrace::packed::PackedMaterial;

/// Points of a swatch.
const SWATCH: f32 = 20.0;
/// Points of lists before they scroll.
const HEIGHT: f32 = 110.0;
const AXES: [&str; 3] = ["x", "y", "z"];

/// The button that begins to edit.
pub fn begin(ui: &mut Ui, session: &mut Session) {
    let text = if session.is_editing() { tr!("edit.end") } else { tr!("edit.begin") };
    if ui.button(text).on_hover_text(key_of(Action::ToggleEditing)).clicked() {
        session.act(Action::ToggleEditing, None);
    }
}

/// The whole panel.
pub fn editing(ui: &mut Ui, session: &mut Session) {
    let Some(editing) = session.editing.as_ref().filter(|editing| editing.is_on) else { return };
    heading(ui, tr!("edit.title"));
    if !editing.is_ready {
        ui.horizontal(|ui| (ui.spinner(), ui.label(tr!("edit.preparing"))));
    }
    tools(ui, session);
    brush(ui, session);
    palette(ui, session);
    symmetry(ui, session);
    selection(ui, session);
    steps(ui, session);
    ui.label(RichText::new(told(session)).weak());
}

/// What the cursor is at, or how large what is dragged is.
fn told(session: &Session) -> String {
    let Some(editing) = &session.editing else { return String::new() };
    if let Some(text) = editing.stroke().and_then(extent) {
        return text;
    }
    if editing.picks_middle {
        return tr!("edit.pick_middle").into();
    }
    if editing.pasting.is_some() {
        return tr!("edit.put_down").into();
    }
    let spot = session.hover.and_then(|cursor| session.edit_spot(cursor));
    match spot.map(|spot| (spot.grid, session.copies_of(spot.grid))) {
        Some((_, copies)) if copies > 1 => tr!("edit.copies", copies = copies),
        _ => editing.tool.about().into(),
    }
}

/// A button that stays pressed, with its key.
fn choice(ui: &mut Ui, is_chosen: bool, name: &str, action: Action) -> bool {
    let button = ui.add(Button::selectable(is_chosen, name));
    button.on_hover_text(key_of(action)).clicked()
}

fn tools(ui: &mut Ui, session: &mut Session) {
    let Some(editing) = &session.editing else { return };
    let (act, tool) = (editing.act, editing.tool);
    let mut asked = None;
    ui.horizontal_wrapped(|ui| {
        for own in Act::ALL {
            let action = EditAction::Choose(own);
            let is_chosen = own == act && !matches!(tool, Tool::Extrude | Tool::Select);
            if choice(ui, is_chosen, own.name(), Action::Edit(action)) {
                asked = Some(action);
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        for own in Tool::ALL {
            let action = EditAction::Take(own);
            if choice(ui, own == tool, own.name(), Action::Edit(action)) {
                asked = Some(action);
            }
        }
    });
    if let Some(action) = asked {
        session.act(Action::Edit(action), None);
    }
}

fn brush(ui: &mut Ui, session: &mut Session) {
    let Some(editing) = session.editing.as_mut().filter(|editing| editing.tool.has_act()) else { return };
    if editing.tool == Tool::Box {
        return;
    }
    let Brush { mut size, mut is_round } = editing.brush;
    ui.add(slider(&mut size, 1..=64, tr!("edit.brush_size")).logarithmic(true));
    ui.horizontal(|ui| {
        ui.radio_value(&mut is_round, true, tr!("edit.ball"));
        ui.radio_value(&mut is_round, false, tr!("edit.cube"));
    });
    editing.brush = Brush { is_round, ..editing.brush }.resized(size);
}

/// What a material is, in a few words.
fn about(number: usize, material: &PackedMaterial) -> String {
    let [red, green, blue] = material.base_color.to_array().map(srgb_from_linear);
    let color = format!("#{red:02x}{green:02x}{blue:02x}");
    let mut text = tr!("edit.material", number = number, color = color);
    for (is_so, word) in [
        (material.emission.max_element() > 0.0, tr!("edit.glows")),
        (material.transmission > 0.0, tr!("edit.glass")),
        (material.metallic > 0.0, tr!("edit.metal")),
    ] {
        if is_so {
            text.push_str(", ");
            text.push_str(word);
        }
    }
    text
}

fn color_of(material: &PackedMaterial) -> Color32 {
    let strength = material.emission.max_element();
    let shown = if strength > 0.0 { material.emission / strength } else { material.base_color };
    let [red, green, blue] = shown.to_array().map(srgb_from_linear);
    Color32::from_rgb(red, green, blue)
}

/// A swatch. Returns whether it was clicked.
fn swatch(ui: &mut Ui, session: &Session, number: usize, is_current: bool) -> bool {
    let Some(material) = session.material(number) else { return false };
    let (rect, response) = ui.allocate_exact_size(vec2(SWATCH, SWATCH), Sense::click());
    let stroke = if is_current { Stroke::new(2.5, Color32::WHITE) } else { Stroke::new(1.0, Color32::from_gray(90)) };
    ui.painter().rect_filled(rect.shrink(1.0), 3.0, color_of(&material));
    if is_current {
        ui.painter().rect_stroke(rect, 3.0, Stroke::new(4.0, Color32::BLACK), StrokeKind::Inside);
    }
    ui.painter().rect_stroke(rect.shrink(0.5), 3.0, stroke, StrokeKind::Inside);
    if material.emission.max_element() > 0.0 {
        ui.painter().circle_filled(rect.center(), 3.0, Color32::BLACK);
        ui.painter().circle_filled(rect.center(), 2.0, Color32::WHITE);
    }
    let text = about(number, &material);
    name_node(ui, &response, &text);
    response.on_hover_text(text).clicked()
}

fn palette(ui: &mut Ui, session: &mut Session) {
    let (Some(open), Some(editing)) = (&session.open, &session.editing) else { return };
    let count = open.original.materials().len();
    let (current, recent) = (usize::from(editing.material), editing.recent.clone());
    let mut chosen = None;
    if let Some(material) = session.material(current) {
        ui.horizontal(|ui| {
            swatch(ui, session, current, true);
            ui.label(about(current, &material)).on_hover_text(tr!("edit.take_hint"));
        });
    }
    let spacing = vec2(2.0, 2.0);
    // Beside the bar that scrolls: it would take the clicks on the last column.
    let width = ui.available_width() - ui.spacing().scroll.bar_width;
    let across = ((width / (SWATCH + spacing.x)).floor() as usize).max(1);
    // As wide as there is room, or its bar would lie on the last column all the same.
    let area = ScrollArea::vertical().id_salt("palette").max_height(HEIGHT).min_scrolled_height(HEIGHT);
    area.auto_shrink([false, true]).show_rows(ui, SWATCH, count.div_ceil(across), |ui, rows| {
        ui.spacing_mut().item_spacing = spacing;
        for row in rows {
            ui.horizontal(|ui| {
                for number in row * across..((row + 1) * across).min(count) {
                    if swatch(ui, session, number, number == current) {
                        chosen = Some(number);
                    }
                }
            });
        }
    });
    if recent.len() > 1 {
        ui.horizontal(|ui| {
            ui.label(tr!("edit.recent"));
            ui.spacing_mut().item_spacing = spacing;
            for number in recent.into_iter().map(usize::from).filter(|&number| number < count) {
                if swatch(ui, session, number, number == current) {
                    chosen = Some(number);
                }
            }
        });
    }
    if let (Some(number), Some(editing)) = (chosen, &mut session.editing) {
        editing.take_material(number as u16);
    }
    super::materials::material(ui, session, current);
    new_material(ui, session, current);
}

/// Buttons that add a material in the colour of the current one.
fn new_material(ui: &mut Ui, session: &mut Session, current: usize) {
    let Some(now) = session.material(current) else { return };
    let mut own = Material::diffuse(now.base_color);
    (own.roughness, own.metallic, own.transmission) = (now.roughness, now.metallic, now.transmission);
    (own.ior, own.specular, own.anisotropy) = (now.ior, now.specular, now.anisotropy);
    (own.absorption, own.scattering, own.emission) = (now.absorption, now.scattering, now.emission);
    let kinds = [
        (tr!("edit.like_it"), own),
        (tr!("edit.matt"), Material::diffuse(now.base_color)),
        (tr!("edit.metal"), Material::metal(now.base_color, 0.2)),
        (tr!("edit.plastic"), Material::plastic(now.base_color, 0.1)),
        (tr!("edit.lamp"), Material::diffuse(now.base_color).glowing(4.0)),
    ];
    ui.horizontal_wrapped(|ui| {
        ui.label(tr!("edit.new")).on_hover_text(tr!("edit.new_about"));
        for (name, material) in kinds {
            if ui.button(name).clicked() {
                session.add_material(material);
            }
        }
    });
}

fn symmetry(ui: &mut Ui, session: &mut Session) {
    let Some(editing) = &mut session.editing else { return };
    ui.horizontal(|ui| {
        ui.label(tr!("edit.symmetry"));
        for (axis, name) in AXES.into_iter().enumerate() {
            ui.checkbox(&mut editing.symmetry.axes[axis], name);
        }
    });
    if editing.symmetry.is_none() {
        return;
    }
    ui.horizontal(|ui| {
        let is_middle = editing.symmetry_of.is_none();
        if ui.radio(is_middle, tr!("edit.middle")).clicked() {
            (editing.symmetry_of, editing.picks_middle) = (None, false);
        }
        if ui
            .radio(!is_middle || editing.picks_middle, tr!("edit.a_voxel"))
            .on_hover_text(tr!("edit.then_click"))
            .clicked()
        {
            editing.picks_middle = true;
        }
    });
    if editing.symmetry_of.is_some() {
        ui.horizontal(|ui| {
            for (axis, name) in AXES.into_iter().enumerate().filter(|(axis, _)| editing.symmetry.axes[*axis]) {
                let mut at = f64::from(editing.symmetry.twice[axis]) / 2.0;
                ui.add(DragValue::new(&mut at).speed(0.5).prefix(format!("{name} ")).max_decimals(1));
                editing.symmetry.twice[axis] = (at * 2.0).round() as i32;
            }
        });
    }
}

fn selection(ui: &mut Ui, session: &mut Session) {
    let Some(Editing { tool, selection, pasting, clip, .. }) = &mut session.editing else { return };
    if let Some(selection) = selection {
        let region = &mut selection.region;
        for (name, corner) in [(tr!("edit.from"), &mut region.min), (tr!("edit.to"), &mut region.max)] {
            ui.horizontal(|ui| {
                ui.label(name);
                for axis in 0..3 {
                    ui.add(DragValue::new(&mut corner[axis]).speed(0.2));
                }
            });
        }
        region.max = region.max.max(region.min + 1);
        let size = region.size();
        ui.label(tr!("edit.selected", x = size.x, y = size.y, z = size.z));
    }
    let (has_selection, has_clip, is_pasting) = (selection.is_some(), clip.is_some(), pasting.is_some());
    if !has_selection && !has_clip && *tool != Tool::Select {
        return;
    }
    let mut asked = None;
    ui.horizontal_wrapped(|ui| {
        let mut button = |name: &str, is_enabled: bool, action: EditAction| {
            let button = ui.add_enabled(is_enabled, Button::new(name));
            if button.on_hover_text(key_of(Action::Edit(action))).clicked() {
                asked = Some(action);
            }
        };
        button(tr!("edit.copy"), has_selection, EditAction::Copy);
        button(tr!("edit.cut"), has_selection, EditAction::Cut);
        button(tr!("edit.move"), has_selection, EditAction::Move);
        button(tr!("edit.clear"), has_selection, EditAction::Clear);
        button(tr!("edit.paste"), has_clip, EditAction::Paste);
    });
    if is_pasting {
        ui.horizontal_wrapped(|ui| {
            let axes = [EditAxis::X, EditAxis::Y, EditAxis::Z];
            for (name, axis) in AXES.into_iter().zip(axes) {
                let (turn, mirror) = (EditAction::Turn(axis), EditAction::Mirror(axis));
                for (text, action) in [(tr!("edit.turn", name = name), turn), (tr!("edit.mirror", name = name), mirror)]
                {
                    let button = ui.button(text);
                    if button.on_hover_text(key_of(Action::Edit(action))).clicked() {
                        asked = Some(action);
                    }
                }
            }
        });
    }
    if has_selection && ui.button(tr!("edit.fill_box")).clicked() {
        session.fill_selection();
    }
    if let Some(action) = asked {
        session.act(Action::Edit(action), None);
    }
}

/// Bytes for people.
fn megabytes(bytes: u64) -> String {
    format!("{:.1} MB", bytes as f64 / f64::from(1 << 20))
}

fn steps(ui: &mut Ui, session: &mut Session) {
    let Some(editing) = &session.editing else { return };
    let steps = &editing.steps;
    let (done, undone) = (steps.done.len(), steps.undone.len());
    let mut asked = None;
    ui.horizontal(|ui| {
        for (name, count, is_back) in [(tr!("edit.undo"), done, true), (tr!("edit.redo"), undone, false)] {
            let action = if is_back { EditAction::Undo } else { EditAction::Redo };
            let button = ui.add_enabled(count > 0, Button::new(name));
            if button.on_hover_text(key_of(Action::Edit(action))).clicked() {
                asked = Some((1, is_back));
            }
        }
        ui.label(RichText::new(tr!("edit.bytes", bytes = megabytes(steps.bytes), most = megabytes(UNDO_BYTES))).weak())
            .on_hover_text(tr!("edit.bytes_about"));
    });
    let height = ui.text_style_height(&egui::TextStyle::Body) + 2.0;
    let rows = done + undone + 1;
    ScrollArea::vertical()
        .id_salt("steps")
        .max_height(HEIGHT)
        .min_scrolled_height(HEIGHT)
        .auto_shrink([false, true])
        .stick_to_bottom(true)
        .show_rows(ui, height, rows, |ui, rows| {
            for row in rows {
                let (text, is_undone) = match row.checked_sub(1) {
                    None if steps.has_forgotten => (tr!("edit.forgotten").to_owned(), false),
                    None => (tr!("edit.as_opened").to_owned(), false),
                    Some(index) => {
                        let is_undone = index >= done;
                        let step =
                            if is_undone { &steps.undone[undone - 1 - (index - done)] } else { &steps.done[index] };
                        let voxels = match step.voxels {
                            0 => String::new(),
                            voxels => format!(
                                " {}{}",
                                if voxels > 0 { "+" } else { "−" },
                                counted(voxels.unsigned_abs(), Noun::Voxel)
                            ),
                        };
                        (format!("{row}. {}{voxels}", step.name), is_undone)
                    }
                };
                let text = if is_undone { RichText::new(text).weak() } else { RichText::new(text) };
                if ui.add(Button::selectable(row == done, text)).clicked() && row != done {
                    asked = Some((row.abs_diff(done), row < done));
                }
            }
        });
    if let Some((count, is_back)) = asked {
        session.travel(count, is_back);
    }
    ui.horizontal(|ui| {
        if ui.button(tr!("edit.save")).on_hover_text(key_of(Action::SaveEdits)).clicked() {
            session.save_edits();
        }
        if session.has_unsaved_edits() {
            ui.label(RichText::new(tr!("edit.not_saved")).weak());
        }
    });
}
