//! The table of the parts of answers: their keys in what `solve` writes, what they hold, and which have them.

/// A part of an answer, as `solve` writes it.
#[derive(Clone, Copy, Debug)]
pub struct AnswerField {
    /// Its key.
    pub name: &'static str,
    /// What it holds, and in which unit.
    pub about: &'static str,
    /// Which answers have it, as "a hit"; empty where all do.
    pub when: &'static str,
    /// The keys of what it holds, where that is an object or a list of objects.
    pub inner: &'static [Self],
}

impl AnswerField {
    /// A key of every answer of its kind.
    pub(crate) const fn always(name: &'static str, about: &'static str) -> Self {
        Self::of("", name, about)
    }

    /// A key of some answers.
    pub(crate) const fn of(when: &'static str, name: &'static str, about: &'static str) -> Self {
        Self { name, about, when, inner: &[] }
    }

    /// A key of every answer here, and of some there.
    const fn only(self, when: &'static str) -> Self {
        Self { when, ..self }
    }
}

const KIND: AnswerField = AnswerField::always("kind", "the kind of the query");
const DISTANCE: AnswerField =
    AnswerField::always("separation", "signed distance, negative inside; world units");
const ENCLOSED: AnswerField = AnswerField::always(
    "separation_bounds",
    "[lo, hi], which enclose the exact one; hi is null after a separating axis",
);
const NORMAL: AnswerField =
    AnswerField::always("normal", "[x, y], unit vector from A to B, along which B moves apart");
const TIES: AnswerField =
    AnswerField::always("ties", "directions with the same depth or distance; 0 where all tie");
const POINTS: AnswerField = AnswerField::always(
    "points",
    "{\"A\": [x, y], \"B\": [x, y]}, the points of A and B closest to each other, in the world",
);
const FEATURES: AnswerField = AnswerField::always(
    "features",
    "{\"A\": f, \"B\": f}, what carries these points: {\"vertex\": i} or {\"edge\": i}, from 0",
);
const VERDICT: AnswerField =
    AnswerField::always("overlap", "true or false, touching is true; null where rounding forbids a verdict");

/// How near a miss came.
const CLOSEST: AnswerField = AnswerField {
    inner: &[
        AnswerField::always(
            "time",
            "when the bodies are closest, in [0, 1]; where one turns, as far as is found: at no other time \
             are they nearer by more than `separation_bounds` are wide",
        ),
        AnswerField::always("separation", "how far apart they are then, world units"),
        AnswerField::always("separation_bounds", "[lo, hi], which enclose the least separation over [0, 1]"),
    ],
    ..AnswerField::of("a miss", "closest", "how near the bodies came")
};

/// How far off someone else's answer is.
const OFF: AnswerField = AnswerField {
    inner: &[
        AnswerField::always(
            "size",
            "S of the pair, world units: the largest of extents, turns, half the distance and the motion",
        ),
        AnswerField::of(
            "an `expected` that has an `outcome`",
            "same_outcome",
            "true or false, whether ours came out so; null where that is open",
        ),
        AnswerField::of(
            "an `expected` that has it",
            "separation",
            "how far it is outside the bounds, world units, negative below them; null where ours has none. \
             The bounds of a verdict suffice for it alone, and a separating axis has no upper one: there \
             those of `closest-features`",
        ),
        AnswerField::of("an `expected` that has it", "separation_in_eps", "that in units of S ε"),
        AnswerField::of(
            "an `expected` that has it",
            "time",
            "how far it is outside the bounds, negative before them, of bodies that overlap at the start \
             from 0; null where ours has none, or one is of a hit and the other of a miss",
        ),
        AnswerField::of(
            "an `expected` that has it",
            "normal_deg",
            "angle between the normals, in degrees, where several tie to the nearest; null where ours has \
             none",
        ),
        AnswerField::of(
            "an `expected` that has it",
            "points",
            "{\"A\": x, \"B\": x}, how far from where such may be, across from each other; null also where \
             directions tie",
        ),
        AnswerField::of("an `expected` that has it", "points_in_eps", "that in units of S ε"),
    ],
    ..AnswerField::of("a query with `expected`", "off", "how far off what the scene expects is")
};

/// Parts of an answer to a question for the bounding box.
pub(crate) const OF_BOUNDS: &[AnswerField] = &[
    KIND,
    AnswerField::always("min", "[x, y], smallest coordinates, rounded down"),
    AnswerField::always("max", "[x, y], largest coordinates, rounded up"),
    AnswerField::always("center", "[x, y], (min + max) / 2"),
    AnswerField::always("half_extents", "[x, y], half of width and height, rounded up"),
];

/// Parts of an answer to a question for overlap.
pub(crate) const OF_OVERLAP: &[AnswerField] = &[KIND, VERDICT, ENCLOSED, OFF];

/// Parts of an answer to a question for the separation.
pub(crate) const OF_SEPARATION: &[AnswerField] =
    &[KIND, DISTANCE, ENCLOSED, NORMAL, TIES, POINTS, FEATURES, OFF];

/// Parts of an answer to a question for the first contact.
pub(crate) const OF_IMPACT: &[AnswerField] = &[
    KIND,
    AnswerField::always("outcome", "\"hit\", \"miss\", \"overlapping\" (at the start) or \"unresolved\""),
    AnswerField::of("a hit", "time", "the last moment proved free, in [0, 1]"),
    AnswerField::of(
        "a hit or an unresolved motion",
        "time_bounds",
        "[lo, hi]: free until lo; of a hit, contact at or before hi",
    ),
    AnswerField::of(
        "an unresolved motion",
        "reason",
        "why it is: within-rounding, within-tolerance, iteration-limit or stalled",
    ),
    DISTANCE.only("a hit or an overlap at the start"),
    ENCLOSED.only("a hit or an overlap at the start"),
    AnswerField::always("tolerance", "the tolerance in force, world units; 0 where the answer is direct"),
    NORMAL.only("a hit"),
    POINTS.only("a hit"),
    FEATURES.only("a hit"),
    AnswerField::always("iterations", "how many distance queries were made"),
    CLOSEST,
    OFF,
];

/// Parts of an answer to a question for the bound on motion.
pub(crate) const OF_MOTION_BOUND: &[AnswerField] = &[
    KIND,
    AnswerField::always(
        "bound",
        "the farthest that a point can move over t in [0, 1], world units, rounded up",
    ),
];

/// Parts of an answer to a question for the contact.
pub(crate) const OF_CONTACT: &[AnswerField] = &[
    KIND,
    VERDICT,
    DISTANCE,
    ENCLOSED,
    NORMAL,
    TIES,
    AnswerField::of(
        "edges that face each other",
        "reference",
        "{\"body\": \"A\", \"edge\": i}, the edge that is clipped against",
    ),
    AnswerField::of(
        "edges that face each other",
        "incident",
        "{\"body\": \"B\", \"edge\": i}, the edge that is clipped",
    ),
    AnswerField {
        inner: &[
            AnswerField::always("separation", "minus the depth there, world units"),
            AnswerField::always("separation_bounds", "[lo, hi], which enclose the exact one"),
            POINTS,
            FEATURES,
        ],
        ..AnswerField::always(
            "contacts",
            "a list of at most two points, along the reference edge; none where apart",
        )
    },
    OFF,
];
