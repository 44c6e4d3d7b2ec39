//! What the server withstands.

use crate::client::{Answer, KINDS, SECRET, connect, exchange, get, get_with, head, hostile};
use crate::{Running, files_below, until};
use std::io::{Read, Write};
use std::time::{Duration, Instant};

/// Hostile requests here; the example `load` sends ten thousand and more.
const REQUESTS: usize = 900;

/// Where clients may take a second only, one that is held up asks once more.
fn patient(ask: impl Fn() -> Answer) -> Answer {
    let mut answer = ask();
    for _ in 0..20 {
        if !matches!(answer.status, 0 | 408) {
            break;
        }
        answer = ask();
    }
    answer
}

#[test]
fn hostile_requests_get_nothing_and_leave_nothing() {
    let running = Running::start(|settings| settings.limits.head = Duration::from_secs(1));
    let before = files_below(&running.folder());
    let mut answers = std::collections::BTreeMap::new();
    for number in 0..REQUESTS {
        let (bytes, kind) = hostile(number, running.address);
        let answer = exchange(running.address, &bytes);
        assert!(
            answer.status == 0 || (400..500).contains(&answer.status),
            "{kind}: {} to {}",
            answer.status,
            String::from_utf8_lossy(&bytes[..bytes.len().min(200)])
        );
        assert!(!answer.text().contains(SECRET), "{kind}");
        *answers.entry(kind).or_insert(0) += 1;
    }
    assert!(answers.len() >= KINDS, "{answers:?}");
    assert_eq!(files_below(&running.folder()), before);
    // The same requests of somebody honest.
    let status = |path: &str, headers: &[&str]| patient(|| get_with(running.address, path, headers)).status;
    assert_eq!(status("/files/scene.vxt", &[]), 200);
    assert_eq!(status("/files/inner/copy%20of%20it.vxt", &[]), 200);
    assert_eq!(status("/api/list/inner", &[]), 200);
    let origin = format!("origin: http://{}", running.address);
    assert_eq!(status("/files/scene.vxt", &[&origin, "sec-fetch-site: same-origin"]), 200);
    assert_eq!(status("/", &["sec-fetch-site: cross-site", "sec-fetch-mode: navigate"]), 200);
}

#[test]
fn every_answer_has_the_headers_of_safety() {
    let running = Running::start(|_| ());
    for path in ["/", "/page/page.js", "/files/scene.vxt", "/api/list", "/nothing", "/api/info/damaged.vox"] {
        let answer = get(running.address, path);
        let policy = answer.header("content-security-policy").unwrap_or_else(|| panic!("{path}"));
        assert!(policy.contains("default-src 'none'") && !policy.contains("unsafe-inline"), "{policy}");
        for (name, value) in [
            ("x-content-type-options", "nosniff"),
            ("x-frame-options", "deny"),
            ("cross-origin-resource-policy", "same-origin"),
        ] {
            assert_eq!(answer.header(name), Some(value), "{path}");
        }
    }
    let strange = get_with(running.address, "/", &["host: evil.example"]);
    assert_eq!((strange.status, strange.header("x-frame-options")), (403, Some("deny")));
}

#[test]
fn whoever_does_not_know_the_token_gets_nothing() {
    let token = "0123456789abcdef";
    let running = Running::start(|settings| settings.token = Some(token.into()));
    assert!(running.url.ends_with(&format!("/?token={token}")));
    let address = running.address;
    for path in [
        "/",
        "/api/list",
        "/files/scene.vxt",
        "/page/page.js",
        "/?token=0123456789abcdee",
        "/?token=",
        "/?token=0123456789abcdef0",
    ] {
        assert_eq!(get(address, path).status, 401, "{path}");
    }
    let port = address.port();
    for header in [
        format!("cookie: voxtrace-{port}=wrong"),
        "authorization: Bearer wrong".into(),
        format!("cookie: other={token}"),
    ] {
        assert_eq!(get_with(address, "/api/list", &[&header]).status, 401, "{header}");
    }
    let welcome = get(address, &format!("/?token={token}"));
    assert_eq!((welcome.status, welcome.header("location")), (303, Some("/")));
    let cookie = welcome.header("set-cookie").unwrap().to_owned();
    assert!(cookie.contains("httponly") && cookie.contains("samesite=lax"), "{cookie}");
    let cookie = format!("cookie: a=b; {}", cookie.split(';').next().unwrap());
    assert_eq!(get_with(address, "/api/list", &[&cookie]).status, 200);
    assert_eq!(get_with(address, "/api/list", &[&format!("authorization: Bearer {token}")]).status, 200);
}

#[test]
fn slow_clients_are_hung_up_on_and_others_are_answered_meanwhile() {
    let running = Running::start(|settings| {
        settings.limits.head = Duration::from_secs(1);
        settings.limits.body = Duration::from_secs(1);
        settings.limits.connections = 40;
    });
    let address = running.address;
    let before = files_below(&running.folder());
    // Heads that never end, bodies that stop, and connections that say nothing, on all connections but a few.
    let mut slow: Vec<_> = (0..36)
        .map(|number| {
            let mut stream = connect(address);
            let text = match number % 3 {
                0 => format!("GET / HTTP/1.1\r\nhost: {address}\r\nx-slow: "),
                1 => head("PUT", "/api/upload/slow.vox", address, &["content-length: 1000000"]) + "some",
                _ => String::new(),
            };
            // It may be hung up on by now.
            let _ = stream.write_all(text.as_bytes());
            stream
        })
        .collect();
    let is_answered = || patient(|| get(address, "/api/list")).status == 200;
    assert!(is_answered());
    for stream in &mut slow {
        let mut answer = Vec::new();
        // The end, or an answer and the end.
        let _ = stream.read_to_end(&mut answer);
        assert!(!answer.starts_with(b"HTTP/1.1 2"), "{}", String::from_utf8_lossy(&answer));
    }
    assert!(is_answered());
    until("parts of files are removed", || files_below(&running.folder()) == before);
    // More connections than are allowed wait for the others, and are answered then.
    let idle: Vec<_> = (0..60).map(|_| connect(address)).collect();
    assert!(is_answered());
    drop(idle);
}

#[test]
fn a_client_that_does_not_read_is_hung_up_on() {
    let running = Running::start(|settings| {
        settings.limits.unread = Duration::from_secs(1);
        settings.limits.connections = 1;
    });
    // Larger than the system keeps for a connection.
    std::fs::write(running.folder().join("large.vox"), vec![0; 64 << 20]).unwrap();
    let start = Instant::now();
    let mut stream = connect(running.address);
    stream.write_all(head("GET", "/files/large.vox", running.address, &[]).as_bytes()).unwrap();
    // The only connection is free again.
    assert_eq!(get(running.address, "/api/list").status, 200);
    assert!(start.elapsed() >= Duration::from_millis(500), "it waited for the other");
}

#[test]
fn the_server_ends_when_it_is_asked_to_whatever_is_open() {
    let mut running = Running::start(|settings| {
        settings.limits.farewell = Duration::from_secs(1);
        settings.limits.head = Duration::from_secs(3600);
        settings.limits.body = Duration::from_secs(3600);
    });
    let open: Vec<_> = (0..10).map(|_| connect(running.address)).collect();
    let mut begun = connect(running.address);
    begun.write_all(head("PUT", "/api/upload/a.vox", running.address, &["content-length: 1000"]).as_bytes()).unwrap();
    assert_eq!(get(running.address, "/api/list").status, 200);
    assert!(running.stop() < Duration::from_secs(300));
    assert!(std::net::TcpStream::connect(running.address).is_err());
    drop(open);
}
