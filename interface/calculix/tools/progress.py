"""What the runner says while a deck runs."""

import shutil
import sys


def say(text):
    print("run: " + text, flush=True)


class Progress:
    """A line that changes on a terminal; a log gets one line for each step."""

    def __init__(self, steps):
        self.steps, self.live = steps, sys.stdout.isatty()
        self.shown, self.last = False, -1.0
        self.begin(0)

    def begin(self, step):
        self.step, self.increments, self.iterations, self.wall = step, 0, 0, 0.0
        self.cutbacks, self.springs = 0, (None, None)

    def update(self, watcher, seconds):
        """Show where the run is, on a terminal, not more than five times a second."""
        if not self.live or seconds - self.last < 0.2 or watcher.step == 0:
            return
        self.last, self.shown = seconds, True
        size = shutil.get_terminal_size().columns - 1
        text = (f"step {watcher.step}/{self.steps}  increment {watcher.increment}  "
                f"time {watcher.step_time:.4g}  iteration {watcher.iteration}  "
                f"springs {watcher.springs or 0}  {seconds:.0f} s")
        print("\r" + text[:size].ljust(size), end="", flush=True)

    def clear(self):
        if self.shown:
            print("\r" + " "*(shutil.get_terminal_size().columns - 1) + "\r", end="", flush=True)
            self.shown = False

    def add(self, row):
        """Count a converged increment."""
        if row.step != self.step:
            self.end()
            self.begin(row.step)
        self.increments += 1
        self.iterations += row.iterations
        self.cutbacks += row.attempts - 1
        low, high = self.springs
        self.springs = (row.springs if low is None else min(low, row.springs),
                        row.springs if high is None else max(high, row.springs))

    def end(self, seconds=None):
        """Say what a step took."""
        if self.step == 0:
            return
        self.clear()
        low, high = self.springs
        springs = f"{low}" if low == high else f"{low} to {high}"
        say(f"step {self.step} of {self.steps}: {self.increments} increments, "
            f"{self.iterations} iterations, {self.cutbacks} cutbacks, {springs} contact springs"
            + (f", {seconds:.1f} s in all" if seconds is not None else ""))
        self.step = 0
