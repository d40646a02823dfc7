"""CSV files: a column is headed by its name, with the unit in brackets where it has one."""

import csv

from .whole_file import whole_file

UNITS = {"displacement": "mm", "force": "N", "wall_time": "s", "cpu_time": "s", "area": "mm^2",
         **dict.fromkeys(("x", "y", "z", "ux", "uy", "uz", "opening", "slip_1", "slip_2"), "mm"),
         "normal_force": "N", **dict.fromkeys(("area_open", "area_stick", "area_slip"), "mm^2"),
         **dict.fromkeys(("largest_pressure", "pressure", "shear_1", "shear_2"), "MPa")}


def heading(name):
    """Name and unit of a column."""
    return f"{name} ({UNITS[name]})" if name in UNITS else name


def name_in(text):
    """The name in a heading."""
    return text.partition(" (")[0]


def write_rows(path, names, rows):
    """A CSV file, whole or not at all."""
    with whole_file(path) as part, open(part, "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(heading, names))
        writer.writerows([f"{v:.9g}" if isinstance(v, float) else v for v in row] for row in rows)


def read_rows(path):
    """Yield the rows of a CSV file, {name: text}; texts that are missing are None."""
    with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
        lines = csv.reader(file)
        names = [name_in(text) for text in next(lines, [])]
        for values in lines:
            yield dict(zip(names, values + [None]*(len(names) - len(values))))
