"""The first run in ABAQUS, turned into CalculiX' words: `asperity compare` passes with the values that
a user of ABAQUS is to expect, and says so when a property is another."""

import subprocess
import sys
from pathlib import Path

from harness import Run, check

sys.path.append(str(Path(__file__).resolve().parents[3] / "first_run"))
from deck import FOLDER, NAMES, Deck  # noqa: E402

# CalculiX prints seven figures, of which the last is rounded; the motion of the faces is exact
TOLERANCE = 1e-6


def compared(asperity, name, run):
    """`asperity compare` of a run's printed forces with the expected values."""
    return subprocess.run([str(asperity), "compare", FOLDER / f"{name}_expected.csv",
                           run.file("dat"), "--tolerance", f"{TOLERANCE:g}"],
                          capture_output=True, text=True, check=False)


def first_run(uinter, asperity, folder):
    """Both decks as they are, then one with a friction coefficient that is 1 % larger."""
    for name in NAMES:
        deck = Deck(name)
        run = Run(uinter, folder, f"first-{name}", deck.calculix())
        said = compared(asperity, name, run)
        passed = said.returncode == 0 and f"pass: 3 columns at {len(deck.path)} times" in said.stdout
        check(f"first run, {name}: forces of {len(deck.path)} increments within {TOLERANCE:g}",
              run.status == 0 and passed, "" if passed else said.stdout + said.stderr)
        mu, *others = deck.properties
        said = compared(asperity, name, Run(uinter, folder, f"first-{name}-mu",
                                            deck.calculix([1.01 * mu, *others])))
        columns = "reaction_1" + (", reaction_2" if name == "two_blocks" else "")
        departs = said.returncode == 1 and said.stderr.strip().endswith(f"in {columns}")
        check(f"first run, {name}: another friction coefficient departs in shear alone", departs,
              "" if departs else said.stdout + said.stderr)
