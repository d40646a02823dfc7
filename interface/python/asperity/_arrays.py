"""Between numpy's arrays and the addresses that the library takes."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from dataclasses import MISSING, fields
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from .errors import InputError

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.intc]

# Lengths are C's int
_MOST_POINTS = 2**31 - 1
_REAL = np.dtype(np.float64)
# A field that was not asked for
NOT_ASKED: Any = None


def as_shape(shape: int | Sequence[int]) -> tuple[int, ...]:
    """The shape of a number of points.

    Raises:
        InputError: a length below zero
    """
    lengths = tuple(map(operator.index, shape)) if isinstance(shape, Sequence) \
        else (operator.index(shape),)
    if any(length < 0 for length in lengths):
        raise InputError(f"shape = {shape} is not allowed: numbers of points are zero or more")
    return lengths


def count(shape: tuple[int, ...]) -> int:
    """Number of points of a shape."""
    points = math.prod(shape)
    if points > _MOST_POINTS:
        raise InputError(f"{points} points are too many for one call: at most {_MOST_POINTS}")
    return points


def given(name: str, values: npt.ArrayLike, shape: tuple[int, ...] | None = None,
          components: int = 0) -> FloatArray:
    """An input as the library reads it: the array itself where it is contiguous float64.

    Args:
        name: for messages
        values: the input
        shape: what it must have. After the axes of components one value stands for all points, and
            so does a length of 1 for a longer axis
        components: number of axes of components, which come first

    Raises:
        InputError: no real numbers, or another shape
    """
    try:
        array = np.asarray(values)
    except ValueError as problem:
        raise InputError(f"{name} is no array: {problem}") from problem
    if array.dtype != _REAL and not np.can_cast(array.dtype, _REAL, "same_kind"):
        raise InputError(f"{name} has the type {array.dtype}; it must be real numbers")
    if shape is not None and array.shape != shape:
        wanted = shape[components:]
        points = array.shape[components:] or (1,)*len(wanted)
        if array.shape[:components] != shape[:components] or len(points) != len(wanted) or any(
                length not in (1, most) for length, most in zip(points, wanted, strict=True)):
            raise InputError(f"{name} has the shape {array.shape}; it must be {shape}")
        array = np.broadcast_to(array.reshape(shape[:components] + points), shape)
    return np.require(array, np.float64, ["C", "A"])


def number(name: str, value: Any) -> float:
    """One real number.

    Raises:
        InputError: it is none
    """
    if not isinstance(value, float):
        array = np.asarray(value)
        if array.ndim > 0 or not np.can_cast(array.dtype, np.float64, "same_kind"):
            raise InputError(f"{name} = {value!r} is not allowed: it must be a number")
    return float(value)


def whole(name: str, value: Any) -> int:
    """One whole number that C's int holds.

    Raises:
        InputError: it is none
    """
    try:
        found = operator.index(value)
    except TypeError:
        found = 2**31
    if not -2**31 <= found < 2**31:
        raise InputError(f"{name} = {value!r} is not allowed: it must be a whole number below 2**31")
    return found


# Axes of components that come before those of the points, and what is not a real number
_AXES = {"traction": (3,), "tangent": (3, 3)}
_KINDS: dict[str, npt.DTypeLike] = {"validity": np.intc}


class Outputs:
    """Arrays that the library writes to: a dataclass whose fields without default it always writes,
    and those with None only where there is an array."""

    @classmethod
    def empty(cls: type[Made], shape: int | Sequence[int], *names: str) -> Made:
        """Arrays for `out=`, of points of a shape.

        Args:
            shape: of the points
            *names: what is asked for besides what is always given; without names, everything

        Raises:
            InputError: a name that is none of them, or a length below zero
        """
        shape = as_shape(shape)
        known = fields(cls)  # type: ignore[arg-type]
        unknown = set(names) - {field.name for field in known}
        if unknown:
            raise InputError(f"{cls.__name__} has no {', '.join(sorted(unknown))}")
        wanted = [field.name for field in known
                  if not names or field.name in names or field.default is MISSING]
        reals = {name: _AXES.get(name, ()) + shape for name in wanted if name not in _KINDS}
        # in one block: of many large arrays the system takes each back, page by page
        block = np.empty(sum(map(math.prod, reals.values())))
        made: dict[str, npt.NDArray[Any]] = {
            name: np.empty(shape, _KINDS[name]) for name in wanted if name in _KINDS}
        end = 0
        for name, whole in reals.items():
            start, end = end, end + math.prod(whole)
            made[name] = _by_columns(name, block[start:end].reshape(whole))
        return cls(**made)

    @classmethod
    def _or_new(cls: type[Made], out: Made | None, shape: tuple[int, ...]) -> Made:
        """What is written to: `out`, or new arrays of everything.

        Raises:
            TypeError: `out` is of another class
        """
        if out is None:
            return cls.empty(shape)
        if not isinstance(out, cls):
            raise TypeError(f"out is of the class {type(out).__name__}; it must be made by "
                            f"{cls.__name__}.empty()")
        return out

    def _addresses(self, shape: tuple[int, ...], *names: str) -> list[int | None]:
        """Where the library finds arrays, by their names; None for what was not asked for.

        Raises:
            InputError: an array that the library cannot write to
        """
        found: list[int | None] = []
        for name in names:
            array = getattr(self, name)
            if array is None:  # the library says where that is not allowed
                found.append(None)
                continue
            expected, kind = _AXES.get(name, ()) + shape, np.dtype(_KINDS.get(name, np.float64))
            if not (isinstance(array, np.ndarray) and array.shape == expected
                    and array.dtype == kind):
                raise InputError(f"out.{name} must be an array of {kind} of the shape {expected}")
            array = _by_columns(name, array)
            if not (array.flags.c_contiguous and array.flags.writeable):
                raise InputError(f"out.{name} cannot be written in place: make it by empty()")
            found.append(array.ctypes.data)
        return found


Made = TypeVar("Made", bound=Outputs)


def _by_columns(name: str, array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """A tangent [row, column] of [column][row] of the library, and the other way round."""
    return array.swapaxes(0, 1) if len(_AXES.get(name, ())) == 2 else array
