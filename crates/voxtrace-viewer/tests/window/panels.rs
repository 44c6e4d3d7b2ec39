//! The panels as a screen reader has them: what is there by its name, and what a click asks for.

use crate::common::panel::{choose, click, panels};
use crate::common::{SIZE, house, in_room, room, said};
use egui::accesskit::{Role, Toggled};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use std::sync::Arc;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::surroundings::{Fog, Ground};
use voxtrace::{Integrator, PackedScene, Sun};
use voxtrace_bench::{Measurement, Times};
use voxtrace_viewer::cutting::Slice;
use voxtrace_viewer::engine::{Backend, Contrast, Pause};
use voxtrace_viewer::keys::{self, Action, Group};
use voxtrace_viewer::measuring::{Kind, Measure};
use voxtrace_viewer::navigation::Mode;
use voxtrace_viewer::panels::{self as panel, Status};
use voxtrace_viewer::session::{Command, Session};
use voxtrace_vulkan::{Primitive, Traversal};

fn commands(harness: &mut Harness<Session>) -> Vec<Command> {
    harness.state_mut().take_commands()
}

/// What stands in all nodes of a role, by name; what has none is an empty text.
fn names(harness: &Harness<Session>, role: Role) -> Vec<String> {
    let nodes = harness.root().children_recursive().filter(|node| node.accesskit_node().role() == role);
    nodes.map(|node| node.accesskit_node().label().unwrap_or_default()).collect()
}

/// Roles of nodes that somebody can change or press and that have no name.
fn nameless(harness: &Harness<Session>) -> Vec<Role> {
    const ROLES: [Role; 7] =
        [Role::Button, Role::Slider, Role::SpinButton, Role::CheckBox, Role::ComboBox, Role::Link, Role::RadioButton];
    let nodes = ROLES.into_iter().flat_map(|role| names(harness, role).into_iter().map(move |name| (role, name)));
    nodes.filter(|(_, name)| name.trim().is_empty()).map(|(role, _)| role).collect()
}

#[test]
fn the_welcome_lists_what_there_is_and_a_click_asks_to_open_it() {
    let built_in = ["city", "church"].map(|name| (name.to_owned(), format!("about {name}")));
    let status = Status { built_in: built_in.into(), recent: vec!["/x/last.vox".into()], ..Status::default() };
    let mut harness = panels(Session::new(Traversal::Cpu), status);
    assert_eq!(commands(&mut harness), []);
    assert!(harness.query_by_label_contains("about city").is_some(), "what it is stands beside it");
    for name in ["church", "/x/last.vox"] {
        click(&mut harness, name);
        assert_eq!(commands(&mut harness), [Command::Load(name.into())]);
    }
    click(&mut harness, "Open a file…");
    assert_eq!(commands(&mut harness), [Command::AskForFile]);
    assert_eq!(nameless(&harness), []);
    let welcome = panels(in_room("room.vxt"), Status::default());
    assert!(welcome.query_by_label("Open a file…").is_none(), "a scene takes its place");
}

#[test]
fn the_box_of_traversals_lists_what_the_machine_has_and_a_choice_is_traced_with() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    assert!(harness.query_by_role_and_label(Role::ComboBox, "primitive").is_none(), "the processor has none");
    harness.get_by_role_and_label(Role::ComboBox, "traversal").click();
    harness.run_steps(3);
    let listed = names(&harness, Role::Button);
    let has = |traversal: Traversal| listed.iter().any(|name| name == traversal.name());
    assert!(has(Traversal::Cpu) && has(Traversal::Walk) && has(Traversal::Query), "{listed:?}");
    assert!(!has(Traversal::Pipeline), "the machine has no such thing");
    harness.get_by_role_and_label(Role::Button, "query").click();
    harness.run_steps(3);
    let backend = harness.state().backend();
    assert_eq!(
        (commands(&mut harness), harness.state().render_settings.traversal),
        (vec![Command::SetBackend(backend)], Traversal::Query)
    );
    choose(&mut harness, "primitive", Primitive::VoxelApprox.name());
    assert_eq!(harness.state().render_settings.primitive, Primitive::VoxelApprox);
    assert_eq!(commands(&mut harness).len(), 1);
}

