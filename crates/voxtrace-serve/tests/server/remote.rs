//! Pictures over web sockets.

use crate::client::{connect, get};
use crate::{Running, until};
use std::net::TcpStream;
use std::time::Duration;
use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{Error, Message, WebSocket};

type Socket = WebSocket<TcpStream>;

fn open_as(running: &Running, origin: Option<&str>) -> Result<Socket, u16> {
    let address = running.address;
    let mut request = format!("ws://{address}/api/remote/scene.vxt").into_client_request().unwrap();
    if let Some(origin) = origin {
        request.headers_mut().insert("origin", HeaderValue::from_str(origin).unwrap());
    }
    match tungstenite::client(request, connect(address)) {
        Ok((socket, _)) => Ok(socket),
        Err(tungstenite::HandshakeError::Failure(Error::Http(answer))) => Err(answer.status().as_u16()),
        Err(error) => panic!("{error}"),
    }
}

fn open(running: &Running) -> Socket {
    open_as(running, Some(&format!("http://{}", running.address))).unwrap()
}

/// The greeting's camera.
fn greeted(socket: &mut Socket) -> Vec<f64> {
    let text = loop {
        if let Message::Text(text) = socket.read().unwrap() {
            break text;
        }
    };
    let said: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((said["type"].as_str(), said["name"].as_str()), (Some("scene"), Some("city")));
    said["camera"].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn ask(socket: &mut Socket, id: u32, camera: &[f64], size: (u32, u32), samples: u32) {
    let view = serde_json::json!({
        "type": "view", "id": id, "camera": camera, "width": size.0, "height": size.1, "samples": samples,
    });
    socket.send(Message::text(view.to_string())).unwrap();
}

/// The next picture's numbers, and whether it is a PNG; acknowledges it.
fn next(socket: &mut Socket) -> ([u32; 4], bool) {
    loop {
        match socket.read().unwrap() {
            Message::Binary(bytes) => {
                let number = |at: usize| u32::from_le_bytes(bytes[at * 4..at * 4 + 4].try_into().unwrap());
                let is_png = number(4) == 1;
                assert!(bytes[20..].starts_with(if is_png { b"\x89PNG" } else { b"\xFF\xD8\xFF\xE0" }));
                socket.send(Message::text(format!(r#"{{"type":"ack","frame":{}}}"#, number(0)))).unwrap();
                return ([number(0), number(1), number(2), number(3)], is_png);
            }
            Message::Close(frame) => panic!("{frame:?}"),
            _ => {}
        }
    }
}

/// Reads until the server hangs up, and why it does.
fn hung_up(mut socket: Socket) -> String {
    loop {
        match socket.read() {
            Ok(Message::Close(frame)) => return frame.map_or_else(String::new, |frame| frame.reason.to_string()),
            Ok(_) => {}
            Err(error) => return error.to_string(),
        }
    }
}

#[test]
fn a_client_gets_pictures_of_what_it_looks_at() {
    let running = Running::start(|_| ());
    let mut socket = open(&running);
    let mut camera = greeted(&mut socket);
    for id in 1..=5 {
        camera[0] += 1.0;
        // So many samples that no view but the last has all of them, however late its picture is looked at.
        ask(&mut socket, id, &camera, (320, 200), 4096);
        let ([_, view, samples, of], is_png) = next(&mut socket);
        assert!(view <= id && samples <= of && of == 4096 && !is_png);
    }
    ask(&mut socket, 6, &camera, (320, 200), 8);
    let last = loop {
        let ([_, view, samples, _], is_png) = next(&mut socket);
        if is_png {
            break (view, samples);
        }
    };
    assert_eq!(last, (6, 8));
    assert_eq!(running.viewers.count(), 1);
}

#[test]
fn a_client_that_drops_costs_nothing_any_more() {
    let running = Running::start(|settings| settings.limits.viewers = 2);
    let busy = |running: &Running| {
        let mut socket = open(running);
        let camera = greeted(&mut socket);
        // Hours of tracing.
        ask(&mut socket, 1, &camera, (1920, 1080), 4096);
        next(&mut socket);
        socket
    };
    let sockets = [busy(&running), busy(&running)];
    assert_eq!(running.viewers.count(), 2);
    assert_eq!(open_as(&running, None).err(), Some(503), "a third one");
    // Without a word, as when a cable is cut or a page is closed.
    for socket in sockets {
        socket.get_ref().shutdown(std::net::Shutdown::Both).unwrap();
    }
    until("their tracing ends", || running.viewers.count() == 0);
    drop(busy(&running));
    until("so does one that leaves", || running.viewers.count() == 0);
}

#[test]
fn a_client_that_is_silent_is_let_go() {
    let running = Running::start(|settings| settings.limits.silence = Duration::from_secs(1));
    let mut socket = open(&running);
    greeted(&mut socket);
    // It reads nothing, so that it answers nothing either.
    until("it is let go", || running.viewers.count() == 0);
}

#[test]
fn sockets_of_other_origins_and_what_is_no_message_are_refused() {
    let running = Running::start(|settings| settings.limits.messages = 50);
    for origin in ["http://evil.example", "null", "http://localhost:1"] {
        assert_eq!(open_as(&running, Some(origin)).err(), Some(403), "{origin}");
    }
    assert!(open_as(&running, None).is_ok(), "programs say no origin");
    let hangs_up = |message: Message| {
        let mut socket = open(&running);
        greeted(&mut socket);
        socket.send(message).unwrap();
        hung_up(socket)
    };
    assert_eq!(hangs_up(Message::text("{}")), "a message is not understood");
    assert_eq!(hangs_up(Message::binary(vec![1])), "messages are text");
    hangs_up(Message::text("x".repeat(100_000)));
    let wrong = r#"{"type":"view","id":1,"camera":[0,0,0,0,0,0,0,0,1,45],"width":100000,"height":100000}"#;
    assert_eq!(hangs_up(Message::text(wrong)), "tracing failed");

    let mut flood = open(&running);
    greeted(&mut flood);
    for _ in 0..10_000 {
        if flood.send(Message::text(r#"{"type":"ack","frame":1}"#)).is_err() {
            break;
        }
    }
    hung_up(flood);
    until("all are let go", || running.viewers.count() == 0);
    assert_eq!(get(running.address, "/api/list").status, 200);
}

#[test]
fn clients_are_told_when_the_server_ends() {
    let mut running = Running::start(|_| ());
    let mut socket = open(&running);
    let camera = greeted(&mut socket);
    ask(&mut socket, 1, &camera, (1920, 1080), 4096);
    let reason = std::thread::spawn(move || hung_up(socket));
    assert!(running.stop() < Duration::from_secs(300));
    assert_eq!(reason.join().unwrap(), "the server stops");
    assert_eq!(running.viewers.count(), 0);
}
