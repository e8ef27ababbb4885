//! Which named elements of a drawing lie in an area of the page.

use crate::drawing::{Drawing, Group, Item, Rect};

/// Names of the innermost groups that reach into an area of the page (pixels, y down), in painting order,
/// each once.
///
/// ```
/// use tracefig::{drawing::Rect, drift::elements_in, figure::{draw, plan}, scene::open_text};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']\n\
///             [[panels]]\nlayers = ['shapes']";
/// let file = open_text("s.toml", text)?;
/// let plan = plan(&file.scene).unwrap();
/// let drawing = draw(&plan, plan.theme, "f").drawing;
/// let page = Rect { x0: 0.0, y0: 0.0, x1: drawing.width, y1: drawing.height };
/// assert!(elements_in(&drawing, page).contains(&"body-A".to_owned()));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn elements_in(drawing: &Drawing, area: Rect) -> Vec<String> {
    let mut names = Vec::new();
    for item in &drawing.items {
        if let Item::Group(group) = item {
            inside(group, area, &mut names);
        }
    }
    names
}

/// Adds the names of the innermost groups; returns whether anything of the group reaches into the area.
fn inside(group: &Group, area: Rect, names: &mut Vec<String>) -> bool {
    let (mut own, mut inner) = (false, false);
    for item in &group.items {
        match item {
            Item::Group(part) => inner |= inside(part, area, names),
            Item::Path(path) => own |= path.extent().is_some_and(|e| e.intersection(area).is_some()),
            Item::Text(text) => own |= text.extent().intersection(area).is_some(),
        }
    }
    if own && !names.contains(&group.name) {
        names.push(group.name.clone());
    }
    own || inner
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Contour, Paint, Path, Point, Role, Stroke};

    #[test]
    fn only_what_reaches_into_the_area_is_named() {
        let theme = crate::figure::theme::find("light").unwrap();
        let dot = |name: &str, x: f64| {
            let paint: Paint = theme.paint(Role::A);
            let mut group = Group::new(name);
            let circle = Contour::Circle { center: Point::new(x, 10.0), radius: 3.0 };
            group.items.push(Item::Path(Path::stroked(circle, Stroke::solid(paint, 1.0))));
            Item::Group(group)
        };
        let mut outer = Group::new("panel-1");
        outer.items = vec![dot("left", 10.0), dot("right", 90.0)];
        let drawing = Drawing {
            width: 100.0,
            height: 20.0,
            id: "f".into(),
            lang: None,
            title: String::new(),
            is_titled: false,
            desc: String::new(),
            background: theme.paint(Role::Background),
            ink: theme.color(Role::Ink),
            words: Vec::new(),
            fill_opacity: 0.14,
            dark: None,
            metadata: String::new(),
            hash: String::new(),
            items: vec![Item::Group(outer)],
        };
        let area = Rect { x0: 80.0, y0: 0.0, x1: 100.0, y1: 20.0 };
        assert_eq!(elements_in(&drawing, area), ["right"]);
    }
}
