//! Threads that work while a window is open stand back behind the one that takes its events and the one that draws it: whatever is
//! traced, read or written, the window gets a core as soon as it wants one.

use std::sync::LazyLock;

/// How much lower than the window's the priority of work is: ten steps of `nice` are a tenth of the weight.
#[cfg(target_os = "linux")]
const NICE: i32 = 10;

/// Lowers the priority of the calling thread, and of threads that it starts from now on. Elsewhere than on Linux, where the
/// priority of a thread is not that of its process, it does nothing.
pub fn yield_to_window() {
    #[cfg(target_os = "linux")]
    {
        // Linux takes the calling thread for "the calling process" (setpriority(2), "C library/kernel differences"). Refused
        // where somebody lowered it more already: then there is nothing to do.
        let _ = rustix::process::setpriority_process(None, NICE);
    }
}

/// Lowers the priority of all threads that share the work of the processor.
pub fn let_workers_yield() {
    rayon::broadcast(|_| yield_to_window());
}

/// Does work that is shared among threads on threads of the window's own, and waits for it: those that all else shares may be busy with a
/// sample for seconds, and would begin it only then.
pub fn aside<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    static OWN: LazyLock<Option<rayon::ThreadPool>> = LazyLock::new(|| rayon::ThreadPoolBuilder::new().build().ok());
    match &*OWN {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn workers_stand_back_and_the_thread_of_the_window_does_not() {
        let priority = || rustix::process::getpriority_process(None).unwrap();
        let before = priority();
        let_workers_yield();
        assert!(rayon::broadcast(|_| priority()).into_iter().all(|lower| lower >= NICE));
        assert_eq!(priority(), before);
        let inherited = std::thread::spawn(move || {
            yield_to_window();
            std::thread::spawn(priority).join().unwrap()
        });
        assert!(inherited.join().unwrap() >= NICE);
    }
}
