//! What something that is done again and again spends its time on: the turns of the window, the frames that are drawn.

use std::fmt::{Display, Formatter};
use std::time::{Duration, Instant};

/// Longer than this is felt.
pub const FELT: Duration = Duration::from_millis(50);

/// Times of rounds that consist of named phases.
#[derive(Clone, Debug)]
pub struct Phases {
    /// Each phase of the round under way.
    round: Vec<(&'static str, Duration)>,
    begun: Instant,
    lap: Instant,
    /// Rounds that are over, and those that were felt.
    rounds: u64,
    felt: u64,
    /// Each phase, its longest time and its time in all.
    phases: Vec<(&'static str, Duration, Duration)>,
    /// The longest round and its phases.
    longest: (Duration, Vec<(&'static str, Duration)>),
}

impl Default for Phases {
    fn default() -> Self {
        let now = Instant::now();
        let longest = (Duration::ZERO, Vec::new());
        Self { round: Vec::new(), begun: now, lap: now, rounds: 0, felt: 0, phases: Vec::new(), longest }
    }
}

impl Phases {
    /// A round begins.
    pub fn begin(&mut self) {
        self.round.clear();
        self.begun = Instant::now();
        self.lap = self.begun;
    }

    /// What went by since the round began, or since the last call, was `phase`.
    pub fn lap(&mut self, phase: &'static str) {
        let now = Instant::now();
        let time = now.duration_since(self.lap);
        self.lap = now;
        match self.round.iter_mut().find(|(name, _)| *name == phase) {
            Some((_, sum)) => *sum += time,
            None => self.round.push((phase, time)),
        }
    }

    /// The round is over; what is left of it was `phase`.
    pub fn end(&mut self, phase: &'static str) {
        self.lap(phase);
        let time = self.lap.duration_since(self.begun);
        self.rounds += 1;
        self.felt += u64::from(time > FELT);
        for &(name, time) in &self.round {
            match self.phases.iter_mut().find(|(known, ..)| *known == name) {
                Some((_, longest, sum)) => (*longest, *sum) = ((*longest).max(time), *sum + time),
                None => self.phases.push((name, time, time)),
            }
        }
        if time > self.longest.0 {
            self.longest = (time, self.round.clone());
        }
    }

    /// Rounds so far, those that were felt, and the longest.
    pub fn summary(&self) -> (u64, u64, Duration) {
        (self.rounds, self.felt, self.longest.0)
    }
}

impl Display for Phases {
    fn fmt(&self, f: &mut Formatter) -> std::fmt::Result {
        let ms = |time: Duration| time.as_secs_f64() * 1e3;
        write!(f, "{} over {:.0} ms, the longest {:.1} ms", self.felt, ms(FELT), ms(self.longest.0))?;
        for (index, &(name, time)) in self.longest.1.iter().enumerate() {
            write!(f, "{}{name} {:.1}", if index == 0 { " (" } else { ", " }, ms(time))?;
        }
        f.write_str(if self.longest.1.is_empty() { "" } else { ")" })?;
        for &(name, longest, sum) in &self.phases {
            let mean = ms(sum) / self.rounds.max(1) as f64;
            write!(f, "\n  {name:<10} mean {mean:7.2} ms, longest {:7.1} ms", ms(longest))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_round_says_what_it_was_spent_on() {
        let mut phases = Phases::default();
        for pause in [0, 60, 0] {
            phases.begin();
            phases.lap("events");
            std::thread::sleep(Duration::from_millis(pause));
            phases.lap("drawing");
            phases.lap("events");
            phases.end("rest");
        }
        let (rounds, felt, longest) = phases.summary();
        // A slow machine may take long for all of them.
        assert!(rounds == 3 && felt >= 1 && longest >= Duration::from_millis(60));
        assert_eq!(phases.longest.1.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["events", "drawing", "rest"]);
        assert!(phases.to_string().contains("drawing"));
    }
}
