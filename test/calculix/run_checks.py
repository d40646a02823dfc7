#!/usr/bin/env python3
"""All checks of CalculiX with UINTER:
run_checks.py STOCK UINTER RECORDER PENALTY EVENTS ASPERITY FOLDER

Programs: a stock ccx, ccx with asperity's UINTER, ccx with recorder.f90, penalty.f and events.for,
and asperity. What a program that is not there (-) would be needed for is left out. Python 3 alone
is needed.
"""

import sys
import time

import test_arguments
import test_cutback
import test_law
import test_lift
import test_mixed
import test_newton
import test_patch
import test_restart
import test_threads
import test_turn
import test_user_file
from harness import COUNTS, group
from rough_law import RoughLaw


def main():
    """Run the groups whose programs are there."""
    stock, uinter, recorder, penalty, events, asperity, folder = sys.argv[1:]
    law = RoughLaw()
    groups = [("law", test_law.law_of_program, law, asperity)]
    for name, angle in (("matching", 0.0), ("tilted", 20.0), ("upright", 90.0), ("offset", 0.0)):
        groups += [(f"patch test, {name}", test_patch.press, law, uinter, folder, name, angle),
                   (f"sliding, {name}", test_patch.sliding, law, uinter, folder, name, angle)]
    for slave, master, most in ((4, 6, 0.18), (6, 4, 0.07)):
        groups += [("meshes that do not match", test_patch.not_matching, law, stock, uinter,
                    folder, slave, master, most)]
    for name, axis in (("the normal", (0, 0, 1)), ("a slip direction", (0, 1, 0)),
                       ("the diagonal", (1, 1, 1))):
        groups += [(f"turned about {name}", test_turn.turned, law, uinter, folder, name, axis)]
    groups += [
        ("sliding over many faces", test_patch.far_sliding, law, stock, uinter, folder),
        ("Newton's method", test_newton.quadratic, law, uinter, folder),
        ("lifted and pressed again, stock", test_lift.stock_keeps_shear, law, stock, folder),
        ("lifted and pressed again", test_lift.uinter_forgets, law, uinter, folder),
        ("refused by a stock ccx", test_mixed.refused, law, stock, folder),
        ("bad decks", test_mixed.bad_decks, law, uinter, folder),
        ("other springs beside UINTER", test_mixed.apart, law, stock, uinter, folder),
        ("a face in two halves", test_mixed.halves, stock, recorder, folder),
        ("arguments", test_arguments.arguments, recorder, folder),
        ("PNEWDT", test_cutback.cutback, recorder, folder),
        ("PNEWDT where increments are fixed", test_cutback.no_automatic_increments, recorder,
         folder),
        ("cutbacks of the solver", test_cutback.solver_cutback, uinter, recorder, law, folder),
        ("restart", test_restart.restart, law, uinter, folder),
        ("threads", test_threads.threads, law, uinter, folder),
        ("what build says", test_user_file.built, events, uinter),
        ("no stress at all", test_user_file.no_stress, events, folder),
        ("the course of a job", test_user_file.course, events, folder),
        ("the end by URDFIL", test_user_file.stopped, events, folder),
        ("a slave surface of nodes", test_user_file.node_surface, events, folder),
        ("outputs that are not set", test_user_file.poison, penalty, uinter, law, folder),
        ("pairs that are not node to surface", test_user_file.pairs, stock, events, folder),
    ]
    began = time.monotonic()
    for name, function, *arguments in groups:
        if "-" in arguments:
            print(f"-- {name}: left out, a program is missing")
        else:
            group(name, function, *arguments)
    print(f"{time.monotonic() - began:.0f} s")
    print(f"{COUNTS['passed']} passed, {COUNTS['failed']} failed")
    return COUNTS["failed"] > 0 or COUNTS["passed"] == 0


if __name__ == "__main__":
    sys.exit(main())
