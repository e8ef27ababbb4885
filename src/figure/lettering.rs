//! Words that wear a role, as `{a|the red box}`: which roles there are for words, and what tells them apart
//! without colour.
//!
//! A word wears the colour of its thing, so that a caption needs no legend. Where a theme can't count on
//! colour, the marker of the thing's points stands before the word.

use std::sync::Arc;

use crate::drawing::{Halo, Item, Point, Role, Shown, Text};
use crate::figure::theme::Theme;
use crate::typeset::{Line, Piece, TypesetError, pieces};

/// The sign before words of a role, in the form of the markers of its points.
const MARKERS: [(Role, char); 3] = [(Role::A, '●'), (Role::B, '■'), (Role::Difference, '◆')];
/// The space after such a sign, at which no line is broken.
const GAP: char = '\u{202F}';

/// The words of the roles that words may wear.
pub(crate) fn role_words() -> Vec<String> {
    Role::OF_WORDS.map(|role| role.name().to_owned()).to_vec()
}

/// The role that a word of markup names.
fn role_of(word: &str) -> Option<Role> {
    Role::OF_WORDS.into_iter().find(|role| role.name() == word)
}

/// The first word in the place of a role that is none.
pub(crate) fn unknown(markup: &str) -> Option<&str> {
    let roles = pieces(markup).ok()?;
    roles.into_iter().find_map(|piece| match piece {
        Piece::Role(_, word) if role_of(word).is_none() => Some(word),
        _ => None,
    })
}

/// Markup with the marker of its role before all that wears one.
pub(crate) fn with_markers(markup: &str) -> String {
    let mut out = markup.to_owned();
    for piece in pieces(markup).unwrap_or_default().into_iter().rev() {
        let Piece::Role(at, word) = piece else { continue };
        let marker = MARKERS.iter().find(|(role, _)| role.name() == word);
        if let Some((_, sign)) = marker {
            out.insert(at, GAP);
            out.insert(at, *sign);
        }
    }
    out
}

/// A line at its place on the page: what wears a role in the colour of that, the rest in the colour of
/// `role`.
pub(crate) fn lettered(
    line: &Arc<Line>,
    origin: Point,
    role: Role,
    (theme, halo): (&Theme, Option<Halo>),
) -> Vec<Item> {
    let text = |line, x: f64, role, halo| {
        let origin = Point::new(origin.x + x, origin.y);
        Item::Text(Text { line, origin, paint: theme.word_paint(role), halo, shown: Shown::ALWAYS })
    };
    if line.tints.is_empty() {
        return vec![text(Arc::clone(line), 0.0, role, halo)];
    }
    // The halo of a stretch would cover the end of the one before it, so that of the whole line comes first,
    // with letters that are not seen.
    let halo = halo.map(|halo| Text {
        line: Arc::clone(line),
        origin,
        paint: halo.paint.with_opacity(0.0),
        halo: Some(halo),
        shown: Shown::ALWAYS,
    });
    let stretches = line
        .stretches()
        .into_iter()
        .map(|(word, x, stretch)| text(Arc::new(stretch), x, word.and_then(role_of).unwrap_or(role), None));
    halo.map(Item::Text).into_iter().chain(stretches).collect()
}

/// A text on its lines, for themes that tell roles by colour and for those that do not count on it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lettering {
    /// The lines as the markup has them.
    colored: Vec<Arc<Line>>,
    /// The lines with markers before what wears a role; none where nothing does.
    marked: Option<Vec<Arc<Line>>>,
}

impl Lettering {
    /// Sets markup both ways.
    ///
    /// # Errors
    /// Where `typeset` can't set it.
    pub(crate) fn new(
        markup: &str,
        typeset: impl Fn(&str) -> Result<Vec<Arc<Line>>, TypesetError>,
    ) -> Result<Self, TypesetError> {
        let colored = typeset(markup)?;
        let wears = colored.iter().any(|line| !line.tints.is_empty());
        let marked = if wears { Some(typeset(&with_markers(markup))?) } else { None };
        Ok(Self { colored, marked })
    }

    /// The lines in a theme.
    pub(crate) fn of(&self, theme: &Theme) -> &[Arc<Line>] {
        match &self.marked {
            Some(marked) if !theme.counts_on_color() => marked,
            _ => &self.colored,
        }
    }

