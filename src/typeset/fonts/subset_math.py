"""Makes the face of formulas: STIX Two Math cut to the characters that the language of formulas can set."""
import csv
import re
import sys
from pathlib import Path
from fontTools import subset
from fontTools.ttLib import TTFont

# Letters, digits and signs as typed; accents, primes, arrows above and braces below; Greek.
TYPED = [(0x20, 0x7E), (0xA0, 0xFF), (0x2C6, 0x2C7), (0x2D8, 0x2DD), (0x300, 0x338), (0x391, 0x3F6),
         (0x20D0, 0x20EF), (0x23B0, 0x23E1)]
# Signs for private use that stand for words while a formula is laid out: `inner_words.rs`.
STAND_INS = [(0xE17D, 0xE18C)]
# What words take from this face where theirs lacks it: further Latin letters, Vietnamese too, spaces and punctuation,
# raised and lowered digits, fractions, arrows, operators, circled numbers, shapes, stars and ticks.
LENT = [(0x180, 0x24F), (0x1EA0, 0x1EF9), (0x2000, 0x206F), (0x2070, 0x209F), (0x2150, 0x215F), (0x2190, 0x21FF),
        (0x2200, 0x22FF), (0x2460, 0x2473), (0x25A0, 0x25FF), (0x2605, 0x2606), (0x2660, 0x2667), (0x2713, 0x2718),
        (0x27C0, 0x27EF)]
# What \mathbf, \mathit, \mathcal, \mathfrak, \mathbb, \mathsf, \mathtt and \boldsymbol make of letters and digits.
STYLED = [(0x1D400, 0x1D4CF), (0x1D504, 0x1D56B), (0x1D5A0, 0x1D5D3), (0x1D670, 0x1D755), (0x1D7CE, 0x1D7EB),
          (0x1D7F6, 0x1D7FF)]
STYLED_LETTERS = "ℂℍℕℙℚℝℤℬℰℱℋℐℒℳℛℯℊℴℭℌℑℜℨℎ"
# Letters that have drawings of their own as scripts; others are scaled.
SCRIPTS = [(0x20, 0x1D3FF), (0x1D434, 0x1D467), (0x1D6A4, 0x1D6A5), (0x1D6E2, 0x1D71B)]


def within(ranges):
    return {c for lo, hi in ranges for c in range(lo, hi + 1)}


def named(crate):
    """Every character that a command of `latex-rust` stands for: those of its table, and those in its sources."""
    with open(crate / "data" / "symbols.tsv", encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE))[1:]
    chars = {ord(c) for row in rows for c in row[0] if len(row[0]) <= 2}
    for path in sorted((crate / "src").rglob("*.rs")):
        text = path.read_text(encoding="utf-8")
        chars |= {ord(c) for c in text if ord(c) > 0x7E}
        chars |= {int(digits, 16) for digits in re.findall(r"\\u\{([0-9A-Fa-f]+)\}", text)}
    return chars


def script_forms(font, kept):
    """The script forms of the glyphs kept; those of all others are taken away."""
    forms = set()
    for lookup in font["GSUB"].table.LookupList.Lookup:
        for table in lookup.SubTable:
            table = getattr(table, "ExtSubTable", table)
            for glyph in set(getattr(table, "alternates", {})) - kept:
                del table.alternates[glyph]
            forms |= {form for alternates in getattr(table, "alternates", {}).values() for form in alternates}
    return {form for form in forms if ".ssty" in form}


def shorten_names(path):
    """Numbers glyphs instead of naming them: the names are a tenth of the file. All other tables stay as they are."""
    font = TTFont(path, recalcBBoxes=False, recalcTimestamp=False)
    top = font["CFF "].cff.topDictIndex[0]
    order = list(top.charset)
    short = {name: name if name == ".notdef" else f"{i:x}!" for i, name in enumerate(order)}
    top.CharStrings.charStrings = {short[name]: value for name, value in top.CharStrings.charStrings.items()}
    top.charset[:] = [short[name] for name in order]
    font.save(path)


crate, target = Path(sys.argv[1]), sys.argv[2]
options = subset.Options(layout_features=["ssty"], hinting=False, desubroutinize=True, notdef_outline=True, glyph_names=False,
                         legacy_kern=False, drop_tables=["STAT", "BASE", "GPOS", "GDEF", "DSIG"],
                         name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14])
font = TTFont(crate / "fonts" / "stix-two-math" / "STIXTwoMath-Regular.otf", recalcTimestamp=False)
cmap = font.getBestCmap()
wanted = within(TYPED + STAND_INS + LENT + STYLED) | set(map(ord, STYLED_LETTERS)) | named(crate)
forms = script_forms(font, {cmap[c] for c in wanted & within(SCRIPTS) if c in cmap})
cutter = subset.Subsetter(options)
# Named, lest their constants be cut: what a feature leads to is found after those.
cutter.populate(unicodes=wanted, glyphs=forms)
cutter.subset(font)
for number, text in {1: "Tracefig Math", 2: "Regular", 3: "Tracefig Math", 4: "Tracefig Math", 6: "TracefigMath"}.items():
    font["name"].setName(text, number, 3, 1, 0x409)
font.save(target)
shorten_names(target)
