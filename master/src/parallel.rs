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
    let first_error = items
        .par_iter_mut()
        .with_max_len(1)
        .enumerate()
        .filter_map(|(i, item)| task(item).err().map(|error| (i, error)))
        .min_by_key(|(i, _)| *i);
    first_error.map_or(Ok(()), |(_, error)| Err(error))
}

/// A pool of `threads` threads.
///
/// # Errors
/// When the system does not give the threads.
pub fn pool(threads: usize) -> Result<rayon::ThreadPool, rayon::ThreadPoolBuildError> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(|i| format!("hotfoot-{i}"))
        .build()
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
