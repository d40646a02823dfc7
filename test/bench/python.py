#!/usr/bin/env python3
"""Calls of the Python package against the same calls from C, in one process and in turn.

usage: test/bench/python.py [--output FOLDER] [--points 100000] [--repetitions 101]

For the Python that has the package; the C calls are compiled by CC, or cc. FOLDER/python.md is a table of
medians with 10 and 90 % quantiles, and of the ratios of calls that followed each other.
"""
import argparse
import ctypes
import os
import subprocess
import sys
import time

sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
import asperity
import numpy as np
from asperity import _library
from processes import heading, show, spread_text

HERE = os.path.dirname(os.path.abspath(__file__))
LAW_FIELDS = ("pressure", "stiffness", "area_fraction", "contact_density", "energy", "validity")
POINT_FIELDS = ("traction", "tangent", "tangential_energy", "dissipation", "plastic_dissipation",
                "pressure_coupling", "validity")


def compile_calls(folder):
    """The calls from C, as a library."""
    library = os.path.join(folder, "python_calls.so")
    subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-O2", "-Wall", "-Wextra", "-shared", "-fPIC",
                    "-I" + os.path.join(HERE, "../../interface/c"),
                    os.path.join(HERE, "python_calls.c"), "-o", library], check=True)
    return ctypes.CDLL(library)


def seconds_from_c(calls, name, arguments):
    """One call as C makes it."""
    function = getattr(calls, "time_" + name.rsplit("_", maxsplit=1)[-1])
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_void_p, *_library.FUNCTIONS[name]]
    found = function(ctypes.cast(_library._functions[name], ctypes.c_void_p), *arguments)
    if found < 0.0:
        sys.exit(f"python.py: error: asperity_{name} failed")
    return found


def seconds(action):
    """One call from Python."""
    began = time.perf_counter()
    action()
    return time.perf_counter() - began


def law_case(calls, law, n, names):
    """What times a batch of the law: from C, with out=, with new arrays."""
    d = np.linspace(0.05, 0.25, n)
    out, other = (asperity.LawValues.empty(n, *names) for _ in range(2))

    def from_c():
        return seconds_from_c(calls, "law_evaluate", (
            law._handle, n, d.ctypes.data, *other._addresses((n,), *LAW_FIELDS)))

    def new_arrays():
        law.evaluate(d, out=asperity.LawValues.empty(n, *names))

    return (from_c, lambda: seconds(lambda: law.evaluate(d, out=out)),
            lambda: seconds(new_arrays))


def contact_case(calls, law, n, names):
    """The same of points that slide back and forth."""
    closure, slip = np.linspace(0.0, 0.15, n), np.full((2, n), 0.05)
    contacts = [asperity.Contact(law, n) for _ in range(3)]
    out, other = (asperity.Response.empty(n, *names) for _ in range(2))

    def from_c():
        slip[:] = -slip
        return seconds_from_c(calls, "states_update", (
            law._handle, contacts[0]._handle, n, closure.ctypes.data, slip.ctypes.data, None, 0.0,
            *other._addresses((n,), *POINT_FIELDS)))

    def new_arrays():
        contacts[2].update(closure, slip, out=asperity.Response.empty(n, *names))

    return (from_c, lambda: seconds(lambda: contacts[1].update(closure, slip, out=out)),
            lambda: seconds(new_arrays))


def spread(values):
    """Median, and in brackets the 10 and 90 % quantiles."""
    low, middle, high = np.quantile(values, [0.1, 0.5, 0.9])
    return spread_text(middle, low, high)


def row(label, n, repetitions, case):
    """Median seconds from C, and both ways from Python as multiples of it."""
    for action in case:  # the first of each does not count
        action()
    runs = [[action() for action in case] for _ in range(repetitions)]
    unit, factor = ("ms", 1e3) if n > 1000 else ("µs", 1e6)
    cells = [spread([factor*run[0] for run in runs]) + " " + unit]
    for i in 1, 2:
        cells.append(spread([run[i]/run[0] for run in runs]) + " times C" if n > 1
                     else spread([factor*run[i] for run in runs]) + " " + unit)
    return f"| {label} | {n} | " + " | ".join(cells) + " |\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", default="build/bench", metavar="FOLDER")
    parser.add_argument("--points", type=int, default=100_000)
    parser.add_argument("--repetitions", type=int, default=101)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    calls = compile_calls(options.output)
    law = asperity.Law(asperity.Properties.from_pair("transverse-tangential", compiled=True))
    lines = ["| | points | from C | from Python with `out=` | with new arrays |\n",
             "|---|---|---|---|---|\n"]
    for n in options.points, 1:
        lines += [
            row("`Law.evaluate`, pressure and stiffness", n, options.repetitions,
                law_case(calls, law, n, ("pressure", "stiffness"))),
            row("`Law.evaluate`, everything", n, options.repetitions,
                law_case(calls, law, n, LAW_FIELDS)),
            row("`Contact.update`, tractions and tangents", n, options.repetitions,
                contact_case(calls, law, n, ("traction", "tangent"))),
            row("`Contact.update`, everything", n, options.repetitions,
                contact_case(calls, law, n, POINT_FIELDS))]
    show(os.path.join(options.output, "python.md"),
         f"Compiled law, numpy {np.__version__}; " + heading(options.repetitions) + "".join(lines))


main()
