//! FMU files: zip archives, unpacked with distrust and packed with care (FMI 2.0 §2.3).

use std::collections::HashSet;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

use zip::CompressionMethod;
use zip::write::SimpleFileOptions;

use crate::files::file_error::FileError;

/// How much may come out of an archive.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// Total size, bytes.
    bytes: u64,
    /// Number of files.
    files: usize,
}

/// The limits for an FMU.
const LIMITS: Limits = Limits { bytes: 2 << 30, files: 100_000 };

/// Why an archive cannot be unpacked or packed.
#[derive(Debug, thiserror::Error)]
pub enum ArchiveError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// Not a zip archive, or damaged.
    #[error("{path} is not a usable FMU: {source}; an FMU is a zip archive")]
    Damaged {
        /// Archive.
        path: String,
        /// Reason.
        source: zip::result::ZipError,
    },
    /// An entry would be written outside of the folder, or is a link.
    #[error("{path}: entry '{entry}' {reason}; the FMU is refused")]
    Unsafe {
        /// Archive.
        path: String,
        /// Name of the entry.
        entry: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// Two entries have the same name.
    #[error("{path}: two entries of the archive have the same name; the FMU is refused")]
    Repeated {
        /// Archive.
        path: String,
    },
    /// Too large.
    #[error("{path} unpacks to {what}; the FMU is refused")]
    TooLarge {
        /// Archive.
        path: String,
        /// How much of what comes out of it, and how much may.
        what: String,
    },
}

/// Unpacks `archive` into the folder `target`: no paths outside, no links, limited size.
///
/// # Errors
/// When the archive cannot be read, is damaged, unsafe or too large.
pub fn unpack(archive: &Path, target: &Path) -> Result<(), ArchiveError> {
    unpack_within(LIMITS, archive, target)
}

fn unpack_within(limits: Limits, archive: &Path, target: &Path) -> Result<(), ArchiveError> {
    let path = || archive.display().to_string();
    let damaged = |source| ArchiveError::Damaged { path: path(), source };
    let file = fs::File::open(archive).map_err(FileError::at(archive))?;
    let mut zip = zip::ZipArchive::new(file).map_err(damaged)?;
    let too_large = |what| ArchiveError::TooLarge { path: path(), what };
    if zip.len() > limits.files {
        return Err(too_large(format!("{} files (at most {})", zip.len(), limits.files)));
    }
    let too_many_bytes = || too_large(format!("more than {} bytes", limits.bytes));
    // What the archive says of itself, before anything is written.
    if zip.decompressed_size().is_some_and(|size| size > u128::from(limits.bytes)) {
        return Err(too_many_bytes());
    }
    if zip.has_duplicate_names() {
        return Err(ArchiveError::Repeated { path: path() });
    }
    let mut left = limits.bytes;
    let mut unpacked = HashSet::new();
    for i in 0..zip.len() {
        let mut entry = zip.by_index(i).map_err(damaged)?;
        let name = entry.name().map_err(damaged)?.into_owned();
        let refuse = |reason| ArchiveError::Unsafe { path: path(), entry: name.clone(), reason };
        if entry.is_symlink() {
            return Err(refuse("is a symbolic link"));
        }
        let inside = safe_path(&name).ok_or_else(|| refuse("leads out of the archive's folder"))?;
        let destination = target.join(inside);
        if entry.is_dir() {
            fs::create_dir_all(&destination).map_err(FileError::at(&destination))?;
            continue;
        }
        if let Some(folder) = destination.parent() {
            fs::create_dir_all(folder).map_err(FileError::at(folder))?;
        }
        if !unpacked.insert(destination.components().collect::<PathBuf>()) {
            return Err(refuse("is written where another one is"));
        }
        let mut out = fs::File::create(&destination).map_err(FileError::at(&destination))?;
        // The stated size may lie, so what is unpacked is counted.
        let written = io::copy(&mut entry.by_ref().take(left + 1), &mut out)
            .map_err(FileError::at(&destination))?;
        left = left.checked_sub(written).ok_or_else(too_many_bytes)?;
    }
    Ok(())
}

