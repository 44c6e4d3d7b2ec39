//! A client of bytes, for what no ordinary client sends; and hostile requests of every kind. The example `load` has the same.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::Duration;

/// What lies outside of the folder that is served, or is hidden in it.
pub(crate) const SECRET: &str = "TOP-SECRET-4711";

/// An answer.
pub(crate) struct Answer {
    /// 0 where the server hung up.
    pub(crate) status: u16,
    /// Lower case.
    pub(crate) head: String,
    pub(crate) body: Vec<u8>,
}

impl Answer {
    fn of(bytes: &[u8]) -> Self {
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").map_or(bytes.len(), |at| at + 4);
        let head = String::from_utf8_lossy(&bytes[..end]).to_ascii_lowercase();
        let status = head.split(' ').nth(1).and_then(|code| code.parse().ok()).unwrap_or(0);
        Self { status, head, body: bytes[end..].to_vec() }
    }

    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        self.head.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }

    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }
}

pub(crate) fn connect(address: SocketAddr) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    let time = Some(Duration::from_secs(120));
    stream.set_read_timeout(time).unwrap();
    stream.set_write_timeout(time).unwrap();
    stream
}

/// Sends bytes and reads all that comes until the server hangs up.
pub(crate) fn exchange(address: SocketAddr, bytes: &[u8]) -> Answer {
    let mut stream = connect(address);
    // A server that has seen enough hangs up before all was sent.
    let _ = stream.write_all(bytes);
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer);
    Answer::of(&answer)
}

/// Asks for a path, with further headers, each `name: value`.
pub(crate) fn get_with(address: SocketAddr, path: &str, headers: &[&str]) -> Answer {
    exchange(address, head("GET", path, address, headers).as_bytes())
}

pub(crate) fn get(address: SocketAddr, path: &str) -> Answer {
    get_with(address, path, &[])
}

pub(crate) fn put(address: SocketAddr, path: &str, body: &[u8]) -> Answer {
    let length = format!("content-length: {}", body.len());
    exchange(address, &[head("PUT", path, address, &[&length]).as_bytes(), body].concat())
}

/// The head of a request under the server's own name, unless the headers have another.
pub(crate) fn head(method: &str, path: &str, address: SocketAddr, headers: &[&str]) -> String {
    let mut text = format!("{method} {path} HTTP/1.1\r\nconnection: close\r\n");
    if !headers.iter().any(|header| header.starts_with("host:")) {
        text += &format!("host: {address}\r\n");
    }
    headers.iter().for_each(|header| text += &format!("{header}\r\n"));
    text + "\r\n"
}

/// Kinds of hostile requests.
pub(crate) const KINDS: usize = 9;

/// Ways to a file outside; `{}` is the way up.
const WAYS: [&str; 9] = [
    "/files/{}secret.vox",
    "/api/info/{}secret.vox",
    "/api/thumbnail/{}secret.vox",
    "/api/packed/{}secret.vox",
    "/api/list/{}",
    "/files/inner/{}{}secret.vox",
    "/api/remote/{}secret.vox",
    "/element/{}secret.vox",
    "/page/{}secret.vox",
];
const UPS: [&str; 20] = [
    "../",
    "..%2f",
    "%2e%2e/",
    "%2e%2e%2f",
    "..%5c",
    "..\\",
    "%252e%252e%252f",
    "....//",
    "..;/",
    "..%00/",
    "%c0%ae%c0%ae/",
    "/../",
    "//",
    "%2f",
    "c:%5c",
    "c:/",
    "~/",
    ".hidden/",
    "out/",
    "..%ff/",
];
const FILES: [&str; 9] = [
    "/files/link.vox",
    "/files/out/secret.vox",
    "/files/.hidden/secret.vox",
    "/files/nul",
    "/files/con.vox",
    "/files/com1.vox",
    "/files/pipe.vox",
    "/files/zero.vox",
    "/files//etc/passwd",
];

