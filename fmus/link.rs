//! Build script of the FMUs' packages.

fn main() {
    println!("cargo::rerun-if-changed=../../link.rs");
    // The library stays in the process once it is loaded. Importers may close it while instances live
    // (ecos 0.7.2 does at the second instance of an FMU), and these would be left with dangling pointers.
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo::rustc-link-arg-cdylib=-Wl,-z,nodelete");
    }
}
