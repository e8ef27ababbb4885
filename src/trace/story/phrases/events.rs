//! What is told of bodies that stand.

use crate::trace::tongue::{Phrase, phrase, phrases};

phrases! {
    /// An algorithm begins: its name, the bodies, the moment.
    STARTED: "* looks at * at *.",
        "* betrachtet * bei *.",
        "* examine * à *.",
        "* examina * en *.";
    /// It ends.
    FINISHED: "Done: *.", "Fertig: *.", "Fini : *.", "Listo: *.";
    /// The early-out of circles: distance, its square, the sign, both radii, their square, what follows.
    SQUARES: "Centres and radii, squared: *² = * * *² = (* + *)² = **.",
        "Mittelpunkte und Radien im Quadrat: *² = * * *² = (* + *)² = **.",
        "Centres et rayons, au carré : *² = * * *² = (* + *)² = **.",
        "Centros y radios, al cuadrado: *² = * * *² = (* + *)² = **.";
    /// The squares are enough.
    SETTLED: "; that settles it, without a root",
        "; das entscheidet, ohne Wurzel",
        " ; cela suffit, sans racine",
        "; con eso basta, sin raíz";
    /// The penetration of circles: centres, p, N, from, to, P.
    PENETRATION: "p = * * * = *, N = * from * to *, P = N p = *.",
        "p = * * * = *; N = * von * nach *; P = N p = *.",
        "p = * * * = * ; N = * de * vers * ; P = N p = *.",
        "p = * * * = *; N = * de * a *; P = N p = *.";
    /// A bounding box: whose, from, to.
    BOX: "The box of * runs from * to *",
        "Die Bounding-Box von * reicht von * bis *",
        "La boîte englobante de * va de * à *",
        "La caja envolvente de * va de * a *";
    /// The box of both bodies.
    TOGETHER: "* together", "* zusammen", "* ensemble", "* juntos";
    /// What is on its left.
    LEFT: "left", "links", "à gauche", "a la izquierda";
    /// What is at its bottom.
    BOTTOM: "bottom", "unten", "en bas", "abajo";
    /// What is on its right.
    RIGHT: "right", "rechts", "à droite", "a la derecha";
    /// What is at its top.
    TOP: "top", "oben", "en haut", "arriba";
    /// A circle's centre in the frame of a box: whose, V, what it is clamped to, by what, the closest point,
    /// D, the sign of its length, and the distance.
    CLAMPED: "In *'s frame V = *, clamped to * by the half-extents *. In the world the closest point is *, \
         with D = * from there, and *|D| * r = *.",
        "Im System von * ist V = *, auf * begrenzt durch die halben Ausdehnungen *. In der Welt ist der \
         nächste Punkt *, mit D = * von dort, und *|D| * r = *.",
        "Dans le repère de * : V = *, borné à * par les demi-étendues *. Dans le monde, le point le plus \
         proche est *, avec D = * de là, et *|D| * r = *.",
        "En el sistema de *: V = *, limitado a * por las semiextensiones *. En el mundo el punto más cercano \
         es *, con D = * desde ahí, y *|D| * r = *.";
    /// A circle's centre inside a box, in the frame of that: whose, V, the half-extents, the closest point of
    /// the outline, D, what subtracts, twice, and the distance.
    CLAMPED_INSIDE: "In *'s frame V = *, within the half-extents *: the centre is inside. In the world the \
         closest point of the outline is *, with D = * from there, and *|D| * r = *.",
        "Im System von * ist V = *, innerhalb der halben Ausdehnungen *: Der Mittelpunkt liegt darin. In der \
         Welt ist der nächste Punkt des Umrisses *, mit D = * von dort, und *|D| * r = *.",
        "Dans le repère de * : V = *, dans les demi-étendues * : le centre est à l’intérieur. Dans le monde, \
         le point le plus proche du contour est *, avec D = * de là, et *|D| * r = *.",
        "En el sistema de *: V = *, dentro de las semiextensiones *: el centro está dentro. En el mundo el \
         punto más cercano del contorno es *, con D = * desde ahí, y *|D| * r = *.";
    /// The farthest vertices of a body: direction, body, vertices, a tie.
    SUPPORT: "Farthest along * on *: **.",
        "Am weitesten entlang * auf *: **.",
        "Le plus loin le long de * sur * : **.",
        "Lo más lejano a lo largo de * en *: **.";
    /// Several are as far.
    TIE: ", a tie", ", gleichauf", ", à égalité", ", empatados";
    /// An edge of B ⊖ A: edge, body, vertex, the other body, from, to, of what, and where the origin is.
    DIFFERENCE_EDGE: "Edge * of * with vertex * of * is the edge from * to * of *; the origin is * its line.",
        "Kante * von * mit Ecke * von * ist die Kante von * bis * von *; der Ursprung liegt * ihrer Geraden.",
        "L’arête * de * avec le sommet * de * est l’arête de * à * de * ; l’origine est * de sa droite.",
        "La arista * de * con el vértice * de * es la arista de * a * de *; el origen está * de su recta.";
    /// An edge of B ⊖ A with a circle: edge, body, the circle, from, to, of what, and where the origin is.
    DIFFERENCE_EDGE_OF_CENTER:
        "Edge * of * with the centre of * is the edge from * to * of *; the origin is * its line.",
        "Kante * von * mit der Mitte von * ist Kante von * bis * von *; der Ursprung liegt * ihrer Geraden.",
        "L’arête * de * avec le centre de * est l’arête de * à * de * ; l’origine est * de sa droite.",
        "La arista * de * con el centro de * es la arista de * a * de *; el origen está * de su recta.";
    /// B ⊖ A of the cores of round bodies.
    WITHOUT_RADII: "* without the radii", "* ohne die Radien", "* sans les rayons", "* sin los radios";
    /// The next edge of a merge: edge, body, why.
    MERGED: "Next the edge * of *: *.",
        "Als Nächstes die Kante * von *: *.",
        "Ensuite l’arête * de * : *.",
        "Ahora la arista * de *: *.";
    /// The other body has none left.
    NO_MORE: "* has no more", "* hat keine mehr", "* n’en a plus", "* no tiene más";
    /// The other body's next one comes later: body, edge.
    TURNS_MORE: "*'s next, *, turns more",
        "die nächste von *, *, ist weiter gedreht",
        "la suivante de *, *, est plus tournée",
        "la siguiente de *, *, está más girada";
    /// The difference of two circles: what, its radius, its centre.
    DISC: "* is a disc of radius * around *.",
        "* ist eine Scheibe vom Radius * um *.",
        "* est un disque de rayon * autour de *.",
        "* es un disco de radio * alrededor de *.";
    /// The difference of bodies of which one is round.
    ROUNDED: "* is rounded by a radius of *.",
        "* ist mit einem Radius von * abgerundet.",
        "* a des coins arrondis d’un rayon de *.",
        "* tiene esquinas redondeadas con un radio de *.";
    /// The point of an edge that is nearest to the origin, and how far the origin is from there.
    PROJECTED: "Nearest to the origin is *, *.",
        "Dem Ursprung am nächsten ist *, *.",
        "Le plus proche de l’origine est *, *.",
        "Lo más cercano al origen es *, *.";
    /// The best edge so far of those that the origin is inside of: distance, place, edge, body.
    LEAST_PENETRATING: "Least depth so far, if the origin is inside: * at *, by * of *.",
        "Bisher kleinste Tiefe, falls der Ursprung innen liegt: * bei *, durch * von *.",
        "Moindre profondeur jusqu’ici, si l’origine est à l’intérieur : * en * (* de *).",
        "Menor profundidad hasta ahora, si el origen está dentro: * en * (* de *).";
    /// The best one so far of those that it is outside of.
    LEAST_POSITIVE: "Least distance so far: * at *, by * of *.",
        "Bisher kleinster Abstand: * bei *, durch * von *.",
        "Moindre distance jusqu’ici : * en * (* de *).",
        "Menor distancia hasta ahora: * en * (* de *).";
    /// What a search by simplexes found of bodies without radii: distance, of what, place, part, body.
    DISTANCE_IS: "The distance is *, from the origin to * at *, by * of *.",
        "Der Abstand ist *, vom Ursprung zu * bei *, durch * von *.",
        "La distance est *, de l’origine à * en * (* de *).",
        "La distancia es *, del origen a * en * (* de *).";
    /// Its distance of bodies with radii.
    LESS_RADII: "Less the radii the distance is *, at *, by * of *.",
        "Abzüglich der Radien ist der Abstand *, bei *, durch * von *.",
        "Rayons déduits, la distance est *, en * (* de *).",
        "Descontados los radios, la distancia es *, en * (* de *).";
    /// What it found of bodies that overlap, without radii: depth, of what, place, edge, body.
    DEPTH_IS: "The depth is *, from the origin to the outline of * at *, by * of *.",
        "Die Tiefe ist *, vom Ursprung zum Umriss von * bei *, durch * von *.",
        "La profondeur est *, de l’origine au contour de * en * (* de *).",
        "La profundidad es *, del origen al contorno de * en * (* de *).";
    /// Its depth of bodies with radii.
    WITH_RADII: "With the radii the depth is *, at *, by * of *.",
        "Mit den Radien ist die Tiefe *, bei *, durch * von *.",
        "Avec les rayons, la profondeur est *, en * (* de *).",
        "Con los radios, la profundidad es *, en * (* de *).";
    /// What the axes say of bodies that are apart: distance, edge or vertex, body.
    LARGEST_GAP: "The largest gap is the distance: *, by * of *.",
        "Die größte Lücke ist der Abstand: *, durch * von *.",
        "Le plus grand écart est la distance : * (* de *).",
        "El mayor hueco es la distancia: * (* de *).";
    /// What they say of bodies that overlap.
    LEAST_OVERLAP: "The least overlap is the depth: *, by * of *.",
        "Die kleinste Überlappung ist die Tiefe: *, durch * von *.",
        "Le plus petit recouvrement est la profondeur : * (* de *).",
        "El menor solapamiento es la profundidad: * (* de *).";
    /// Both bodies along an axis: the axis, whose normal of which body, a body and its interval, the other
    /// one and its, and what lies between.
    AXIS: "Along *, the normal of * of *: * spans *, * spans *, *.",
        "Entlang *, der Normalen von * von *: * reicht von *, * von *; *.",
        "Le long de *, normale (* de *) : * va de *, * va de * ; *.",
        "A lo largo de *, normal (* de *): * va de *, * va de *; *.";
    /// Both bodies along an axis of the second one, which points into its edge.
    AXIS_INTO: "Along *, against the normal of * of *: * spans *, * spans *, *.",
        "Entlang *, entgegen der Normalen von * von *: * reicht von *, * von *; *.",
        "Le long de *, à l’opposé de la normale (* de *) : * va de *, * va de * ; *.",
        "A lo largo de *, en contra de la normal (* de *): * va de *, * va de *; *.";
    /// Both bodies along the way from a vertex to the nearest point of the other one: the axis, which vertex
    /// of which body, a body and its interval, the other one and its, and what lies between.
    AXIS_FROM: "Along *, from * of * to the nearest point: * spans *, * spans *, *.",
        "Entlang *, von * von * zum nächsten Punkt: * reicht von *, * von *; *.",
        "Le long de *, vers le point le plus proche (* de *) : * va de *, * va de * ; *.",
        "A lo largo de *, hacia el punto más cercano (* de *): * va de *, * va de *; *.";
    /// They are apart there.
    GAP: "a gap of *", "eine Lücke von *", "un écart de *", "un hueco de *";
    /// They are not: the second body, by how much, the first one.
    OVERLAP: "where * begins * before * ends",
        "* beginnt * vor dem Ende von *",
        "* commence * avant la fin de *",
        "* empieza * antes del final de *";
    /// They are apart the other way round: the second body, the first one.
    BEHIND: "with all of * behind *: no gap this way",
        "* liegt ganz hinter *: in dieser Richtung keine Lücke",
        "* est tout entier derrière * : pas d’écart dans ce sens",
        "todo * queda detrás de *: ningún hueco en este sentido";
    /// The separating axis, and how far apart.
    SEPARATED: "* separates them by *: no need to look further.",
        "* trennt sie um *: Weiter braucht man nicht zu suchen.",
        "* les sépare de * : inutile de chercher plus loin.",
        "* los separa por *: no hace falta buscar más.";
    /// A simplex: vertices, the point closest to the origin, where to look next.
    SIMPLEX: "The simplex is *; closest to the origin is *, so look along *.",
        "Das Simplex ist *; dem Ursprung am nächsten liegt *, also weiter entlang *.",
        "Le simplexe est * ; le plus proche de l’origine est *, on cherche donc le long de *.",
        "El símplex es *; lo más cercano al origen es *, así que se busca a lo largo de *.";
    /// A simplex as before, and the vertex that is farthest there: vertices, the point closest to the origin,
    /// where to look, what is found there.
    SIMPLEX_GROWS: "The simplex is *; closest to the origin is *, so look along *: farthest there is *.",
        "Das Simplex ist *; dem Ursprung am nächsten liegt *, also weiter entlang *: am weitesten dort \
            liegt *.",
        "Le simplexe est * ; le plus proche de l’origine est *, on cherche donc le long de * : le plus loin \
            y est *.",
        "El símplex es *; lo más cercano al origen es *, así que se busca a lo largo de *: lo más lejano \
            allí es *.";
    /// The last simplex outside the origin: vertices, the point closest to the origin, where nothing is.
    SIMPLEX_ENDS: "The simplex is *; closest to the origin is *, and nothing is farther along *: the search \
            ends.",
        "Das Simplex ist *; dem Ursprung am nächsten liegt *, und weiter entlang * liegt nichts: Die Suche \
            endet.",
        "Le simplexe est * ; le plus proche de l’origine est *, et rien n’est plus loin le long de * : la \
            recherche s’arrête.",
        "El símplex es *; lo más cercano al origen es *, y nada está más lejos a lo largo de *: la búsqueda \
            termina.";
    /// A simplex around the origin, or through it: vertices.
    SIMPLEX_HOLDS: "The simplex is *; the origin is in it.",
        "Das Simplex ist *; der Ursprung liegt darin.",
        "Le simplexe est * ; l’origine est dedans.",
        "El símplex es *; el origen está dentro.";
    /// What goes before the first polytope where its simplex is not told.
    HELD: "A simplex of the search holds the origin; the polytope grows from it.",
        "Ein Simplex der Suche enthält den Ursprung; daraus wächst das Polytop.",
        "Un simplexe de la recherche contient l’origine ; le polytope en part.",
        "Un símplex de la búsqueda contiene el origen; de él parte el politopo.";
    /// A polytope: count, vertices, how near its nearest edge is, along what, and what is beyond.
    POLYTOPE: "The polytope has * vertices, *; its nearest edge is * from the origin along *; *.",
        "Das Polytop hat * Ecken, *; seine nächste Kante ist * vom Ursprung entfernt, entlang *; *.",
        "Le polytope a * sommets, * ; son arête la plus proche est à * de l’origine le long de * ; *.",
        "El politopo tiene * vértices, *; su arista más cercana está a * del origen a lo largo de *; *.";
    /// A polytope that has grown by the vertices that were told before: count, how near its nearest edge is,
    /// along what, and what is beyond.
    POLYTOPE_GROWN: "The polytope has * vertices; its nearest edge is * from the origin along *; *.",
        "Das Polytop hat * Ecken; seine nächste Kante ist * vom Ursprung entfernt, entlang *; *.",
        "Le polytope a * sommets ; son arête la plus proche est à * de l’origine le long de * ; *.",
        "El politopo tiene * vértices; su arista más cercana está a * del origen a lo largo de *; *.";
    /// A vertex lies beyond: which, by how much.
    SPLITS: "farthest there is *, * beyond it: it splits the edge",
        "am weitesten dort liegt *, um * dahinter: Sie teilt die Kante",
        "le plus loin y est *, à * au-delà : il divise l’arête",
        "lo más lejano allí es *, * más allá: divide la arista";
    /// None does.
    WAY_OUT: "no vertex is beyond it: it is the way out",
        "keine Ecke liegt dahinter: Das ist der Weg hinaus",
        "aucun sommet n’est au-delà : c’est par là qu’on sort",
        "ningún vértice está más allá: es la salida";
    /// None does, and it passes through the origin.
    NO_FARTHER: "no vertex is beyond it",
        "keine Ecke liegt dahinter",
        "aucun sommet n’est au-delà",
        "ningún vértice está más allá";
    /// The edges that face each other: part, body, from, to, outward normal, the other part and body.
    FACED: "Reference: * of *, * to *, outward normal n = *; incident: * of *.",
        "Referenz: * von *, * bis *, Normale nach außen n = *; auftreffend: * von *.",
        "Référence : * de *, * à *, normale sortante n = * ; incidente : * de *.",
        "Referencia: * de *, * a *, normal hacia fuera n = *; incidente: * de *.";
    /// What a plane cut off: where the plane is, the end, where that is now.
    CUT: "The plane at * cuts off the end *: the edge now ends at *.",
        "Die Ebene bei * schneidet das Ende * ab: Die Kante endet nun bei *.",
        "Le plan en * coupe le bout * : l’arête finit alors en *.",
        "El plano en * corta el extremo *: la arista acaba ahora en *.";
    /// A point of each body.
    OVER: "* of * and * of *", "* von * und * von *", "* de * et * de *", "* de * y * de *";
    /// A contact: places, depth.
    CONTACT: "Contact: *, * deep.",
        "Kontakt: *, * tief.",
        "Contact : *, profondeur *.",
        "Contacto: *, profundidad *.";
    /// No contact: places, gap.
    NO_CONTACT: "No contact: *, * apart.",
        "Kein Kontakt: *, * entfernt.",
        "Pas de contact : *, distance *.",
        "Sin contacto: *, distancia *.";
    /// All edges of B ⊖ A: what, how many, the vertices.
    OUTLINE: "* has * edges, from vertex to vertex: *.",
        "* hat * Kanten, von Ecke zu Ecke: *.",
        "* a * arêtes, de sommet en sommet : *.",
        "* tiene * aristas, de vértice a vértice: *.";
    /// How many they are.
    EDGES: "* has * edges.", "* hat * Kanten.", "* a * arêtes.", "* tiene * aristas.";
    /// How many they are that are drawn for a reader alone.
    UNBUILT: "* has * edges; the algorithm does not build it.",
        "* hat * Kanten; der Algorithmus bildet sie nicht.",
        "* a * arêtes ; l’algorithme ne forme pas cette différence.",
        "* tiene * aristas; el algoritmo no forma esta diferencia.";
    /// The nearest of them: edge, body, how far, where.
    NEAREST: "Nearest to the origin is * of *: * away, at *.",
        "Dem Ursprung am nächsten ist * von *: * entfernt, bei *.",
        "Le plus près de l’origine : * de *, à une distance de *, en *.",
        "Lo más cercano al origen es * de *: a una distancia de *, en *.";
    /// The one that the origin is least inside of.
    LEAST_DEEP: "The origin is inside all its edges, least deep at * of *: by *, at *.",
        "Der Ursprung liegt innerhalb aller Kanten, am wenigsten tief bei * von *: um *, bei *.",
        "L’origine est à l’intérieur de toutes les arêtes, le moins pour * de * : de *, en *.",
        "El origen está dentro de todas las aristas, lo menos hondo en * de *: *, en *.";
}

/// How an algorithm says that it ended: as events have it, then in the other languages.
pub(crate) static OUTCOMES: [Phrase; 8] = [
    phrase(["overlapping", "überlappend", "recouvrement", "solapados"]),
    phrase(["separating axis", "Trennachse", "axe séparateur", "eje separador"]),
    phrase(["apart", "getrennt", "séparés", "separados"]),
    phrase(["undecided", "unentschieden", "indécis", "sin decidir"]),
    phrase(["touching", "in Berührung", "en contact", "en contacto"]),
    phrase(["hit", "Treffer", "impact", "contacto"]),
    phrase(["miss", "kein Treffer", "pas de contact", "sin contacto"]),
    phrase(["unresolved", "ungeklärt", "non résolu", "sin resolver"]),
];
