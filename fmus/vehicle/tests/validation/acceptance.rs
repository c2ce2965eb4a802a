//! The acceptance scenarios: the locomotive over their track files, judged as rail practice does.
//! Where the limits come from: `docs/validation/vehicle.md`.

use std::path::{Path, PathBuf};

use numerics::constants::STANDARD_GRAVITY;
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;
use vehicle::track::Line;

use crate::common::*;

/// Static wheel load Q0, N.
const STATIC_LOAD: f64 = 134e3 * STANDARD_GRAVITY / 12.0;

/// Greatest sum of Y of a wheelset: 10 kN + 2 Q0/3, N.
const TRACK_SHIFT: f64 = 10e3 + 2.0 * STATIC_LOAD / 3.0;

/// What a run showed.
#[derive(Debug, Default)]
struct Judged {
    quotient: f64,
    unloading: f64,
    vertical: f64,
    lateral_sum: f64,
    /// Root mean square of the sum of Y of the first wheelset.
    lateral_sum_rms: f64,
    /// Standard deviation of the body's lateral acceleration, m/s².
    body_acceleration: f64,
}

/// Folder of a scenario.
fn scenario(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios").join(name)
}

/// Runs the locomotive for the time of a scenario; extremes are those of forces averaged over 20 ms.
fn judge(name: &str) -> (Judged, Dynamics) {
    let folder = scenario(name);
    let text = std::fs::read_to_string(folder.join("scenario.toml")).unwrap();
    let file: toml::Table = text.parse().unwrap();
    let speed = file["train"]["speed_m_per_s"].as_float().unwrap();
    let time = file["duration_s"].as_float().unwrap();
    let line = Line::shared(&folder.join("track.toml")).unwrap();
    let inputs = Inputs::none(FRICTION);
    let mut vehicle = Dynamics::new(locomotive(), line);
    assert!(vehicle.start(0.0, speed, &inputs).reached, "{name}");
    let (mut judged, mut sums) = (Judged::default(), [0.0; 3]);
    let windows = (time / 0.02).round() as usize;
    for _ in 0..windows {
        let before = vehicle.state.bodies[0].velocity.y;
        let mut means = [[[0.0; 2]; 2]; 6];
        for _ in 0..20 {
            vehicle.step(1e-3, &inputs);
            for (mean, wheels) in means.iter_mut().zip(&vehicle.wheels) {
                for (mean, wheel) in mean.iter_mut().zip(wheels) {
                    mean[0] += wheel.guiding / 20.0;
                    mean[1] += wheel.vertical / 20.0;
                }
            }
        }
        let acceleration = (vehicle.state.bodies[0].velocity.y - before) / 0.02;
        sums[0] += acceleration;
        sums[1] += acceleration * acceleration;
        let first = means[0][0][0] + means[0][1][0];
        sums[2] += first * first;
        for wheels in means {
            judged.lateral_sum = judged.lateral_sum.max((wheels[0][0] + wheels[1][0]).abs());
            for ([lateral, vertical], outward) in wheels.into_iter().zip([1.0, -1.0]) {
                judged.quotient = judged.quotient.max(outward * lateral / vertical);
                judged.vertical = judged.vertical.max(vertical);
                judged.unloading = judged.unloading.max(1.0 - vertical / STATIC_LOAD);
            }
        }
    }
    let count = windows as f64;
    let mean = sums[0] / count;
    judged.body_acceleration = (sums[1] / count - mean * mean).sqrt();
    judged.lateral_sum_rms = (sums[2] / count).sqrt();
    println!("{name}: {judged:?}");
    (judged, vehicle)
}

/// Twist of 3 per mille at 3 m/s: wheel unloading at most 0.6.
#[test]
fn benchmark_twist() {
    let (judged, _) = judge("acceptance-twist");
    assert!(judged.unloading < 0.6 && judged.unloading > 0.05, "{judged:?}");
}

/// Sine of 6 mm in the alignment at 22 m/s: Y/Q at most 0.8, track shift force below its limit.
#[test]
fn benchmark_sine() {
    let (judged, _) = judge("acceptance-sine");
    assert!(judged.quotient < 0.8 && judged.lateral_sum < TRACK_SHIFT, "{judged:?}");
}

/// A lateral step of 5 mm at 25 m/s: Y/Q at most 0.8, and the wheelsets come to rest beside the new
/// middle.
#[test]
fn benchmark_ramp() {
    let (judged, vehicle) = judge("acceptance-ramp");
    assert!(judged.quotient < 0.8, "{judged:?}");
    for data in &vehicle.structure.wheelsets {
        let aside = vehicle.state.bodies[data.body].position.y - 5e-3;
        assert!(aside.abs() < 0.5e-3, "{aside} m");
    }
}

/// Curve of R 600 m with 80 mm of cant at cant deficiencies of 0, 50 and 100 mm: Y/Q at most 0.8,
/// track shift force and vertical force below their limits, and all of them rise with the deficiency.
#[test]
fn benchmark_curves() {
    let judged = [0, 50, 100].map(|mm| judge(&format!("acceptance-curve-{mm}mm")).0);
    for judged in &judged {
        assert!(judged.quotient < 0.8 && judged.lateral_sum < TRACK_SHIFT, "{judged:?}");
        assert!(judged.vertical < (90e3 + STATIC_LOAD).min(200e3), "{judged:?}");
    }
    assert!(judged.windows(2).all(|pair| pair[0].vertical < pair[1].vertical), "{judged:?}");
}

/// Rough straight track at 35 m/s: standard deviation of the body's lateral acceleration at most
/// 0.13 g, root mean square of the sum of Y at most half its limit.
#[test]
fn benchmark_hunting() {
    let (judged, _) = judge("acceptance-hunting");
    assert!(judged.body_acceleration < 0.13 * STANDARD_GRAVITY, "{judged:?}");
    assert!(judged.lateral_sum_rms < 0.5 * TRACK_SHIFT, "{judged:?}");
}
