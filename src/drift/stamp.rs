//! What a figure's file says of itself: the hash of its scene and options, the answer, the events that it
//! shows.
//!
//! A format carries all of it or the hash alone. Written when a figure is drawn and read when it is compared,
//! it tells a figure whose scene has changed since (*stale*) from one that tracefig draws otherwise now
//! (*changed*), and what moved in words.

use serde_json::{Value, json};

use super::shown::tables;
use crate::drawing::Drawing;
use crate::figure::Plan;
use crate::output::{Format, Stamped};
use crate::scene::{Variant, answer_json};
use crate::trace::Event;

/// The tracefig that drew a figure.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Version of the metadata's format, in every file.
const STAMP_FORMAT: u32 = 2;

/// Largest metadata of a figure, in bytes. Tuned on the committed figures: they have 20 to 40 kB, of which
/// metadata at most 6 kB. At half the trace of that one would be cut; at twice a long trace could take a
/// third of a file.
const MAX_BYTES: usize = 8_000;

/// Largest metadata that is read, as those of other versions may be longer.
const MOST_READ: usize = 4 * MAX_BYTES;

/// Bytes of [`MAX_BYTES`] that are kept for version, hash and counts.
const AROUND: usize = 200;

/// What a file says of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Stamp {
    /// The [`fingerprint`] of the scene and the options.
    pub hash: String,
    /// The tracefig that drew it.
    pub version: String,
    /// The whole metadata as JSON, answer and trace; `None` where the format carries the hash alone.
    pub facts: Option<Value>,
}

/// Hash of what a scene says and of the options that its bytes depend on: 32 hexadecimal digits of FNV-1a
/// (Fowler, Noll, Vo, IETF draft-eastlake-fnv) in 128 bits. It finds changes; it does not withstand someone
/// who looks for a clash.
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

/// What a drawing carries in formats that hold no more than a line: the hash and the version.
///
/// ```
/// let text = tracefig::drift::text_chunk("00ff");
/// assert!(text.starts_with("00ff "));
/// ```
#[must_use]
pub fn text_chunk(hash: &str) -> String {
    format!("{hash} {VERSION}")
}

/// The part of the metadata that all files of a drawn scene share: the question, the answer, how many events
/// the trace has, how many of them the figure shows, and those. Which are shown is known once the plan was
/// drawn. A question says that it is one, and no more.
///
/// ```
/// use tracefig::{drift::facts, figure::{draw, plan}, scene::open_text};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']\n\
///             [[panels]]\nlayers = ['shapes']";
/// let file = open_text("s.toml", text)?;
/// let plan = plan(&file.scene).unwrap();
/// let _ = draw(&plan, plan.theme, "f");
/// assert!(facts(&plan).contains(r#""answer":{"kind":"bounds""#));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn facts(plan: &Plan<'_>) -> String {
    if plan.scene.variant == Variant::Question {
        return format!("\"variant\":{}", json!(plan.scene.variant.word()));
    }
    let (query, own) = (&plan.scene.query, plan.own_run());
    let runs = plan.all_runs();
    let shown: Vec<&Event> = runs.iter().flat_map(|run| run.shown()).collect();
    let head = format!(
        "\"algorithm\":{},\"answer\":{},\"events\":{},\"shown\":{}",
        json!(query.algorithm.name),
        answer_json(query.kind, &own.answer),
        own.trace.events.len(),
        shown.len()
    );
    let (trace, _) = tables(&shown, MAX_BYTES.saturating_sub(AROUND + head.len()));
    format!("{head},\"trace\":{trace}")
}

/// What the hash of a document of several scenes begins with, so that no scene is looked for that has its
/// name.
const OF_SEVERAL: &str = "several-";

/// What a document of several scenes carries, of their hashes and of how it has them.
///
/// ```
/// use tracefig::drift::text_chunk_of_several;
/// let text = text_chunk_of_several(&["00ff", "00fe"], "two a sheet");
/// assert_ne!(text, text_chunk_of_several(&["00ff", "00fe"], "one a sheet"));
/// assert!(text.starts_with("several-"));
/// ```
#[must_use]
pub fn text_chunk_of_several(hashes: &[&str], options: &str) -> String {
    text_chunk(&format!("{OF_SEVERAL}{}", fingerprint(&hashes.join(" "), options)))
}

/// What the hash of a line of a stream begins with: where its figure lies no scene of its name does.
const OF_A_LINE: &str = "line-";

