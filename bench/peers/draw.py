"""Draws the display lists that `bare --dump` prints, with one plotter, to PNG (1920 x 1080) and SVG.

    draw.py cairo|matplotlib|typst LISTS.json FOLDER

prints two processor times in milliseconds: of drawing and writing, and of what came before it (the interpreter, the
imports, reading the lists, which no user of the plotter would do).
"""

import json
import resource
import sys
from pathlib import Path

SCALE = 2


def processor_ms():
    """What this process and those that it waited for used so far."""
    both = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return 1e3 * sum(usage.ru_utime + usage.ru_stime for usage in both)


# pycairo: the drawing is replayed onto an image surface and onto an SVG surface.


def cairo_path(context, pieces):
    for name, *at in pieces:
        if name == "M":
            context.move_to(*at)
        elif name == "L":
            context.line_to(*at)
        elif name == "C":
            context.curve_to(*at)
        else:
            context.close_path()


def cairo_items(cairo, context, items):
    for item in items:
        if "items" in item:
            context.save()
            if item["clip"]:
                cairo_path(context, item["clip"])
                context.clip()
            if item["opacity"] < 1:
                context.push_group()
            cairo_items(cairo, context, item["items"])
            if item["opacity"] < 1:
                context.pop_group_to_source()
                context.paint_with_alpha(item["opacity"])
            context.restore()
            continue
        cairo_path(context, item["path"])
        if item["fill"]:
            context.set_source_rgba(*item["fill"])
            context.fill_preserve()
        if stroke := item["stroke"]:
            context.set_source_rgba(*stroke["color"])
            context.set_line_width(stroke["width"])
            context.set_dash(stroke["dash"])
            context.set_line_cap(cairo.LINE_CAP_ROUND if stroke["round"] else cairo.LINE_CAP_BUTT)
            context.set_line_join(cairo.LINE_JOIN_ROUND)
            context.stroke_preserve()
        context.new_path()


def with_cairo():
    import cairo

    def draw(figure, stem):
        width, height = figure["width"], figure["height"]
        image = cairo.ImageSurface(cairo.FORMAT_RGB24, round(SCALE * width), round(SCALE * height))
        svg = cairo.SVGSurface(f"{stem}.svg", width, height)
        for surface, scale in ((image, SCALE), (svg, 1)):
            context = cairo.Context(surface)
            context.scale(scale, scale)
            context.set_source_rgba(*figure["background"])
            context.paint()
            cairo_items(cairo, context, figure["items"])
        image.write_to_png(f"{stem}.png")
        svg.finish()

    return draw


# matplotlib: each path is a PathPatch of one figure, which is saved twice.


def with_matplotlib():
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib.figure import Figure
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    codes = {"M": [Outline.MOVETO], "L": [Outline.LINETO], "C": [Outline.CURVE4] * 3, "Z": [Outline.CLOSEPOLY]}

    def outline(pieces, height):
        points, kinds = [], []
        for name, *at in pieces:
            kinds += codes[name]
            points += [(x, height - y) for x, y in zip(at[::2], at[1::2])] or [(0, 0)]
        return Outline(points, kinds)

    def add(axes, items, height, clip, opacity):
        for item in items:
            if "items" in item:
                inner = outline(item["clip"], height) if item["clip"] else clip
                # A group's opacity goes to its parts: there are no groups.
                add(axes, item["items"], height, inner, opacity * item["opacity"])
                continue
            fill, stroke = item["fill"], item["stroke"]
            faded = lambda c: (*c[:3], c[3] * opacity)
            patch = PathPatch(
                outline(item["path"], height),
                facecolor=faded(fill) if fill else "none",
                edgecolor=faded(stroke["color"]) if stroke else "none",
                linewidth=stroke["width"] if stroke else 0,
                capstyle="round" if stroke and stroke["round"] else "butt",
                joinstyle="round",
            )
            if stroke and stroke["dash"]:
                # A dash without length, which makes a dot of round caps, is not drawn.
                patch.set_linestyle((0, [max(d, 0.05) / stroke["width"] for d in stroke["dash"]]))
            axes.add_patch(patch)
            if clip is not None:
                patch.set_clip_path(clip, axes.transData)

    def draw(figure, stem):
        # At 72 dots an inch a point, the unit of line widths, is a page pixel.
        width, height = figure["width"], figure["height"]
        page = Figure(figsize=(width / 72, height / 72), facecolor=figure["background"])
        axes = page.add_axes((0, 0, 1, 1))
        axes.set_xlim(0, width)
        axes.set_ylim(0, height)
        axes.axis("off")
        add(axes, figure["items"], height, None, 1)
        page.savefig(f"{stem}.png", dpi=72 * SCALE)
        page.savefig(f"{stem}.svg", dpi=72)

    return draw


