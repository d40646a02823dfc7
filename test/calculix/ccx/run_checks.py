#!/usr/bin/env python3
"""All checks of CalculiX with UINTER:
run_checks.py STOCK UINTER RECORDER PENALTY EVENTS ASPERITY FOLDER

Programs: a stock ccx, ccx with asperity's UINTER, ccx with recorder.f90, penalty.f and events.for,
and asperity. What a program that is not there (-) would be needed for is left out. Python 3 alone
is needed.
"""

import sys
import time

from checks import (arguments, cutback, first_run, law, lift, mixed, newton, patch, restart,
                    threads, turn, two_d, user_file)
from harness import COUNTS, group
from rough_law import RoughLaw


def main():
    """Run the groups whose programs are there."""
    stock, uinter, recorder, penalty, events, asperity, folder = sys.argv[1:]
    rough = RoughLaw()
    groups = [("law", law.law_of_program, rough, asperity)]
    for name, angle in (("matching", 0.0), ("tilted", 20.0), ("upright", 90.0), ("offset", 0.0)):
        groups += [(f"patch test, {name}", patch.press, rough, uinter, folder, name, angle),
                   (f"sliding, {name}", patch.sliding, rough, uinter, folder, name, angle)]
    for slave, master, most in ((4, 6, 0.18), (6, 4, 0.07)):
        groups += [("meshes that do not match", patch.not_matching, rough, stock, uinter,
                    folder, slave, master, most)]
    for name, axis in (("the normal", (0, 0, 1)), ("a slip direction", (0, 1, 0)),
                       ("the diagonal", (1, 1, 1))):
        groups += [(f"turned about {name}", turn.turned, rough, uinter, folder, name, axis)]
    groups += [
        ("sliding over many faces", patch.far_sliding, rough, stock, uinter, folder),
        ("Newton's method", newton.quadratic, rough, uinter, folder),
        ("lifted and pressed again, stock", lift.stock_keeps_shear, rough, stock, folder),
        ("lifted and pressed again", lift.uinter_forgets, rough, uinter, folder),
        ("two dimensions", two_d.two_dimensions, rough, uinter, events, folder),
        ("the first run in ABAQUS", first_run.first_run, uinter, asperity, folder),
        ("refused by a stock ccx", mixed.refused, rough, stock, folder),
        ("bad decks", mixed.bad_decks, rough, uinter, folder),
        ("other springs beside UINTER", mixed.apart, rough, stock, uinter, folder),
        ("a face in two halves", mixed.halves, stock, recorder, folder),
        ("arguments", arguments.arguments, recorder, folder),
        ("PNEWDT", cutback.cutback, recorder, folder),
        ("PNEWDT where increments are fixed", cutback.no_automatic_increments, recorder,
         folder),
        ("cutbacks of the solver", cutback.solver_cutback, uinter, recorder, rough, folder),
        ("restart", restart.restart, rough, uinter, folder),
        ("threads", threads.threads, rough, uinter, folder),
        ("what build says", user_file.built, events, uinter),
        ("no stress at all", user_file.no_stress, events, folder),
        ("the course of a job", user_file.course, events, folder),
        ("the end by URDFIL", user_file.stopped, events, folder),
        ("a slave surface of nodes", user_file.node_surface, events, folder),
        ("outputs that are not set", user_file.poison, penalty, uinter, rough, folder),
        ("pairs that are not node to surface", user_file.pairs, stock, events, folder),
    ]
    began = time.monotonic()
    for name, function, *inputs in groups:
        if "-" in inputs:
            print(f"-- {name}: left out, a program is missing")
        else:
            group(name, function, *inputs)
    print(f"{time.monotonic() - began:.0f} s")
    print(f"{COUNTS['passed']} passed, {COUNTS['failed']} failed")
    return COUNTS["failed"] > 0 or COUNTS["passed"] == 0


if __name__ == "__main__":
    sys.exit(main())
