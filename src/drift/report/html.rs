//! The findings as one page that needs nothing else: pictures are inside it, and there is no script.

use std::fmt::Write;

use super::{Finding, advice, escape, tally};
use crate::drift::TRIPTYCH_FORMAT;
use crate::output::base64;
use crate::scene::visible;

/// How the page looks; it follows the reader's light or dark system.
const STYLE: &str = "body{font:16px/1.5 sans-serif;max-width:120rem;margin:2rem auto;padding:0 1rem;\
color:#1b1f24;background:#fff}p,ul,dl{max-width:75rem}code{font-size:.95em}\
dl{display:grid;grid-template-columns:auto 1fr;gap:0 1rem}dt{font-weight:600}dd{margin:0}\
figure{margin:1rem 0}img{display:block;width:100%}\
figcaption{display:grid;grid-template-columns:repeat(3,1fr);text-align:center}\
@media(prefers-color-scheme:dark){body{color:#e8eaed;background:#12161c}}";

/// The beginning of the page, by which it is known again.
const HEAD: &str =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>tracefig check</title>";

/// A page of all findings: counts, then a section with its picture for each file that is not identical.
///
/// ```
/// use tracefig::drift::report::{Finding, html};
/// let bad = Finding::new("a.svg", "missing");
/// assert!(html(&[bad]).contains("<code>a.svg</code>: missing"));
/// ```
#[must_use]
pub fn html(findings: &[Finding]) -> String {
    let counts: Vec<_> = tally(findings).into_iter().filter(|&(_, n)| n > 0).collect();
    let mut out = format!(
        "{HEAD}<style>{STYLE}</style></head>\n\
         <body><h1>Are the figures what their scenes give today?</h1>\n<dl>\n"
    );
    for (state, count) in counts {
        let _ = writeln!(out, "<dt>{count} {state}</dt><dd>{}</dd>", meaning(state));
    }
    out.push_str("</dl>\n");
    if let Some(advice) = advice(findings) {
        // What stands in backticks is code.
        let parts = escape(&advice);
        let parts = parts.split('`').enumerate();
        let marked =
            parts.map(|(i, part)| if i % 2 == 1 { format!("<code>{part}</code>") } else { part.into() });
        let _ = writeln!(out, "<p>{}</p>", marked.collect::<String>());
    }
    for finding in findings.iter().filter(|f| f.is_bad()) {
        let name = escape(&visible(&finding.file));
        let _ = writeln!(out, "<section><h2><code>{name}</code>: {}</h2>\n<ul>", finding.state);
        for line in &finding.details {
            let _ = writeln!(out, "<li>{}</li>", escape(&visible(line)));
        }
        out.push_str("</ul>\n");
        if let Some((_, image)) = &finding.picture {
            let (kind, data) = (TRIPTYCH_FORMAT.name, base64(image));
            let _ = writeln!(
                out,
                "<figure><img src=\"data:image/{kind};base64,{data}\" \
                 alt=\"{name}: on disk, the difference, and drawn now\">\
                 <figcaption><span>on disk</span><span>difference: what changed is pink</span>\
                 <span>now, as its scene gives it</span></figcaption></figure>"
            );
        }
        out.push_str("</section>\n");
    }
    out.push_str("</body></html>\n");
    out
}

/// Whether a file, given from its beginning, is such a page.
///
/// ```
/// use tracefig::drift::report::{html, is_page};
/// assert!(is_page(html(&[]).as_bytes()) && !is_page(b"<!doctype html>\n<title>mine</title>"));
/// ```
#[must_use]
pub fn is_page(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD.as_bytes())
}

/// What a state means, for a reader who meets it first here.
fn meaning(state: &str) -> &'static str {
    match state {
        "identical" => "the file is, byte for byte, what its scene gives",
        "changed" => "the scene is the one that the file was drawn from, but gives another file now",
        "stale" => "the scene or the options have changed since the file was drawn",
        "missing" => "there is a scene, but no file yet",
        "orphan" => {
            "there is a file of ours, but no scene that gives it, or tracefig.toml asks for it no more"
        }
        _ => "the scene can't be drawn, or a file can't be read or written",
    }
}
