//! The samples of a scan (T.87, annex A). Names of variables in the standard stand beside ours where they differ.

use super::bits::Bits;

/// Orders of run lengths (J).
const ORDERS: [u32; 32] =
    [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 9, 10, 11, 12, 13, 14, 15];
const CONTEXTS: usize = 365;
/// Samples of the rows above, left and right of a row.
const MARGIN: usize = 2;

/// How samples are coded (T.87, C.2.4.1 and A.2.1).
pub(super) struct Coding {
    near: i32,
    /// The highest sample (MAXVAL).
    most: i32,
    thresholds: [i32; 3],
    reset: i32,
    /// Errors of predictions that are told apart (RANGE).
    range: i32,
    /// Bits of such an error (qbpp).
    bits: u32,
    /// Most bits of a code (LIMIT).
    limit: u32,
}

/// Bits that tell so many numbers apart.
fn bits_for(count: i32) -> u32 {
    (count - 1).checked_ilog2().map_or(0, |bits| bits + 1)
}

impl Coding {
    pub fn new(precision: u32, near: i32, most: u16, thresholds: [u16; 3], reset: u16) -> Result<Self, String> {
        let highest = (1 << precision) - 1;
        let most = if most == 0 { highest } else { i32::from(most) };
        if most > highest || most < 1 || near > (most / 2).min(255) {
            return Err(format!("samples up to {most}, {near} beside the truth"));
        }
        let clamp = |value: i32, low: i32| if value > most || value < low { low } else { value };
        let mut defaults = [0; 3];
        let mut low = near + 1;
        for (default, (least, base, steps)) in defaults.iter_mut().zip([(2, 3, 3), (3, 7, 5), (4, 21, 7)]) {
            let value = if most >= 128 {
                (most.min(4095) + 128) / 256 * (base - least) + least + steps * near
            } else {
                least.max(base / (256 / (most + 1)) + steps * near)
            };
            *default = clamp(value, low);
            low = *default;
        }
        let chosen: [i32; 3] =
            std::array::from_fn(|n| if thresholds[n] == 0 { defaults[n] } else { i32::from(thresholds[n]) });
        if !(near < chosen[0] && chosen[0] <= chosen[1] && chosen[1] <= chosen[2] && chosen[2] <= most) {
            return Err("thresholds out of order".into());
        }
        let range = if near == 0 { most + 1 } else { (most + 2 * near) / (2 * near + 1) + 1 };
        let depth = bits_for(most + 1).max(2);
        Ok(Self {
            near,
            most,
            thresholds: chosen,
            reset: if reset == 0 { 64 } else { i32::from(reset).max(3) },
            range,
            bits: bits_for(range),
            limit: 2 * (depth + depth.max(8)),
        })
    }

    /// The region of a gradient, −4 to 4.
    fn region(&self, gradient: i32) -> i32 {
        let size = gradient.abs();
        let region = match self.thresholds {
            _ if size <= self.near => 0,
            [first, ..] if size < first => 1,
            [_, second, _] if size < second => 2,
            [.., third] if size < third => 3,
            _ => 4,
        };
        region * gradient.signum()
    }

    /// The sample of a prediction and its quantized error.
    fn corrected(&self, prediction: i32, error: i32) -> i32 {
        let step = 2 * self.near + 1;
        let mut sample = prediction + error * step;
        if sample < -self.near {
            sample += self.range * step;
        } else if sample > self.most + self.near {
            sample -= self.range * step;
        }
        sample.clamp(0, self.most)
    }

    /// A Golomb code of order `k` and at most `limit` bits.
    fn code(&self, bits: &mut Bits, k: u32, limit: u32) -> Result<i32, String> {
        let most = limit - self.bits - 1;
        let high = bits.zeros(most)?;
        let code = if high < most { high << k | bits.take(k)? } else { bits.take(self.bits)? + 1 } as i32;
        if code > 2 * self.range {
            return Err("an error of prediction that cannot be".into());
        }
        Ok(code)
    }
}

