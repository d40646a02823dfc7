"""Contact points between the increments of a finite-element code."""

from __future__ import annotations

import ctypes
import weakref
from ctypes import byref
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum, IntFlag
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._arrays import NOT_ASKED, FloatArray, IntArray, Outputs, as_shape, count, given, number
from .errors import InputError
from .law import Law

STATE_TYPE = np.dtype(_library.StateStruct)
"""What a point remembers, as numpy has asperity_state of asperity.h: status; validity, the flags so
far; overclosure, mm; pressure, MPa; normal_energy, stored, N/mm; elastic_slip, mm; largest_closure
reached, mm; dissipation by friction and pressure_coupling since the start, N/mm; motion_share, how far
friction has gone from rest, 0, to motion, 1; grain_turn since the start, radians; summit_slip, mm. All
zero is a fresh point."""


class Status(IntEnum):
    """Contact status of a point."""

    UNSET = 0
    """Never updated."""
    OPEN = 1
    """Apart."""
    STICK = 2
    """Closed; only elastic slip at the end of the increment."""
    SLIP = 3
    """Closed and slipping at the end of the increment."""


class Validity(IntFlag):
    """Limits past which a result no longer means what the law assumes; `remark` says more."""

    AREA_ABOVE_NOMINAL = 1
    PRESSURE_ABOVE_HARDNESS = 2
    CLOSURE_ABOVE_HALF_RADIUS = 4
    STIFFER_THAN_HERTZ = 8
    ROUGHNESS_NUMBER_HIGH = 16
    ROUGHNESS_NUMBER_LOW = 32
    IMPLAUSIBLE_PROPERTY = 64
    MEMORY_BEYOND_DATA = 128

    @property
    def remark(self) -> str:
        """What the flags mean, in words; empty where none is set."""
        return _library.text("validity_remark", int(self))


@dataclass
class Response(Outputs):
    """What an increment of contact points gives; (...) is the shape of the points."""

    traction: FloatArray
    """(3, ...): pressure, positive in compression, and two shear stresses, which have the sign of
    the elastic slip, MPa."""
    tangent: FloatArray = NOT_ASKED
    """(3, 3, ...): derivative of traction[row] by overclosure (column 0) or slip (1, 2) as
    tangent[row, column], MPa/mm; unsymmetric."""
    tangential_energy: FloatArray = NOT_ASKED
    """(...): stored tangential energy per area at the end, N/mm."""
    dissipation: FloatArray = NOT_ASKED
    """(...): frictional dissipation per area of the increment, N/mm."""
    plastic_dissipation: FloatArray = NOT_ASKED
    """(...): plastic dissipation of summits per area of the increment, N/mm; 0 without memory."""
    pressure_coupling: FloatArray = NOT_ASKED
    """(...): energy per area that a change of pressure put into elastic slip, N/mm."""
    validity: IntArray = NOT_ASKED
    """(...): sum of Validity flags of the increment."""


class Contact:
    """Contact points of one law, and what they remember between increments.

    Overclosures, slips and all results have the shape of the points, after the axes of components.
    A contact belongs to one thread at a time; several may share a law. It is freed with its last
    reference, or by close(), or at the end of a `with` block.
    """

    def __init__(self, law: Law, shape: int | Sequence[int]) -> None:
        """Make fresh points.

        Args:
            law: their law
            shape: number of points, or the shape of an array of them

        Raises:
            InputError: a number of points that is not allowed
            TypeError: no Law, or a shape that is no whole number
        """
        if not isinstance(law, Law):
            raise TypeError(f"law is of the class {type(law).__name__}; it must be a Law")
        self._law = law
        self._shape = as_shape(shape)
        self._n = count(self._shape)
        self._pointer = ctypes.c_void_p()
        _library.call("states_new", byref(self._pointer), self._n)
        self.close = weakref.finalize(self, _library.free, "states_free", self._pointer)
        """Free the points now; they are refused everywhere from then on."""

    @property
    def _handle(self) -> ctypes.c_void_p:
        if not self._pointer:
            raise InputError("this contact is closed")
        return self._pointer

    def __enter__(self) -> Contact:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce__(self) -> Any:
        return _restored, (self.law, self.shape, self.states)

    def __repr__(self) -> str:
        return f"<Contact of the shape {self.shape}: {self.law}>"

    @property
    def law(self) -> Law:
        """The law."""
        return self._law

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the points."""
        return self._shape

    def update(self, overclosure: npt.ArrayLike, slip_increment: npt.ArrayLike,
               rotation: npt.ArrayLike | None = None, time_increment: float = 0.0,
               out: Response | None = None) -> Response:
        """Advance all points over one increment. On any path, work = change of (normal + tangential
        energy) + dissipation + plastic dissipation - pressure coupling.

        Args:
            overclosure: (...) at the end, mm; NO_OPPOSITE_SURFACE where there is none. Here and
                below one value stands for all points: a number, (2,) or (2, 2)
            slip_increment: (2, ...), relative tangential motion of the increment, mm
            rotation: (2, 2, ...), rotation[row, column] of the slip directions in the increment,
                w = R v; copied unless rotation.swapaxes(0, 1) is contiguous
            time_increment: s, for friction with a decay_slip_rate
            out: arrays to write to, by Response.empty()

        Returns:
            out, or new arrays of everything

        Raises:
            InputError: numbers that are not finite, arrays that do not fit; nothing has changed then
        """
        shape = self._shape
        closure = given("overclosure", overclosure, shape)
        slip = given("slip_increment", slip_increment, (2, *shape), 1)
        turn = None
        if rotation is not None:
            turn = np.asarray(rotation)
            turn = given("rotation", turn.swapaxes(0, 1) if turn.ndim > 1 else turn,
                         (2, 2, *shape), 2)
        out = Response._or_new(out, shape)
        _library.call("states_update", self._law._handle, self._handle, self._n,
                      closure.ctypes.data, slip.ctypes.data,
                      None if turn is None else turn.ctypes.data,
                      number("time_increment", time_increment),
                      *out._addresses(
                          shape, "traction", "tangent", "tangential_energy", "dissipation",
                          "plastic_dissipation", "pressure_coupling", "validity"))
        return out

    @property
    def states(self) -> npt.NDArray[np.void]:
        """What the points remember, a read-only copy of STATE_TYPE: contact.states["status"] and so
        on. To set it restarts a run, which goes on bit by bit; what no update can have left is
        refused."""
        states = np.zeros(self.shape, STATE_TYPE)
        _library.call("states_get", self._handle, 0, self._n, states.ctypes.data)
        # to write to it would change no point
        states.flags.writeable = False
        return states

    @states.setter
    def states(self, states: npt.NDArray[np.void]) -> None:
        states = np.require(states, None, ["C", "A"])
        if states.dtype != STATE_TYPE:
            raise InputError(f"states has the type {states.dtype}; it must be asperity.STATE_TYPE")
        if states.shape != self.shape:
            raise InputError(f"states has the shape {states.shape}; it must be {self.shape}")
        _library.call("states_set", self._handle, 0, self._n, states.ctypes.data)

    def copy(self) -> Contact:
        """Points of the same law and the same past."""
        other = Contact(self.law, self.shape)
        other.copy_from(self)
        return other

    def copy_from(self, other: Contact) -> None:
        """Take over the past of as many other points, as an iteration does before each trial."""
        _library.call("states_copy", other._handle, self._handle)


def _restored(law: Law, shape: tuple[int, ...], states: npt.NDArray[np.void]) -> Contact:
    contact = Contact(law, shape)
    contact.states = states
    return contact
