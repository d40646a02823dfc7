"""What goes wrong, as exceptions with the message of the library."""

from __future__ import annotations


class AsperityError(Exception):
    """Anything that asperity refuses or cannot do."""


class InputError(AsperityError, ValueError):
    """A value, a length or a name that is not allowed; nothing has changed."""


class ComputationError(AsperityError, ArithmeticError):
    """A computation failed."""


class NoMemoryError(AsperityError, MemoryError):
    """There is not enough memory."""


def of_code(code: int, message: str) -> AsperityError:
    """The exception that stands for an asperity_code of the C interface."""
    if code == 1:
        return ComputationError(message)
    if code == 6:
        return NoMemoryError(message)
    return InputError(message)
