//! Which page of a scene lies in which slot, and which makes room: that which no round came to for longest.

/// Pages and slots.
pub struct Slots {
    /// The slot of each page, 0 where it has none.
    of_pages: Vec<u32>,
    /// For each slot its page and the last round that came to it. The first one holds no page.
    slots: Vec<Option<Held>>,
    round: u64,
}

#[derive(Clone, Copy)]
struct Held {
    page: usize,
    round: u64,
}

/// What a round asked for.
#[derive(Debug, PartialEq, Eq)]
pub struct Brought {
    /// Pages that it came to and did not find.
    pub wanted: usize,
    /// Those of them that got a slot.
    pub pages: Vec<(usize, usize)>,
}

impl Slots {
    /// So many pages, none of which has one of so many slots.
    pub fn new(pages: usize, slots: usize) -> Self {
        Self { of_pages: vec![0; pages], slots: vec![None; slots], round: 0 }
    }

    /// Slots, with the first one.
    pub fn len(&self) -> usize {
        self.slots.len()
    }

    /// The slot of each page, 0 where it has none.
    pub fn of_pages(&self) -> &[u32] {
        &self.of_pages
    }

    /// Ends a round that came to the pages `marked`. Those without a slot get one, free or of a page that the round did not come to, as far as
    /// there are any.
    pub fn bring(&mut self, marked: impl Iterator<Item = usize>) -> Brought {
        self.round += 1;
        let mut wanted = Vec::new();
        for page in marked {
            match &mut self.slots[self.of_pages[page] as usize] {
                Some(held) => held.round = self.round,
                None => wanted.push(page),
            }
        }
        let mut room: Vec<(u64, usize)> = (self.slots.iter().enumerate().skip(1))
            .map(|(slot, held)| (held.map_or(0, |held| held.round), slot))
            .filter(|&(round, _)| round < self.round)
            .collect();
        if room.len() > wanted.len() && !wanted.is_empty() {
            room.select_nth_unstable(wanted.len() - 1);
        }
        let pages: Vec<(usize, usize)> = wanted.iter().copied().zip(room.iter().map(|&(_, slot)| slot)).collect();
        for &(page, slot) in &pages {
            if let Some(left) = self.slots[slot].replace(Held { page, round: self.round }) {
                self.of_pages[left.page] = 0;
            }
            self.of_pages[page] = slot as u32;
        }
        Brought { wanted: wanted.len(), pages }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_round_came_to_for_longest_makes_room() {
        let mut slots = Slots::new(10, 4);
        let bring = |slots: &mut Slots, pages: &[usize]| {
            let brought = slots.bring(pages.iter().copied());
            let mut got: Vec<usize> = brought.pages.iter().map(|&(page, _)| page).collect();
            got.sort_unstable();
            (brought.wanted, got)
        };
        assert_eq!(bring(&mut slots, &[3, 4, 5]), (3, vec![3, 4, 5]));
        assert_eq!(bring(&mut slots, &[3, 5]), (0, vec![]));
        assert_eq!(bring(&mut slots, &[3, 6]), (1, vec![6]), "in the place of 4");
        assert_eq!(slots.of_pages()[4], 0);
        assert_eq!(bring(&mut slots, &[3, 7, 6]), (1, vec![7]), "in the place of 5");
        // What the round itself came to stays: there is room for no more than one.
        assert_eq!(bring(&mut slots, &[3, 6, 8, 9]), (2, vec![8]));
        assert_eq!(bring(&mut slots, &[3, 6, 8, 9]), (1, vec![]));
        let mut held: Vec<u32> = slots.of_pages().iter().copied().filter(|&slot| slot > 0).collect();
        held.sort_unstable();
        assert_eq!(held, [1, 2, 3], "each slot has one page, and none has the first");
    }
}
