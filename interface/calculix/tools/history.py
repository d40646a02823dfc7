"""Force and displacement of the loaded node set per increment, joined over the parts of a run."""

import os

from .files import dat, tables

INCREMENT_COLUMNS = ("step", "increment", "attempts", "iterations", "springs", "increment_time",
                     "step_time", "total_time", "wall_time", "cpu_time")


class HistoryError(Exception):
    """Why there is no history."""


def read_increments(path):
    """Rows of an increments file, [{column: number}]; a line cut short is left out."""
    rows = []
    try:
        for row in tables.read_rows(path):
            try:
                # version 0.1 named the last two by their unit
                rows.append({name: (int if name in INCREMENT_COLUMNS[:5] else float)(
                    row.get(name, row.get(name.replace("time", "seconds"))))
                             for name in INCREMENT_COLUMNS})
            except (TypeError, ValueError):
                pass
    except OSError:
        pass
    return rows


def select(parts):
    """[(part, row)]: the increments that count. A part ends where the next one begins."""
    chosen = []
    for number, part in enumerate(parts):
        end = parts[number + 1]["first_step"] if number + 1 < len(parts) else None
        chosen += [(part, row) for row in part["increments"]
                   if row["step"] >= part["first_step"] and (end is None or row["step"] < end)]
    return chosen


def history(folder, parts, name, gauge=None, direction=None, factor=1.0):
    """(direction, [(step, time, displacement, force)]) of node set `name`.

    parts: [{job, first_step, increments}]. Without a direction, 1, 2 or 3, it is that of the
    largest displacement. The force is the load's on the body, times the factor. The displacement
    can be that of another set, the gauge."""
    points = []
    for part in parts:
        path = os.path.join(folder, part["job"] + ".dat")
        try:
            part["records"] = dat.by_time(path, name, gauge)
        except OSError as problem:
            raise HistoryError(f"{path}: {problem.strerror}") from problem
    for part, row in select(parts):
        record = take(part, row["total_time"])
        if record is not None:
            points.append((row["step"], *record))
    if not points:
        raise HistoryError(f"no displacement and force in the .dat file: the deck needs "
                           f"*NODE PRINT,NSET={gauge or name} with U, and "
                           f"*NODE PRINT,NSET={name},TOTALS=ONLY with RF")
    if direction is None:
        reach = [max(abs(u[i]) for _, _, u, _ in points) for i in range(3)]
        direction = reach.index(max(reach)) + 1
    i = direction - 1
    rows = [(0, 0.0, 0.0, 0.0)]
    rows += [(step, time, u[i], force[i]*factor) for step, time, u, force in points]
    return direction, rows


def take(part, time):
    """The record of a time, and forget those before it. ccx prints 7 figures of it in both places,
    and times grow: the nearest one is right."""
    records = part["records"]
    while records and records[0][0] < time - 1.5e-6*max(1e-3, abs(time)):
        records.pop(0)
    if records and abs(records[0][0] - time) <= 1.5e-6*max(1e-3, abs(time)):
        found = records.pop(0)
        if found[1] is not None and found[2] is not None:
            return found
    return None


def states(folder, parts):
    """(names, rows) of STATEV of the contact points in the increments that count."""
    names, chosen = [], []
    for part in parts:
        path = os.path.join(folder, part["job"] + ".states.csv")
        good = {(row["step"], row["increment"]) for other, row in select(parts) if other is part}
        for row in tables.read_rows(path) if os.path.exists(path) else ():
            if None in row.values() or (int(row["step"]), int(row["increment"])) not in good:
                continue
            names = names or list(row)
            chosen.append([row[name] for name in names])
    return names, chosen
