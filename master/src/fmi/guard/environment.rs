//! How the processor computes: rounding, denormal numbers, exceptions.
//!
//! An FMU that changes this for its own thread changes what the other units on it compute. Reading it takes
//! some ten clock cycles, so it is compared after every call.

/// The settings of the processor for the thread at hand, without the flags of what has happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Environment {
    /// MXCSR on x86-64, FPCR on AArch64.
    control: u64,
    /// Control word of the x87 unit.
    x87: u16,
}

impl Environment {
    /// Those of now.
    pub fn now() -> Self {
        let (control, x87) = processor::read();
        Self { control, x87 }
    }

    /// Sets the processor back to these if it has others, and says what it had.
    pub fn put_back(self) -> Option<String> {
        let now = Self::now();
        if now == self {
            return None;
        }
        processor::write(self.control, self.x87);
        Some(now.words())
    }

    /// What is unusual about these settings.
    fn words(self) -> String {
        let found: Vec<_> = processor::unusual(self.control, self.x87).collect();
        match found.is_empty() {
            true => "the processor's settings changed".to_owned(),
            false => format!("the processor with {}", found.join(", ")),
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod processor {
    use std::arch::asm;

    /// The bits of MXCSR that say what has happened; all others say what shall happen.
    const FLAGS: u32 = 0x3f;

    /// MXCSR without its flags, and the control word of the x87 unit.
    pub fn read() -> (u64, u16) {
        let (mut mxcsr, mut x87) = (0_u32, 0_u16);
        // SAFETY: both instructions only write the two numbers.
        unsafe {
            asm!(
                "stmxcsr [{0}]",
                "fnstcw [{1}]",
                in(reg) &raw mut mxcsr,
                in(reg) &raw mut x87,
                options(nostack, preserves_flags),
            );
        }
        (u64::from(mxcsr & !FLAGS), x87)
    }

    /// Sets both; exceptions that wait are forgotten, as they would be trapped otherwise.
    pub fn write(control: u64, x87: u16) {
        let mxcsr = control as u32;
        // SAFETY: the values were read before, so that no reserved bit is set; Rust code runs with them.
        unsafe {
            asm!(
                "fnclex",
                "fldcw [{1}]",
                "ldmxcsr [{0}]",
                in(reg) &raw const mxcsr,
                in(reg) &raw const x87,
                options(nostack, preserves_flags),
            );
        }
    }

    /// What differs from how a program begins (System V ABI for AMD64, 3.2.1: MXCSR 0x1f80, x87 0x037f).
    pub fn unusual(control: u64, x87: u16) -> impl Iterator<Item = &'static str> {
        let x87 = u64::from(x87);
        [
            (control >> 13 & 3 != 0 || x87 >> 10 & 3 != 0, "another rounding than to nearest"),
            (control & 0x8040 != 0, "denormal numbers taken for zero"),
            (control & 0x1f80 != 0x1f80 || x87 & 0x3f != 0x3f, "floating-point exceptions trapped"),
            (x87 >> 8 & 3 != 3, "less precision in the x87 unit"),
        ]
        .into_iter()
        .filter_map(|(is, what)| is.then_some(what))
    }
}

#[cfg(target_arch = "aarch64")]
mod processor {
    use std::arch::asm;

    /// FPCR; there is no x87 unit.
    pub fn read() -> (u64, u16) {
        let mut fpcr: u64;
        // SAFETY: the instruction only reads the register.
        unsafe { asm!("mrs {}, fpcr", out(reg) fpcr, options(nomem, nostack, preserves_flags)) };
        (fpcr, 0)
    }

    /// Sets FPCR.
    pub fn write(control: u64, _: u16) {
        // SAFETY: the value was read before; Rust code runs with it.
        unsafe { asm!("msr fpcr, {}", in(reg) control, options(nomem, nostack, preserves_flags)) };
    }

    /// What differs from how a program begins, where FPCR is 0.
    pub fn unusual(control: u64, _: u16) -> impl Iterator<Item = &'static str> {
        [
            (control >> 22 & 3 != 0, "another rounding than to nearest"),
            (control >> 24 & 1 != 0, "denormal numbers taken for zero"),
            (control & 0x9f00 != 0, "floating-point exceptions trapped"),
        ]
        .into_iter()
        .filter_map(|(is, what)| is.then_some(what))
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod processor {
    /// Nothing is known of this processor.
    pub fn read() -> (u64, u16) {
        (0, 0)
    }

    /// Sets nothing.
    pub fn write(_: u64, _: u16) {}

    /// Nothing.
    pub fn unusual(_: u64, _: u16) -> impl Iterator<Item = &'static str> {
        std::iter::empty()
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    /// Rounding towards zero in both units, flushing, and a trap (Intel SDM, volume 1, 8.1.5 and 10.2.3).
    #[test]
    fn what_is_changed_is_named_and_put_back() {
        let before = Environment::now();
        assert_eq!(before.put_back(), None);
        for (control, x87, words) in [
            (0x7f80, 0x037f, "another rounding than to nearest"),
            (0x1f80, 0x0f7f, "another rounding than to nearest"),
            (0x9fc0, 0x037f, "denormal numbers taken for zero"),
            (0x1d80, 0x037f, "floating-point exceptions trapped"),
            (0x1f80, 0x007f, "less precision in the x87 unit"),
        ] {
            processor::write(control, x87);
            let reported = before.put_back().unwrap();
            assert!(reported.contains(words), "{control:#x} {x87:#x}: {reported}");
            assert_eq!(Environment::now(), before);
        }
    }
}
