"""The program asperity from Python: its commands as functions, its results as numpy arrays.

The program is no part of this package, as it is linked with libraries under the GNU GPL. The
environment variable ASPERITY_PROGRAM names it; without, it is looked for on PATH.
"""

from .commands import fit, hysteresis, law_properties, solid, surface, tenon
from .errors import FileError, ProgramNotFoundError
from .result import Result, Table
from .run import find_program, run

__all__ = [
    "FileError", "ProgramNotFoundError", "Result", "Table", "find_program", "fit", "hysteresis",
    "law_properties", "run", "solid", "surface", "tenon",
]
