//! What values a parameter may have, and the sentences that say so.

use fmu::ModelError;

/// How many parts of `part` make up `whole`; at least two and, but for rounding, a whole number.
pub(crate) fn whole(name: &str, whole: f64, part_name: &str, part: f64) -> Result<f64, ModelError> {
    let whole = positive(name, whole)?;
    let parts = (whole / part).round();
    if parts >= 2.0 && (parts * part - whole).abs() <= 1e-6 * part {
        return Ok(parts);
    }
    Err(ModelError::new(format!(
        "{name} = {whole} m and {part_name} = {part} m: the first must be the second times a whole \
         number of at least 2"
    )))
}

pub(crate) fn positive(name: &str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(wrong(name, value, "must be greater than zero"))
    }
}

pub(crate) fn not_negative(name: &str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(wrong(name, value, "must not be negative"))
    }
}

pub(crate) fn share(name: &str, value: f64) -> Result<f64, ModelError> {
    if (0.0..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(wrong(name, value, "must be from 0 to 1"))
    }
}

pub(crate) fn wrong(name: &str, value: f64, wanted: &str) -> ModelError {
    ModelError::new(format!("{name} = {value}: {wanted}"))
}
