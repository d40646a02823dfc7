"""A job that is read back and goes on, with the state of the springs and UINTER's properties."""

import math

from blocks import Deck, Interaction
from harness import Run, at_most, check

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0


def restart(law, uinter, folder):
    """Press and stick, stop, read back and slide on; against one job of all steps."""
    deck = Deck()
    deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
    deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", law.props()), "HIGH_DOWN", "LOW_UP")
    write = ["*RESTART,WRITE,FREQUENCY=1"]
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.1)}, more=write)
    deck.step({"HIGH_TOP": (0.1, 0.05, -0.1)}, more=write)
    begun = Run(uinter, folder, "restart-begun", deck).completed(2)
    steps = len(deck.steps)
    deck.step({"HIGH_TOP": (0.25, -0.1, -0.11)})
    whole = Run(uinter, folder, "restart-whole", deck).completed(3)
    rest = "\n".join(["*RESTART,READ,STEP=2", *deck.steps[steps:]]) + "\n"
    files = [path for path in begun.folder.iterdir() if path.name.startswith("job.")]
    resumed = Run(uinter, folder, "restart-resumed", rest, files=[
        (path, path.name.replace("job.rout", "job.rin")) for path in files
        if path.suffix not in (".inp", ".dat", ".frd", ".sta", ".cvg")]).completed(3)
    forces = [run.printed.last_force("HIGH_TOP") for run in (whole, resumed)]
    at_most("restart: force off the job of all steps, over the shear force",
            math.dist(*forces) / math.hypot(*forces[0][:2]), 1e-6)
    worst = max(abs(a - b) for node, row in whole.contact.items()
                for a, b in zip(row, resumed.contact[node]))
    at_most("restart: fields of contact off", worst, 1e-6)
    # what the shear would be without a memory of the slip before the restart
    fresh = law.mu * math.hypot(0.15, 0.15) / law.critical_slip
    found = math.hypot(*forces[0][:2]) / abs(forces[0][2])
    check("restart: the slip of before matters", abs(found - fresh) > 0.02,
          f"{found:.3f}, {fresh:.3f} without")
    bare = Run(uinter, folder, "restart-bare", rest, files=[
        (begun.file("rout"), "job.rin")])
    check("restart: without the file of properties it ends with an error status and says so",
          bare.status != 0 and "*ERROR" in bare.log, f"{bare.status}")
