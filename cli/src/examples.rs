//! Examples in the help of the commands; each can be typed at the top of the repository.

/// Of the program: what its exit codes mean.
pub const ALL: &str = "\
Exit codes:
  0        done
  1        failed, wrong, or (compare, expect) different; the reason is on the standard error
  2        the arguments are wrong
  128 + n  stopped by signal n, such as 130 after Ctrl-C; what was recorded is complete

Each command has examples: hotfoot COMMAND --help";

/// Of `hotfoot run`.
pub const RUN: &str = "\
Examples:
  hotfoot run scenarios/first-look --set train.speed_m_per_s=20
  hotfoot run scenarios/curve-increasing-speed --duration 20
  hotfoot run scenarios/train-alone --results results/first --quiet --json
  hotfoot run train.ssp --step 0.001 --threads 4 --record 'vehicle_1.*' --csv
  hotfoot run scenarios/wet-rail --checkpoint 20 --results results/long
  hotfoot run --resume results/long";

/// Of `hotfoot new`.
pub const NEW: &str = "\
Examples:
  hotfoot new
  hotfoot new studies/my-curve
  hotfoot new studies/rain --from wet-rail --stock stock";

/// Of `hotfoot export-ssp`.
pub const EXPORT_SSP: &str = "\
Examples:
  hotfoot export-ssp scenarios/curve-increasing-speed --output train.ssp
  hotfoot export-ssp scenarios/first-look --set duration_s=60 --quiet";

/// Of `hotfoot check`.
pub const CHECK: &str = "\
Examples:
  hotfoot check scenarios/first-look --set train.speed_m_per_s=20
  hotfoot check scenarios/first-look --json
  hotfoot check wagon.fmu
  hotfoot check wagon.fmu --as vehicle --replay
  hotfoot check --rules";

/// Of `hotfoot pack`.
pub const PACK: &str = "\
Examples:
  hotfoot pack target/release/libvehicle_fmu.so --resources fmus/vehicle/resources --stock stock --output wagon.fmu
  hotfoot pack wagon.fmu --resources my-wagon --output my-wagon.fmu";

/// Of `hotfoot schema`.
pub const SCHEMA: &str = "\
Examples:
  hotfoot schema
  hotfoot schema track
  hotfoot schema weather";

/// Of `hotfoot modes`.
pub const MODES: &str = "\
Examples:
  hotfoot modes wagon-ore-40t
  hotfoot modes locomotive-coco-134t --stick --csv";

/// Of `hotfoot contact`.
pub const CONTACT: &str = "\
Examples:
  hotfoot contact --wheel S1002 --rail 60E1 --from-mm -6 --to-mm 6
  hotfoot contact --wheel cone-1-20 --plot cone.svg
  hotfoot contact --left-radius 0.459 --roll off --from-mm 1 --to-mm 7";

/// Of `hotfoot profile`.
pub const PROFILE: &str = "\
Examples:
  hotfoot profile tests/profiles/worn.prw
  hotfoot profile tests/profiles/worn.prw --plot worn.svg --write worn-clean.txt";

/// Of `hotfoot creep`.
pub const CREEP: &str = "\
Examples:
  hotfoot creep --load 100000 --radii-m 0.5 0.3 --longitudinal 0.001
  hotfoot creep --load 100000 --semi-axes-mm 6 6 --longitudinal 0,0.002,0.004,0.008 --plot creep.svg
  hotfoot creep --law polach --factors 0.7 0.4 --load 100000 --semi-axes-mm 6 5 --lateral 0.002";

/// Of `hotfoot critical-speed`.
pub const CRITICAL_SPEED: &str = "\
Examples:
  hotfoot critical-speed wagon-ore-40t --conicity 0.1,0.2,0.3
  hotfoot critical-speed locomotive-coco-134t --greatest 80 --csv";

/// Of `hotfoot report`.
pub const REPORT: &str = "\
Examples:
  hotfoot report results/curve-increasing-speed
  hotfoot report results/curve-increasing-speed --csv";

/// Of `hotfoot expect`.
pub const EXPECT: &str = "\
Examples:
  hotfoot expect results/foot-study/r800 scenarios/foot-study/expected/r800.toml
  hotfoot expect results/acceptance-sine scenarios/acceptance-sine/expected.toml --json";

/// Of `hotfoot compare`.
pub const COMPARE: &str = "\
Examples:
  hotfoot compare results/dry results/wet
  hotfoot compare results/dry results/wet results/sanded --output rails.html
  hotfoot compare results/before results/after --tolerance 1e-9 --quiet
  hotfoot compare results/replay logger.csv --map V_GPS=vehicles[1].velocity --shift -12.5 --json";

/// Of `hotfoot interface`.
pub const INTERFACE: &str = "\
Examples:
  hotfoot interface wagon.fmu
  hotfoot interface wagon.fmu --json
  hotfoot interface --xml wagon.fmu";

/// Of `hotfoot wiring`.
pub const WIRING: &str = "\
Examples:
  hotfoot wiring scenarios/curve-increasing-speed
  hotfoot wiring scenarios/curve-increasing-speed --set scheme=jacobi --json
  hotfoot wiring train.ssp --dot";

/// Of `hotfoot stock`.
pub const STOCK: &str = "\
Examples:
  hotfoot stock list
  hotfoot stock show wagon-ore-40t
  hotfoot stock source friction-gear-m901e
  hotfoot stock list --json";

/// Of `hotfoot completions`.
pub const COMPLETIONS: &str = "\
Examples:
  hotfoot completions bash
  hotfoot completions zsh";

/// Of `hotfoot man`.
pub const MAN: &str = "\
Examples:
  hotfoot man target/man";
