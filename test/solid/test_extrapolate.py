#!/usr/bin/env python3
"""Tests of examples/solid_joint/extrapolate.py: series of known limit and order.

usage: test_extrapolate.py      prints `N passed, N failed` at the end
"""

import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "solid_joint"))

# pylint: disable=wrong-import-position
from extrapolate import interpolate, limit

COUNTS = {True: 0, False: 0}
SIZES = (30.0, 20.0, 10.0)


def check(name, good, seen=""):
    COUNTS[bool(good)] += 1
    print(f"{'ok  ' if good else 'FAIL'} {name}" + ("" if good else f"\n     | {seen}"))


def near(first, second, tolerance=1e-9):
    return abs(first - second) <= tolerance*max(1.0, abs(second))


def refused(sizes, values):
    try:
        limit(sizes, values)
    except ValueError:
        return True
    return False


def main():
    for order in (1.1, 1.3, 1.9):
        found = limit(SIZES, [5.0 - 0.02*size**order for size in SIZES])
        check(f"order {order}", near(found.order, order) and near(found.value, 5.0), found)
        check(f"order {order}: the limit is within the uncertainty of the finest",
              found.uncertainty >= 0.02*10.0**order*(1.0 - 1e-9), found)
    # by hand: orders 1 and 2 of values 7 at 20 and 6 at 10 give 5 and 17/3
    for what, values in (("two meshes", (7.0, 6.0)), ("an order of 3", (6.0 + 19.0/7.0, 7.0, 6.0)),
                         ("an order of 0.4", (7.05, 7.0, 6.0)), ("a turn", (6.5, 7.0, 6.0))):
        found = limit(SIZES[-len(values):], values)
        check(f"{what}: linear", near(found.value, 5.0) and near(found.order, 1.0), found)
        check(f"{what}: distance to the finest", near(found.uncertainty, 1.0), found)
    # of sizes 20 and 15, orders 1 and 2 differ by 3 - 9/7 of the last change
    found = limit((20.0, 15.0), (7.0, 6.0))
    check("distance to the finest is the larger one", near(found.uncertainty, 3.0), found)
    found = limit(SIZES, (6.0, 6.0, 6.0))
    check("no change", near(found.value, 6.0) and found.uncertainty < 1e-12, found)
    check("one mesh", refused((10.0,), (1.0,)))
    check("rising sizes", refused((10.0, 20.0), (1.0, 2.0)))
    check("sizes and values", refused((20.0, 10.0), (1.0,)))

    places = [1.0, 2.5, 3.0, 7.0]
    values = [2.0 - place + 3.0*place**2 for place in places]
    check("a parabola", near(interpolate(places, values, 2.2), 2.0 - 2.2 + 3.0*2.2**2))
    check("at a place", near(interpolate(places, values, 2.5), values[1]))
    print(f"{COUNTS[True]} passed, {COUNTS[False]} failed")
    return 1 if COUNTS[False] else 0


if __name__ == "__main__":
    sys.exit(main())
