//! What the system says of memory and processor time: whether it has ended a process for want of them.

use std::fs;
use std::path::{Path, PathBuf};

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

/// Number of processes that the system has killed for want of memory, where it counts them: those of
/// our control group, since other groups have limits of their own, or else of the whole system.
fn kills() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    let files = event_files(&groups).chain([PathBuf::from("/proc/vmstat")]);
    files.filter_map(|file| fs::read_to_string(file).ok()).find_map(|text| kills_in(&text))
}

/// Files that count what happened to the memory of our control group, of version 1 and 2; `groups` is
/// what proc_pid_cgroup(5) says of a process.
fn event_files(groups: &str) -> impl Iterator<Item = PathBuf> {
    groups.lines().filter_map(|line| {
        let mut parts = line.splitn(3, ':').skip(1);
        let (root, file) = match parts.next()? {
            "memory" => ("/sys/fs/cgroup/memory", "memory.oom_control"),
            "" => ("/sys/fs/cgroup", "memory.events.local"),
            _ => return None,
        };
        let group = parts.next()?.trim_start_matches('/');
        Some(Path::new(root).join(group).join(file))
    })
}

/// The count in such a file.
fn kills_in(text: &str) -> Option<u64> {
    text.lines().find_map(|line| line.strip_prefix("oom_kill ")?.parse().ok())
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines as Docker (version 2) and systemd with hierarchies of version 1 have them.
    #[test]
    fn the_count_of_the_own_group_is_read() {
        let groups = "4:memory:/runs/7\n1:cpu:/runs\n0::/docker/ab\n";
        let files: Vec<_> = event_files(groups).collect();
        let wanted = [
            "/sys/fs/cgroup/memory/runs/7/memory.oom_control",
            "/sys/fs/cgroup/docker/ab/memory.events.local",
        ];
        assert_eq!(files, wanted.map(PathBuf::from));
        assert_eq!(kills_in("oom_kill_disable 0\nunder_oom 0\noom_kill 3\n"), Some(3));
        assert_eq!(kills_in("low 0\noom 2\noom_kill 1\noom_group_kill 0\n"), Some(1));
        assert_eq!(kills_in("nr_free_pages 5\n"), None);
    }
}
