//! The options of a layer: what a layer declares, and what a scene gave, checked against it.

use std::ops::Range;

use crate::drawing::Role;
use crate::geometry::{DVec2, Side};
use crate::scene::{Fault, LayerSpec, NOTES, Problem, Scene, Spanned, Value, When};

/// The farthest a point of the reader's choice may lie from the origin along either axis.
const FARTHEST: f64 = 1e100;

/// The largest number of a vertex or an edge that is read: no scene has as many.
const LARGEST_COUNT: f64 = 1e9;

/// What values an option takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// A flag: `true` or `false`.
    Flag,
    /// Any finite number.
    Number,
    /// A number above 0.
    Positive,
    /// A point `[x, y]`.
    Point,
    /// Whole numbers from 0: a list, or one.
    Counts,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A list of these words, or one of them.
    Words(&'static [&'static str]),
    /// Names of the query's shapes: a list, or one.
    Bodies,
    /// A time from 0 to 1, or one of these words.
    When(&'static [&'static str]),
    /// The word of a colour role.
    Role,
    /// Markup: a list of lines, or one.
    Lines,
}

/// An option of a layer.
#[derive(Clone, Copy, Debug)]
pub struct OptionSpec {
    /// The key in the layer's table in a scene.
    pub name: &'static str,
    /// What values it takes.
    pub takes: Takes,
    /// What holds where a scene says nothing, in words.
    pub default: &'static str,
    /// What it is for, with its unit, for `tracefig list`.
    pub about: &'static str,
}

/// The options that every layer has.
pub static COMMON: &[OptionSpec] = &[
    OptionSpec { name: "role", takes: Takes::Role, default: "the layer's own", about: "colour role" },
    OptionSpec { name: "labels", takes: Takes::Flag, default: "true", about: "whether it writes its labels" },
];

/// A value of an option, fit for what the option takes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Setting {
    /// The value of a [`Takes::Flag`].
    Flag(bool),
    /// The value of a [`Takes::Number`] or [`Takes::Positive`], or the time of a [`Takes::When`].
    Number(f64),
    /// The value of a [`Takes::Point`].
    Point(DVec2),
    /// The values of a [`Takes::Counts`].
    Counts(Vec<usize>),
    /// The words or lines of an option that takes them; one where it takes a single word.
    Words(Vec<String>),
    /// The bodies of a [`Takes::Bodies`].
    Bodies(Vec<Side>),
    /// The value of a [`Takes::Role`].
    Role(Role),
}

/// The options of one layer of a scene, checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// Each option that the scene gave, by name, in file order.
    given: Vec<(&'static str, Setting)>,
}

impl Options {
    /// Whether the scene gave none.
    pub(crate) fn is_bare(&self) -> bool {
        self.given.is_empty()
    }

    /// Checks what a scene says of a layer whose own options are `own`.
    ///
    /// # Errors
    ///
    /// Every unknown option and every value that does not fit, with its place in the scene.
    pub(crate) fn read(own: &[OptionSpec], spec: &LayerSpec, scene: &Scene) -> Result<Self, Vec<Problem>> {
        let mut options = Self::default();
        let mut problems = Vec::new();
        for (key, value) in &spec.options {
            let known = || own.iter().chain(COMMON);
            let Some(option) = known().find(|o| o.name == key.value) else {
                let known = known().map(|o| o.name.to_owned()).collect();
                let place = format!("the layer `{}`", spec.name.value);
                let fault = Fault::UnknownKey { key: key.value.clone(), place, known };
                problems.push(Problem::new(fault, key.span.clone()));
                continue;
            };
            let reading = Reading { key: option.name, scene, span: &value.span };
            match reading.setting(option.takes, &value.value) {
                Ok(setting) => options.given.push((option.name, setting)),
                Err(problem) => problems.push(problem),
            }
        }
        if problems.is_empty() { Ok(options) } else { Err(problems) }
    }

    /// What the scene gave for an option, the last where it stands twice.
    fn get(&self, name: &str) -> Option<&Setting> {
        self.given.iter().rev().find(|(n, _)| *n == name).map(|(_, s)| s)
    }

    /// All of them but one.
    #[must_use]
    pub(crate) fn without(&self, name: &str) -> Self {
        Self { given: self.given.iter().filter(|(given, _)| *given != name).cloned().collect() }
    }

    /// Whether the scene gave an option.
    #[must_use]
    pub(crate) fn gives(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// A flag, or `default` where the scene does not say.
    #[must_use]
    pub(crate) fn flag(&self, name: &str, default: bool) -> bool {
        if let Some(Setting::Flag(b)) = self.get(name) { *b } else { default }
    }

    /// A number, where the scene gave one.
    #[must_use]
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        if let Some(Setting::Number(x)) = self.get(name) { Some(*x) } else { None }
    }

