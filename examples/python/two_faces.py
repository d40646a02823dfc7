#!/usr/bin/env python3
"""Two faces as one pair from Python: Table 2's surfaces, and a smooth plate of steel.

usage: two_faces.py [LIBRARY]

LIBRARY is as for normal_law.py, whose structs and loader this uses.
"""

import ctypes
import os
import sys
from ctypes import byref, c_char_p, c_double, c_int, c_size_t, c_void_p, sizeof

from normal_law import Properties, load

TRANSVERSE, TANGENTIAL, RADIAL = 1, 2, 3
SOFTER, HARDER = 1, 2
MOMENTS, FACE_1, FACE_2 = 1, 2, 3


class Face(ctypes.Structure):
    """asperity_face, N-mm-MPa"""

    _fields_ = [(name, c_double) for name in (
        "sigma", "radius", "eta", "young_modulus", "poisson_ratio", "hardness")]


def main():
    call = load(sys.argv[1] if len(sys.argv) > 1 else os.environ.get(
        "ASPERITY_C_LIBRARY", "libasperity_c.so"))

    def face(surface, section):
        made = Face()
        call("face_from_paper", byref(made), c_char_p(surface), c_int(section))
        return made

    def pair(one, other, hardness, roughness):
        made = Properties()
        call("properties_from_faces", byref(made), c_size_t(sizeof(made)), byref(one), byref(other),
             c_int(hardness), c_int(roughness))
        return made

    cross, tangential = face(b"unpolished-cross", TRANSVERSE), face(b"unpolished-tangential", TANGENTIAL)
    # of the radial section the paper has no hardness: as of the tangential one
    radial = Face(0.0276, 0.0696, 127.0, tangential.young_modulus, tangential.poisson_ratio,
                  tangential.hardness)
    steel = Face(young_modulus=2.0e5, poisson_ratio=0.3, hardness=2000.0)
    for name, properties in (
            ("cross on tangential", pair(cross, tangential, SOFTER, MOMENTS)),
            ("the same by Table 4's rules", pair(cross, tangential, HARDER, FACE_1)),
            ("radial on radial", pair(radial, radial, SOFTER, MOMENTS)),
            ("radial on steel", pair(radial, steel, SOFTER, FACE_1))):
        law, separation = c_void_p(), c_double()
        call("law_new", byref(law), byref(properties))
        try:
            call("law_separation", law, 1.0, byref(separation))
        finally:
            call("law_free", byref(law))
        print(f"{name}: E* {properties.modulus:.1f} MPa, H {properties.hardness} MPa, "
              f"sigma {properties.sigma:.4f} mm, closed by "
              f"{4.0 * properties.sigma - separation.value:.4f} mm at 1 MPa")


if __name__ == "__main__":
    main()
