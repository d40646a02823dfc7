"""Finds the program, runs it and reads what it found."""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from .. import __version__
from ..errors import InputError
from .errors import ProgramNotFoundError, of_status
from .result import Result

VARIABLE = "ASPERITY_PROGRAM"
_GET_IT = ("It is no part of this package, as it is linked with libraries under the GNU GPL: build it "
           "from asperity's sources by `./run build`, or install it by cmake, and put its folder on "
           f"PATH or its path into {VARIABLE}")

# What tells a program that it is a rank of MPI: a rank of a parameter study starts one of its own
_LAUNCHERS = ("OMPI_", "PMI_", "PMIX_", "SLURM_PROCID")

# Seconds that an interrupted program has
_PATIENCE = 5.0

File = str | os.PathLike[str]


def find_program() -> Path:
    """Path of the program: that in ASPERITY_PROGRAM, or else the one on PATH.

    Raises:
        ProgramNotFoundError: there is none, or it is not of the version of this package
    """
    named = os.environ.get(VARIABLE)
    found = shutil.which(named or "asperity")
    if found is None:
        place = f"{VARIABLE} = {named} is no program" if named else "no program asperity is on PATH"
        raise ProgramNotFoundError(f"{place}. {_GET_IT}")
    version = _version(found, os.stat(found).st_mtime_ns)
    if version != __version__:
        raise ProgramNotFoundError(f"{found} is {version}; this package needs the program of version "
                                   f"{__version__}. {_GET_IT}")
    return Path(found)


@cache
def _version(program: str, _built: int) -> str:
    """Version of a program, or that it is another one, and what it says."""
    ended = _ended([program, "version"])
    words = ended.stdout.split()
    if len(words) > 1 and words[0] == "asperity":
        return words[1]
    return ": ".join(["not asperity", *ended.stderr.strip().splitlines()[:1]])


def _ended(words: list[str], standard_input: str = "") -> subprocess.CompletedProcess[str]:
    """A program that has ended. On a terminal alone asperity shows progress.

    Raises:
        ProgramNotFoundError: it cannot be run
        InputError: more words than the system takes
    """
    pipe = subprocess.PIPE
    alone = {name: value for name, value in os.environ.items() if not name.startswith(_LAUNCHERS)}
    try:
        process = subprocess.Popen(words, stdin=pipe, stdout=pipe, stderr=pipe, encoding="utf-8",
                                   errors="replace", env=alone)
    except OSError as problem:
        if problem.errno == errno.E2BIG:
            raise InputError("a list is too long for a command line: give it in a case file, by "
                             "case_text") from problem
        raise ProgramNotFoundError(f"{words[0]} cannot be run: {problem.strerror}. {_GET_IT}") \
            from problem
    with process:
        try:
            output, said = process.communicate(standard_input)
        except BaseException:
            # asked first, as it ends what it runs itself and takes its folder away
            process.terminate()
            try:
                with suppress(subprocess.TimeoutExpired):
                    process.wait(_PATIENCE)
            finally:
                process.kill()
            raise
    return subprocess.CompletedProcess(words, process.returncode, output, said)


def _words(value: Any) -> list[str]:
    """The words of a key's value."""
    value = _plain(value)
    if isinstance(value, Mapping):
        return [",".join(f"{name}={_words(part)[0]}" for name, part in value.items())]
    if isinstance(value, (str, os.PathLike)):
        return [os.fspath(value)]
    if hasattr(value, "__iter__"):
        parts = list(value)
        if parts and all(isinstance(part, os.PathLike) for part in parts):
            return [os.fspath(part) for part in parts]
        return [",".join(_words(part)[0] for part in parts)]
    return [repr(value).lower()]


def _plain(value: Any) -> Any:
    """One of numpy's numbers as Python has it."""
    return value.item() if isinstance(value, (np.generic, np.ndarray)) and value.ndim == 0 else value


def _options(keys: Mapping[str, Any]) -> list[str]:
    """Options that stand for keys."""
    options = []
    for name, value in keys.items():
        option = name.replace("_", "-")
        if value is None:
            continue
        if isinstance(_plain(value), bool):
            options.append(f"--{option}" if value else f"--no-{option}")
        elif name == "sweep" and isinstance(value, Mapping):
            for swept, values in value.items():
                options += ["--sweep", f"{swept}={_words(values)[0]}"]
        else:
            options += [f"--{option}", *_words(value)]
    return options


def run(command: str, *files: File, case_text: str | None = None, **keys: Any) -> Result:
    """Run a command of the program.

    Args:
        command: its name, such as "press", "shear" or "curve"
        *files: what stands after it: a case file, records, height maps
        case_text: text of a case file, in place of one
        **keys: keys by their names in case files, and outputs such as csv="loops.csv". A number, a
            text, True or False, a list, a list of pathlib.Path where a key takes several files, or a
            dictionary where it takes NAME=VALUE,...; sweep={"sigma": [0.04, 0.06]} runs all
            combinations. None is a key that is not given. `asperity help COMMAND` explains them all

    Returns:
        all that the command found, in full precision

    Raises:
        InputError: what the program refuses, such as a key that it does not know (status 2)
        ComputationError: a computation failed (status 1)
        FileError: a file could not be read or written (status 3)
        ProgramNotFoundError: the program is not there, or of another version
    """
    # a name that begins as an option does is one of this folder
    names = [os.fspath(file) for file in files]
    names = ["./" + name if name.startswith("-") else name for name in names]
    words = [str(find_program()), *command.split(), *names]
    if case_text is not None:
        words.append("-")
    # in a file, so that standard output has the tables
    with tempfile.TemporaryDirectory(prefix="asperity-") as folder:
        answer, case = Path(folder, "answer.json"), Path(folder, "case.nml")
        if command in ("surface", "fit") and keys.get("case") is not None:
            case = Path(keys["case"])
        elif command in ("surface", "fit"):
            keys["case"] = case
        ended = _ended([*words, *_options(keys), "--json", str(answer)], case_text or "")
        # with an answer, 1 is the answer no
        if ended.returncode != 0 and not (ended.returncode == 1 and answer.exists()):
            message = ended.stderr.strip().removeprefix("asperity: error: ")
            raise of_status(ended.returncode, message or "it says nothing")
        if not answer.exists():
            raise InputError(f"'{command}' finds no values: see what the program says by itself")
        # names of files need be no text
        found = json.loads(answer.read_text(encoding="utf-8", errors="surrogateescape"))
        return Result.from_json(found, ended.stdout,
                                passed=ended.returncode == 0,
                                case=case.read_text(encoding="utf-8") if case.exists() else None)