    /// How many lines it takes, in the theme where it takes most.
    pub(crate) fn len(&self) -> usize {
        self.marked.as_ref().map_or(0, Vec::len).max(self.colored.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use crate::figure::theme::{THEMES, find};
    use crate::figure::{draw, plan};
    use crate::scene::{Source, read};
    use crate::typeset::{Style, paragraph};

    #[test]
    fn markers_stand_before_words_of_bodies_and_difference_alone() {
        assert_eq!(with_markers("{a|x} {b|y} z"), "{a|●\u{202F}x} {b|■\u{202F}y} z");
        assert_eq!(with_markers("{difference|$D$} {now|new}"), "{difference|◆\u{202F}$D$} {now|new}");
        assert_eq!(unknown("{a|x} {reed|y}"), Some("reed"));
        assert_eq!(unknown("{grid|x}"), Some("grid"), "its colour is too faint for words");
    }

    #[test]
    fn a_text_has_markers_in_the_themes_that_do_not_count_on_colour() {
        let set = |text: &str| Ok(paragraph(text, Style::regular(14.0))?.lines(500.0));
        let text = Lettering::new("{a|box}", set).unwrap();
        for theme in THEMES {
            let glyphs = text.of(theme)[0].glyphs.len();
            assert_eq!(glyphs, if theme.patterns.is_empty() { 3 } else { 5 }, "{}", theme.name);
        }
        assert!(Lettering::new("plain", set).unwrap().marked.is_none());
    }

    /// The drawing of two circles with words of a scene, and the plan's texts for those who do not see it.
    fn drawn(words: &str, theme: &str) -> Result<Drawing, Vec<String>> {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            {words}"
        );
        let scene = read(&Source::new("words.toml", &text)).unwrap();
        let plan = plan(&scene).map_err(|all| all.iter().map(|p| p.fault.to_string()).collect());
        plan.map(|plan| draw(&plan, find(theme).unwrap(), "words").drawing)
    }

    /// The paints of what stands in the group of a name, in order.
    fn paints(items: &[Item], name: &str) -> Vec<Role> {
        let mut found = Vec::new();
        for item in items {
            let Item::Group(group) = item else { continue };
            let texts = group.items.iter().filter(|_| group.name == name);
            found.extend(texts.filter_map(|item| match item {
                Item::Text(text) => text.paint.role,
                _ => None,
            }));
            found.extend(paints(&group.items, name));
        }
        found
    }

    #[test]
    fn words_wear_their_role_wherever_a_scene_writes() {
        let words = "
            headline = '{difference|The edge} is near.'
            caption = 'Push {b|the ball $B$} by {=d}.'
            labels.A = '{muted|quiet} {a|A}'
            panels = [{ title = 'Now {now|this}', layers = ['shapes'] }]";
        let drawing = drawn(words, "light").unwrap();
        let roles = |name| paints(&drawing.items, name);
        assert_eq!(roles("headline"), [Role::Difference, Role::Ink]);
        assert_eq!(roles("caption"), [Role::Ink, Role::B, Role::Ink]);
        assert_eq!(roles("title"), [Role::Ink, Role::Now]);
        assert_eq!(roles("label-A"), [Role::Background, Role::Muted, Role::A], "the halo comes first");
        assert!(drawing.desc.starts_with("The edge is near. A is a circle"), "{}", drawing.desc);
        assert!(drawing.desc.contains("(Now this)") && !drawing.desc.contains('|'));
        let lines = |theme: &str| drawn(words, theme).unwrap();
        assert_eq!(paints(&lines("print").items, "caption"), roles("caption"));
    }

    #[test]
    fn a_role_that_is_none_is_refused_with_the_nearest_and_a_name_is_no_role() {
        for words in ["caption = '{trnslation|x}'", "headline = '{trnslation|x}'"] {
            let words = format!("{words}\npanels = [{{ layers = ['shapes'] }}]");
            let problems = drawn(&words, "light").unwrap_err();
            assert!(problems.len() == 1 && problems[0].contains("unknown role `trnslation`"), "{problems:?}");
        }
        assert!(drawn("panels = [{ layers = ['shapes'] }]\nlabels.A = '{b|x'", "light").is_err());
        assert!(drawn(r"caption = 'all \{x|x > 0} {and} {}'", "light").is_ok());
    }
}
