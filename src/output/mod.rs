//! One format a file: a [`Drawing`], or a sequence of them, to bytes, and bytes back to what they show.
//!
//! A format is a row in [`FORMATS`] and sees nothing but the display list, so every format shows the same.
//! The row says what else the bytes depend on and how they are read again, so that no other room knows a
//! format by its name or by its first bytes. The same drawing gives the same bytes on every machine.

mod apng;
mod base64;
mod curves;
mod embedded;
mod gallery;
mod gif;
mod handout;
mod heading;
mod hold;
mod html;
mod item_package;
mod live_book;
mod live_page;
mod moodle;
mod motion;
mod number;
mod page;
mod page_colors;
mod pdf;
mod picture;
mod png;
mod pptx;
mod question;
mod raster;
mod refusal;
mod sha256;
mod stepper;
mod svg;
mod validity;
mod xml;
mod zip;

use crate::drawing::Drawing;

pub(crate) use base64::{base64, of_base64};
pub use gallery::{Gallery, gallery};
pub use handout::{Handout, MOST_A_SHEET, PAPERS, Paper};
pub use heading::Heading;
pub use hold::InSteps;
pub use item_package::ItemPackage;
pub use live_book::live_book_runtime;
pub use live_page::{LivePage, Module, live_runtime};
pub use moodle::Quiz;
use motion::InMotionWriter;
pub use motion::{InMotion, MOST_DOTS};
pub use picture::TooMuch;
pub(crate) use picture::{Later, Picture, Rows, Unread};
pub(crate) use png::ImageWriter;
pub use question::Numerical;
pub(crate) use raster::Pixel;
pub use raster::{Pixels, rasterize};
pub use refusal::OutputError;
pub(crate) use svg::inline::inline_with;
pub use svg::inline::{data_uri, inline, short_id};
pub(crate) use svg::read::sheets_apart;
pub(crate) use svg::{found_words, key as svg_key, text_with as svg_with};

/// A row in the table of formats.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// The word for it on the command line, and the end of its files' names.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// What kind of file it is, as IANA names them.
    pub media_type: &'static str,
    /// Whether it is written where nobody says which formats.
    pub usual: bool,
    /// Whether a file follows its reader into the dark, where the theme has a dark side; an image does not.
    pub in_the_dark: bool,
    /// Which options its bytes depend on.
    pub(crate) depends: Depends,
    /// How a drawing becomes its bytes.
    pub write: Writer,
    /// How all steps of a drawing become one file; none where a file has room for one of them only.
    pub(crate) in_steps: Option<InStepsWriter>,
    /// How all pictures of a drawing that plays become one file; none where a file has room for one only.
    pub(crate) in_motion: Option<InMotionWriter>,
    /// How it writes several drawings as one file; `None` where a file has room for one of them only.
    pub(crate) bind: Option<Binder>,
    /// How its files begin and end.
    pub(crate) bracket: Bracket,
    /// How a page is written whose figure a reader can drag; `None` where the format has no such pages.
    pub live: Option<WriteLive>,
    /// How its files are read again; `None` where they say nothing of themselves and are compared byte by
    /// byte.
    pub(crate) read: Option<Reader>,
}

/// What a format makes a file of.
#[derive(Clone, Copy, Debug)]
pub enum Writer {
    /// One drawing.
    One(fn(&Drawing, &Options) -> Result<Vec<u8>, OutputError>),
    /// Drawings of one size, one after the other.
    Sequence(fn(&[&Drawing], &Options) -> Result<Vec<u8>, OutputError>),
}

/// Writes a page whose figure a reader can drag.
pub type WriteLive = fn(&Drawing, &LivePage<'_>) -> Result<Vec<u8>, OutputError>;
/// Makes one file of all steps of a drawing.
pub(crate) type InStepsWriter = fn(&Drawing, &Options, InSteps) -> Result<Vec<u8>, OutputError>;

/// Writes several drawings as one file.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Binder {
    /// On sheets of paper.
    Sheets(fn(&[handout::Sheet<'_>]) -> Result<Vec<u8>, OutputError>),
    /// On slides: one for each, or where the options say so for each of its steps.
    Slides(fn(&[&Drawing], &Options) -> Result<Vec<u8>, OutputError>),
}

/// Which of the [`Options`] the bytes of a format depend on. A file is not out of date because of another
/// option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Depends {
    /// On none of them: a page of outlines has no pixels.
    Page,
    /// On the scale.
    Pixels,
    /// On the scale, and on how the pixels are packed.
    Packing,
}

/// How a file of a format begins and ends, blanks aside, whoever wrote it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// One of these is its beginning.
    pub(crate) begins: &'static [&'static [u8]],
    /// One of these is its end.
    pub(crate) ends: &'static [&'static [u8]],
}

