//! Steady rolling of two equal elastic bodies on a Hertzian ellipse, by Kalker's half-space theory.
//!
//! Two half-spaces of one material touch in an ellipse with the semi-axes a (rolling direction x) and b.
//! The pressure is Hertz's, friction is Coulomb's. With tractions q on the rail, in the direction of the
//! slip s of the wheel, and with the displacement h of the rail against the wheel that they cause,
//!
//! ```text
//! s = (xi - phi y, eta + phi x) + dh/dx,    h = A q                                                (C12)
//! |q| <= mu p;   s = 0 where |q| < mu p,    q = mu p s/|s| where the contact slips                  (C13)
//! ```
//!
//! A is Boussinesq's and Cerruti's influence of a traction on the displacement (`influence.rs`). This is
//! the theory of Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990); the axes of spin and
//! creepage are those of the simplified theory (C2), and turning the sign of xi mirrors the contact across.
//!
//! In steady rolling the bodies give back at the trailing edge what they took, so that the power of the
//! slip field is Fx xi + Fy eta + M phi exactly, with the moment M of the tractions.
//!
//! All is dimensionless: a b = 1, G = 1, and mu times the largest pressure is 1.
//!
//! | file | part |
//! |---|---|
//! | `grid.rs` | elements of the ellipse and the bound of each |
//! | `influence.rs` | displacement by a traction on one element |
//! | `solver.rs` | tractions that fulfil C12 and C13 |
//! | `flash.rs` | highest temperature by the heat of the slip zone |
//! | `recipe.rs` | how the table of the creep law is made |
//!
//! It takes milliseconds for one motion and serves to make a table (`creep/rolling_table.rs`).

mod flash;
mod grid;
mod influence;
pub mod recipe;
mod solver;

pub use grid::Cells;
pub use solver::{RollingContact, RollingForces, RollingMotion};
