//! Gamepads of Windows and macOS, by gilrs.

use super::{PadAxis, PadEvent};
use crate::keys::PadButton;
use gilrs::{Axis, Button, EventType, Gilrs};
use std::sync::Arc;
use std::time::Duration;

/// Longest wait for something to happen.
const WAIT: Duration = Duration::from_secs(1);

/// Tells what gamepads do until nobody listens any more.
pub fn listen(tell: Arc<dyn Fn(PadEvent) -> bool + Send + Sync>) {
    // A system without gamepads has none to listen to.
    let Ok(mut gilrs) = Gilrs::new() else { return };
    loop {
        let Some(event) = gilrs.next_event_blocking(Some(WAIT)) else { continue };
        let told = match event.event {
            EventType::AxisChanged(axis, value, _) => axis_of(axis).map(|axis| PadEvent::Axis(axis, value)),
            EventType::ButtonChanged(Button::LeftTrigger2, value, _) => {
                Some(PadEvent::Axis(PadAxis::LeftTrigger, value))
            }
            EventType::ButtonChanged(Button::RightTrigger2, value, _) => {
                Some(PadEvent::Axis(PadAxis::RightTrigger, value))
            }
            EventType::ButtonPressed(button, _) => button_of(button).map(PadEvent::Press),
            EventType::Disconnected => Some(PadEvent::Gone),
            _ => None,
        };
        if told.is_some_and(|told| !tell(told)) {
            return;
        }
    }
}

fn axis_of(axis: Axis) -> Option<PadAxis> {
    Some(match axis {
        Axis::LeftStickX => PadAxis::LeftX,
        Axis::LeftStickY => PadAxis::LeftY,
        Axis::RightStickX => PadAxis::RightX,
        Axis::RightStickY => PadAxis::RightY,
        _ => return None,
    })
}

fn button_of(button: Button) -> Option<PadButton> {
    Some(match button {
        Button::South => PadButton::South,
        Button::East => PadButton::East,
        Button::North => PadButton::North,
        Button::West => PadButton::West,
        Button::LeftTrigger => PadButton::LeftShoulder,
        Button::RightTrigger => PadButton::RightShoulder,
        Button::Start => PadButton::Start,
        Button::Select => PadButton::Select,
        Button::DPadUp => PadButton::Up,
        Button::DPadDown => PadButton::Down,
        Button::DPadLeft => PadButton::Left,
        Button::DPadRight => PadButton::Right,
        _ => return None,
    })
}
