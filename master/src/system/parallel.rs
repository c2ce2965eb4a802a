//! Vehicles in parallel.

use rayon::prelude::*;

/// Runs `task` on every item, on the threads of the current pool, and gives the first error in
/// the order of the items. Items share nothing, so the number of threads cannot change a result.
///
/// # Errors
/// When a task fails.
pub fn for_each<T: Send, E: Send>(
    items: &mut [T],
    task: impl Fn(&mut T) -> Result<(), E> + Sync,
) -> Result<(), E> {
    if let [item] = items {
        // A single one needs no other thread, which an FMU might not bear.
        return task(item);
    }
    let first_error = items
        .par_iter_mut()
        .with_max_len(1)
        .enumerate()
        .filter_map(|(i, item)| task(item).err().map(|error| (i, error)))
        .min_by_key(|(i, _)| *i);
    first_error.map_or(Ok(()), |(_, error)| Err(error))
}

/// The system gives no threads.
#[derive(Debug, thiserror::Error)]
#[error("{threads} threads cannot be started: {source}")]
pub struct ThreadsError {
    /// Threads wanted.
    threads: usize,
    /// Reason.
    source: rayon::ThreadPoolBuildError,
}

/// A pool of `threads` threads.
///
/// # Errors
/// When the system does not give the threads.
pub fn pool(threads: usize) -> Result<rayon::ThreadPool, ThreadsError> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(|i| format!("hotfoot-{i}"))
        .build()
        .map_err(|source| ThreadsError { threads, source })
}

/// All cores.
pub fn default_threads() -> usize {
    std::thread::available_parallelism().map_or(1, Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_error_in_order_is_given_whatever_the_threads() {
        for threads in [1, 4] {
            let run = || {
                for_each(&mut [1, 2, 3, 4], |item| {
                    *item *= 2;
                    if *item > 4 { Err(*item) } else { Ok(()) }
                })
            };
            assert_eq!(pool(threads).unwrap().install(run), Err(6));
        }
    }
}
