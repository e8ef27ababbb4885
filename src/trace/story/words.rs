//! Numbers, points and moments in the words of a story.

use super::hand::{Hand, number, short};
use super::phrases::events::OUTCOMES;
use super::phrases::{
    AT_ANGLE, AWAY, BOTH, CENTER, EDGE, INSIDE, INSIDE_LINE, LESS, NEAR_LINE, OUTLINE_AROUND, OUTSIDE_LINE,
    ROUNDING_AT, SPAN, VERTEX, VERTEX_AT,
};
use super::place::place;
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side, power_of_ten, read};
use crate::trace::tongue::{Phrase, Tongue};
use crate::trace::{Moment, SupportVertex};

/// The share of a point's larger coordinate, and for readers of a figure of the size of the pair, below which
/// a coordinate is what rounding left of a 0, and told as 0: a thousand times what a few roundings leave. A
/// distance that small is told as less than a power of ten, as it may be proved not to be 0. The JSON lines
/// have every bit.
const NOTHING: f64 = 1e-12;
/// Digits in all that numbers have.
const DIGITS: f64 = 6.0;
/// How finely a place is told where nobody says how large the bodies are, world units: below that six digits
/// in all take it near the origin.
const THOUSANDTHS: f64 = 1e-3;
/// Coordinates up to this are told as other numbers: those of directions are.
const DIRECTION: f64 = 1.0;

/// Whose story it is and in which language: every number, point and name in it goes through here.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Voice<'n> {
    /// What the bodies are called.
    pub(crate) names: &'n Names,
    /// The language.
    pub(crate) tongue: Tongue,
    /// For whom its numbers and signs are written.
    pub(crate) hand: Hand,
    /// The size of the pair in world units, by which a length is told to be next to nothing; 0 where all are
    /// told.
    pub(crate) size: f64,
    /// How finely places are told at least, world units.
    pub(crate) unit: f64,
}

impl<'n> Voice<'n> {
    /// A story in English.
    pub(super) const fn english(names: &'n Names) -> Self {
        Self { names, tongue: Tongue::ENGLISH, hand: Hand::Terminal, size: 0.0, unit: THOUSANDTHS }
    }

    /// With the digits that pictures have, for titles.
    pub(super) fn in_short(self) -> Self {
        Self { hand: Hand::Title, ..self }
    }

    /// A phrase with the values that stand for its stars.
    pub(crate) fn say(self, phrase: &Phrase, values: &[&str]) -> String {
        self.tongue.say(phrase, values)
    }