/// What a context has learned.
#[derive(Clone, Copy)]
struct Context {
    /// Sum of the sizes of errors (A).
    sizes: i64,
    /// Sum of errors, as far as it is not in `bias` (B); of runs the number of negative ones (Nn).
    errors: i32,
    /// What predictions are corrected by (C).
    bias: i32,
    /// Samples seen (N).
    seen: i32,
}

impl Context {
    /// The order of its Golomb codes.
    fn order(&self, sizes: i64) -> u32 {
        (0..24).find(|k| i64::from(self.seen) << k >= sizes).unwrap_or(24)
    }
}

pub(super) struct Scan {
    pub columns: usize,
    pub rows: usize,
    /// Which components of the frame it holds.
    pub components: Vec<usize>,
    /// Whether the components of a pixel stand beside each other, else rows do.
    pub by_sample: bool,
    pub coding: Coding,
}

struct State<'a> {
    bits: Bits<'a>,
    contexts: [Context; CONTEXTS],
    /// Contexts of the samples that end runs: where they differ from the left neighbour in the row above, and where not.
    endings: [Context; 2],
}

/// Two rows of a component with a margin.
struct Rows {
    above: Vec<i32>,
    row: Vec<i32>,
    /// The index of run lengths (RUNindex).
    order: usize,
}

impl Rows {
    fn begin(&mut self) {
        std::mem::swap(&mut self.above, &mut self.row);
        let last = self.above.len() - 1;
        self.above[last] = self.above[last - 1];
        self.row[0] = self.above[1];
    }

    /// The neighbours of a place: left, above, above left, above right.
    fn around(&self, x: usize) -> [i32; 4] {
        [self.row[x], self.above[x + 1], self.above[x], self.above[x + 2]]
    }
}

impl Scan {
    /// The samples of each component.
    pub fn decode(&self, bits: Bits) -> Result<Vec<Vec<u16>>, String> {
        let start = Context { sizes: i64::from((self.coding.range + 32) / 64).max(2), errors: 0, bias: 0, seen: 1 };
        let mut state = State { bits, contexts: [start; CONTEXTS], endings: [start; 2] };
        let width = self.columns + MARGIN;
        let rows = || Rows { above: vec![0; width], row: vec![0; width], order: 0 };
        let mut rows: Vec<Rows> = self.components.iter().map(|_| rows()).collect();
        let mut samples = vec![Vec::new(); rows.len()];
        for _ in 0..self.rows {
            rows.iter_mut().for_each(Rows::begin);
            if self.by_sample {
                self.row(&mut state, &mut rows)?;
            } else {
                rows.chunks_mut(1).try_for_each(|rows| self.row(&mut state, rows))?;
            }
            for (samples, rows) in samples.iter_mut().zip(&rows) {
                samples.extend(rows.row[1..=self.columns].iter().map(|&sample| sample as u16));
            }
        }
        Ok(samples)
    }

    /// Decodes a row of one component, or of several whose samples stand beside each other.
    fn row(&self, state: &mut State, rows: &mut [Rows]) -> Result<(), String> {
        let near = self.coding.near;
        let mut x = 0;
        while x < self.columns {
            let is_flat = rows.iter().all(|rows| {
                let [left, above, corner, right] = rows.around(x);
                [right - above, above - corner, corner - left].iter().all(|gradient| gradient.abs() <= near)
            });
            if is_flat {
                x = self.run(state, rows, x)?;
                continue;
            }
            for rows in rows.iter_mut() {
                rows.row[x + 1] = self.sample(state, rows.around(x))?;
            }
            x += 1;
        }
        Ok(())
    }

