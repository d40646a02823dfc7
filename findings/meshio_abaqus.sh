#!/usr/bin/env bash
# meshio 5.3.5: an ABAQUS deck that is read and written again has other elements, and no surfaces.
#
# A good guess: C3D8 (or C3D8I, with incompatible modes against locking in bending) comes back as it was,
# or is refused. Seen: both come back as C3D8RH, which is hybrid and integrated at one point, and so
# bends without stiffness in its hourglass modes. *SURFACE, which contact needs, is left out without a word.
source "$(dirname "$0")/lib/setup.sh"
python_packages meshio==5.3.5 numpy==2.4.6
deck() { # element-type
   cat <<DECK
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT, TYPE=$1, ELSET=BLOCK
1,1,2,3,4,5,6,7,8
*SURFACE, NAME=TOP, TYPE=ELEMENT
BLOCK,S2
DECK
}
deck C3D8 >one.inp
deck C3D8I >two.inp
expect 'C3D8RH C3D8RH, surfaces 0 0' "$("$python" - <<'PY'
import re
import meshio

types, surfaces = [], []
for name in ("one.inp", "two.inp"):
    meshio.write("again.inp", meshio.read(name))
    text = open("again.inp", encoding="utf-8").read()
    types += re.findall(r"TYPE=(\w+)", text)
    surfaces.append(text.upper().count("*SURFACE"))
print(*types, end="")
print(", surfaces", *surfaces)
PY
)"