/// How the files of a format are read again.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reader {
    /// What a file says of itself; `None` where it is of another format or says nothing.
    pub(crate) stamp: Reads<Stamped>,
    /// What a file shows. A format without it is compared as text.
    pub(crate) picture: Option<Shows>,
}

/// Finds something in the bytes of a file; `None` where they do not hold it.
pub(crate) type Reads<T> = fn(&[u8]) -> Option<T>;

/// Finds what a file shows.
pub(crate) type Shows = fn(&[u8]) -> Result<Picture<'_>, Unread>;

/// What a file says of itself, as the drawing had it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Stamped {
    /// All that the drawing says of itself: [`Drawing::metadata`].
    Metadata(String),
    /// The hash alone, [`Drawing::hash`], where the format has no place for more.
    Hash(String),
}

/// Every format.
pub const FORMATS: [Format; 7] =
    [svg::FORMAT, png::FORMAT, pdf::FORMAT, html::FORMAT, apng::FORMAT, gif::FORMAT, pptx::FORMAT];

/// The format of the picture inside a live page.
pub const INLINE: Format = svg::FORMAT;

/// The format of an image that is no drawing, as [`crate::drift::triptych`] gives.
pub(crate) const IMAGE: Format = png::FORMAT;

/// The format of that name.
///
/// ```
/// assert!(tracefig::output::format("svg").is_some());
/// assert!(tracefig::output::format("doc").is_none());
/// ```
#[must_use]
pub fn format(name: &str) -> Option<&'static Format> {
    FORMATS.iter().find(|format| format.name == name)
}

impl Format {
    /// Whether it writes several figures as one document: a [`Handout`].
    ///
    /// ```
    /// use tracefig::output::format;
    /// assert!(format("pdf").unwrap().has_sheets());
    /// assert!(!format("svg").unwrap().has_sheets());
    /// ```
    #[must_use]
    pub fn has_sheets(&self) -> bool {
        matches!(self.bind, Some(Binder::Sheets(_)))
    }

    /// Whether it writes several figures as one presentation: [`Format::slides`].
    ///
    /// ```
    /// use tracefig::output::format;
    /// assert!(format("pptx").unwrap().has_slides());
    /// assert!(!format("pdf").unwrap().has_slides());
    /// ```
    #[must_use]
    pub fn has_slides(&self) -> bool {
        matches!(self.bind, Some(Binder::Slides(_)))
    }