    /// A point, where the scene gave one.
    #[must_use]
    pub(crate) fn point(&self, name: &str) -> Option<DVec2> {
        if let Some(Setting::Point(p)) = self.get(name) { Some(*p) } else { None }
    }

    /// Whole numbers, where the scene gave some.
    #[must_use]
    pub(crate) fn counts(&self, name: &str) -> Option<&[usize]> {
        if let Some(Setting::Counts(counts)) = self.get(name) { Some(counts) } else { None }
    }

    /// A word, or `default` where the scene does not say.
    #[must_use]
    pub(crate) fn word<'o>(&'o self, name: &str, default: &'o str) -> &'o str {
        match self.get(name) {
            Some(Setting::Words(words)) => words.first().map_or(default, String::as_str),
            _ => default,
        }
    }

    /// Words or lines, where the scene gave some.
    #[must_use]
    pub(crate) fn words(&self, name: &str) -> Option<&[String]> {
        if let Some(Setting::Words(words)) = self.get(name) { Some(words) } else { None }
    }

    /// Whether a list of words holds one; `default` where the scene does not say.
    #[must_use]
    pub(crate) fn shows(&self, name: &str, word: &str, default: bool) -> bool {
        self.words(name).map_or(default, |words| words.iter().any(|w| w == word))
    }

    /// The bodies of the option `of`, or `default`.
    #[must_use]
    pub(crate) fn of(&self, default: &[Side]) -> Vec<Side> {
        if let Some(Setting::Bodies(sides)) = self.get("of") { sides.clone() } else { default.to_vec() }
    }

    /// The colour role that the scene gave, or the layer's own.
    #[must_use]
    pub(crate) fn role(&self, default: Role) -> Role {
        if let Some(Setting::Role(role)) = self.get("role") { *role } else { default }
    }

    /// A moment: a number, or one of the words of [`When::WORDS`]; `None` for another word, and where the
    /// scene does not say.
    #[must_use]
    pub(crate) fn when(&self, name: &str) -> Option<When> {
        match self.get(name)? {
            Setting::Number(t) => Some(When::Time(*t)),
            Setting::Words(words) => When::of_word(words.first()?),
            _ => None,
        }
    }
}

/// One value of one option, being read.
struct Reading<'r> {
    /// The name of the option.
    key: &'static str,
    /// The scene, whose bodies an option may name.
    scene: &'r Scene,
    /// Where the value stands in the scene.
    span: &'r Range<usize>,
}

