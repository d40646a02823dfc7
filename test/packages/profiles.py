"""Profiles by asperity beside numpy, as sdfio, x3pio and numpy write them: moments by their
definition, Nayak's route, the robust filter by direct sums."""

import math

import numpy as np
import sdfio
import x3pio
from table import check

STEP = 0.01  # mm
POINTS = 400
CUTOFF = 0.8
SAME, FILTERED = 1e-10, 1e-7


def wood(seed):
    """Roughness, a wave and pores with flanks, in mm."""
    random = np.random.RandomState(seed)
    x = STEP*np.arange(POINTS)
    z = 0.01*np.cos(2*np.pi*x/5 + seed)
    for _ in range(30):
        z += 0.0008*np.cos(2*np.pi*(x/random.uniform(0.08, 0.5) + random.uniform()))
    middle = (x + 0.19*seed) % 0.7 - 0.35
    return z - np.where(abs(middle) < 0.1, 0.045*np.cos(np.pi*middle/0.2)**2, 0)


def levelled(z):
    """Above the least-squares line."""
    x = np.arange(len(z))
    return z - np.polyval(np.polyfit(x, z, 1), x)


def robust_line(z, order_2):
    """The line of the robust Gaussian regression filter, by the sums of every point over all."""
    x = (np.arange(len(z))[None, :] - np.arange(len(z))[:, None])*STEP/CUTOFF
    weights, before = np.ones(len(z)), None
    for turn in range(200):
        g = order_2 if turn > 2 else math.sqrt(math.log(2)/math.pi)
        s = np.exp(-np.pi*(x/g)**2)*weights
        if turn > 2:
            powers = [(x/g)**p for p in range(5)]
            matrix = np.array([[(s*powers[p + q]).sum(1) for q in range(3)] for p in range(3)])
            right = np.array([(s*powers[p])@z for p in range(3)])
            line = np.linalg.solve(np.moveaxis(matrix, 2, 0), right.T[:, :, None])[:, 0, 0]
        else:
            line = (s@z)/s.sum(1)
        c = 4.4478*np.median(abs(z - line))
        if turn > 3 and abs(line - before).max() <= 1e-4*c:
            return line
        weights = np.where(abs(z - line) < c, (1 - ((z - line)/c)**2)**2, 0)
        before = line
    raise RuntimeError("the robust filter has not settled")


def moments(profiles):
    """m0, m2, m4 of all together."""
    z = np.concatenate(profiles)
    return (np.var(z), np.mean(np.concatenate([np.diff(p) for p in profiles])**2)/STEP**2,
            np.mean(np.concatenate([np.diff(p, 2) for p in profiles])**2)/STEP**4)


def written(folder, number, z):
    """Files of one profile: (name of the writer, path, options)."""
    path = folder/f"profile_{number}"
    np.savetxt(path.with_suffix(".txt"), np.c_[STEP*np.arange(POINTS), z], fmt="%.17g")
    yield "numpy", path.with_suffix(".txt"), ("--lateral-unit", "mm", "--height-unit", "mm")
    sdfio.write(path.with_suffix(".sdf"), 1e-3*z[None, :], x_scale=1e-3*STEP, y_scale=1e-3)
    yield "sdfio", path.with_suffix(".sdf"), ()
    x3pio.write(path.with_suffix(".x3p"), 1e-3*z, x_scale=1e-3*STEP)
    yield "x3pio", path.with_suffix(".x3p"), ()


def compare_profiles(program, _table):
    """Five profiles together, and one in every format."""
    heights = [wood(seed) for seed in range(5)]
    files = [list(written(program.folder, i, z)) for i, z in enumerate(heights)]
    for k in range(3):
        writer, first, options = files[0][k]
        for number, chosen in ((1, [levelled(heights[0])]), (5, [levelled(z) for z in heights])):
            others = [str(f[k][1]) for f in files[1:number]]
            off = difference(program.values(first, *others, *options), moments(chosen))
            check(f"{number} profiles of {writer}: moments and Nayak's route by numpy", off <= SAME,
                  f"{off:.1e} off (at most {SAME:.0e})")
    u = 1.678346990016661  # (1 + u) exp(-u) = 1/2
    left = [levelled(z) for z in heights]
    left = [levelled(z - robust_line(z, math.sqrt(u/math.pi))) for z in left]
    others = [str(f[1][1]) for f in files[1:]]
    off = difference(program.values(files[0][1][1], *others, "--long-cutoff", str(CUTOFF),
                                    "--long-filter", "robust"), moments(left))
    check("robust filter: moments and Nayak's route by numpy", off <= FILTERED,
          f"{off:.1e} off (at most {FILTERED:.0e})")


def difference(ours, theirs):
    """Largest relative difference of the moments and of what Nayak makes of them."""
    m0, m2, m4 = theirs
    expected = {"m0": m0, "m2": m2, "m4": m4, "eta_nayak": m4/m2/(6*math.pi*math.sqrt(3)),
                "radius_nayak": 0.375*math.sqrt(math.pi/m4),
                "sigma_nayak": math.sqrt(m0 - (1 - 3*math.sqrt(3) + 16/math.pi)*m2**2/m4)}
    return max(abs(ours[name]/value - 1) for name, value in expected.items())
