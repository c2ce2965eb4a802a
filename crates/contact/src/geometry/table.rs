//! Contacts of one wheel over its lateral shift, interpolated.

use super::contact_point::ContactPoint;
use super::pair::ProfilePair;
use super::patch_at::{PatchAt, RowPosition, WheelPosition};
use super::row::{STEP, TablePatch};
use super::search::{Search, Touch};
use super::{corners, slots};
use crate::error::ContactError;
use std::sync::{Arc, Mutex, PoisonError};

/// Rows towards the field side: the table begins at a shift of -20 mm, or where the wheel leaves the
/// rail.
const ROWS_AWAY: i32 = 400;

/// Rows towards the flange: up to a shift of 30 mm, where the flange has climbed by 23 mm, or where
/// the wheel leaves the rail.
const ROWS_TOWARDS: i32 = 600;

/// The tables made so far: a train of 250 vehicles needs one. A process knows few pairs, so that a list
/// serves.
static TABLES: Mutex<Vec<Arc<GeometryTable>>> = Mutex::new(Vec::new());

/// Contacts of one wheel with its rail as a function of the lateral shift and of the yaw.
///
/// The shift is the lateral displacement of the wheel relative to its rail at the height of the
/// contact, in m, positive when the flange approaches the rail; 0 is the wheelset in the middle of
/// the track. A wheelset displaced by y to the right and rolled by phi (right side down) shifts its
/// right wheel by y - r phi and its left wheel by -(y - r phi).
///
/// A wheel may touch at up to [`Self::MOST_PATCHES`] patches at once. Each is a spring of its own;
/// they share the load as their approaches say.
///
/// `drop` is a cubic through values and slopes, so that its derivative is continuous and equals the
/// `slope` given, and so is the stiffness; all else is linear between the rows. `patch_at.rs` has what
/// load, yaw and roll do.
#[derive(Debug)]
pub struct GeometryTable {
    pair: ProfilePair,
    begin: f64,
    /// Number of rows.
    count: usize,
    patches: Vec<TablePatch>,
}

impl GeometryTable {
    /// Most patches of a wheel.
    pub const MOST_PATCHES: usize = slots::MOST_PATCHES;

    /// The table of this pair, made at the first call and shared by all later ones in the process.
    ///
    /// The lock is held while a table is made: others that ask for the same pair at the same time wait
    /// for it rather than make it again.
    ///
    /// # Errors
    /// When a dimension is out of range or the wheel does not stand on the rail.
    pub fn shared(pair: &ProfilePair) -> Result<Arc<Self>, ContactError> {
        let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(table) = tables.iter().find(|table| table.pair() == pair) {
            return Ok(Arc::clone(table));
        }
        let table = Arc::new(Self::new(pair)?);
        tables.push(Arc::clone(&table));
        Ok(table)
    }

    /// Searches the contacts at every row.
    pub(super) fn new(pair: &ProfilePair) -> Result<Self, ContactError> {
        pair.check()?;
        let mut search = Search::new(pair);
        let mut touches = |i: i32| search.shifted(f64::from(i) * STEP);
        let centred = touches(0);
        let level = centred.iter().map(|touch| touch.drop).fold(f64::INFINITY, f64::min);
        if !level.is_finite() {
            return Err(ContactError::NoContact {
                wheel: pair.wheel.name(),
                rail: pair.rail.name(),
                shift_mm: 0.0,
            });
        }
        let on_rail = |touches: &Vec<Touch>| !touches.is_empty();
        let away = (1..=ROWS_AWAY).map(|i| touches(-i)).take_while(on_rail);
        let mut rows: Vec<_> = away.collect();
        let before = rows.len();
        rows.reverse();
        rows.push(centred);
        rows.extend((1..=ROWS_TOWARDS).map(touches).take_while(on_rail));
        let mut tracks = slots::follow(&rows);
        corners::divide(&mut tracks);
        let patches = tracks.iter().map(|track| TablePatch::new(pair, track, level)).collect();
        let begin = -(before as f64) * STEP;
        Ok(Self { pair: pair.clone(), begin, count: rows.len(), patches })
    }

    /// The pair this table was made for.
    pub fn pair(&self) -> &ProfilePair {
        &self.pair
    }

    /// Least and greatest shift of the table, in m.
    pub fn range(&self) -> (f64, f64) {
        (self.begin, self.begin + (self.count - 1) as f64 * STEP)
    }

    /// Number of patches that the pair has at any shift, at most [`Self::MOST_PATCHES`].
    pub fn patches(&self) -> usize {
        self.patches.len()
    }

    /// The contact that touches first at a lateral `shift` in m, without yaw. A shift that is not a
    /// number gives the first row.
    pub fn at(&self, shift: f64) -> ContactPoint {
        let (row, wheel) = (self.row(shift), WheelPosition { shift, ..WheelPosition::default() });
        let patches = (0..self.patches()).filter_map(|patch| self.patch(patch, row, &wheel));
        let real = patches.filter(|patch| patch.point().hertz.stiffness > 0.0);
        let first = real.reduce(|a, b| if b.drop() < a.drop() { b } else { a });
        // Every row has a contact, but two rows between which one ends and another begins may not.
        first.unwrap_or_else(|| self.patch_at(0, row, &wheel)).point()
    }

    /// A patch, counted from 0, under a `wheel`; nothing where the pair has no such patch.
    ///
    /// `row` is that of the wheel's shift, by [`Self::row`].
    #[inline]
    pub fn patch(
        &self,
        patch: usize,
        row: RowPosition,
        wheel: &WheelPosition,
    ) -> Option<PatchAt<'_>> {
        self.patches[patch].rows[row.index].near.then(|| self.patch_at(patch, row, wheel))
    }

    #[inline]
    fn patch_at(&self, patch: usize, row: RowPosition, wheel: &WheelPosition) -> PatchAt<'_> {
        PatchAt::new(&self.patches[patch], self.begin, row, wheel)
    }

    /// Where a lateral `shift` in m lies among the rows.
    #[inline]
    pub fn row(&self, shift: f64) -> RowPosition {
        RowPosition::new(shift, self.begin, self.count)
    }
}
