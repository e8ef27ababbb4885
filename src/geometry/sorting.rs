//! Sorting, in machine code that is there once for all kinds of items.
//!
//! The standard library's is made anew for each kind and each comparison, with 5 kB each time, of the module
//! that live pages load a twentieth. Here numbers are sorted by a comparison of what they stand for, and the
//! items then follow the cycles of that permutation (Knuth, *The Art of Computer Programming* 1, 1.3.3).

use std::cmp::Ordering;

/// Sorts items; equal ones stay in their order.
pub(crate) fn sort_by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let mut from = sorted(items.len(), &|i, j| compare(&items[i], &items[j]));
    for start in 0..from.len() {
        let mut to = start;
        while from[to] != start {
            let next = std::mem::replace(&mut from[to], to);
            items.swap(to, next);
            to = next;
        }
        from[to] = to;
    }
}

/// The numbers below `count` in the order of what they stand for.
pub(crate) fn sorted(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    numbers.sort_by(|&i, &j| compare(i, j));
    numbers
}

/// Puts a number among others in their order, where it is not there yet.
pub(crate) fn insert_in_order(numbers: &mut Vec<usize>, number: usize) {
    if let Err(at) = numbers.binary_search(&number) {
        numbers.insert(at, number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_their_order_once_each() {
        let mut all = Vec::new();
        for number in [5, 2, 9, 2, 0, 5] {
            insert_in_order(&mut all, number);
        }
        assert_eq!(all, [0, 2, 5, 9]);
    }

    #[test]
    fn items_are_sorted_as_the_standard_library_sorts_them() {
        for count in 0..60_u32 {
            // Keys that meet often, each with its place.
            let items: Vec<(u32, u32)> = (0..count).map(|i| (i * i * 7 % 11, i)).collect();
            let (mut ours, mut theirs) = (items.clone(), items);
            sort_by(&mut ours, |a, b| a.0.cmp(&b.0));
            theirs.sort_by_key(|item| item.0);
            assert_eq!(ours, theirs);
        }
    }
}
