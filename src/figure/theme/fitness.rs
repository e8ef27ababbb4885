//! Whether the readers of a figure can tell its colours apart: measured on the roles that it uses, and no
//! others.
//!
//! Held of every theme, on each of its sides:
//!
//! - lines, areas and markers keep [`LINE_CONTRAST`] against the page. WCAG 2.2 (1.4.11) asks 3 : 1 of what
//!   stands alone; things of ours have a name beside them, in words that keep 4.5 : 1;
//! - ink keeps [`TEXT_CONTRAST`] on the areas that it may stand on; all other words have a readable shade;
//!   The area where bodies overlap is one of these, though nothing is seen through it;
//! - A and B differ by [`BODIES_APART`], any other two roles by [`ROLES_APART`], for the worst of four
//!   visions.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use crate::drawing::{Color, Drawing, Item, Role, blend};

use super::contrast::contrast;
use super::nearest::nearest;
use super::vision::{most_alike_to, worst_difference};
use super::{Side, Theme, index};

/// The least contrast of text against what lies under it (WCAG 2.2, level AA).
pub(super) const TEXT_CONTRAST: f64 = 4.5;
/// The least contrast of a line against the page. The orange and the sky blue of Okabe and Ito have 2.2 and
/// 2.3 on white, the orange of matplotlib 2.5; at 3 none of the palettes that people bring would do, at 1.5
/// their yellow would, and its lines are lost.
pub(super) const LINE_CONTRAST: f64 = 2.0;
/// The least ΔE2000 of shape A and shape B for the worst of four visions.
const BODIES_APART: f64 = 20.0;
/// The least ΔE2000 of any other two roles; dashes, markers and shapes tell them apart besides.
const ROLES_APART: f64 = 9.0;

/// The roles that colour lines and words.
pub(super) const SPEAKING: [Role; 7] =
    [Role::A, Role::B, Role::Difference, Role::Now, Role::Translation, Role::Ink, Role::Muted];

/// The roles of areas that words may stand on.
pub(super) const AREAS: [Role; 3] = [Role::A, Role::B, Role::Difference];

/// What is measured of two colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The contrast ratio of WCAG 2.2.
    Contrast,
    /// The difference CIEDE2000, for the reader to whom they look most alike.
    Difference,
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Contrast => "contrast",
            Self::Difference => "ΔE2000",
        })
    }
}

/// A pair of roles whose colours are too near each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortcoming {
    /// What was measured.
    pub measure: Measure,
    /// The two roles whose colours were compared.
    pub roles: [Role; 2],
    /// Their colours.
    pub colors: [Color; 2],
    /// The value of the measure.
    pub value: f64,
    /// The least value that would do.
    pub limit: f64,
    /// Whether it is so for readers whose system is dark, where the theme follows it.
    pub in_the_dark: bool,
}

impl fmt::Display for Shortcoming {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { measure, roles: [p, q], colors: [c, d], value, limit, in_the_dark } = self;
        let (p, q, side) = (p.name(), q.name(), if *in_the_dark { " in the dark" } else { "" });
        // Cut off, as what is rounded could read like the limit.
        let value = (10.0 * value).floor() / 10.0;
        let vision = match measure {
            Measure::Difference => most_alike_to(*c, *d),
            Measure::Contrast => None,
        };
        let to = vision.map(|vision| format!(" {vision}")).unwrap_or_default();
        write!(f, "{p} {c} is too near {q} {d}{side}{to}: {measure} {value:.1}, at least {limit}")
    }
}

/// Which roles a drawing uses.
#[derive(Default)]
struct Used {
    /// The roles of lines, areas and markers, and of coloured words.
    marks: BTreeSet<Role>,
    /// The roles of areas that are seen through.
    areas: BTreeSet<Role>,
    /// Whether there are words in ink.
    ink: bool,
}

impl Used {
    fn by(drawing: &Drawing) -> Self {
        let mut used = Self::default();
        used.items(&drawing.items);
        used
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.items(&group.items),
                Item::Path(path) => {
                    let fill = path.fill.as_ref();
                    let stroke = path.stroke.as_ref().map(|stroke| &stroke.paint);
                    self.marks.extend(fill.into_iter().chain(stroke).filter_map(|paint| paint.role));
                    self.areas.extend(fill.filter(|paint| paint.opacity < 1.0).and_then(|paint| paint.role));
                }
                Item::Text(text) => match text.paint.role {
                    Some(Role::Ink) => self.ink = true,
                    // Plain words are told from others by what they say.
                    Some(Role::Muted) | None => {}
                    Some(role) => _ = self.marks.insert(role),
                },
            }
        }
    }
}

