//! Files that are uploaded are whole or not there.

use crate::client::{connect, get, head, put};
use crate::{Running, city, files_below, until};
use std::fs;
use std::io::Write;
use voxtrace::PackedScene;

/// A MagicaVoxel file of a few voxels.
fn vox(voxels: u8) -> Vec<u8> {
    let mut xyzi = u32::from(voxels).to_le_bytes().to_vec();
    (0..voxels).for_each(|at| xyzi.extend([at, 0, 0, 1]));
    let size = [voxels.max(1), 1, 1].map(u32::from).map(u32::to_le_bytes).concat();
    let chunk = |name: &[u8], content: &[u8]| {
        [name, &(content.len() as u32).to_le_bytes(), &0u32.to_le_bytes(), content].concat()
    };
    let inside = [chunk(b"SIZE", &size), chunk(b"XYZI", &xyzi)].concat();
    let main = [b"MAIN".as_slice(), &0u32.to_le_bytes(), &(inside.len() as u32).to_le_bytes(), &inside].concat();
    [b"VOX ".as_slice(), &150u32.to_le_bytes(), &main].concat()
}

fn voxels_of(running: &Running, name: &str) -> u64 {
    PackedScene::read(&running.folder().join(name)).unwrap().statistics().voxels
}

#[test]
fn a_file_is_converted_and_takes_no_other_files_place_unless_asked() {
    let running = Running::start(|_| ());
    let answer = put(running.address, "/api/upload/inner/row.vox", &vox(3));
    assert_eq!(answer.status, 201, "{}", answer.text());
    assert!(answer.text().contains("inner/row.vxt"));
    assert_eq!(voxels_of(&running, "inner/row.vxt"), 3);
    assert_eq!(PackedScene::read(&running.folder().join("inner/row.vxt")).unwrap().name, "row");

    let again = put(running.address, "/api/upload/inner/row.vox", &vox(5));
    assert!(again.status == 409 && again.text().contains("row.vxt is there already"), "{}", again.text());
    assert_eq!(voxels_of(&running, "inner/row.vxt"), 3);
    assert_eq!(put(running.address, "/api/upload/inner/row.vox?replace=true", &vox(5)).status, 201);
    assert_eq!(voxels_of(&running, "inner/row.vxt"), 5);
    assert_eq!(get(running.address, "/api/thumbnail/inner/row.vxt").status, 200);
}

#[test]
fn what_cannot_be_read_is_too_large_or_comes_in_part_leaves_nothing() {
    let running = Running::start(|settings| settings.limits.upload = 100_000);
    let before = files_below(&running.folder());
    let damaged = put(running.address, "/api/upload/bad.vox", b"VOX and no more");
    assert!(damaged.status == 422 && damaged.text().contains("bad.vox"), "{}", damaged.text());
    assert!(!damaged.text().contains("voxtrace-upload"), "{}", damaged.text());
    assert_eq!(put(running.address, "/api/upload/a.exe", b"").status, 415);
    assert_eq!(put(running.address, "/api/upload/none/a.vox", &vox(1)).status, 404);
    assert!(matches!(put(running.address, "/api/upload/big.vox", &vec![0; 1_000_000]).status, 413 | 0));
    // A client that leaves in the middle.
    let mut stream = connect(running.address);
    let request = head("PUT", "/api/upload/part.vox", running.address, &["content-length: 90000"]);
    stream.write_all(request.as_bytes()).unwrap();
    stream.write_all(&vox(9)).unwrap();
    until("the upload begins", || files_below(&running.folder()).len() > before.len());
    drop(stream);
    until("parts of files are removed", || files_below(&running.folder()) == before);
    assert_eq!(put(running.address, "/api/upload/good.vox", &vox(9)).status, 201);
}

#[test]
fn a_server_that_takes_no_files_takes_none() {
    let running = Running::start(|settings| settings.limits.upload = 0);
    assert_eq!(put(running.address, "/api/upload/a.vox", &vox(1)).status, 403);
    assert!(!fs::exists(running.folder().join("a.vxt")).unwrap());
    city(9000).save(&running.folder().join("mine.vxt")).unwrap();
    assert_eq!(get(running.address, "/api/info/mine.vxt").status, 200);
}
