//! One table for each pair of profiles in a process: a train of 250 vehicles needs one.

use super::pair::ProfilePair;
use super::table::GeometryTable;
use crate::ContactError;
use std::sync::{Arc, Mutex, PoisonError};

/// The tables made so far. A process knows few pairs, so that a list serves.
static TABLES: Mutex<Vec<Arc<GeometryTable>>> = Mutex::new(Vec::new());

/// The table of this pair. The lock is held while a table is made: others that ask for the same pair
/// at the same time wait for it rather than make it again.
pub(super) fn table(pair: &ProfilePair) -> Result<Arc<GeometryTable>, ContactError> {
    let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(table) = tables.iter().find(|table| table.pair() == pair) {
        return Ok(Arc::clone(table));
    }
    let table = Arc::new(GeometryTable::new(pair)?);
    tables.push(Arc::clone(&table));
    Ok(table)
}
