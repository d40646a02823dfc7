"""Contact faces and what ccx found on them: one row for each slave node and chosen increment."""

import json
import math
import os
from collections import namedtuple

from . import history
from .files import frd
from .files.deck import Deck
from .files.mesh import new_mesh

# state is 'open', 'stick', 'slip', or 'closed' where friction is unknown
Point = namedtuple("Point", "step increment time pair node x y z ux uy uz area opening slip_1 "
                            "slip_2 pressure shear_1 shear_2 state")

# What a face bears, named as in the tables of `asperity tenon`
FaceRow = namedtuple("FaceRow", "face largest_pressure normal_force area_open area_stick area_slip")

# A point slips from this share of friction times pressure: ccx writes six figures of each
SLIPPING = 0.999
# MPa; a rough face never quite ends, and asperity's law counts as open some way below this
OPEN = 1e-6


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
        """{name: frd.Result} of an increment."""
        for path, begin, end in self.parts:
            if begin <= key[0] < end:
                return {r.name: r for r in frd.results(
                    path, names, lambda step, increment: (step, increment) == key)}
        return {}

    def clearance(self, node, pair, moved):
        """How far a node is from the nearest face of a pair's master."""
        def position(n):
            return [a + b for a, b in zip(self.mesh.nodes[n], moved.get(n, (0.0, 0.0, 0.0)))]
        here, best = position(node), (math.inf, math.inf)
        for face in self.mesh.surfaces.get(pair.master, []):
            corners = [position(n) for n in face]
            middle = [sum(c[i] for c in corners)/4.0 for i in range(3)]
            way = [here[i] - middle[i] for i in range(3)]
            # ccx numbers a face so that the normal points into the element
            normal = cross(*([corners[k][i] - corners[k - 2][i] for i in range(3)] for k in (2, 3)))
            length = math.sqrt(sum(v*v for v in normal))
            best = min(best, (sum(v*v for v in way),
                              -sum(a*b for a, b in zip(way, normal))/length))
        return best[1]

    def points(self, key, friction=None):
        """Points of all contact pairs at an increment."""
        found = self.read(key, ("DISP", "CONTACT"))
        moved = found["DISP"].values if "DISP" in found else {}
        surfaces = self.mesh.slave_faces()
        shares = [{**dict.fromkeys(self.mesh.node_surfaces.get(pair.slave, ()), 0.0),
                   **areas(self.mesh.nodes, faces)} for pair, faces in surfaces]
        springs = by_pair(found["CONTACT"].rows if "CONTACT" in found else [], shares,
                          lambda node, number: self.clearance(node, surfaces[number][0], moved))
        rows = []
        for (pair, _), share, contact in zip(surfaces, shares, springs):
            mu = friction if friction is not None else self.mesh.friction.get(pair.interaction)
            for node, area in sorted(share.items()):
                values = contact.get(node)
                motion = moved.get(node, (0.0, 0.0, 0.0))[:3]
                # no spring: so far apart that ccx did not look
                opening, slip1, slip2, pressure, shear1, shear2 = values or (math.nan, *[0.0]*5)
                rows.append(Point(*key, self.times[key], pair.slave, node,
                                  *self.mesh.nodes[node], *motion, area, opening, slip1, slip2,
                                  pressure, shear1, shear2,
                                  state(pressure, math.hypot(shear1, shear2), mu)))
        return rows


def face_rows(points):
    """A row for each contact pair of some points; stick and slip are nan where friction is unknown."""
    rows = []
    for pair in dict.fromkeys(p.pair for p in points):
        mine = [p for p in points if p.pair == pair]
        area = dict.fromkeys(("open", "stick", "slip"), 0.0)
        for p in mine:
            area[p.state] = area.get(p.state, 0.0) + p.area
        if "closed" in area:
            area["stick"] = area["slip"] = math.nan
        rows.append(FaceRow(pair, max(p.pressure for p in mine),
                            sum(p.pressure*p.area for p in mine), area["open"], area["stick"],
                            area["slip"]))
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


def by_pair(rows, surfaces, clearance):
    """Springs of each pair, [{node: values}], of the rows of ccx's CONTACT.

    A node where two surfaces meet can have a spring for each, and ccx does not say which is which.
    It lists them from the last pair to the first, in each from the largest node to the smallest. Of
    what that allows, the openings have the nearest to clearance(node, pair)."""
    # per row, {pair: (sum of differences so far, pair of the row before)}
    ways, node_before = [{len(surfaces) - 1: (0.0, None)}], math.inf
    for node, values in rows:
        choices = [i for i, surface in enumerate(surfaces) if node in surface]
        ways.append({})
        for i in choices:
            cost = abs(clearance(node, i) - values[0]) if len(choices) > 1 else 0.0
            befores = [(before[0] + cost, j) for j, before in ways[-2].items()
                       if j > i or (j == i and node < node_before)]
            if befores:
                ways[-1][i] = min(befores)
        node_before = node
    if not ways[-1]:
        raise frd.FrdError("contact is not in the order of the deck's pairs")
    springs = [{} for _ in surfaces]
    pair = min(ways[-1], key=lambda i: ways[-1][i][0])
    for (node, values), way in zip(reversed(rows), reversed(ways)):
        springs[pair][node] = values
        pair = way[pair][1]
    return springs


def state(pressure, shear, friction):
    """Contact state of a point."""
    if pressure <= OPEN:
        return "open"
    if friction is None:
        return "closed"
    return "slip" if shear >= SLIPPING*friction*pressure else "stick"


def areas(nodes, faces):
    """{node: its quarter of the faces around}, of the mesh as it was at first."""
    shares = {}
    for face in faces:
        a, b = ([nodes[face[k]][i] - nodes[face[k - 2]][i] for i in range(3)] for k in (2, 3))
        quarter = 0.125*math.sqrt(sum(v*v for v in cross(a, b)))
        for node in face:
            shares[node] = shares.get(node, 0.0) + quarter
    return shares


def cross(a, b):
    """Vector product."""
    return a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]
