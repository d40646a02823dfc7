"""The normal law: pressures, stiffnesses, areas and energies at separations."""

from __future__ import annotations

import ctypes
import weakref
from ctypes import byref
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._arrays import NOT_ASKED, FloatArray, IntArray, Outputs, count, given
from .errors import InputError
from .properties import Properties


@dataclass
class LawValues(Outputs):
    """The normal law at a number of points; each array has the shape of the separations."""

    pressure: FloatArray
    """Pressure, MPa."""
    stiffness: FloatArray
    """Stiffness -dp/dd, MPa/mm; with memory, at fixed memory."""
    area_fraction: FloatArray = NOT_ASKED
    """Real area over nominal area, without unit."""
    contact_density: FloatArray = NOT_ASKED
    """Summits in contact per area, 1/mm2."""
    energy: FloatArray = NOT_ASKED
    """Energy per area that is stored, N/mm. By Law.evaluate() of a law with memory: the work since
    first touch."""
    validity: IntArray = NOT_ASKED
    """Sum of Validity flags."""


@dataclass
class UnloadingValues(LawValues):
    """The law with memory at a number of points."""

    plastic_dissipation: FloatArray = NOT_ASKED
    """Plastic dissipation per area since first touch, N/mm."""


class Law:
    """Normal law, friction and the datum of the overclosure of one pair of faces.

    It never changes, so any number of threads may use one, and a copy is the law itself. It is freed
    with its last reference, or by close(), or at the end of a `with` block.
    """

    def __init__(self, properties: Properties) -> None:
        """Make the law.

        Raises:
            InputError: a property that is not allowed, by its name
            TypeError: no Properties
        """
        if not isinstance(properties, Properties):
            raise TypeError(f"properties is of the class {type(properties).__name__}; it must be "
                            "Properties, such as Properties.from_pair() makes")
        self._pointer = ctypes.c_void_p()
        self._given = properties
        _library.call("law_new", byref(self._pointer), byref(properties.as_struct()))
        self.close = weakref.finalize(self, _library.free, "law_free", self._pointer)
        """Free the law now; it is refused everywhere from then on."""

    @property
    def _handle(self) -> ctypes.c_void_p:
        if not self._pointer:
            raise InputError("this law is closed")
        return self._pointer

    def __enter__(self) -> Law:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce__(self) -> Any:
        return Law, (self._given,)

    def __copy__(self) -> Law:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Law:
        return self

    def __repr__(self) -> str:
        return f"Law({self._given!r})"

    @property
    def properties(self) -> Properties:
        """What the law is made of, its initial separation as a number."""
        return Properties.of_law(self._handle)

    def evaluate(self, separation: npt.ArrayLike, out: LawValues | None = None) -> LawValues:
        """The law at separations, each as if the face had never been closer.

        Args:
            separation: mm, of any shape; not copied where it is contiguous float64
            out: arrays of that shape to write to, by LawValues.empty(); a compiled law is fast
                where no more than pressure and stiffness is asked for

        Returns:
            out, or new arrays of everything

        Raises:
            InputError: a separation that is not finite, or arrays that do not fit
        """
        d = given("separation", separation)
        out = LawValues._or_new(out, d.shape)
        _library.call("law_evaluate", self._handle, count(d.shape), d.ctypes.data,
                      *out._addresses(d.shape, "pressure", "stiffness", "area_fraction",
                                     "contact_density", "energy", "validity"))
        return out

    def evaluate_unloading(self, closest_separation: npt.ArrayLike, retraction: npt.ArrayLike,
                           out: UnloadingValues | None = None) -> UnloadingValues:
        """The law of unloading="elastic" away from the closest separations so far.

        Args:
            closest_separation: mm, of any shape
            retraction: separation less the closest one, mm, of the same shape or one that numpy
                broadcasts to it, or it to that; with zero or less the face is as close as never
                before
            out: arrays of that shape to write to, by UnloadingValues.empty()

        Returns:
            out, or new arrays of everything

        Raises:
            InputError: a law without memory, numbers that are not finite, arrays that do not fit
        """
        d = given("closest_separation", closest_separation)
        r = given("retraction", retraction)
        if d.shape != r.shape:
            try:
                d, r = map(np.ascontiguousarray, np.broadcast_arrays(d, r))
            except ValueError as problem:
                raise InputError(f"retraction has the shape {r.shape}; closest_separation has "
                                 f"{d.shape}") from problem
        out = UnloadingValues._or_new(out, d.shape)
        _library.call("law_evaluate_unloading", self._handle, count(d.shape), d.ctypes.data,
                      r.ctypes.data, *out._addresses(
                          d.shape, "pressure", "stiffness", "area_fraction", "contact_density",
                          "energy", "plastic_dissipation", "validity"))
        return out

    def pressure(self, separation: npt.ArrayLike) -> FloatArray:
        """Pressures alone, MPa, at separations, mm, of any shape; see evaluate()."""
        d = given("separation", separation)
        return self.evaluate(d, LawValues.empty(d.shape, "pressure")).pressure

    def separation(self, pressure: npt.ArrayLike) -> FloatArray:
        """Separations at which the law gives pressures, when the face was never closer.

        Args:
            pressure: MPa, above zero, of any shape

        Returns:
            separations, mm, of that shape

        Raises:
            InputError: a pressure that the law does not reach
        """
        p = given("pressure", pressure)
        out = np.empty(p.shape)
        found = ctypes.c_double()
        for place, value in np.ndenumerate(p):
            _library.call("law_separation", self._handle, value, byref(found))
            out[place] = found.value
        return out
