#!/usr/bin/env python3
"""One run of another program: read a map, level it, find parameters, write them as JSON, in mm.

usage: test/bench/surface_peer.py surfalize|surfalize_peaks|SurfaceTopography MAP JSON
"""
# pylint: disable=import-outside-toplevel
import json
import sys

UM = 1e-3  # mm, the unit of surfalize


def surfalize(path, peaks=False):
    """Heights and gradient, by surfalize; with the peaks that Wolf pruning leaves, if asked for."""
    from surfalize import Surface
    surface = Surface.load(path).detrend_polynomial(1)
    found = {name.lower(): value for name, value in surface.height_parameters().items()}
    for name in ("sa", "sq", "sz", "sp", "sv"):
        found[name] *= UM
    found["sdq"] = surface.Sdq()
    if peaks:
        found.update(spd=surface.Spd()/UM**2, spc=surface.Spc()/UM)
    return found


def surfacetopography(path):
    """Heights, gradient and curvature of profiles along x, by SurfaceTopography."""
    from SurfaceTopography import read_topography
    read = read_topography(path)
    mm = {"m": 1e3, "mm": 1.0, "µm": 1e-3, "nm": 1e-6}[read.unit]
    level = read.detrend("height")
    return {"sq": level.Sq()*mm, "sdq": level.rms_gradient(), "m4_x": (level.Rddq()/mm)**2}


def main():
    name, path, result = sys.argv[1:]
    if name == "SurfaceTopography":
        found = surfacetopography(path)
    else:
        found = surfalize(path, peaks=name == "surfalize_peaks")
    with open(result, "w", encoding="utf-8") as file:
        json.dump({key: float(value) for key, value in found.items()}, file)


main()
