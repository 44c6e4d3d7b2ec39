//! The study's question to a driver, ray by ray: is there a candidate for every box that is entered, is the closest hit of
//! an exact test right, and is that of the approximate one, which trusts the candidates and reports their centres?

use super::reference::Expected;
use super::report::Finding;
use super::shot::Answers;
use crate::method::Traversal;

/// Counts of one traversal.
pub struct Merging {
    pub traversal: Traversal,
    rays: u64,
    /// Boxes entered beyond doubt, and those that gave no candidate.
    entered: u64,
    pub missing: u64,
    rays_missing: u64,
    /// Rays whose exact closest hit is wrong.
    wrong_exact: u64,
    /// Rays whose approximate hit is another box than the first, and those among them that report a box that the ray does
    /// not touch.
    wrong_centre: u64,
    wrong_untouched: u64,
    /// Candidates that the ray does not touch, and all of them.
    untouched: u64,
    candidates: u64,
}

impl Merging {
    pub fn new(traversal: Traversal) -> Self {
        Self {
            traversal,
            rays: 0,
            entered: 0,
            missing: 0,
            rays_missing: 0,
            wrong_exact: 0,
            wrong_centre: 0,
            wrong_untouched: 0,
            untouched: 0,
            candidates: 0,
        }
    }

    /// Takes in one ray. `id` makes a box's name of the instance, unknown for candidates, and the primitive.
    pub fn look<Id: Copy + PartialEq>(
        &mut self,
        expected: &Expected<Id>,
        logged: &Answers,
        exact: &Answers,
        centre: &Answers,
        index: usize,
        id: &dyn Fn(Option<u32>, u32) -> Id,
    ) {
        self.rays += 1;
        if logged.is_whole(index) {
            let seen: Vec<Id> = logged.candidates(index).iter().map(|&primitive| id(None, primitive)).collect();
            let missing = expected.sure().filter(|box_id| !seen.contains(box_id)).count() as u64;
            self.entered += expected.sure().count() as u64;
            self.missing += missing;
            self.rays_missing += u64::from(missing > 0);
            self.candidates += seen.len() as u64;
            self.untouched += seen.iter().filter(|&&box_id| !expected.may_meet(box_id)).count() as u64;
        }
        let answer = &exact.answers[index];
        let is_right = expected.accepts_answer(answer, id(Some(answer.instance), answer.primitive));
        self.wrong_exact += u64::from(!is_right);
        let answer = &centre.answers[index];
        let hit = (answer.is_hit == 1).then(|| id(Some(answer.instance), answer.primitive));
        if !expected.accepts(hit) {
            self.wrong_centre += 1;
            self.wrong_untouched += u64::from(hit.is_some_and(|hit| !expected.may_meet(hit)));
        }
    }

    /// What was found. `missing_inset` is the number of missing candidates where the same boxes are a little smaller.
    pub fn finding(&self, missing_inset: Option<u64>) -> Finding {
        let (rays, wrong) = (self.rays, self.wrong_exact);
        let mut says = match (self.missing, missing_inset) {
            (0, _) => "every box entered is a candidate: nothing is merged".to_owned(),
            (missing, Some(0)) => format!(
                "merged: {missing} of {} boxes entered give no candidate, but all do where boxes do not touch",
                self.entered
            ),
            (missing, _) => format!("merged or lost: {missing} of {} boxes entered give no candidate", self.entered),
        };
        says += &match wrong {
            0 => ", every exact hit is right".to_owned(),
            wrong => format!(", {wrong} of {rays} exact hits are wrong"),
        };
        says += &match self.wrong_centre {
            0 => "; the study's approximate hits are right too".to_owned(),
            wrong => format!(
                "; {wrong} of {rays} of the study's approximate hits are wrong, {} of them boxes that the ray does not touch",
                self.wrong_untouched
            ),
        };
        Finding::judged(self.traversal, rays, wrong.max(self.rays_missing), says)
            .with("boxes entered", self.entered)
            .with("missing candidates", self.missing)
            .with("rays with missing candidates", self.rays_missing)
            .with("exact hits wrong", wrong)
            .with("approximate hits wrong", self.wrong_centre)
            .with("approximate hits on boxes not touched", self.wrong_untouched)
            .with("candidates", self.candidates)
            .with("false candidates", self.untouched)
    }
}
