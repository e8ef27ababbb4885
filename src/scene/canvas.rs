//! `[canvas]`: the page that a figure is drawn on.
//!
//! Nothing has to be said of it; what is said in a project file stands in the scene by then.

use super::Spanned;
use super::checked::{Checked, as_number, as_rgb, check};
use super::fields::CANVAS;
use super::problem::Problems;

/// Width of a page where nobody says another, page pixels.
const WIDTH: f64 = 960.0;

/// The page that a figure is drawn on; what is `None` was not said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Canvas {
    /// Width in page pixels.
    pub width: Option<f64>,
    /// Height of the page.
    pub height: Option<Height>,
    /// From the page's edges to what is drawn, page pixels.
    pub margin: Option<f64>,
    /// What lies under the drawing.
    pub background: Option<Spanned<Background>>,
    /// Size of running text, page pixels an em: all other letters keep their ratio to it.
    pub text: Option<f64>,
    /// How many panels stand side by side at most.
    pub columns: Option<usize>,
    /// Name of a theme, checked by the figure's table of themes.
    pub theme: Option<Spanned<String>>,
}

/// How high a page is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Height {
    /// The page ends where the drawing ends.
    Auto,
    /// A number of page pixels.
    Pixels(f64),
}

/// What lies under a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Background {
    /// Nothing: what the figure stands on is seen.
    Transparent,
    /// Red, green and blue of sRGB in the place of the theme's colour.
    Color([u8; 3]),
}

impl Canvas {
    /// Width of the page, page pixels.
    #[must_use]
    pub(crate) fn page_width(&self) -> f64 {
        self.width.unwrap_or(WIDTH)
    }

    /// Height of the page, page pixels; `None` where it ends with the drawing.
    #[must_use]
    pub(crate) fn page_height(&self) -> Option<f64> {
        match self.height {
            Some(Height::Pixels(height)) => Some(height),
            Some(Height::Auto) | None => None,
        }
    }
}

/// Reads the canvas of a scene; what is wrong is told and left open.
pub(super) fn read(top: &Checked<'_>, p: &mut Problems) -> Canvas {
    let table = top.get("canvas").and_then(|node| check(node, "canvas", CANVAS.place, CANVAS.fields, p));
    let Some(table) = table else { return Canvas::default() };
    let number = |key: &str| table.number(key).map(|n| n.value);
    let height = table.get("height").map(|node| as_number(node).map_or(Height::Auto, Height::Pixels));
    let background = table.get("background").map(|node| {
        let value = as_rgb(node).map_or(Background::Transparent, Background::Color);
        Spanned { value, span: node.span.clone() }
    });
    Canvas {
        width: number("width"),
        height,
        margin: number("margin"),
        background,
        text: number("text"),
        columns: table.count("columns").map(|n| n.value),
        theme: table.text("theme"),
    }
}
