//! Which panels stand in which row: they follow each other from left to right, each as many columns wide as
//! it asks for, and one that has no room beside those before it begins a row.

use std::ops::Range;

/// The columns that a panel takes which asks for some, of those that there are.
pub(super) fn taken(asked: usize, columns: usize) -> usize {
    asked.clamp(1, columns.max(1))
}

/// The panels of each row, by their place among all, which ask for so many columns each; one row where there
/// is none.
pub(super) fn rows(asked: &[usize], columns: usize) -> Vec<Range<usize>> {
    let (mut rows, mut first, mut full) = (Vec::new(), 0, 0);
    for (i, &asked) in asked.iter().enumerate() {
        let wide = taken(asked, columns);
        if full + wide > columns && i > first {
            rows.push(first..i);
            (first, full) = (i, 0);
        }
        full += wide;
    }
    rows.push(first..asked.len());
    rows
}

/// The numbers of columns that suit panels, the fewest first. One that leaves a row nearly empty does not,
/// nor one that would make panels as wide as each other that ask for different widths.
pub(super) fn suited(asked: &[usize]) -> impl DoubleEndedIterator<Item = usize> + Clone {
    let widest = asked.iter().copied().max().unwrap_or(1).max(1);
    let all: usize = asked.iter().map(|asked| (*asked).max(1)).sum();
    // Rows do not get more as columns do.
    let is_even = move |&columns: &usize| {
        columns == widest || rows(asked, columns).len() < rows(asked, columns - 1).len()
    };
    (widest..=all.max(1)).filter(is_even)
}

/// Whether every row is full of panels that ask for so many columns each.
pub(super) fn is_full(asked: &[usize], columns: usize) -> bool {
    let wide = |row: Range<usize>| asked[row].iter().map(|asked| taken(*asked, columns)).sum::<usize>();
    rows(asked, columns).into_iter().all(|row| wide(row) == columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_without_room_beside_the_others_begins_a_row() {
        assert_eq!(rows(&[1, 2], 2), [0..1, 1..2]);
        assert_eq!(rows(&[2, 1], 2), [0..1, 1..2]);
        assert_eq!(rows(&[1, 1, 1, 2], 3), [0..3, 3..4]);
        assert_eq!(rows(&[2, 1, 1, 2], 3), [0..2, 2..4]);
        assert_eq!(rows(&[1, 1, 2], 1), [0..1, 1..2, 2..3], "there is but one");
        assert_eq!(rows(&[], 3).len(), 1);
    }

    #[test]
    fn numbers_of_columns_that_leave_a_row_nearly_empty_are_none() {
        let of = |asked: &[usize]| suited(asked).collect::<Vec<_>>();
        assert_eq!(of(&[1; 4]), [1, 2, 4]);
        assert_eq!(of(&[1; 6]), [1, 2, 3, 6]);
        assert_eq!(of(&[1, 1, 2]), [2, 4]);
        assert_eq!(of(&[1, 1, 1, 2]), [2, 3, 5]);
        assert_eq!((of(&[]), of(&[2])), (vec![1], vec![2]));
    }

    #[test]
    fn rows_are_full_where_nothing_is_left_beside_a_panel() {
        assert!(is_full(&[1, 1, 2], 2) && is_full(&[2, 1, 1, 2], 3) && is_full(&[1, 2, 1], 1));
        assert!(!is_full(&[1, 2], 2) && !is_full(&[1; 3], 2));
    }
}
