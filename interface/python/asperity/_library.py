"""The shared library of the C interface, interface/c/asperity.h: its structs and its functions."""

from __future__ import annotations

import ctypes
import sys
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Any, ClassVar

from .errors import of_code

MOST_FRICTION_POINTS = 8
MOST_STICK_ELEMENTS = 16


class ErrorStruct(ctypes.Structure):
    """asperity_error"""

    _fields_: ClassVar[Any] = [("code", c_int), ("message", c_char * 508)]


class FaceStruct(ctypes.Structure):
    """asperity_face"""

    _fields_: ClassVar[Any] = [(name, c_double) for name in (
        "sigma", "radius", "eta", "young_modulus", "poisson_ratio", "hardness")]


class PropertiesStruct(ctypes.Structure):
    """asperity_properties"""

    _fields_: ClassVar[Any] = [
        ("size", c_size_t),
        *((name, c_double) for name in (
            "eta", "modulus", "radius", "hardness", "yield_factor", "sigma",
            "friction_coefficient", "critical_slip", "initial_separation")),
        *((name, c_int) for name in (
            "friction_rule", "slip_integration", "accept_unphysical", "compiled", "unloading")),
        ("plastic_ratio", c_double),
        ("height_distribution", c_int),
        *((name, c_double) for name in (
            "skewness", "kurtosis", "static_friction_coefficient", "decay_slip", "decay_slip_rate",
            "friction_coefficient_across", "grain_angle")),
        ("slip_direction", c_int),
        *((name, c_double) for name in ("pressure_exponent", "reference_pressure", "shear_limit")),
        ("stick", c_int),
        ("stick_elements", c_int),
        ("shear_modulus", c_double),
        ("friction_points", c_int),
        ("friction_pressures", c_double * MOST_FRICTION_POINTS),
        ("friction_factors", c_double * MOST_FRICTION_POINTS)]


class StateStruct(ctypes.Structure):
    """asperity_state"""

    _fields_: ClassVar[Any] = [
        ("status", c_int),
        ("validity", c_int),
        *((name, c_double) for name in ("overclosure", "pressure", "normal_energy")),
        ("elastic_slip", c_double * 2),
        *((name, c_double) for name in (
            "largest_closure", "dissipation", "pressure_coupling", "motion_share", "grain_turn")),
        ("summit_slip", c_double * 2 * MOST_STICK_ELEMENTS)]


# Arguments of each function but the last, the error. Arrays are addresses
_HANDLE, _MADE, _ARRAY = c_void_p, POINTER(c_void_p), c_void_p
FUNCTIONS: dict[str, list[Any]] = {
    "library_version": [c_char_p, c_int],
    "validity_remark": [c_int, c_char_p, c_int],
    "properties_init": [POINTER(PropertiesStruct), c_size_t],
    "properties_from_pair": [POINTER(PropertiesStruct), c_size_t, c_char_p],
    "face_from_paper": [POINTER(FaceStruct), c_char_p, c_int],
    "properties_from_faces": [POINTER(PropertiesStruct), c_size_t, POINTER(FaceStruct),
                              POINTER(FaceStruct), c_int, c_int],
    "law_new": [_MADE, POINTER(PropertiesStruct)],
    "law_free": [_MADE],
    "law_properties": [_HANDLE, POINTER(PropertiesStruct), c_size_t],
    "law_evaluate": [_HANDLE, c_int, *[_ARRAY]*7],
    "law_evaluate_unloading": [_HANDLE, c_int, *[_ARRAY]*9],
    "law_separation": [_HANDLE, c_double, POINTER(c_double)],
    "states_new": [_MADE, c_int],
    "states_free": [_MADE],
    "states_copy": [_HANDLE, _HANDLE],
    "states_count": [_HANDLE, POINTER(c_int)],
    "states_get": [_HANDLE, c_int, c_int, _ARRAY],
    "states_set": [_HANDLE, c_int, c_int, _ARRAY],
    "states_update": [_HANDLE, _HANDLE, c_int, *[_ARRAY]*3, c_double, *[_ARRAY]*7],
}


def _load() -> dict[str, Any]:
    # of two folders where the package is installed to be edited
    paths = [Path(folder, "libasperity_c.so") for folder in sys.modules["asperity"].__path__]
    path = next(filter(Path.exists, paths), paths[0])
    try:
        library = ctypes.CDLL(str(path))
        functions = {name: getattr(library, "asperity_" + name) for name in FUNCTIONS}
    except (OSError, AttributeError) as problem:
        raise ImportError(f"{problem}: the package asperity is not whole, or the run-time library of "
                          "gfortran is not installed (on Debian, libgfortran5). Its sources have no "
                          "library: install them by pip, and import it elsewhere") from problem
    for name, arguments in FUNCTIONS.items():
        functions[name].argtypes = [*arguments, POINTER(ErrorStruct)]
        functions[name].restype = c_int
    return functions


_functions = _load()


def call(name: str, *arguments: Any) -> None:
    """Call asperity_<name>; the interpreter's lock is released meanwhile.

    Raises:
        AsperityError: what the function refuses or cannot do, in its words
    """
    error = ErrorStruct()
    if _functions[name](*arguments, byref(error)):
        raise of_code(error.code, error.message.decode())


def text(name: str, *arguments: Any) -> str:
    """The text that asperity_<name> writes."""
    buffer = ctypes.create_string_buffer(1024)
    call(name, *arguments, buffer, len(buffer))
    return buffer.value.decode()


def free(name: str, handle: c_void_p) -> None:
    """Free a handle, which is NULL then; NULL is fine."""
    call(name, byref(handle))
