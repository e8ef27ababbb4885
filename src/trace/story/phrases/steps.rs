//! What steps of a figure are called, and what the parts of an event say.

use crate::trace::tongue::phrases;

phrases! {
    /// How the bodies stand at a moment.
    AT: "At t = *", "Bei t = *", "À t = *", "En t = *";
    /// The first step.
    QUESTION: "The question", "Die Frage", "La question", "La pregunta";
    /// The early-out of circles.
    SQUARES: "Centres and radii", "Mittelpunkte und Radien", "Centres et rayons", "Centros y radios";
    /// Their penetration.
    PENETRATION: "The penetration", "Das Eindringen", "La pénétration", "La penetración";
    /// A bounding box.
    BOX: "The box", "Die Bounding-Box", "La boîte englobante", "La caja envolvente";
    /// Its centre.
    CENTER: "Centre and half-extents",
        "Mittelpunkt und halbe Ausdehnungen",
        "Centre et demi-étendues",
        "Centro y semiextensiones";
    /// What touches it on the left.
    LEFTMOST: "Leftmost", "Ganz links", "Le plus à gauche", "Lo más a la izquierda";
    /// Below.
    LOWEST: "Lowest", "Ganz unten", "Le plus bas", "Lo más bajo";
    /// On the right.
    RIGHTMOST: "Rightmost", "Ganz rechts", "Le plus à droite", "Lo más a la derecha";
    /// Above.
    HIGHEST: "Highest", "Ganz oben", "Le plus haut", "Lo más alto";
    /// The extents of two boxes.
    EXTENTS: "The extents", "Die Ausdehnungen", "Les étendues", "Las extensiones";
    /// V of a circle and a box.
    WAY: "From centre to centre", "Von Mitte zu Mitte", "De centre à centre", "De centro a centro";
    /// What is left of it.
    CLAMPED: "Cut to the half-extents",
        "Auf die halben Ausdehnungen begrenzt",
        "Borné aux demi-étendues",
        "Limitado a las semiextensiones";
    /// Nothing is cut off it: the centre is inside.
    WITHIN: "Within the half-extents",
        "Innerhalb der halben Ausdehnungen",
        "Dans les demi-étendues",
        "Dentro de las semiextensiones";
    /// Where it leads.
    CLOSEST_POINT: "The closest point",
        "Der nächste Punkt",
        "Le point le plus proche",
        "El punto más cercano";
    /// A support.
    FARTHEST: "The farthest vertex", "Die fernste Ecke", "Le sommet le plus éloigné", "El vértice más lejano";
    /// An edge of B ⊖ A: index, body.
    EDGE_OF: "Edge * of *", "Kante * von *", "Arête * de *", "Arista * de *";
    /// One that a merge takes: its place in the order of directions, index, body.
    TAKEN: "*: edge * of *", "*: Kante * von *", "* : arête * de *", "*: arista * de *";
    /// The next one of a merge.
    AN_EDGE_OF: "An edge of *", "Eine Kante von *", "Une arête de *", "Una arista de *";
    /// Where the origin projects to.
    NEAREST_POINT: "The nearest point",
        "Der nächste Punkt",
        "Le point le plus proche",
        "El punto más cercano";
    /// The best edge so far.
    LEAST: "The least distance", "Der kleinste Abstand", "La plus petite distance", "La menor distancia";
    /// The one so far that the origin is least inside of.
    LEAST_DEPTH: "The least depth", "Die kleinste Tiefe", "La plus petite profondeur", "La menor profundidad";
    /// An axis that is tested: edge, body.
    NORMAL_OF: "The normal of * of *", "Die Normale von * von *", "Normale : * de *", "Normal: * de *";
    /// One that leads away from a vertex: vertex, body.
    AWAY_FROM: "From * of *", "Von * von * aus", "À partir de * de *", "Desde * de *";
    /// One that separates.
    SEPARATING: "A separating axis", "Eine Trennachse", "Un axe séparateur", "Un eje separador";
    /// A simplex of one vertex.
    A_VERTEX: "A vertex", "Eine Ecke", "Un sommet", "Un vértice";
    /// A simplex of two.
    AN_EDGE: "An edge", "Eine Kante", "Une arête", "Una arista";
    /// A simplex of three.
    A_TRIANGLE: "A triangle", "Ein Dreieck", "Un triangle", "Un triángulo";
    /// It holds the origin.
    HOLDS: "* that holds the origin",
        "*: enthält den Ursprung",
        "* : contient l’origine",
        "*: contiene el origen";
    /// It does not: what, how far.
    AT_MOST: "*: at most * away",
        "*: höchstens * entfernt",
        "* : distance d’au plus *",
        "*: a una distancia de * a lo sumo";
    /// A polytope: how deep.
    AT_LEAST: "A polytope: at least * deep",
        "Ein Polytop: mindestens * tief",
        "Un polytope : profondeur d’au moins *",
        "Un politopo: profundidad de al menos *";
    /// A ray against an edge, or a vertex of round bodies: which, body.
    RAY: "The ray against * of *", "Der Strahl: * von *", "Le rayon : * de *", "El rayo: * de *";
    /// Edges that it passes over.
    AWAY: "What faces away", "Was abgewandt ist", "Ce qui tourne le dos", "Lo que da la espalda";
    /// The first part of a step.
    HOW_FAR: "Step *: how far apart",
        "Schritt *: wie weit entfernt",
        "Étape * : à quelle distance",
        "Paso *: a qué distancia";
    /// The second one.
    HOW_SAFE: "Step *: how far it is safe",
        "Schritt *: wie weit es sicher ist",
        "Étape * : jusqu’où c’est sûr",
        "Paso *: hasta dónde es seguro";
    /// A swept axis.
    SWEPT: "An axis that parts them",
        "Eine Achse, die sie trennt",
        "Un axe qui les sépare",
        "Un eje que los separa";
    /// The closest approach.
    CLOSEST: "The closest approach", "Die größte Annäherung", "Au plus près", "El mayor acercamiento";
    /// Another's answer.
    EXPECTED: "What was expected", "Das Erwartete", "Ce qui était attendu", "Lo esperado";
    /// The arc of a turn.
    ARC: "Its arc", "Ihr Bogen", "Son arc", "Su arco";
    /// The bound on it.
    BOUND: "The bound", "Die Schranke", "La borne", "La cota";
    /// The edges of a contact.
    FACED: "The edges that face",
        "Die Kanten, die sich gegenüberliegen",
        "Les arêtes face à face",
        "Las aristas enfrentadas";
    /// An end that was cut off.
    CUT: "Cut off", "Abgeschnitten", "Coupé", "Recortado";
    /// A point of contact.
    CONTACT: "A point of contact", "Ein Kontaktpunkt", "Un point de contact", "Un punto de contacto";
    /// A point between the planes that does not touch.
    NO_CONTACT: "A point without contact",
        "Ein Punkt ohne Kontakt",
        "Un point sans contact",
        "Un punto sin contacto";
    /// The last step.
    ANSWER: "The answer", "Die Antwort", "La réponse", "La respuesta";
    /// V: from which body, to which, V, in whose frame.
    LEADS: "V leads from the centre of * to that of *: * in *'s frame.",
        "V führt vom Mittelpunkt von * zu dem von *: * im System von *.",
        "V mène du centre de * à celui de * : * dans le repère de *.",
        "V va del centro de * al de *: * en el sistema de *.";
    /// What is left of it: half-extents, V clamped.
    CUT_DOWN: "The half-extents * cut it down to *.",
        "Die halben Ausdehnungen * begrenzen es auf *.",
        "Les demi-étendues * le bornent à *.",
        "Las semiextensiones * lo limitan a *.";
    /// V that they leave as it is: half-extents, the circle, the box.
    IS_WITHIN: "It is within the half-extents *: the centre of * is inside *.",
        "Es liegt innerhalb der halben Ausdehnungen *: Der Mittelpunkt von * liegt in *.",
        "Il est dans les demi-étendues * : le centre de * est à l’intérieur de *.",
        "Está dentro de las semiextensiones *: el centro de * está dentro de *.";
    /// From where the nearest side is left: point, body, D.
    NEAREST_SIDE: "The point of the nearest side is * of *; from there D = *.",
        "Der Punkt der nächsten Seite ist * von *; von dort ist D = *.",
        "Le point du côté le plus proche est * de * ; de là, D = *.",
        "El punto del lado más cercano es * de *; desde ahí D = *.";
    /// Where that leads: point, body, the other body, D.
    LEADS_TO: "In the world that leads to *, the point of * closest to *; from there D = *.",
        "In der Welt führt das zu *, dem Punkt von *, der * am nächsten liegt; von dort ist D = *.",
        "Dans le monde, cela mène à *, le point de * le plus proche de * ; de là, D = *.",
        "En el mundo eso lleva a *, el punto de * más cercano a *; desde ahí D = *.";
    /// The farthest vertex of a body that turns: body, radius, vertex.
    FARTHEST_BY: "Farthest from the origin of *, at r = *: *.",
        "Am weitesten vom Ursprung von * entfernt, mit r = *: *.",
        "Le plus loin de l’origine de *, à r = * : *.",
        "Lo más lejano del origen de *, a r = *: *.";
    /// The angle of its turn.
    TURNS: "* turns by θ = * rad.",
        "* dreht sich um θ = * rad.",
        "* tourne de θ = * rad.",
        "* gira θ = * rad.";
    /// It has none.
    TURNS_NOT: "* does not turn.", "* dreht sich nicht.", "* ne tourne pas.", "* no gira.";
    /// The bound on its turn.
    NO_FARTHER: "Turning moves no point of * farther than L = θ r = *.",
        "Die Drehung bewegt keinen Punkt von * weiter als L = θ r = *.",
        "La rotation ne déplace aucun point de * de plus de L = θ r = *.",
        "Ningún punto de * se desplaza al girar más que L = θ r = *.";
    /// A step of an advancement: separation, normal.
    APART: "They are * apart along *.",
        "Sie sind * voneinander entfernt, entlang *.",
        "Ils sont à une distance de * le long de *.",
        "Están a * a lo largo de *.";
    /// How deep they are in each other at a step: depth, normal.
    OVERLAP: "They overlap by * along *.",
        "Sie überlappen sich um * entlang *.",
        "Ils se recouvrent de * le long de *.",
        "Se solapan en * a lo largo de *.";
    /// How far it is safe: speed, bound, time.
    CLOSE_IN: "They close in at **: nothing touches before t = *.",
        "Sie nähern sich mit **: Nichts berührt sich vor t = *.",
        "Ils se rapprochent à une vitesse de ** : rien ne se touche avant t = *.",
        "Se acercan a una velocidad de **: nada se toca antes de t = *.";
    /// How far it is safe where only their turning brings them nearer: bound, time.
    TURN_IN: "They come nearer by turning alone, at most at *: nothing touches before t = *.",
        "Nur ihre Drehung nähert sie, höchstens mit *: Nichts berührt sich vor t = *.",
        "Seule la rotation les rapproche, à une vitesse d’au plus * : rien ne se touche avant t = *.",
        "Solo el giro los acerca, a una velocidad de a lo sumo *: nada se toca antes de t = *.";
    /// Nothing touches until the end: bound, when it might.
    PAST_THE_END: "They come nearer at * at most: nothing touches before t = *, after the end.",
        "Sie nähern sich höchstens mit *: Nichts berührt sich vor t = *, nach dem Ende.",
        "Ils se rapprochent à une vitesse d’au plus * : rien ne se touche avant t = *, après la fin.",
        "Se acercan a una velocidad de a lo sumo *: nada se toca antes de t = *, después del final.";
    /// They come no nearer.
    NO_NEARER: "They come no nearer.",
        "Sie nähern sich nicht mehr.",
        "Ils ne se rapprochent plus.",
        "Ya no se acercan.";
    /// Why an advancement ends: the tolerance.
    WITHIN_TOLERANCE: "That is no more than the tolerance *: it stops here.",
        "Das ist nicht mehr als die Toleranz *: Hier ist Schluss.",
        "Ce n’est pas plus que la tolérance * : fin des étapes.",
        "No es más que la tolerancia *: aquí se detiene.";
    /// Steps that are not shown: how many.
    LEFT_OUT: "Steps in between: *.",
        "Schritte dazwischen: *.",
        "Étapes entre les deux : *.",
        "Pasos intermedios: *.";
    /// No step follows.
    STOPS: "It stops here.", "Hier ist Schluss.", "Fin des étapes.", "Aquí se detiene.";
    /// No axis before has less overlap.
    LESS_SO_FAR: "It is the least overlap so far.",
        "Das ist die bisher kleinste Überlappung.",
        "C’est le plus petit recouvrement jusqu’ici.",
        "Es el menor solapamiento hasta ahora.";
    /// One before has: how much, edge or vertex, body.
    STILL_LEAST: "The least overlap so far remains *, by * of *.",
        "Die bisher kleinste Überlappung bleibt *, durch * von *.",
        "Le plus petit recouvrement jusqu’ici reste * (* de *).",
        "El menor solapamiento hasta ahora sigue siendo * (* de *).";
    /// No axis before has a larger gap.
    MORE_SO_FAR: "It is the largest gap so far.",
        "Das ist die bisher größte Lücke.",
        "C’est le plus grand écart jusqu’ici.",
        "Es el mayor hueco hasta ahora.";
    /// One before has: how large, edge or vertex, body.
    STILL_LARGEST: "The largest gap so far remains *, by * of *.",
        "Die bisher größte Lücke bleibt *, durch * von *.",
        "Le plus grand écart jusqu’ici reste * (* de *).",
        "El mayor hueco hasta ahora sigue siendo * (* de *).";
    /// The vertex on the left: body, vertex.
    IS_LEFTMOST: "The leftmost of * is *.",
        "Ganz links in * liegt *.",
        "Le plus à gauche, dans * : *.",
        "Lo más a la izquierda en *: *.";
    /// Below.
    IS_LOWEST: "The lowest of * is *.",
        "Ganz unten in * liegt *.",
        "Le plus bas, dans * : *.",
        "Lo más bajo en *: *.";
    /// On the right.
    IS_RIGHTMOST: "The rightmost of * is *.",
        "Ganz rechts in * liegt *.",
        "Le plus à droite, dans * : *.",
        "Lo más a la derecha en *: *.";
    /// Above.
    IS_HIGHEST: "The highest of * is *.",
        "Ganz oben in * liegt *.",
        "Le plus haut, dans * : *.",
        "Lo más alto en *: *.";
    /// The centre and the half-extents of a box.
    CENTER_IS: "Its centre is *, its half-extents are *.",
        "Der Mittelpunkt ist *, die halben Ausdehnungen sind *.",
        "Son centre est *, ses demi-étendues sont *.",
        "Su centro es *, sus semiextensiones son *.";
    /// The box.
    BOX_RUNS: "The box runs from * to *.",
        "Die Bounding-Box reicht von * bis *.",
        "La boîte englobante va de * à *.",
        "La caja envolvente va de * a *.";
    /// There is no vertex.
    NO_VERTEX: "no vertex", "keine Ecke", "aucun sommet", "ningún vértice";
    /// There are others as far.
    AMONG_OTHERS: "*, among others", "*, unter anderen", "*, entre autres", "*, entre otros";
    /// A polytope at the beginning.
    AROUND: "A polytope of * vertices",
        "Ein Polytop mit * Ecken",
        "Un polytope de * sommets",
        "Un politopo de * vértices";
    /// A simplex of one vertex at the beginning.
    BEGIN_AT: "Begin at *", "Beginn bei *", "Début en *", "Comienzo en *";
    /// A simplex of several.
    BEGIN_WITH: "Begin with * vertices",
        "Beginn mit * Ecken",
        "Début avec * sommets",
        "Comienzo con * vértices";
    /// The search ends.
    NONE_BEYOND: "*: no vertex is beyond",
        "*: keine Ecke liegt dahinter",
        "* : aucun sommet au-delà",
        "*: ningún vértice más allá";
    /// A vertex that came.
    ADD: "add *", "hinzu kommt *", "ajouter *", "añadir *";
    /// One that went.
    DROP: "drop *", "weg fällt *", "retirer *", "quitar *";
    /// None.
    NOTHING_NEW: "Nothing new", "Nichts Neues", "Rien de neuf", "Nada nuevo";
}
