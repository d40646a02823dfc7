#!/usr/bin/env bash
# surfalize 0.19.2: a map of singles that is saved as SUR has its highest point as its lowest.
#
# A good guess: heights of 0 to 11 um come back as such, as from a map of doubles. Seen: the point of
# 11 um is at 0 um: as a single the largest whole number of the file, 2147483646, is rounded to
# 2147483648, which wraps to the least one. Maps that surfalize itself reads from files of singles
# become such.
source "$(dirname "$0")/lib/setup.sh"
python_packages surfalize==0.19.2 numpy==2.4.6
expect 'the point of 11 um: doubles 11.0, singles 0.0' "$("$python" - 2>/dev/null <<'PY'
import numpy as np
from surfalize import Surface

heights = np.arange(12.0).reshape(3, 4)
found = []
for kind in ("f8", "f4"):
    Surface(heights.astype(kind), 1.0, 1.0).save("map.sur")
    found.append(float(Surface.load("map.sur").data[2, 3]))
print(f"the point of 11 um: doubles {found[0]:.1f}, singles {found[1]:.1f}")
PY
)"
