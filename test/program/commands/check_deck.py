#!/usr/bin/env python3
"""Check the syntax of an input deck: check_deck.py abaqus|calculix DECK.inp

Neither solver reads the deck here. What is checked is what their manuals say: keywords, parameters
and their values are known, data lines hold as many numbers as they must, nothing is used before it
is defined, fields have up to 20 characters. One line for each fault; the last one counts what was
found, and the status is not zero when there was a fault.
"""
import re
import sys

BOTH, ABAQUS, CALCULIX = {"abaqus", "calculix"}, {"abaqus"}, {"calculix"}
SOLIDS = {"C3D8": 8, "C3D8I": 8, "C3D8R": 8}

# keyword: (solvers, inside a step, {parameter: pattern}, parameters that must be there)
NAME = r"[A-Z][A-Z0-9_]*"
NUMBER = r"[-+]?(\d+\.?\d*|\.\d+)(E[-+]?\d+)?"
COUNT = r"\d+"
NONE = r""
KEYWORDS = {
    "HEADING": (BOTH, False, {}, ()),
    "NODE": (BOTH, False, {"NSET": NAME}, ()),
    "ELEMENT": (BOTH, False, {"TYPE": "C3D8[IR]?|SPRING1", "ELSET": NAME}, ("TYPE",)),
    "NSET": (BOTH, False, {"NSET": NAME}, ("NSET",)),
    "ORIENTATION": (BOTH, False, {"NAME": NAME, "SYSTEM": "RECTANGULAR"}, ("NAME",)),
    "MATERIAL": (BOTH, False, {"NAME": NAME}, ("NAME",)),
    "ELASTIC": (BOTH, False, {"TYPE": "ENGINEERINGCONSTANTS"}, ("TYPE",)),
    "PLASTIC": (BOTH, False, {}, ()),
    "POTENTIAL": (ABAQUS, False, {}, ()),
    "EXPANSION": (BOTH, False, {"TYPE": "ORTHO"}, ("TYPE",)),
    "INITIAL CONDITIONS": (BOTH, False, {"TYPE": "TEMPERATURE"}, ("TYPE",)),
    "SOLID SECTION": (BOTH, False, {"ELSET": NAME, "MATERIAL": NAME, "ORIENTATION": NAME},
                      ("ELSET", "MATERIAL", "ORIENTATION")),
    "SPRING": (BOTH, False, {"ELSET": NAME}, ("ELSET",)),
    "SURFACE": (BOTH, False, {"NAME": NAME, "TYPE": "ELEMENT"}, ("NAME", "TYPE")),
    "SURFACE INTERACTION": (BOTH, False, {"NAME": NAME, "USER": NONE, "PROPERTIES": COUNT,
                                          "DEPVAR": COUNT, "UNSYMM": NONE}, ("NAME",)),
    "SURFACE BEHAVIOR": (BOTH, False, {
        "PRESSURE-OVERCLOSURE": "UINTER|TABULAR|LINEAR|HARD", "PROPERTIES": COUNT,
        "DEPVAR": COUNT, "SEARCHDISTANCE": NUMBER}, ("PRESSURE-OVERCLOSURE",)),
    "FRICTION": (BOTH, False, {"ELASTICSLIP": NUMBER, "EXPONENTIALDECAY": NONE,
                               "ANISOTROPIC": NONE, "TAUMAX": NUMBER}, ()),
    "CONTACT PAIR": (BOTH, False, {"INTERACTION": NAME, "TYPE": "NODETOSURFACE"},
                     ("INTERACTION", "TYPE")),
    "EQUATION": (BOTH, False, {}, ()),
    "BOUNDARY": (BOTH, None, {}, ()),
    "STEP": (BOTH, False, {"NLGEOM": "|YES", "INC": COUNT, "NAME": NAME, "UNSYMM": "YES"}, ()),
    "STATIC": (BOTH, True, {"DIRECT": NONE}, ()),
    "CONTROLS": (CALCULIX, True, {"PARAMETERS": "TIMEINCREMENTATION"}, ("PARAMETERS",)),
    "DSLOAD": (BOTH, True, {}, ()),
    "TEMPERATURE": (BOTH, True, {}, ()),
    "NODE PRINT": (CALCULIX, True, {"NSET": NAME, "TOTALS": "ONLY", "FREQUENCY": COUNT},
                   ("NSET",)),
    "NODE FILE": (CALCULIX, True, {}, ()),
    "EL FILE": (CALCULIX, True, {}, ()),
    "CONTACT FILE": (CALCULIX, True, {}, ()),
    "OUTPUT": (ABAQUS, True, {"HISTORY": NONE, "FIELD": NONE, "FREQUENCY": COUNT}, ("FREQUENCY",)),
    "NODE OUTPUT": (ABAQUS, True, {"NSET": NAME}, ()),
    "ELEMENT OUTPUT": (ABAQUS, True, {}, ()),
    "CONTACT OUTPUT": (ABAQUS, True, {}, ()),
    "END STEP": (BOTH, True, {}, ()),
}
OUTPUTS = {"NODE PRINT": {"RF", "U"}, "NODE FILE": {"U"}, "EL FILE": {"S", "PEEQ"},
           "CONTACT FILE": {"CDIS", "CSTR"}, "NODE OUTPUT": {"RF", "U"},
           "ELEMENT OUTPUT": {"S", "PEEQ"}, "CONTACT OUTPUT": {"CSTRESS", "CDISP"}}


