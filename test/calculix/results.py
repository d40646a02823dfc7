"""What CalculiX leaves: JOB.dat (printed), JOB.frd (fields), JOB.cvg (iterations), JOB.sta."""

import re
from pathlib import Path


def number(text):
    """A number of Fortran, `1.0-100` among them."""
    try:
        return float(text)
    except ValueError:
        return float(re.sub(r"(?<=\d)([+-]\d+)$", r"E\1", text.strip()))


class Printed:
    """JOB.dat: {time: {node: [x, y, z]}} by set for displacements, {time: [x, y, z]} for the sum
    of forces on a set."""

    HEAD = re.compile(r"^ (displacements|total force|forces)\b.*for set (\S+) and time +(\S+)")

    def __init__(self, path):
        self.displacements, self.forces = {}, {}
        kind, rows, when, name = None, None, None, None
        for line in Path(path).read_text(encoding="ascii").splitlines():
            head = self.HEAD.match(line)
            if head:
                kind, name, when = head[1], head[2], number(head[3])
                if kind == "displacements":
                    rows = self.displacements.setdefault(name, {}).setdefault(when, {})
            elif line.strip() and kind == "displacements":
                words = line.split()
                rows[int(words[0])] = [number(word) for word in words[1:]]
            elif line.strip() and kind == "total force":
                self.forces.setdefault(name, {})[when] = [number(word) for word in line.split()]
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
    fields, when, rows = {}, None, None
    with open(path, encoding="ascii", errors="replace") as lines:
        for line in lines:
            if line.startswith("  100C"):
                when = number(line[12:24])
            elif line.startswith(" -4"):
                rows = fields.setdefault(when, {}) if line.split()[1] == "CONTACT" else None
            elif line.startswith(" -3"):
                rows = None
            elif line.startswith(" -1") and rows is not None:
                rows[int(line[3:13])] = [number(line[13 + 12 * i:25 + 12 * i]) for i in range(6)]
    return fields


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
            table.setdefault(key, []).append((int(words[4]), number(words[5]), number(words[6])))
    return table


def increments(path):
    """JOB.sta: [(step, increment, attempt, iterations, total time, step time, length), ...] of
    converged increments; an attempt that was given up is marked by U."""
    rows = []
    for line in Path(path).read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 7 and all(word.isdigit() for word in words[:4]):
            rows.append(tuple(int(word) for word in words[:4]) + tuple(map(number, words[4:7])))
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
            found[-1].values[name] = [int(word) if integer else number(word) for word in words]
    return found
