"""Decks for CalculiX of rectangular blocks that are pressed together, N-mm-MPa."""

import math


def fields(values):
    """One data line; ccx reads 20 characters of a field at most."""
    return ", ".join(f"{value:.12g}" for value in values)


def data_lines(values):
    """Data lines of eight values each."""
    return [fields(values[i:i + 8]) for i in range(0, len(values), 8)]


def tilt(degrees):
    """Rotation about y, of a point or a direction."""
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return lambda v: (cosine * v[0] + sine * v[2], v[1], -sine * v[0] + cosine * v[2])


class Block:
    """A mesh of equal hexahedra; nodes carry their numbers by position (i, j, k)."""

    def __init__(self, name, low, high, divisions, first_node, first_element):
        self.name, self.divisions, self.nodes, self.elements = name, divisions, {}, {}
        nx, ny, nz = divisions
        for k in range(nz + 1):
            for j in range(ny + 1):
                for i in range(nx + 1):
                    share = (i / nx, j / ny, k / nz)
                    self.nodes[i, j, k] = (first_node + len(self.nodes), tuple(
                        a + (b - a) * s for a, b, s in zip(low, high, share)))
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    corners = [(i, j, k), (i + 1, j, k), (i + 1, j + 1, k), (i, j + 1, k)]
                    corners += [(a, b, k + 1) for a, b, _ in corners]
                    self.elements[i, j, k] = (first_element + len(self.elements),
                                              [self.nodes[corner][0] for corner in corners])

    def layer(self, k):
        """Nodes of a layer, {number: position}; -1 is the top."""
        k = k % (self.divisions[2] + 1)
        return {number: at for (_, _, layer), (number, at) in self.nodes.items() if layer == k}

    def faces(self, k, face):
        """(element, face label) of a layer of elements; -1 is the top."""
        k = k % self.divisions[2]
        return [(number, face) for (_, _, layer), (number, _) in self.elements.items()
                if layer == k]


class Interaction:
    """How two surfaces meet: the cards between *SURFACE INTERACTION and *CONTACT PAIR."""

    def __init__(self, name, lines):
        self.name, self.lines = name, lines

    @classmethod
    def uinter(cls, name, props, depvar=11, search_distance=0.5):
        """A UINTER; springs are made for slave nodes nearer than the search distance."""
        return cls(name, [f"*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=UINTER,PROPERTIES={len(props)},"
                          f"DEPVAR={depvar},SEARCH DISTANCE={search_distance:g}",
                          *data_lines(props), "*FRICTION", "1.,1."])

    @classmethod
    def table(cls, name, rows, mu, stick_slope):
        """Rows (pressure, overclosure), for every ccx."""
        return cls(name, ["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TABULAR",
                          *[fields(row) for row in rows], "*FRICTION", fields((mu, stick_slope))])

    @classmethod
    def exponential(cls, name, distance, pressure, mu, stick_slope):
        """p = pressure exp(ln(100) overclosure/distance), for every ccx."""
        return cls(name, ["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=EXPONENTIAL",
                          fields((distance, pressure)), "*FRICTION", fields((mu, stick_slope))])


class Deck:
    """Blocks, pairs and steps, in the order in which they were added."""

    def __init__(self, place=lambda v: v, element="C3D8I"):
        self.place, self.element, self.blocks = place, element, []
        self.model, self.pairs, self.steps, self.prints = [], [], [], []
        self.next_node = self.next_element = 1

    def block(self, name, low, high, divisions, modulus=351.0, poisson=0.0):
        """Add a block. Its sets NAME_TOP, NAME_BOTTOM and NAME_ALL hold nodes, its surfaces
        NAME_UP and NAME_DOWN are the upper faces and the lower nodes' faces."""
        new = Block(name, low, high, divisions, self.next_node, self.next_element)
        self.next_node += len(new.nodes)
        self.next_element += len(new.elements)
        self.blocks.append(new)
        lines = ["*NODE"]
        lines += [f"{number}, {fields(self.place(at))}" for number, at in new.nodes.values()]
        lines += [f"*ELEMENT,TYPE={self.element},ELSET={name}"]
        lines += [f"{number}, " + ", ".join(map(str, nodes))
                  for number, nodes in new.elements.values()]
        for label, layer in (("TOP", new.layer(-1)), ("BOTTOM", new.layer(0)),
                             ("ALL", [number for number, _ in new.nodes.values()])):
            lines += [f"*NSET,NSET={name}_{label}", *[f"{number}," for number in layer]]
        for label, faces in (("UP", new.faces(-1, "S2")), ("DOWN", new.faces(0, "S1"))):
            lines += [f"*SURFACE,NAME={name}_{label}", *[f"{number}, {face}"
                                                         for number, face in faces]]
        lines += [f"*MATERIAL,NAME={name}", "*ELASTIC", fields((modulus, poisson)),
                  f"*SOLID SECTION,ELSET={name},MATERIAL={name}"]
        self.model += lines
        return new

    def contact(self, interaction, slave, master):
        """Add a pair of surfaces; one interaction may serve several pairs."""
        if interaction.name not in [known.name for known, _, _ in self.pairs]:
            self.model += [f"*SURFACE INTERACTION,NAME={interaction.name}", *interaction.lines]
        self.pairs.append((interaction, slave, master))
        self.model += [f"*CONTACT PAIR,INTERACTION={interaction.name},TYPE=NODE TO SURFACE",
                       f"{slave},{master}"]

    def step(self, motions, increment=0.25, residual=1e-9, direct=False, more=(), output=True):
        """Add a step that brings sets of nodes to displacements (x, y, z) of the untilted deck;
        a component that is None stays free."""
        lines = ["*STEP,NLGEOM,INC=500", "*STATIC" + (",DIRECT" if direct else ""),
                 f"{increment:g}, 1., 1e-6, {increment:g}",
                 "*CONTROLS,PARAMETERS=TIME INCREMENTATION", "20,25,9,40,12,4,,12",
                 "*CONTROLS,PARAMETERS=FIELD", f"{residual:g},1.e-2,,,1.e-2,1.e-9"]
        for name, motion in motions.items():
            lines += ["*BOUNDARY"]
            values = motion if None in motion else self.place(motion)
            lines += [f"{name},{axis},{axis},{value:.12g}"
                      for axis, value in enumerate(values, 1) if value is not None]
        lines += more
        if output:
            for block in self.blocks:
                lines += [f"*NODE PRINT,NSET={block.name}_TOP,TOTALS=ONLY", "RF",
                          f"*NODE PRINT,NSET={block.name}_BOTTOM,TOTALS=ONLY", "RF",
                          f"*NODE PRINT,NSET={block.name}_ALL", "U"]
            lines += ["*NODE FILE", "U", "*CONTACT FILE", "CDIS,CSTR"]
        self.steps += [*lines, "*END STEP"]

    def text(self):
        """The deck."""
        return "\n".join(self.model + self.steps) + "\n"
