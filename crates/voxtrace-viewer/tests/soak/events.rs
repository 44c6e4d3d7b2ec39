//! The events that random numbers choose for the window: mouse and keys over picture and panels, all keys of the table, files, sizes, and faults of the
//! driver.

use super::app::App;
use super::turn::Turn;
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;
use voxtrace_viewer::input::Button;
use voxtrace_viewer::keys::{Action, Binding, EDIT_TABLE, EditAction, Key, Modifiers, TABLE, Trigger};
use voxtrace_viewer::session::Command;
use voxtrace_vulkan::Fault;

/// Time between two losses of the device, at least: five within ten seconds, and the window gives it up.
const BETWEEN_LOSSES: Duration = Duration::from_secs(3);
const BUTTONS: [Button; 3] = [Button::Left, Button::Middle, Button::Right];

/// SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }

    fn place(&mut self, (width, height): (u32, u32)) -> Vec2 {
        Vec2::new(self.below(width.max(1).into()) as f32, self.below(height.max(1).into()) as f32)
    }
}

/// What the events need to know of those before.
pub struct Hands {
    random: Random,
    /// Until when nothing happens, so that a film is made.
    rests: Instant,
    /// When the device was lost last.
    lost: Instant,
    /// Button that is held over the panels.
    holds_panels: bool,
    /// Whether real-time light is turned on again and again.
    lights: bool,
}

impl Hands {
    pub fn new(seed: u64, lights: bool) -> Self {
        let now = Instant::now();
        Self { random: Random(seed), rests: now, lost: now, holds_panels: false, lights }
    }

    /// Does something.
    pub fn act(&mut self, app: &mut App, since: Duration) {
        if Instant::now() < self.rests {
            return;
        }
        let turn = Turn::begin();
        let what = self.event(app);
        if what == "nothing" {
            // Let things happen.
            std::thread::sleep(Duration::from_millis(self.random.below(60)));
        } else {
            app.note(&turn, since, &what);
        }
    }

    /// Does something, and says what.
    fn event(&mut self, app: &mut App) -> String {
        let place = self.random.place(app.size);
        match self.random.below(100) {
            0..24 => {
                move_to(app, place);
                "moving".into()
            }
            24..33 => {
                move_to(app, place);
                self.press(app, place)
            }
            33..42 => {
                self.release(app);
                "letting go".into()
            }
            42..47 => {
                let notches = self.random.below(5) as f32 - 2.0;
                if app.is_on_panels(place) {
                    let delta = egui::vec2(0.0, 40.0 * notches);
                    let (unit, modifiers) = (egui::MouseWheelUnit::Point, egui::Modifiers::NONE);
                    app.to_panels.push(egui::Event::MouseWheel {
                        unit,
                        delta,
                        phase: egui::TouchPhase::Move,
                        modifiers,
                    });
                } else {
                    app.input.wheel(notches, &mut app.session);
                }
                "the wheel".into()
            }
            47..50 => {
                let number = self.random.below(app.files.len() as u64 + 2) as usize;
                // Some are begun here.
                let command =
                    app.files.get(number).map_or(Command::New([24, 20, 16]), |file| Command::Load(file.clone()));
                app.session.ask(command);
                "opening".into()
            }
            50..53 => {
                // Minimized, too.
                app.size = if self.random.below(4) == 0 {
                    (0, 0)
                } else {
                    (200 + self.random.below(500) as u32, 150 + self.random.below(300) as u32)
                };
                app.window.screen.resize(app.size);
                "another size".into()
            }
            53..54 => {
                app.input.lose_focus(&mut app.session);
                app.session.act(Action::Screenshot, None);
                self.rests = Instant::now() + Duration::from_millis(400);
                "a screenshot".into()
            }
            54..55 => self.lose(app),
            55..62 => {
                // Hands that edit do it again and again.
                app.session.act(self.random.of(&EDITS), Some(place));
                "editing".into()
            }
            62..66 => {
                self.answer(app);
                "answering".into()
            }
            66..92 => self.key(app),
            92 if self.lights => {
                app.light_again();
                // On a slow machine a frame takes its time.
                self.rests = Instant::now() + Duration::from_millis(self.random.below(2500));
                "real-time light".into()
            }
            _ => "nothing".into(),
        }
    }

