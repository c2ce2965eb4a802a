//! Tables of variables: what a model declares with them, and what an instance then admits.
//!
//! | file | part |
//! |---|---|
//! | `kettle.rs` | a model whose tables have a row of every kind |
//! | `declaring.rs` | what the tables declare, and what the XML says of it |
//! | `values.rs` | reading and writing |
//! | `setters.rs` | what may be set, in every phase |

mod declaring;
mod kettle;
mod setters;
mod values;
