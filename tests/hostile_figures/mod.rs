//! Figures on disk that somebody made to cost `check` seconds, gigabytes or its life.
//!
//! Each lies in the place of a figure of ours, and is a finding of that figure; the check goes on.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A scene and what lies in the place of its figure.
pub(crate) struct Hostile {
    /// What it is.
    pub(crate) name: &'static str,
    /// The format of the figure.
    pub(crate) format: &'static str,
    /// What lies in its place, made of the figure that should.
    pub(crate) made: fn(&[u8]) -> Vec<u8>,
    /// What is told of it, and where: in the findings or among the errors.
    pub(crate) told: &'static str,
}

/// The scene of each.
pub(crate) const SCENE: &str = "[shapes.A]\nkind = 'box'\nhalf_extents = [1, 0.6]\n[shapes.B]\nkind = 'circle'\n\
    radius = 1\nposition = [3, 1]\n[query]\nkind = 'separation'\nof = ['A', 'B']\n[[panels]]\n\
    space = 'configuration'\nlayers = ['difference', 'closest']\n";

/// The figure with more at its end; `PREFIX` is what ids begin with.
fn with(svg: &[u8], more: &str) -> Vec<u8> {
    let text = std::str::from_utf8(svg).unwrap();
    let prefix = text.split("aria-labelledby=\"").nth(1).unwrap().split('-').next().unwrap();
    let end = text.rfind("</svg>").unwrap();
    format!("{}{}</svg>\n", &text[..end], more.replace("PREFIX", prefix)).into_bytes()
}

fn repeat(count: usize, piece: impl Fn(usize) -> String) -> String {
    (0..count).map(piece).collect()
}

/// A place on the page, another one for each number.
fn place(i: usize) -> String {
    format!("{} {}", i * 7919 % 960, i * 6101 % 540)
}

fn line(data: &str, more: &str) -> String {
    format!("<path fill=\"none\" stroke=\"#000000\" stroke-width=\"2\" {more}d=\"{data}\"/>")
}

/// The figure with another trace in its metadata.
fn traced(svg: &[u8], rows: usize) -> Vec<u8> {
    let text = std::str::from_utf8(svg).unwrap();
    let (before, rest) = text.split_once("\"trace\":").unwrap();
    let after = &rest[rest.find("}</metadata>").unwrap()..];
    let trace = format!("[[\"e\",[\"x\"]{}]]", ",[1]".repeat(rows));
    format!("{before}\"trace\":{trace}{after}").into_bytes()
}

/// A PNG's head, and pixels of no more than it takes to begin.
fn head(width: u32, height: u32) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut chunk = |name: &[u8; 4], data: &[u8]| {
        file.extend(u32::try_from(data.len()).unwrap().to_be_bytes());
        let checked = [&name[..], data].concat();
        file.extend(&checked);
        file.extend(checksum(&checked).to_be_bytes());
    };
    let size = [width.to_be_bytes(), height.to_be_bytes()].concat();
    chunk(b"IHDR", &[&size[..], &[1, 0, 0, 0, 0]].concat());
    // A stream without an end.
    chunk(b"IDAT", &[0x78, 0x01, 0x03, 0x00]);
    chunk(b"IEND", b"");
    file
}

