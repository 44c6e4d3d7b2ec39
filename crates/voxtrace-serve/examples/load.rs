//! A load on `voxtrace serve`: so many clients for so long, then hostile requests, clients that are slow or drop, and the end. Prints what the server's
//! process had of memory, files and threads meanwhile (Linux).
//!
//! `cargo run --release -p voxtrace-serve --example load -- target/release/voxtrace [CLIENTS SECONDS HOSTILE]`

#[allow(dead_code, reason = "the tests use all of it")]
#[path = "../tests/server/client.rs"]
mod client;

use client::{SECRET, connect, exchange, get, get_with, head, hostile};
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::SocketAddr;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use tungstenite::{Error, Message};
use voxtrace::{PackedScene, scenes};

fn main() {
    let mut words = std::env::args().skip(1);
    let program = words.next().expect("the program voxtrace");
    let mut number = |usual: usize| words.next().map_or(usual, |word| word.parse().expect("a number"));
    let (clients, seconds, requests) = (number(200), number(60), number(10_000));

    let parent = tempfile::tempdir().expect("a folder");
    let folder = make_folder(parent.path());
    let (mut child, address) = start(&program, &folder);
    let process = Process(child.id());
    // As much as it has when everything was used once.
    visit(address, 0, &Mutex::default());
    let before = process.now();
    println!("{:<44} {:>9} {:>9} {:>7} {:>8}", "", "resident", "most", "files", "threads");
    before.say("used once");

    let answers = Mutex::default();
    let start = Instant::now();
    std::thread::scope(|scope| {
        for client in 0..clients {
            let answers = &answers;
            scope.spawn(move || {
                while start.elapsed() < Duration::from_secs(seconds as u64) {
                    visit(address, client, answers);
                }
            });
        }
        for tick in 1..=4 {
            std::thread::sleep(Duration::from_secs(seconds as u64) * tick / 4 - start.elapsed());
            process.now().say(&format!("{clients} clients, {} s", start.elapsed().as_secs()));
        }
    });
    say_answers(&answers);

    let (answers, next) = (Mutex::default(), AtomicUsize::new(0));
    std::thread::scope(|scope| {
        for _ in 0..16 {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= requests {
                        return;
                    }
                    let (bytes, kind) = hostile(number, address);
                    let answer = exchange(address, &bytes);
                    assert!(!answer.text().contains(SECRET), "{kind}");
                    count(&answers, &format!("{kind}: {}", answer.status));
                }
            });
        }
    });
    process.now().say(&format!("{requests} hostile requests"));
    say_answers(&answers);

    slow(address, &process);
    floods(address, &process);
    std::thread::sleep(Duration::from_secs(15));
    let after = process.now();
    after.say("15 s later");
    let thumbnails = get(address, "/api/thumbnail/scene-0.vxt").status;
    println!(
        "a thumbnail afterwards: {thumbnails}; files more than before: {}",
        after.files as i64 - before.files as i64
    );
    end(&mut child);
}

/// A folder with scenes of several sizes, a damaged file, and a secret beside it.
fn make_folder(parent: &Path) -> std::path::PathBuf {
    let folder = parent.join("folder");
    fs::create_dir_all(folder.join("inner")).expect("a folder");
    fs::create_dir_all(folder.join(".hidden")).expect("a folder");
    fs::write(parent.join("secret.vox"), SECRET).expect("a file");
    fs::write(folder.join(".hidden/secret.vox"), SECRET).expect("a file");
    fs::write(folder.join("damaged.vox"), "VOX \u{96}\0\0\0 and nothing more").expect("a file");
    for (number, name) in ["city", "church", "operating-room"].into_iter().enumerate() {
        let scene = scenes::generate(name, Some(300_000)).expect("a built-in scene");
        let packed = PackedScene::pack_merged(&scene).expect("a scene");
        packed.save(&folder.join(format!("scene-{number}.vxt"))).expect("a file");
    }
    fs::copy(folder.join("scene-0.vxt"), folder.join("scene.vxt")).expect("a copy");
    #[cfg(unix)]
    std::os::unix::fs::symlink(parent, folder.join("out")).expect("a link");
    folder
}

fn start(program: &str, folder: &Path) -> (Child, SocketAddr) {
    let mut command = Command::new(program);
    command.arg("serve").arg(folder).args(["--listen", "127.0.0.1:0", "--traversal", "cpu", "--quiet"]);
    command.env("VOXTRACE_CACHE", folder.parent().expect("a folder").join("cache"));
    let mut child = command.stdout(Stdio::piped()).spawn().expect("the program starts");
    let mut line = String::new();
    BufReader::new(child.stdout.as_mut().expect("its output")).read_line(&mut line).expect("an address");
    let address = line.trim().trim_start_matches("http://").trim_end_matches('/');
    (child, address.parse().expect("an address"))
}

/// Asks it to end, as Ctrl-C does.
fn end(child: &mut Child) {
    let start = Instant::now();
    let asked = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(asked.is_ok_and(|status| status.success()), "it cannot be asked");
    let status = child.wait().expect("it ends");
    println!("asked to end: {status} after {:.1} s", start.elapsed().as_secs_f64());
}

