//! A long name on two or three lines, as short as they can be.

use std::sync::Arc;

use crate::typeset::{Line, Style, wrap};

/// A name that is shorter than this, in ems, stays on one line: a word of eight letters.
const SHORT: f64 = 4.0;
/// Most lines of a name; with more it would be read as a paragraph.
const MOST: usize = 3;
/// Lines are as short as they can be up to this, in ems.
const STEP: f64 = 0.25;

/// The ways to set a line on two lines and on three, broken at spaces; none where it has no space, or is
/// short.
pub(super) fn folds(line: &Line, style: Style) -> Vec<Vec<Arc<Line>>> {
    let mut all: Vec<Vec<Arc<Line>>> = Vec::new();
    if line.width < SHORT * style.size {
        return all;
    }
    let set = |width: f64| wrap(&line.markup, style, width).unwrap_or_default();
    for most in 2..=MOST {
        // The least width that keeps to so many lines.
        let (mut narrow, mut wide) = (0.0, line.width);
        while wide - narrow > STEP * style.size {
            let middle = 0.5 * (narrow + wide);
            if set(middle).len() <= most { wide = middle } else { narrow = middle }
        }
        let lines = set(wide);
        if lines.len() == most {
            all.push(lines.into_iter().map(Arc::new).collect());
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::typeset::typeset;

    fn widths(markup: &str) -> Vec<Vec<f64>> {
        let style = Style::regular(17.0);
        let folds = folds(&typeset(markup, style).unwrap(), style);
        folds.iter().map(|lines| lines.iter().map(|line| line.width).collect()).collect()
    }

    #[test]
    fn a_long_name_is_folded_at_its_spaces_into_lines_of_like_width() {
        let whole = typeset("the left crate (dynamic)", Style::regular(17.0)).unwrap().width;
        let [two, three] = &widths("the left crate (dynamic)")[..] else { panic!("two ways") };
        assert!(two.len() == 2 && three.len() == 3);
        assert!(two.iter().all(|&w| w < 0.65 * whole) && three.iter().all(|&w| w < 0.5 * whole));
        assert_eq!(widths(r"ground plane $\ominus$ crate").len(), 2);
    }

    #[test]
    fn a_name_that_is_short_or_one_word_has_one_line() {
        assert!(widths("a b c").is_empty() && widths("unbreakableletters").is_empty());
        assert_eq!(widths("unbreakable letters").len(), 1, "two words make two lines at most");
    }
}