/// The entries of an archive that are packed by another method than stored or deflated, which is all
/// that FMI 2.0 allows (§2.3), and the methods.
///
/// # Errors
/// When the archive cannot be read or is damaged.
pub fn uncommon_entries(archive: &Path) -> Result<Vec<(String, String)>, ArchiveError> {
    let damaged = |source| ArchiveError::Damaged { path: archive.display().to_string(), source };
    let file = fs::File::open(archive).map_err(FileError::at(archive))?;
    let mut zip = zip::ZipArchive::new(file).map_err(damaged)?;
    let mut uncommon = vec![];
    for i in 0..zip.len() {
        let entry = zip.by_index_raw(i).map_err(damaged)?;
        let method = entry.compression();
        if !matches!(method, CompressionMethod::Stored | CompressionMethod::Deflated) {
            let name = entry.name().map_err(damaged)?.into_owned();
            uncommon.push((name, format!("{method:?}")));
        }
    }
    Ok(uncommon)
}

/// The entry's path if it stays inside of the folder it is unpacked to. Some tools of Windows write
/// backslashes between folders, which the format does not allow (APPNOTE 4.4.17.1).
fn safe_path(entry: &str) -> Option<PathBuf> {
    if entry.contains(':') || entry.contains('\0') {
        return None;
    }
    let path = PathBuf::from(entry.replace('\\', "/"));
    let inside = path.components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    inside.then_some(path)
}

/// Packs the files below `folder` into `archive`, in the order of their names and without
/// times, so that equal content gives equal bytes.
///
/// # Errors
/// When a file cannot be read or the archive cannot be written.
pub fn pack(folder: &Path, archive: &Path) -> Result<(), ArchiveError> {
    let damaged = |source| ArchiveError::Damaged { path: archive.display().to_string(), source };
    let mut files = vec![];
    list_files(folder, &mut files).map_err(FileError::at(folder))?;
    files.sort();
    let out = fs::File::create(archive).map_err(FileError::at(archive))?;
    let mut zip = zip::ZipWriter::new(out);
    // A run packs its FMUs anew, so that packing fast matters more than the last tenth of the size.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(1))
        .last_modified_time(zip::DateTime::default());
    for file in files {
        let name = file.strip_prefix(folder).unwrap_or(&file).to_string_lossy().replace('\\', "/");
        let permissions = if name.starts_with("binaries/") { 0o755 } else { 0o644 };
        zip.start_file(name, options.unix_permissions(permissions)).map_err(damaged)?;
        let content = fs::read(&file).map_err(FileError::at(&file))?;
        zip.write_all(&content).map_err(FileError::at(archive))?;
    }
    zip.finish().map_err(damaged)?;
    Ok(())
}

