//! What a layer may know of the others in its panel.

use super::Sketch;

impl Sketch<'_> {
    /// Says which layers the panel has.
    pub(crate) fn of_layers(self, names: impl Iterator<Item = &'static str>) -> Self {
        Self { names: names.collect(), ..self }
    }

    /// Whether the panel has a layer of this name, wherever in the order of drawing.
    #[must_use]
    pub(crate) fn has_layer(&self, name: &str) -> bool {
        self.names.contains(&name)
    }
}
