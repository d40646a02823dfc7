"""`asperity fit --kind shear` beside SciPy's least_squares on a model of its own: friction with an elastic
slip in series with a machine, written here anew.

usage: fit_shear.py ASPERITY FOLDER
"""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student
from table import COUNTS, check

AREA = np.pi * 61.8**2 / 4  # mm^2
SEED = 11
# Values, and ends of intervals, agree to these shares of half an interval
SAME_VALUE, SAME_END = 1e-5, 1e-4


def force(mu, critical_slip, compliance, displacement, normal_stress):
    """Force of faces and machine in series: a spring of mu N/(gcrit + C mu N) that slips at mu N."""
    largest = mu * normal_stress * AREA
    stiffness = largest / (critical_slip + compliance * largest)
    forces = np.zeros_like(displacement)
    for i in range(1, len(displacement)):
        trial = forces[i - 1] + stiffness * (displacement[i] - displacement[i - 1])
        forces[i] = max(-largest, min(largest, trial))
    return forces


def path(turns, step):
    """Displacements from zero through turning points."""
    points, start = [0.0], 0.0
    for turn in turns:
        n = int(np.ceil(abs(turn - start) / step - 1e-9))
        points += [start + (turn - start) * i / n for i in range(1, n + 1)]
        start = turn
    return np.array(points)


def fit_by_scipy(residuals, start):
    """Values and 95 % intervals; the residuals are of logarithms."""
    found = least_squares(residuals, np.log(start), diff_step=1e-6, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    freedom = len(found.fun) - len(start)
    covariance = np.linalg.inv(found.jac.T @ found.jac) * (2 * found.cost / freedom)
    half = student.ppf(0.975, freedom) * np.sqrt(np.diag(covariance))
    return np.exp(found.x), np.exp(found.x - half), np.exp(found.x + half)


def fit_by_asperity(program, record, *options):
    """The same of the program."""
    result = record.with_suffix(".json")
    subprocess.run([program, "fit", str(record), "--kind", "shear", *options, "--json", str(result)],
                   check=True, stdout=subprocess.DEVNULL, timeout=600)
    data = json.loads(result.read_text(encoding="utf-8"))["summary"]
    return [np.array([float(v) for v in data[key]]) for key in ("value", "low_95", "high_95")]


def compare(name, ours, theirs):
    """Values within a share of half an interval, and both ends of it."""
    half = (theirs[2] - theirs[1]) / 2
    off = np.max(np.abs(ours[0] - theirs[0]) / half)
    ends = max(np.max(np.abs(ours[k] - theirs[k]) / half) for k in (1, 2))
    check(f"shear, {name}: values by SciPy", off < SAME_VALUE, f"{off:.1e} of half an interval off")
    check(f"shear, {name}: intervals by SciPy", ends < SAME_END, f"{ends:.1e} of half an interval off")


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(SEED)
    print(f"     seed {SEED}")
    steps = path([1.5, -1.5, 1.0], 0.0317)
    truth = np.array([0.42, 0.25])
    for noise in (0.003, 0.03):
        pressures = (0.05, 0.1)
        records = [force(*truth, 0.0, steps, p) for p in pressures]
        records = [f + noise * 126 * random.standard_normal(len(f)) for f in records]
        file = folder / f"shear_{noise}.csv"
        rows = [f"{p},{x!r},{y!r}" for p, f in zip(pressures, records) for x, y in zip(steps.tolist(), f.tolist())]
        file.write_text("\n".join(["normal_stress (MPa),displacement (mm),force (N)", *rows, ""]), encoding="utf-8")
        scale = max(np.max(np.abs(f)) for f in records)

        def plain(y):
            return np.concatenate([force(*np.exp(y), 0.0, steps, p) - f for p, f in zip(pressures, records)]) / scale

        compare(f"noise {noise:g}", fit_by_asperity(program, file, "--free", "friction_coefficient,critical_slip",
                                                    "--fix", "diameter=61.8"), fit_by_scipy(plain, [0.5, 0.2]))

    truth = np.array([0.42, 0.25, 1e-3])
    pressures = (0.05, 0.1, 0.2)
    records = [force(*truth, steps, p) + 1.0 * random.standard_normal(len(steps)) for p in pressures]
    file = folder / "shear_machine.csv"
    rows = [f"{p},{x!r},{y!r}" for p, f in zip(pressures, records) for x, y in zip(steps.tolist(), f.tolist())]
    file.write_text("\n".join(["normal_stress (MPa),displacement (mm),force (N)", *rows, ""]), encoding="utf-8")
    scale = max(np.max(np.abs(f)) for f in records)

    def with_machine(y):
        mu, critical_slip, compliance = np.exp(y)
        return np.concatenate([force(mu, critical_slip, compliance, steps, p) - f
                               for p, f in zip(pressures, records)]) / scale

    ours = fit_by_asperity(program, file, "--free", "friction_coefficient,critical_slip,shear_compliance",
                           "--fix", "diameter=61.8")
    theirs = fit_by_scipy(with_machine, [0.5, 0.2, 5e-4])
    # the compliance, which may be zero, has an interval of its value, not of its logarithm
    relative = (theirs[2][2] / theirs[0][2]) - 1
    theirs[1][2], theirs[2][2] = (theirs[0][2] * (1 - np.log1p(relative)), theirs[0][2] * (1 + np.log1p(relative)))
    compare("with a machine", ours, theirs)
    print(f"{COUNTS['passed']} passed, {COUNTS['failed']} failed")
    sys.exit(COUNTS["failed"] > 0)


if __name__ == "__main__":
    main()
