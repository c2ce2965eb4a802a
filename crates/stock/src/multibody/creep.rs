//! The creep law of a vehicle's contacts: `[multibody.contact.creep]`.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Which creep law.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum CreepLawKind {
    /// Modified FASTSIM, by a table.
    #[default]
    ModifiedFastsim,
    /// Modified FASTSIM, evaluated in every step: slow, for comparison.
    FastsimOnLine,
    /// Polach's closed formula.
    Polach,
    /// Kalker's linear theory limited after Shen, Hedrick and Elkins.
    ShenHedrickElkins,
    /// Kalker's linear theory without limit.
    KalkerLinear,
}

/// A creep law with its parameters and its falling friction.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CreepLaw {
    /// Where the values come from.
    pub source: String,
    /// Which law.
    #[serde(default)]
    pub law: CreepLawKind,
    /// Modified FASTSIM: initial slope of the creep curve by Kalker's (k0); left out: 1.
    pub initial_slope: Option<f64>,
    /// Modified FASTSIM: what is left of the slope at infinite creepage (alpha); left out: 1.
    pub remaining_slope: Option<f64>,
    /// Modified FASTSIM: how fast the slope falls (beta); left out: 0.
    pub slope_fall: Option<f64>,
    /// FASTSIM on line: strips of the contact on either side of its middle; left out: 5.
    pub strip_pairs: Option<usize>,
    /// FASTSIM on line: elements of each strip; left out: 20.
    pub elements: Option<usize>,
    /// Polach: reduction of the initial slope in the area of adhesion (kA).
    pub adhesion_factor: Option<f64>,
    /// Polach: reduction in the area of slip (kS).
    pub slip_factor: Option<f64>,
    /// Friction coefficient without slip (mu0).
    pub friction: f64,
    /// Ratio of the friction at infinite slip velocity to `friction` (A).
    pub limit_ratio: f64,
    /// Decay of the friction with the slip velocity (B), s/m.
    pub decay_s_m: f64,
}

impl CreepLaw {
    /// Checks the values, and that each belongs to the law.
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        use CreepLawKind::{FastsimOnLine, ModifiedFastsim, Polach};
        let fastsim: &[CreepLawKind] = &[ModifiedFastsim, FastsimOnLine];
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
        check.between("limit_ratio", self.limit_ratio, 0.01, 1.0)?;
        check.between("decay_s_m", self.decay_s_m, 0.0, 10.0)
    }
}

impl CreepLawKind {
    /// The law as files write it.
    fn key(self) -> &'static str {
        match self {
            Self::ModifiedFastsim => "\"modified_fastsim\"",
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
        let friction = "source = \"test\"\nfriction = 0.3\nlimit_ratio = 0.4\ndecay_s_m = 0.6\n";
        let document = Document::new("v.toml", format!("{friction}{text}"));
        document.parse::<CreepLaw>()?.check(&document.check())
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
            ("law = \"kalker_linear\"\nslope_fall = 1.0", "is for law = \"modified_fastsim\" or"),
            ("initial_slope = 2.0", "between 0.01 and 1"),
        ] {
            let error = checked(text).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
