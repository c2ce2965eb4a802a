//! Files on disk: archives, and what goes wrong with a file.

pub mod archive;
pub mod file_error;
