//! Edits in the real window: made by a hand, saved, rendered by the command line, and kept when the program is ended.

use crate::common::{Folder, Picture};
use crate::view::{A_WHILE, Screen, View, has_device, validation};
use std::process::Command;
use std::time::Duration;
use voxtrace_test_support::{Need, skip_without};

/// The words of the last command that was copied, for as many samples as a picture has, into another file.
pub fn words_of(stdout: &str, picture: &Picture, out: &str) -> Vec<String> {
    let line = stdout.lines().rfind(|line| line.starts_with("voxtrace render ")).expect(stdout);
    let words: Vec<String> = line.split(' ').skip(1).map(str::to_owned).collect();
    let spp = words.iter().position(|word| word == "--spp").unwrap();
    let samples = picture.text("voxtrace.samples").to_owned();
    [&words[..=spp], &[samples], &words[spp + 2..], &["-o".to_owned(), out.to_owned()]].concat()
}

pub fn pixels(picture: &Picture) -> Vec<Vec<u16>> {
    (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| picture.pixel(x, y).to_vec())).collect()
}

#[test]
fn edits_are_marked_asked_for_saved_rendered_to_the_bit_and_kept_when_the_program_is_ended() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    let mut view = View::open(&folder, &screen, &["room.vxt"]);
    view.wait("the scene's title", |view| view.title().starts_with("room"));
    view.hand(&["windowsize", "--sync"], &["640", "420"]);
    view.hand(&["mousemove", "--window"], &["150", "235"]);
    view.key("ctrl+e");
    // The scene is made ready meanwhile.
    view.wait("the mark of edits", |view| {
        screen.hand(&["click", "1", "sleep", "0.2"]);
        view.title().starts_with("• room")
    });
    view.key("ctrl+z");
    view.wait("no mark any more", |view| {
        view.key("ctrl+z");
        view.title().starts_with("room")
    });
    view.key("ctrl+shift+z");
    view.wait("the mark again", |view| view.title().starts_with("• room"));
    // Closing asks; Esc stays.
    view.key("ctrl+q");
    std::thread::sleep(A_WHILE);
    assert!(view.program.0.try_wait().unwrap().is_none(), "it asks first");
    view.key("Escape");
    view.key("ctrl+s");
    view.wait("the file", |view| {
        view.key("Return");
        std::thread::sleep(Duration::from_millis(200));
        folder.exists("room-2.vxt")
    });
    view.wait("no mark of what is saved", |view| view.title().starts_with("room"));
    view.key("ctrl+shift+c");
    view.wait("a picture", |view| {
        view.key("F12");
        std::thread::sleep(Duration::from_millis(200));
        folder.exists("room-001.png")
    });
    // One more, which nobody saves: a signal ends the program.
    view.hand(&["mousemove", "--window"], &["120", "250"]);
    view.wait("the mark of another edit", |view| {
        screen.hand(&["click", "1", "sleep", "0.2"]);
        view.title().starts_with("• room")
    });
    std::thread::sleep(Duration::from_millis(300));
    Command::new("kill").args(["-TERM", &view.program.0.id().to_string()]).status().unwrap();
    let (_, stdout, stderr) = view.end();
    assert_eq!(validation(&stderr), Vec::<&str>::new());

    let picture = folder.png("room-001.png");
    let words = words_of(&stdout, &picture, "again.png");
    assert!(words.iter().any(|word| word.ends_with("room-2.vxt")), "{words:?}");
    folder.succeed(&words);
    let again = folder.png("again.png");
    assert!(pixels(&again) == pixels(&picture), "the window's film is that of the saved scene");
    let before: Vec<String> = words.iter().map(|word| word.replace("room-2.vxt", "room.vxt")).collect();
    folder.succeed(&before);
    assert!(pixels(&folder.png("again.png")) != pixels(&picture), "the comparison sees an edit");

    let kept: Vec<_> = std::fs::read_dir(folder.path("settings/recovery")).unwrap().flatten().collect();
    let scene = kept.iter().map(|entry| entry.path()).find(|path| path.extension().is_some_and(|own| own == "vxt"));
    let scene = scene.expect("the last edit is kept").display().to_string();
    let after: Vec<String> =
        words.iter().map(|word| if word.ends_with("room-2.vxt") { scene.clone() } else { word.clone() }).collect();
    folder.succeed(&after);
    assert!(pixels(&folder.png("again.png")) != pixels(&picture), "with the edit that nobody saved");
}
