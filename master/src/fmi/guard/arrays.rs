//! The arrays that an FMU is handed. They are copies between guard words, so that nothing that an FMU
//! writes reaches the master's own values but what it was asked for.
//!
//! A copy and a comparison of some hundred numbers take less than a hundredth of the shortest step of a
//! vehicle, so they are made in every call.

/// Guard words on either side of an array.
const GUARDS: usize = 8;

/// A number that is exchanged.
pub trait Word: Copy + Default {
    /// What stands around an array: a number that no FMU writes by chance.
    const GUARD: Self;
    /// Its bits.
    fn bits(self) -> u64;
}

impl Word for f64 {
    const GUARD: Self = f64::from_bits(0x7ff4_dead_beef_5afe);
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl Word for i32 {
    const GUARD: Self = 0x5afe_beef;
    fn bits(self) -> u64 {
        u64::from(self.cast_unsigned())
    }
}

impl Word for u32 {
    const GUARD: Self = 0x5afe_beef;
    fn bits(self) -> u64 {
        u64::from(self)
    }
}

/// An array between guard words; its memory is used again by the next call.
#[derive(Default)]
struct Lent<T>(Vec<T>);

impl<T: Word> Lent<T> {
    /// Takes in the numbers, and gives where they lie.
    fn lend(&mut self, numbers: &[T]) -> *mut T {
        let Self(words) = self;
        words.clear();
        words.resize(GUARDS, T::GUARD);
        words.extend_from_slice(numbers);
        words.resize(numbers.len() + 2 * GUARDS, T::GUARD);
        words[GUARDS..].as_mut_ptr()
    }

    fn numbers(&self) -> &[T] {
        &self.0[GUARDS..self.0.len() - GUARDS]
    }

    /// Whether all guard words are as they were.
    fn is_kept(&self) -> bool {
        let (front, rest) = self.0.split_at(GUARDS);
        let back = &rest[rest.len() - GUARDS..];
        front.iter().chain(back).all(|word| word.bits() == T::GUARD.bits())
    }

    fn holds(&self, numbers: &[T]) -> bool {
        let pairs = self.numbers().iter().zip(numbers);
        pairs.fold(0, |different, (own, other)| different | (own.bits() ^ other.bits())) == 0
    }
}

/// Value references and the values of variables, as an FMU is handed them.
#[derive(Default)]
pub struct Arrays<T> {
    references: Lent<u32>,
    values: Lent<T>,
}

impl<T: Word> Arrays<T> {
    /// Takes in references and values, and gives where they lie until the next call.
    pub fn lend(&mut self, references: &[u32], values: &[T]) -> (*const u32, *mut T) {
        (self.references.lend(references), self.values.lend(values))
    }

    /// What an FMU has done in setting these, that it must not.
    pub fn damage_in_setting(&self, references: &[u32], values: &[T]) -> Option<String> {
        let changed = || "it has changed the values that it shall only read".to_owned();
        self.damage(references).or_else(|| (!self.values.holds(values)).then(changed))
    }

    /// The same in getting these; `values` become what it gave.
    pub fn damage_in_getting(&self, references: &[u32], values: &mut [T]) -> Option<String> {
        values.copy_from_slice(self.values.numbers());
        self.damage(references)
    }

    fn damage(&self, references: &[u32]) -> Option<String> {
        let count = references.len();
        if !self.values.is_kept() || !self.references.is_kept() {
            return Some(format!("it has written outside of the array of {count} values"));
        }
        let changed = || "it has changed the value references that it shall only read".to_owned();
        (!self.references.holds(references)).then(changed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_an_fmu_gives_is_taken_and_all_else_is_named() {
        let mut arrays = Arrays::default();
        let references = [4, 5];
        let mut values = [1.0, f64::NAN];
        let (_, lent) = arrays.lend(&references, &values);
        assert_eq!(arrays.damage_in_setting(&references, &values), None);
        // SAFETY: two values were lent.
        unsafe { lent.add(1).write(3.0) };
        let reported = arrays.damage_in_setting(&references, &values).unwrap();
        assert_eq!(reported, "it has changed the values that it shall only read");
        assert_eq!(arrays.damage_in_getting(&references, &mut values), None);
        assert_eq!(values, [1.0, 3.0]);

        for place in [-8, -1, 2, 9] {
            let (_, lent) = arrays.lend(&references, &values);
            // SAFETY: there are eight guard words on either side of the two values.
            unsafe { lent.offset(place).write(0.0) };
            let reported = arrays.damage_in_getting(&references, &mut values).unwrap();
            assert_eq!(reported, "it has written outside of the array of 2 values", "{place}");
        }
        let (lent, _) = arrays.lend(&references, &values);
        // SAFETY: two references were lent, from memory that is written.
        unsafe { lent.cast_mut().write(9) };
        let reported = arrays.damage_in_getting(&references, &mut values).unwrap();
        assert_eq!(reported, "it has changed the value references that it shall only read");
    }
}
