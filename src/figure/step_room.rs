//! Room on the page for what only steps show: the axes, simplices and polytopes that a search replaced.
//!
//! The finished figure has none of it, so its page is fitted without. Drawn in steps it would be cut off at
//! the edges of a panel, where a bar's end is not its end.

use super::fault::Problem;
use super::frame::union;
use super::kept::Kept;
use super::plan::Plan;
use super::view;

/// How often the page is fitted again at most: what is drawn at a distance in page pixels reaches elsewhere
/// in a smaller scale.
const PASSES: usize = 3;

impl Plan<'_> {
    /// Makes room on the page for what comes and goes with the steps of a figure: a panel without a `view`
    /// shows all of it. Where the figure shows it anyway, or has a `view`, nothing changes.
    ///
    /// # Errors
    /// Where the panels draw more than a figure may show.
    ///
    /// ```
    /// use tracefig::{figure::{Plan, draw_in_steps, plan}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "box", half_extents = [1, 0.5], angle_deg = 20 }
    /// shapes.B = { kind = "box", half_extents = [0.6, 0.6], position = [2.5, 0.4], angle_deg = 50 }
    /// query = { kind = "separation", of = ["A", "B"], algorithm = "separating-axes" }
    /// "#;
    /// let scene = read(&Source::new("boxes.toml", text)).unwrap();
    /// let scale = |plan: Plan| {
    ///     let frame = draw_in_steps(&plan, plan.theme, "f").panels[0].frame;
    ///     frame.page([1.0, 0.0].into()).x - frame.page([0.0, 0.0].into()).x
    /// };
    /// // Of the axes that the test leaves again some reach farther than the last.
    /// assert!(scale(plan(&scene).unwrap().with_room_for_steps().unwrap()) < scale(plan(&scene).unwrap()));
    /// ```
    pub fn with_room_for_steps(mut self) -> Result<Self, Vec<Problem>> {
        // What the plan keeps was drawn for the finished figure.
        self.kept = Kept::default();
        self.panels.iter_mut().for_each(|panel| panel.in_steps = true);
        for _ in 0..PASSES {
            let one = |problem: crate::scene::Problem| vec![problem.into()];
            let sketched = view::sketch(self.scene, &self.runs, self.theme, &self.panels).map_err(one)?;
            let mut is_cut = false;
            for (panel, sketched) in self.panels.iter_mut().zip(sketched) {
                if panel.source.view.is_none() && !sketched.frame.holds(sketched.passed) {
                    panel.reach = union(panel.reach, sketched.passed);
                    is_cut = true;
                }
            }
            if !is_cut {
                break;
            }
            let fitted = view::fit(self.scene, &self.runs, self.theme, &self.layout, &mut self.panels);
            self.page = fitted.map_err(one)?.1;
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Drawing, Item, Path, Rect};
    use crate::figure::{draw_in_steps, plan};
    use crate::scene::open_text;

    /// Two boxes of which one is turned: axes in four directions.
    const BOXES: &str = "shapes.u = { kind = 'box', half_extents = [1, 0.5], angle_deg = 20 }
        shapes.w = { kind = 'box', half_extents = [0.6, 0.6], position = [2.5, 0.4], angle_deg = 50 }
        query = { kind = 'separation', of = ['u', 'w'], algorithm = 'separating-axes' }";

    /// The boxes of all that is drawn of a panel's layer, page pixels.
    fn reach(items: &[Item]) -> Option<Rect> {
        let of = |item: &Item| match item {
            Item::Group(group) => reach(&group.items),
            Item::Path(Path { contour, .. }) => contour.bounds(),
            Item::Text(_) => None,
        };
        items.iter().filter_map(of).reduce(Rect::union)
    }

    /// What a drawing shows of the layers of its only panel.
    fn layers(drawing: &Drawing) -> Rect {
        let group = |items: &[Item], name: &str| {
            let mut groups = items.iter().filter_map(|item| match item {
                Item::Group(group) if group.name == name => Some(group.items.clone()),
                _ => None,
            });
            groups.next().unwrap()
        };
        reach(&group(&group(&drawing.items, "panel-1"), "layers")).unwrap()
    }

    #[test]
    fn no_step_is_cut_off_at_the_edge_of_its_panel() {
        let scene = open_text("s", BOXES).unwrap().scene;
        let is_whole = |plan: &crate::figure::Plan| {
            let figure = draw_in_steps(plan, plan.theme, "f");
            let (whole, panel) = (layers(&figure.drawing), figure.panels[0].frame.panel);
            panel.union(whole) == panel
        };
        let still = plan(&scene).unwrap();
        assert!(!is_whole(&still));
        assert!(is_whole(&still.with_room_for_steps().unwrap()));
    }

    #[test]
    fn in_steps_labels_keep_off_what_a_later_step_takes_away() {
        // The name of B ⊖ A would stand on the edge that the search takes first.
        let text = "shapes.Caisse = { kind = 'box', half_extents = [1.4, 0.5], angle_deg = 33 }
            shapes.Tonneau = { kind = 'polygon', position = [0.7, 0.9],
                vertices = [[-0.8, -0.3], [0.2, -0.9], [1, 0.1], [0.3, 0.9], [-0.6, 0.7]] }
            query = { kind = 'separation', of = ['Caisse', 'Tonneau'], algorithm = 'gjk' }";
        let scene = open_text("s", text).unwrap().scene;
        let crossed = |plan: &crate::figure::Plan| {
            let figure = draw_in_steps(plan, plan.theme, "f");
            let passing = passing(&figure.drawing.items);
            let boxes = figure.panels.iter().flat_map(|panel| &panel.placed).map(|label| label.bounds);
            boxes.filter(|bounds| passing.iter().any(|line| bounds.intersection(*line).is_some())).count()
        };
        let still = plan(&scene).unwrap();
        assert!(crossed(&still) > 0);
        assert_eq!(crossed(&still.with_room_for_steps().unwrap()), 0);
    }

    /// The boxes of short lines that a later step takes away.
    fn passing(items: &[Item]) -> Vec<Rect> {
        let of = |item: &Item| match item {
            Item::Group(group) => passing(&group.items),
            Item::Path(path) if path.shown.until.is_some() => {
                let short = |r: &Rect| r.x1 - r.x0 < 30.0 && r.y1 - r.y0 < 30.0;
                path.contour.bounds().filter(short).into_iter().collect()
            }
            _ => Vec::new(),
        };
        items.iter().flat_map(of).collect()
    }

    #[test]
    fn the_sentence_of_the_answer_comes_with_the_last_step() {
        let scene = open_text("s", BOXES).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawing = draw_in_steps(&plan, plan.theme, "f").drawing;
        let last = drawing.steps.len();
        let says = |step: usize| format!("{:?}", drawing.at_step(step).items).contains("\"caption\"");
        assert!(last > 2 && (1..=last).filter(|step| says(*step)).eq([last]));
    }
}
