#!/usr/bin/env bash
# FElupe 11.3.0: newtonraphson measures a residual by 1e-3 plus the forces at the supports, in whatever units
# the model has.
#
# A good guess: in m and GN a stretched cube converges as it does in other units, as all forces are 1e-9
# times as large. Seen: 4 iterations with a shear modulus of 1, and 2 with 1e-9, called a success with
# forces left inside that are 2 % of those at the supports. The text of newtonraphson has "a small number",
# the 1e-3 stands in the code of `check`. N and mm help, or a `check` of one's own.
source "$(dirname "$0")/lib/setup.sh"
python_packages felupe==11.3.0 numpy==2.4.6
expect 'modulus 1: success True, iterations 4, left inside 5e-09
modulus 1e-09: success True, iterations 2, left inside 2e-02' "$("$python" - <<'PY'
import felupe
import numpy as np

for modulus in (1.0, 1e-9):
    region = felupe.RegionHexahedron(felupe.Cube(n=6))
    field = felupe.FieldContainer([felupe.Field(region, dim=3)])
    load = felupe.dof.uniaxial(field, clamped=True, move=0.5, return_loadcase=True)[1]
    solid = felupe.SolidBody(felupe.NeoHooke(mu=modulus, bulk=2*modulus), field)
    found = felupe.newtonraphson(items=[solid], verbose=0, **load)
    inside, support = (np.linalg.norm(found.fun[load[dof]]) for dof in ("dof1", "dof0"))
    print(f"modulus {modulus:g}: success {found.success}, iterations {found.iterations},"
          f" left inside {inside/support:.0e}")
PY
)"