#[test]
fn tracing_is_paused_by_its_box_and_an_integrator_takes_its_bounces() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let is_checked =
        |harness: &Harness<Session>| harness.get_by_label("paused").accesskit_node().toggled() == Some(Toggled::True);
    for (pause, expected) in [(Pause::Samples, true), (Pause::Nothing, false)] {
        click(&mut harness, "paused");
        assert_eq!((commands(&mut harness), is_checked(&harness)), (vec![Command::Pause(pause)], expected));
    }
    click(&mut harness, Integrator::Essay.name());
    assert_eq!(commands(&mut harness), [Command::SetView]);
    assert_eq!(
        (harness.state().render_settings.integrator, harness.state().render_settings.max_bounces),
        (Integrator::Essay, 3)
    );
}

#[test]
fn every_slider_and_button_has_a_name() {
    let mut session = in_room("room.vxt");
    session.act(Action::Pick, Some(Vec2::new(320.0, 240.0)));
    session.has_help = true;
    let harness = panels(session, Status::default());
    let sliders = names(&harness, Role::Slider);
    let wanted = ["exposure, stops", "lamps ×", "sky and sun ×", "sun's bearing °", "sun's height °", "sun's strength"];
    for name in wanted.into_iter().chain(["field of view °", "bounces", "samples"]) {
        assert!(sliders.iter().any(|own| own == name), "{name}: {sliders:?}");
    }
    let buttons = names(&harness, Role::Button);
    assert!(buttons.iter().any(|name| name == "frame it"), "the picked voxel is shown: {buttons:?}");
    assert_eq!(nameless(&harness), []);

    let mut nameless_slider = 0.0;
    let show = move |ui: &mut egui::Ui, _: &mut Session| {
        ui.add(egui::Slider::new(&mut nameless_slider, 0.0..=1.0));
    };
    let mut harness = Harness::new_ui_state(show, in_room("room.vxt"));
    harness.run_steps(2);
    assert!(nameless(&harness).contains(&Role::Slider), "the comparison sees one without");
}

#[test]
fn the_list_of_keys_has_every_row_of_the_table() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let missing = |harness: &Harness<Session>| {
        let labels = names_of_all(harness);
        let rows = Group::ALL.into_iter().flat_map(keys::rows);
        rows.filter(|row| !labels.contains(&row.keys) || !labels.iter().any(|label| label == row.about)).count()
    };
    assert_eq!(missing(&harness), keys::TABLE.len() + keys::EDIT_TABLE.len(), "it is not shown yet");
    click(&mut harness, "Keys");
    assert_eq!(missing(&harness), 0);
    let unwritten = |family: egui::FontFamily| {
        let font = egui::FontId::new(11.0, family);
        // Where the font's picture has a sign; what the font lacks is one and the same box.
        let place = |sign: char| {
            let white = egui::Color32::WHITE;
            let lay = |fonts: &mut egui::epaint::FontsView| fonts.layout_no_wrap(sign.to_string(), font.clone(), white);
            harness.ctx.fonts_mut(lay).rows[0].glyphs[0].uv_rect
        };
        let signs = Group::ALL.into_iter().flat_map(keys::rows).flat_map(|row| row.keys.chars().collect::<Vec<_>>());
        signs.filter(|&sign| place(sign) == place('\u{10fffd}')).count()
    };
    assert_eq!(unwritten(egui::FontFamily::Monospace), 0, "the font has every sign");
    assert!(unwritten(egui::FontFamily::Proportional) > 0, "the comparison sees arrows that are boxes");
    click(&mut harness, "Close window");
    assert!(!harness.state().has_help);
    harness.state_mut().has_help = true;
    harness.state_mut().has_panels = false;
    harness.run_steps(3);
    assert_eq!(missing(&harness), 0, "also without panels");
}

fn names_of_all(harness: &Harness<Session>) -> Vec<String> {
    let nodes = harness.root().children_recursive();
    nodes.filter_map(|node| node.accesskit_node().label().or_else(|| node.accesskit_node().value())).collect()
}

