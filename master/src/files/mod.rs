//! Files on disk: archives, XML in its encodings, and what goes wrong with a file.

pub mod archive;
pub mod file_error;
pub mod xml_depth;
pub mod xml_text;
