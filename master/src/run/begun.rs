//! When and how a run began, as its manifest has it.

use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// Seconds of a day.
const DAY: u64 = 86_400;

/// A time as `2026-11-30T09:16:02Z`.
pub fn utc(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (mut days, mut year) = (seconds / DAY, 1970);
    while days >= days_of_year(year) {
        days -= days_of_year(year);
        year += 1;
    }
    let mut month = 1;
    while days >= days_of_month(year, month) {
        days -= days_of_month(year, month);
        month += 1;
    }
    let (of_day, day) = (seconds % DAY, days + 1);
    let [hour, minute, second] = [of_day / 3600, of_day / 60 % 60, of_day % 60];
    format!("{year}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// Every fourth year is a leap year, but of the hundreds only every fourth.
fn is_leap(year: u64) -> bool {
    year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
}

fn days_of_year(year: u64) -> u64 {
    365 + u64::from(is_leap(year))
}

fn days_of_month(year: u64, month: u64) -> u64 {
    match month {
        2 => 28 + u64::from(is_leap(year)),
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
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
    use std::time::Duration;

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
