//! The scene again with other numbers: where bodies are, how large, how turned, how fast.
//!
//! The numbers are exchanged in the tree of the file, so that what comes out was read and checked as any
//! other scene, and says what it says.

use super::meaning::meaning;
use super::node::{Node, NodeValue};
use super::open::{Refused, SceneFile};
use super::read::from_tree;
use super::source::Source;

/// Keys of a shape whose numbers are exchanged.
const KEYS: [&str; 7] =
    ["position", "velocity", "radius", "half_extents", "rotation", "angle_deg", "angular_velocity_deg"];
/// The table of shapes.
const SHAPES: &str = "shapes";

/// The numbers that stand under a key of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// Name of the shape.
    pub shape: String,
    /// The key, as `position`.
    pub key: &'static str,
    /// One number, or those of a list.
    pub values: Vec<f64>,
}

/// A scene whose numbers can be exchanged.
#[derive(Clone, Debug)]
pub struct Template {
    /// The text that it was read from.
    source: Source,
    /// What the text says.
    root: Node,
    /// The numbers as they are written.
    numbers: Vec<Numbers>,
}

impl SceneFile {
    /// The scene as a template: the numbers that its query's bodies have are those that can be exchanged.
    ///
    /// ```
    /// use tracefig::scene::open_text;
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let template = open_text("s.toml", text)?.template();
    /// assert_eq!((template.numbers()[0].key, template.numbers()[0].values[0]), ("radius", 2.0));
    /// let file = template.with(&[vec![2.5]])?;
    /// assert_eq!(file.scene.shapes()[0].1.shape.radius, 2.5);
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn template(&self) -> Template {
        let root = self.tree.clone();
        let asked = self.scene.query.of.iter().filter_map(|&i| self.scene.shapes.get(i));
        let of_shape = |name: &str| {
            let table = root.get(SHAPES).and_then(|shapes| shapes.get(name));
            let number = |key: &'static str| {
                let values = values(table?.get(key)?)?;
                Some(Numbers { shape: name.to_owned(), key, values })
            };
            KEYS.into_iter().filter_map(number).collect::<Vec<_>>()
        };
        let numbers = asked.flat_map(|(name, _)| of_shape(&name.value)).collect();
        Template { source: self.source.clone(), root, numbers }
    }
}

impl Template {
    /// The numbers that can be exchanged, as they are written.
    ///
    /// ```
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let template = tracefig::scene::open_text("s.toml", text)?.template();
    /// assert_eq!((template.numbers()[0].shape.as_str(), template.numbers()[0].key), ("A", "radius"));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn numbers(&self) -> &[Numbers] {
        &self.numbers
    }

    /// The scene with other numbers, in the order of [`Template::numbers`].
    ///
    /// # Errors
    /// Where it is no scene then, as with a negative radius.
    ///
    /// ```
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let template = tracefig::scene::open_text("s.toml", text)?.template();
    /// assert_eq!(template.with(&[vec![2.5]])?.scene.shapes()[0].1.shape.radius, 2.5);
    /// assert!(template.with(&[vec![-1.0]]).is_err());
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    pub fn with(&self, numbers: &[Vec<f64>]) -> Result<SceneFile, Box<Refused>> {
        let root = self.exchanged(numbers);
        let (source, meaning) = (self.source.clone(), meaning(&root));
        match from_tree(&root) {
            Ok(scene) => Ok(SceneFile { source, scene, meaning, tree: root }),
            Err(problems) => Err(Box::new(Refused { source, problems })),
        }
    }

    /// The tree with other numbers.
    fn exchanged(&self, numbers: &[Vec<f64>]) -> Node {
        let mut root = self.root.clone();
        for (field, values) in self.numbers.iter().zip(numbers) {
            let table = entry(&mut root, SHAPES).and_then(|shapes| entry(shapes, &field.shape));
            let Some(node) = table.and_then(|table| entry(table, field.key)) else { continue };
            match &mut node.value {
                NodeValue::List(items) => {
                    items.iter_mut().zip(values).for_each(|(item, x)| item.value = NodeValue::Number(*x));
                }
                value => values.iter().take(1).for_each(|&x| *value = NodeValue::Number(x)),
            }
        }
        root
    }
}

/// The numbers that a value is; `None` for anything else.
fn values(node: &Node) -> Option<Vec<f64>> {
    let number = |node: &Node| if let NodeValue::Number(x) = node.value { Some(x) } else { None };
    match &node.value {
        NodeValue::List(items) => items.iter().map(number).collect(),
        _ => number(node).map(|x| vec![x]),
    }
}

/// The value under a key of a table, to be changed.
fn entry<'n>(node: &'n mut Node, key: &str) -> Option<&'n mut Node> {
    let NodeValue::Table(entries) = &mut node.value else { return None };
    entries.iter_mut().find(|(name, _)| name.value == key).map(|(_, node)| node)
}