/// One side of a theme, measured for what a drawing uses.
struct Measured<'m> {
    /// The colours.
    side: Side,
    /// What the drawing uses.
    used: &'m Used,
    /// Whether it is the side for readers whose system is dark.
    in_the_dark: bool,
}

impl Measured<'_> {
    /// The pairs that fall short, in the order of the roles; of one role alone where it is given.
    fn shortcomings(&self, of: Option<Role>) -> Vec<Shortcoming> {
        let Side { colors, words, fill_opacity } = &self.side;
        let color = |role: Role| colors[index(role)];
        let asked = |p: Role, q: Role| of.is_none_or(|role| role == p || role == q);
        let marks: Vec<Role> = SPEAKING.into_iter().filter(|role| self.used.marks.contains(role)).collect();
        let mut all = Vec::new();
        let mut hold = |measure, roles, colors: [Color; 2], value: f64, limit| {
            if value < limit {
                let in_the_dark = self.in_the_dark;
                all.push(Shortcoming { measure, roles, colors, value, limit, in_the_dark });
            }
        };
        let page = color(Role::Background);
        for &role in marks.iter().filter(|&&role| asked(role, Role::Background)) {
            let value = contrast(color(role), page);
            hold(Measure::Contrast, [role, Role::Background], [color(role), page], value, LINE_CONTRAST);
        }
        for role in AREAS.into_iter().filter(|&role| asked(Role::Ink, role)) {
            if self.used.ink && self.used.areas.contains(&role) {
                let (fill, ink) = (blend(color(role), *fill_opacity, page), words[index(Role::Ink)]);
                hold(Measure::Contrast, [Role::Ink, role], [ink, fill], contrast(ink, fill), TEXT_CONTRAST);
            }
        }
        if self.used.ink && self.used.marks.contains(&Role::Overlap) && asked(Role::Ink, Role::Overlap) {
            let (area, ink) = (color(Role::Overlap), words[index(Role::Ink)]);
            let value = contrast(ink, area);
            hold(Measure::Contrast, [Role::Ink, Role::Overlap], [ink, area], value, TEXT_CONTRAST);
        }
        for (i, &p) in marks.iter().enumerate() {
            for &q in marks[i + 1..].iter().filter(|&&q| asked(p, q)) {
                let value = worst_difference(color(p), color(q));
                hold(Measure::Difference, [p, q], [color(p), color(q)], value, apart(p, q));
            }
        }
        all
    }
}

/// The least ΔE2000 of two roles.
pub(super) fn apart(p: Role, q: Role) -> f64 {
    if [p, q] == [Role::A, Role::B] || [p, q] == [Role::B, Role::A] { BODIES_APART } else { ROLES_APART }
}

/// The theme on the page of a drawing, where the scene gives that another colour.
fn on_page<'t>(theme: &'t Theme, drawing: &Drawing) -> Cow<'t, Theme> {
    let page = drawing.background.color;
    if page == theme.color(Role::Background) { Cow::Borrowed(theme) } else { Cow::Owned(theme.on(page)) }
}

/// Everything in which a theme falls short of the limits in this drawing; empty for a fit one.
///
/// ```
/// use tracefig::{figure::{draw, plan, theme}, scene::{Source, read}};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
///             [[panels]]\nlayers = ['shapes']";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let alike = theme::parse("[colors]\na = '#102030'\nb = '#102030'").unwrap();
/// let drawing = draw(&plan, &alike, "circle").drawing;
/// assert!(theme::shortcomings(&alike, &drawing).is_empty(), "B is not in the picture");
/// ```
#[must_use]
pub fn shortcomings(theme: &Theme, drawing: &Drawing) -> Vec<Shortcoming> {
    let used = Used::by(drawing);
    let theme = on_page(theme, drawing);
    let sides = theme.sides().enumerate();
    sides
        .flat_map(|(i, side)| Measured { side, used: &used, in_the_dark: i > 0 }.shortcomings(None))
        .collect()
}

