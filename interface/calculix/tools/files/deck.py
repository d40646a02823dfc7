"""A CalculiX input deck, taken apart into its model and its steps."""

import hashlib
import os
import re

# Comment lines that the runner obeys
HALF_MODEL = re.compile(r"\*\*\s*half model\b", re.I)
MAY_VANISH = re.compile(r"\*\*\s*springs may vanish\b(\s+within a step)?", re.I)
LOAD = re.compile(r"\*\*\s*load:\s*set\s+([^\s,]+)\s*,\s*direction\s+([123])\b"
                  r"(?:\s*,\s*gauge\s+([^\s,]+))?", re.I)


class DeckError(Exception):
    """What is wrong with a deck."""


def keyword(line):
    """The keyword of a line as ccx understands it, upper case without blanks, or ''."""
    if not line.startswith("*") or line.startswith("**"):
        return ""
    return line.split(",")[0].replace(" ", "").replace("\t", "").strip().upper()


def parameters(line):
    """Parameters of a keyword line: {name: value or ''}."""
    values = {}
    for text in line.strip().split(",")[1:]:
        name, _, value = text.partition("=")
        values[re.sub(r"\s+", "", name).upper()] = value.strip()
    return values


def read_lines(path, depth=0):
    """Lines of a deck with its *INCLUDE files in place."""
    if depth > 5:
        raise DeckError(f"{path}: *INCLUDE goes in circles")
    try:
        with open(path, encoding="utf-8", errors="surrogateescape") as file:
            text = file.read()
    except OSError as problem:
        raise DeckError(f"{path}: {problem.strerror}") from problem
    lines = []
    for line in text.splitlines():
        if keyword(line) != "*INCLUDE":
            lines.append(line)
            continue
        name = parameters(line).get("INPUT", "").strip('"')
        if not name:
            raise DeckError(f"{path}: *INCLUDE without INPUT=")
        # ccx looks in the folder it runs in; a deck means its own
        lines += read_lines(os.path.join(os.path.dirname(path), name), depth + 1)
    return lines


def digest(lines):
    """A fingerprint of what lines say: comments and blanks do not count."""
    said = [line.strip().upper() for line in lines
            if line.strip() and not line.startswith("**")]
    return hashlib.sha256("\n".join(said).encode("utf-8", "surrogateescape")).hexdigest()


class Deck:
    """Model, steps, and what comment lines say to the runner."""

    def __init__(self, path):
        self.path = path
        self.model, self.steps = split(read_lines(path))
        if not self.steps:
            raise DeckError(f"{path}: no *STEP")
        every = self.model + [line for step in self.steps for line in step]
        for line in every:
            if keyword(line) == "*RESTART" and "READ" in parameters(line):
                raise DeckError(f"{path}: *RESTART,READ: give the deck of the whole programme; "
                                "--resume makes the deck that goes on")
        self.half_model = any(HALF_MODEL.match(line) for line in every)
        self.has_contact = any(keyword(line) == "*CONTACTPAIR" for line in self.model)
        self.load_set, self.load_direction, self.gauge = "TIP", None, None
        for line in every:
            found = LOAD.match(line)
            if found:
                self.load_set, self.load_direction = found[1].upper(), int(found[2])
                self.gauge = found[3].upper() if found[3] else None

    def may_vanish(self, step):
        """'never', 'within' or 'always': may contact springs vanish in a step, 1 the first?

        A comment before the first step speaks of all, one inside a step of that step."""
        answer = "never"
        for lines in (self.model, self.steps[step - 1]):
            for line in lines:
                found = MAY_VANISH.match(line)
                if found:
                    answer = "within" if found[1] else "always"
        return answer

    def fingerprints(self):
        """Of the model and of each step, for --resume."""
        return {"model": digest(self.model), "steps": [digest(step) for step in self.steps]}

    def text(self):
        """The deck that starts the programme, writing a restart file after every step."""
        lines = list(self.model)
        for step in self.steps:
            lines += with_restart(step)
        return "\n".join(lines) + "\n"

    def resumed_text(self, finished):
        """The deck that goes on after so many finished steps: the restart file holds the model."""
        lines = [f"*RESTART,READ,STEP={finished}"]
        for step in self.steps[finished:]:
            lines += with_restart(step)
        return "\n".join(lines) + "\n"


def split(lines):
    """Model and steps of a deck. Comments above a *STEP belong to that step, save to the first."""
    model, steps, inside = [], [], False
    waiting = []
    for line in lines:
        word = keyword(line)
        if word == "*STEP":
            steps.append(waiting + [line])
            waiting, inside = [], True
        elif inside:
            steps[-1].append(line)
            inside = word != "*ENDSTEP"
        elif steps:
            if word or (line.strip() and not line.startswith("**")):
                raise DeckError(f"'{line.strip()}' between steps")
            waiting.append(line)
        else:
            model.append(line)
    return model, steps


def with_restart(step):
    """A step that writes the restart file when done."""
    lines, waiting = [], False
    for line in step:
        if keyword(line) == "*RESTART":
            continue
        lines.append(line)
        if keyword(line) == "*STEP" or waiting:
            waiting = line.rstrip().endswith(",")
            if not waiting:
                lines.append("*RESTART,WRITE,FREQUENCY=1,OVERLAY")
    return lines
