"""Press, slide, lift, move back in the air, press again: the shear of before is gone. ccx's own
spring brings it back with the slip that was travelled in the air."""

from blocks import Deck, Interaction
from harness import Run, at_most, check, close

PRESSURE = 0.2
SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0


def lifted(law, interaction, lift):
    """The five steps; the block moves back by 0.5 of 1 mm in the air."""
    deck = Deck()
    deck.block("LOW", (-SIDE / 4, -SIDE / 4, -HEIGHT), (1.25 * SIDE, 1.25 * SIDE, 0), (6, 6, 1),
               MODULUS)
    deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(interaction, "HIGH_DOWN", "LOW_UP")
    down = law.closure(PRESSURE)
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -down)})
    for motion in ((1.0, 0, -down), (1.0, 0, lift), (0.5, 0, lift), (0.5, 0, -down)):
        deck.step({"HIGH_TOP": motion})
    return deck


def shear(run, when):
    """Shear over normal force on the upper block at a time."""
    force = run.printed.forces["HIGH_TOP"][when]
    return force[0] / -force[2]


def stock_keeps_shear(law, stock, folder):
    """What a stock ccx does, so that it is known when it changes."""
    interaction = Interaction.table("WOOD", law.table(PRESSURE), law.mu,
                                    law.stick_slope(PRESSURE))
    run = Run(stock, folder, "lift-stock", lifted(law, interaction, 1.25)).completed(5)
    close("lift, stock ccx: mu p while it slides", shear(run, 2.0), law.mu, relative=1e-3)
    close("lift, stock ccx: mu p again after the air, backwards", shear(run, 5.0), -law.mu,
          relative=1e-3)


def uinter_forgets(law, uinter, folder):
    """No shear, whether the springs vanish in the air or are kept by the search distance. What
    there is comes from meshes that no longer match."""
    for lift, search, words, kept in ((1.25, 0.5, "springs vanish", 0),
                                      (0.3, 0.5, "springs stay", 25),
                                      (1.25, 3.0, "springs stay, far", 25)):
        interaction = Interaction.uinter("WOOD", law.props(), search_distance=search)
        run = Run(uinter, folder, f"lift-{lift}-{search}",
                  lifted(law, interaction, lift)).completed(5)
        close(f"lift, {words}: mu p while it slides", shear(run, 2.0), law.mu, relative=1e-3)
        normal = [run.printed.forces["HIGH_TOP"][when][2] for when in (1.0, 4.0, 5.0)]
        at_most(f"lift, {words}: force in the air over that before", normal[1] / normal[0], 1e-9)
        springs = [rows[-1][0] for (step, _, _), rows in run.iterations.items() if step == 4]
        check(f"lift, {words}: springs in the air", min(springs) == max(springs) == kept,
              f"{min(springs)} to {max(springs)}")
        at_most(f"lift, {words}: shear over normal force after the air", shear(run, 5.0), 2e-4)
        # the meshes do not match any more
        close(f"lift, {words}: normal force as before the sliding", normal[2], normal[0],
              relative=1e-2)
