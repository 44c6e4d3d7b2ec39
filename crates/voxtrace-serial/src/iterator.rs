//! Iterators: those of the standard library under rayon's names. They are methods of a type, since a trait's would be ambiguous beside `Iterator`'s.

use std::iter;

/// An iterator whose methods are rayon's.
#[derive(Clone, Debug)]
pub struct Serial<I>(I);

impl<I: Iterator> IntoIterator for Serial<I> {
    type Item = I::Item;
    type IntoIter = I;

    fn into_iter(self) -> I {
        self.0
    }
}

/// `into_par_iter` of all that is an iterator or becomes one.
pub trait IntoParallelIterator: IntoIterator + Sized {
    /// Its items, one after another.
    fn into_par_iter(self) -> Serial<Self::IntoIter> {
        Serial(self.into_iter())
    }
}
impl<T: IntoIterator> IntoParallelIterator for T {}

/// `par_iter` of all whose references are iterators.
pub trait IntoParallelRefIterator<'a> {
    /// Iterator of references.
    type Iter;
    /// References to its items, one after another.
    fn par_iter(&'a self) -> Serial<Self::Iter>;
}
impl<'a, T: ?Sized + 'a> IntoParallelRefIterator<'a> for T
where
    &'a T: IntoIterator,
{
    type Iter = <&'a T as IntoIterator>::IntoIter;

    fn par_iter(&'a self) -> Serial<Self::Iter> {
        Serial(self.into_iter())
    }
}

/// `par_iter_mut` of all whose mutable references are iterators.
pub trait IntoParallelRefMutIterator<'a> {
    /// Iterator of mutable references.
    type Iter;
    /// Mutable references to its items, one after another.
    fn par_iter_mut(&'a mut self) -> Serial<Self::Iter>;
}
impl<'a, T: ?Sized + 'a> IntoParallelRefMutIterator<'a> for T
where
    &'a mut T: IntoIterator,
{
    type Iter = <&'a mut T as IntoIterator>::IntoIter;

    fn par_iter_mut(&'a mut self) -> Serial<Self::Iter> {
        Serial(self.into_iter())
    }
}

/// `par_extend` of all that `extend`.
pub trait ParallelExtend<T> {
    /// Adds the items at the end.
    fn par_extend<I: IntoIterator<Item = T>>(&mut self, items: I);
}
impl<T, E: Extend<T>> ParallelExtend<T> for E {
    fn par_extend<I: IntoIterator<Item = T>>(&mut self, items: I) {
        self.extend(items);
    }
}

// How much a thread is given at least or at most: nothing here.
#[allow(missing_docs)]
impl<I: Iterator> Serial<I> {
    pub fn with_min_len(self, _: usize) -> Self {
        self
    }

    pub fn with_max_len(self, _: usize) -> Self {
        self
    }
}

// Adaptors and consumers that the standard library has under the same names.
#[allow(missing_docs)]
impl<I: Iterator> Serial<I> {
    pub fn map<B, F: FnMut(I::Item) -> B>(self, f: F) -> Serial<iter::Map<I, F>> {
        Serial(self.0.map(f))
    }

    pub fn filter<F: FnMut(&I::Item) -> bool>(self, f: F) -> Serial<iter::Filter<I, F>> {
        Serial(self.0.filter(f))
    }

    pub fn filter_map<B, F: FnMut(I::Item) -> Option<B>>(self, f: F) -> Serial<iter::FilterMap<I, F>> {
        Serial(self.0.filter_map(f))
    }

    pub fn enumerate(self) -> Serial<iter::Enumerate<I>> {
        Serial(self.0.enumerate())
    }

    pub fn zip<J: IntoIterator>(self, other: J) -> Serial<iter::Zip<I, J::IntoIter>> {
        Serial(self.0.zip(other))
    }

    pub fn flatten(self) -> Serial<iter::Flatten<I>>
    where
        I::Item: IntoIterator,
    {
        Serial(self.0.flatten())
    }

    pub fn collect<C: FromIterator<I::Item>>(self) -> C {
        self.0.collect()
    }

    pub fn for_each<F: FnMut(I::Item)>(self, f: F) {
        self.0.for_each(f);
    }

    pub fn count(self) -> usize {
        self.0.count()
    }

    pub fn sum<S: iter::Sum<I::Item>>(self) -> S {
        self.0.sum()
    }

    pub fn max(self) -> Option<I::Item>
    where
        I::Item: Ord,
    {
        self.0.max()
    }

    pub fn all<F: FnMut(I::Item) -> bool>(mut self, f: F) -> bool {
        self.0.all(f)
    }
}

// What rayon alone has.
#[allow(missing_docs)]
impl<I: Iterator> Serial<I> {
    pub fn flat_map_iter<U: IntoIterator, F: FnMut(I::Item) -> U>(self, f: F) -> Serial<iter::FlatMap<I, U, F>> {
        Serial(self.0.flat_map(f))
    }

    pub fn flatten_iter(self) -> Serial<iter::Flatten<I>>
    where
        I::Item: IntoIterator,
    {
        self.flatten()
    }

    pub fn map_init<T, B>(
        self,
        init: impl FnOnce() -> T,
        mut f: impl FnMut(&mut T, I::Item) -> B,
    ) -> Serial<impl Iterator<Item = B>> {
        let mut state = init();
        Serial(self.0.map(move |item| f(&mut state, item)))
    }

    pub fn for_each_init<T>(self, init: impl FnOnce() -> T, mut f: impl FnMut(&mut T, I::Item)) {
        let mut state = init();
        self.0.for_each(|item| f(&mut state, item));
    }

    pub fn fold<T>(self, identity: impl FnOnce() -> T, f: impl FnMut(T, I::Item) -> T) -> Serial<iter::Once<T>> {
        Serial(iter::once(self.0.fold(identity(), f)))
    }

    pub fn reduce(self, identity: impl FnOnce() -> I::Item, f: impl FnMut(I::Item, I::Item) -> I::Item) -> I::Item {
        self.0.fold(identity(), f)
    }

    pub fn reduce_with(self, f: impl FnMut(I::Item, I::Item) -> I::Item) -> Option<I::Item> {
        self.0.reduce(f)
    }

    pub fn find_map_first<B>(mut self, f: impl FnMut(I::Item) -> Option<B>) -> Option<B> {
        self.0.find_map(f)
    }

    pub fn find_map_any<B>(self, f: impl FnMut(I::Item) -> Option<B>) -> Option<B> {
        self.find_map_first(f)
    }

    pub fn position_first(mut self, f: impl FnMut(I::Item) -> bool) -> Option<usize> {
        self.0.position(f)
    }
}

#[allow(missing_docs)]
impl<'a, T: Copy + 'a, I: Iterator<Item = &'a T>> Serial<I> {
    pub fn copied(self) -> Serial<iter::Copied<I>> {
        Serial(self.0.copied())
    }
}

impl<T, E, I: Iterator<Item = Result<T, E>>> Serial<I> {
    /// The items joined, or the first error.
    ///
    /// # Errors
    /// That of an item, or of `f`.
    pub fn try_reduce(self, identity: impl FnOnce() -> T, mut f: impl FnMut(T, T) -> Result<T, E>) -> Result<T, E> {
        let mut all = self.0;
        all.try_fold(identity(), |sum, item| f(sum, item?))
    }
}
