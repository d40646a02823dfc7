"""Nodes, elements, sets, surfaces and contact pairs of a deck's model."""

from collections import namedtuple

from .deck import DeckError, keyword, parameters

# Corners of the faces S1 to S6 of a hexahedron, as ccx numbers them
HEX_FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))

Pair = namedtuple("Pair", "slave master interaction")


class Mesh:
    """What the pictures need of a model."""

    def __init__(self, lines):
        self.nodes, self.elements = {}, {}
        self.node_sets, self.element_sets = {}, {}
        self.surfaces, self.node_surfaces = {}, {}
        self.pairs, self.friction = [], {}
        for word, values, data in cards(lines):
            reader = READERS.get(word)
            if reader:
                reader(self, values, data)
            elif word in ("*SURFACEINTERACTION", "*SURFACEBEHAVIOR", "*FRICTION"):
                self._read_law(word, values, data)

    def _read_nodes(self, values, data):
        for row in data:
            self.nodes[int(row[0])] = tuple(float(v or 0.0) for v in (row[1:4] + [""]*3)[:3])
        if "NSET" in values:
            self.node_sets.setdefault(values["NSET"].upper(), []).extend(
                int(row[0]) for row in data)

    def _read_elements(self, values, data):
        numbers = [int(v) for row in data for v in row if v]
        kind = values.get("TYPE", "").upper()
        size = 1 + (20 if kind.startswith("C3D20") else 8)
        if not kind.startswith(("C3D8", "C3D20")):
            return
        for i in range(0, len(numbers) - size + 1, size):
            self.elements[numbers[i]] = tuple(numbers[i + 1:i + 9])
        if "ELSET" in values:
            self.element_sets.setdefault(values["ELSET"].upper(), []).extend(
                numbers[0::size])

    def _read_set(self, sets, name, values, data):
        members = sets.setdefault(name.upper(), [])
        for row in data:
            row = [v for v in row if v]
            if "GENERATE" in values:
                first, last, step = (int(v) for v in (row + ["1"])[:3])
                members.extend(range(first, last + 1, step))
                continue
            for v in row:
                members.extend([int(v)] if v.isdigit() else sets.get(v.upper(), []))

    def _read_node_set(self, values, data):
        self._read_set(self.node_sets, values.get("NSET", ""), values, data)

    def _read_element_set(self, values, data):
        self._read_set(self.element_sets, values.get("ELSET", ""), values, data)

    def _read_surface(self, values, data):
        if values.get("TYPE", "ELEMENT").upper() == "NODE":
            self._read_set(self.node_surfaces, values.get("NAME", ""), values,
                           [self._numbers(row[0]) for row in data])
            return
        faces = self.surfaces.setdefault(values.get("NAME", "").upper(), [])
        for row in data:
            label = row[1].upper() if len(row) > 1 else ""
            if not (label[:1] == "S" and label[1:] in tuple("123456")):
                continue
            members = [int(row[0])] if row[0].isdigit() else self.element_sets.get(
                row[0].upper(), [])
            for element in members:
                corners = self.elements.get(element)
                if corners:
                    faces.append(tuple(corners[i] for i in HEX_FACES[int(label[1:]) - 1]))

    def _numbers(self, text):
        """A node, or those of a set, as texts."""
        return [text] if text.isdigit() else [str(n) for n in self.node_sets.get(text.upper(), [])]

    def _read_pair(self, values, data):
        for row in data:
            if len(row) > 1:
                self.pairs.append(Pair(row[0].upper(), row[1].upper(),
                                       values.get("INTERACTION", "").upper()))

    def _read_law(self, word, values, data):
        if word == "*SURFACEINTERACTION":
            self._name, self._user = values.get("NAME", "").upper(), False
        elif word == "*SURFACEBEHAVIOR":
            # the friction coefficient is the first property of UINTER
            self._user = values.get("PRESSURE-OVERCLOSURE", "").upper() == "UINTER"
            if self._user and data:
                self.friction[self._name] = float(data[0][0])
        elif data and not self._user:
            self.friction[self._name] = float(data[0][0])

    def slave_faces(self):
        """[(pair, faces)] of all contact pairs.

        A surface given by all elements of a body has faces inside it: these do not count. One given
        by nodes has the outer faces all of whose nodes it has, as with UINTER."""
        skin = self.skin()
        outside = {tuple(sorted(face)) for face in skin}
        found = []
        for pair in self.pairs:
            slaves = set(self.node_surfaces.get(pair.slave, ()))
            faces = [face for face in self.surfaces.get(pair.slave, [])
                     if tuple(sorted(face)) in outside]
            found.append((pair, faces + [face for face in skin if slaves.issuperset(face)]))
        return [(pair, faces) for pair, faces in found if faces]

    def skin(self):
        """Faces that belong to one element alone."""
        seen = {}
        for corners in self.elements.values():
            for face in HEX_FACES:
                nodes = tuple(corners[i] for i in face)
                key = tuple(sorted(nodes))
                seen[key] = None if key in seen else nodes
        return [nodes for nodes in seen.values() if nodes]


READERS = {"*NODE": Mesh._read_nodes, "*ELEMENT": Mesh._read_elements,
           "*NSET": Mesh._read_node_set, "*ELSET": Mesh._read_element_set,
           "*SURFACE": Mesh._read_surface, "*CONTACTPAIR": Mesh._read_pair}


def cards(lines):
    """Yield (keyword, parameters, data rows) of a model."""
    word, values, data = "", {}, []
    header = ""
    for line in lines:
        if line.startswith("**") or not line.strip():
            continue
        if header.endswith(","):            # a keyword line goes on
            header += line.strip()
            values = parameters(header)
            continue
        if line.startswith("*"):
            if word:
                yield word, values, data
            header = line.strip()
            word, values, data = keyword(line), parameters(line), []
        else:
            data.append([v.strip() for v in line.split(",")])
    if word:
        yield word, values, data


def new_mesh(lines):
    """The mesh of a model; DeckError for numbers that are none."""
    try:
        return Mesh(lines)
    except (ValueError, IndexError) as problem:
        raise DeckError(f"the model cannot be read: {problem}") from problem