impl Reading<'_> {
    /// A value that fits, or what was expected.
    fn setting(&self, takes: Takes, value: &Value) -> Result<Setting, Problem> {
        match (takes, value) {
            (Takes::Flag, Value::Bool(b)) => Ok(Setting::Flag(*b)),
            (Takes::Number, Value::Number(x)) => Ok(Setting::Number(*x)),
            (Takes::Positive, Value::Number(x)) if *x > 0.0 => Ok(Setting::Number(*x)),
            (Takes::Point, Value::List(list)) => match list[..] {
                [Spanned { value: Value::Number(x), .. }, Spanned { value: Value::Number(y), .. }]
                    if in_reach(x) && in_reach(y) =>
                {
                    Ok(Setting::Point(DVec2::new(x, y)))
                }
                _ => Err(self.wrong_type(&expected(takes), value, self.span)),
            },
            (Takes::Counts, Value::Number(_)) => {
                self.count(value, self.span).map(|k| Setting::Counts(vec![k]))
            }
            (Takes::Counts, Value::List(list)) => {
                let counts = list.iter().map(|item| self.count(&item.value, &item.span));
                counts.collect::<Result<_, _>>().map(Setting::Counts)
            }
            (Takes::When(_), Value::Number(t)) if (0.0..=1.0).contains(t) => Ok(Setting::Number(*t)),
            (Takes::Word(words) | Takes::Words(words) | Takes::When(words), Value::Text(word)) => {
                self.one_of(words, word, self.span).map(|w| Setting::Words(vec![w]))
            }
            (Takes::Words(words), Value::List(list)) => {
                self.texts(list, |text, span| self.one_of(words, text, span)).map(Setting::Words)
            }
            (Takes::Lines, Value::Text(line)) => Ok(Setting::Words(vec![line.clone()])),
            (Takes::Lines, Value::List(list)) => {
                self.texts(list, |text, _| Ok(text.to_owned())).map(Setting::Words)
            }
            (Takes::Role, Value::Text(word)) => self.role(word).map(Setting::Role),
            (Takes::Bodies, Value::Text(name)) => {
                self.side(name, self.span).map(|s| Setting::Bodies(vec![s]))
            }
            (Takes::Bodies, Value::List(list)) => {
                self.texts(list, |text, span| self.side(text, span)).map(Setting::Bodies)
            }
            _ => Err(self.wrong_type(&expected(takes), value, self.span)),
        }
    }

    /// A value of another type than the option takes.
    fn wrong_type(&self, expected: &str, value: &Value, span: &Range<usize>) -> Problem {
        let fault =
            Fault::WrongType { key: self.key.to_owned(), expected: expected.to_owned(), got: shown(value) };
        Problem::new(fault, span.clone())
    }

    /// Every text of a list, read by `each`; anything else in it is a problem.
    fn texts<T>(
        &self,
        list: &[Spanned<Value>],
        each: impl Fn(&str, &Range<usize>) -> Result<T, Problem>,
    ) -> Result<Vec<T>, Problem> {
        list.iter()
            .map(|item| match &item.value {
                Value::Text(text) => each(text, &item.span),
                other => Err(self.wrong_type("strings in the list", other, &item.span)),
            })
            .collect()
    }

    /// A whole number from 0.
    fn count(&self, value: &Value, span: &Range<usize>) -> Result<usize, Problem> {
        let whole = match value {
            Value::Number(x) if (0.0..=LARGEST_COUNT).contains(x) && x.fract() == 0.0 => Some(*x),
            _ => None,
        };
        let count = whole.and_then(|x| format!("{x}").parse().ok());
        count.ok_or_else(|| self.wrong_type(&expected(Takes::Counts), value, span))
    }

    /// A word, if it is one of those known.
    fn one_of(&self, words: &[&str], word: &str, span: &Range<usize>) -> Result<String, Problem> {
        if words.contains(&word) {
            return Ok(word.to_owned());
        }
        let known = words.iter().map(|&w| w.to_owned()).collect();
        let fault = Fault::UnknownWord { what: self.key, got: word.to_owned(), known };
        Err(Problem::new(fault, span.clone()))
    }

    /// A colour role by its word.
    fn role(&self, word: &str) -> Result<Role, Problem> {
        let names: Vec<_> = Role::ALL.iter().map(|r| r.name()).collect();
        let name = self.one_of(&names, word, self.span)?;
        Ok(Role::ALL.into_iter().find(|r| r.name() == name).unwrap_or(Role::Ink))
    }

    /// A body of the query by its name.
    fn side(&self, name: &str, span: &Range<usize>) -> Result<Side, Problem> {
        let shapes = &self.scene.shapes;
        let names = self.scene.query.of.iter().filter_map(|&i| shapes.get(i)).map(|(n, _)| n.value.clone());
        let known: Vec<String> = names.collect();
        match known.iter().position(|n| n == name) {
            Some(0) => Ok(Side::A),
            Some(_) => Ok(Side::B),
            None if shapes.iter().any(|(n, _)| n.value == name) => {
                let message =
                    format!("`{}`: expected a shape of the query, got `{name}`, which is context", self.key);
                let known: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
                let help = format!("the query is of {}", known.join(" and "));
                Err(Problem::new(Fault::Conflict { message, help }, span.clone()))
            }
            None => Err(Problem::new(Fault::UnknownBody { got: name.to_owned(), known }, span.clone())),
        }
    }
}

/// Whether a point may have this coordinate.
fn in_reach(x: f64) -> bool {
    x.abs() <= FARTHEST
}

/// What an option takes, in the words of a message; no page changes options.
fn expected(takes: Takes) -> String {
    match takes {
        _ if !NOTES => String::new(),
        Takes::Flag => "true or false".to_owned(),
        Takes::Number => "a number".to_owned(),
        Takes::Positive => "a number above 0".to_owned(),
        Takes::Point => format!("two numbers [x, y] within ±{FARTHEST:e}"),
        Takes::Counts => "a whole number from 0, or a list of them".to_owned(),
        Takes::Word(words) => format!("one of {}", quoted(words)),
        Takes::Words(words) => format!("a list of {}", quoted(words)),
        Takes::Bodies => "names of the query's shapes".to_owned(),
        Takes::When(words) => format!("a time from 0 to 1 or one of {}", quoted(words)),
        Takes::Role => "the word of a colour role".to_owned(),
        Takes::Lines => "a line of text or a list of them".to_owned(),
    }
}

/// Words for a message: `` `a`, `b` ``.
fn quoted(words: &[&str]) -> String {
    words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ")
}

/// A value as a message shows it.
fn shown(value: &Value) -> String {
    match value {
        Value::Bool(b) => b.to_string(),
        Value::Number(x) => x.to_string(),
        Value::Text(t) => format!("`{t}`"),
        Value::List(_) => "a list".to_owned(),
    }
}
