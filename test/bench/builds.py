#!/usr/bin/env python3
"""Several builds by the same benchmarks (test/bench/builds), in turn on the same machine.

usage: test/bench/builds.py --output FILE [--rounds 15] [--instructions] NAME=PROGRAM...

A round runs every program once; ratios are those of one round, over the first build. FILE.csv and
FILE.md are tables of medians with the 10 and 90 % quantiles. --instructions counts those of a call as
well, by test/bench/instructions/count.sh.
"""
import argparse
import csv
import os
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
from processes import heading, run, show, spread_text

COUNT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "instructions", "count.sh")


def once(program, path):
    """One run of a program: {contender: ns a point}."""
    # threads that wait must not spin: they would slow down who is timed next
    run([program, "--csv", path], path + ".log", {"OMP_WAIT_POLICY": "passive"})
    with open(path, encoding="utf-8", newline="") as file:
        return {row["name"]: float(row["median"]) for row in csv.DictReader(file)
                if row["section"] == "time"}


def count(program):
    """Instructions a call: {what: number}."""
    folder = os.path.dirname(os.path.dirname(os.path.abspath(program)))
    lines = subprocess.run(["bash", COUNT, folder], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {name: float(number) for name, number in
            (line.rsplit(maxsplit=1) for line in lines.splitlines())}


def spread(values):
    """Median, 10 and 90 % quantiles."""
    if len(values) == 1:
        return values*3
    tenths = statistics.quantiles(values, n=10, method="inclusive")
    return [statistics.median(values), tenths[0], tenths[-1]]


def compare(builds, rounds):
    """[name, the spread of each build, that of its ratio to the first], as far as builds have it."""
    rows = []
    for name in rounds[0][builds[0]]:
        first = [found[builds[0]][name] for found in rounds]
        cells = []
        for build in builds:
            values = [found[build].get(name) for found in rounds]
            if None not in values:
                cells.append((build, spread(values), spread([b/a for a, b in zip(first, values)])))
        rows.append((name, cells))
    return rows


def table(rows, builds, unit):
    """Markdown."""
    over = [f" | over {builds[0]}"]*(len(builds) - 1)
    lines = [f"| {unit} | {builds[0]}" + "".join(f" | {b}{o}" for b, o in zip(builds[1:], over)) + " |",
             "|---"*(2*len(builds)) + "|"]
    for name, cells in rows:
        found = {build: (spread_text(*values), spread_text(*ratios)) for build, values, ratios in cells}
        line = [name, found[builds[0]][0]]
        for build in builds[1:]:
            line += found.get(build, ("", ""))
        lines.append("| " + " | ".join(line) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", required=True, metavar="FILE")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--instructions", action="store_true")
    parser.add_argument("builds", nargs="+", metavar="NAME=PROGRAM")
    options = parser.parse_args()
    # the names may hold an equals sign, the programs do not
    programs = dict(item.rsplit("=", 1) for item in options.builds)
    builds = list(programs)
    rounds = []
    for _ in range(options.rounds):
        # there and back, so that a drift of the machine hits all alike
        order = builds if len(rounds) % 2 == 0 else builds[::-1]
        rounds.append({build: once(programs[build], options.output + ".run") for build in order})
    os.remove(options.output + ".run")
    os.remove(options.output + ".run.log")
    tables = [("ns a point", compare(builds, rounds))]
    if options.instructions:
        counts = [{build: count(programs[build]) for build in builds}]
        tables.append(("instructions a call", compare(builds, counts)))
    with open(options.output + ".csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["name", "unit", "build", "median", "quantile_10", "quantile_90", "ratio",
                         "ratio_10", "ratio_90"])
        for unit, rows in tables:
            for name, cells in rows:
                writer.writerows([name, unit, build, *values, *ratios] for build, values, ratios in cells)
    show(options.output + ".md", heading(options.rounds)
         + "\n".join(table(rows, builds, unit) for unit, rows in tables))


main()
