//! Limits of bounces by kind and the clamp of indirect light: the panel sets them, the frame has them, and the command says them.

use crate::common::panel::{click, panels, set};
use crate::common::{in_room, packed, rendered, words};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use voxtrace::{BounceLimits, Frame};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::Command;

#[test]
fn limits_are_set_by_sliders_and_the_film_is_that_of_render() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let unlimited = harness.state().view().frame();
    assert!(!words(harness.state()).contains("bounces") && !words(harness.state()).contains("clamp"));
    click(&mut harness, "Limits");
    for (slider, value) in [("bounces, matte", 1.0), ("bounces, glossy", 2.0), ("bounces, media", 32.0)] {
        set(&mut harness, slider, value);
        assert_eq!(harness.state_mut().take_commands(), [Command::SetView]);
    }
    assert!(harness.query_by_role_and_label(Role::Slider, "most radiance").is_none());
    click(&mut harness, "clamp indirect light: less noise, too dark");
    set(&mut harness, "most radiance", 0.5);
    let line = words(harness.state());
    let expected = "--diffuse-bounces 1 --glossy-bounces 2 --volume-bounces 32 --clamp-indirect 0.5";
    assert!(line.contains(expected), "{line}");

    let limits = BounceLimits { diffuse: 1, glossy: 2, volume: 32, ..BounceLimits::default() };
    let limited = unlimited.clone().bounce_limits(limits).clamp_indirect(0.5);
    assert_eq!(harness.state().view().frame(), limited);
    let film = |frame: &Frame| rendered(&packed(), &frame.clone().size(40, 30).samples(2));
    assert!(film(&harness.state().view().frame()) == film(&limited), "to the bit");
    assert!(film(&limited) != film(&unlimited), "the comparison sees the limits");

    // The end of a slider, and the box once more, take them away.
    for slider in ["bounces, matte", "bounces, glossy", "bounces, media"] {
        set(&mut harness, slider, 33.0);
    }
    click(&mut harness, "clamp indirect light: less noise, too dark");
    assert_eq!(harness.state().view().frame(), unlimited);
}
