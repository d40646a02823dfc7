#!/usr/bin/env python3
"""Compile and run every block of Markdown pages, follow their links and look up names, lest they rot.

usage: run_blocks.py PAGE.md... --source PROJECT --prefix PREFIX --work FOLDER

The language of a block tells what is done with it:
    fortran    a complete program: compiled against the package installed in PREFIX, and run
    c          likewise, C99 without a warning
    python     a script: run by the Python that runs this
    sh, bash   a script: run by `bash -eu` in a fresh copy of the project
    console    lines that begin with `$ ` are run likewise; the lines between are their output
An HTML comment on the line before the fence (blank lines may stand between) marks a block:
    <!-- output -->         what the block run before this one printed
    <!-- file: NAME -->     written to NAME, where the blocks after it find it; not run itself
    <!-- not run: WHY -->   only shown
A block with neither such a language nor a mark is a failure: nothing is passed over silently.

The blocks of a page share one folder, a fresh copy of the project, and find the installed program on
PATH, the package by CMAKE_PREFIX_PATH, PKG_CONFIG_PATH and LD_LIBRARY_PATH. Expected output is compared
line by line without trailing blanks; a line of three dots stands for any number of lines.

Links to files must meet a file, `#...` a heading, and links lead from the first page to every other. What
stands between single backticks must exist if it begins like a path of the project, and must be a word of its
sources if it is a name with an underscore.
"""

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

FENCE = re.compile(r"^(?P<indent> {0,3})(?P<ticks>`{3,}|~{3,})\s*(?P<language>[\w+-]*)")
LINK = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\]\([^)]*\))*\]\((?P<target>[^)\s]+)\)")
MARK = re.compile(r"^\s*<!--\s*(?P<mark>output|file:\s*\S+|not run:\s*\S.*?)\s*-->\s*$")


class Failure(Exception):
    """A block does not do what the text says."""


class Block:
    """One fenced block: its first line, language, mark and text."""

    def __init__(self, line, language, mark):
        self.line, self.language, self.mark, self.lines = line, language, mark, []

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"


def read_page(path):
    """All fenced blocks of a Markdown file and, by number, its other lines; a fence left open is an error."""
    blocks, prose, current, fence, mark = [], {}, None, None, ""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if current is not None:
            if line.strip().startswith(fence) and not line.strip().strip(fence[0]):
                current = None
            else:
                current.lines.append(line)
            continue
        opening = FENCE.match(line)
        if opening:
            fence = opening["ticks"]
            current = Block(number, opening["language"].lower(), mark)
            blocks.append(current)
        else:
            prose[number] = line
        found = MARK.match(line)
        if found or line.strip():
            mark = found["mark"] if found else ""
    if current is not None:
        sys.exit(f"{path}:{current.line}: this block is never closed")
    return blocks, prose


def anchors(prose):
    """What `#...` can name on a page: its headings as GitHub spells them, the second of a kind with -1."""
    found = set()
    for line in prose.values():
        if re.match(r"#{1,6} ", line):
            plain = re.sub(r"\]\([^)]*\)", "", line.lstrip("#").strip()).lower()
            name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
            same = sum(re.fullmatch(re.escape(name) + r"(-\d+)?", other) is not None for other in found)
            found.add(f"{name}-{same}" if name in found else name)
    return found


def words_of(source):
    """All words of the project's sources."""
    words = set()
    for folder in ("src", "interface", "app", "test", "examples", "cmake"):
        for path in (source / folder).rglob("*"):
            if path.is_file() and "data" not in path.parts:
                words.update(re.findall(r"\w+", path.read_text(encoding="utf-8", errors="ignore")))
    return words


def check_names(pages, source):
    """Find paths and names between backticks that the project does not have; return as check_links."""
    checks, wrong, words = 0, [], words_of(source)
    for path, (_, prose) in pages.items():
        if path.name == "CHANGELOG.md":  # tells what was
            continue
        for number, line in prose.items():
            for name in re.findall(r"`([^`\s]+)[^`]*`", line):
                is_path = re.match(r"(src|interface|app|test|examples|cmake|docs|findings)/", name)
                if not is_path and not re.fullmatch(r"[a-z]\w*_\w+", name):
                    continue
                checks += 1
                # keys of faces have a number, and those of sides a word before
                stem = re.sub(r"^side_|_[12]$", "", re.sub(r"^side_", "", name))
                if not ((source / name).exists() if is_path else name in words or stem in words):
                    wrong.append(f"{path}:{number}: the project has no {name}")
    return checks, wrong


def paragraphs(prose):
    """The first line's number and the text of what stands between blank lines: links may be broken."""
    first = last = 0
    lines = []
    for number, line in prose.items():
        if lines and (number != last + 1 or not line.strip()):
            yield first, "\n".join(lines)
            lines = []
        if line.strip():
            first = first if lines else number
            lines.append(line)
        last = number
    if lines:
        yield first, "\n".join(lines)


def check_links(pages):
    """Follow the links between files; return the number of checks and what is wrong."""
    links, wrong, reached = 0, [], {next(iter(pages))}
    for path, (_, prose) in pages.items():
        for first, paragraph in paragraphs(prose):
            text = re.sub(r"`[^`]*`", "", paragraph)
            for link in LINK.finditer(text):
                number = first + text.count("\n", 0, link.end())
                if re.match(r"[a-z]+:", link["target"]):
                    continue
                links += 1
                name, _, anchor = link["target"].partition("#")
                file = (path.parent / name).resolve() if name else path
                reached.add(file)
                if not file.exists():
                    wrong.append(f"{path}:{number}: there is no file {link['target']}")
                elif anchor and anchor not in anchors(read_page(file)[1]):
                    wrong.append(f"{path}:{number}: no heading of {file.name} is called #{anchor}")
    wrong += [f"{path}: no link leads to this page" for path in pages if path not in reached]
    return links + len(pages), wrong


