//! What a place costs for what lies there.

super::numbers! {
    /// Costs of hiding, touching, crowding and misleading.
    Costs {
        /// Room that labels keep from strokes of other things, page pixels.
        stroke_room: f64 = 2.0;
        /// Touching an outline, vector or dimension of something else.
        stroke: f64 = 14.0;
        /// Each page pixel of a stroke inside the label.
        stroke_px: f64 = 0.5;
        /// Touching a construction line, a ghost or an axis of something else, or any stroke of the thing
        /// that the label belongs to.
        light: f64 = 11.0;
        /// A foreign stroke nearer than this crowds a label, page pixels.
        crowd_reach: f64 = 7.0;
        /// A foreign stroke right beside a label, falling to nothing at `crowd_reach`.
        crowd: f64 = 1.2;
        /// A line between a label and the point that it names.
        parted: f64 = 7.0;
        /// Room that labels keep from markers and arrowheads, page pixels.
        marker_room: f64 = 1.5;
        /// Touching a marker or an arrowhead.
        marker: f64 = 30.0;
        /// A foreign marker nearer than this misleads, page pixels.
        mislead_reach: f64 = 8.0;
        /// A foreign marker so near that a reader could take the label for its.
        mislead: f64 = 2.5;
        /// The name of an area seems to name a marker nearer than this, page pixels.
        naming_reach: f64 = 30.0;
        /// A marker right beside the name of an area, falling to nothing at `naming_reach`.
        naming: f64 = 6.0;
        /// How far a label may reach over the edge of its panel, page pixels: a quarter of the gap between
        /// panels.
        spill: f64 = 6.0;
        /// Reaching over the panel's edge into that gap.
        spilled: f64 = 1.5;
        /// Each page pixel of that.
        spilled_px: f64 = 0.3;
        /// Reaching farther over the panel's edge than `spill`.
        edge: f64 = 60.0;
        /// Each page pixel of that.
        edge_px: f64 = 2.0;
        /// Room that labels keep from each other, page pixels.
        label_room: f64 = 3.0;
        /// Two labels that overlap, or come nearer than `label_room`.
        overlap: f64 = 70.0;
        /// Two labels at this distance are as good as apart, page pixels.
        label_comfort: f64 = 18.0;
        /// Two labels that nearly touch, falling to nothing at `label_comfort`.
        close: f64 = 4.0;
        /// A stroke or a label under a leader line.
        leader: f64 = 8.0;
        /// Standing elsewhere than the same label of the same thing in an earlier panel.
        moved: f64 = 6.0;
        /// Things and labels of two panels are at the same place if they are nearer than this, page pixels.
        same_place: f64 = 1.0;
    }
}
