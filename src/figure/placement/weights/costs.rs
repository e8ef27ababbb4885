//! What a place costs for what lies there.

super::numbers! {
    /// Costs of hiding, touching, crowding and misleading.
    Costs {
        /// Room that labels keep from strokes of other things, page pixels.
        /// Twice: 11 + 36 labels; half: 2 + 2 labels.
        stroke_room: f64 = 2.0;
        /// Touching an outline, vector or dimension of something else.
        /// Twice: nothing; half: 0 + 2 labels.
        stroke: f64 = 18.0;
        /// Each page pixel of such a stroke inside the label.
        /// Twice: nothing; half: 0 + 2 labels.
        stroke_px: f64 = 0.5;
        /// Touching a construction line, a ghost or an axis of something else, or any stroke of the thing
        /// that the label belongs to.
        /// Twice: 1 + 2 labels; half: nothing.
        light: f64 = 11.0;
        /// Each page pixel of such a stroke inside the label.
        /// Twice: 0 + 2 labels; half: nothing.
        light_px: f64 = 0.3;
        /// A foreign stroke nearer than this crowds a label, page pixels.
        /// Twice: 27 + 63 labels; half: 6 + 55 labels.
        crowd_reach: f64 = 7.0;
        /// A foreign stroke right beside a label, falling to nothing at `crowd_reach`.
        /// Twice: 14 + 18 labels; half: 2 + 34 labels.
        crowd: f64 = 1.2;
        /// A line between a label and the point that it names.
        /// Twice: 3 + 0 labels; half: 2 + 0 labels.
        parted: f64 = 7.0;
        /// Room that labels keep from markers and arrowheads, page pixels.
        /// Twice: 9 + 3 labels; half: 6 + 7 labels.
        marker_room: f64 = 1.5;
        /// Touching a marker or an arrowhead.
        /// Twice and half: nothing.
        marker: f64 = 30.0;
        /// A foreign marker nearer than this misleads, page pixels.
        /// Twice: 11 + 7 labels; half: 3 + 0 labels.
        mislead_reach: f64 = 8.0;
        /// A foreign marker so near that a reader could take the label for its.
        /// Twice: 5 + 2 labels; half: 1 + 0 labels.
        mislead: f64 = 2.5;
        /// The name of an area seems to name a marker nearer than this, page pixels.
        /// Twice: 16 + 17 labels; half: 2 + 4 labels.
        naming_reach: f64 = 30.0;
        /// A marker right beside the name of an area, falling to nothing at `naming_reach`.
        /// Twice: 1 + 5 labels; half: 0 + 1 labels.
        naming: f64 = 6.0;
        /// How far a label may reach over the edge of its panel, page pixels: a quarter of the gap between
        /// panels.
        /// Twice: 0 + 3 labels, three faults more; half: 0 + 3 labels. A label that reaches farther than it
        /// does as tuned is a fault, so most of those at twice are of this number's making.
        spill: f64 = 6.0;
        /// Reaching over the panel's edge into that gap.
        /// Twice: 0 + 3 labels; half: 1 + 2 labels.
        spilled: f64 = 1.5;
        /// Each page pixel of reaching into that gap.
        /// Twice: 0 + 4 labels; half: 1 + 0 labels.
        spilled_px: f64 = 0.3;
        /// Reaching farther over the panel's edge than `spill`.
        /// Twice and half: nothing.
        edge: f64 = 60.0;
        /// Each page pixel of reaching farther over the panel's edge than `spill`.
        /// Twice and half: nothing.
        edge_px: f64 = 2.0;
        /// Room that labels keep from each other, page pixels.
        /// Twice and half: nothing.
        label_room: f64 = 3.0;
        /// Two labels that overlap, or come nearer than `label_room`.
        /// Twice and half: nothing.
        overlap: f64 = 70.0;
        /// Two labels at this distance are as good as apart, page pixels.
        /// Twice: 14 + 31 labels; half: 4 + 9 labels.
        label_comfort: f64 = 18.0;
        /// Two labels that nearly touch, falling to nothing at `label_comfort`.
        /// Twice: 1 + 5 labels; half: 2 + 4 labels.
        close: f64 = 4.0;
        /// A stroke under a leader line.
        /// Twice: 0 + 2 labels; half: nothing.
        leader: f64 = 3.0;
        /// A label or another leader line under a leader line.
        /// Twice and half: nothing.
        under: f64 = 40.0;
        /// Standing as near to another thing as to its own, or nearer, without a leader line.
        /// Twice: 0 + 4 labels; half: 0 + 2 labels.
        nearer: f64 = 40.0;
        /// How much nearer to its own thing than to any other a label should stand, page pixels.
        /// Twice: 7 + 7 labels; half: 2 + 1 labels.
        doubt_reach: f64 = 8.0;
        /// Standing just nearer to its own thing than to another one, falling to nothing at `doubt_reach`.
        /// Twice: nothing; half: 0 + 1 labels.
        doubt: f64 = 5.0;
        /// Standing elsewhere than the same label of the same thing in an earlier panel.
        /// Twice: 1 + 0 labels; half: 0 + 2 labels.
        moved: f64 = 6.0;
        /// Things and labels of two panels are at the same place if they are nearer than this, page pixels.
        /// Twice and half: nothing.
        same_place: f64 = 1.0;
    }
}
