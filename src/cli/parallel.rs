//! Work on many scenes on all cores, with results in the order of the scenes.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// How many threads work where so many are asked for; else as many as there are processors.
pub(crate) fn threads(asked: Option<NonZeroUsize>) -> NonZeroUsize {
    asked.or_else(|| thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN)
}

/// Works on every item, on as many threads as asked for, and hands the results to `each` in the order of the
/// items. A result is `None` where the work panicked: a bug, of which the others must not suffer. Where the
/// system gives fewer threads, those do it; where it gives none, and for one, this thread does.
///
/// # Errors
/// The first error of `each`; the rest of the results are then dropped.
pub(crate) fn in_order<T: Sync, R: Send, E>(
    items: &[T],
    threads: NonZeroUsize,
    work: impl Fn(&T) -> R + Sync,
    mut each: impl FnMut(&T, Option<R>) -> Result<(), E>,
) -> Result<(), E> {
    let next = AtomicUsize::new(0);
    let work = |item: &T| catch_unwind(AssertUnwindSafe(|| work(item))).ok();
    let (results, arrived) = mpsc::channel();
    thread::scope(|scope| {
        let mut workers = 0;
        while threads.get() > 1 && workers < threads.get().min(items.len()) {
            let (results, next, work) = (results.clone(), &next, &work);
            let worker = move || {
                while let Some((i, item)) = take(items, next) {
                    if results.send((i, work(item))).is_err() {
                        return;
                    }
                }
            };
            if thread::Builder::new().spawn_scoped(scope, worker).is_err() {
                break;
            }
            workers += 1;
        }
        drop(results);
        if workers == 0 {
            return items.iter().try_for_each(|item| each(item, work(item)));
        }
        let mut early = BTreeMap::new();
        let mut wanted = 0;
        for (i, result) in &arrived {
            early.insert(i, result);
            while let Some(result) = early.remove(&wanted) {
                if let Err(error) = each(&items[wanted], result) {
                    // Nobody wants the rest.
                    next.store(items.len(), Ordering::Relaxed);
                    return Err(error);
                }
                wanted += 1;
            }
        }
        Ok(())
    })
}

/// The next item that nobody works on.
fn take<'i, T>(items: &'i [T], next: &AtomicUsize) -> Option<(usize, &'i T)> {
    let i = next.fetch_add(1, Ordering::Relaxed);
    items.get(i).map(|item| (i, item))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_and_a_panic_costs_only_its_own() {
        std::panic::set_hook(Box::new(|_| {}));
        let items: Vec<u32> = (0..200).collect();
        let work = |&i: &u32| {
            assert!(i != 77, "planted");
            std::thread::sleep(std::time::Duration::from_micros(u64::from(i * 37 % 50)));
            i * 2
        };
        let want: Vec<_> = items.iter().map(|&i| (i, (i != 77).then_some(i * 2))).collect();
        for threads in [1, 2, 7, 300] {
            let mut got = Vec::new();
            let threads = NonZeroUsize::new(threads).unwrap();
            let done: Result<(), ()> = in_order(&items, threads, work, |&i, r| {
                got.push((i, r));
                Ok(())
            });
            assert!(done.is_ok());
            assert_eq!(got, want);
        }
    }

    #[test]
    fn an_error_ends_the_work() {
        let items: Vec<u32> = (0..100).collect();
        let done = in_order(
            &items,
            NonZeroUsize::MIN,
            |&i| i,
            |_, r| if r == Some(3) { Err("enough") } else { Ok(()) },
        );
        assert_eq!(done, Err("enough"));
    }
}
