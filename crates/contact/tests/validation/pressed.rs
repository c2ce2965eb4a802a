//! A loaded contact as the gradient of its elastic energy.

use crate::pair;
use contact::{GeometryTable, PatchAt, PressedPatch, WheelPosition};

/// The contacts of a wheel that press.
fn pressed(table: &GeometryTable, wheel: &WheelPosition) -> Vec<PressedPatch> {
    let row = table.row(wheel.shift);
    let patches = (0..table.patches()).filter_map(|patch| table.patch(patch, row, wheel));
    let sunk = |mut patch: PatchAt<'_>| (patch.sunk(wheel) > 0.0).then(|| patch.pressed(wheel));
    patches.filter_map(sunk).collect()
}

/// Elastic energy of the whole wheel, J.
fn energy(table: &GeometryTable, wheel: &WheelPosition) -> f64 {
    pressed(table, wheel).iter().map(|patch| patch.energy).sum()
}

/// Places from the tread over the flange root to the flange, pressed by 40 to 200 um, straight and with the
/// yaw and roll of a curve of 150 m.
fn places(table: &GeometryTable) -> Vec<WheelPosition> {
    let mut places = vec![];
    for i in 0..420 {
        let shift = 1e-3 + 2.0031e-5 * f64::from(i);
        for (depth, roll, yaw) in [(40e-6, 0.0, 0.0), (100e-6, -6e-4, 9e-3), (200e-6, -1e-3, 18e-3)]
        {
            // Down until the wheel is pressed so far in one of its contacts.
            let at = |descent| WheelPosition { shift, descent, roll, yaw_squared: yaw * yaw };
            let (mut high, mut low) = (-0.02, 0.02);
            for _ in 0..50 {
                let middle: f64 = 0.5 * (high + low);
                let deep = pressed(table, &at(middle)).iter().any(|patch| patch.approach > depth);
                if deep { low = middle } else { high = middle }
            }
            places.push(at(low));
        }
    }
    places
}

/// The force that each contact gives is what the energy of all loses by a displacement: sideways, down, in
/// roll and in yaw. Central differences over 1e-8 (m, rad, rad²); 1e-3 of the normal forces: 5e-4 is what
/// the differences and the turning of the path by roll and yaw under the foot leave at two places of the
/// corner between root and flange, less elsewhere.
#[test]
fn property_normal_force_is_the_gradient_of_the_energy() {
    for (wheel, rail) in [("S1002", "60E1"), ("S1002", "AS60"), ("cone-1-20", "60E1")] {
        let table = GeometryTable::shared(&pair(wheel, rail)).unwrap();
        for place in places(&table) {
            let patches = pressed(&table, &place);
            let sum = |part: &dyn Fn(&PressedPatch) -> f64| -> f64 {
                let force = |patch: &PressedPatch| patch.point.hertz.normal_force(patch.approach);
                patches.iter().map(|patch| force(patch) * part(patch)).sum()
            };
            let slope = |change: &dyn Fn(&mut WheelPosition, f64), step: f64| {
                let [after, before] = [step, -step].map(|step| {
                    let mut moved = place;
                    change(&mut moved, step);
                    energy(&table, &moved)
                });
                (after - before) / (2.0 * step)
            };
            let normal = sum(&|_| 1.0);
            let cases = [
                ("shift", slope(&|w, d| w.shift += d, 1e-8), sum(&|p| p.by_shift)),
                ("descent", slope(&|w, d| w.descent += d, 1e-8), sum(&|p| p.by_descent)),
                ("roll", slope(&|w, d| w.roll += d, 1e-8), sum(&|p| p.by_descent * p.roll_arm)),
                ("yaw", slope(&|w, d| w.yaw_squared += d, 1e-8), sum(&|p| p.by_yaw_squared)),
            ];
            for (what, found, expected) in cases {
                let error = (found - expected).abs() / normal;
                assert!(
                    error < 1e-3,
                    "{wheel} on {rail}, {what}: {found} instead of {expected} at {place:?}"
                );
            }
        }
    }
}
