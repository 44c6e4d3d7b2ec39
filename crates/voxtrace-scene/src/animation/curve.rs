//! Numbers over time: values at keys, and how they go on between them.

/// How a value goes from one key to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// It stays, and jumps.
    Step,
    /// Straight.
    Linear,
    /// By the spline of Catmull and Rom (1974) with the times as knots: without corners.
    #[default]
    Smooth,
}

/// How something speeds up and slows down on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ease {
    /// One speed.
    #[default]
    None,
    /// Slow at first.
    In,
    /// Slow at last.
    Out,
    /// Slow at first and at last.
    InOut,
}

impl Ease {
    /// The share of the way after a share of the time, both from 0 to 1.
    pub fn at(self, share: f64) -> f64 {
        let s = share.clamp(0.0, 1.0);
        match self {
            Self::None => s,
            Self::In => s * s,
            Self::Out => s * (2.0 - s),
            Self::InOut => s * s * (3.0 - 2.0 * s),
        }
    }
}

/// `N` numbers over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<const N: usize> {
    keys: Vec<(f64, [f64; N])>,
    interpolation: Interpolation,
}

impl<const N: usize> Curve<N> {
    /// A curve through values at times; before the first and after the last they hold.
    ///
    /// # Panics
    /// Without keys, or where their times do not rise.
    pub fn new(keys: Vec<(f64, [f64; N])>, interpolation: Interpolation) -> Self {
        assert!(!keys.is_empty() && keys.is_sorted_by(|one, other| one.0 < other.0), "keys by rising time");
        Self { keys, interpolation }
    }

    /// When the last key comes, seconds.
    pub fn end(&self) -> f64 {
        self.keys[self.keys.len() - 1].0
    }

    /// The values at a time.
    pub fn at(&self, time: f64) -> [f64; N] {
        let keys = &self.keys;
        let key = keys.partition_point(|&(key, _)| key <= time).saturating_sub(1);
        let (start, from) = keys[key];
        let Some(&(end, to)) = keys.get(key + 1).filter(|_| time > start) else { return from };
        let (length, s) = (end - start, (time - start) / (end - start));
        match self.interpolation {
            Interpolation::Step => from,
            Interpolation::Linear => std::array::from_fn(|n| from[n] + (to[n] - from[n]) * s),
            Interpolation::Smooth => {
                let (s2, s3) = (s * s, s * s * s);
                std::array::from_fn(|n| {
                    (2.0 * s3 - 3.0 * s2 + 1.0) * from[n]
                        + (s3 - 2.0 * s2 + s) * length * self.tangent(key, n)
                        + (3.0 * s2 - 2.0 * s3) * to[n]
                        + (s3 - s2) * length * self.tangent(key + 1, n)
                })
            }
        }
    }

    /// Change of a number with time at a key: at the ends that of the straight way.
    fn tangent(&self, key: usize, n: usize) -> f64 {
        let slope = |one: usize, other: usize| {
            let ((t0, a), (t1, b)) = (self.keys[one], self.keys[other]);
            (b[n] - a[n]) / (t1 - t0)
        };
        // Where two keys say the same, nothing moves between them.
        let is_same =
            |other: Option<usize>| other.and_then(|at| self.keys.get(at)).is_some_and(|at| at.1 == self.keys[key].1);
        if is_same(key.checked_sub(1)) || is_same(Some(key + 1)) {
            return 0.0;
        }
        match key {
            0 => slope(0, 1),
            last if last + 1 == self.keys.len() => slope(last - 1, last),
            key => slope(key - 1, key) + slope(key, key + 1) - slope(key - 1, key + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_passes_its_keys_and_holds_before_and_after_them() {
        let keys = vec![(1.0, [0.0, 5.0]), (2.0, [10.0, 5.0]), (5.0, [-20.0, 5.0])];
        for interpolation in [Interpolation::Step, Interpolation::Linear, Interpolation::Smooth] {
            let curve = Curve::new(keys.clone(), interpolation);
            keys.iter().for_each(|&(time, value)| assert_eq!(curve.at(time), value));
            assert_eq!((curve.at(-3.0), curve.at(9.0)), (keys[0].1, keys[2].1));
            assert_eq!(curve.at(3.3)[1], 5.0);
        }
        let at = |interpolation| Curve::new(keys.clone(), interpolation).at(1.5)[0];
        assert_eq!((at(Interpolation::Step), at(Interpolation::Linear)), (0.0, 5.0));
        assert!(at(Interpolation::Smooth) > 5.0, "a spline leaves the straight line");
    }

    #[test]
    fn a_smooth_curve_through_a_line_is_the_line_and_has_no_corners() {
        let line = Curve::new([0.0, 1.0, 1.5, 4.0].map(|t| (t, [3.0 * t])).into(), Interpolation::Smooth);
        for step in 0..=40 {
            let time = f64::from(step) / 10.0;
            assert!((line.at(time)[0] - 3.0 * time).abs() < 1e-12);
        }
        let curve = Curve::new(vec![(0.0, [0.0]), (1.0, [4.0]), (2.0, [1.0])], Interpolation::Smooth);
        let slope = |from: f64| (curve.at(from + 1e-6)[0] - curve.at(from)[0]) / 1e-6;
        assert!((slope(1.0 - 1e-6) - slope(1.0)).abs() < 1e-3);
    }

    #[test]
    fn easing_begins_and_ends_where_the_way_does() {
        for ease in [Ease::None, Ease::In, Ease::Out, Ease::InOut] {
            assert_eq!((ease.at(-1.0), ease.at(0.0), ease.at(1.0), ease.at(2.0)), (0.0, 0.0, 1.0, 1.0));
        }
        assert!(Ease::In.at(0.5) < 0.5 && Ease::Out.at(0.5) > 0.5 && Ease::InOut.at(0.5) == 0.5);
    }
}
