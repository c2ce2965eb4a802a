//! The rolling-stock library.
//!
//! | file | what is tested |
//! |---|---|
//! | `library.rs` | the shipped rolling stock, and vehicles that extend one another |
//! | `published.rs` | values against the sources that the files name |
//! | `messages.rs` | what is said of wrong files, word for word |
//! | `scratch.rs` | a library of its own for each test |

mod library;
mod messages;
mod published;
mod scratch;
