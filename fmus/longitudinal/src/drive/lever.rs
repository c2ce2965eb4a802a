//! The lever of a drive, which follows the driver's command at a limited rate.
//!
//! One number: from 0 to 1 traction as a share of the highest notch, from 0 to −1 dynamic brake as
//! a share of full effort. It moves at a constant rate and goes through zero (theory, eq. 13).

/// The lever after a time `step`, s, in which it moves to `target`.
///
/// The ramps are the times for the whole range of traction and of dynamic brake, s.
pub fn moved(
    lever: f64,
    target: f64,
    step: f64,
    traction_ramp: f64,
    dynamic_brake_ramp: f64,
) -> f64 {
    let (from, to, ramp) = match lever > 0.0 || (lever == 0.0 && target > 0.0) {
        true => (0.0, 1.0, traction_ramp),
        false => (-1.0, 0.0, dynamic_brake_ramp),
    };
    let target = target.max(from).min(to);
    match step < ramp {
        true => lever + (target - lever).max(-step / ramp).min(step / ramp),
        false => target,
    }
}

#[cfg(test)]
mod tests {
    use super::moved;

    #[test]
    fn analytic_lever_needs_its_ramp_for_the_whole_way() {
        let mut lever = 0.0;
        for _ in 0..2500 {
            assert!(lever < 1.0);
            lever = moved(lever, 1.0, 0.01, 25.0, 10.0);
        }
        assert!((lever - 1.0).abs() < 1e-9);
    }

    #[test]
    fn lever_stops_at_zero_between_traction_and_dynamic_brake() {
        assert_eq!(moved(0.01, -1.0, 1.0, 10.0, 10.0), 0.0);
        assert_eq!(moved(0.0, -1.0, 1.0, 10.0, 10.0), -0.1);
    }

    #[test]
    fn lever_without_ramp_moves_at_once() {
        assert_eq!(moved(0.0, 0.5, 0.001, 0.0, 0.0), 0.5);
    }
}
