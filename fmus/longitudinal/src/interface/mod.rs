//! The train as an FMU.
//!
//! | file | part |
//! |---|---|
//! | `signals.rs` | the variables that the FMU shows |
//! | `model.rs` | from the variables to the physics and back |

pub(crate) mod model;
pub(crate) mod signals;
