//! Steps in an SVG: all in one document, in groups that say which steps show them.
//!
//! `data-step` is the first step that shows a group, `data-until` the step that takes it away. What stands
//! outside of such groups is always there. Without a page that acts on it the whole figure shows: what a step
//! took away has opacity 0, which a style sheet overrides.

use super::{Document, searchable};
use crate::drawing::{Drawing, Item, Shown};
use crate::output::xml::Xml;
use crate::output::{InSteps, Options, OutputError, validity};

/// The attribute with the first step that shows a group.
pub(in crate::output) const SINCE: &str = "data-step";
/// The attribute with the step that takes a group away.
pub(in crate::output) const UNTIL: &str = "data-until";

/// Writes a drawing with all its steps.
pub(super) fn write(drawing: &Drawing, _: &Options, in_steps: InSteps) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    Ok(searchable(drawing, Some(in_steps)).into_bytes())
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
            let groups = open_groups(&mut self.xml, own, in_steps);
            let outer = std::mem::replace(&mut self.shown, own);
            self.all(together);
            self.shown = outer;
            (0..groups).for_each(|_| self.xml.end());
        }
    }
}

/// Opens the groups of what some steps show, and says how many: a fragment either comes or goes. What is
/// there from the start does not come.
pub(super) fn open_groups(xml: &mut Xml, shown: Shown, in_steps: InSteps) -> usize {
    xml.start("g");
    xml.attribute(SINCE, &shown.since.to_string());
    if let Some(until) = shown.until {
        xml.attribute(UNTIL, &until.to_string());
        xml.attribute("opacity", "0");
    }
    if !in_steps.fragments {
        return 1;
    }
    let comes = (shown.since > 1).then_some(("fragment", shown.since));
    let goes = shown.until.map(|until| ("fragment fade-out", until));
    for (group, (class, step)) in (1..).zip(comes.into_iter().chain(goes)) {
        if group > 1 {
            xml.start("g");
        }
        xml.attribute("class", class);
        // Fragments count from 0, and the first step is there before them.
        xml.attribute("data-fragment-index", &step.saturating_sub(2).to_string());
    }
    if comes.is_some() && goes.is_some() { 2 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::everything;

    #[test]
    fn a_fragment_comes_goes_or_does_both_and_what_is_there_from_the_start_only_goes() {
        let opened = |since: usize, until: Option<usize>| {
            let mut drawing = everything();
            drawing.items.truncate(1);
            drawing.items[0].for_each_shown(&|shown| *shown = Shown { since, until });
            let in_steps = InSteps { fragments: true, ..InSteps::default() };
            let text = String::from_utf8(write(&drawing, &Options::default(), in_steps).unwrap()).unwrap();
            assert_eq!(text.matches("<g").count(), text.matches("</g>").count(), "{text}");
            let begin = text.find("<g data-step").unwrap();
            text[begin..].split_inclusive('>').take(2).map(str::trim).collect::<String>()
        };
        let come = "class=\"fragment\" data-fragment-index=\"1\">";
        let go = "class=\"fragment fade-out\" data-fragment-index=\"3\">";
        let at = |since: usize| format!("<g data-step=\"{since}\" data-until=\"5\" opacity=\"0\"");
        assert!(opened(3, None).starts_with(&format!("<g data-step=\"3\" {come}")));
        assert!(opened(3, Some(5)).starts_with(&format!("{} {come}<g {go}", at(3))));
        assert!(opened(1, Some(5)).starts_with(&format!("{} {go}", at(1))));
    }
}
