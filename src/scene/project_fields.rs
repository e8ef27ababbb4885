//! The table of fields of a project file, a row a key, as [`super::fields`] has those of scenes.

use super::fields::{TableRows, may, must};
use super::holds::Holds;
use super::limits::{MAX_A_SHEET, MAX_SCALE};

/// The words for what the steps of a figure become: one file with all of them, or a file each.
pub const STEP_FILES: [&str; 2] = ["one", "files"];

/// The top of a project file.
pub(super) static PROJECT: TableRows = TableRows {
    header: "tracefig.toml",
    place: "the project file",
    fields: &[
        may("render", Holds::Table, "which scenes are drawn, and how"),
        may(
            "handout",
            Holds::List("handouts"),
            "documents of several figures, which `render` writes and `check` compares as well",
        ),
        may("canvas", Holds::Table, "the page of scenes that do not say otherwise: keys as in a scene"),
    ],
};

/// Which scenes a project has, and how they are drawn; an option of the command line beats each.
pub(super) static RENDER: TableRows = TableRows {
    header: "[render]",
    place: "`[render]`",
    fields: &[
        may(
            "scenes",
            Holds::List("files and folders"),
            "folders are searched in depth; default [\"figures\"]",
        ),
        may("output", Holds::Text, "folder for the figures; default: beside each scene"),
        may("formats", Holds::List("formats"), "what each scene is written as"),
        may(
            "themes",
            Holds::List("themes"),
            "words for themes, theme files, or FILE.toml#dark, a dark side; default: each scene's own",
        ),
        may(
            "scale",
            Holds::Number { min: 0.0, max: MAX_SCALE },
            "dots of an image for each page pixel; default 2",
        ),
        may(
            "steps",
            Holds::Word { what: "kind of files", known: || STEP_FILES.map(str::to_owned).to_vec() },
            "the steps of a figure, in one file or in files; default: the finished figure",
        ),
    ],
};

/// A document of several figures that a project keeps.
pub(super) static HANDOUT: TableRows = TableRows {
    header: "[[handout]]",
    place: "a handout",
    fields: &[
        must("file", Holds::Text, "the document: a PDF of sheets, or a presentation"),
        may("scenes", Holds::List("files and folders"), "what is on it, in this order; default: all scenes"),
        may(
            "theme",
            Holds::Text,
            "a word or a theme file; default: the first of `[render]`, else each scene's own",
        ),
        may("variants", Holds::Texts("variants"), "question, key or both, of exercises; default: figures"),
        may("seeds", Holds::Texts("numbers"), "variants of exercises by number, as \"1..8\""),
        may("per_page", Holds::Count { min: 1, max: MAX_A_SHEET }, "figures on a sheet; default 2"),
        may("paper", Holds::Text, "paper of the sheets; default \"a4\""),
        may("numbers", Holds::Switch, "whether a line \"Figure N\" stands below each; default true"),
        may("heading", Holds::Text, "words above the figures of the first sheet"),
        may("name_line", Holds::Switch, "whether a line for a name stands there; default false"),
    ],
};

/// The tables of a project file but its `[canvas]`, which is a scene's.
pub static PROJECT_TABLES: [&TableRows; 3] = [&PROJECT, &RENDER, &HANDOUT];
