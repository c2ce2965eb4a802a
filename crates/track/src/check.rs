//! What the values of a track file must be.

use files::{Check, Mistake};

use crate::chainages::check_order;
use crate::content::{Content, CurvaturePoint, Element, GradientPoint};

/// Greatest curvature, 1/km: that of the smallest radius, 50 m.
const GREATEST_CURVATURE: f64 = 20.0;

impl Content {
    /// Refuses what a designed line cannot be.
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        let wanted = "must be a finite chainage in metres";
        check.ensure(self.start_m.is_finite(), "start_m", self.start_m, wanted)?;
        for (i, element) in self.alignment.iter().enumerate() {
            element.check(&check.element("alignment", i))?;
        }
        for (i, point) in self.curvature.iter().enumerate() {
            point.check(&check.element("curvature", i))?;
        }
        for (i, point) in self.gradient.iter().enumerate() {
            point.check(&check.element("gradient", i))?;
        }
        for (i, limit) in self.speed_limit.iter().enumerate() {
            limit.check(&check.element("speed_limit", i))?;
        }
        check_order(check, "curvature", self.curvature.iter().map(|point| point.chainage_m))?;
        check_order(check, "gradient", self.gradient.iter().map(|point| point.chainage_m))?;
        match (self.alignment.is_empty(), self.curvature.first()) {
            (false, Some(point)) => {
                let wanted = "leave either [[alignment]] or [[curvature]] out";
                Err(check.error("curvature[1].per_km", point.per_km, wanted))
            }
            _ => Ok(()),
        }
    }
}

impl Element {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        let Self { length_m, transition, radius_m, cant_mm } = *self;
        check.positive("length_m", length_m)?;
        if let Some(radius) = radius_m {
            let possible = radius.is_finite() && radius.abs() >= 50.0;
            let wanted = "must be at least 50 m (negative: left-hand curve); \
                          leave it out for straight track";
            check.ensure(possible, "radius_m", radius, wanted)?;
        }
        check_cant(check, cant_mm)?;
        let wanted = "a transition takes curvature and cant from its neighbours; \
                      leave radius_m and cant_mm out";
        match radius_m {
            Some(radius) => check.ensure(!transition, "radius_m", radius, wanted),
            None => check.ensure(!transition || cant_mm == 0.0, "cant_mm", cant_mm, wanted),
        }
    }
}

impl CurvaturePoint {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        let possible = self.per_km.abs() <= GREATEST_CURVATURE;
        let wanted = "must lie between -20 and 20, the curvature of a radius of 50 m";
        check.ensure(possible, "per_km", self.per_km, wanted)?;
        check_cant(check, self.cant_mm)
    }
}

impl GradientPoint {
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        check.between("permille", self.permille, -100.0, 100.0)
    }
}

fn check_cant(check: &Check, cant_mm: f64) -> Result<(), Mistake> {
    let possible = (-300.0..=300.0).contains(&cant_mm);
    check.ensure(possible, "cant_mm", cant_mm, "must lie between -300 and 300 mm")
}
