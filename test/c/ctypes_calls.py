#!/usr/bin/env python3
"""Calls of the C interface from Python, by ctypes and nothing else: to be run under valgrind.

usage: ctypes_calls.py LIBRARY

LIBRARY is the file libasperity_c.so.
"""

import ctypes
import sys
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p, sizeof

doubles, ints = POINTER(c_double), POINTER(c_int)


class Error(ctypes.Structure):
    """asperity_error"""

    _fields_ = [("code", c_int), ("message", c_char * 508)]


class Properties(ctypes.Structure):
    """asperity_properties, N-mm-MPa"""

    _fields_ = (
        [("size", c_size_t)]
        + [(name, c_double) for name in (
            "eta", "modulus", "radius", "hardness", "yield_factor", "sigma",
            "friction_coefficient", "critical_slip", "initial_separation")]
        + [(name, c_int) for name in (
            "friction_rule", "slip_integration", "accept_unphysical", "compiled",
            "unloading")]
        + [("plastic_ratio", c_double), ("height_distribution", c_int), ("skewness", c_double),
           ("kurtosis", c_double), ("static_friction_coefficient", c_double),
           ("decay_slip", c_double), ("decay_slip_rate", c_double),
           ("friction_coefficient_across", c_double), ("grain_angle", c_double),
           ("slip_direction", c_int), ("pressure_exponent", c_double),
           ("reference_pressure", c_double), ("shear_limit", c_double), ("stick", c_int),
           ("stick_elements", c_int), ("shear_modulus", c_double), ("friction_points", c_int),
           ("friction_pressures", c_double * 8), ("friction_factors", c_double * 8)])


class AsperityError(Exception):
    """What the library refused."""


def load(file):
    """The library, each of its functions with argument types and raising AsperityError."""
    library = ctypes.CDLL(file)
    pointer = POINTER(c_void_p)
    for name, *arguments in (
            ("library_version", c_char * 16, c_int),
            ("properties_from_pair", POINTER(Properties), c_size_t, c_char_p),
            ("law_new", pointer, POINTER(Properties)),
            ("law_free", pointer),
            ("law_evaluate", c_void_p, c_int, *[doubles] * 6, ints),
            ("law_separation", c_void_p, c_double, doubles),
            ("states_new", pointer, c_int),
            ("states_free", pointer),
            ("states_update", c_void_p, c_void_p, c_int, *[doubles] * 3, c_double, *[doubles] * 6,
             ints)):
        function = getattr(library, "asperity_" + name)
        function.argtypes = [*arguments, POINTER(Error)]
        function.restype = c_int

    def call(name, *arguments):
        error = Error()
        if getattr(library, "asperity_" + name)(*arguments, byref(error)):
            raise AsperityError(f"{error.code}: {error.message.decode()}")
    return call


def array(values):
    """A C array of doubles."""
    return (c_double * len(values))(*values)


def main():
    call = load(sys.argv[1])
    version = (c_char * 16)()
    call("library_version", version, len(version))
    print("asperity", version.value.decode())

    pair, law, states = Properties(), c_void_p(), c_void_p()
    call("properties_from_pair", byref(pair), sizeof(pair), b"transverse-tangential")
    pair.compiled = 1
    call("law_new", byref(law), byref(pair))
    try:
        # the normal law at many separations in one call
        n = 9
        d = array([0.5 * pair.sigma * i for i in range(n)])
        p, s, area = array([0.0] * n), array([0.0] * n), array([0.0] * n)
        call("law_evaluate", law, n, d, p, s, area, None, None, None)
        for i in range(n):
            print(f"{d[i]:.4f} mm: {p[i]:9.5f} MPa {s[i]:9.4f} MPa/mm, real area {area[i]:.5f}")

        # one point pressed to 0.2 MPa and slid back and forth
        call("states_new", byref(states), 1)
        separation, traction = c_double(), array([0.0] * 3)
        call("law_separation", law, 0.2, byref(separation))
        closure = array([4.0 * pair.sigma - separation.value])
        for step in 0.4, -0.4, -0.4, 0.4:
            call("states_update", law, states, 1, closure, array([step, 0.0]), None, 0.0, traction,
                 None, None, None, None, None, None)
            print(f"slip {step:+.1f} mm: shear stress {traction[1]:+.4f} MPa")

        # what is refused raises
        try:
            call("law_evaluate", law, n, d, p, None, None, None, None, None)
        except AsperityError as error:
            print("refused,", error)
    finally:
        call("states_free", byref(states))
        call("law_free", byref(law))


if __name__ == "__main__":
    main()