#[test]
fn panels_that_are_shown_change_nothing_whatever_the_scene_says() {
    let mut scene = room();
    scene.light_intensity = 5000.0;
    scene.sky.set_brightness(77.0);
    scene.sky.set_sun(Sun::at(300.0, -40.0, 90.0));
    let mut session = in_room("room.vxt");
    session.show("room.vxt".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
    let mut settings = session.render_settings.clone();
    (settings.samples, settings.max_bounces, settings.tone_map.exposure) = (1 << 20, 200, 20.0);
    session.set_render_settings(settings.clone());
    session.take_commands();
    let camera = session.navigator.camera().clone();
    let mut harness = panels(session, Status::default());
    harness.run_steps(5);
    assert_eq!(commands(&mut harness), []);
    assert_eq!((&harness.state().render_settings, harness.state().navigator.camera()), (&settings, &camera));

    // One slider moves: the others' values stay.
    harness.get_by_role_and_label(Role::Slider, "sun's bearing °").focus();
    harness.run_steps(2);
    harness.key_press(egui::Key::ArrowRight);
    harness.run_steps(3);
    assert_eq!(commands(&mut harness), [Command::SetScene]);
    let sun = harness.state().render_settings.sun.unwrap();
    assert!(sun.bearing > 300.0 && (sun.height + 40.0).abs() < 0.1 && (sun.strength - 90.0).abs() < 0.1, "{sun:?}");
    click(&mut harness, "the camera sees the sun's disc");
    assert_eq!(commands(&mut harness), [Command::SetScene]);
    let sky = |harness: &Harness<Session>| harness.state().open.as_ref().unwrap().lit.sky.clone();
    assert!(!sky(&harness).is_sun_disc_visible() && sky(&harness).sun() == sun.sun().as_ref());
    click(&mut harness, "the scene's own light");
    assert!(sky(&harness).is_sun_disc_visible());
}

#[test]
fn buttons_that_need_a_scene_are_off_without_one_and_do_their_work_with_one() {
    let empty = panels(Session::new(Traversal::Cpu), Status::default());
    let is_off = |harness: &Harness<Session>, name| harness.get_by_label(name).accesskit_node().is_disabled();
    assert!(["Picture to file", "Copy command", "show all"].iter().all(|name| is_off(&empty, name)));
    assert!(!is_off(&empty, "Open…") && !is_off(&empty, "Keys"));

    let mut harness = panels(in_room("/none/room.vxt"), Status::default());
    assert!(!is_off(&harness, "Copy command"));
    assert!(harness.query_by_label("792 voxels, 1 object").is_some());
    click(&mut harness, "Picture to file");
    let saved = commands(&mut harness);
    assert!(
        matches!(&saved[..], [Command::Save(path)] if path.is_absolute() && path.ends_with("room-001.png")),
        "{saved:?}"
    );
    click(&mut harness, "Copy command");
    assert!(matches!(&commands(&mut harness)[..], [Command::Print(_), Command::Copy(_)]));
    let lines = said(harness.state_mut());
    harness.run_steps(2);
    assert!(lines.iter().all(|line| harness.query_by_label(line).is_some()), "{lines:?} can be read");
    choose(&mut harness, "camera", "front");
    assert_eq!(commands(&mut harness), [], "it is there already");
    assert_eq!(SIZE, harness.state().size(), "the panels do not size the picture themselves");
}

/// A session that shows the house, with its lists unfolded.
fn house_panels<'a>() -> Harness<'a, Session> {
    let mut session = in_room("room.vxt");
    session.show("house.vox".into(), Arc::new(PackedScene::pack(&house()).unwrap()));
    session.take_commands();
    let mut harness = panels(session, Status::default());
    click(&mut harness, "Parts (1 hidden)");
    click(&mut harness, "Materials");
    while harness.state().open.as_ref().unwrap().used_materials().is_none() {
        std::thread::yield_now();
    }
    harness.run_steps(20);
    harness
}

#[test]
fn layers_groups_and_objects_have_boxes_that_show_and_hide_them() {
    let mut harness = house_panels();
    let is_checked = |harness: &Harness<Session>, name: &str| {
        harness.get_by_label(name).accesskit_node().toggled() == Some(Toggled::True)
    };
    let boxes = names(&harness, Role::CheckBox);
    for name in ["layer 0: rooms", "layer 1: lamps", "group 0: pair", "object 0: kitchen", "object 1", "object 2"] {
        assert!(boxes.iter().any(|own| own == name), "{name}: {boxes:?}");
    }
    assert!(is_checked(&harness, "layer 0: rooms") && !is_checked(&harness, "layer 1: lamps"));
    click(&mut harness, "object 0: kitchen");
    assert_eq!(commands(&mut harness), [Command::SetScene]);
    let group = harness.get_by_label("group 0: pair").accesskit_node().toggled();
    assert_eq!(group, Some(Toggled::Mixed), "a part of it is seen");
    click(&mut harness, "layer 0: rooms");
    assert!(is_checked(&harness, "object 0: kitchen"), "a click on what is seen in part shows all of it");
    click(&mut harness, "layer 0: rooms");
    assert!(!is_checked(&harness, "object 1") && harness.state().open.as_ref().unwrap().lit.instances().is_empty());
    commands(&mut harness);
    click(&mut harness, "layer 1: lamps");
    assert_eq!(commands(&mut harness), [Command::LoadAgain], "what the file hides has to be read");
    assert_eq!(nameless(&harness), []);
}

#[test]
fn materials_in_use_have_a_line_that_changes_them() {
    let mut harness = house_panels();
    assert!(harness.query_by_label("2 of 3 materials in use").is_some(), "the lamp is hidden");
    harness.get_by_role_and_label(Role::SpinButton, "emission of material 1").focus();
    harness.run_steps(2);
    harness.key_press(egui::Key::ArrowUp);
    harness.run_steps(3);
    assert_eq!(commands(&mut harness), [Command::SetScene]);
    let material = |harness: &Harness<Session>| harness.state().material(1).unwrap();
    let glowing = material(&harness);
    assert!(glowing.emission.x > 0.0 && glowing.emission.x > glowing.emission.y, "in its own hue: {glowing:?}");
    assert!(harness.query_by_label("Materials (1 changed)").is_some());
    click(&mut harness, "↺");
    assert_eq!((commands(&mut harness), material(&harness).emission.x), (vec![Command::SetScene], 0.0));
    harness.run_steps(5);
    assert_eq!(commands(&mut harness), [], "what is shown changes nothing");
    assert_eq!(nameless(&harness), []);
}

#[test]
fn a_comparison_is_begun_set_and_ended_in_its_panel() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    assert!(harness.query_by_role_and_label(Role::ComboBox, "other traversal").is_none());
    click(&mut harness, "with another tracer");
    assert_eq!(commands(&mut harness).len(), 2);
    choose(&mut harness, "other traversal", "cpu");
    assert_eq!(commands(&mut harness), [Command::CompareWith(Some(Backend::Cpu))]);
    choose(&mut harness, "shown", Contrast::Voxels.name());
    assert_eq!(commands(&mut harness), [Command::SetContrast(Contrast::Voxels)]);
    assert!(harness.query_by_label("no voxels to compare yet").is_some());
    click(&mut harness, "Copy the other's command");
    assert!(matches!(&commands(&mut harness)[..], [Command::Print(_), Command::Copy(_)]));
    assert_eq!(nameless(&harness), []);
    click(&mut harness, "with another tracer");
    assert_eq!((commands(&mut harness), harness.state().comparison.clone()), (vec![Command::CompareWith(None)], None));
}

