//! What can be wrong with a pair of profiles.

/// Why a wheel and a rail cannot be paired.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// No wheel profile has this name.
    #[error(
        "there is no wheel profile \"{name}\"; known are S1002, cone-1-n with n from 5 to 200, such as cone-1-20, and files of points that end in .prw, .whl, .wheel, .txt, .csv, .dat or .asc"
    )]
    UnknownWheelProfile {
        /// Name that was asked for.
        name: String,
    },
    /// No rail profile has this name.
    #[error(
        "there is no rail profile \"{name}\"; known are 60E1, AS60, UIC60-manchester, round-300, and files of points that end in .prr, .ban, .rail, .txt, .csv, .dat or .asc"
    )]
    UnknownRailProfile {
        /// Name that was asked for.
        name: String,
    },
    /// A file of points cannot be used.
    #[error("{file}: {reason}")]
    ProfileFile {
        /// Name of the file.
        file: String,
        /// What is wrong, with the line.
        reason: String,
    },
    /// A dimension lies outside what makes sense.
    #[error("{quantity} must be {allowed}, but is {value}")]
    OutOfRange {
        /// Which dimension.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// What is allowed, with unit.
        allowed: &'static str,
    },
    /// Wheel and rail do not meet.
    #[error(
        "the wheel {wheel} stands beside the rail {rail} at a lateral shift of {shift_mm} mm; gauge and flange-back distance do not fit each other"
    )]
    NoContact {
        /// Name of the wheel profile.
        wheel: String,
        /// Name of the rail profile.
        rail: String,
        /// Lateral shift in millimetres.
        shift_mm: f64,
    },
}
