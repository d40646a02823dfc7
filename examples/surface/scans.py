#!/usr/bin/env python3
"""Write scan.plu, scan.gwy and scan.csv beside this file: a map by formula as a confocal microscope
saves it (PLU), as Gwyddion does (GWY), and as Keyence's program exports it, with 3 points missing.

It is no measurement: waves across a lay, whose phases follow the golden ratio, 64 x 48 points at 5 um.
"""

import math
import struct
from pathlib import Path

NX, NY, STEP = 64, 48, 5.0
MISSING = {(10, 7), (11, 7), (50, 40)}


def height(i, j):
    """Height of a point, um, as a single."""
    z = 0.0
    for k in range(1, 25):
        phase = 2*math.pi*math.modf(k*k*(1 + math.sqrt(5))/2)[0]
        across, along = 2*math.pi*(1 + k//3)/NX, 2*math.pi*(7*k % 9 - 4)/NY
        z += math.cos(across*i + along*j + phase)
    return struct.unpack("<f", struct.pack("<f", z))[0]


def plu(heights):
    """Bytes of the PLU file: lengths in um, 1000001 where a point is missing."""
    head = struct.pack("<128sI256s", b"Mon Nov 30 09:15:00 2026", 0, b"a map by formula")
    head += struct.pack("<3I7f", NY, NX, NX, 1, STEP, STEP, 0, 0, STEP, 0)
    head += struct.pack("<5I5IdfII", 3, 3, 0, 14, 3, NY, NX, NY, NX, 1, 0.1, 50, 23, 0)
    head += struct.pack("<5B3xI2I", 0, 1, 251, 5, 0, 1, NY, NX)
    values = [1000001.0 if place in MISSING else z for place, z in heights.items()]
    measured = [z for place, z in heights.items() if place not in MISSING]
    return head + struct.pack(f"<{NX*NY}f2f", *values, min(measured), max(measured))


def component(name, kind, value):
    """A component of an object of Gwyddion."""
    return name.encode() + b"\0" + kind.encode() + value


def component_object(name, kind, *inside):
    """A component that is an object."""
    return component(name, "o", kind.encode() + b"\0" + struct.pack("<I", len(b"".join(inside)))
                     + b"".join(inside))


def field(name, values, unit):
    """A field of data, in m."""
    sides = [component(side, "d", struct.pack("<d", n*STEP*1e-6))
             for side, n in (("xreal", NX), ("yreal", NY))]
    units = [component_object(axes, "GwySIUnit", component("unitstr", "s", text.encode() + b"\0"))
             for axes, text in (("si_unit_xy", "m"), ("si_unit_z", unit))]
    return component_object(
        name, "GwyDataField", component("xres", "i", struct.pack("<i", NX)),
        component("yres", "i", struct.pack("<i", NY)), *sides, *units,
        component("data", "D", struct.pack(f"<I{NX*NY}d", NX*NY, *values)))


def gwy(heights):
    """Bytes of the GWY file: the heights, and a mask over the points that are missing."""
    inside = [component("/0/data/title", "s", b"Topography\0"),
              field("/0/data", [z*1e-6 for z in heights.values()], "m"),
              field("/0/mask", [float(place in MISSING) for place in heights], "")]
    return b"GWYP" + component_object("", "GwyContainer", *inside)[2:]


def keyence(heights):
    """Text of the csv file: nothing between the quotes where a point is missing."""
    lines = [("Measured date", "2026-11-30 09:15:00"), ("Model", "VK-X3000 Series"),
             ("Data type", "ImageDataCsv"), ("File version", "1000"),
             ("Measurement data name", "a map by formula"),
             ("XY Calibration", f"{1e3*STEP:g}", "nm"), ("Output image data", "Height"),
             ("Horizontal", NX), ("Vertical", NY), ("Minimum value", f"{min(heights.values()):.3f}"),
             ("Maximum value", f"{max(heights.values()):.3f}"), ("Unit", "um"),
             ("Reference data name", ""), (), ("Height",)]
    lines += [["" if (i, j) in MISSING else f"{heights[i, j]:.3f}" for i in range(NX)]
              for j in range(NY)]
    return "".join(",".join(f'"{field}"' for field in line) + "\n" for line in lines)


def main():
    """All files."""
    heights = {(i, j): height(i, j) for j in range(NY) for i in range(NX)}
    folder = Path(__file__).resolve().parent
    (folder/"scan.plu").write_bytes(plu(heights))
    (folder/"scan.gwy").write_bytes(gwy(heights))
    (folder/"scan.csv").write_text(keyence(heights), encoding="ascii")


if __name__ == "__main__":
    main()
