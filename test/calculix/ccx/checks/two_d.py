"""Plane strain, plane stress and axisymmetric elements, which CalculiX makes solid elements of: force
and areas against their closed values."""

import csv
import math

from blocks import Interaction, fields
from harness import Run, check, close

# One block on a larger one, from LEFT to RIGHT; thickness of the plane ones, mm
LEFT, RIGHT, THICK = 5.0, 15.0, 4.0
DOWN, ALONG = 0.12, 0.6
# What CalculiX makes of an axisymmetric model
WEDGE = math.radians(2.0)


def deck_of(element, interaction):
    """The face moves as a whole: pressed, then slid where the model can slide."""
    axisymmetric = element.startswith("CAX")
    lines = ["*NODE", *[f"{number}, {x}, {y}" for number, x, y in (
        (1, 0, -5), (2, 10, -5), (3, 20, -5), (4, 0, 0), (5, 10, 0), (6, 20, 0))]]
    middle = 0.5*(LEFT + RIGHT)
    lines += [f"{number}, {fields((x, y))}" for number, x, y in (
        (11, LEFT, 0), (12, middle, 0), (13, RIGHT, 0), (14, LEFT, 5), (15, middle, 5),
        (16, RIGHT, 5))]
    lines += [f"*ELEMENT, TYPE={element}, ELSET=ALL", "1, 1, 2, 5, 4", "2, 2, 3, 6, 5",
              "11, 11, 12, 15, 14", "12, 12, 13, 16, 15",
              "*NSET, NSET=FACE", "11, 12, 13", "*NSET, NSET=BASE", "4, 5, 6",
              "*SURFACE, NAME=UPPER", "11, S1", "12, S1", "*SURFACE, NAME=LOWER", "1, S3", "2, S3",
              "*MATERIAL, NAME=BLOCK", "*ELASTIC", "1000., 0.",
              "*SOLID SECTION, ELSET=ALL, MATERIAL=BLOCK", *([] if axisymmetric else [f"{THICK}"]),
              "*SURFACE INTERACTION, NAME=WOOD", *interaction.lines,
              "*CONTACT PAIR, INTERACTION=WOOD, TYPE=NODE TO SURFACE", "UPPER, LOWER",
              "*BOUNDARY", "BASE, 1, 2"]
    for along in (0.0,) if axisymmetric else (0.0, ALONG):
        lines += ["*STEP, NLGEOM, INC=100", "*STATIC, DIRECT", "0.1, 1.", "*BOUNDARY",
                  f"FACE, 1, 1, {along}", f"FACE, 2, 2, {-DOWN}",
                  "*NODE PRINT, NSET=FACE, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(lines) + "\n"


def two_dimensions(law, uinter, events, folder):
    """Force over the area is the law's pressure and mu p; the areas that UINTER gets are the face."""
    pressure = law.pressure(DOWN)
    # a wedge has flat faces
    for element, area in (("CPE4", (RIGHT - LEFT)*THICK), ("CPS4", (RIGHT - LEFT)*THICK),
                          ("CAX4", 0.5*math.sin(WEDGE)*(RIGHT**2 - LEFT**2))):
        interaction = Interaction.uinter("WOOD", law.props())
        run = Run(uinter, folder, f"plane-{element}", deck_of(element, interaction))
        forces = run.printed.forces["FACE"]
        close(f"{element}: force over area at the overclosure, MPa", -forces[1.0][1]/area, pressure,
              relative=1e-6)
        if element != "CAX4":
            close(f"{element}: shear force over area in slip, MPa", forces[2.0][0]/area,
                  law.mu*pressure, relative=1e-6)
        interaction = Interaction.uinter("WOOD", [1000.0, 99.0, 0.0], depvar=3)
        run = Run(events, folder, f"areas-{element}", deck_of(element, interaction),
                  {"ASPERITY_CALCULIX_STATES": "1"})
        with open(run.file("states.csv"), encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
        last = [row for row in rows if row["time"] == rows[-1]["time"]]
        check(f"{element}: two points a node", len(last) == 6, f"{len(last)}")
        close(f"{element}: sum of AREA, mm2", sum(float(row["statev_3"]) for row in last), area,
              relative=1e-6)
