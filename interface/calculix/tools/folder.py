"""The folder of a run: what is there of an earlier one, the decks of its parts, its results."""

import json
import os
import shutil

from . import history
from .files import restart, tables
from .files.whole_file import whole_file
from .progress import say

# What a run leaves of a job
ENDINGS = ("inp", "dat", "frd", "sta", "cvg", "12d", "rout", "rin", "uinter", "log",
           "increments.csv", "states.csv")
# Bytes of a file's name, of which the endings need some
LONGEST_NAME = 200


class Failure(Exception):
    """An error for the user, with the reason that gives the exit status."""

    def __init__(self, reason, message):
        super().__init__(message)
        self.reason = reason


class Run:
    """The folder of a run: its parts, one for each time that ccx was started."""

    def __init__(self, options, deck):
        self.deck, self.options = deck, options
        place, name = os.path.split(options.deck)
        name = os.fsencode(os.path.splitext(name)[0])[:LONGEST_NAME]
        self.name = os.fsdecode(name)
        # ccx cuts the name of a job at a blank, and hands it to a shell: its files are renamed
        self.plain = "ccx" if self.name.startswith("job") else "job"
        self.folder = options.output or os.path.join(place, self.name + ".results")
        self.state = {"deck": deck.fingerprints(), "parts": [], "finished_steps": 0,
                      "most_springs": 0, "outcome": "begun"}

    def path(self, name):
        return os.path.join(self.folder, name)

    def save(self):
        """Write what --resume needs."""
        with whole_file(self.path("run.json")) as part, open(part, "w", encoding="utf-8") as file:
            json.dump(self.state, file, indent=1)
            file.write("\n")

    def open(self):
        """Find what is there; decide where to begin."""
        os.makedirs(self.folder, exist_ok=True)
        self.lock()
        before = self.read_state()
        if before is not None:
            self.settle(before["parts"])
        if before is None or self.options.anew:
            self.clean(before)
            return
        if not self.options.resume:
            raise Failure("input", f"{self.folder} holds a run ({before['outcome']}): --resume "
                          "goes on with it, --anew throws it away")
        self.adopt(before)

    def lock(self):
        """One runner at a time in a folder."""
        try:
            import fcntl                    # pylint: disable=import-outside-toplevel
        except ImportError:
            return
        self._lock = open(self.path("run.lock"), "w", encoding="ascii")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Failure("input", f"another run is under way in {self.folder}") from None

    def read_state(self):
        try:
            with open(self.path("run.json"), encoding="utf-8") as file:
                state = json.load(file)
            return state if {"deck", "parts", "outcome"} <= state.keys() else None
        except FileNotFoundError:
            return None
        except (ValueError, AttributeError):
            raise Failure("input", f"{self.path('run.json')} is not readable; --anew throws the "
                          "run away") from None

    def clean(self, before):
        """Remove what an earlier run left, and only that."""
        self.remove_files([part["job"] for part in (before or {"parts": []})["parts"]]
                          or [self.name])
        for name in ("history.csv", "history.unfinished.csv", "increments.csv", "states.csv",
                     "run.json", "temporaryrestartfile"):
            self.remove(name)

    def remove_files(self, jobs):
        """Remove the files of jobs."""
        for job in jobs:
            for ending in ENDINGS:
                self.remove(f"{job}.{ending}")

    def remove(self, name):
        try:
            os.remove(self.path(name))
        except FileNotFoundError:
            pass

    def adopt(self, before):
        """Take over the finished steps of an earlier run of this deck."""
        mine, done = self.deck.fingerprints(), self.finished_in(before["parts"])
        if before["deck"]["model"] != mine["model"]:
            raise Failure("input", "the model of the deck is not that of the run in "
                          f"{self.folder}; --anew throws the run away")
        if before["deck"]["steps"][:done] != mine["steps"][:done]:
            raise Failure("input", f"finished steps (1 to {done}) differ from those of the run in "
                          f"{self.folder}; --anew throws the run away")
        if done == 0:
            say("no step was finished: beginning from the start")
            self.clean(before)
            return
        # a runner that was killed had no time to note its springs
        springs = [row["springs"] for part in before["parts"] for row in
                   history.read_increments(self.path(part["job"] + ".increments.csv"))]
        self.state.update(parts=before["parts"], finished_steps=done,
                          most_springs=max([before.get("most_springs", 0), *springs]))

    def finished_in(self, parts):
        """Steps that the restart files hold; the parts without any are dropped."""
        while parts:
            job = parts[-1]["job"]
            done = restart.last_step(self.path(job + ".rout"))
            if done >= parts[-1].get("failed_step", done + 1):
                done = 0                    # ccx went on until it was stopped
            if done == 0 and len(parts) == 1:
                # ended between removing the old file and naming the new one
                waiting = restart.last_step(self.path("temporaryrestartfile"))
                if waiting:
                    os.replace(self.path("temporaryrestartfile"), self.path(job + ".rout"))
                    done = waiting
            if done:
                return done
            parts.pop()
        return 0

    def start(self, program):
        """Write the deck of the next part and start ccx; return its name for the job."""
        done, parts, job = self.state["finished_steps"], self.state["parts"], self.plain
        name = f"{self.name}-{len(parts) + 1}" if done else self.name
        self.remove_files([job, name])
        if done:
            before = parts[-1]["job"]
            shutil.copyfile(self.path(before + ".rout"), self.path(job + ".rin"))
            # what UINTER's interactions are stands beside the restart file
            if os.path.exists(self.path(before + ".uinter")):
                shutil.copyfile(self.path(before + ".uinter"), self.path(job + ".uinter"))
        text = self.deck.resumed_text(done) if done else self.deck.text()
        with open(self.path(job + ".inp"), "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(text)
        parts.append({"job": job, "name": name, "first_step": done + 1, "program": program})
        self.save()
        return job

    def settle(self, parts):
        """Give the files of parts that have ended the deck's name."""
        for part in parts:
            job, name = part["job"], part.get("name", part["job"])
            for file in os.listdir(self.folder) if job != name else ():
                if file.startswith(job + "."):
                    os.replace(self.path(file), self.path(name + file[len(job):]))
            part["job"] = name

    def write_results(self, complete):
        """increments.csv and history.csv of all parts. Unfinished, it has another name."""
        parts = [{**part, "increments": history.read_increments(
            self.path(part["job"] + ".increments.csv"))} for part in self.state["parts"]]
        tables.write_rows(self.path("increments.csv"), history.INCREMENT_COLUMNS,
                          [list(row.values()) for _, row in history.select(parts)])
        names, rows = history.states(self.folder, parts)
        if rows:
            tables.write_rows(self.path("states.csv"), names, rows)
            say(f"written: {self.path('states.csv')}: STATEV of {len(rows)} points and increments")
        elif self.options.states:
            say("no states: they need a ccx of interface/calculix/build, and a deck with UINTER")
        options, deck = self.options, self.deck
        factor = options.force_factor or (2.0 if deck.half_model else 1.0)
        gauge = options.gauge or (None if options.set else deck.gauge)
        try:
            direction, rows = history.history(
                self.folder, parts, (options.set or deck.load_set).upper(), gauge and gauge.upper(),
                options.direction or deck.load_direction, factor)
        except history.HistoryError as problem:
            return str(problem) if complete else None
        self.remove("history.csv")
        self.remove("history.unfinished.csv")
        name = "history.csv" if complete else "history.unfinished.csv"
        tables.write_rows(self.path(name), ("step", "time", "displacement", "force"), rows)
        if complete:
            say(f"written: {self.path(name)}: {len(rows)} points in direction {direction}"
                + (f", force times {factor:g}" if factor != 1.0 else ""))
        return None