/// The hostile request of a number: its bytes, which kind it is, and whether an answer with status 200 would be a fault.
pub(crate) fn hostile(number: usize, address: SocketAddr) -> (Vec<u8>, &'static str) {
    let pick = |from: &[&'static str]| from[(number / KINDS) % from.len()];
    let plain = |method: &str, path: &str, headers: &[&str]| head(method, path, address, headers).into_bytes();
    match number % KINDS {
        0 => {
            let way = WAYS[(number / KINDS) % WAYS.len()];
            (plain("GET", &way.replace("{}", UPS[(number / KINDS / WAYS.len()) % UPS.len()]), &[]), "traversal")
        }
        1 => (plain("GET", pick(&FILES), &[]), "links, devices, hidden files"),
        2 => {
            let hosts = [
                "evil.example",
                "localhost.evil.example",
                "169.254.169.254",
                "user@evil.example",
                "",
                "[::ffff:8.8.8.8]",
                "127.0.0.1.nip.io",
            ];
            (plain("GET", "/api/list", &[&format!("host: {}", hosts[(number / KINDS) % hosts.len()])]), "another host")
        }
        3 => {
            let origins = [
                "http://evil.example",
                "null",
                "http://localhost:1",
                "https://evil.example",
                "file://",
                "http://127.0.0.1",
            ];
            let origin = format!("origin: {}", origins[(number / KINDS) % origins.len()]);
            let socket = [
                "upgrade: websocket",
                "sec-websocket-version: 13",
                "sec-websocket-key: dGhlIHNhbXBsZSBub25jZQ==",
                &*origin,
            ];
            match number / KINDS % 2 {
                0 => (plain("GET", "/api/remote/scene.vxt", &socket).to_vec(), "cross-origin web sockets"),
                _ => (plain("PUT", "/api/upload/new.vox", &[&origin, "content-length: 0"]), "cross-origin writes"),
            }
        }
        4 => match number / KINDS % 3 {
            0 => (plain("GET", "/", &[&format!("x-large: {}", "a".repeat(100_000))]), "huge headers"),
            1 => (plain("GET", &format!("/files/{}", "a".repeat(60_000)), &[]), "huge addresses"),
            _ => {
                let many: Vec<String> = (0..500).map(|number| format!("x-{number}: a")).collect();
                (plain("GET", "/", &many.iter().map(String::as_str).collect::<Vec<_>>()), "many headers")
            }
        },
        5 => {
            let broken: [&[u8]; 8] = [
                b"GET\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n",
                b"GET / HTTP/1.1\r\nhost\x00: a\r\n\r\n", b"\r\n\r\n\r\n\r\n", b"GET http://evil.example/ HTTP/1.1\r\nhost: evil.example\r\nconnection: close\r\n\r\n",
                b"GET / HTTP/1.1\r\ntransfer-encoding: chunked\r\ncontent-length: 5\r\nhost: a\r\nconnection: close\r\n\r\nzzzz\r\n",
            ];
            (broken[(number / KINDS) % broken.len()].to_vec(), "what is no request")
        }
        6 => {
            let methods = ["DELETE", "POST", "TRACE", "CONNECT", "OPTIONS", "PROPFIND", "PATCH"];
            (plain(methods[(number / KINDS) % methods.len()], "/files/scene.vxt", &[]), "other methods")
        }
        7 => {
            let names = [
                "/api/upload/../new.vox",
                "/api/upload/.hidden.vox",
                "/api/upload/a%2f..%2f..%2fnew.vox",
                "/api/upload/new.exe",
                "/api/upload/nul.vox",
                "/api/upload/new.vox",
            ];
            let body = "content-length: 9\r\n\r\nno scene!";
            let request = format!("PUT {} HTTP/1.1\r\nhost: {address}\r\nconnection: close\r\n{body}", pick(&names));
            (request.into_bytes(), "uploads")
        }
        _ => {
            let sites = ["sec-fetch-site: cross-site", "sec-fetch-site: same-site"];
            (plain("GET", "/files/scene.vxt", &[pick(&sites)]), "pages of other sites")
        }
    }
}
