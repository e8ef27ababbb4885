//! Which named elements of a drawing lie in an area of the page.

use crate::drawing::{Drawing, Group, Item, Rect};

/// A named element of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Its name, as "body-A".
    pub name: String,
    /// The box around what it draws itself, in page pixels, y down.
    pub extent: Rect,
}

/// The innermost groups that reach into an area of the page (pixels, y down), in painting order, one of each
/// name: of bodies in several panels the first.
///
/// ```
/// use tracefig::{drawing::Rect, drift::elements_in, figure::{draw, plan}, scene::open_text};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']\n\
///             [[panels]]\nlayers = ['shapes']";
/// let file = open_text("s.toml", text)?;
/// let plan = plan(&file.scene).unwrap();
/// let drawing = draw(&plan, plan.theme, "f").drawing;
/// let page = Rect { x0: 0.0, y0: 0.0, x1: drawing.width, y1: drawing.height };
/// assert!(elements_in(&drawing, page).iter().any(|element| element.name == "body-A"));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn elements_in(drawing: &Drawing, area: Rect) -> Vec<Element> {
    let mut found = Vec::new();
    for item in &drawing.items {
        if let Item::Group(group) = item {
            inside(group, area, &mut found);
        }
    }
    found
}

/// Adds the innermost groups; returns whether anything of the group reaches into the area.
fn inside(group: &Group, area: Rect, found: &mut Vec<Element>) -> bool {
    let (mut own, mut inner, mut extent) = (false, false, None);
    for item in &group.items {
        let of_item = match item {
            Item::Group(part) => {
                inner |= inside(part, area, found);
                continue;
            }
            Item::Path(path) => path.extent(),
            Item::Text(text) => Some(text.extent()),
        };
        own |= of_item.is_some_and(|e| e.intersection(area).is_some());
        extent = around(extent, of_item);
    }
    if let Some(extent) = extent.filter(|_| own && found.iter().all(|known| known.name != group.name)) {
        found.push(Element { name: group.name.clone(), extent });
    }
    own || inner
}

/// The box around both.
fn around(a: Option<Rect>, b: Option<Rect>) -> Option<Rect> {
    let (Some(a), Some(b)) = (a, b) else { return a.or(b) };
    Some(Rect { x0: a.x0.min(b.x0), y0: a.y0.min(b.y0), x1: a.x1.max(b.x1), y1: a.y1.max(b.y1) })
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
            heading: None,
            desc: String::new(),
            background: theme.paint(Role::Background),
            ink: theme.color(Role::Ink),
            words: Vec::new(),
            fill_opacity: 0.14,
            dark: None,
            metadata: String::new(),
            hash: String::new(),
            items: vec![Item::Group(outer)],
            steps: Vec::new(),
            motion: Vec::new(),
            narrow: None,
        };
        let area = Rect { x0: 80.0, y0: 0.0, x1: 100.0, y1: 20.0 };
        let found = elements_in(&drawing, area);
        assert_eq!(found.iter().map(|e| e.name.as_str()).collect::<Vec<_>>(), ["right"]);
        // Half a line's width is around the circle.
        assert_eq!((found[0].extent.x0, found[0].extent.y1), (86.5, 13.5));
    }
}
