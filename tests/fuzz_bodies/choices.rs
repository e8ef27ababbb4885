//! Bytes as choices: what a fuzzer changes byte by byte becomes a scene that is mostly well-formed, so that
//! its changes reach the drawing and not only the reader.

use std::fmt::Write;

use tracefig::collision::{ALGORITHMS, Bodies, Motion, QUERIES};
use tracefig::figure::layer::{LAYERS, Layer, Shows};
use tracefig::figure::theme::THEMES;
use tracefig::figure::{COMMON, Takes};
use tracefig::geometry::shape::{FieldType, KINDS, Kind};

/// Numbers up to the ends of what a double and what a scene holds.
const EXTREMES: &[&str] = &[
    "0",
    "-0.0",
    "1e300",
    "-1e300",
    "1e150",
    "-1e155",
    "5e-324",
    "-5e-324",
    "1e-300",
    "2.2250738585072014e-308",
    "1e9",
    "-1e9",
    "1e-9",
    "1e16",
    "9007199254740993",
    "0.1",
    "1e6",
    "360",
    "1e10",
    "180",
    "89.99999999999999",
    "1e22",
];

/// Pieces that texts are made of.
const PIECES: &[&str] = &[
    "a",
    " ",
    "x_1",
    "$",
    "$$",
    "\\",
    "{",
    "}",
    "{=separation}",
    "{a|the box $A$}",
    "{=time}",
    "{=D.x}",
    "$\\frac{1}{2}$",
    "$\\hat{n}$",
    "$\\sqrt{}$",
    "$\\,$",
    "$\\text{}$",
    "\\$",
    "\u{200b}",
    "\u{202e}",
    "δ",
    "漢",
    "\t",
    "\u{1b}",
    "_",
    "^",
    "%",
    "&",
    "$x^{2}_{i}$",
    "long words that need their room on the page ",
    "A′",
    "crate_1",
    "-",
    "(",
    "\u{301}",
];

/// Vertices of a convex polygon, and of each that leaves out the last of them.
const AROUND: [[f64; 2]; 8] =
    [[3.0, 0.0], [2.0, 2.0], [0.0, 3.0], [-2.0, 2.0], [-3.0, 0.0], [-2.0, -2.0], [0.0, -3.0], [2.0, -2.0]];

/// What is left to choose by; zeros when it is used up.
pub(crate) struct Choices<'b>(&'b [u8]);