    fn press(&mut self, app: &mut App, place: Vec2) -> String {
        if app.is_on_panels(place) {
            self.holds_panels = true;
            app.to_panels.push(button_event(place, true));
            // A click, more often than not.
            if self.random.below(4) > 0 {
                self.release(app);
            }
            return "a click on the panels".into();
        }
        let button = self.random.of(&BUTTONS);
        app.input.press(button, &mut app.session);
        if self.random.below(6) == 0 {
            app.input.double_click(&mut app.session);
        }
        format!("pressing {button:?}")
    }

    fn release(&mut self, app: &mut App) {
        BUTTONS.into_iter().for_each(|button| app.input.release(button, &mut app.session));
        if std::mem::take(&mut self.holds_panels) {
            let place = app.input.cursor().unwrap_or_default();
            app.to_panels.push(button_event(place, false));
        }
    }

    /// A key of one of the tables, or text where a field is typed in.
    fn key(&mut self, app: &mut App) -> String {
        if !app.has_keyboard() {
            let letter = char::from(b'a' + self.random.below(26) as u8);
            app.to_panels.push(egui::Event::Text(letter.into()));
            if self.random.below(3) == 0 {
                let (key, modifiers) = (egui::Key::Escape, egui::Modifiers::NONE);
                app.to_panels.push(egui::Event::Key {
                    key,
                    physical_key: None,
                    pressed: true,
                    repeat: false,
                    modifiers,
                });
                app.input.key(Key::Escape, true, false, &mut app.session);
            }
            return "typing".into();
        }
        let table = if app.session.is_editing() && self.random.below(2) == 0 { EDIT_TABLE } else { TABLE };
        let keys: Vec<(Key, Modifiers)> = table.iter().flat_map(keys_of).collect();
        let (key, modifiers) = self.random.of(&keys);
        app.input.set_modifiers(modifiers, &mut app.session);
        app.input.key(key, true, false, &mut app.session);
        app.input.key(key, false, false, &mut app.session);
        app.input.set_modifiers(Modifiers::NONE, &mut app.session);
        format!("{modifiers}{key}")
    }

    /// Answers the question about edits that no file holds, or stops what is being made.
    fn answer(&mut self, app: &mut App) {
        match self.random.below(4) {
            0 => app.session.discard_and_leave(),
            1 => app.session.save_and_leave(),
            2 => app.session.stay(),
            _ => app.session.act(Action::Cancel, None),
        }
    }

    /// Lets the driver fail. The window gives up a device that is lost again and again, so it is not lost more often than every few seconds.
    fn lose(&mut self, app: &mut App) -> String {
        let faults = [
            ("vkAcquireNextImageKHR", Fault::SurfaceLost),
            ("vkQueuePresentKHR", Fault::OutOfDate),
            ("vkCreateBuffer", Fault::OutOfDeviceMemory),
            ("vkCreateSwapchainKHR", Fault::SurfaceLost),
            ("vkQueueSubmit", Fault::DeviceLost),
            ("vkQueuePresentKHR", Fault::DeviceLost),
        ];
        app.window.faults.clear();
        let (function, fault) = self.random.of(&faults);
        if fault == Fault::DeviceLost {
            if self.lost.elapsed() < BETWEEN_LOSSES {
                return "nothing".into();
            }
            self.lost = Instant::now();
        }
        app.window.faults.plant(function, fault);
        format!("{function} fails")
    }
}

/// What a hand does again and again while it edits; the first begins it where it has not begun.
const EDITS: [Action; 8] = [
    Action::ToggleEditing,
    Action::Edit(EditAction::Undo),
    Action::Edit(EditAction::Undo),
    Action::Edit(EditAction::Redo),
    Action::Edit(EditAction::Larger),
    Action::Edit(EditAction::Copy),
    Action::Edit(EditAction::Paste),
    Action::Edit(EditAction::Move),
];

fn keys_of(binding: &Binding) -> Vec<(Key, Modifiers)> {
    let of = |trigger: &Trigger| match *trigger {
        Trigger::Key(chord) => vec![(chord.key, chord.modifiers)],
        Trigger::Digits(modifiers) => (1..=9).map(|digit| (Key::Digit(digit), modifiers)).collect(),
        Trigger::Gesture(..) => Vec::new(),
    };
    binding.triggers.iter().flat_map(of).collect()
}

fn move_to(app: &mut App, place: Vec2) {
    app.to_panels.push(egui::Event::PointerMoved(egui::pos2(place.x, place.y)));
    app.input.move_to(place, &mut app.session);
}

fn button_event(place: Vec2, pressed: bool) -> egui::Event {
    let pos = egui::pos2(place.x, place.y);
    egui::Event::PointerButton { pos, button: egui::PointerButton::Primary, pressed, modifiers: egui::Modifiers::NONE }
}
