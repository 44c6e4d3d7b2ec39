//! Key frames of a .vox file. Between two of a transform node (`_f`) its translation moves evenly from one to the other, and its rotation
//! stays that of the first; a shape node shows a model until its next key frame. With `_loop` the frames from the first key to the last, both
//! included, come again and again. (The format text names the keys alone; this is what readers of it agree on.)
//!
//! Nodes on one way down the graph have key frames of their own. A [`Timeline`] joins them: a list of events, between which everything moves
//! evenly or not at all, and the frames that come again. Where something begins, things stand in whole voxels, so that any timeline can be
//! written as the key frames of one node.

use super::rotation::Rotation;
use glam::DVec3;
use std::ops::Range;

/// Most frames that a timeline lasts before it comes again: where loops of different lengths meet later than this, the rest is left out.
const MOST_FRAMES: u64 = 10_000;

/// A rotation and a translation in voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Done first.
    pub rotation: Rotation,
    /// Done last.
    pub translation: DVec3,
}

impl Placement {
    const IDENTITY: Self = Self { rotation: Rotation::IDENTITY, translation: DVec3::ZERO };

    /// `self` after `first`.
    pub fn after(&self, first: &Self) -> Self {
        let turned: DVec3 = self.rotation.apply(first.translation.to_array()).into();
        Self { rotation: self.rotation.after(first.rotation), translation: self.translation + turned }
    }
}

/// Key frames by rising frame number, at least one, and whether they come again.
#[derive(Clone, Debug)]
pub struct Track<T> {
    keys: Vec<(u32, T)>,
    loops: bool,
}

impl<T: Copy> Track<T> {
    /// From key frames in the order of the file; of two with the same number the later one holds. `None` without any.
    pub fn new(mut keys: Vec<(u32, T)>, loops: bool) -> Option<Self> {
        keys.sort_by_key(|&(frame, _)| frame);
        keys.reverse();
        keys.dedup_by_key(|&mut (frame, _)| frame);
        keys.reverse();
        (!keys.is_empty()).then_some(Self { loops: loops && keys.len() > 1, keys })
    }

    /// Number of key frames.
    pub fn len(&self) -> usize {
        self.keys.len()
    }

    fn first(&self) -> u64 {
        self.keys[0].0.into()
    }

    fn last(&self) -> u64 {
        self.keys[self.keys.len() - 1].0.into()
    }

    /// Frames of the loop, 1 where there is none.
    fn period(&self) -> u64 {
        if self.loops { self.last() - self.first() + 1 } else { 1 }
    }

    /// The frame of the track that is shown at a frame of the file.
    fn local(&self, frame: u64) -> u64 {
        if self.loops && frame > self.last() { self.first() + (frame - self.first()) % self.period() } else { frame }
    }

    /// The key that holds from a frame of the track on.
    fn key(&self, local: u64) -> usize {
        self.keys.partition_point(|&(key, _)| u64::from(key) <= local).saturating_sub(1)
    }

    /// Frames below `end` at which something begins.
    fn events(&self, end: u64, events: &mut Vec<u64>) {
        let keys = self.keys.iter().map(|&(key, _)| u64::from(key)).filter(|_| self.keys.len() > 1);
        if !self.loops {
            return events.extend(keys.filter(|&key| key < end));
        }
        let (period, most) = (self.period(), MOST_FRAMES as usize);
        for key in keys {
            events.extend((key..end).step_by(period as usize).take(most));
        }
    }
}

impl Track<Placement> {
    /// Placement `further` frames after `frame`, as long as nothing of the track begins between them.
    fn at(&self, frame: u64, further: u64) -> Placement {
        let local = self.local(frame);
        let (key, value) = self.keys[self.key(local)];
        let Some(&(next, to)) = self.keys.get(self.key(local) + 1).filter(|_| local >= self.first()) else {
            return value;
        };
        let share = (local + further - u64::from(key)) as f64 / f64::from(next - key);
        Placement { translation: value.translation.lerp(to.translation, share), ..value }
    }
}

/// The transform nodes on the way down to a node: those above the first one that moves are multiplied.
#[derive(Clone, Debug)]
pub struct Way {
    still: Placement,
    moving: Vec<Track<Placement>>,
}

impl Default for Way {
    fn default() -> Self {
        Self { still: Placement::IDENTITY, moving: Vec::new() }
    }
}

impl Way {
    /// The way, one node longer.
    pub fn with(&self, own: Track<Placement>) -> Self {
        let mut longer = self.clone();
        match own.keys[..] {
            [(_, value)] if self.moving.is_empty() => longer.still = self.still.after(&value),
            _ => longer.moving.push(own),
        }
        longer
    }

    /// Nodes from the first one on that moves.
    pub fn moving(&self) -> usize {
        self.moving.len()
    }

    /// In whole voxels, as a node says it.
    fn at(&self, frame: u64, further: u64) -> Placement {
        let placed = self.moving.iter().fold(self.still, |above, track| above.after(&track.at(frame, further)));
        Placement { translation: placed.translation.round(), ..placed }
    }
}

/// Something that begins.
pub struct Event {
    /// Number of the frame.
    pub frame: u32,
    /// The model that is shown from then on.
    pub model: usize,
    /// Where it is then.
    pub placement: Placement,
    /// Where it has moved when the next event comes.
    pub end: Placement,
}

