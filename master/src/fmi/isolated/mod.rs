//! FMUs in processes of their own.

pub mod mailbox;
