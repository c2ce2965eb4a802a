//! The keys of section `[resistance]` of the vehicle file on curves.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Formula of the curve resistance; the train model has the formulas themselves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CurveFormula {
    /// Proportional to mass and curvature, by `curve_n_m_per_t`.
    #[default]
    Radius,
    /// 0.8 lb for each short ton and degree of curve.
    Degree,
    /// Röckl's formula, with one branch above 300 m of radius and one below.
    Roeckl,
    /// N/t by curvature from the table.
    Table,
}

/// Curve resistance over curvature.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CurveTable {
    /// Curvatures, rising from zero, 1/km.
    pub per_km: Vec<f64>,
    /// Resistance, N/t.
    pub resistance_n_per_t: Vec<f64>,
}

impl CurveFormula {
    /// The table must be there where the formula needs it, and only there.
    pub(crate) fn check(self, table: Option<&CurveTable>, check: &Check) -> Result<(), Mistake> {
        match (self, table) {
            (Self::Table, Some(table)) => check.section("curve_table").columns(
                ("per_km", &table.per_km),
                ("resistance_n_per_t", &table.resistance_n_per_t),
                2,
            ),
            (Self::Table, None) => {
                Err(check.missing("curve_table", "the curve formula \"table\" needs it"))
            }
            (_, Some(_)) => {
                let wanted = "leave it out, or set curve_formula = \"table\"";
                Err(check.refuse("curve_table", wanted))
            }
            (_, None) => Ok(()),
        }
    }
}
