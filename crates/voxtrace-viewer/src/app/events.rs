//! Events of winit, as plain values, to the state.

use super::graphics::Graphics;
use super::wake::{Wake, WakeDrawing, WakeEngine};
use super::{App, keyboard};
use crate::dialogs::TabUse;
use crate::engine::Event;
use crate::gamepad::Gamepad;
use crate::input::Button;
use crate::keys::Key;
use crate::session::News;
use crate::touch::Phase;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{ElementState, MouseButton, MouseScrollDelta, StartCause, TouchPhase, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::window::WindowId;

/// Time between two frames while the camera moves by itself.
const FRAME: Duration = Duration::from_millis(8);
/// Two clicks within this time are a double click.
const DOUBLE_CLICK: Duration = Duration::from_millis(400);

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.graphics.is_none()
            && let Err(failure) = self.open(event_loop)
        {
            self.fail(event_loop, failure);
        }
        self.carry_out(event_loop);
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: Wake) {
        match event {
            Wake::Engine(WakeEngine(Event::Gone(error))) => return self.fail(event_loop, error.into()),
            Wake::Engine(WakeEngine(event)) => self.take_engine_event(event),
            Wake::Drawing(WakeDrawing(drawing)) => {
                self.take_drawing(drawing);
                // Frames follow each other where one is due, and not else.
                return self.carry_out_without_redraw(event_loop);
            }
            Wake::News(News::Loading) => self.take_loaded(),
            Wake::News(News::Edited) => self.session.take_edited(),
            Wake::News(News::Sky) => self.session.take_sky(),
            Wake::News(News::Surroundings) => self.session.take_surroundings(),
            Wake::News(News::Exported) => self.session.take_exported(),
            Wake::News(News::Written) => self.session.take_written(),
            Wake::Unkept(reason) => self.session.say(reason, true),
            Wake::Chosen { path, is_quick } => self.take_chosen(path, is_quick),
            Wake::ChosenPath { path, is_quick } => self.take_chosen_path(path, is_quick),
            // Systems tell every program: who plays in another window moves nothing here.
            Wake::Pad(_) if self.is_away => return,
            Wake::Pad(event) => self.gamepad.take(event, &mut self.session),
            Wake::Devices(devices) => self.status.devices = devices,
            Wake::Accessibility(event) => {
                if let (Some(graphics), egui_winit::accesskit_winit::WindowEvent::ActionRequested(request)) =
                    (&mut self.graphics, event.window_event)
                {
                    graphics.egui.on_accesskit_action_request(request);
                }
            }
        }
        self.carry_out(event_loop);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(graphics) = &mut self.graphics else { return };
        // Keys that are down when the window gets the keyboard were pressed elsewhere: Ctrl+Q that closed another window closes no second one.
        if let WindowEvent::KeyboardInput { event, is_synthetic: true, .. } = &event
            && event.state == ElementState::Pressed
        {
            return;
        }
        let window = Arc::clone(&graphics.window);
        // Tab shows and hides the panels; among them it would take the focus, and with it the arrows. In a dialog it leads on.
        let tab = match &event {
            WindowEvent::KeyboardInput { event, .. } if keyboard::key_of(event) == Some(Key::Tab) => {
                Some(if event.state == ElementState::Pressed { self.session.take_tab() } else { TabUse::Window })
            }
            _ => None,
        };
        let is_for_egui = matches!(tab, None | Some(TabUse::NextField));
        let repaints = is_for_egui && graphics.egui.on_window_event(&window, &event).repaint;
        match event {
            WindowEvent::CloseRequested => self.quit(event_loop),
            WindowEvent::RedrawRequested => {
                self.draw();
                self.carry_out_without_redraw(event_loop);
                return;
            }
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                graphics.resize((width, height));
                let size = window.inner_size().to_logical::<u32>(window.scale_factor());
                if window.fullscreen().is_none() && width > 0 {
                    self.settings.settings.window = [size.width, size.height];
                }
            }
            WindowEvent::DroppedFile(path) => self.session.take_dropped(&path),
            WindowEvent::ModifiersChanged(modifiers) => {
                self.input.set_modifiers(keyboard::modifiers_of(modifiers.state()), &mut self.session);
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let is_pressed = event.state == ElementState::Pressed;
                let key = keyboard::key_of(&event);
                // Esc closes a dialog also while its fields are typed in.
                let is_escape = key == Some(Key::Escape) && self.session.dialog.is_some();
                if let Some(key) = key
                    && matches!(tab, None | Some(TabUse::Window))
                    && (self.has_keyboard() || !is_pressed || is_escape)
                {
                    self.input.key(key, is_pressed, event.repeat, &mut self.session);
                }
            }
            WindowEvent::Focused(is_here) => {
                self.is_away = !is_here;
                if self.is_away {
                    self.input.lose_focus(&mut self.session);
                    // Where its sticks are when the keyboard is back, they tell then.
                    self.gamepad = Gamepad::default();
                }
            }
            WindowEvent::CursorLeft { .. } => self.input.leave(&mut self.session),
            WindowEvent::CursorMoved { position, .. } => {
                let cursor = Vec2::new(position.x as f32, position.y as f32);
                self.input.move_to(cursor, &mut self.session);
                // What lies behind a dialog is not under the cursor.
                if self.is_over_panels() {
                    self.session.hover = None;
                }
            }
            WindowEvent::MouseInput { button, state, .. } => self.mouse_button(button, state),
            WindowEvent::MouseWheel { delta, .. } if !self.is_over_panels() => match delta {
                MouseScrollDelta::LineDelta(_, notches) => self.input.wheel(notches, &mut self.session),
                MouseScrollDelta::PixelDelta(by) => {
                    self.input.scroll(Vec2::new(by.x as f32, by.y as f32), &mut self.session);
                }
            },
            WindowEvent::PinchGesture { delta, .. } if !self.is_over_panels() => {
                self.input.pinch(delta as f32, &mut self.session);
            }
            WindowEvent::RotationGesture { delta, .. } if !self.is_over_panels() => {
                self.input.rotate(delta, &mut self.session);
            }
            WindowEvent::PanGesture { delta, .. } if !self.is_over_panels() => {
                self.input.scroll(Vec2::new(delta.x, delta.y), &mut self.session);
            }
            WindowEvent::Touch(touch) => self.touched(touch),
            _ => {
                if repaints {
                    window.request_redraw();
                }
                return;
            }
        }
        self.carry_out(event_loop);
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _: StartCause) {
        self.stopwatch.begin_turn();
        let now = Instant::now();
        let since = now.duration_since(self.last_advance);
        // Drawing does not hold this thread up: without a shortest step it would take a core for itself.
        if since >= FRAME / 2 {
            self.last_advance = now;
            self.session.advance(since.as_secs_f32());
            self.carry_out_without_redraw(event_loop);
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        // A view that has come to rest is asked for once more; messages go by themselves; a film may be under way.
        let is_soon = self.session.is_moving() || self.session.navigator.held.is_moving();
        let flow = if is_soon {
            ControlFlow::WaitUntil(Instant::now() + FRAME)
        } else {
            let repaint = self.graphics.as_ref().and_then(|graphics| graphics.repaint_at);
            if repaint.is_some_and(|at| at <= Instant::now())
                && let Some(graphics) = &self.graphics
            {
                graphics.window.request_redraw();
            }
            ControlFlow::WaitUntil(Instant::now() + Duration::from_millis(200))
        };
        if self.loader.is_interrupted() {
            event_loop.exit();
        }
        self.save_film();
        self.keep_edits();
        self.carry_out_without_redraw(event_loop);
        self.update_title();
        event_loop.set_control_flow(flow);
        self.stopwatch.end_turn();
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        self.save_settings();
        self.end_edits();
        self.stopwatch.report(self.graphics.as_ref().map(Graphics::phases).as_ref());
        // What is being written is whole or not there.
        (self.session.exporting, self.session.running) = (None, None);
        self.session.finish_writing();
        // A panic was printed when it happened.
        self.writing.drain(..).for_each(|thread| _ = thread.join());
        // What traces ends before what shows it.
        self.engine = None;
        self.status.forget_pictures();
        self.graphics = None;
    }
}

