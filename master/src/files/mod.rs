//! Files on disk: archives, XML, foreign texts, what is shipped, and what goes wrong with a file.

pub mod archive;
pub mod file_error;
pub mod printable;
pub mod shipped;
pub mod xml_depth;
pub mod xml_text;
