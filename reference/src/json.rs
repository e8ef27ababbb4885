//! JSON, read and written; numbers by the standard library's correctly rounded parser.
//!
//! Not `serde_json`: the solver reads with that, and a misread number would hide here.

use std::fmt::Write as _;

/// A JSON value; objects keep their order.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// `null`.
    Null,
    /// `true`, `false`.
    Bool(bool),
    /// A number, as the nearest double.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    List(Vec<Json>),
    /// An object.
    Object(Vec<(String, Json)>),
}

impl Json {
    /// Reads one value that fills the text.
    ///
    /// # Errors
    /// Says what is wrong and at which byte.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut reader = Reader { bytes: text.as_bytes(), at: 0 };
        let value = reader.value()?;
        reader.space();
        if reader.at < reader.bytes.len() { Err(reader.wrong("end of text")) } else { Ok(value) }
    }

    /// The value of a key; None where there is none, or no object.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Json> {
        match self {
            Self::Object(fields) => fields.iter().find(|(name, _)| name == key).map(|(_, value)| value),
            _ => None,
        }
    }

    /// Sets or adds a key of an object.
    pub fn set(&mut self, key: &str, value: Json) {
        if let Self::Object(fields) = self {
            match fields.iter_mut().find(|(name, _)| name == key) {
                Some(slot) => slot.1 = value,
                None => fields.push((key.to_owned(), value)),
            }
        }
    }

    /// The number.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(x) = self { Some(*x) } else { None }
    }

    /// The string.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        if let Self::Text(x) = self { Some(x) } else { None }
    }

    /// The elements; none where it is no array.
    #[must_use]
    pub fn list(&self) -> &[Json] {
        if let Self::List(x) = self { x } else { &[] }
    }

    /// The number of a key.
    #[must_use]
    pub fn number_at(&self, key: &str) -> Option<f64> {
        self.get(key)?.number()
    }

    /// The string of a key.
    #[must_use]
    pub fn text_at(&self, key: &str) -> Option<&str> {
        self.get(key)?.text()
    }

    /// Two numbers of a key.
    #[must_use]
    pub fn pair_at(&self, key: &str) -> Option<[f64; 2]> {
        self.get(key)?.pair()
    }

    /// An array of two numbers.
    #[must_use]
    pub fn pair(&self) -> Option<[f64; 2]> {
        match self.list() {
            [x, y] => Some([x.number()?, y.number()?]),
            _ => None,
        }
    }

    /// An array of two numbers.
    #[must_use]
    pub fn from_pair(pair: [f64; 2]) -> Self {
        Self::List(pair.map(Self::Number).to_vec())
    }

    /// An object.
    #[must_use]
    pub fn object<const K: usize>(fields: [(&str, Json); K]) -> Self {
        Self::Object(fields.map(|(name, value)| (name.to_owned(), value)).to_vec())
    }
}

impl std::fmt::Display for Json {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Null => f.write_str("null"),
            Self::Bool(x) => write!(f, "{x}"),
            Self::Number(x) => {
                if x.abs() >= 1e15 || (*x != 0.0 && x.abs() < 1e-5) {
                    write!(f, "{x:e}")
                } else {
                    write!(f, "{x}")
                }
            }
            Self::Text(x) => quote(f, x),
            Self::List(items) => {
                f.write_char('[')?;
                for (i, item) in items.iter().enumerate() {
                    write!(f, "{}{item}", if i > 0 { ", " } else { "" })?;
                }
                f.write_char(']')
            }
            Self::Object(fields) => {
                f.write_char('{')?;
                for (i, (name, value)) in fields.iter().enumerate() {
                    f.write_str(if i > 0 { ", " } else { "" })?;
                    quote(f, name)?;
                    write!(f, ": {value}")?;
                }
                f.write_char('}')
            }
        }
    }
}

fn quote(f: &mut std::fmt::Formatter<'_>, text: &str) -> std::fmt::Result {
    f.write_char('"')?;
    for c in text.chars() {
        match c {
            '"' | '\\' => write!(f, "\\{c}")?,
            c if c < ' ' => write!(f, "\\u{:04x}", u32::from(c))?,
            c => f.write_char(c)?,
        }
    }
    f.write_char('"')
}

struct Reader<'t> {
    bytes: &'t [u8],
    at: usize,
}

