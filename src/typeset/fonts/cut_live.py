"""Cuts a face to what most live figures set; a page whose figure sets more brings the whole face along.

Every glyph keeps its number, which stands in pictures, and every table that lays out says what it said; what goes is the
outlines of all others.
"""
import sys
from io import BytesIO
from fontTools import subset
from fontTools.misc.psCharStrings import T2CharString
from fontTools.ttLib import TTFont
from fontTools.ttLib.tables.DefaultTable import DefaultTable

# Letters, digits and signs of English, German, French and Spanish; raised and lowered digits; what our words say.
WORDS = [(0x20, 0x7E), (0xA0, 0xFF), (0x152, 0x153), (0x2010, 0x2014), (0x2018, 0x201E), (0x2026, 0x2026), (0x202F, 0x202F),
         (0x2032, 0x2033), (0x2070, 0x208E), (0x394, 0x394), (0x2190, 0x2193), (0x2212, 0x2212), (0x221E, 0x221E),
         (0x2248, 0x2248), (0x2260, 0x2260), (0x2264, 0x2265), (0x25A0, 0x25CF), (0x2713, 0x2713)]
# What is typed in formulas: accents, Greek, upright bold, italic and slanted Greek letters, operators of geometry.
FORMULAS = [(0x20, 0x7E), (0xA0, 0xA0), (0xB0, 0xB1), (0xB7, 0xB7), (0xD7, 0xD7), (0x300, 0x308), (0x30C, 0x30C),
            (0x2000, 0x200A), (0x2018, 0x201E), (0x202F, 0x202F),
            (0x391, 0x3A9), (0x3B1, 0x3C9), (0x3D1, 0x3D6), (0x2016, 0x2016), (0x2026, 0x2026), (0x2032, 0x2034),
            (0x20D7, 0x20D7), (0x210E, 0x210E), (0x2113, 0x2113), (0x211D, 0x211D), (0x2190, 0x2194), (0x21D2, 0x21D2),
            (0x2200, 0x2205), (0x2207, 0x220B), (0x2211, 0x2213), (0x2216, 0x221E), (0x2220, 0x222B), (0x223C, 0x223C),
            (0x2248, 0x2248), (0x2260, 0x2261), (0x2264, 0x2265), (0x226A, 0x226B), (0x2282, 0x2287), (0x2295, 0x2299),
            (0x22A5, 0x22A5), (0x22C5, 0x22C5), (0x22EF, 0x22EF), (0x2308, 0x230B), (0x27E8, 0x27E9), (0x1D400, 0x1D467),
            (0x1D6A4, 0x1D6A5), (0x1D6FC, 0x1D71B), (0xE17D, 0xE18C)]
# Those whose first script forms stay, and those whose large forms do.
SCRIPTS = [(0x28, 0x3E), (0x41, 0x7A), (0x210E, 0x210E), (0x2032, 0x2033), (0x2212, 0x2212), (0x221E, 0x221E),
           (0x22C5, 0x22C5), (0x1D434, 0x1D467), (0x1D6FC, 0x1D71B)]
LARGE = [(0x28, 0x29), (0x5B, 0x5D), (0x7B, 0x7D), (0x302, 0x304), (0x20D7, 0x20D7), (0x2016, 0x2016), (0x2211, 0x2211),
         (0x221A, 0x221A), (0x222B, 0x222B)]


def within(ranges):
    return {c for lo, hi in ranges for c in range(lo, hi + 1)}


def kept_glyphs(font):
    """The glyphs of the characters, their first script forms and their large forms."""
    cmap = font.getBestCmap()
    named = lambda ranges: {cmap[c] for c in within(ranges) if c in cmap}
    kept = named(FORMULAS) | {".notdef"}
    for lookup in font["GSUB"].table.LookupList.Lookup:
        for table in lookup.SubTable:
            table = getattr(table, "ExtSubTable", table)
            for glyph, forms in getattr(table, "alternates", {}).items():
                kept |= set(forms[:1]) if glyph in named(SCRIPTS) else set()
    variants = font["MATH"].table.MathVariants
    for way in ("Vert", "Horiz"):
        glyphs = getattr(variants, f"{way}GlyphCoverage").glyphs
        for glyph, made in zip(glyphs, getattr(variants, f"{way}GlyphConstruction")):
            if glyph in named(LARGE):
                kept |= {record.VariantGlyph for record in made.MathGlyphVariantRecord}
                kept |= {part.glyph for part in made.GlyphAssembly.PartRecords} if made.GlyphAssembly else set()
    return kept


def unnamed(cff):
    """The same outlines without the names of glyphs, which nothing asks for and which pack badly."""
    def index(at):
        count = int.from_bytes(cff[at:at + 2], "big")
        wide = cff[at + 2]
        ends = at + 3 + (count + 1) * wide
        offset = lambda k: int.from_bytes(cff[at + 3 + k * wide:at + 3 + (k + 1) * wide], "big")
        return ends + offset(count) - 1 if count else at + 2

    name = cff[2]
    strings = index(index(name))
    outlines, private = top.rawDict["CharStrings"], top.rawDict["Private"]
    number = lambda n: b"\x1d" + n.to_bytes(4, "big")
    # Of the top: where outlines begin (17), and how long what they share is and where it begins (18).
    head = cff[:index(name)]
    before = len(head) + 2 + 1 + 2 + 17 + 2 + 2
    body = cff[outlines:index(outlines)]
    shared = cff[private[1]:private[1] + private[0]]
    dictionary = number(before) + b"\x11" + number(private[0]) + number(before + len(body)) + b"\x12"
    assert cff[index(strings):index(strings) + 2] == b"\0\0" and len(dictionary) == 17
    return head + b"\0\1\1\1\x12" + dictionary + b"\0\0" + b"\0\0" + body + shared


source, target = sys.argv[1:]
is_math = source.endswith(".otf")
font = TTFont(source, recalcTimestamp=False)
options = subset.Options(layout_features=["kern", "ssty"], hinting=False, desubroutinize=True, notdef_outline=True,
                         retain_gids=True, glyph_names=False, legacy_kern=False, drop_tables=["name", "OS/2"])
cutter = subset.Subsetter(options)
cutter.populate(unicodes=within(FORMULAS if is_math else WORDS))
cutter.subset(font)
if is_math:
    top = font["CFF "].cff.topDictIndex[0]
    letters, kept = top.CharStrings, kept_glyphs(font)
    for name in set(font.getGlyphOrder()) - kept:
        letters[name] = T2CharString(program=["endchar"], private=top.Private, globalSubrs=letters.globalSubrs)
        font["hmtx"][name] = (0, 0)
    font.save(whole := BytesIO())
    font = TTFont(whole, recalcTimestamp=False, recalcBBoxes=False)
    top = font["CFF "].cff.topDictIndex[0]
    # Of script forms fontTools would drop what this table says.
    for table, data in {"CFF ": unnamed(font.reader["CFF "]), "MATH": TTFont(source).reader["MATH"]}.items():
        font[table] = DefaultTable(table)
        font[table].data = data
font.save(target)
