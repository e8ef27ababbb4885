//! TOML to the common tree, from toml's own tree with spans.

use toml::Spanned as TomlSpanned;
use toml::de::{DeInteger, DeTable, DeValue};
use toml_parser::lexer::TokenKind;

use super::Spanned;
use super::limits::MAX_NESTING;
use super::node::{Node, NodeValue};
use super::problem::{Fault, MAX_PROBLEMS, Problem};
use super::toml_slips::meant;

/// Reads a TOML text.
pub(super) fn parse(text: &str) -> Result<Node, Vec<Problem>> {
    if let Some(problem) = too_deep(text) {
        return Err(vec![problem]);
    }
    let (root, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        return Err(one_a_line(&errors, text));
    }
    let mut problems = Vec::new();
    let span = root.span();
    let value = table(root.into_inner(), 0, &mut problems);
    if problems.is_empty() { Ok(Node { value, span }) } else { Err(problems) }
}

/// After an error the parser guesses how to go on; only its first complaint about a line is sure to be one.
fn one_a_line(errors: &[toml::de::Error], text: &str) -> Vec<Problem> {
    let mut problems: Vec<Problem> = Vec::new();
    let mut last = None;
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        // Only what lies between two is looked at: a file may have a hundred thousand.
        let between =
            last.and_then(|last: usize| text.as_bytes().get(last.min(span.start)..last.max(span.start)));
        last = Some(span.start);
        if between.is_some_and(|bytes| !bytes.contains(&b'\n')) {
            continue;
        }
        if problems.len() == MAX_PROBLEMS {
            break;
        }
        let message = error.message();
        let fault = if message.contains("duplicate key") {
            Fault::DuplicateKey { key: text.get(span.clone()).unwrap_or_default().to_owned() }
        } else {
            let written = text.get(span.clone()).unwrap_or_default();
            let help = meant(message, line_at(text, span.start), written);
            let help = help.map_or_else(String::new, |help| format!("; {help}"));
            Fault::Syntax { message: format!("not TOML: {}{help}", message.replace('\n', ", ")) }
        };
        problems.push(Problem::new(fault, span));
    }
    problems
}

/// The line of a text that holds a byte.
fn line_at(text: &str, at: usize) -> &str {
    let (before, after) = text.split_at_checked(at).unwrap_or((text, ""));
    let start = before.rfind('\n').map_or(0, |i| i + 1);
    let end = after.find('\n').map_or(text.len(), |i| before.len() + i);
    text.get(start..end).unwrap_or_default()
}

/// Brackets or parts of a dotted key a million deep would become as many nested values, and dropping these as
/// many nested calls; the parser would also complain a million times.
fn too_deep(text: &str) -> Option<Problem> {
    let (mut dots, mut brackets) = (0_usize, 0_usize);
    for token in toml_parser::Source::new(text).lex() {
        match token.kind() {
            TokenKind::Dot => dots += 1,
            TokenKind::LeftCurlyBracket | TokenKind::LeftSquareBracket => {
                dots = 0;
                brackets += 1;
            }
            TokenKind::RightCurlyBracket | TokenKind::RightSquareBracket => {
                dots = 0;
                brackets = brackets.saturating_sub(1);
            }
            TokenKind::Equals | TokenKind::Comma | TokenKind::Newline => dots = 0,
            _ => {}
        }
        let got = dots.max(brackets);
        if got > MAX_NESTING {
            let at = token.span().start();
            let fault =
                Fault::OverLimit { what: "nesting".to_owned(), limit: MAX_NESTING, unit: "levels", got };
            return Some(Problem::new(fault, at..at + 1));
        }
    }
    None
}

fn table(entries: DeTable<'_>, depth: usize, problems: &mut Vec<Problem>) -> NodeValue {
    NodeValue::Table(
        entries
            .into_iter()
            .map(|(key, value)| {
                let span = key.span();
                (Spanned { value: key.into_inner().into_owned(), span }, node(value, depth + 1, problems))
            })
            .collect(),
    )
}

