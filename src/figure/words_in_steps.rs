//! When captions come in a figure in steps: with what they are about, so that none tells what is to come.
//!
//! A panel's caption comes with the panel's last mark, as it tells of all of them. The caption of the figure
//! comes at once, or last where it writes a value.

use std::collections::BTreeSet;

use crate::drawing::Item;

use super::plan::Plan;
use super::steps::{Scope, collect};

/// How a value begins in a text.
const VALUE: &str = "{=";

/// Lets the captions of the panels, and of the figure, which is the last item, come in a figure of `count`
/// steps.
pub(super) fn let_captions_come(items: &mut [Item], scopes: &[Scope], plan: &Plan, count: usize) {
    for (scope, panel) in scopes.iter().zip(&plan.panels) {
        if panel.source.caption.is_none() {
            continue;
        }
        let own = &mut items[scope.items.clone()];
        let mut marks = BTreeSet::new();
        own.iter().filter(|item| !is_caption(item)).for_each(|item| collect(item, &mut marks));
        if let Some(&since) = marks.last() {
            own.iter_mut().filter(|item| is_caption(item)).for_each(|item| come(item, since));
        }
    }
    let tells = plan.scene.caption.as_ref().is_some_and(|text| text.value.contains(VALUE));
    if let Some(caption) = items.last_mut().filter(|_| tells || plan.caption.is_answer) {
        come(caption, count.max(1));
    }
}

/// Whether an item is the caption of a panel.
fn is_caption(item: &Item) -> bool {
    matches!(item, Item::Group(group) if group.name == "caption")
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
        let comes = |caption: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-3, 0], [3, -2], [1, 2]] }}
                shapes.B = {{ kind = 'polygon', vertices = [[2, 5], [6, 2], [5, 5]] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'gjk' }}
                caption = '{caption}'
                panels = [{{ space = 'configuration', caption = 'two of them',
                    layers = [{{ layer = 'simplex', step = 1 }}, {{ layer = 'simplex', step = 2 }}] }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let drawing = draw_in_steps(&plan, plan.theme, "s").drawing;
            let since = |items: &[Item]| {
                let mut steps = BTreeSet::new();
                items.iter().filter(|item| is_caption(item)).for_each(|item| collect(item, &mut steps));
                steps.into_iter().collect::<Vec<_>>()
            };
            let (whole, panels) = drawing.items.split_last().unwrap();
            (since(panels), since(std::slice::from_ref(whole)), drawing.steps.len())
        };
        let (panel, whole, count) = comes("all");
        assert_eq!((panel, whole), (vec![3], vec![1]), "with the second simplex, and at once");
        assert!(count >= 3, "{count}");
        let (panel, whole, _) = comes("they are {=separation} apart");
        assert_eq!((panel, whole), (vec![3], vec![count]));
    }
}
