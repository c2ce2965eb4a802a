//! When and how a run began, as its manifest has it.

use std::path::Path;
use std::time::SystemTime;

use chrono::{DateTime, SecondsFormat, Utc};

/// A time as `2026-11-30T09:16:02Z`.
pub fn utc(time: SystemTime) -> String {
    DateTime::<Utc>::from(time).to_rfc3339_opts(SecondsFormat::Secs, true)
}

/// The words of a command, the program without its folder; those with blanks in quotation marks.
pub fn command(words: impl IntoIterator<Item = String>) -> String {
    let word = |(number, word): (usize, String)| match (number, word.contains(' ')) {
        (0, _) => Path::new(&word).file_name().unwrap_or_default().to_string_lossy().into_owned(),
        (_, true) => format!("\"{word}\""),
        (_, false) => word,
    };
    words.into_iter().enumerate().map(word).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, UNIX_EPOCH};

    use super::*;

    /// The second times are those of `date --utc --date @SECONDS`.
    #[test]
    fn benchmark_dates() {
        for (seconds, date) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(utc(UNIX_EPOCH + Duration::from_secs(seconds)), date);
        }
    }

    #[test]
    fn a_command_can_be_given_again() {
        let words = ["/usr/bin/hotfoot", "run", "my scenario"].map(str::to_owned);
        assert_eq!(command(words), "hotfoot run \"my scenario\"");
    }
}
