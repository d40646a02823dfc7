"""What the program found: tables, input, remarks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import InputError

Column = npt.NDArray[Any]


def column(values: list[Any]) -> Column:
    """A column of JSON: texts, whole numbers, or numbers, NaN where there is no value."""
    if any(isinstance(value, str) for value in values):
        return np.array(["" if value is None else value for value in values])
    if values and all(isinstance(value, int) for value in values):
        return np.array(values)
    return np.array(values, dtype=np.float64)


class Table(Mapping[str, Column]):
    """Columns by their names, all of one length."""

    def __init__(self, columns: Mapping[str, Column], units: Mapping[str, str]) -> None:
        self._columns = dict(columns)
        self.units: dict[str, str] = {name: units[name] for name in columns if name in units}
        """Units of the columns; "-" of none."""

    def __getitem__(self, name: str) -> Column:
        if name not in self._columns:
            raise KeyError(f"there is no column {name}; there are {', '.join(self._columns)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def where(self, **values: Any) -> Table:
        """The rows that have these values in these columns, such as where(model="rough")."""
        chosen = np.ones(self.rows, dtype=bool)
        for name, value in values.items():
            chosen &= self[name] == value
        return Table({name: found[chosen] for name, found in self.items()}, self.units)

    def row(self, **values: Any) -> dict[str, Any]:
        """The one row that has these values, as a dictionary.

        Raises:
            InputError: none has, or several have
        """
        found = self.where(**values)
        if found.rows != 1:
            raise InputError(f"{found.rows} rows have {values}; one is wanted")
        return {name: cells[0].item() for name, cells in found.items()}

    def __repr__(self) -> str:
        names = ", ".join(f"{name} ({self.units[name]})" if self.units.get(name, "-") != "-" else name
                          for name in self)
        return f"<Table of {self.rows} rows: {names}>"


@dataclass
class Result:
    """What one command found. print() shows it as a terminal would."""

    command: str
    """The command, such as "tenon"."""
    version: str
    """Version of the program."""
    properties: dict[str, Any] = field(repr=False)
    """Properties of the faces that it ran with, in N, mm and MPa, by the names of case files."""
    settings: dict[str, Any] = field(repr=False)
    """The other keys that it ran with."""
    sources: dict[str, str] = field(repr=False)
    """Where each of these comes from, such as "default", "--sigma" or "case.nml:4"."""
    units: dict[str, str] = field(repr=False)
    """Units of all keys and columns."""
    remarks: list[str]
    """What is to be said of the results."""
    tables: dict[str, Table]
    """All tables by their names: "data", the main one; most commands have "summary" as well."""
    text: str = field(repr=False)
    """All as a terminal shows it."""
    passed: bool = True
    """False where a comparison departs or `check` finds errors (status 1)."""
    verdict: str | None = None
    """What surface, compare, replay and check say in the end."""
    record_kind: str | None = None
    """What hysteresis takes the record for, such as "cyclic"."""
    case: str | None = field(default=None, repr=False)
    """Text of the case file that surface and fit write of what they found."""

    @classmethod
    def from_json(cls, answer: dict[str, Any], text: str, **more: Any) -> Result:
        """The result in a JSON file of the program."""
        known = {name: answer[name] for name in (f.name for f in fields(cls)) if name in answer}
        tables = {name: Table({key: column(cells) for key, cells in found.items()}, answer["units"])
                  for name, found in answer.items() if isinstance(found, dict) and name not in known}
        return cls(**known, version=answer["asperity"], tables=tables, text=text, **more)

    @property
    def data(self) -> Table:
        """The main table: every increment, separation or sample."""
        return self._table("data")

    @property
    def summary(self) -> Table:
        """A row for each run, route or parameter."""
        return self._table("summary")

    def _table(self, name: str) -> Table:
        if name not in self.tables:
            raise KeyError(f"{self.command} has no table {name}; there are {', '.join(self.tables)}")
        return self.tables[name]

    def __str__(self) -> str:
        return self.text
