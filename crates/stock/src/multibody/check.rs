//! What a `[multibody]` section must fulfil.

use super::{Body, Multibody, Wheelset};
use files::{Check, Mistake};

pub(super) type Checked = Result<(), Mistake>;

impl Multibody {
    /// Checks the section.
    pub(crate) fn check(&self, check: &Check) -> Checked {
        let checker = Checker::new(self, check)?;
        checker.masses()?;
        checker.contact()?;
        checker.elements()
    }

    /// Checks the sum of the masses, kg, against that of a vehicle; `check` is that of its file.
    pub(crate) fn check_mass(&self, check: &Check, mass_kg: f64) -> Checked {
        let sum = self.mass();
        let listed = |mut masses: Vec<f64>| {
            masses.dedup();
            masses.iter().map(|mass| format!("{mass} kg")).collect::<Vec<_>>().join(", ")
        };
        let bodies = listed(self.body.iter().map(|body| body.mass_kg).collect());
        let wheelsets = listed(self.wheelset.iter().map(|wheelset| wheelset.mass_kg).collect());
        let wanted = format!(
            "must be {sum} kg, the sum of the {} bodies ({bodies}) and {} wheelsets ({wheelsets}) of [multibody]",
            self.body.len(),
            self.wheelset.len()
        );
        let fits = (sum - mass_kg).abs() <= 1e-6 * mass_kg;
        check.ensure(fits, "mass_kg", mass_kg, &wanted)
    }
}

/// Checks a section whose bodies and wheelsets have names of their own.
pub(super) struct Checker<'a> {
    pub(super) multibody: &'a Multibody,
    pub(super) check: &'a Check<'a>,
    /// Names of the bodies, then of the wheelsets.
    pub(super) names: Vec<&'a str>,
}

impl<'a> Checker<'a> {
    /// Collects the names of bodies and wheelsets.
    pub fn new(multibody: &'a Multibody, check: &'a Check<'a>) -> Result<Self, Mistake> {
        if multibody.body.is_empty() {
            return Err(check.refuse("body", "at least one body is needed, the car body first"));
        }
        if multibody.wheelset.is_empty() {
            return Err(check.refuse("wheelset", "at least one wheelset is needed"));
        }
        let bodies = multibody.body.iter().map(|body| body.name.as_str());
        let wheelsets = multibody.wheelset.iter().map(|w| w.name.as_str());
        let names: Vec<&str> = bodies.chain(wheelsets).collect();
        for (i, name) in names.iter().enumerate() {
            if names[..i].contains(name) {
                let wanted = "every body and wheelset needs a name of its own";
                return Err(check.error("body[..].name", name, wanted));
            }
        }
        Ok(Self { multibody, check, names })
    }

    /// Masses, inertias and positions.
    pub fn masses(&self) -> Checked {
        let height = self.multibody.coupler.height_m;
        self.check.between("coupler.height_m", height, 0.0, 3.0)?;
        for (i, body) in self.multibody.body.iter().enumerate() {
            self.body(body, &self.check.section(&format!("body[{}]", i + 1)))?;
        }
        for (i, wheelset) in self.multibody.wheelset.iter().enumerate() {
            let check = self.check.section(&format!("wheelset[{}]", i + 1));
            self.wheelset(wheelset, &check)?;
            if let Some(before) = i.checked_sub(1).map(|before| &self.multibody.wheelset[before])
                && wheelset.x_m >= before.x_m
            {
                let wanted = format!(
                    "must be less than {}, that of the wheelset before it: wheelsets stand \
                     from front to rear",
                    before.x_m
                );
                return Err(check.error("x_m", wheelset.x_m, wanted));
            }
        }
        Ok(())
    }

    fn body(&self, body: &Body, check: &Check) -> Checked {
        inertia(check, body.mass_kg, body.inertia_kg_m2)?;
        check.between("x_m", body.x_m, -50.0, 50.0)?;
        check.between("y_m", body.y_m, -3.0, 3.0)?;
        check.between("height_m", body.height_m, 0.0, 10.0)
    }

    fn wheelset(&self, wheelset: &Wheelset, check: &Check) -> Checked {
        inertia(check, wheelset.mass_kg, wheelset.inertia_kg_m2)?;
        check.between("x_m", wheelset.x_m, -50.0, 50.0)?;
        check.between("wheel_radius_m", wheelset.wheel_radius_m, 0.1, 1.5)?;
        let bodies = &self.names[..self.multibody.body.len()];
        match bodies.contains(&wheelset.frame.as_str()) {
            true => Ok(()),
            false => {
                Err(check.error("frame", &wheelset.frame, format!("must be one of {bodies:?}")))
            }
        }
    }

