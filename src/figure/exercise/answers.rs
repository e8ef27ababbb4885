//! What an exercise asks, the numbers that answer it, and the way to them.

use crate::figure::context::Context;
use crate::figure::play::Play;
use crate::figure::runs::Runs;
use crate::figure::standing::lacking as of_this_answer;
use crate::figure::text::{Digits, NO_OTHER, filled, givers, in_math, rounded, value_of, with_powers};
use crate::figure::tongue::voice;
use crate::geometry::{Side, read};
use crate::scene::{Exercise, Scene, Space, Spanned};
use crate::trace::{Event, Hand, script, told};
use crate::typeset::as_markup;

use super::askable::{all, askable, in_words};
use super::givens::givens;
use super::measure::Measure;
use super::phrases::{
    ANSWER, BETWEEN, DIGITS, ENTER, EXACT, FIND, GAP_ALONG, IN_UNIT, LENGTHS_IN, TIMES_IN, UNIT, UNITS,
    WITHIN, Words,
};
use super::quantities::Askable;

/// Where the class writes a number.
const BLANK: &str = "____________";
/// What is asked of the gap of two AABBs, and along which axis.
const GAPS: [(&str, &str); 2] = [("D.x", "x"), ("D.y", "y")];
/// A share of a unit of the third digit: what is rounded to three digits is right.
const HALF_A_UNIT: f64 = 0.5;
/// Digits after the first one of an answer that is given to three.
const MORE_DIGITS: f64 = 2.0;
/// How far a double that is told without bounds may be off its three digits, in parts of it or of 1: what the
/// checker in `reference/` allows a normal.
const TOLD: f64 = 1e-14;
/// The part of an answer by which its bounds may lie off the number that is told, which then is the answer:
/// what proving them added to a round number, far below the third digit.
const ROUNDING: f64 = 1e-9;
/// Digits of the bounds that a key tells of any other answer: two more than the answer has.
const BOUND: Digits = Digits::Significant(5);
/// What an answer of 0 may be off: half a unit of the second decimal.
const OFF_ZERO: f64 = 0.005;

/// A number that an exercise asks for, with its answer. Its texts are markup.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The name of the value, as `depth`.
    pub name: &'static str,
    /// How it is written before the blank, as `$d$`.
    pub symbol: String,
    /// What it is, as "the depth by which A and B overlap".
    pub what: String,
    /// Its unit; empty where it has none.
    pub unit: String,
    /// Not above the answer.
    pub lo: f64,
    /// Not below the answer.
    pub hi: f64,
    /// Whether the exact answer is proved to lie between the two; else they are one number, rounded.
    pub is_proved: bool,
}

impl Asked {
    /// The answer: the number of three digits that lies within its bounds, else the middle of these.
    ///
    /// ```
    /// use tracefig::figure::exercise::Asked;
    /// let asked = Asked {
    ///     name: "d", symbol: "$d$".into(), what: "the distance".into(), unit: "m".into(),
    ///     lo: 0.49999999999999994, hi: 0.5,
    ///     is_proved: true,
    /// };
    /// assert_eq!((asked.value(), asked.tolerance() > 0.0005), (0.5, true));
    /// ```
    #[must_use]
    pub fn value(&self) -> f64 {
        let off = if self.is_proved { 0.0 } else { TOLD * self.hi.abs().max(1.0) };
        let within = self.short().filter(|&short| self.lo - off <= short && short <= self.hi + off);
        within.unwrap_or(0.5 * (self.lo + self.hi))
    }

    /// The number of three digits at most that both bounds round to; `None` where they round apart.
    pub(super) fn short(&self) -> Option<f64> {
        read(&Digits::Significant(3).of(self.lo, self.hi))
    }

