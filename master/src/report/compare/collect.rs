//! Compares runs column by column.

use std::path::{Path, PathBuf};

use super::along::along_rails;
use super::comparison::{Compared, Comparison};
use super::curves::Thinning;
use super::error::CompareError;
use super::errors::{self, ColumnErrors};
use super::measurement::MeasurementOptions;
use super::run::Run;
use super::subject::Subject;

/// Compares the results in the folder `first` with others: folders, or CSV files of a measurement.
///
/// # Errors
/// When one cannot be read, or has nothing in common with the first.
pub fn compare(
    first: &Path,
    others: &[PathBuf],
    options: &MeasurementOptions,
) -> Result<Comparison, CompareError> {
    let first = Run::open(first)?;
    let others: Vec<Subject> = others
        .iter()
        .map(|path| Subject::open(path, &first, options))
        .collect::<Result<_, CompareError>>()?;
    let mut compared: Vec<Compared> = vec![];
    for other in &others {
        let fields = other.fields(&first)?;
        compared.push(Compared {
            with: other.about(),
            inputs: other.input_differences(&first)?,
            columns: vec![],
            fields: fields.errors,
            fields_not_compared: fields.not_compared,
            only_in_first: fields.only_in_first,
            only_in_other: [fields.only_in_other, other.without_home(&first)].concat(),
        });
    }
    let thinning = Thinning::of(first.column_count(), others.len());
    let mut curves = vec![];
    for table in &first.tables {
        for (column, unit) in table.columns() {
            let own = table.curves(&column)?;
            let mut of_others = vec![];
            for (other, compared) in others.iter().zip(&mut compared) {
                let Some(found) = other.curves(&table.name, &column)? else {
                    if other.run().is_some() {
                        compared.only_in_first.push(format!("{}.{column}", table.name));
                    }
                    of_others.push(None);
                    continue;
                };
                let name = (table.name.as_str(), column.as_str(), unit.as_str());
                compared.columns.extend(errors::of_column(name, &own, &found));
                of_others.push(Some(found));
            }
            let errors: Vec<_> = compared.iter().map(|c| c.columns.last()).collect();
            let of_this =
                |errors: &&ColumnErrors| errors.table == table.name && errors.column == column;
            let errors = errors.into_iter().flatten().filter(of_this);
            // The row that differs most is drawn.
            let worst = errors.max_by(|a, b| a.max_abs.total_cmp(&b.max_abs));
            if let Some(worst) = worst {
                curves.extend(thinning.curve(worst, &own, &of_others));
            }
        }
    }
    if let Some(empty) = compared.iter().find(|compared| compared.columns.is_empty()) {
        let (first, other) = (first.about.name.clone(), empty.with.name.clone());
        return Err(CompareError::Nothing { first, other });
    }
    let along = along_rails(&first, &others.iter().map(Subject::run).collect::<Vec<_>>())?;
    let curves = thinning.most_different(curves);
    Ok(Comparison { first: first.about, compared, curves, along })
}
