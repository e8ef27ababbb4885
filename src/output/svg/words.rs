//! Words that are found and copied: text without ink over the outlines that are seen.
//!
//! A browser finds, marks and copies text by its characters, which outlines do not have. So each line stands
//! once more as `<text>`, stretched to the width that its outlines take; nothing fills or strokes it. Those
//! who listen hear the title and the description, and not these parts of them again. A picture that a page
//! holds as an image can't be searched, and goes without.

use super::number;
use super::steps::open_groups;
use crate::drawing::{Drawing, Item, Shown, Text};
use crate::output::InSteps;
use crate::output::xml::Xml;

/// How far apart two stretches of a line may be, in ems of their letters: the width of a wide blank.
const BLANK: f64 = 0.6;

/// A line as it is read.
#[derive(Clone, Debug, PartialEq)]
struct Words {
    /// What it says.
    text: String,
    /// Page pixels from the page's left edge to its beginning and to its end.
    x: [f64; 2],
    /// Page pixels from the page's top edge to its baseline.
    y: f64,
    /// Page pixels of an em of its largest letters.
    size: f64,
    /// Which steps show it.
    shown: Shown,
}

/// The words of a text at its place; none where it has no letters.
fn of_text(Text { line, origin, shown, .. }: &Text) -> Option<Words> {
    let (first, last) = (line.runs.first()?, line.runs.last()?);
    let text: String = line.runs.iter().map(|run| run.text.as_str()).collect();
    let x = [origin.x + first.x[0], origin.x + last.x[1]];
    let size = line.runs.iter().map(|run| run.size).fold(0.0, f64::max);
    (!text.trim().is_empty() && x[1] > x[0]).then_some(Words { text, x, y: origin.y, size, shown: *shown })
}

/// Adds the words of items to those before; a stretch that goes on a line is part of it.
fn collect(items: &[Item], all: &mut Vec<Words>) {
    for item in items {
        match item {
            Item::Group(group) => collect(&group.items, all),
            Item::Path(_) => {}
            Item::Text(text) => {
                let Some(words) = of_text(text) else { continue };
                match all.last_mut().filter(|line| goes_on(line, &words)) {
                    Some(line) => {
                        line.text.push_str(&words.text);
                        line.x[1] = words.x[1];
                    }
                    None => all.push(words),
                }
            }
        }
    }
}

/// Whether words stand right behind others on one line.
fn goes_on(line: &Words, next: &Words) -> bool {
    let gap = next.x[0] - line.x[1];
    line.shown == next.shown
        && line.y.total_cmp(&next.y).is_eq()
        && line.size.total_cmp(&next.size).is_eq()
        && gap > -0.1 * line.size
        && gap < BLANK * line.size
}

/// The words of a drawing as an element, those of a step and of a size together; empty where it has none.
pub(crate) fn found_words(drawing: &Drawing, in_steps: Option<InSteps>) -> String {
    let mut all = Vec::new();
    collect(&drawing.items, &mut all);
    if all.is_empty() {
        return String::new();
    }
    let mut xml = Xml::default();
    xml.start("g");
    xml.attribute("aria-hidden", "true");
    xml.attribute("font-family", "sans-serif");
    xml.attribute("pointer-events", "all");
    // A figure without steps does not know of them.
    for together in all.chunk_by(|a, b| in_steps.is_none() || a.shown == b.shown) {
        let in_steps = in_steps.filter(|_| together[0].shown != Shown::ALWAYS);
        let groups = in_steps.map_or(0, |in_steps| open_groups(&mut xml, together[0].shown, in_steps));
        for of_size in together.chunk_by(|a, b| a.size.total_cmp(&b.size).is_eq()) {
            xml.start("g");
            xml.number("font-size", of_size[0].size);
            for words in of_size {
                line_of_words(&mut xml, words);
            }
            xml.end();
        }
        (0..groups).for_each(|_| xml.end());
    }
    xml.finish()
}

/// Writes a line, in tenths of a pixel: what is marked need not be sharper.
fn line_of_words(xml: &mut Xml, Words { text, x: [from, to], y, .. }: &Words) {
    xml.start("text");
    let tenths = |value: f64| (10.0 * value).round() / 10.0;
    for (name, value) in [("x", *from), ("y", *y), ("textLength", to - from)] {
        xml.attribute_by(name, |out| number::push(out, tenths(value)));
    }
    xml.text(text.trim_end());
    xml.end();
}

#[cfg(test)]
mod tests {
    use super::super::{Sheet, document, searchable};
    use crate::output::InSteps;
    use crate::output::samples::everything;

    #[test]
    fn every_line_stands_once_without_ink_as_wide_as_its_outlines() {
        let drawing = everything();
        let page = searchable(&drawing, None);
        let parsed = roxmltree::Document::parse(&page).unwrap();
        let texts: Vec<_> = parsed
            .descendants()
            .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")))
            .collect();
        let said: Vec<&str> = texts.iter().filter_map(roxmltree::Node::text).collect();
        for line in ["distance = ‖D‖ − r = 3/2", "Ærø Ωμέγα Жизнь", "clamped V_x"] {
            assert_eq!(said.iter().filter(|text| **text == line).count(), 1, "{said:?}");
        }
        for node in texts {
            let hidden = node.ancestors().any(|node| node.attribute("aria-hidden") == Some("true"));
            // The root fills nothing, and nothing between it and the text says otherwise.
            let ink = node.ancestors().filter_map(|node| node.attribute("fill").or(node.attribute("stroke")));
            assert!(hidden && ink.eq(["none"]), "{:?}", node.text());
            assert!(node.attribute("textLength").unwrap().parse::<f64>().unwrap() > 1.0);
        }
        let alone = document(&drawing, Sheet::Inside);
        assert!(!alone.contains("<text") && page.len() - alone.len() < alone.len() / 10);
        assert!(searchable(&drawing, Some(InSteps::default())).contains("<text"));
    }
}
