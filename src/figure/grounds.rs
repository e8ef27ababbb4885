//! What tells panels apart: a pale ground behind each, on which what is empty looks as meant and what is cut
//! off ends at an edge. On paper it would be a screen of dots, so that there a thin line stands between them.

use crate::drawing::{Clip, Contour, Group, Item, Path, Rect, Role, Stroke};

use super::plan::Plan;
use super::theme::Theme;

/// Width of the lines between panels, page pixels.
const RULE: f64 = 1.5;
/// How much of the grid's colour a ground has: it is seen on white, and lines of the grid are seen on it.
const TINT: f64 = 0.35;
/// How far a ground reaches above and below its panel, as a share of the gap between panels: titles and
/// captions stand there. On the left and right it ends with its panel, where these begin.
const ABOVE: f64 = 1.0 / 6.0;
/// The radius of its corners, as a share of that gap: 6 px of 24.
const CORNER: f64 = 0.25;

/// Whether panels have grounds: those that are several, and one that has words about it.
fn has_grounds(plan: &Plan) -> bool {
    plan.page.cells.len() > 1 || plan.layout.head > 0
}

/// What tells the panels of a page apart; nothing where there is one.
pub(super) fn grounds(plan: &Plan, theme: &Theme) -> Item {
    if !theme.counts_on_color() {
        return rules(plan, theme);
    }
    let mut group = Group::new("grounds");
    for cell in plan.page.cells.iter().filter(|_| has_grounds(plan)) {
        let paint = theme.paint(Role::Grid).with_opacity(TINT);
        group.items.push(Item::Path(Path::filled(ground(*cell, plan, theme).contour(), paint)));
    }
    Item::Group(group)
}

/// What a panel's drawing is cut off at: the edges of its ground, or its own where it has none.
pub(super) fn ground(cell: Rect, plan: &Plan, theme: &Theme) -> Clip {
    if !has_grounds(plan) || !theme.counts_on_color() {
        return cell.into();
    }
    let [above, corner] = [ABOVE, CORNER].map(|share| share * plan.layout.measures.gap());
    let rect = Rect { y0: cell.y0 - above, y1: cell.y1 + above, ..cell };
    Clip::rounded(rect, corner)
}

/// The thin lines between panels.
fn rules(plan: &Plan, theme: &Theme) -> Item {
    let mut group = Group::new("rules");
    for &(from, to) in &plan.page.rules {
        let stroke = Stroke::solid(theme.paint(Role::Grid), RULE);
        group.items.push(Item::Path(Path::stroked(Contour::line(from, to), stroke)));
    }
    Item::Group(group)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{draw, plan, theme};
    use crate::scene::open_text;

    /// The first group of a figure of so many panels.
    fn first(panels: usize, name: &str) -> (Group, Vec<Rect>) {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            query = { kind = 'bounds', of = ['A'] }\n"
            .to_owned()
            + &"[[panels]]\nlayers = ['shapes']\n".repeat(panels);
        let scene = open_text("grounds", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, theme::find(name).unwrap(), "grounds");
        let Item::Group(group) = figure.drawing.items[0].clone() else { panic!("a group") };
        (group, figure.panels.iter().map(|panel| panel.frame.panel).collect())
    }

    #[test]
    fn each_of_several_panels_has_a_ground_of_its_own_that_holds_it_and_no_other() {
        for name in ["light", "dark", "auto"] {
            let (group, panels) = first(3, name);
            assert_eq!((group.name.as_str(), group.items.len()), ("grounds", 3));
            for (item, panel) in group.items.iter().zip(&panels) {
                let Item::Path(path) = item else { panic!("a path") };
                let seen = path.contour.bounds().unwrap();
                assert!(
                    seen.x0 == panel.x0 && panel.x1 == seen.x1 && seen.y0 < panel.y0 && panel.y1 < seen.y1
                );
                assert_eq!(panels.iter().filter(|other| seen.intersection(**other).is_some()).count(), 1);
            }
            assert!(first(1, name).0.items.is_empty());
        }
    }

    #[test]
    fn on_paper_a_line_stands_between_panels() {
        let (group, _) = first(3, "print");
        assert_eq!((group.name.as_str(), group.items.len()), ("rules", 2));
    }
}
