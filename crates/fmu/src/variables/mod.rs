//! What an FMU shows: its variables, their declaration, their values.
//!
//! | file | part |
//! |---|---|
//! | `table_macro.rs` | `variables!`: the variables of one thing, said once in a table |
//! | `table.rs` | what a table and its entries offer: reading and writing |
//! | `scope.rs` | what the names of a table's variables begin with |
//! | `choice.rs` | a text that is one of a few |
//! | `resource_file.rs` | a file named by a parameter, with a default in the resources |
//! | `declaration.rs` | the declaration, one variable after the other |
//! | `variable.rs` | a variable as the model description shows it |
//! | `bounds.rs`, `unit.rs` | its bounds, and the SI units of `UnitDefinitions` |
//! | `values.rs` | the values of an instance's variables, read and written by handle |
//! | `guid.rs` | the fingerprint of a declaration |

mod bounds;
mod choice;
mod declaration;
mod guid;
mod resource_file;
mod scope;
mod table;
mod table_macro;
pub mod unit;
mod values;
mod variable;

pub use bounds::{Bounds, above};
pub use choice::Choice;
pub use declaration::{Declaration, VariableDeclaration};
pub use guid::Guid;
pub use resource_file::{FileHandle, ResourceFile};
pub use scope::Scope;
pub use table::{Handles, Variables};
pub use unit::Unit;
pub use values::{Boolean, Integer, Real, Reals, Text, Type, Values};
pub use variable::{Causality, Initial, Kind, Terminal, Variability, Variable};