    /// What came out, which events tell in English.
    pub(super) fn outcome<'o>(self, outcome: &'o str) -> &'o str
    where
        'n: 'o,
    {
        let known = OUTCOMES.iter().find(|phrase| phrase[0] == outcome);
        known.map_or(outcome, |phrase| self.tongue.word(phrase))
    }

    /// A phrase without a star.
    pub(super) fn word(self, phrase: &Phrase) -> String {
        self.tongue.word(phrase).to_owned()
    }

    /// The name of a body.
    pub(super) fn of(self, side: Side) -> String {
        self.names.quoted(side)
    }

    /// All names: "A and B".
    pub(crate) fn all(self) -> String {
        let [a, b] = Side::BOTH.map(|side| self.of(side));
        if b.is_empty() { a } else { self.say(&BOTH, &[&a, &b]) }
    }

    /// A moment, with the angles where a body is turned.
    pub(crate) fn moment(self, at: &Moment) -> String {
        let time = format!("t = {}", self.number(at.time));
        if at.angle_a == 0.0 && at.angle_b == 0.0 {
            return time;
        }
        let of_each = [(Side::A, at.angle_a), (Side::B, at.angle_b)];
        let there = of_each.into_iter().filter(|(side, _)| !self.names.of(*side).is_empty());
        let turned = there.map(|(side, angle)| self.say(&AT_ANGLE, &[&self.of(side), &self.number(angle)]));
        let between = self.tongue.between_phrases();
        format!("{time} ({})", turned.collect::<Vec<_>>().join(between))
    }

    /// Vertices in words: "vertex 0 at (1, 2) and vertex 1 at (3, 4)".
    pub(super) fn list(self, vertices: &[SupportVertex]) -> String {
        self.farthest(None, vertices)
    }

    /// What lies farthest of a body, at these vertices of its core: they, or what is around them where it
    /// has a radius.
    pub(super) fn farthest(self, side: Option<Side>, vertices: &[SupportVertex]) -> String {
        let mut all = vertices.iter().map(|vertex| self.around(side, vertex));
        let first = all.next().unwrap_or_default();
        all.fold(first, |before, next| self.say(&BOTH, &[&before, &next]))
    }

    /// What lies farthest of a body at a vertex of its core.
    pub(super) fn around(self, side: Option<Side>, vertex: &SupportVertex) -> String {
        let (index, point) = (vertex.index.to_string(), self.point(vertex.point));
        match side {
            Some(side) if self.names.is_of_circle(side) => self.say(&OUTLINE_AROUND, &[&point]),
            Some(side) if self.names.is_round(side) => self.say(&ROUNDING_AT, &[&index, &point]),
            _ => self.say(&VERTEX_AT, &[&index, &point]),
        }
    }

    /// Points, one after the other.
    pub(super) fn points(self, vertices: &[DVec2]) -> String {
        let all: Vec<String> = vertices.iter().map(|&p| self.point(p)).collect();
        match &all[..] {
            [] => String::new(),
            [one] => one.clone(),
            [first @ .., last] => self.say(&BOTH, &[&first.join(self.tongue.between()), last]),
        }
    }

    /// A distance from the boundary in words: "2 inside" or "2 away".
    pub(super) fn away(self, distance: f64) -> String {
        self.say(if distance < 0.0 { &INSIDE } else { &AWAY }, &[&self.length(distance.abs())])
    }

    /// A distance from a line in words, of the origin from the line of an edge that is so `far` away: "2
    /// inside" or "2 outside". What is next to nothing is rounding, and may be on either side.
    pub(super) fn aside(self, distance: f64, far: f64) -> String {
        let voice = Self { size: self.size.max(far), ..self };
        if distance != 0.0 && distance.abs() < NOTHING * voice.size {
            return self.say(&NEAR_LINE, &[&voice.length(distance.abs())]);
        }
        let phrase = if distance < 0.0 { &INSIDE_LINE } else { &OUTSIDE_LINE };
        self.say(phrase, &[&self.length(distance.abs())])
    }

    /// An interval: "0 to 2".
    pub(super) fn interval(self, x: Enclosure) -> String {
        let least = NOTHING * x.hi.abs().max(x.lo.abs()).max(self.size);
        let [lo, hi] = [x.lo, x.hi].map(|end| if end.abs() < least { 0.0 } else { end });
        let [lo, hi] = [lo, hi].map(|end| self.tongue.decimal(self.place(end)));
        self.say(&SPAN, &[&lo, &hi])
    }

    /// A vertex or an edge of a body by its index, or the centre of a circle.
    pub(super) fn part(self, (side, feature): (Side, Feature)) -> String {
        match feature {
            Feature::Vertex(_) if self.names.is_of_circle(side) => self.word(&CENTER),
            Feature::Vertex(i) => self.say(&VERTEX, &[&i.to_string()]),
            Feature::Edge(i) => self.say(&EDGE, &[&i.to_string()]),
        }
    }

    /// A point; a coordinate that is rounding beside the other one, or the size of the pair, is told as 0.
    pub(super) fn point(self, p: DVec2) -> String {
        let least = NOTHING * p.abs().max_element().max(self.size);
        self.tongue.point([p.x, p.y].map(|x| self.place(if x.abs() < least { 0.0 } else { x })))
    }

    /// A number.
    pub(super) fn number(self, x: f64) -> String {
        self.tongue.decimal(self.digits(x))
    }

    /// A number of which is said that something is no more.
    pub(super) fn at_most(self, x: f64) -> String {
        let is_less = read(&number(x)).is_some_and(|told| told < x);
        let unit = power_of_ten(libm::floor(libm::log10(x.abs())) + 1.0 - DIGITS);
        self.number(if is_less { x + 0.5 * unit } else { x })
    }

    /// A number of which only the size matters, to few digits.
    pub(super) fn few(self, x: f64) -> String {
        let digits = short(x);
        let terminal = matches!(self.hand, Hand::Terminal);
        self.tongue.decimal(if terminal { digits } else { Hand::written(&digits) })
    }

    /// A length; one that is next to nothing beside the pair is less than a power of ten.
    pub(super) fn length(self, x: f64) -> String {
        if x == 0.0 || x.abs() >= NOTHING * self.size {
            return self.number(x);
        }
        let above = power_of_ten(libm::floor(libm::log10(x.abs())) + 1.0);
        self.say(&LESS, &[&self.number(above)])
    }

    /// The quantity of a body that has a letter.
    pub(super) fn symbol(self, letter: &str, side: Side) -> String {
        match self.hand {
            Hand::Type => format!("{letter}{}", script(side)),
            Hand::Terminal | Hand::Words | Hand::Title => {
                let name = self.of(side);
                let is_letter = name.chars().nth(1).is_none();
                if is_letter { format!("{letter}_{name}") } else { format!("{letter}({name})") }
            }
        }
    }

    /// What subtracts.
    pub(super) const fn minus(self) -> &'static str {
        if matches!(self.hand, Hand::Terminal) { "-" } else { "−" }
    }

    /// The name of B ⊖ A.
    pub(crate) fn difference(self) -> String {
        format!("{} ⊖ {}", self.of(Side::B), self.of(Side::A))
    }

    /// A number with a decimal point.
    fn digits(self, x: f64) -> String {
        self.written(&self.cut(x))
    }

    /// A coordinate with a decimal point.
    fn place(self, x: f64) -> String {
        let text = self.cut(x);
        self.written(&if x.abs() > DIRECTION { place(x, text, self.unit) } else { text })
    }

    /// A number in as many digits as this hand writes, with the signs of a terminal.
    fn cut(self, x: f64) -> String {
        if matches!(self.hand, Hand::Title) { short(x) } else { number(x) }
    }

    /// A number with the signs of this hand.
    fn written(self, number: &str) -> String {
        if matches!(self.hand, Hand::Terminal) { number.to_owned() } else { Hand::written(number) }
    }
}

