"""Springs on several threads give what they give on one."""

import os

from blocks import Deck, Interaction
from harness import Run, at_most, check
from .cutback import ends, far

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0


def threads(law, uinter, folder):
    """Press by a wedge and slide, on one thread and on two."""
    runs = []
    for count in ("1", "2"):
        deck = Deck()
        deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (7, 7, 1), MODULUS)
        high = deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (6, 6, 1), MODULUS)
        deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")
        for along in (0.0, 0.8):
            deck.step({"LOW_BOTTOM": (0, 0, 0), **{
                number: (along, 0, -0.1 - 0.02 * at[0] / SIDE)
                for number, at in high.layer(-1).items()}})
        runs.append(Run(uinter, folder, f"threads-{count}", deck, {
            "OMP_NUM_THREADS": count, "CCX_NPROC_STIFFNESS": count,
            "CCX_NPROC_RESULTS": count}).completed(2))
    used = ["2 cpu(s) for the stress calculation" in run.log for run in runs]
    if (os.cpu_count() or 1) > 1:
        check("threads: two were used", used == [False, True])
    at_most("threads: two give what one gives", far(ends(runs[0]), ends(runs[1])), 2e-6)
    counts = [sum(map(len, run.iterations.values())) for run in runs]
    check("threads: as many iterations", counts[0] == counts[1], str(counts))
