//! What clicks and keys do while something is measured, and what is kept of it.

use super::file::MeasureFile;
use super::snap::snapped;
use super::{Flood, Kind, Measure, Snapped, csv};
use crate::kept_file::KeptError;
use crate::keys::Gesture;
use crate::navigation::Motion;
use crate::projection::Projection;
use crate::scale::Scale;
use crate::session::Session;
use crate::tr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use voxtrace::glam::{DVec3, Vec2};
use voxtrace_core::atomic_file::write_atomically;

/// Pixels within which a click on a point that is there already ends a path or an area.
const SAME: f32 = 8.0;
/// What is shown around a measurement, as a share of its size, and in voxels at least.
const AROUND: (f64, f64) = (0.25, 4.0);

impl Session {
    /// The camera as what is drawn over the picture needs it.
    pub fn projection(&self) -> Projection {
        Projection::new(self.navigator.camera(), self.size())
    }

    /// Measures from now on, or picks again.
    pub fn toggle_measuring(&mut self) {
        let next = match self.measuring.tool {
            Some(_) => None,
            None => Some(self.measuring.last.unwrap_or(Kind::Distance)),
        };
        self.choose_tool(next);
    }

    /// Measures with the next tool.
    pub fn next_tool(&mut self) {
        let now = self.measuring.tool.or(self.measuring.last);
        self.choose_tool(Some(now.map_or(Kind::Distance, Kind::next)));
    }

    /// Measures something else from now on, or nothing any more.
    pub fn choose_tool(&mut self, tool: Option<Kind>) {
        if tool.is_some() && self.open.is_none() {
            return self.say(tr!("measure.no_scene"), false);
        }
        self.measuring.points.clear();
        self.measuring.tool = tool;
        if let Some(kind) = tool {
            self.measuring.last = tool;
            self.measuring.opens = true;
            self.say_instead(&Kind::ALL.map(hint), hint(kind));
        }
    }

    /// The point that a click would take.
    pub fn point_under(&self, cursor: Vec2) -> Option<Snapped> {
        let scene = &self.open.as_ref()?.pickable;
        let ray = self.navigator.ray(cursor);
        let hit = scene.cast(&ray)?;
        Some(snapped(scene, &ray, hit, self.measuring.snap, &self.projection(), cursor))
    }

    /// Whether a gesture belongs to what is being measured; then it did what it does there.
    pub(crate) fn measure_by(&mut self, gesture: Gesture, cursor: Option<Vec2>) -> bool {
        let (Some(kind), Some(cursor)) = (self.measuring.tool, cursor) else { return false };
        match gesture {
            Gesture::Click => self.measure_at(kind, cursor),
            Gesture::DoubleClick => self.finish_measuring(),
            _ => return false,
        }
        true
    }

    fn measure_at(&mut self, kind: Kind, cursor: Vec2) {
        let Some(found) = self.point_under(cursor) else { return self.say(tr!("measure.nothing_there"), false) };
        if kind == Kind::Component {
            if let Some(open) = &self.open {
                let scene = Arc::clone(&open.pickable);
                self.measuring.flood = Some(Flood::start(scene, found.hit, found.point, self.measuring.by_material));
            }
            return;
        }
        let projection = self.projection();
        let is_same = |point: Option<&DVec3>| {
            let place = point.and_then(|point| projection.place(point.as_vec3()));
            place.is_some_and(|place| place.distance(cursor) <= SAME)
        };
        let points = &self.measuring.points;
        let (least, most) = kind.points();
        if most.is_none() && points.len() >= least && (is_same(points.last()) || is_same(points.first())) {
            return self.finish_measuring();
        }
        if points.last() == Some(&found.point) {
            return;
        }
        self.measuring.points.push(found.point);
        if most == Some(self.measuring.points.len()) {
            self.finish_measuring();
        }
    }

    /// Ends a measurement that has as many points as it needs.
    pub fn finish_measuring(&mut self) {
        let Some(kind) = self.measuring.tool else { return };
        if kind == Kind::Component || self.measuring.points.len() < kind.points().0 {
            return;
        }
        let points = std::mem::take(&mut self.measuring.points);
        self.keep_measure(kind, points, None);
    }

    /// Stops counting, drops the points of what is under way, or ends measuring: the first of these that there is. Returns whether one was.
    pub(crate) fn cancel_measuring(&mut self) -> bool {
        if self.measuring.flood.take().is_some() {
            self.say(tr!("measure.stopped"), false);
            return true;
        }
        if !self.measuring.points.is_empty() {
            self.measuring.points.clear();
            return true;
        }
        self.measuring.tool.take().is_some()
    }

    /// Takes what was counted on the thread, once it is there.
    pub fn take_component(&mut self) {
        let Some(result) = self.measuring.flood.as_ref().and_then(Flood::take) else { return };
        let point = self.measuring.flood.take().map(|flood| flood.point);
        match (result, point) {
            (Ok(component), Some(point)) => self.keep_measure(Kind::Component, vec![point], Some(component)),
            (Err(error), _) => self.say(error, true),
            _ => {}
        }
    }

    fn keep_measure(&mut self, kind: Kind, points: Vec<DVec3>, component: Option<super::Component>) {
        let of_kind = self.measuring.list.values().filter(|measure| measure.kind == kind).count();
        let name = format!("{} {}", kind_name(kind), of_kind + 1);
        let number = self.keep(Measure { name, is_hidden: false, kind, points, component });
        self.measuring.selected = Some(number);
    }