fn list_files(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list_files(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn archive_with(name: &str, options: SimpleFileOptions, folder: &Path) -> PathBuf {
        let path = folder.join("hostile.fmu");
        let mut zip = zip::ZipWriter::new(fs::File::create(&path).unwrap());
        zip.start_file(name, options).unwrap();
        zip.write_all(b"content").unwrap();
        zip.finish().unwrap();
        path
    }

    #[test]
    fn round_trip_and_equal_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let source = folder.path().join("source");
        fs::create_dir_all(source.join("resources")).unwrap();
        fs::write(source.join("modelDescription.xml"), "x").unwrap();
        fs::write(source.join("resources/a.toml"), "y").unwrap();
        let (one, two) = (folder.path().join("1.fmu"), folder.path().join("2.fmu"));
        pack(&source, &one).unwrap();
        pack(&source, &two).unwrap();
        assert_eq!(fs::read(&one).unwrap(), fs::read(&two).unwrap());
        let target = folder.path().join("target");
        unpack(&one, &target).unwrap();
        assert_eq!(fs::read_to_string(target.join("resources/a.toml")).unwrap(), "y");
    }

    #[test]
    fn entries_that_lead_outside_are_refused() {
        for name in ["../../x", "/etc/x", "a/../../x", "c:\\x", "a\\..\\x", "\\etc\\x"] {
            let folder = tempfile::tempdir().unwrap();
            let path = archive_with(name, SimpleFileOptions::default(), folder.path());
            let error = unpack(&path, &folder.path().join("target")).unwrap_err();
            assert!(matches!(error, ArchiveError::Unsafe { .. }), "{name}: {error}");
        }
    }

    #[test]
    fn backslashes_between_folders_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let name = "binaries\\linux64\\x.so";
        let path = archive_with(name, SimpleFileOptions::default(), folder.path());
        let target = folder.path().join("target");
        unpack(&path, &target).unwrap();
        assert_eq!(fs::read(target.join("binaries/linux64/x.so")).unwrap(), b"content");
    }

    #[test]
    fn links_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("link.fmu");
        let mut zip = zip::ZipWriter::new(fs::File::create(&path).unwrap());
        zip.add_symlink("link", "/tmp", SimpleFileOptions::default()).unwrap();
        zip.finish().unwrap();
        let error = unpack(&path, &folder.path().join("target")).unwrap_err();
        assert!(error.to_string().contains("symbolic link"), "{error}");
    }

    /// The writer refuses equal names, so the second is changed in the archive. Which of the two a tool reads
    /// is chance.
    #[test]
    fn an_archive_with_two_entries_of_one_name_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("twice.fmu");
        for (second, reason) in [
            ("modelDescription.xmk", "two entries of the archive have the same name"),
            ("./modelDescription.xml", "'./modelDescription.xml' is written where another one is"),
        ] {
            let mut zip = zip::ZipWriter::new(fs::File::create(&path).unwrap());
            for name in ["modelDescription.xml", second] {
                zip.start_file(name, SimpleFileOptions::default()).unwrap();
            }
            zip.finish().unwrap();
            let mut bytes = fs::read(&path).unwrap();
            while let Some(at) = bytes.windows(4).position(|part| part == b".xmk") {
                bytes[at..at + 4].copy_from_slice(b".xml");
            }
            fs::write(&path, bytes).unwrap();
            let target = tempfile::tempdir().unwrap();
            let error = unpack(&path, target.path()).unwrap_err().to_string();
            assert!(error.contains(reason), "{error}");
        }
    }

    const SMALL: Limits = Limits { bytes: 6, files: 1 };

    #[test]
    fn an_archive_that_says_it_is_too_large_is_refused_before_anything_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = archive_with("x", SimpleFileOptions::default(), folder.path());
        let target = folder.path().join("target");
        let error = unpack_within(SMALL, &path, &target).unwrap_err().to_string();
        assert!(error.contains("unpacks to more than 6 bytes"), "{error}");
        assert!(!target.exists());
        unpack_within(Limits { bytes: 7, ..SMALL }, &path, &target).unwrap();
    }

    /// The size in the directory of the archive is changed from 7 to 1.
    #[test]
    fn an_archive_that_lies_about_its_size_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        let path = archive_with("x", stored, folder.path());
        let mut bytes = fs::read(&path).unwrap();
        let directory = bytes.windows(4).position(|mark| mark == b"PK\x01\x02").unwrap();
        // Local header: size at 22; directory: size at 24.
        for offset in [22, directory + 24] {
            assert_eq!(bytes[offset], 7);
            bytes[offset] = 1;
        }
        fs::write(&path, bytes).unwrap();
        let error = unpack_within(SMALL, &path, &folder.path().join("target")).unwrap_err();
        assert!(matches!(error, ArchiveError::TooLarge { .. } | ArchiveError::File(_)), "{error}");
    }

    #[test]
    fn an_archive_with_too_many_files_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("many.fmu");
        let mut zip = zip::ZipWriter::new(fs::File::create(&path).unwrap());
        for name in ["a", "b"] {
            zip.start_file(name, SimpleFileOptions::default()).unwrap();
        }
        zip.finish().unwrap();
        let error = unpack_within(SMALL, &path, &folder.path().join("target")).unwrap_err();
        assert!(error.to_string().contains("2 files (at most 1)"), "{error}");
    }

    #[test]
    fn a_file_that_is_no_archive_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("corrupt.fmu");
        fs::write(&path, "not a zip").unwrap();
        let error = unpack(&path, folder.path()).unwrap_err().to_string();
        assert!(error.contains("corrupt.fmu is not a usable FMU"), "{error}");
    }
}