    /// How far from [`Asked::value`] an answer may lie that counts as right, in the same unit: its bounds,
    /// and half a unit of the third digit.
    ///
    /// ```
    /// use tracefig::figure::exercise::Asked;
    /// let asked = Asked {
    ///     name: "d", symbol: "$d$".into(), what: "the distance".into(), unit: "m".into(),
    ///     lo: 2.25, hi: 2.25, is_proved: true,
    /// };
    /// assert_eq!(asked.tolerance(), 0.005);
    /// ```
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        let value = self.value();
        let unit = if value == 0.0 {
            OFF_ZERO
        } else {
            HALF_A_UNIT * libm::pow(10.0, libm::floor(libm::log10(value.abs())) - MORE_DIGITS)
        };
        unit + (self.hi - value).max(value - self.lo)
    }

    /// The answer as the key has it, as markup: three digits at most, the unit, and the bounds: how much it
    /// is off at most where that is rounding, else what it is proved to lie between, to five digits.
    ///
    /// ```
    /// use tracefig::figure::exercise::Asked;
    /// let asked = Asked {
    ///     name: "d", symbol: "$d$".into(), what: "the distance".into(), unit: "m".into(),
    ///     lo: 2.25, hi: 2.25, is_proved: true,
    /// };
    /// assert_eq!(asked.line(), "Answer: $d = 2.25$ m, proved to be exact.");
    /// let rounded = Asked { hi: 2.2500000000000004, ..asked.clone() };
    /// assert_eq!(rounded.line(), "Answer: $d = 2.25$ m, proved to within $10^{-15}$.");
    /// let wide = Asked { lo: 0.601252, hi: 0.601253, ..asked };
    /// assert_eq!(
    ///     wide.line(),
    ///     r"Answer: $d \approx 0.601$ m, proved to lie between $0.60125$ and $0.60126$."
    /// );
    /// ```
    #[must_use]
    pub fn line(&self) -> String {
        self.line_in(Words::ENGLISH)
    }

    /// The answer as [`Asked::line`] has it, in the words of an exercise.
    pub(super) fn line_in(&self, words: Words) -> String {
        let (value, symbol) = (self.value(), self.symbol.trim_matches('$'));
        let text = rounded(self.lo, self.hi);
        let off = read(&text).map(|told| (self.hi - told).max(told - self.lo));
        let off = off.filter(|off| self.is_proved && *off <= ROUNDING * value.abs());
        let sign = if read(&text) == Some(value) || off.is_some() { "=" } else { r"\approx" };
        let [units, unit] = [&UNITS, &UNIT].map(|phrase| words.word(phrase));
        let unit = if text == "1" && self.unit == units { unit } else { &self.unit };
        let answer = format!("${symbol} {sign} {}$ {unit}", words.in_latex(in_math(&text)));
        let answer = words.say(&ANSWER, &[answer.trim_end()]);
        if !self.is_proved {
            return format!("{answer}.");
        }
        match off {
            Some(0.0) => words.say(&EXACT, &[&answer]),
            Some(off) => {
                let power = libm::floor(libm::log10(off)) + 1.0;
                words.say(&WITHIN, &[&answer, &format!("$10^{{{power}}}$")])
            }
            None => {
                let bounds = [BOUND.at_most(self.lo), BOUND.at_least(self.hi)];
                let [lo, hi] = bounds.map(|text| format!("${}$", words.in_latex(in_math(&text))));
                words.say(&BETWEEN, &[&answer, &lo, &hi])
            }
        }
    }

    /// Which number is to be typed, and in which unit, as markup.
    pub(super) fn to_enter(&self, words: Words) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { words.say(&IN_UNIT, &[&self.unit]) };
        words.say(&DIGITS, &[&(words.say(&ENTER, &[&self.symbol, &self.what]) + &unit)])
    }
}

/// What a scene asks for by name: the rows of the table, in the order of the exercise.
pub(super) fn rows(scene: &Scene, exercise: &Exercise) -> Vec<&'static Askable> {
    exercise.ask.iter().filter_map(|name| askable(&name.value, scene.query.kind)).collect()
}