class Fault(Exception):
    """What is wrong."""


def need(condition, text):
    if not condition:
        raise Fault(text)


def squeezed(text):
    """Upper case without blanks, as both solvers read names."""
    return re.sub(r"\s+", "", text).upper()


def fields(line):
    return [part.strip() for part in line.split(",")]


def numbers(line, counts, kind=float):
    """Numbers of a data line, of which there must be one of `counts`."""
    parts = fields(line)
    need(len(parts) in counts, f"{len(parts)} entries, not {' or '.join(map(str, counts))}")
    for part in parts:
        need(len(part) <= 20, f"'{part}' has more than 20 characters")
        pattern = NUMBER if kind is float else r"-?\d+"
        need(re.fullmatch(pattern, part.upper()), f"'{part}' is no number")
    return [kind(part) for part in parts]


def lists(lines, most, kind=float):
    """Numbers of several lines, all but the last one full."""
    values = []
    for place, line in enumerate(lines):
        full = place < len(lines) - 1
        values += numbers(line, [most] if full else range(1, most + 1), kind)
    return values


class Checker:
    """The deck as read so far."""

    def __init__(self, solver):
        self.solver = solver
        self.nodes, self.elements = {}, {}
        self.node_sets, self.element_sets = {}, {}
        self.axes, self.materials, self.surfaces, self.interactions = set(), {}, {}, {}
        self.pairs, self.sectioned, self.springs = [], set(), set()
        self.tied, self.held = set(), set()
        self.material = self.interaction = None
        self.step = self.steps = 0
        self.procedure = False
        self.counts = {}

    def card(self, name, parameters, data):
        """One keyword with its data lines."""
        need(name in KEYWORDS, f"*{name} is unknown")
        solvers, inside, known, needed = KEYWORDS[name]
        need(self.solver in solvers, f"*{name} is not for {self.solver}")
        if inside is not None:
            need(inside == bool(self.step), f"*{name} " + ("outside a" if inside else "in a")
                 + " step")
        for key, value in parameters.items():
            need(key in known, f"*{name} has no parameter {key}")
            need(re.fullmatch(known[key], value), f"{key}={value} is not allowed")
        for key in needed:
            need(key in parameters, f"*{name} needs {key}")
        self.counts[name] = self.counts.get(name, 0) + 1
        if name in OUTPUTS:
            self.results(name, parameters, data)
        else:
            getattr(self, "card_" + name.lower().replace(" ", "_"))(parameters, data)

    def card_heading(self, _, data):
        need(len(data) >= 1, "no title")

    def card_node(self, parameters, data):
        found = []
        for line in data:
            number, *place = fields(line)
            need(len(place) == 3, "a node has three coordinates")
            numbers(line, [4])
            number = int(number)
            need(number not in self.nodes, f"node {number} is there twice")
            self.nodes[number] = tuple(map(float, place))
            found.append(number)
        if "NSET" in parameters:
            self.node_sets.setdefault(parameters["NSET"], []).extend(found)

    def card_element(self, parameters, data):
        kind = parameters["TYPE"]
        found = []
        for line in data:
            number, *corners = numbers(line, [SOLIDS.get(kind, 1) + 1], int)
            need(number not in self.elements, f"element {number} is there twice")
            need(all(corner in self.nodes for corner in corners), f"element {number}: no such node")
            need(len(set(corners)) == len(corners), f"element {number}: a node twice")
            self.elements[number] = corners
            found.append(number)
        self.element_sets[parameters["ELSET"]] = found
        if kind == "SPRING1":
            self.springs.update(found)

    def card_nset(self, parameters, data):
        found = lists(data, 16, int)
        need(all(number in self.nodes for number in found), "no such node")
        need(len(set(found)) == len(found), "a node twice")
        need(parameters["NSET"] not in self.node_sets, "the set is there twice")
        self.node_sets[parameters["NSET"]] = found

    def card_orientation(self, parameters, data):
        need(len(data) == 1, "one data line")
        a = numbers(data[0], [6])
        cross = [a[1]*a[5] - a[2]*a[4], a[2]*a[3] - a[0]*a[5], a[0]*a[4] - a[1]*a[3]]
        need(any(abs(x) > 1e-9 for x in cross), "the two directions are one")
        self.axes.add(parameters["NAME"])

    def card_material(self, parameters, _):
        self.material = parameters["NAME"]
        self.materials[self.material] = set()

    def card_elastic(self, _, data):
        need(self.material, "no material")
        need(len(data) == 2, "two data lines")
        e1, e2, e3, n12, n13, n23, g12, g13 = numbers(data[0], [8])
        (g23,) = numbers(data[1], [1])
        need(min(e1, e2, e3, g12, g13, g23) > 0, "a modulus is not above zero")
        a, b, c = n12*(e2/e1)**0.5, n13*(e3/e1)**0.5, n23*(e3/e2)**0.5
        need(1 - a*a > 0 and 1 - a*a - b*b - c*c - 2*a*b*c > 0, "the wood gives energy")
        self.materials[self.material].add("ELASTIC")

    def card_plastic(self, _, data):
        rows = [numbers(line, [2]) for line in data]
        need(rows[0][1] == 0, "plastic strain begins at zero")
        need(all(a[1] < b[1] and a[0] <= b[0] for a, b in zip(rows, rows[1:])), "not rising")
        self.materials[self.material].add("PLASTIC")

    def card_potential(self, _, data):
        need("PLASTIC" in self.materials[self.material], "needs *PLASTIC")
        need(len(data) == 1, "one data line")
        r = numbers(data[0], [6])
        s = [1/x**2 for x in r[:3]]
        f, g, h = (s[1] + s[2] - s[0])/2, (s[2] + s[0] - s[1])/2, (s[0] + s[1] - s[2])/2
        need(f*g + g*h + h*f > 0, "Hill's criterion is not convex")

    def card_expansion(self, _, data):
        need(len(data) == 1, "one data line")
        numbers(data[0], [3])
        self.materials[self.material].add("EXPANSION")

    def card_initial_conditions(self, _, data):
        self.card_temperature(_, data)

    def card_temperature(self, _, data):
        for line in data:
            name, value = fields(line)
            need(name in self.node_sets, f"no node set {name}")
            numbers(value, [1])

    def card_solid_section(self, parameters, data):
        need(not data, "no data line")
        need(parameters["ELSET"] in self.element_sets, "no such set of elements")
        need(parameters["MATERIAL"] in self.materials, "no such material")
        need(parameters["ORIENTATION"] in self.axes, "no such orientation")
        self.sectioned.update(self.element_sets[parameters["ELSET"]])

    def card_spring(self, parameters, data):
        need(len(data) == 2, "two data lines")
        need(numbers(data[0], [1], int)[0] in (1, 2, 3), "the direction is 1, 2 or 3")
        need(numbers(data[1], [1])[0] > 0, "the stiffness is not above zero")
        self.sectioned.update(self.element_sets[parameters["ELSET"]])

    def card_surface(self, parameters, data):
        faces = [tuple(fields(line)) for line in data]
        need(faces, "the surface is empty")
        need(len(set(faces)) == len(faces), "a face twice")
        for element, face in faces:
            need(int(element) in self.elements, f"no element {element}")
            need(re.fullmatch("S[1-6]", face), f"no face {face}")
        need(parameters["NAME"] not in self.surfaces, "the surface is there twice")
        self.surfaces[parameters["NAME"]] = faces

    def card_surface_interaction(self, parameters, data):
        self.interaction = parameters["NAME"]
        self.interactions[self.interaction] = {}
        if "USER" not in parameters:
            need(not data, "no data line")
            return
        need(self.solver == "abaqus", "USER is for ABAQUS")
        need(parameters.keys() >= {"PROPERTIES", "DEPVAR", "UNSYMM"}, "a parameter is missing")
        need(data and not data[0].strip(), "the blank data line before the properties is missing")
        self.check_properties(parameters, data[1:])

    def check_properties(self, parameters, data):
        found = lists(data, 8)
        need(len(found) == int(parameters["PROPERTIES"]), "PROPERTIES is not the number of numbers")
        need(12 <= len(found) <= 47, "UINTER takes 12 to 47 properties here")
        need(abs(found[4] - 3.14159265358979) < 1e-6, "the fifth property is not pi")
        plain = not any(found[18:22] + found[24:28] + found[30:])
        stick = 2*int(found[28] or 8) if found[27:28] == [1] else 0
        need(int(parameters["DEPVAR"]) == (11 if plain else 13 + stick), "DEPVAR does not fit")
        self.interactions[self.interaction] = {"BEHAVIOR": "UINTER", "FRICTION": "UINTER"}

    def card_surface_behavior(self, parameters, data):
        kind = parameters["PRESSURE-OVERCLOSURE"]
        here = self.interactions[self.interaction]
        need("BEHAVIOR" not in here, "a second behaviour")
        if kind == "UINTER":
            need(self.solver == "calculix", "UINTER is for *SURFACE INTERACTION, USER in ABAQUS")
            need(parameters.keys() >= {"PROPERTIES", "DEPVAR", "SEARCHDISTANCE"}, "a parameter is "
                 "missing")
            self.check_properties(parameters, data)
            del self.interactions[self.interaction]["FRICTION"]
            return
        need(parameters.keys() == {"PRESSURE-OVERCLOSURE"}, "parameters of UINTER")
        if kind == "TABULAR":
            rows = [numbers(line, [2]) for line in data]
            need(rows[0][0] == 0, "the first pressure is not zero")
            need(all(a[0] < b[0] and a[1] < b[1] for a, b in zip(rows, rows[1:])), "not rising")
            need(self.solver == "abaqus" or len(rows) <= 200, "more than 200 rows")
        elif kind == "LINEAR":
            need(self.solver == "calculix" and len(data) == 1, "one line of CalculiX")
            need(min(numbers(data[0], [3])) > 0, "not above zero")
        else:
            need(self.solver == "abaqus" and not data, "hard contact of ABAQUS has no data")
        here["BEHAVIOR"] = kind

    def card_friction(self, parameters, data):
        here = self.interactions[self.interaction]
        need("FRICTION" not in here, "a second friction")
        decays, directions = "EXPONENTIALDECAY" in parameters, 1 + ("ANISOTROPIC" in parameters)
        need(len(data) == 1 or self.solver == "abaqus" and not decays, "one data line")
        if self.solver == "calculix":
            need(not parameters, "CalculiX has no elastic slip")
            need(min(numbers(data[0], [2])) > 0, "not above zero")
        else:
            # by pressure: coefficients, slip rate, pressure
            counts = [3] if decays else [directions] if len(data) == 1 else [directions + 2]
            rows = [numbers(line, counts) for line in data]
            need(all(row[0] > 0 for row in rows), "not above zero")
            need(all(a[-1] < b[-1] for a, b in zip(rows, rows[1:])), "pressures do not rise")
        here["FRICTION"] = True

    def card_contact_pair(self, parameters, data):
        need(parameters["INTERACTION"] in self.interactions, "no such interaction")
        need(len(data) == 1, "one data line")
        slave, master = fields(data[0])
        need(slave in self.surfaces and master in self.surfaces, "no such surface")
        need(slave != master, "slave and master are one")
        self.pairs.append((slave, master, parameters["INTERACTION"]))

    def card_equation(self, _, data):
        need(len(data) % 2 == 0, "two lines an equation")
        for count, terms in zip(data[::2], data[1::2]):
            need(numbers(count, [1], int) == [2], "two terms")
            values = numbers(terms, [6])
            need(int(values[0]) in self.nodes and int(values[3]) in self.nodes, "no such node")
            need(values[1] == values[4] and values[2] == -values[5], "terms differ")
            self.tied.add((int(values[0]), int(values[1])))

    def card_boundary(self, _, data):
        for line in data:
            parts = fields(line)
            need(len(parts) == 4, "set, first and last direction, displacement")
            need(parts[0] in self.node_sets, f"no node set {parts[0]}")
            first, last = numbers(",".join(parts[1:3]), [2], int)
            need(1 <= first <= last <= 3, "directions are 1 to 3")
            numbers(parts[3], [1])
            for node in self.node_sets[parts[0]]:
                for direction in range(first, last + 1):
                    need((node, direction) not in self.tied, f"node {node} is tied and held")
                    if not self.step:
                        need((node, direction) not in self.held or float(parts[3]) == 0,
                             f"node {node} is held twice")
                    self.held.add((node, direction))

    def card_step(self, parameters, data):
        need(not data, "no data line")
        need("NLGEOM" in parameters and "INC" in parameters, "NLGEOM and INC are needed")
        if self.solver == "abaqus":
            need(parameters["NLGEOM"] == "YES" and "NAME" in parameters
                 and parameters.get("UNSYMM") == "YES", "NAME, NLGEOM=YES and UNSYMM=YES")
        else:
            need(parameters["NLGEOM"] == "" and parameters.keys() == {"NLGEOM", "INC"},
                 "CalculiX has NLGEOM and INC")
        self.step = 1
        self.steps += 1
        self.procedure = False

    def card_static(self, parameters, data):
        need(len(data) == 1, "one data line")
        times = numbers(data[0], [2] if "DIRECT" in parameters else [4])
        need(0 < times[0] <= times[1]*(1 + 1e-9), "first increment and period")
        if len(times) == 4:
            need(times[2] < times[0] <= times[3]*(1 + 1e-9), "least and largest increment")
        self.procedure = True

    def card_controls(self, _, data):
        need(data == ["20, 25, 9, 40, 12, 4, , 12"], "not the known line")

    def card_dsload(self, _, data):
        for line in data:
            name, kind, value = fields(line)
            need(name in self.surfaces and kind == "P", "a surface and P")
            numbers(value, [1])

    def results(self, name, parameters, data):
        if "NSET" in parameters:
            need(parameters["NSET"] in self.node_sets, "no such node set")
        need(len(data) == 1 and set(fields(data[0])) <= OUTPUTS[name], "not the known results")

    def card_output(self, parameters, data):
        need(not data, "no data line")
        need(("HISTORY" in parameters) != ("FIELD" in parameters), "HISTORY or FIELD")

    def card_end_step(self, _, data):
        need(self.procedure and not data, "no *STATIC")
        self.step = 0

    def whole(self):
        """What only the whole deck can tell."""
        need(not self.step and self.steps >= 2, "steps")
        need(self.sectioned == set(self.elements), "elements without section")
        used = {corner for corners in self.elements.values() for corner in corners}
        need(used == set(self.nodes), "nodes without element")
        for _, _, interaction in self.pairs:
            need({"BEHAVIOR", "FRICTION"} <= self.interactions[interaction].keys(),
                 f"{interaction} is not complete")
        need(self.pairs, "no contact")
        need(all("ELASTIC" in found for found in self.materials.values()), "wood without elasticity")


