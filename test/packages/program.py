"""`asperity surface`, run on a map."""

import json
import math
import subprocess


class Program:
    """The program and the folder of its files."""

    def __init__(self, path, folder):
        self.path, self.folder = path, folder

    def write(self, m):
        """Path of a map's file."""
        path = self.folder / f"{m.name}.{m.ending}"
        m.write(m, path)
        return path

    def run(self, path, *options):
        """What it writes as JSON."""
        result = path.with_suffix(".json")
        done = subprocess.run([self.path, "surface", str(path), *options, "--json", str(result)],
                              check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True, timeout=60)
        if done.returncode:
            raise RuntimeError(f"status {done.returncode}: {done.stderr.strip()}")
        return json.loads(result.read_text(encoding="utf-8"))

    def columns(self, path, *options):
        """{column: {parameter: value}}, nan for what does not exist."""
        data = self.run(path, *options)["data"]
        return {column: {name: number(value)
                         for name, value in zip(data["parameter"], data[column])}
                for column in ("value", "uncertainty", "step_2", "step_4")}

    def values(self, path, *options):
        """{parameter: value}"""
        return self.columns(path, *options)["value"]


def number(value):
    """A number of a table, where none may be empty or null."""
    return float(value) if value not in (None, "") else math.nan
