"""Pictures by matplotlib, which the package needs for nothing else: pressures, loops, moments.

Each function draws into `ax`, or into new axes, and returns them; line keywords go to matplotlib.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError
from .law import Law
from .program.result import Result, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# What counts rows; columns before them tell one run from another
_COUNTS = ("time", "step", "cycle", "increment", "separation", "closure", "displacement")
_LOOPS = (("displacement", "shear_stress"), ("displacement", "force"), ("rotation", "moment"))
_SHARE_OF_HARDNESS = 0.2


def pressure(what: Law | Result | Mapping[str, Law | Result], *, largest: float | None = None,
             ax: Axes | None = None, **line: Any) -> Axes:
    """Pressure over overclosure.

    Args:
        what: a law; what "press", "curve", surface(verify=True) or fit(kind="press") found; or several
            of these, by the names of the legend
        largest: pressure up to which a law is drawn, MPa; a fifth of its hardness unless given
        ax: axes to draw into
        **line: of matplotlib's lines

    Raises:
        InputError: the result has no pressures over an overclosure
        ImportError: matplotlib is not installed
    """
    ax = _axes(ax)
    for name, one in (what if isinstance(what, Mapping) else {"": what}).items():
        if isinstance(one, Law):
            properties = one.properties
            top = _SHARE_OF_HARDNESS*properties.hardness if largest is None else largest
            end = properties.initial_separation - float(one.separation(top))
            closure = np.linspace(min(0.0, end), end, 201)
            ax.plot(closure, one.pressure(properties.initial_separation - closure),
                    **{"label": name or "law"} | line)
        elif isinstance(one, Result):
            _pressures(ax, name, one, line)
        else:
            raise TypeError(f"{name or 'what'} is of the class {type(one).__name__}; it must be a Law or "
                            "a Result")
    return _labelled(ax, "overclosure", "mm", "pressure", "MPa")


def _pressures(ax: Axes, name: str, result: Result, line: dict[str, Any]) -> None:
    """The pressures of a result."""
    table = result.tables.get("law", result.data)
    closure = next((one for one in ("overclosure", "closure") if one in table), None)
    columns = [one for one in table if one.removeprefix("model_").startswith("pressure")
               and not one.endswith(("_error", "_coupling"))]
    if closure is None or not columns:
        raise InputError(f"{result.command} has no pressures over an overclosure")
    for label, rows in _runs(table):
        for column in columns:
            # what was measured or summed beside its model
            points = (column == "pressure" and f"model_{column}" in columns) \
                or column.startswith(("pressure_summits", "pressure_own"))
            words = [name, label, column.replace("_", " ") if len(columns) > 1 else ""]
            ax.plot(rows[closure], rows[column],
                    **{"label": ", ".join(filter(None, words)) or column}
                    | ({"linestyle": "", "marker": "."} if points else {}) | line)


def loops(what: Result | Table, x: str | None = None, y: str | None = None, *,
          ax: Axes | None = None, **line: Any) -> Axes:
    """Force over displacement, a line for each run.

    Args:
        what: what "shear", tenon() or solid() found, or one of the tables or rows of it
        x, y: names of columns; displacement and shear stress, or force, unless given
        ax: axes to draw into
        **line: of matplotlib's lines

    Raises:
        InputError: there are no such columns
        ImportError: matplotlib is not installed
    """
    table = what.data if isinstance(what, Result) else what
    if x is None or y is None:
        pair = next((one for one in _LOOPS if set(one) <= set(table)), None)
        if pair is None:
            raise InputError(f"x and y must be given, of {', '.join(table)}")
        x, y = x or pair[0], y or pair[1]
    if lacking := [one for one in (x, y) if one not in table]:
        raise InputError(f"there is no {' and no '.join(lacking)}; there are {', '.join(table)}")
    ax = _axes(ax)
    for label, rows in _runs(table):
        ax.plot(rows[x], rows[y], **{"label": label} | line)
    return _labelled(ax, x, table.units.get(x, "-"), y, table.units.get(y, "-"))


def moment_rotation(what: Result | Table, *, ax: Axes | None = None, **line: Any) -> Axes:
    """Moment over rotation of a joint, hard contact and the rough law; see loops()."""
    return loops(what, "rotation", "moment", ax=ax, **line)


def _runs(table: Table) -> Iterator[tuple[str, Table]]:
    """The runs of a table, each with what tells it from the others."""
    names = list(table)
    leading = names[:next((i for i, name in enumerate(names) if name in _COUNTS), 0)]
    if not leading or table.rows == 0:
        yield "", table
        return
    cells = list(zip(*(table[name].tolist() for name in leading), strict=True))
    for run in dict.fromkeys(cells):
        words = [value if isinstance(value, str) else
                 f"{name.replace('_', ' ')} {value:g} {table.units.get(name, '-').strip('-')}".strip()
                 for name, value in zip(leading, run, strict=True)]
        yield ", ".join(words), table.where(**dict(zip(leading, run, strict=True)))


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as problem:
        raise ImportError("pictures need matplotlib, which is not installed: pip install matplotlib") \
            from problem
    return pyplot.subplots()[1]


def _labelled(ax: Axes, x: str, x_unit: str, y: str, y_unit: str) -> Axes:
    """Names and units at the axes, and a legend where there is something to tell apart."""
    for label, name, unit in (ax.set_xlabel, x, x_unit), (ax.set_ylabel, y, y_unit):
        label(name.replace("_", " ") + (f" ({unit})" if unit != "-" else ""))
    lines = [line for line in ax.get_lines() if not str(line.get_label()).startswith("_")]
    if len(lines) > 1:
        ax.legend()
    return ax
