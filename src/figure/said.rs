//! Texts beside a figure, as those of a book's page: with the values of its answer.

use crate::scene::Spanned;

use super::fault::Problem;
use super::plan::Plan;
use super::text::spoken;

impl Plan<'_> {
    /// A text of the caller's with the values of the answer for every `{=name}`, in plain words.
    ///
    /// # Errors
    /// When it names a value that this answer lacks or no answer has, or is no markup. The problems have no
    /// place in the scene.
    ///
    /// ```
    /// use tracefig::{figure::plan, scene::{Source, read}};
    /// let bodies = "shapes.A = { kind = 'circle', radius = 1 }
    ///     shapes.B = { kind = 'circle', radius = 1, position = [2.5, 0] }";
    /// let text = format!("{bodies}\nquery = {{ kind = 'separation', of = ['A', 'B'] }}");
    /// let scene = read(&Source::new("circles.toml", &text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// assert_eq!(plan.say("{=separation:.2} apart").unwrap(), "0.50 apart");
    /// assert!(plan.say("{=depth}").is_err(), "they are apart");
    /// ```
    pub fn say(&self, markup: &str) -> Result<String, Vec<Problem>> {
        let (mut problems, mut lacking) = (Vec::new(), Vec::new());
        let text = Spanned { value: markup.to_owned(), span: 0..0 };
        let first = self.of_the_whole().map(|panel| panel.context(self.scene, &self.runs));
        let said = first.and_then(|first| spoken(Some(&text), &first, (&mut problems, &mut lacking)));
        problems.extend(lacking);
        if problems.is_empty() { Ok(said.unwrap_or_default()) } else { Err(problems) }
    }
}
