#!/usr/bin/env bash
# Package hysteresis 2.0.5: the backbone curve runs through the tips of the loops, so the strength of a
# connection that softens within an excursion is lost.
#
# A good guess: getBackboneCurve and fitEEEP of a record with a largest force of 20 give 20. Seen: the
# backbone ends at 14, and so does the strength in the equivalent elastic-plastic curve: every excursion
# reaches its largest force at 0.6 of its amplitude and is at 0.7 of that when it turns. With
# returnPeaks=True it has the 20, and the tips between them as well, so that it goes up and down.
source "$(dirname "$0")/lib/setup.sh"
python_packages hysteresis==2.0.5 numpy==2.4.6 scipy==1.17.1
expect 'record 20, backbone 14, with peaks 0 10 7 20 14 20 14' "$(MPLBACKEND=agg "$python" - <<'PY'
import hysteresis
import numpy as np

displacement, force = [0.0], [0.0]
for amplitude in (1, 2, 4):
    for side in (1, -1):
        way = np.linspace(0, amplitude, 41)[1:]
        peak = 10 * min(amplitude, 2)
        displacement += [*(side * way), *(side * (way[::-1] - way[0]))]
        force += [*(side * np.interp(way, [0, 0.6 * amplitude, amplitude], [0, peak, 0.7 * peak])),
                  *np.zeros(40)]
record = hysteresis.Hysteresis(np.c_[displacement, force])
tips = hysteresis.getBackboneCurve(record).xy
both = hysteresis.getBackboneCurve(record, returnPeaks=True).xy
print(f"record {max(force):g}, backbone {tips[:, 1].max():g},"
      f" with peaks {' '.join(f'{f:g}' for f in both[:, 1])}")
PY
)"
