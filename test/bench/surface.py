#!/usr/bin/env python3
"""`asperity surface` against surfalize and SurfaceTopography on the same file, as whole processes.

usage: test/bench/surface.py --python PYTHON [--asperity PROGRAM] [--output FOLDER] [--points 4096]
                             [--repetitions 5]

PYTHON is that of the environment in which both are installed. Each reads the map, levels it and
finds what it has of asperity's parameters, which must agree. FOLDER/surface.md is a table of medians
with the least and the largest, and of the ratios of runs that followed each other.
"""
import argparse
import json
import os
import sys

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
from processes import heading, run, show, spread

PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "surface_peer.py")
CONTENDERS = {"asperity": "asperity surface", "surfalize": "surfalize",
              "surfalize_peaks": "surfalize, with peaks", "SurfaceTopography": "SurfaceTopography"}
# Rounding; and where borders are left out, which matters the less the larger the map
SAME, BORDERS = 1e-9, {"sdq": 2e-3, "m4_x": 2e-3, "spd": 0.5, "spc": 0.1}


def read(path):
    """A result of either kind."""
    with open(path, encoding="utf-8") as file:
        found = json.load(file)
    return dict(zip(found["data"]["parameter"], found["data"]["value"])) if "data" in found else found


def once(options, path, name):
    """One run of a contender: its seconds, its memory, MB, and what it found."""
    result = os.path.join(options.output, f"surface_{name}.json")
    command = ([options.asperity, "surface", path, "--json", result] if name == "asperity"
               else [options.python, PEER, name, path, result])
    wall, _, memory = run(command, os.path.join(options.output, f"surface_{name}.log"))
    return wall, memory, read(result)


def check(values):
    """All found the same."""
    for name, found in values.items():
        for key, value in found.items():
            ours = values["asperity"][key]
            if name != "asperity" and abs(value - ours) > max(BORDERS.get(key, SAME)*abs(ours), 1e-12):
                sys.exit(f"surface.py: error: {key} is {value} by {name} and {ours} by asperity")


def table(runs):
    """A row for each contender."""
    lines = ["| | parameters | time, s | times asperity's | largest memory, MB | times asperity's |",
             "|---|---|---|---|---|---|"]
    for name, label in CONTENDERS.items():
        found = [run[name] for run in runs]
        cells = []
        for i in (0, 1):
            cells.append(spread([of_one[i] for of_one in found]))
            cells.append(spread([run[name][i]/run["asperity"][i] for run in runs]))
        parameters = list(found[0][2])
        names = f"all {len(parameters)}" if name == "asperity" else ", ".join(sorted(parameters))
        lines.append(f"| {label} | {names} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asperity", default="build/asperity", metavar="PROGRAM")
    parser.add_argument("--python", required=True, metavar="PYTHON")
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--points", type=int, default=4096)
    parser.add_argument("--repetitions", type=int, default=5)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    path = os.path.join(options.output, "surface.sdf")
    run([options.asperity, "surface", "--generate", "--map-points", str(options.points), "--map", path],
        os.path.join(options.output, "surface.log"))
    # the first run of each, which finds its files on the disk, does not count
    check({name: once(options, path, name)[2] for name in CONTENDERS})
    runs = []
    for _ in range(options.repetitions):
        runs.append({name: once(options, path, name) for name in CONTENDERS})
        print(", ".join(f"{name} {runs[-1][name][0]:.1f} s" for name in CONTENDERS), flush=True)
    show(os.path.join(options.output, "surface.md"),
         f"{options.points} x {options.points} points; " + heading(options.repetitions) + table(runs))
    os.remove(path)


main()
