//! Line charts as SVG: axes, lines, bands, horizontal rules and a legend, in colours for light and for dark pages. No
//! scripts, no fonts of its own.

use super::table::escape;
use std::fmt::Write;

/// What a chart's classes look like; once in a page, or in each file of its own.
pub const STYLE: &str = "\
.plot{--ink:#24292f;--faint:#d0d7de;--c0:#0969da;--c1:#bc4c00;--c2:#1a7f37;--c3:#8250df;--c4:#bf3989;--c5:#9a6700;--c6:#0e7c86;--c7:#57606a;\
font:12px system-ui,sans-serif}
@media(prefers-color-scheme:dark){.plot{--ink:#e6edf3;--faint:#3d444d;--c0:#58a6ff;--c1:#f0883e;--c2:#3fb950;--c3:#bc8cff;--c4:#f778ba;--c5:#d29922;--c6:#39c5cf;--c7:#9198a1}}
.plot text{fill:var(--ink)}.plot .grid{stroke:var(--faint);stroke-width:1}.plot .line{fill:none;stroke-width:1.8;stroke-linejoin:round}
.plot .band{opacity:.16;stroke:none}.plot .rule{stroke:var(--ink);stroke-dasharray:5 4;stroke-width:1.2}
.c0{--c:var(--c0)}.c1{--c:var(--c1)}.c2{--c:var(--c2)}.c3{--c:var(--c3)}.c4{--c:var(--c4)}.c5{--c:var(--c5)}.c6{--c:var(--c6)}.c7{--c:var(--c7)}
.plot .line{stroke:var(--c)}.plot .dashed .line{stroke-dasharray:6 3}.plot .band,.plot .dot{fill:var(--c)}
";
/// Number of colours in [`STYLE`].
const COLORS: usize = 8;
const WIDTH: f64 = 480.0;
/// The part that lines are drawn in.
const LEFT: f64 = 54.0;
const RIGHT: f64 = 466.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 250.0;
/// Height of a line of the legend, and width of an entry.
const LEGEND: [f64; 2] = [17.0, 206.0];

/// A line.
pub struct Series {
    pub name: String,
    pub color: usize,
    pub points: Vec<(f64, f64)>,
    /// Least and most around the line, at the same places.
    pub band: Vec<(f64, f64)>,
    pub has_dots: bool,
    pub is_dashed: bool,
}

/// A chart.
pub struct Plot {
    pub title: String,
    pub x_label: String,
    pub y_label: String,
    pub is_log_x: bool,
    pub is_log_y: bool,
    pub series: Vec<Series>,
    /// Height and name of dashed lines.
    pub rules: Vec<(f64, String)>,
}

/// From values to places.
struct Axis {
    low: f64,
    high: f64,
    is_log: bool,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, is_log: bool, from: f64, to: f64) -> Self {
        let usable = values.filter(|value| value.is_finite() && (!is_log || *value > 0.0));
        let (low, high) = usable.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let (low, high) = if low > high { (1.0, 10.0) } else { (low, high) };
        let (low, high) = match is_log {
            true => (low / 1.25, high * 1.25),
            // From zero, so that lengths can be compared.
            false => (low.min(0.0), if high > 0.0 { high * 1.08 } else { 1.0 }),
        };
        Self { low, high, is_log, from, to }
    }

    fn place(&self, value: f64) -> f64 {
        let part = match self.is_log {
            true => (value.max(self.low) / self.low).ln() / (self.high / self.low).ln(),
            false => (value - self.low) / (self.high - self.low),
        };
        self.from + (self.to - self.from) * part.clamp(-0.05, 1.05)
    }

    fn ticks(&self) -> Vec<f64> {
        let inside = |value: &f64| *value >= self.low && *value <= self.high;
        if self.is_log {
            let digits: &[f64] = match self.high / self.low {
                wide if wide > 300.0 => &[1.0],
                wide if wide > 5.0 => &[1.0, 2.0, 5.0],
                // An axis around a single value has one of these at least.
                _ => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
            };
            let decades = (self.low.log10().floor() as i32)..=(self.high.log10().ceil() as i32);
            let all = decades.flat_map(|decade| digits.iter().map(move |digit| digit * 10f64.powi(decade)));
            return all.filter(inside).collect();
        }
        let step = (self.high - self.low) / 5.0;
        let unit = 10f64.powf(step.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * unit).into_iter().find(|&s| s >= step).unwrap_or(step);
        (0..12).map(|index| self.low + f64::from(index) * step).filter(inside).collect()
    }
}

/// A number as short as it can be: 20,000,000 is 20M.
fn short(value: f64) -> String {
    let (value, unit) = match value.abs() {
        v if v >= 1e9 => (value / 1e9, "G"),
        v if v >= 1e6 => (value / 1e6, "M"),
        v if v >= 1e4 => (value / 1e3, "k"),
        _ => (value, ""),
    };
    let text = format!("{value:.3}");
    format!("{}{unit}", text.trim_end_matches('0').trim_end_matches('.'))
}

impl Plot {
    /// Whether there is anything to draw.
    pub fn is_empty(&self) -> bool {
        self.series.iter().all(|series| series.points.is_empty())
    }

    /// The chart; with its style inside where it stands alone.
    pub fn svg(&self, is_alone: bool) -> String {
        let points = || self.series.iter().flat_map(|series| series.points.iter());
        let x = Axis::new(points().map(|point| point.0), self.is_log_x, LEFT, RIGHT);
        let y_values = points().map(|point| point.1).chain(self.rules.iter().map(|rule| rule.0));
        let y = Axis::new(y_values, self.is_log_y, BOTTOM, TOP);
        let legend_top = BOTTOM + 48.0;
        let height = legend_top + LEGEND[0] * self.series.len().div_ceil(2) as f64;
        let title = escape(&self.title);
        let mut svg = format!(
            "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
             aria-label=\"{title}\"><title>{title}</title>"
        );
        if is_alone {
            let _ = write!(
                svg,
                "<style>.plot{{background:#fff}}@media(prefers-color-scheme:dark){{.plot{{background:#0d1117}}}}{STYLE}</style>"
            );
        }
        let _ = write!(svg, "<text x=\"0\" y=\"14\" font-weight=\"600\">{title}</text>");
        for tick in y.ticks() {
            let at = y.place(tick);
            let _ = write!(svg, "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{RIGHT}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>");
            let _ = write!(
                svg,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                LEFT - 6.0,
                at + 4.0,
                short(tick)
            );
        }
        for tick in x.ticks() {
            let at = x.place(tick);
            let _ = write!(
                svg,
                "<line class=\"grid\" x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{BOTTOM}\" y2=\"{:.1}\"/>",
                BOTTOM + 4.0
            );
            let _ = write!(
                svg,
                "<text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                BOTTOM + 17.0,
                short(tick)
            );
        }
        let _ = write!(
            svg,
            "<text x=\"{RIGHT}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            BOTTOM + 34.0,
            escape(&self.x_label)
        );
        let _ =
            write!(svg, "<text x=\"0\" y=\"{:.1}\">{}</text>", BOTTOM + 34.0, escape(&format!("↑ {}", self.y_label)));
        for series in &self.series {
            series.draw(&x, &y, &mut svg);
        }
        for (value, name) in &self.rules {
            let at = y.place(*value);
            let _ = write!(svg, "<line class=\"rule\" x1=\"{LEFT}\" x2=\"{RIGHT}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>");
            let _ =
                write!(svg, "<text x=\"{RIGHT}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>", at - 5.0, escape(name));
        }
        for (index, series) in self.series.iter().enumerate() {
            let (column, row) = (index % 2, index / 2);
            let (left, top) = (LEGEND[1] * column as f64 + LEFT, legend_top + LEGEND[0] * row as f64);
            let _ = write!(
                svg,
                "<g class=\"{}\"><line class=\"line\" x1=\"{left:.1}\" x2=\"{:.1}\" y1=\"{top:.1}\" y2=\"{top:.1}\"/></g>\
                 <text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                series.class(),
                left + 16.0,
                left + 22.0,
                top + 4.0,
                escape(&series.name)
            );
        }
        svg + "</svg>\n"
    }
}

impl Series {
    fn class(&self) -> String {
        format!("c{}{}", self.color % COLORS, if self.is_dashed { " dashed" } else { "" })
    }

    fn draw(&self, x: &Axis, y: &Axis, svg: &mut String) {
        let _ = write!(svg, "<g class=\"{}\">", self.class());
        let places = |values: &mut dyn Iterator<Item = (f64, f64)>| {
            values.map(|(a, b)| format!("{:.1},{:.1}", x.place(a), y.place(b))).collect::<Vec<_>>().join(" ")
        };
        if !self.band.is_empty() {
            let along = || self.points.iter().zip(&self.band);
            let low = places(&mut along().map(|(point, band)| (point.0, band.0)));
            let high = places(&mut along().rev().map(|(point, band)| (point.0, band.1)));
            let _ = write!(svg, "<polygon class=\"band\" points=\"{low} {high}\"/>");
        }
        let line = places(&mut self.points.iter().copied());
        let _ = write!(svg, "<polyline class=\"line\" points=\"{line}\"/>");
        for &(a, b) in self.points.iter().filter(|_| self.has_dots) {
            let _ = write!(svg, "<circle class=\"dot\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"2.6\"/>", x.place(a), y.place(b));
        }
        svg.push_str("</g>");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(is_log: bool, points: Vec<(f64, f64)>) -> Plot {
        let series =
            Series { name: "a < b".into(), color: 9, points, band: Vec::new(), has_dots: true, is_dashed: false };
        Plot {
            title: "frame time".into(),
            x_label: "voxels".into(),
            y_label: "ms".into(),
            is_log_x: is_log,
            is_log_y: is_log,
            series: vec![series],
            rules: vec![(16.67, "60 frames a second".into())],
        }
    }

    #[test]
    fn higher_values_stand_higher_and_rules_are_within_the_chart() {
        for is_log in [false, true] {
            let svg = plot(is_log, vec![(1e6, 1.0), (2e6, 2.0), (4e6, 8.0)]).svg(true);
            let heights: Vec<f64> =
                svg.split("cy=\"").skip(1).map(|part| part.split('"').next().unwrap().parse().unwrap()).collect();
            assert!(heights.len() == 3 && heights.windows(2).all(|pair| pair[1] < pair[0]), "{heights:?}");
            let rule: f64 = svg
                .split("class=\"rule\"")
                .nth(1)
                .unwrap()
                .split("y1=\"")
                .nth(1)
                .unwrap()
                .split('"')
                .next()
                .unwrap()
                .parse()
                .unwrap();
            assert!(rule >= TOP && rule < heights[2], "{rule}");
            assert!(svg.contains("a &lt; b") && svg.contains("<style>"));
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
        }
    }

    #[test]
    fn no_points_one_point_and_absurd_points_draw_without_numbers_that_are_none() {
        for points in [vec![], vec![(0.0, 0.0)], vec![(f64::NAN, 1.0), (1.0, f64::INFINITY)], vec![(5.0, 5.0)]] {
            for is_log in [false, true] {
                let svg = plot(is_log, points.clone()).svg(false);
                assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
                assert!(!svg.contains("<style>"));
            }
        }
        assert!(plot(false, vec![]).is_empty());
    }

    #[test]
    fn numbers_are_as_short_as_they_can_be() {
        assert_eq!([500_000.0, 1e6, 16e6, 0.25, 1000.0, 2e9].map(short), ["500k", "1M", "16M", "0.25", "1000", "2G"]);
    }

    #[test]
    fn ticks_are_round_and_few() {
        let axis = Axis::new([0.0, 17.3].into_iter(), false, 0.0, 1.0);
        assert_eq!(axis.ticks(), [0.0, 5.0, 10.0, 15.0]);
        let axis = Axis::new([5e5, 16e6].into_iter(), true, 0.0, 1.0);
        assert_eq!(axis.ticks().len(), 6);
        let wide = Axis::new([0.1, 5000.0].into_iter(), true, 0.0, 1.0);
        assert!(wide.ticks().iter().all(|tick| tick.log10().fract().abs() < 1e-9));
        for one in [1.3e6, 3e6, 4.5e6, 9.9e6] {
            assert!(
                !Axis::new([one].into_iter(), true, 0.0, 1.0).ticks().is_empty(),
                "an axis without a number: {one}"
            );
        }
    }
}
