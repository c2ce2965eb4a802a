//! Compiles the C shims of the FMI logger, since Rust cannot define a variadic function, and of
//! the handler of crashes, and notes the commit that the program is built from.

use std::process::Command;

fn main() {
    let shims = ["src/fmi/logger.c", "src/fmi/watched/crash.c"];
    for shim in shims {
        println!("cargo::rerun-if-changed={shim}");
    }
    cc::Build::new().files(shims).warnings_into_errors(true).compile("fmi_shims");

    println!("cargo::rerun-if-changed=../.git/HEAD");
    let git = Command::new("git").args(["describe", "--always", "--dirty"]).output();
    let commit = git.ok().filter(|output| output.status.success()).map_or_else(
        || "unknown".to_owned(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    );
    println!("cargo::rustc-env=HOTFOOT_GIT_COMMIT={commit}");
}
