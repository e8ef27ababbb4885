"""Makes the word faces: Source Sans 3 cut to the characters that tracefig sets, renamed as its licence asks."""
import sys
from fontTools import subset
from fontTools.ttLib import TTFont

RANGES = [(0x20, 0x7E), (0xA0, 0x17F), (0x192, 0x192), (0x218, 0x21B), (0x2C6, 0x2C7), (0x2D8, 0x2DD),
          (0x384, 0x3CE), (0x400, 0x45F), (0x490, 0x491), (0x2010, 0x2015), (0x2018, 0x201E), (0x2020, 0x2022),
          (0x2026, 0x2026), (0x2030, 0x2030), (0x2032, 0x2033), (0x2039, 0x203A), (0x2044, 0x2044),
          (0x2070, 0x208E), (0x20AC, 0x20AC), (0x2116, 0x2116), (0x2122, 0x2122), (0x2190, 0x2199),
          (0x2202, 0x2202), (0x2206, 0x2206), (0x220F, 0x2212), (0x2215, 0x2215), (0x2219, 0x221A),
          (0x221E, 0x221E), (0x222B, 0x222B), (0x2248, 0x2248), (0x2260, 0x2260), (0x2264, 0x2265),
          (0x25A0, 0x25CF), (0x2713, 0x2713)]

source, target, style = sys.argv[1:]
options = subset.Options(layout_features=["kern"], hinting=False, notdef_outline=True, glyph_names=False,
                         legacy_kern=False, drop_tables=["STAT", "BASE", "GSUB", "GDEF", "gasp", "prep"],
                         name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14])
font = TTFont(source, recalcTimestamp=False)
cutter = subset.Subsetter(options)
cutter.populate(unicodes=[c for lo, hi in RANGES for c in range(lo, hi + 1)])
cutter.subset(font)
# The licence reserves the font name "Source" for unmodified versions.
for number, text in {1: "Tracefig Sans", 2: style, 3: f"Tracefig Sans {style}", 4: f"Tracefig Sans {style}",
                     6: f"TracefigSans-{style}"}.items():
    font["name"].setName(text, number, 3, 1, 0x409)
font.save(target)
