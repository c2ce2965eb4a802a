//! A column and a key of a table, and how the file describes them.
//!
//! Unit and description stand in the Arrow schema as metadata of each field, under the keys
//! `unit` and `description`, where pyarrow shows them as `schema.field("…").metadata`.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float32Array, Float64Array, Int32Array, StringArray};
use arrow_schema::{DataType, Field};

/// A quantity that a table records.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    name: String,
    unit: String,
    description: String,
    double: bool,
    mean: bool,
    extremes: bool,
}

impl Column {
    /// A column in single precision without extremes; `unit` is an SI unit, "1" for a number.
    pub fn new(name: &str, unit: &str, description: &str) -> Self {
        Self {
            name: name.to_owned(),
            unit: unit.to_owned(),
            description: description.to_owned(),
            double: false,
            mean: false,
            extremes: false,
        }
    }

    /// Name of the column.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// SI unit of the values.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Keeps all digits of an f64 in the file.
    #[must_use]
    pub fn double(mut self) -> Self {
        self.double = true;
        self
    }

    /// Records also the mean since the last record, as the column `<name>_mean`.
    #[must_use]
    pub fn mean(mut self) -> Self {
        self.mean = true;
        self
    }

    /// Records also the lowest and the highest value since the last record, as columns
    /// `<name>_min` and `<name>_max`.
    #[must_use]
    pub fn extremes(mut self) -> Self {
        self.extremes = true;
        self
    }

    /// Whether the mean is recorded too.
    pub(super) fn has_mean(&self) -> bool {
        self.mean
    }

    /// Whether the lowest and the highest value are recorded too.
    pub(super) fn has_extremes(&self) -> bool {
        self.extremes
    }

    /// The fields that the column takes in the file: the value, then its mean and its extremes if
    /// wanted.
    pub(super) fn fields(&self) -> Vec<Field> {
        let data_type = match self.double {
            true => DataType::Float64,
            false => DataType::Float32,
        };
        let field = |name: String, description: String| {
            described(&name, data_type.clone(), &self.unit, &description)
        };
        let mut fields = vec![field(self.name.clone(), self.description.clone())];
        let more = [
            (self.mean, "mean", "mean"),
            (self.extremes, "min", "lowest"),
            (self.extremes, "max", "highest"),
        ];
        for (_, suffix, word) in more.into_iter().filter(|(wanted, ..)| *wanted) {
            let description = format!("{}, {word} since the last record", self.description);
            fields.push(field(format!("{}_{suffix}", self.name), description));
        }
        fields
    }

    /// Values of the column as the file stores them.
    pub(super) fn array(&self, values: &[f64]) -> ArrayRef {
        match self.double {
            true => Arc::new(Float64Array::from(values.to_vec())),
            false => Arc::new(values.iter().map(|&v| v as f32).collect::<Float32Array>()),
        }
    }
}

/// What tells the rows of one instant apart, such as the number of the vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// Name of the column.
    pub name: String,
    /// What it counts or names.
    pub description: String,
    /// Its value for each row of an instant.
    pub values: KeyValues,
}

/// The values of a key for the rows of an instant.
#[derive(Debug, Clone, PartialEq)]
pub enum KeyValues {
    /// Numbers.
    Integer(Vec<i32>),
    /// Names.
    Text(Vec<String>),
}

impl Key {
    /// Number of rows of an instant.
    pub(super) fn len(&self) -> usize {
        match &self.values {
            KeyValues::Integer(values) => values.len(),
            KeyValues::Text(values) => values.len(),
        }
    }

    /// The field of the key in the file.
    pub(super) fn field(&self) -> Field {
        let data_type = match self.values {
            KeyValues::Integer(_) => DataType::Int32,
            KeyValues::Text(_) => DataType::Utf8,
        };
        described(&self.name, data_type, "1", &self.description)
    }

    /// The key of `instants` instants, one after another.
    pub(super) fn array(&self, instants: usize) -> ArrayRef {
        match &self.values {
            KeyValues::Integer(values) => Arc::new(Int32Array::from(values.repeat(instants))),
            KeyValues::Text(values) => {
                let repeated = (0..instants).flat_map(|_| values);
                Arc::new(StringArray::from_iter_values(repeated))
            }
        }
    }
}

/// A field that is never empty, with unit and description.
pub(super) fn described(name: &str, data_type: DataType, unit: &str, description: &str) -> Field {
    let metadata = [("unit", unit), ("description", description)];
    let metadata = metadata.map(|(key, value)| (key.to_owned(), value.to_owned()));
    Field::new(name, data_type, false).with_metadata(std::collections::HashMap::from(metadata))
}
