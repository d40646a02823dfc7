"""Springs of other interactions, and springs that are no contact, beside UINTER: as in a stock ccx.
A stock ccx refuses a deck with UINTER, and UINTER's ccx a deck that is wrong."""

import math

from blocks import Deck, Interaction
from harness import Run, at_most, check
from .arguments import props

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
# ccx's EXPONENTIAL: p = p0 exp(ln(100) overclosure/c0)
P0, C0, MU, SLOPE = 0.02, 0.4, 0.5, 0.3
EXPONENTIAL = Interaction.exponential("OTHER", C0, P0, MU, SLOPE)


def two_pairs(interaction):
    """Two pairs of blocks apart: one with the interaction, one always ccx's EXPONENTIAL, with a
    spring and a gap element between its blocks besides."""
    deck = Deck()
    first = 0.0
    for pair in ("A", "B"):
        deck.block(f"LOW{pair}", (first - 5, -5, -HEIGHT), (first + SIDE + 5, SIDE + 5, 0),
                   (5, 5, 1), MODULUS)
        deck.block(f"HIGH{pair}", (first, 0, 0), (first + SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
        first += 100.0
    low, high = deck.blocks[2:]
    corner, below = high.nodes[4, 4, 0][0], low.nodes[5, 5, 0][0]
    middle, under = high.nodes[2, 2, 0][0], low.nodes[2, 2, 0][0]
    deck.model += ["*ELEMENT,TYPE=SPRINGA,ELSET=SPRING", f"90001, {corner}, {below}",
                   "*SPRING,ELSET=SPRING", "", "20.",
                   "*ELEMENT,TYPE=GAPUNI,ELSET=GAP", f"90002, {under}, {middle}",
                   "*GAP,ELSET=GAP", "-0.02, 0., 0., 1., , 500., 0.01"]
    deck.contact(interaction, "HIGHA_DOWN", "LOWA_UP")
    deck.contact(EXPONENTIAL, "HIGHB_DOWN", "LOWB_UP")
    deck.step({"LOWA_BOTTOM": (0, 0, 0), "LOWB_BOTTOM": (0, 0, 0), "HIGHA_TOP": (0, 0, -0.1),
               "HIGHB_TOP": (0, 0, -0.1)}, residual=1e-8)
    deck.step({"HIGHA_TOP": (0.6, 0.1, -0.1), "HIGHB_TOP": (0.6, 0.1, -0.1)}, residual=1e-8)
    return deck


def apart(law, stock, uinter, folder):
    """The pair that is not UINTER's comes out as in a stock ccx, digit by digit."""
    table = Interaction.table("WOOD", law.table(0.2), law.mu, law.stick_slope(0.2))
    runs = [Run(stock, folder, "mixed-stock", two_pairs(table)).completed(2),
            Run(uinter, folder, "mixed-uinter",
                two_pairs(Interaction.uinter("WOOD", law.props()))).completed(2)]
    compare("mixed, pairs apart: the pair with EXPONENTIAL, a spring and a gap", runs, "B")
    springs = [len(run.contact) for run in runs]
    check("mixed, pairs apart: 50 springs", springs == [50, 50], str(springs))


def compare(name, runs, pair=""):
    """Displacements and forces of the upper block, and of the lower, in both runs."""
    sets = [f"LOW{pair}_ALL", f"HIGH{pair}_ALL"]
    off = max(math.dist(at, runs[1].printed.at(one)[node])
              for one in sets for node, at in runs[0].printed.at(one).items())
    at_most(f"{name}: displacements off stock, mm", off, 1e-6)
    forces = [run.printed.last_force(f"HIGH{pair}_TOP") for run in runs]
    at_most(f"{name}: forces off stock, over the normal force",
            math.dist(*forces) / abs(forces[0][2]), 1e-5)


def halves(stock, recorder, folder):
    """One face in two halves, one UINTER's with the formula of EXPONENTIAL, the other ccx's own;
    against both halves ccx's own."""
    runs = []
    for ccx, name, left in (
            (stock, "stock", Interaction.exponential("LEFT", C0, P0, MU, SLOPE)),
            (recorder, "uinter", Interaction.uinter("LEFT", props(
                P0, C0 / math.log(100), mu=MU, slope=SLOPE, record=0), 5, C0))):
        deck = Deck()
        deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
        high = deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
        # a node between the halves has a spring in each
        for half, columns in (("LEFT", (0, 1)), ("RIGHT", (2, 3))):
            deck.model += [f"*SURFACE,NAME={half}"] + [
                f"{number}, S1" for (i, _, k), (number, _) in high.elements.items()
                if i in columns and k == 0]
        deck.contact(left, "LEFT", "LOW_UP")
        deck.contact(EXPONENTIAL, "RIGHT", "LOW_UP")
        top = {number: (0, 0, -0.1 - 0.1 * at[0] / SIDE)
               for number, at in high.layer(-1).items()}
        deck.step({"LOW_BOTTOM": (0, 0, 0), **top}, residual=1e-8)
        runs.append(Run(ccx, folder, f"halves-{name}", deck).completed(1))
    name = "mixed, two halves of a face"
    counts = [rows[-1][0] for run in runs for rows in list(run.iterations.values())[-1:]]
    check(f"{name}: 30 springs", counts == [30, 30], str(counts))
    compare(name, runs)


def refused(law, stock, folder):
    """A stock ccx computes nothing with a deck for UINTER."""
    deck = Deck()
    deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
    deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.1)})
    run = Run(stock, folder, "refused", deck)
    check("refused: a stock ccx ends with an error status", run.status != 0, f"{run.status}")
    check("refused: it says so", "*ERROR" in run.log)
    printed = run.file("dat")
    check("refused: no displacement is printed",
          not printed.exists() or "displacements" not in printed.read_text(encoding="ascii"))


