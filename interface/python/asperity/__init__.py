"""Elasto-plastic contact of rough timber faces. Units are N, mm and MPa throughout."""

from . import _library
from .contact import STATE_TYPE, Contact, Response, Status, Validity
from .errors import AsperityError, ComputationError, InputError, NoMemoryError
from .faces import Face
from .law import Law, LawValues, UnloadingValues
from .properties import Properties

__version__ = _library.text("library_version")

FOUR_SIGMA = 1.0e300
"""Properties.initial_separation that stands for 4 sigma."""
NO_OPPOSITE_SURFACE = -1.0e36
"""Overclosure of a point without opposite surface, mm."""

__all__ = [
    "AsperityError", "ComputationError", "Contact", "FOUR_SIGMA", "Face", "InputError", "Law",
    "LawValues", "NO_OPPOSITE_SURFACE", "NoMemoryError", "Properties", "Response", "STATE_TYPE",
    "Status", "UnloadingValues", "Validity", "__version__",
]
