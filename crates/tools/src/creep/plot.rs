//! The plot of `hotfoot creep`: forces, friction power and flash temperature over the creepage.

use clap::ValueEnum;
use plotters::style::RGBColor;

use super::arguments::CreepArguments;
use super::row::Row;
use crate::error::ToolError;
use crate::plot::{BLACK, BLUE, Curve, Page, Panel, VERMILION};

/// Names of the creepages.
const CREEPAGES: [&str; 3] = ["longitudinal creepage", "lateral creepage", "spin creepage in 1/m"];

/// A value of a row.
type Quantity = fn(&Row) -> f64;

/// The page for these rows.
///
/// # Errors
/// When no creepage changes from row to row.
pub(super) fn page(arguments: &CreepArguments, rows: &[Row]) -> Result<Page, ToolError> {
    let changes = |&i: &usize| rows.iter().any(|row| row.creepages[i] != rows[0].creepages[i]);
    let Some(axis) = (0..CREEPAGES.len()).find(changes) else {
        let wanted = "--plot needs a list of creepages that differ, such as --longitudinal 0,0.001";
        return Err(ToolError::Options(wanted.to_owned()));
    };
    let panel = |vertical, curves: &[(RGBColor, Quantity)]| Panel {
        horizontal: CREEPAGES[axis].to_owned(),
        vertical,
        curves: curves
            .iter()
            .map(|(colour, quantity)| curve(rows, axis, *colour, *quantity))
            .collect(),
    };
    let law = arguments.law.to_possible_value();
    let law = law.as_ref().map_or("", |value| value.get_name());
    Ok(Page {
        title: format!(
            "{law}, {} kN, friction {}, {} m/s",
            arguments.load / 1e3,
            arguments.friction,
            arguments.speed
        ),
        legend: vec![(BLUE, "longitudinal force"), (VERMILION, "lateral force")],
        panels: vec![
            panel(
                "creep force on the wheel in N",
                &[
                    (BLUE, |row| row.forces.force.longitudinal),
                    (VERMILION, |row| row.forces.force.lateral),
                ],
            ),
            panel("friction power in W", &[(BLACK, |row| row.forces.friction_power)]),
            panel("spin moment on the wheel in N m", &[(BLACK, |row| row.forces.spin_moment)]),
            panel("flash temperature, rise in K", &[(BLACK, |row| row.flash)]),
        ],
    })
}

/// A quantity over the creepage `axis`, in the order of the rows.
fn curve(rows: &[Row], axis: usize, colour: RGBColor, quantity: Quantity) -> Curve {
    let points = rows.iter().map(|row| (row.creepages[axis], quantity(row)));
    Curve { colour, joined: true, points: points.collect() }
}
