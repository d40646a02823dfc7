#!/usr/bin/env python3
"""Reference values at other plastic ratios w2/w1 than 110, for test/data/plastic_ratio_reference.csv.

    python3 plastic_ratio_reference.py > OUTPUT.csv

The law without memory by normal_law_reference.py, in 30 digits, where the retraction is none; the
one with memory by unloading_reference.py, in 25.
"""
import csv
import random
import sys

import mpmath as mp
import normal_law_reference as virgin
import unloading_reference as memory

RATIOS = 10.0, 54.0, 200.0, 1000.0
NONE = -1.0


def cases():
    stream = random.Random(54)
    for i in range(80):
        plastic_ratio = RATIOS[i % 4] if i % 8 < 4 else float(f"{10**stream.uniform(1, 3):.4g}")
        w1_ratio = 10**stream.uniform(-8, 3)
        h = stream.uniform(-40, 37) if i % 2 else stream.uniform(-6, 6)
        values = memory.properties(w1_ratio, float(f"{stream.uniform(0.05, 1):.4g}"), stream)
        yield plastic_ratio, values, float(f"{h:.5g}")*values[0], NONE
    for plastic_ratio in RATIOS:
        for w1_ratio in 1e-8, 1e-4, 0.02, 1.0:
            for h in -2.0, 3.0:
                yield plastic_ratio, (values := memory.properties(w1_ratio, 0.4, stream)), h*values[0], NONE
    for i in range(80):
        plastic_ratio = RATIOS[i % 4] if i % 8 < 4 else float(f"{10**stream.uniform(1, 3):.4g}")
        w1_ratio = 10**(stream.uniform(-6, 2) if i % 2 else stream.uniform(-4, 0))
        least = 2.0001/plastic_ratio**0.5
        yield_factor = least if i % 5 == 0 else float(f"{stream.uniform(least, 1):.4g}")
        values = memory.properties(w1_ratio, yield_factor, stream)
        d = float(f"{stream.uniform(-8, 8):.5g}")*values[0]
        part = stream.uniform(0, 1) if i % 3 else 10**stream.uniform(-8, 0)
        yield plastic_ratio, values, d, part*memory.farthest(values, d, plastic_ratio)


def main():
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["plastic_ratio", *memory.INPUTS, *memory.OUTPUTS])
    for plastic_ratio, values, d, retraction in cases():
        if retraction < 0:
            result = virgin.verified([*values, d], plastic_ratio)
            result = [*result[:5], mp.mpf(0), *result[5:8]]
        else:
            result = memory.verified([*values, d, retraction], plastic_ratio)
        out.writerow([*map(repr, [plastic_ratio, *values, d, retraction]),
                      *(mp.nstr(v, 25) if v > mp.mpf(2)**-1075 else "0.0" for v in result)])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