/// What a shape shows, and where, over time.
pub struct Timeline<'w> {
    way: &'w Way,
    models: &'w Track<usize>,
    events: Vec<u64>,
    /// Frames that come again.
    cycle: Option<Range<u64>>,
}

impl<'w> Timeline<'w> {
    /// The timeline of a shape at the end of a way.
    pub fn of(way: &'w Way, models: &'w Track<usize>) -> Self {
        let once = way.moving.iter().filter(|track| !track.loops).map(|track| (track.len(), track.last()));
        let once = once.chain((!models.loops).then(|| (models.len(), models.last())));
        let settled = once.filter(|&(keys, _)| keys > 1).map(|(_, last)| last).max().unwrap_or(0);
        let periods = way.moving.iter().map(Track::period).chain([models.period()]);
        let period = periods.fold(1, |all, period| match all == 0 || period == 0 {
            true => 1,
            false => (all / gcd(all, period)).saturating_mul(period),
        });
        let loops = models.loops || way.moving.iter().any(|track| track.loops);
        let start = way.moving.iter().filter(|track| track.loops).map(Track::first);
        let start = start.chain(models.loops.then(|| models.first())).max().unwrap_or(0).max(settled);
        let end = start.saturating_add(period);
        let cycle = (loops && period <= MOST_FRAMES).then_some(start..end);
        let end = if loops { end.min(start.saturating_add(MOST_FRAMES)) } else { u64::MAX };
        let mut events = Vec::new();
        way.moving.iter().for_each(|track| track.events(end, &mut events));
        models.events(end, &mut events);
        events.sort_unstable();
        events.dedup();
        if events.is_empty() {
            events.push(0);
        }
        Self { way, models, events, cycle }
    }

    /// How many events there are, at least one.
    pub fn events(&self) -> usize {
        self.events.len()
    }

    /// The frames that come again and again.
    pub fn repeats(&self) -> Option<Range<u32>> {
        let Range { start, end } = self.cycle.clone()?;
        Some(u32::try_from(start).ok()?..u32::try_from(end).ok()?)
    }

    /// The events, by their time.
    pub fn iter(&self) -> impl Iterator<Item = Event> + '_ {
        let next = |index: usize| self.events.get(index + 1).copied().unwrap_or(self.events[index]);
        self.events.iter().enumerate().map(move |(index, &frame)| Event {
            frame: frame as u32,
            model: self.models.keys[self.models.key(self.models.local(frame))].1,
            placement: self.way.at(frame, 0),
            end: self.way.at(frame, next(index) - frame),
        })
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moving(keys: &[(u32, f64)], loops: bool) -> Track<Placement> {
        let key = |&(frame, x): &(u32, f64)| (frame, Placement { translation: DVec3::X * x, ..Placement::IDENTITY });
        Track::new(keys.iter().map(key).collect(), loops).unwrap()
    }

    fn events(way: &Way, models: &Track<usize>) -> Vec<(u32, usize, f64, f64)> {
        let timeline = Timeline::of(way, models);
        let number = |event: Event| (event.frame, event.model, event.placement.translation.x, event.end.translation.x);
        timeline.iter().map(number).collect()
    }

    #[test]
    fn translations_move_evenly_between_keys_and_models_stay_until_the_next() {
        let way = Way::default().with(moving(&[(0, 0.0), (8, 80.0)], false));
        let models = Track::new(vec![(0, 5), (2, 6)], false).unwrap();
        assert_eq!(events(&way, &models), [(0, 5, 0.0, 20.0), (2, 6, 20.0, 80.0), (8, 6, 80.0, 80.0)]);
        assert_eq!(Timeline::of(&way, &models).repeats(), None);
        let turned = way.with(moving(&[(0, 1.0), (4, 3.0)], false));
        assert_ne!(events(&turned, &models), events(&way, &models), "the comparison sees another node");
    }

    #[test]
    fn loops_of_different_lengths_come_again_together() {
        let way = Way::default().with(moving(&[(0, 0.0), (1, 10.0)], true));
        let models = Track::new(vec![(0, 7), (1, 8), (2, 9)], true).unwrap();
        let timeline = Timeline::of(&way, &models);
        assert_eq!(timeline.repeats(), Some(0..6));
        let shown: Vec<(u32, usize, f64)> =
            timeline.iter().map(|event| (event.frame, event.model, event.placement.translation.x)).collect();
        let expected = [(0, 7, 0.0), (1, 8, 10.0), (2, 9, 0.0), (3, 7, 10.0), (4, 8, 0.0), (5, 9, 10.0)];
        assert_eq!(shown, expected);
    }

    #[test]
    fn a_loop_goes_on_beside_what_moves_once() {
        let way = Way::default().with(moving(&[(0, 0.0), (4, 40.0)], false));
        let models = Track::new(vec![(0, 1), (1, 2)], true).unwrap();
        let timeline = Timeline::of(&way, &models);
        assert_eq!(timeline.repeats(), Some(4..6));
        let last: Vec<(u32, usize, f64)> =
            (timeline.iter().skip(4)).map(|event| (event.frame, event.model, event.placement.translation.x)).collect();
        assert_eq!(last, [(4, 1, 40.0), (5, 2, 40.0)]);
    }
}
