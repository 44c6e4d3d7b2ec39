//! The server, as it is started: what it is told is what it does.

use crate::common::Folder;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};

/// Ends the program with the test, however it ends.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// What the server says of itself, started with these options.
fn about(options: &[&str]) -> serde_json::Value {
    let folder = Folder::new();
    let arguments = [&["serve", ".", "--listen", "127.0.0.1:0"], options].concat();
    let child = folder.command(&arguments).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let mut child = Running(child);
    let mut url = String::new();
    BufReader::new(child.0.stdout.take().unwrap()).read_line(&mut url).unwrap();
    let address = url.trim().strip_prefix("http://").and_then(|url| url.strip_suffix('/'));
    let address = address.unwrap_or_else(|| panic!("{options:?}: no address: {url:?}"));
    let mut stream = TcpStream::connect(address).unwrap();
    let request = format!("GET /api/server HTTP/1.1\r\nhost: {address}\r\nconnection: close\r\n\r\n");
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    let (_, body) = answer.split_once("\r\n\r\n").unwrap();
    serde_json::from_str(body).unwrap()
}

#[test]
fn options_that_cannot_be_are_refused_and_not_offered() {
    let folder = Folder::new();
    assert!(!folder.succeed(&["serve", "--help"]).contains("--cluster"));
    assert!(folder.fail(&["serve", ".", "--cluster", "tcp://127.0.0.1:1"], 2).contains("--cluster is for"));
    let missing = folder.fail(&["serve", "none", "--listen", "127.0.0.1:0"], 3);
    assert!(missing.starts_with("error: cannot read none: no such file"), "{missing}");
    for name in ["scans.example:8080", "http://scans.example", ""] {
        let said = folder.fail(&["serve", ".", "--host-name", name], 2);
        assert!(said.contains("without scheme and port"), "{name:?}: {said}");
    }
}

#[test]
fn a_server_takes_files_of_the_size_that_it_was_told_or_none() {
    assert_eq!(about(&[])["largest_upload"], 2_000_000_000_u64);
    assert_eq!(about(&["--max-upload", "5MB"])["largest_upload"], 5_000_000);
    assert_eq!(about(&["--max-upload", "0"])["largest_upload"], 0);
}
