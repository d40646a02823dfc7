"""One rough face, such as those of the paper."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass, fields
from typing import Literal

from . import _library
from ._arrays import number
from .errors import InputError

Section = Literal["transverse", "tangential", "radial"]
SECTIONS = {"transverse": 1, "tangential": 2, "radial": 3}
HARDNESS_RULES = {"softer": 1, "harder": 2}
ROUGHNESS_RULES = {"moments": 1, "face_1": 2, "face_2": 3}


def code_of(name: str, word: str, words: dict[str, int]) -> int:
    """The library's number of a word.

    Raises:
        InputError: there is no such word
    """
    if not isinstance(word, str) or word not in words:
        raise InputError(f"{name} = {word!r} is not allowed: it must be one of {', '.join(words)}")
    return words[word]


@dataclass(frozen=True, kw_only=True)
class Face:
    """One rough face. A smooth one has no summits: sigma, radius and eta stay 0."""

    sigma: float = 0.0
    """Standard deviation of summit heights, mm."""
    radius: float = 0.0
    """Summit radius, mm."""
    eta: float = 0.0
    """Asperity density, summits per nominal area, 1/mm2."""
    young_modulus: float
    """Young's modulus along the normal of the face, MPa."""
    poisson_ratio: float
    """Poisson's ratio of strain in the face for pressure on it, -0.99 to 0.99."""
    hardness: float
    """Hardness, MPa."""

    def __post_init__(self) -> None:
        for field in fields(self):
            object.__setattr__(self, field.name, number(field.name, getattr(self, field.name)))

    @classmethod
    def from_paper(cls, surface: str, section: Section) -> Face:
        """A surface of Table 2 of the paper on a section of its wood.

        Args:
            surface: name, such as "unpolished-cross"
            section: by the direction of the face's normal: "transverse" along the grain,
                "tangential" radial, "radial" tangential

        Raises:
            InputError: a name that is not one, or a face without hardness: that of "radial"
        """
        struct = _library.FaceStruct()
        _library.call("face_from_paper", byref(struct), surface.encode(),
                      code_of("section", section, SECTIONS))
        return cls(**{field.name: getattr(struct, field.name) for field in fields(cls)})

    def as_struct(self) -> _library.FaceStruct:
        """As the library takes it."""
        return _library.FaceStruct(**{field.name: getattr(self, field.name)
                                      for field in fields(self)})
