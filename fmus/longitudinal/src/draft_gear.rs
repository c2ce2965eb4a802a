//! A draft gear as two curves of force over deflection, and two gears in series.
//!
//! Pushed in, a friction gear follows its loading curve; coming out, its unloading curve; between
//! them friction locks it and only the steep locked stiffness is left. Forces and deflections are
//! counted positive in draft; buff mirrors both.
//!
//! Source of the form: look-up table with locked stiffness, `docs/theory/longitudinal.md` 3.

/// A force that rises with the deflection by straight pieces, from zero at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Deflection, m, and force, N, both rising.
    points: Vec<(f64, f64)>,
    /// Slope beyond the last point, N/m.
    end_stiffness: f64,
}

impl Curve {
    fn new(curve: &stock::ForceCurve, end_stiffness: f64) -> Self {
        let columns = curve.deflection_mm.iter().zip(&curve.force_kn);
        Self { points: columns.map(|(x, f)| (x * 1e-3, f * 1e3)).collect(), end_stiffness }
    }

    /// Deflection at a force that is not negative, m.
    pub fn deflection(&self, force: f64) -> f64 {
        let after = self.points.partition_point(|point| point.1 <= force);
        match (self.points[after.saturating_sub(1)], self.points.get(after)) {
            ((x, f), None) => x + (force - f) / self.end_stiffness,
            ((x0, f0), Some((x1, f1))) => x0 + (force - f0) * (x1 - x0) / (f1 - f0),
        }
    }

    /// Force at a deflection that is not negative, N.
    pub fn force(&self, deflection: f64) -> f64 {
        let after = self.points.partition_point(|point| point.0 <= deflection);
        match (self.points[after.saturating_sub(1)], self.points.get(after)) {
            ((x, f), None) => f + (deflection - x) * self.end_stiffness,
            ((x0, f0), Some((x1, f1))) => f0 + (deflection - x0) * (f1 - f0) / (x1 - x0),
        }
    }

    /// The points that bound the pieces: deflection, m, and force, N.
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// Slope beyond the last point, N/m.
    pub fn end_stiffness(&self) -> f64 {
        self.end_stiffness
    }

    /// Two curves in series: at the same force the deflections add (theory, eq. 5).
    fn in_series(&self, other: &Self) -> Self {
        let both = self.points.iter().chain(&other.points);
        let mut forces: Vec<f64> = both.map(|point| point.1).collect();
        forces.sort_by(f64::total_cmp);
        forces.dedup();
        let deflection = |force| self.deflection(force) + other.deflection(force);
        Self {
            points: forces.iter().map(|&f| (deflection(f), f)).collect(),
            end_stiffness: in_series(self.end_stiffness, other.end_stiffness),
        }
    }
}

/// Stiffness of two springs, or damping of two dampers, in series (theory, eq. 6).
fn in_series(a: f64, b: f64) -> f64 {
    match a * b {
        0.0 => 0.0,
        product => product / (a + b),
    }
}

/// A draft gear, or several in series.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftGear {
    /// Force while the gear is pushed in.
    pub loading: Curve,
    /// Force while it comes out; nowhere above the loading curve.
    pub unloading: Curve,
    /// Slope between the two curves, greater than that of any piece of them, N/m.
    pub locked_stiffness: f64,
    /// Viscous damping in parallel, N s/m.
    pub damping: f64,
}

impl DraftGear {
    /// The gear of a draft-gear file.
    pub fn new(gear: &stock::DraftGear) -> Self {
        let (loading, unloading) = gear.curves();
        let structure = gear.structure_stiffness_mn_m * 1e6;
        Self {
            loading: Curve::new(loading, structure),
            unloading: Curve::new(unloading, structure),
            locked_stiffness: gear.locked_stiffness_mn_m * 1e6,
            damping: gear.damping_kn_s_m * 1e3,
        }
    }

    /// Two gears in series, as between two vehicles.
    #[must_use]
    pub fn in_series(&self, other: &Self) -> Self {
        Self {
            loading: self.loading.in_series(&other.loading),
            unloading: self.unloading.in_series(&other.unloading),
            locked_stiffness: in_series(self.locked_stiffness, other.locked_stiffness),
            damping: in_series(self.damping, other.damping),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f64, f64)], end_stiffness: f64) -> Curve {
        Curve { points: points.to_vec(), end_stiffness }
    }

    /// Two equal curves in series are twice as long; a curve and its inverse cancel.
    #[test]
    fn analytic_equal_curves_in_series_double_the_deflection() {
        let one = curve(&[(0.0, 0.0), (0.01, 1e5), (0.03, 5e5)], 2e8);
        let two = one.in_series(&one);
        for force in [0.0, 5e4, 3e5, 9e5] {
            assert!((two.deflection(force) - 2.0 * one.deflection(force)).abs() < 1e-15);
            assert!((two.force(two.deflection(force)) - force).abs() < 1e-8 * 1e5);
        }
    }

    /// Linear springs of 10 and 30 MN/m in series have 7.5 MN/m.
    #[test]
    fn analytic_springs_in_series() {
        let soft = curve(&[(0.0, 0.0), (0.1, 1e6)], 10e6);
        let hard = curve(&[(0.0, 0.0), (0.1, 3e6)], 30e6);
        let both = soft.in_series(&hard);
        for deflection in [0.02, 0.1, 0.5] {
            assert!((both.force(deflection) / (7.5e6 * deflection) - 1.0).abs() < 1e-14);
        }
    }
}
