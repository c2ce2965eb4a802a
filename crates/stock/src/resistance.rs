//! Section `[resistance]` of the vehicle file.
//!
//! Each formula comes down to `factor (constant + linear V + quadratic V²)` in N with the speed V in
//! km/h, or to a table.

use files::{Check, Mistake};
use serde::Deserialize;

use crate::curve_resistance::{CurveFormula, CurveTable};
use crate::propulsion::EffortBySpeed;

/// Newtons in a pound of force.
const POUND: f64 = 4.448_221_615;
/// Tonnes in a short ton.
const SHORT_TON: f64 = 0.907_184_74;
/// Kilometres in a mile.
const MILE: f64 = 1.609_344;
/// Square feet in a square metre.
const SQUARE_FEET: f64 = 10.763_910_4;

/// Which formula of the propulsion resistance holds. W is the mass and w the axle load in short
/// tons, V the speed in mph, A the area in ft², all in lb per short ton; m is the mass and m_a the
/// axle load in t, V in km/h where N is the unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ResistanceFormula {
    /// `constant m + axle n + linear m V + quadratic V²` with the coefficients of the file, N.
    #[default]
    Coefficients,
    /// Davis 1926: `1.3 + 29/w + 0.045 V + C A V²/W`; C = 0.0005 and A = 90 ft² for freight cars.
    Davis,
    /// Modified Davis, AAR RP-548: `1.3 + 72.5/W + 0.015 V + 0.055 V²/W`.
    AarRp548,
    /// AREMA 1970: `0.6 + 20/w + 0.01 V + K V²/W`; K = 0.07 conventional equipment, 0.0935
    /// containers, 0.16 trailers on flat cars.
    Arema,
    /// Canadian National 1992: `1.5 + 18 n/W + 0.03 V + C A V²/(10000 W)`.
    CanadianNational,
    /// Cole 2006: `2.943 + 89.2/m_a + 0.0306 V + 1.741 K V²/m` N/t; its factor Ka is `factor`.
    Cole,
    /// Force by speed from the table.
    Table,
}

/// Section `[resistance]`: propulsion and curve resistance.
#[derive(Clone, Debug, PartialEq, Deserialize)]
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

/// Propulsion resistance `constant + linear V + quadratic V²`, N with V in km/h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DavisCoefficients {
    /// N.
    pub constant_n: f64,
    /// N/(km/h).
    pub linear_n_per_kmh: f64,
    /// N/(km/h)²; the air's part.
    pub quadratic_n_per_kmh2: f64,
}

fn one() -> f64 {
    1.0
}

fn three() -> f64 {
    3.0
}

impl Resistance {
    /// The coefficients for a vehicle of a mass, t, on axles; those of a table are zero.
    pub fn coefficients(&self, mass_t: f64, axles: f64) -> DavisCoefficients {
        let tons = mass_t / SHORT_TON;
        let air = self.air_coefficient.unwrap_or_default();
        let area = self.area_m2.unwrap_or_default() * SQUARE_FEET;
        // Parts in lb of force and mph: by the vehicle, by speed, by its square.
        let imperial = |constant: f64, linear: f64, quadratic: f64| DavisCoefficients {
            constant_n: constant * POUND,
            linear_n_per_kmh: linear * POUND / MILE,
            quadratic_n_per_kmh2: quadratic * POUND / (MILE * MILE),
        };
        let metric = |constant_n, linear_n_per_kmh, quadratic_n_per_kmh2| DavisCoefficients {
            constant_n,
            linear_n_per_kmh,
            quadratic_n_per_kmh2,
        };
        let formula = match self.formula {
            ResistanceFormula::Coefficients => metric(
                self.constant_n_per_t * mass_t + self.axle_n * axles,
                self.linear_n_per_t_kmh * mass_t,
                self.quadratic_n_per_kmh2,
            ),
            ResistanceFormula::Davis => {
                imperial(1.3 * tons + 29.0 * axles, 0.045 * tons, air * area)
            }
            ResistanceFormula::AarRp548 => imperial(1.3 * tons + 72.5, 0.015 * tons, 0.055),
            ResistanceFormula::Arema => imperial(0.6 * tons + 20.0 * axles, 0.01 * tons, air),
            ResistanceFormula::CanadianNational => {
                imperial(1.5 * tons + 18.0 * axles, 0.03 * tons, air * area * 1e-4)
            }
            ResistanceFormula::Cole => {
                metric(2.943 * mass_t + 89.2 * axles, 0.0306 * mass_t, 1.741 * air)
            }
            ResistanceFormula::Table => metric(0.0, 0.0, 0.0),
        };
        DavisCoefficients {
            constant_n: self.factor * formula.constant_n,
            linear_n_per_kmh: self.factor * formula.linear_n_per_kmh,
            quadratic_n_per_kmh2: self.factor * formula.quadratic_n_per_kmh2,
        }
    }

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

    /// Source: project reference 3.1, the table for a wagon of 134 t on four axles, N/t at 0, 20,
    /// 40, 60 and 80 km/h; the tolerance is the rounding of its figures. The reference prints
    /// AREMA's figures for Cole's formula, too, whose metric coefficients are rounded otherwise;
    /// those of Cole are by hand.
    #[test]
    fn benchmark_formulas_for_a_wagon_of_134_t() {
        let published: [(&str, [f64; 5]); 5] = [
            (
                "formula = 'davis'\narea_m2 = 8.3613\nair_coefficient = 0.0005",
                [10.23, 13.20, 16.63, 20.53, 24.88],
            ),
            ("formula = 'aar-rp548'", [8.78, 9.98, 11.74, 14.06, 16.95]),
            (
                "formula = 'canadian-national'\narea_m2 = 9.7548\nair_coefficient = 4.2",
                [9.75, 11.80, 14.31, 17.26, 20.67],
            ),
            ("formula = 'arema'\nair_coefficient = 0.07", [5.60, 6.57, 8.25, 10.66, 13.78]),
            ("formula = 'cole'\nair_coefficient = 0.07", [5.61, 6.58, 8.28, 10.72, 13.87]),
        ];
        for (text, expected) in published {
            let c = resistance(text).unwrap().coefficients(134.0, 4.0);
            for (i, expected) in expected.into_iter().enumerate() {
                let v = 20.0 * i as f64;
                let force = c.constant_n + v * (c.linear_n_per_kmh + v * c.quadratic_n_per_kmh2);
                assert!((force / 134.0 - expected).abs() < 0.01, "{text}: {}", force / 134.0);
            }
        }
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
