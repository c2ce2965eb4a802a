//! The brake pipe of a train: which group of locomotives commands which vehicle.

use crate::brake::pipe::Source;
use crate::command::Command;
use crate::history::History;
use crate::train::dynamics::TrainDynamics;

impl TrainDynamics {
    /// Finds the group of locomotives that commands each vehicle's air brake.
    ///
    /// It is the nearest one, or the head of the train where no vehicle has traction.
    pub(crate) fn find_sources(&mut self) {
        let mut middle = 0.0;
        let middles: Vec<f64> = self
            .vehicles
            .iter()
            .map(|vehicle| {
                middle += vehicle.length;
                middle - vehicle.length / 2.0
            })
            .collect();
        let mut groups: Vec<(usize, f64)> = self
            .vehicles
            .iter()
            .zip(&self.members)
            .zip(&middles)
            .filter(|((vehicle, _), _)| vehicle.has_traction())
            .map(|((_, member), middle)| (member.group, *middle))
            .collect();
        if groups.is_empty() {
            groups.push((0, middles.first().copied().unwrap_or_default()));
        }
        for (member, middle) in self.members.iter_mut().zip(middles) {
            member.source = Source::nearest(&groups, middle);
        }
    }

    /// Histories of the groups' train brakes; empty when no vehicle has an air brake.
    ///
    /// They begin with commands that have been the same for ever, and reach back far enough for the
    /// farthest vehicle.
    pub(crate) fn pipe_histories(&self, commands: &[Command]) -> Vec<History<f64>> {
        let delays = self.vehicles.iter().zip(&self.members).filter_map(|(vehicle, member)| {
            vehicle.brake.air().map(|air| member.source.distance / air.slowest_wave())
        });
        match delays.reduce(f64::max) {
            None => vec![],
            Some(longest) => {
                let of = |group: usize| commands[group.min(commands.len() - 1)].train_brake;
                (0..self.groups()).map(|group| History::new(longest, of(group))).collect()
            }
        }
    }
}