    /// Keeps a measurement, in the file too where there is one. Returns its number.
    fn keep(&mut self, measure: Measure) -> u32 {
        self.make_kept_folder();
        let next = self.measuring.list.keys().next_back().map_or(1, |last| last.saturating_add(1));
        let number = self.kept(|file| file.store(None, &measure)).unwrap_or(next);
        self.measuring.list.insert(number, measure);
        number
    }

    /// Changes one that was measured, in the file too.
    pub fn change_measure(&mut self, number: u32, change: impl FnOnce(&mut Measure)) {
        let Some(measure) = self.measuring.list.get_mut(&number) else { return };
        change(measure);
        let measure = measure.clone();
        self.kept(|file| file.store(Some(number), &measure));
    }

    /// Forgets one that was measured, in the file too.
    pub fn delete_measure(&mut self, number: u32) {
        if self.measuring.list.remove(&number).is_some() {
            self.kept(|file| file.remove(number));
        }
        self.measuring.selected = self.measuring.selected.filter(|own| *own != number);
    }

    /// Shows one that was measured.
    pub fn show_measure(&mut self, number: u32) {
        let Some((min, max)) = self.measuring.list.get(&number).and_then(Measure::bounds) else { return };
        let around = ((max - min).max_element() * AROUND.0).max(AROUND.1);
        self.measuring.selected = Some(number);
        self.move_by(Motion::Frame { min: (min - around).as_vec3(), max: (max + around).as_vec3() });
    }

    /// Writes all of them as CSV beside the scene, under the next name that is free.
    pub fn export_measures(&mut self) {
        let (Some(open), Some(file)) = (&self.open, &self.measuring.file) else { return };
        let text = csv::csv(self.measuring.list.values(), &Scale::of(&open.original));
        let path = free_csv(file.path());
        let text = match write_atomically(&path, |file| file.write_all(text.as_bytes())) {
            Ok(()) => (tr!("measure.exported", path = path.display()), false),
            Err(error) => (tr!("measure.not_exported", path = path.display(), error = error), true),
        };
        self.say(text.0, text.1);
    }

    /// Reads what was measured of the scene that was opened.
    pub(crate) fn load_measures(&mut self) {
        self.measuring = super::Measuring {
            snap: self.measuring.snap,
            by_material: self.measuring.by_material,
            last: self.measuring.last,
            ..Default::default()
        };
        let Some(open) = &self.open else { return };
        let scale = Scale::of(&open.original);
        self.measuring.file = self.beside_scene("measurements.toml").map(|path| MeasureFile::new(path, scale));
        self.measuring.list = self.kept(MeasureFile::read).unwrap_or_default();
    }

    /// A scene that had no file has one now: what was measured before is kept beside it, too, after what is there.
    pub(crate) fn keep_measures(&mut self) {
        let Some(open) = &self.open else { return };
        let scale = Scale::of(&open.original);
        self.measuring.file = self.beside_scene("measurements.toml").map(|path| MeasureFile::new(path, scale));
        let there = self.kept(MeasureFile::read).unwrap_or_default();
        let measured = std::mem::replace(&mut self.measuring.list, there);
        (self.measuring.selected, self.measuring.typed) = (None, None);
        for measure in measured.into_values() {
            self.keep(measure);
        }
    }

    /// The scene is about to be shown with other voxels: what was measured stays in its place, and is as large as it was.
    pub(crate) fn measure_in(&mut self, scene: &voxtrace::PackedScene) {
        let Some(open) = &self.open else { return };
        let (old, new) = (Scale::of(&open.original), Scale::of(scene));
        if old == new {
            return;
        }
        let new_from_old = new.world_from_other(&old);
        let measuring = &mut self.measuring;
        measuring.list.values_mut().for_each(|measure| measure.transform(&new_from_old));
        measuring.points.iter_mut().for_each(|point| *point = new_from_old.transform_point3(*point));
        // What it counts are voxels that go.
        measuring.flood = None;
        measuring.file = measuring.file.take().map(|file| MeasureFile::new(file.path().to_path_buf(), new));
    }

    /// Does something with the file; says what goes wrong.
    fn kept<T>(&mut self, work: impl FnOnce(&MeasureFile) -> Result<T, KeptError>) -> Option<T> {
        let file = self.measuring.file.as_ref()?;
        match work(file) {
            Ok(done) => Some(done),
            Err(error) => {
                self.say(error.to_string(), true);
                None
            }
        }
    }
}

/// `church.measurements.csv`, or with the first number that is free.
fn free_csv(file: &Path) -> PathBuf {
    let plain = file.with_extension("csv");
    let stem = plain.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let numbered = (2..).map(|number: u32| plain.with_file_name(format!("{stem}-{number}.csv")));
    std::iter::once(plain.clone()).chain(numbered).find(|path| !path.exists()).unwrap_or(plain)
}

/// The name of a kind, for people.
pub fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Distance => tr!("measure.distance"),
        Kind::Height => tr!("measure.height"),
        Kind::Angle => tr!("measure.angle"),
        Kind::Path => tr!("measure.path"),
        Kind::Area => tr!("measure.area"),
        Kind::Component => tr!("measure.component"),
    }
}

/// What to do with a tool.
fn hint(kind: Kind) -> &'static str {
    match kind {
        Kind::Distance | Kind::Height => tr!("measure.hint_two"),
        Kind::Angle => tr!("measure.hint_angle"),
        Kind::Path => tr!("measure.hint_path"),
        Kind::Area => tr!("measure.hint_area"),
        Kind::Component => tr!("measure.hint_component"),
    }
}
