//! Two programs that were measured in turns, a report of each in every round. A round's two reports are a pair: what the machine did
//! meanwhile met both. The verdict follows the rules of two reports, by the ratios of the rounds in which the machine was quiet.

use super::{BAND, Outcome, differing_settings, disturbance, judge, key, label, name, obstacle, text};
use crate::numbers::{FEWEST_ROUNDS, ratio_of_rounds};
use serde_json::{Value, json};

/// What to do where the machine was not quiet.
const ADVICE: &str = "Measure again while nothing else runs, or in more --rounds.\n";

/// Two programs side by side.
pub struct Duel {
    /// The programs, and what they say of themselves.
    names: [String; 2],
    rounds: usize,
    cells: Vec<CellRounds>,
    alone: Vec<String>,
}

/// One cell of one scene in all rounds.
struct CellRounds {
    scene: String,
    cell: String,
    /// Median milliseconds in each round.
    ms: Vec<[Option<f64>; 2]>,
    /// Rounds in which the machine was quiet.
    quiet: usize,
    /// B's time over A's, and where it lies with a certainty of 95 %.
    ratio: Option<f64>,
    interval: Option<[f64; 2]>,
    outcome: Outcome,
    /// Why it cannot be compared, or there is no verdict.
    why: Option<String>,
}

impl Duel {
    /// Compares the reports of rounds, A's and B's.
    pub(crate) fn of(programs: [String; 2], rounds: &[[Value; 2]]) -> Self {
        let cells = |json: &Value| json["cells"].as_array().cloned().unwrap_or_default();
        let [a, b] = rounds.first().map_or_else(Default::default, |pair| pair.each_ref().map(cells));
        let is_in = |cells: &[Value], cell: &Value| cells.iter().any(|other| key(other) == key(cell));
        let (both, ours): (Vec<_>, Vec<_>) = a.iter().partition(|cell| is_in(&b, cell));
        let theirs = b.iter().filter(|cell| !is_in(&a, cell));
        let alone = ours.into_iter().map(|cell| format!("only in A: {}", label(cell)));
        let alone = alone.chain(theirs.map(|cell| format!("only in B: {}", label(cell)))).collect();
        let named = |side: usize| {
            let said = rounds.first().map_or_else(String::new, |pair| format!(" ({})", name(&pair[side])));
            format!("{}{said}", programs[side])
        };
        let cells = both.into_iter().map(|cell| CellRounds::of(cell, rounds)).collect();
        Self { names: [0, 1].map(named), rounds: rounds.len(), cells, alone }
    }

    /// The result in one line.
    fn summary(&self) -> String {
        if self.rounds == 0 {
            return "No round was measured to its end.".into();
        }
        let outcomes: Vec<Outcome> = self.cells.iter().map(|cell| cell.outcome).collect();
        super::summary(&outcomes)
    }

