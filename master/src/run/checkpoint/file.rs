//! A state as a file: what it is, a digest, the content. It gets its name only when it is on the disk.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use crate::files::file_error::FileError;

/// Begins each file; the number is that of the format.
const MAGIC: &[u8] = b"hotfoot checkpoint 1\n";

/// Length of a digest, bytes.
const DIGEST: usize = 32;

/// Writes a state; a file that is there is replaced when all of the new one is on the disk.
///
/// # Errors
/// When the file cannot be written.
pub fn write(path: &Path, state: &impl Serialize) -> Result<(), FileError> {
    write_whole(path, &[&to_bytes(state)])
}

/// A state as the bytes of its file.
pub fn to_bytes(state: &impl Serialize) -> Vec<u8> {
    let content = postcard::to_allocvec(state).expect("plain data can always be serialized");
    [MAGIC, &Sha256::digest(&content), &content].concat()
}

/// Writes a file of these pieces under another name, and gives it its own when it is on the disk.
///
/// # Errors
/// When the file cannot be written.
pub fn write_whole(path: &Path, pieces: &[&[u8]]) -> Result<(), FileError> {
    let hidden = path.with_extension("partial");
    let write = || -> io::Result<()> {
        let mut file = File::create(&hidden)?;
        pieces.iter().try_for_each(|piece| file.write_all(piece))?;
        file.sync_all()?;
        fs::rename(&hidden, path)?;
        match path.parent() {
            // The name is on the disk when the folder is.
            Some(folder) if cfg!(unix) => File::open(folder)?.sync_all(),
            _ => Ok(()),
        }
    };
    write().map_err(FileError::at(path))
}

/// Reads a state, or says what is wrong with the file.
///
/// # Errors
/// When it cannot be read, or is not one that was written as a whole.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, String> {
    from_bytes(&fs::read(path).map_err(|error| error.to_string())?)
}

/// The state that these are the bytes of, or says what is wrong with them.
///
/// # Errors
/// When they are not those of a whole state.
pub fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let rest = bytes.strip_prefix(MAGIC).ok_or("it is no checkpoint of this version")?;
    let (digest, content) = rest.split_at_checked(DIGEST).ok_or("it is cut short")?;
    if Sha256::digest(content)[..] != *digest {
        return Err("it is damaged: its digest is wrong".to_owned());
    }
    postcard::from_bytes(content).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn property_a_state_comes_back_and_no_damage_passes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("00000001.state");
        let state = (7_u64, vec![1.5, f64::NEG_INFINITY], "wheel".to_owned());
        write(&path, &state).unwrap();
        assert_eq!(read::<(u64, Vec<f64>, String)>(&path).unwrap(), state);
        let bytes = fs::read(&path).unwrap();
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            fs::write(&path, damaged).unwrap();
            assert!(read::<(u64, Vec<f64>, String)>(&path).is_err(), "byte {at}");
            fs::write(&path, &bytes[..at]).unwrap();
            assert!(read::<(u64, Vec<f64>, String)>(&path).is_err(), "cut at {at}");
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left");
    }
}
