//! What the run says about the foot of the rail.
//!
//! Its highest rise so far, when a camera could first see it, and what a camera on the train
//! itself sees. All are rises over untouched rail at the same time: what the train has done.

use serde::{Deserialize, Serialize};

/// A rise of the foot with its chainage and time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Rise, K.
    pub rise: f64,
    /// Chainage, m.
    pub chainage: f64,
    /// Time, s.
    pub time: f64,
}

/// The findings of a run so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The highest rise along the track now.
    pub present: Finding,
    /// The highest rise so far.
    pub highest: Finding,
    /// Where and when the detection threshold was first reached.
    pub detected: Option<Finding>,
    /// What a camera over the last wheel sees now.
    pub from_train: Finding,
    /// The most that it has seen.
    pub highest_from_train: Finding,
}

impl Answer {
    /// Takes the highest rise of the foot at a time.
    pub fn note(&mut self, finding: Finding, threshold: f64) {
        self.present = finding;
        if finding.rise > self.highest.rise {
            self.highest = finding;
        }
        if self.detected.is_none() && finding.rise >= threshold {
            self.detected = Some(finding);
        }
    }

    /// Takes the rise of the foot under the last wheel.
    pub fn note_from_train(&mut self, finding: Finding) {
        self.from_train = finding;
        if finding.rise > self.highest_from_train.rise {
            self.highest_from_train = finding;
        }
    }
}
