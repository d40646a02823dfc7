#!/usr/bin/env python3
"""Tests of examples/solid_joint/extrapolate.py: series of known limit and order.

usage: test_extrapolate.py      prints `N passed, N failed` at the end
"""

import math
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
    for order, factor in ((0.5, 3.0), (0.6, 3.0), (0.99, 3.0), (1.0, 1.25), (1.3, 1.25), (2.0, 1.25)):
        # at a bound the fit may fall on either side: a hair within
        exact = order + {0.5: 1e-9, 1.0: 1e-9, 2.0: -1e-9}.get(order, 0.0)
        found = limit(SIZES, [5.0 - 0.02*size**exact for size in SIZES])
        check(f"order {order}", near(found.order, order, 1e-6) and near(found.value, 5.0, 1e-6), found)
        check(f"order {order}: {factor} times what the finest is off",
              near(found.uncertainty, factor*0.02*10.0**order, 1e-6), found)
    for what, values in (("an order of 0.49", [size**0.49 for size in SIZES]),
                         ("a logarithm", [math.log(size) for size in SIZES]),
                         ("changes that grow", (15.50, 14.63, 12.15))):
        check(f"{what}: nothing can be told", limit(SIZES, values) == (None, None, None), limit(SIZES, values))
    for what, values in (("an order of 2.01", [size**2.01 for size in SIZES]), ("a turn", (6.5, 7.0, 6.0)),
                         ("a stop", (7.0, 6.0, 6.0)), ("no change", (6.0, 6.0, 6.0))):
        found = limit(SIZES, values)
        check(f"{what}: the finest stands, within three ranges", found.value == values[-1] and found.order is None
              and near(found.uncertainty, 3.0*(max(values) - min(values))), found)
    # by hand: equal changes at sizes that fall equally are of order 1; 6 at 10 goes on to 5
    found = limit(SIZES, (8.0, 7.0, 6.0))
    check("linear", near(found.value, 5.0) and near(found.order, 1.0), found)
    check("two meshes", refused((20.0, 10.0), (2.0, 1.0)))
    check("rising sizes", refused((10.0, 20.0, 30.0), (1.0, 2.0, 3.0)))
    check("sizes and values", refused(SIZES, (2.0, 1.0)))

    places = [1.0, 2.5, 3.0, 7.0]
    values = [2.0 - place + 3.0*place**2 for place in places]
    check("a parabola", near(interpolate(places, values, 2.2), 2.0 - 2.2 + 3.0*2.2**2))
    check("at a place", near(interpolate(places, values, 2.5), values[1]))
    print(f"{COUNTS[True]} passed, {COUNTS[False]} failed")
    return 1 if COUNTS[False] else 0


if __name__ == "__main__":
    sys.exit(main())
