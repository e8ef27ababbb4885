//! What the bodies of a query are called, in every text that speaks of them.

use super::Side;

/// Names of the query's bodies: the scene's, or A and B where nobody names them.
///
/// ```
/// use tracefig::geometry::{Names, Side};
/// let names = Names::new("bullet", Some("wall"));
/// assert_eq!((names.of(Side::A), names.all().as_str()), ("bullet", "bullet and wall"));
/// assert_eq!(Names::default().all(), "A and B");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Names {
    /// Name of the first body.
    a: String,
    /// Name of the second body; `None` where the query is about one.
    b: Option<String>,
    /// Which of them are circles: their only vertex is a centre.
    circles: [bool; 2],
    /// Which of them have a radius.
    rounds: [bool; 2],
}

impl Default for Names {
    fn default() -> Self {
        Self::new("A", Some("B"))
    }
}

impl Names {
    /// The first body's name, and the second's where the query is about two.
    ///
    /// ```
    /// use tracefig::geometry::Names;
    /// assert_eq!(Names::new("crate_1", None).all(), "crate_1");
    /// ```
    #[must_use]
    pub fn new(a: &str, b: Option<&str>) -> Self {
        Self { a: a.to_owned(), b: b.map(str::to_owned), circles: [false; 2], rounds: [false; 2] }
    }

    /// With which of the two bodies are circles, whose only vertex is called a centre.
    pub(crate) fn of_circles(self, circles: [bool; 2]) -> Self {
        Self { circles, ..self }
    }

    /// With which of the two bodies have a radius: what is told of cores is then not all.
    pub(crate) fn of_rounds(self, rounds: [bool; 2]) -> Self {
        Self { rounds, ..self }
    }

    /// Whether a body is known to have a radius.
    pub(crate) fn has_radius(&self) -> bool {
        self.rounds.contains(&true)
    }

    /// Whether this body is known to have one.
    pub(crate) fn is_round(&self, side: Side) -> bool {
        self.rounds[usize::from(side == Side::B)]
    }

    /// Whether a body is known to be a circle.
    pub(crate) fn is_of_circle(&self, side: Side) -> bool {
        self.circles[usize::from(side == Side::B)]
    }

    /// The name of a body; empty for the second of a query about one.
    ///
    /// ```
    /// use tracefig::geometry::{Names, Side};
    /// assert_eq!(Names::default().of(Side::B), "B");
    /// ```
    #[must_use]
    pub fn of(&self, side: Side) -> &str {
        match side {
            Side::A => &self.a,
            Side::B => self.b.as_deref().unwrap_or_default(),
        }
    }

    /// The name of a body where it stands among other words or in a formula: in quotes unless it is one word.
    ///
    /// ```
    /// use tracefig::geometry::{Names, Side};
    /// let names = Names::new("crate_1", Some("the wall"));
    /// assert_eq!(names.quoted(Side::A), "crate_1");
    /// assert_eq!(names.quoted(Side::B), "\"the wall\"");
    /// ```
    #[must_use]
    pub fn quoted(&self, side: Side) -> String {
        let name = self.of(side);
        let of_a_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '′');
        if name.chars().all(of_a_word) { name.to_owned() } else { format!("\"{name}\"") }
    }

    /// All names, each as [`Names::quoted`] writes it: "A and B".
    ///
    /// ```
    /// use tracefig::geometry::Names;
    /// assert_eq!(Names::new("the crate", Some("wall")).all(), "\"the crate\" and wall");
    /// ```
    #[must_use]
    pub fn all(&self) -> String {
        match &self.b {
            Some(_) => format!("{} and {}", self.quoted(Side::A), self.quoted(Side::B)),
            None => self.quoted(Side::A),
        }
    }
}
