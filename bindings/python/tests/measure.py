"""What the installed wheel costs, in processor time: `python measure.py FOLDER_OF_SCENES`."""

import time

begun = time.process_time()
import tracefig  # noqa: E402

imported = time.process_time() - begun

import pathlib  # noqa: E402
import sys  # noqa: E402

files = sorted(file for file in pathlib.Path(sys.argv[1]).glob("*.toml") if file.name != "tracefig.toml")
scenes = [files[i % len(files)].read_text() for i in range(100)]
begun = time.process_time()
size = sum(len(tracefig.render(scene).svg) for scene in scenes)
drawn = time.process_time() - begun
print(f"import {imported * 1e3:.0f} ms; 100 figures {drawn * 1e3:.0f} ms, {size / 1e6:.1f} MB of SVG")
