#!/usr/bin/env bash
# surfalize 0.19.2: columns x y z are read with steps of range/n, and as metres.
#
# A good guess: 6 x 4 points that are 2.5 and 2 apart are a map with steps of 2.5 and 2, in the
# numbers of the file or in a unit that can be given. Seen: steps of 2083333.3 and 1500000 um, as 12.5 is
# divided by 6 points and not by 5 steps (6 by 4 and not by 3), and all is multiplied by 1e6. Slopes of
# such a map are off by n/(n - 1) even where the file was in metres.
source "$(dirname "$0")/lib/setup.sh"
python_packages surfalize==0.19.2 numpy==2.4.6
expect 'steps 2083333.3 and 1500000.0 um, heights times 1000000' "$("$python" - <<'PY'
import numpy as np
from surfalize import Surface

x, y = np.meshgrid(np.arange(6) * 2.5, np.arange(4) * 2.0)
z = 1.0 + 0.1 * x + 0.01 * y
np.savetxt("map.xyz", np.c_[x.ravel(), y.ravel(), z.ravel()])
read = Surface.load("map.xyz")
print(f"steps {read.step_x:.1f} and {read.step_y:.1f} um,"
      f" heights times {np.mean(read.data / z):.0f}")
PY
)"
