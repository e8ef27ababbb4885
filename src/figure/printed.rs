//! Titles, headline and captions as items of the page, each line at its baseline.

use crate::drawing::{Group, Item, Point, Role};

use super::lettering::{Lettering, lettered};
use super::panel::PanelPlan;
use super::placement::Labelled;
use super::plan::Plan;
use super::text::Across;
use super::theme::Theme;

/// The title over a panel, from its left edge on, as the headline and the captions are set.
pub(super) fn title(text: &Lettering, plan: &Plan, panel: &Labelled, theme: &Theme) -> Item {
    let lines = text.of(theme);
    let mut group = Group::new("title");
    for (line, origin) in lines.iter().zip(plan.page.title_baselines(&panel.frame.panel, lines.len())) {
        group.items.extend(lettered(line, origin, Role::Ink, (theme, None)));
    }
    Item::Group(group)
}

/// The caption below a panel, from its left edge on; none where it has none.
pub(super) fn under(of: &PanelPlan, plan: &Plan, panel: &Labelled, theme: &Theme) -> Option<Item> {
    let mut group = Group::new("caption");
    group.label = Some(of.caption_words.clone()?);
    for (line, origin) in of.caption.of(theme).iter().zip(plan.page.caption_baselines(&panel.frame.panel)) {
        group.items.extend(lettered(line, origin, Role::Ink, (theme, None)));
    }
    Some(Item::Group(group))
}

/// A text across the page: its first baseline begins at `at`, the others follow by `step` pixels, and another
/// column by `aside`.
pub(super) fn across(name: &str, text: &Across, (at, step, aside): (Point, f64, f64), theme: &Theme) -> Item {
    let mut group = Group::new(name);
    group.label.clone_from(&text.words);
    let mut x = at.x;
    for column in &text.columns {
        let mut y = at.y;
        for line in column.of(theme) {
            group.items.extend(lettered(line, Point::new(x, y), Role::Ink, (theme, None)));
            y += step;
        }
        x += aside;
    }
    Item::Group(group)
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Drawing, Group, Item};
    use crate::figure::{Figure, draw, plan, unnamed};
    use crate::scene::open_text;

    /// Two panels side by side, the left one with a caption.
    fn drawn(canvas: &str, caption: &str) -> (Figure, usize) {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            query = {{ kind = 'bounds', of = ['A'] }}
            [canvas]\n{canvas}
            [[panels]]\nlayers = ['shapes']\ncaption = '{caption}'
            [[panels]]\nlayers = ['shapes', 'origin']"
        );
        let scene = open_text("captions", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        (draw(&plan, plan.theme, "captions"), plan.warnings.len())
    }

    /// The captions of a drawing that have words.
    fn captions(drawing: &Drawing) -> Vec<&Group> {
        let groups = drawing.items.iter().filter_map(|item| match item {
            Item::Group(group) if group.name == "caption" && group.label.is_some() => Some(group),
            _ => None,
        });
        groups.collect()
    }

    const WORDS: &str = "The ball {a|$A$} is {=max.x} wide to the right and as wide to the left, so that \
        its box is twice as wide as that; where it stands nobody asks.";

    #[test]
    fn a_caption_stands_below_its_panel_in_lines_no_wider_than_that() {
        let (figure, warnings) = drawn("columns = 2", WORDS);
        let [caption] = captions(&figure.drawing)[..] else { panic!("one caption") };
        assert!(caption.label.as_ref().unwrap().starts_with("The ball A is 1 wide"), "{:?}", caption.label);
        let panel = figure.panels[0].frame.panel;
        let mut lines: Vec<f64> = Vec::new();
        for item in &caption.items {
            let Item::Text(text) = item else { panic!("words") };
            assert!(text.origin.x >= panel.x0 && text.origin.x + text.line.width <= panel.x1 + 1e-9);
            assert!(text.origin.y > panel.y1 && text.origin.y < figure.drawing.height);
            lines.extend(Some(text.origin.y).filter(|y| lines.last() != Some(y)));
        }
        assert!(lines.len() > 1 && warnings == 0, "{lines:?}");
        assert_eq!(panel.y1, figure.panels[1].frame.panel.y1, "panels of a row are as high");
    }

    #[test]
    fn titles_and_captions_of_a_panel_begin_at_its_left_edge() {
        let (figure, _) = drawn("columns = 2", "A ball.'\ntitle = 'A title");
        let left = figure.panels[0].frame.panel.x0;
        let of = |name: &str| {
            let group = figure.drawing.items.iter().find_map(|item| match item {
                Item::Group(group) if group.name == name && !group.items.is_empty() => Some(group),
                _ => None,
            });
            let Some(Item::Text(text)) = group.and_then(|group| group.items.first()) else {
                panic!("{name}")
            };
            text.origin.x
        };
        assert_eq!((of("title"), of("caption")), (left, left));
    }

    #[test]
    fn what_a_caption_of_a_panel_names_is_asked_for_on_the_picture() {
        let (figure, _) = drawn("columns = 2", "{a|$A$} is about $O$, its radius is $r$.");
        let found: Vec<String> = unnamed(&figure.drawing).iter().map(ToString::to_string).collect();
        assert_eq!(found, ["`r` is in the words and not on the picture"]);
    }

    #[test]
    fn a_caption_without_room_on_a_page_of_a_given_height_is_told_and_left_to_the_alternative_text() {
        let (figure, warnings) = drawn("width = 320\nheight = 180\ncolumns = 2", &[WORDS; 3].join(" "));
        assert!(captions(&figure.drawing).iter().all(|caption| caption.items.is_empty()));
        assert!(warnings == 1 && figure.drawing.desc.contains("its box is twice as wide"));
    }
}
