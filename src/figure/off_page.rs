//! A place that is on no page, told where it comes from.

use crate::scene::Scene;

use super::fault::{Fault, Problem};

/// The problem of a scene whose drawing has a place that is on no page: in which panel, given the names of
/// the outermost and of the innermost group that it is in.
///
/// ```
/// use tracefig::{figure::off_page, scene::open_text};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']\n\
///             [[panels]]\nlayers = ['shapes']";
/// let file = open_text("s.toml", text)?;
/// let problem = off_page(&file.scene, "panel-1", "body-A");
/// assert_eq!(problem.fault.to_string(), "`body-A` has a place that is not on any page");
/// assert_eq!(problem.span, file.scene.panels[0].span);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn off_page(scene: &Scene, outer: &str, group: &str) -> Problem {
    let number = outer.rsplit('-').next().and_then(|number| number.parse::<usize>().ok());
    let panel = number.and_then(|number| scene.panels.get(number.checked_sub(1)?));
    // The picture of a scene without panels is of its bodies.
    let body = || scene.shapes.first().map_or(0..0, |(name, _)| name.span.clone());
    let span = panel.map_or_else(body, |panel| panel.span.clone());
    Problem::new(Fault::OffPage { group: group.to_owned() }, span)
}
