//! Undo and redo of states that change in small steps: one entry a gesture. A gesture lies between `begin` and `end`, or where
//! nothing says so ends with a pause.

use std::collections::VecDeque;

/// Most entries; the oldest go first.
const MOST: usize = 256;
/// Seconds without a change that end a gesture.
const PAUSE: f64 = 0.5;

/// Earlier and later states.
#[derive(Clone, Debug)]
pub struct History<T> {
    past: VecDeque<T>,
    future: Vec<T>,
    /// The state before the gesture in progress.
    start: Option<T>,
    /// Whether somebody holds the gesture, so that pauses do not end it.
    is_held: bool,
    /// Seconds since the last change.
    quiet: f64,
}

impl<T> Default for History<T> {
    fn default() -> Self {
        Self { past: VecDeque::new(), future: Vec::new(), start: None, is_held: false, quiet: 0.0 }
    }
}

impl<T: Clone + PartialEq> History<T> {
    /// Says that the state changes from `before`.
    pub fn note(&mut self, before: &T) {
        self.start.get_or_insert_with(|| before.clone());
        self.future.clear();
        self.quiet = 0.0;
    }

    /// Says that time goes by; `now` is the state.
    pub fn pass(&mut self, seconds: f64, now: &T) {
        self.quiet += seconds;
        if self.quiet >= PAUSE && !self.is_held {
            self.close(now);
        }
    }

    /// A gesture begins in the state `now`.
    pub fn begin(&mut self, now: &T) {
        self.close(now);
        self.is_held = true;
    }

    /// It ends.
    pub fn end(&mut self, now: &T) {
        self.close(now);
        self.is_held = false;
    }

    /// Makes an entry of what changed since the last one.
    pub fn close(&mut self, now: &T) {
        let Some(start) = self.start.take().filter(|start| start != now) else { return };
        if self.past.len() == MOST {
            self.past.pop_front();
        }
        self.past.push_back(start);
    }

    /// The state before the last gesture.
    pub fn undo(&mut self, now: &T) -> Option<T> {
        self.close(now);
        let before = self.past.pop_back()?;
        self.future.push(now.clone());
        Some(before)
    }

    /// The state that was undone last.
    pub fn redo(&mut self, now: &T) -> Option<T> {
        let after = self.future.pop()?;
        self.past.push_back(now.clone());
        Some(after)
    }

    /// Whether there is something to undo.
    pub fn can_undo(&self, now: &T) -> bool {
        self.start.as_ref().is_some_and(|start| start != now) || !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps from `from` to `to`, as a mouse makes them.
    fn drag(history: &mut History<i32>, from: i32, to: i32) -> i32 {
        (from..to).for_each(|state| history.note(&state));
        to
    }

    #[test]
    fn a_gesture_of_many_events_is_one_entry() {
        let mut history = History::default();
        history.begin(&0);
        let now = drag(&mut history, 0, 10);
        history.pass(5.0, &now);
        let now = drag(&mut history, now, 20);
        history.end(&now);
        assert_eq!(history.undo(&now), Some(0), "a held gesture goes on over a pause");
        assert_eq!(history.undo(&0), None);
        assert_eq!(history.redo(&0), Some(20));
        assert_eq!(history.redo(&20), None);
    }

    #[test]
    fn a_pause_of_half_a_second_ends_what_nobody_holds() {
        let mut history = History::default();
        let now = drag(&mut history, 0, 10);
        (0..4).for_each(|_| history.pass(0.1, &now));
        let now = drag(&mut history, now, 20);
        (0..6).for_each(|_| history.pass(0.1, &now));
        let now = drag(&mut history, now, 30);
        assert_eq!(history.undo(&now), Some(20), "0.4 s is no pause, 0.6 s is one");
        assert_eq!(history.undo(&20), Some(0));
    }

    #[test]
    fn a_change_after_an_undo_ends_what_could_be_redone() {
        let mut history = History::default();
        let now = drag(&mut history, 0, 5);
        assert_eq!(history.undo(&now), Some(0));
        assert!(history.can_redo());
        drag(&mut history, 0, 3);
        assert!(!history.can_redo());
        assert_eq!(history.redo(&3), None);
    }

    #[test]
    fn a_gesture_that_comes_back_is_no_entry_and_the_oldest_of_many_go() {
        let mut history = History::default();
        history.note(&0);
        assert!(!history.can_undo(&0) && history.can_undo(&1));
        assert_eq!(history.undo(&0), None);
        for state in 0..1000 {
            history.note(&state);
            history.close(&(state + 1));
        }
        let undone = std::iter::successors(Some(1000), |now| history.undo(now)).count() - 1;
        assert_eq!(undone, MOST);
    }
}
