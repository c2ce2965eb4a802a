//! The draft-gear file: one gear as its maker or a test describes it.
//!
//! ```toml
//! name = "Elastic gear of the Train Propulsion Simulator"
//! source = "its example input"
//! locked_stiffness_mn_m = 200.0     # between the loading and the unloading curve
//! structure_stiffness_mn_m = 150.0  # added beyond the last point of the curves
//! damping_kn_s_m = 0.0              # viscous, in parallel; may be left out
//! [loading]
//! deflection_mm = [0.0, 19.05, 76.2, 101.6]
//! force_kn = [0.0, 889.6, 1445.7, 1779.3]
//! # [unloading] with the same keys; left out: the gear is elastic
//! ```

use serde::Deserialize;

use crate::check::{Check, StockError};

/// A draft gear. It works in draft and in buff alike, as a gear in a yoke does.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DraftGear {
    /// Name for people.
    pub name: String,
    /// Where the values come from.
    pub source: String,
    /// Slope of the force while friction holds the gear between its two curves, MN/m.
    pub locked_stiffness_mn_m: f64,
    /// Slope beyond the last point of the curves, where the gear is solid, MN/m.
    pub structure_stiffness_mn_m: f64,
    /// Viscous damping in parallel to the curves, kN s/m.
    #[serde(default)]
    pub damping_kn_s_m: f64,
    /// Force while the gear is pushed in.
    pub loading: ForceCurve,
    /// Force while it comes out again; none: the loading curve.
    pub unloading: Option<ForceCurve>,
}

/// Force over deflection by points, linear between them, from zero at zero.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceCurve {
    /// Deflections, rising, mm.
    pub deflection_mm: Vec<f64>,
    /// Forces, rising, kN.
    pub force_kn: Vec<f64>,
}

impl DraftGear {
    /// The loading and the unloading curve.
    pub fn curves(&self) -> (&ForceCurve, &ForceCurve) {
        (&self.loading, self.unloading.as_ref().unwrap_or(&self.loading))
    }

    pub(crate) fn check(&self, file: &str) -> Result<(), StockError> {
        let check = Check::new(file);
        check.between("locked_stiffness_mn_m", self.locked_stiffness_mn_m, 1.0, 2000.0)?;
        check.between("structure_stiffness_mn_m", self.structure_stiffness_mn_m, 1.0, 2000.0)?;
        check.between("damping_kn_s_m", self.damping_kn_s_m, 0.0, 1000.0)?;
        if self.structure_stiffness_mn_m >= self.locked_stiffness_mn_m {
            return Err(check.error(
                "structure_stiffness_mn_m",
                self.structure_stiffness_mn_m,
                "must be less than locked_stiffness_mn_m",
            ));
        }
        let locked = self.locked_stiffness_mn_m;
        self.loading.check(&check.section("loading"), locked)?;
        match &self.unloading {
            None => Ok(()),
            Some(unloading) => {
                unloading.check(&check.section("unloading"), locked)?;
                self.check_unloading_is_below(unloading, &check.section("unloading"))
            }
        }
    }

    /// A gear gives back less than it took: at no force is its unloading curve left of the
    /// loading curve, and both end at the same deflection.
    fn check_unloading_is_below(
        &self,
        unloading: &ForceCurve,
        check: &Check,
    ) -> Result<(), StockError> {
        let travel = self.loading.travel_mm();
        if unloading.travel_mm() != travel {
            let wanted = format!("must end at the travel of the loading curve, {travel}");
            return Err(check.error("deflection_mm", unloading.travel_mm(), wanted));
        }
        let deflections = self.loading.deflection_mm.iter().chain(&unloading.deflection_mm);
        for &x in deflections {
            let (above, below) = (self.loading.force_at_kn(x), unloading.force_at_kn(x));
            if below > above {
                let wanted =
                    format!("must not exceed the loading curve, which has {above} kN at {x} mm");
                return Err(check.error("force_kn", below, wanted));
            }
        }
        Ok(())
    }
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

    fn check(&self, check: &Check, locked_stiffness_mn_m: f64) -> Result<(), StockError> {
        let (x, f) = (&self.deflection_mm, &self.force_kn);
        check.columns(("deflection_mm", x), ("force_kn", f), 2)?;
        if f[0] != 0.0 {
            let wanted = "must be zero; begin with a steep piece for a gear with preload";
            return Err(check.error("force_kn[1]", f[0], wanted));
        }
        for i in 1..f.len() {
            // kN/mm and MN/m are the same.
            let slope = (f[i] - f[i - 1]) / (x[i] - x[i - 1]);
            if !(slope > 0.0 && slope < locked_stiffness_mn_m) {
                let wanted = format!(
                    "must rise from the value before it, {}, with less than \
                     locked_stiffness_mn_m = {locked_stiffness_mn_m}",
                    f[i - 1]
                );
                return Err(check.error(&format!("force_kn[{}]", i + 1), f[i], wanted));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve() -> ForceCurve {
        ForceCurve { deflection_mm: vec![0.0, 10.0, 30.0], force_kn: vec![0.0, 100.0, 200.0] }
    }

    #[test]
    fn analytic_force_and_energy_of_a_polyline() {
        assert_eq!(curve().force_at_kn(20.0), 150.0);
        assert_eq!(curve().energy_to_kj(10.0), 0.5);
        assert_eq!(curve().energy_to_kj(20.0), 1.75);
    }

    #[test]
    fn an_unloading_curve_above_the_loading_curve_is_refused() {
        let mut unloading = curve();
        unloading.force_kn[1] = 120.0;
        let gear = DraftGear {
            name: "gear".into(),
            source: "test".into(),
            locked_stiffness_mn_m: 100.0,
            structure_stiffness_mn_m: 50.0,
            damping_kn_s_m: 0.0,
            loading: curve(),
            unloading: Some(unloading),
        };
        let message = gear.check("gear.toml").unwrap_err().to_string();
        assert!(message.starts_with("gear.toml: unloading.force_kn = 120: must not exceed"));
    }
}
