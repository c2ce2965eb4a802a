//! `hotfoot profile`: what is understood of a file of points.
//!
//! | file | part |
//! |---|---|
//! | `arguments.rs` | its options |
//! | `dimensions.rs` | flange, running circle and gauge point of an outline |
//! | `plot.rs` | what `--plot` draws |

mod arguments;
mod dimensions;
mod plot;

use contact::{ProfileFile, ProfileKind};

pub use arguments::ProfileArguments;

use super::outline::MM;
use crate::error::ToolError;

/// What was understood of the file, a line each; draws and writes what the options name.
///
/// # Errors
/// When the file is no profile, or a file cannot be written.
pub fn profile(arguments: &ProfileArguments) -> Result<String, ToolError> {
    let kind = arguments.kind.map(Into::into);
    let file = ProfileFile::read(&arguments.file, kind, &arguments.reading())?;
    let mut text = String::new();
    for (name, value) in understood(arguments, &file) {
        text += &format!("{name:<18} {value}\n");
    }
    if let Some(plot) = &arguments.plot {
        text += &format!("{:<18} {}", "drawn in", plot::page(arguments, &file).write(plot)?);
    }
    if let Some(new) = &arguments.write {
        let name = new.display().to_string();
        std::fs::write(new, file.clean_text())
            .map_err(|reason| ToolError::Write { file: name.clone(), reason })?;
        text += &format!("{:<18} {name}\n", "written to");
    }
    Ok(text)
}

/// Names and values.
fn understood(arguments: &ProfileArguments, file: &ProfileFile) -> Vec<(&'static str, String)> {
    let (begin, end) = file.profile.range();
    let mut understood = vec![
        ("file", arguments.file.display().to_string()),
        ("profile", file.kind.to_string()),
        ("format", file.format.to_string()),
        ("unit", unit(file.per_metre)),
        ("points", file.points.len().to_string()),
        ("curve", format!("from {} to {}", mm(begin), mm(end))),
    ];
    match file.kind {
        ProfileKind::Wheel => understood.extend(wheel(arguments, file)),
        ProfileKind::Rail => understood.extend(rail(arguments, file)),
    }
    let smooth = match file.wavelength > 0.0 {
        true => format!("to a wavelength of {} mm", file.wavelength / MM),
        false => "no".into(),
    };
    let roughness = &file.roughness;
    let removed = format!(
        "{:.2} µm rms, at most {:.2} µm at {}",
        1e6 * roughness.rms,
        1e6 * roughness.largest,
        mm(roughness.at)
    );
    understood.extend([("smoothed", smooth), ("removed", removed)]);
    understood.extend(file.notes.iter().map(|note| ("note", note.clone())));
    understood
}

fn wheel(arguments: &ProfileArguments, file: &ProfileFile) -> Vec<(&'static str, String)> {
    let circle = arguments.outline.running_circle_mm * MM;
    let flange = dimensions::Flange::new(file.profile.outline(), circle);
    let known = |length: Option<f64>| length.map_or("not in the points".into(), mm);
    vec![
        (
            "flange back",
            format!(
                "{} from the running circle, in the points {}",
                mm(circle),
                mm(-file.profile.range().0)
            ),
        ),
        ("running circle", format!("at 0, where the slope is {:.4}", file.profile.at(0.0).slope)),
        ("flange height", format!("{} (Sh)", mm(flange.height))),
        (
            "flange thickness",
            format!("{} (Sd, 10 mm beyond the running circle)", known(flange.thickness)),
        ),
        ("flange gradient", format!("{} (qR)", known(flange.gradient))),
    ]
}

fn rail(arguments: &ProfileArguments, file: &ProfileFile) -> Vec<(&'static str, String)> {
    let depth = arguments.outline.gauge_depth_mm * MM;
    let [top, _] = file.profile.top();
    let reached = file.profile.gauge_depth();
    let gauge = match dimensions::gauge_point(file.profile.outline(), file.profile.top(), depth) {
        Some(lateral) => format!("at {}, {} below the top", mm(lateral), mm(depth)),
        None => format!("not in the points: they end {} below the top", mm(reached)),
    };
    vec![
        ("top", format!("at {}", mm(top))),
        ("gauge point", gauge),
        ("gauge side", format!("down to {} below the top", mm(reached))),
    ]
}

/// A length in m, in mm.
fn mm(length: f64) -> String {
    // Adding zero takes the sign off a negative zero.
    format!("{:.3} mm", (length / MM * 1e3).round() / 1e3 + 0.0)
}

/// Name of the unit of which a metre has `per_metre`.
fn unit(per_metre: f64) -> String {
    match arguments::Unit::ALL.iter().find(|unit| unit.per_metre() == per_metre) {
        Some(unit) => unit.name().into(),
        None => format!("{per_metre} to a metre"),
    }
}
