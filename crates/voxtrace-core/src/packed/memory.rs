//! How much memory there is for what is mapped: that of the machine, or less where the process may take less.

use super::{Geometry, PackedScene};
use std::fs::read_to_string;
use std::path::Path;

impl PackedScene {
    /// Whether the file that it was opened from is more than memory holds beside the rest, so that tracing it waits for the disk. Known on Linux;
    /// elsewhere no.
    pub(crate) fn is_larger_than_memory(&self) -> bool {
        let mapped = self.geometry.mapped_bytes();
        mapped > 0 && available().is_some_and(|available| mapped > available / 4 * 3)
    }
}

impl Geometry {
    /// Bytes of it that lie in a mapped file.
    fn mapped_bytes(&self) -> u64 {
        let words = [&self.cells, &self.bricks, &self.brick_materials];
        let words: u64 = words.iter().map(|section| section.mapped_bytes()).sum();
        words + self.emitters.mapped_bytes() + self.light_nodes.mapped_bytes()
    }
}

/// Bytes that the process can have: what the machine can give, and the limits of its control groups.
fn available() -> Option<u64> {
    let machine = of_machine(&read_to_string("/proc/meminfo").ok()?)?;
    let limits = |groups: String| limits_of_groups(&groups, &|path| read_to_string(path).ok());
    let limit = read_to_string("/proc/self/cgroup").ok().and_then(limits);
    Some(limit.map_or(machine, |limit| limit.min(machine)))
}

/// What programs can have without others losing theirs, from `/proc/meminfo`.
fn of_machine(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

/// The least limit of the groups named in `/proc/self/cgroup` and of those around them, of both versions of control groups.
fn limits_of_groups(groups: &str, read: &dyn Fn(&Path) -> Option<String>) -> Option<u64> {
    let limit_of = |line: &str| {
        let mut fields = line.splitn(3, ':').skip(1);
        let (controllers, group) = (fields.next()?, fields.next()?);
        let (root, file) = match controllers {
            "" => ("/sys/fs/cgroup", "memory.max"),
            names if names.split(',').any(|name| name == "memory") => {
                ("/sys/fs/cgroup/memory", "memory.limit_in_bytes")
            }
            _ => return None,
        };
        // In a container the path may be the host's; then only the root is there.
        let limit = |group: &Path| read(&Path::new(root).join(group).join(file))?.trim().parse::<u64>().ok();
        Path::new(group.trim_start_matches('/')).ancestors().filter_map(limit).min()
    };
    groups.lines().filter_map(limit_of).min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_that_of_the_machine_or_the_least_limit_of_a_group() {
        let meminfo = "MemTotal:       24576 kB\nMemFree: 1 kB\nMemAvailable:    8192 kB\n";
        assert_eq!(of_machine(meminfo), Some(8 << 20));
        assert_eq!(of_machine("MemAvailable: much kB"), None);
        let files = [
            ("/sys/fs/cgroup/memory/a/memory.limit_in_bytes", "5000\n"),
            ("/sys/fs/cgroup/memory/a/b/memory.limit_in_bytes", "9223372036854771712\n"),
            ("/sys/fs/cgroup/c/d/memory.max", "max\n"),
            ("/sys/fs/cgroup/c/memory.max", "7000\n"),
        ];
        let read =
            |path: &Path| files.iter().find(|(name, _)| Path::new(name) == path).map(|(_, text)| (*text).to_owned());
        let limit = |groups: &str| limits_of_groups(groups, &read);
        assert_eq!(limit("5:cpu:/x\n4:memory:/a/b\n0::/\n"), Some(5000));
        assert_eq!(limit("0::/c/d\n"), Some(7000));
        assert_eq!(limit("0::/c/d\n4:cpu,memory:/a\n"), Some(5000));
        assert_eq!(limit("0::/\n"), None);
        assert_eq!(limit("nothing"), None);
    }

    #[test]
    fn what_lies_in_memory_is_not_larger_than_it() {
        assert!(!PackedScene::empty().is_larger_than_memory());
    }
}
