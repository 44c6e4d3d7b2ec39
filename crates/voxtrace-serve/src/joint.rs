//! Work that several clients wait for: it is done once, goes on while any of them waits, and ends when none does.

use futures_util::FutureExt;
use futures_util::future::{Shared, WeakShared};
use std::pin::Pin;

/// Work of any kind.
pub type Work<T> = Pin<Box<dyn Future<Output = T> + Send>>;

/// Work under way, as long as somebody waits for it.
pub struct Joint<T: Clone>(Option<WeakShared<Work<T>>>);

impl<T: Clone> Default for Joint<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T: Clone> Joint<T> {
    /// The end of the work under way, or else of what `begin` gives. Once all who wait for it are dropped, so is the work.
    pub fn join(&mut self, begin: impl FnOnce() -> Work<T>) -> Shared<Work<T>> {
        if let Some(work) = self.0.as_ref().and_then(WeakShared::upgrade) {
            return work;
        }
        let work = begin().shared();
        self.0 = work.downgrade();
        work
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::future::pending;
    use std::sync::Arc;
    use tokio::sync::oneshot;

    #[test]
    fn work_is_done_once_though_the_first_who_waits_leaves() {
        let (mut joint, (sender, receiver)) = (Joint::default(), oneshot::channel());
        let mut first = joint.join(|| Box::pin(async move { receiver.await.unwrap_or(0) }));
        assert_eq!((&mut first).now_or_never(), None);
        let mut second = joint.join(|| unreachable!("it is under way"));
        assert_eq!((&mut second).now_or_never(), None);
        drop(first);
        sender.send(7).unwrap();
        assert_eq!((&mut second).now_or_never(), Some(7));
    }

    #[test]
    fn work_ends_when_nobody_waits_and_begins_anew_for_the_next() {
        let (mut joint, held) = (Joint::<u32>::default(), Arc::new(()));
        let mut work = || {
            let held = Arc::clone(&held);
            joint.join(|| {
                Box::pin(async move {
                    let _held = held;
                    pending().await
                })
            })
        };
        let both = [work(), work()];
        assert_eq!(Arc::strong_count(&held), 2, "one of ours, one of the work");
        drop(both);
        assert_eq!(Arc::strong_count(&held), 1);
        let _again = work();
        assert_eq!(Arc::strong_count(&held), 2);
    }
}
