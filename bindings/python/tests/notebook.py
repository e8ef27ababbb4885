"""Runs a notebook, and looks at what its cells show."""

import nbclient
import nbformat

CELLS = [
    "import tracefig, json",
    """pair = {
    "shapes": {
        "ball": {"kind": "circle", "radius": 1, "velocity": [2, 0]},
        "wall": {"kind": "box", "half_extents": [0.2, 2], "position": [2.5, 0]},
    },
    "query": {"kind": "linear-sweep", "of": ["ball", "wall"]},
}
tracefig.render(pair)""",
    "tracefig.solve(pair)['time']",
    "tracefig.trace(pair)",
    "pair['query']['kind'] = 'swep'\ntry:\n    tracefig.render(pair)\nexcept tracefig.SceneError as error:\n    print(error)",
]

notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
outputs = [cell["outputs"] for cell in notebook.cells]
(figure,), (time,), (trace,), (error,) = outputs[1:]
assert figure["data"]["image/svg+xml"].count("<svg") == 1
assert len(figure["data"]["image/png"]) > 1000
assert "ball" in figure["data"]["text/plain"]
assert 0 < float(time["data"]["text/plain"]) < 1
assert "events" in trace["data"]["text/plain"]
assert "unknown-word" in error["text"] and "'swep'" not in error["text"], error["text"]
nbformat.validate(notebook)
print("the notebook shows what it should")
