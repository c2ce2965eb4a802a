//! Times as people read them.

/// A time in s as it is shown to people: to the nanosecond.
///
/// Times of a run are sums and products of its steps, so that their last digits are rounding: three steps of
/// 0.1 s end at 0.30000000000000004 s. Records and JSON keep all digits.
pub fn seconds(time: f64) -> f64 {
    let rounded = (time * 1e9).round() / 1e9;
    // No time is shown as -0, and one beyond the range of the product as it is.
    if rounded.is_finite() { rounded + 0.0 } else { time }
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn the_rounding_of_sums_of_steps_is_not_shown() {
        let mut time = 0.0;
        for _ in 0..3 {
            time += 0.1;
        }
        for (time, text) in [
            (time, "0.3"),
            (26.0 * 0.001, "0.026"),
            (1e-9, "0.000000001"),
            (-1e-12, "0"),
            (3600.0, "3600"),
            (123_456_789.000_25, "123456789.00025"),
            (1e300, &1e300.to_string()),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(seconds(time).to_string(), text);
        }
    }
}
