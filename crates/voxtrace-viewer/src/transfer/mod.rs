//! Which values of a volume are shown, and in which colours: a curve of stops between two ends, as `--transfer` has it in one word. The volume stays in
//! memory; another curve makes other voxels of it (`shape`), coarse ones at once and all of them after.

mod shape;

pub use shape::Values;
pub(crate) use shape::with_transfer;

use voxtrace::glam::Vec3;
use voxtrace::material::{linear_color, srgb_from_linear};
use voxtrace::volume::{Preset, Ramp, Transfer, ValueStatistics};

/// Least share of the range of values that a window is wide.
const LEAST_WINDOW: f32 = 1e-4;

/// What the values of a volume are.
#[derive(Clone, Debug, PartialEq)]
pub struct ValuesSeen {
    /// Their range, threshold and kind.
    pub statistics: ValueStatistics,
    /// How many lie in each of equal parts from the least to the greatest one.
    pub histogram: Vec<u64>,
}

impl ValuesSeen {
    /// The least and the greatest value.
    pub fn range(&self) -> (f32, f32) {
        (self.statistics.lowest, self.statistics.highest)
    }

    /// The value that this share of all lies below, to a part of the histogram.
    pub fn quantile(&self, share: f64) -> f32 {
        let wanted = self.histogram.iter().sum::<u64>() as f64 * share;
        let mut sum = 0;
        let found = self.histogram.iter().position(|count| {
            sum += count;
            sum as f64 >= wanted
        });
        let (low, high) = self.range();
        low + (high - low) * found.unwrap_or(0) as f32 / self.histogram.len().max(1) as f32
    }

    /// The curve of a preset for these values; `None` where it shows labels, each in a colour of its own.
    pub fn preset(&self, preset: Preset) -> Option<ValueCurve> {
        self.curve(preset.transfer(), None)
    }

    /// The curve that is chosen where nobody chose one.
    pub fn usual(&self) -> Option<ValueCurve> {
        self.curve(Transfer::automatic(&self.statistics), None)
    }

    /// The curve of a scene that is read with these options. Of files, and of stops that are given in words, no more is known here than of none.
    pub fn given(&self, options: &[String]) -> Option<ValueCurve> {
        let value = |name: &str| {
            let of = |(index, option): (usize, &String)| match option.strip_prefix(name)? {
                "" => options.get(index + 1).cloned(),
                rest => rest.strip_prefix('=').map(str::to_owned),
            };
            options.iter().enumerate().filter_map(of).next_back()
        };
        let threshold = value("--threshold").and_then(|threshold| threshold.parse().ok());
        match value("--transfer") {
            None => self.curve(Transfer::automatic(&self.statistics), threshold),
            Some(name) => match Preset::ALL.into_iter().find(|preset| preset.name() == name) {
                Some(preset) => self.curve(preset.transfer(), threshold),
                None => self.usual(),
            },
        }
    }

    /// A transfer function as a curve, with another least value where one is said.
    fn curve(&self, mut transfer: Transfer, threshold: Option<f32>) -> Option<ValueCurve> {
        transfer.resolve(&self.statistics, threshold);
        let Ramp::Absolute { low, high, stops } = transfer.ramp else { return None };
        let stops = stops.into_iter().map(|(at, color)| (at, bytes_of(color))).collect();
        let high = (high < f32::MAX).then_some(high);
        Some(ValueCurve { low, high, stops, opacity: transfer.opacity })
    }

    /// Grey from the value below which 1 % lies to that below which 99 % do.
    pub fn automatic(&self) -> ValueCurve {
        let (low, high) = (self.quantile(0.01), self.quantile(0.99));
        let (least, most) = self.range();
        let (low, high) = if high > low { (low, high) } else { (least, most) };
        // What is darkest is what surrounds the rest: air, or the dark between cells.
        let floor = self.statistics.threshold.clamp(low, high);
        ValueCurve { low: floor, high: None, stops: vec![(low, [24; 3]), (high, [250; 3])], opacity: 1.0 }
    }
}

/// A curve of colours over values.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueCurve {
    /// The least value that is shown.
    pub low: f32,
    /// The greatest one; `None`: all that are higher.
    pub high: Option<f32>,
    /// Values with their colours, sRGB, by rising value; at least one.
    pub stops: Vec<(f32, [u8; 3])>,
    /// How much of what lies behind a surface it hides, from 0 to 1.
    pub opacity: f32,
}

