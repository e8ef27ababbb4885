//! What each step of a figure says, below its picture: for an animation or a picture that stands alone, where
//! no page tells it.

use std::sync::Arc;

use crate::drawing::{Drawing, Group, Item, Point, Role, Shown, Step};
use crate::typeset::{Line, Style, TypesetError, as_markup, paragraph};

use super::lettering::lettered;
use super::plan::Plan;
use super::text::with_powers;
use super::theme::Theme;

impl Plan<'_> {
    /// A drawing in steps with a strip below it in which each step says its number, its title and its
    /// sentences; the strip has room for the longest, so that nothing moves. The drawing as it is where it
    /// has no steps, or where the fonts lack a letter.
    ///
    /// ```
    /// use tracefig::{figure::{draw_in_steps, plan}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// shapes.B = { kind = "circle", radius = 1, position = [3, 1] }
    /// query = { kind = "separation", of = ["A", "B"] }
    /// "#;
    /// let scene = read(&Source::new("circles.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let bare = draw_in_steps(&plan, plan.theme, "circles").drawing;
    /// let told = plan.with_words_below(bare.clone(), plan.theme);
    /// assert!(told.height >= bare.height && told.items.len() > bare.items.len());
    /// ```
    #[must_use]
    pub fn with_words_below(&self, mut drawing: Drawing, theme: &Theme) -> Drawing {
        let (measures, left) = (&self.layout.measures, self.page.caption.x);
        let size = measures.caption_size();
        let width = measures.caption_measure().min(drawing.width - 2.0 * left);
        let count = drawing.steps.len();
        let set = |(k, step): (usize, &Step)| lines((k, count), step, (size, width));
        let Ok(all) = (1..).zip(&drawing.steps).map(set).collect::<Result<Vec<_>, _>>() else {
            return drawing;
        };
        let most = all.iter().map(Vec::len).max().unwrap_or_default();
        if most == 0 {
            return drawing;
        }
        // What the figure came to stands in its last step.
        let first = if self.caption.is_answer {
            drawing.items.pop();
            self.page.caption.y
        } else {
            drawing.height + size
        };
        let height = first + room(most) * measures.step();
        drawing.height = drawing.height.max(height);
        for (k, lines) in (1..).zip(all) {
            let mut group = Group::new("said");
            let mut y = first;
            for line in &lines {
                group.items.extend(lettered(line, Point::new(left, y), Role::Ink, (theme, None)));
                y += measures.step();
            }
            let mut item = Item::Group(group);
            let until = (k < count).then_some(k + 1);
            item.for_each_shown(&|shown| *shown = Shown { since: k, until });
            drawing.items.push(item);
        }
        drawing
    }
}

/// The lines of a step: its number among all and its title, in bold, then its sentences.
fn lines(
    (k, count): (usize, usize),
    step: &Step,
    (size, width): (f64, f64),
) -> Result<Vec<Arc<Line>>, TypesetError> {
    // An equation stays in one line.
    let whole = |words: &str| words.replace(" = ", "\u{a0}=\u{a0}");
    let set = |words: &str, style: Style| {
        Ok(paragraph(&with_powers(&as_markup(&whole(words))), style)?.lines(width))
    };
    let title = set(&format!("{k} / {count} · {}", step.title), Style::semibold(size))?;
    let said = set(&step.sentences.join(" "), Style::regular(size))?;
    Ok(title.into_iter().chain(said).collect())
}

/// How many lines there is room for, as a length.
fn room(lines: usize) -> f64 {
    u32::try_from(lines).map_or(0.0, f64::from)
}