/// The hash of a figure of a line of a stream, which has no file that could be looked for.
///
/// ```
/// use tracefig::drift::{hash_of_line, hash_of_part};
/// assert_eq!(hash_of_line("00ff"), "line-00ff");
/// assert!(hash_of_part("line-00ff", "step 1").starts_with("line-"));
/// ```
#[must_use]
pub fn hash_of_line(hash: &str) -> String {
    format!("{OF_A_LINE}{hash}")
}

/// The hash of a part of a figure, as one of its steps, which is of a line where the figure is.
///
/// ```
/// use tracefig::drift::hash_of_part;
/// assert_ne!(hash_of_part("00ff", "step 1"), hash_of_part("00ff", "step 2"));
/// ```
#[must_use]
pub fn hash_of_part(hash: &str, part: &str) -> String {
    let own = fingerprint(hash, part);
    if hash.starts_with(OF_A_LINE) { hash_of_line(&own) } else { own }
}

/// The metadata of one file: the [`fingerprint`] of its scene and options, and the [`facts`] of the scene.
///
/// ```
/// let text = tracefig::drift::metadata("00ff", "\"answer\":null");
/// assert!(text.starts_with(r#"{"tracefig_figure":2,"version":""#));
/// assert!(text.ends_with(r#"","hash":"00ff","answer":null}"#));
/// ```
#[must_use]
pub fn metadata(hash: &str, facts: &str) -> String {
    metadata_of((hash, VERSION), facts)
}

/// The metadata of a file that the tracefig of a version drew.
fn metadata_of((hash, version): (&str, &str), facts: &str) -> String {
    format!("{{\"tracefig_figure\":{STAMP_FORMAT},\"version\":\"{version}\",\"hash\":\"{hash}\",{facts}}}")
}

/// A drawing as if this tracefig and scene were those of another stamp. A file of it tells a figure that
/// shows something else from one whose stamp alone is another: its theme file has a new comment, or tracefig
/// a new version.
///
/// ```
/// use tracefig::{drift::{Stamp, facts, metadata, restamped}, figure::{draw, plan}, scene::open_text};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
/// let file = open_text("s.toml", text)?;
/// let plan = plan(&file.scene).unwrap();
/// let mut drawing = draw(&plan, plan.theme, "f").drawing;
/// drawing.metadata = metadata("00ff", &facts(&plan));
/// let other = Stamp { hash: "00fe".to_owned(), version: "0.0.9".to_owned(), facts: None };
/// let drawing = restamped(&drawing, &other);
/// assert_eq!(drawing.hash, "00fe 0.0.9");
/// assert!(drawing.metadata.starts_with(r#"{"tracefig_figure":2,"version":"0.0.9","hash":"00fe","alg"#));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn restamped(drawing: &Drawing, stamp: &Stamp) -> Drawing {
    let Stamp { hash, version, .. } = stamp;
    let after_hash = |text: &str| Some(text.split_once("\"hash\":\"")?.1.split_once("\",")?.1.to_owned());
    let mut drawing = drawing.clone();
    drawing.hash = format!("{hash} {version}");
    if let Some(facts) = after_hash(&drawing.metadata) {
        drawing.metadata = metadata_of((hash, version), facts.strip_suffix('}').unwrap_or(&facts));
    }
    drawing
}

impl Stamp {
    /// Whether this version of tracefig drew the file, of a scene and options with this hash.
    ///
    /// ```
    /// use tracefig::drift::Stamp;
    /// let stamp = Stamp { hash: "00ff".to_owned(), version: "0.0.0".to_owned(), facts: None };
    /// assert!(!stamp.is_of("00ff"), "an older version drew it");
    /// ```
    #[must_use]
    pub fn is_of(&self, hash: &str) -> bool {
        self.hash == hash && self.version == VERSION
    }

    /// Whether the file is the figure of a file's scene: not a document of several, as a handout, nor the
    /// figure of a line of a stream.
    ///
    /// ```
    /// use tracefig::drift::Stamp;
    /// let stamp = |hash: &str| Stamp { hash: hash.to_owned(), version: "0.0.0".to_owned(), facts: None };
    /// assert!(stamp("00ff").is_of_a_file());
    /// assert!(!stamp("several-00ff").is_of_a_file() && !stamp("line-00ff").is_of_a_file());
    /// ```
    #[must_use]
    pub fn is_of_a_file(&self) -> bool {
        !self.hash.starts_with(OF_SEVERAL) && !self.hash.starts_with(OF_A_LINE)
    }