impl ValueCurve {
    /// The word of `--transfer`.
    pub fn word(&self) -> String {
        let stops = self.stops.iter().map(|(at, [r, g, b])| format!("{at}=#{r:02x}{g:02x}{b:02x}"));
        let mut parts: Vec<String> = stops.chain([format!("threshold={}", self.low)]).collect();
        parts.extend(self.high.map(|high| format!("upper={high}")));
        parts.extend((self.opacity < 1.0).then(|| format!("opacity={}", self.opacity)));
        format!("stops:{}", parts.join(","))
    }

    /// The same with values of no more digits than matter: those of a hundred-thousandth of the range.
    pub fn rounded(mut self, (least, most): (f32, f32)) -> Self {
        let range = f64::from(most) - f64::from(least);
        if range > 0.0 && range.is_finite() {
            let scale = 10f64.powi(5 - range.log10().floor() as i32);
            let rounded = |value: f32| ((f64::from(value) * scale).round() / scale) as f32;
            self.stops.iter_mut().for_each(|stop| stop.0 = rounded(stop.0));
            (self.low, self.high) = (rounded(self.low), self.high.map(rounded));
        }
        self
    }

    /// From where to where colours change: the window of the values.
    pub fn window(&self) -> (f32, f32) {
        (self.stops[0].0, self.stops[self.stops.len() - 1].0)
    }

    /// Moves the window: its middle is the level. The ends of what is shown go with it.
    pub fn set_window(&mut self, (from, to): (f32, f32), (least, most): (f32, f32)) {
        let (a, b) = self.window();
        let to = to.max(from + (most - least) * LEAST_WINDOW);
        let scale = if b > a { (to - from) / (b - a) } else { 1.0 };
        let moved = |value: f32| from + (value - a) * scale;
        self.stops.iter_mut().for_each(|stop| stop.0 = moved(stop.0));
        self.low = moved(self.low);
        self.high = self.high.map(moved);
    }

    /// Changes the width of the window by a factor, and its middle by so much.
    pub fn turn(&mut self, factor: f32, by: f32, range: (f32, f32)) {
        let (from, to) = self.window();
        let (level, half) = ((from + to) / 2.0 + by, (to - from) / 2.0 * factor);
        let level = level.clamp(range.0, range.1);
        self.set_window((level - half, level + half), range);
    }

    /// Moves a stop, no farther than its neighbours. Returns where it is.
    pub fn move_stop(&mut self, index: usize, value: f32) -> f32 {
        let before = index.checked_sub(1).and_then(|index| self.stops.get(index)).map_or(f32::MIN, |stop| stop.0);
        let after = self.stops.get(index + 1).map_or(f32::MAX, |stop| stop.0);
        let Some(stop) = self.stops.get_mut(index) else { return value };
        stop.0 = value.max(before).min(after);
        stop.0
    }

    /// Puts a stop at a value, in the colour that is there. Returns its number.
    pub fn add_stop(&mut self, value: f32) -> usize {
        let color = self.color_at(value);
        let index = self.stops.partition_point(|stop| stop.0 <= value);
        self.stops.insert(index, (value, color));
        index
    }

