#!/usr/bin/env bash
# SurfaceTopography 1.27.1 reading a SUR file (Digital Surf) that surfalize 0.19.2 wrote: heights lose
# their offset, and the unit is not that of the file.
#
# A good guess: heights from 100 to 119 um come back as 100 to 119 um, as surfalize reads them itself.
# Seen: -9.5 to 9.5 in the unit "Âµm". The offset of the format is left out, so that heights count
# from the middle of the range, and the two bytes of the micro sign are taken for two characters.
source "$(dirname "$0")/lib/setup.sh"
python_packages surfalize==0.19.2 SurfaceTopography==1.27.1 numpy==2.4.6
expect 'surfalize: 100.0 to 119.0 um; SurfaceTopography: -9.5 to 9.5 Âµm' "$("$python" - <<'PY'
import warnings
import numpy as np
import SurfaceTopography
from surfalize import Surface

warnings.simplefilter("ignore")
Surface(100 + np.arange(20.0).reshape(4, 5), 1.0, 1.0).save("map.sur")
one = Surface.load("map.sur").data
other = SurfaceTopography.read_topography("map.sur")
heights = np.asarray(other.heights())
print(f"surfalize: {one.min():.1f} to {one.max():.1f} um;"
      f" SurfaceTopography: {heights.min():.1f} to {heights.max():.1f} {other.unit}")
PY
)"
