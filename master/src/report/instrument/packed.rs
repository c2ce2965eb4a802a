//! Numbers as text that a page can hold: little-endian binary in base64, a third of what digits take.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

/// Numbers in single precision; not-a-number stays what it is.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub(in crate::report) struct Packed(String);

impl Packed {
    /// Packs numbers.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let bytes = values.into_iter().flat_map(|value| (value as f32).to_le_bytes());
        Self(STANDARD.encode(bytes.collect::<Vec<u8>>()))
    }
}

/// Rows of numbers, each in steps of its own: what the largest in the row is over [`STEPS`].
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub(super) struct PackedRows {
    /// Step of each row.
    step: Packed,
    /// The numbers in steps of their rows, as 16-bit integers.
    steps: String,
}

/// Steps of the largest number of a row.
const STEPS: f64 = 32_767.0;

impl PackedRows {
    /// Packs rows of numbers; what is not finite becomes zero.
    pub fn of<R: AsRef<[f64]>>(rows: impl IntoIterator<Item = R>) -> Self {
        let (mut step, mut bytes) = (vec![], vec![]);
        for row in rows {
            let row = row.as_ref();
            let finite = row.iter().filter(|value| value.is_finite());
            let largest = finite.fold(0.0, |largest: f64, value| largest.max(value.abs()));
            // The page has the step in single precision too.
            let of_row = f64::from((largest / STEPS) as f32);
            let scaled = |value: &f64| match of_row > 0.0 {
                true => (value / of_row).round() as i16,
                false => 0,
            };
            bytes.extend(row.iter().flat_map(|value| scaled(value).to_le_bytes()));
            step.push(of_row);
        }
        Self { step: Packed::of(step), steps: STANDARD.encode(bytes) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1.0 is 0x3f800000 and -2.5 is 0xc0200000 (IEEE 754).
    #[test]
    fn benchmark_numbers_are_little_endian_singles() {
        let bytes = STANDARD.decode(Packed::of([1.0, -2.5]).0).unwrap();
        assert_eq!(bytes, [0, 0, 0x80, 0x3f, 0, 0, 0x20, 0xc0]);
    }

    #[test]
    fn property_a_row_keeps_four_digits_of_its_largest_number() {
        let rows = [vec![1e-6, -3e-6, 0.0], vec![100.0, f64::NAN, 50.0], vec![0.0; 3]];
        let packed = PackedRows::of(&rows);
        let steps = STANDARD.decode(&packed.steps).unwrap();
        let step = STANDARD.decode(&packed.step.0).unwrap();
        for (number, row) in rows.iter().enumerate() {
            let step = f32::from_le_bytes(step[4 * number..][..4].try_into().unwrap());
            for (column, wanted) in row.iter().enumerate().filter(|(_, value)| value.is_finite()) {
                let at = 2 * (3 * number + column);
                let found = i16::from_le_bytes([steps[at], steps[at + 1]]);
                let difference = f64::from(found) * f64::from(step) - wanted;
                let largest = row.iter().copied().fold(0.0, |a: f64, b| a.max(b.abs()));
                assert!(difference.abs() <= 2e-5 * largest, "{difference} of {wanted}");
            }
        }
    }
}
