"""The law that these tests compute by quadrature is the program's."""

import csv
import io
import subprocess

from harness import at_most


def law_of_program(law, asperity):
    """Pressures of `asperity curve` for the pair that the tests use."""
    printed = subprocess.run([str(asperity), "curve", "--separation", "0.06:0.24:10", "--csv", "-"],
                             stdout=subprocess.PIPE, check=True, encoding="utf-8",
                             timeout=60).stdout
    table = [line for line in printed.splitlines() if not line.startswith("#")]
    rows = [{name.split(" (")[0]: text for name, text in row.items()}
            for row in csv.DictReader(io.StringIO("\n".join(table)))]
    worst = max(abs(law.pressure(law.initial_separation - float(row["separation"]))
                    / float(row["pressure"]) - 1) for row in rows)
    at_most(f"law: {len(rows)} pressures by quadrature against `asperity curve`", worst, 1e-9)
