//! Words of an SVG of ours that are found and not seen: what they say.
//!
//! [`super::super::words`] writes them without ink, of which the root says that there is none; whatever else
//! might show them is none of ours.

use roxmltree::Node;

/// The attribute by which an element with such words is known.
const MARK: &str = "aria-hidden";
/// Every attribute that the element may have, and those of a size and of a line.
const KNOWN: [&str; 7] = [MARK, "font-family", "pointer-events", "font-size", "x", "y", "textLength"];

/// Whether an element holds words that are found.
pub(super) fn are_in(node: Node) -> bool {
    node.has_attribute(MARK)
}

/// What the words of an element say, one line below the other; `None` where anything else is in it.
pub(super) fn said(node: Node) -> Option<String> {
    let mut lines = Vec::new();
    for of_size in elements(node, "g")? {
        for line in elements(of_size, "text")? {
            let is_text = is_plain(line) && line.children().all(|child| child.is_text());
            lines.push(is_text.then(|| line.text().unwrap_or_default())?);
        }
    }
    Some(lines.join("\n"))
}

/// The elements of this name in another one; `None` where there are others.
fn elements<'d>(node: Node<'d, 'd>, name: &str) -> Option<Vec<Node<'d, 'd>>> {
    let inner: Vec<_> = node.children().filter(Node::is_element).collect();
    (is_plain(node) && inner.iter().all(|node| node.has_tag_name(name))).then_some(inner)
}

/// Whether an element has nothing that could show it.
fn is_plain(node: Node) -> bool {
    node.attributes().all(|attribute| KNOWN.contains(&attribute.name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(inner: &str) -> Option<String> {
        let text = format!("<g aria-hidden=\"true\" font-family=\"sans-serif\">{inner}</g>");
        let document = roxmltree::Document::parse(&text).unwrap();
        assert!(are_in(document.root_element()));
        said(document.root_element())
    }

    #[test]
    fn lines_of_all_sizes_are_read() {
        let inner = "<g font-size=\"14\">\n<text x=\"1\" y=\"2\" textLength=\"9\">a &lt; b</text>\n</g>\
                     <g font-size=\"9\"><text>1</text><text>2</text></g>";
        assert_eq!(read(inner).as_deref(), Some("a < b\n1\n2"));
        assert_eq!(read("").as_deref(), Some(""));
    }

    #[test]
    fn what_could_be_seen_is_refused() {
        for inner in [
            "<g><text fill=\"red\">a</text></g>",
            "<g><text>a<tspan stroke=\"red\">b</tspan></text></g>",
            "<g style=\"fill:red\"><text>a</text></g>",
            "<g class=\"a\"><text>a</text></g>",
            "<g><path d=\"M0 0\"/></g>",
            "<g><g><text>a</text></g></g>",
            "<text>a</text>",
            "<image/>",
        ] {
            assert_eq!(read(inner), None, "{inner}");
        }
    }
}
