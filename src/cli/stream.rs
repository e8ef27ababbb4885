//! A stream of scenes, a line each, as jobs of `render`: batches of lines, each with the name of its files.
//!
//! A batch is what has arrived, up to a few lines for each thread, so that whoever writes a line and waits
//! sees its figure, and a stream of any length takes the memory of a batch and some bytes for each name.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::io::{self, Read};
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;

use tracefig::drift::fingerprint;
use tracefig::scene::limits::MAX_FILE_BYTES;
use tracefig::scene::{Ink, jsonl_name, open_jsonl_line, refused_bytes, refused_length, visible};

use super::inputs::{Input, Located};
use super::jobs::{Job, job};
use super::lines::{Line, Lines};
use super::settings::Settings;

/// Lines of a batch for each thread: enough that none waits long for the slowest of them.
const LINES_A_THREAD: usize = 8;

/// Longest stem of a file's name, in bytes: file systems take 255, with the theme and what a half-written
/// file is called.
const LONGEST: usize = 150;

/// Digits of an id's fingerprint that keep its name apart from another's.
const APART: usize = 8;

/// Names that Windows keeps for devices, whatever follows the first dot.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// A line of the stream.
pub(crate) enum Drawable {
    /// A text that may be a scene, and its files.
    Job(Job),
    /// A line that is none, or whose id is another line's: the message.
    Refused(String),
}

impl Drawable {
    /// How messages call it.
    pub(crate) fn shown(&self) -> String {
        match self {
            Self::Job(job) => job.input.shown(),
            Self::Refused(_) => "a line".to_owned(),
        }
    }
}

/// Whose a name is.
struct Named {
    /// The number of the line.
    line: usize,
    /// The fingerprint of its id.
    id: String,
}

/// Reads a stream of scenes batch by batch.
pub(crate) struct LinesToDraw<R> {
    /// The lines that were not read yet.
    lines: Lines<R>,
    /// How messages are written.
    ink: Ink,
    /// The names so far, as fingerprints, with those who have them.
    names: BTreeMap<String, Named>,
}

impl<R: Read> LinesToDraw<R> {
    /// A stream of which nothing was read yet.
    pub(crate) fn new(input: R, ink: Ink) -> Self {
        Self { lines: Lines::new(input), ink, names: BTreeMap::new() }
    }

    /// The next lines; none at the end of the stream.
    ///
    /// # Errors
    /// Where the stream can't be read.
    pub(crate) fn next_batch(
        &mut self,
        settings: &Arc<Settings>,
        threads: NonZeroUsize,
    ) -> io::Result<Vec<Drawable>> {
        let (mut batch, mut bytes) = (Vec::new(), 0);
        let most = threads.get().saturating_mul(LINES_A_THREAD);
        while batch.len() < most && bytes < MAX_FILE_BYTES && (batch.is_empty() || self.lines.has_next()) {
            let ink = self.ink;
            let (number, text) = match self.lines.next()? {
                None => break,
                Some((number, Line::Text(text))) => (number, text.to_owned()),
                Some((number, Line::NotUtf8)) => {
                    batch.push(Drawable::Refused(refused_bytes(number).render(ink)));
                    continue;
                }
                Some((number, Line::TooLong(length))) => {
                    batch.push(Drawable::Refused(refused_length(number, length).render(ink)));
                    continue;
                }
            };
            bytes += text.len();
            batch.push(self.line(number, text, settings));
        }
        Ok(batch)
    }

    /// A line with the name of its files, unless an earlier one has its id.
    fn line(&mut self, number: usize, text: String, settings: &Arc<Settings>) -> Drawable {
        let id = jsonl_name(&text).unwrap_or_default();
        let plain = Some(safe(&id)).filter(|stem| !stem.is_empty());
        let plain = plain.unwrap_or_else(|| format!("line-{number}"));
        let mut first = number;
        let apart = kept_apart(&plain, &id);
        for stem in [plain, apart] {
            let own = Named { line: number, id: fingerprint(&id, "id") };
            // Some file systems take capitals for small letters.
            match self.names.entry(fingerprint(&stem.to_lowercase(), "name")) {
                Entry::Vacant(place) => {
                    place.insert(own);
                    let input = Input::Line { number, text, stem };
                    return Drawable::Job(job(Located { input, below: PathBuf::new() }, settings));
                }
                Entry::Occupied(other) => {
                    first = other.get().line;
                    if other.get().id == own.id {
                        break;
                    }
                }
            }
        }
        // What else is wrong would come to light only once its id is its own.
        let own = open_jsonl_line(&text, number).err();
        let own = own.map_or_else(String::new, |refused| format!("\n{}", refused.render(self.ink)));
        let id = visible(&id);
        Drawable::Refused(format!(
            "error: <stdin>:{number} has the id of <stdin>:{first}, {id}: it is not drawn\n{own}"
        ))
    }
}

/// An id as the stem of a file's name: what is special to a shell, a path or a file system becomes `-`; one
/// that is too long is cut, and its fingerprint tells it from others that begin so.
fn safe(id: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || "._-+=@,".contains(c);
    let whole: String = id.trim().chars().map(|c| if kept(c) { c } else { '-' }).collect();
    let stem = if whole.len() > LONGEST { kept_apart(&whole, id) } else { whole };
    // A dot in front hides a file, one at the end is lost on Windows; a dash in front is an option.
    let stem = stem.trim_start_matches(['.', '-']).trim_end_matches('.');
    let device = stem.split('.').next().unwrap_or_default().to_lowercase();
    let port = |name: &str| {
        device.strip_prefix(name).is_some_and(|n| n.len() == 1 && n.chars().all(|c| c.is_ascii_digit()))
    };
    if DEVICES.contains(&device.as_str()) || port("com") || port("lpt") {
        return format!("{stem}-");
    }
    stem.to_owned()
}

/// The stem of an id that another one's name would be: the same for each run, whatever came first.
fn kept_apart(stem: &str, id: &str) -> String {
    let mark = fingerprint(id, "id");
    let end = stem.floor_char_boundary(LONGEST - APART - 1);
    format!("{}-{}", &stem[..end], &mark[mark.len() - APART..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_becomes_a_name_that_leads_nowhere_else() {
        for (id, stem) in [
            ("pair 7", "pair-7"),
            ("-12.5", "12.5"),
            ("../../etc/passwd", "etc-passwd"),
            ("a/b\\c:d", "a-b-c-d"),
            ("Körper_1", "Körper_1"),
            ("..", ""),
            ("", ""),
            ("nul", "nul-"),
            ("COM1.x", "COM1.x-"),
            ("computer", "computer"),
            ("a\u{0}\n\u{202e}b", "a---b"),
        ] {
            assert_eq!(safe(id), stem, "{id:?}");
        }
        let long = "é".repeat(200);
        assert_eq!(safe(&long).len(), LONGEST - 1, "cut between two letters");
        assert_ne!(safe(&long), safe(&format!("{long}!")), "two that begin alike");
    }
}
