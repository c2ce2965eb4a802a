//! The creep law of a vehicle's contacts: `[multibody.contact.creep]`.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Which creep law.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum CreepLawKind {
    /// Kalker's exact theory with the reduction of modified FASTSIM, by a table; `modified_fastsim` is
    /// its former name.
    #[default]
    #[serde(alias = "modified_fastsim")]
    ExactRolling,
    /// Modified FASTSIM as published, evaluated in every step: slow, for comparison.
    FastsimOnLine,
    /// Polach's closed formula.
    Polach,
    /// Kalker's linear theory limited after Shen, Hedrick and Elkins.
    ShenHedrickElkins,
    /// Kalker's linear theory without limit.
    KalkerLinear,
}

/// A creep law with its parameters and its friction.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CreepLaw {
    /// Where the values come from.
    pub source: String,
    /// Which law.
    #[serde(default)]
    pub law: CreepLawKind,
    /// Exact rolling and FASTSIM: initial slope of the creep curve by Kalker's (k0); left out: 1.
    pub initial_slope: Option<f64>,
    /// Exact rolling and FASTSIM: what is left of the slope at infinite creepage (alpha); left out: 1.
    pub remaining_slope: Option<f64>,
    /// Exact rolling and FASTSIM: how fast the slope falls (beta); left out: 0.
    pub slope_fall: Option<f64>,
    /// FASTSIM on line: strips of the contact on either side of its middle; left out: 5.
    pub strip_pairs: Option<usize>,
    /// FASTSIM on line: elements of each strip; left out: 20.
    pub elements: Option<usize>,
    /// Polach: reduction of the initial slope in the area of adhesion (kA).
    pub adhesion_factor: Option<f64>,
    /// Polach: reduction in the area of slip (kS).
    pub slip_factor: Option<f64>,
    /// Friction coefficient without slip (mu0), or up to the reference temperature (mu_ref).
    pub friction: f64,
    /// Friction at infinite slip velocity, or at the end of the range of temperature, by `friction` (A).
    pub limit_ratio: f64,
    /// Friction by slip velocity: its decay (B), s/m.
    pub decay_s_m: Option<f64>,
    /// Friction by temperature: range above the reference temperature over which it changes (dT), K.
    pub temperature_range_k: Option<f64>,
    /// Friction by temperature: temperature from which on it changes (T_ref), °C; left out: 0.
    pub reference_temperature_c: Option<f64>,
    /// Friction by temperature: that of wheel and rail away from the contact, °C; left out: 20.
    pub bulk_temperature_c: Option<f64>,
}

impl CreepLaw {
    /// Checks the values, and that each belongs to the law.
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        use CreepLawKind::{ExactRolling, FastsimOnLine, Polach};
        let fastsim: &[CreepLawKind] = &[ExactRolling, FastsimOnLine];
        let count = |number: Option<usize>| number.map(|number| number as f64);
        let most_slip = self.adhesion_factor.unwrap_or(1.0);
        for (key, value, laws, low, high) in [
            ("initial_slope", self.initial_slope, fastsim, 0.01, 1.0),
            ("remaining_slope", self.remaining_slope, fastsim, 0.001, 1.0),
            ("slope_fall", self.slope_fall, fastsim, 0.0, 100.0),
            ("strip_pairs", count(self.strip_pairs), &[FastsimOnLine], 1.0, 100.0),
            ("elements", count(self.elements), &[FastsimOnLine], 4.0, 1000.0),
            ("adhesion_factor", self.adhesion_factor, &[Polach], 0.01, 1.0),
            ("slip_factor", self.slip_factor, &[Polach], 0.01, most_slip),
        ] {
            match value {
                Some(value) if laws.contains(&self.law) => check.between(key, value, low, high)?,
                Some(value) => {
                    let laws: Vec<_> = laws.iter().map(|law| law.key()).collect();
                    let wanted = format!("is for law = {}", laws.join(" or "));
                    return Err(check.error(key, value, wanted));
                }
                None if laws == [Polach] && self.law == Polach => {
                    return Err(check.missing(key, "law = \"polach\" needs it"));
                }
                None => {}
            }
        }
        check.between("friction", self.friction, 0.01, 1.0)?;
        self.check_friction(check)
    }

    /// Friction depends on either the slip velocity or the temperature.
    fn check_friction(&self, check: &Check) -> Result<(), Mistake> {
        let by_temperature = [
            ("reference_temperature_c", self.reference_temperature_c),
            ("bulk_temperature_c", self.bulk_temperature_c),
        ];
        match (self.decay_s_m, self.temperature_range_k) {
            (Some(decay), None) => {
                if let Some((key, Some(value))) = by_temperature.into_iter().find(|k| k.1.is_some())
                {
                    return Err(check.error(key, value, "is for friction by temperature_range_k"));
                }
                check.between("limit_ratio", self.limit_ratio, 0.01, 1.0)?;
                check.between("decay_s_m", decay, 0.0, 10.0)
            }
            (None, Some(range)) => {
                check.between("limit_ratio", self.limit_ratio, 0.01, 5.0)?;
                check.between("temperature_range_k", range, 1.0, 10e3)?;
                for (key, value) in by_temperature {
                    check.between(key, value.unwrap_or(0.0), -273.0, 2000.0)?;
                }
                Ok(())
            }
            (Some(_), Some(range)) => {
                let wanted = "stands beside decay_s_m: friction depends on one of the two";
                Err(check.error("temperature_range_k", range, wanted))
            }
            (None, None) => {
                let wanted = "friction needs it, or temperature_range_k (decay_s_m = 0: constant)";
                Err(check.missing("decay_s_m", wanted))
            }
        }
    }
}

