"""Patch tests: uniform pressure and the law's closure on meshes that match, are tilted or lie off
by whole elements; mu p in sliding; balance and bounds on meshes that do not match.
"""

import math

from blocks import Deck, Interaction, tilt
from harness import Run, at_most, check, close

PRESSURE = 0.2
SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
STIFF = 1e8
# Directions of sliding: 30 degrees off the first slip direction
ALONG = (math.cos(math.pi / 6), math.sin(math.pi / 6), 0.0)
# ccx prints displacements and sums of forces with 7 digits, fields with 6
FIELD_DIGITS = 6e-6


def shortening(pressure, modulus, height):
    """How much a laterally free block of Poisson's ratio 0 shortens, as ccx takes *ELASTIC with
    NLGEOM: 2nd Piola-Kirchhoff stress over Green strain."""
    stretch = 1.0
    for _ in range(60):
        stretch = 1 - pressure / modulus * 2 / (stretch * (stretch + 1))
    return height * (1 - stretch)


def pressed(law, name, angle=0.0, modulus=MODULUS):
    """Two blocks, the lower face of HIGH on LOW, and the displacement of HIGH's top that gives the
    pressure. `offset` stands on a larger LOW that is held everywhere."""
    deck = Deck(tilt(angle))
    element = SIDE / 4
    if name == "offset":
        deck.block("LOW", (0, 0, -HEIGHT), (8 * element, 6 * element, 0), (8, 6, 1), STIFF)
        deck.block("HIGH", (2 * element, element, 0),
                   (2 * element + SIDE, element + SIDE, HEIGHT), (4, 4, 2), modulus)
        fixed, height = "LOW_ALL", HEIGHT
    else:
        deck.block("LOW", (0, 0, -HEIGHT), (SIDE, SIDE, 0), (4, 4, 2), modulus)
        deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 2), modulus)
        fixed, height = "LOW_BOTTOM", 2 * HEIGHT
    down = law.closure(PRESSURE) + shortening(PRESSURE, modulus, height)
    deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")
    return deck, fixed, down


def components(deck, force):
    """A force in the directions of the deck before it was tilted."""
    return [sum(a * b for a, b in zip(force, deck.place(axis)))
            for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]


def motions(deck, run):
    """Displacement of each slave node against the master's node below it, untilted; the master
    of a mesh that lies off is at rest."""
    low, high = deck.blocks
    below = {at[:2]: number for number, at in low.layer(-1).items()}
    slave, master = run.printed.at("HIGH_ALL"), run.printed.at("LOW_ALL")
    found = []
    for number, at in high.layer(0).items():
        node = below[at[:2]]
        found.append(components(deck, [a - b for a, b in zip(slave[number], master[node])]))
    return found


def press(law, uinter, folder, name, angle):
    """Press to a displacement that is computed beforehand from the law and the blocks."""
    deck, fixed, down = pressed(law, name, angle)
    deck.step({fixed: (0, 0, 0), "HIGH_TOP": (0, 0, -down)})
    run = Run(uinter, folder, f"press-{name}", deck).completed(1)
    force = components(deck, run.printed.last_force("HIGH_TOP"))
    close(f"{name}: force over area", -force[2] / SIDE**2, PRESSURE, relative=1e-6)
    at_most(f"{name}: shear force over normal force", math.hypot(*force[:2]) / force[2], 1e-6)
    closures = [-motion[2] for motion in motions(deck, run)]
    expected = law.closure(PRESSURE)
    check(f"{name}: 25 springs", len(run.contact) == 25, f"{len(run.contact)}")
    worst = max(closures, key=lambda c: abs(c - expected))
    close(f"{name}: worst closure of the nodes", worst, expected, relative=1e-6)
    pressures = [law.pressure(closure) for closure in closures]
    at_most(f"{name}: pressure not uniform", (max(pressures) - min(pressures)) / PRESSURE, 1e-6)
    worst = max((row[3] for row in run.contact.values()), key=lambda p: abs(p - PRESSURE))
    close(f"{name}: worst pressure in the field", worst, PRESSURE, relative=FIELD_DIGITS)


def sliding(law, uinter, folder, name, angle):
    """mu p gamma/gcrit in stick and mu p in slip, along the motion."""
    deck = Deck(tilt(angle))
    element = SIDE / 4
    # a master that reaches two elements past the slave all around
    deck.block("LOW", (-2 * element, -2 * element, -HEIGHT),
               (SIDE + 2 * element, SIDE + 2 * element, 0), (8, 8, 1), STIFF)
    shift = element if name == "offset" else 0.0
    deck.block("HIGH", (shift, shift, 0), (SIDE + shift, SIDE + shift, HEIGHT), (4, 4, 1), STIFF)
    deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")
    down = law.closure(PRESSURE) + shortening(PRESSURE, STIFF, HEIGHT)
    deck.step({"LOW_ALL": (0, 0, 0), "HIGH_TOP": (0, 0, -down)})
    for distance in (0.1, 1.0):
        deck.step({"HIGH_TOP": (distance * ALONG[0], distance * ALONG[1], -down)})
    run = Run(uinter, folder, f"slide-{name}", deck).completed(3)
    for when, words, share in ((2.0, "stick", 0.1 / law.critical_slip), (3.0, "slip", 1.0)):
        force = components(deck, run.printed.forces["HIGH_TOP"][when])
        close(f"{name}: shear over normal force in {words}",
              (force[0] * ALONG[0] + force[1] * ALONG[1]) / -force[2], law.mu * share,
              absolute=1e-6 * law.mu)
        at_most(f"{name}: force across the motion in {words}, over the normal force",
                (force[1] * ALONG[0] - force[0] * ALONG[1]) / force[2], 1e-6)