type Answers = Mutex<BTreeMap<String, usize>>;

fn count(answers: &Answers, what: &str) {
    *answers.lock().expect("no panic").entry(what.to_owned()).or_default() += 1;
}

fn say_answers(answers: &Answers) {
    answers.lock().expect("no panic").iter().for_each(|(what, count)| println!("    {what:<40} {count:>9}"));
}

/// What a person does: looks at the list, at a scene's facts, takes a part of its file, and looks at it.
fn visit(address: SocketAddr, client: usize, answers: &Answers) {
    let scene = format!("scene-{}.vxt", client % 3);
    let said = |what: &str, status: u16| count(answers, &format!("{what}: {status}"));
    said("page", get(address, "/").status);
    said("list", get(address, "/api/list").status);
    said("thumbnail", get(address, &format!("/api/thumbnail/{scene}")).status);
    said("thumbnail of a damaged file", get(address, "/api/thumbnail/damaged.vox").status);
    said("facts", get(address, &format!("/api/info/{scene}")).status);
    said("part of a file", get_with(address, &format!("/files/{scene}"), &["range: bytes=0-65535"]).status);
    said("pictures", look(address, &scene, 5).unwrap_or_else(|status| status));
}

/// Takes so many pictures of a view that moves; 101 where they came.
fn look(address: SocketAddr, scene: &str, pictures: u32) -> Result<u16, u16> {
    let url = format!("ws://{address}/api/remote/{scene}");
    let (mut socket, _) = tungstenite::client(url, connect(address)).map_err(|error| match error {
        tungstenite::HandshakeError::Failure(Error::Http(answer)) => answer.status().as_u16(),
        _ => 0,
    })?;
    let lost = |_: Error| 0u16;
    let greeting = socket.read().map_err(lost)?.into_text().map_err(lost)?;
    let greeting: serde_json::Value = serde_json::from_str(&greeting).map_err(|_| 0u16)?;
    for id in 1..=pictures {
        let mut camera = greeting["camera"].clone();
        camera[0] = (camera[0].as_f64().unwrap_or_default() + f64::from(id)).into();
        let view = serde_json::json!({ "type": "view", "id": id, "camera": camera, "width": 640, "height": 360 });
        socket.send(Message::text(view.to_string())).map_err(lost)?;
        while !matches!(socket.read().map_err(lost)?, Message::Binary(_)) {}
        socket.send(Message::text(format!(r#"{{"type":"ack","frame":{id}}}"#))).map_err(lost)?;
    }
    // Gone without a word.
    Ok(101)
}

/// Clients that begin and do not go on.
fn slow(address: SocketAddr, process: &Process) {
    let slow: Vec<_> = (0..300)
        .map(|number| {
            let mut stream = connect(address);
            let text = match number % 3 {
                0 => format!("GET / HTTP/1.1\r\nhost: {address}\r\nx-slow: "),
                1 => head("PUT", "/api/upload/slow.vox", address, &["content-length: 1000000"]) + "some",
                _ => String::new(),
            };
            let _ = stream.write_all(text.as_bytes());
            stream
        })
        .collect();
    process.now().say("300 clients that begin and do not go on");
    println!("    a list meanwhile: {}", get(address, "/api/list").status);
    for mut stream in slow {
        let _ = stream.read_to_end(&mut Vec::new());
    }
    process.now().say("all of them hung up on");
}

/// Clients that say as much as they can.
fn floods(address: SocketAddr, process: &Process) {
    std::thread::scope(|scope| {
        for _ in 0..32 {
            scope.spawn(|| {
                for _ in 0..8 {
                    let url = format!("ws://{address}/api/remote/scene.vxt");
                    let Ok((mut socket, _)) = tungstenite::client(url, connect(address)) else { continue };
                    while socket.send(Message::text(r#"{"type":"ack","frame":1}"#)).is_ok() {}
                }
            });
        }
    });
    process.now().say("web sockets that are flooded");
}

/// The server's process.
struct Process(u32);

struct Facts {
    resident_mb: f64,
    most_mb: f64,
    files: usize,
    threads: usize,
}

impl Process {
    fn now(&self) -> Facts {
        let status = fs::read_to_string(format!("/proc/{}/status", self.0)).expect("the server runs");
        let number = |name: &str| {
            let line = status.lines().find_map(|line| line.strip_prefix(name)).unwrap_or_default();
            line.split_whitespace().nth(0).and_then(|word| word.parse::<f64>().ok()).unwrap_or_default()
        };
        let files = fs::read_dir(format!("/proc/{}/fd", self.0)).map_or(0, Iterator::count);
        let (resident_mb, most_mb) = (number("VmRSS:") / 1e3, number("VmHWM:") / 1e3);
        Facts { resident_mb, most_mb, files, threads: number("Threads:") as usize }
    }
}

impl Facts {
    fn say(&self, when: &str) {
        let Self { resident_mb, most_mb, files, threads } = self;
        println!("{when:<44} {resident_mb:>6.0} MB {most_mb:>6.0} MB {files:>7} {threads:>8}");
    }
}