impl CreepLawKind {
    /// The law as files write it.
    fn key(self) -> &'static str {
        match self {
            Self::ExactRolling => "\"exact_rolling\"",
            Self::FastsimOnLine => "\"fastsim_on_line\"",
            Self::Polach => "\"polach\"",
            Self::ShenHedrickElkins => "\"shen_hedrick_elkins\"",
            Self::KalkerLinear => "\"kalker_linear\"",
        }
    }
}

#[cfg(test)]
mod tests {
    use files::Document;

    use super::*;

    fn checked(text: &str) -> Result<(), Mistake> {
        with_friction(&format!("limit_ratio = 0.4\ndecay_s_m = 0.6\n{text}"))
    }

    fn with_friction(text: &str) -> Result<(), Mistake> {
        let document =
            Document::new("v.toml", format!("source = \"test\"\nfriction = 0.3\n{text}"));
        document.parse::<CreepLaw>()?.check(&document.check())
    }

    #[test]
    fn friction_depends_on_slip_or_on_temperature() {
        with_friction("limit_ratio = 0.4\ntemperature_range_k = 400").unwrap();
        with_friction("limit_ratio = 1.5\ntemperature_range_k = 400\nbulk_temperature_c = 30")
            .unwrap();
        for (text, expected) in [
            ("limit_ratio = 0.4", "decay_s_m"),
            ("limit_ratio = 0.4\ndecay_s_m = 0.6\ntemperature_range_k = 400", "one of the two"),
            ("limit_ratio = 0.4\ndecay_s_m = 0.6\nbulk_temperature_c = 30", "is for friction by"),
            ("limit_ratio = 0.4\ntemperature_range_k = 0", "between 1 and 10000"),
            ("limit_ratio = 1.5\ndecay_s_m = 0.6", "between 0.01 and 1"),
        ] {
            let error = with_friction(text).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }

    #[test]
    fn the_former_name_of_exact_rolling_still_serves() {
        checked("law = \"exact_rolling\"\nslope_fall = 0.62").unwrap();
        checked("law = \"modified_fastsim\"\nslope_fall = 0.62").unwrap();
    }

    #[test]
    fn every_law_takes_its_own_keys() {
        for text in [
            "",
            "initial_slope = 0.54\nremaining_slope = 0.02\nslope_fall = 0.62",
            "law = \"fastsim_on_line\"\nstrip_pairs = 5\nelements = 20",
            "law = \"polach\"\nadhesion_factor = 0.56\nslip_factor = 0.29",
            "law = \"shen_hedrick_elkins\"",
            "law = \"kalker_linear\"",
        ] {
            checked(text).unwrap();
        }
    }

    #[test]
    fn keys_of_another_law_and_missing_ones_are_named() {
        for (text, expected) in [
            ("adhesion_factor = 0.5", "is for law = \"polach\""),
            ("law = \"polach\"\nadhesion_factor = 0.5", "law = \"polach\" needs it"),
            ("law = \"kalker_linear\"\nslope_fall = 1.0", "is for law = \"exact_rolling\" or"),
            ("initial_slope = 2.0", "between 0.01 and 1"),
        ] {
            let error = checked(text).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
