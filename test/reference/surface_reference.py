#!/usr/bin/env python3
"""Small maps and their parameters for test/data/surface_reference.txt, by surface_statistics.py.

    python3 surface_reference.py > OUTPUT.txt

Needs numpy. A map is a line `NAME NX NY STEP_X STEP_Y SHARE DEGREE`, steps in mm, then its heights
in units of 1e-5 mm, one profile along x a line, -1000000 where nothing was measured, then its
parameters, `NAME VALUE` a line, to `end`.
"""
import numpy as np
from surface_statistics import statistics

UNIT, MISSING = 1e-5, -1000000


def waves(nx, ny, across, along, turned, seed):
    """Gaussian map with unit Sq: noise times a Gaussian in the frequencies, lengths in steps."""
    q_x, q_y = 2*np.pi*np.fft.fftfreq(nx)[None, :], 2*np.pi*np.fft.fftfreq(ny)[:, None]
    c, s = np.cos(np.radians(turned)), np.sin(np.radians(turned))
    z = np.fft.ifft2(np.fft.fft2(np.random.RandomState(seed).standard_normal((ny, nx)))
                     * np.exp(-((across*(c*q_x + s*q_y))**2 + (along*(c*q_y - s*q_x))**2)/8)).real
    return z/z.std()


def all_maps():
    """(name, heights in units, step_x, step_y, share, degree)"""
    y, x = np.indices((24, 40))
    yield "isotropic", 300*waves(40, 24, 3, 3, 0, 1), 0.002, 0.002, 0.05, 1
    yield "lay", 200*waves(36, 48, 2, 8, 35, 2), 0.002, 0.003, 0.05, 1
    yield "tilted", 100*waves(40, 24, 2, 2, 0, 3) + 900*x - 1300*y + 70000, 0.005, 0.004, 0.1, 1
    yield "curved", 80*waves(40, 24, 3, 2, 0, 4) + 2*(x - 9)**2 - 3*(y - 5)**2 + x*y, 0.01, 0.01, \
        0.02, 2
    yield "stepped", 3*waves(40, 24, 2, 2, 0, 5), 0.001, 0.001, 0.05, 1
    holed = 150*waves(40, 24, 3, 3, 0, 6)
    holed[np.random.RandomState(7).uniform(size=holed.shape) < 0.03] = np.nan
    holed[:9, 14:17] = holed[20:, :5] = np.nan
    yield "holed", holed, 0.002, 0.002, 0.05, 1


def main():
    """The program."""
    for name, heights, step_x, step_y, share, degree in all_maps():
        heights = np.round(heights)
        ny, nx = heights.shape
        print(name, nx, ny, step_x, step_y, share, degree)
        for row in np.where(np.isnan(heights), MISSING, heights).astype(int):
            print(*row)
        for parameter, value in statistics(heights*UNIT, step_x, step_y, share, degree).items():
            print(parameter, repr(value))
        print("end")


if __name__ == "__main__":
    main()