def not_matching(law, stock, uinter, folder, slave, master, most):
    """Meshes that do not match: the force balances, and UINTER is as far from uniform as ccx's own
    spring is with a table of the same law. Node-to-face contact does not pass this patch test."""
    rows = law.table(PRESSURE)
    runs = {}
    for program, ccx, interaction in (
            ("stock", stock, Interaction.table("WOOD", rows, law.mu, law.stick_slope(PRESSURE))),
            ("uinter", uinter, Interaction.uinter("WOOD", law.props()))):
        deck = Deck()
        deck.block("LOW", (0, 0, -HEIGHT), (SIDE, SIDE, 0), (master, master, 2), MODULUS)
        deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (slave, slave, 2), MODULUS)
        deck.contact(interaction, "HIGH_DOWN", "LOW_UP")
        down = law.closure(PRESSURE) + shortening(PRESSURE, MODULUS, 2 * HEIGHT)
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -down)})
        runs[program] = Run(ccx, folder, f"{program}-{slave}-on-{master}", deck).completed(1)
    name = f"{slave}x{slave} on {master}x{master}"
    pressed = runs["uinter"].printed.last_force("HIGH_TOP")
    carried = runs["uinter"].printed.last_force("LOW_BOTTOM")
    at_most(f"{name}: forces do not balance",
            math.dist(pressed, [-force for force in carried]) / pressed[2], 1e-6)
    springs = {program: run.contact for program, run in runs.items()}
    nodes = (slave + 1)**2
    if not check(f"{name}: springs", set(springs["stock"]) == set(springs["uinter"])
                 and len(springs["stock"]) == nodes,
                 f"{len(springs['stock'])} and {len(springs['uinter'])} of {nodes}"):
        return
    off = {program: [row[3] / PRESSURE - 1 for row in rows.values()]
           for program, rows in springs.items()}
    # 6 digits of both, the table's 4e-6, and its one stick slope for all pressures
    for words, extreme in (("lowest", min), ("highest", max)):
        close(f"{name}: {words} pressure off uniform, as stock", extreme(off["uinter"]),
              extreme(off["stock"]), absolute=1e-4)
    at_most(f"{name}: largest difference of a node's pressure to stock",
            max(abs(springs["uinter"][node][3] / row[3] - 1)
                for node, row in springs["stock"].items()), 1e-4)
    at_most(f"{name}: pressure off uniform", max(map(abs, off["uinter"])), most)


def far_sliding(law, stock, uinter, folder):
    """Slide 9 mm over faces of 4.3 mm that do not match: as stock, within what its slip loses by
    the strain of the faces."""
    rows = law.table(PRESSURE, band=3.0)
    runs = {}
    for program, ccx, interaction in (
            ("stock", stock, Interaction.table("WOOD", rows, law.mu, law.stick_slope(PRESSURE))),
            ("uinter", uinter, Interaction.uinter("WOOD", law.props()))):
        deck = Deck()
        deck.block("LOW", (0, 0, -HEIGHT), (SIDE, SIDE, 0), (7, 7, 1), MODULUS)
        deck.block("HIGH", (5, 5, 0), (15, 15, HEIGHT), (3, 3, 1), MODULUS)
        deck.contact(interaction, "HIGH_DOWN", "LOW_UP")
        down = 1.2 * law.closure(PRESSURE)
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -down)}, residual=1e-6)
        deck.step({"HIGH_TOP": (9 * ALONG[0], 9 * ALONG[1], -down)}, increment=0.1, residual=1e-6)
        runs[program] = Run(ccx, folder, f"{program}-far", deck).completed(2)
    forces = {program: run.printed.last_force("HIGH_TOP") for program, run in runs.items()}
    for axis, words in ((0, "along x"), (1, "along y"), (2, "normal")):
        close(f"far sliding: force {words}, as stock", forces["uinter"][axis],
              forces["stock"][axis], relative=5e-4)
    counts = {program: sum(map(len, run.iterations.values())) for program, run in runs.items()}
    check("far sliding: no more iterations than stock and 10 %",
          counts["uinter"] <= 1.1 * counts["stock"], f"{counts['uinter']}, {counts['stock']}")