fn node(value: TomlSpanned<DeValue<'_>>, depth: usize, problems: &mut Vec<Problem>) -> Node {
    let span = value.span();
    if depth > MAX_NESTING {
        let fault =
            Fault::OverLimit { what: "nesting".to_owned(), limit: MAX_NESTING, unit: "levels", got: depth };
        problems.push(Problem::new(fault, span.start..span.start + 1));
        return Node { value: NodeValue::Other("a nested value"), span };
    }
    let value = match value.into_inner() {
        DeValue::String(text) => NodeValue::Text(text.into_owned()),
        DeValue::Integer(n) => NodeValue::Number(integer(&n)),
        // `f64::from_str` rounds to nearest and reads "inf" and "nan" too.
        DeValue::Float(x) => NodeValue::Number(x.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(b) => NodeValue::Bool(b),
        DeValue::Datetime(_) => NodeValue::Other("a date"),
        DeValue::Array(items) => {
            NodeValue::List(items.into_iter().map(|item| node(item, depth + 1, problems)).collect())
        }
        DeValue::Table(entries) => table(entries, depth, problems),
    };
    Node { value, span }
}

/// Decimal digits of any length round to nearest; in other bases up to 2¹²⁷ do.
#[expect(
    clippy::cast_precision_loss,
    reason = "`as` rounds to nearest, which is what a number in a file means"
)]
fn integer(n: &DeInteger<'_>) -> f64 {
    if n.radix() == 10 {
        n.as_str().parse().unwrap_or(f64::NAN)
    } else {
        i128::from_str_radix(n.as_str(), n.radix()).map_or(f64::INFINITY, |i| i as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_knows_its_bytes() {
        let text = "title = 'x'\n[shapes.A]\nradius = 0x10\npoints = [[1, -2.5e3],\n [inf, 1_000]]\n";
        let root = parse(text).unwrap();
        let a = root.get("shapes").unwrap().get("A").unwrap();
        let radius = a.get("radius").unwrap();
        assert_eq!((&radius.value, &text[radius.span.clone()]), (&NodeValue::Number(16.0), "0x10"));
        let NodeValue::List(rows) = &a.get("points").unwrap().value else { panic!("a list") };
        let NodeValue::List(second) = &rows[1].value else { panic!("a list") };
        assert_eq!(second[0].value, NodeValue::Number(f64::INFINITY));
        assert_eq!(second[1].value, NodeValue::Number(1000.0));
        assert_eq!(&text[second[1].span.clone()], "1_000");
    }

    #[test]
    fn a_name_of_other_letters_is_to_be_quoted() {
        let problems = parse("[shapes.方块]\nkind = 'box'").unwrap_err();
        let said = problems[0].fault.to_string();
        assert!(said.ends_with("; such a name stands in quotes: [shapes.\"方块\"]"), "{said}");
        assert!(parse("[shapes.\"方块\"]\nkind = 'box'").is_ok());
    }

    #[test]
    fn each_broken_line_is_told_once() {
        let problems = parse("a = \nb = 1\nc = [1,\n").unwrap_err();
        assert!(problems.len() >= 2, "{problems:?}");
        assert!(problems.iter().all(|p| p.fault.code() == "syntax"));
    }

    #[test]
    fn deep_nesting_is_an_error_and_not_a_crash() {
        for text in [
            format!("a{} = 1", ".a".repeat(200_000)),
            format!("[a{}]", ".a".repeat(200_000)),
            format!("a = {}{}", "[".repeat(200_000), "]".repeat(200_000)),
            format!("a = {}", "{a=".repeat(100_000)),
            format!("a = {{ a{} = 1 }}", ".a".repeat(200_000)),
        ] {
            assert!(parse(&text).is_err());
        }
    }

    #[test]
    fn twin_keys_are_an_error() {
        let problems = parse("a = 1\nb = 2\na = 3\n").unwrap_err();
        assert_eq!(problems[0].fault.code(), "duplicate-key");
        assert_eq!(problems[0].span, 12..13);
    }
}