/// What a row asks of a scene, as markup.
fn what(row: &Askable, scene: &Scene, runs: &Runs) -> String {
    let (names, words) = (runs.called.names(scene), Words::of(scene));
    let [a, b] = [Side::A, Side::B].map(|side| as_markup(&names.quoted(side)));
    let all = if b.is_empty() { vec![a.clone()] } else { vec![a.clone(), b.clone()] };
    // D is another thing for two AABBs.
    let axis = GAPS.iter().find(|(name, _)| *name == row.name).map(|(_, axis)| *axis);
    let run = runs.own(scene, scene.query.time);
    if let Some(axis) = axis.filter(|_| run.events().any(|e| matches!(e, Event::ExtentsCompared { .. }))) {
        return words.say(&GAP_ALONG, &[&words.listed(&all), axis]);
    }
    in_words(words.word(&row.what), [&words.listed(&all), &a, &b])
}

/// The unit of a row, as markup.
fn unit(row: &Askable, exercise: &Exercise, words: Words) -> String {
    let given = |unit: &Option<Spanned<String>>| unit.as_ref().map(|unit| unit.value.clone());
    match row.measure {
        Measure::Length => given(&exercise.length_unit).unwrap_or_else(|| words.word(&UNITS).to_owned()),
        Measure::Time => given(&exercise.time_unit).unwrap_or_default(),
        Measure::Degrees => "°".to_owned(),
        Measure::Pure => String::new(),
    }
}

/// In which units the numbers of an exercise are, where it gives them; as markup, after what is given.
fn units(exercise: &Exercise, words: Words) -> String {
    let given = [(&LENGTHS_IN, &exercise.length_unit), (&TIMES_IN, &exercise.time_unit)];
    let said = given.map(|(phrase, unit)| unit.as_ref().map(|unit| words.say(phrase, &[&unit.value])));
    said.into_iter().flatten().fold(String::new(), |all, text| all + " " + &text)
}

/// The numbers that answer an exercise, of the query's own moment; those that this answer lacks are left out.
pub(super) fn answers(scene: &Scene, runs: &Runs, exercise: &Exercise) -> Vec<Asked> {
    let context = of_the_query(scene, runs);
    let answer = |row: &'static Askable| {
        let quantity = value_of(row.name, &context)?;
        let symbol = format!("${}$", row.symbol);
        let (what, unit) = (what(row, scene, runs), unit(row, exercise, Words::of(scene)));
        Some(Asked {
            name: row.name,
            symbol,
            what,
            unit,
            lo: quantity.lo,
            hi: quantity.hi,
            is_proved: row.is_proved,
        })
    };
    rows(scene, exercise).into_iter().filter_map(answer).collect()
}

/// The names of all values that may be asked for and that this answer has, for a message.
pub(super) fn there(scene: &Scene, runs: &Runs) -> String {
    let context = of_the_query(scene, runs);
    let has = |row: &&Askable| (row.of)(scene.query.kind) && value_of(row.name, &context).is_some();
    all().filter(has).map(|row| format!("`{}`", row.name)).collect::<Vec<_>>().join(", ")
}

/// Why this answer lacks a value that may be asked for: another algorithm or question has it, or the bodies
/// stand otherwise.
pub(super) fn lacking(scene: &Scene, runs: &Runs, name: &str) -> String {
    let others = givers(name, &of_the_query(scene, runs)).filter(|others| others != NO_OTHER);
    let answer = &runs.own(scene, scene.query.time).answer;
    others.unwrap_or_else(|| of_this_answer(answer).to_owned())
}

/// What is to be done, as markup: the exercise's own words, or ours.
pub(super) fn to_do(scene: &Scene, runs: &Runs, exercise: &Exercise) -> String {
    if let Some(task) = &exercise.task {
        return task.value.clone();
    }
    let all: Vec<String> = rows(scene, exercise).iter().map(|row| what(row, scene, runs)).collect();
    let words = Words::of(scene);
    words.say(&FIND, &[&words.listed(&all)])
}

/// What is given and what is to be done, as paragraphs of markup.
pub(super) fn task(scene: &Scene, runs: &Runs, exercise: &Exercise) -> Vec<String> {
    let given = as_markup(&givens(scene, &runs.called.names(scene)));
    vec![given + &units(exercise, Words::of(scene)), to_do(scene, runs, exercise)]
}

