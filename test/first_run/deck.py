"""The decks of the first run in ABAQUS: what their faces do, and the same model for CalculiX."""

from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "interface" / "abaqus" / "ready" / "first_run"
NAMES = ("one_point", "two_blocks")
# Cards that ask ABAQUS for output; CalculiX prints the totals alone
OUTPUT = ("*NODE PRINT", "*CONTACT PRINT", "*OUTPUT", "*NODE OUTPUT", "*CONTACT OUTPUT")


class Card:
    """A keyword, its parameters, and its data lines, comments left out."""

    def __init__(self, line):
        name, *parameters = [word.strip().upper() for word in line.split(",")]
        self.name, self.line, self.data = name, line, []
        self.parameters = dict((word.split("=") + [""])[:2] for word in parameters)


def cards(text):
    """The cards of a deck. A blank line is data: ABAQUS takes the first of *SURFACE INTERACTION."""
    found = []
    for line in text.splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            found.append(Card(line))
        else:
            found[-1].data.append([word.strip() for word in line.split(",")])
    return found


class Deck:
    """One of the decks."""

    def __init__(self, name):
        self.name = name
        self.text = (FOLDER / f"{name}.inp").read_text(encoding="ascii")
        self.cards = cards(self.text)

    def card(self, name, **parameters):
        """The one card of a name with such parameters."""
        found, = (card for card in self.cards if card.name == name and all(
            card.parameters.get(key) == value for key, value in parameters.items()))
        return found

    @property
    def properties(self):
        """PROPS of UINTER; a thickness would stand on the line before."""
        first, *lines = self.card("*SURFACE INTERACTION").data
        assert first == [""], first
        return [float(word) for line in lines for word in line]

    @property
    def face(self):
        """Corners of the slave face, lowest and highest."""
        nodes = {row[0]: [float(word) for word in row[1:]] for row in self.card("*NODE").data}
        points = [nodes[word] for line in self.card("*NSET", NSET="FACE").data for word in line]
        return [min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)]

    @property
    def area(self):
        """Area of the slave face, mm2."""
        low, high = self.face
        return (high[0] - low[0])*(high[1] - low[1])

    @property
    def path(self):
        """(time, overclosure, slip 1, slip 2) at the end of every increment: displacements go in a
        straight line through each step, and the face comes from its gap in the mesh."""
        gap = self.face[0][2]
        rows, start, where, began = [], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], 0
        length = duration = 1.0
        for card in self.cards:
            if card.name == "*STEP":
                start = list(where)
            elif card.name == "*STATIC":
                length, duration = map(float, card.data[0])
            elif card.name == "*BOUNDARY":
                for name, first, last, *value in card.data:
                    if name == "FACE":
                        assert first == last
                        where[int(first) - 1] = float(value[0])
            elif card.name == "*END STEP":
                count = round(duration/length)
                for i in range(1, count + 1):
                    at = [a + (b - a)*i/count for a, b in zip(start, where)]
                    rows.append((round(began + i*length, 9), round(-at[2] - gap, 12),
                                 round(at[0], 12), round(at[1], 12)))
                began += duration
        return rows

    def calculix(self, properties=None, search_distance=1.0):
        """The same model in CalculiX' words, with other properties if so wished."""
        lines = []
        for card in self.cards:
            data = [", ".join(row) for row in card.data]
            if card.name == "*SURFACE INTERACTION":
                values = properties or self.properties
                depvar = card.parameters["DEPVAR"]
                lines += [f"*SURFACE INTERACTION, NAME={card.parameters['NAME']}",
                          "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, "
                          f"PROPERTIES={len(values)}, DEPVAR={depvar}, "
                          f"SEARCH DISTANCE={search_distance:g}"]
                lines += [", ".join(f"{value:.12g}" for value in values[i:i + 8])
                          for i in range(0, len(values), 8)]
                lines += ["*FRICTION", "1., 1."]
            elif card.name == "*STEP":
                lines.append("*STEP, NLGEOM, INC=100")
            elif card.name == "*NODE PRINT":
                lines += ["*NODE PRINT, NSET=FACE, TOTALS=ONLY", "RF"]
            elif card.name not in OUTPUT:
                lines += [card.line, *data]
        return "\n".join(lines) + "\n"
