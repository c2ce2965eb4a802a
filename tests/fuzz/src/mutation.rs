//! Bytes that are a little wrong, always the same ones for the same bytes.

use std::ops::Range;

/// What stands in files in place of what should.
const WRONG: &[&str] = &[
    "",
    "0",
    "-1",
    "1",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "9223372036854775807",
    "4294967296",
    "60000",
    "0.001",
    "true",
    "\"",
    "\"\"",
    "[",
    "]",
    "[[a]]",
    "{}",
    "\n",
    "\r",
    "\t",
    "\0",
    "\u{feff}",
    "\u{20ac}",
    "=",
    ",",
    ";",
    "<",
    ">",
    "</",
    "&#0;",
    "&amp;",
    "<!--",
    "<![CDATA[",
    "..",
    "/",
    "%2e",
    "#",
];

/// Mutation number `number` of `bytes`.
pub fn mutated(bytes: &[u8], number: u64) -> Vec<u8> {
    let mut dice = Dice::new(bytes, number);
    let mut mutated = bytes.to_vec();
    for _ in 0..1 + dice.below(3) {
        let range = dice.range(mutated.len());
        match dice.below(6) {
            0 => drop(mutated.drain(range)),
            1 => mutated.truncate(range.start),
            2 => {
                let again = mutated[range.clone()].to_vec();
                mutated.splice(range.end..range.end, again);
            }
            3 => {
                let wrong = *dice.of(WRONG);
                let word = word_at(&mutated, range.start);
                mutated.splice(word, wrong.bytes());
            }
            4 => {
                let wrong = *dice.of(WRONG);
                mutated.splice(range.start..range.start, wrong.bytes());
            }
            _ => mutated[range].iter_mut().for_each(|byte| *byte ^= 1 << dice.below(8)),
        }
    }
    mutated
}

/// The word or number around a byte.
fn word_at(bytes: &[u8], at: usize) -> Range<usize> {
    let is_in_word = |byte: &u8| byte.is_ascii_alphanumeric() || b"._-+".contains(byte);
    let before = bytes[..at].iter().rev().take_while(|byte| is_in_word(byte)).count();
    let after = bytes[at..].iter().take_while(|byte| is_in_word(byte)).count();
    at - before..at + after
}

/// Numbers that look like chance: SplitMix64 (Steele, Lea and Flood 2014).
struct Dice(u64);

impl Dice {
    /// Begins with a hash (FNV-1a) of what is mutated.
    fn new(bytes: &[u8], number: u64) -> Self {
        let hash = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        Self(bytes.iter().fold(0xcbf2_9ce4_8422_2325 ^ number.rotate_left(32), hash))
    }

    /// A number below `end`; 0 where that is 0.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) % (end.max(1) as u64)) as usize
    }

    /// A piece of so many bytes, mostly a short one.
    fn range(&mut self, length: usize) -> Range<usize> {
        let begin = self.below(length + 1);
        let most = [1, 4, 16, 200][self.below(4)];
        begin..length.min(begin + 1 + self.below(most))
    }

    fn of<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }
}
