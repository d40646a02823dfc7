"""What CalculiX leaves: JOB.dat (printed), JOB.frd (fields), JOB.cvg (iterations), JOB.sta."""

import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[3] / "interface" / "calculix"))
from tools.files import dat, frd  # noqa: E402


def numbers(values):
    """A list of numbers; one that is none is an error, as max and min may leave it out."""
    values = list(values)
    if any(map(math.isnan, values)):
        raise ValueError(f"not a number: {values}")
    return values


class Printed:
    """JOB.dat: {time: {node: [x, y, z]}} by set for displacements, {time: [x, y, z]} for the sum
    of forces on a set."""

    def __init__(self, path):
        self.displacements, self.forces = {}, {}
        for block in dat.blocks(path):
            if block.quantity == "displacements":
                rows = self.displacements.setdefault(block.set, {}).setdefault(block.time, {})
                rows.update((node, numbers(values)) for node, values in block.rows)
            elif block.quantity == "total force":
                self.forces.setdefault(block.set, {})[block.time] = numbers(block.rows[0][1])
        self.times = sorted({when for rows in self.displacements.values() for when in rows})

    def last_force(self, name):
        """Sum of forces on a set at the end."""
        return self.forces[name][max(self.forces[name])]

    def at(self, name, when=None):
        """Displacements of a set's nodes, by default at the end."""
        rows = self.displacements[name]
        return rows[max(rows) if when is None else min(rows, key=lambda t: abs(t - when))]


def contact_fields(path):
    """JOB.frd's fields of contact, {time: {node: [clearance, slip 1, slip 2, pressure, shear 1,
    shear 2]}}; nodes that no spring holds stand there with zeros or are left out."""
    return {result.time: {node: numbers(row) for node, row in result.values.items()}
            for result in frd.results(path, ["CONTACT"])}


def last_contact(path):
    """The last field of contact: nodes with a spring only."""
    fields = contact_fields(path)
    return {node: row for node, row in fields[max(fields)].items() if any(row)} if fields else {}


def iterations(path):
    """JOB.cvg: {(step, increment, attempt): [(springs, residual %, correction %), ...]}."""
    table = {}
    for line in Path(path).read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) >= 7 and words[0].isdigit():
            key = tuple(int(word) for word in words[:3])
            table.setdefault(key, []).append((int(words[4]), dat.number(words[5]), dat.number(words[6])))
    return table


def increments(path):
    """JOB.sta: [(step, increment, attempt, iterations, total time, step time, length), ...] of
    converged increments; an attempt that was given up is marked by U."""
    rows = []
    for line in Path(path).read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 7 and all(word.isdigit() for word in words[:4]):
            rows.append(tuple(int(word) for word in words[:4]) + tuple(map(dat.number, words[4:7])))
    return rows


class Call:
    """One call of the UINTER in recorder.f90: numbers by name (OUT_ before what it returned), and
    the `names` of interaction, slave and
    master."""

    def __init__(self):
        self.values, self.names = {}, []

    def __getitem__(self, name):
        return self.values[name]

    def one(self, name):
        """An argument of one number."""
        return self.values[name][0]


def recorded_calls(path):
    """Every call of the UINTER in recorder.f90, in order."""
    found = []
    for line in Path(path).read_text(encoding="ascii").splitlines():
        name, *words = line.split()
        if name == "CALL":
            found.append(Call())
        elif line.startswith("NAMES"):
            found[-1].names = line.split("|")[1:]
        else:
            integer = name in ("NODE", "SIZES", "COUNTERS", "FLAGS", "OUT_FLAGS")
            found[-1].values[name] = numbers(int(word) if integer else dat.number(word) for word in words)
    return found