/// The nearest colours that would pass, in every drawing or at least in this one, for each of the two roles
/// that one could change with all others as they are; a role for which there is none is left out, as is the
/// page.
///
/// ```
/// use tracefig::{figure::{draw, plan, theme}, scene::{Source, read}};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
///             [[panels]]\nlayers = ['shapes']";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let pale = theme::parse("[colors]\na = '#F0E442'").unwrap();
/// let drawing = draw(&plan, &pale, "circle").drawing;
/// let short = &theme::shortcomings(&pale, &drawing)[0];
/// let (role, color) = theme::remedies(&pale, &drawing, short)[0];
/// assert_eq!((role.name(), color.to_string().as_str()), ("a", "#C3BB1C"));
/// ```
#[must_use]
pub fn remedies(theme: &Theme, drawing: &Drawing, short: &Shortcoming) -> Vec<(Role, Color)> {
    // What passes in every figure is better than what passes in this one, and the next names another.
    let marks = SPEAKING.into_iter().chain([Role::Overlap]).collect();
    let all = Used { marks, areas: AREAS.into(), ink: true };
    let used = Used::by(drawing);
    let theme = on_page(theme, drawing);
    let Some(side) = theme.sides().nth(usize::from(short.in_the_dark)) else { return Vec::new() };
    let changed = |role: Role, used: &Used| {
        let passes = |color: Color| {
            let mut side = side;
            side.colors[index(role)] = color;
            side.words[index(role)] = color;
            let measured = Measured { side, used, in_the_dark: short.in_the_dark };
            measured.shortcomings(Some(role)).is_empty()
        };
        Some((role, nearest(side.colors[index(role)], passes)?))
    };
    // Of two roles without contrast the first is the one to see.
    let movable = |role: &Role| short.measure == Measure::Difference || *role == short.roles[0];
    short
        .roles
        .into_iter()
        .filter(movable)
        .filter_map(|role| changed(role, &all).or_else(|| changed(role, &used)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::{THEMES, find, parse};
    use super::*;

    /// What falls short of a theme in a drawing that uses everything.
    fn short(theme: &Theme) -> Vec<String> {
        let marks = SPEAKING.into_iter().chain([Role::Overlap]).collect();
        let used = Used { marks, areas: AREAS.into(), ink: true };
        let side = |(i, side)| Measured { side, used: &used, in_the_dark: i > 0 }.shortcomings(None);
        theme.sides().enumerate().flat_map(side).map(|short| short.to_string()).collect()
    }

    #[test]
    fn the_themes_of_the_house_keep_the_limits_too() {
        for theme in THEMES {
            assert!(short(theme).is_empty(), "{}: {:#?}", theme.name, short(theme));
        }
    }

    #[test]
    fn a_theme_is_readable_on_any_page_that_a_scene_gives() {
        for theme in THEMES {
            for page in [0x10_2030, 0xFF_F8E7, 0xFF_D500, 0x80_8080, 0].map(Color::hex) {
                let on = theme.on(page);
                let pale = short(&on).into_iter().filter(|short| short.contains("background"));
                assert_eq!(pale.collect::<Vec<_>>(), [""; 0], "{} on {page}", theme.name);
                let read = |role: Role| contrast(on.word_color(role), page) >= TEXT_CONTRAST;
                assert!(SPEAKING.into_iter().all(read), "{} on {page}", theme.name);
            }
        }
        let light = find("light").unwrap();
        assert_eq!(light.on(Color::hex(0xFF_FFFF)).colors[..7], light.colors[..7]);
    }

    #[test]
    fn the_printed_digits_of_an_unfit_theme_stay() {
        let colors = "a = '#C02A1E'\nb = '#8A5A00'\ndifference = '#7B4FA3'\nnow = '#2E6FD0'\n\
            translation = '#E088C0'\nink = '#7C7C7C'\nmuted = '#9A9A9A'\nbackground = '#D0D8F0'";
        let unfit = parse(&format!("[colors]\n{colors}")).unwrap();
        let expected = [
            "translation #E088C0 is too near background #D0D8F0: contrast 1.7, at least 2",
            "muted #9A9A9A is too near background #D0D8F0: contrast 1.9, at least 2",
            "a #C02A1E is too near b #8A5A00 to readers without green cones: ΔE2000 3.1, at least 20",
            "difference #7B4FA3 is too near now #2E6FD0 to readers without green cones: ΔE2000 6.7, \
             at least 9",
        ];
        assert_eq!(short(&unfit), expected);
    }
}
