//! The order of points along the track.

use files::{Check, Mistake};

/// Points stand in the order of their chainages; one that stands twice is a step.
pub(crate) fn check_order(
    check: &Check,
    list: &str,
    chainages: impl Iterator<Item = f64>,
) -> Result<(), Mistake> {
    let mut before: Option<f64> = None;
    for (i, chainage) in chainages.enumerate() {
        let check = check.element(list, i);
        check.ensure(chainage.is_finite(), "chainage_m", chainage, "must be a finite chainage")?;
        if let Some(before) = before.filter(|before| chainage < *before) {
            let wanted = format!("must not be less than {before}, that of the point before it");
            return Err(check.error("chainage_m", chainage, wanted));
        }
        before = Some(chainage);
    }
    Ok(())
}
