//! What an exercise may ask for: values of texts that are numbers of an answer, with the words of the
//! question.

use crate::collision::QueryKind;

use super::asked_of::{bounds_motion, is_for_a_box, is_of_two, moves};
use super::measure::Measure;
use crate::trace::{Phrase, phrase};

/// A value that can be asked for.
pub(crate) struct Askable {
    /// Its name among the values of texts.
    pub(crate) name: &'static str,
    /// How it is written before the blank, as LaTeX.
    pub(crate) symbol: &'static str,
    /// What is to be found, with `{}` for the bodies, `{a}` and `{b}` for each: "the depth of {}"; in each
    /// language of exercises.
    pub(super) what: Phrase,
    /// What it is measured in.
    pub(crate) measure: Measure,
    /// Whether its bounds are proved; else a double is told, rounded.
    pub(crate) is_proved: bool,
    /// The questions whose answers it is a part of.
    pub(crate) of: fn(QueryKind) -> bool,
}

/// A row of the table.
pub(super) const fn row(
    name: &'static str,
    symbol: &'static str,
    what: [&'static str; 4],
    measure: Measure,
    of: fn(QueryKind) -> bool,
) -> Askable {
    Askable { name, symbol, what: phrase(what), measure, is_proved: false, of }
}

/// A row whose bounds are proved.
pub(super) const fn proved(mut row: Askable) -> Askable {
    row.is_proved = true;
    row
}

/// Every value that can be asked for but those of a contact.
pub(super) static ASKABLE: &[Askable] = &[
    proved(row(
        "separation",
        "s",
        [
            "the signed separation of {}, negative inside",
            "der Abstand von {}, innen negativ",
            "la distance signée de {}, négative à l’intérieur",
            "la separación con signo de {}, negativa dentro",
        ],
        Measure::Length,
        is_of_two,
    )),
    proved(row(
        "d",
        "d",
        [
            "how far {} are apart, or how deep they overlap",
            "wie weit {} entfernt sind oder wie tief sie sich überlappen",
            "de combien {} sont distants, ou de combien ils se recouvrent",
            "cuánto distan {}, o cuánto se solapan",
        ],
        Measure::Length,
        is_of_two,
    )),
    proved(row(
        "depth",
        "d",
        [
            "the depth by which {} overlap",
            "die Tiefe, um die sich {} überlappen",
            "la profondeur de recouvrement de {}",
            "la profundidad en que se solapan {}",
        ],
        Measure::Length,
        is_of_two,
    )),
    row(
        "n.x",
        "n_x",
        [
            "the x component of the unit normal from {a} to {b}",
            "die x-Komponente der Einheitsnormale von {a} nach {b}",
            "la composante x de la normale unitaire de {a} vers {b}",
            "la componente x de la normal unitaria de {a} a {b}",
        ],
        Measure::Pure,
        is_of_two,
    ),
    row(
        "n.y",
        "n_y",
        [
            "the y component of the unit normal from {a} to {b}",
            "die y-Komponente der Einheitsnormale von {a} nach {b}",
            "la composante y de la normale unitaire de {a} vers {b}",
            "la componente y de la normal unitaria de {a} a {b}",
        ],
        Measure::Pure,
        is_of_two,
    ),
    proved(row(
        "time",
        "t",
        [
            "the time of the first contact of {}",
            "der Zeitpunkt der ersten Berührung von {}",
            "l’instant du premier contact de {}",
            "el instante del primer contacto de {}",
        ],
        Measure::Time,
        moves,
    )),
    row(
        "hit.n.x",
        "n_x",
        [
            "the x component of the unit normal from {a} to {b} at the first contact",
            "die x-Komponente der Einheitsnormale von {a} nach {b} bei der ersten Berührung",
            "la composante x de la normale unitaire de {a} vers {b} au premier contact",
            "la componente x de la normal unitaria de {a} a {b} en el primer contacto",
        ],
        Measure::Pure,
        moves,
    ),
    row(
        "hit.n.y",
        "n_y",
        [
            "the y component of the unit normal from {a} to {b} at the first contact",
            "die y-Komponente der Einheitsnormale von {a} nach {b} bei der ersten Berührung",
            "la composante y de la normale unitaire de {a} vers {b} au premier contact",
            "la componente y de la normal unitaria de {a} a {b} en el primer contacto",
        ],
        Measure::Pure,
        moves,
    ),
    row(
        "closest.time",
        "t",
        [
            "the time at which {} are closest",
            "der Zeitpunkt, zu dem {} am nächsten sind",
            "l’instant où {} sont le plus proches",
            "el instante en que {} están más cerca",
        ],
        Measure::Time,
        moves,
    ),
    proved(row(
        "closest.separation",
        "d",
        [
            "the least distance between {} on their way",
            "der kleinste Abstand zwischen {} auf dem Weg",
            "la plus petite distance entre {} en chemin",
            "la menor distancia entre {} en su camino",
        ],
        Measure::Length,
        moves,
    )),
    row(
        "centers",
        "c",
        [
            "the distance of the centres of {}",
            "der Abstand der Mittelpunkte von {}",
            "la distance des centres de {}",
            "la distancia entre los centros de {}",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "radii",
        "r_1 + r_2",
        [
            "the sum of the radii of {}",
            "die Summe der Radien von {}",
            "la somme des rayons de {}",
            "la suma de los radios de {}",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "p",
        "p",
        [
            "the distance of the centres of {} less the sum of their radii",
            "der Abstand der Mittelpunkte von {} weniger die Summe ihrer Radien",
            "la distance des centres de {} moins la somme de leurs rayons",
            "la distancia entre los centros de {} menos la suma de sus radios",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "P.x",
        "P_x",
        [
            "the x component of the penetration vector, which moves {b} until it just touches {a}",
            "die x-Komponente des Eindringvektors, der {b} bewegt, bis es {a} nur noch berührt",
            "la composante x du vecteur de pénétration, qui déplace {b} jusqu’à toucher juste {a}",
            "la componente x del vector de penetración, que mueve {b} hasta que toca justo {a}",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "P.y",
        "P_y",
        [
            "the y component of the penetration vector, which moves {b} until it just touches {a}",
            "die y-Komponente des Eindringvektors, der {b} bewegt, bis es {a} nur noch berührt",
            "la composante y du vecteur de pénétration, qui déplace {b} jusqu’à toucher juste {a}",
            "la componente y del vector de penetración, que mueve {b} hasta que toca justo {a}",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "D",
        "D",
        [
            "the distance from the nearest point of the box's outline to the circle's centre",
            "der Abstand vom nächsten Punkt auf dem Rand des Rechtecks zum Mittelpunkt des Kreises",
            "la distance du point le plus proche du contour du rectangle au centre du cercle",
            "la distancia del punto más cercano del contorno del rectángulo al centro del círculo",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "D.x",
        "D_x",
        [
            "the x component of D, from the nearest point of the box's outline to the circle's centre",
            "die x-Komponente von D, vom nächsten Punkt am Rand des Rechtecks zur Kreismitte",
            "la composante x de D, du point le plus proche du contour du rectangle au centre du cercle",
            "la componente x de D, del punto más cercano del contorno del rectángulo al centro del círculo",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "D.y",
        "D_y",
        [
            "the y component of D, from the nearest point of the box's outline to the circle's centre",
            "die y-Komponente von D, vom nächsten Punkt am Rand des Rechtecks zur Kreismitte",
            "la composante y de D, du point le plus proche du contour du rectangle au centre du cercle",
            "la componente y de D, del punto más cercano del contorno del rectángulo al centro del círculo",
        ],
        Measure::Length,
        is_of_two,
    ),
    row(
        "bound",
        "b",
        [
            "the bound on the motion of {}: path and arc together",
            "die Schranke für die Bewegung von {}: Weg und Bogen zusammen",
            "la borne du mouvement de {} : trajet et arc réunis",
            "la cota del movimiento de {}: recorrido y arco juntos",
        ],
        Measure::Length,
        bounds_motion,
    ),
    row(
        "L",
        "L",
        [
            "the arc that the farthest point of {} travels",
            "der Bogen, den der fernste Punkt von {} zurücklegt",
            "l’arc que parcourt le point le plus éloigné de {}",
            "el arco que recorre el punto más lejano de {}",
        ],
        Measure::Length,
        bounds_motion,
    ),
    row(
        "theta",
        r"\theta",
        [
            "the angle by which {} turns",
            "der Winkel, um den sich {} dreht",
            "l’angle dont tourne {}",
            "el ángulo que gira {}",
        ],
        Measure::Degrees,
        bounds_motion,
    ),
    row(
        "radius",
        "r",
        [
            "how far the farthest point of {} is from its origin",
            "wie weit der fernste Punkt von {} von dessen Ursprung entfernt ist",
            "à quelle distance de son origine est le point le plus éloigné de {}",
            "a qué distancia de su origen está el punto más lejano de {}",
        ],
        Measure::Length,
        bounds_motion,
    ),
    row(
        "min.x",
        r"x_{\mathrm{min}}",
        ["the smallest x of {}", "das kleinste x von {}", "le plus petit x de {}", "el menor x de {}"],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "min.y",
        r"y_{\mathrm{min}}",
        ["the smallest y of {}", "das kleinste y von {}", "le plus petit y de {}", "el menor y de {}"],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "max.x",
        r"x_{\mathrm{max}}",
        ["the largest x of {}", "das größte x von {}", "le plus grand x de {}", "el mayor x de {}"],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "max.y",
        r"y_{\mathrm{max}}",
        ["the largest y of {}", "das größte y von {}", "le plus grand y de {}", "el mayor y de {}"],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "h.x",
        "h_x",
        [
            "half the width of the bounding box of {}",
            "die halbe Breite der Bounding-Box von {}",
            "la demi-largeur de la boîte englobante de {}",
            "la mitad del ancho de la caja envolvente de {}",
        ],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "h.y",
        "h_y",
        [
            "half the height of the bounding box of {}",
            "die halbe Höhe der Bounding-Box von {}",
            "la demi-hauteur de la boîte englobante de {}",
            "la mitad del alto de la caja envolvente de {}",
        ],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "c.x",
        "c_x",
        [
            "the x of the centre of the bounding box of {}",
            "das x der Mitte der Bounding-Box von {}",
            "le x du centre de la boîte englobante de {}",
            "la x del centro de la caja envolvente de {}",
        ],
        Measure::Length,
        is_for_a_box,
    ),
    row(
        "c.y",
        "c_y",
        [
            "the y of the centre of the bounding box of {}",
            "das y der Mitte der Bounding-Box von {}",
            "le y du centre de la boîte englobante de {}",
            "la y del centro de la caja envolvente de {}",
        ],
        Measure::Length,
        is_for_a_box,
    ),
];
