//! How many pictures a second a client of `voxtrace serve` gets while it goes around a scene: it asks for another view 60 times a second and shows what
//! comes at once. Prints pictures a second, their size in pixels and bytes, and how long after its view was asked for a picture is there.
//!
//! `cargo run --release -p voxtrace-serve --example frames -- 127.0.0.1:8080 city.vxt [WIDTH HEIGHT SECONDS]`

use serde_json::{Value, json};
use std::collections::HashMap;
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::{Error, Message};

const VIEWS_A_SECOND: f64 = 60.0;

fn main() {
    let mut words = std::env::args().skip(1);
    let address = words.next().expect("the address of the server");
    let scene = words.next().expect("the name of a scene");
    let mut number = |usual: u32| words.next().map_or(usual, |word| word.parse().expect("a number"));
    let (width, height, seconds) = (number(1280), number(720), number(10));
    let stream = TcpStream::connect(&address).expect("the server answers");
    stream.set_nodelay(true).unwrap();
    let url = format!("ws://{address}/api/remote/{scene}");
    let (mut socket, _) = tungstenite::client(url.as_str(), stream).expect("a web socket");
    let greeting: Value = serde_json::from_str(socket.read().unwrap().to_text().unwrap()).unwrap();
    assert_eq!(greeting["type"], "scene", "{greeting}");
    let camera: Vec<f64> = greeting["camera"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
    socket.get_mut().set_read_timeout(Some(Duration::from_millis(2))).unwrap();

    let (start, mut asked, mut last) = (Instant::now(), HashMap::new(), 0);
    let (mut arrivals, mut delays, mut bytes, mut sizes) = (Vec::new(), Vec::new(), 0, Vec::new());
    while start.elapsed() < Duration::from_secs(seconds.into()) {
        let id = (start.elapsed().as_secs_f64() * VIEWS_A_SECOND) as u32 + 1;
        if id != last {
            last = id;
            let view = json!({ "type": "view", "id": id, "camera": turned(&camera, f64::from(id) / 300.0), "width": width, "height": height });
            socket.send(Message::text(view.to_string())).unwrap();
            asked.insert(id, Instant::now());
        }
        let data = match socket.read() {
            Ok(Message::Binary(data)) => data,
            Ok(Message::Text(text)) => panic!("{text}"),
            Ok(_) => continue,
            Err(Error::Io(error)) if error.kind() == std::io::ErrorKind::WouldBlock => continue,
            Err(error) => panic!("{error}"),
        };
        let word = |index: usize| u32::from_le_bytes(data[4 * index..4 * index + 4].try_into().unwrap());
        let ack = json!({ "type": "ack", "frame": word(0) });
        socket.send(Message::text(ack.to_string())).unwrap();
        arrivals.push(start.elapsed());
        delays.push(asked[&word(1)].elapsed().as_secs_f64() * 1000.0);
        bytes += data.len();
        sizes.push(size_of(&data[20..]));
    }
    // The first ones wait for the scene and for shaders that are compiled.
    let settled = arrivals.iter().filter(|at| **at > start.elapsed() / 4).count();
    let span = start.elapsed().as_secs_f64() * 0.75;
    delays.sort_by(f64::total_cmp);
    let at = |share: f64| delays.get((delays.len() as f64 * share) as usize).copied().unwrap_or(f64::NAN);
    println!(
        "{scene}, {width} x {height}, {}: {:.1} pictures a second, {} kB each, there after {:.0} ms (median; {:.0} ms for nine of ten)",
        greeting["tracer"],
        settled as f64 / span,
        bytes / arrivals.len().max(1) / 1000,
        at(0.5),
        at(0.9)
    );
    sizes.sort_unstable();
    println!("pixels: {:?} to {:?}, median {:?}", sizes.first(), sizes.last(), sizes.get(sizes.len() / 2));
}

/// The camera, gone around its target by an angle in radians.
fn turned(camera: &[f64], angle: f64) -> Vec<f64> {
    let (x, y) = (camera[0] - camera[3], camera[1] - camera[4]);
    let mut camera = camera.to_vec();
    (camera[0], camera[1]) =
        (camera[3] + x * angle.cos() - y * angle.sin(), camera[4] + x * angle.sin() + y * angle.cos());
    camera
}

/// Width and height of a JPEG (its frame header) or PNG file.
fn size_of(file: &[u8]) -> (u32, u32) {
    let big = |at: usize, count: usize| file[at..at + count].iter().fold(0, |sum, byte| sum << 8 | u32::from(*byte));
    if file.starts_with(b"\x89PNG") {
        return (big(16, 4), big(20, 4));
    }
    let mut at = 2;
    while at + 9 < file.len() {
        if matches!(file[at + 1], 0xc0..=0xc2) {
            return (big(at + 7, 2), big(at + 5, 2));
        }
        at += 2 + big(at + 2, 2) as usize;
    }
    (0, 0)
}
