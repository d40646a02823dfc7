#!/usr/bin/env python3
"""`asperity fit` beside SciPy's least_squares: fit.py ASPERITY FOLDER

The same press records, with noise of a printed seed, are fitted by both; SciPy has a law of its own here,
integrated by other points. Values agree to 1e-4 of their intervals, ends of intervals to 1e-3 of them.
One line per check; the last line is `N passed, N failed`."""

import json
import pathlib
import subprocess
import sys

import numpy
import scipy
from scipy.optimize import least_squares
from scipy.stats import t as student

SEED = 20210101
TRUTH = {"eta": 206.0, "modulus": 297.0, "radius": 0.1477, "hardness": 24.53, "yield_factor": 0.4,
         "sigma": 0.0593, "initial_separation": 0.2372, "machine_compliance": 0.0}
# Varied by their logarithms
RATIOS = {"eta", "modulus", "radius", "hardness", "yield_factor", "sigma"}
RATIO = 110.0
NODES, WEIGHTS = numpy.polynomial.legendre.leggauss(60)
passed = failed = 0


def check(name, fine):
    """Count and tell."""
    global passed, failed
    passed, failed = passed + fine, failed + (not fine)
    print(("ok   " if fine else "FAIL ") + name)


def law(separation, n):
    """Pressure of Gaussian heights, panel by panel over the deformation of a summit."""
    d = separation[:, None]
    root = numpy.sqrt(n["radius"])
    w1 = (3*numpy.pi*n["yield_factor"]*n["hardness"]/(4*n["modulus"]))**2*n["radius"]
    w2 = RATIO*w1
    n1 = 4/3*n["modulus"]*root*w1**1.5
    b3 = 1 + numpy.log(2/n["yield_factor"])/numpy.log(RATIO)

    def force(w):
        return numpy.where(w < w1, 4/3*n["modulus"]*root*w**1.5, numpy.where(
            w < w2, n1*(w/w1)**b3, 2*numpy.pi*n["radius"]*n["hardness"]*w))

    highest = numpy.maximum(-separation, 0) + 12*n["sigma"]
    total = numpy.zeros_like(separation)
    for low, high in ((0*highest, w1 + 0*highest), (w1 + 0*highest, w2 + 0*highest),
                      (w2 + 0*highest, numpy.maximum(w2, highest))):
        shares = (0, 0.02, 0.1, 0.3, 0.6, 1)
        for a, b in zip(shares[:-1], shares[1:]):
            left, right = low + a*(high - low), low + b*(high - low)
            half = ((right - left)/2)[:, None]
            w = (left + right)[:, None]/2 + half*NODES
            density = numpy.exp(-0.5*((d + w)/n["sigma"])**2)/(n["sigma"]*numpy.sqrt(2*numpy.pi))
            total += numpy.sum(half*WEIGHTS*force(w)*density, axis=1)
    return n["eta"]*total


def pressures(closure, n):
    """p = law(closure - compliance p), by halving."""
    high = law(n["initial_separation"] - closure, n)
    if n["machine_compliance"] == 0:
        return high
    low = numpy.zeros_like(high)
    for _ in range(60):
        p = (low + high)/2
        above = law(n["initial_separation"] - closure + n["machine_compliance"]*p, n) > p
        low, high = numpy.where(above, p, low), numpy.where(above, high, p)
    return (low + high)/2


def fitted(closure, pressure, free, scale, known):
    """Values and ends of 95 % intervals by SciPy."""
    def numbers(y):
        return {**known, **{name: numpy.exp(v) if name in RATIOS else v for name, v in zip(free, y)}}

    def residuals(y):
        return (pressures(closure, numbers(y)) - pressure)/scale

    start = [numpy.log(known[name]) if name in RATIOS else known[name] for name in free]
    found = least_squares(residuals, start, jac="3-point", x_scale="jac", xtol=1e-14, ftol=1e-14,
                          gtol=1e-14)
    degrees = len(closure) - len(free)
    covariance = numpy.linalg.inv(found.jac.T@found.jac)*2*found.cost/degrees
    half = student.ppf(0.975, degrees)*numpy.sqrt(numpy.diag(covariance))
    ends = [numbers(found.x - half), numbers(found.x + half)]
    return [[n[name] for name in free] for n in (numbers(found.x), *ends)]


def compare(name, asperity, folder, free, noise, compliance, relative):
    """One record by both."""
    known = {**TRUTH, "machine_compliance": compliance}
    path = folder/f"{name}.csv"
    subprocess.run([asperity, "press", "--peak", "3", "--increments", "50", "--csv", str(path)],
                   check=True, stdout=subprocess.DEVNULL)
    table = numpy.genfromtxt(path, delimiter=",", skip_header=1, usecols=(1, 3))[1:51]
    random = numpy.random.default_rng(SEED)
    closure = table[:, 0] + compliance*table[:, 1]
    size = table[:, 1] if relative else table[-1, 1]
    pressure = table[:, 1] + noise*size*random.standard_normal(len(closure))
    numpy.savetxt(path, numpy.column_stack([closure, pressure]), delimiter=",", fmt="%.17g",
                  header="closure (mm),pressure (MPa)", comments="")
    fixed = ",".join(f"{key}={value!r}" for key, value in known.items() if key not in free)
    result = folder/f"{name}.json"
    # the middle of wide bounds, 10 to 1000 times off
    subprocess.run([asperity, "fit", str(path), "--kind", "press", "--free", ",".join(free), "--fix",
                    fixed, "--json", str(result), "--residual-scale",
                    "relative" if relative else "absolute"], check=True, stdout=subprocess.DEVNULL)
    found = json.loads(result.read_text(encoding="utf-8"))["summary"]
    largest = numpy.max(numpy.abs(pressure))
    scale = numpy.maximum(numpy.abs(pressure), 0.01*largest) if relative else largest
    values, low, high = fitted(closure, pressure, free, scale, known)
    for i, key in enumerate(free):
        width = high[i] - low[i]
        check(f"{name}: {key} {values[i]:.6g}, asperity {found['value'][i]:.6g}",
              abs(found["value"][i] - values[i]) < 1e-4*width)
        check(f"{name}: {key} from {low[i]:.6g} to {high[i]:.6g}, asperity from "
              f"{found['low_95'][i]:.6g} to {found['high_95'][i]:.6g}",
              max(abs(found["low_95"][i] - low[i]), abs(found["high_95"][i] - high[i])) < 1e-3*width)


def main():
    """All records."""
    asperity, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    print(f"SciPy {scipy.__version__}, seed {SEED}")
    compare("three", asperity, folder, ["eta", "sigma", "initial_separation"], 0.002, 0.0, False)
    compare("relative", asperity, folder, ["eta", "sigma", "initial_separation"], 0.002, 0.0, True)
    compare("machine", asperity, folder, ["eta", "initial_separation", "machine_compliance"], 0.005,
            0.005, False)
    compare("four", asperity, folder, ["eta", "hardness", "sigma", "initial_separation"], 2e-5, 0.0,
            False)
    print(f"{passed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
