//! A draft gear as two curves of force over deflection, and two gears in series.
//!
//! Pushed in, a friction gear follows its loading curve; coming out, its unloading curve; between
//! them friction locks it and only the steep locked stiffness is left. A preload is a first piece
//! with the stiffness of the structure. Forces and deflections are not negative here: a [`Side`] is
//! what the gear does in one direction, draft or buff.
//!
//! Source of the form: look-up table with locked stiffness, `docs/theory/longitudinal.md` 3.

use numerics::{LinearTable, TableError};

/// A force that rises with the deflection by straight pieces, from zero at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Deflection, m, and force, N, both rising.
    points: Vec<(f64, f64)>,
    /// Slope beyond the last point, N/m.
    end_stiffness: f64,
}

impl Curve {
    /// The curve of a file, behind the deflection `preloaded`, m, over which its preload comes up.
    fn new(curve: &stock::ForceCurve, preloaded: f64, end_stiffness: f64) -> Self {
        let columns = curve.deflection_mm.iter().zip(&curve.force_kn);
        let points = columns.map(|(x, f)| (preloaded + x * 1e-3, f * 1e3));
        let unstressed = (preloaded > 0.0).then_some((0.0, 0.0));
        Self { points: unstressed.into_iter().chain(points).collect(), end_stiffness }
    }

    /// Energy under the curve up to a force, J.
    fn energy_to(&self, force: f64) -> f64 {
        let inner = self.points.iter().copied().filter(|point| point.1 < force);
        let points: Vec<_> = inner.chain([(self.deflection(force), force)]).collect();
        points.windows(2).map(|p| (p[0].1 + p[1].1) / 2.0 * (p[1].0 - p[0].0)).sum()
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

/// What a gear, or several in series, do in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// Force while the gear is pushed in.
    pub loading: Curve,
    /// Force while it comes out; nowhere above the loading curve.
    pub unloading: Curve,
    /// Slope between the two curves, greater than that of any piece of them, N/m.
    pub locked_stiffness: f64,
    /// Viscous damping in parallel, N s/m.
    pub damping: f64,
    /// Speed over which one curve blends into the other, m/s; zero: the force is clamped.
    pub transition_speed: f64,
    /// Force of a hydraulic cushion over the square of the speed, N s²/m² over m.
    pub orifice: Option<LinearTable>,
}

/// A draft gear.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftGear {
    /// What it does in draft.
    pub draft: Side,
    /// What it does in buff.
    pub buff: Side,
}

impl DraftGear {
    /// The gear of a draft-gear file.
    ///
    /// # Errors
    /// When a table of it cannot be used.
    pub fn new(gear: &stock::DraftGear) -> Result<Self, TableError> {
        Ok(Self { draft: Side::new(&gear.draft)?, buff: Side::new(&gear.buff)? })
    }
}

impl Side {
    fn new(file: &stock::Characteristic) -> Result<Self, TableError> {
        let structure = file.structure_stiffness_mn_m * 1e6;
        let preloaded = file.loading.force_kn[0] * 1e3 / structure;
        let orifice = file.orifice.as_ref().map(|orifice| {
            let deflections = orifice.deflection_mm.iter().map(|x| x * 1e-3).collect();
            let values = orifice.resistance_kn_s2_m2.iter().map(|c| c * 1e3).collect();
            LinearTable::new(deflections, values)
        });
        Ok(Self {
            loading: Curve::new(&file.loading, preloaded, structure),
            unloading: Curve::new(&file.unloading, preloaded, structure),
            locked_stiffness: file.locked_stiffness_mn_m * 1e6,
            damping: file.damping_kn_s_m * 1e3,
            transition_speed: file.transition_speed_mm_s.unwrap_or_default() * 1e-3,
            orifice: orifice.transpose()?,
        })
    }

    /// Two gears in series, as between two vehicles.
    #[must_use]
    pub fn in_series(&self, other: &Self) -> Self {
        Self {
            loading: self.loading.in_series(&other.loading),
            unloading: self.unloading.in_series(&other.unloading),
            locked_stiffness: in_series(self.locked_stiffness, other.locked_stiffness),
            damping: in_series(self.damping, other.damping),
            transition_speed: self.transition_speed + other.transition_speed,
            orifice: self.orifices_in_series(other),
        }
    }

    /// Greatest deflection of the curves, m.
    fn travel(&self) -> f64 {
        self.loading.points.last().map_or(0.0, |point| point.0)
    }

    /// Two cushions in series share the speed so that their forces are equal:
    /// 1/√C = 1/√C_a + 1/√C_b. Beside a gear without one, a cushion gets the share of the speed that
    /// its travel has in the travel of both.
    fn orifices_in_series(&self, other: &Self) -> Option<LinearTable> {
        let whole = self.travel() + other.travel();
        let (own, others) = (self.travel() / whole, other.travel() / whole);
        let of = |side: &Self, share: f64, x: f64| {
            side.orifice.as_ref().map(|orifice| orifice.value(share * x, &mut 0))
        };
        let at = |x: f64| match (of(self, own, x), of(other, others, x)) {
            (Some(a), Some(b)) => (a * b) / (a.sqrt() + b.sqrt()).powi(2),
            (Some(a), None) => a * own * own,
            (None, b) => b.unwrap_or_default() * others * others,
        };
        let deflections_of = |side: &Self, share: f64| -> Vec<f64> {
            let deflections = side.orifice.as_ref().map_or(&[][..], |orifice| orifice.x());
            deflections.iter().map(|x| x / share).collect()
        };
        let mut deflections = [deflections_of(self, own), deflections_of(other, others)].concat();
        deflections.sort_by(f64::total_cmp);
        deflections.dedup();
        let values = deflections.iter().map(|&x| at(x)).collect();
        LinearTable::new(deflections, values).ok()
    }

    /// Energy that the gear keeps when it is pushed in to a force and let go, J, without the lock.
    fn loss_to(&self, force: f64) -> f64 {
        let back = self.unloading.force(self.loading.deflection(force));
        self.loading.energy_to(force) - self.unloading.energy_to(back)
    }

    /// Share of this gear in the heat of two in series: that of their losses at the smaller of
    /// their forces at full travel.
    pub fn loss_share(&self, other: &Self) -> f64 {
        let full = |side: &Self| side.unloading.points.last().map_or(0.0, |point| point.1);
        let force = full(self).min(full(other));
        let (own, others) = (self.loss_to(force), other.loss_to(force));
        match own + others > 0.0 {
            true => own / (own + others),
            false => 0.5,
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
