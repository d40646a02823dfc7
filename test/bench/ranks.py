#!/usr/bin/env python3
"""`asperity solid` on several ranks, by factors and by multigrid: time of an iteration, and where it goes.

usage: test/bench/ranks.py [--asperity PROGRAM] [--output FOLDER] [--ranks 1,2] [--repetitions 3] [RUN...]

A RUN is the paper's joint, plastic, under the rough law, on a mesh and by a preconditioner, through one
cycle of 8 mm or one stroke of 48 mm from rest (`--help` lists them); without any, those of elements of 30
and 20 mm. Each is made by all numbers of ranks in turn, one thread each, and kept in FOLDER/ranks, as the
large ones take half an hour each. FOLDER/ranks.md is a table of all that is kept: medians with the least and the
largest; a ratio is that of two runs that followed each other. Below it is the power of the number of
equations that things go with from the smallest to the largest mesh of a preconditioner, and what the machine
allows: how much longer N runs of one rank take side by side than one alone (RUN `side-by-side`).
"""
import argparse
import glob
import json
import math
import os
import re
import resource
import statistics
import subprocess
import sys
import time

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
from processes import run, show, spread

CASE = ["examples/tenon_joint/base.nml", "--contact", "rough"]
CYCLE = ("--amplitudes", "8", "--cycles", "1")
# A history of the load point, mm
STROKE = ("--history", "stroke.csv")
HISTORY = "displacement (mm)\n0\n48\n"
GRADED = ("--mesh-size", "9.7", "--rim-mesh-size", "5", "--edge-relief", "2")
MULTIGRID = ("--preconditioner", "multigrid")
RUNS = {f"{size}{suffix}": ("--mesh-size", str(size), *more, *CYCLE)
        for suffix, more in (("", ()), ("-multigrid", MULTIGRID)) for size in (60, 40, 30, 20, 15)}
RUNS.update({"graded": (*GRADED, *CYCLE), "graded-multigrid": (*GRADED, *MULTIGRID, *CYCLE),
             "graded-multigrid-stroke": (*GRADED, *MULTIGRID, *STROKE)})
USUAL = ["30", "20", "30-multigrid", "20-multigrid", "side-by-side"]
# Runs of one rank that do not share anything but the machine
BESIDE, BESIDE_RUNS = "side-by-side", ("20", "20-multigrid")
# Of the JSON's times, each of the rank that it took longest; what is left is the rest
SHARES = ["elements", "contact", "exchange", "patterns", "factors", "solutions"]
LAUNCH = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
if os.getuid() == 0:
    LAUNCH.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})


def be_rank(stem, command):
    """Run a command in place of a rank and write down the memory that it took, MB."""
    status = subprocess.call(command)
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
    with open(f"{stem}.memory.{rank}", "w", encoding="utf-8") as file:
        file.write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss/1024))
    sys.exit(status)


def measure(options, name, ranks, repetition):
    """Make one run and keep its sizes, seconds an iteration by what they go to, and the largest rank's MB."""
    stem = os.path.join(options.output, "ranks", name)
    for left in glob.glob(f"{stem}.*checkpoint") + glob.glob(f"{stem}.memory.*"):
        os.remove(left)
    command = [sys.executable, __file__, "--rank", stem, options.asperity, "solid", *CASE,
               *(os.path.join(options.output, "ranks", word) if word == STROKE[1] else word
                 for word in RUNS[name]), "--checkpoint", stem, "--json", f"{stem}.json"]
    run(["mpirun", "-q", "-n", str(ranks), *command], f"{stem}.log", LAUNCH)
    with open(f"{stem}.json", encoding="utf-8") as file:
        found = json.load(file)
    found, times = found["analysis"], found["times"]
    if times["ranks"][0] != ranks:
        sys.exit(f"ranks.py: error: {ranks} ranks were started, {times['ranks'][0]} ran")
    memory = []
    for path in glob.glob(f"{stem}.memory.*"):
        with open(path, encoding="utf-8") as file:
            memory.append(float(file.read()))
    iterations = found["iterations"][0]
    one = {"elements": found["elements"][0], "unknowns": found["unknowns"][0], "iterations": iterations,
           "seconds": found["time"][0]/iterations, "memory": max(memory), "date": time.strftime("%Y-%m-%d"),
           "vectors": times["vectors"][0]/iterations,
           "shares": {share: times[f"{share}_seconds"][0]/iterations for share in SHARES}}
    one["shares"]["rest"] = one["seconds"] - sum(one["shares"].values())
    with open(f"{stem}.{ranks}.{repetition}.kept", "w", encoding="utf-8") as file:
        json.dump(one, file)
    print(f"{name}, {ranks} ranks: {one['seconds']:.3g} s for each of {iterations} iterations, "
          f"{one['memory']:.0f} MB", flush=True)


