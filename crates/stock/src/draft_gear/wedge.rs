//! Section `[wedge]` of the draft-gear file: the statics of a friction clutch.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// A friction clutch around the spring.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wedge {
    /// Angle of the wedge to the axis, degrees.
    pub angle_deg: f64,
    /// Friction between wedge and shoe.
    pub wedge_friction: f64,
    /// Friction between shoe and housing.
    pub housing_friction: f64,
}

impl Wedge {
    /// Force at the coupler over the force of the spring, pushed in and coming out
    /// (theory, eq. 7b and 7c).
    ///
    /// Statics of a wedge of the angle φ between spring and coupler, with the friction μ₁ at the
    /// wedge and μ₂ at the housing:
    ///
    /// ```text
    /// in:   F_c = F_s / (1 − μ₂ (1 − μ₁ tan φ)/(tan φ + μ₁))
    /// out:  F_c = F_s / (1 + μ₂ (1 + μ₁ tan φ)/(tan φ − μ₁))
    /// ```
    ///
    /// They are `docs/theory/longitudinal.md#eq-7b` and `docs/theory/longitudinal.md#eq-7c`. With μ₁ = 0
    /// they are the form of Cole, *Handbook of Railway Vehicle Dynamics*, 2006, ch. 9.
    pub(crate) fn force_ratios(&self, check: &Check) -> Result<(f64, f64), Mistake> {
        let Self { angle_deg, wedge_friction, housing_friction } = *self;
        check.between("angle_deg", angle_deg, 1.0, 89.0)?;
        check.between("wedge_friction", wedge_friction, 0.0, 1.0)?;
        check.between("housing_friction", housing_friction, 0.0, 1.0)?;
        let tan = libm::tan(angle_deg.to_radians());
        let held = housing_friction * (1.0 - wedge_friction * tan) / (tan + wedge_friction);
        if held >= 1.0 {
            let wanted = "the wedge jams: its angle is too small for this friction";
            return Err(check.error("angle_deg", angle_deg, wanted));
        }
        if tan <= wedge_friction {
            let wanted = "the wedge does not come out: its tangent must exceed wedge_friction";
            return Err(check.error("angle_deg", angle_deg, wanted));
        }
        let freed = housing_friction * (1.0 + wedge_friction * tan) / (tan - wedge_friction);
        Ok((1.0 / (1.0 - held), 1.0 / (1.0 + freed)))
    }
}

#[cfg(test)]
mod tests {
    use files::Document;

    use super::*;

    /// Loads on a wedge in equilibrium by its two equations, solved by hand as a linear system:
    /// along the axis `F_c = N (sin φ + μ₁ cos φ)` for the coupler's face, and `F_c − F_s = μ₂ P` with the
    /// pressure `P = N (cos φ − μ₁ sin φ)` on the housing; pushed in. Coming out, friction turns round.
    #[test]
    fn analytic_forces_are_in_equilibrium() {
        let document = Document::new("gear.toml", "");
        for (angle_deg, at_wedge, at_housing) in
            [(50.0, 0.1, 0.3), (45.0, 0.0, 0.4), (60.0, 0.2, 0.2)]
        {
            let wedge = Wedge { angle_deg, wedge_friction: at_wedge, housing_friction: at_housing };
            let (pushed_in, coming_out) = wedge.force_ratios(&document.check()).unwrap();
            let (sin, cos) = f64::to_radians(angle_deg).sin_cos();
            for (ratio, direction) in [(pushed_in, 1.0), (coming_out, -1.0)] {
                let face = ratio / (sin + direction * at_wedge * cos);
                let pressure = face * (cos - direction * at_wedge * sin);
                let balance = ratio - 1.0 - direction * at_housing * pressure;
                assert!(balance.abs() < 1e-12, "{angle_deg}: {balance}");
            }
        }
    }

    #[test]
    fn analytic_a_clutch_without_friction_is_its_spring() {
        let wedge = Wedge { angle_deg: 50.0, wedge_friction: 0.0, housing_friction: 0.0 };
        let document = Document::new("gear.toml", "");
        assert_eq!(wedge.force_ratios(&document.check()).unwrap(), (1.0, 1.0));
    }

    #[test]
    fn a_wedge_that_does_not_come_out_is_refused() {
        let wedge = Wedge { angle_deg: 10.0, wedge_friction: 0.3, housing_friction: 0.0 };
        let document = Document::new("gear.toml", "");
        let message = wedge.force_ratios(&document.check()).unwrap_err().to_string();
        assert!(message.contains("angle_deg = 10: the wedge does not come out"), "{message}");
    }
}
