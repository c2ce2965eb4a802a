//! The draft-gear file: one gear as its maker or a test describes it.
//!
//! ```toml
//! name = "Friction gear"
//! source = "data sheet"
//! locked_stiffness_mn_m = 200.0     # between the loading and the unloading curve
//! structure_stiffness_mn_m = 150.0  # added beyond the travel, where the gear is solid
//! damping_kn_s_m = 0.0              # viscous, in parallel; may be left out
//! transition_speed_mm_s = 10.0      # blends the curves by the speed; left out: they are clamped
//! [loading]                         # a force that does not begin at zero is a preload
//! deflection_mm = [0.0, 19.05, 76.2, 101.6]
//! force_kn = [0.0, 889.6, 1445.7, 1779.3]
//! ```
//!
//! | the gear is | what the file has |
//! |---|---|
//! | a table | `[loading]`, and `[unloading]` or `loss_percent`, the share of the force that is lost |
//! | elastic | `[loading]` only; `locked_stiffness_mn_m` may be left out |
//! | polymer | `[loading]` of the stack and its `loss_percent` |
//! | steel friction with a wedge | `[loading]` of the spring, `[wedge]` with its angle and friction |
//! | friction and polymer | `[loading]` of the stack, its `loss_percent`, and `[wedge]` |
//! | a hydraulic cushion | `[loading]` of the return spring, `[orifice]` over the stroke |
//! | a drawbar | `[drawbar]` with its stiffness |
//! | buffers and screw coupling | the coupling in draft as above, `[buff]` with the same keys and `count` |

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use super::force_curve::ForceCurve;
use super::wedge::Wedge;
use super::{Characteristic, DraftGear, Orifice};

/// Stiffness of an elastic gear's lock over the steepest piece of its curve.
///
/// Any number above one gives the same force.
const ELASTIC_LOCK: f64 = 2.0;

/// Deflection up to which the curve of a drawbar is given, mm; it goes on alike.
const DRAWBAR_DEFLECTION: f64 = 10.0;

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Drawbar {
    stiffness_mn_m: f64,
}

/// Declares the file of a gear, its section `[buff]`, and a [`Side`], all with the same keys.
macro_rules! keys_of_a_direction {
    ($($key:ident: $kind:ty),* $(,)?) => {
        #[derive(Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub(crate) struct GearFile {
            name: String,
            source: String,
            buff: Option<Buff>,
            $($key: Option<$kind>,)*
        }

        /// Section `[buff]`: so many gears side by side, in buff only.
        #[derive(Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        struct Buff {
            #[serde(default = "one")]
            count: f64,
            $($key: Option<$kind>,)*
        }

        /// One direction of a gear as it is written.
        struct Side {
            count: f64,
            $($key: Option<$kind>,)*
        }

        impl GearFile {
            /// Name, source, draft and buff.
            fn parts(self) -> (String, String, Side, Option<Side>) {
                let buff = self.buff.map(|buff| Side { count: buff.count, $($key: buff.$key,)* });
                (self.name, self.source, Side { count: one(), $($key: self.$key,)* }, buff)
            }
        }
    };
}

keys_of_a_direction! {
    locked_stiffness_mn_m: f64,
    structure_stiffness_mn_m: f64,
    damping_kn_s_m: f64,
    transition_speed_mm_s: f64,
    loading: ForceCurve,
    unloading: ForceCurve,
    loss_percent: f64,
    wedge: Wedge,
    orifice: Orifice,
    drawbar: Drawbar,
}

fn one() -> f64 {
    1.0
}

impl GearFile {
    /// What the gear does in draft and in buff, if its values are possible.
    pub(crate) fn compile(self, check: &Check) -> Result<DraftGear, Mistake> {
        let (name, source, draft, buff) = self.parts();
        let draft = draft.compile(check)?;
        let buff = match buff {
            None => draft.clone(),
            Some(buff) => buff.compile(&check.section("buff"))?,
        };
        Ok(DraftGear { name, source, draft, buff })
    }
}

