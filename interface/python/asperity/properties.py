"""The properties of a pair of faces, from which laws are made."""

from __future__ import annotations

import ctypes
from ctypes import byref
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import Any, Literal

import numpy as np

from . import _library
from ._arrays import given, number, whole
from .errors import InputError
from .faces import HARDNESS_RULES, ROUGHNESS_RULES, Face, code_of

# The words of case files, and the library's numbers
WORDS = {
    "friction_rule": {"abaqus": 1, "dissipative": 2},
    "slip_integration": {"exact": 1, "backward_euler": 2},
    "unloading": {"reversible": 0, "elastic": 1},
    "height_distribution": {"gaussian": 0, "johnson": 1},
    "slip_direction": {"associated": 0, "stress": 1},
    "stick": {"critical_slip": 0, "summits": 1},
}
_SWITCHES = ("accept_unphysical", "compiled")
_POINTS = ("friction_pressures", "friction_factors")


def _as_dict(struct: _library.PropertiesStruct) -> dict[str, Any]:
    """The values of a struct, as Properties has them."""
    values: dict[str, Any] = {}
    for name, _ in struct._fields_:
        value = getattr(struct, name)
        if name in WORDS:
            value = next(word for word, code in WORDS[name].items() if code == value)
        elif name in _SWITCHES:
            value = bool(value)
        elif name in _POINTS:
            value = tuple(value[:struct.friction_points])
        if name not in ("size", "friction_points"):
            values[name] = value
    return values


def _filled(function: str, *arguments: Any) -> dict[str, Any]:
    """The values of the struct that asperity_properties_<function> fills."""
    struct = _library.PropertiesStruct()
    _library.call("properties_" + function, byref(struct), ctypes.sizeof(struct), *arguments)
    return _as_dict(struct)


# Where not given: the library's own
_DEFAULT = _filled("init")


