//! Developer tasks: `cargo xtask <task>`.
//!
//! | file | task |
//! |---|---|
//! | `book/` | the book |
//! | `creep_table.rs` | the table of the creep law |
//! | `fmus.rs` | build and pack the FMUs; the committed model descriptions |
//! | `foot_study.rs` | the runs of the foot study, its table and expected figures |
//! | `instructions.rs` | instructions of a vehicle's step, counted |
//! | `package.rs` | the Python package and its wheel |
//! | `test.rs` | the whole test run, and checks that take longer |
//! | `python.rs` | the Python environments: of the tests, which has libclang too, and of the wheel's tools |
//! | `scenario_table.rs` | the runs of the paper's scenarios, and their table |
//! | `shell.rs` | running commands |

mod book;
mod creep_table;
mod fmus;
mod foot_study;
mod instructions;
mod package;
mod python;
mod scenario_table;
mod shell;
mod test;

use std::path::PathBuf;

use anyhow::Result;
use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(bin_name = "cargo xtask", about = "Developer tasks of Hotfoot")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Build everything, run a scenario and write its report
    Run {
        /// Scenario folder or file, and further arguments of `hotfoot run`
        #[arg(required = true, trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Build and pack the FMUs into target/fmus
    Fmus,
    /// Write the published model descriptions anew
    ModelDescriptions,
    /// Run the foot study (some minutes a scenario) and print its table, and what is said beside it
    FootStudy {
        /// Folder of the results
        #[arg(default_value = "results/foot-study")]
        results: PathBuf,
        /// Take the results that are there
        #[arg(long)]
        table_only: bool,
        /// Write what the runs gave as their expected figures
        #[arg(long)]
        write_expected: bool,
    },
    /// Run the paper's four scenarios (some minutes each) and print the table of what was measured
    ScenarioTable {
        /// Folder in which each run has its results
        #[arg(default_value = "results")]
        results: PathBuf,
        /// Take the results that are there
        #[arg(long)]
        table_only: bool,
        /// Further arguments of `hotfoot run`, behind `--`
        #[arg(last = true)]
        arguments: Vec<String>,
    },
    /// Make the table of the creep law anew (ten minutes on two cores)
    CreepTable {
        /// Solve only every so many rays, and write nothing: how long all would take
        #[arg(long)]
        every: Option<usize>,
    },
    /// Build the book in target/book/html
    Book,
    /// Run the FMUs with the crate `fmi`, another importer (some minutes, most for building it)
    Importer,
    /// Compare the package of every shipped scenario with the scenario's run (a quarter of an hour)
    Packages,
    /// Count the instructions of a vehicle's step by its parts (needs valgrind)
    Instructions,
    /// Kill runs at many moments, and see that no whole record is lost
    CrashTest {
        /// Number of kills
        #[arg(default_value_t = 100)]
        kills: u32,
    },
    /// Lay the Python package out in target/package, where the tests find it
    Package,
    /// Build the wheel into target/wheel, for glibc 2.28 (some minutes)
    Wheel,
    /// Build the wheel and try it in an environment without Rust
    WheelTest,
    /// The whole test run
    Test,
}

fn main() -> Result<()> {
    shell::go_to_workspace()?;
    match Arguments::parse().task {
        Task::Run { arguments } => {
            fmus::build()?;
            shell::run(shell::hotfoot().arg("run").args(arguments))
        }
        Task::Fmus => fmus::build(),
        Task::ModelDescriptions => {
            fmus::build()?;
            fmus::write_model_descriptions()
        }
        Task::FootStudy { results, table_only, write_expected } => {
            if !table_only {
                build_package()?;
                foot_study::run_all(&results)?;
            }
            if write_expected {
                foot_study::write_expected(&results)?;
            }
            print!("{}", foot_study::table(&results)?);
            package::read_by("examples/read-results/foot_study.py", &results)
        }
        Task::ScenarioTable { results, table_only, arguments } => {
            if !table_only {
                build_package()?;
                scenario_table::run_all(&results, &arguments)?;
            }
            scenario_table::print(&results)
        }
        Task::CreepTable { every } => creep_table::make(every),
        Task::Book => {
            println!("{}", book::build()?.display());
            Ok(())
        }
        Task::Importer => {
            fmus::build()?;
            test::importer()
        }
        Task::Packages => {
            fmus::build()?;
            test::packages()
        }
        Task::Instructions => {
            print!("{}", instructions::table()?);
            Ok(())
        }
        Task::CrashTest { kills } => test::kill_runs(kills),
        Task::Package => {
            build_package()?;
            package::stage()
        }
        Task::Wheel => package::wheel().map(|_| ()),
        Task::WheelTest => package::test_wheel(),
        Task::Test => test::run_all(),
    }
}

/// Builds what the Python package holds.
fn build_package() -> Result<()> {
    fmus::build()?;
    shell::run(shell::cargo().args(["build", "--release", "-p", "hotfoot-python"]))
}
