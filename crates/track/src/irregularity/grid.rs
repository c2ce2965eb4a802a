//! Irregularities at equal distances, with a cubic through values and central slopes between them.

use super::rail_offset::RailOffset;

/// Values at one chainage: lateral left, vertical left, lateral right, vertical right, m.
pub(super) type Row = [f64; 4];

/// Rows at equal distances; outside, the outermost row holds.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    begin: f64,
    distance: f64,
    rows: Vec<Row>,
}

impl Grid {
    /// At least two rows, the first one at `begin`.
    pub fn new(begin: f64, distance: f64, rows: Vec<Row>) -> Self {
        Self { begin, distance, rows }
    }

    /// Both rails at a chainage.
    #[inline]
    pub fn at(&self, chainage: f64) -> [RailOffset; 2] {
        let last = self.rows.len() - 1;
        let row = (chainage - self.begin) / self.distance;
        if row <= 0.0 || row >= last as f64 {
            let [a, b, c, d] = self.rows[if row <= 0.0 { 0 } else { last }];
            let constant =
                |lateral, vertical| RailOffset { lateral, vertical, ..Default::default() };
            return [constant(a, b), constant(c, d)];
        }
        let i = row as usize;
        let t = row - i as f64;
        let (p, q) = (&self.rows[i], &self.rows[i + 1]);
        let before = &self.rows[i.saturating_sub(1)];
        let after = &self.rows[(i + 2).min(last)];
        // Hermite's cubic with the slopes of the neighbours (Catmull and Rom).
        let part = |k: usize| {
            let (m, n) = (0.5 * (q[k] - before[k]), 0.5 * (after[k] - p[k]));
            let rise = q[k] - p[k];
            let (c2, c3) = (3.0 * rise - 2.0 * m - n, m + n - 2.0 * rise);
            let value = p[k] + t * (m + t * (c2 + t * c3));
            (value, (m + t * (2.0 * c2 + t * 3.0 * c3)) / self.distance)
        };
        [0, 2].map(|k| {
            let ((lateral, lateral_slope), (vertical, vertical_slope)) = (part(k), part(k + 1));
            RailOffset { lateral, vertical, lateral_slope, vertical_slope }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of 0.5 m from 10 m on with values f(chainage), times 1 to 4 for the four columns.
    fn grid(f: impl Fn(f64) -> f64) -> Grid {
        let rows = (0..20).map(|i| [1.0, 2.0, 3.0, 4.0].map(|k| k * f(10.0 + 0.5 * f64::from(i))));
        Grid::new(10.0, 0.5, rows.collect())
    }

    /// Slopes by central differences are exact for a parabola, and so is the cubic through them.
    #[test]
    fn analytic_a_parabola_is_met_between_rows() {
        let parabola = |x: f64| 1e-3 * (x - 12.0) * (x - 17.0);
        let grid = grid(parabola);
        for x in [10.75, 12.2, 14.0, 18.9] {
            let [left, right] = grid.at(x);
            let slope = 1e-3 * (2.0 * x - 29.0);
            let pairs = [
                (left.lateral, parabola(x)),
                (left.vertical, 2.0 * parabola(x)),
                (right.lateral, 3.0 * parabola(x)),
                (right.vertical, 4.0 * parabola(x)),
                (left.lateral_slope, slope),
                (right.vertical_slope, 4.0 * slope),
            ];
            for (found, expected) in pairs {
                assert!((found - expected).abs() < 1e-15, "{found}, {expected} at {x} m");
            }
        }
    }

    #[test]
    fn property_values_and_slopes_are_continuous_at_rows() {
        let grid = grid(|x| (3.0 * x).sin() * 1e-3);
        for row in [10.5, 13.0, 19.0] {
            let ([before, _], [after, _]) = (grid.at(row - 1e-9), grid.at(row + 1e-9));
            assert!((before.lateral - after.lateral).abs() < 1e-11);
            assert!((before.lateral_slope - after.lateral_slope).abs() < 1e-8);
        }
    }

    #[test]
    fn outside_the_rows_the_outermost_holds() {
        let grid = grid(|x| x * 1e-3);
        let lateral = |x| grid.at(x)[0].lateral;
        assert_eq!([lateral(-5.0), lateral(99.0)], [10e-3, 19.5e-3]);
        assert_eq!(grid.at(99.0)[0].lateral_slope, 0.0);
    }
}
