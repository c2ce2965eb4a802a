//! What a value must be, and the error that says so.

/// Why a rolling-stock file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum StockError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The file is not TOML, or has an unknown key, a missing key or a wrong type.
    #[error("{file}: {source}")]
    Syntax {
        /// File name.
        file: String,
        /// Reason.
        source: Box<toml::de::Error>,
    },
    /// A value is not possible.
    #[error("{file}: {key} = {value}: {wanted}")]
    Value {
        /// File name.
        file: String,
        /// Key.
        key: String,
        /// Value found.
        value: String,
        /// What would be right.
        wanted: String,
    },
}

/// Checks the values of one file, or of one section of it.
#[derive(Clone, Debug)]
pub struct Check<'a> {
    file: &'a str,
    section: String,
}

impl<'a> Check<'a> {
    /// Checks the values of `file`.
    pub fn new(file: &'a str) -> Self {
        let section = String::new();
        Self { file, section }
    }

    /// Checks the values of a section, whose name then stands before each key.
    #[must_use]
    pub fn section(&self, name: &str) -> Self {
        let section = format!("{}{name}.", self.section);
        Self { section, ..*self }
    }

    /// The error for a value that is not possible.
    pub fn error(&self, key: &str, value: impl ToString, wanted: impl Into<String>) -> StockError {
        StockError::Value {
            file: self.file.to_owned(),
            key: format!("{}{key}", self.section),
            value: value.to_string(),
            wanted: wanted.into(),
        }
    }

    /// A finite number greater than zero.
    ///
    /// # Errors
    /// When it is not.
    pub fn positive(&self, key: &str, value: f64) -> Result<(), StockError> {
        match value.is_finite() && value > 0.0 {
            true => Ok(()),
            false => Err(self.error(key, value, "must be greater than zero")),
        }
    }

    /// A number from `low` to `high`.
    ///
    /// # Errors
    /// When it is not.
    pub fn between(&self, key: &str, value: f64, low: f64, high: f64) -> Result<(), StockError> {
        match value >= low && value <= high {
            true => Ok(()),
            false => Err(self.error(key, value, format!("must lie between {low} and {high}"))),
        }
    }

    /// Two columns of a table: equally long, at least `rows`, the first one rising from row to
    /// row and beginning at zero, the second one without negative values.
    ///
    /// # Errors
    /// When one of this does not hold.
    pub fn columns(
        &self,
        (x_key, x): (&str, &[f64]),
        (y_key, y): (&str, &[f64]),
        rows: usize,
    ) -> Result<(), StockError> {
        if x.len() < rows || x.len() != y.len() {
            let wanted = format!("needs at least {rows} values, and as many as {y_key}");
            return Err(self.error(x_key, format!("{x:?}"), wanted));
        }
        if x[0] != 0.0 {
            return Err(self.error(&format!("{x_key}[1]"), x[0], "must be zero"));
        }
        for i in 1..x.len() {
            if !(x[i].is_finite() && x[i] > x[i - 1]) {
                let key = format!("{x_key}[{}]", i + 1);
                let wanted = format!("must be greater than the value before it, {}", x[i - 1]);
                return Err(self.error(&key, x[i], wanted));
            }
        }
        match y.iter().position(|y| !(y.is_finite() && *y >= 0.0)) {
            None => Ok(()),
            Some(i) => {
                let key = format!("{y_key}[{}]", i + 1);
                Err(self.error(&key, y[i], "must not be negative"))
            }
        }
    }
}
