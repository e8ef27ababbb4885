"""Explanatory diagrams for 2D collision detection, and certified answers.

A *scene* is a dict, a text (TOML or JSON), or a path to a file. Lengths are in the scene's own unit, times from 0 to 1.

>>> import tracefig
>>> pair = {
...     "shapes": {
...         "A": {"kind": "circle", "radius": 1},
...         "B": {"kind": "circle", "radius": 1, "position": [3, 0]},
...     },
...     "query": {"kind": "separation", "of": ["A", "B"]},
... }
>>> tracefig.solve(pair)["separation"]
1.0
>>> tracefig.render(pair).save("pair.svg")  # doctest: +SKIP
"""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any, Iterable, Mapping, Union

from . import _tracefig

__all__ = ["Fault", "Figure", "SceneError", "Trace", "render", "solve", "solve_many", "trace"]

#: What a scene may be given as.
Scene = Union[Mapping[str, Any], str, "os.PathLike[str]"]


class Fault:
    """What is wrong at one place of a scene."""

    def __init__(self, code: str, line: int, column: int, message: str) -> None:
        #: The stable word for programs, as ``tracefig list errors`` has it.
        self.code = code
        #: Number of the line, from 1.
        self.line = line
        #: Number of the character in its line, from 1.
        self.column = column
        #: What is wrong, in words.
        self.message = message

    def __repr__(self) -> str:
        return f"Fault({self.code!r}, line={self.line}, column={self.column}, {self.message!r})"


class SceneError(ValueError):
    """A scene that can't be answered or drawn. Its text quotes the lines at fault."""

    def __init__(self, message: str, faults: Iterable[Fault]) -> None:
        super().__init__(message)
        #: All that is wrong, in the order of the text; at least one.
        self.faults = list(faults)


class Figure:
    """A figure, drawn. It shows itself in a notebook, and writes itself in every format."""

    def __init__(self, drawn: "_tracefig.Drawn") -> None:
        self._drawn = drawn

    @property
    def svg(self) -> str:
        """The figure as SVG."""
        return self.to_bytes("svg").decode()

    @property
    def png(self) -> bytes:
        """The figure as PNG, two pixels a page pixel."""
        return self.to_bytes("png")

    @property
    def size(self) -> "tuple[float, float]":
        """Width and height, page pixels."""
        return self._drawn.size

    @property
    def alt(self) -> str:
        """The short alternative text."""
        return self._drawn.alt[0]

    @property
    def description(self) -> str:
        """The figure in words, for those who do not see it."""
        return self._drawn.alt[1]

    @property
    def warnings(self) -> "list[str]":
        """What should be better, as a label that stands on a line."""
        return self._drawn.warnings

    def to_bytes(self, format: str, *, scale: float = 2.0) -> bytes:
        """The figure in a format: ``"svg"``, ``"png"``, ``"pdf"`` or ``"html"``.

        ``scale`` is how many pixels of an image are one page pixel.
        """
        return self._drawn.write(format, scale)

    def save(self, path: "str | os.PathLike[str]", *, scale: float = 2.0) -> None:
        """Writes a file, in the format that the end of its name says."""
        path = Path(path)
        path.write_bytes(self.to_bytes(path.suffix.lstrip("."), scale=scale))

    def __repr__(self) -> str:
        return f"<Figure: {self.alt}>"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> "tuple[dict[str, Any], dict[str, Any]]":
        width, height = self.size
        shown = {"image/svg+xml": self.svg, "image/png": self.png, "text/plain": self.alt}
        return shown, {"image/png": {"width": round(width), "height": round(height)}}


class Trace:
    """What an algorithm did, event by event."""

    def __init__(self, lines: str, story: str) -> None:
        header, *events = (json.loads(line) for line in lines.splitlines())
        #: The version of the format.
        self.header: "dict[str, Any]" = header
        #: The events, each a dict.
        self.events: "list[dict[str, Any]]" = events
        #: The same in words, a sentence a line.
        self.story = story

    def __len__(self) -> int:
        return len(self.events)

    def __iter__(self) -> Any:
        return iter(self.events)

    def __repr__(self) -> str:
        return f"<Trace of {len(self)} events>"

    def __str__(self) -> str:
        return self.story


def _given(scene: Scene) -> "tuple[str, str | None]":
    """A name for messages and the text; no text where the name is that of a file."""
    if isinstance(scene, Mapping):
        return "<dict>", json.dumps(scene, allow_nan=False)
    if isinstance(scene, os.PathLike):
        return os.fspath(scene), None
    if not isinstance(scene, str):
        raise TypeError(f"expected a dict, a text or a path, got {type(scene).__name__}")
    is_path = "\n" not in scene and scene.endswith((".toml", ".json"))
    return (scene, None) if is_path else ("<text>", scene)


def _asked(function: Any, *arguments: Any) -> Any:
    try:
        return function(*arguments)
    except _tracefig.SceneError as error:
        message, faults = error.args
        raise SceneError(message, [Fault(*fault) for fault in faults]) from None


def render(scene: Scene, *, theme: "str | None" = None, id: "str | None" = None) -> Figure:
    """Draws a scene.

    ``theme`` is a word of ``tracefig list themes`` or a theme file; without it the scene's own. ``id`` begins every id
    in the SVG; without it it is a hash of the scene, so that two figures on one page do not meet.

    Raises ``SceneError`` for a scene that can't be drawn.
    """
    name, text = _given(scene)
    if id is None:
        seen = text.encode() if text is not None else Path(name).read_bytes()
        id = "f" + hashlib.sha256(seen + (theme or "").encode()).hexdigest()[:10]
    return Figure(_asked(_tracefig.render, name, text, theme, id))


def solve(scene: Scene) -> "dict[str, Any]":
    """The answer, as ``tracefig solve --json`` prints it: numbers with the bounds that enclose the exact ones.

    Raises ``SceneError`` for a scene that can't be answered.
    """
    return json.loads(_asked(_tracefig.solve, *_given(scene)))


def solve_many(
    scenes: "Iterable[Mapping[str, Any] | str]", *, threads: "int | None" = None
) -> "list[dict[str, Any]]":
    """The replies to many scenes, in their order: ``{"id": …, "result": …}``, or ``{"id": …, "error": …}``.

    A scene is a dict or a line of JSON, as ``tracefig solve --jsonl`` reads them; a wrong one costs only its own
    answer. Runs on ``threads`` threads, by default as many as there are cores, and lets other Python run meanwhile.
    """
    if threads is not None and threads < 1:
        raise ValueError(f"expected 1 thread or more, got {threads}")
    lines = [scene if isinstance(scene, str) else json.dumps(scene, allow_nan=False) for scene in scenes]
    return [json.loads(reply) for reply in _tracefig.solve_many(lines, threads)]


def trace(scene: Scene) -> Trace:
    """Every step of the algorithm.

    Raises ``SceneError`` for a scene that can't be answered.
    """
    return Trace(*_asked(_tracefig.trace, *_given(scene)))
