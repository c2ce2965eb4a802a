//! The texts that describe an FMU, written from a model's identity and declaration.
//!
//! | file | part |
//! |---|---|
//! | `model_description.rs` | `modelDescription.xml` |
//! | `elements.rs` | its elements, named as in the schema |
//! | `signal_table.rs` | `documentation/index.html` |
//! | `terminals.rs` | `terminalsAndIcons/terminalsAndIcons.xml` |

mod elements;
mod model_description;
mod signal_table;
mod terminals;

pub use model_description::model_description;
pub use signal_table::{documentation, signal_table_html};
pub use terminals::terminals;
