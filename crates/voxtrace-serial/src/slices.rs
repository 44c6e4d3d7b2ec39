//! Slices: parts of them, one after another, and sorting.

use crate::{IntoParallelIterator, Serial};
use std::cmp::Ordering;
use std::slice::{Chunks, ChunksExactMut, ChunksMut};

/// Parts of slices.
pub trait ParallelSlice<T> {
    /// Parts of `size` items, the last of what is left.
    fn par_chunks(&self, size: usize) -> Serial<Chunks<'_, T>>;
}

impl<T> ParallelSlice<T> for [T] {
    fn par_chunks(&self, size: usize) -> Serial<Chunks<'_, T>> {
        self.chunks(size).into_par_iter()
    }
}

/// Parts of slices that are written, and sorting.
pub trait ParallelSliceMut<T> {
    /// The slice itself.
    fn as_parallel_slice_mut(&mut self) -> &mut [T];

    /// Parts of `size` items, the last of what is left.
    fn par_chunks_mut(&mut self, size: usize) -> Serial<ChunksMut<'_, T>> {
        self.as_parallel_slice_mut().chunks_mut(size).into_par_iter()
    }

    /// Parts of `size` items, without what is left.
    fn par_chunks_exact_mut(&mut self, size: usize) -> Serial<ChunksExactMut<'_, T>> {
        self.as_parallel_slice_mut().chunks_exact_mut(size).into_par_iter()
    }

    /// Sorts; what is equal keeps its order.
    fn par_sort_by_key<K: Ord>(&mut self, key: impl Fn(&T) -> K) {
        sort(self.as_parallel_slice_mut(), &|a, b| key(a).cmp(&key(b)));
    }

    /// Sorts by keys that are asked for once each; what is equal keeps its order.
    fn par_sort_by_cached_key<K: Ord>(&mut self, key: impl Fn(&T) -> K) {
        let slice = self.as_parallel_slice_mut();
        let keys: Vec<K> = slice.iter().map(key).collect();
        permute(slice, order(keys.len(), &|a, b| keys[a].cmp(&keys[b])));
    }

    /// Sorts; what is equal keeps its order, as here all do.
    fn par_sort_unstable(&mut self)
    where
        T: Ord,
    {
        sort(self.as_parallel_slice_mut(), &T::cmp);
    }

    /// Sorts; what is equal keeps its order, as here all do.
    fn par_sort_unstable_by(&mut self, compare: impl Fn(&T, &T) -> Ordering) {
        sort(self.as_parallel_slice_mut(), &compare);
    }

    /// Sorts; what is equal keeps its order, as here all do.
    fn par_sort_unstable_by_key<K: Ord>(&mut self, key: impl Fn(&T) -> K) {
        self.par_sort_by_key(key);
    }
}

impl<T> ParallelSliceMut<T> for [T] {
    fn as_parallel_slice_mut(&mut self) -> &mut [T] {
        self
    }
}

fn sort<T>(slice: &mut [T], compare: &dyn Fn(&T, &T) -> Ordering) {
    let order = order(slice.len(), &|a, b| compare(&slice[a], &slice[b]));
    permute(slice, order);
}

/// Where the items of a sorted slice are now. Sorting is some kilobytes of code for each type and order; this is there once.
#[inline(never)]
fn order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

/// Puts the item of each place that `order` names, all of them once, at its place in `order`.
fn permute<T>(slice: &mut [T], mut order: Vec<usize>) {
    for first in 0..order.len() {
        let mut at = first;
        loop {
            let from = std::mem::replace(&mut order[at], at);
            if from == first {
                break;
            }
            slice.swap(at, from);
            at = from;
        }
    }
}
