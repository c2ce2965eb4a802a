//! Conduction along the track, which matters at a joint or a wheel burn.
//!
//! All of the section has one diffusivity, so that conduction along the track is the same in every
//! mode and couples none of them (`docs/theory/railheat/energy.md#eq-10`):
//!
//! ```text
//! a_i' = α/ℓ² (a_{i+1} - 2 a_i + a_{i-1})
//! ```
//!
//! for the amplitudes of neighbouring elements of the length ℓ. A step is taken by the two-stage
//! diagonally implicit Runge-Kutta method with γ = 1 - 1/√2 (Alexander, *SIAM J. Numer. Anal.* 14 (1977)
//! 1006-1021): second order, and stable for steps of any length. Each mode decays by its own factor
//! meanwhile, which commutes with it. The ends of what wheels have touched grow where heat
//! comes to them; nothing flows through the ends themselves, so that no heat is lost.
//! Validated by `analytic_along_…`.

use super::elements::Elements;
use crate::section::{LANES, Modes, dot};

/// γ = 1 - 1/√2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

/// What lies further away gets less than this share of an element's heat in a step.
const SHARE_BEYOND: f64 = 1e-6;

/// Less heat than this at an end does not make it grow, J/m: 4e-10 K.
const LEAST_HEAT: f64 = 1e-5;

/// Amplitudes of [`LANES`] modes.
type Row = [f64; LANES];

/// Scratch for conduction along so many elements.
#[derive(Clone, Debug)]
pub(super) struct Along {
    /// Of the elimination: what is left of the diagonal, one over.
    pivots: Vec<f64>,
    first: Vec<Row>,
    second: Vec<Row>,
}

impl Along {
    /// Room for so many elements.
    pub fn new(elements: usize) -> Self {
        Self {
            pivots: vec![0.0; elements],
            first: vec![[0.0; LANES]; elements],
            second: vec![[0.0; LANES]; elements],
        }
    }

    /// One step; `number` is α Δt/ℓ².
    pub fn conduct(&mut self, elements: &mut Elements, modes: &Modes, number: f64) {
        grow(elements, modes, number);
        let mut from = 0;
        while from < elements.count() {
            let run = (from..elements.count()).take_while(|e| elements.is_touched(*e)).count();
            if run > 1 {
                self.step(elements, from, run, number);
            }
            from += run + 1;
        }
    }

    /// One step of a run of touched elements.
    fn step(&mut self, elements: &mut Elements, from: usize, run: usize, number: f64) {
        let off = -GAMMA * number;
        for i in 0..run {
            let neighbours = if i == 0 || i == run - 1 { 1.0 } else { 2.0 };
            let before = if i == 0 { 0.0 } else { off * off * self.pivots[i - 1] };
            self.pivots[i] = 1.0 / (1.0 - neighbours * off - before);
        }
        for group in 0..elements.width() / LANES {
            let (first, second) = (&mut self.first[..run], &mut self.second[..run]);
            let row = |i: usize| elements.row(from + i, group);
            differences(first, row);
            solve(first, &self.pivots, off);
            let along = (1.0 - GAMMA) * number;
            differences(second, |i| lanes(|lane| row(i)[lane] + along * first[i][lane]));
            solve(second, &self.pivots, off);
            for i in 0..run {
                let change = lanes(|lane| {
                    number * ((1.0 - GAMMA) * first[i][lane] + GAMMA * second[i][lane])
                });
                elements.change_row(from + i, group, &change);
            }
        }
    }
}

fn lanes(value: impl Fn(usize) -> f64) -> Row {
    std::array::from_fn(value)
}

/// Differences of second order of the rows, with insulated ends.
fn differences(into: &mut [Row], row: impl Fn(usize) -> Row) {
    let last = into.len() - 1;
    let mut inflow = [0.0; LANES];
    let mut here = row(0);
    for (i, sum) in into.iter_mut().enumerate() {
        let next = if i < last { row(i + 1) } else { here };
        let outflow = lanes(|lane| here[lane] - next[lane]);
        *sum = lanes(|lane| inflow[lane] - outflow[lane]);
        inflow = outflow;
        here = next;
    }
}

/// Elimination in a tridiagonal matrix with `off` beside the diagonal.
fn solve(rows: &mut [Row], pivots: &[f64], off: f64) {
    let mut before = [0.0; LANES];
    for (row, pivot) in rows.iter_mut().zip(pivots) {
        *row = lanes(|lane| pivot * (row[lane] - off * before[lane]));
        before = *row;
    }
    let mut after = [0.0; LANES];
    for (row, pivot) in rows.iter_mut().zip(pivots).rev() {
        *row = lanes(|lane| row[lane] - pivot * off * after[lane]);
        after = *row;
    }
}

/// Lets runs of touched elements grow at ends to which heat has come.
fn grow(elements: &mut Elements, modes: &Modes, number: f64) {
    // Share of a step's heat from one element to the next: the root of the difference equation.
    let s = GAMMA * number;
    let share = (1.0 + 2.0 * s - (1.0 + 4.0 * s).sqrt()) / (2.0 * s);
    let reach = (libm::log(SHARE_BEYOND) / libm::log(share)).ceil().max(1.0) as usize;
    let count = elements.count();
    let warm = |elements: &Elements, e: usize| {
        elements.is_touched(e) && dot(&modes.content, elements.amplitudes(e)).abs() > LEAST_HEAT
    };
    let mut element = 0;
    while element + 1 < count {
        let end = element + reach;
        if !elements.is_touched(element + 1) && warm(elements, element) {
            (element + 1..=end.min(count - 1)).for_each(|e| elements.touch(e));
            element = end;
        }
        element += 1;
    }
    let mut element = count;
    while element > 1 {
        element -= 1;
        if !elements.is_touched(element - 1) && warm(elements, element) {
            let begin = element.saturating_sub(reach);
            (begin..element).for_each(|e| elements.touch(e));
            element = begin.max(1);
        }
    }
}