    /// Values of the contact section; profiles are known to the contact model only.
    pub fn contact(&self) -> Checked {
        let contact = &self.multibody.contact;
        let check = self.check.section("contact");
        check.between("rail_inclination", contact.rail_inclination, 0.0, 0.05)?;
        check.between("gauge_mm", contact.gauge_mm, 300.0, 2500.0)?;
        let back = contact.flange_back_distance_mm;
        let gauge = contact.gauge_mm;
        check.between("flange_back_distance_mm", back, gauge - 150.0, gauge - 30.0)?;
        check.between("gauge_depth_mm", contact.gauge_depth_mm, 5.0, 30.0)?;
        check.between("running_circle_mm", contact.running_circle_mm, 50.0, 100.0)?;
        check.between("profile_smoothing_mm", contact.profile_smoothing_mm, 0.0, 20.0)?;
        check.between("damping_s_m", contact.damping_s_m, 0.0, 10.0)?;
        contact.creep.check(&check.section("creep"))
    }
}

fn inertia(check: &Check, mass: f64, inertia: [f64; 3]) -> Checked {
    check.positive("mass_kg", mass)?;
    for value in inertia {
        check.positive("inertia_kg_m2", value)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use files::Document;
    use serde::Deserialize;

    use super::*;

    #[derive(Deserialize)]
    struct File {
        multibody: Multibody,
    }

    const SMALL: &str = r#"
        source = "test"
        coupler.height_m = 0.9
        body = [{ name = "frame", mass_kg = 900.0, inertia_kg_m2 = [1.0, 1.0, 1.0],
                  x_m = 0.0, height_m = 0.6 }]
        wheelset = [{ name = "axle", mass_kg = 100.0, inertia_kg_m2 = [1.0, 1.0, 1.0],
                      x_m = 0.0, wheel_radius_m = 0.46, frame = "frame" }]
        spring = [{ name = "primary", between = ["frame", "axle"],
                    points_m = [[0.0, 1.0, 0.46]], stiffness_n_m = [1e6, 1e6, 1e6] }]
        [contact]
        wheel = "S1002"
        rail = "60E1"
        rail_inclination = 0.025
        gauge_mm = 1435.0
        flange_back_distance_mm = 1360.0
        damping_s_m = 0.9
        [contact.creep]
        source = "test"
        friction = 0.3
        limit_ratio = 0.4
        decay_s_m = 0.6
    "#;

    fn checked(text: &str) -> Checked {
        let document = Document::new(
            "v.toml",
            format!("[multibody]\n{}", text.replace("[contact", "[multibody.contact")),
        );
        let file: File = document.parse().unwrap();
        file.multibody.check(&document.check().section("multibody"))?;
        file.multibody.check_mass(&document.check(), 1000.0)
    }

    fn message(from: &str, to: &str) -> String {
        assert!(SMALL.contains(from));
        checked(&SMALL.replacen(from, to, 1)).unwrap_err().to_string()
    }

    #[test]
    fn a_sound_section_passes() {
        checked(SMALL).unwrap();
    }

    #[test]
    fn wrong_values_are_named_with_key_value_and_remedy() {
        let negative = message("900.0", "-1.0");
        assert!(negative.starts_with("v.toml:5:45: multibody.body[1].mass_kg = -1.0: must be"));
        assert!(
            message("900.0", "800.0")
                .contains("mass_kg = 1000: must be 900 kg, the sum of the 1 bodies (800 kg)")
        );
        assert!(message("\"frame\", \"axle\"", "\"frame\", \"axel\"").contains("axel"));
        assert!(message("[0.0, 1.0, 0.46]", "[0.0, 1.0, 0.5]").contains("act in the axle"));
        assert!(message("[0.0, 1.0, 0.46]", "").contains("at least one point"));
        let behind = SMALL.replace(
            "x_m = 0.0, wheel_radius_m = 0.46, frame = \"frame\" }]",
            "x_m = 0.0, wheel_radius_m = 0.46, frame = \"frame\" },
             { name = \"other\", mass_kg = 100.0, inertia_kg_m2 = [1.0, 1.0, 1.0],
               x_m = 1.0, wheel_radius_m = 0.46, frame = \"frame\" }]",
        );
        let message_of = checked(&behind).unwrap_err().to_string();
        assert!(message_of.contains("wheelset[2].x_m = 1.0: must be less than 0"), "{message_of}");
        assert!(message("limit_ratio = 0.4", "limit_ratio = 2.0").contains("creep.limit_ratio"));
    }
}
