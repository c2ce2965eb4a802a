//! Profiles that are files of points.
//!
//! In a vehicle file a profile whose name has an ending, such as `"profiles/worn.prw"`, is a file. Its
//! path counts from the library's folder and does not leave it: the library goes into the resources of
//! an FMU as a whole, and the file with it.

use std::fs::File;
use std::path::{Component, Path};

use super::WheelRailContact;
use files::{Check, Mistake};

/// Puts the folder `library` before the names of profiles that are files.
pub(crate) fn find(
    contact: &mut WheelRailContact,
    library: &Path,
    check: &Check,
) -> Result<(), Mistake> {
    let WheelRailContact { wheel, rail, left_wheel, left_rail, .. } = contact;
    let both = [("wheel", Some(wheel)), ("rail", Some(rail))];
    let left = [("left_wheel", left_wheel.as_mut()), ("left_rail", left_rail.as_mut())];
    for (key, name) in both.into_iter().chain(left) {
        let Some(name) = name else { continue };
        let path = Path::new(name.as_str());
        if path.extension().is_none() {
            continue;
        }
        if !path.components().all(|part| matches!(part, Component::Normal(_))) {
            let wanted = "must be a path inside of the rolling-stock library, such as \
                          profiles/worn.prw: an FMU takes its files from there";
            return Err(check.error(key, name, wanted));
        }
        let file = library.join(path);
        let opened = File::open(&file).and_then(|file| file.metadata());
        let problem = match opened {
            Ok(found) if found.is_file() => None,
            Ok(_) => Some("it is a folder".to_owned()),
            Err(error) => Some(error.to_string()),
        };
        if let Some(problem) = problem {
            let wanted = format!("cannot read the points in {}: {problem}", file.display());
            return Err(check.error(key, name, wanted));
        }
        *name = file.display().to_string();
    }
    Ok(())
}
