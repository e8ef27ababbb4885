//! Texts that this thread has set, kept for the next time.
//!
//! A figure's texts are set for its plan and again for its picture, those of one that moves for every
//! frame: of the time of a frame that was a third. What is kept is a pure function of the markup and its
//! style, so no run can tell the difference; and it is bounded.

use std::cell::RefCell;
#[cfg(not(tracefig_page))]
use std::collections::BTreeSet;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

use super::line::{Line, Style, TypesetError, Weight};
use super::paragraph::{Newlines, Paragraph};

/// Glyphs in all texts that are kept, about; a page has a few thousand.
const MOST_GLYPHS: usize = 20_000;

/// Lines of how many widths are kept of a text.
const MOST_WIDTHS: usize = 4;

/// All that a text depends on.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    /// The markup.
    markup: String,
    /// Page pixels of an em, as bits.
    size: u64,
    /// Whether the words are semibold.
    is_semibold: bool,
    /// What newlines mean.
    newlines: Newlines,
}

/// A text that is set, with the lines that were made of it.
pub(crate) struct Kept {
    /// The text.
    paragraph: Paragraph,
    /// Its lines in some widths, as bits.
    lines: RefCell<Vec<(u64, Vec<Arc<Line>>)>>,
}

/// The texts of this thread.
#[derive(Default)]
struct Texts {
    /// Every text that was set so far.
    all: HashMap<Key, Rc<Kept>>,
    /// The number of their glyphs.
    glyphs: usize,
}

// All texts that this thread sets while someone listens, drawn in the end or not.
#[cfg(not(tracefig_page))]
thread_local! { static SAID: RefCell<Option<BTreeSet<String>>> = const { RefCell::new(None) }; }

thread_local! { static TEXTS: RefCell<Texts> = RefCell::default(); }

/// Every text that is set while something is done, drawn in the end or not.
#[cfg(not(tracefig_page))]
pub(crate) fn said(act: impl FnOnce()) -> BTreeSet<String> {
    SAID.set(Some(BTreeSet::new()));
    act();
    SAID.take().unwrap_or_default()
}

/// Sets `markup` to be broken into lines, as [`wrap`](super::wrap) breaks it.
pub(crate) fn paragraph(markup: &str, style: Style) -> Result<Rc<Kept>, TypesetError> {
    kept(markup, style, Newlines::Breaks)
}

/// Sets `markup` on one line, as [`typeset`](super::typeset) does.
pub(crate) fn line(markup: &str, style: Style) -> Result<Arc<Line>, TypesetError> {
    let first = kept(markup, style, Newlines::Spaces)?.lines(f64::INFINITY).into_iter().next();
    Ok(first.unwrap_or_else(|| Arc::new(Line::empty(markup, style))))
}

impl Kept {
    /// Lines of at most `width` page pixels; a word or formula that is wider has a line of its own.
    pub(crate) fn lines(&self, width: f64) -> Vec<Arc<Line>> {
        let mut known = self.lines.borrow_mut();
        if let Some((_, lines)) = known.iter().find(|(bits, _)| *bits == width.to_bits()) {
            return lines.clone();
        }
        let lines: Vec<Arc<Line>> = self.paragraph.lines(width).into_iter().map(Arc::new).collect();
        if known.len() == MOST_WIDTHS {
            known.remove(0);
        }
        known.push((width.to_bits(), lines.clone()));
        lines
    }

    /// How many lines of at most `width` page pixels it takes, and how wide the widest is.
    pub(crate) fn extent(&self, width: f64) -> (usize, f64) {
        self.paragraph.extent(width)
    }
}

/// A text, set now or before.
fn kept(markup: &str, style: Style, newlines: Newlines) -> Result<Rc<Kept>, TypesetError> {
    #[cfg(not(tracefig_page))]
    SAID.with_borrow_mut(|said| said.as_mut().map(|said| said.insert(markup.to_owned())));
    let is_semibold = style.weight == Weight::Semibold;
    let key = Key { markup: markup.to_owned(), size: style.size.to_bits(), is_semibold, newlines };
    TEXTS.with_borrow_mut(|texts| {
        if let Some(kept) = texts.all.get(&key) {
            return Ok(Rc::clone(kept));
        }
        let paragraph = Paragraph::of(markup, style, newlines)?;
        let glyphs = texts.glyphs + 1 + paragraph.glyphs();
        let kept = Rc::new(Kept { paragraph, lines: RefCell::default() });
        if glyphs > MOST_GLYPHS {
            *texts = Texts::default();
        } else {
            texts.glyphs = glyphs;
            texts.all.insert(key, Rc::clone(&kept));
        }
        Ok(kept)
    })
}

#[cfg(test)]
mod tests {
    use super::super::{typeset, wrap};
    use super::*;

    #[test]
    fn what_is_kept_is_what_is_set_afresh() {
        let style = Style::semibold(14.0);
        for text in ["A moves along $v_A$, and\n first touches {b|B} as A′.", "", " \n ", "$x$"] {
            for _ in 0..2 {
                assert_eq!(*line(text, style).unwrap(), typeset(text, style).unwrap());
                for width in [10.0, 60.0, 100.0, 300.0, 900.0, f64::INFINITY] {
                    let lines = paragraph(text, style).unwrap().lines(width);
                    let again = wrap(text, style, width).unwrap();
                    assert!(lines.iter().map(|line| &**line).eq(&again), "{text:?} in {width}");
                    let widest = again.iter().map(|line| line.width).fold(0.0, f64::max);
                    assert_eq!(paragraph(text, style).unwrap().extent(width), (again.len(), widest));
                }
            }
        }
    }

    #[test]
    fn texts_are_kept_up_to_a_bound() {
        let style = Style::regular(10.0);
        for i in 0..3000 {
            line(&format!("the text of number {i}"), style).unwrap();
            TEXTS.with_borrow(|texts| assert!(texts.glyphs <= MOST_GLYPHS && texts.all.len() <= MOST_GLYPHS));
        }
    }
}