def bad_decks(law, uinter, folder):
    """Each of these ends with an error status and a word on what is wrong."""
    good = Interaction.uinter("WOOD", law.props()).lines
    head, lines, friction = good[0], good[1:-2], good[-2:]
    no_pi = list(law.props())
    no_pi[4] = 0.0
    cases = (
        ("fewer-properties", "fewer properties", [head, lines[0], *friction]),
        ("more-properties", "more properties", [head, *lines, "1.", *friction]),
        ("no-properties", "PROPERTIES", [head.replace("PROPERTIES=12,", ""), *lines, *friction]),
        ("no-depvar", "DEPVAR", [head.replace("DEPVAR=11,", ""), *lines, *friction]),
        ("small-depvar", "DEPVAR", [head.replace("DEPVAR=11", "DEPVAR=5"), *lines, *friction]),
        ("no-distance", "SEARCH DISTANCE", [head.split(",SEARCH")[0], *lines, *friction]),
        ("negative-distance", "SEARCH DISTANCE", [head.replace("=0.5", "=-0.5"), *lines,
                                                  *friction]),
        ("unknown-parameter", "SERCH", [head.replace("SEARCH", "SERCH"), *lines, *friction]),
        ("no-number", "number", [head, lines[0].replace("206", "2O6"), lines[1], *friction]),
        ("no-friction", "FRICTION", [head, *lines]),
        ("no-pi", "PROPS", [head, *Interaction.uinter("WOOD", no_pi).lines[1:]]),
    )
    for name, word, cards in cases:
        deck = Deck()
        deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (2, 2, 1), MODULUS)
        deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (1, 1, 1), MODULUS)
        deck.contact(Interaction("WOOD", cards), "HIGH_DOWN", "LOW_UP")
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.1)})
        run = Run(uinter, folder, f"bad-{name}", deck)
        said = [line for line in run.log.splitlines() if word in line.upper() or word in line]
        said = [line for line in said if "ERROR" in line.upper()]
        check(f"bad deck, {name}: error status and message", run.status != 0 and bool(said),
              f"{run.status}: {said[0].strip()[:110] if said else run.log.strip()[-200:]}")
