//! Keys of winit as those of the table.

use crate::keys::{Key, Modifiers};
use winit::event::KeyEvent;
use winit::keyboard::{Key as Logical, KeyCode, ModifiersState, NamedKey, PhysicalKey};
use winit::platform::modifier_supplement::KeyEventExtModifierSupplement;

/// The key of an event: digits by their place, so that Shift+1 is one; letters by what they write without modifiers.
pub fn key_of(event: &KeyEvent) -> Option<Key> {
    if let PhysicalKey::Code(code) = event.physical_key
        && let Some(digit) = digit_of(code)
    {
        return Some(Key::Digit(digit));
    }
    match event.key_without_modifiers() {
        Logical::Character(text) => match text.chars().next()? {
            '+' | '=' => Some(Key::Plus),
            '-' => Some(Key::Minus),
            letter if letter.is_ascii_alphabetic() => Some(Key::Letter(letter.to_ascii_uppercase())),
            _ => letter_at(event.physical_key),
        },
        Logical::Named(named) => named_key(named),
        _ => letter_at(event.physical_key),
    }
}

/// What is held beside keys.
pub fn modifiers_of(state: ModifiersState) -> Modifiers {
    Modifiers { ctrl: state.control_key() || state.super_key(), shift: state.shift_key(), alt: state.alt_key() }
}

fn digit_of(code: KeyCode) -> Option<u8> {
    use KeyCode::{
        Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9, Numpad0, Numpad1, Numpad2,
        Numpad3, Numpad4, Numpad5, Numpad6, Numpad7, Numpad8, Numpad9,
    };
    let rows = [
        [Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9],
        [Numpad0, Numpad1, Numpad2, Numpad3, Numpad4, Numpad5, Numpad6, Numpad7, Numpad8, Numpad9],
    ];
    rows.iter().find_map(|row| row.iter().position(|&other| other == code)).map(|digit| digit as u8)
}

/// The letter at the place of a key on a US keyboard, for layouts of other scripts.
fn letter_at(key: PhysicalKey) -> Option<Key> {
    let PhysicalKey::Code(code) = key else { return None };
    let name = format!("{code:?}");
    let letter = name.strip_prefix("Key")?.chars().next()?;
    Some(Key::Letter(letter))
}

fn named_key(named: NamedKey) -> Option<Key> {
    Some(match named {
        NamedKey::Escape => Key::Escape,
        NamedKey::Enter => Key::Enter,
        NamedKey::Space => Key::Space,
        NamedKey::Tab => Key::Tab,
        NamedKey::Delete => Key::Delete,
        NamedKey::Home => Key::Home,
        NamedKey::PageUp => Key::PageUp,
        NamedKey::PageDown => Key::PageDown,
        NamedKey::ArrowLeft => Key::Left,
        NamedKey::ArrowRight => Key::Right,
        NamedKey::ArrowUp => Key::Up,
        NamedKey::ArrowDown => Key::Down,
        NamedKey::F1 => Key::Function(1),
        NamedKey::F2 => Key::Function(2),
        NamedKey::F3 => Key::Function(3),
        NamedKey::F4 => Key::Function(4),
        NamedKey::F5 => Key::Function(5),
        NamedKey::F6 => Key::Function(6),
        NamedKey::F7 => Key::Function(7),
        NamedKey::F8 => Key::Function(8),
        NamedKey::F9 => Key::Function(9),
        NamedKey::F10 => Key::Function(10),
        NamedKey::F11 => Key::Function(11),
        NamedKey::F12 => Key::Function(12),
        _ => return None,
    })
}
