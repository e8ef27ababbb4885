//! What is said of a body, in the long text and in the question of an exercise.

use crate::trace::phrases;

phrases! {
    /// A body and what it is.
    IS: "* is *", "* ist *", "* est *", "* es *";
    /// The sides of a box.
    OF_SIZE: " of * by *", " von * mal *", " de * sur *", " de * por *";
    /// The two ends of a capsule.
    FROM_TO: " from * to *", " von * bis *", " de * à *", " de * a *";
    /// A circle without a radius.
    POINT: "a point", "ein Punkt", "un point", "un punto";
    /// A capsule without a radius.
    SEGMENT: "a segment", "eine Strecke", "un segment", "un segmento";
    /// The radius of a body.
    OF_RADIUS: " of radius *", " mit Radius *", " de rayon *", " de radio *";
    /// Where the origin of a body is, from which its vertices are given.
    MOVED: ", as seen from its origin at *",
        ", gesehen vom Ursprung des Körpers bei *",
        " (coordonnées depuis l’origine du corps, en *)",
        " (coordenadas desde el origen del cuerpo, que está en *)";
    /// Where a body is.
    AT: " at *", " bei *", " en *", " en *";
    /// By which angle a body is turned.
    TURNED: ", turned by *", ", um * gedreht", ", avec une rotation de *", ", con un giro de *";
    /// How a body moves from the start to the end.
    MOVING: ", moving by *", ", bewegt sich um *", ", se déplaçant de *", ", que se desplaza *";
    /// How a body turns from the start to the end.
    TURNING: ", turning by *", ", dreht sich um *", ", tournant de *", ", que gira *";
    /// Two things that are named together.
    AND: "* and *", "* und *", "* et *", "* y *";
    /// A regular polygon: its edges and its circumradius.
    REGULAR: " with * edges, circumradius *",
        " mit * Kanten und Umkreisradius *",
        " à * arêtes, de rayon circonscrit *",
        " de * aristas y circunradio *";
    /// The vertices of a polygon, counted, and how far they reach: width, height, from, to.
    SPANNING: " of * vertices, spanning * by * from * to *",
        " mit * Ecken, * mal * groß, von * bis *",
        " de * sommets, * sur *, de * à *",
        " de * vértices, de * por *, de * a *";
    /// The cosine and sine by which it is turned.
    ROTATION: " (rotation *)", " (Drehung *)", " (rotation *)", " (rotación *)";
    /// What a body turns about.
    ABOUT_ORIGIN: " about its origin",
        " um den eigenen Ursprung",
        " autour de son origine",
        " alrededor de su origen";
}