/// The character that stands for a body's name as the script of a letter, where signs are set: one for
/// private use, which no text has.
pub(crate) const fn script(side: Side) -> char {
    match side {
        Side::A => '\u{E002}',
        Side::B => '\u{E003}',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_left_of_a_zero_is_told_as_zero() {
        let names = Names::default();
        let told = |x, y| Voice::english(&names).point(DVec2::new(x, y));
        assert_eq!(told(4.4e-16, 5.0), "(0, 5)");
        assert_eq!(told(4e-16, 5e-16), "(4e-16, 5e-16)");
    }

    #[test]
    fn far_from_the_origin_places_keep_their_thousandths() {
        let names = Names::default();
        let told = |x, y| Voice::english(&names).point(DVec2::new(x, y));
        assert_eq!(told(1_000_002.5, 48_007.234_56), "(1000002.5, 48007.235)");
        assert_eq!(told(1.0 / 3.0, 4.0 / 3.0), "(0.333333, 1.33333)");
    }

    #[test]
    fn for_a_reader_of_a_figure_a_length_that_is_rounding_is_less_than_a_power_of_ten() {
        let names = Names::default();
        let voice = Voice { hand: Hand::Words, size: 5.0, ..Voice::english(&names) };
        assert_eq!(voice.length(4.54e-13), "less than 10^−12");
        assert_eq!(voice.length(-4.54e-11), "−4.54 × 10^−11");
        assert_eq!([voice.length(0.0), voice.length(-0.5)], ["0", "−0.5"]);
        assert_eq!(voice.point(DVec2::new(4.5e-13, -3.4e-14)), "(0, 0)");
        assert_eq!(Voice::english(&names).length(4.54e-13), "4.54e-13");
    }

    #[test]
    fn a_title_has_the_digits_of_a_picture() {
        let names = Names::default();
        let point = |p| Voice::english(&names).in_short().point(p);
        assert_eq!(point(DVec2::new(0.123_456, -2.162_5)), "(0.123, −2.1625)");
    }
}