@dataclass(frozen=True, kw_only=True, repr=False)
class Properties:
    """Properties of a pair of faces, in N, mm and MPa, with the names of case files.

    They never change; dataclasses.replace(properties, ...) makes others. What is no number is
    refused here, a number or a word that is not allowed when a law is made of them.
    """

    eta: float
    """Asperity density, summits per nominal area, 1/mm2."""
    modulus: float
    """Equivalent modulus E*, MPa."""
    radius: float
    """Summit radius R, mm."""
    hardness: float
    """Hardness H of the softer face, MPa."""
    yield_factor: float
    """Mean contact pressure factor k, 0.05 to 1."""
    sigma: float
    """Standard deviation of summit heights, mm."""
    friction_coefficient: float
    """Coulomb friction coefficient mu, 0 to 1000; in motion and along the grain."""
    critical_slip: float
    """Critical elastic slip gcrit, mm."""
    initial_separation: float = _DEFAULT["initial_separation"]
    """Separation at zero overclosure d0, mm: separation = d0 - overclosure. FOUR_SIGMA, unless
    given, stands for 4 sigma."""
    friction_rule: Literal["abaqus", "dissipative"] = _DEFAULT["friction_rule"]
    """When the pressure changes: "abaqus", the elastic slip stays; "dissipative", pressure rising
    keeps the shear stress and falling the elastic slip, which creates no energy."""
    slip_integration: Literal["exact", "backward_euler"] = _DEFAULT["slip_integration"]
    """"exact" on a straight path, or "backward_euler" (radial return)."""
    accept_unphysical: bool = _DEFAULT["accept_unphysical"]
    """Let properties that no face or solid has pass, and flag results."""
    compiled: bool = _DEFAULT["compiled"]
    """Compile the normal law to polynomials, for many evaluations."""
    unloading: Literal["reversible", "elastic"] = _DEFAULT["unloading"]
    """"reversible", as loading; "elastic", yielded summits stay flat: the law has memory."""
    plastic_ratio: float = _DEFAULT["plastic_ratio"]
    """Plastic ratio w2/w1, 10 to 1000."""
    height_distribution: Literal["gaussian", "johnson"] = _DEFAULT["height_distribution"]
    """How summit heights are distributed."""
    skewness: float = _DEFAULT["skewness"]
    """Skewness of Johnson's heights."""
    kurtosis: float = _DEFAULT["kurtosis"]
    """Kurtosis of Johnson's heights."""
    static_friction_coefficient: float = _DEFAULT["static_friction_coefficient"]
    """Friction coefficient at rest; 0 stands for friction_coefficient."""
    decay_slip: float = _DEFAULT["decay_slip"]
    """Slip over which the excess at rest falls to 1/e, mm; 0, not by slip."""
    decay_slip_rate: float = _DEFAULT["decay_slip_rate"]
    """Slip rate at which it is down to 1/e, mm/s; 0, not by rate."""
    friction_coefficient_across: float = _DEFAULT["friction_coefficient_across"]
    """Friction coefficient across the grain; 0 stands for friction_coefficient."""
    grain_angle: float = _DEFAULT["grain_angle"]
    """Angle from the first slip direction to the grain at the start, degrees."""
    slip_direction: Literal["associated", "stress"] = _DEFAULT["slip_direction"]
    """Slip normal to the ellipse of shear stresses, or along the shear stress."""
    pressure_exponent: float = _DEFAULT["pressure_exponent"]
    """All coefficients times (p/reference_pressure)**pressure_exponent."""
    reference_pressure: float = _DEFAULT["reference_pressure"]
    """Pressure at which the coefficients hold, MPa."""
    shear_limit: float = _DEFAULT["shear_limit"]
    """Largest shear stress at rest along the grain, MPa; 0, none."""
    stick: Literal["critical_slip", "summits"] = _DEFAULT["stick"]
    """What sticks before it slides: the point, or each summit as Mindlin's theory has it."""
    stick_elements: int = _DEFAULT["stick_elements"]
    """Elements that stand for the summits, 4 to 16; 0 stands for 8."""
    shear_modulus: float = _DEFAULT["shear_modulus"]
    """Equivalent shear modulus G*, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2, MPa."""
    friction_pressures: tuple[float, ...] = _DEFAULT["friction_pressures"]
    """Up to 8 pressures, MPa, rising, at which friction_factors stand."""
    friction_factors: tuple[float, ...] = _DEFAULT["friction_factors"]
    """Factors on all coefficients there; straight in between, constant outside."""

    def __post_init__(self) -> None:
        """Numbers of numpy and lists become Python's own, so that properties compare and hash."""
        for name, kind in _library.PropertiesStruct._fields_:
            if name in ("size", "friction_points") or name in WORDS:
                continue
            value = getattr(self, name)
            if name in _POINTS:
                value = tuple(given(name, value, (np.size(value),)).tolist())
            elif name in _SWITCHES:
                if not isinstance(value, (bool, int, np.bool_)) or value not in (0, 1):
                    raise InputError(f"{name} = {value!r} is not allowed: it must be True or False")
                value = bool(value)
            else:
                value = (number if kind is ctypes.c_double else whole)(name, value)
            object.__setattr__(self, name, value)

    def __reduce__(self) -> Any:
        """By names, so that another version refuses a property that it does not know."""
        return partial(Properties, **{field.name: getattr(self, field.name)
                                      for field in fields(self)}), ()

    def __repr__(self) -> str:
        """What differs from its default."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return "Properties(%s)" % ", ".join(f"{name}={value!r}" for name, value in values.items()
                                            if value != _DEFAULT[name])

    @classmethod
    def from_pair(cls, pair: str, **changes: Any) -> Properties:
        """The properties of a pair of the paper.

        Args:
            pair: "transverse-tangential" or "tangential-tangential"
            **changes: properties that differ

        Raises:
            InputError: there is no such pair
        """
        return replace(cls(**_filled("from_pair", pair.encode())), **changes)

    @classmethod
    def from_faces(cls, face_1: Face, face_2: Face, *,
                   hardness_rule: Literal["softer", "harder"] = "softer",
                   roughness_rule: Literal["moments", "face_1", "face_2"] = "moments",
                   **changes: Any) -> Properties:
        """The pair that two faces make: E* by Eq. 4 of the paper, hardness and summits by rules.
        Yield factor, friction and critical slip are those of the paper's pairs.

        Args:
            face_1, face_2: the faces
            hardness_rule: whose hardness the pair takes
            roughness_rule: whose summits: of the sum of both faces, whose spectral moments add, or
                of one, the other being smooth
            **changes: properties that differ

        Raises:
            InputError: a face or a rule that is not allowed
        """
        return replace(cls(**_filled(
            "from_faces", byref(face_1.as_struct()), byref(face_2.as_struct()),
            code_of("hardness_rule", hardness_rule, HARDNESS_RULES),
            code_of("roughness_rule", roughness_rule, ROUGHNESS_RULES))), **changes)

    @classmethod
    def of_law(cls, law: ctypes.c_void_p) -> Properties:
        """The properties of a law, by its handle."""
        struct = _library.PropertiesStruct()
        _library.call("law_properties", law, byref(struct), ctypes.sizeof(struct))
        return cls(**_as_dict(struct))

    def as_struct(self) -> _library.PropertiesStruct:
        """As the library takes them.

        Raises:
            InputError: an unknown word, or too many or unequal points of friction
        """
        struct = _library.PropertiesStruct(size=ctypes.sizeof(_library.PropertiesStruct))
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name in WORDS:
                value = code_of(field.name, value, WORDS[field.name])
            elif field.name in _POINTS:
                if not len(self.friction_pressures) == len(self.friction_factors) \
                        <= _library.MOST_FRICTION_POINTS:
                    raise InputError(
                        f"{len(self.friction_pressures)} friction_pressures and "
                        f"{len(self.friction_factors)} friction_factors are not allowed: there must "
                        f"be as many of both, up to {_library.MOST_FRICTION_POINTS}")
                getattr(struct, field.name)[:len(value)] = value
                continue
            setattr(struct, field.name, value)
        struct.friction_points = len(self.friction_pressures)
        return struct
