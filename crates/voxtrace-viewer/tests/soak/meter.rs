//! What memory the process has, by who holds it: so that growth has a name.

#![allow(unsafe_code, reason = "the C library says what its heaps hold; each block says why it is sound")]

use std::fmt::{Display, Formatter};

/// One of its parts.
type Part = fn(&Memory) -> u64;

/// Bytes at one time.
#[derive(Clone, Copy, Debug, Default)]
pub struct Memory {
    /// Pages that lie in memory.
    pub resident: u64,
    /// The same once the heaps of the GNU C library have given back what was freed. Drivers in software compile on threads of their own, each of which has
    /// a heap; how much of what they freed still lies there says nothing about what is held.
    pub needed: u64,
    /// What was asked for and not freed, in these heaps and in maps of their own for large blocks.
    pub held: u64,
    /// Of the resident pages those of files: programs, and buffers of a device in software.
    pub files: u64,
}

/// mallinfo2(3).
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[repr(C)]
#[derive(Default)]
struct Mallinfo2 {
    arena: usize,
    ordblks: usize,
    smblks: usize,
    hblks: usize,
    hblkhd: usize,
    usmblks: usize,
    fsmblks: usize,
    uordblks: usize,
    fordblks: usize,
    keepcost: usize,
}

#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn held_after_trimming() -> u64 {
    unsafe extern "C" {
        fn mallinfo2() -> Mallinfo2;
        /// malloc_trim(3).
        fn malloc_trim(pad: usize) -> std::ffi::c_int;
    }
    // SAFETY: both lock what they look at; the second touches free memory alone.
    let info = unsafe {
        malloc_trim(0);
        mallinfo2()
    };
    (info.uordblks + info.hblkhd) as u64
}

#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn held_after_trimming() -> u64 {
    0
}

/// Resident pages, and those of them that are of files, bytes.
fn pages() -> (u64, u64) {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    let bytes =
        |index: usize| text.split(' ').nth(index).and_then(|pages| pages.parse::<u64>().ok()).unwrap_or(0) * 4096;
    (bytes(1), bytes(2))
}

impl Memory {
    /// What the parts are called.
    pub const KINDS: [(&str, Part); 4] = [
        ("resident", |memory| memory.resident),
        ("without what was freed", |memory| memory.needed),
        ("held in heaps", |memory| memory.held),
        ("of files", |memory| memory.files),
    ];

    /// As it is.
    pub fn now() -> Self {
        let (resident, _) = pages();
        let held = held_after_trimming();
        let (needed, files) = pages();
        Self { resident, needed, held, files }
    }
}

impl Display for Memory {
    fn fmt(&self, f: &mut Formatter) -> std::fmt::Result {
        let Self { resident, needed, held, files } = self;
        write!(f, "{} {} {} {}", resident >> 10, needed >> 10, held >> 10, files >> 10)
    }
}
