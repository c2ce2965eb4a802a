//! The message of an error: each sentence once.

use anyhow::Error;

/// The sentence of an error and those of what has caused it. Many an error repeats its cause in its own
/// sentence; such a cause is left out.
pub fn message(error: &Error) -> String {
    let mut message = String::new();
    for cause in error.chain().map(|cause| cause.to_string()) {
        let cause = cause.trim();
        match message.is_empty() {
            true => cause.clone_into(&mut message),
            false if message.contains(cause) => {}
            false => message = format!("{message}: {cause}"),
        }
    }
    message
}

#[cfg(test)]
mod tests {
    use anyhow::anyhow;

    use super::*;

    #[test]
    fn a_cause_that_the_error_repeats_comes_once() {
        let twice = anyhow!("no such folder").context("train.fmu: no such folder");
        assert_eq!(message(&twice), "train.fmu: no such folder");
    }

    #[test]
    fn a_cause_that_the_error_keeps_to_itself_comes_behind_it() {
        let own = anyhow!("no such folder\n").context("the FMU cannot be packed").context("export");
        assert_eq!(message(&own), "export: the FMU cannot be packed: no such folder");
    }
}
