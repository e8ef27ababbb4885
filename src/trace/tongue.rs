//! The languages in which sentences of ours are told, and how numbers stand in them.
//!
//! A sentence is a [`Phrase`], the same one in every language, with stars for its values. No sentence is made
//! from another one: a language has its own words around the values, which stand in the same order.

use super::foreign::text;

/// A phrase in English, German, French and Spanish. A star stands for a value, in their order.
#[cfg(not(tracefig_page))]
pub(crate) type Phrase = [&'static str; 4];

/// A phrase in English: a page has the others, where it is in one of them ([`text`]).
#[cfg(tracefig_page)]
pub(crate) type Phrase = [&'static str; 1];

/// What this program has of a phrase.
pub(crate) const fn phrase(all: [&'static str; 4]) -> Phrase {
    #[cfg(tracefig_page)]
    let all = [all[0]];
    all
}

/// What stands in a phrase for a value.
const STAR: char = '*';

/// Declares phrases, and the list of them: for tests alone where no page says them.
macro_rules! phrases {
    (listed for tests; $($rows:tt)+) => {
        $crate::trace::phrases! { @listed [#[cfg(test)]] $($rows)+ }
    };
    (@listed [$($when:tt)*]
        $($(#[doc = $about:literal])+ $NAME:ident: $en:literal, $de:literal, $fr:literal, $es:literal;)+) => {
        $(
            $(#[doc = $about])+
            pub(crate) static $NAME: $crate::trace::Phrase = $crate::trace::phrase([$en, $de, $fr, $es]);
        )+

        /// Every phrase of this file.
        $($when)*
        pub(crate) const ALL: &[&$crate::trace::Phrase] = &[$(&$NAME),+];
    };
    ($($rows:tt)+) => {
        $crate::trace::phrases! { @listed [] $($rows)+ }
    };
}
pub(crate) use phrases;

/// A language of sentences, and the sign that its numbers have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tongue {
    /// Which of a [`Phrase`].
    column: usize,
    /// Whether numbers have a comma: points then have a semicolon.
    has_comma: bool,
}

impl Tongue {
    /// English, with points in its numbers.
    pub(crate) const ENGLISH: Self = Self { column: 0, has_comma: false };

    /// A column of the phrases, with a comma in its numbers or a point.
    pub(crate) const fn new(column: usize, has_comma: bool) -> Self {
        Self { column, has_comma }
    }

    /// A phrase without a star.
    pub(crate) fn word(self, phrase: &[&'static str]) -> &'static str {
        text(phrase, self.column)
    }

    /// A phrase with the values that stand for its stars.
    pub(crate) fn say(self, phrase: &[&'static str], values: &[&str]) -> String {
        self.filled(self.word(phrase), values)
    }

    /// Words with the values that stand for their stars.
    pub(crate) fn filled(self, words: &str, values: &[&str]) -> String {
        let mut pieces = words.split(STAR);
        let mut said = pieces.next().unwrap_or_default().to_owned();
        for (piece, value) in pieces.zip(values) {
            self.meet(&mut said, value);
            said.push_str(value);
            said.push_str(piece);
        }
        said
    }

    /// Changes the last word of a phrase for the word that follows: French "de" before a vowel, Spanish "y"
    /// before an i. A letter alone is a symbol, and changes nothing.
    fn meet(self, said: &mut String, next: &str) {
        let (word, by) = match self.column {
            2 => (" de ", " d’"),
            3 => (" y ", " e "),
            _ => return,
        };
        let mut letters = next.chars().flat_map(char::to_lowercase);
        let [first, second, third] = [(); 3].map(|()| letters.next().unwrap_or(' '));
        let is_met = match (first, second) {
            _ if self.column == 2 => "aeiouàâéèêëîïôœûù".contains(first) && second.is_alphabetic(),
            ('i' | 'í', after) => after.is_alphabetic() && !"aeou".contains(after),
            ('h', 'i' | 'í') => !"aeou".contains(third),
            _ => false,
        };
        if is_met && said.ends_with(word) {
            said.truncate(said.len() - word.len());
            said.push_str(by);
        }
    }

    /// A number, or several, that are written with points.
    pub(crate) fn decimal(self, number: String) -> String {
        if self.has_comma { number.replace('.', ",") } else { number }
    }

    /// A point by its coordinates, written with points.
    pub(crate) fn point(self, [x, y]: [String; 2]) -> String {
        self.decimal(format!("({x}{}{y})", self.between()))
    }

    /// What parts two numbers or points.
    pub(crate) const fn between(self) -> &'static str {
        if self.has_comma { "; " } else { ", " }
    }

    /// What parts two phrases with numbers: a semicolon in French has a space before it.
    pub(crate) const fn between_phrases(self) -> &'static str {
        if self.column == 2 { " ; " } else { self.between() }
    }
}

/// Phrases of which a language has another count of stars than English.
#[cfg(test)]
pub(crate) fn unlike(all: impl IntoIterator<Item = &'static Phrase>) -> Vec<&'static Phrase> {
    let stars = |said: &str| said.matches(STAR).count();
    let is_unlike = |phrase: &Phrase| phrase.iter().any(|said| stars(said) != stars(phrase[0]));
    all.into_iter().filter(|phrase| is_unlike(phrase)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    static IS: Phrase = ["* is *", "* ist *", "* est *", "* es *"];

    #[test]
    fn values_stand_for_stars_and_a_star_in_a_value_stays() {
        assert_eq!(Tongue::new(1, true).say(&IS, &["A*", "B"]), "A* ist B");
        assert_eq!(Tongue::ENGLISH.say(&IS, &["A", "B"]), "A is B");
        assert_eq!(unlike([&IS]), [&[""; 4]; 0]);
    }

    #[test]
    fn little_words_change_before_the_names_that_follow() {
        let [french, spanish] = [2, 3].map(|column| Tongue::new(column, true));
        let of: Phrase = [" of *", " von *", "le centre de *", "el centro de *"];
        let both: Phrase = ["* and *", "* und *", "* et *", "* y *"];
        for (name, said) in [("Ile", "d’Ile"), ("Éclair", "d’Éclair"), ("A", "de A"), ("Mur", "de Mur")]
        {
            assert_eq!(french.say(&of, &[name]), format!("le centre {said}"));
        }
        for (name, said) in
            [("Isla", "e Isla"), ("Higo", "e Higo"), ("Hielo", "y Hielo"), ("Casa", "y Casa"), ("B", "y B")]
        {
            assert_eq!(spanish.say(&both, &["Mar", name]), format!("Mar {said}"));
        }
        assert_eq!(french.say(&of, &["0,5"]), "le centre de 0,5");
    }

    #[test]
    fn where_numbers_have_commas_coordinates_have_semicolons() {
        let at = || ["1.5".to_owned(), "-2".to_owned()];
        assert_eq!(Tongue::new(1, true).point(at()), "(1,5; -2)");
        assert_eq!(Tongue::new(3, false).point(at()), "(1.5, -2)");
    }
}
