#!/usr/bin/env python3
"""Force of OpenSees' materials along paths, for test/data/opensees_reference.csv.

    python3 opensees_reference.py > OUTPUT.csv
    python3 opensees_reference.py --check TABLE.csv

It needs openseespy, 3.7.1.2. The numbers of the materials are those of test/frame/rules.f90. With
--check, the last line is `N passed, N failed`: whether openseespy still gives the table to 1e-12.
"""
import os
import sys

import openseespy.opensees as ops

NO_DAMAGE = [0.0]*15 + [10.0, 'cycle']
PINCHING = ['Pinching4', 10.0, 1.0, 16.0, 4.0, 20.0, 8.0, 21.0, 20.0,
            -12.0, -1.0, -18.0, -4.0, -22.0, -8.0, -23.0, -20.0,
            0.5, 0.25, 0.05, 0.4, 0.3, 0.1] + NO_DAMAGE
UNEVEN = ['Pinching4', 10.0, 2.0, 16.0, 4.0, 20.0, 8.0, 15.0, 20.0,
          -12.0, -1.0, -18.0, -4.0, -22.0, -8.0, -20.0, -20.0,
          0.5, 0.25, 0.05, 0.4, 0.3, 0.1] + NO_DAMAGE
EARLY = ['Pinching4', 0.68, 0.74, 12.1, 6.8, 17.9, 13.6, 21.3, 22.4,
         -1.14, -0.59, -10.0, -5.4, -15.0, -10.8, -18.6, -17.8,
         0.07, 0.4, 0.0014, 0.25, 0.37, 0.016] + NO_DAMAGE
STIFF = ['Pinching4', 6.0, 0.002, 7.0, 0.004, 7.5, 0.01, 7.0, 0.03,
         -5.0, -0.0015, -6.5, -0.004, -6.8, -0.012, -7.1, -0.03,
         0.8, 0.6, 0.4, 0.7, 0.5, 0.3] + NO_DAMAGE
DOWEL = ['DowelType', 6.0, 0.5, 3.0, 0.5, 1.0, 1.0, 0.1, 2.0, 0.5, 0.2, 0.3, '-bezier',
         1.5, 12.0, 4.0, 18.0, 20.0, 25.0, 1.0, -1.2, -11.0, -5.0, -19.0, -18.0, -24.0, 0.8]
ROUND = DOWEL[:4] + [1.5] + DOWEL[5:]
GAP = ['ElasticMultiLinear', '-strain', -8.0, -6.0, -4.0, -2.0, 1.0, 3.0, 5.0, 7.0,
       '-stress', -9.0, -7.0, -4.0, 0.0, 0.0, 3.0, 8.0, 10.0]
SLIDER = ['ElasticPP', 5.0, 0.4]
GROWING = [0.5, -0.5, 0.5, -2.0, 2.0, -2.0, 6.0, -6.0, 6.0, -6.0, 9.0, -1.0, 9.0, -10.0]
INNER = [6.0, -6.0, 6.0, -2.0, 6.0, -5.0, 3.0, -3.0, 7.0, 3.0, 7.0, -7.0, 6.5, -6.5, 7.0]
# Turns before the envelope of a side is reached, and parts of cycles
TURNS = [4.0, -1.5, 3.0, -0.5, 2.0, -6.0, -4.0, -7.0, 1.0, 9.0, -3.0, -2.0, -3.5, 8.0, 7.6, 9.5,
         -8.0]
CASES = {
    'pinching': ([PINCHING], GROWING + INNER + [25.0, -10.0, 10.0], 0.5),
    'stiff': ([STIFF], [1.0e-3*x for x in GROWING + INNER], 5.0e-4),
    'dowel': ([DOWEL], GROWING, 0.5),
    'dowel_small': ([DOWEL], [4.0, -0.3, 6.0, -1.0, 8.0, -9.0], 0.2),
    'dowel_slider': ([DOWEL, SLIDER], [4.0, -4.0, 4.0, -4.0, 15.0, -15.0, 15.0, -15.0], 0.5),
    'uneven': ([UNEVEN], [-0.5, 1.5, -3.0, 5.0, -9.0, 22.0, -24.0, 10.0], 0.4),
    'early': ([EARLY], TURNS + [0.3, 0.1, 1.5, -0.05, 0.4], 0.4),
    'dowel_turns': ([DOWEL], TURNS, 0.4),
    'dowel_round': ([ROUND], TURNS, 0.4),
    'dowel_inner': ([ROUND], [6.0, -6.0, 6.0, -2.0, 7.0, -7.0, 6.5, -6.5, 3.0, -3.0, 8.0], 0.5),
    'gap': ([GAP], [1.5, -3.0, 6.5, -7.5], 0.5),
}


def path(ends, step):
    """From zero through the ends, in steps of about this size."""
    displacement = [0.0]
    for end in ends:
        begin = displacement[-1]
        steps = max(1, round(abs(end - begin)/step))
        displacement += [begin + (end - begin)*i/steps for i in range(1, steps)] + [end]
    return displacement


def forces(materials, displacement):
    """Force of materials in parallel."""
    total = [0.0]*len(displacement)
    for name, *numbers in materials:
        ops.wipe()
        ops.uniaxialMaterial(name, 1, *numbers)
        ops.testUniaxialMaterial(1)
        for i, x in enumerate(displacement):
            ops.setStrain(x)
            total[i] += ops.getStress()
    return total


def main():
    rows = ['case,displacement,force']
    for case, (materials, ends, step) in CASES.items():
        displacement = path(ends, step)
        force = forces(materials, displacement)
        rows += [f'{case},{x!r},{f!r}' for x, f in zip(displacement, force)]
    if sys.argv[1:2] != ['--check']:
        print('\n'.join(rows))
        return 0
    with open(sys.argv[2]) as table:
        kept = table.read().split('\n')[:-1]
    failed = int(len(kept) != len(rows))
    for old, new in zip(kept[1:], rows[1:]):
        old, new = old.split(','), new.split(',')
        off = abs(float(old[2]) - float(new[2]))
        if old[:2] != new[:2] or off > 1e-12*max(1.0, abs(float(old[2]))):
            failed += 1
            print('FAIL', old, new)
    print(f'{len(rows) - failed} passed, {failed} failed')
    return failed > 0


if __name__ == '__main__':
    status = main()
    # a last word of openseespy's on standard error would stand behind the counts
    sys.stdout.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    raise SystemExit(status)
