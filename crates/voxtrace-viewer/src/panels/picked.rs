//! The panel of one voxel, below the others: the one that was picked, else the one under the cursor.

use super::{heading, materials};
use crate::inspector::{self, Fact, Sampling};
use crate::keys::Action;
use crate::session::{Command, Picked, Session};
use crate::tr;
use egui::{CollapsingHeader, Grid, Label, RichText, Ui};
use std::time::Duration;

/// Share of the panel that a column takes at most.
const NAMES: f32 = 0.62;
/// Time until one looks again whether the values were read.
const SOON: Duration = Duration::from_millis(100);

/// The voxel that is told of, and whether it was picked.
pub fn seen(session: &Session) -> Option<(Picked, bool)> {
    let hovered = || session.hover.filter(|_| !session.is_moving()).and_then(|cursor| session.pick(cursor));
    session.picked.clone().map(|picked| (picked, true)).or_else(|| Some((hovered()?, false)))
}

pub fn picked(ui: &mut Ui, session: &mut Session, picked: &Picked, is_picked: bool) {
    if is_picked && matches!(session.sampling, Sampling::Unasked) {
        session.ask(Command::ReadValues);
    }
    if session.sampling.take() {
        ui.ctx().request_repaint_after(SOON);
    }
    let Some(open) = &session.open else { return };
    heading(ui, if is_picked { tr!("voxel.picked") } else { tr!("voxel.under_cursor") });
    let middle = inspector::middle(open, picked);
    let facts = [inspector::place_facts(open, picked), session.sampling.facts(middle)].concat();
    let number = picked.material as usize;
    let material = open.lit.materials().get(number).map(|material| inspector::material_facts(number, material));
    table(ui, "voxel", &facts);
    materials::material(ui, session, number);
    if !is_picked {
        return;
    }
    CollapsingHeader::new(tr!("voxel.material_all")).id_salt("voxel's material").show(ui, |ui| {
        table(ui, "voxel's material", &material.unwrap_or_default());
    });
    ui.horizontal(|ui| {
        if ui.button(tr!("voxel.frame")).clicked() {
            session.act(Action::FramePicked, None);
        }
        if ui.button(tr!("voxel.hide")).clicked() {
            session.act(Action::HidePicked, None);
        }
        if ui.button(tr!("voxel.copy")).clicked()
            && let Some(text) = inspector::text(session, picked)
        {
            session.copy(text, tr!("voxel.copied"));
        }
    });
}

fn table(ui: &mut Ui, id: &str, facts: &[Fact]) {
    // Long names are wrapped: panels that became wider would make the picture another one.
    let widest = ui.available_width() * NAMES;
    Grid::new(id).num_columns(2).spacing([8.0, 2.0]).max_col_width(widest).show(ui, |ui| {
        for fact in facts {
            ui.label(RichText::new(fact.name).weak());
            ui.add(Label::new(&fact.text).wrap());
            ui.end_row();
        }
    });
}