impl App {
    /// Whether the panels want what the mouse does: by where it is now, which they themselves see in their next frame only.
    fn is_over_panels(&self) -> bool {
        let holds = |graphics: &Graphics| graphics.egui.egui_ctx().egui_is_using_pointer();
        let is_over = || self.input.cursor().is_some_and(|cursor| self.is_on_panels(cursor));
        !self.input.is_dragging() && (self.graphics.as_ref().is_some_and(holds) || is_over())
    }

    /// A finger on the screen, unless it came down on the panels: these have it then.
    fn touched(&mut self, touch: winit::event::Touch) {
        let place = Vec2::new(touch.location.x as f32, touch.location.y as f32);
        let phase = match touch.phase {
            TouchPhase::Started if self.is_on_panels(place) => return,
            TouchPhase::Started => Phase::Down,
            TouchPhase::Moved => Phase::Moved,
            TouchPhase::Ended => Phase::Up,
            TouchPhase::Cancelled => Phase::Cancelled,
        };
        self.touch.touch(touch.id, phase, place, Instant::now(), &mut self.input, &mut self.session);
    }

    /// Whether a place lies on the panels: beside the picture, or on a window over it.
    fn is_on_panels(&self, place: Vec2) -> bool {
        let Some(graphics) = &self.graphics else { return true };
        let context = graphics.egui.egui_ctx();
        let point = egui::Pos2::new(place.x, place.y) / context.pixels_per_point();
        let layer = context.layer_id_at(point);
        let (width, height) = self.session.size();
        place.x >= width as f32
            || place.y >= height as f32
            || layer.is_some_and(|layer| layer.order != egui::Order::Background)
    }

    /// Whether keys are those of the table: all but what is typed into a field of the panels, or is for what has the focus of a dialog.
    fn has_keyboard(&self) -> bool {
        let in_dialog = self.session.dialog.is_some();
        let takes = |context: &egui::Context| {
            context.text_edit_focused() || (in_dialog && context.memory(|memory| memory.focused().is_some()))
        };
        !self.graphics.as_ref().is_some_and(|graphics| takes(graphics.egui.egui_ctx()))
    }

    fn mouse_button(&mut self, button: MouseButton, state: ElementState) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        if state == ElementState::Released {
            self.input.release(button, &mut self.session);
            return;
        }
        if self.is_over_panels() {
            return;
        }
        self.input.press(button, &mut self.session);
        let Some(cursor) = self.input.cursor().filter(|_| button == Button::Left) else { return };
        let is_second =
            self.last_click.is_some_and(|(time, place)| time.elapsed() < DOUBLE_CLICK && place.distance(cursor) < 6.0);
        self.last_click = (!is_second).then(|| (Instant::now(), cursor));
        if is_second {
            self.input.double_click(&mut self.session);
        }
    }
}
