"""The same figures by several programs, in turns, in one run: processor time as a ratio to the bare program.

    pip install pycairo matplotlib typst        # those that are missing are left out
    cargo build --release
    cargo build --release --manifest-path bench/Cargo.toml
    python3 bench/peers/compare.py [ROUNDS]

`tracefig` is the whole process, from the scene files to synced files, on one core. The bare program and the plotters
draw display lists that are ready: only drawing and writing count, and what came before is told apart.
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BARE = ROOT / "bench/target/release/bare"
TRACEFIG = ROOT / "target/release/tracefig"
PLOTTERS = {"typst": "typst", "cairo": "cairo", "matplotlib": "matplotlib"}


def run(command, **how):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **how).stdout


def whole_process(command):
    """Processor milliseconds of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(command)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1e3 * (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def installed(module):
    found = subprocess.run([sys.executable, "-c", f"import {module}"], stderr=subprocess.DEVNULL)
    return found.returncode == 0


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    scenes = [str(path) for path in sorted((ROOT / "figures").glob("0*.toml"))]
    # One core for everybody, so that threads change nothing.
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    plotters = [name for name, module in PLOTTERS.items() if installed(module)]
    with tempfile.TemporaryDirectory() as folder:
        lists = Path(folder) / "lists.json"
        lists.write_text(run([BARE, "--dump", *scenes]))
        times = {name: [] for name in ["bare", "tracefig", *plotters]}
        before = {}
        for _ in range(rounds):
            times["bare"].append(float(run([BARE, "--once", folder, *scenes])))
            times["tracefig"].append(whole_process([TRACEFIG, "render", *scenes, "-o", folder]))
            for name in plotters:
                script = Path(__file__).with_name("draw.py")
                drawing, start = map(float, run([sys.executable, script, name, lists, folder]).split())
                times[name].append(drawing)
                before[name] = start
    print(f"{len(scenes)} figures, SVG and PNG at 1920 x 1080, {rounds} rounds in turns, one core\n")
    print("| program | processor time, ms (median, least) | median of the ratios to bare | before it, ms |")
    print("|---|---:|---:|---:|")
    for name, all_times in times.items():
        ratio = statistics.median(t / b for t, b in zip(all_times, times["bare"]))
        start = f"{before[name]:.0f}" if name in before else "–"
        print(f"| {name} | {statistics.median(all_times):.1f}, {min(all_times):.1f} | {ratio:.2f} | {start} |")


main()
