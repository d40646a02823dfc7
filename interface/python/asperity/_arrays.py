"""Between numpy's arrays and the addresses that the library takes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.intc]

# Lengths are C's int
_MOST_POINTS = 2**31 - 1
# A field that was not asked for
NOT_ASKED: Any = None


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


def address(name: str, array: npt.NDArray[Any] | None, shape: tuple[int, ...],
            kind: npt.DTypeLike = np.float64) -> int | None:
    """Address of an output; None where it was not asked for."""
    if array is None:
        return None
    if array.shape != shape or array.dtype != kind:
        raise InputError(f"out.{name} has the shape {array.shape} and numbers of {array.dtype}; it "
                         f"must be {shape} of {np.dtype(kind)}")
    if not (array.flags.c_contiguous and array.flags.writeable):
        raise InputError(f"out.{name} cannot be written in place: make it by empty()")
    return int(array.ctypes.data)
