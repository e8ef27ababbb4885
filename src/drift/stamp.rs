//! What a figure's file says of itself: the hash of its scene and options, the answer, the numbers of the trace.
//!
//! An SVG carries it in `<metadata>`, a PNG carries the hash as text. Written when a figure is drawn and read when it is
//! compared, it tells a figure whose scene has changed since (*stale*) from one that tracefig draws otherwise now
//! (*changed*), and what moved in words.

use std::fmt::Write;
use std::io::Cursor;

use serde_json::{Value, json};

use crate::scene::{Scene, answer_json};
use crate::trace::{Trace, json_lines};

/// The tracefig that drew a figure.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Version of the metadata's format.
pub const STAMP_FORMAT: u32 = 1;

/// The metadata of a figure has at most so many bytes, as it stands in an SVG.
const MAX_BYTES: usize = 8_000;

/// Bytes of them that are kept for what stands around the events.
const AROUND: usize = 200;

/// Events of a trace that are looked at for the metadata; no more fit than these.
const MAX_EVENTS: usize = 120;

/// What a file says of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Stamp {
    /// Of the scene and the options.
    pub hash: String,
    /// The tracefig that drew it.
    pub version: String,
    /// All of it, as JSON; in a PNG there is only the hash.
    pub facts: Option<Value>,
}

/// Hash of a scene's text and of the options that its bytes depend on: 32 hexadecimal digits of FNV-1a (Fowler, Noll,
/// Vo, IETF draft-eastlake-fnv) in 128 bits. It finds changes; it does not withstand someone who looks for a clash.
///
/// ```
/// use tracefig::drift::fingerprint;
/// assert_eq!(fingerprint("", ""), fingerprint("", ""));
/// assert_ne!(fingerprint("a", "b"), fingerprint("ab", ""));
/// assert_eq!(fingerprint("a", "b").len(), 32);
/// ```
#[must_use]
pub fn fingerprint(scene: &str, options: &str) -> String {
    const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    // A byte that no text has keeps the two apart.
    let bytes = scene.bytes().chain([0xff]).chain(options.bytes());
    let hash = bytes.fold(BASIS, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    format!("{hash:032x}")
}

/// The text of a PNG: the hash and the version.
#[must_use]
pub fn text_chunk(hash: &str) -> String {
    format!("{hash} {VERSION}")
}

/// What is the same for every file of a scene: the question, the answer, the first events of its trace.
#[must_use]
pub fn facts(scene: &Scene) -> String {
    let query = &scene.query;
    let mut trace = Trace::default();
    let answer = (query.algorithm.traced)(&scene.query_of_bodies(), &mut trace);
    let total = trace.events.len();
    trace.events.truncate(MAX_EVENTS);
    let mut facts = format!(
        "\"algorithm\":{},\"answer\":{},\"events\":{total},\"trace\":[",
        json!(query.algorithm.name),
        answer_json(query.kind, &answer)
    );
    // The first line is a header; a trace without a form in JSON, which none is, is left out.
    let lines = json_lines(&trace).unwrap_or_default();
    let mut bytes = escaped_length(&facts) + AROUND;
    for (i, event) in lines.lines().skip(1).enumerate() {
        bytes += escaped_length(event) + 1;
        if bytes > MAX_BYTES {
            break;
        }
        let comma = if i == 0 { "" } else { "," };
        let _ = write!(facts, "{comma}{event}");
    }
    facts.push(']');
    facts
}

/// Bytes of a text in an SVG, where a quotation mark is `&quot;`.
fn escaped_length(text: &str) -> usize {
    text.len() + ("&quot;".len() - 1) * text.matches('"').count()
}

/// The metadata of one file.
///
/// ```
/// let text = tracefig::drift::metadata("00ff", "\"answer\":null");
/// assert!(text.starts_with(r#"{"tracefig_figure":1,"version":""#));
/// assert!(text.ends_with(r#"","hash":"00ff","answer":null}"#));
/// ```
#[must_use]
pub fn metadata(hash: &str, facts: &str) -> String {
    format!("{{\"tracefig_figure\":{STAMP_FORMAT},\"version\":\"{VERSION}\",\"hash\":\"{hash}\",{facts}}}")
}

impl Stamp {
    /// Whether this tracefig drew the file, of a scene and options with this hash.
    #[must_use]
    pub fn is_of(&self, hash: &str) -> bool {
        self.hash == hash && self.version == VERSION
    }

    /// What a file says of itself; None where it is none of ours.
    #[must_use]
    pub fn read(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"\x89PNG") {
            Self::of_png(bytes)
        } else {
            Self::of_svg(std::str::from_utf8(bytes).ok()?)
        }
    }

    fn of_svg(text: &str) -> Option<Self> {
        let start = text.find("<metadata>")? + "<metadata>".len();
        let end = start + text[start..].find("</metadata>")?;
        let facts: Value = serde_json::from_str(&unescape(&text[start..end])).ok()?;
        facts.get("tracefig_figure")?;
        let text = |key: &str| Some(facts.get(key)?.as_str()?.to_owned());
        Some(Self { hash: text("hash")?, version: text("version")?, facts: Some(facts) })
    }

    fn of_png(bytes: &[u8]) -> Option<Self> {
        let reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
        let text = reader.info().uncompressed_latin1_text.iter().find(|t| t.keyword == "tracefig")?;
        let (hash, version) = text.text.split_once(' ')?;
        Some(Self { hash: hash.to_owned(), version: version.to_owned(), facts: None })
    }
}