def compare(expected, printed):
    """Fail unless the printed lines are the expected ones; `...` stands for any lines."""
    expected = [line.rstrip() for line in expected.strip("\n").split("\n")]
    printed = [line.rstrip() for line in printed.strip("\n").split("\n")]
    pattern = "".join(r"(?:.*\n)*" if line.strip() == "..." else re.escape(line) + "\n"
                      for line in expected)
    if not re.fullmatch(pattern, "\n".join(printed) + "\n"):
        raise Failure("expected:\n" + "\n".join("   |" + line for line in expected)
                      + "\nprinted:\n" + "\n".join("   |" + line for line in printed))


class Runner:
    """Runs blocks in one folder and remembers what the last one printed."""

    def __init__(self, source, prefix, work):
        self.folder = work / "asperity"
        shutil.rmtree(work, ignore_errors=True)
        shutil.copytree(source, self.folder, symlinks=True, ignore=lambda folder, names: [
            name for name in names if name == ".git" or (folder == str(source) and name == "build")])
        self.printed = None
        libraries = [str(path) for path in prefix.glob("lib*/**/pkgconfig")]
        self.environment = dict(
            os.environ, PATH=f"{prefix / 'bin'}:{os.environ['PATH']}",
            CMAKE_PREFIX_PATH=str(prefix), PKG_CONFIG_PATH=":".join(libraries),
            LD_LIBRARY_PATH=":".join(str(Path(path).parent) for path in libraries))
        self.compiler = os.environ.get("FC", "gfortran")
        self.c_compiler = os.environ.get("CC", "gcc")

    def command(self, words, limit=600):
        """Run a command and return what it printed; fail when it does."""
        result = subprocess.run(
            words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit, check=False)
        if result.returncode != 0:
            raise Failure(f"status {result.returncode}, printed:\n{result.stdout}")
        return result.stdout

    def fortran(self, block):
        """Compile a complete program as the text says, and run it."""
        source = self.folder / f"block_at_line_{block.line}.f90"
        source.write_text(block.text, encoding="utf-8")
        flags = self.command(["pkg-config", "--cflags", "--libs", "asperity"])
        self.command([self.compiler, "-std=f2018", "-Wall", source.name, *shlex.split(flags),
                      "-o", source.stem])
        self.printed = self.command([f"./{source.stem}"])

    def c(self, block):
        """Compile a complete program in C as the text says, and run it."""
        source = self.folder / f"block_at_line_{block.line}.c"
        source.write_text(block.text, encoding="utf-8")
        flags = self.command(["pkg-config", "--cflags", "--libs", "asperity-c"])
        self.command([self.c_compiler, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                      source.name, *shlex.split(flags), "-o", source.stem])
        self.printed = self.command([f"./{source.stem}"])

    def python(self, block):
        self.printed = self.command([sys.executable, "-c", block.text])

    def script(self, block):
        self.printed = self.command(["bash", "-euo", "pipefail", "-c", block.text])

    def console(self, block):
        """Run each command after `$ ` and compare the lines that follow it."""
        if not block.text.startswith("$ "):
            raise Failure("a console block begins with `$ ` and a command")
        for part in re.split(r"^\$ ", block.text, flags=re.MULTILINE)[1:]:
            command, output = part.split("\n", 1)
            while command.endswith("\\") and output:
                more, output = output.split("\n", 1)
                command += "\n" + more.removeprefix("> ")
            self.printed = self.command(["bash", "-euo", "pipefail", "-c", command])
            compare(output, self.printed)

    def run(self, block):
        """Do with one block what its mark or language says; return that in a word."""
        if block.mark.startswith("not run:"):
            return "shown only: " + block.mark[len("not run:"):].strip()
        if block.mark.startswith("file:"):
            path = self.folder / block.mark[len("file:"):].strip()
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
            return f"written to {path.relative_to(self.folder)}"
        if block.mark == "output":
            if self.printed is None:
                raise Failure("no block was run before this output")
            compare(block.text, self.printed)
            return "output compared"
        action = {"fortran": self.fortran, "c": self.c, "python": self.python,
                  "sh": self.script, "bash": self.script, "console": self.console}.get(block.language)
        if action is None:
            raise Failure(f"language '{block.language}' cannot be run and there is no mark")
        self.printed = None
        action(block)
        return "run"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("page", type=Path, nargs="+")
    for option in ("--source", "--prefix", "--work"):
        parser.add_argument(option, type=Path, required=True)
    options = parser.parse_args()
    pages = {path.resolve(): read_page(path) for path in options.page}
    checks, wrong = check_links(pages)
    names, unknown = check_names(pages, options.source.resolve())
    checks, wrong = checks + names, wrong + unknown
    for problem in wrong:
        print(f"FAIL  {problem}", flush=True)
    passed, failed = checks - len(wrong), len(wrong)
    for path, (blocks, _) in pages.items():
        if not blocks:
            continue
        runner = Runner(options.source.resolve(), options.prefix.resolve(),
                        options.work.resolve() / path.stem)
        for block in blocks:
            place = f"{path.name}:{block.line} {block.language or 'no language'}"
            try:
                print(f"  ok  {place}: {runner.run(block)}", flush=True)
                passed += 1
            except (Failure, subprocess.TimeoutExpired) as failure:
                failed += 1
                print(f"FAIL  {place}: {failure}", flush=True)
    print(f"{passed} passed, {failed} failed")
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main())