impl Side {
    fn compile(self, check: &Check) -> Result<Characteristic, Mistake> {
        check.between("count", self.count, 1.0, 4.0)?;
        let damping = self.damping_kn_s_m.unwrap_or_default();
        check.between("damping_kn_s_m", damping, 0.0, 10_000.0)?;
        if let Some(speed) = self.transition_speed_mm_s {
            check.between("transition_speed_mm_s", speed, 0.1, 1000.0)?;
        }
        let (loading, drawbar) = self.loading_curve(check)?;
        loading.check(&check.section("loading"))?;
        let loss = 1.0 - self.loss_percent.unwrap_or_default() / 100.0;
        let unloading = match (&self.unloading, self.loss_percent) {
            (Some(unloading), None) => unloading.clone(),
            (Some(_), Some(percent)) => {
                let wanted = "leave either loss_percent or [unloading] out";
                return Err(check.error("loss_percent", percent, wanted));
            }
            (None, percent) => {
                check.between("loss_percent", percent.unwrap_or_default(), 0.0, 99.0)?;
                loading.scaled(loss)
            }
        };
        unloading.check(&check.section("unloading"))?;
        let (loading_ratio, unloading_ratio) = match &self.wedge {
            None => (1.0, 1.0),
            Some(wedge) => wedge.force_ratios(&check.section("wedge"))?,
        };
        if let Some(orifice) = &self.orifice {
            orifice.check(&check.section("orifice"))?;
        }
        let count = self.count;
        let loading = loading.scaled(count * loading_ratio);
        let unloading = unloading.scaled(count * unloading_ratio);
        unloading.check_is_below(&loading, &check.section("unloading"))?;
        if loading.force_kn[0] > 0.0 && unloading.force_kn[0] == 0.0 {
            let wanted =
                "must be above zero, as that of the loading curve is: a preload does not vanish";
            return Err(check.error("unloading.force_kn[1]", 0.0, wanted));
        }
        let elastic = loading == unloading;
        let (locked, structure) = self.stiffness(check, &loading, elastic, drawbar)?;
        let characteristic = Characteristic {
            locked_stiffness_mn_m: locked,
            structure_stiffness_mn_m: structure,
            damping_kn_s_m: count * damping,
            transition_speed_mm_s: self.transition_speed_mm_s,
            loading,
            unloading,
            orifice: self.orifice.map(|orifice| orifice.scaled(count)),
        };
        characteristic.check_lock(check)?;
        Ok(characteristic)
    }

    /// The curve that the file gives, and the stiffness of a drawbar.
    fn loading_curve(&self, check: &Check) -> Result<(ForceCurve, Option<f64>), Mistake> {
        match (&self.loading, &self.drawbar) {
            (Some(loading), None) => Ok((loading.clone(), None)),
            (None, Some(drawbar)) => {
                let stiffness = drawbar.stiffness_mn_m;
                check.between("drawbar.stiffness_mn_m", stiffness, 1.0, 2000.0)?;
                let curve = ForceCurve {
                    deflection_mm: vec![0.0, DRAWBAR_DEFLECTION],
                    force_kn: vec![0.0, DRAWBAR_DEFLECTION * stiffness],
                };
                Ok((curve, Some(stiffness)))
            }
            (Some(_), Some(_)) => {
                Err(check.refuse("drawbar", "leave either [loading] or [drawbar] out"))
            }
            (None, None) => {
                let what_for = "a gear needs [loading], force over deflection, or [drawbar]";
                Err(check.missing("loading", what_for))
            }
        }
    }

    /// Locked and structure stiffness, MN/m.
    fn stiffness(
        &self,
        check: &Check,
        loading: &ForceCurve,
        elastic: bool,
        drawbar: Option<f64>,
    ) -> Result<(f64, f64), Mistake> {
        let structure = match (self.structure_stiffness_mn_m, drawbar) {
            (Some(structure), _) => {
                check.between("structure_stiffness_mn_m", structure, 1.0, 2000.0)?;
                structure * self.count
            }
            (None, Some(stiffness)) => stiffness * self.count,
            (None, None) => {
                let what_for = "the slope beyond the last point, where the gear is solid";
                return Err(check.missing("structure_stiffness_mn_m", what_for));
            }
        };
        let locked = match self.locked_stiffness_mn_m {
            Some(locked) => {
                check.between("locked_stiffness_mn_m", locked, 1.0, 5000.0)?;
                locked * self.count
            }
            None if elastic => ELASTIC_LOCK * structure.max(loading.steepest_mn_m()),
            None => {
                let what_for = "the slope between the loading and the unloading curve";
                return Err(check.missing("locked_stiffness_mn_m", what_for));
            }
        };
        Ok((locked, structure))
    }
}

