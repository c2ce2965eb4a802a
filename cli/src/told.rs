//! How an error is told: each sentence once.

use anyhow::Error;

/// The sentence of an error and those of what has caused it. Many an error repeats its cause in its own
/// sentence; such a cause is not told again.
pub fn told(error: &Error) -> String {
    let mut told = String::new();
    for cause in error.chain().map(|cause| cause.to_string()) {
        let cause = cause.trim();
        match told.is_empty() {
            true => cause.clone_into(&mut told),
            false if told.contains(cause) => {}
            false => told = format!("{told}: {cause}"),
        }
    }
    told
}

#[cfg(test)]
mod tests {
    use anyhow::anyhow;

    use super::*;

    #[test]
    fn a_cause_that_the_error_repeats_is_told_once() {
        let twice = anyhow!("no such folder").context("train.fmu: no such folder");
        assert_eq!(told(&twice), "train.fmu: no such folder");
    }

    #[test]
    fn a_cause_that_the_error_keeps_to_itself_is_told_behind_it() {
        let own = anyhow!("no such folder\n").context("the FMU cannot be packed").context("export");
        assert_eq!(told(&own), "export: the FMU cannot be packed: no such folder");
    }
}
