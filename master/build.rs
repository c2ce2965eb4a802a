//! Compiles the C shim of the FMI logger, since Rust cannot define a variadic function, and
//! notes the commit that the program is built from.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=src/fmi/logger.c");
    cc::Build::new().file("src/fmi/logger.c").warnings_into_errors(true).compile("fmi_logger");

    println!("cargo::rerun-if-changed=../.git/HEAD");
    let git = Command::new("git").args(["describe", "--always", "--dirty"]).output();
    let commit = git.ok().filter(|output| output.status.success()).map_or_else(
        || "unknown".to_owned(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    );
    println!("cargo::rustc-env=HOTFOOT_GIT_COMMIT={commit}");
}
