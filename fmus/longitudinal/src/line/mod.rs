//! What the line does to every vehicle alike: its gradient, and the wind over it.

pub mod gravity;
pub mod wind;
