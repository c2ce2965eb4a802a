//! Spring with a table of force over displacement, such as a progressive bump stop:
//! F = -f(u) - c v with f linear between its points (eq. 27).

use nalgebra::Vector3;

use super::energy::ElementEnergy;
use super::pair::{Between, Point};

/// A spring that acts in one direction.
#[derive(Clone, Debug)]
pub struct TabulatedSpring {
    /// Where it joins two bodies.
    pub at: Point,
    /// Direction: 0 is x, 1 is y, 2 is z.
    pub axis: usize,
    /// Points u, f, rising, m and N.
    points: Vec<[f64; 2]>,
    /// ∫ f du from the first point to each one, J.
    energies: Vec<f64>,
    /// Energy at displacement zero, J.
    zero: f64,
    /// Damping c, N s/m.
    pub damping: f64,
}

impl TabulatedSpring {
    /// A spring through the points (u, f), at least two, u rising. If they begin at zero, they
    /// are mirrored.
    pub fn new(at: Point, axis: usize, mut points: Vec<[f64; 2]>, damping: f64) -> Self {
        if points[0][0] == 0.0 {
            let mirrored = points[1..].iter().rev().map(|[u, f]| [-u, -f]);
            points = mirrored.chain(points.iter().copied()).collect();
        }
        let mut energies = vec![0.0];
        for pair in points.windows(2) {
            let [[u, f], [v, g]] = [pair[0], pair[1]];
            energies.push(energies[energies.len() - 1] + 0.5 * (f + g) * (v - u));
        }
        let mut spring = Self { at, axis, points, energies, zero: 0.0, damping };
        spring.zero = spring.force_and_energy(0.0).1;
        spring
    }

    /// Force f at the displacement `u`, and energy.
    fn force_and_energy(&self, u: f64) -> (f64, f64) {
        let (i, slope) = self.piece(u);
        let [from, force] = self.points[i];
        let beyond = u - from;
        let energy = self.energies[i] + beyond * (force + 0.5 * slope * beyond);
        (force + slope * beyond, energy - self.zero)
    }

    /// The piece in which `u` lies, the outermost beyond the ends, and its slope.
    fn piece(&self, u: f64) -> (usize, f64) {
        let inner = &self.points[1..self.points.len() - 1];
        let i = inner.iter().take_while(|point| point[0] <= u).count();
        let ([u, f], [v, g]) = (self.points[i], self.points[i + 1]);
        (i, (g - f) / (v - u))
    }

    /// Force at rest, N.
    pub fn static_force(&self) -> f64 {
        -self.force_and_energy(0.0).0
    }

    /// Stiffness at rest, N/m.
    pub fn static_stiffness(&self) -> f64 {
        self.piece(0.0).1
    }

    /// Adds the forces on both bodies.
    #[inline]
    pub fn apply(&self, between: &mut Between, energy: &mut ElementEnergy) {
        let stretch = between.stretch(&self.at.arm);
        let (elastic, stored) = self.force_and_energy(stretch.length[self.axis]);
        let viscous = self.damping * stretch.rate[self.axis];
        let mut force = Vector3::zeros();
        force[self.axis] = -elastic - viscous;
        between.push(&stretch, &force);
        energy.stored += stored;
        energy.dissipated += viscous * stretch.rate[self.axis];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Manchester bump stop (mm, N): 0-25: 0, 30: 600, 35: 1760; beyond with its last slope.
    #[test]
    fn analytic_a_table_is_mirrored_and_goes_on() {
        let points = vec![[0.0, 0.0], [0.025, 0.0], [0.030, 600.0], [0.035, 1760.0]];
        let spring = TabulatedSpring::new(Point::TEST, 1, points, 0.0);
        let force = |u: f64| spring.force_and_energy(u).0;
        assert_eq!(force(0.020), 0.0);
        assert!((force(0.0275) - 300.0).abs() < 1e-9);
        assert!((force(-0.0275) + 300.0).abs() < 1e-9);
        assert!((force(0.040) - 2920.0).abs() < 1e-9);
        // Half of 600 N times 5 mm.
        assert!((spring.force_and_energy(-0.030).1 - 1.5).abs() < 1e-12);
        assert_eq!(spring.static_force(), 0.0);
        assert_eq!(spring.static_stiffness(), 0.0);
    }
}
