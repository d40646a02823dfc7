"""What CalculiX (2.20) computes wrongly, without a word, of a deck's contact pairs."""

from .files.deck import DeckError
from .files.mesh import cards

# Types of contact pairs whose springs are node to surface
NODE_TO_SURFACE = ("NODETOSURFACE", "MASSLESS")


def squeezed(text):
    """As ccx compares: in capitals, without blanks."""
    return "".join(text.split()).upper()


def check_pairs(deck):
    """Refuse pairs that would come out wrong; return remarks on the others."""
    laws, types, by_nodes, remarks, name = {}, set(), set(), [], ""
    for word, values, data in cards(deck.model):
        if word == "*SURFACEINTERACTION":
            name = squeezed(values.get("NAME", ""))
        elif word == "*SURFACEBEHAVIOR":
            laws[name] = squeezed(values.get("PRESSURE-OVERCLOSURE", ""))
        elif word == "*SURFACE" and squeezed(values.get("TYPE", "")) == "NODE":
            by_nodes.add(squeezed(values.get("NAME", "")))
        elif word == "*CONTACTPAIR":
            kind = squeezed(values.get("TYPE", ""))
            types.add(kind)
            law = laws.get(squeezed(values.get("INTERACTION", "")))
            at = f"{deck.path}: *CONTACT PAIR {', '.join(data[0]) if data else ''}"
            if law == "UINTER" and kind not in NODE_TO_SURFACE:
                name = values.get("INTERACTION", "")
                raise DeckError(f"{at}: UINTER serves node to surface alone: with others, such as "
                                "SURFACE TO SURFACE, CalculiX does not call it; write *CONTACT "
                                f"PAIR, INTERACTION={name}, TYPE=NODE TO SURFACE, and below it "
                                "the surface with the finer mesh first")
            if law == "TABULAR" and kind == "SURFACETOSURFACE":
                raise DeckError(f"{at}: a table with SURFACE TO SURFACE gives no pressure at all in "
                                "CalculiX, and no message: take NODE TO SURFACE")
            if law != "UINTER" and data and squeezed(data[0][0]) in by_nodes:
                remarks.append(f"slave surface {data[0][0]} is given by nodes: CalculiX counts the "
                               "sides of the body to its area, and pressures come out too small; "
                               "name the faces")
    totals = {squeezed(text) for step in deck.steps for word, _, data in cards(step)
              if word == "*CONTACTPRINT" for row in data for text in row} & {"CF", "CFN", "CFS"}
    if totals and types <= set(NODE_TO_SURFACE):
        remarks.append(f"*CONTACT PRINT of {', '.join(sorted(totals))}: CalculiX writes zeros for "
                       "NODE TO SURFACE; interface/calculix/contact sums pressures")
    return remarks
