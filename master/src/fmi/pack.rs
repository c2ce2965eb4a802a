//! Packs an FMU: a binary with resources, and the model description that the binary gives for
//! them. So one binary serves trains of any length.

use std::fs;
use std::path::{Path, PathBuf};

use crate::check::TERMINALS;
use crate::files::archive::{self, ArchiveError};
use crate::files::file_error::FileError;
use crate::fmi::documentation::{EQUATIONS, INDEX, Text, equations_page, with_link_to_equations};
use crate::fmi::{self, ImportError, describe};

/// Icon of the FMUs.
const MODEL_PNG: &[u8] = include_bytes!("../../assets/model.png");
/// Licences of the FMUs, by their names in `documentation/licenses`: which hold, and their texts.
const LICENSES: [(&str, &str); 3] = [
    ("license.txt", include_str!("../../assets/license.txt")),
    ("LICENSE-MIT", include_str!("../../../LICENSE-MIT")),
    ("LICENSE-APACHE", include_str!("../../../LICENSE-APACHE")),
];

/// Why an FMU cannot be packed.
#[derive(Debug, thiserror::Error)]
pub enum PackError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The archive cannot be read or written.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// The binary cannot be loaded or refuses the resources.
    #[error(transparent)]
    Import(#[from] ImportError),
}

/// Where the binary of the new FMU comes from.
#[derive(Debug, Clone, Copy)]
pub enum Binary<'a> {
    /// A shared library.
    Library(&'a Path),
    /// An FMU that was packed before.
    Fmu(&'a Path),
}

/// Packs `binary` with the files of the folder `resources` into the FMU `target`.
///
/// # Errors
/// When files cannot be read or written, or the model refuses the resources.
pub fn pack(binary: Binary<'_>, resources: &Path, target: &Path) -> Result<(), PackError> {
    let folder = tempfile::tempdir().map_err(FileError::at(target))?;
    let base = folder.path().join("base");
    let (library, file) = match binary {
        Binary::Library(path) => (path.to_owned(), path),
        Binary::Fmu(path) => (unpacked_binary(path, &base)?, path),
    };
    let description = describe(&library, &file.display().to_string(), resources)?;

    let content = folder.path().join("content");
    let file = |name: &str, bytes: &[u8]| write(&content.join(name), bytes);
    file("modelDescription.xml", description.xml.as_bytes())?;
    match fs::read(base.join(EQUATIONS)) {
        Ok(equations) => {
            file(EQUATIONS, &equations)?;
            file(INDEX, with_link_to_equations(&description.html).as_bytes())?;
        }
        Err(_) => file(INDEX, description.html.as_bytes())?,
    }
    if !description.terminals.is_empty() {
        file(TERMINALS, description.terminals.as_bytes())?;
    }
    for (name, text) in LICENSES {
        file(&format!("documentation/licenses/{name}"), text.as_bytes())?;
    }
    file("model.png", MODEL_PNG)?;
    let bytes = fs::read(&library).map_err(FileError::at(&library))?;
    write(&content.join(fmi::binary_path(&description.identifier)), &bytes)?;
    copy_folder(resources, &content.join("resources"))?;
    Ok(archive::pack(&content, target)?)
}

/// Adds the equations of the model, texts in Markdown, to the documentation of an FMU. An FMU
/// that is packed from this one has them too.
///
/// # Errors
/// When a text or the FMU cannot be read or written.
pub fn add_equations(fmu: &Path, files: &[PathBuf]) -> Result<(), PackError> {
    let read = |file: &PathBuf| {
        let markdown = fs::read_to_string(file).map_err(FileError::at(file))?;
        Ok(Text { file: file.clone(), markdown })
    };
    let texts = files.iter().map(read).collect::<Result<Vec<_>, FileError>>()?;
    let folder = tempfile::tempdir().map_err(FileError::at(fmu))?;
    archive::unpack(fmu, folder.path())?;
    let index = folder.path().join(INDEX);
    let page = fs::read_to_string(&index).map_err(FileError::at(&index))?;
    write(&index, with_link_to_equations(&page).as_bytes())?;
    write(&folder.path().join(EQUATIONS), equations_page(&texts).as_bytes())?;
    Ok(archive::pack(folder.path(), fmu)?)
}

/// Unpacks an FMU and gives the path of its binary.
fn unpacked_binary(fmu: &Path, folder: &Path) -> Result<PathBuf, PackError> {
    archive::unpack(fmu, folder)?;
    let interface = fmi::read_interface(folder, &fmu.display().to_string())?;
    Ok(folder.join(fmi::binary_path(&interface.identifier)))
}

/// Writes a file, and the folders that it lies in.
///
/// # Errors
/// When that fails.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), PackError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(FileError::at(folder))?;
    }
    Ok(fs::write(path, bytes).map_err(FileError::at(path))?)
}

/// Copies a folder with all that is in it.
///
/// # Errors
/// When a file cannot be read or written.
pub fn copy_folder(from: &Path, to: &Path) -> Result<(), PackError> {
    fs::create_dir_all(to).map_err(FileError::at(to))?;
    for entry in fs::read_dir(from).map_err(FileError::at(from))? {
        let path = entry.map_err(FileError::at(from))?.path();
        let Some(name) = path.file_name() else { continue };
        let target = to.join(name);
        if path.is_dir() {
            copy_folder(&path, &target)?;
        } else {
            fs::copy(&path, &target).map_err(FileError::at(&path))?;
        }
    }
    Ok(())
}
