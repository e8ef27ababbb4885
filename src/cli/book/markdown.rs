//! What of a page is ours: fenced scenes, scenes in files, and values.
//!
//! A parser of `CommonMark`, mdBook's own, says what is code: there the words that ask for a figure are an
//! example, as they are after a backslash. What is found keeps its place in lists and quotes.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, LinkType, Options, Parser, Tag};

/// The word before a fenced scene.
const FENCE: &str = "tracefig";
/// What asks for the figure of a file.
const FILE: &str = "{{#tracefig";
/// What asks for a value of an answer.
const VALUE: &str = "{{=";
/// The end of both.
const END: &str = "}}";

/// A place of a page that is ours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    /// Where it stands in the page's text, bytes.
    pub(crate) range: Range<usize>,
    /// Number of its first line in that text, from 1.
    pub(crate) line: usize,
    /// What begins a line that goes on in the list or quote where it stands.
    pub(crate) margin: String,
    /// What stands there.
    pub(crate) what: What,
}

/// What stands at a place that is ours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// A fenced scene.
    Scene {
        /// What its fence says behind the word.
        attributes: String,
        /// Its text; the first line is the one below the fence.
        text: String,
    },
    /// The figure of a file.
    File {
        /// Its path from the page's folder.
        path: String,
        /// What is said behind it.
        attributes: String,
    },
    /// A value of a file's answer.
    Value {
        /// Its path from the page's folder.
        path: String,
        /// The value's name, with its digits.
        name: String,
    },
    /// The target of a link.
    Link(String),
    /// What was meant for us and is none of these.
    Wrong(String),
    /// The backslash before what is not meant for us.
    Backslash,
}

/// All places of a page, in its order.
pub(crate) fn places(page: &str) -> Vec<Place> {
    let (mut found, code) = fences(page);
    for word in [FILE, VALUE] {
        found.extend(page.match_indices(word).filter_map(|(at, _)| {
            let is_code = code.iter().any(|range| range.contains(&at));
            let is_other = word == FILE && page[at + FILE.len()..].starts_with(|c: char| c.is_alphanumeric());
            (!is_code && !is_other).then(|| asked(page, at, word))
        }));
    }
    found.sort_by_key(|place| place.range.start);
    // What stands within another one is part of that, whatever it asks for.
    let mut end = 0;
    found.retain(|place| {
        let is_next = place.range.start >= end;
        end = end.max(place.range.end);
        is_next
    });
    found
}

/// The fenced scenes, and where the page is code or a comment.
fn fences(page: &str) -> (Vec<Place>, Vec<Range<usize>>) {
    let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES | Options::ENABLE_TASKLISTS;
    let (mut found, mut code) = (Vec::new(), Vec::new());
    let mut scene: Option<(Range<usize>, String, String)> = None;
    for (event, range) in Parser::new_ext(page, options).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                if let CodeBlockKind::Fenced(info) = &kind
                    && let Some(attributes) = info.strip_prefix(FENCE)
                    && !attributes.starts_with(|c: char| c != ',' && !c.is_whitespace())
                {
                    scene = Some((range.clone(), attributes.to_owned(), String::new()));
                }
                code.push(range);
            }
            Event::Text(text) => {
                if let Some((_, _, written)) = &mut scene {
                    written.push_str(&text);
                }
            }
            Event::End(_) => {
                if let Some((range, attributes, text)) = scene.take() {
                    found.push(place(page, range, What::Scene { attributes, text }));
                }
            }
            Event::Start(Tag::Link { link_type: LinkType::Inline, dest_url, .. }) => {
                found.extend(target(page, range, &dest_url));
            }
            Event::Code(_) => code.push(range),
            Event::Html(text) | Event::InlineHtml(text) if text.trim_start().starts_with("<!--") => {
                code.push(range);
            }
            _ => {}
        }
    }
    (found, code)
}

/// The place of a link's target; `None` where it is not written as it is.
fn target(page: &str, link: Range<usize>, to: &str) -> Option<Place> {
    let start = link.start + page[link].rfind(&format!("]({to}"))? + 2;
    Some(place(page, start..start + to.len(), What::Link(to.to_owned())))
}

/// The place at a word that asks for something.
fn asked(page: &str, at: usize, word: &str) -> Place {
    if page[..at].ends_with('\\') {
        return place(page, at - 1..at, What::Backslash);
    }
    let rest = &page[at..];
    let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
    let Some(end) = line.find(END) else {
        return place(page, at..at + word.len(), What::Wrong(format!("`{word}` lacks its `{END}`")));
    };
    let range = at..at + end + END.len();
    let within = line[word.len()..end].trim();
    let (path, behind) = within.split_once(char::is_whitespace).unwrap_or((within, ""));
    let (path, behind) = (path.to_owned(), behind.trim().to_owned());
    let what = match (word, path.is_empty()) {
        (FILE, true) => What::Wrong(format!("expected the path of a scene, as `{FILE} scene.toml{END}`")),
        (FILE, false) if !is_alone(page, &range) => {
            What::Wrong(format!("`{FILE} …{END}` stands on a line of its own: it becomes a figure"))
        }
        (FILE, false) => What::File { path, attributes: behind },
        _ if behind.is_empty() => {
            let form = format!("`{VALUE}scene.toml separation{END}`");
            What::Wrong(format!("expected the path of a scene and the name of a value, as {form}"))
        }
        _ => What::Value { path, name: behind },
    };
    place(page, range, what)
}

