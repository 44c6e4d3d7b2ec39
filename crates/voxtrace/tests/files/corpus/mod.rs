//! The corpora of the fuzz targets, `fuzz/corpus`: the samples that they start from, and what fuzzing has found.

use std::fs;
use std::path::Path;

/// Checks every file of a target's corpus, after a look whether the samples are among them as they are now. With
/// `VOXTRACE_BLESS=1` they are written.
pub fn replay<'a>(target: &str, samples: impl IntoIterator<Item = &'a (&'a str, Vec<u8>)>, check: impl Fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    for (name, bytes) in samples {
        let path = folder.join(name);
        if std::env::var_os("VOXTRACE_BLESS").is_some() {
            fs::create_dir_all(&folder).unwrap();
            fs::write(&path, bytes).unwrap();
        }
        let committed = fs::read(&path).unwrap_or_default();
        assert!(committed == *bytes, "{name} is stale: run this test with VOXTRACE_BLESS=1");
    }
    for entry in fs::read_dir(&folder).unwrap() {
        check(&fs::read(entry.unwrap().path()).unwrap());
    }
}
