//! The device that traces and draws: what there is, which one it is, changing it while the window is open.

use super::App;
use super::wake::{Wake, WakeEngine};
use crate::engine::Engine;
use crate::panels::DeviceChoice;
use crate::session::Command;
use crate::tr;
use std::sync::Arc;
use voxtrace_vulkan::{DeviceInfo, DeviceKind, Options, Traversal, devices, missing};

impl App {
    /// Starts to trace on the device of the window, with what it can do.
    pub(super) fn start_engine(&mut self) {
        let Some(graphics) = &self.graphics else { return };
        let info = graphics.device().info();
        let has = |traversal: &Traversal| missing(info, *traversal).is_none();
        let all = [Traversal::Cpu, Traversal::Walk, Traversal::Query, Traversal::Pipeline];
        self.session.traversals = all.into_iter().filter(has).collect();
        let is_hardware = info.kind != DeviceKind::Cpu;
        let usual = if is_hardware { Traversal::Walk } else { Traversal::Cpu };
        let now = &mut self.session.render_settings.traversal;
        if !self.is_traversal_chosen || !self.session.traversals.contains(now) {
            *now = usual;
        }
        self.status.device = tr!("tracing.window_on", name = info.name);
        self.status.device_index = info.index;
        let proxy = self.proxy.clone();
        self.session.has_hardware = is_hardware;
        let engine = Engine::start(Arc::clone(graphics.device()), self.session.backend(), move |event| {
            // The window may be closed.
            let _ = proxy.send_event(Wake::Engine(WakeEngine(event)));
        });
        engine.set_light(self.session.light);
        self.engine = Some(engine);
    }

    /// Looks for the devices of this machine, which takes drivers a while.
    pub(super) fn list_devices(&self) {
        let proxy = self.proxy.clone();
        std::thread::spawn(move || {
            let found = devices(Options::default()).unwrap_or_default();
            let _ = proxy.send_event(Wake::Devices(choices(&found)));
        });
    }

    /// Goes on with another device: scene, camera and settings stay. Where it does not open, with the one there was.
    pub(super) fn set_device(&mut self, name: String) {
        let Some(graphics) = &mut self.graphics else { return };
        let is_chosen = self.session.render_settings.traversal != Traversal::Cpu;
        let device = match graphics.open_other(&name) {
            Ok(device) => device,
            Err(error) => return self.session.say(tr!("said.cannot_be_taken", name = name, error = error), true),
        };
        // What traces ends before what shows it.
        self.engine = None;
        self.status.forget_pictures();
        self.status.times.clear();
        let old = Arc::clone(graphics.device());
        if let Err(error) = graphics.move_to(&device) {
            self.session.say(tr!("said.cannot_be_taken", name = name, error = error), true);
            if let Err(error) = graphics.move_to(&old) {
                self.session.say(error.to_string(), true);
            }
        } else {
            self.settings.settings.device = Some(name);
            self.save_settings();
        }
        // What was traced by the processor may have been so for want of a GPU alone.
        self.is_traversal_chosen |= is_chosen;
        self.start_engine();
        self.session.ask(Command::SetScene);
        self.session.ask(Command::SetView);
        self.session.ask_for_comparison();
        self.session.ask(Command::Pause(self.session.pause()));
    }
}

/// The devices that can trace, by their names, or by their numbers where two have one name.
fn choices(devices: &[DeviceInfo]) -> Vec<DeviceChoice> {
    let is_double = |name: &str| devices.iter().filter(|device| device.name == name).count() > 1;
    let usable = devices.iter().filter(|device| device.walk_missing.is_none());
    usable
        .map(|device| DeviceChoice {
            index: device.index,
            value: if is_double(&device.name) { device.index.to_string() } else { device.name.clone() },
            label: format!("{}: {}", device.index, device.name),
        })
        .collect()
}
