//! Typed arguments, and the rows that a command gives.

use clap::Args;
use tools::ToolError;

/// The repository's rolling stock.
pub const STOCK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock");

/// The arguments that these words are.
pub fn arguments<T: Args>(words: &[&str]) -> Result<T, clap::Error> {
    let command = T::augment_args(clap::Command::new("hotfoot").no_binary_name(true));
    T::from_arg_matches(&command.try_get_matches_from(words)?)
}

/// What a command says to wrong words: as they are taken, or as they are carried out.
pub fn refusal<T: Args>(run: fn(&T) -> Result<String, ToolError>, words: &[&str]) -> String {
    match arguments(words) {
        Ok(arguments) => run(&arguments).expect_err("the command must refuse this").to_string(),
        Err(error) => error.to_string(),
    }
}

/// Rows of comma-separated values with the names of their columns.
pub struct Table {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// What a command gives for these words.
    pub fn of<T: Args>(run: fn(&T) -> Result<String, ToolError>, words: &[&str]) -> Self {
        let arguments = arguments(words).expect("arguments that can be typed");
        let text = run(&arguments).expect("a command that can be carried out");
        let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect());
        let names = lines.next().expect("a line with the names of the columns");
        Self { names, rows: lines.collect() }
    }

    /// The names of the columns.
    pub fn names(&self) -> String {
        self.names.join(",")
    }

    /// The texts in a column.
    pub fn texts(&self, name: &str) -> Vec<&str> {
        let index = self.names.iter().position(|column| column == name);
        let index = index.unwrap_or_else(|| panic!("no column {name} in {:?}", self.names));
        self.rows.iter().map(|row| row[index].as_str()).collect()
    }

    /// The numbers in a column.
    pub fn column(&self, name: &str) -> Vec<f64> {
        self.texts(name).iter().map(|text| text.parse().expect("a number")).collect()
    }
}

/// Fails unless a value is within a share of the one expected.
pub fn assert_near(value: f64, expected: f64, tolerance: f64) {
    let difference = (value / expected - 1.0).abs();
    assert!(difference <= tolerance, "{value} instead of {expected}: off by {difference:.2e}");
}
