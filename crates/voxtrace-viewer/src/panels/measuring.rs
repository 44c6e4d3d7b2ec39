//! The panel of measurements, and what is drawn of them over the picture.

use super::over::{Over, over};
use super::{Noun, counted, name_node};
use crate::measuring::{Kind, Measure, Snap, Snapped, Value, kind_name};
use crate::scale::Scale;
use crate::session::Session;
use crate::tr;
use egui::{Button, CollapsingHeader, Color32, ComboBox, CursorIcon, Grid, ScrollArea, TextEdit, Ui};
use std::time::Duration;
use voxtrace::glam::{DVec3, Vec2};

/// Points of the list before it scrolls.
const HEIGHT: f32 = 160.0;
/// Colours of what was measured, of the one that is selected, and of what is under way.
const DONE: Color32 = Color32::from_rgb(255, 214, 64);
const SELECTED: Color32 = Color32::from_rgb(96, 224, 255);
const UNDER_WAY: Color32 = Color32::from_rgb(255, 255, 255);
/// Time until one looks again how many voxels were counted.
const SOON: Duration = Duration::from_millis(60);

pub fn measuring(ui: &mut Ui, session: &mut Session) {
    let count = session.measuring.list.len();
    let title = match count {
        0 => tr!("measure.title").to_owned(),
        _ => tr!("measure.title_count", count = count),
    };
    let opens = std::mem::take(&mut session.measuring.opens).then_some(true);
    CollapsingHeader::new(title).id_salt("measurements").open(opens).show(ui, |ui| {
        tools(ui, session);
        if let Some(flood) = &session.measuring.flood {
            let found = counted(flood.found(), Noun::Voxel);
            let mut is_stopped = false;
            // Panels that became wider would make the picture another one.
            ui.horizontal_wrapped(|ui| {
                ui.spinner();
                ui.label(tr!("measure.counting", voxels = found));
                is_stopped = ui.button(tr!("measure.stop")).clicked();
            });
            if is_stopped {
                session.cancel_measuring();
            }
        }
        list(ui, session);
        details(ui, session);
    });
}

fn tools(ui: &mut Ui, session: &mut Session) {
    ui.horizontal_wrapped(|ui| {
        for kind in Kind::ALL {
            let is_chosen = session.measuring.tool == Some(kind);
            if ui.selectable_label(is_chosen, kind_name(kind)).clicked() {
                session.choose_tool((!is_chosen).then_some(kind));
            }
        }
    });
    let snap = &mut session.measuring.snap;
    ComboBox::from_label(tr!("measure.snap")).selected_text(snap_name(*snap)).show_ui(ui, |ui| {
        for choice in Snap::ALL {
            ui.selectable_value(snap, choice, snap_name(choice));
        }
    });
    if session.measuring.tool == Some(Kind::Component) {
        ui.checkbox(&mut session.measuring.by_material, tr!("measure.by_material"));
    }
    if !session.measuring.points.is_empty() {
        ui.horizontal_wrapped(|ui| {
            let least = session.measuring.tool.map_or(0, |kind| kind.points().0);
            let can_finish = session.measuring.points.len() >= least;
            if ui.add_enabled(can_finish, Button::new(tr!("measure.finish"))).clicked() {
                session.finish_measuring();
            }
            if ui.button(tr!("measure.drop_point")).clicked() {
                session.measuring.points.pop();
            }
        });
    }
}

fn list(ui: &mut Ui, session: &mut Session) {
    let Some(scale) = session.open.as_ref().map(|open| Scale::of(&open.original)) else { return };
    let numbers: Vec<u32> = session.measuring.list.keys().copied().collect();
    let height = ui.spacing().interact_size.y;
    let area = ScrollArea::vertical().id_salt("measures").max_height(HEIGHT).min_scrolled_height(HEIGHT);
    // As wide as there is room: its bar would lie on the rows.
    area.auto_shrink([false, true]).show_rows(ui, height, numbers.len(), |ui, rows| {
        for &number in &numbers[rows] {
            row(ui, session, number, &scale);
        }
    });
    if !numbers.is_empty() && ui.button(tr!("measure.export")).clicked() {
        session.export_measures();
    }
}

fn row(ui: &mut Ui, session: &mut Session, number: u32, scale: &Scale) {
    let Some(measure) = session.measuring.list.get(&number).cloned() else { return };
    ui.horizontal(|ui| {
        let mut is_shown = !measure.is_hidden;
        let shown = ui.checkbox(&mut is_shown, "");
        name_node(ui, &shown, &tr!("measure.shown", name = measure.name));
        if shown.changed() {
            session.change_measure(number, |measure| measure.is_hidden = !is_shown);
        }
        let is_selected = session.measuring.selected == Some(number);
        let first = measure.values().first().map(|value| scale.text(value.quantity, value.number)).unwrap_or_default();
        let text = format!("{}: {first}", measure.name);
        if ui.add(Button::selectable(is_selected, text).truncate()).clicked() {
            session.measuring.selected = (!is_selected).then_some(number);
        }
    });
}

