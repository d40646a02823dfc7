"""Contact faces and what ccx found on them: one row for each slave node and chosen increment."""

import json
import math
import os
from collections import namedtuple

import frd
import history
from deck import Deck
from mesh import new_mesh

# state is 'open', 'stick', 'slip', or 'closed' where friction is unknown
Point = namedtuple("Point", "step increment time pair node x y z ux uy uz area opening slip_1 "
                            "slip_2 pressure shear_1 shear_2 state")

# A point slips from this share of friction times pressure: ccx writes six figures of each
SLIPPING = 0.999


class Results:
    """A run's mesh and results, of one part or of several."""

    def __init__(self, place, deck=None):
        self.parts, self.converged = parts_of(place)
        first = self.parts[0][0]
        self.deck = Deck(deck or os.path.splitext(first)[0] + ".inp")
        self.mesh = new_mesh(self.deck.model)
        self.times = {}
        for path, begin, end in self.parts:
            found = frd.times(path)
            self.times.update({key: time for key, time in found.items()
                               if begin <= key[0] < end and self.counts(key)})
        if not self.times:
            raise frd.FrdError(f"{first}: no results")

    def counts(self, key):
        """Has this (step, increment) converged? ccx writes its last try, too."""
        return self.converged is None or key in self.converged

    def choose(self, text):
        """[(step, increment)] of a list such as '2,3:5,last': a step alone is its end."""
        known, chosen = sorted(self.times), []
        for word in text.split(","):
            step, _, increment = word.strip().partition(":")
            if step == "last":
                chosen.append(known[-1])
                continue
            if not step.isdigit() or (increment and not increment.isdigit()):
                raise ValueError(f"'{word}' is neither STEP, STEP:INCREMENT nor last")
            inside = [key for key in known if key[0] == int(step)
                      and (not increment or key[1] == int(increment))]
            if not inside:
                raise ValueError(f"no results of '{word}': there are those of steps "
                                 f"{known[0][0]} to {known[-1][0]}")
            chosen.append(inside[-1])
        return list(dict.fromkeys(chosen))

    def read(self, key, names):
        """{name: (components, values)} of an increment."""
        for path, begin, end in self.parts:
            if begin <= key[0] < end:
                return {r.name: (r.components, r.values) for r in frd.results(
                    path, names, lambda step, increment: (step, increment) == key)}
        return {}

    def points(self, key, friction=None):
        """Points of all contact pairs at an increment."""
        found = self.read(key, ("DISP", "CONTACT"))
        moved = found.get("DISP", ([], {}))[1]
        contact = found.get("CONTACT", ([], {}))[1]
        rows = []
        for pair, faces in self.mesh.slave_faces():
            mu = friction if friction is not None else self.mesh.friction.get(pair.interaction)
            for node, area in sorted(areas(self.mesh.nodes, faces).items()):
                values = contact.get(node)
                motion = moved.get(node, (0.0, 0.0, 0.0))[:3]
                # no spring: so far apart that ccx did not look
                opening, slip1, slip2, pressure, shear1, shear2 = values or (math.nan, *[0.0]*5)
                rows.append(Point(*key, self.times[key], pair.slave, node,
                                  *self.mesh.nodes[node], *motion, area, opening, slip1, slip2,
                                  pressure, shear1, shear2,
                                  state(pressure, math.hypot(shear1, shear2), mu)))
        return rows


def parts_of(place):
    """([(results file, first step, step where the next part begins)], converged or None)."""
    if not os.path.exists(place):
        raise frd.FrdError(f"{place} is not there")
    if not os.path.isdir(place):
        return [(place, 0, math.inf)], None
    try:
        with open(os.path.join(place, "run.json"), encoding="utf-8") as file:
            parts = json.load(file)["parts"]
        firsts = [part["first_step"] for part in parts] + [math.inf]
        paths = [os.path.join(place, part["job"]) for part in parts]
    except (OSError, ValueError, KeyError) as problem:
        raise frd.FrdError(f"{place}: no folder of a run ({problem})") from problem
    converged = {(row["step"], row["increment"]) for path in paths
                 for row in history.read_increments(path + ".increments.csv")}
    return [(path + ".frd", firsts[i], firsts[i + 1]) for i, path in enumerate(paths)], converged


def state(pressure, shear, friction):
    """Contact state of a point."""
    if pressure <= 0.0:
        return "open"
    if friction is None:
        return "closed"
    return "slip" if shear >= SLIPPING*friction*pressure else "stick"


def areas(nodes, faces):
    """{node: its quarter of the faces around}, of the mesh as it was at first."""
    shares = {}
    for face in faces:
        a, b = ([nodes[face[k]][i] - nodes[face[k - 2]][i] for i in range(3)] for k in (2, 3))
        cross = (a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0])
        quarter = 0.125*math.sqrt(sum(v*v for v in cross))
        for node in face:
            shares[node] = shares.get(node, 0.0) + quarter
    return shares
