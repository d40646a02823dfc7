#!/usr/bin/env bash
# tamaas 2.9.0: Statistics2D.computeMoments gives the moments of an isotropic surface; with a lay they
# are those of no profile. computeRMSHeights divides by n - 1.
#
# A good guess: m4 of a single wave of 3 periods along x is 3^4/2 = 40.5 along x and 0 along y, and the
# value given is one of them or their mean. Seen: 13.5, a third; of the wave of 3 periods along both axes,
# whose m4 is 40.5 along either, 67.5. It is (m40 + 3 m22 + m04)/3, which is m40 only where m22 = m40/3.
# Wave numbers are counted in periods of the map, not in 1/length. The root mean square height of the
# wave, sqrt(1/2) = 0.707107, is 0.707193 on 64 x 64 points.
source "$(dirname "$0")/lib/setup.sh"
python_packages tamaas==2.9.0 numpy==2.4.6
expect 'm2 2.25, m4 13.5, diagonal m2 4.5, m4 67.5, rms 0.707193' "$("$python" - <<'PY'
import numpy as np
import tamaas

tamaas.set_log_level(tamaas.LogLevel.error)
turn = np.arange(64) * 2 * np.pi / 64
along = np.cos(3 * turn[:, None] + 0 * turn[None, :])
diagonal = np.cos(3 * turn[:, None] + 3 * turn[None, :])
found = tamaas.Statistics2D
_, m2, m4 = found.computeMoments(along)
_, d2, d4 = found.computeMoments(diagonal)
print(f"m2 {m2:.4g}, m4 {m4:.4g}, diagonal m2 {d2:.4g}, m4 {d4:.4g},"
      f" rms {found.computeRMSHeights(along):.6f}")
PY
)"
