"""Blocks that are pressed and sheared, then turned together: pressure and shear turn with them."""

import math

from blocks import Deck, Interaction
from harness import Run, at_most

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
DOWN, ALONG, TURN = 0.1, (0.12, 0.05), 1.0


def turn(axis, degrees):
    """Rotation about an axis of length 1 through the origin (Rodrigues)."""
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def of(v):
        along = (1 - cosine) * sum(a * b for a, b in zip(axis, v))
        cross = (axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                 axis[0] * v[1] - axis[1] * v[0])
        return [cosine * b + along * a + sine * c for a, b, c in zip(axis, v, cross)]
    return of


def turned(law, uinter, folder, name, axis):
    """A turn of 4 degrees in four increments: in between, ccx moves the nodes along chords. After
    more than 8 iterations, in longer ones, it would be left with the areas of the eighth."""
    size = math.hypot(*axis)
    axis = [component / size for component in axis]
    deck = Deck()
    low = deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
    high = deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", law.props(), search_distance=3.0), "HIGH_DOWN",
                 "LOW_UP")
    deck.step({"LOW_ALL": (0, 0, 0), "HIGH_TOP": (0, 0, -DOWN)}, increment=0.5)
    deck.step({"HIGH_TOP": (*ALONG, -DOWN)}, increment=0.5)
    for quarter in range(1, 5):
        of, motions = turn(axis, quarter * TURN), {}
        for nodes, shift in ((dict(low.nodes.values()), (0, 0, 0)),
                             (high.layer(-1), (*ALONG, -DOWN))):
            for number, at in nodes.items():
                there = of([a + b for a, b in zip(at, shift)])
                motions[number] = [b - a for a, b in zip(at, there)]
        deck.step(motions, increment=1.0, residual=1e-8)
    run = Run(uinter, folder, f"turn-{name}", deck).completed(6)
    before = run.printed.forces["HIGH_TOP"][2.0]
    after = run.printed.last_force("HIGH_TOP")
    at_most(f"turned about {name}: force off the turned one, over the shear force",
            math.dist(after, turn(axis, 4 * TURN)(before)) / math.hypot(*before[:2]), 1e-5)
    fields = run.contact_history
    fields = [fields[when] for when in (2.0, 6.0)]
    at_most(f"turned about {name}: pressures and sizes of shear of the nodes", max(
        max(abs(a[3] - b[3]), abs(math.hypot(*a[4:]) - math.hypot(*b[4:]))) / a[3]
        for a, b in ((row, fields[1][node]) for node, row in fields[0].items() if row[3])), 2e-5)
