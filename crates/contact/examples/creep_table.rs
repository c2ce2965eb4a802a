//! Makes the table of exact rolling: `cargo xtask creep-table`.
//!
//! Argument: the file to write. With a second one, a number n, only every n-th ray is solved and
//! nothing is written: how long all would take.

use std::error::Error;
use std::time::Instant;

use contact::rolling::recipe::{self, Ray};
use rayon::prelude::*;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("give the file to write")?;
    let every = arguments.next().map_or(Ok(1), |every| every.parse())?;
    let begin = Instant::now();
    let rays: Vec<_> = Ray::all().into_iter().step_by(every).collect();
    let solved: Vec<_> = rays.par_iter().map(|ray| (*ray, recipe::nodes(*ray))).collect();
    let seconds = begin.elapsed().as_secs_f64();
    println!("{} rays in {seconds:.0} s on {} threads", solved.len(), rayon::current_num_threads());
    if every == 1 {
        std::fs::write(&file, recipe::file(&solved))?;
        println!("{file}");
    }
    Ok(())
}
