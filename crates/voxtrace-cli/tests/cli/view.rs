//! The real window: an X server in memory, the program, and a hand that drags and presses keys.

use crate::common::{Folder, Picture};
use std::io::{BufRead, BufReader, ErrorKind, Read};
use std::process::{Child, Command, Output, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use voxtrace_test_support::{Need, skip_without};

/// Longest time that one thing may take here: a device in software compiles shaders for long where others have the processors.
const MOST: Duration = Duration::from_secs(300);

/// For what a dialog takes to have the keyboard, also on a busy machine.
pub const A_WHILE: Duration = Duration::from_secs(3);

/// A program that ends with the test, however that ends.
pub struct Running(pub Child);

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// An X server in memory. It chooses a display that is free, and does not begin anew (`-noreset`) whenever its last client goes.
pub struct Screen {
    _server: Running,
    display: String,
}

impl Screen {
    /// `None` where the machine has no such server.
    pub fn open() -> Option<Self> {
        Command::new("xdotool").arg("version").output().ok()?;
        let arguments = ["-displayfd", "1", "-screen", "0", "1024x768x24", "-nolisten", "tcp", "-noreset"];
        let server = Command::new("Xvfb").args(arguments).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        let mut server = Running(server.ok()?);
        let mut number = String::new();
        BufReader::new(server.0.stdout.take()?).read_line(&mut number).ok()?;
        let display = format!(":{}", number.trim());
        (display != ":").then_some(Self { _server: server, display })
    }

    /// One call of `xdotool`, which must succeed.
    pub fn hand(&self, words: &[&str]) -> Output {
        let output = self.try_hand(words);
        assert!(output.status.success(), "xdotool {words:?}: {}", String::from_utf8_lossy(&output.stderr));
        output
    }

    fn try_hand(&self, words: &[&str]) -> Output {
        Command::new("xdotool").args(words).env("DISPLAY", &self.display).output().unwrap()
    }
}

/// The program with its window.
pub struct View<'a> {
    pub program: Running,
    screen: &'a Screen,
    window: String,
    /// What it has written so far.
    said: Arc<Mutex<Vec<u8>>>,
    stderr: std::thread::JoinHandle<String>,
    stdout: std::thread::JoinHandle<String>,
}

impl<'a> View<'a> {
    /// Starts the program and waits for its window to have the keyboard.
    pub fn open(folder: &Folder, screen: &'a Screen, arguments: &[&str]) -> Self {
        Self::open_with(folder, screen, arguments, &[])
    }

    /// The same with further variables of the environment.
    pub fn open_with(folder: &Folder, screen: &'a Screen, arguments: &[&str], variables: &[(&str, &str)]) -> Self {
        let mut command = folder.command(&[&["view"], arguments].concat());
        command.env("DISPLAY", &screen.display).env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
        command.env("VOXTRACE_VALIDATION", "1").env("VOXTRACE_SETTINGS", folder.path("settings/viewer.toml"));
        command.envs(variables.iter().copied());
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let read = |mut from: Box<dyn Read + Send>, said: Arc<Mutex<Vec<u8>>>| {
            std::thread::spawn(move || {
                let mut some = [0; 4096];
                loop {
                    match from.read(&mut some) {
                        Err(error) if error.kind() == ErrorKind::Interrupted => {}
                        Err(error) => panic!("{error}"),
                        Ok(0) => break String::from_utf8_lossy(&said.lock().unwrap()).into_owned(),
                        Ok(length) => said.lock().unwrap().extend(&some[..length]),
                    }
                }
            })
        };
        let said = Arc::default();
        let stderr = read(Box::new(child.stderr.take().unwrap()), Arc::default());
        let stdout = read(Box::new(child.stdout.take().unwrap()), Arc::clone(&said));
        let mut view = Self { program: Running(child), screen, window: String::new(), said, stderr, stdout };
        view.wait("a window", |view| {
            let found = view.screen.try_hand(&["search", "--onlyvisible", "--name", "voxtrace"]);
            view.window = String::from_utf8_lossy(&found.stdout).lines().next().unwrap_or_default().to_owned();
            !view.window.is_empty()
        });
        // Without a window manager nobody gives it the keyboard.
        view.hand(&["windowfocus", "--sync"], &[]);
        view
    }