def measure_beside(options, name, ranks, repetition):
    """How much longer as many runs of one rank as ranks take, side by side, than one alone: kept."""
    stem = os.path.join(options.output, "ranks", f"{BESIDE}-{name}")

    def seconds(count):
        runs = []
        for number in range(count):
            for left in glob.glob(f"{stem}.{number}.*checkpoint"):
                os.remove(left)
            runs.append(subprocess.Popen(
                ["mpirun", "-q", "--bind-to", "none", "-n", "1", options.asperity, "solid", *CASE, *RUNS[name],
                 "--checkpoint", f"{stem}.{number}", "--json", f"{stem}.{number}.json"],
                env={**os.environ, **LAUNCH}, stdout=subprocess.DEVNULL))
        if any([one.wait() for one in runs]):
            sys.exit(f"ranks.py: error: {stem} failed")
        times = []
        for number in range(count):
            with open(f"{stem}.{number}.json", encoding="utf-8") as file:
                times.append(json.load(file)["analysis"]["time"][0])
        return statistics.mean(times)

    alone = seconds(1)
    longer = seconds(ranks)/alone
    with open(f"{stem}.{ranks}.{repetition}.kept", "w", encoding="utf-8") as file:
        json.dump({"ranks": ranks, "longer": longer, "run": name}, file)
    print(f"{name}, {ranks} runs side by side: {longer:.3g} times one alone", flush=True)


def ceilings(folder):
    """What is kept of runs side by side."""
    found = {}
    for path in sorted(glob.glob(os.path.join(folder, f"{BESIDE}-*.kept"))):
        with open(path, encoding="utf-8") as file:
            one = json.load(file)
        found.setdefault((one["run"], one["ranks"]), []).append(one["longer"])
    return [f"- {ranks} runs `{run}` of one rank each, side by side, take {spread(longer)} times as long as one alone: "
            f"more than {spread([ranks/one for one in longer])} times the speed of one is not to be had here\n"
            for (run, ranks), longer in found.items()]


def kept(folder):
    """What is kept, by run, number of ranks and repetition, in the order of the runs."""
    found = {}
    for name in RUNS:
        for path in glob.glob(os.path.join(folder, f"{name}.*.kept")):
            ranks, repetition = map(int, re.search(r"\.(\d+)\.(\d+)\.kept$", path).groups())
            with open(path, encoding="utf-8") as file:
                found.setdefault(name, {}).setdefault(ranks, {})[repetition] = json.load(file)
    return found


def rows_of(name, by_ranks):
    """The rows of one run."""
    lines, first = [], by_ranks[min(by_ranks)]
    for ranks, runs in sorted(by_ranks.items()):
        ratios = [first[number]["seconds"]/one["seconds"] for number, one in runs.items() if number in first]
        runs = list(runs.values())
        seconds = statistics.median(one["seconds"] for one in runs)
        lines.append(" | ".join([
            f"| {name.replace('-', ', ')}", str(runs[0]["elements"]), str(runs[0]["unknowns"]), str(ranks),
            spread([one["iterations"] for one in runs]), spread([one["seconds"] for one in runs]),
            spread(ratios), spread([one["memory"] for one in runs]), spread([one["vectors"] for one in runs]),
            *(f"{100*statistics.median(one['shares'][share] for one in runs)/seconds:.0f}"
              for share in (*SHARES, "rest"))]) + " |")
    return lines


