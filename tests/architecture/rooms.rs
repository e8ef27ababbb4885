//! The rooms of the house and the arrows between them.

/// A room, as its path below `src/`, and the rooms that it may use with all that is within them.
pub(crate) type Row = (&'static str, &'static [&'static str]);

/// The rooms of the house. These are all the arrows there are.
pub(crate) const ROOMS: &[Row] = &[
    ("geometry", &[]),
    ("trace", &["geometry"]),
    ("collision", &["geometry", "trace"]),
    // The ground floor: what is asked, what is answered, and the parts of B ⊖ A.
    ("collision/query", &["geometry"]),
    ("collision/answer", &["geometry"]),
    ("collision/feature", &["geometry"]),
    ("collision/size", &["geometry"]),
    ("collision/expected", &["geometry", "trace", "collision/answer", "collision/query", "collision/size"]),
    // The upper storey: what the article does. It enters the lower one by the items that the three rooms
    // there re-export; the modules behind them are private.
    (
        "collision/algorithm",
        &[
            "geometry",
            "trace",
            "collision/query",
            "collision/answer",
            "collision/feature",
            "collision/size",
            "collision/certified",
        ],
    ),
    // What looks right and is wrong, beside both storeys: nothing but a layer of figures enters it.
    ("collision/naive", &["geometry", "collision/query", "collision/certified/distance"]),
    // The lower storey: what proves the numbers. No query, no event, no tracer. distance ← sweep/{ray, balls,
    // exact} ← impact ← sweep, no way back.
    ("collision/certified", &[]),
    ("collision/certified/rounding", &["geometry"]),
    (
        "collision/certified/distance",
        &["geometry", "collision/answer", "collision/feature", "collision/certified/rounding"],
    ),
    (
        "collision/certified/sweep/ray",
        &["geometry", "collision/answer", "collision/feature", "collision/certified/distance"],
    ),
    (
        "collision/certified/sweep/balls",
        &["geometry", "collision/feature", "collision/certified/distance", "collision/certified/sweep/ray"],
    ),
    ("collision/certified/sweep/exact", &["geometry", "collision/answer", "collision/certified/distance"]),
    (
        "collision/certified/impact",
        &[
            "geometry",
            "collision/answer",
            "collision/feature",
            "collision/size",
            "collision/certified/rounding",
            "collision/certified/distance",
            "collision/certified/sweep/ray",
            "collision/certified/sweep/balls",
            "collision/certified/sweep/exact",
        ],
    ),
    (
        "collision/certified/sweep",
        &[
            "geometry",
            "collision/answer",
            "collision/feature",
            "collision/certified/distance",
            "collision/certified/impact",
        ],
    ),
    (
        "collision/certified/approach",
        &[
            "geometry",
            "collision/answer",
            "collision/feature",
            "collision/certified/distance",
            "collision/certified/impact",
        ],
    ),
    (
        "collision/certified/clip",
        &["geometry", "collision/answer", "collision/feature", "collision/certified/distance"],
    ),
    // The filters: each may use the base of its room and what lies below the room, none the room's searches.
    (
        "collision/certified/distance/filter",
        &[
            "geometry",
            "collision/feature",
            "collision/certified/rounding",
            "collision/certified/distance/pair",
            "collision/certified/distance/conditions",
            "collision/certified/distance/gaps",
            "collision/certified/distance/refine",
            "collision/certified/distance/witnesses",
        ],
    ),
    (
        "collision/certified/sweep/filter",
        &[
            "geometry",
            "collision/feature",
            "collision/certified/rounding",
            "collision/certified/distance",
            "collision/certified/sweep/ray",
            "collision/certified/sweep/heading",
        ],
    ),
    (
        "collision/certified/impact/filter",
        &[
            "geometry",
            "collision/answer",
            "collision/feature",
            "collision/certified/rounding",
            "collision/certified/distance",
            "collision/certified/impact/moving_pair",
            "collision/certified/impact/axis",
            "collision/certified/impact/closest",
            "collision/certified/impact/limits",
        ],
    ),
    ("scene", &["geometry", "collision"]),
    ("typeset", &[]),
    ("drawing", &["typeset"]),
    ("figure", &["geometry", "trace", "collision", "scene", "typeset", "drawing"]),
    // From the ground floor up: what others stand on comes first.
    ("figure/limits", &["scene"]),
    ("figure/question", &["collision"]),
    ("figure/name", &["geometry", "typeset"]),
    ("figure/called", &["geometry", "scene", "typeset", "figure/name"]),
    ("figure/language", &["trace", "scene"]),
    ("figure/standing", &["collision"]),
    ("figure/frame", &["geometry", "drawing"]),
    ("figure/playhead", &["geometry", "scene", "figure/question"]),
    (
        "figure/handle",
        &["geometry", "scene", "drawing", "figure/frame", "figure/language", "figure/playhead"],
    ),
    ("figure/theme", &["drawing"]),
    ("figure/page", &["scene", "drawing", "figure/theme"]),
    ("figure/lettering", &["typeset", "drawing", "figure/theme"]),
    ("figure/cue", &[]),
    (
        "figure/sketch",
        &[
            "geometry",
            "typeset",
            "drawing",
            "figure/cue",
            "figure/frame",
            "figure/handle",
            "figure/limits",
            "figure/theme",
        ],
    ),
    (
        "figure/inset",
        &[
            "geometry",
            "scene",
            "drawing",
            "figure/frame",
            "figure/placement",
            "figure/sketch",
            "figure/theme",
        ],
    ),
    ("figure/difference", &["geometry", "trace", "figure/sketch"]),
    (
        "figure/runs",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "figure/called",
            "figure/cue",
            "figure/limits",
            "figure/question",
        ],
    ),
    ("figure/moving_frame", &["geometry", "collision"]),
    ("figure/touching", &["geometry", "collision"]),
    (
        "figure/context",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "figure/cue",
            "figure/moving_frame",
            "figure/name",
            "figure/question",
            "figure/runs",
            "figure/sketch",
        ],
    ),
    ("figure/placement", &["geometry", "scene", "typeset", "drawing", "figure/frame", "figure/sketch"]),
    ("figure/fault", &["scene", "figure/placement"]),
    ("figure/budget", &["scene", "typeset", "figure/limits", "figure/sketch"]),
    (
        "figure/text",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "typeset",
            "figure/budget",
            "figure/context",
            "figure/fault",
            "figure/language",
            "figure/lettering",
            "figure/name",
            "figure/page",
            "figure/placement",
            "figure/question",
            "figure/sketch",
            "figure/standing",
        ],
    ),
    (
        "figure/layer",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "drawing",
            "figure/context",
            "figure/cue",
            "figure/difference",
            "figure/handle",
            "figure/runs",
            "figure/sketch",
            "figure/text",
            "figure/touching",
        ],
    ),
    ("figure/tongue", &["geometry", "trace", "collision", "scene", "figure/language", "figure/text"]),
    (
        "figure/describe",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "figure/called",
            "figure/difference",
            "figure/question",
            "figure/runs",
            "figure/text",
            "figure/tongue",
            "figure/touching",
        ],
    ),
    (
        "figure/default_picture",
        &["trace", "collision", "scene", "figure/fault", "figure/language", "figure/runs"],
    ),
    (
        "figure/exercise",
        &[
            "geometry",
            "trace",
            "collision",
            "scene",
            "typeset",
            "figure/called",
            "figure/context",
            "figure/describe",
            "figure/fault",
            "figure/language",
            "figure/layer",
            "figure/page",
            "figure/plan",
            "figure/question",
            "figure/runs",
            "figure/standing",
            "figure/text",
            "figure/tongue",
        ],
    ),
    (
        "figure/panel",
        &[
            "scene",
            "drawing",
            "figure/context",
            "figure/cue",
            "figure/frame",
            "figure/inset",
            "figure/layer",
            "figure/lettering",
            "figure/limits",
            "figure/page",
            "figure/runs",
            "figure/sketch",
            "figure/theme",
        ],
    ),
    (
        "figure/narrow",
        &[
            "drawing",
            "scene",
            "typeset",
            "figure/layer",
            "figure/page",
            "figure/panel",
            "figure/placement",
            "figure/runs",
            "figure/sketch",
            "figure/text",
        ],
    ),
    (
        "figure/view",
        &[
            "geometry",
            "scene",
            "drawing",
            "figure/frame",
            "figure/inset",
            "figure/limits",
            "figure/page",
            "figure/panel",
            "figure/runs",
            "figure/sketch",
            "figure/theme",
        ],
    ),
    ("output", &["drawing", "typeset"]),
    ("drift", &["scene", "trace", "figure", "drawing", "output"]),
    ("live", &["geometry", "trace", "scene", "typeset", "drawing", "figure", "drift", "output"]),
    ("report", &["geometry", "trace", "collision", "scene", "typeset", "drawing", "figure", "output"]),
    // Speaks to the library from outside, as `tracefig::…`, so it sees the public API and no more.
    ("cli", &[]),
];

/// Whether a module or an item, given as the segments of its path, is a room or lies within it.
pub(crate) fn is_within(path: &[String], room: &str) -> bool {
    let mut at = path.iter();
    room.split('/').all(|segment| at.next().is_some_and(|own| own == segment))
}

/// The row that a module obeys.
pub(crate) fn row_of(module: &[String]) -> Option<&'static Row> {
    let is_test = module.iter().any(|segment| segment == "tests");
    let rows = ROOMS.iter().filter(|(room, _)| is_within(module, room) && !(is_test && room.contains('/')));
    rows.max_by_key(|(room, _)| room.len())
}