    /// What a file of a format says of itself; `None` where it is none of ours, or the format has no place
    /// for it.
    ///
    /// ```
    /// use tracefig::{drift::{Stamp, metadata}, output::format};
    /// let svg = format!("<svg><metadata>{}</metadata></svg>", metadata("00ff", "\"answer\":null"));
    /// let stamp = Stamp::read(format("svg").unwrap(), svg.as_bytes()).unwrap();
    /// assert!(stamp.is_of("00ff") && !stamp.is_of("00fe"));
    /// assert_eq!(Stamp::read(format("png").unwrap(), svg.as_bytes()), None);
    /// ```
    #[must_use]
    pub fn read(format: &Format, bytes: &[u8]) -> Option<Self> {
        match (format.read?.stamp)(bytes)? {
            Stamped::Metadata(text) if text.len() > MOST_READ => None,
            Stamped::Metadata(text) => {
                let facts: Value = serde_json::from_str(&text).ok()?;
                facts.get("tracefig_figure")?;
                let text = |key: &str| Some(facts.get(key)?.as_str()?.to_owned());
                Some(Self { hash: text("hash")?, version: text("version")?, facts: Some(facts) })
            }
            Stamped::Hash(text) => {
                let (hash, version) = text.split_once(' ')?;
                Some(Self { hash: hash.to_owned(), version: version.to_owned(), facts: None })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{draw, plan};
    use crate::output::{FORMATS, format};
    use crate::scene::open_text;

    fn read(name: &str, bytes: &[u8]) -> Option<Stamp> {
        Stamp::read(format(name).unwrap(), bytes)
    }

    const SCENE: &str = r#"
        [shapes.A]
        kind = "circle"
        radius = 1
        [shapes.B]
        kind = "circle"
        radius = 1
        position = [3, 0]
        [query]
        kind = "separation"
        of = ["A", "B"]
        algorithm = "minkowski"
        [[panels]]
        space = "configuration"
        layers = ["difference"]
    "#;

    fn facts_of(scene: &str) -> String {
        let scene = open_text("s.toml", scene).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let _ = draw(&plan, plan.theme, "s");
        facts(&plan)
    }

    #[test]
    fn what_is_written_is_read_again() {
        let text = metadata("00ff", &facts_of(SCENE));
        let svg =
            format!("<svg><metadata>{}</metadata></svg>", text.replace('&', "&amp;").replace('<', "&lt;"));
        let stamp = read("svg", svg.as_bytes()).unwrap();
        assert!(stamp.is_of("00ff") && !stamp.is_of("00fe"));
        let facts = stamp.facts.unwrap();
        assert_eq!(facts["answer"]["separation"], 1.0);
        assert_eq!(facts["trace"][0][0], "started");
    }

    #[test]
    fn the_trace_holds_what_the_layers_drew_and_nothing_else() {
        let trace = |scene: &str| {
            let facts: Value = serde_json::from_str(&format!("{{{}}}", facts_of(scene))).unwrap();
            let tables = facts["trace"].as_array().unwrap().iter();
            (facts["shown"].clone(), tables.map(|t| t[0].as_str().unwrap().to_owned()).collect::<Vec<_>>())
        };
        assert_eq!(trace(SCENE), (json!(2), vec!["started".into(), "difference-rounded".into()]));
        let without = SCENE.replace("\"difference\"", "\"origin\"");
        assert_eq!(trace(&without), (json!(0), vec![]));
        let closest = SCENE.replace("\"difference\"", "\"closest\"");
        // The right angle at the closest point is of an edge of the difference.
        assert_eq!(trace(&closest).1, ["started", "difference-rounded", "candidate-improved"]);
    }

    #[test]
    fn other_files_have_no_stamp() {
        let others: [&[u8]; 5] =
            [b"<svg><metadata>{}</metadata></svg>", b"<svg/>", b"\x89PNG\r\n", b"\xff\xfe", b"<svg "];
        for format in FORMATS {
            for bytes in others {
                assert_eq!(Stamp::read(&format, bytes), None, "{}: {bytes:?}", format.name);
            }
        }
    }

    #[test]
    fn a_long_trace_is_cut_to_the_limit() {
        let corners: Vec<String> = (0..400)
            .map(|i| {
                let x = f64::from(i) - 200.0;
                format!("[{x}, {}]", 0.01 * x * x)
            })
            .collect();
        let polygon =
            format!("kind = \"polygon\"\nvertices = [{}]\nposition = [0, -300]", corners.join(", "));
        let text = metadata(
            "00ff",
            &facts_of(&SCENE.replacen("kind = \"circle\"\n        radius = 1", &polygon, 1)),
        );
        assert!(text.len() <= MAX_BYTES && text.len() > MAX_BYTES / 2, "{}", text.len());
        let facts: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(facts["shown"], 402, "the edges, the radius, and the start");
    }
}
