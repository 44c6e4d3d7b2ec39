//! Free places of an array, by size: a place that is given back is taken again by what is as large, or by something smaller, which leaves
//! the rest free. Neighbours that are free are joined only where the array would have to grow otherwise, and not often then.

/// Which places of an array are free. Places and sizes count units: words, records of two words, nodes of 64 cells.
#[derive(Clone, Debug)]
pub(super) struct Pool {
    /// Free places of each size up to the largest one, by size − 1.
    free: Vec<Vec<u32>>,
    /// A bit for each list of `free` that may have a place.
    some: Vec<u64>,
    /// Smallest piece that is of use: what would leave less is not split.
    least: u32,
    /// Units of the array.
    end: u32,
    /// Units freed since neighbours were joined.
    freed_since: u64,
}

impl Pool {
    /// Of an array of `end` units without free places, whose pieces have `least..=largest` units.
    pub fn new(end: usize, least: u32, largest: u32) -> Self {
        Self {
            free: vec![Vec::new(); largest as usize],
            some: vec![0; largest.div_ceil(64) as usize],
            least,
            end: end as u32,
            freed_since: 0,
        }
    }

    /// Units of the array.
    pub fn end(&self) -> usize {
        self.end as usize
    }

    /// A place of `size` units; the array ends at [`Self::end`] then.
    pub fn take(&mut self, size: u32) -> u32 {
        if let Some(place) = self.take_free(size) {
            return place;
        }
        if self.freed_since > (u64::from(self.end) / 16).max(1024) {
            self.join_neighbours();
            if let Some(place) = self.take_free(size) {
                return place;
            }
        }
        let place = self.end;
        self.end += size;
        place
    }

    fn take_free(&mut self, size: u32) -> Option<u32> {
        let exact = size as usize - 1;
        let fits = |class: usize| class == exact || class as u32 - exact as u32 >= self.least;
        let mut from = exact;
        let (class, place) = loop {
            let class = self.class_from(from)?;
            match self.free[class].pop() {
                Some(place) if fits(class) => break (class, place),
                Some(place) => self.free[class].push(place),
                None => self.some[class / 64] &= !(1 << (class % 64)),
            }
            from = class + 1;
        };
        let rest = (class - exact) as u32;
        if rest > 0 {
            self.put(place + size, rest);
        }
        Some(place)
    }

    /// The first list from one on that may have a place.
    fn class_from(&self, from: usize) -> Option<usize> {
        let above = |word: usize| if word == from / 64 { u64::MAX << (from % 64) } else { u64::MAX };
        let word = (from / 64..self.some.len()).find(|&word| self.some[word] & above(word) != 0)?;
        Some(64 * word + (self.some[word] & above(word)).trailing_zeros() as usize)
    }

    /// Gives a place back.
    pub fn give(&mut self, place: u32, size: u32) {
        self.freed_since += u64::from(size);
        self.put(place, size);
    }

    fn put(&mut self, mut place: u32, mut size: u32) {
        while size > 0 {
            let piece = size.min(self.free.len() as u32);
            let class = piece as usize - 1;
            self.free[class].push(place);
            self.some[class / 64] |= 1 << (class % 64);
            place += piece;
            size -= piece;
        }
    }

    /// All free places, in order.
    pub fn places(&self) -> Vec<(u32, u32)> {
        let of_class = |(class, places): (usize, &Vec<u32>)| {
            places.iter().map(move |&place| (place, class as u32 + 1)).collect::<Vec<_>>()
        };
        let mut places: Vec<(u32, u32)> = self.free.iter().enumerate().flat_map(of_class).collect();
        places.sort_unstable();
        places
    }

    fn join_neighbours(&mut self) {
        let places = self.places();
        self.free.iter_mut().for_each(Vec::clear);
        self.freed_since = 0;
        let mut joined: Option<(u32, u32)> = None;
        for (place, size) in places {
            joined = Some(match joined {
                Some((first, length)) if first + length == place => (first, length + size),
                Some((first, length)) => {
                    self.put(first, length);
                    (place, size)
                }
                None => (place, size),
            });
        }
        if let Some((first, length)) = joined {
            self.put(first, length);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_never_overlap_and_are_used_again() {
        let mut pool = Pool::new(100, 1, 32);
        let mut held: Vec<(u32, u32)> = vec![(0, 100)];
        let mut random = 1u32;
        let mut next = |most: u32| {
            random = random.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (random >> 8) % most
        };
        for _ in 0..20_000 {
            if held.len() > 200 || held.len() > 1 && next(2) == 0 {
                let (place, size) = held.swap_remove(1 + next(held.len() as u32 - 1) as usize);
                pool.give(place, size);
            } else {
                let size = 1 + next(32);
                held.push((pool.take(size), size));
            }
        }
        let mut all = held.clone();
        all.extend(pool.places());
        all.sort_unstable();
        assert!(all.windows(2).all(|pair| pair[0].0 + pair[0].1 == pair[1].0), "gaps or overlaps");
        assert_eq!(all.last().map(|(place, size)| (place + size) as usize), Some(pool.end()));
        let used: u32 = held.iter().map(|(_, size)| size).sum();
        assert!(pool.end() < 2 * used as usize + 4000, "{} units for {used}", pool.end());
    }
}
