#!/usr/bin/env python3
"""Are the paths and the expected values of the first run what its decks and the program say?

usage: expected.py ASPERITY [write]

The path of the faces is read from the deck. What the law answers is `asperity replay` of it with the
deck's properties; `reaction_1` to `reaction_3` follow here: the area of the face times both shear
stresses and minus the pressure. With `write` the files are written, else compared.
"""

import csv
import io
import subprocess
import sys

from deck import FOLDER, NAMES, Deck

# Of a value, and of the largest of its column
RELATIVE, ROUND_OFF = 1e-12, 1e-15
PATH_HEADINGS = ["time (s)", "overclosure (mm)", "slip_1 (mm)", "slip_2 (mm)"]
REACTION_HEADINGS = ["reaction_1 (N)", "reaction_2 (N)", "reaction_3 (N)"]


def table(headings, rows):
    """Rows as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(headings)
    writer.writerows(rows)
    return text.getvalue()


def path_text(deck):
    """The path of a deck's faces."""
    return table(PATH_HEADINGS, [[f"{value:.12g}" for value in row] for row in deck.path])


def expected_text(deck, asperity, path):
    """What the law answers along the path, and the forces of the face."""
    done = subprocess.run(
        [asperity, "replay", path, "--properties", ",".join(f"{p:.12g}" for p in deck.properties),
         "--csv", "-"], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"asperity replay {path}: {done.stderr}")
    headings, *rows = csv.reader(io.StringIO(done.stdout))
    names = [heading.split(" (")[0] for heading in headings]
    for row in rows:
        pressure, shear_1, shear_2 = (float(row[names.index(name)])
                                      for name in ("pressure", "shear_1", "shear_2"))
        row += [f"{deck.area*value:.16E}" for value in (shear_1, shear_2, -pressure)]
    return table(headings + REACTION_HEADINGS, rows)


def as_number(text):
    """A number, or nothing."""
    try:
        return float(text)
    except ValueError:
        return None


def departure(old, new):
    """The first cell in which two tables differ, or nothing."""
    old, new = (list(csv.reader(io.StringIO(text))) for text in (old, new))
    if [len(row) for row in old] != [len(row) for row in new] or old[0] != new[0]:
        return f"{len(old)} rows under {old[0]}, now {len(new)} under {new[0]}"
    for heading, *column in zip(old[0], *(zip(a, b) for a, b in zip(old[1:], new[1:]))):
        values = [(as_number(a), as_number(b)) for a, b in column]
        largest = max(abs(a or 0.0) for a, _ in values)
        for number, ((a, b), (text, now)) in enumerate(zip(values, column), 1):
            if text == now or None not in (a, b) and abs(a - b) <= max(
                    RELATIVE*max(abs(a), abs(b)), ROUND_OFF*largest):
                continue
            return f"row {number}, {heading}: {text}, now {now}"
    return ""


def main():
    """Write or compare both files of every deck."""
    asperity, *words = sys.argv[1:]
    failed = checks = 0
    for name in NAMES:
        deck, path = Deck(name), FOLDER / f"{name}_path.csv"
        for file, text in ((path, lambda: path_text(deck)),
                           (FOLDER / f"{name}_expected.csv",
                            lambda: expected_text(deck, asperity, path))):
            new = text()
            if words == ["write"]:
                file.write_text(new, encoding="ascii")
                print(f"written: {file}")
                continue
            checks += 1
            off = departure(file.read_text(encoding="ascii"), new)
            failed += bool(off)
            print(f"FAIL {file.name}: {off}; test/first_run/expected.py {asperity} write mends it"
                  if off else f"ok   {file.name} is what deck and program say")
    if words != ["write"]:
        print(f"{checks - failed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
