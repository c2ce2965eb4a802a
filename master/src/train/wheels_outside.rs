//! What can be foreseen before the first step: wheels outside the modelled rail, which heat nothing.

use super::layout::Layout;
use crate::scenario::Extent;
use crate::system::step::System;

/// A sentence on wheels that stand outside the modelled rail at the start, and one on wheels that
/// leave it if they keep their speed for `duration`, s.
pub fn wheels_outside(
    layout: &Layout,
    system: &mut System,
    extent: Extent,
    duration: f64,
) -> Vec<String> {
    let mut wheels = vec![];
    for vehicle in &layout.vehicles {
        let speed = vehicle.tap_output(system, "velocity");
        let speed = speed.map_or(0.0, |tap| system.value(&tap));
        for j in 1..=vehicle.wheelsets {
            let position = vehicle.tap_wheelset(system, j);
            wheels.extend(position.map(|tap| (system.value(&tap), speed)));
        }
    }
    sentences(&wheels, extent, duration)
}

/// The same for wheels with their positions, m, and speeds, m/s.
fn sentences(wheels: &[(f64, f64)], extent: Extent, duration: f64) -> Vec<String> {
    let positions = || wheels.iter().map(|(position, _)| *position);
    let ahead = wheels.iter().map(|(position, speed)| position + duration * speed);
    let (tail, head) = (lowest(positions()), highest(positions()));
    let farthest = highest(ahead);
    let (begin, end) = (extent.begin, extent.begin + extent.length);
    // Behind the rail a train may come to it; ahead of it, it does not.
    if tail > end || farthest < begin {
        return vec![format!(
            "in this run no wheel comes to the modelled rail, which goes from {begin} m to {end} m \
             (heat.begin_m, heat.length_m), and nothing is heated: at the start wheels stand from chainage \
             {tail:.1} m to {head:.1} m, and at the speed of the start the first one comes to {farthest:.1} m"
        )];
    }
    let mut sentences = vec![];
    if tail < begin || head > end {
        sentences.push(format!(
            "at the start wheels stand from chainage {tail:.1} m to {head:.1} m, but the rail is modelled \
             from {begin} m to {end} m only (heat.begin_m, heat.length_m); wheels outside of it heat nothing"
        ));
    }
    if head <= end && farthest > end {
        sentences.push(format!(
            "at the speed of the start the first wheel comes to chainage {farthest:.1} m, but the rail is \
             modelled to {end} m only (heat.length_m); wheels beyond it heat nothing"
        ));
    }
    sentences
}

fn lowest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}

fn highest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXTENT: Extent = Extent { begin: 0.0, length: 100.0 };

    #[test]
    fn wheels_outside_are_told_at_the_start_and_ahead() {
        let said = |position, duration| sentences(&[(position, 10.0)], EXTENT, duration);
        assert_eq!(said(50.0, 4.9), [""; 0]);
        assert!(said(-1.0, 1.0)[0].contains("from chainage -1.0 m to -1.0 m"));
        let ahead = said(50.0, 5.1);
        assert!(ahead[0].contains("comes to chainage 101.0 m") && ahead.len() == 1, "{ahead:?}");
        let never = said(101.0, 5.0);
        assert!(never[0].contains("no wheel comes to the modelled rail") && never.len() == 1);
        assert!(said(-60.0, 5.0)[0].contains("the first one comes to -10.0 m"));
        assert!(said(-60.0, 7.0)[0].starts_with("at the start"), "it comes there later");
    }
}
