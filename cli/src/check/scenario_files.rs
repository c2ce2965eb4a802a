//! The files of a scenario, checked before any FMU is packed with them.

use files::Mistake;
use hotfoot::scenario::{Scenario, Value, quoted};
use tools::train_files::{Start, TrainFiles, check_rail, check_weather};

/// The parameter of a rail that names the file of the weather.
const WEATHER: &str = "weather_file";
/// The parameter of a rail that names its section.
const SECTION: &str = "section.rail";

/// Reads and checks every file that a scenario names, as the models do.
///
/// Gives what is possible and yet hardly meant, in sentences.
///
/// # Errors
/// When one cannot be read or has a value that is not possible.
pub fn check(scenario: &Scenario) -> Result<Vec<String>, Mistake> {
    // Models that replace Hotfoot's own have files of their own kinds.
    let own_train = scenario.fmus.longitudinal.is_none();
    let mut notes = match own_train {
        true => of_train(scenario).check()?,
        false => vec![],
    };
    if own_train && scenario.fmus.vehicle.is_none() && !scenario.train_alone {
        check_start(scenario)?;
    }
    if let Some(heat) = &scenario.heat {
        let check = scenario.check().section("heat.parameters");
        if let Some(Value::File(weather)) = heat.parameters.get(WEATHER) {
            check_weather(weather)?;
        }
        match heat.parameters.get(SECTION) {
            Some(Value::File(file)) => {
                check_rail(&file.display().to_string(), &check, &quoted(SECTION))?;
            }
            Some(Value::Text(name)) => check_rail(name, &check, &quoted(SECTION))?,
            _ => {}
        }
        notes.extend(shallow(&heat.depths_mm));
    }
    Ok(notes)
}

/// Refuses a train that would tip over where it starts.
fn check_start(scenario: &Scenario) -> Result<(), Mistake> {
    let train = &scenario.train;
    let groups = train.vehicles.iter();
    let files: Vec<_> =
        groups.map(|group| (scenario.vehicle_file(&group.kind), group.count)).collect();
    let vehicles: Vec<_> = files.iter().map(|(file, count)| (file.as_path(), *count)).collect();
    let start = Start { position: train.leading_vehicle_position_m, speed: train.speed_m_per_s };
    start.check(&vehicles, &scenario.stock, &scenario.track.file, &scenario.check())
}

fn of_train(scenario: &Scenario) -> TrainFiles<'_> {
    let groups = scenario.train.vehicles.iter();
    TrainFiles {
        stock: &scenario.stock,
        vehicles: groups.map(|group| (scenario.vehicle_file(&group.kind), group.group)).collect(),
        track: &scenario.track.file,
        driver: &scenario.driver.file,
        with: &scenario.driver.with,
        duration: scenario.duration_s,
    }
}

/// Depth, mm, above which all lies in the topmost cell of a rail.
const SURFACE: f64 = 1.0;

/// A note on depths that can hardly be told from the surface.
fn shallow(depths: &[f64]) -> Option<String> {
    let shallow: Vec<String> = depths
        .iter()
        .filter(|depth| (0.0..SURFACE).contains(*depth) && **depth > 0.0)
        .map(f64::to_string)
        .collect();
    (!shallow.is_empty()).then(|| {
        format!(
            "heat.depths_mm = {}: less than {SURFACE} mm below the crown is its topmost cell; depths are in mm",
            shallow.join(", ")
        )
    })
}
