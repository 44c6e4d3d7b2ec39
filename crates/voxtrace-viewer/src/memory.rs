//! Memory that was freed goes back to the system. The allocator of the GNU C library keeps it, in an arena for each of many threads: what is
//! freed lies between what is not, and a driver in software, which compiles on its own threads, frees much. Scenes and tracers come and go
//! in a window for hours.

#[cfg(all(target_os = "linux", target_env = "gnu"))]
use std::{
    sync::{Mutex, PoisonError},
    time::{Duration, Instant},
};

/// Time from one giving back to the next.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const AT_LEAST: Duration = Duration::from_secs(3);

/// Gives back what is free, on all threads, where that was not done within the last seconds: it takes some milliseconds, in which others that
/// allocate may wait. Elsewhere than with the GNU C library, whose habit this is, it does nothing.
pub fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    {
        static LAST: Mutex<Option<Instant>> = Mutex::new(None);
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        if last.is_none_or(|last| last.elapsed() >= AT_LEAST) {
            trim();
            *last = Some(Instant::now());
        }
    }
}

#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn trim() {
    unsafe extern "C" {
        /// malloc_trim(3): 1 where memory was given back.
        fn malloc_trim(pad: usize) -> std::ffi::c_int;
    }
    // SAFETY: it locks what it looks at, and touches free memory alone.
    unsafe { malloc_trim(0) };
}

#[cfg(all(test, target_os = "linux", target_env = "gnu"))]
mod tests {
    use super::*;

    /// Resident memory, bytes.
    fn resident() -> usize {
        let text = std::fs::read_to_string("/proc/self/statm").unwrap();
        text.split(' ').nth(1).unwrap().parse::<usize>().unwrap() * 4096
    }

    #[test]
    fn what_is_freed_between_what_is_kept_goes_back_to_the_system() {
        const BLOCKS: usize = 2000;
        let make = || (0..BLOCKS).map(|index| vec![index as u8; 60_000]).collect::<Vec<_>>();
        let mut kept: Vec<Vec<u8>> = std::thread::spawn(make).join().unwrap();
        let full = resident();
        // Most of it goes, and what stays keeps the arena from shrinking by itself.
        let mut index = 0;
        kept.retain(|_| {
            index += 1;
            index % 20 == 0
        });
        let freed = (BLOCKS - kept.len()) * 60_000;
        let before = resident();
        assert!(full - before.min(full) < freed / 4, "the allocator keeps it: {full} {before}");
        trim();
        let after = resident();
        assert!(before - after.min(before) > freed / 2, "{before} {after}");
        assert!(kept.iter().all(|block| block.len() == 60_000));
    }
}
