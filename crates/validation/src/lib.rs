//! Comparisons of a model with something that is not ours, each a row of a table under
//! `docs/validation`.
//!
//! A test computes a value, names what it expects and where that comes from, and calls
//! [`Row::holds`]. The call fails if the value is beyond the tolerance, and if the page does not show
//! this comparison: the same case, expectation, source, tolerance and reason, and an obtained value
//! that agrees with that of now. So no row is kept that nothing tests, and no page tells of another
//! program than this one.
//!
//! A crate depends on this one for its tests (`validation.workspace = true` under
//! `[dev-dependencies]`) and names its page once, beside its tests:
//!
//! ```text
//! /// The page that has the table of all comparisons.
//! pub const PAGE: Page = Page {
//!     path: "docs/validation/longitudinal.md",
//!     text: include_str!("../../../../docs/validation/longitudinal.md"),
//! };
//! ```
//!
//! A test then reads
//!
//! ```text
//! Row {
//!     case: "balancing speed on 1 permille",
//!     value: 3.6 * speed,
//!     expected: 45.2,
//!     unit: "km/h",
//!     source: "Canadian National's formula by hand",
//!     tolerance: (0.1, "rounding of the masses"),
//! }
//! .holds(&PAGE);
//! ```
//!
//! and the page has a line under the head
//!
//! ```text
//! | case | expected | source | obtained | allowed difference |
//! |---|---|---|---|---|
//! ```
//!
//! Each call prints its line: `cargo test -p PACKAGE -- --nocapture --test-threads 1 | grep '^|'` makes
//! the table, to be put into the page.
//!
//! A comparison whose expectation is a limit is a [`Bound`]; one without a number (two files that must
//! be equal) is a [`Finding`].

mod page;
mod row;

pub use page::Page;
pub use row::{Bound, Finding, Row, six_digits};
