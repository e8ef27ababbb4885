//! What texts say of a contact: how many points it has, how deep the shallower one is, and where the deepest
//! one lies.

use crate::collision::{Answer, ContactPoint};
use crate::figure::context::Context;
use crate::geometry::DVec2;

use super::quantity::Quantity;

/// The points of the contact that answers; `None` where the question is for none, or the bodies are apart.
fn points(context: &Context) -> Option<Vec<ContactPoint>> {
    let run = context.run();
    let Answer::Contact(contact) = &run.answer else { return None };
    let found: Vec<ContactPoint> = contact.points.iter().flatten().copied().collect();
    (!found.is_empty()).then_some(found)
}

/// How many points the contact has.
pub(super) fn count(context: &Context) -> Option<Quantity> {
    let count = u32::try_from(points(context)?.len()).ok()?;
    Some(Quantity::exactly(f64::from(count)))
}

/// The bounds of the depth at a contact by its place along the reference edge, from 0.
pub(super) fn depth(context: &Context, place: usize) -> Option<Quantity> {
    Some(Quantity::within(points(context)?.get(place)?.bounds).negated())
}

/// The bounds of the depth at the shallower of two points.
pub(super) fn shallower(context: &Context) -> Option<Quantity> {
    let [p, q] = points(context)?[..] else { return None };
    let shallower = if p.separation > q.separation { p } else { q };
    Some(Quantity::within(shallower.bounds).negated())
}

/// What `pick` takes of the points of A and B where the contact is deepest, as the panel shows them; `None`
/// where two are as deep.
pub(super) fn deepest(context: &Context, pick: fn([DVec2; 2]) -> f64) -> Option<Quantity> {
    let deepest = match points(context)?[..] {
        [one] => one,
        [p, q] if p.bounds.hi < q.bounds.lo => p,
        [p, q] if q.bounds.hi < p.bounds.lo => q,
        _ => return None,
    };
    Some(Quantity::exactly(pick(deepest.points.map(|p| context.in_space(p)))))
}

#[cfg(test)]
mod tests {
    use crate::figure::fault::Fault;
    use crate::figure::plan;
    use crate::figure::text::value_of;
    use crate::scene::open_text;

    /// The values of a contact of a floor, whose top is at 1, with a body.
    fn values(body: &str) -> [Option<f64>; 8] {
        let text = format!(
            "shapes.floor = {{ kind = 'aabb', half_extents = [5, 1] }}
            shapes.B = {{ {body} }}
            query = {{ kind = 'contact', of = ['floor', 'B'] }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let context = plan.panels[0].context(&scene, &plan.runs);
        ["contacts", "d_1", "d_2", "shallow", "contact.a.x", "contact.a.y", "contact.b.x", "contact.b.y"]
            .map(|name| value_of(name, &context).map(|found| 0.5 * (found.lo + found.hi)))
    }

    #[test]
    fn the_deepest_point_is_told_where_one_is_deeper_than_the_other() {
        let tilted = "kind = 'polygon', vertices = [[-2, 0.5], [2, 0.75], [2, 3], [-2, 3]]";
        let expected = [2.0, 0.25, 0.5, 0.25, -2.0, 1.0, -2.0, 0.5];
        for (found, expected) in values(tilted).into_iter().zip(expected) {
            assert!((found.unwrap() - expected).abs() < 1e-12, "{found:?}, not {expected}");
        }
        let level = values("kind = 'box', half_extents = [2, 1], position = [0, 1.75]");
        assert_eq!((level[0], level[4]), (Some(2.0), None), "two as deep");
        let vertex = values("kind = 'polygon', vertices = [[0, 0.5], [2, 2], [-2, 2]]");
        assert_eq!((vertex[0], vertex[1], vertex[2], vertex[3]), (Some(1.0), Some(0.5), None, None));
        assert_eq!(values("kind = 'circle', radius = 1, position = [0, 9]"), [None; 8]);
    }

    #[test]
    fn a_text_of_a_contact_that_has_one_point_has_a_dash_for_the_shallower_of_two() {
        let told = |y: f64| {
            let text = format!(
                "caption = '{{=contacts}}, {{=shallow}}, {{=contact.a.x}}'
                shapes.floor = {{ kind = 'aabb', half_extents = [5, 1] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [0, {y}] }}
                query = {{ kind = 'contact', of = ['floor', 'B'] }}"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let why = plan.warnings.iter().find_map(|problem| match &problem.fault {
                Fault::NoValue { why, .. } => Some(*why),
                _ => None,
            });
            (plan.caption.words.clone().unwrap(), why)
        };
        let words = |y: f64| told(y).0;
        assert_eq!(told(1.5).1, Some("there is one point of contact"));
        assert_eq!(words(1.5), "1, –, 0");
        assert_eq!(words(9.0), "–, –, –", "they are apart");
    }

    #[test]
    fn in_the_panel_of_a_body_the_deepest_point_is_where_its_frame_has_it() {
        let text =
            "shapes.floor = { kind = 'box', half_extents = [5, 1], position = [10, 20], angle_deg = 90 }
            shapes.B = { kind = 'circle', radius = 1, position = [8.5, 22] }
            query = { kind = 'contact', of = ['floor', 'B'] }
            panels = [{ layers = ['shapes'] }, { space = 'body', frame = 'floor', layers = ['shapes'] }]";
        let scene = open_text("s.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        for (panel, expected) in plan.panels.iter().zip([[9.0, 22.0, 9.5, 22.0], [2.0, 1.0, 2.0, 0.5]]) {
            let context = panel.context(&scene, &plan.runs);
            let names = ["contact.a.x", "contact.a.y", "contact.b.x", "contact.b.y"];
            let found = names.map(|name| value_of(name, &context).unwrap().lo);
            assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12), "{found:?}");
        }
    }
}