    /// Waits until something holds, as long as the program runs.
    pub fn wait(&mut self, what: &str, mut holds: impl FnMut(&mut Self) -> bool) {
        let since = Instant::now();
        while !holds(self) {
            if let Some(status) = self.program.0.try_wait().unwrap() {
                let stderr = std::mem::replace(&mut self.stderr, std::thread::spawn(String::new)).join().unwrap();
                panic!("the program ended ({status}) before there was {what}:\n{stderr}");
            }
            assert!(since.elapsed() < MOST, "no {what} after {MOST:?}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// A call of `xdotool` with the window between its words.
    pub fn hand(&self, before: &[&str], after: &[&str]) -> Output {
        self.screen.hand(&[before, &[&self.window], after].concat())
    }

    pub fn key(&self, key: &str) {
        self.screen.hand(&["key", key]);
    }

    /// Whether it has written this to stdout.
    pub fn has_said(&self, text: &str) -> bool {
        String::from_utf8_lossy(&self.said.lock().unwrap()).contains(text)
    }

    pub fn title(&self) -> String {
        let output = self.hand(&["getwindowname"], &[]);
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }

    /// The size of the window as the X server knows it.
    fn size(&self) -> (usize, usize) {
        let output = self.hand(&["getwindowgeometry", "--shell"], &[]);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let of = |name: &str| text.lines().find_map(|line| line.strip_prefix(name)?.parse().ok()).unwrap();
        (of("WIDTH="), of("HEIGHT="))
    }

    /// Presses the key of a picture and waits for it.
    pub fn screenshot(&mut self, folder: &Folder) -> Picture {
        self.key("F12");
        self.wait("a picture", |_| folder.exists("room-001.png"));
        folder.png("room-001.png")
    }

    /// Waits for the end; the exit code, stdout and stderr.
    pub fn end(mut self) -> (Option<i32>, String, String) {
        let (mut code, since) = (None, Instant::now());
        while code.is_none() {
            code = self.program.0.try_wait().unwrap();
            assert!(since.elapsed() < MOST, "the window did not close");
            std::thread::sleep(Duration::from_millis(20));
        }
        (code.unwrap().code(), self.stdout.join().unwrap(), self.stderr.join().unwrap())
    }
}

/// Whether there is a device beside the processor.
pub fn has_device(folder: &Folder) -> bool {
    let devices: serde_json::Value = serde_json::from_str(&folder.succeed(&["devices", "--json"])).unwrap();
    devices["devices"].as_array().unwrap().len() > 1
}

/// Lines that the validation layer wrote.
pub fn validation(stderr: &str) -> Vec<&str> {
    stderr.lines().filter(|line| line.starts_with("validation:") || line.contains("VUID-")).collect()
}

#[test]
fn a_window_is_opened_resized_dragged_flown_through_photographed_and_closed() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    let mut view = View::open(&folder, &screen, &["room.vxt"]);
    view.wait("the scene's title", |view| view.title().starts_with("room"));

    for step in 1..=20 {
        let (width, height) = (480 + step * 20, 700 - step * 15);
        view.hand(&["windowsize"], &[&width.to_string(), &height.to_string()]);
    }
    view.wait("the last size", |view| view.size() == (880, 400));
    // The picture lies to the left of the panels.
    view.hand(&["mousemove", "--window"], &["200", "200"]);
    screen.hand(&[
        "mousedown",
        "1",
        "mousemove_relative",
        "--sync",
        "40",
        "5",
        "mousemove_relative",
        "--sync",
        "40",
        "5",
    ]);
    screen.hand(&["mouseup", "1"]);
    screen.hand(&["keydown", "w", "sleep", "0.2", "keyup", "w"]);
    view.key("F1");
    view.key("Escape");
    view.key("c");
    for _ in 0..3 {
        view.key("t");
        view.key("ctrl+shift+c");
    }
    view.key("Home");
    view.key("ctrl+shift+c");
    // Without panels the picture is as large as the window, also right after they went.
    view.key("Tab");
    let picture = view.screenshot(&folder);
    assert_eq!((picture.width, picture.height), (880, 400));
    view.key("ctrl+q");
    let (code, stdout, stderr) = view.end();

    assert_eq!(code, Some(0), "{stderr}");
    assert_eq!(validation(&stderr), Vec::<&str>::new());
    assert_eq!(validation("a\nvalidation: a fault").len(), 1);
    assert!(picture.mean() > 20.0, "the picture is black");
    let first = picture.pixel(0, 0).to_vec();
    assert!((0..400).any(|y| picture.pixel(440, y) != first), "the picture is of one colour");

    // The camera moved, and traversals were switched while it ran.
    let eye = stdout.lines().find(|line| line.starts_with("eye = ")).expect(&stdout);
    assert_ne!(eye, "eye = [12.0, -30.0, 18.0]");
    let lines: Vec<&str> = stdout.lines().filter(|line| line.starts_with("voxtrace render ")).collect();
    let traversal =
        |line: &str| line.split("--traversal ").nth(1).and_then(|rest| rest.split(' ').next()).map(str::to_owned);
    let traversals: Vec<_> = lines.iter().filter_map(|line| traversal(line)).collect();
    assert!(traversals.len() == 4 && traversals[0] != traversals[1], "{stdout}");
    let settings = std::fs::read_to_string(folder.path("settings/viewer.toml")).unwrap();
    assert!(settings.contains("room.vxt") && settings.contains("880"), "{settings}");

    // The command that was copied is one that the program takes.
    let words: Vec<&str> = lines[3].split(' ').skip(1).collect();
    assert!(words.iter().all(|word| !word.contains('\'')), "{lines:?}");
    let spp = words.iter().position(|&word| word == "4096").unwrap();
    let words = [&words[..spp], &["1"], &words[spp + 1..], &["-o", "again.png"]].concat();
    folder.succeed(&words);
    assert!(folder.exists("again.png"));
}

#[test]
fn in_the_window_one_measures_cuts_with_knobs_isolates_and_walks() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    let mut view = View::open(&folder, &screen, &["room.vxt"]);
    view.wait("the scene's title", |view| view.title().starts_with("room"));
    view.hand(&["windowsize"], &["1000", "700"]);
    view.wait("the size", |view| view.size() == (1000, 700));
    let at = |x: &str, y: &str| drop(view.hand(&["mousemove", "--window"], &[x, y]));
    let click = || drop(screen.hand(&["click", "1", "sleep", "0.1"]));
    // Two points on the block, which is in the middle of the picture.
    view.key("m");
    for (x, y) in [("330", "350"), ("380", "340")] {
        at(x, y);
        click();
    }
    view.key("Escape");
    view.key("shift+b");
    view.key("ctrl+shift+c");
    view.key("shift+b");
    view.key("shift+o");
    screen.hand(&["keydown", "w", "sleep", "0.3", "keyup", "w"]);
    view.key("c");
    at("355", "350");
    view.key("ctrl+Delete");
    view.key("ctrl+q");
    let measured = folder.path("room.measurements.toml");
    let (code, stdout, stderr) = view.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert_eq!(validation(&stderr), Vec::<&str>::new());
    let kept = std::fs::read_to_string(measured).unwrap();
    assert!(kept.contains("[measurements.1]") && kept.contains("kind = \"distance\""), "{kept}");
    let command = stdout.lines().find(|line| line.starts_with("voxtrace render ")).expect(&stdout);
    assert!(command.contains("--clip-box "), "the box was there when the command was copied: {command}");
    assert!(stdout.lines().any(|line| line.starts_with("eye = ")), "{stdout}");
}

#[test]
fn a_timeline_that_lies_beside_the_scene_is_played_and_recorded_by_keys_as_animate_renders_it() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    let key = |at: f32, x: f32| format!("{{ at = {at}, eye = [{x}, -20.0, 14.0], target = [12.0, 12.0, 3.0] }}");
    let text = format!(
        "scene = \"room.vxt\"\nfps = 3\nseconds = 1\n[camera]\npath = [{}, {}]\n",
        key(0.0, 4.0),
        key(0.6, 20.0)
    );
    std::fs::write(folder.path("room.animation.toml"), text).unwrap();
    let mut view = View::open(&folder, &screen, &["room.animation.toml", "--traversal", "cpu"]);
    view.wait("the scene's title", |view| view.title().starts_with("room"));
    view.hand(&["windowsize"], &["400", "420"]);
    view.wait("its size", |view| view.size() == (400, 420));
    view.key("space");
    view.wait("the last key's view", |view| {
        view.key("c");
        std::thread::sleep(Duration::from_millis(200));
        view.has_said("eye = [20")
    });
    view.key("shift+F8");
    std::thread::sleep(A_WHILE);
    view.key("ctrl+a");
    screen.hand(&["type", &folder.path("ours_####.png").display().to_string()]);
    view.key("Return");
    view.wait("the last frame", |_| folder.exists("ours_0003.png"));
    view.wait("that it is whole", |_| !std::fs::read(folder.path("ours_0003.png")).unwrap().is_empty());
    let size = folder.png("ours_0003.png");
    view.key("ctrl+q");
    view.key("ctrl+q");
    let (code, stdout, stderr) = view.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert!(stdout.contains("eye = [20"), "at its end the view is the last key's: {stdout}");
    let size = format!("{}x{}", size.width, size.height);
    folder.succeed(&["animate", "room.animation.toml", "-o", "theirs_####.png", "--size", &size, "--traversal", "cpu"]);
    for frame in ["0001", "0002", "0003"] {
        assert!(folder.bytes(&format!("ours_{frame}.png")) == folder.bytes(&format!("theirs_{frame}.png")), "{frame}");
    }
    assert!(folder.bytes("ours_0001.png") != folder.bytes("ours_0003.png"), "the comparison sees frames");
}