    /// The colour at a value: between stops as it is seen, not as it is computed.
    pub fn color_at(&self, value: f32) -> [u8; 3] {
        let after = self.stops.partition_point(|stop| stop.0 <= value);
        match (after.checked_sub(1).map(|before| self.stops[before]), self.stops.get(after)) {
            (Some((a, one)), Some(&(b, other))) => {
                let share = ((value - a) / (b - a).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
                bytes_of(linear_color(one).lerp(linear_color(other), share))
            }
            (Some((_, only)), None) | (None, Some(&(_, only))) => only,
            (None, None) => [204; 3],
        }
    }

    /// Whether something of the values is shown.
    pub fn shows(&self, (least, most): (f32, f32)) -> bool {
        self.low <= most && self.high.is_none_or(|high| high >= least && high >= self.low)
    }
}

/// The nearest colour of eight bits a channel, sRGB.
fn bytes_of(color: Vec3) -> [u8; 3] {
    color.to_array().map(srgb_from_linear)
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::Volume;

    fn seen() -> ValuesSeen {
        // Half air, the rest spread evenly, and one far outlier.
        let mut values = vec![-1000.0; 5000];
        values.extend((0..5000).map(|i| i as f32 * 0.4 - 200.0));
        values.push(30_000.0);
        let volume = Volume::new([values.len(), 1, 1], values);
        let statistics = volume.statistics();
        ValuesSeen { histogram: volume.histogram(statistics.lowest, statistics.highest), statistics }
    }

    #[test]
    fn presets_keep_their_colours_and_places_in_the_word_of_the_command() {
        let bone = seen().preset(Preset::CtBone).unwrap();
        assert_eq!(bone.word(), "stops:250=#c9a67c,500=#e2cea8,1200=#f3ead2,2500=#fffdf8,threshold=250");
        assert_eq!(bone.window(), (250.0, 2500.0));
        assert_eq!(seen().preset(Preset::Labels), None, "labels are no curve");
        let glassy = ValueCurve { high: Some(1e3), opacity: 0.5, ..bone };
        assert!(glassy.word().ends_with(",threshold=250,upper=1000,opacity=0.5"), "{}", glassy.word());
    }

    #[test]
    fn a_scene_has_the_curve_that_its_options_say() {
        let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let given = |text: &str| seen().given(&words(text));
        let [mri, bone] = [Preset::Mri, Preset::CtBone].map(|preset| seen().preset(preset).unwrap());
        assert_eq!(given("--transfer mri --resolution 64"), Some(mri.clone()));
        assert_eq!(given("--transfer=hot --transfer=mri"), Some(mri.clone()), "the last one counts");
        assert_ne!(Some(mri), seen().usual(), "which would be another one");
        assert_eq!(given("--threshold=300 --transfer ct-bone"), Some(ValueCurve { low: 300.0, ..bone }));
        assert_eq!(given("--resolution 64"), seen().usual());
        assert_eq!(given("--transfer mine.toml"), seen().usual());
    }

    #[test]
    fn the_automatic_ramp_leaves_out_one_percent_at_each_end() {
        let seen = seen();
        let ramp = seen.automatic();
        let (from, to) = ramp.window();
        assert!(from < -960.0 && (1700.0..1830.0).contains(&to), "{from} {to}");
        assert!(ramp.low > -900.0 && ramp.shows(seen.range()));
        let hidden = ValueCurve { low: 40_000.0, ..ramp };
        assert!(!hidden.shows(seen.range()), "nothing is as high as that");
    }

    #[test]
    fn the_window_moves_and_stretches_with_all_that_is_in_it() {
        let mut curve = seen().preset(Preset::CtBone).unwrap();
        curve.turn(2.0, 100.0, (-1000.0, 3000.0));
        assert_eq!(curve.window(), (-775.0 + 0.0, 3725.0));
        assert_eq!(curve.low, -775.0, "what is shown begins with the window");
        let inner: Vec<f32> = curve.stops.iter().map(|stop| stop.0).collect();
        assert!(inner.is_sorted() && (inner[1] - -275.0).abs() < 1e-3, "{inner:?}");
        for _ in 0..200 {
            curve.turn(0.5, 1e4, (-1000.0, 3000.0));
        }
        let (from, to) = curve.window();
        assert!(to > from && to <= 3001.0 && curve.stops.iter().all(|stop| stop.0.is_finite()));
    }

    #[test]
    fn values_have_as_many_digits_as_matter() {
        let curve =
            ValueCurve { low: 649.208_86, high: Some(0.000_012_3), stops: vec![(1.0 / 3.0, [9; 3])], opacity: 1.0 };
        let rounded = |range| curve.clone().rounded(range).word();
        assert_eq!(rounded((0.0, 3000.0)), "stops:0.33=#090909,threshold=649.21,upper=0");
        assert_eq!(rounded((-1e5, 9e5)), "stops:0=#090909,threshold=650,upper=0");
        assert_eq!(rounded((0.0, 0.02)), "stops:0.3333333=#090909,threshold=649.20886,upper=0.0000123");
        assert_eq!(rounded((5.0, 5.0)), curve.word(), "of one value nothing is known");
    }

    #[test]
    fn a_stop_stays_between_its_neighbours_and_a_new_one_changes_no_colour() {
        let mut curve = seen().preset(Preset::CtBone).unwrap();
        assert_eq!(
            (curve.move_stop(1, 9000.0), curve.move_stop(1, -9000.0), curve.move_stop(1, 700.0)),
            (1200.0, 250.0, 700.0)
        );
        let before = curve.color_at(900.0);
        let index = curve.add_stop(900.0);
        assert_eq!((index, curve.stops[index]), (2, (900.0, before)));
        assert_ne!(before, curve.color_at(2000.0));
    }
}
