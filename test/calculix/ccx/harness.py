"""Running a ccx, and counting checks: a check prints a line, the last line has the counts."""

import os
import shutil
import subprocess
import traceback
from pathlib import Path

from results import Printed, contact_fields, increments, iterations, last_contact

COUNTS = {"passed": 0, "failed": 0}
LONGEST_RUN = 120


def check(name, good, found=""):
    """One check; what was found is shown whether it passed or not."""
    COUNTS["passed" if good else "failed"] += 1
    print(f"{'ok  ' if good else 'FAIL'} {name}{': ' if found else ''}{found}", flush=True)
    return good


def close(name, found, expected, relative=0.0, absolute=0.0):
    """One check that a number is the expected one, to whichever tolerance is larger."""
    off = abs(found - expected)
    share = f", {off / abs(expected):.1e} of it off" if expected else ""
    limit = max(relative * abs(expected), absolute)
    return check(name, off <= limit,
                 f"{found:.9g}, expected {expected:.9g}{share} (at most {limit:.1e} off)")


def at_most(name, found, limit):
    """One check that a size is below a limit."""
    return check(name, abs(found) <= limit, f"{found:.2e} (at most {limit:.1e})")


def group(name, function, *arguments):
    """Checks under a heading; an exception is a failed check."""
    print(f"-- {name}", flush=True)
    try:
        function(*arguments)
    except Exception:  # whatever happens, the other groups run and this one has failed
        check(f"{name} ran to its end", False, "\n     | " + "\n     | ".join(
            traceback.format_exc().strip().splitlines()[-6:]))


class Run:
    """One job: its exit status and its files."""

    def __init__(self, ccx, folder, name, deck, environment=None, files=()):
        """`files` are copied into the job's folder: (path, name there)."""
        self.folder = Path(folder) / name
        self.folder.mkdir(parents=True)
        for path, copy in files:
            shutil.copy(path, self.folder / copy)
        (self.folder / "job.inp").write_text(deck if isinstance(deck, str) else deck.text(),
                                             encoding="ascii")
        surroundings = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_STIFFNESS="1")
        surroundings.update(environment or {})
        with open(self.folder / "log", "w", encoding="utf-8") as log:
            self.status = subprocess.run([str(ccx), "-i", "job"], cwd=self.folder, stdout=log,
                                         stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                         env=surroundings, timeout=LONGEST_RUN,
                                         check=False).returncode
        self.log = (self.folder / "log").read_text(encoding="utf-8", errors="replace")

    def file(self, ending):
        """Path of one of its files."""
        return self.folder / f"job.{ending}"

    def completed(self, steps):
        """Ended well with so many steps done; else an exception tells where the job stopped."""
        rows = increments(self.file("sta")) if self.file("sta").exists() else []
        if self.status or not rows or rows[-1][0] != steps or abs(rows[-1][5] - 1) > 1e-9:
            tail = "\n".join(self.log.strip().splitlines()[-8:])
            raise RuntimeError(f"{self.folder.name}: status {self.status}, last increment "
                               f"{rows[-1] if rows else None}, log ends:\n{tail}")
        return self

    @property
    def printed(self):
        """Of JOB.dat."""
        return Printed(self.file("dat"))

    @property
    def contact(self):
        """Of JOB.frd, at the end."""
        return last_contact(self.file("frd"))

    @property
    def contact_history(self):
        """Of JOB.frd, at all times."""
        return contact_fields(self.file("frd"))

    @property
    def increments(self):
        """Of JOB.sta."""
        return increments(self.file("sta"))

    @property
    def iterations(self):
        """Of JOB.cvg."""
        return iterations(self.file("cvg"))
