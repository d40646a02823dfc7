"""Results of a joint in one form for the plane replay, the solid and CalculiX.

A number has a quantity, a face (or nothing), a displacement of the load point in mm, and a value under
hard contact and one under the rough law. Of cycles the first at each amplitude counts, and the negative
side, as in the paper's Table 5.
"""

import csv
import json
import math
import os
import subprocess
import tempfile

COLUMNS = ["quantity", "face", "displacement", "hard", "rough"]


class Joint:
    """Numbers by quantity and face: [(displacement, hard, rough)], small displacements first."""

    def __init__(self, rows):
        self.rows = rows

    def series(self, quantity, face=""):
        found = sorted(((u, hard, rough) for q, f, u, hard, rough in self.rows
                        if (q, f) == (quantity, face)), key=lambda row: abs(row[0]))
        if not found:
            raise KeyError(quantity)
        return found

    def last(self, quantity, face=""):
        """(hard, rough) at the largest displacement."""
        return self.series(quantity, face)[-1][1:]

    def back(self, quantity, face):
        """The series on the way down and back: at the reverse peak, which is its last, and before it
        smaller displacements of that side."""
        return [row for row in self.series(quantity, face) if row[0] < 0.0]

    def ratios(self, quantity, face=""):
        """[(displacement, rough over hard)] where hard contact has something."""
        return [(u, rough/hard) for u, hard, rough in self.series(quantity, face) if hard != 0.0]

    def add_penalty(self, stiffness, soft):
        """What another joint, whose hard contact gives, has of moments and pressure."""
        for name, quantity, face in (("moment", "negative_moment", ""),
                                     ("pressure", "largest_pressure", "lower")):
            rows = soft.back(quantity, face) if face else soft.series(quantity)
            self.rows += [(f"{name}_penalty_{stiffness}", "", *row) for row in rows]

    def with_rough_of(self, other):
        """This joint's hard contact beside the rough law of another."""
        return Joint([(*row[:4], theirs[4]) for row, theirs in zip(self.rows, other.rows)])


class Program:
    """`asperity`, and what it answered."""

    def __init__(self, path):
        self.path, self.known = os.path.abspath(path), {}

    def run(self, *arguments):
        """The JSON of a command, which is run once."""
        if arguments not in self.known:
            done = subprocess.run([self.path, *arguments, "--json", "-"], capture_output=True, text=True,
                                  check=False)
            if done.returncode:
                raise SystemExit(f"asperity {' '.join(arguments)}: {done.stderr}")
            self.known[arguments] = json.loads(done.stdout)
        return self.known[arguments]

    def text(self, *arguments):
        """What a command prints."""
        return subprocess.run([self.path, *arguments], capture_output=True, text=True, check=True).stdout

    def points(self, *arguments):
        """Rows of `--points`."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "points.csv")
            subprocess.run([self.path, *arguments, "--points", path], capture_output=True, check=True)
            with open(path, encoding="ascii") as file:
                return [{name.partition(" (")[0]: value for name, value in row.items()}
                        for row in csv.DictReader(file)]


def cycles_of(table, arm):
    """{amplitude: (first, last)} of cycles of the same amplitude, places in the table. The solid tells
    displacement over arm, its drift, from the joint's rotation; in the plane they are one."""
    found = {}
    for i, angle in enumerate(table["drift" if "drift" in table else "rotation"]):
        found.setdefault(round(arm*angle, 3), [i, i])[1] = i
    return found


def at_peaks(data, name, amplitude, peak):
    """(hard, rough) of a column at an amplitude: the first time at the peak, or the last time at the
    reverse peak."""
    found = []
    for model in ("hard", "rough"):
        reach, values = 0.0, []
        for k, m in enumerate(data["model"]):
            if m != model:
                continue
            reach = max(reach, abs(data["displacement"][k]))
            if reach < 1.000001*amplitude and abs(data["displacement"][k] - peak) < 1e-6*amplitude:
                values.append(data[name][k])
        found.append(values[0 if peak > 0.0 else -1])
    return tuple(found)


def from_json(answer):
    """Of `asperity tenon --json`, or of `asperity solid --json`: tables cycles, totals, summary and faces,
    and of the steps (data) model, displacement, moment, normal_upper, friction_dissipation."""
    cycles, data, rows = answer["cycles"], answer["data"], []
    amplitudes = cycles_of(cycles, answer["settings"]["arm"])
    for amplitude, (first, last) in amplitudes.items():
        for name, i in (("secant_stiffness", first), ("negative_moment", first), ("energy", first),
                        ("pinching", first), ("cumulative_energy", last)):
            rows.append((name, "", amplitude, cycles[f"{name}_hard"][i], cycles[f"{name}_rough"][i]))
        for name, column, peak in (("positive_moment", "moment", amplitude),
                                   ("peak_force", "normal_upper", amplitude),
                                   ("friction_dissipation", "friction_dissipation", -amplitude)):
            rows.append((name, "", amplitude, *at_peaks(data, column, amplitude, peak)))
    largest, given = max(amplitudes), {row[0] for row in rows}
    for table in ("totals", "summary"):
        rows += [(name, "", largest, *values[-2:]) for name, values in answer[table].items()
                 if isinstance(values[-1], float) and name not in given]
    faces = answer["faces"]
    for name in ("largest_pressure", "normal_force", "area_open", "area_stick", "area_slip"):
        values = {}
        for i, face in enumerate(faces["face"]):
            # models may come there by other increments, and so by other sums
            u = round(faces["displacement"][i], 6)
            values.setdefault((face, u), {})[faces["model"][i]] = faces[name][i]
        rows += [(name, face, u, v["hard"], v["rough"]) for (face, u), v in values.items()]
    return [row for row in rows if None not in row]


def read(path):
    """(Joint, the command that made it) of a file that `keep` wrote, or nothing."""
    if not os.path.exists(path):
        return None, ""
    with open(path, encoding="ascii") as file:
        command = file.readline()[1:].strip()
        rows = [(row["quantity"], row["face"], *(float(row[name]) for name in COLUMNS[2:]))
                for row in csv.DictReader(file)]
    return Joint(rows), command


def write(file, rows, command):
    """Numbers with the command that made them, six figures."""
    file.write(f"# {command}\n")
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([q, f, *(f"{v:.6g}" if math.isfinite(v) else "" for v in values)]
                     for q, f, *values in rows)