/// The entities that XML text may hold.
fn unescape(text: &str) -> String {
    let named =
        [("&#39;", "'"), ("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
    named.iter().fold(text.to_owned(), |text, (entity, c)| text.replace(entity, c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    const SCENE: &str = "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\nposition = [3, 0]\n[query]\nkind = 'separation'\nof = ['A', 'B']\n";

    #[test]
    fn what_is_written_is_read_again() {
        let scene = open_text("s.toml", SCENE).unwrap().scene;
        let text = metadata("00ff", &facts(&scene));
        assert!(escaped_length(&text) <= MAX_BYTES, "{}", text.len());
        let svg =
            format!("<svg><metadata>{}</metadata></svg>", text.replace('&', "&amp;").replace('<', "&lt;"));
        let stamp = Stamp::read(svg.as_bytes()).unwrap();
        assert!(stamp.is_of("00ff") && !stamp.is_of("00fe"));
        let facts = stamp.facts.unwrap();
        assert_eq!(facts["answer"]["separation"], 1.0);
        assert_eq!(facts["trace"][0]["event"], "started");
    }

    #[test]
    fn other_files_have_no_stamp() {
        assert_eq!(Stamp::read(b"<svg><metadata>{}</metadata></svg>"), None);
        assert_eq!(Stamp::read(b"<svg/>"), None);
        assert_eq!(Stamp::read(b"\x89PNG\r\n"), None);
        assert_eq!(Stamp::read(b"\xff\xfe"), None);
    }

    #[test]
    fn a_long_trace_is_cut_to_the_limit() {
        let corners: Vec<String> = (0..400)
            .map(|i| {
                let x = f64::from(i) - 200.0;
                format!("[{x}, {}]", 0.01 * x * x)
            })
            .collect();
        let polygon = format!("kind = 'polygon'\nvertices = [{}]\nposition = [0, -300]", corners.join(", "));
        let scene = SCENE
            .replacen("kind = 'circle'\nradius = 1", &polygon, 1)
            .replace("of =", "algorithm = 'minkowski'\nof =");
        let scene = open_text("s.toml", &scene).unwrap().scene;
        let text = metadata("00ff", &facts(&scene));
        let bytes = escaped_length(&text);
        assert!(bytes <= MAX_BYTES && bytes > MAX_BYTES / 2, "{bytes}");
        assert!(serde_json::from_str::<Value>(&text).is_ok());
    }
}