def growth(found):
    """How things grow with the equations, by preconditioner and number of ranks."""
    lines = []
    for label, is_multigrid in (("LU", False), ("multigrid", True)):
        names = [name for name in found if ("multigrid" in name) == is_multigrid and "stroke" not in name]
        for ranks in sorted({ranks for name in names for ranks in found[name]}):
            runs = [list(found[name][ranks].values()) for name in names if ranks in found[name]]
            runs.sort(key=lambda of: of[0]["unknowns"])
            if len(runs) < 2:
                continue
            powers = []
            for what, number in (("elements", lambda one: one["shares"]["elements"]),
                                 ("contact", lambda one: one["shares"]["contact"]),
                                 ("solver", lambda one: one["shares"]["factors"] + one["shares"]["solutions"]),
                                 ("memory", lambda one: one["memory"])):
                small, large = (statistics.median(map(number, of)) for of in (runs[0], runs[-1]))
                power = math.log(large/small)/math.log(runs[-1][0]["unknowns"]/runs[0][0]["unknowns"])
                powers.append(f"{what} {power:.2f}")
            lines.append(f"- {label}, {ranks} rank{'s' if ranks > 1 else ''}, {runs[0][0]['unknowns']} to "
                         f"{runs[-1][0]['unknowns']} equations: {', '.join(powers)}\n")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog=f"RUN: {', '.join(RUNS)}, {BESIDE}",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asperity", default="build/asperity", metavar="PROGRAM")
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--ranks", default="1,2", metavar="N,...")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("runs", nargs="*", metavar="RUN")
    options = parser.parse_args()
    unknown = set(options.runs) - set(RUNS) - {BESIDE}
    if unknown:
        parser.error(f"there is no run {', '.join(sorted(unknown))}, but {', '.join(RUNS)}, {BESIDE}")
    folder = os.path.join(options.output, "ranks")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, STROKE[1]), "w", encoding="ascii") as file:
        file.write(HISTORY)
    for name in options.runs or USUAL:
        for path in glob.glob(os.path.join(folder, f"{name}{'-*' if name == BESIDE else ''}.*.kept")):
            os.remove(path)
        for repetition in range(options.repetitions):
            for ranks in map(int, options.ranks.split(",")):
                if name != BESIDE:
                    measure(options, name, ranks, repetition)
                elif ranks > 1:
                    for one in BESIDE_RUNS:
                        measure_beside(options, one, ranks, repetition)
    found = kept(folder)
    dates = sorted({one["date"] for of in found.values() for runs in of.values() for one in runs.values()})
    lines = [f"Runs of {', '.join(dates)}; names are sizes of elements in mm, by LU unless they say multigrid.\n",
             "| run | elements | equations | ranks | iterations | time an iteration, s | first row's over it | "
             "memory of a rank, MB | vectors of GMRES an iteration | "
             + " | ".join(f"{share}, %" for share in (*SHARES, "rest")) + " |",
             "|" + "---|"*16]
    for name, by_ranks in found.items():
        lines += rows_of(name, by_ranks)
    powers = growth(found)
    if powers:
        powers = ["\nPowers of the number of equations that an iteration's time and a rank's memory go with:\n\n",
                  *powers]
    powers += ["\n", *ceilings(folder)]
    show(os.path.join(options.output, "ranks.md"), "\n".join(lines) + "\n" + "".join(powers))


if len(sys.argv) > 3 and sys.argv[1] == "--rank":
    be_rank(sys.argv[2], sys.argv[3:])
main()
