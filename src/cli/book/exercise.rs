//! An exercise on a page: the question, and behind it the key, folded away.

use std::borrow::Cow;

use tracefig::figure::exercise::solution;
use tracefig::scene::{Refused, Scene, SceneFile, Variant};

use super::super::themes::ChosenTheme;
use super::super::variants::{Unvaried, scene_of};
use super::attributes::Attributes;
use super::figures::{Desk, Order, Served, Takes};

/// What is told of a scene that asks nothing.
const NO_EXERCISE: &str = "the scene is no exercise: it has no table `[exercise]`";

impl Desk<'_> {
    /// The question of an exercise as Markdown, and the key in an element that opens.
    pub(super) fn exercise(
        &self,
        order: &Order,
        attributes: &Attributes,
        mut file: SceneFile,
        own: Option<&ChosenTheme>,
    ) -> Result<Served, String> {
        let [question, key] = Variant::OF_AN_EXERCISE.map(|variant| self.variant(order, &file, variant));
        let summary = solution(&file.scene);
        file.scene = question?;
        let asked = self.drawn(order, &file, own)?;
        file.scene = key?;
        let behind = Order {
            place: order.place,
            name: order.name,
            file: order.file,
            line: order.line,
            id: format!("{}-key", order.id),
            with_sheet: false,
        };
        let told = self.drawn(&behind, &file, own)?;
        let margin = &order.place.margin;
        // A blank line ends an element for Markdown.
        let blank = format!("\n{}", margin.trim_end());
        let text = match self.takes {
            Takes::Element => {
                let figure = |order, picture| self.element(order, attributes, own.is_none(), picture);
                let (question, key) = (figure(order, &asked.picture), figure(&behind, &told.picture));
                format!(
                    "{question}{blank}\n{margin}<details><summary>{summary}</summary>{key}</details>{blank}"
                )
            }
            // A book that is read without a page has nothing that folds.
            Takes::Image => {
                let (question, key) = (&asked.picture, &told.picture);
                format!("{question}{blank}\n{margin}**{summary}**{blank}\n{margin}{key}{blank}")
            }
        };
        let kept = vec![asked.kept(), told.kept()];
        Ok(Served { text: Some(text), messages: asked.messages + &told.messages, kept, is_live: false })
    }

    /// A variant of a scene, or what is wrong with it.
    fn variant(&self, order: &Order, file: &SceneFile, variant: Variant) -> Result<Scene, String> {
        scene_of(file, variant).map(Cow::into_owned).map_err(|unvaried| match unvaried {
            Unvaried::Wrong(problems) => {
                order.refused(&Refused { source: file.source.clone(), problems }, self.ink)
            }
            Unvaried::NoExercise | Unvaried::TooFew { .. } => order.told(NO_EXERCISE),
        })
    }
}
