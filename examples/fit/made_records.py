#!/usr/bin/env python3
"""Make the records of shear and of a joint that docs/fit.md fits: replays of known numbers, with
Gaussian noise and a drift of the load cell, rounded as a logger does.

usage: made_records.py [PROGRAM]

Writes shear.csv, joint.csv and joint_push.csv beside itself; PROGRAM is asperity unless given.
"""

import csv
import random
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "asperity"
SEED = 20


def replay(*arguments):
    """The rows that a replay writes, by column names without units."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "replay.csv"
        subprocess.run([PROGRAM, *arguments, "--csv", path], check=True, stdout=subprocess.DEVNULL)
        with open(path, encoding="utf-8") as file:
            rows = list(csv.reader(file))
    names = [name.split(" (")[0] for name in rows[0]]
    return [dict(zip(names, row)) for row in rows[1:]]


def spoilt(values, noise, drift):
    """Values with noise and a drift, as shares of the largest."""
    largest = max(abs(v) for v in values)
    return [v + largest * (random.gauss(0.0, noise) + drift * i / len(values)) for i, v in enumerate(values)]


def write(name, heading, *columns):
    with open(FOLDER / name, "w", encoding="utf-8") as file:
        file.write(heading + "\n")
        file.writelines(",".join(row) + "\n" for row in zip(*columns))


def shear():
    """mu 0.42, gcrit 0.25 mm, 3e-4 mm/N of machine; discs of 61.8 mm at three normal stresses."""
    rows = replay(
        "shear", "--friction-coefficient", "0.42", "--critical-slip", "0.25", "--shear-compliance", "3e-4",
        "--normal-stress", "0.05,0.1,0.2", "--displacement", "1.2,-1.2,0.6", "--displacement-increment", "0.05",
    )  # fmt: skip
    force = spoilt([float(row["shear_force"]) for row in rows], 0.01, 0.0)
    write(
        "shear.csv", "normal_stress (MPa),displacement (mm),shear_force (N)",
        [f"{float(row['normal_stress_nominal']):g}" for row in rows],
        [f"{float(row['displacement']):.3f}" for row in rows], [f"{f:.1f}" for f in force],
    )  # fmt: skip


def joint(name, *programme):
    """Clearance 0.4 mm, side pressure 0.3 MPa, bearing depth 75 mm, hardening 0.04."""
    rows = replay(
        "tenon", FOLDER / "joint.nml", "--clearance", "0.4", "--side-pressure", "0.3", "--bearing-depth", "75",
        "--hardening-across", "0.04", *programme,
    )  # fmt: skip
    rows = [row for row in rows if row["model"] == "rough"]
    force = spoilt([float(row["force"]) for row in rows], 0.01, 0.002)
    write(
        name, "displacement (mm),force (kN)", [f"{float(row['displacement']):.2f}" for row in rows],
        [f"{f / 1000:.4f}" for f in force],
    )  # fmt: skip


random.seed(SEED)
shear()
joint("joint.csv")
with tempfile.NamedTemporaryFile("w", suffix=".csv", encoding="utf-8") as push:
    push.write("displacement (mm)\n" + "".join(f"{i}\n" for i in range(0, 41, 2)))
    push.flush()
    joint("joint_push.csv", "--history", push.name)