    /// A sample by itself (T.87, A.3 to A.6).
    fn sample(&self, state: &mut State, [left, above, corner, right]: [i32; 4]) -> Result<i32, String> {
        let coding = &self.coding;
        let gradients = [right - above, above - corner, corner - left];
        let number = gradients.iter().fold(0, |number, &gradient| number * 9 + coding.region(gradient));
        let sign = if number < 0 { -1 } else { 1 };
        let context = &mut state.contexts[number.unsigned_abs() as usize];
        let prediction = if corner >= left.max(above) {
            left.min(above)
        } else if corner <= left.min(above) {
            left.max(above)
        } else {
            left + above - corner
        };
        let prediction = (prediction + sign * context.bias).clamp(0, coding.most);
        let k = context.order(context.sizes);
        let code = coding.code(&mut state.bits, k, coding.limit)?;
        let is_turned = coding.near == 0 && k == 0 && 2 * context.errors <= -context.seen;
        let error = match (code % 2 == 0, is_turned) {
            (true, false) => code / 2,
            (false, false) => -(code + 1) / 2,
            (true, true) => -code / 2 - 1,
            (false, true) => (code - 1) / 2,
        };
        context.errors += error * (2 * coding.near + 1);
        context.sizes += i64::from(error.abs());
        if context.seen == coding.reset {
            context.sizes >>= 1;
            context.errors >>= 1;
            context.seen >>= 1;
        }
        context.seen += 1;
        if context.errors <= -context.seen {
            context.errors = (context.errors + context.seen).max(1 - context.seen);
            context.bias = (context.bias - 1).max(-128);
        } else if context.errors > 0 {
            context.errors = (context.errors - context.seen).min(0);
            context.bias = (context.bias + 1).min(127);
        }
        Ok(coding.corrected(prediction, sign * error))
    }

    /// A run from `x` on, and the sample that ends it (T.87, A.7). Returns where to go on.
    fn run(&self, state: &mut State, rows: &mut [Rows], start: usize) -> Result<usize, String> {
        let mut x = start;
        // Samples beside each other share the index of the first.
        let mut order = rows[0].order;
        loop {
            if state.bits.take(1)? == 0 {
                x += state.bits.take(ORDERS[order])? as usize;
                break;
            }
            let whole = 1 << ORDERS[order];
            let count = whole.min(self.columns - x);
            x += count;
            if count == whole {
                order = (order + 1).min(31);
            }
            if x == self.columns {
                break;
            }
        }
        let is_whole = x == self.columns;
        if x > self.columns {
            return Err("a run beyond its row".into());
        }
        let is_single = rows.len() == 1;
        for rows in rows.iter_mut() {
            let left = rows.row[start];
            rows.row[start + 1..=x].fill(left);
            if !is_whole {
                let above = rows.above[x + 1];
                rows.row[x + 1] = self.ending(state, left, above, order, is_single)?;
            }
        }
        rows[0].order = if is_whole { order } else { order.saturating_sub(1) };
        Ok(if is_whole { x } else { x + 1 })
    }

    fn ending(&self, state: &mut State, left: i32, above: i32, order: usize, is_single: bool) -> Result<i32, String> {
        let coding = &self.coding;
        let is_like = is_single && (left - above).abs() <= coding.near;
        let context = &mut state.endings[usize::from(is_like)];
        let k = context.order(context.sizes + if is_like { i64::from(context.seen >> 1) } else { 0 });
        let code = coding.code(&mut state.bits, k, coding.limit - ORDERS[order] - 1)?;
        let mapped = code + i32::from(is_like);
        let size = (mapped + 1) / 2;
        let is_negative = (k != 0 || 2 * context.errors >= context.seen) == (mapped % 2 == 1);
        let error = if is_negative { -size } else { size };
        context.errors += i32::from(error < 0);
        context.sizes += i64::from(code + 1 - i32::from(is_like)) >> 1;
        if context.seen == coding.reset {
            context.sizes >>= 1;
            context.errors >>= 1;
            context.seen >>= 1;
        }
        context.seen += 1;
        let (prediction, sign) = if is_like { (left, 1) } else { (above, if left > above { -1 } else { 1 }) };
        Ok(coding.corrected(prediction, sign * error))
    }
}