/// The checksum of a chunk (*Portable Network Graphics, Third Edition*, annex D).
fn checksum(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

const NOT_OURS: &str = "not what tracefig writes: more than ";

/// All of them.
pub(crate) static HOSTILE: &[Hostile] = &[
    Hostile {
        name: "groups that use each other",
        format: "svg",
        made: |svg| {
            let use_of = |id| format!("<use xlink:href=\"#PREFIX-{id}\"/>");
            with(
                svg,
                &format!("<g id=\"PREFIX-x\">{}</g><g id=\"PREFIX-y\">{}</g>", use_of("y"), use_of("x")),
            )
        },
        told: "more than 24 elements in one another",
    },
    Hostile {
        name: "groups in groups",
        format: "svg",
        made: |svg| with(svg, &format!("{}{}", "<g>".repeat(10_000), "</g>".repeat(10_000))),
        told: "more than 24 elements in one another",
    },
    Hostile {
        name: "a chain of references",
        format: "svg",
        made: |svg| {
            let link = |i| format!("<g id=\"PREFIX-{i}\"><use xlink:href=\"#PREFIX-{}\"/></g>", i + 1);
            with(svg, &repeat(10_000, link).replace("#PREFIX-10000\"", "#PREFIX-0\""))
        },
        told: "more than 24 elements in one another",
    },
    Hostile {
        name: "a fan of references",
        format: "svg",
        made: |svg| {
            let fan = line(&format!("M0 0{}", repeat(1000, |i| format!("L{}", place(i)))), "");
            with(
                svg,
                &format!("<g id=\"PREFIX-x\">{fan}</g>{}", "<use xlink:href=\"#PREFIX-x\"/>".repeat(90_000)),
            )
        },
        told: NOT_OURS,
    },
    Hostile {
        name: "references that double",
        format: "svg",
        made: |svg| {
            let two = |i| {
                format!(
                    "<g id=\"PREFIX-{i}\">{}</g>",
                    format!("<use xlink:href=\"#PREFIX-{}\"/>", i + 1).repeat(4)
                )
            };
            with(svg, &(repeat(20, two) + "<g id=\"PREFIX-20\"><circle cx=\"9\" cy=\"9\" r=\"9\"/></g>"))
        },
        told: NOT_OURS,
    },
    Hostile {
        name: "attributes of an element",
        format: "svg",
        made: |svg| with(svg, &format!("<g {}/>", repeat(100_000, |i| format!("a{i}=\"\" ")))),
        told: "more than 32 attributes of an element",
    },
    Hostile {
        name: "elements",
        format: "svg",
        made: |svg| with(svg, &"<g/>".repeat(160_000)),
        told: "more than 150000 elements",
    },
    Hostile {
        name: "entities",
        format: "svg",
        made: |svg| {
            let entity = |i: usize| format!("<!ENTITY e{} \"{}\">", i + 1, format!("&e{i};").repeat(9));
            [format!("<!DOCTYPE svg [<!ENTITY e0 \"x\">{}]>", repeat(9, entity)).as_bytes(), svg].concat()
        },
        told: "line 1, column 2",
    },
    Hostile {
        name: "arcs",
        format: "svg",
        made: |svg| with(svg, &line(&curves(40_000, "A50 50 0 0 1 ", 1), "")),
        told: NOT_OURS,
    },
    Hostile {
        name: "cubics",
        format: "svg",
        made: |svg| with(svg, &line(&curves(50_000, "C", 3), "")),
        told: NOT_OURS,
    },
    Hostile {
        name: "lines",
        format: "svg",
        made: |svg| with(svg, &line(&curves(500_000, "L", 1), "")),
        told: NOT_OURS,
    },
    Hostile {
        name: "dashes",
        format: "svg",
        made: |svg| with(svg, &line("M0 0L960 540", "stroke-dasharray=\".001\" ").repeat(500)),
        told: NOT_OURS,
    },
    Hostile {
        name: "see-through groups",
        format: "svg",
        made: |svg| {
            let page = "<rect x=\"0\" y=\"0\" width=\"960\" height=\"540\" fill=\"#123456\"/>";
            with(svg, &repeat(20_000, |i| format!("<g id=\"PREFIX-g{i}\" opacity=\".5\">{page}</g>")))
        },
        told: NOT_OURS,
    },
    Hostile {
        name: "lines across the page",
        format: "svg",
        made: |svg| with(svg, &line("M0 0L960 540", "").repeat(100_000)),
        told: NOT_OURS,
    },
    Hostile {
        name: "events",
        format: "svg",
        made: |svg| traced(svg, 3_000),
        told: "the same picture in other bytes",
    },
    Hostile {
        name: "many events",
        format: "svg",
        made: |svg| traced(svg, 200_000),
        told: "the same picture in other bytes",
    },
    Hostile {
        name: "a head of 60,000 × 60,000",
        format: "png",
        made: |_| head(60_000, 60_000),
        told: "more than 32768 pixels a side",
    },
    Hostile {
        name: "a head of 1 × 20,000,000",
        format: "png",
        made: |_| head(1, 20_000_000),
        told: "more than 32768 pixels a side",
    },
    Hostile {
        name: "a head of 30,000 × 30,000",
        format: "apng",
        made: |_| head(30_000, 30_000),
        told: "more than 67108864 pixels",
    },
    Hostile {
        name: "a head of 8192 × 8192",
        format: "png",
        made: |_| head(8_192, 8_192),
        told: "it differs from byte ",
    },
    Hostile {
        name: "a long file",
        format: "pdf",
        made: |_| vec![b' '; (64 << 20) + 1],
        told: "more than 67108864 bytes",
    },
    Hostile {
        name: "a long page",
        format: "html",
        made: |_| vec![b'<'; 20 << 20],
        told: "cut short after 20,971,520",
    },
    Hostile {
        name: "a long line",
        format: "svg",
        made: |svg| [svg, &vec![b' '; 17 << 20]].concat(),
        told: "more than 16777216 bytes",
    },
];

/// Path data of so many curves, each of so many points.
fn curves(count: usize, letter: &str, points: usize) -> String {
    let mut data = String::from("M0 0");
    for i in 0..count {
        data.push_str(letter);
        for k in 0..points {
            let _ = write!(data, "{} ", place(points * i + k));
        }
    }
    data
}

impl Hostile {
    /// Puts the scene and what lies in its figure's place into a folder, with a second scene that is well.
    pub(crate) fn put(&self, folder: &Path) {
        for name in ["s.toml", "t.toml"] {
            fs::write(folder.join(name), SCENE).unwrap();
        }
        let render = ["render", ".", "--format", self.format, "--scale", "1"];
        let mut command = Command::new(env!("CARGO_BIN_EXE_tracefig"));
        assert!(command.args(render).current_dir(folder).output().unwrap().status.success());
        let place = folder.join(format!("s.{}", self.format));
        let made = (self.made)(&fs::read(&place).unwrap());
        fs::write(place, made).unwrap();
    }

    /// The arguments of the check.
    pub(crate) fn arguments(&self) -> [&'static str; 6] {
        ["check", ".", "--format", self.format, "--scale", "1"]
    }
}
