//! Runs beside each other: inputs that differ, errors of every column, and a page of curves.
//!
//! | file | part |
//! |---|---|
//! | `collect.rs` | compares runs column by column |
//! | `comparison.rs`, `about.rs` | what a comparison has found, and of what |
//! | `subject.rs` | what is compared: a run, or a measurement |
//! | `run.rs` | the tables of a run as curves |
//! | `measurement.rs`, `measured_unit.rs` | the columns of a CSV file as curves of a run |
//! | `inputs.rs` | inputs of two runs that differ |
//! | `grid.rs` | times at which two curves are compared |
//! | `errors.rs`, `texts.rs` | error measures of a column, and as people read them |
//! | `fields.rs`, `field_errors.rs` | the temperature fields of the rails of two runs |
//! | `curves.rs` | the curves that the page shows |
//! | `along.rs` | surface and foot along the rails, which the page shows |
//! | `page.rs` | the page, from `templates/compare.html` |
//! | `error.rs` | why results cannot be compared |

mod about;
mod along;
mod collect;
mod comparison;
mod curves;
mod error;
mod errors;
mod field_errors;
mod fields;
mod grid;
mod inputs;
mod measured_unit;
mod measurement;
mod page;
mod run;
mod subject;
mod texts;

pub use about::About;
pub use collect::compare;
pub use comparison::{Compared, Comparison};
pub use error::CompareError;
pub use errors::ColumnErrors;
pub use field_errors::FieldErrors;
pub use grid::How;
pub use inputs::InputDifference;
pub use measurement::{Mapping, MeasurementOptions};
pub use page::write_page;
