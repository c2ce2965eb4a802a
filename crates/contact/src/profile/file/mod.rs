//! Files of points: what people measure, and what other programs write.
//!
//! | file | part |
//! |---|---|
//! | `reading.rs` | what may be said beside the file |
//! | `text.rs` | bytes to text: encodings, the size of a file |
//! | `format.rs` | text to points, by the format |
//! | `parsed.rs` | what stands in a file |
//! | `columns.rs` | numbers in lines |
//! | `miniprof.rs`, `simpack.rs` | the formats that have a header |
//! | `size.rs` | whether the lengths can be those of a wheel or rail, and in which unit |
//! | `orientation.rs` | which way round the points are, and where their origin is |
//! | `order.rs` | the order of the points |
//! | `smoothing.rs` | an outline without roughness |
//! | `outline.rs` | whether the outline is that of a wheel or a rail |

mod columns;
mod format;
mod miniprof;
mod order;
mod orientation;
mod outline;
mod parsed;
mod reading;
mod simpack;
mod size;
mod smoothing;
mod text;

use std::path::Path;

use super::kind::ProfileKind;
use super::points::PointProfile;
use crate::error::ContactError;

pub use parsed::ProfileFormat;
pub use reading::Reading;
pub use smoothing::Roughness;

/// A file of points and what was understood of it.
#[derive(Clone, Debug)]
pub struct ProfileFile {
    /// Whose profile it is.
    pub kind: ProfileKind,
    /// How the file is written.
    pub format: ProfileFormat,
    /// Lengths in the file for a metre.
    pub per_metre: f64,
    /// Cut-off wavelength to which the outline was made smooth, m; 0 if it was not.
    pub wavelength: f64,
    /// What was done to the points, a sentence each.
    pub notes: Vec<String>,
    /// The points before smoothing, m: lateral coordinate towards the field side and height downwards.
    pub points: Vec<[f64; 2]>,
    /// What smoothing took away.
    pub roughness: Roughness,
    /// The profile.
    pub profile: PointProfile,
}

impl ProfileFile {
    /// Reads the file at `path`; without a `kind`, the file or its size tells it.
    ///
    /// # Errors
    /// When the file cannot be read or is no profile of this kind: with line, value and likely unit.
    pub fn read(
        path: &Path,
        kind: Option<ProfileKind>,
        reading: &Reading,
    ) -> Result<Self, ContactError> {
        let name = path.display().to_string();
        let text = text::read(path).map_err(|reason| parsed::wrong(&name, reason))?;
        Self::of_text(&text, &name, kind, reading)
    }

    /// The profile that `text` gives; `name` is that of its file.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of_text(
        text: &str,
        name: &str,
        kind: Option<ProfileKind>,
        reading: &Reading,
    ) -> Result<Self, ContactError> {
        let mut parsed = format::parse(text, name, reading.per_metre)?;
        size::check_points(&parsed, name)?;
        if let (Some(wanted), Some(found)) = (kind, parsed.kind)
            && wanted != found
        {
            let reason =
                format!("the file says that it is the profile of a {found}, not of a {wanted}");
            return Err(parsed::wrong(name, reason));
        }
        let kind = kind.or(parsed.kind).or_else(|| format::kind(name));
        let kind = kind.unwrap_or_else(|| size::kind(&parsed.points));
        size::check_unit(&parsed, kind, name)?;
        orientation::orient(&mut parsed, kind, reading);
        order::along_the_outline(&mut parsed, kind);
        order::refuse_gaps(&parsed.points, name)?;
        let points: Vec<[f64; 2]> = parsed.points.iter().map(|point| point.at).collect();
        let wavelength = if parsed.clean { 0.0 } else { reading.wavelength };
        let (smooth, roughness) = smoothing::smoothed(&points, wavelength);
        let profile = outline::checked(name, kind, smooth, reading, parsed.from_flange_back)?;
        Ok(Self {
            kind,
            format: parsed.format,
            per_metre: parsed.per_metre,
            wavelength,
            notes: parsed.notes,
            points,
            roughness,
            profile,
        })
    }

    /// The text of a clean file: the outline in mm, to a nanometre, which no reader makes smooth again.
    pub fn clean_text(&self) -> String {
        let mut text = format!(
            "{} of a {}, smooth to a wavelength of {} mm: lateral coordinate towards the field side, \
             height downwards, mm\n",
            parsed::CLEAN,
            self.kind,
            1e3 * self.wavelength
        );
        for [y, z] in self.profile.outline() {
            text += &format!("{:.6} {:.6}\n", 1e3 * y, 1e3 * z);
        }
        text
    }
}

/// The profile of a `name` that is a file of points; nothing if it is none.
pub(super) fn named(
    name: &str,
    kind: ProfileKind,
    reading: &Reading,
) -> Option<Result<PointProfile, ContactError>> {
    let read = || ProfileFile::read(Path::new(name), Some(kind), reading);
    format::is_file(name).then(|| read().map(|file| file.profile))
}

#[cfg(test)]
mod tests;