    /// Every cell, for people.
    pub fn text(&self) -> String {
        let number = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.3}"));
        let mut text = format!("A: {}\nB: {}\n{} rounds in turns\n\n", self.names[0], self.names[1], self.rounds);
        if self.rounds == 0 {
            return format!("{text}{}\n", self.summary());
        }
        text += &format!(
            "{:<16} {:<22} {:>10} {:>10} {:>7} {:>16} {:>6}  {}\n",
            "scene", "cell", "A ms", "B ms", "B / A", "95 %", "quiet", "outcome"
        );
        for cell in &self.cells {
            let interval = cell.interval.map_or("-".into(), |[low, high]| format!("{low:.3} to {high:.3}"));
            let why = cell.why.as_ref().map_or(String::new(), |why| format!(": {why}"));
            text += &format!(
                "{:<16} {:<22} {:>10} {:>10} {:>7} {interval:>16} {:>6}  {}{why}\n",
                cell.scene,
                cell.cell,
                number(cell.middle(0)),
                number(cell.middle(1)),
                number(cell.ratio),
                format!("{}/{}", cell.quiet, self.rounds),
                cell.outcome.name(),
            );
        }
        for line in &self.alone {
            text += &format!("{line}\n");
        }
        let is_disturbed = self.cells.iter().any(|cell| cell.outcome == Outcome::Disturbed);
        format!("{text}\n{}\n{}", self.summary(), if is_disturbed { ADVICE } else { "" })
    }

    /// Every cell, for programs.
    pub fn json(&self) -> Value {
        let cell = |cell: &CellRounds| {
            json!({
                "scene": cell.scene, "cell": cell.cell, "median_ms": cell.ms, "quiet_rounds": cell.quiet,
                "ratio": cell.ratio, "ratio_95": cell.interval, "outcome": cell.outcome.name(), "why": cell.why,
            })
        };
        json!({
            "a": self.names[0], "b": self.names[1], "rounds": self.rounds, "summary": self.summary(), "band": BAND,
            "cells": self.cells.iter().map(cell).collect::<Vec<_>>(), "alone": self.alone,
        })
    }
}

impl CellRounds {
    /// One cell of the reports of all rounds.
    fn of(first: &Value, rounds: &[[Value; 2]]) -> Self {
        let own = |report: &Value| {
            let cells = report["cells"].as_array();
            cells.into_iter().flatten().find(|cell| key(cell) == key(first)).cloned().unwrap_or_default()
        };
        let (mut ms, mut all, mut quiet, mut loud, mut in_the_way) = (Vec::new(), Vec::new(), Vec::new(), None, None);
        for [a, b] in rounds {
            let (ours, theirs) = (own(a), own(b));
            let settings = differing_settings(a, b);
            in_the_way = in_the_way.or_else(|| obstacle((a, &ours), (b, &theirs), settings.as_deref()));
            let medians = [&ours, &theirs].map(|cell| cell["ms"]["median"].as_f64());
            ms.push(medians);
            let Some(ratio) = medians[0].zip(medians[1]).map(|(a, b)| b / a) else { continue };
            all.push(ratio);
            match disturbance(&ours, &theirs) {
                None => quiet.push(ratio),
                Some((_, why)) => loud = loud.or(Some(why)),
            }
        }
        // Where it was quiet half of the time, these rounds alone count; else all are shown, and nothing is judged.
        let is_quiet = quiet.len() >= FEWEST_ROUNDS.min(rounds.len()) && quiet.len() * 2 >= rounds.len();
        let counted = ratio_of_rounds(if is_quiet { &quiet } else { &all });
        let (ratio, interval) = counted.filter(|_| in_the_way.is_none()).unzip();
        let interval = interval.flatten();
        let (outcome, why) = match (in_the_way, loud) {
            (Some(why), _) => (Outcome::Incomparable, Some(why)),
            (None, Some(why)) if !is_quiet => (Outcome::Disturbed, Some(why)),
            _ if interval.is_none() => (Outcome::Unknown, Some(format!("it takes {FEWEST_ROUNDS} rounds"))),
            _ => (judge(ratio, interval), None),
        };
        let (scene, cell) = (text(&first["scene"]), text(&first["cell"]));
        Self { scene, cell, ms, quiet: quiet.len(), ratio, interval, outcome, why }
    }

