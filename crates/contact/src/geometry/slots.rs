//! Contacts followed from shift to shift.
//!
//! A lobe that lives on from one row of the table to the next keeps its slot, so that values can be
//! interpolated; a new one takes a slot that is free. Where a lobe ends, as the barrier to its neighbour
//! sinks, its path goes on along the tangent for a while: there a wheel may still be pressed on it. Other
//! rows in which a slot is not used have no share of stiffness.

use super::row::STEP;
use super::search::Touch;

/// Most contacts of a wheel at the same time: tread, flange root and flange.
pub const MOST_PATCHES: usize = 3;

/// Rows for which a path goes on along its tangent: 1 mm, on which it parts from its neighbour by more
/// than any wheel is pressed.
const TANGENT: usize = 20;

/// Rows for which a slot must have been free before another lobe takes it.
const REST: usize = 4;

/// A slot's contact in every row of the table.
pub(super) type Track = Vec<Touch>;

/// The contacts of every row, sorted into slots; slots never used are left
/// out. The first slot holds the contact of the first row.
pub(super) fn follow(rows: &[Vec<Touch>]) -> Vec<Track> {
    let mut slots: Vec<Vec<Option<Touch>>> = vec![vec![None; rows.len()]; MOST_PATCHES];
    for (i, touches) in rows.iter().enumerate() {
        let mut left: Vec<Touch> = touches.clone();
        while let Some((slot, touch)) = nearest(&slots, i, &left) {
            slots[slot][i] = Some(left.remove(touch));
        }
        // Born towards the flange first: the tread is there already.
        for touch in left {
            if let Some(slot) = free(&slots, i) {
                slots[slot][i] = Some(touch);
            }
        }
    }
    slots.iter().filter_map(|slot| filled(slot)).collect()
}

/// The slot and the contact in row `i` that continue each other best, of those that may.
fn nearest(slots: &[Vec<Option<Touch>>], i: usize, left: &[Touch]) -> Option<(usize, usize)> {
    let before = |slot: usize| match slots[slot][i] {
        None => i.checked_sub(1).and_then(|row| slots[slot][row]),
        Some(_) => None,
    };
    let pairs = (0..slots.len()).flat_map(|slot| (0..left.len()).map(move |touch| (slot, touch)));
    pairs
        .filter_map(|(slot, touch)| {
            let (before, now) = (before(slot)?, &left[touch]);
            let overlap = holds(&before, now) || holds(now, &before);
            overlap.then(|| ((slot, touch), (before.wheel_lateral - now.wheel_lateral).abs()))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(pair, _)| pair)
}

/// Whether the contact of `other` lies within the lobe of `lobe`.
fn holds(lobe: &Touch, other: &Touch) -> bool {
    (lobe.range.0..=lobe.range.1).contains(&other.wheel_lateral)
}

/// The first slot that has been free for a while.
fn free(slots: &[Vec<Option<Touch>>], i: usize) -> Option<usize> {
    let rested =
        |slot: &Vec<Option<Touch>>| slot[i.saturating_sub(REST)..=i].iter().all(Option::is_none);
    slots.iter().position(rested)
}

/// A slot with its empty rows filled; nothing if all are empty.
fn filled(slot: &[Option<Touch>]) -> Option<Track> {
    let used: Vec<usize> = (0..slot.len()).filter(|&i| slot[i].is_some()).collect();
    used.first()?;
    let mut track = Vec::with_capacity(slot.len());
    for i in 0..slot.len() {
        let after = used.partition_point(|&row| row < i);
        let neighbours = [after.checked_sub(1), Some(after)].map(|k| used.get(k?).copied());
        let near = neighbours.into_iter().flatten().min_by_key(|row| row.abs_diff(i))?;
        let mut touch = tangent(&slot[near]?, near, i);
        if let [Some(before), Some(after)] = neighbours
            && near != i
            && after - before <= 2 * TANGENT
        {
            touch.share = 0.0;
        }
        track.push(touch);
    }
    Some(track)
}

/// What stands at `row` for a contact whose path ends at row `end`.
pub(super) fn tangent(touch: &Touch, end: usize, row: usize) -> Touch {
    let drop = touch.drop + touch.slope * STEP * (row as f64 - end as f64);
    let share = if row.abs_diff(end) <= TANGENT { touch.share } else { 0.0 };
    Touch { drop, share, ..*touch }
}
