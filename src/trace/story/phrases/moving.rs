//! What is told of bodies that move, and of what someone else answered.

use crate::trace::tongue::phrases;

phrases! {
    /// A ray and an edge: part, body, from, to, what came of it, when.
    RAY: "The ray against * of *, from * to *: **.",
        "Strahl – * von *, von * bis *: **.",
        "Rayon – * de *, de * à * : **.",
        "Rayo – * de *, de * a *: **.";
    /// A ray and a vertex of round bodies: part, body, where, what came of it, when.
    RAY_AT: "The ray against * of *, as a circle around *: **.",
        "Strahl – * von *, als Kreis um *: **.",
        "Rayon – * de *, comme cercle autour de * : **.",
        "Rayo – * de *, como círculo en torno a *: **.";
    /// It was not looked at.
    FACES_AWAY: "it faces away, skipped",
        "abgewandt, übersprungen",
        "face arrière, ignorée",
        "cara posterior, se omite";
    /// It was missed.
    MISSED: "missed", "verfehlt", "manqué", "fallado";
    /// It was hit.
    ENTERED: "entered", "getroffen", "touché", "alcanzado";
    /// When.
    AT_TIME: " at t = *", " bei t = *", " à t = *", " en t = *";
    /// When it crosses the line of an edge that it misses.
    CROSSED: ", its line is crossed at t = *",
        ", ihre Gerade wird bei t = * gekreuzt",
        ", sa droite est coupée à t = *",
        ", su recta se cruza en t = *";
    /// A step of an advancement: number, moment, separation, normal, speed, bound, what then.
    STEP: "Step *: at * they are * apart along *, closing at **; *.",
        "Schritt *: Bei * sind sie * voneinander entfernt, entlang *, und nähern sich mit **; *.",
        "Étape * : à *, ils sont à une distance de * le long de * ; vitesse de rapprochement : ** ; *.",
        "Paso *: en * están a * a lo largo de *; velocidad de acercamiento: **; *.";
    /// A step of bodies that overlap: number, moment, depth, normal, how it goes on.
    OVERLAP_STEP: "Step *: at * they overlap by * along *; *.",
        "Schritt *: Bei * überlappen sie sich um * entlang *; *.",
        "Étape * : à *, ils se recouvrent de * le long de * ; *.",
        "Paso *: en * se solapan en * a lo largo de *; *.";
    /// The bound on their speed.
    WITH_TURNING: ", at most * with the turning",
        ", höchstens * mit der Drehung",
        ", au plus * avec la rotation",
        ", a lo sumo * con el giro";
    /// No step follows.
    STOPS: "it stops here", "hier ist Schluss", "fin des étapes", "aquí se detiene";
    /// The next one.
    ON_TO: "on to t = *", "weiter zu t = *", "suite à t = *", "sigue en t = *";
    /// A direction along which they stay apart: from, to, direction, body.
    SWEPT: "From t = * to * they stay apart along *, a direction in the frame of *.",
        "Von t = * bis * bleiben sie entlang * getrennt, einer Richtung im System von *.",
        "De t = * à *, ils restent séparés le long de *, une direction du repère de *.",
        "De t = * a * siguen separados a lo largo de *, una dirección del sistema de *.";
    /// The closest approach: bodies, moment, where that is, separation, normal, what is proved.
    CLOSEST: "* come closest at **: * apart along *, and never less*.",
        "* kommen sich am nächsten bei **: * voneinander entfernt, entlang *, und nie weniger*.",
        "* sont au plus près à ** : une distance de * le long de *, et jamais moins*.",
        "* tienen su menor distancia en **: * a lo largo de *, y nunca menos*.";
    /// At the beginning.
    BEGINS: ", where the motion begins",
        ", am Anfang der Bewegung",
        ", au début du mouvement",
        ", al comienzo del movimiento";
    /// At the end.
    ENDS: ", where the motion ends",
        ", am Ende der Bewegung",
        ", à la fin du mouvement",
        ", al final del movimiento";
    /// What is proved.
    THAN: " than *", " als *", " de *", " de *";
    /// Another's answer can't be compared.
    INCOMPARABLE: "Nothing of what was expected can be held against this answer.",
        "Nichts vom Erwarteten lässt sich mit dieser Antwort vergleichen.",
        "Rien de ce qui était attendu ne se compare à cette réponse.",
        "Nada de lo esperado se puede comparar con esta respuesta.";
    /// How far off it is: the size of the scene, the parts.
    OFF: "What was expected is off, with S = *: *.",
        "Das Erwartete liegt daneben, mit S = *: *.",
        "Ce qui était attendu s’écarte, avec S = * : *.",
        "Lo esperado se desvía, con S = *: *.";
    /// How far off it is, for readers of a figure: the parts.
    OFF_BY: "What was expected is off: *.",
        "Das Erwartete liegt daneben: *.",
        "Ce qui était attendu s’écarte : *.",
        "Lo esperado se desvía: *.";
    /// Nothing of it is off.
    AGREES: "What was expected agrees with the answer.",
        "Das Erwartete stimmt mit der Antwort überein.",
        "Ce qui était attendu concorde avec la réponse.",
        "Lo esperado coincide con la respuesta.";
    /// Its outcome, and ours.
    OUTCOME_BY: "the outcome (expected: *, found: *)",
        "das Ergebnis (erwartet: *, gefunden: *)",
        "le résultat (attendu : *, trouvé : *)",
        "el resultado (esperado: *, hallado: *)";
    /// Its separation.
    SEPARATION_BY: "the separation by *", "der Abstand um *", "la séparation de *", "la separación en *";
    /// Its time.
    TIME_BY: "the time by *", "die Zeit um *", "le temps de *", "el tiempo en *";
    /// Its normal.
    NORMAL_BY: "the normal by *°",
        "die Normale um *°",
        "la normale de *°",
        "la normal en *°";
    /// A point: on which body, by what.
    POINT_BY: "the point on * by *",
        "der Punkt auf * um *",
        "le point sur * de *",
        "el punto de * en *";
    /// A bound on a motion: body, angle, radius, vertices, arc, path.
    BOUND: "* turns by * rad; its farthest point is * from its origin (*), so L = *; *.",
        "* dreht sich um * rad; der fernste Punkt ist * vom Ursprung entfernt (*), also L = *; *.",
        "* tourne de * rad ; son point le plus éloigné est à * de son origine (*), donc L = * ; *.",
        "* gira * rad; su punto más lejano está a * de su origen (*), luego L = *; *.";
    /// The path of one body.
    PATH: "its path adds *", "der Weg bringt * dazu", "son trajet ajoute *", "su camino añade *";
    /// The path of two.
    PATHS: "the way that the two pass each other adds *, once",
        "der Weg der beiden aneinander vorbei bringt * dazu, einmal",
        "le trajet de l’un par rapport à l’autre ajoute *, une fois",
        "el camino de uno respecto al otro añade *, una vez";
    /// An edge that faces away from the ray.
    ONE_AWAY: "One edge faces away from the ray and is skipped.",
        "Eine Kante ist vom Strahl abgewandt und wird übersprungen.",
        "Une arête tourne le dos au rayon et est ignorée.",
        "Una arista da la espalda al rayo y se omite.";
    /// Several.
    MANY_AWAY: "* edges face away from the ray and are skipped.",
        "* Kanten sind vom Strahl abgewandt und werden übersprungen.",
        "* arêtes tournent le dos au rayon et sont ignorées.",
        "* aristas dan la espalda al rayo y se omiten.";
}