# Typst: a document of curves, compiled twice. It clips to boxes only, and a group's opacity goes to its parts.


def typst_color(color, opacity):
    red, green, blue, alpha = (100 * c for c in color)
    return f"rgb({red:.2f}%, {green:.2f}%, {blue:.2f}%, {alpha * opacity:.2f}%)"


def typst_curve(item, opacity):
    point = lambda x, y: f"({x}pt, {y}pt)"
    calls = []
    for name, *at in item["path"]:
        points = ", ".join(point(x, y) for x, y in zip(at[::2], at[1::2]))
        call = {"M": "move", "L": "line", "C": "cubic", "Z": "close"}[name]
        calls.append(f"curve.{call}({points})")
    fill = typst_color(item["fill"], opacity) if item["fill"] else "none"
    stroke = "none"
    if line := item["stroke"]:
        dash = "(" + "".join(f"{d}pt, " for d in line["dash"]) + ")" if line["dash"] else "none"
        cap = "round" if line["round"] else "butt"
        color = typst_color(line["color"], opacity)
        stroke = f'(paint: {color}, thickness: {line["width"]}pt, cap: "{cap}", join: "round", dash: {dash})'
    return f"#place(curve(fill: {fill}, stroke: {stroke}, {', '.join(calls)}))\n"


def typst_items(items, opacity):
    for item in items:
        if "items" not in item:
            yield typst_curve(item, opacity)
            continue
        inner = "".join(typst_items(item["items"], opacity * item["opacity"]))
        clip = item["clip"]
        if not clip or not inner:
            yield inner
            continue
        xs = [piece[i] for piece in clip for i in range(1, len(piece), 2)]
        ys = [piece[i] for piece in clip for i in range(2, len(piece), 2)]
        x, y = min(xs), min(ys)
        yield f"#place(dx: {x}pt, dy: {y}pt, box(width: {max(xs) - x}pt, height: {max(ys) - y}pt, clip: true, "
        yield f"place(dx: {-x}pt, dy: {-y}pt, [{inner}])))\n"


def with_typst():
    import typst

    def draw(figure, stem):
        background = typst_color(figure["background"], 1)
        page = f'#set page(width: {figure["width"]}pt, height: {figure["height"]}pt, margin: 0pt, fill: {background})\n'
        source = Path(f"{stem}.typ")
        source.write_text(page + "".join(typst_items(figure["items"], 1)))
        typst.compile(str(source), output=f"{stem}.png", format="png", ppi=72 * SCALE)
        typst.compile(str(source), output=f"{stem}.svg", format="svg")

    return draw


def main():
    plotter, lists, folder = sys.argv[1:]
    draw = {"cairo": with_cairo, "matplotlib": with_matplotlib, "typst": with_typst}[plotter]()
    figures = json.loads(Path(lists).read_text())
    start = processor_ms()
    for figure in figures:
        draw(figure, str(Path(folder) / figure["name"]))
    print(f"{processor_ms() - start:.1f} {start:.1f}")


main()
