//! Undo and redo: for each edit the words that its bricks had before, or have after.

use super::plan::Change;
use glam::IVec3;
use rustc_hash::FxHashSet;
use std::collections::VecDeque;

/// Bytes that are kept unless said otherwise.
const MOST_BYTES: u64 = 256 << 20;

/// What one edit changed: grid and bricks as they were.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub grid: u32,
    pub bricks: Vec<Change>,
}

impl Entry {
    fn size_bytes(&self) -> u64 {
        let code = |(_, code): &Change| code.as_ref().map_or(0, |code| code.size_bytes());
        self.bricks.iter().map(|change| size_of::<Change>() as u64 + code(change)).sum()
    }
}

/// Edits that can be undone, and those that were.
#[derive(Clone, Debug)]
pub(super) struct History {
    undo: VecDeque<Entry>,
    redo: Vec<Entry>,
    size_bytes: u64,
    most_bytes: u64,
    /// Bricks of the last entry, while edits are joined to it.
    joined: Option<FxHashSet<IVec3>>,
    /// Whether no edit joins the last entry: one that failed or changed nothing came after it.
    is_closed: bool,
}

impl Default for History {
    fn default() -> Self {
        Self {
            undo: VecDeque::new(),
            redo: Vec::new(),
            size_bytes: 0,
            most_bytes: MOST_BYTES,
            joined: None,
            is_closed: false,
        }
    }
}

impl History {
    /// Keeps at most so many bytes from now on.
    pub fn set_most_bytes(&mut self, bytes: u64) {
        self.most_bytes = bytes;
        self.forget_oldest();
    }

    pub fn size_bytes(&self) -> u64 {
        self.size_bytes
    }

    /// How many edits can be undone, and how many redone.
    pub fn lengths(&self) -> (usize, usize) {
        (self.undo.len(), self.redo.len())
    }

    /// An edit that is one step with the last one: of bricks that both changed, the words before the first count. Where there is none to join, it
    /// is a new one.
    pub fn join(&mut self, entry: Entry) {
        let is_open = self.redo.is_empty() && !self.is_closed;
        let last = self.undo.back_mut().filter(|last| last.grid == entry.grid && is_open);
        let Some(last) = last else { return self.push(entry) };
        let known = self.joined.get_or_insert_with(|| last.bricks.iter().map(|(at, _)| *at).collect());
        let added: Vec<Change> = entry.bricks.into_iter().filter(|(at, _)| known.insert(*at)).collect();
        let added = Entry { grid: last.grid, bricks: added };
        self.size_bytes += added.size_bytes();
        last.bricks.extend(added.bricks);
        self.forget_oldest();
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        *self = Self { most_bytes: self.most_bytes, ..Self::default() };
    }

    /// A new edit begins, which may fail or change nothing: edits that are joined to it are no part of the step before.
    pub fn close(&mut self) {
        self.is_closed = true;
    }

    /// A new edit: what was undone before cannot be redone.
    pub fn push(&mut self, entry: Entry) {
        (self.joined, self.is_closed) = (None, false);
        let gone: u64 = self.redo.drain(..).map(|entry| entry.size_bytes()).sum();
        self.size_bytes = self.size_bytes - gone + entry.size_bytes();
        self.undo.push_back(entry);
        self.forget_oldest();
    }

    pub fn pop_undo(&mut self) -> Option<Entry> {
        self.joined = None;
        let entry = self.undo.pop_back()?;
        self.size_bytes -= entry.size_bytes();
        Some(entry)
    }

    /// The edit that would be undone next.
    pub fn next_undo(&self) -> Option<&Entry> {
        self.undo.back()
    }

    /// The edit that would be redone next.
    pub fn next_redo(&self) -> Option<&Entry> {
        self.redo.last()
    }

    pub fn pop_redo(&mut self) -> Option<Entry> {
        let entry = self.redo.pop()?;
        self.size_bytes -= entry.size_bytes();
        Some(entry)
    }

    /// What was undone.
    pub fn push_redo(&mut self, entry: Entry) {
        self.size_bytes += entry.size_bytes();
        self.redo.push(entry);
        self.forget_oldest();
    }

    /// What was redone.
    pub fn push_undo(&mut self, entry: Entry) {
        self.joined = None;
        self.size_bytes += entry.size_bytes();
        self.undo.push_back(entry);
        self.forget_oldest();
    }

    fn forget_oldest(&mut self) {
        while self.size_bytes > self.most_bytes {
            let oldest = self.undo.pop_front().or_else(|| (!self.redo.is_empty()).then(|| self.redo.remove(0)));
            let Some(oldest) = oldest else { break };
            self.size_bytes -= oldest.size_bytes();
            // It may have been the one that others were joined to.
            self.joined = self.joined.take().filter(|_| !self.undo.is_empty());
        }
    }
}
