//! Irregularities at equal distances, with a cubic through values and central slopes between them.

use super::RailOffset;

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
        let place = (chainage - self.begin) / self.distance;
        if place <= 0.0 || place >= last as f64 {
            let [a, b, c, d] = self.rows[if place <= 0.0 { 0 } else { last }];
            let constant =
                |lateral, vertical| RailOffset { lateral, vertical, ..Default::default() };
            return [constant(a, b), constant(c, d)];
        }
        let i = place as usize;
        let t = place - i as f64;
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
