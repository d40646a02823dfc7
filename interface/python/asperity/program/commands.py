"""The commands that are most used, with their keys."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, fields, replace
from pathlib import Path
from typing import Any, Literal

from ..errors import InputError
from ..law import Law
from ..properties import Properties
from .errors import FileError
from .result import Result
from .run import File, run


def surface(*files: File, material: str | None = None, route: Literal["nayak", "paper"] | None = None,
            verify: bool | None = None, short_cutoff: float | None = None,
            long_cutoff: float | None = None, perpendicular: File | Iterable[File] | None = None,
            **keys: Any) -> Result:
    """A height map, or profiles, to the parameters of the law.

    Args:
        *files: a map in any format that the program reads (SDF, X3P, SUR, PLU, GWY, text, ...), two
            maps with pair=True, or profiles; none with generate=True
        material: pair of the paper for modulus, hardness, yield factor and friction
        route: parameters by spectral moments, or by the paper's spd, spc and sq
        verify: sum the law over the summits of the map beside the Gaussian integral
        short_cutoff, long_cutoff: S and L filter, mm
        perpendicular: profiles at right angles to the others
        **keys: all others of `asperity help surface`

    Returns:
        summary: eta, radius, sigma by route, with half widths of 95 % intervals; data: all
        parameters; verdict. law_properties() makes properties of it
    """
    return run("surface", *files, material=material, route=route, verify=verify,
               short_cutoff=short_cutoff, long_cutoff=long_cutoff,
               perpendicular=_paths(perpendicular), **keys)


def tenon(*case: File, pair: str | None = None, amplitudes: Iterable[float] | None = None,
          cycles: Iterable[int] | None = None, history: File | None = None,
          clearance: float | None = None, side_pressure: float | None = None,
          properties: Properties | None = None, **keys: Any) -> Result:
    """Replay of a tenon joint, with hard contact and with the rough law.

    Args:
        *case: a case file
        pair: pair of the paper, if neither the case nor `properties` say what the faces are
        amplitudes: of the load point, growing, mm
        cycles: at each amplitude
        history: CSV file of recorded displacements or rotations, in place of amplitudes
        clearance: above the tenon and below it, mm
        side_pressure: on each side face, MPa
        properties: of upper and lower face, such as law_properties() gives
        **keys: all others of `asperity help tenon`, sizes above all

    Returns:
        summary: moments and stiffness beside the paper's; cycles, skeleton, faces, totals; data:
        every increment, with column model ("hard" or "rough"), rotation (rad), moment (kN m)
    """
    return _joint("tenon", case, properties, pair=pair, amplitudes=amplitudes, cycles=cycles,
                  history=history, clearance=clearance, side_pressure=side_pressure, **keys)


def solid(*case: File, mesh_size: float | None = None, properties: Properties | None = None,
          **keys: Any) -> Result:
    """The tenon joint as a solid of plastic wood. It takes minutes, and needs PETSc.

    Args:
        *case: a case file
        mesh_size: size of elements, mm
        properties: of upper and lower face, such as law_properties() gives
        **keys: all others of `asperity help solid`

    Returns:
        as of tenon()
    """
    return _joint("solid", case, properties, mesh_size=mesh_size, **keys)


def hysteresis(*records: File, where: Mapping[str, Any] | None = None,
               displacement_column: str | int | None = None, force_column: str | int | None = None,
               quantity: Literal["force", "moment"] | None = None, **keys: Any) -> Result:
    """Records of displacement and force, or rotation and moment, taken apart.

    Args:
        *records: CSV files
        where: values that the rows to be read have, such as {"model": "rough"}
        displacement_column, force_column: name or number, if not found by name and unit
        quantity: what is taken of a record that has both
        **keys: all others of `asperity help hysteresis`

    Returns:
        summary: stiffness, yield, peak and ultimate point of each side; data: a row for each cycle
        with energy, damping, pinching; skeleton, amplitudes, en_12512, en_26891. Units are those of
        the file
    """
    return run("hysteresis", *records, where=where, displacement_column=displacement_column,
               force_column=force_column, quantity=quantity, **keys)


def fit(*records: File, kind: Literal["press", "shear", "joint"], free: str | Iterable[str],
        fix: Mapping[str, Any] | None = None, start: Mapping[str, float] | None = None,
        model: File | None = None, hold_out: File | Iterable[File] | None = None, **keys: Any) -> Result:
    """Parameters of the law, of friction or of a joint, from records.

    Args:
        *records: CSV files of one test each
        kind: closure and pressure; displacement and shear force or stress; those of a joint
        free: keys that are found
        fix: keys that are known, such as {"pair": "transverse-tangential"}
        start: where the search begins
        model: case file with what is known
        hold_out: records that are not fitted, but compared
        **keys: all others of `asperity help fit`

    Returns:
        summary: value, low_95 and high_95 of each parameter; data: record and model, sample by
        sample; fixed, quality, correlations

    Raises:
        InputError: also where the record cannot tell the parameters
        ComputationError: the search does not converge
    """
    return run("fit", *records, kind=kind, free=free, fix=fix, start=start, model=model,
               hold_out=_paths(hold_out), **keys)


def law_properties(found: Result | File, pair: str | None = None, **keys: Any) -> Properties:
    """Properties for a law of what surface() or fit() found, of the faces that a command ran with, or
    of a case file.

    Args:
        found: the result, or the path of a case file
        pair: pair of the paper for what the case does not give
        **keys: properties in place of those of the case

    Raises:
        InputError: the case does not give all properties, and neither pair nor keys do
        FileError: the case file cannot be read
    """
    if isinstance(found, Result) and found.case is None:
        return _as_properties(found, pair, **keys)
    if isinstance(found, Result) or pair is not None:
        case = found.case if isinstance(found, Result) else _text(found)
        if pair is not None:
            # as an option it would replace what the case gives
            case = re.sub(r"^\s*&asperity", rf"\g<0> pair = '{pair}'", str(case), count=1,
                          flags=re.MULTILINE | re.IGNORECASE)
        run_with = run("shear", case_text=str(case), **keys)
    else:
        run_with = run("shear", found, **keys)
    if run_with.sources.get("pair") == "default":
        lacking = [name for name in _NEEDED if run_with.sources[name].startswith("pair ")]
        raise InputError(f"{', '.join(lacking)} must be given, by name or by a pair of the paper")
    return _as_properties(run_with)


_NEEDED = [f.name for f in fields(Properties) if f.default is MISSING]
# Keys that need no other one, so that they can replace those of a case even where they are usual
_ALWAYS = (*_NEEDED, "friction_rule", "slip_integration", "accept_unphysical", "unloading",
           "plastic_ratio", "height_distribution")


def _text(file: File) -> str:
    try:
        return Path(file).read_text(encoding="utf-8", errors="replace")
    except OSError as problem:
        raise FileError(f"{os.fspath(file)}: cannot be read: {problem.strerror}") from problem


def _as_properties(found: Result, pair: str | None = None, **keys: Any) -> Properties:
    """The properties that a command ran with, those of a pair where it had none, and keys."""
    values = dict(found.properties)
    points = values.pop("friction_points", [])
    values |= {"friction_pressures": tuple(points[::2]), "friction_factors": tuple(points[1::2])}
    if pair is not None:
        values = vars(Properties.from_pair(pair)) | values
    values |= keys
    lacking = [name for name in _NEEDED if name not in values]
    if lacking:
        raise InputError(f"{found.command} ran without {' and '.join(lacking)}: give them by name, or "
                         "by a pair of the paper")
    return Properties(**{f.name: values[f.name] for f in fields(Properties) if f.name in values})


def _joint(command: str, case: tuple[File, ...], properties: Properties | None,
           **keys: Any) -> Result:
    """Run a joint with properties in place of those of the case."""
    if properties is None:
        return run(command, *case, **keys)
    if not isinstance(properties, Properties):
        raise TypeError(f"properties is of the class {type(properties).__name__}; it must be Properties")
    properties = replace(properties, compiled=False)
    wanted = Law(properties).properties
    properties = replace(properties, initial_separation=wanted.initial_separation)
    given = {f.name: value for f in fields(Properties)
             if (value := getattr(properties, f.name)) != f.default or f.name in _ALWAYS}
    points = zip(given.pop("friction_pressures", ()), given.pop("friction_factors", ()), strict=True)
    if properties.friction_pressures:
        given["friction_points"] = [part for point in points for part in point]
    if twice := sorted(given.keys() & keys.keys()):
        raise InputError(f"{', '.join(twice)} is given beside the properties, which have it: take it out")
    found = run(command, *case, **given, **keys)
    if "sweep" not in keys:
        ran_with = Law(_as_properties(found)).properties
        # no stick_elements stand for the usual number of them
        if more := [f.name for f in fields(Properties)
                    if getattr(ran_with, f.name) != getattr(wanted, f.name)
                    and (f.name != "stick_elements" or wanted.stick_elements > 0)]:
            raise InputError(f"the case gives {', '.join(more)} beside the properties: take it out")
    return found


def _paths(files: File | Iterable[File] | None) -> list[Path] | None:
    if isinstance(files, (str, os.PathLike)):
        files = [files]
    return None if files is None else [Path(file) for file in files]
