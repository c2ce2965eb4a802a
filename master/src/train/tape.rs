//! What the wheels do to a rail, step by step, on disk: so that a train can pass again without
//! being computed again.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Seek, Write};
use std::path::Path;

/// The inputs of all steps of a rail, in a file without a name that goes with it.
pub struct Tape {
    writer: BufWriter<File>,
    reader: BufReader<File>,
    steps: u64,
}

impl Tape {
    /// An empty tape on the disk of `folder`.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn new(folder: &Path) -> io::Result<Self> {
        let file = tempfile::tempfile_in(folder)?;
        let reader = BufReader::new(file.try_clone()?);
        Ok(Self { writer: BufWriter::new(file), reader, steps: 0 })
    }

    /// Adds the inputs of a step.
    ///
    /// # Errors
    /// When the disk is full.
    pub fn add(&mut self, inputs: &[f64]) -> io::Result<()> {
        self.steps += 1;
        inputs.iter().try_for_each(|value| self.writer.write_all(&value.to_le_bytes()))
    }

    /// Goes back to the first step and gives the number of steps.
    ///
    /// # Errors
    /// When the disk is full.
    pub fn rewind(&mut self) -> io::Result<u64> {
        self.writer.flush()?;
        self.reader.rewind()?;
        Ok(self.steps)
    }

    /// Takes the inputs of the next step.
    ///
    /// # Errors
    /// When there is none, or the file cannot be read.
    pub fn next(&mut self, inputs: &mut [f64]) -> io::Result<()> {
        let mut bytes = [0; 8];
        for value in inputs {
            self.reader.read_exact(&mut bytes)?;
            *value = f64::from_le_bytes(bytes);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn property_a_tape_gives_the_same_bits_as_often_as_wanted() {
        let folder = tempfile::tempdir().unwrap();
        let mut tape = Tape::new(folder.path()).unwrap();
        let step = |k: u32| [f64::from(k) / 3.0, -1e300, f64::MIN_POSITIVE];
        for k in 0..5000 {
            tape.add(&step(k)).unwrap();
        }
        for _ in 0..2 {
            assert_eq!(tape.rewind().unwrap(), 5000);
            let mut inputs = [0.0; 3];
            for k in 0..5000 {
                tape.next(&mut inputs).unwrap();
                assert_eq!(inputs, step(k));
            }
            assert!(tape.next(&mut inputs).is_err(), "the tape has ended");
        }
    }
}
