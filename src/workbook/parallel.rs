//! Work on several threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// How many threads work at once by default: one for each core.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Does something with each job, on so many threads; the results keep the order of the jobs.
///
/// # Errors
///
/// The first error; the jobs that nobody has begun by then are left.
pub fn in_parallel<J: Sync, T: Send, E: Send>(
    jobs: &[J],
    threads: usize,
    work: impl Fn(&J) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, Result<T, E>)>> = Mutex::new(Vec::new());
    thread::scope(|scope| {
        for _ in 0..threads.min(jobs.len()) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(job) = jobs.get(index) else { break };
                    let result = work(job);
                    if result.is_err() {
                        next.store(jobs.len(), Ordering::Relaxed);
                    }
                    let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
                    done.push((index, result));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_keep_the_order_and_an_error_ends_the_work() {
        let jobs: Vec<u32> = (0..50).collect();
        let doubled = in_parallel(&jobs, 4, |n| Ok::<_, ()>(2 * n));
        assert_eq!(doubled, Ok(jobs.iter().map(|n| 2 * n).collect()));
        let begun = AtomicUsize::new(0);
        let failed = in_parallel(&jobs, 1, |&n| {
            begun.fetch_add(1, Ordering::Relaxed);
            if n == 3 { Err(n) } else { Ok(n) }
        });
        assert_eq!((failed, begun.into_inner()), (Err(3), 4));
        assert_eq!(
            in_parallel(&[] as &[u32], 4, |_| Err::<(), ()>(())),
            Ok(vec![])
        );
    }
}
