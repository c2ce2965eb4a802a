//! What the values of a TOML file must be.

use crate::document::Document;
use crate::key::{self, Found};
use crate::mistake::{Mark, Mistake, is_short};

/// Checks the values of a document, or of one section of it.
///
/// Keys are written as in `key.rs`, the elements of lists numbered from 1.
#[derive(Clone, Debug)]
pub struct Check<'a> {
    document: &'a Document,
    section: String,
}

impl Document {
    /// Checks for the values of the TOML text.
    pub fn check(&self) -> Check<'_> {
        Check::new(self)
    }
}

impl<'a> Check<'a> {
    /// Checks the values of a document.
    pub fn new(document: &'a Document) -> Self {
        Self { document, section: String::new() }
    }

    /// Checks the values of a section, whose name then stands before each key.
    #[must_use]
    pub fn section(&self, name: &str) -> Self {
        Self { section: format!("{}{name}.", self.section), ..*self }
    }

    /// Checks the values of an element of a list of sections; `index` counts from 0.
    #[must_use]
    pub fn element(&self, list: &str, index: usize) -> Self {
        self.section(&format!("{list}[{}]", index + 1))
    }

    /// A value that is not possible, as the file has it if it is there, and what would be right.
    pub fn error(&self, key: &str, value: impl ToString, wanted: impl AsRef<str>) -> Mistake {
        self.about_value(key, Some(value.to_string()), wanted.as_ref())
    }

    /// The same for a value that only the file knows.
    pub fn wrong(&self, key: &str, wanted: impl AsRef<str>) -> Mistake {
        self.about_value(key, None, wanted.as_ref())
    }

    fn about_value(&self, key: &str, value: Option<String>, wanted: &str) -> Mistake {
        let key = self.full(key);
        let (mark, written) = match key::find(self.document.text(), &key) {
            Some(Found::Value(bytes)) => {
                let written = self.document.text().get(bytes.clone()).map(str::to_owned);
                // Of a list or a section the caller names the part that is wrong.
                let whole = |written: &String| value.is_some() && written.starts_with(['[', '{']);
                (Some(bytes), written.filter(|written| !whole(written)))
            }
            Some(Found::Holder(bytes)) => (Some(bytes), None),
            None => (None, None),
        };
        let sentence = match written.or(value).filter(|value| is_short(value)) {
            Some(value) => format!("{key} = {value}: {wanted}"),
            None => format!("{key}: {wanted}"),
        };
        self.mistake(mark, sentence)
    }

    /// A section or key as a whole that cannot be, and why.
    pub fn refuse(&self, key: &str, why: impl AsRef<str>) -> Mistake {
        self.about(key, &format!(": {}", why.as_ref()))
    }

    /// A key that is needed and not there, and what for.
    pub fn missing(&self, key: &str, what_for: impl AsRef<str>) -> Mistake {
        self.about(key, &format!(" is missing: {}", what_for.as_ref()))
    }

    fn about(&self, key: &str, rest: &str) -> Mistake {
        let key = self.full(key);
        let mark = key::find(self.document.text(), &key).map(|found| match found {
            Found::Value(bytes) | Found::Holder(bytes) => bytes,
        });
        self.mistake(mark, format!("{key}{rest}"))
    }

    fn full(&self, key: &str) -> String {
        format!("{}{key}", self.section)
    }

    fn mistake(&self, mark: Option<std::ops::Range<usize>>, sentence: String) -> Mistake {
        let mark = mark.map(|bytes| Mark::new(self.document.text(), bytes));
        Mistake { mark, ..Mistake::in_file(self.document.name(), sentence) }
    }

    /// A value for which `possible` holds; `wanted` says in words what that is.
    ///
    /// # Errors
    /// When it does not hold.
    pub fn ensure(
        &self,
        possible: bool,
        key: &str,
        value: impl ToString,
        wanted: &str,
    ) -> Result<(), Mistake> {
        match possible {
            true => Ok(()),
            false => Err(self.error(key, value, wanted)),
        }
    }

    /// A finite number greater than zero.
    ///
    /// # Errors
    /// When it is not.
    pub fn positive(&self, key: &str, value: f64) -> Result<(), Mistake> {
        let possible = value.is_finite() && value > 0.0;
        self.ensure(possible, key, value, "must be greater than zero")
    }

    /// A number from `low` to `high`.
    ///
    /// # Errors
    /// When it is not.
    pub fn between(&self, key: &str, value: f64, low: f64, high: f64) -> Result<(), Mistake> {
        let possible = value >= low && value <= high;
        self.ensure(possible, key, value, &format!("must lie between {low} and {high}"))
    }

