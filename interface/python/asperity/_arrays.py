"""Between numpy's arrays and the addresses that the library takes."""

from __future__ import annotations

import math
import operator
from dataclasses import MISSING, fields
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from .errors import InputError

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.intc]

# Lengths are C's int
_MOST_POINTS = 2**31 - 1
# A field that was not asked for
NOT_ASKED: Any = None


def as_shape(shape: int | tuple[int, ...]) -> tuple[int, ...]:
    """The shape of a number of points."""
    return shape if isinstance(shape, tuple) else (operator.index(shape),)


def count(shape: tuple[int, ...]) -> int:
    """Number of points of a shape."""
    points = math.prod(shape)
    if points > _MOST_POINTS:
        raise InputError(f"{points} points are too many for one call: at most {_MOST_POINTS}")
    return points


def given(name: str, values: npt.ArrayLike, shape: tuple[int, ...] | None = None) -> FloatArray:
    """An input as the library reads it: the array itself where it is contiguous float64."""
    array: FloatArray = np.require(values, np.float64, ["C", "A"])
    if shape is not None and array.shape != shape:
        raise InputError(f"{name} has the shape {array.shape}; it must be {shape}")
    return array


# Axes of components that come before those of the points, and what is not a real number
_AXES = {"traction": (3,), "tangent": (3, 3)}
_KINDS: dict[str, npt.DTypeLike] = {"validity": np.intc}


class Outputs:
    """Arrays that the library writes to: a dataclass whose fields without default it always writes,
    and those with None only where there is an array."""

    @classmethod
    def empty(cls: type[Made], shape: int | tuple[int, ...], *names: str) -> Made:
        """Arrays for `out=`, of points of a shape.

        Args:
            shape: of the points
            *names: what is asked for besides what is always given; without names, everything

        Raises:
            InputError: a name that is none of them
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
