//! Where wheel and rail touch.
//!
//! | file | part |
//! |---|---|
//! | `pair.rs` | the dimensions of a wheel over a rail |
//! | `search.rs` | the quasi-elastic search for the contacts at one placement |
//! | `lobes.rs` | which parts of the profile touch separately |
//! | `slots.rs` | contacts followed from shift to shift |
//! | `corners.rs` | floor and wall of a path's corner as contacts of their own |
//! | `contact_point.rs` | what is known at a contact |
//! | `table.rs`, `row.rs` | contacts over the lateral shift, interpolated |
//! | `patch_at.rs` | a patch under a wheel: where it touches, where and how it presses |
//! | `wheelset.rs` | both wheels of a rolled wheelset, for validation |
//! | `conicity.rs` | the equivalent conicity that follows |

pub(crate) mod conicity;
pub(crate) mod contact_point;
mod corners;
mod lobes;
pub(crate) mod pair;
pub(crate) mod patch_at;
mod row;
mod search;
mod slots;
pub(crate) mod table;
pub(crate) mod wheelset;
