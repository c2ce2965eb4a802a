//! The numbers that options take: what is right is said in words.

/// A finite number.
///
/// # Errors
/// When it is none.
pub fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ if text.contains(',') => Err("must be a number, with a decimal point".to_owned()),
        _ => Err("must be a number, without a unit".to_owned()),
    }
}

/// A number greater than zero.
///
/// # Errors
/// When it is not.
pub fn positive(text: &str) -> Result<f64, String> {
    within(text, |number| number > 0.0, "must be greater than zero")
}

/// A number that is zero or greater.
///
/// # Errors
/// When it is not.
pub fn not_negative(text: &str) -> Result<f64, String> {
    within(text, |number| number >= 0.0, "must not be negative")
}

/// A whole number from one on.
///
/// # Errors
/// When it is not.
pub fn count(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err("must be a whole number, at least 1".to_owned()),
    }
}

fn within(text: &str, possible: fn(f64) -> bool, wanted: &str) -> Result<f64, String> {
    let number = number(text)?;
    match possible(number) {
        true => Ok(number),
        false => Err(wanted.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_taken_in_every_notation_and_units_are_not() {
        assert_eq!(number("-1.5e3"), Ok(-1500.0));
        assert_eq!(positive("10s"), Err("must be a number, without a unit".to_owned()));
        assert_eq!(number("0,5"), Err("must be a number, with a decimal point".to_owned()));
        assert!(number("inf").is_err() && number("NaN").is_err() && number("").is_err());
    }

    #[test]
    fn bounds_have_their_ends() {
        assert_eq!(not_negative("0"), Ok(0.0));
        assert_eq!(positive("0"), Err("must be greater than zero".to_owned()));
        assert_eq!(not_negative("-1"), Err("must not be negative".to_owned()));
        assert_eq!(count("1"), Ok(1));
        for wrong in ["0", "-1", "1.5", "all"] {
            assert_eq!(count(wrong), Err("must be a whole number, at least 1".to_owned()));
        }
    }
}