    /// Writes figures as one presentation: a slide for each, or for each of its steps where the options ask
    /// for steps.
    ///
    /// # Errors
    ///
    /// [`OutputError::NoSlides`] where the format has none or there is no figure, else what the format says.
    ///
    /// ```
    /// use tracefig::{figure::{draw_in_steps, plan}, output::{InSteps, Options, format}, scene::open_text};
    /// let text = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let file = open_text("s.toml", text)?;
    /// let plan = plan(&file.scene).unwrap();
    /// let drawing = draw_in_steps(&plan, plan.theme, "f").drawing;
    /// let options = Options { steps: Some(InSteps::default()), ..Options::default() };
    /// let deck = format("pptx").unwrap().slides(&[&drawing, &drawing], &options)?;
    /// assert!(deck.starts_with(b"PK"));
    /// assert!(format("svg").unwrap().slides(&[&drawing], &options).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn slides(&self, drawings: &[&Drawing], options: &Options) -> Result<Vec<u8>, OutputError> {
        match self.bind {
            Some(Binder::Slides(write)) if !drawings.is_empty() => write(drawings, options),
            _ => Err(OutputError::NoSlides),
        }
    }

    /// What the bytes of a file depend on besides its scene: the format, the theme's word and those options
    /// that make a difference to this format. Two calls give the same text exactly where the same scene gives
    /// the same bytes.
    ///
    /// ```
    /// use tracefig::output::{Options, format};
    /// let (twice, thrice) = (Options::default(), Options { scale: 3.0, ..Options::default() });
    /// let key = |name: &str, options| format(name).unwrap().key("dark", options);
    /// assert_eq!(key("png", &twice), "png theme=dark scale=2 png=fast");
    /// assert_eq!(key("svg", &twice), key("svg", &thrice));
    /// assert_ne!(key("apng", &twice), key("apng", &thrice));
    /// ```
    #[must_use]
    pub fn key(&self, theme: &str, options: &Options) -> String {
        let Options { scale, png, steps, motion } = options;
        let plays = motion.map_or_else(String::new, InMotion::key);
        let page = page_key(self.name, theme) + &steps.map_or_else(String::new, InSteps::key) + &plays;
        match self.depends {
            Depends::Page => page,
            Depends::Pixels => format!("{page} scale={scale}"),
            Depends::Packing => format!("{page} scale={scale} png={}", png.word()),
        }
    }

    /// Whether a page of this format in steps shows a narrow window [`Drawing::narrow`].
    ///
    /// ```
    /// use tracefig::output::format;
    /// assert!(format("html").unwrap().has_narrow_pages());
    /// assert!(!format("svg").unwrap().has_narrow_pages());
    /// ```
    #[must_use]
    pub fn has_narrow_pages(&self) -> bool {
        self.live.is_some()
    }

    /// Whether one file of this format can hold all steps of a drawing. Of the others each step is a file.
    ///
    /// ```
    /// use tracefig::output::format;
    /// assert!(format("svg").unwrap().holds_steps() && !format("png").unwrap().holds_steps());
    /// ```
    #[must_use]
    pub fn holds_steps(&self) -> bool {
        self.in_steps.is_some()
    }

    /// A drawing as a file of this format: the finished figure, or all its steps or its motion where the
    /// options say so and [`Format::holds_steps`] or [`Format::holds_motion`].
    ///
    /// # Errors
    ///
    /// As [`OutputError`] says.
    ///
    /// ```
    /// use tracefig::{figure::{draw_in_steps, plan}, output::{InSteps, Options, format}, scene::open_text};
    /// let text = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let file = open_text("s.toml", text)?;
    /// let plan = plan(&file.scene).unwrap();
    /// let drawing = draw_in_steps(&plan, plan.theme, "f").drawing;
    /// let options = Options { steps: Some(InSteps::default()), ..Options::default() };
    /// let svg = format("svg").unwrap().encode(&drawing, &options)?;
    /// assert!(String::from_utf8(svg)?.contains("<g data-step=\"2\">"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn encode(&self, drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
        if let (Some(in_steps), Some(write)) = (options.steps, self.in_steps) {
            return write(drawing, options, in_steps);
        }
        if let (Some(in_motion), Some(write)) = (options.motion, self.in_motion) {
            return write(drawing, options, in_motion);
        }
        if drawing.takes_away() {
            return self.encode(&drawing.clone().finished(), &Options { steps: None, ..*options });
        }
        match self.write {
            Writer::One(write) => write(drawing, options),
            Writer::Sequence(write) => write(&[drawing], options),
        }
    }
}

/// What the bytes of a page of outlines depend on besides its scene, as [`Format::key`] says it.
fn page_key(format: &str, theme: &str) -> String {
    format!("{format} theme={theme}")
}

/// What may be asked of a format; those that it does not concern it ignores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Pixels of the image for a page pixel.
    pub scale: f64,
    /// How a PNG is packed.
    pub png: PngEffort,
    /// How all steps of a figure are written; none writes the finished figure.
    pub steps: Option<InSteps>,
    /// How the motion of a figure is written; none writes the finished figure.
    pub motion: Option<InMotion>,
}

impl Default for Options {
    /// Twice the page's size, packed fast.
    fn default() -> Self {
        Self { scale: 2.0, png: PngEffort::Fast, steps: None, motion: None }
    }
}

/// How much time goes into a smaller PNG; the pixels are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PngEffort {
    /// Milliseconds a figure.
    #[default]
    Fast,
    /// Tenths of a second a figure, for a file that is much smaller.
    Small,
}

impl PngEffort {
    /// Every effort, the least first.
    pub const ALL: [Self; 2] = [Self::Fast, Self::Small];

    /// The word for it on the command line: "fast" or "small".
    ///
    /// ```
    /// use tracefig::output::PngEffort;
    /// assert_eq!(PngEffort::ALL.map(PngEffort::word), ["fast", "small"]);
    /// ```
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Small => "small",
        }
    }
}

/// Pixels of the largest image: 2²⁶, of which four bytes each are kept.
pub const MOST_PIXELS: f64 = 67_108_864.0;

/// Bytes of the largest file that is read again, 64 MiB. The largest figure that may be drawn, 250,000 points
/// of text or 2²⁶ pixels that repeat from row to row, has some 10 MB; a scene has no more memory than eight
/// times as much.
pub const MOST_BYTES: usize = 64 << 20;

#[cfg(test)]
mod samples;
#[cfg(test)]
mod tests;
