//! Section `[resistance]` of the vehicle file.
//!
//! The formulas themselves are those of the train model; here stands what each needs from the file.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::curve_resistance::{CurveFormula, CurveTable};
use crate::propulsion::EffortBySpeed;

/// Formula of the propulsion resistance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ResistanceFormula {
    /// `constant m + axle n + linear m V + quadratic V²` with the coefficients of the file.
    #[default]
    Coefficients,
    /// Davis 1926; needs the area and its C.
    Davis,
    /// Modified Davis, AAR RP-548.
    AarRp548,
    /// AREMA 1970; needs its K.
    Arema,
    /// Canadian National 1992; needs the area and its C.
    CanadianNational,
    /// Cole 2006; needs K, and `factor` is its Ka.
    Cole,
    /// Force by speed from the table.
    Table,
}

/// Section `[resistance]`: propulsion and curve resistance.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Resistance {
    /// Formula of the propulsion resistance.
    #[serde(default)]
    pub formula: ResistanceFormula,
    /// Factor on the propulsion resistance.
    #[serde(default = "one")]
    pub factor: f64,
    /// Part by mass, N/t.
    #[serde(default)]
    pub constant_n_per_t: f64,
    /// Part by axles, N.
    #[serde(default)]
    pub axle_n: f64,
    /// Part by mass and speed, N/(t km/h).
    #[serde(default)]
    pub linear_n_per_t_kmh: f64,
    /// Part by the square of the speed, N/(km/h)².
    #[serde(default)]
    pub quadratic_n_per_kmh2: f64,
    /// Frontal area A of Davis and Canadian National, m².
    pub area_m2: Option<f64>,
    /// C of Davis and Canadian National, K of AREMA and Cole.
    pub air_coefficient: Option<f64>,
    /// Force by speed, for the formula "table".
    pub table: Option<EffortBySpeed>,
    /// What it takes to set the vehicle in motion beyond the rolling resistance, N/t.
    #[serde(default)]
    pub starting_n_per_t: f64,
    /// Speed at which nothing of that is left, km/h.
    #[serde(default = "three")]
    pub starting_until_kmh: f64,
    /// Formula of the curve resistance.
    #[serde(default)]
    pub curve_formula: CurveFormula,
    /// Curve resistance times radius, N m/t.
    #[serde(default)]
    pub curve_n_m_per_t: f64,
    /// Curve resistance by curvature, for the formula "table".
    pub curve_table: Option<CurveTable>,
}

fn one() -> f64 {
    1.0
}

fn three() -> f64 {
    3.0
}

impl Resistance {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("factor", self.factor, 0.0, 10.0)?;
        check.between("constant_n_per_t", self.constant_n_per_t, 0.0, 1000.0)?;
        check.between("axle_n", self.axle_n, 0.0, 1e4)?;
        check.between("linear_n_per_t_kmh", self.linear_n_per_t_kmh, 0.0, 10.0)?;
        check.between("quadratic_n_per_kmh2", self.quadratic_n_per_kmh2, 0.0, 100.0)?;
        check.between("curve_n_m_per_t", self.curve_n_m_per_t, 0.0, 1e5)?;
        check.between("starting_n_per_t", self.starting_n_per_t, 0.0, 1000.0)?;
        check.between("starting_until_kmh", self.starting_until_kmh, 0.1, 50.0)?;
        self.check_what_the_formula_needs(check)?;
        self.check_tables(check)
    }

    /// What a formula needs must be there, and what it does not use must not.
    fn check_what_the_formula_needs(&self, check: &Check) -> Result<(), Mistake> {
        use ResistanceFormula::{Arema, CanadianNational, Coefficients, Cole, Davis, Table};
        let formula = self.formula;
        let used: [(&str, Option<f64>, &[ResistanceFormula]); 7] = [
            ("constant_n_per_t", nonzero(self.constant_n_per_t), &[Coefficients]),
            ("axle_n", nonzero(self.axle_n), &[Coefficients]),
            ("linear_n_per_t_kmh", nonzero(self.linear_n_per_t_kmh), &[Coefficients]),
            ("quadratic_n_per_kmh2", nonzero(self.quadratic_n_per_kmh2), &[Coefficients]),
            ("area_m2", self.area_m2, &[Davis, CanadianNational]),
            ("air_coefficient", self.air_coefficient, &[Davis, Arema, CanadianNational, Cole]),
            ("table", self.table.as_ref().map(|_| 1.0), &[Table]),
        ];
        for (key, value, users) in used {
            match value {
                Some(value) if !users.contains(&formula) => {
                    let wanted = format!(
                        "the formula {formula:?} does not use it; leave it out \
                         (without = [\"resistance\"] when it comes from another vehicle)"
                    );
                    return Err(check.error(key, value, wanted));
                }
                None if users.contains(&formula) && formula != Coefficients => {
                    let what_for = format!("the formula {formula:?} needs it");
                    return Err(check.missing(key, what_for));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn check_tables(&self, check: &Check) -> Result<(), Mistake> {
        if let Some(area) = self.area_m2 {
            check.between("area_m2", area, 0.1, 100.0)?;
        }
        if let Some(air) = self.air_coefficient {
            check.between("air_coefficient", air, 0.0, 1000.0)?;
        }
        if let Some(table) = &self.table {
            table.check(&check.section("table"))?;
        }
        self.curve_formula.check(self.curve_table.as_ref(), check)
    }
}

fn nonzero(value: f64) -> Option<f64> {
    (value != 0.0).then_some(value)
}

#[cfg(test)]
mod tests {
    use files::Document;

    use super::*;

    fn resistance(text: &str) -> Result<Resistance, Mistake> {
        let document = Document::new("v.toml", text);
        let resistance: Resistance = document.parse()?;
        resistance.check(&document.check())?;
        Ok(resistance)
    }

    #[test]
    fn a_formula_without_what_it_needs_is_refused() {
        let message = resistance("formula = 'arema'").unwrap_err().to_string();
        assert!(
            message.contains("air_coefficient is missing: the formula Arema needs it"),
            "{message}"
        );
    }

    #[test]
    fn a_coefficient_that_the_formula_does_not_use_is_refused() {
        let text = "formula = 'aar-rp548'\naxle_n = 80.0";
        let message = resistance(text).unwrap_err().to_string();
        assert!(
            message.contains("axle_n = 80.0: the formula AarRp548 does not use it"),
            "{message}"
        );
    }
}