/// All that is known of the one that is selected, and what can be done with it.
fn details(ui: &mut Ui, session: &mut Session) {
    let selected = session.measuring.selected;
    // A click on another one ends the typing, too.
    if let Some((whose, typed)) = session.measuring.typed.take_if(|(whose, _)| Some(*whose) != selected) {
        session.change_measure(whose, |measure| measure.name = typed);
    }
    let Some(number) = selected else { return };
    let Some(measure) = session.measuring.list.get(&number).cloned() else { return };
    let Some(scale) = session.open.as_ref().map(|open| Scale::of(&open.original)) else { return };
    let mut name = match &session.measuring.typed {
        Some((whose, typed)) if *whose == number => typed.clone(),
        _ => measure.name.clone(),
    };
    let field = ui.add(TextEdit::singleline(&mut name).desired_width(ui.available_width() - 60.0));
    name_node(ui, &field, tr!("measure.name"));
    if field.lost_focus() {
        session.measuring.typed = None;
        if name != measure.name {
            session.change_measure(number, |measure| measure.name = name);
        }
    } else if field.changed() {
        session.measuring.typed = Some((number, name));
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button(tr!("measure.zoom")).clicked() {
            session.show_measure(number);
        }
        if ui.button(tr!("measure.copy")).clicked() {
            session.copy(text_of(&measure, &scale), tr!("measure.copied"));
        }
        if ui.button(tr!("measure.delete")).clicked() {
            session.delete_measure(number);
        }
    });
    Grid::new("measure").num_columns(2).show(ui, |ui| {
        for value in measure.values() {
            ui.label(value_name(value.name));
            ui.label(scale.text(value.quantity, value.number));
            ui.end_row();
        }
    });
    for line in points_of(&measure, &scale) {
        ui.label(line);
    }
}

/// The places of its points: coordinates of the source where there are any, else units or voxels.
fn points_of(measure: &Measure, scale: &Scale) -> Vec<String> {
    let text = |point: DVec3, decimals: usize, unit: &str| {
        format!("{:.decimals$}, {:.decimals$}, {:.decimals$}{unit}", point.x, point.y, point.z)
    };
    let line = |point: &DVec3| match (scale.coordinates(*point), scale.place(*point)) {
        (Some(at), _) => text(at, 3, &scale.coordinates_symbol()),
        (None, Some(at)) => text(at, 3, &format!(" {}", scale.symbol())),
        (None, None) => text(*point, 2, " vx"),
    };
    measure.points.iter().enumerate().map(|(index, point)| format!("{}: {}", index + 1, line(point))).collect()
}

fn text_of(measure: &Measure, scale: &Scale) -> String {
    let line = |value: &Value| format!("{}: {}", value_name(value.name), scale.text(value.quantity, value.number));
    let values = measure.values();
    let lines = values.iter().map(line).chain(points_of(measure, scale));
    [measure.name.clone()].into_iter().chain(lines).collect::<Vec<_>>().join("\n")
}

fn value_name(name: &str) -> &str {
    match name {
        "distance" => tr!("measure.value.distance"),
        "horizontal" => tr!("measure.value.horizontal"),
        "height" => tr!("measure.value.height"),
        "angle" => tr!("measure.value.angle"),
        "length" => tr!("measure.value.length"),
        "climb" => tr!("measure.value.climb"),
        "between ends" => tr!("measure.value.between_ends"),
        "area" => tr!("measure.value.area"),
        "area from above" => tr!("measure.value.from_above"),
        "perimeter" => tr!("measure.value.perimeter"),
        "beside its plane" => tr!("measure.value.beside_plane"),
        "volume" => tr!("measure.value.volume"),
        "voxels" => tr!("measure.value.voxels"),
        "exposed area" => tr!("measure.value.exposed"),
        "dx" => "Δx",
        "dy" => "Δy",
        "dz" => "Δz",
        "size x" => tr!("measure.value.size_x"),
        "size y" => tr!("measure.value.size_y"),
        "size z" => tr!("measure.value.size_z"),
        other => other,
    }
}

fn snap_name(snap: Snap) -> &'static str {
    match snap {
        Snap::Auto => tr!("measure.snap_auto"),
        Snap::Face => tr!("measure.snap_face"),
        Snap::Edge => tr!("measure.snap_edge"),
        Snap::Corner => tr!("measure.snap_corner"),
        Snap::FaceCentre => tr!("measure.snap_face_centre"),
        Snap::VoxelCentre => tr!("measure.snap_voxel_centre"),
    }
}

