"""What goes wrong with the program, beside InputError (status 2) and ComputationError (status 1)."""

from __future__ import annotations

from ..errors import AsperityError, ComputationError, InputError


class FileError(AsperityError, OSError):
    """A file could not be read or written (status 3)."""


class ProgramNotFoundError(AsperityError, FileNotFoundError):
    """The program is not there, or not of the version of this package."""


def of_status(status: int, message: str) -> AsperityError:
    """The exception that stands for an exit status of the program."""
    known = {1: ComputationError, 2: InputError, 3: FileError}
    if status < 0:
        return ComputationError(f"the program was ended by signal {-status}: {message}")
    if status not in known:
        return ComputationError(f"the program ended with status {status}: {message}")
    return known[status](message)
