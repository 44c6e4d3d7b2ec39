//! What the server gives.

use crate::client::{get, get_with};
use crate::{Running, city, files_below};
use std::fs;
use std::sync::Arc;
use voxtrace::PackedScene;

#[test]
fn a_folder_is_listed_with_its_scenes_and_nothing_else() {
    let running = Running::start(|_| ());
    let list: serde_json::Value = serde_json::from_slice(&get(running.address, "/api/list").body).unwrap();
    let names = |of: &str| {
        let mut names: Vec<&str> =
            list[of].as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect();
        names.sort_unstable();
        names
    };
    // Links are listed, and refused where they lead out.
    assert!(names("scenes").contains(&"scene.vxt") && names("scenes").contains(&"damaged.vox"));
    assert!(!names("scenes").contains(&"notes.html"));
    assert!(names("folders").contains(&"inner") && !names("folders").contains(&".hidden"));
}

#[test]
fn facts_of_a_scene_are_those_of_its_file_and_a_damaged_one_says_why() {
    let running = Running::start(|_| ());
    let info: serde_json::Value = serde_json::from_slice(&get(running.address, "/api/info/scene.vxt").body).unwrap();
    let scene = PackedScene::open(&running.folder().join("scene.vxt")).unwrap();
    assert_eq!(info["voxels"], scene.statistics().voxels);
    assert_eq!(info["content_hash"], format!("{:016x}", scene.content_hash()));
    assert_eq!(info["fits_pages"], true);
    let damaged = get(running.address, "/api/info/damaged.vox");
    assert_eq!(damaged.status, 422);
    let text = damaged.text();
    assert!(text.contains("damaged.vox") && !text.contains(running.folder().to_str().unwrap()), "{text}");
    // Once it is mended it is read again.
    fs::remove_file(running.folder().join("damaged.vox")).unwrap();
    assert_eq!(get(running.address, "/api/info/damaged.vox").status, 404);
    city(9000).save(&running.folder().join("damaged.vxt")).unwrap();
    fs::rename(running.folder().join("damaged.vxt"), running.folder().join("damaged.vox")).unwrap();
    assert_eq!(get(running.address, "/api/info/damaged.vox").status, 200);
}

#[test]
fn thumbnails_are_pictures_of_scenes_and_kept_by_what_files_hold() {
    let running = Running::start(|_| ());
    let first = get(running.address, "/api/thumbnail/scene.vxt");
    assert_eq!((first.status, first.header("content-type")), (200, Some("image/jpeg")));
    assert!(first.body.starts_with(&[0xFF, 0xD8]) && first.body.len() > 4000, "{} bytes", first.body.len());
    let kept = files_below(&running.cache().join("thumbnails"));
    assert_eq!(kept.len(), 1);
    // The copy has the same one; another scene has another.
    assert_eq!(get(running.address, "/api/thumbnail/inner/copy%20of%20it.vxt").body, first.body);
    assert_eq!(files_below(&running.cache().join("thumbnails")), kept);
    city(9000).save(&running.folder().join("other.vxt")).unwrap();
    assert_ne!(get(running.address, "/api/thumbnail/other.vxt").body, first.body);
    assert_eq!(files_below(&running.cache().join("thumbnails")).len(), 2);
    let damaged = get(running.address, "/api/thumbnail/damaged.vox");
    assert!(damaged.status == 422 && damaged.text().contains("damaged.vox"), "{}", damaged.text());
}

#[test]
fn a_scene_for_pages_is_the_file_packed_whatever_its_format() {
    let running = Running::start(|_| ());
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
    fs::write(running.folder().join("triangle.obj"), triangle).unwrap();
    let answer = get(running.address, "/api/packed/triangle.obj");
    assert_eq!(answer.status, 200, "{}", answer.text());
    let scene = PackedScene::from_bytes(&answer.body).unwrap();
    assert!(scene.statistics().voxels > 1000);
    let again = PackedScene::from_bytes(&get(running.address, "/api/packed/scene.vxt").body).unwrap();
    assert_eq!(again.content_hash(), PackedScene::open(&running.folder().join("scene.vxt")).unwrap().content_hash());
}

#[test]
fn files_come_in_parts_of_one_version() {
    let running = Running::start(|_| ());
    let address = running.address;
    let path = running.folder().join("scene.vxt");
    let bytes = fs::read(&path).unwrap();
    let whole = get(address, "/files/scene.vxt");
    assert!(whole.body == bytes);
    assert_eq!(whole.header("accept-ranges"), Some("bytes"));
    let tag = whole.header("etag").unwrap().to_owned();
    let part = get_with(address, "/files/scene.vxt", &["range: bytes=100-199", &format!("if-range: {tag}")]);
    assert_eq!((part.status, part.body.as_slice()), (206, &bytes[100..200]));
    assert_eq!(part.header("content-range"), Some(&*format!("bytes 100-199/{}", bytes.len())));
    let last = get_with(address, "/files/scene.vxt", &["range: bytes=-10"]);
    assert_eq!((last.status, last.body.as_slice()), (206, &bytes[bytes.len() - 10..]));
    assert_eq!(get_with(address, "/files/scene.vxt", &["range: bytes=99999999-"]).status, 416);
    assert_eq!(get_with(address, "/files/scene.vxt", &[&format!("if-none-match: {tag}")]).status, 304);
    // Another version comes whole, whatever part of the old one is asked for.
    city(9000).save(&path).unwrap();
    let other = get_with(address, "/files/scene.vxt", &["range: bytes=100-199", &format!("if-range: {tag}")]);
    assert!(other.status == 200 && other.body == fs::read(&path).unwrap());
    assert_ne!(other.header("etag").unwrap(), tag);
}

#[test]
fn scenes_are_read_once_and_forgotten_when_there_is_no_room() {
    let folder = tempfile::tempdir().unwrap();
    let scene = city(20_000);
    let bytes = scene.statistics().total_bytes();
    let running = Running::start(|settings| {
        for number in 0..6 {
            scene.save(&settings.folder.join(format!("{number}.vxt"))).unwrap();
        }
        settings.limits.memory = bytes * 2;
    });
    drop(folder);
    for round in 0..2 {
        for number in 0..6 {
            assert_eq!(get(running.address, &format!("/api/info/{number}.vxt")).status, 200, "round {round}");
        }
    }
    let scene = Arc::new(scene);
    assert_eq!(Arc::strong_count(&scene), 1);
}
