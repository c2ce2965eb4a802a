//! Force over deflection by points.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Force over deflection by points, linear between them. A force that is not zero at zero is a
/// preload.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForceCurve {
    /// Deflections, rising from zero, mm.
    pub deflection_mm: Vec<f64>,
    /// Forces, rising, kN.
    pub force_kn: Vec<f64>,
}

impl ForceCurve {
    /// The greatest deflection of the curve, mm.
    pub fn travel_mm(&self) -> f64 {
        self.deflection_mm.last().copied().unwrap_or_default()
    }

    /// Force at a deflection within the travel, kN.
    pub fn force_at_kn(&self, deflection_mm: f64) -> f64 {
        let (x, f) = (&self.deflection_mm, &self.force_kn);
        let i = x.partition_point(|x| *x < deflection_mm).clamp(1, x.len() - 1);
        f[i - 1] + (deflection_mm - x[i - 1]) * (f[i] - f[i - 1]) / (x[i] - x[i - 1])
    }

    /// Energy under the curve up to a deflection within the travel, kJ.
    pub fn energy_to_kj(&self, deflection_mm: f64) -> f64 {
        let inner = self.deflection_mm.iter().copied();
        let ends: Vec<f64> =
            inner.take_while(|x| *x < deflection_mm).chain([deflection_mm]).collect();
        let area = |pair: &[f64]| {
            let mean = (self.force_at_kn(pair[0]) + self.force_at_kn(pair[1])) / 2.0;
            mean * (pair[1] - pair[0])
        };
        ends.windows(2).map(area).sum::<f64>() * 1e-3
    }

    /// Slope of the steepest piece, MN/m, which is kN/mm.
    pub fn steepest_mn_m(&self) -> f64 {
        let points = self.deflection_mm.windows(2).zip(self.force_kn.windows(2));
        points.map(|(x, f)| (f[1] - f[0]) / (x[1] - x[0])).fold(0.0, f64::max)
    }

    /// The same curve with its forces times `factor`.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let force_kn = self.force_kn.iter().map(|force| force * factor).collect();
        Self { deflection_mm: self.deflection_mm.clone(), force_kn }
    }

    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        let (x, f) = (&self.deflection_mm, &self.force_kn);
        check.columns(("deflection_mm", x), ("force_kn", f), 2)?;
        match (1..f.len()).find(|&i| f[i] <= f[i - 1]) {
            None => Ok(()),
            Some(i) => {
                let wanted = format!("must rise from the value before it, {}", f[i - 1]);
                Err(check.error(&format!("force_kn[{}]", i + 1), f[i], wanted))
            }
        }
    }

    /// A gear gives back no more than it took.
    ///
    /// Its unloading curve is nowhere above `loading`, and both end at the same deflection.
    pub(crate) fn check_is_below(&self, loading: &Self, check: &Check) -> Result<(), Mistake> {
        let travel = loading.travel_mm();
        if self.travel_mm() != travel {
            let wanted = format!("must end at the travel of the loading curve, {travel}");
            return Err(check.error("deflection_mm", self.travel_mm(), wanted));
        }
        for &x in loading.deflection_mm.iter().chain(&self.deflection_mm) {
            let (above, below) = (loading.force_at_kn(x), self.force_at_kn(x));
            if below > above {
                let wanted =
                    format!("must not exceed the loading curve, which has {above} kN at {x} mm");
                return Err(check.error("force_kn", below, wanted));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_force_and_energy_of_a_polyline() {
        let curve =
            ForceCurve { deflection_mm: vec![0.0, 10.0, 30.0], force_kn: vec![0.0, 100.0, 200.0] };
        assert_eq!(curve.force_at_kn(20.0), 150.0);
        assert_eq!(curve.energy_to_kj(10.0), 0.5);
        assert_eq!(curve.energy_to_kj(20.0), 1.75);
    }
}
