#!/usr/bin/env python3
"""`asperity solid` by `preconditioner = lu` against `multigrid`, mesh by mesh.

usage: test/bench/preconditioners.py [--asperity PROGRAM] [--output FOLDER] [--repetitions 1]
                                     [--meshes 30,20] [--amplitude 8]

One cycle of the paper's joint under the rough law, plastic, in turn, one thread each. FOLDER/preconditioners.md
is a table; a ratio is that of two runs that followed each other.
"""
import argparse
import json
import os
import statistics
import sys

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
from processes import heading, run, show, spread

CASE = ["examples/tenon_joint/base.nml", "--cycles", "1", "--contact", "rough", "--edge-relief", "2.5"]
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")}
COLUMNS = ("mesh, mm", "unknowns", "iterations: lu, multigrid", "processor time, s: lu", "multigrid",
           "over lu", "largest memory, MB: lu", "multigrid", "over lu", "peak force over lu's")


def one(options, mesh, preconditioner):
    """One run: its iterations, unknowns, processor seconds, memory and peak force."""
    name = os.path.join(options.output, f"{preconditioner}_{mesh}")
    _, cpu, memory = run(
        [options.asperity, "solid", *CASE, "--amplitudes", options.amplitude, "--mesh-size", mesh,
         "--preconditioner", preconditioner, "--checkpoint", name, "--json", name + ".json"],
        name + ".log", ONE_THREAD)
    with open(name + ".json", encoding="utf-8") as file:
        found = json.load(file)
    return {"iterations": found["analysis"]["iterations"][0], "unknowns": found["analysis"]["unknowns"][0],
            "cpu": cpu, "memory": memory, "peak": found["by_amplitude"]["positive_force_rough"][0]}


def row(mesh, pairs):
    """The row of a mesh."""
    cells = [mesh, str(pairs[0][0]["unknowns"]),
             ", ".join(str(of["iterations"]) for of in pairs[0])]
    for key in ("cpu", "memory"):
        cells += [spread([pair[i][key] for pair in pairs]) for i in (0, 1)]
        cells.append(spread([pair[1][key]/pair[0][key] for pair in pairs]))
    cells.append(f"{statistics.median([pair[1]['peak']/pair[0]['peak'] for pair in pairs]):.5f}")
    return "| " + " | ".join(cells) + " |\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asperity", default="build/asperity", metavar="PROGRAM")
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--repetitions", type=int, default=1)
    parser.add_argument("--meshes", default="30,20", metavar="LIST")
    parser.add_argument("--amplitude", default="8", metavar="MM")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    text = "| " + " | ".join(COLUMNS) + " |\n|" + "---|"*len(COLUMNS) + "\n"
    for mesh in options.meshes.split(","):
        pairs = [tuple(one(options, mesh, kind) for kind in ("lu", "multigrid"))
                 for _ in range(options.repetitions)]
        text += row(mesh, pairs)
        print(text.splitlines()[-1], flush=True)
    show(os.path.join(options.output, "preconditioners.md"), heading(options.repetitions) + text)


main()