#[cfg(test)]
mod tests {
    use files::Document;

    use super::*;

    const LOADING: &str = "[loading]\ndeflection_mm = [0, 10, 30]\nforce_kn = [0, 100, 200]\n";

    /// The gear of a file with `keys` before the loading curve and `sections` behind it.
    fn gear(keys: &str, sections: &str) -> Result<DraftGear, Mistake> {
        let text = format!(
            "name = 'gear'\nsource = 'test'\nstructure_stiffness_mn_m = 50\n{keys}\n{LOADING}{sections}"
        );
        let document = Document::new("gear.toml", text);
        document.parse::<GearFile>()?.compile(&document.check())
    }

    fn message(keys: &str, sections: &str) -> String {
        gear(keys, sections).unwrap_err().to_string()
    }

    #[test]
    fn an_unloading_curve_above_the_loading_curve_is_refused() {
        let unloading = "[unloading]\ndeflection_mm = [0, 10, 30]\nforce_kn = [0, 120, 200]";
        let message = message("locked_stiffness_mn_m = 100", unloading);
        assert!(message.contains("unloading.force_kn = 120: must not exceed"));
    }

    #[test]
    fn analytic_polymer_loses_its_share_of_the_force() {
        let gear = gear("locked_stiffness_mn_m = 100\nloss_percent = 40", "").unwrap();
        assert_eq!(gear.draft.unloading.force_kn, [0.0, 60.0, 120.0]);
        assert_eq!(gear.buff, gear.draft);
    }

    /// Without friction at the wedge: tan φ/(tan φ − μ) in, tan φ/(tan φ + μ) out (Cole 2006).
    #[test]
    fn analytic_wedge_without_friction_at_the_wedge_is_cole_s() {
        let wedge = "[wedge]\nangle_deg = 50\nwedge_friction = 0\nhousing_friction = 0.4";
        let gear = gear("locked_stiffness_mn_m = 100", wedge).unwrap();
        let tan = 50.0_f64.to_radians().tan();
        let (loading, unloading) = (&gear.draft.loading, &gear.draft.unloading);
        assert!((loading.force_kn[2] / 200.0 - tan / (tan - 0.4)).abs() < 1e-12);
        assert!((unloading.force_kn[2] / 200.0 - tan / (tan + 0.4)).abs() < 1e-12);
    }

    #[test]
    fn a_wedge_that_jams_is_refused() {
        let wedge = "[wedge]\nangle_deg = 10\nwedge_friction = 0.1\nhousing_friction = 0.5";
        let message = message("locked_stiffness_mn_m = 100", wedge);
        assert!(message.contains("wedge.angle_deg = 10: the wedge jams"), "{message}");
    }

    #[test]
    fn buffers_work_in_buff_only() {
        let buff = "[buff]\ncount = 2\nstructure_stiffness_mn_m = 80\n\
                    [buff.loading]\ndeflection_mm = [0, 100]\nforce_kn = [10, 400]";
        let gear = gear("", buff).unwrap();
        assert_eq!(gear.buff.loading.force_kn, [20.0, 800.0]);
        assert_eq!(gear.draft.loading.force_kn, [0.0, 100.0, 200.0]);
        assert_eq!(gear.buff.structure_stiffness_mn_m, 160.0);
    }

    #[test]
    fn a_gear_with_friction_needs_its_lock() {
        let message = message("loss_percent = 40", "");
        assert!(
            message.contains("locked_stiffness_mn_m is missing: the slope between"),
            "{message}"
        );
    }

    #[test]
    fn a_lock_softer_than_the_curve_is_refused() {
        let message = message("loss_percent = 40\nlocked_stiffness_mn_m = 9", "");
        assert!(message.contains("structure_stiffness_mn_m = 50: must be less"), "{message}");
    }
}
