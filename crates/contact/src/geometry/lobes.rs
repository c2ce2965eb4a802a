//! Parts of a wheel's profile that touch separately.
//!
//! Every local minimum of the gap between wheel and rail is a lobe. A lobe that a barrier parts from
//! its neighbour by less than the softness of the search is no contact of its own: both make one
//! patch. From there to [`SEPARATE`] a lobe becomes a spring of its own by and by, so that forces never
//! jump: with the separation s, which goes from 0 to 1, and the weights Z of two neighbours (see
//! `search.rs`), each has the share
//!
//! ```text
//! share = s + (1 - s) Z/(Z + Z_neighbour)
//! ```
//!
//! of its Hertzian stiffness. Two lobes that hardly differ thus share one stiffness, and two that are
//! clearly separate have one each. A lobe far above its neighbour has its own whatever the barrier: it bears
//! nothing before the other is pressed as far, and no force comes from a stiffness that grows under load.

/// Softness s in m: gaps within a few times this share the load.
///
/// A quarter of the elastic approach of a wheel under 10 kN, the load of the Manchester benchmark.
/// With it contact positions keep within 0.5 mm of CONTACT's elastic ones in that benchmark, and the
/// pressure within 5 % where there is one contact (`benchmark_manchester_…` in `tests/validation/`).
/// Heavier wheels would spread over more. A jump is spread over 4 s by the step in slope: 0.1 mm of
/// shift from tread to flange root, 0.7 mm on the tread.
pub(super) const SOFTNESS: f64 = 5e-6;

/// Height of the barrier above the higher lobe from which both are contacts of their own, in m.
const SEPARATE: f64 = 4.0 * SOFTNESS;

/// Lobes whose gap exceeds the least by more than this never touch, in m: it is several times the
/// elastic approach of the heaviest wheel.
const REACH: f64 = 0.5e-3;

/// A part of the profile around one minimum of the gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lobe {
    /// First sample.
    pub begin: usize,
    /// Sample after the last one.
    pub end: usize,
    /// Least gap in m.
    pub least: f64,
    /// Separation from the lobe before it, 0 to 1.
    pub separation: f64,
}

/// The lobes of the gaps in m, in the order of the samples; samples beside the rail are infinite.
pub(super) fn lobes(gaps: &[f64]) -> Vec<Lobe> {
    let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    let mut lobes = minima(gaps, least + REACH);
    while let Some((i, height)) = lowest_barrier(gaps, &lobes) {
        if height >= SOFTNESS {
            break;
        }
        let merged = lobes.remove(i + 1);
        lobes[i].end = merged.end;
        lobes[i].least = lobes[i].least.min(merged.least);
    }
    for i in 1..lobes.len() {
        let share = (barrier(gaps, &lobes, i - 1) - SOFTNESS) / (SEPARATE - SOFTNESS);
        lobes[i].separation = smooth(share);
    }
    lobes
}

/// From 0 to 1 as `t` does, without kinks.
pub(super) fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A lobe for every local minimum below `ceiling`; neighbours meet at the highest gap between them.
fn minima(gaps: &[f64], ceiling: f64) -> Vec<Lobe> {
    let mut lobes: Vec<Lobe> = Vec::new();
    let mut top = 0;
    for i in 0..gaps.len() {
        if gaps[i] > gaps[top] {
            top = i;
        }
        let before = if i == 0 { f64::INFINITY } else { gaps[i - 1] };
        let after = gaps.get(i + 1).copied().unwrap_or(f64::INFINITY);
        if gaps[i] < before && gaps[i] <= after && gaps[i] <= ceiling {
            let begin = match lobes.last_mut() {
                Some(last) => {
                    last.end = top;
                    top
                }
                None => 0,
            };
            lobes.push(Lobe { begin, end: gaps.len(), least: gaps[i], separation: 1.0 });
            top = i;
        }
    }
    lobes
}

/// The pair of neighbours (by its first lobe) with the lowest barrier, and its height.
fn lowest_barrier(gaps: &[f64], lobes: &[Lobe]) -> Option<(usize, f64)> {
    (1..lobes.len())
        .map(|i| (i - 1, barrier(gaps, lobes, i - 1)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Height of the barrier after lobe `i` above the higher of both lobes, in m.
fn barrier(gaps: &[f64], lobes: &[Lobe], i: usize) -> f64 {
    let (a, b) = (&lobes[i], &lobes[i + 1]);
    gaps[b.begin] - a.least.max(b.least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two valleys whose bottoms lie at 0 and `excess`, and a barrier of `height` between, in m.
    fn gaps(height: f64, excess: f64) -> Vec<f64> {
        let hill = |i: i32| 0.5 - 0.5 * (std::f64::consts::TAU * f64::from(i) / 200.0).cos();
        let inner = (0..=200).map(|i| match i {
            ..100 => height * hill(i),
            _ => excess + (height - excess) * hill(i),
        });
        let outer = (1..100).map(|i| 1e-6 * f64::from(i));
        outer.clone().rev().chain(inner).chain(outer.map(|g| excess + g)).collect()
    }

    #[test]
    fn a_clear_barrier_parts_two_lobes_and_a_low_one_does_not() {
        let two = lobes(&gaps(60e-6, 30e-6));
        assert_eq!(two.len(), 2);
        assert_eq!((two[0].least, two[1].least), (0.0, 30e-6));
        assert_eq!(two[1].separation, 1.0);
        assert_eq!(two[0].end, two[1].begin);
        assert_eq!(lobes(&gaps(8e-6, 5e-6)).len(), 1);
    }

    #[test]
    fn a_lobe_separates_gradually() {
        let separation = |height: f64| lobes(&gaps(height, 0.0))[1].separation;
        assert!(separation(5.1e-6) < 0.01);
        assert!((separation(12.5e-6) - 0.5).abs() < 0.01);
        assert_eq!(separation(21e-6), 1.0);
    }

    #[test]
    fn samples_beside_the_rail_part_lobes_and_belong_to_none() {
        let mut broken = gaps(8e-6, 0.0);
        broken[200] = f64::INFINITY;
        assert_eq!(lobes(&broken).len(), 2);
        assert!(lobes(&[f64::INFINITY; 5]).is_empty());
    }
}
