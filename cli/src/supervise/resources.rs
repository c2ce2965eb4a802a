//! What the system says of memory and processor time: whether it has ended a process for want of them.

use std::fs;

/// Ticks of `/proc` a second.
const TICKS: f64 = 100.0;
/// Indices of cutime and cstime behind the name in proc_pid_stat(5).
const OF_CHILDREN: [usize; 2] = [13, 14];
/// Seconds of processor time below the limit at which the system may have ended a process.
const NEARLY: f64 = 1.0;

/// What the system has counted until now.
pub struct Resources {
    /// Processes that it has killed for want of memory.
    kills: Option<u64>,
}

impl Resources {
    /// What it has counted now.
    pub fn now() -> Self {
        Self { kills: kills() }
    }

    /// Whether it has killed a process for want of memory since then.
    pub fn memory_ran_out(&self) -> bool {
        self.kills.zip(kills()).is_some_and(|(before, now)| now > before)
    }
}

/// Number of processes that the system has killed for want of memory, where it counts them.
fn kills() -> Option<u64> {
    let counters = fs::read_to_string("/proc/vmstat").ok()?;
    counters.lines().find_map(|line| line.strip_prefix("oom_kill ")?.parse().ok())
}

/// The limit of processor time, s, if the children that have ended came to it.
pub fn spent_processor_time() -> Option<f64> {
    let limit = limit("Max cpu time")?;
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks: Option<f64> =
        OF_CHILDREN.iter().map(|&index| fields.get(index)?.parse::<f64>().ok()).sum();
    (ticks? / TICKS >= limit - NEARLY).then_some(limit)
}

/// The limit of memory that a process may have, bytes, if there is one.
pub fn memory_limit() -> Option<f64> {
    limit("Max address space")
}

/// The hard limit of that name in proc_pid_limits(5), if there is one.
fn limit(name: &str) -> Option<f64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let line = limits.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().nth(1)?.parse().ok()
}
