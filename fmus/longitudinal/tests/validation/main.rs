//! The longitudinal train against closed forms, published figures and another program.
//!
//! Each comparison is one `Row` of the table in `docs/validation/longitudinal.md`:
//! `cargo test -p longitudinal --test validation -- --nocapture` prints them.
//!
//! | file | what |
//! |---|---|
//! | `closed_forms.rs` | forces, energy and standstill of whole trains |
//! | `performance.rs` | resistance, gradients, traction, balancing speeds |
//! | `pairs.rs` | two vehicles: impacts and oscillations |
//! | `cross_code.rs` | a complete case of the Train Propulsion Simulator |
//! | `gears.rs` | kinds of draft gears, their energy, mixed and over a transition speed |
//! | `line.rs` | curve resistance, wind, starting, length over gradients |
//! | `brakes.rs` | air brake, locomotive brake, hand brakes, heat of the wheels |
//! | `drivers.rs` | control of the speed, replay of a logger, remote locomotives |
//! | `driver_files.rs` | what is refused of their files |
//! | `traction.rs` | effort by notch, power, adhesion, splines |
//! | `numerics.rs` | the step: stable range, convergence, chatter, standstill |

mod brakes;
mod closed_forms;
mod cross_code;
mod driver_files;
mod drivers;
mod gears;
mod line;
mod numerics;
mod pairs;
mod performance;
mod support;
mod traction;
