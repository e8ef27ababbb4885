//! The sentences of a story in each language, a file for what they are about; here what stands in many.

pub(super) mod events;
pub(super) mod moving;
pub(super) mod steps;

use crate::trace::tongue::phrases;

phrases! {
    /// The two bodies.
    BOTH: "* and *", "* und *", "* et *", "* y *";
    /// A moment with the angle of a body.
    AT_ANGLE: "* at * deg", "* bei * Grad", "* à * degrés", "* a * grados";
    /// A vertex by its index.
    VERTEX: "vertex *", "Ecke *", "sommet *", "vértice *";
    /// The vertex of a circle.
    CENTER: "the centre", "Mittelpunkt", "centre", "centro";
    /// An edge by its index.
    EDGE: "edge *", "Kante *", "arête *", "arista *";
    /// A vertex and its place.
    VERTEX_AT: "vertex * at *", "Ecke * bei *", "sommet * en *", "vértice * en *";
    /// What lies farthest of a vertex of a body with a radius: index, place.
    ROUNDING_AT: "the rounding of vertex * at *",
        "die Rundung um Ecke * bei *",
        "l’arrondi du sommet * en *",
        "el redondeo del vértice * en *";
    /// What lies farthest of a circle: its centre.
    OUTLINE_AROUND: "the outline around the centre at *",
        "der Umriss um den Mittelpunkt bei *",
        "le contour autour du centre en *",
        "el contorno en torno al centro en *";
    /// Inside of a boundary, by a length.
    INSIDE: "* inside", "* im Inneren", "à * à l’intérieur", "* por dentro";
    /// Away from a boundary, by a length.
    AWAY: "* away", "* entfernt", "à une distance de *", "a una distancia de *";
    /// Inside of a line, by a length.
    INSIDE_LINE: "* inside", "um * innerhalb", "à * en dedans", "* por dentro";
    /// Outside of a line, by a length.
    OUTSIDE_LINE: "* outside", "um * außerhalb", "à * en dehors", "* por fuera";
    /// On either side of a line, by less than a length.
    NEAR_LINE: "* from", "* von", "à *", "a *";
    /// A length that is next to nothing.
    LESS: "less than *", "weniger als *", "moins de *", "menos de *";
    /// An interval.
    SPAN: "* to *", "* bis *", "* à *", "* a *";
}
