#!/usr/bin/env python3
"""`asperity solid` on several ranks: how the time of an iteration falls, and where it goes.

usage: test/bench/ranks.py [--asperity PROGRAM] [--output FOLDER] [--mesh-size 20,15] [--ranks 1,2]
                           [--repetitions 3] [--amplitude 8 | --stroke 48] [--with "OPTIONS"]

One plastic cycle of the paper's joint under the rough law on each mesh, or one stroke from rest, by all
numbers of ranks in turn, one thread each. OPTIONS are those of `asperity solid`, for all runs, such as
"--rim-mesh-size 5 --preconditioner multigrid". FOLDER/ranks.md is a table of medians with the least and the largest; a ratio is
that of two runs that followed each other. Growth is the power of the number of equations that the time
goes with between the smallest and the largest mesh.
"""
import argparse
import glob
import json
import math
import os
import resource
import shlex
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
from processes import heading, run, show, spread

CASE = ["examples/tenon_joint/base.nml", "--contact", "rough"]
# Of the JSON's times, each of the rank that it took longest; what is left is the rest
SHARES = ["elements", "contact", "exchange", "patterns", "factors", "solutions"]
LAUNCH = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
if os.getuid() == 0:
    LAUNCH.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})


def be_rank(folder, command):
    """Run a command in place of a rank and write down the memory that it took, MB."""
    status = subprocess.call(command)
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
    with open(os.path.join(folder, f"memory.{rank}"), "w", encoding="utf-8") as file:
        file.write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss/1024))
    sys.exit(status)


def programme(options):
    """Options of what is done to the joint."""
    if options.stroke is None:
        return ["--amplitudes", options.amplitude, "--cycles", "1"]
    path = os.path.join(options.output, "stroke.csv")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"displacement (mm)\n0\n{options.stroke}\n")
    return ["--history", path]


def measure(options, mesh, ranks):
    """One run: its sizes, time an iteration, memory of the largest rank, and shares of its time."""
    stem = os.path.join(options.output, "ranks")
    for left in glob.glob(f"{stem}.*.checkpoint") + glob.glob(os.path.join(options.output, "memory.*")):
        os.remove(left)
    command = [sys.executable, __file__, "--rank", options.output, options.asperity, "solid", *CASE,
               *programme(options), "--mesh-size", mesh, *shlex.split(options.more), "--checkpoint", stem,
               "--json", f"{stem}.json"]
    run(["mpirun", "-q", "-n", str(ranks), *command], f"{stem}.log", LAUNCH)
    with open(f"{stem}.json", encoding="utf-8") as file:
        found = json.load(file)
    found, times = found["analysis"], found["times"]
    if times["ranks"][0] != ranks:
        sys.exit(f"ranks.py: error: {ranks} ranks were started, {times['ranks'][0]} ran")
    memory = []
    for path in glob.glob(os.path.join(options.output, "memory.*")):
        with open(path, encoding="utf-8") as file:
            memory.append(float(file.read()))
    time, iterations = found["time"][0], found["iterations"][0]
    shares = [100*times[f"{name}_seconds"][0]/time for name in SHARES]
    return {"elements": found["elements"][0], "unknowns": found["unknowns"][0],
            "iterations": iterations, "seconds": time/iterations, "memory": max(memory),
            "shares": shares + [100 - sum(shares)]}


def rows_of(mesh, found, numbers):
    """The rows of one mesh: `found` has a list of runs for each number of ranks."""
    lines = []
    for ranks in numbers:
        runs = found[ranks]
        ratios = [one["seconds"]/many["seconds"] for one, many in zip(found[numbers[0]], runs)]
        shares = [statistics.median(share) for share in zip(*(one["shares"] for one in runs))]
        lines.append(" | ".join([
            f"| {mesh} mm, {runs[0]['elements']}, {runs[0]['unknowns']}", str(ranks),
            spread([one["iterations"] for one in runs]), spread([one["seconds"] for one in runs]),
            spread(ratios), spread([one["memory"] for one in runs])]
            + [f"{share:.0f}" for share in shares]) + " |")
    return lines


def growth(found, numbers):
    """How time and memory grow with the equations, by the number of ranks."""
    meshes = sorted(found, key=lambda mesh: found[mesh][numbers[0]][0]["unknowns"])
    words = []
    for ranks in numbers:
        small, large = (found[mesh][ranks] for mesh in (meshes[0], meshes[-1]))
        step = math.log(large[0]["unknowns"]/small[0]["unknowns"])
        time, memory = (math.log(statistics.median(b[name] for b in large)
                                 / statistics.median(a[name] for a in small))/step
                        for name in ("seconds", "memory"))
        words.append(f"{ranks}: {time:.2f}, {memory:.2f}")
    return ("Growth of the time of an iteration and of memory with the equations, as powers, by ranks: "
            + "; ".join(words) + ".\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asperity", default="build/asperity", metavar="PROGRAM")
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--mesh-size", default="20,15", metavar="MM,...")
    parser.add_argument("--ranks", default="1,2", metavar="N,...")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--amplitude", default="8", metavar="MM")
    parser.add_argument("--stroke", metavar="MM")
    parser.add_argument("--with", dest="more", default="", metavar="OPTIONS")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    numbers = [int(n) for n in options.ranks.split(",")]
    found = {}
    for mesh in options.mesh_size.split(","):
        found[mesh] = {ranks: [] for ranks in numbers}
        for _ in range(options.repetitions):
            for ranks in numbers:
                one = measure(options, mesh, ranks)
                found[mesh][ranks].append(one)
                print(f"{mesh} mm, {ranks} ranks: {one['seconds']:.3g} s for each of "
                      f"{one['iterations']} iterations, {one['memory']:.0f} MB", flush=True)
    names = [*SHARES, "rest"]
    lines = ["| mesh, elements, equations | ranks | iterations | time an iteration, s | "
             f"{numbers[0]} rank's over it | memory of a rank, MB | "
             + " | ".join(f"{name}, %" for name in names) + " |", "|" + "---|"*13]
    for mesh, runs in found.items():
        lines += rows_of(mesh, runs, numbers)
    text = heading(options.repetitions) + "\n".join(lines) + "\n"
    if len(found) > 1:
        text += "\n" + growth(found, numbers)
    show(os.path.join(options.output, "ranks.md"), text)


if len(sys.argv) > 3 and sys.argv[1] == "--rank":
    be_rank(sys.argv[2], sys.argv[3:])
main()
