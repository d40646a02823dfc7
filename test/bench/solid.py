#!/usr/bin/env python3
"""`asperity solid` against CalculiX with UINTER: one elastic cycle of the paper's joint on one mesh.

usage: test/bench/solid.py --ccx PROGRAM [--asperity PROGRAM] [--output FOLDER] [--repetitions 3]

Both run in turn, one thread each, on the mesh of `asperity deck tenon`. FOLDER/solid.md is a table
of medians with the least and the largest, and of the ratios of runs that followed each other.
"""
import argparse
import json
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "interface", "calculix"))
# pylint: disable=wrong-import-position
from processes import heading, run, show, spread
from tools import study

CASE = ["examples/tenon_joint/base.nml", "--amplitudes", "8", "--cycles", "1", "--criterion",
        "none", "--mesh-size", "30"]
RUNNER = os.path.join(HERE, "..", "..", "interface", "calculix", "run")
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "CCX_NPROC_RESULTS")}
QUANTITIES = {"increments": "increments", "iterations": "iterations", "cpu": "processor time, s",
              "wall": "time, s", "per_iteration": "processor time an iteration, s",
              "memory": "largest memory, MB", "positive": "peak force, kN",
              "negative": "reverse peak force, kN"}


def ours(options):
    """One run of asperity solid."""
    result = os.path.join(options.output, "asperity.json")
    wall, cpu, memory = run(
        [options.asperity, "solid", *CASE, "--contact", "rough", "--checkpoint",
         os.path.join(options.output, "asperity"), "--json", result],
        os.path.join(options.output, "asperity.log"), ONE_THREAD)
    with open(result, encoding="utf-8") as file:
        found = json.load(file)
    analysis, peaks = found["analysis"], found["by_amplitude"]
    iterations = analysis["iterations"][0]
    return {"increments": analysis["increments"][0], "iterations": iterations, "cpu": cpu,
            "wall": wall, "per_iteration": cpu/iterations, "memory": memory,
            "positive": peaks["positive_force_rough"][0],
            "negative": peaks["negative_force_rough"][0]}


def theirs(options, deck):
    """One run of ccx; its times are those of ccx, without the program that runs it."""
    folder = os.path.join(options.output, "ccx")
    _, _, memory = run([RUNNER, deck, "--ccx", options.ccx, "--output", folder, "--anew"],
                       os.path.join(options.output, "ccx.log"), ONE_THREAD)
    costs = study.costs(folder, {"parts": []})
    increments = study.table(os.path.join(folder, "increments.csv"))
    forces = [row["force"]/1000 for row in study.table(os.path.join(folder, "history.csv"))]
    return {"increments": costs["increments"], "iterations": costs["iterations"],
            "cpu": costs["seconds"], "wall": sum(row["wall_time"] for row in increments),
            "per_iteration": costs["per_iteration"], "memory": memory,
            "positive": max(forces), "negative": min(forces)}


def table(pairs):
    """The rows of all repetitions."""
    lines = ["| | asperity solid | ccx with UINTER | ratio |", "|---|---|---|---|"]
    for key, name in QUANTITIES.items():
        mine, other = ([pair[i][key] for pair in pairs] for i in (0, 1))
        ratios = [b/a for a, b in zip(mine, other)]
        lines.append(f"| {name} | {spread(mine)} | {spread(other)} | {spread(ratios)} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asperity", default="build/asperity", metavar="PROGRAM")
    parser.add_argument("--ccx", required=True, metavar="PROGRAM")
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--repetitions", type=int, default=3)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    deck = os.path.join(options.output, "joint.inp")
    study.asperity(options, "deck", "tenon", *CASE, "--inp", deck)
    pairs = []
    for _ in range(options.repetitions):
        pairs.append((ours(options), theirs(options, deck)))
        print("{0[wall]:.1f} s, ccx {1[wall]:.1f} s".format(*pairs[-1]), flush=True)
    show(os.path.join(options.output, "solid.md"), heading(options.repetitions) + table(pairs))


main()
