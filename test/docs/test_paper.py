#!/usr/bin/env python3
"""Tests of docs/paper: each verdict can be yes and no; a run that is kept says what the run says.

usage: test_paper.py ASPERITY      prints `N passed, N failed` at the end
"""

import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import sys
import tempfile

sys.dont_write_bytecode = True
PAPER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "paper")
sys.path.insert(0, PAPER)

# pylint: disable=wrong-import-position
import joint_rows
import law_rows
import results

COUNTS = {True: 0, False: 0}
AMPLITUDES = (1.0, 4.0, 8.0, 48.0)


def check(name, good, seen=""):
    COUNTS[bool(good)] += 1
    print(f"{'ok  ' if good else 'FAIL'} {name}" + ("" if good else f"\n     | {seen}"))


def script(name):
    """A script of docs/paper as a module."""
    loader = importlib.machinery.SourceFileLoader(name, os.path.join(PAPER, name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def joint(quantity, hard, rough, face=""):
    """A joint of one quantity, a value at each amplitude, or one at the largest."""
    return results.Joint([(quantity, face, *row) for row in zip(AMPLITUDES[-len(hard):], hard, rough)])


def both(*joints):
    return results.Joint([row for one in joints for row in one.rows])


def faces(quantity, upper, lower, unloaded=(0.0, 0.0)):
    return results.Joint([(quantity, "upper", -48.0, *upper), (quantity, "lower", -48.0, *lower),
                          (quantity, "upper", -46.4, *unloaded), (quantity, "lower", -46.4, *unloaded)])


def areas(turn, after):
    return both(faces("area_slip", turn, turn, after), faces("area_stick", (0.0, 0.0), (0.0, 0.0)))


def places(upper, lower):
    return results.Joint([("place", "upper", -48.0, upper, upper), ("place", "lower", -48.0, lower, lower),
                          ("place_deepest", "", -48.0, -300.0, -300.0)])


def moments(down, up):
    return both(joint("negative_moment", *[[-m for m in down]]*2), joint("positive_moment", up, up))


FALLING, RISING = [4.0, 2.0, 1.5, 1.0], [4.0, 2.0, 2.5, 1.0]
# id: a joint of which the paper's statement is true, and one of which it is not
CASES = {
    "F23a": (joint("largest_pull_out", [-5.0], [-9.0]), joint("largest_pull_out", [0.0], [9.0])),
    "F23b": (joint("plastic_dissipation", [9.0], [9.0]), joint("plastic_dissipation", [9.0], [0.0])),
    "F25": (joint("pinching", [0.1], [0.2]), joint("pinching", [0.1], [0.6])),
    "F26a": (joint("energy", [1.0], [1.1]), joint("energy", [1.0], [0.9])),
    "F26b": (joint("negative_moment", [-1.0], [-1.1]), joint("negative_moment", [-1.0], [-0.9])),
    "F27": (joint("secant_stiffness", FALLING, [4.1, 2.05, 3.0, 2.0]),
            joint("secant_stiffness", FALLING, [4.0, 2.2, 1.5, 1.0])),
    "F28a": (moments([1.0, 2.0, 3.0, 3.1], [1.0]*4), moments([1.0, 4.0, 8.0, 48.0], [1.0]*4)),
    "F28b": (moments([1.0]*4, [1.0, 1.0, 1.04, 1.0]), moments([1.0]*4, [1.0, 1.0, 1.0, 1.06])),
    "T5a": (joint("yield_moment", [-1.0], [-1.07]), joint("yield_moment", [-1.0], [-1.06])),
    "T5b": (joint("ultimate_moment", [-1.0], [-1.06]), joint("ultimate_moment", [-1.0], [-1.05])),
    "T5c": (joint("bending_stiffness", [1.0], [1.04]), joint("bending_stiffness", [1.0], [1.02])),
    "F29a": (joint("secant_stiffness", FALLING, FALLING), joint("secant_stiffness", RISING, FALLING)),
    "F29b": (joint("secant_stiffness", FALLING, FALLING),
             joint("secant_stiffness", FALLING, [4.0, 3.5, 3.0, 1.0])),
    "F30": (joint("cumulative_energy", [1.0], [1.1]), joint("cumulative_energy", [1.0], [0.9])),
    "F31": (areas((1.0, 1.1), (1.0, 1.0)), areas((1.0, 0.9), (1.0, 2.0))),
    "F32": (areas((1.0, 1.0), (1.0, 1.1)), areas((1.0, 2.0), (1.0, 0.9))),
    "F33a": (faces("largest_pressure", (1.0, 1.0), (2.0, 2.2)),
             faces("largest_pressure", (1.0, 1.5), (2.0, 2.1))),
    "F33b": (places(-298.0, -5.0), places(-298.0, -150.0)),
    "F34a": (joint("peak_force", [0.0, 1.0, 1.0, 1.0], [1.0, 1.01, 1.1, 1.2]),
             joint("peak_force", [1.0]*4, [1.2, 1.1, 1.0, 1.0])),
    "F34b": (joint("peak_force", [1.0], [1.1]), joint("peak_force", [1.0], [0.9])),
    "F35a": (joint("friction_dissipation", [1.0], [1.1]), joint("friction_dissipation", [1.0], [0.9])),
    "F35b": (joint("friction_dissipation", [0.0]*4, [0.0, 1.0, 2.0, 3.0]),
             joint("friction_dissipation", [0.0]*4, [0.0, 3.0, 2.0, 1.0])),
}


def verdicts():
    checks = {row[0]: row[3] for row in joint_rows.ROWS}
    check("every row of the joint is tested", checks.keys() == CASES.keys(), checks.keys() ^ CASES.keys())
    for name, (true, false) in CASES.items():
        seen = checks[name](true)[0], checks[name](false)[0]
        check(f"{name}: yes and no", seen == ("yes", "no"), seen)
    check("percent: no sign of nothing", joint_rows.percent(0.99999) == "0.0 %"
          and joint_rows.percent(1.0123) == "+1.2 %", joint_rows.percent(0.99999))


def coverage():
    write = script("write")
    seen = write.covered([("a", "Eqs 1-3, Figs 23b, 24, Table 4, conclusion 2"), ("b", "Eq. 23, Fig. 6")])
    check("what rows cover", seen == {("Eq", 1), ("Eq", 2), ("Eq", 3), ("Fig", 23), ("Fig", 24),
                                      ("Table", 4), ("conclusion", 2), ("Eq", 23), ("Fig", 6)}, seen)


def kept(path):
    """What `keep` writes of a replay gives the same cells as the replay."""
    program, keep, write = results.Program(path), script("keep"), script("write")
    answer = program.run("tenon", law_rows.CASE, "--face-points", "40", "--side-points", "4",
                         "--displacement-increment", "2")
    with tempfile.TemporaryDirectory() as folder:
        run, file = (os.path.join(folder, name) for name in ("run.json", "solid.csv"))
        with open(run, "w", encoding="utf-8") as out:
            json.dump(answer, out)
        sys.argv = ["keep", run, "asperity solid"]
        with open(file, "w", encoding="ascii") as out, contextlib.redirect_stdout(out):
            keep.main()
        other, command = results.read(file)
    check("the command is kept", command == "asperity solid", command)
    direct = results.Joint(results.from_json(answer))
    faces = answer["faces"]
    faces["displacement"] = [u + (1e-12 if model == "rough" else 0.0)
                             for u, model in zip(faces["displacement"], faces["model"])]
    check("displacements that differ by round-off are one", results.from_json(answer) == direct.rows)
    for name, _, _, row, _ in joint_rows.ROWS:
        cells = [write.cell(row, model) for model in (direct, other)]
        check(f"{name}: kept", cells[0] == cells[1] and (cells[0] or name == "F33b"), cells)
    check("no file, no cells", results.read("nowhere.csv") == (None, "")
          and write.cell(joint_rows.fuller, None) == "")
    with contextlib.redirect_stderr(io.StringIO()):
        try:
            program.run("tenon", "--height", "-1")
            check("a run that fails ends the page", False)
        except SystemExit as end:
            check("a run that fails ends the page", "height = -1" in str(end), end)


def main():
    verdicts()
    coverage()
    kept(sys.argv[1])
    print(f"{COUNTS[True]} passed, {COUNTS[False]} failed")
    return COUNTS[False] > 0


if __name__ == "__main__":
    sys.exit(main())
