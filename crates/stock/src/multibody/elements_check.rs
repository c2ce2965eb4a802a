//! What force elements must fulfil.

use super::Wheelset;
use super::check::{Checked, Checker};
use super::elements::{
    CentrePlate, Damper, Friction, Rod, RotationalSpring, SideBearer, Spring, Stop,
    TabulatedSpring, Wedge,
};
use files::Check;

/// Greatest stiffness, N/m and N m/rad.
const STIFFEST: f64 = 1e10;

/// Greatest damping, N s/m and N m s/rad.
const MOST_DAMPING: f64 = 1e8;

/// Calls `check` for each element of a list, in the section of that element.
fn each<T>(list: &[T], name: &str, all: &Check, check: impl Fn(&T, &Check) -> Checked) -> Checked {
    let mut numbered = list.iter().enumerate();
    numbered
        .try_for_each(|(i, element)| check(element, &all.section(&format!("{name}[{}]", i + 1))))
}

/// Values of a list that must lie between zero and `most`.
fn none_beyond(check: &Check, key: &str, values: &[f64], most: f64) -> Checked {
    values.iter().try_for_each(|value| check.between(key, *value, 0.0, most))
}

impl Checker<'_> {
    /// All force elements.
    pub fn elements(&self) -> Checked {
        let (all, m) = (self.check, self.multibody);
        each(&m.spring, "spring", all, |e, check| self.spring(e, check))?;
        each(&m.damper, "damper", all, |e, check| self.damper(e, check))?;
        each(&m.stop, "stop", all, |e, check| self.stop(e, check))?;
        each(&m.tabulated_spring, "tabulated_spring", all, |e, check| self.tabulated(e, check))?;
        each(&m.rotational_spring, "rotational_spring", all, |e, check| self.rotational(e, check))?;
        each(&m.rod, "rod", all, |e, check| self.rod(e, check))?;
        each(&m.friction, "friction", all, |e, check| self.friction(e, check))?;
        each(&m.wedge, "wedge", all, |e, check| self.wedge(e, check))?;
        each(&m.centre_plate, "centre_plate", all, |e, check| self.centre_plate(e, check))?;
        each(&m.side_bearer, "side_bearer", all, |e, check| self.side_bearer(e, check))
    }

    fn spring(&self, spring: &Spring, check: &Check) -> Checked {
        self.ends(check, &spring.between, &spring.points_m)?;
        none_beyond(check, "stiffness_n_m", &spring.stiffness_n_m, STIFFEST)?;
        none_beyond(check, "damping_n_s_m", &spring.damping_n_s_m, MOST_DAMPING)
    }

    fn damper(&self, damper: &Damper, check: &Check) -> Checked {
        self.ends(check, &damper.between, &damper.points_m)?;
        check.positive("damping_n_s_m", damper.damping_n_s_m)?;
        check.positive("series_stiffness_n_m", damper.series_stiffness_n_m.unwrap_or(1.0))?;
        check.positive("blow_off_n", damper.blow_off_n.unwrap_or(1.0))
    }

    fn stop(&self, stop: &Stop, check: &Check) -> Checked {
        self.ends(check, &stop.between, &stop.points_m)?;
        check.between("free_play_mm", stop.free_play_mm, 0.0, 1000.0)?;
        check.positive("stiffness_n_m", stop.stiffness_n_m)
    }

    fn tabulated(&self, spring: &TabulatedSpring, check: &Check) -> Checked {
        self.ends(check, &spring.between, &spring.points_m)?;
        check.between("damping_n_s_m", spring.damping_n_s_m, 0.0, MOST_DAMPING)?;
        let (x, y) = (&spring.displacement_mm, &spring.force_n);
        if x.len() < 2 || x.len() != y.len() {
            let wanted = "needs at least 2 values, and as many as force_n";
            return Err(check.error("displacement_mm", format!("{x:?}"), wanted));
        }
        for i in 1..x.len() {
            let rises = x[i].is_finite() && x[i] > x[i - 1];
            if !rises {
                let wanted = format!("must be greater than the value before it, {}", x[i - 1]);
                return Err(check.error(&format!("displacement_mm[{}]", i + 1), x[i], wanted));
            }
            let stiff = y[i].is_finite() && y[i] >= y[i - 1];
            if !stiff {
                let wanted = format!("must not be less than the value before it, {}", y[i - 1]);
                return Err(check.error(&format!("force_n[{}]", i + 1), y[i], wanted));
            }
        }
        match x[0] {
            first if first == 0.0 && y[0] != 0.0 => {
                let wanted = "a table that begins at displacement zero must begin at force zero";
                Err(check.error("force_n[1]", y[0], wanted))
            }
            first => check.between("displacement_mm[1]", first, -1e4, 0.0),
        }
    }

    fn rotational(&self, spring: &RotationalSpring, check: &Check) -> Checked {
        self.names(check, &spring.between)?;
        none_beyond(check, "stiffness_n_m_rad", &spring.stiffness_n_m_rad, STIFFEST)?;
        none_beyond(check, "damping_n_m_s_rad", &spring.damping_n_m_s_rad, MOST_DAMPING)
    }

    fn rod(&self, rod: &Rod, check: &Check) -> Checked {
        self.names(check, &rod.between)?;
        for (name, end) in rod.between.iter().zip(rod.ends_m) {
            self.in_an_axle(check, "ends_m", name, &[end])?;
        }
        check.positive("stiffness_n_m", rod.stiffness_n_m)?;
        check.between("damping_n_s_m", rod.damping_n_s_m, 0.0, MOST_DAMPING)?;
        let [a, b] = rod.ends_m;
        let length = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        match length >= 0.05 {
            true => Ok(()),
            false => {
                let ends = format!("{:?}", rod.ends_m);
                Err(check.error("ends_m", ends, "must lie at least 0.05 m from each other"))
            }
        }
    }

    fn friction(&self, friction: &Friction, check: &Check) -> Checked {
        self.ends(check, &friction.between, &friction.points_m)?;
        check.positive("force_n", friction.force_n)?;
        check.positive("stick_stiffness_n_m", friction.stick_stiffness_n_m)
    }

    fn wedge(&self, wedge: &Wedge, check: &Check) -> Checked {
        self.ends(check, &wedge.between, &wedge.points_m)?;
        check.between("angle_deg", wedge.angle_deg, 20.0, 70.0)?;
        // Else the wedge locks itself: tan(angle) = friction.
        let locking = 0.9 * libm::tan(wedge.angle_deg.to_radians());
        check.between("friction", wedge.friction, 0.01, locking.min(1.0))?;
        check.positive("spring_force_n", wedge.spring_force_n)?;
        check.positive("spring_stiffness_n_m", wedge.spring_stiffness_n_m)?;
        check.positive("stick_stiffness_n_m", wedge.stick_stiffness_n_m)
    }

    fn centre_plate(&self, plate: &CentrePlate, check: &Check) -> Checked {
        self.names(check, &plate.between)?;
        check.between("radius_m", plate.radius_m, 0.05, 2.0)?;
        for value in plate.stiffness_n_m {
            check.positive("stiffness_n_m", value)?;
        }
        none_beyond(check, "damping_n_s_m", &plate.damping_n_s_m, MOST_DAMPING)?;
        check.between("friction", plate.friction, 0.0, 1.0)?;
        check.positive("stick_stiffness_n_m_rad", plate.stick_stiffness_n_m_rad)
    }

    fn side_bearer(&self, bearer: &SideBearer, check: &Check) -> Checked {
        self.ends(check, &bearer.between, &bearer.points_m)?;
        check.positive("preload_n", bearer.preload_n)?;
        check.positive("stiffness_n_m", bearer.stiffness_n_m)?;
        check.between("solid_gap_mm", bearer.solid_gap_mm, 0.0, 100.0)?;
        check.positive("solid_stiffness_n_m", bearer.solid_stiffness_n_m)?;
        check.between("friction", bearer.friction, 0.0, 1.0)?;
        check.positive("stick_stiffness_n_m", bearer.stick_stiffness_n_m)
    }

    /// The two bodies of an element exist and differ.
    fn names(&self, check: &Check, between: &[String; 2]) -> Checked {
        if let Some(name) = between.iter().find(|name| !self.names.contains(&name.as_str())) {
            let wanted = format!("must name two of {:?}", self.names);
            return Err(check.error("between", name, wanted));
        }
        match between[0] == between[1] {
            true => Err(check.error("between", &between[0], "must name two different bodies")),
            false => Ok(()),
        }
    }

    /// The same, and there are points, finite ones, and in the axle on a wheelset.
    fn ends(&self, check: &Check, between: &[String; 2], points: &[[f64; 3]]) -> Checked {
        self.names(check, between)?;
        if points.is_empty() {
            return Err(check.refuse("points_m", "at least one point is needed"));
        }
        for value in points.iter().flatten() {
            check.between("points_m", *value, -50.0, 50.0)?;
        }
        between.iter().try_for_each(|name| self.in_an_axle(check, "points_m", name, points))
    }

    /// A wheelset turns, so that elements can act in its axle only.
    fn in_an_axle(&self, check: &Check, key: &str, name: &str, points: &[[f64; 3]]) -> Checked {
        let Some(wheelset) = self.multibody.wheelset.iter().find(|w| w.name == name) else {
            return Ok(());
        };
        match points.iter().find(|point| !in_the_axle(wheelset, point)) {
            None => Ok(()),
            Some(point) => {
                let wanted = "an element on a wheelset must act in the axle: x as the wheelset's \
                              x_m, height as its wheel_radius_m";
                Err(check.error(key, format!("{point:?}"), wanted))
            }
        }
    }
}

fn in_the_axle(wheelset: &Wheelset, [x, _, height]: &[f64; 3]) -> bool {
    (x - wheelset.x_m).abs() <= 1e-9 && (height - wheelset.wheel_radius_m).abs() <= 1e-9
}
