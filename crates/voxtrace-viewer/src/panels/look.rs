//! How the window itself looks: dark or light, as the system has it or as somebody chose, and which language it speaks.

use super::heading;
use crate::session::Session;
use crate::{strings, tr};
use egui::{ComboBox, Ui};

/// Dark panels or light ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// As the system has them; dark where it does not say.
    #[default]
    System,
    /// Dark.
    Dark,
    /// Light.
    Light,
}

impl Theme {
    /// All of them, in the order of lists.
    pub const ALL: [Self; 3] = [Self::System, Self::Dark, Self::Light];

    /// Its name in the settings.
    pub fn name(self) -> &'static str {
        match self {
            Self::System => "system",
            Self::Dark => "dark",
            Self::Light => "light",
        }
    }

    /// That of a name in the settings; of one that there is not, the system's.
    pub fn of_name(name: &str) -> Self {
        Self::ALL.into_iter().find(|theme| theme.name() == name).unwrap_or_default()
    }

    fn preference(self) -> egui::ThemePreference {
        match self {
            Self::System => egui::ThemePreference::System,
            Self::Dark => egui::ThemePreference::Dark,
            Self::Light => egui::ThemePreference::Light,
        }
    }
}

/// Opacity of the bars of lists that nobody scrolls.
const BAR: f32 = 0.4;

/// Takes the theme that was chosen, and how lists scroll.
pub fn apply(ui: &Ui, session: &Session) {
    // Bars say that there is more. egui's fade at the ends of lists would: but colours are interpolated linearly here, which makes it a block.
    let mut scroll = ui.spacing().scroll;
    (scroll.fade.strength, scroll.dormant_handle_opacity) = (0.0, BAR);
    if ui.spacing().scroll != scroll {
        ui.ctx().all_styles_mut(|style| style.spacing.scroll = scroll);
        ui.ctx().request_repaint();
    }
    let wanted = session.theme.preference();
    if ui.ctx().options(|options| options.theme_preference) != wanted {
        ui.ctx().set_theme(wanted);
        ui.ctx().request_repaint();
    }
}

/// Text that says what went wrong: red that can be read on the panels.
pub fn error_color(ui: &Ui) -> egui::Color32 {
    match ui.visuals().dark_mode {
        true => egui::Color32::from_rgb(255, 128, 112),
        false => egui::Color32::from_rgb(176, 24, 12),
    }
}

pub fn look(ui: &mut Ui, session: &mut Session) {
    heading(ui, tr!("look.title"));
    ComboBox::from_label(tr!("look.theme")).selected_text(theme_name(session.theme)).show_ui(ui, |ui| {
        for theme in Theme::ALL {
            ui.selectable_value(&mut session.theme, theme, theme_name(theme));
        }
    });
    let languages: Vec<_> = strings::languages().collect();
    if languages.len() < 2 {
        return;
    }
    let spoken = strings::spoken();
    let own = languages.iter().find(|(name, _)| *name == spoken).map_or(spoken, |(_, own)| own);
    ComboBox::from_label(tr!("look.language")).selected_text(own).show_ui(ui, |ui| {
        for (name, own) in languages {
            if ui.selectable_label(name == spoken, own).clicked() {
                strings::speak(name);
                session.language = Some(name.to_owned());
            }
        }
    });
}

fn theme_name(theme: Theme) -> &'static str {
    match theme {
        Theme::System => tr!("look.system"),
        Theme::Dark => tr!("look.dark"),
        Theme::Light => tr!("look.light"),
    }
}
