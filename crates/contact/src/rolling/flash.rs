//! Highest flash temperature by the heat of the slip zone.
//!
//! The surface passes the contact fast, so that heat flows downwards only, and each strip along the
//! rolling direction is by itself: the rise behind a flux f is the integral of f/sqrt(distance) upstream.

use super::grid::Grid;
use crate::flash::HERTZ_PEAK;
use std::f64::consts::PI;

/// Greatest value over s of the integral of sqrt(1 - u²)/sqrt(s - u) over u from -1 to s: the rise by a
/// flux that is spread as Hertz's pressure.
const WHOLE_CONTACT: f64 = HERTZ_PEAK * 1.772_453_850_905_516;

/// Highest rise by the flux of each element, by that of the same power spread as Hertz's pressure.
pub(super) fn peak(grid: &Grid, a: f64, flux: &[f64]) -> f64 {
    let along = grid.cells.along;
    let step = grid.size[0];
    let mut highest = 0.0_f64;
    for row in flux.chunks_exact(along) {
        for column in 0..along {
            // At the trailing edge of the element, which all of its heat has reached.
            let rise: f64 = (column..along)
                .map(|source| {
                    let distance = (source - column) as f64;
                    2.0 * row[source] * ((distance + 1.0).sqrt() - distance.sqrt())
                })
                .sum();
            highest = highest.max(rise * step.sqrt());
        }
    }
    let power = flux.iter().sum::<f64>() * grid.size[0] * grid.size[1];
    if power <= 0.0 {
        return 1.0;
    }
    // a b = 1.
    highest * PI / (1.5 * power * a.sqrt() * WHOLE_CONTACT)
}
