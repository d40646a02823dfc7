"""What ccx says while it runs: increments, iterations, contact springs, errors."""

import re
from dataclasses import dataclass

NUMBER = r"([-+0-9.eE]+)"
STEP = re.compile(r"\s*STEP\s+(\d+)\s*$")
INCREMENT = re.compile(r" ?increment (\d+) attempt (\d+)")
SIZE = re.compile(r" ?increment size=\s*" + NUMBER)
STEP_TIME = re.compile(r" ?actual step time=\s*" + NUMBER)
TOTAL_TIME = re.compile(r" ?actual total time=\s*" + NUMBER)
ITERATION = re.compile(r" ?iteration (\d+)\s*$")
SPRINGS = re.compile(r" ?Number of contact spring elements=\s*(\d+)")
CONVERGED = re.compile(r" ?convergence\b")
NOTE = re.compile(r" ?(?:asperity: |\*WARNING: )(UINTER .*)")
UINTER = re.compile(r" ?asperity: (\d+) calls of UINTER took\s+([.\d]+) s")
RESIDUAL = re.compile(r" ?(largest (?:residual force|correction to disp)=.*)")
NO_CONVERGENCE = re.compile(
    r"increment size smaller than minimum|too many (iterations|cutbacks)|seems to diverge"
    r"|max\. # of increments", re.I)


@dataclass
class Increment:
    """A converged increment."""

    step: int
    increment: int
    attempts: int
    iterations: int
    springs: int
    size: float
    step_time: float
    total_time: float


class Watcher:
    """Follows the lines of ccx. `failure` is set as soon as the run cannot be a result.

    may_vanish(step) says whether contact springs may vanish in a step: 'never', 'always', or
    'within', for some increments but not for the whole step. A run of several parts hands on
    `most`, the largest number of springs so far."""

    def __init__(self, may_vanish, share=0.0, most=0):
        self.may_vanish, self.share, self.most = may_vanish, share, most
        self.step = self.increment = self.attempt = self.iteration = 0
        self.size = self.step_time = self.total_time = 0.0
        self.springs = None
        self.iterations = 0             # of all attempts at this increment
        self.cutbacks = self.all_iterations = 0
        self.errors, self.warnings = [], 0
        self.failure, self.reason = None, ""
        self.job_finished = False
        self.uinter = None              # calls and seconds, where ccx tells
        self.notes = []                 # what else our host of UINTER says
        self._in_error = False
        self._clues = {}
        self._step_springs = 0          # most in a converged increment of this step

    def feed(self, line):
        """Take one line; return an Increment when it says that one has converged."""
        line = line.rstrip("\r\n")
        if self._take_error(line):
            return None
        for pattern, take in TAKERS:
            found = pattern.match(line)
            if found:
                return take(self, found)
        return None

    def _take_error(self, line):
        text = line.strip()
        if text.startswith("*ERROR"):
            self.errors.append([text])
            self._in_error = True
        elif text.startswith("*WARNING"):
            self.warnings += 1
            self._in_error = False
        elif self._in_error and text and not text.startswith(("*INFO", "STOP ")):
            self.errors[-1].append(text)
        else:
            self._in_error = False
        return self._in_error

    def _begin_step(self, found):
        self.end_step()
        self.step = int(found[1])
        self._step_springs = 0
        self.increment = 0

    def end_step(self):
        """A step is over: were there springs in it?"""
        if (self.step > 0 and self.increment > 0 and self.failure is None and self.most > 0
                and self._step_springs == 0 and self.may_vanish(self.step) == "within"):
            self._fail("springs", f"step {self.step}: no contact springs in the whole step")

    def _begin_increment(self, found):
        number, attempt = int(found[1]), int(found[2])
        if attempt > 1:
            self.cutbacks += 1
        else:
            self.iterations = 0
        self.increment, self.attempt, self.iteration = number, attempt, 0
        self._clues = {}

    def _begin_iteration(self, found):
        self.iteration = int(found[1])
        self.iterations += 1
        self.all_iterations += 1

    def _count_springs(self, found):
        self.springs = int(found[1])
        self.most = max(self.most, self.springs)

    def _note(self, found):
        self._clues[found[1].split("=")[0]] = found[1]

    def _converge(self, _):
        springs = 0 if self.springs is None else self.springs
        self._step_springs = max(self._step_springs, springs)
        gone = springs == 0 or springs < self.share*self.most
        if self.most > 0 and gone and self.may_vanish(self.step) == "never":
            self._fail("springs", f"{self.where()}: contact springs "
                       + (f"dropped to {springs}" if springs else "vanished")
                       + f", there were up to {self.most}")
        return Increment(self.step, self.increment, self.attempt, self.iterations, springs,
                         self.size, self.step_time, self.total_time)

    def _fail(self, reason, message):
        if self.failure is None:
            self.reason, self.failure = reason, message

    def where(self):
        """Step, increment and time in words."""
        return f"step {self.step}, increment {self.increment}, step time {self.step_time:g}"

    def end(self, status, has_contact=True):
        """ccx has ended with an exit status (negative: by a signal); set `failure` if it failed."""
        self.end_step()
        if self.failure is not None:
            return
        stuck = [text for text in self.errors if NO_CONVERGENCE.search(" ".join(text))]
        if stuck:
            text = stuck[0][0].removeprefix("*ERROR").lstrip(": ").replace("in nonlingeo: ", "")
            lines = [f"{self.where()}: {text}",
                     f"increment size {self.size:g}, attempt {self.attempt}, "
                     f"iteration {self.iteration}, contact springs {self.springs or 0}",
                     *self._clues.values()]
            self._fail("convergence", "\n".join(lines))
        elif self.errors:
            self._fail("ccx", short_errors(self.errors))
        elif status < 0:
            self._fail("ccx", f"ccx was killed by signal {-status} in {self.where()}")
        elif status != 0:
            self._fail("ccx", f"ccx ended with status {status} in {self.where()}")
        elif not self.job_finished:
            self._fail("ccx", f"ccx ended without 'Job finished' in {self.where()}")
        elif has_contact and self.most == 0 and self.step > 0 \
                and all(self.may_vanish(step) == "never" for step in range(1, self.step + 1)):
            self._fail("springs", "there was no contact spring in the whole run")

    def _finish(self, _):
        self.job_finished = True

    def _take_uinter(self, found):
        self.uinter = (int(found[1]), float(found[2]))


TAKERS = (
    (INCREMENT, Watcher._begin_increment), (ITERATION, Watcher._begin_iteration),
    (SPRINGS, Watcher._count_springs), (CONVERGED, Watcher._converge), (STEP, Watcher._begin_step),
    (SIZE, lambda self, found: setattr(self, "size", float(found[1]))),
    (STEP_TIME, lambda self, found: setattr(self, "step_time", float(found[1]))),
    (TOTAL_TIME, lambda self, found: setattr(self, "total_time", float(found[1]))),
    (RESIDUAL, Watcher._note), (UINTER, Watcher._take_uinter),
    (NOTE, lambda self, found: self.notes.append(found[1])),
    (re.compile(r" ?Job finished"), Watcher._finish))


def short_errors(errors, most=3):
    """The first errors of ccx, each once, without those that only follow from others."""
    texts = []
    for lines in errors:
        text = "\n   ".join(re.sub(r"\s+", " ", line) for line in lines[:4])
        general = re.match(r"\*ERROR in calinput: (at least one fatal|no material)", text)
        if text not in texts and not (general and texts):
            texts.append(text)
    shown = texts[:most]
    if len(texts) > most:
        shown.append(f"and {len(texts) - most} more")
    return "\n".join(shown)
