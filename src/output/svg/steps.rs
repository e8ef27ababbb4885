//! Steps in an SVG: all in one document, in groups that say which steps show them.
//!
//! `data-step` is the first step that shows a group, `data-until` the step that takes it away. What stands
//! outside of such groups is always there. Without a page that acts on it the whole figure shows: what a step
//! took away has opacity 0, which a style sheet overrides.

use super::{Document, Sheet, document_in_steps};
use crate::drawing::{Drawing, Item, Shown};
use crate::output::{InSteps, Options, OutputError, validity};

/// The attribute with the first step that shows a group.
pub(in crate::output) const SINCE: &str = "data-step";
/// The attribute with the step that takes a group away.
pub(in crate::output) const UNTIL: &str = "data-until";

/// Writes a drawing with all its steps.
pub(super) fn write(drawing: &Drawing, _: &Options, in_steps: InSteps) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    Ok(document_in_steps(drawing, Sheet::Inside, Some(in_steps)).into_bytes())
}

/// Which steps show an item; none where its parts differ.
fn shown(item: &Item) -> Option<Shown> {
    match item {
        Item::Group(group) => one(&group.items),
        Item::Path(_) | Item::Text(_) => Some(item.shown()),
    }
}

/// Which steps show items; none where they differ, or there are none.
fn one(items: &[Item]) -> Option<Shown> {
    let (first, rest) = items.split_first()?;
    let first = shown(first)?;
    rest.iter().all(|item| shown(item) == Some(first)).then_some(first)
}

/// Whether the same steps show all items.
pub(super) fn is_of_one(items: &[Item]) -> bool {
    one(items).is_some()
}

impl Document {
    /// Writes items, those that come and go together in a group of their own.
    pub(super) fn stepwise(&mut self, items: &[Item], in_steps: InSteps) {
        for together in items.chunk_by(|a, b| shown(a) == shown(b)) {
            let own = together.first().and_then(shown).filter(|own| *own != self.shown);
            let Some(own) = own else {
                self.all(together);
                continue;
            };
            let groups = self.open_groups(own, in_steps);
            let outer = std::mem::replace(&mut self.shown, own);
            self.all(together);
            self.shown = outer;
            (0..groups).for_each(|_| self.xml.end());
        }
    }

    /// Opens the groups of what some steps show, and says how many: a fragment either comes or goes.
    fn open_groups(&mut self, shown: Shown, in_steps: InSteps) -> usize {
        self.xml.start("g");
        self.xml.attribute(SINCE, &shown.since.to_string());
        if let Some(until) = shown.until {
            self.xml.attribute(UNTIL, &until.to_string());
            self.xml.attribute("opacity", "0");
        }
        if !in_steps.fragments {
            return 1;
        }
        // Fragments count from 0, and the first step is there before them.
        let index = |step: usize| step.saturating_sub(2).to_string();
        self.xml.attribute("class", "fragment");
        self.xml.attribute("data-fragment-index", &index(shown.since));
        let Some(until) = shown.until else { return 1 };
        self.xml.start("g");
        self.xml.attribute("class", "fragment fade-out");
        self.xml.attribute("data-fragment-index", &index(until));
        2
    }
}