    /// The median of the medians of A or B, as they are shown.
    fn middle(&self, side: usize) -> Option<f64> {
        let mut ms: Vec<f64> = self.ms.iter().filter_map(|pair| pair[side]).collect();
        ms.sort_by(f64::total_cmp);
        ms.get(ms.len() / 2).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::tests::report;

    /// Rounds in which A takes 10 ms, more or less, and B so many times as long.
    fn rounds(ratio: f64, spread: f64) -> Vec<[Value; 2]> {
        let drift = [1.0, 1.3, 0.9, 1.1, 1.7];
        let noise = [0.5, -1.0, 0.0, 1.0, -0.5];
        let pair = |(drift, noise): (&f64, &f64)| {
            let a = 10.0 * drift;
            [report([a, 20.0]), report([a * ratio * (1.0 + noise * spread), 20.0])]
        };
        drift.iter().zip(&noise).map(pair).collect()
    }

    fn duel(rounds: &[[Value; 2]]) -> Duel {
        Duel::of(["this".into(), "other".into()], rounds)
    }

    #[test]
    fn what_drifts_from_round_to_round_meets_both_and_a_planted_difference_is_found() {
        for (ratio, wanted) in
            [(1.0, Outcome::Equal), (1.015, Outcome::Equal), (1.1, Outcome::Slower), (0.9, Outcome::Faster)]
        {
            let duel = duel(&rounds(ratio, 0.005));
            let cell = &duel.cells[0];
            assert_eq!((cell.outcome, cell.quiet), (wanted, 5), "{ratio}: {:?} {:?}", cell.ratio, cell.interval);
            assert!((cell.ratio.unwrap() / ratio - 1.0).abs() < 0.005);
            let [low, high] = cell.interval.unwrap();
            assert!(low < ratio && ratio < high && high - low < 0.05);
            assert_eq!(duel.cells[1].outcome, Outcome::Equal);
        }
        assert_eq!(duel(&rounds(1.1, 0.2)).cells[0].outcome, Outcome::Equal, "the interval is wide");
        assert_eq!(duel(&rounds(1.1, 0.005)[..2]).cells[0].outcome, Outcome::Unknown);
        assert!(duel(&[]).text().ends_with("No round was measured to its end.\n"));
        assert_eq!(duel(&rounds(1.1, 0.0)).summary(), "Of 2 cells: 1 equal within noise, 1 B is slower.");
    }

    #[test]
    fn rounds_in_which_the_machine_was_not_quiet_do_not_count_and_where_most_were_not_there_is_no_verdict() {
        let mut loud = rounds(1.2, 0.005);
        let mut disturb = |round: usize, side: usize| {
            loud[round][side]["cells"][0]["disturbance"] = "threads waited 41 % of the time".into();
            loud[round][side]["cells"][0]["ms"]["median"] = 77.0.into();
            let duel = duel(&loud);
            (duel.cells[0].outcome, duel.cells[0].quiet, duel.cells[0].ratio, duel.text())
        };
        let (outcome, quiet, ratio, _) = disturb(0, 1);
        assert_eq!((outcome, quiet), (Outcome::Slower, 4));
        assert!((ratio.unwrap() - 1.2).abs() < 0.01, "{ratio:?}");
        assert_eq!(disturb(3, 0).0, Outcome::Slower);
        let (outcome, quiet, ratio, text) = disturb(4, 0);
        assert_eq!((outcome, quiet), (Outcome::Disturbed, 2));
        assert!(
            ratio.is_some() && text.contains("no verdict: the machine was not quiet (B: threads waited 41 %"),
            "{text}"
        );
        assert!(text.ends_with(ADVICE));
    }

    #[test]
    fn other_scenes_and_settings_are_not_compared_and_what_one_has_alone_is_named() {
        let mut other = rounds(1.2, 0.0);
        other[3][1]["settings"]["width"] = 11.into();
        let found = duel(&other);
        assert_eq!((found.cells[0].outcome, found.cells[0].ratio), (Outcome::Incomparable, None));
        assert!(found.cells[0].why.as_ref().unwrap().contains("width (10, 11)"));
        let mut alone = rounds(1.2, 0.0);
        for pair in &mut alone {
            pair[1]["cells"][1]["cell"] = "query:brick".into();
        }
        assert_eq!(duel(&alone).alone, ["only in A: city cpu", "only in B: city query:brick"]);
        assert_eq!(duel(&alone).json()["cells"][0]["median_ms"].as_array().map(Vec::len), Some(5));
    }
}
