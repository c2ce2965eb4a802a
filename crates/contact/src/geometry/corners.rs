//! Corners of a path, where the root of the flange lies on the gauge corner and the flange meets it.
//!
//! There the path of the wheel turns by tens of degrees within 0.1 mm of shift (S1002 on 60E1 at 6.6 mm:
//! from 29 to 70 degrees), though the gap has one minimum only. A wheel pressed into such a corner is
//! held by its floor and by its wall. So both become contacts of their own, each on its part of the
//! path and on the tangent at its end, from which the other one soon lifts it. It is also what a yawed
//! wheel does: there the flange touches earlier than the root, and the corner becomes sharp.

use super::slots::{MOST_PATCHES, Track, tangent};

/// Change of the slope from row to row in a corner. Yaw moves the path by R times its square times the
/// slope; up to a yaw of 40 mrad paths that turn less do not overtake themselves.
const SHARP: f64 = 0.06;

/// Turn of the slope that makes a corner.
const TURN: f64 = 0.4;

/// Divides the tracks at their corners as long as there are slots left.
pub(super) fn divide(tracks: &mut Vec<Track>) {
    while tracks.len() < MOST_PATCHES {
        let corners = tracks.iter().enumerate().filter_map(|(i, track)| Some((i, corner(track)?)));
        let Some((i, corner)) = corners.max_by(|a, b| a.1.turn.total_cmp(&b.1.turn)) else {
            return;
        };
        let mut wall = tracks[i].clone();
        let floor = &mut tracks[i];
        for row in corner.floor + 1..floor.len() {
            floor[row] = tangent(&floor[corner.floor], corner.floor, row);
        }
        for row in 0..corner.wall {
            wall[row] = tangent(&wall[corner.wall], corner.wall, row);
        }
        tracks.insert(i + 1, wall);
    }
}

/// A corner between two rows.
struct Corner {
    /// Last row before it.
    floor: usize,
    /// First row after it.
    wall: usize,
    /// How far the slope falls.
    turn: f64,
}

/// The sharpest corner of a track.
fn corner(track: &Track) -> Option<Corner> {
    let sharp = |i: usize| {
        let (before, after) = (&track[i], &track[i + 1]);
        let exist = before.share > 0.0 && after.share > 0.0;
        exist && before.slope - after.slope > SHARP
    };
    let mut corners: Vec<Corner> = vec![];
    for i in (0..track.len() - 1).filter(|&i| sharp(i)) {
        let turn = track[i].slope - track[i + 1].slope;
        match corners.last_mut() {
            Some(last) if last.wall == i => {
                last.wall += 1;
                last.turn += turn;
            }
            _ => corners.push(Corner { floor: i, wall: i + 1, turn }),
        }
    }
    let large = corners.into_iter().filter(|corner| corner.turn > TURN);
    large.max_by(|a, b| a.turn.total_cmp(&b.turn))
}
