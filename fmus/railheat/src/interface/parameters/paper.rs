//! The constants of `model = "paper"`.

use fmu::ModelError;

use super::common::{Common, whole};
use crate::contact::Friction;
use crate::paper::{Grid, Parameters, RunningSurface};
use crate::weather::Weather;

/// Most cells of the whole rail: 0.8 GB.
const MOST_CELLS: usize = 100_000_000;

/// The constants, with the depths in m at which the highest rise is looked for.
pub(crate) fn constants(
    common: &Common,
    weather: &Weather,
    depths: &[f64],
) -> Result<Parameters, ModelError> {
    let surface = RunningSurface {
        convection: common.convection,
        emissivity: common.emissivity,
        absorptivity: common.absorptivity,
        filter: common.filter,
    };
    Ok(Parameters {
        grid: grid(common)?,
        depths: depths.to_vec(),
        width: common.column.width,
        conduction_interval: common.column.interval,
        material: common.steel.material(),
        friction: Friction { coefficient: common.friction, partition: common.partition },
        initial_temperature: match common.equilibrium {
            true => surface.equilibrium(weather),
            false => common.temperature,
        },
        surface,
    })
}

fn grid(common: &Common) -> Result<Grid, ModelError> {
    let line = common.line()?;
    let (height, cell_size) = (common.column.height, common.column.cell_size);
    let cells = whole("rail.height", height, "cell.size", cell_size)?;
    let elements = line.elements;
    if elements.saturating_mul(cells) > MOST_CELLS {
        return Err(ModelError::new(format!(
            "the grid has {elements} elements of {cells} cells, more than {MOST_CELLS} in all; \
             choose a shorter track.length, longer elements or larger cells"
        )));
    }
    Ok(Grid { line, cell_size, cells })
}