/// Whether nothing but the signs of lists and quotes shares a line.
fn is_alone(page: &str, range: &Range<usize>) -> bool {
    let before = page[..range.start].rsplit('\n').next().unwrap_or_default();
    let after = page[range.end..].lines().next().unwrap_or_default();
    let is_sign = |c: char| c.is_whitespace() || c.is_ascii_digit() || ">-+*.)".contains(c);
    before.chars().all(is_sign) && after.trim().is_empty()
}

/// A place with its line and its margin: what stands before it, blanks for the signs of lists.
fn place(page: &str, range: Range<usize>, what: What) -> Place {
    let before = &page[..range.start];
    let line = 1 + before.bytes().filter(|&b| b == b'\n').count();
    let signs = before.rsplit('\n').next().unwrap_or_default();
    let margin = signs.chars().map(|c| if c == '>' { c } else { ' ' }).collect();
    Place { range, line, margin, what }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(page: &str) -> Vec<(usize, What)> {
        places(page).into_iter().map(|place| (place.line, place.what)).collect()
    }

    #[test]
    fn targets_of_links_have_their_place() {
        let page = "A [`a(b).rs`](../a.rs \"(../a.rs\") and `[x](y)`\n\n\
                    | t |\n|---|\n| [b](<b c.rs>) [d](d.rs#L1) |\n";
        let places = places(page);
        let texts: Vec<&str> = places.iter().map(|place| &page[place.range.clone()]).collect();
        assert_eq!(texts, ["../a.rs", "d.rs#L1"]);
        assert!(matches!(&places[1].what, What::Link(to) if to == "d.rs#L1"));
    }

    fn file(path: &str, attributes: &str) -> What {
        What::File { path: path.to_owned(), attributes: attributes.to_owned() }
    }

    #[test]
    fn scenes_files_and_values_are_found_in_their_order() {
        let page = "# A\n\n```tracefig,width=60%\na = 1\n\nb = 2\n```\n\n{{#tracefig x/y.toml alt=\"Z\"}}\n\n\
                    The depth is {{=x/y.toml separation:.2}}.\n";
        let scene = What::Scene { attributes: ",width=60%".to_owned(), text: "a = 1\n\nb = 2\n".to_owned() };
        let value = What::Value { path: "x/y.toml".to_owned(), name: "separation:.2".to_owned() };
        assert_eq!(found(page), [(3, scene), (9, file("x/y.toml", "alt=\"Z\"")), (11, value)]);
        let places = places(page);
        assert!(page[places[0].range.clone()].trim_end().ends_with("b = 2\n```"));
        assert_eq!(&page[places[2].range.clone()], "{{=x/y.toml separation:.2}}");
    }

    #[test]
    fn what_stands_within_another_place_is_part_of_it() {
        let page = "{{=a {{=b c}}\n\n{{#tracefig s.toml alt=\"see [x](../../b.rs)\"}}\n";
        let texts: Vec<&str> = places(page).iter().map(|place| &page[place.range.clone()]).collect();
        assert_eq!(texts, ["{{=a {{=b c}}", "{{#tracefig s.toml alt=\"see [x](../../b.rs)\"}}"]);
    }

    #[test]
    fn examples_of_code_comments_and_escaped_words_stay() {
        let page = "````md\n```tracefig\nx\n```\n{{#tracefig a}}\n````\n\n    {{=a b}}\n\n`{{=a b}}` \
                    <!-- {{#tracefig a}} -->\n\n```tracefigs\nx\n```\n\n{{#tracefigs a}}\n";
        assert_eq!(found(page), []);
        assert_eq!(found("see \\{{=a b}}"), [(1, What::Backslash)]);
    }

    #[test]
    fn a_scene_in_a_list_and_a_quote_keeps_their_margin() {
        let page = "- one\n\n  ```tracefig\n  a = 1\n  ```\n- ```tracefig\n  b = 2\n  ```\n\n\
                    > ~~~tracefig\n> c = 3\n>\n> d = 4\n> ~~~\n";
        let texts: Vec<_> = places(page)
            .into_iter()
            .map(|place| match place.what {
                What::Scene { text, .. } => (place.margin, text),
                other => panic!("{other:?}"),
            })
            .collect();
        let want = [("  ", "a = 1\n"), ("  ", "b = 2\n"), ("> ", "c = 3\n\nd = 4\n")];
        assert_eq!(texts, want.map(|(margin, text)| (margin.to_owned(), text.to_owned())));
    }

    #[test]
    fn what_is_half_said_is_told() {
        let told = |page: &str| match found(page).remove(0) {
            (1, What::Wrong(told)) => told,
            other => panic!("{other:?}"),
        };
        assert_eq!(told("{{#tracefig x.toml\n}}"), "`{{#tracefig` lacks its `}}`");
        assert!(told("{{#tracefig }}").starts_with("expected the path of a scene"));
        assert!(told("see {{#tracefig x.toml}}").contains("a line of its own"));
        assert!(told("{{=x.toml}}").contains("`{{=scene.toml separation}}`"));
        assert_eq!(found("> - {{#tracefig x.toml}}  "), [(1, file("x.toml", ""))]);
    }
}
