//! What was meant by a line that is no TOML: slips of those who come from other languages, or from a word
//! processor.

/// What would help with a line that the parser complains about, at the text that it quotes; `None` where
/// nothing is known.
pub(super) fn meant(message: &str, line: &str, quoted: &str) -> Option<String> {
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    if ["//", "--", "/*"].iter().any(|sign| line.trim_start().starts_with(sign)) {
        return Some("a comment begins with `#`".to_owned());
    }
    if line.contains(['“', '”', '„', '«', '’', '‘']) {
        return Some("texts stand between straight quotes, as \"A\"".to_owned());
    }
    let is_name = message.contains("unquoted key") || message.contains("unclosed table");
    if let Some(key) = key_in_quotes(line, quoted).filter(|_| is_name) {
        return Some(format!("such a name stands in quotes: {key}"));
    }
    if message.contains("must be quoted") {
        let words: Vec<&str> = quoted.split_whitespace().collect();
        return match words[..] {
            [_, _, ..] if words.iter().all(|word| is_number(word)) => {
                Some(format!("commas stand between values, as {}", words.join(", ")))
            }
            [number, unit] if is_number(number) && unit.chars().all(|c| c.is_alphabetic() || c == '°') => {
                Some(format!("numbers have no unit: {number}"))
            }
            [word] if word.starts_with(|c: char| c.is_ascii_digit()) => {
                Some("a number is written out, as 0.5".to_owned())
            }
            [word] if word.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '.')) => {
                Some(format!("a text stands between quotes: \"{word}\""))
            }
            _ => None,
        };
    }
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    if value.starts_with('.') || value.starts_with("-.") {
        return Some("a digit stands before the point, as 0.5".to_owned());
    }
    let is_list = value.contains(',') && value.split(',').all(|word| is_number(word.trim()));
    let has_comma = |(whole, part): &(&str, &str)| {
        [whole.trim_start_matches('-'), part].iter().all(|word| word.bytes().all(|b| b.is_ascii_digit()))
    };
    let decimal = value.split_once(',').filter(has_comma);
    is_list.then(|| match decimal {
        Some((whole, part)) => {
            format!("a point stands before decimals: {whole}.{part}; a list between brackets: [{value}]")
        }
        None => format!("a list stands between brackets: [{value}]"),
    })
}

/// The key of a line around what the parser quotes, with the names in quotes that need them; a header as the
/// whole. `None` where no name does.
fn key_in_quotes(line: &str, quoted: &str) -> Option<String> {
    let line = line.trim();
    let key = if let Some(end) = line.rfind(']').filter(|_| line.starts_with('[')) {
        &line[..=end]
    } else {
        let at = line.find(quoted).filter(|_| !quoted.is_empty())?;
        let ends = ['=', '{', '}', ',', ' '];
        let from = line[..at].rfind(ends).map_or(0, |i| i + 1);
        &line[from..at + line[at..].find(ends).unwrap_or(line.len() - at)]
    };
    let named = |part: &str| {
        let name = part.trim_matches(['[', ']']).trim();
        let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '"' | '\'');
        if name.chars().all(is_bare) { part.to_owned() } else { part.replace(name, &format!("\"{name}\"")) }
    };
    let mended: Vec<String> = key.split('.').map(named).collect();
    let mended = mended.join(".");
    (mended != key).then_some(mended)
}

#[cfg(test)]
mod tests {
    use crate::scene::open_text;

    #[test]
    fn a_slip_comes_with_what_was_meant() {
        for (line, meant) in [
            ("// the question", "a comment begins with `#`"),
            ("kind = “circle”", "texts stand between straight quotes, as \"A\""),
            ("position = [3 0]", "commas stand between values, as 3, 0"),
            ("position = 3, 0", "a list stands between brackets: [3, 0]"),
            ("radius = 1,5", "a point stands before decimals: 1.5; a list between brackets: [1,5]"),
            ("radius = .5", "a digit stands before the point, as 0.5"),
            ("radius = 1/2", "a number is written out, as 0.5"),
            ("radius = 1 m", "numbers have no unit: 1"),
            ("angle_deg = 45 °", "numbers have no unit: 45"),
            ("kind = circle", "a text stands between quotes: \"circle\""),
            ("[shapes.方块]", "such a name stands in quotes: [shapes.\"方块\"]"),
            ("[shapes.Tür]", "such a name stands in quotes: [shapes.\"Tür\"]"),
            ("shapes.Tür.größe = 1", "such a name stands in quotes: shapes.\"Tür\".\"größe\""),
            ("shapes = { Tür = { kind = 'circle' } }", "such a name stands in quotes: \"Tür\""),
            ("[shapes.My box]", "such a name stands in quotes: [shapes.\"My box\"]"),
        ] {
            let refused = open_text("s.toml", &format!("title = 'x'\n{line}\n")).unwrap_err();
            let said = refused.problems[0].fault.to_string();
            assert!(said.starts_with("not TOML: ") && said.ends_with(&format!("; {meant}")), "{said}");
        }
    }
}