#[test]
fn what_was_measured_stands_in_the_panel_of_the_benchmark() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    click(&mut harness, "Measure this view");
    assert_eq!(commands(&mut harness), [Command::Pause(Pause::Everything), Command::Benchmark]);
    let times = Times { frames: 64, median_ms: 1.2345, p99_ms: 2.5, rays_per_second: Some(3.25e9) };
    harness.state_mut().measured = Some(vec![Measurement {
        scene: "room".into(),
        cell: "walk".into(),
        rounding: "precise",
        times: Some(times),
        traced_bytes: 3 << 20,
        peak_bytes: Some(9 << 20),
        wrong_voxels: Some((2, 1000)),
        failure: None,
    }]);
    harness.run_steps(3);
    let shown = names_of_all(&harness);
    for text in ["walk, precise", "1.234 ms", "2.500 ms", "3.2500 G/s", "3.0 MiB", "9.0 MiB", "2 of 1,000 rays"] {
        assert!(shown.iter().any(|own| own == text), "{text}: {shown:?}");
    }
    click(&mut harness, "Copy bench command");
    let copied = commands(&mut harness);
    assert!(matches!(&copied[..], [_, Command::Copy(text)] if text.starts_with("voxtrace bench ")), "{copied:?}");
}

#[test]
fn the_voxel_under_the_cursor_is_told_with_its_place_on_the_map() {
    let mut scene = house();
    let origin = voxtrace::glam::DVec3::new(691_000.5, 5_334_000.25, 512.0);
    scene.georeference = Some(voxtrace::georeference::Georeference::of_grid(origin, 0.5, "EPSG:32632"));
    (scene.unit, scene.voxel_size) = (voxtrace::scene::Unit::Metre, 0.5);
    let mut session = in_room("room.vxt");
    session.show("house.vox".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
    let cursor = Vec2::new(320.0, 240.0);
    let point = session.pick(cursor).unwrap().point;
    let told = |session: Session| names_of_all(&panels(session, Status::default()));
    session.hover = Some(cursor);
    let shown = told(session);
    let at = origin + point.as_dvec3() * 0.5;
    let coordinates = format!("{:.3}, {:.3}, {:.3} m", at.x, at.y, at.z);
    for text in ["Voxel under the cursor", "0: kitchen", "0: rooms", "EPSG:32632", coordinates.as_str()] {
        assert!(shown.iter().any(|own| own == text), "{text}: {shown:?}");
    }
    assert!(!told(in_room("room.vxt")).iter().any(|text| text == "Voxel under the cursor"), "nothing is under it");
}

#[test]
fn the_side_keeps_its_width_whatever_is_opened_in_it_or_lies_under_the_cursor() {
    let widths = |hover: Option<Vec2>, opens: bool| {
        let mut session = in_room("room.vxt");
        session.hover = hover;
        if opens {
            let mut settings = session.render_settings.clone();
            settings.traversal = Traversal::Query;
            settings.clamp_indirect = Some(100.0);
            settings.cutting.clip_box = session.whole_box();
            settings.cutting.slice = Some(Slice { axis: 2, from: 3.5, thickness: 1.0 });
            settings.cutting.planes = vec![(Vec3::NEG_Y, -12.0); 6];
            settings.surroundings.ground = Some(Ground { height: Some(-3.5), color: Vec3::ONE });
            settings.surroundings.fog = Some(Fog { density: 1e-5, color: Vec3::ONE, anisotropy: -0.99 });
            session.set_render_settings(settings);
            session.toggle_comparison();
            session.choose_tool(Some(Kind::Area));
            let points = vec![voxtrace::glam::DVec3::splat(123.456); 3];
            let name = "the area of a room whose name is longer than the panel is wide".to_owned();
            session.measuring.points.clone_from(&points);
            let measure = Measure { name, is_hidden: false, kind: Kind::Area, points, component: None };
            session.measuring.list.insert(1, measure);
            session.measuring.selected = Some(1);
            session.navigator.mode = Mode::Walk;
        }
        let show = |ui: &mut egui::Ui, (session, width): &mut (Session, f32)| {
            *width = panel::show(ui, session, &Status::default());
        };
        let mut harness = Harness::builder().with_size([1280.0, 3000.0]).build_ui_state(show, (session, 0.0));
        harness.run_steps(4);
        if opens {
            for section in ["Cuts (cut open)", "Surroundings (ground, fog)", "Materials", "Limits (some)"] {
                harness.get_by_label(section).click();
                harness.run_steps(4);
            }
            assert!(harness.query_by_role_and_label(Role::Slider, "bearing 6 °").is_some());
            assert!(harness.query_by_label("Without the last point").is_some(), "the measurements are open");
        }
        assert_eq!(harness.query_by_label("Voxel under the cursor").is_some(), hover.is_some());
        harness.state().1
    };
    let width = widths(None, false);
    assert_eq!(width, widths(Some(Vec2::new(320.0, 240.0)), false), "the picture keeps its size, and its film");
    assert_eq!(width, widths(None, true), "the picture keeps its size, and its film");
}

#[test]
fn a_further_message_is_drawn_once_more_where_all_of_it_is_seen() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    harness.state_mut().say("one line", false);
    harness.run_steps(4);
    assert!(!harness.ctx.has_requested_repaint(), "nothing moves any more");
    harness.state_mut().say("another line", true);
    harness.run_steps(1);
    assert!(harness.ctx.has_requested_repaint(), "it lies in part below the window");
    harness.run_steps(4);
    assert!(!harness.ctx.has_requested_repaint());
    assert!(harness.get_by_label("another line").rect().bottom() < 2400.0);
}

#[test]
fn the_panels_are_dark_or_light_as_somebody_chooses() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    for (choice, is_dark) in [("light", false), ("dark", true)] {
        choose(&mut harness, "colours of the panels", choice);
        harness.run_steps(2);
        assert_eq!(harness.ctx.global_style().visuals.dark_mode, is_dark, "{choice}");
    }
}
