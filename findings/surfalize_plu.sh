#!/usr/bin/env bash
# surfalize 0.19.2 reading PLU, the format of Sensofar's and Leica's confocal microscopes: all heights are
# two points late, and two that are none come first.
#
# A good guess: 6 x 4 points with the heights 0, 1, 2 ... um come back so, as SurfaceTopography 1.27.1 and
# Gwyddion read them. Seen: the sizes of the layer, which stand before its heights, are taken for the
# first two of them, so that every line begins with the end of the one before, and the last two are lost.
# On a real scan, levelled, Sq is 0.55 for 0.018 um.
source "$(dirname "$0")/lib/setup.sh"
python_packages surfalize==0.19.2 SurfaceTopography==1.27.1 numpy==2.4.6
expect 'SurfaceTopography: 0 1 2 3 4 5 / 6 7 ...; surfalize: 0 0 0 1 2 3 / 4 5 ...' "$("$python" - <<'PY'
import struct
import warnings

import numpy as np
import SurfaceTopography
from surfalize import Surface

warnings.simplefilter("ignore")
ny, nx = 4, 6
with open("map.plu", "wb") as file:
    # date and comment; points and steps; a topography and its settings; a layer, and no image
    file.write(struct.pack("<128sI256s", b"Mon Nov 30 09:15:00 2026", 0, b""))
    file.write(struct.pack("<3I7f", ny, nx, nx, 1, 2.5, 2.0, 0, 0, 2.5, 0))
    file.write(struct.pack("<5I5IdfII", 3, 3, 0, 14, 3, ny, nx, ny, nx, 1, 0.1, 50, 23, 0))
    file.write(struct.pack("<5B3xI", 0, 1, 251, 6, 0, 1))
    file.write(struct.pack("<2I", ny, nx) + np.arange(24, dtype="<f4").tobytes())
    file.write(struct.pack("<2f", 0, 23))


def beginning(z):
    """The first line and the begin of the second."""
    words = [f"{value:.0f}" for value in z.ravel()]
    return f"{' '.join(words[:6])} / {' '.join(words[6:8])} ..."


other = np.asarray(SurfaceTopography.read_topography("map.plu").heights()).T
print(f"SurfaceTopography: {beginning(other)}; surfalize: {beginning(Surface.load('map.plu').data)}")
PY
)"