impl Reader<'_> {
    fn wrong(&self, expected: &str) -> String {
        format!("expected {expected} at byte {}", self.at)
    }

    fn space(&mut self) {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    fn eat(&mut self, word: &str) -> bool {
        let found = self.bytes[self.at..].starts_with(word.as_bytes());
        if found {
            self.at += word.len();
        }
        found
    }

    fn value(&mut self) -> Result<Json, String> {
        self.space();
        match self.bytes.get(self.at) {
            Some(b'{') => self.object(),
            Some(b'[') => self.array(),
            Some(b'"') => self.string().map(Json::Text),
            Some(b'-' | b'0'..=b'9') => self.number(),
            _ if self.eat("null") => Ok(Json::Null),
            _ if self.eat("true") => Ok(Json::Bool(true)),
            _ if self.eat("false") => Ok(Json::Bool(false)),
            _ => Err(self.wrong("a value")),
        }
    }

    fn object(&mut self) -> Result<Json, String> {
        self.at += 1;
        let mut fields = Vec::new();
        self.space();
        if self.eat("}") {
            return Ok(Json::Object(fields));
        }
        loop {
            self.space();
            let name = self.string()?;
            self.space();
            if !self.eat(":") {
                return Err(self.wrong("`:`"));
            }
            fields.push((name, self.value()?));
            self.space();
            if self.eat("}") {
                return Ok(Json::Object(fields));
            }
            if !self.eat(",") {
                return Err(self.wrong("`,` or `}`"));
            }
        }
    }

    fn array(&mut self) -> Result<Json, String> {
        self.at += 1;
        let mut items = Vec::new();
        self.space();
        if self.eat("]") {
            return Ok(Json::List(items));
        }
        loop {
            items.push(self.value()?);
            self.space();
            if self.eat("]") {
                return Ok(Json::List(items));
            }
            if !self.eat(",") {
                return Err(self.wrong("`,` or `]`"));
            }
        }
    }

    fn string(&mut self) -> Result<String, String> {
        if !self.eat("\"") {
            return Err(self.wrong("a string"));
        }
        let mut out = Vec::new();
        loop {
            let Some(byte) = self.bytes.get(self.at).copied() else { return Err(self.wrong("`\"`")) };
            self.at += 1;
            match byte {
                b'"' => return String::from_utf8(out).map_err(|_| self.wrong("UTF-8")),
                b'\\' => {
                    let c = self.escape()?;
                    out.extend_from_slice(c.encode_utf8(&mut [0; 4]).as_bytes());
                }
                byte => out.push(byte),
            }
        }
    }

    fn escape(&mut self) -> Result<char, String> {
        let kind = self.bytes.get(self.at).copied();
        self.at += 1;
        Ok(match kind {
            Some(b'n') => '\n',
            Some(b't') => '\t',
            Some(b'r') => '\r',
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(c @ (b'"' | b'\\' | b'/')) => char::from(c),
            Some(b'u') => {
                let digits = self.bytes.get(self.at..self.at + 4).and_then(|d| std::str::from_utf8(d).ok());
                let code = digits.and_then(|d| u32::from_str_radix(d, 16).ok());
                self.at += 4;
                // Half of a surrogate pair: no scene or answer of ours holds one.
                code.and_then(char::from_u32).unwrap_or('\u{fffd}')
            }
            _ => return Err(self.wrong("an escape")),
        })
    }

    fn number(&mut self) -> Result<Json, String> {
        let start = self.at;
        while self
            .bytes
            .get(self.at)
            .is_some_and(|b| matches!(b, b'-' | b'+' | b'.' | b'e' | b'E' | b'0'..=b'9'))
        {
            self.at += 1;
        }
        let text = std::str::from_utf8(&self.bytes[start..self.at]).unwrap_or("");
        text.parse().map(Json::Number).map_err(|_| self.wrong("a number"))
    }
}

#[cfg(test)]
mod tests {
    use super::Json;

    #[test]
    fn values_print_as_they_were_read() {
        let text =
            r#"{"id": "a\"b", "x": [1, -2.5, 1e-300, 5e-324, 0.1], "y": null, "z": {"t": true, "f": []}}"#;
        assert_eq!(Json::parse(text).expect("valid").to_string(), text);
    }

    #[test]
    fn broken_text_is_refused_with_its_place() {
        for text in ["{", "[1,]", "{\"a\" 1}", "nul", "1 2", "\"x", "--1"] {
            assert!(Json::parse(text).is_err(), "{text}");
        }
        assert_eq!(Json::parse("[1;"), Err("expected `,` or `]` at byte 2".to_owned()));
    }
}
