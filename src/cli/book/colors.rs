//! The colours of figures in a book whose reader chooses the theme.
//!
//! mdBook sets the class of `<html>` to the reader's choice before anything is painted, and gives each theme
//! its page as `--bg`. A style sheet sets our custom properties by that class: no script, no flash. A theme
//! that is not mdBook's own has the colours of a light page, and so has paper.

use std::fmt::Write as _;

use tracefig::drawing::{Color, Drawing, Role};
use tracefig::figure::theme::contrast::contrast;
use tracefig::figure::theme::{Side, THEMES, Theme};

use super::super::themes::ChosenTheme;

/// The class of figures that follow the book.
const FOLLOWS: &str = "tracefig-book";
/// The class of all figures.
const FIGURE: &str = "tracefig";

/// The widest window of a phone: there a figure may be wider than the page, and is scrolled sideways.
const PHONE: &str = "600px";
/// How far it is shrunk there at most: the letters of a usual figure have 10 pixels then.
const READABLE: &str = "540px";

/// The other themes of mdBook, by their class, and the page of each, from its `variables.css`.
const PAGES: [(&str, Color); 4] = [
    ("rust", Color::hex(0xE1_E1DB)),
    ("coal", Color::hex(0x13_1516)),
    ("navy", Color::hex(0x16_1923)),
    ("ayu", Color::hex(0x0F_141A)),
];

/// How figures look in a book.
#[derive(Debug)]
pub(crate) struct Colors {
    /// What figures are drawn in.
    pub(crate) base: Theme,
    /// The theme that they are from.
    pub(crate) chosen: ChosenTheme,
    /// The roles whose words have another colour than their lines, on one page at least.
    pub(crate) shaded: Vec<Role>,
    /// The style sheet of a page with figures, one line.
    pub(crate) sheet: String,
}

/// The theme of the house that has a light side and a dark one.
pub(crate) fn of_the_house() -> ChosenTheme {
    let theme = THEMES.iter().find(|theme| theme.dark.is_some()).unwrap_or(&THEMES[0]);
    ChosenTheme::of_the_house(theme)
}

impl Colors {
    /// Colours of a theme; one with a dark side has it on dark pages.
    pub(crate) fn of(chosen: ChosenTheme) -> Self {
        let theme = &chosen.theme;
        let base = Theme { dark: None, ..theme.clone() };
        let pages = PAGES.map(|(class, page)| (class, on_page(theme, page)));
        let sides = || pages.iter().map(|(_, side)| side).chain([&base]);
        let is_shaded = |role: &Role| sides().any(|side| side.word_color(*role) != side.color(*role));
        let shaded: Vec<Role> = Role::ALL.into_iter().filter(is_shaded).collect();
        let mut sheet = format!(
            ".{FIGURE}{{margin:1.5em auto;max-width:100%;text-align:center;break-inside:avoid}}\
             .{FIGURE} svg{{max-width:100%;height:auto}}\
             @media screen and (max-width:{PHONE}){{.{FIGURE}{{width:auto!important;overflow-x:auto}}\
             .{FIGURE} svg{{max-width:max(100%,{READABLE})}}}}@media screen{{\
             .{FOLLOWS}{{--tracefig-background:var(--bg,{})}}",
            base.color(Role::Background)
        );
        for (class, side) in &pages {
            let _ = write!(sheet, ".{class} .{FOLLOWS}{{");
            for role in Role::ALL.into_iter().filter(|&role| role != Role::Background) {
                let _ = write!(sheet, "--tracefig-{}:{};", role.name(), side.color(role));
            }
            for &role in &shaded {
                let _ = write!(sheet, "--tracefig-words-{}:{};", role.name(), side.word_color(role));
            }
            let _ = write!(sheet, "--tracefig-fill-opacity:{}}}", side.fill_opacity);
        }
        sheet.push('}');
        Self { base, chosen, shaded, sheet }
    }

    /// Lets words have another colour than lines, as some pages want it.
    pub(crate) fn open_words(&self, drawing: &mut Drawing) {
        drawing.words = self.shaded.iter().map(|&role| (role, self.base.word_color(role))).collect();
    }

    /// The classes of a figure; one that follows the book has its colours.
    pub(crate) fn class(follows: bool) -> String {
        if follows { format!("{FIGURE} {FOLLOWS}") } else { FIGURE.to_owned() }
    }
}

/// A theme on a page: its dark side on a dark one, if it has one.
fn on_page(theme: &Theme, page: Color) -> Theme {
    let [black, white] = [0, 0xFF_FFFF].map(Color::hex);
    let is_dark = contrast(white, page) > contrast(black, page);
    // The side first: to fit the other one to the page too would take longer than all else.
    let side = match theme.dark.filter(|_| is_dark) {
        Some(Side { colors, words, fill_opacity }) => Theme { colors, words, fill_opacity, ..theme.clone() },
        None => theme.clone(),
    };
    Theme { dark: None, ..side }.on(page)
}

#[cfg(test)]
mod tests {
    use tracefig::figure::theme::shortcomings;
    use tracefig::figure::{draw, plan_in};
    use tracefig::scene::open;

    use super::*;

    #[test]
    fn every_page_of_the_house_theme_keeps_what_themes_promise() {
        let figures = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
        let file = open(&figures.join("03-circle-box.toml")).unwrap();
        for (class, page) in PAGES {
            let theme = on_page(&of_the_house().theme, page);
            let plan = plan_in(&file.scene, &theme).unwrap();
            let short = shortcomings(&theme, &draw(&plan, &theme, "book").drawing);
            assert!(short.is_empty(), "{class}: {}", short[0]);
            assert_eq!(theme.color(Role::Background), page);
        }
    }

    #[test]
    fn the_sheet_is_one_line_and_sets_every_role_by_class() {
        let colors = Colors::of(of_the_house());
        assert!(!colors.sheet.contains(['\n', '<']));
        for class in ["rust", "coal", "navy", "ayu"] {
            assert!(colors.sheet.contains(&format!(".{class} .tracefig-book{{--tracefig-a:#")), "{class}");
        }
        assert_eq!(colors.sheet.matches("--tracefig-b:").count(), 4);
        assert_eq!(colors.sheet.matches("--tracefig-words-b:").count(), 4, "too pale on rust");
        assert_eq!(colors.base.name, of_the_house().name);
        assert!(colors.base.dark.is_none());
    }
}
