//! Where the heat came from and where it is.

use serde::{Deserialize, Serialize};

/// Heat since the start, J, over the whole modelled rail.
///
/// Conduction moves heat and makes none (`docs/theory/railheat/paper.md#eq-7`), so that [`stored`](Self::stored) is
/// [`imposed`](Self::imposed) plus [`weather`](Self::weather) but for rounding;
/// [`error`](Self::error) tells how well. Validated by `property_energy_is_accounted_for`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Audit {
    /// Heat in the rail above the initial state, summed over all cells.
    pub stored: f64,
    /// Heat that came in because wheels set surface temperatures.
    pub imposed: f64,
    /// Heat that came in from the weather; negative when the rail cools.
    pub weather: f64,
}

impl Audit {
    /// Heat that is stored but did not come in, J.
    pub fn error(&self) -> f64 {
        self.stored - self.imposed - self.weather
    }
}