def cards(path):
    """(line number, keyword, parameters, data lines) of a deck. Blank lines are kept."""
    found = None
    with open(path, encoding="ascii") as file:
        for number, line in enumerate(file, 1):
            line = line.rstrip("\n")
            need(len(line) <= 132 or line.startswith("**"), f"line {number} is long")
            if line.startswith("**"):
                continue
            if line.startswith("*"):
                if found:
                    yield found
                word, *rest = line[1:].split(",")
                parameters = {}
                for part in rest:
                    key, _, value = part.partition("=")
                    need(squeezed(key) not in parameters, f"line {number}: {key} twice")
                    parameters[squeezed(key)] = squeezed(value)
                found = (number, " ".join(word.upper().split()), parameters, [])
            else:
                need(found, "data before the first keyword")
                found[3].append(line)
    if found:
        yield found


def main(solver, path):
    checker = Checker(solver)
    faults = 0
    try:
        for number, name, parameters, data in cards(path):
            try:
                if name != "SURFACE INTERACTION":
                    need(all(line.strip() for line in data), "a blank line")
                checker.card(name, parameters, data)
            except (Fault, ValueError, KeyError) as fault:
                print(f"{path}:{number}: *{name}: {fault}")
                faults += 1
        checker.whole()
    except Fault as fault:
        print(f"{path}: {fault}")
        faults += 1
    print(f"{len(checker.nodes)} nodes, {len(checker.elements)} elements, {len(checker.pairs)} "
          f"pairs, {checker.steps} steps, {faults} faults")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
