//! One test at a time has what must not be used by several: [`Alone`].

use std::cell::RefCell;
use std::ops::Deref;
use std::rc::{Rc, Weak};
use std::sync::{Mutex, MutexGuard, PoisonError};

static TURN: Mutex<()> = Mutex::new(());

thread_local! {
    /// The turn of this thread's test, while it has one.
    static MINE: RefCell<Weak<MutexGuard<'static, ()>>> = const { RefCell::new(Weak::new()) };
}

/// A Vulkan device under the validation layer, or its name, which the process's other tests wait for: the layer of Debian 12 (1.3.239) looks
/// its instances and devices up in a table without a lock, so that a thread that makes or ends one while another thread calls Vulkan now and
/// then ends the process with a segmentation fault. Tests without the layer run beside it.
///
/// A test's thread may have several.
#[derive(Debug)]
pub struct Alone<T> {
    // Dropped first.
    value: T,
    _turn: Rc<MutexGuard<'static, ()>>,
}

impl<T> Alone<T> {
    /// Waits for the turn of the calling thread, unless it has it, and makes the value. The turn ends with the thread's last value.
    pub fn new(make: impl FnOnce() -> T) -> Self {
        let turn = MINE.with_borrow(Weak::upgrade).unwrap_or_else(|| {
            // A test that failed in its turn is no reason for the next one to fail.
            let turn = Rc::new(TURN.lock().unwrap_or_else(PoisonError::into_inner));
            MINE.set(Rc::downgrade(&turn));
            turn
        });
        Self { value: make(), _turn: turn }
    }

    /// Another value in the same turn.
    pub fn map<U>(self, make: impl FnOnce(T) -> U) -> Alone<U> {
        Alone { value: make(self.value), _turn: self._turn }
    }
}

impl<T> Alone<Option<T>> {
    /// What there is, with the turn.
    pub fn some(self) -> Option<Alone<T>> {
        Some(Alone { value: self.value?, _turn: self._turn })
    }
}

impl<T> Deref for Alone<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::thread;
    use std::time::Duration;

    #[test]
    fn a_thread_has_several_and_another_waits_for_the_last() {
        static IS_OVER: AtomicBool = AtomicBool::new(false);
        let first = Alone::new(|| 1);
        let second = Alone::new(|| Some(2)).some().unwrap().map(|number| number + 1);
        assert_eq!((*first, *second), (1, 3));
        let other = thread::spawn(|| *Alone::new(|| IS_OVER.load(Ordering::SeqCst)));
        drop(first);
        thread::sleep(Duration::from_millis(50));
        assert!(!other.is_finished(), "the second is still there");
        IS_OVER.store(true, Ordering::SeqCst);
        drop(second);
        assert!(other.join().unwrap(), "the other thread began before the turn was over");
    }
}
