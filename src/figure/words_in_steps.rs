//! When titles and captions come in a figure in steps: with what they are about, so that none tells what is
//! to come.
//!
//! A panel's caption comes with the panel's last mark, as it tells of all of them, and so does a title that
//! writes a value; another title of a panel without bodies comes with the first of its marks. The caption of
//! the figure comes at once, or last where it writes a value.

use crate::drawing::Item;

use super::plan::Plan;
use super::steps::{Scope, collect};

/// How a value begins in a text.
const VALUE: &str = "{=";
/// The title of a panel.
const TITLE: &str = "title";
/// Its caption.
const CAPTION: &str = "caption";

/// Lets the titles and captions of the panels, and the caption of the figure, which is the last item, come in
/// a figure of `count` steps.
pub(super) fn let_words_come(items: &mut [Item], scopes: &[Scope], plan: &Plan, count: usize) {
    for (i, scope) in scopes.iter().enumerate() {
        let own = &mut items[scope.items.clone()];
        let is_words = |item: &Item| is(item, TITLE) || is(item, CAPTION);
        let mut marks = Vec::new();
        own.iter().filter(|item| !is_words(item)).for_each(|item| collect(item, &mut marks));
        let Some(&last) = marks.last() else { continue };
        // Marks that are there from the start are what is given.
        let first = marks.into_iter().find(|&since| since > 1);
        // As the scene writes it, its values not filled in; ours have none, and tell nothing.
        let title = match plan.scene.panels.get(i).and_then(|panel| panel.title.as_ref()) {
            Some(title) if title.value.contains(VALUE) => Some(last),
            Some(_) if !scope.shows_bodies => first,
            _ => None,
        };
        let caption = plan.scene.panels.get(i).and_then(|panel| panel.caption.as_ref());
        // Where it tells no number it leads through what becomes of the bodies.
        let leads = scope.shows_bodies && caption.is_some_and(|caption| !caption.value.contains(VALUE));
        let caption = if leads { first.or(Some(last)) } else { Some(last) };
        let when = |item: &Item| if is(item, CAPTION) { caption } else { title };
        for item in own.iter_mut().filter(|item| is_words(item)) {
            if let Some(since) = when(item) {
                come(item, since);
            }
        }
    }
    let tells = plan.scene.caption.as_ref().is_some_and(|text| text.value.contains(VALUE));
    if let Some(caption) = items.last_mut().filter(|_| tells || plan.caption.is_answer) {
        come(caption, count.max(1));
    }
}

/// Whether an item is the words of a panel that are called so.
fn is(item: &Item, words: &str) -> bool {
    matches!(item, Item::Group(group) if group.name == words)
}

/// Lets all of an item come with a step.
fn come(item: &mut Item, since: usize) {
    item.for_each_shown(&|shown| shown.since = since);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{draw_in_steps, plan};
    use crate::scene::open_text;

    #[test]
    fn no_caption_tells_what_is_still_to_come() {
        let comes = |caption: &str, title: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-3, 0], [3, -2], [1, 2]] }}
                shapes.B = {{ kind = 'polygon', vertices = [[2, 5], [6, 2], [5, 5]] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
                caption = '{caption}'
                panels = [{{ space = 'configuration', caption = 'two of them',
                    title = '{title}', layers = [
                        {{ layer = 'simplex', step = 1 }}, {{ layer = 'simplex', step = 2 }}] }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let drawing = draw_in_steps(&plan, plan.theme, "s").drawing;
            let since = |items: &[Item], words: &str| {
                let mut steps = Vec::new();
                items.iter().filter(|item| is(item, words)).for_each(|item| collect(item, &mut steps));
                steps
            };
            let (whole, panels) = drawing.items.split_last().unwrap();
            let panel = [since(panels, TITLE), since(panels, CAPTION)];
            (panel, since(std::slice::from_ref(whole), CAPTION), drawing.steps.len())
        };
        let (panel, whole, count) = comes("all", "two");
        assert_eq!(panel, [[2], [3]], "with the first simplex, and with the second");
        assert_eq!(whole, [1], "at once");
        assert!(count >= 3, "{count}");
        let (panel, whole, _) = comes("they are {=separation} apart", "{=separation} apart");
        assert_eq!((panel, whole), ([vec![3], vec![3]], vec![count]));
    }
}