/// The paragraphs of a question, as markup: what is given, what is to be done, a blank for each number.
pub(super) fn question(scene: &Scene, runs: &Runs, exercise: &Exercise) -> Vec<String> {
    let blank = |row: &'static Askable| {
        format!("${}$ = {BLANK} {}", row.symbol, unit(row, exercise, Words::of(scene))).trim_end().to_owned()
    };
    let blanks = rows(scene, exercise).into_iter().map(blank);
    task(scene, runs, exercise).into_iter().chain(blanks).collect()
}

/// What stands over the way in a key, as paragraphs of markup: what was to be done, each answer with its
/// bounds, and what the scene's own caption says of the figure.
pub(super) fn solved(scene: &Scene, runs: &Runs, exercise: &Exercise) -> Vec<String> {
    let context = of_the_query(scene, runs);
    let said = |text: &Spanned<String>| filled(text, &context).unwrap_or_else(|| text.value.clone());
    std::iter::once(to_do(scene, runs, exercise))
        .chain(answers(scene, runs, exercise).iter().map(|asked| asked.line_in(Words::of(scene))))
        .chain(scene.caption.as_ref().map(said))
        .collect()
}

/// What is known of a scene at the moment of its query.
fn of_the_query<'s>(scene: &'s Scene, runs: &'s Runs) -> Context<'s> {
    Context { scene, space: &Space::World, time: scene.query.time, step: None, play: Play::No, runs }
}

/// The sentences of the trace that a reader works through, as markup.
pub(super) fn steps(scene: &Scene, runs: &Runs) -> Vec<String> {
    let (run, names) = (runs.own(scene, scene.query.time), runs.called.names(scene));
    let context = of_the_query(scene, runs);
    let (turns, voice) = (context.turns(), voice(scene, &names, Hand::Type));
    let way = told::way(told::told(&run.trace).filter(|event| is_worked(event)), voice, turns);
    way.iter().map(|sentence| with_scripts(with_powers(&as_markup(sentence)), &context)).collect()
}

/// Letters of quantities of a body as the picture has them.
fn with_scripts(markup: String, context: &Context) -> String {
    let with = |markup: String, side: Side| {
        let mut pieces = markup.split(script(side)).peekable();
        let mut out = String::new();
        while let Some(piece) = pieces.next() {
            let letter = piece.char_indices().next_back().filter(|_| pieces.peek().is_some());
            out.push_str(letter.map_or(piece, |(at, _)| &piece[..at]));
            out.extend(letter.map(|(at, _)| context.symbol(&piece[at..], side)));
        }
        out
    };
    Side::BOTH.into_iter().fold(markup, with)
}

/// Whether an event is a step of working an answer out: not that it begins, ends, or looks something up for
/// the step that follows.
fn is_worked(event: &Event) -> bool {
    match event {
        Event::Started { .. }
        | Event::Finished { .. }
        | Event::SupportFound { .. }
        | Event::OriginProjected { .. }
        | Event::ExpectationCompared { .. } => false,
        Event::CirclesCompared { .. }
        | Event::PenetrationMeasured { .. }
        | Event::BoundsFound { .. }
        | Event::ExtentsCompared { .. }
        | Event::Clamped { .. }
        | Event::DifferenceEdgeFound { .. }
        | Event::EdgesMerged { .. }
        | Event::DifferenceRounded { .. }
        | Event::CandidateImproved { .. }
        | Event::AxisTested { .. }
        | Event::SeparatingAxisFound { .. }
        | Event::SimplexUpdated { .. }
        | Event::PolytopeExpanded { .. }
        | Event::RayClipped { .. }
        | Event::Advanced { .. }
        | Event::AxisSwept { .. }
        | Event::ClosestApproachFound { .. }
        | Event::MotionBounded { .. }
        | Event::EdgesFaced { .. }
        | Event::EdgeCut { .. }
        | Event::ContactFound { .. } => true,
    }
}
