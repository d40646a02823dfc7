#!/usr/bin/env bash
# ContactMechanics 1.8.3: the integral over summit heights of its Greenwood-Tripp solution, Fn(h, n), is lost
# where the faces overlap deeply, and good to 6 digits only where they are far apart. No warning is given.
#
# A good guess: Fn(h, 0) is the share of summits above h, so 1 far below their mean plane, and Fn(h, 1) is
# -h there; and a reference solution has ten digits. Seen: at h = -30 they are 1 and 30, at h = -22 the share
# is 3e-9, and at h = -40 both are below 1e-20: adaptive quadrature over a half-infinite range may not meet
# the bell. At h = 5, n = 3/2 the exact value is 3.033851e-8 and 3.033844e-8 is found, as the quadrature
# stops at an absolute error.
source "$(dirname "$0")/lib/setup.sh"
python_packages ContactMechanics==1.8.3 scipy==1.17.1 numpy==2.4.6
expect 'h -30: 1, 30; h -22: 3e-09; h -40 lost: True, True; h 5: 3.033844e-08; warnings 0' "$("$python" - <<'PY'
import warnings
from ContactMechanics.ReferenceSolutions.GreenwoodTripp import Fn

with warnings.catch_warnings(record=True) as seen:
    warnings.simplefilter("always")
    near, far = [Fn(-30, n) for n in (0, 1)], [Fn(-40, n) for n in (0, 1)]
    share, apart = Fn(-22, 0), Fn(5, 1.5)
print(f"h -30: {near[0]:.6g}, {near[1]:.6g}; h -22: {share:.0e}; h -40 lost: {far[0] < 1e-20}, {far[1] < 1e-20};"
      f" h 5: {apart:.6e}; warnings {len(seen)}")
PY
)"
