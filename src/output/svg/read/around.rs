//! What is around the elements that are drawn in an SVG of ours: the root's attributes, the style sheet, the
//! outlines that are referred to, and what is said to who does not see the picture.
//!
//! No pixel shows any of it, yet a rule or a script there may hide or change all of the picture in a page.

use roxmltree::{Attribute, NS_XML_URI, Node};

/// The attributes of the root, by the values that they have in every file, or by what they hold.
const ROOT: [(&str, Option<&str>); 8] = [
    ("width", None),
    ("height", None),
    ("viewBox", None),
    ("fill", Some("none")),
    ("stroke-linejoin", Some("round")),
    ("role", Some("img")),
    ("aria-labelledby", None),
    ("lang", None),
];
/// The elements beside those that are drawn, of which there is one each at most, with their attributes.
const BESIDE: [(&str, &[&str]); 5] =
    [("title", &["id", "lang"]), ("desc", &["id", "lang"]), ("metadata", &[]), ("style", &[]), ("defs", &[])];

/// Whether all that is around the elements that are drawn is as we write it.
pub(super) fn is_ours(root: Node) -> bool {
    let is_known = |attribute: &Attribute| {
        let (name, value) = (attribute.name(), attribute.value());
        attribute.namespace() == (name == "lang").then_some(NS_XML_URI)
            && ROOT
                .iter()
                .any(|&(known, always)| known == name && always.is_none_or(|always| always == value))
    };
    // Without the role a reader that speaks reads the picture's pieces, and with another one nothing.
    let has = |name: &str| root.has_attribute(name);
    let inner = || root.children().filter(Node::is_element);
    let of = |name: &str| inner().filter(|node| node.has_tag_name(name)).count();
    has("role")
        && has("fill")
        && root.attributes().all(|attribute| is_known(&attribute))
        && BESIDE.iter().all(|(name, _)| of(name) <= 1)
        && inner().all(is_plain)
}

/// Whether an element beside those that are drawn has nothing in it but what we write; of another one,
/// always.
fn is_plain(node: Node) -> bool {
    let name = node.tag_name().name();
    let Some((_, known)) = BESIDE.iter().find(|(beside, _)| *beside == name) else { return true };
    let has_only =
        |node: Node, known: &[&str]| node.attributes().all(|attribute| known.contains(&attribute.name()));
    let is_outline = |node: Node| {
        node.has_tag_name("path") && has_only(node, &["id", "d"]) && !node.children().any(|n| n.is_element())
    };
    let mut inner = node.children().filter(Node::is_element);
    has_only(node, known) && if name == "defs" { inner.all(is_outline) } else { inner.next().is_none() }
}

/// What a page says to who does not see it, besides title and description: the languages, and what its parts
/// are called.
pub(super) fn told(root: Node) -> String {
    let said = |node: Node| {
        let lang = node.attribute((NS_XML_URI, "lang")).map(|lang| format!("language {lang}"));
        [lang, node.attribute("aria-label").map(str::to_owned)]
    };
    root.descendants().flat_map(said).flatten().collect::<Vec<_>>().join("\n")
}
