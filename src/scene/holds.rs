//! What a key of a scene may hold, and how messages say it.

use super::limits::MAX_NUMBER;

/// What a key holds.
#[derive(Clone, Copy, Debug)]
pub enum Holds {
    /// Any text.
    Text,
    /// One of the known words.
    Word {
        /// What the word is, as "algorithm", for messages.
        what: &'static str,
        /// Every word that it may be.
        known: fn() -> Vec<String>,
    },
    /// A finite number in a closed range.
    Number {
        /// The smallest that is allowed.
        min: f64,
        /// The largest that is allowed.
        max: f64,
    },
    /// A finite number in a closed range, or a word.
    NumberOr {
        /// The smallest that is allowed.
        min: f64,
        /// The largest that is allowed.
        max: f64,
        /// What may stand instead.
        word: &'static str,
    },
    /// A colour `#RRGGBB`, or a word.
    ColorOr(
        /// What may stand instead.
        &'static str,
    ),
    /// A whole number in a closed range.
    Count {
        /// The smallest that is allowed.
        min: usize,
        /// The largest that is allowed.
        max: usize,
    },
    /// true or false.
    Switch,
    /// Two numbers `[x, y]`.
    Pair,
    /// A rectangle `[x0, y0, x1, y1]` by two opposite corners.
    Rectangle,
    /// A rectangle, or a word.
    RectangleOr(
        /// What may stand instead.
        &'static str,
    ),
    /// A list of points `[x, y]`.
    Points,
    /// Names of shapes of the scene.
    Names,
    /// Names of shapes, each alone or with a word for something of it.
    Drags,
    /// A text or a list of texts; the words say of what.
    Texts(&'static str),
    /// A number in [0, 1], or a word of [`super::When`].
    Moment,
    /// A direction such as "NE", or an offset `[dx, dy]` in page pixels.
    LabelPlace,
    /// Layers, by name or as tables.
    Layers,
    /// Tables by name; the words say of what.
    Tables(&'static str),
    /// A list; the words say of what.
    List(&'static str),
    /// A table with rows of its own.
    Table,
    /// Anything; not read.
    Anything,
}

impl Holds {
    /// What is expected, for messages.
    ///
    /// ```
    /// use tracefig::scene::Holds;
    /// assert_eq!(Holds::Number { min: 0.0, max: 1.0 }.expected(), "a number in [0, 1]");
    /// ```
    #[must_use]
    pub fn expected(&self) -> String {
        match *self {
            Self::Text => "a text".to_owned(),
            Self::Word { what, .. } => format!("a word, the {what}"),
            Self::Number { min, max } => match (min == -MAX_NUMBER, max == MAX_NUMBER) {
                (true, _) => "a number".to_owned(),
                (false, true) => format!("a number of at least {min}"),
                (false, false) => format!("a number in [{min}, {max}]"),
            },
            Self::NumberOr { min, max, word } => format!("a number in [{min}, {max}], or \"{word}\""),
            Self::ColorOr(word) => format!("a colour \"#RRGGBB\", or \"{word}\""),
            Self::Count { min, max } => format!("a whole number in [{min}, {max}]"),
            Self::Switch => "true or false".to_owned(),
            Self::Pair => "two numbers [x, y]".to_owned(),
            Self::Rectangle => "four numbers [x0, y0, x1, y1]".to_owned(),
            Self::RectangleOr(word) => format!("four numbers [x0, y0, x1, y1], or \"{word}\""),
            Self::Points => "a list of points [[x, y], …]".to_owned(),
            Self::Names => "a list of names of shapes".to_owned(),
            Self::Drags => "a list of shapes, or of what they have, as [\"A\", \"B.velocity\"]".to_owned(),
            Self::Texts(what) => format!("{what}: a text or a list of texts"),
            Self::Moment => {
                "a number in [0, 1], \"start\", \"hit\", \"closest\", \"bound\" or \"end\"".to_owned()
            }
            Self::LabelPlace => {
                "one of \"E\", \"NE\", \"N\", \"NW\", \"W\", \"SW\", \"S\", \"SE\", or [dx, dy]".to_owned()
            }
            Self::Layers => "a list of layers, each a name or a table { layer = \"…\", … }".to_owned(),
            Self::Tables(what) => format!("a table of {what} by name"),
            Self::List(what) => format!("a list of {what}"),
            Self::Table => "a table".to_owned(),
            Self::Anything => "anything".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::When;

    #[test]
    fn every_word_of_a_moment_is_expected() {
        let expected = Holds::Moment.expected();
        let unsaid = When::WORDS.iter().filter(|(word, _)| !expected.contains(&format!("\"{word}\"")));
        assert_eq!(unsaid.count(), 0, "{expected}");
        assert_eq!(expected.matches('"').count(), 2 * When::WORDS.len());
    }
}
