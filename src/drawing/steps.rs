//! A drawing as a step of its figure shows it.

use super::{Drawing, Group, Item, Path, Shown, Text};

impl Item {
    /// The steps that show something of it.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Contour, Group, Item, Paint, Path, Point, Role, Shown};
    /// let disc = Contour::Circle { center: Point::new(5.0, 6.0), radius: 2.0 };
    /// let shown = Shown { since: 3, until: None };
    /// let path = Path { shown, ..Path::filled(disc, Paint::role(Role::B, Color::hex(0))) };
    /// let group = Group { items: vec![Item::Path(path)], ..Group::new("late") };
    /// assert_eq!(Item::Group(group).shown(), shown);
    /// ```
    #[must_use]
    pub fn shown(&self) -> Shown {
        match self {
            Self::Group(Group { items, .. }) => {
                items.iter().map(Self::shown).reduce(Shown::union).unwrap_or_default()
            }
            Self::Path(Path { shown, .. }) | Self::Text(Text { shown, .. }) => *shown,
        }
    }

    /// Calls `change` with what is said of every path and text in it.
    pub(crate) fn for_each_shown(&mut self, change: &impl Fn(&mut Shown)) {
        match self {
            Self::Group(group) => group.items.iter_mut().for_each(|item| item.for_each_shown(change)),
            Self::Path(path) => change(&mut path.shown),
            Self::Text(text) => change(&mut text.shown),
        }
    }
}

/// Whether a step takes away something of an item.
fn takes_away(item: &Item) -> bool {
    match item {
        Item::Group(group) => group.items.iter().any(takes_away),
        Item::Path(Path { shown, .. }) | Item::Text(Text { shown, .. }) => shown.until.is_some(),
    }
}

/// Leaves only what `keep` keeps, at any depth, and no group that lost all it had.
fn retain(items: &mut Vec<Item>, keep: &impl Fn(Shown) -> bool) {
    items.retain_mut(|item| match item {
        Item::Group(group) => {
            let had = !group.items.is_empty();
            retain(&mut group.items, keep);
            !(had && group.items.is_empty())
        }
        Item::Path(Path { shown, .. }) | Item::Text(Text { shown, .. }) => keep(*shown),
    });
}

impl Drawing {
    /// The drawing as a step shows it, of the size of the whole; steps count from 1. The last step is the
    /// finished figure.
    ///
    /// No later step takes anything away from it: it is a drawing of its own.
    ///
    /// ```
    /// use tracefig::{figure::{draw, draw_in_steps, plan}, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// shapes.B = { kind = "circle", radius = 1, position = [3, 1] }
    /// query = { kind = "separation", of = ["A", "B"] }
    /// panels = [{ space = "world", layers = ["shapes", "separation"] }]
    /// "#;
    /// let scene = read(&Source::new("circles.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let whole = draw_in_steps(&plan, plan.theme, "circles").drawing;
    /// let last = whole.steps.len();
    /// assert!(last > 1 && whole.at_step(1).items != whole.at_step(last).items);
    /// assert_eq!(whole.at_step(last), draw(&plan, plan.theme, "circles").drawing);
    /// ```
    #[must_use]
    pub fn at_step(&self, step: usize) -> Self {
        let mut drawing = self.clone();
        retain(&mut drawing.items, &|shown| shown.at(step));
        drawing.items.iter_mut().for_each(|item| item.for_each_shown(&|shown| shown.until = None));
        drawing
    }

    /// Whether a step takes something away.
    pub(crate) fn takes_away(&self) -> bool {
        self.items.iter().any(takes_away)
    }

    /// The finished figure: without what a step took away.
    pub(crate) fn finished(mut self) -> Self {
        retain(&mut self.items, &|shown| shown.until.is_none());
        self
    }
}