/// Draws what was measured, and what is being measured, over the picture.
pub fn drawn(ui: &Ui, session: &mut Session, side: f32) {
    if session.measuring.tool.is_none() && session.measuring.list.is_empty() && session.measuring.flood.is_none() {
        return;
    }
    // The section may be closed, and the panels hidden.
    if session.measuring.flood.is_some() {
        ui.ctx().request_repaint_after(SOON);
    }
    let hover = session.hover.filter(|_| session.measuring.tool.is_some());
    if hover.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
    }
    let under = hover.filter(|_| !session.is_moving()).and_then(|cursor: Vec2| session.point_under(cursor));
    over(ui, session, side, |session, over| {
        let Some(scale) = session.open.as_ref().map(|open| Scale::of(&open.original)) else { return };
        for (number, measure) in session.measuring.list.iter().filter(|(_, measure)| !measure.is_hidden) {
            let color = if session.measuring.selected == Some(*number) { SELECTED } else { DONE };
            shape(over, measure, &scale, color);
        }
        if let Some(flood) = &session.measuring.flood {
            over.label(flood.point.as_vec3(), &counted(flood.found(), Noun::Voxel), UNDER_WAY);
        }
        if let Some(kind) = session.measuring.tool {
            under_way(over, kind, &session.measuring.points, under, &scale);
        }
    });
}

fn under_way(over: &mut Over, kind: Kind, points: &[DVec3], under: Option<Snapped>, scale: &Scale) {
    let mut points = points.to_vec();
    if let Some(under) = under {
        let radius = match under.on {
            Snap::Corner => 5.0,
            Snap::FaceCentre | Snap::VoxelCentre => 4.5,
            Snap::Edge => 4.0,
            _ => 3.0,
        };
        over.dot(under.point.as_vec3(), radius, UNDER_WAY);
        points.push(under.point);
    }
    if kind == Kind::Component {
        return;
    }
    let measure = Measure { name: String::new(), is_hidden: false, kind, points, component: None };
    shape(over, &measure, scale, UNDER_WAY);
}

/// One measurement: its lines, its points, and its first number.
fn shape(over: &mut Over, measure: &Measure, scale: &Scale, color: Color32) {
    let points = &measure.points;
    let width = 2.0;
    let mut line = |from: DVec3, to: DVec3, width: f32| over.line(from.as_vec3(), to.as_vec3(), width, color);
    match (measure.kind, points.as_slice()) {
        (Kind::Component, _) => {
            if let Some(component) = &measure.component {
                let corners: Vec<DVec3> = component.corners().collect();
                for from in 0..8usize {
                    for axis in [1, 2, 4].into_iter().filter(|axis| from & axis == 0) {
                        line(corners[from], corners[from | axis], 1.5);
                    }
                }
            }
        }
        (Kind::Height, [from, to, ..]) => {
            let foot = to.with_z(from.z);
            line(*from, foot, 1.0);
            line(foot, *to, width);
        }
        (Kind::Distance, [from, to, ..]) => {
            // The way along the axes.
            let (x, y) = (from.with_x(to.x), to.with_z(from.z));
            [(*from, x), (x, y), (y, *to)].into_iter().for_each(|(from, to)| line(from, to, 0.7));
            line(*from, *to, width);
        }
        _ => {
            points.windows(2).for_each(|pair| line(pair[0], pair[1], width));
            if let (Kind::Area, [first, _, .., last]) = (measure.kind, points.as_slice()) {
                line(*last, *first, width);
            }
        }
    }
    points.iter().for_each(|point| over.dot(point.as_vec3(), 3.5, color));
    let values = measure.values();
    let Some(value) = values.first() else { return };
    let text = scale.text(value.quantity, value.number);
    over.label(label_place(measure).as_vec3(), &text, color);
}

/// Where the number of a measurement stands.
fn label_place(measure: &Measure) -> DVec3 {
    let points = &measure.points;
    match (measure.kind, points.as_slice()) {
        (Kind::Component, _) => match &measure.component {
            Some(component) => component.corners().sum::<DVec3>() / 8.0,
            None => points.first().copied().unwrap_or_default(),
        },
        (Kind::Height, [from, to, ..]) => to.with_z(from.z).midpoint(*to),
        (Kind::Angle, [_, at, ..]) => *at,
        (Kind::Area, _) => points.iter().sum::<DVec3>() / points.len().max(1) as f64,
        (Kind::Path, [.., last]) => *last,
        (_, [from, to, ..]) => from.midpoint(*to),
        _ => points.first().copied().unwrap_or_default(),
    }
}