#[test]
fn values_of_a_scan_are_dragged_in_the_picture_and_a_plan_is_played() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let Some(screen) = Screen::open() else {
        return skip_without(Need::Display, "there is no Xvfb or no xdotool");
    };
    // A ball of values, 0 at its edge and 12 in its middle.
    let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (24, 24, 24), }";
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{header:<117}\n").bytes());
    for i in 0..24 * 24 * 24 {
        let at = [i / 576, i / 24 % 24, i % 24].map(|at| at as f32 - 11.5);
        bytes.extend((12.0 - at.iter().map(|x| x * x).sum::<f32>().sqrt()).to_le_bytes());
    }
    std::fs::write(folder.path("ball.npy"), bytes).unwrap();
    let plan = "scenes = [\"room.vxt\"]\ncells = [\"cpu\"]\nframes = 2\nwarm_up = 0\nsize = \"24x18\"\n";
    std::fs::write(folder.path("plan.toml"), plan).unwrap();
    let mut view = View::open(&folder, &screen, &["ball.npy", "--traversal", "cpu"]);
    view.wait("the scene's title", |view| view.title().starts_with("ball"));
    // The first keys may come before the window has the keyboard.
    view.wait("a picture", |view| {
        view.key("F12");
        std::thread::sleep(Duration::from_millis(100));
        folder.exists("ball-001.png")
    });
    view.key("F9");
    view.hand(&["mousemove", "--window"], &["200", "300"]);
    screen.hand(&["mousedown", "1", "mousemove_relative", "--sync", "--", "-20", "-10"]);
    screen.hand(&["mousemove_relative", "--sync", "--", "-20", "-10", "mouseup", "1"]);
    view.key("Escape");
    view.key("ctrl+shift+c");
    view.key("F10");
    std::thread::sleep(A_WHILE);
    view.key("ctrl+a");
    screen.hand(&["type", &folder.path("plan.toml").display().to_string()]);
    std::thread::sleep(A_WHILE);
    view.key("Return");
    view.wait("the report", |_| folder.exists("plan-report/report.html"));
    view.key("ctrl+q");
    view.key("ctrl+q");
    let (code, stdout, stderr) = view.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert_eq!(validation(&stderr), Vec::<&str>::new());
    let line = stdout.lines().find(|line| line.starts_with("voxtrace render ")).expect(&stdout);
    let word = line.split('\'').nth(1).expect(line);
    assert!(word.starts_with("stops:") && word.contains("threshold="), "{line}");
    let picture = |transfer: &str, name: &str| {
        folder.succeed(&["render", "ball.npy", "--transfer", transfer, "--size", "24x18", "--spp", "1", "-o", name]);
        folder.bytes(name)
    };
    assert!(picture(word, "dragged.png") != picture("mri", "usual.png"), "the drag changed what is shown");
    let results = std::fs::read_to_string(folder.path("plan-report/results.json")).unwrap();
    assert!(
        results.contains("voxtrace bench --plan") && !results.contains("voxtrace view"),
        "its command plays the plan"
    );
}
