//! The panels of the house, which are written as a scene file has them, as JSON.
//!
//! A page that draws again reads no TOML, and where a scene has no panels it needs them all the same, as a
//! drag may lead to another answer with another picture. So the little TOML that they are written in is put
//! into the other language of scenes, wherever they are read: `[[panels]]` before each panel, `key = value` a
//! line, texts between quotes and without escapes, lists and tables that may break after a comma.

/// The panels of a text of the house as a scene in JSON.
pub(crate) fn as_json(text: &str) -> String {
    let mut json = String::from("{\"panels\":[");
    for (i, panel) in text.split("[[panels]]").skip(1).enumerate() {
        json.push_str(if i == 0 { "{" } else { ",{" });
        entries(panel.trim_start(), &mut json);
        json.push('}');
    }
    json.push_str("]}");
    json
}

/// The entries of a table, apart as JSON has them: by a comma, and with none after the last.
fn entries(panel: &str, json: &mut String) {
    let (mut rest, mut depth, mut apart) = (panel, 0_usize, false);
    while let Some(first) = rest.chars().next() {
        let (token, after) = rest.split_at(length(rest, first));
        rest = after;
        match first {
            ' ' => {}
            '\n' => apart |= depth == 0,
            ',' => apart = true,
            '=' => json.push(':'),
            _ => {
                depth += usize::from(matches!(first, '[' | '{'));
                let closes = matches!(first, ']' | '}');
                depth -= usize::from(closes && depth > 0);
                if std::mem::take(&mut apart) && !closes {
                    json.push(',');
                }
                let quote = if first != '"' && after.starts_with(" =") { "\"" } else { "" };
                json.extend([quote, token, quote]);
            }
        }
    }
}

/// Bytes of the token that a text begins with: a text between quotes, a word or number, or a character.
fn length(rest: &str, first: char) -> usize {
    let of_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '+' | '.');
    match first {
        '"' => rest[1..].find('"').map_or(rest.len(), |end| end + 2),
        _ if of_word(first) => rest.find(|c| !of_word(c)).unwrap_or(rest.len()),
        _ => first.len_utf8(),
    }
}
