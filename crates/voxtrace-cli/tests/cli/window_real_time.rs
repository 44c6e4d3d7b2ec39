//! Real-time light in the real window: a hand moves the view, edits a voxel and resizes the window, and where it then stands the film is that of the command line.

use crate::common::{Folder, Picture};
use crate::view::{Screen, View, has_device, validation};
use crate::window_edits::{pixels, words_of};
use std::time::Duration;
use voxtrace_test_support::{Need, skip_without};

/// Samples from which on a film is seen alone at the earliest: over frames whose pixels are eight times as large.
const CLEAN: u32 = 4;

fn samples(picture: &Picture) -> u32 {
    picture.text("voxtrace.samples").parse().unwrap()
}

#[test]
fn after_moving_editing_and_resizing_in_real_time_light_the_film_is_that_of_the_command_line() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    let tells = [("VOXTRACE_VIEW_TIMES", "1")];
    let mut view = View::open_with(&folder, &screen, &["room.vxt", "--traversal", "walk"], &tells);
    view.wait("the scene's title", |view| view.title().starts_with("room"));
    view.hand(&["windowsize", "--sync"], &["360", "270"]);
    // Software, on which the key alone turns it on.
    view.key("r");
    view.hand(&["mousemove", "--window"], &["150", "150"]);
    for _ in 0..6 {
        screen.hand(&["mousedown", "3", "mousemove_relative", "--sync", "4", "1", "mouseup", "3"]);
        std::thread::sleep(Duration::from_millis(150));
    }
    view.key("ctrl+e");
    // Its panel would lie over the place.
    view.key("Tab");
    view.wait("the mark of edits", |view| {
        screen.hand(&["click", "1", "sleep", "0.2"]);
        view.title().starts_with("• room")
    });
    view.hand(&["windowsize", "--sync"], &["330", "250"]);
    view.key("ctrl+s");
    view.wait("the file", |view| {
        view.key("Return");
        std::thread::sleep(Duration::from_millis(200));
        folder.exists("room-2.vxt")
    });
    view.key("Escape");
    view.key("ctrl+shift+c");
    view.key("F12");
    view.wait("a picture", |_| folder.exists("room-001.png"));
    view.key("ctrl+q");
    let (code, stdout, stderr) = view.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert_eq!(validation(&stderr), Vec::<&str>::new());

    let picture = folder.png("room-001.png");
    let drawn = stderr.lines().find_map(|line| line.strip_prefix("pictures drawn: ")).expect(&stderr);
    let lit: u32 = drawn.split(' ').filter_map(|word| word.parse().ok()).nth(1).expect(drawn);
    assert!(lit > 0, "no picture in real-time light: {stderr}");
    assert!(samples(&picture) >= CLEAN, "it waits until the film is seen alone: {}", samples(&picture));
    assert_eq!((picture.width, picture.height), (330, 250));
    let words = words_of(&stdout, &picture, "again.png");
    assert!(words.iter().any(|word| word.ends_with("room-2.vxt")), "{words:?}");
    folder.succeed(&words);
    assert!(pixels(&folder.png("again.png")) == pixels(&picture), "nothing of real-time light is in the film");
    let before: Vec<String> = words.iter().map(|word| word.replace("room-2.vxt", "room.vxt")).collect();
    folder.succeed(&before);
    assert!(pixels(&folder.png("again.png")) != pixels(&picture), "the comparison sees an edit");
}
