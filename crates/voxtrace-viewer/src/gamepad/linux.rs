//! Gamepads of Linux, as the kernel's gamepad specification (Documentation/input/gamepad.rst) names their parts. Udev lets whoever sits at the
//! screen read them.

use super::{PadAxis, PadEvent};
use crate::keys::PadButton;
use evdev::{AbsoluteAxisCode, Device, EventSummary, KeyCode};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How often new gamepads are looked for.
const LOOK: Duration = Duration::from_secs(2);

type Tell = Arc<dyn Fn(PadEvent) -> bool + Send + Sync>;

/// Looks for gamepads, and gives each a thread that waits for what it tells.
pub fn listen(tell: Tell) {
    let known: Arc<Mutex<HashSet<PathBuf>>> = Arc::default();
    let is_open = Arc::new(AtomicBool::new(true));
    while is_open.load(Ordering::Relaxed) {
        let found = std::fs::read_dir("/dev/input").into_iter().flatten().flatten().map(|entry| entry.path());
        let mut seen = HashSet::new();
        for path in found.filter(|path| is_event(path)) {
            seen.insert(path.clone());
            if !locked(&known).insert(path.clone()) {
                continue;
            }
            let Ok(device) = Device::open(&path) else {
                // Udev lets it be read a moment after it has come: it is tried again.
                locked(&known).remove(&path);
                continue;
            };
            if !is_gamepad(&device) {
                continue;
            }
            let (tell, known, is_open) = (Arc::clone(&tell), Arc::clone(&known), Arc::clone(&is_open));
            std::thread::spawn(move || {
                if !follow(device, &tell) {
                    is_open.store(false, Ordering::Relaxed);
                }
                locked(&known).remove(&path);
            });
        }
        locked(&known).retain(|path| seen.contains(path));
        std::thread::sleep(LOOK);
    }
}

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn is_event(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("event"))
}

fn is_gamepad(device: &Device) -> bool {
    device.supported_keys().is_some_and(|keys| keys.contains(KeyCode::BTN_SOUTH))
}

/// Tells what a gamepad does until it is gone. Returns false where nobody listens any more.
fn follow(mut device: Device, tell: &Tell) -> bool {
    let ranges: Vec<(AbsoluteAxisCode, i32, i32)> = device
        .get_absinfo()
        .map(|axes| axes.map(|(code, info)| (code, info.minimum(), info.maximum())).collect())
        .unwrap_or_default();
    let range = |code: AbsoluteAxisCode| {
        ranges.iter().find(|(own, ..)| *own == code).map_or((-32_768, 32_767), |&(_, least, most)| (least, most))
    };
    loop {
        let Ok(events) = device.fetch_events() else { return tell(PadEvent::Gone) };
        for event in events {
            let told = match event.destructure() {
                EventSummary::Key(_, code, 1) => button_of(code).map(PadEvent::Press),
                EventSummary::AbsoluteAxis(_, code, value) => axis_event(code, value, range(code)),
                _ => None,
            };
            if told.is_some_and(|told| !tell(told)) {
                return false;
            }
        }
    }
}

fn button_of(code: KeyCode) -> Option<PadButton> {
    Some(match code {
        KeyCode::BTN_SOUTH => PadButton::South,
        KeyCode::BTN_EAST => PadButton::East,
        KeyCode::BTN_NORTH => PadButton::North,
        KeyCode::BTN_WEST => PadButton::West,
        KeyCode::BTN_TL => PadButton::LeftShoulder,
        KeyCode::BTN_TR => PadButton::RightShoulder,
        KeyCode::BTN_START => PadButton::Start,
        KeyCode::BTN_SELECT => PadButton::Select,
        KeyCode::BTN_DPAD_UP => PadButton::Up,
        KeyCode::BTN_DPAD_DOWN => PadButton::Down,
        KeyCode::BTN_DPAD_LEFT => PadButton::Left,
        KeyCode::BTN_DPAD_RIGHT => PadButton::Right,
        _ => return None,
    })
}

/// What an axis says, whose values lie in a range. Down is positive for the kernel.
fn axis_event(code: AbsoluteAxisCode, value: i32, (least, most): (i32, i32)) -> Option<PadEvent> {
    let share = (f64::from(value) - f64::from(least)) / (f64::from(most) - f64::from(least)).max(1.0);
    let (stick, trigger) = ((share * 2.0 - 1.0) as f32, share as f32);
    let told = match code {
        AbsoluteAxisCode::ABS_X => (PadAxis::LeftX, stick),
        AbsoluteAxisCode::ABS_Y => (PadAxis::LeftY, -stick),
        AbsoluteAxisCode::ABS_RX => (PadAxis::RightX, stick),
        AbsoluteAxisCode::ABS_RY => (PadAxis::RightY, -stick),
        AbsoluteAxisCode::ABS_Z => (PadAxis::LeftTrigger, trigger),
        AbsoluteAxisCode::ABS_RZ => (PadAxis::RightTrigger, trigger),
        AbsoluteAxisCode::ABS_HAT0X if value != 0 => {
            return Some(PadEvent::Press(if value < 0 { PadButton::Left } else { PadButton::Right }));
        }
        AbsoluteAxisCode::ABS_HAT0Y if value != 0 => {
            return Some(PadEvent::Press(if value < 0 { PadButton::Up } else { PadButton::Down }));
        }
        _ => return None,
    };
    Some(PadEvent::Axis(told.0, told.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kernels_axes_are_those_of_a_gamepad_upwards_and_to_the_right() {
        let of = |code, value, range| axis_event(code, value, range);
        let bytes = (0, 255);
        assert_eq!(of(AbsoluteAxisCode::ABS_X, 255, bytes), Some(PadEvent::Axis(PadAxis::LeftX, 1.0)));
        assert_eq!(of(AbsoluteAxisCode::ABS_Y, 0, bytes), Some(PadEvent::Axis(PadAxis::LeftY, 1.0)));
        assert_eq!(
            of(AbsoluteAxisCode::ABS_RY, 32_767, (-32_768, 32_767)),
            Some(PadEvent::Axis(PadAxis::RightY, -1.0))
        );
        assert_eq!(of(AbsoluteAxisCode::ABS_Z, 0, (0, 1023)), Some(PadEvent::Axis(PadAxis::LeftTrigger, 0.0)));
        assert_eq!(of(AbsoluteAxisCode::ABS_HAT0Y, -1, (-1, 1)), Some(PadEvent::Press(PadButton::Up)));
        assert_eq!(of(AbsoluteAxisCode::ABS_HAT0Y, 0, (-1, 1)), None);
        assert_eq!(button_of(KeyCode::BTN_WEST), Some(PadButton::West));
        assert_eq!(button_of(KeyCode::KEY_A), None);
    }
}
