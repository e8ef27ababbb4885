//! What the short and the long text say of an answer and of a picture.

use crate::trace::phrases;

phrases! {
    /// A title and what came out.
    TITLED: "*: *", "*: *", "* : *", "*: *";
    /// A sentence of a later moment.
    AT_MOMENT: "at t = * *", "bei t = *: *", "à t = * : *", "en t = *: *";
    /// A bounding box: whose, from, to.
    BOX: "the bounding box of * reaches from * to *.",
        "die Bounding-Box von * reicht von * bis *.",
        "la boîte englobante de * va de * à *.",
        "la caja envolvente de * va de * a *.";
    /// The bound of one body: which, how far.
    NO_FARTHER: "no point of * travels farther than *.",
        "kein Punkt von * bewegt sich weiter als *.",
        "aucun point de * ne se déplace de plus de *.",
        "ningún punto de * se mueve más de *.";
    /// The bound of one that is carried along and turns: which, how far, of that with the velocity, the turn.
    NO_FARTHER_BY: "no point of * travels farther than *: * with the velocity and at most * with the turn.",
        "kein Punkt von * bewegt sich weiter als *: * durch die Geschwindigkeit, höchstens * durch die \
         Drehung.",
        "aucun point de * ne se déplace de plus de * : * par la vitesse et au plus * par la rotation.",
        "ningún punto de * se mueve más de *: * por la velocidad y como máximo * por el giro.";
    /// The bound of two.
    NO_NEARER: "no two points of * and * come nearer to each other by more than *.",
        "ein Punkt von * und einer von * nähern sich nie um mehr als *.",
        "un point de * et un de * ne se rapprochent jamais de plus de *.",
        "un punto de * y uno de * nunca se acercan más de *.";
    /// The bound of two that are carried along and turn.
    NO_NEARER_BY: "no two points of * and * come nearer to each other by more than *: * with the velocities \
        and at most * with the turns.",
        "ein Punkt von * und einer von * nähern sich nie um mehr als *: * durch die Geschwindigkeiten und \
        höchstens * durch die Drehungen.",
        "un point de * et un de * ne se rapprochent jamais de plus de * : * par les vitesses et au plus * \
        par les rotations.",
        "un punto de * y uno de * nunca se acercan más de *: * por las velocidades y como máximo * por los \
         giros.";
    /// No verdict.
    UNSAID: "rounding forbids to say whether * and * overlap.",
        "durch Rundung bleibt offen, ob * und * sich überlappen.",
        "l’arrondi empêche de dire si * et * se recouvrent.",
        "el redondeo impide decir si * y * se solapan.";
    /// A verdict.
    OVERLAP: "* and * overlap.", "* und * überlappen sich.", "* et * se recouvrent.", "* y * se solapan.";
    /// The other verdict.
    NO_OVERLAP: "* and * do not overlap.",
        "* und * überlappen sich nicht.",
        "* et * ne se recouvrent pas.",
        "* y * no se solapan.";
    /// The other verdict with the distance.
    NO_OVERLAP_BY: "* and * do not overlap: they are * apart.",
        "* und * überlappen sich nicht: Ihr Abstand ist *.",
        "* et * ne se recouvrent pas : leur distance est de *.",
        "* y * no se solapan: su distancia es *.";
    /// The other verdict by an axis: the gap along it.
    NO_OVERLAP_ALONG: "* and * do not overlap: along an axis there is a gap of *.",
        "* und * überlappen sich nicht: Entlang einer Achse ist eine Lücke von *.",
        "* et * ne se recouvrent pas : le long d’un axe, l’écart est de *.",
        "* y * no se solapan: a lo largo de un eje hay un hueco de *.";
    /// Bodies that are apart: how far, along what.
    APART: "* and * are * apart along the normal *.",
        "* und * sind * voneinander entfernt, entlang der Normalen *.",
        "* et * sont à une distance de * le long de la normale *.",
        "* y * están a una distancia de * a lo largo de la normal *.";
    /// Bodies that are apart where edge faces edge, so that no pair of points alone is the closest one.
    APART_ALONG: "* and * are * apart along the normal *, edge to edge.",
        "* und * sind * voneinander entfernt, entlang der Normalen *, Kante an Kante.",
        "* et * sont à une distance de * le long de la normale *, arête contre arête.",
        "* y * están a una distancia de * a lo largo de la normal *, arista contra arista.";
    /// Bodies that overlap, and the push.
    OVERLAP_AND: "* and * overlap; *.",
        "* und * überlappen sich; *.",
        "* et * se recouvrent ; *.",
        "* y * se solapan; *.";
    /// Bodies that touch.
    TOUCH: "* and * touch.", "* und * berühren sich.", "* et * se touchent.", "* y * se tocan.";
    /// Bodies that touch at vertices, where the normal is one of several: it.
    TOUCH_OF_MANY: "* and * touch; * is one of several normals.",
        "* und * berühren sich; * ist eine von mehreren Normalen.",
        "* et * se touchent ; * est l’une de plusieurs normales.",
        "* y * se tocan; * es una de varias normales.";
    /// Bodies that may well touch: the gap is no more than rounding took.
    APART_BY_ROUNDING: "* and * are * apart, no more than the rounding of their numbers.",
        "* und * sind * voneinander entfernt, nicht mehr als die Rundung ihrer Zahlen.",
        "* et * sont à une distance de *, pas plus que l’arrondi de leurs nombres.",
        "* y * están a una distancia de *, no más que el redondeo de sus números.";
    /// The depth is.
    DEEP_BY_ROUNDING: "* and * overlap by *, no more than the rounding of their numbers.",
        "* und * überlappen sich um *, nicht mehr als die Rundung ihrer Zahlen.",
        "* et * se recouvrent de *, pas plus que l’arrondi de leurs nombres.",
        "* y * se solapan en *, no más que el redondeo de sus números.";
    /// The shortest push: body, depth, direction.
    PUSH: "the shortest push that parts them moves * by * along *",
        "der kürzeste Schub, der sie trennt, bewegt * um * entlang *",
        "la plus courte poussée qui les sépare déplace * de * le long de *",
        "el empuje más corto que los separa mueve * en * a lo largo de *";
    /// The shortest push where every direction is as good.
    PUSH_ANY: "the shortest push that parts them moves * by * in any direction, as along *",
        "der kürzeste Schub, der sie trennt, bewegt * um * in irgendeine Richtung, etwa entlang *",
        "la plus courte poussée qui les sépare déplace * de * dans n’importe quelle direction, comme *",
        "el empuje más corto que los separa mueve * en * en cualquier dirección, como *";
    /// One of several pushes that are as short: how many, body, depth, direction.
    PUSH_OF_MANY: "one of the * shortest pushes that part them moves * by * along *",
        "einer der * kürzesten Schübe, die sie trennen, bewegt * um * entlang *",
        "l’une des * plus courtes poussées qui les séparent déplace * de * le long de *",
        "uno de los * empujes más cortos que los separan mueve * en * a lo largo de *";
    /// No point of contact.
    CONTACTS_0: "* There is no point of contact.",
        "* Es gibt keinen Kontaktpunkt.",
        "* Il n’y a pas de point de contact.",
        "* No hay ningún punto de contacto.";
    /// One.
    CONTACTS_1: "* There is one point of contact.",
        "* Es gibt einen Kontaktpunkt.",
        "* Il y a un point de contact.",
        "* Hay un punto de contacto.";
    /// Two.
    CONTACTS_2: "* There are two points of contact.",
        "* Es gibt zwei Kontaktpunkte.",
        "* Il y a deux points de contact.",
        "* Hay dos puntos de contacto.";
    /// A hit: bodies, time, place.
    HIT: "* first touches * at t = *, at *.",
        "* berührt * zum ersten Mal bei t = *, im Punkt *.",
        "* touche * pour la première fois à t = *, en *.",
        "* toca a * por primera vez en t = *, en *.";
    /// A hit edge to edge: bodies, time, from where to where.
    HIT_ALONG: "* first touches * at t = *, from * to *.",
        "* berührt * zum ersten Mal bei t = *, von * bis *.",
        "* touche * pour la première fois à t = *, de * à *.",
        "* toca a * por primera vez en t = *, de * a *.";
    /// A hit at a place that is open: bodies, time.
    HIT_SOMEWHERE: "* first touches * at t = *.",
        "* berührt * zum ersten Mal bei t = *.",
        "* touche * pour la première fois à t = *.",
        "* toca a * por primera vez en t = *.";
    /// A miss, and how near it came.
    MISS: "* and * do not touch*.",
        "* und * berühren sich nicht*.",
        "* et * ne se touchent pas*.",
        "* y * no se tocan*.";
    /// Bodies that overlap at the start, and the push.
    OVERLAP_FIRST: "* and * overlap from the start; *.",
        "* und * überlappen sich von Anfang an; *.",
        "* et * se recouvrent dès le début ; *.",
        "* y * se solapan desde el principio; *.";
    /// Bodies that touch at the start.
    TOUCH_FIRST: "* and * touch from the start.",
        "* und * berühren sich von Anfang an.",
        "* et * se touchent dès le début.",
        "* y * se tocan desde el principio.";
    /// A question that stays open: bodies, until when they are apart, why.
    UNRESOLVED: "* and * are apart until t = *; whether they touch is undecided: *.",
        "* und * sind bis t = * getrennt; ob sie sich berühren, ist nicht entschieden: *.",
        "* et * sont séparés jusqu’à t = * ; on ne sait pas s’ils se touchent : *.",
        "* y * están separados hasta t = *; no se decide si se tocan: *.";
    /// Bodies that overlap at the end: bodies, until when they are apart, depth, why no time is known.
    UNRESOLVED_DEEP: "* and * are apart until t = * and overlap by * at t = 1; when they first touch is \
         undecided: *.",
        "* und * sind bis t = * getrennt und überlappen sich bei t = 1 um *; wann sie sich zuerst \
         berühren, ist nicht entschieden: *.",
        "* et * sont séparés jusqu’à t = * et se recouvrent de * à t = 1 ; l’instant du premier \
         contact n’est pas décidé : *.",
        "* y * están separados hasta t = * y se solapan en * en t = 1; no se decide cuándo se tocan: *.";
    /// The end alone: bodies, depth, why.
    DEEP: "* and * overlap by * at t = 1; when they first touch is undecided: *.",
        "* und * überlappen sich bei t = 1 um *; wann sie sich zuerst berühren, ist nicht entschieden: *.",
        "* et * se recouvrent de * à t = 1 ; l’instant du premier contact n’est pas décidé : *.",
        "* y * se solapan en * en t = 1; no se decide cuándo se tocan: *.";
    /// Nothing at all: bodies, why.
    UNDECIDED: "whether * and * touch is undecided: *.",
        "ob * und * sich berühren, ist nicht entschieden: *.",
        "on ne sait pas si * et * se touchent : *.",
        "no se decide si * y * se tocan: *.";
    /// Rounding.
    ROUNDING: "the rounding of their numbers leaves it open",
        "die Rundung ihrer Zahlen lässt es offen",
        "l’arrondi de leurs nombres ne le dit pas",
        "el redondeo de sus números lo deja abierto";
    /// The tolerance.
    TOLERANCE: "they come within the tolerance",
        "sie kommen sich bis auf die Toleranz nahe",
        "ils s’approchent à la tolérance près",
        "se acercan hasta la tolerancia";
    /// The most steps.
    STEP_CAP: "the step cap was reached",
        "die Höchstzahl der Schritte ist erreicht",
        "le nombre maximal d’étapes est atteint",
        "se alcanzó el máximo de pasos";
    /// Steps of no length.
    STALLED: "the steps no longer advanced",
        "die Schritte kamen nicht mehr voran",
        "les étapes n’avançaient plus",
        "los pasos ya no avanzaban";
    /// A distance that stays.
    STAY: "; they stay * apart",
        "; ihr Abstand bleibt *",
        " ; leur distance reste de *",
        "; su distancia sigue siendo *";
    /// A motion that ends too early: when, how far apart.
    ENDS_EARLY: "; the motion ends at t = * while they still come nearer, * apart",
        "; die Bewegung endet bei t = *, während sie sich noch nähern, mit Abstand *",
        " ; le mouvement finit à t = * alors qu’ils se rapprochent encore, à une distance de *",
        "; el movimiento acaba en t = * mientras aún se acercan, a una distancia de *";
    /// What is said more of a closest approach that may well be a touch.
    BY_ROUNDING: ", no more than the rounding of their numbers",
        ", nicht mehr als die Rundung ihrer Zahlen",
        ", pas plus que l’arrondi de leurs nombres",
        ", no más que el redondeo de sus números";
    /// Bodies that go away from each other.
    CLOSEST_FIRST: "; they are closest at the start, * apart",
        "; am nächsten sind sie sich am Anfang, mit Abstand *",
        " ; ils sont au plus près au début, à une distance de *",
        "; su menor distancia se da al principio: *";
    /// The closest approach: when, how far apart.
    CLOSEST: "; they come closest at t = *, * apart",
        "; am nächsten sind sie sich bei t = *, mit Abstand *",
        " ; ils sont au plus près à t = *, à une distance de *",
        "; su menor distancia se da en t = *: *";
    /// How near a miss is known to come, where a nearer moment may have been missed: how far apart, when, and
    /// what is proved.
    NO_NEARER_THAN: "; they come as near as * at t = *, and never nearer than *",
        "; sie kommen sich bis auf * nahe, bei t = *, und nie näher als *",
        " ; ils s’approchent jusqu’à *, à t = *, et jamais à moins de *",
        "; se acercan hasta *, en t = *, y nunca a menos de *";
    /// The closest approach, as near as which they come again: one moment of them, how far apart.
    CLOSEST_AGAIN: "; they come closest more than once, as at t = *, * apart",
        "; am nächsten sind sie sich mehrmals, so bei t = *, mit Abstand *",
        " ; ils sont au plus près plus d’une fois, comme à t = *, à une distance de *",
        "; su menor distancia se da más de una vez, como en t = *: *";
    /// Closest for a while: from when to when, how far apart.
    CLOSEST_WHILE: "; they are closest from t = * to t = *, * apart",
        "; am nächsten sind sie sich von t = * bis t = *, mit Abstand *",
        " ; ils sont au plus près de t = * à t = *, à une distance de *",
        "; su menor distancia se da de t = * a t = *: *";
    /// Bodies that the query is not about.
    BESIDE: "Beside, and asked nothing: *. ",
        "Daneben, ohne Frage: *. ",
        "À côté, sans question : *. ",
        "Al lado, sin pregunta: *. ";
    /// How the answer was found.
    FOUND: "Found by *. ", "Gefunden mit *. ", "Trouvé par *. ", "Hallado con *. ";
    /// How it was found in one step.
    FOUND_AT_ONCE: "Found by * in 1 step. ",
        "Gefunden mit * in 1 Schritt. ",
        "Trouvé par * en 1 étape. ",
        "Hallado con * en 1 paso. ";
    /// How it was found in several.
    FOUND_IN: "Found by * in * steps. ",
        "Gefunden mit * in * Schritten. ",
        "Trouvé par * en * étapes. ",
        "Hallado con * en * pasos. ";
    /// How it was found on B ⊖ A.
    FOUND_AMONG: "Found by * among the * edges of the Minkowski difference. ",
        "Gefunden mit * unter den * Kanten der Minkowski-Differenz. ",
        "Trouvé par * parmi les * arêtes de la différence de Minkowski. ",
        "Hallado con * entre las * aristas de la diferencia de Minkowski. ";
    /// One of several panels, and its title.
    PANEL: "Panel **", "Teilbild **", "Panneau **", "Panel **";
    /// The only one.
    PICTURE: "The picture*", "Das Bild*", "L’image*", "La imagen*";
    /// A panel without layers.
    EMPTY: "* shows nothing. ", "* zeigt nichts. ", "* ne montre rien. ", "* no muestra nada. ";
    /// A panel: which, its space, its moment, its layers.
    SHOWS: "* shows **: *", "* zeigt **: *", "* montre ** : *", "* muestra **: *";
    /// It has an inset.
    ENLARGED: "; with a detail enlarged. ",
        "; mit einem vergrößerten Detail. ",
        " ; avec un détail agrandi. ",
        "; con un detalle ampliado. ";
    /// The space of bodies.
    WORLD: "the world", "die Welt", "le monde", "el mundo";
    /// Numbers over time.
    CHART: "a chart", "ein Diagramm", "un graphique", "una gráfica";
    /// The space of B ⊖ A.
    CONFIGURATION: "configuration space",
        "den Konfigurationsraum",
        "l’espace des configurations",
        "el espacio de configuración";
    /// The frame of a body.
    FRAME: "the frame of *", "das System von *", "le repère de *", "el sistema de *";
    /// The frame of one that turns. The answer has told of directions before.
    TURNED_FRAME: "the frame of * (the answer's directions are the world's)",
        "das System von * (die Richtungen der Antwort sind die der Welt)",
        "le repère de * (les directions de la réponse sont celles du monde)",
        "el sistema de * (las direcciones de la respuesta son las del mundo)";
    /// A moment by its time.
    AT_TIME: " at t = *", " bei t = *", " à t = *", " en t = *";
    /// The first moment.
    AT_START: " at the start", " am Anfang", " au début", " al principio";
    /// The moment of the hit.
    AT_HIT: " at the first contact",
        " bei der ersten Berührung",
        " au premier contact",
        " en el primer contacto";
    /// The moment of the closest approach.
    AT_CLOSEST: " at the closest approach",
        " bei der größten Annäherung",
        " au plus près",
        " en el mayor acercamiento";
    /// The moment until which nothing can touch.
    AT_BOUND: " at the bound of the first step",
        " an der Schranke des ersten Schritts",
        " à la borne de la première étape",
        " en la cota del primer paso";
    /// The last moment.
    AT_END: " at the end", " am Ende", " à la fin", " al final";
    /// The moment of a step.
    IN_STEP: " in step *", " in Schritt *", " à l’étape *", " en el paso *";
    /// The title of an exercise that has none.
    QUESTION: "A question.", "Eine Aufgabe.", "Une question.", "Una pregunta.";
}
