//! Tests of the table: nothing stands twice, and the page is that of the table.

use super::*;

/// Everything that a trigger answers to.
fn expanded(trigger: &Trigger) -> Vec<String> {
    match *trigger {
        Trigger::Key(chord) => vec![format!("{chord:?}")],
        Trigger::Digits(modifiers) => {
            (1..=9).map(|digit| format!("{:?}", Chord { key: Key::Digit(digit), modifiers })).collect()
        }
        Trigger::Gesture(gesture, modifiers, mode) => {
            let modes =
                [Mode::Fly, Mode::Orbit, Mode::Walk].into_iter().filter(|own| mode.is_none_or(|mode| mode == *own));
            modes.map(|mode| format!("{gesture:?} {modifiers:?} {mode:?}")).collect()
        }
    }
}

/// Triggers that stand twice.
fn collisions(table: &[Binding]) -> Vec<String> {
    let pads = table.iter().filter_map(|binding| binding.pad).map(|button| format!("{button:?}"));
    let keys = table.iter().flat_map(|binding| binding.triggers).flat_map(expanded);
    let mut all: Vec<String> = keys.chain(pads).collect();
    all.sort();
    all.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0].clone()).collect()
}

fn chord(modifiers: Modifiers, key: Key) -> Chord {
    Chord { key, modifiers }
}

#[test]
fn no_key_and_no_gesture_does_two_things() {
    assert_eq!(collisions(TABLE), Vec::<String>::new());
    let plant = |triggers: &'static [Trigger], pad| {
        let planted = Binding { triggers, told: "", pad, action: Action::Quit, group: Group::Window, about: "" };
        collisions(&[TABLE, &[planted]].concat())
    };
    const SEVEN: &[Trigger] = &[Trigger::Key(Chord { key: Key::Digit(7), modifiers: Modifiers::SHIFT })];
    const WHEEL: &[Trigger] = &[Trigger::Gesture(Gesture::Wheel, Modifiers::NONE, None)];
    assert_eq!((plant(SEVEN, None).len(), plant(WHEEL, None).len()), (1, 3), "one among the digits, one in each mode");
    assert_eq!((plant(&[], None).len(), plant(&[], Some(PadButton::East)).len()), (0, 1));
}

#[test]
fn every_key_of_the_table_does_what_the_table_says() {
    for binding in TABLE {
        for trigger in binding.triggers {
            let action = match *trigger {
                Trigger::Key(chord) => action_of(chord, false),
                Trigger::Digits(modifiers) => action_of(chord(modifiers, Key::Digit(1)), false),
                Trigger::Gesture(gesture, modifiers, mode) => {
                    action_of_gesture(gesture, modifiers, mode.unwrap_or(Mode::Fly))
                }
            };
            assert_eq!(action, Some(binding.action), "{trigger:?}");
        }
        let is_reached = !binding.triggers.is_empty() || !binding.told.is_empty() || binding.pad.is_some();
        assert!(!binding.about.is_empty() && is_reached);
        assert!(binding.pad.is_none_or(|button| action_of_pad(button) == Some(binding.action)));
    }
    assert!(Movement::ALL.iter().all(|movement| TABLE.iter().any(|own| own.action == Action::Move(*movement))));
}

#[test]
fn digits_go_to_bookmarks_and_with_shift_keep_them() {
    for number in 1..=9 {
        let key = Key::Digit(number);
        assert_eq!(action_of(chord(Modifiers::NONE, key), false), Some(Action::GoToBookmark(number)));
        assert_eq!(action_of(chord(Modifiers::SHIFT, key), false), Some(Action::StoreBookmark(number)));
    }
    assert_eq!(action_of(chord(Modifiers::NONE, Key::Digit(0)), false), None);
}

#[test]
fn plus_is_plus_with_shift_or_without() {
    for (modifiers, action) in [
        (Modifiers::NONE, Action::SpeedUp),
        (Modifiers::SHIFT, Action::SpeedUp),
        (Modifiers::CTRL, Action::ScaleUp),
        (Modifiers::CTRL_SHIFT, Action::ScaleUp),
    ] {
        assert_eq!(action_of(chord(modifiers, Key::Plus), false), Some(action), "{modifiers}");
    }
    assert_eq!(action_of(chord(Modifiers::CTRL_SHIFT, Key::Minus), false), None, "minus is written without");
}

#[test]
fn in_flight_shift_and_ctrl_mean_the_speed_alone() {
    let (q, w) = (Key::Letter('Q'), Key::Letter('W'));
    let (down, forward) = (Action::Move(Movement::Down), Action::Move(Movement::Forward));
    assert_eq!(action_of(chord(Modifiers::CTRL, q), false), Some(Action::Quit));
    assert_eq!(action_of(chord(Modifiers::CTRL, q), true), Some(down));
    for modifiers in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::CTRL, Modifiers::CTRL_SHIFT] {
        assert_eq!(action_of(chord(modifiers, w), false), Some(forward), "flight begins with them held too");
        assert_eq!(action_of(chord(modifiers, w), true), Some(forward));
        let digit = chord(modifiers, Key::Digit(4));
        assert_eq!(action_of(digit, true), Some(Action::GoToBookmark(4)), "flying fast writes over no bookmark");
    }
    assert_eq!(action_of(chord(Modifiers::ALT, w), false), None);
    assert_eq!(action_of(chord(Modifiers::CTRL, Key::Digit(4)), false), None);
}

#[test]
fn dragging_and_the_wheel_follow_the_mode() {
    let of = |gesture, mode| action_of_gesture(gesture, Modifiers::NONE, mode);
    assert_eq!(of(Gesture::LeftDrag, Mode::Orbit), Some(Action::Steer(Steer::Orbit)));
    assert_eq!(of(Gesture::LeftDrag, Mode::Fly), Some(Action::Steer(Steer::Look)));
    assert_eq!(of(Gesture::Wheel, Mode::Orbit), Some(Action::Steer(Steer::Zoom)));
    assert_eq!(of(Gesture::Wheel, Mode::Fly), Some(Action::Steer(Steer::Speed)));
    assert_eq!(action_of_gesture(Gesture::Click, Modifiers::ALT, Mode::Fly), None);
}

/// Whether a page holds the tables between its markers.
fn is_current(page: &str, tables: &str) -> bool {
    let between = page.split_once("<!-- keys -->\n").and_then(|(_, rest)| rest.split_once("<!-- end of keys -->"));
    between.is_some_and(|(between, _)| between == tables)
}

#[test]
fn the_page_of_the_window_has_the_keys_of_the_table() {
    let page = include_str!("../../../../docs/viewer.md").replace('\r', "");
    let tables = markdown();
    assert!(is_current(&page, &tables), "between the markers of docs/viewer.md should stand:\n{tables}");
    assert!(!is_current(&page.replacen("full screen", "fool screen", 1), &tables));
    assert!(!is_current(&page, &page::markdown_of(&TABLE[1..])));
}