    /// A share from 0 to `most`, which many write in percent.
    ///
    /// # Errors
    /// When it is not.
    pub fn share(&self, key: &str, value: f64, most: f64) -> Result<(), Mistake> {
        let hint = match value > most && value <= 100.0 {
            true => format!("; it is a share: {} for {value} %", value / 100.0),
            false => String::new(),
        };
        let possible = value >= 0.0 && value <= most;
        self.ensure(possible, key, value, &format!("must lie between 0 and {most}{hint}"))
    }

    /// Numbers that rise from each to the next.
    ///
    /// # Errors
    /// When one does not, which is named.
    pub fn rising(&self, key: &str, values: &[f64]) -> Result<(), Mistake> {
        match (1..values.len()).find(|&i| !(values[i].is_finite() && values[i] > values[i - 1])) {
            None => Ok(()),
            Some(i) => {
                let wanted = format!("must be greater than the value before it, {}", values[i - 1]);
                Err(self.error(&format!("{key}[{}]", i + 1), values[i], wanted))
            }
        }
    }

    /// Two columns of a table, equally long and of at least `rows`.
    ///
    /// The first one rises from row to row and begins at zero, the second one has no negative values.
    ///
    /// # Errors
    /// When one of this does not hold.
    pub fn columns(
        &self,
        (x_key, x): (&str, &[f64]),
        (y_key, y): (&str, &[f64]),
        rows: usize,
    ) -> Result<(), Mistake> {
        if x.len() < rows || x.len() != y.len() {
            let wanted = format!("needs at least {rows} values, and as many as {y_key}");
            return Err(self.error(x_key, format!("{x:?}"), wanted));
        }
        self.ensure(x[0] == 0.0, &format!("{x_key}[1]"), x[0], "must be zero")?;
        self.rising(x_key, x)?;
        match y.iter().position(|y| !(y.is_finite() && *y >= 0.0)) {
            None => Ok(()),
            Some(i) => {
                let key = format!("{y_key}[{}]", i + 1);
                Err(self.error(&key, y[i], "must not be negative"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gear() -> Document {
        Document::new(
            "gear.toml",
            "[loading]\ndeflection_mm = [0, 40, 20.0]\nforce_kn = [0, -1, 5]\n",
        )
    }

    #[test]
    fn a_value_is_repeated_as_it_is_written_and_marked() {
        let gear = gear();
        let check = gear.check().section("loading");
        let columns = |x: &[f64]| {
            check.columns(("deflection_mm", x), ("force_kn", &[0.0, -1.0, 5.0]), 2).unwrap_err()
        };
        assert_eq!(
            columns(&[0.0, 40.0, 20.0]).to_string(),
            "gear.toml:2:25: loading.deflection_mm[3] = 20.0: must be greater than the value before \
             it, 40\n  |\n2 | deflection_mm = [0, 40, 20.0]\n  |                         ^^^^"
        );
        let negative = columns(&[0.0, 40.0, 50.0]).to_string();
        assert!(negative.starts_with("gear.toml:3:16: loading.force_kn[2] = -1: must not be"));
        let short = columns(&[0.0]).to_string();
        let wanted = "loading.deflection_mm = [0.0]: needs at least 2 values, and as many as";
        assert!(short.contains(wanted), "{short}");
    }

    #[test]
    fn what_is_missing_is_looked_for_in_its_section() {
        let gear = gear();
        let mistake =
            gear.check().section("loading").missing("source", "where the values are from");
        assert_eq!(mistake.mark.as_ref().map(|mark| mark.line), Some(1));
        assert_eq!(mistake.sentence, "loading.source is missing: where the values are from");
        assert_eq!(gear.check().missing("name", "a name").mark, None);
    }

    #[test]
    fn bounds_hold_with_their_ends_and_not_for_what_is_no_number() {
        let gear = gear();
        let check = gear.check();
        assert!(
            check.between("x", 1.0, 0.0, 1.0).is_ok() && check.between("x", 0.0, 0.0, 1.0).is_ok()
        );
        assert!(check.between("x", f64::NAN, 0.0, 1.0).is_err());
        assert!(check.positive("x", f64::INFINITY).is_err() && check.positive("x", 0.0).is_err());
        let text = check.positive("x", -2.0).unwrap_err().to_string();
        assert_eq!(text, "gear.toml: x = -2: must be greater than zero");
    }

    /// A value of many lines would hide the sentence.
    #[test]
    fn a_long_value_is_marked_only() {
        let text = format!("x = [{}]", "1, ".repeat(30));
        let file = Document::new("f.toml", text);
        let mistake = file.check().wrong("x", "is too long");
        assert_eq!(mistake.sentence, "x: is too long");
        assert_eq!(mistake.mark.map(|mark| mark.column), Some(5));
    }
}
