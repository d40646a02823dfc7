"""Newton's method with the stiffness of the springs: residuals fall quadratically in stick, in slip
and under pressure that varies, and with the symmetric part of the stiffness they do not."""

from blocks import Deck, Interaction
from harness import Run, check

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
# ccx writes no residual below 1e-6 N; in shares of the mean force that is less than this
FLOOR = 1e-6


def wedge(law, down, steps):
    """Two soft blocks, the upper one's top pressed down by a wedge: 20 % more on one side."""
    deck = Deck()
    deck.block("LOW", (-SIDE / 4, -SIDE / 4, -HEIGHT), (1.25 * SIDE, 1.25 * SIDE, 0), (6, 6, 1),
               MODULUS)
    high = deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")

    def pushed(along):
        return {number: (along, 0.5 * along, -down * (1 + 0.2 * at[0] / SIDE))
                for number, at in high.layer(-1).items()}

    deck.step({"LOW_BOTTOM": (0, 0, 0), **pushed(0.0)}, increment=0.25)
    for along, increment in steps:
        deck.step(pushed(along), increment=increment)
    return deck


def worst_factor(residuals):
    """Largest r(next)/r^2 of residuals (shares of the mean force) once below 10 %."""
    worst = 0.0
    for before, after in zip(residuals, residuals[1:]):
        if FLOOR**0.5 < before < 0.1:
            worst = max(worst, max(after - FLOOR, 0.0) / before**2)
    return worst


def quadratic(law, uinter, folder):
    """Every increment of a run in stick, in slip and under a wedge; then the same symmetrised."""
    deck = wedge(law, 0.14, ((0.1, 0.5), (1.5, 0.25)))
    full = Run(uinter, folder, "newton-full", deck).completed(3)
    symmetric = Run(uinter, folder, "newton-symmetric", deck,
                    {"ASPERITY_CALCULIX_TANGENT": "symmetric"}).completed(3)
    for step, words in ((1, "varying pressure"), (2, "stick"), (3, "slip")):
        histories = [[row[1] / 100 for row in rows] for (number, _, _), rows
                     in full.iterations.items() if number == step]
        factors = [worst_factor(residuals) for residuals in histories]
        longest = max(histories, key=len)
        check(f"newton, {words}: r(next) < 2 r^2 in every increment", max(factors) < 2,
              f"factor {max(factors):.2g}; longest: "
              + ", ".join(f"{100 * r:.3g} %" for r in longest))
    slow = [worst_factor([row[1] / 100 for row in rows])
            for rows in symmetric.iterations.values()]
    check("newton, symmetrised: not quadratic", max(slow) > 2, f"factor {max(slow):.2g}")
    counts = [sum(map(len, run.iterations.values())) for run in (full, symmetric)]
    check("newton: fewer iterations with the full stiffness", counts[0] < counts[1],
          f"{counts[0]} against {counts[1]} symmetrised")
    ends = [run.printed.last_force("HIGH_TOP") for run in (full, symmetric)]
    check("newton: the same forces with both", all(
        abs(a - b) < 1e-5 * abs(ends[0][2]) for a, b in zip(*ends)), f"{ends[0]}")
