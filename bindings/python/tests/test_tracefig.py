"""What `tracefig` promises in Python."""

import json
import re
import threading
import time
from pathlib import Path

import pytest

import tracefig

FIGURES = Path(__file__).parents[3] / "figures"
PAIR = {
    "shapes": {
        "A": {"kind": "circle", "radius": 1},
        "B": {"kind": "circle", "radius": 1, "position": [3, 0]},
    },
    "query": {"kind": "separation", "of": ["A", "B"]},
}


def test_a_scene_is_a_dict_a_text_or_a_path():
    path = FIGURES / "01-penetration.toml"
    toml = path.read_text()
    by_path = tracefig.solve(path)
    assert tracefig.solve(str(path)) == tracefig.solve(toml) == by_path
    assert by_path["separation"] < 0
    assert tracefig.solve(PAIR) == tracefig.solve(json.dumps(PAIR))
    with pytest.raises(TypeError):
        tracefig.solve(7)


def test_answers_come_with_bounds():
    answer = tracefig.solve(PAIR)
    low, high = answer["separation_bounds"]
    assert low <= answer["separation"] == 1.0 <= high


@pytest.mark.parametrize("path", sorted(FIGURES.glob("*.toml")), ids=lambda path: path.stem)
def test_a_figure_is_the_committed_one_but_for_what_it_says_of_itself(path):
    committed = path.with_suffix(".svg").read_text()
    ours = tracefig.render(path, id=re.search(r'id="([^".]+)\.', committed)[1]).svg
    bare = lambda svg: re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    assert re.findall("<[a-z][^>]*>", bare(ours))[1:] == re.findall("<[a-z][^>]*>", bare(committed))[1:]


def test_every_format_is_written(tmp_path):
    figure = tracefig.render(PAIR, theme="dark")
    begins = {"svg": b"<svg", "png": b"\x89PNG", "pdf": b"%PDF", "html": b"<!doctype"}
    for name, begin in begins.items():
        figure.save(tmp_path / f"pair.{name}")
        assert begin.lower() in (tmp_path / f"pair.{name}").read_bytes()[:200].lower(), name
    with pytest.raises(ValueError, match="doc"):
        figure.to_bytes("doc")


def test_a_notebook_gets_svg_png_and_words():
    shown, _ = tracefig.render(PAIR)._repr_mimebundle_()
    assert shown["image/svg+xml"].startswith("<svg") or shown["image/svg+xml"].startswith("<?xml")
    assert shown["image/png"].startswith(b"\x89PNG")
    assert shown["text/plain"] == tracefig.render(PAIR).alt != ""


def test_ids_of_two_figures_do_not_meet():
    other = json.loads(json.dumps(PAIR))
    other["shapes"]["B"]["position"] = [4, 0]
    ids = lambda scene: {part.split('"')[0] for part in tracefig.render(scene).svg.split(' id="')[1:]}
    assert ids(PAIR) and not ids(PAIR) & ids(other)


def test_a_wrong_scene_is_quoted_with_its_place():
    with pytest.raises(tracefig.SceneError) as caught:
        tracefig.render('[shapes.A]\nkind = "cirlce"\nradius = 1\n[query]\nkind = "bounds"\nof = ["A"]\n')
    error = caught.value
    assert isinstance(error, ValueError)
    assert 'kind = "cirlce"' in str(error) and "did you mean `circle`?" in str(error)
    assert [(fault.code, fault.line, fault.column) for fault in error.faults] == [("unknown-word", 2, 8)]


def test_a_missing_file_is_a_scene_error():
    with pytest.raises((tracefig.SceneError, OSError)):
        tracefig.solve(Path("no/such/scene.toml"))


def test_a_theme_is_a_word_or_a_file(tmp_path):
    brand = tmp_path / "brand.toml"
    brand.write_text('[colors]\nbackground = "#FFF8E7"\n')
    assert "#FFF8E7" in tracefig.render(PAIR, theme=str(brand)).svg.upper()
    with pytest.raises(ValueError, match="dark"):
        tracefig.render(PAIR, theme="drak")
    with pytest.raises(ValueError, match=r"no table `\[dark\]`"):
        tracefig.render(PAIR, theme=f"{brand}#dark")
    brand.write_text('[colors]\nbackground = "#FFF8E7"\n[dark]\nbackground = "#112233"\n')
    assert "#112233" in tracefig.render(PAIR, theme=f"{brand}#dark").svg


def test_many_scenes_keep_their_order_and_their_errors():
    scenes = [dict(PAIR, id=k) for k in range(50)] + ['{"id": "broken"}']
    replies = tracefig.solve_many(scenes, threads=3)
    assert [reply["id"] for reply in replies] == [*range(50), "broken"]
    assert all(reply["result"]["separation"] == 1.0 for reply in replies[:-1])
    assert replies[-1]["error"]["code"] == "missing-key"
    assert replies[-1]["line"] == 51
    assert tracefig.solve_many([]) == []
    with pytest.raises(ValueError):
        tracefig.solve_many([], threads=0)


def test_other_python_runs_while_many_are_solved():
    line = json.dumps(json.loads((Path(__file__).parents[3] / "tests/data/hard.jsonl").read_text().splitlines()[3]))
    lines = [line] * 20_000
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    ticker = threading.Thread(target=tick)
    ticker.start()
    begun = time.perf_counter()
    tracefig._tracefig.solve_many(lines, 1)
    ended = time.perf_counter()
    done.set()
    ticker.join()
    during = [tick for tick in ticks if begun + 0.01 < tick < ended - 0.01]
    assert ended - begun > 0.05, "too short to tell"
    assert during, "nothing else ran"


def test_a_trace_is_events_and_a_story():
    trace = tracefig.trace(FIGURES / "gjk-steps.toml")
    assert len(trace) == len(list(trace)) > 3
    assert all("event" in event for event in trace)
    assert str(trace).count("\n") >= 3


def test_a_trace_says_how_far_what_was_expected_is_off():
    expected = dict(PAIR, query=dict(PAIR["query"], expected={"separation": 1.5}))
    events = [event["event"] for event in tracefig.trace(expected)]
    assert len(events) == len(tracefig.trace(PAIR)) + 1
