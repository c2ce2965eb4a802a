//! Prints what breaks the rules of the house: `architecture [RULE…] [FOLDER…]`.

use std::process::ExitCode;

use architecture::{RULES, Workspace};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_rule = |name: &str| RULES.iter().any(|rule| rule.name == name);
    let (rules, folders): (Vec<_>, Vec<_>) = arguments.iter().partition(|name| is_rule(name));
    let workspace = Workspace::read();
    let mut count = 0;
    for rule in RULES {
        if !rules.is_empty() && !rules.iter().any(|name| *name == rule.name) {
            continue;
        }
        let mut breaches = (rule.breaches)(&workspace);
        breaches.retain(|breach| {
            folders.is_empty() || folders.iter().any(|folder| breach.path.starts_with(folder))
        });
        println!("{}: {} {}", rule.name, rule.sentence, breaches.len());
        breaches.iter().for_each(|breach| println!("  {breach}"));
        count += breaches.len();
    }
    if count == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