impl<'b> Choices<'b> {
    pub(crate) fn new(bytes: &'b [u8]) -> Self {
        Self(bytes)
    }

    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// A number below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n.max(1)
    }

    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }

    pub(crate) fn of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }

    /// A number: of a figure, of any size, at an end, or of any bits.
    fn number(&mut self) -> String {
        let small = f64::from(self.byte().cast_signed());
        match self.below(6) {
            0..=2 => format!("{}", small / 16.0),
            3 => format!("{small}e{}", i32::from(self.byte().cast_signed()) * 2),
            4 => (*self.of(EXTREMES)).to_owned(),
            _ => {
                let bits = u64::from_le_bytes(std::array::from_fn(|_| self.byte()));
                let number = f64::from_bits(bits);
                if number.abs() <= 1e300 { format!("{number:e}") } else { "1".to_owned() }
            }
        }
    }

    fn point(&mut self) -> String {
        format!("[{}, {}]", self.number(), self.number())
    }

    /// A text in TOML's quotes.
    fn text(&mut self) -> String {
        let text: String = (0..self.below(6)).map(|_| *self.of(PIECES)).collect();
        let mut quoted = String::from("\"");
        for c in text.chars() {
            match c {
                '"' | '\\' => quoted.extend(['\\', c]),
                c if c.is_control() => _ = write!(quoted, "\\u{:04X}", u32::from(c)),
                c => quoted.push(c),
            }
        }
        quoted + "\""
    }

    fn vertices(&mut self) -> String {
        let (count, scale) = (3 + self.below(6), self.number());
        let scale: f64 = scale.parse().unwrap_or(1.0);
        let place = |[x, y]: &[f64; 2]| format!("[{:e}, {:e}]", x * scale, y * scale);
        let places: Vec<String> = AROUND.iter().take(count).map(place).collect();
        format!("[{}]", places.join(", "))
    }

    /// A shape's table; `turns` is whether it may turn as it moves.
    fn shape(&mut self, name: &str, turns: bool) -> String {
        let kinds: Vec<&Kind> = KINDS.iter().filter(|kind| kind.name != "outline").collect();
        let kind = if self.one_in(12) { self.of(KINDS) } else { *self.of(&kinds) };
        let mut text = format!("[shapes.{name}]\nkind = {:?}\n", kind.name);
        for field in kind.fields {
            if !field.required && self.one_in(2) {
                continue;
            }
            let value = match field.holds {
                FieldType::Length => self.number().trim_start_matches('-').to_owned(),
                FieldType::Count { .. } => (*self.of(&["3", "4", "7", "12", "2"])).to_owned(),
                FieldType::Point | FieldType::Extents => self.point().replace('-', "").replace('e', "e-"),
                FieldType::Points { .. } if field.name == "points" => {
                    format!("[{}, {}]", self.point(), self.point())
                }
                FieldType::Points { .. } => self.vertices(),
                FieldType::Switch => (*self.of(&["true", "false"])).to_owned(),
            };
            let _ = writeln!(text, "{} = {value}", field.name);
        }
        let mut keys = vec![("position", true, true), ("angle_deg", false, kind.turns)];
        keys.extend([("velocity", true, true), ("angular_velocity_deg", false, kind.turns && turns)]);
        for (key, is_pair, suits) in keys {
            if suits && !self.one_in(4) {
                let value = if is_pair { self.point() } else { self.number() };
                let _ = writeln!(text, "{key} = {value}");
            }
        }
        text
    }

    fn layer(&mut self, layer: &Layer) -> String {
        let mut text = format!("{{ layer = {:?}", layer.name);
        for option in layer.options.iter().chain(COMMON) {
            if !self.one_in(3) {
                continue;
            }
            let value = match option.takes {
                Takes::Flag => (*self.of(&["true", "false"])).to_owned(),
                Takes::Number | Takes::Positive => self.number(),
                Takes::Point => format!("[{}, {}]", self.number(), self.number()),
                Takes::Counts => (*self.of(&["0", "[0, 2]", "1", "[]", "[7, 1]"])).to_owned(),
                Takes::Word(words) => format!("{:?}", self.of(words)),
                Takes::Words(words) => format!("[{:?}, {:?}]", self.of(words), self.of(words)),
                Takes::Bodies => (*self.of(&["[\"A\"]", "[\"B\", \"A\"]", "\"B\""])).to_owned(),
                Takes::When(words) if self.one_in(2) => format!("{:?}", self.of(words)),
                Takes::When(_) => (*self.of(&["0", "0.5", "1", "1e-300", "5e-324"])).to_owned(),
                Takes::Role => (*self.of(&["\"a\"", "\"b\"", "\"now\"", "\"ink\""])).to_owned(),
                Takes::Lines => format!("[{}, {}]", self.text(), self.text()),
            };
            let _ = write!(text, ", {} = {value}", option.name);
        }
        text + " }"
    }

    fn panel(&mut self) -> String {
        let space = *self.of(&["\"world\"", "\"configuration\"", "\"body\"\nframe = \"A\""]);
        let other = if space == "\"configuration\"" { Shows::World } else { Shows::Configuration };
        let suited: Vec<&Layer> = LAYERS.iter().filter(|layer| layer.shows != other).collect();
        let layers: Vec<String> = (0..=self.below(6))
            .map(|_| {
                let layer = *self.of(&suited);
                self.layer(layer)
            })
            .collect();
        let mut text = format!("[[panels]]\nspace = {space}\nlayers = [{}]\n", layers.join(", "));
        if self.one_in(3) {
            let _ = writeln!(text, "title = {}", self.text());
        }
        match self.below(6) {
            0 => {
                let mut ends: Vec<(f64, String)> = (0..4)
                    .map(|_| {
                        let number = self.number();
                        (number.parse().unwrap_or(0.0), number)
                    })
                    .collect();
                ends[..2].sort_by(|a, b| a.0.total_cmp(&b.0));
                ends[2..].sort_by(|a, b| a.0.total_cmp(&b.0));
                let [x0, x1, y0, y1] = [0, 1, 2, 3].map(|i| ends[i].1.as_str());
                let _ = writeln!(text, "view = [{x0}, {y0}, {x1}, {y1}]");
            }
            1 => text += "view = [-1e300, -1, 1e300, 1]\n",
            2 => text += "view = [-1e-9, -1e-9, 1e-9, 1]\n",
            3 => _ = writeln!(text, "time = {}", *self.of(&["\"hit\"", "\"end\"", "0.5", "1"])),
            4 => _ = writeln!(text, "step = {}", 1 + self.below(4)),
            _ => {}
        }
        text
    }

    fn labels(&mut self) -> String {
        let keys: Vec<&str> =
            LAYERS.iter().flat_map(|layer| layer.labels.iter().map(|label| label.key)).collect();
        let mut text = String::from("[labels]\n");
        let mut taken = Vec::new();
        for _ in 0..self.below(5) {
            let key = if self.one_in(2) { *self.of(&["A", "B"]) } else { *self.of(&keys) };
            if taken.contains(&key) {
                continue;
            }
            taken.push(key);
            let at = *self.of(&["\"NE\"", "\"W\"", "[0, 0]", "[1e9, -1e9]", "[-40, 3]"]);
            let label = self.text();
            let value = if self.one_in(3) { format!("{{ text = {label}, at = {at} }}") } else { label };
            let _ = writeln!(text, "{key:?} = {value}");
        }
        text
    }

    /// Two bodies and a question about them: of them both, and of a kind that is among `kinds` where some
    /// are given.
    pub(crate) fn question(&mut self, kinds: &[&str]) -> String {
        let all: Vec<_> = QUERIES.iter().filter(|q| kinds.is_empty() || kinds.contains(&q.word)).collect();
        let query = *self.of(&all);
        let turns = query.motion == Motion::Any;
        let mut text = self.shape("A", turns) + &self.shape("B", turns);
        let single = kinds.is_empty() && query.bodies == Bodies::OneOrTwo && self.one_in(2);
        let of = if single { "[\"A\"]" } else { "[\"A\", \"B\"]" };
        let _ = write!(text, "[query]\nkind = {:?}\nof = {of}\n", query.word);
        if kinds.is_empty() && self.one_in(4) {
            let suited: Vec<_> = ALGORITHMS.iter().filter(|a| a.kinds.contains(&query.kind)).collect();
            let _ = writeln!(text, "algorithm = {:?}", self.of(&suited).name);
        }
        // A hang is to be found in the search, not in a cap that was asked for.
        let _ = writeln!(text, "max_iterations = {}", 1 + self.below(200));
        text
    }

    /// A scene with its panels and labels.
    pub(crate) fn scene(&mut self) -> String {
        let head = if self.one_in(2) {
            format!("title = {}\ncaption = {}\n", self.text(), self.text())
        } else {
            String::new()
        };
        let mut text = head + &self.question(&[]);
        for _ in 0..=self.below(3) {
            text += &self.panel();
        }
        text += &self.labels();
        let theme = self.of(THEMES).name;
        let (width, height) = (100 + 4 * usize::from(self.byte()), 100 + 2 * usize::from(self.byte()));
        let _ = write!(text, "[canvas]\nwidth = {width}\nheight = {height}\ntheme = {theme:?}\n");
        text
    }
}
