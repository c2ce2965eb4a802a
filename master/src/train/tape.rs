//! What the wheels do to a rail, step by step, on disk: so that a train can pass again without
//! being computed again.

use std::fs::{File, OpenOptions};
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// The inputs of all steps of a rail.
pub struct Tape {
    writer: BufWriter<File>,
    reader: BufReader<File>,
    steps: u64,
}

impl Tape {
    /// An empty tape on the disk of `folder`, in a file without a name that goes with it.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn new(folder: &Path) -> io::Result<Self> {
        Self::of(tempfile::tempfile_in(folder)?)
    }

    /// The tape in `file`, on which another run can go on; it is empty until that is asked for.
    ///
    /// # Errors
    /// When the file cannot be opened or made.
    pub fn in_file(file: &Path) -> io::Result<Self> {
        let mut options = OpenOptions::new();
        Self::of(options.read(true).write(true).create(true).truncate(false).open(file)?)
    }

    fn of(file: File) -> io::Result<Self> {
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

    /// Leaves everything to the system and gives the number of steps.
    ///
    /// # Errors
    /// When the disk is full.
    pub fn save(&mut self) -> io::Result<u64> {
        self.writer.flush()?;
        Ok(self.steps)
    }

    /// Goes on behind so many steps of so many inputs that another run has left in the file.
    ///
    /// # Errors
    /// When there are fewer.
    pub fn resume(&mut self, steps: u64, inputs: usize) -> io::Result<()> {
        let length = offset(steps, inputs);
        if self.writer.get_ref().metadata()?.len() < length {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        self.writer.get_ref().set_len(length)?;
        self.writer.seek(SeekFrom::Start(length))?;
        self.steps = steps;
        Ok(())
    }

    /// Goes to the step of that number, from zero, of so many inputs each, and gives the number of steps.
    ///
    /// # Errors
    /// When the disk is full.
    pub fn seek(&mut self, step: u64, inputs: usize) -> io::Result<u64> {
        self.writer.flush()?;
        self.reader.seek(SeekFrom::Start(offset(step, inputs)))?;
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

/// Where a step begins in the file.
fn offset(step: u64, inputs: usize) -> u64 {
    step * inputs as u64 * size_of::<f64>() as u64
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
            assert_eq!(tape.seek(0, 3).unwrap(), 5000);
            let mut inputs = [0.0; 3];
            for k in 0..5000 {
                tape.next(&mut inputs).unwrap();
                assert_eq!(inputs, step(k));
            }
            assert!(tape.next(&mut inputs).is_err(), "the tape has ended");
        }
    }
    /// Another run goes on behind some of the steps; those behind them come anew.
    #[test]
    fn property_a_tape_goes_on_in_another_run() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("tape");
        let mut killed = Tape::in_file(&file).unwrap();
        (0..7).for_each(|k| killed.add(&[f64::from(k), 0.5]).unwrap());
        assert_eq!(killed.save().unwrap(), 7);
        let mut resumed = Tape::in_file(&file).unwrap();
        resumed.resume(4, 2).unwrap();
        (10..12).for_each(|k| resumed.add(&[f64::from(k), 0.5]).unwrap());
        assert_eq!(resumed.seek(3, 2).unwrap(), 6);
        for expected in [3.0, 10.0, 11.0] {
            let mut inputs = [0.0; 2];
            resumed.next(&mut inputs).unwrap();
            assert_eq!(inputs, [expected, 0.5]);
        }
        assert!(resumed.next(&mut [0.0; 2]).is_err(), "the tape has ended");
        let error = Tape::in_file(&file).unwrap().resume(7, 2).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::UnexpectedEof);
    }
}
