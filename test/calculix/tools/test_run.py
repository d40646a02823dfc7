#!/usr/bin/env python3
"""Tests of interface/calculix/run, its readers and pictures. They need no ccx: a fake one says
what ccx would say.

usage: test_run.py [FOLDER of the interface]      prints `N passed, N failed` at the end
"""

import csv
import importlib
import json
import math
import os
import pty
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
INTERFACE = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else
                            os.path.join(HERE, "..", "..", "..", "interface", "calculix"))
RUN, CONTACT = os.path.join(INTERFACE, "run"), os.path.join(INTERFACE, "contact")
FAKE = os.path.join(HERE, "fake_ccx.py")
sys.path.insert(0, INTERFACE)
deck, dat, frd, mesh, restart = (importlib.import_module("tools.files." + name)
                                 for name in ("deck", "dat", "frd", "mesh", "restart"))
faces, history, watch = (importlib.import_module("tools." + name)
                         for name in ("faces", "history", "watch"))

MODEL = """*HEADING
two blocks
** a comment
*NODE,NSET=ALL
1,0.,0.,0.
*CONTACT PAIR,INTERACTION=WOOD,TYPE=NODE TO SURFACE
S,M
"""
STEP = """*STEP,NLGEOM,
INC=100
*STATIC
0.25,1.
*BOUNDARY
TIP,3,3,{}
*END STEP
"""

passed = failed = skipped = 0


def check(name, condition, seen=""):
    """Count one test."""
    global passed, failed
    if condition:
        passed += 1
        print(f"ok   {name}")
    else:
        failed += 1
        print(f"FAIL {name}")
        for line in str(seen).splitlines()[:12]:
            print(f"     | {line}")


def skip(name, why):
    global skipped
    skipped += 1
    print(f"skip {name}: {why}")


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def deck_text(steps=4, model="", each=""):
    return model + MODEL + "".join(each + STEP.format(i) for i in range(1, steps + 1))


class Result:
    """Status and words of a run."""

    def __init__(self, arguments, fake="", **options):
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True,
                              errors="surrogateescape", env={**os.environ, "FAKE": fake, "CCX": FAKE}, check=False,
                              timeout=50, **options)
        self.status, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.text = f"status {self.status}\n{self.err}{self.out}"


def run(*arguments, fake=""):
    return Result([RUN, *arguments], fake)


def rows(path):
    """Rows of a CSV file by the names of its columns, without their units."""
    with open(path, encoding="ascii", newline="") as file:
        return [{name.split(" (")[0]: value for name, value in row.items()}
                for row in csv.DictReader(file)]


def test_whole_run():
    write("a.inp", deck_text())
    r = run("a.inp")
    check("a run to the end", r.status == 0 and r.err == "", r.text)
    table = rows("a.results/history.csv")
    check("history: start and every increment", len(table) == 17
          and read("a.results/history.csv").startswith("step,time,displacement (mm),force (N)\n")
          and float(table[0]["force"]) == 0.0, table[:2])
    check("history: mean displacement and sum of force in the direction that moves",
          float(table[4]["displacement"]) == 4.0 and float(table[4]["force"]) == 200.0
          and float(table[8]["displacement"]) == -4.0 and table[8]["step"] == "2", table[4:9])
    table = rows("a.results/increments.csv")
    check("increments: time, iterations, springs", len(table) == 16
          and [table[5][k] for k in ("step", "increment", "iterations", "springs", "total_time")]
          == ["2", "2", "2", "50", "1.5"], table[5])
    check("a log gets a line for each step", r.out.count("run: step ") == 4 and "\r" not in r.out,
          r.out)
    check("the share of UINTER is told", "1200 calls of UINTER took 0.002 s" in r.out, r.out)
    written = read("a.results/a.inp")
    check("every step writes a restart file", written.count("*RESTART,WRITE") == 4
          and "INC=100\n*RESTART,WRITE" in written, written)
    r = run("a.inp")
    check("results are not overwritten", r.status == 2 and "--resume" in r.err, r.text)
    r = run("a.inp", "--resume")
    check("a finished run is not computed again", r.status == 0 and "all steps are finished"
          in r.out, r.text)
    r = run("a.inp", "--anew", "--output", "a.results")
    check("--anew begins again", r.status == 0 and len(rows("a.results/history.csv")) == 17, r.text)


def test_springs():
    write("s.inp", deck_text())
    r = run("s.inp", fake="vanish=3:2 slow")
    check("springs that vanish fail the run", r.status == 5
          and "step 3, increment 2, step time 0.5: contact springs vanished, there were up to 50"
          in r.err, r.text)
    check("... leave no history", not os.path.exists("s.results/history.csv")
          and os.path.exists("s.results/history.unfinished.csv"), os.listdir("s.results"))
    check("... and stop ccx at once", not os.path.exists("s.results/went_on"),
          os.listdir("s.results"))
    r = run("s.inp", "--anew", fake="vanish=3:2")
    r = run("s.inp", "--resume")
    check("a restart file that ccx wrote after the failure is not used", r.status == 0
          and "all steps" not in r.out and len(rows("s.results/history.csv")) == 17, r.text)
    run("s.inp", "--anew", fake="killed=3:1")
    r = run("s.inp", "--resume", fake="vanish=3:1")
    check("a resumed run knows that there were springs", r.status == 5
          and "step 3, increment 1" in r.err, r.text)
    r = run("s.inp", "--anew", fake="few=2:3")
    check("fewer springs are no failure", r.status == 0, r.text)
    r = run("s.inp", "--anew", "--spring-share", "0.2", fake="few=2:3")
    check("... but below a stated share they are", r.status == 5
          and "step 2, increment 3" in r.err and "dropped to 5" in r.err, r.text)
    r = run("s.inp", "--anew", fake="none")
    check("a contact that never was fails", r.status == 5 and "no contact spring" in r.err, r.text)
    write("t.inp", deck_text().replace("*CONTACT PAIR", "*TIED NOT"))
    r = run("t.inp", fake="none")
    check("... but not in a deck without contact", r.status == 0, r.text)
    write("v.inp", deck_text(model="** springs may vanish\n"))
    r = run("v.inp", fake="vanish=2:1")
    check("a comment allows it", r.status == 0, r.text)
    write("w.inp", MODEL + STEP.format(1) + STEP.format(2) + "** Springs may vanish: lifted\n"
          + STEP.format(3) + STEP.format(4))
    r = run("w.inp", fake="vanish=3:1 return=4:1")
    check("... in one step", r.status == 0, r.text)
    r = run("w.inp", "--anew", fake="vanish=3:1 return=4:2")
    check("... and in that step only", r.status == 5 and "step 4, increment 1" in r.err, r.text)
    write("x.inp", deck_text(model="** springs may vanish within a step\n"))
    r = run("x.inp", fake="vanish=2:2 return=2:4")
    check("within a step", r.status == 0, r.text)
    r = run("x.inp", "--anew", fake="vanish=2:2")
    check("... not for a whole step", r.status == 5 and "step 3: no contact springs in the whole "
          "step" in r.err, r.text)
    r = run("x.inp", "--anew", fake="vanish=4:1")
    check("... nor the last", r.status == 5 and "step 4: no contact" in r.err, r.text)


def test_errors():
    write("e.inp", deck_text())
    r = run("e.inp", fake="error")
    check("ccx's errors are shown", r.status == 1 and "node set NONE" in r.err
          and "has not yet been defined" in r.err, r.text)
    check("... cut to few lines", len(r.err.splitlines()) <= 10, r.err)
    r = run("e.inp", "--anew", fake="late")
    check("an error with status 0 is an error", r.status == 1 and "in something" in r.err, r.text)
    r = run("e.inp", "--anew", fake="small=2:3")
    check("increments too small: where, and the largest residual", r.status == 4
          and "step 2, increment 3, step time 0.75: increment size smaller" in r.err
          and "node 1007" in r.err and "step 1 is finished" in r.err.replace("steps 1 to 1 are",
                                                                             "step 1 is"), r.text)
    r = run("e.inp", "--anew", fake="silent=2:2")
    check("ccx that ends in the middle", r.status == 1 and "Job finished" in r.err, r.text)
    r = run("e.inp", "--ccx", "no-such-program")
    check("no ccx", r.status == 3 and "no program 'no-such-program'" in r.err, r.text)
    write("text.txt", "no program")
    os.chmod("text.txt", 0o755)
    r = run("e.inp", "--anew", "--ccx", "./text.txt")
    check("something that is no program", r.status == 3 and "text.txt" in r.err, r.text)
    r = run("none.inp")
    check("no deck", r.status == 3 and "no deck none.inp" in r.err
          and not os.path.exists("none.results"), r.text)
    write("f.inp", MODEL)
    r = run("f.inp")
    check("a deck without steps", r.status == 2 and "no *STEP" in r.err
          and not os.path.exists("f.results"), r.text)
    write("g.inp", "*RESTART,READ,STEP=2\n" + STEP.format(1))
    r = run("g.inp")
    check("a deck that reads a restart file itself", r.status == 2 and "--resume" in r.err, r.text)
    r = run("e.inp", "--spring-share", "2")
    check("a share above 1", r.status == 2, r.text)
    r = run("e.inp", "--anew", fake="cutback=2:2")
    check("cutbacks are counted", r.status == 0 and "step 2 of 4: 4 increments, 10 iterations, "
          "1 cutbacks" in r.out, r.text)


def test_resume():
    write("r.inp", deck_text())
    run("r.inp", "--output", "whole")
    r = run("r.inp", fake="killed=3:2")
    check("ccx killed", r.status == 1 and "signal 9" in r.err, r.text)
    write("r.results/r.uinter", "properties\n")
    r = run("r.inp", "--resume", fake="killed=4:1")
    check("resumed, killed again", r.status == 1 and "going on after step 2 of 4" in r.out, r.text)
    r = run("r.inp", "--resume")
    check("resumed to the end", r.status == 0 and "going on after step 3 of 4" in r.out, r.text)
    check("the same history as in one go",
          read("r.results/history.csv") == read("whole/history.csv"), read("r.results/history.csv"))
    check("UINTER's properties go along", read("r.results/r-3.uinter") == "properties\n")
    check("the resumed deck has the steps that are left",
          read("r.results/r-3.inp").startswith("*RESTART,READ,STEP=3\n*STEP")
          and read("r.results/r-3.inp").count("*STEP") == 1, read("r.results/r-3.inp"))

    r = run("r.inp", "--anew", fake="killed=1:3")
    r = run("r.inp", "--resume")
    check("nothing finished: from the start", r.status == 0 and "from the start" in r.out, r.text)
    r = run("r.inp", "--anew", "--seconds", "1", fake="hang=2:2")
    check("--seconds stops a run", r.status == 6 and "step 2, increment 1" in r.err, r.text)
    r = run("r.inp", "--resume")
    check("... which goes on", r.status == 0
          and read("r.results/history.csv") == read("whole/history.csv"), r.text)

    run("r.inp", "--anew", fake="killed=3:2")
    write("r.inp", deck_text().replace("TIP,3,3,4", "TIP,3,3,7").replace("** a c", "** another c"))
    r = run("r.inp", "--resume")
    check("a later step may change", r.status == 0, r.text)
    write("r.inp", deck_text(6).replace("TIP,3,3,4", "TIP,3,3,7"))
    r = run("r.inp", "--resume")
    check("steps may be added", r.status == 0 and len(rows("r.results/history.csv")) == 25, r.text)
    write("r.inp", deck_text(6))
    r = run("r.inp", "--resume")
    check("a finished step may not change", r.status == 2 and "finished steps" in r.err, r.text)
    write("r.inp", deck_text(6).replace("1,0.,0.", "1,0.,1."))
    r = run("r.inp", "--resume")
    check("nor the model", r.status == 2 and "the model" in r.err, r.text)
    write("r.results/run.json", "{")
    r = run("r.inp", "--resume")
    check("a damaged state", r.status == 2 and "run.json" in r.err, r.text)


def test_interruption():
    write("i.inp", deck_text())
    environment = {**os.environ, "FAKE": "hang=2:3", "CCX": FAKE}
    for name, number in (("SIGTERM", signal.SIGTERM), ("SIGINT", signal.SIGINT)):
        shutil.rmtree("i.results", ignore_errors=True)
        with subprocess.Popen([sys.executable, RUN, "i.inp", "--anew"], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            wait_for(lambda: increments("i") == 6)
            other = run("i.inp", "--resume") if number == signal.SIGTERM else None
            process.send_signal(number)
            _, err = process.communicate(timeout=20)
        check(f"{name}: stopped, and it is said where", process.returncode == 130
              and "interrupted in step 2" in err, err)
        if other:
            check("a second run in the same folder is refused", other.status == 2
                  and "under way" in other.err, other.text)
    r = run("i.inp", "--resume")
    check("... and resumed", r.status == 0 and len(rows("i.results/history.csv")) == 17, r.text)
    shutil.rmtree("i.results")
    with subprocess.Popen([sys.executable, RUN, "i.inp", "--anew"], env=environment,
                          stdout=subprocess.DEVNULL) as process:
        wait_for(lambda: increments("i") == 6)
        child = children(process.pid)
        process.kill()
    check("a runner that is killed takes ccx along", child and wait_for(
        lambda: not any(alive(pid) for pid in child)), child)
    r = run("i.inp", "--resume", fake="vanish=2:1")
    check("... and what it saw of springs is known", r.status == 5, r.text)
    r = run("i.inp", "--resume")
    check("... and is resumed", r.status == 0 and len(rows("i.results/history.csv")) == 17, r.text)


def increments(name):
    path = f"{name}.results/job.increments.csv"
    return len(rows(path)) if os.path.exists(path) else 0


def children(pid):
    try:
        with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as file:
            return [int(v) for v in file.read().split()]
    except OSError:
        return []


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def wait_for(condition, seconds=15):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.05)
    return False


def test_names():
    names = ["my deck", "it's", 'a"b', "-dash", "\u00fcber \u00e4", "$(touch pwned)", "`touch pwned`",
             "a;touch pwned", "a,b", "job", "job-2", "run.json", "x"*240,
             os.fsdecode(b"latin \xfc")]
    for name in names:
        write(f"./{name}.inp", deck_text())
        folder = f"./{name[:200]}.results"
        r = run(f"./{name}.inp", "--states", fake="killed=3:2")
        again = run(f"./{name}.inp", "--resume", "--states")
        files = os.listdir(folder) if os.path.isdir(folder) else []
        check(f"a deck called {ascii(name[:30])}: run, resumed", r.status == 1 and again.status == 0
              and len(rows(f"{folder}/history.csv")) == 17
              and {f"{name[:200]}.rout", f"{name[:200]}-2.rout"} <= set(files),
              f"{r.text}{again.text}{files}")
        if name in ("my deck", "job"):
            seen = [(row["step"], row["increment"], row["statev_1"]) for row in rows(
                f"{folder}/states.csv")]
            check("states: each increment once, of all parts", seen == [
                (str(i), str(j), str(10*i + j)) for i in range(1, 5) for j in range(1, 5)], seen)
    check("no shell has read a name", not os.path.exists("pwned")
          and not any("pwned" in os.listdir(f) for f in os.listdir(".") if os.path.isdir(f)))
    r = run("my deck.inp", "--anew", "--poison")
    check("what a poisoned run tells", "run: UINTER leaves unset, as it may: SPD SVD" in r.out
          and "nothing to look at" not in r.out, r.text)
    r = run("my deck.inp", "--anew", "--states", "--poison", fake="stock")
    check("a ccx that knows of neither states nor poison", "--poison found nothing" in r.out
          and "no states" in r.out, r.text)


def test_pairs():
    """What CalculiX computes wrongly without a word."""
    law = "*SURFACE INTERACTION,NAME=WOOD\n*SURFACE BEHAVIOR, pressure-overclosure = {}\n1.,2.\n"
    pair = "*CONTACT PAIR,INTERACTION=Wood,\nTYPE={}\nS,M\n"
    for name, behavior, kind, status, text in (
            ("UINTER", "UINTER, PROPERTIES=2", "surface to surface", 2,
             "write *CONTACT PAIR, INTERACTION=Wood, TYPE=NODE TO SURFACE, and below it"),
            ("UINTER and mortar", "UINTER, PROPERTIES=2", "LINMORTAR", 2,
             "serves node to surface alone"),
            ("UINTER, right", "UINTER, PROPERTIES=2", "Node To Surface", 0, ""),
            ("a table", "Tabular", "SURFACE TO SURFACE", 2, "no pressure at all"),
            ("a table, right", "TABULAR", "NODE TO SURFACE", 0, ""),
            ("a line", "LINEAR", "SURFACE TO SURFACE", 0, "")):
        write("p.inp", law.format(behavior) + pair.format(kind) + STEP.format(1))
        r = run("p.inp", "--anew")
        check(f"pairs: {name}", r.status == status and text in r.err, r.text)
    for behavior, told in (("LINEAR", True), ("UINTER, PROPERTIES=2", False)):
        write("p.inp", "*SURFACE,NAME=s,TYPE=NODE\n1,\n" + law.format(behavior)
              + pair.format("NODE TO SURFACE") + STEP.format(1))
        r = run("p.inp", "--anew")
        check(f"pairs: a slave surface of nodes, {behavior[:6]}", r.status == 0
              and ("is given by nodes" in r.out) == told, r.text)
    write("p.inp", pair.format("NODE TO SURFACE") + STEP.format(1).replace(
        "*END", "*CONTACT PRINT,SLAVE=S,MASTER=M\nCDIS,CF\n*END"))
    r = run("p.inp", "--anew")
    check("pairs: totals that are zero", r.status == 0 and "CalculiX writes zeros" in r.out, r.text)


def test_no_terminal():
    write("n.inp", deck_text())
    run("n.inp", "--output", "with")
    without = ("import pty, runpy, sys\ndef none():\n   raise OSError('out of pty devices')\n"
               f"pty.openpty = none\nsys.path.insert(0, {INTERFACE!r})\n"
               f"sys.argv = [{RUN!r}, 'n.inp', '--output', 'without']\n"
               f"runpy.run_path({RUN!r}, run_name='__main__')\n")
    r = Result(["-c", without])
    check("a machine without terminals", r.status == 0 and os.path.exists("without/history.csv")
          and read("without/history.csv") == read("with/history.csv"), r.text)


def test_terminal():
    write("l.inp", deck_text())
    reader, writer = pty.openpty()
    with subprocess.Popen([sys.executable, RUN, "l.inp"], stdout=writer, stderr=writer,
                          env={**os.environ, "FAKE": "slow", "CCX": FAKE}) as process:
        os.close(writer)
        limit = threading.Timer(50, process.kill)
        limit.start()
        seen = b""
        try:
            while True:
                data = os.read(reader, 4096)
                if not data:
                    break
                seen += data
        except OSError:
            pass
    limit.cancel()
    os.close(reader)
    check("a terminal gets a line that changes", process.returncode == 0
          and b"\rstep 2/4  increment " in seen, seen.decode(errors="replace"))


def test_history_options():
    write("h.inp", deck_text(model="** half model\n"))
    run("h.inp")
    check("a half model's force is doubled",
          float(rows("h.results/history.csv")[4]["force"]) == 400.0)
    r = run("h.inp", "--resume", "--force-factor", "3", "--direction", "1")
    check("factor and direction are given", float(rows("h.results/history.csv")[4]["force"]) == 0.0
          and "force times 3" in r.out, r.text)
    r = run("h.inp", "--resume", "--set", "top")
    check("no such set in the results", r.status == 0 and "no history" in r.out
          and "*NODE PRINT,NSET=TOP" in r.out, r.text)
    r = run("h.inp", "--resume", "--gauge", "tip", "--set", "tip")
    check("a gauge of its own", r.status == 0
          and float(rows("h.results/history.csv")[4]["displacement"]) == 4.0, r.text)
    write("h2.inp", deck_text(model="** load: set tip, direction 2\n"))
    r = run("h2.inp")
    check("set and direction of a comment", "in direction 2" in r.out, r.text)
    os.makedirs("sub", exist_ok=True)
    write("sub/model.txt", MODEL)
    write("sub/k.inp", "*INCLUDE, INPUT=model.txt\n" + STEP.format(1))
    r = run("sub/k.inp")
    check("*INCLUDE, relative to the deck", r.status == 0
          and "two blocks" in read("sub/k.results/k.inp"), r.text)
    write("sub/m.inp", "*INCLUDE,INPUT=missing.txt\n" + STEP.format(1))
    r = run("sub/m.inp")
    check("*INCLUDE of nothing", r.status == 2 and "missing.txt" in r.err, r.text)


def test_restart_files():
    sys.path.insert(0, HERE)
    fake = importlib.import_module("fake_ccx")
    one, two = fake.restart_file(1), fake.restart_file(2)
    for name, data, expected in (
            ("one step", two, 2), ("all steps in one file", one + two, 2),
            ("the last cut short", one + two[:-3], 1), ("cut in the middle", one + two[:500], 1),
            ("cut between two records", one + two[:-16], 1), ("cut in its head", one + two[:20], 1),
            ("nothing", b"", 0), ("a step cut short", one[:-1], 0),
            ("no restart file", b"x"*99, 0)):
        with open("r.bin", "wb") as file:
            file.write(data)
        seen = restart.last_step("r.bin")
        check(f"restart file: {name}", seen == expected, seen)
    check("restart file: none", restart.last_step("no.bin") == 0)


def test_readers():
    block = "\n displacements (vx,vy,vz) for set TIP and time  0.2500000E+00\n\n"
    write("t.dat", block + "      7  1.000000E+00 -2.000000-101  3.000000E+00\n"
          "      8  3.000000E+00  0.000000E+00  5.000000E+00\n"
          "\n forces (fx,fy,fz) for set TIP and time  0.2500000E+00\n\n"
          "      7  1.000000E+00  2.000000E+00  3.000000E+00\n"
          "      8  1.000000E+00  2.000000E+00  3.000000E+00\n"
          + block.replace("0.25", "0.50") + "      7  1.000000E+00  2.0000")
    seen = dat.by_time("t.dat", "TIP")
    check(".dat: mean, sum, lost E, a block cut short", len(seen) == 1
          and seen[0][1] == (2.0, -1e-101, 4.0) and seen[0][2] == (2.0, 4.0, 6.0), seen)
    seen = deck.LOAD.match("** Load: set BOTTOM, direction 1, gauge BOTTOM_GAUGE")
    check("a comment with a gauge", seen and seen.groups() == ("BOTTOM", "1", "BOTTOM_GAUGE"))
    check(".dat: another set", dat.by_time("t.dat", "TOP") == [])
    check("a number whose E is lost", frd.number(" 1.23456-101") == 1.23456e-101)
    lines = deck.with_restart(["*STEP,NLGEOM", "*RESTART,WRITE,FREQUENCY=5", "*STATIC"])
    check("a deck's own *RESTART,WRITE is replaced",
          lines == ["*STEP,NLGEOM", "*RESTART,WRITE,FREQUENCY=1,OVERLAY", "*STATIC"], lines)
    w = watch.Watcher(lambda step: "never")
    for text in ("STEP            1", " increment 1 attempt 1 ", " iteration 1",
                 " Number of contact spring elements=3", " no convergence"):
        w.feed(text)
    check("'no convergence' is none", w.feed(" no convergence") is None and w.failure is None)


def write_model(folder):
    """Two unit cubes, one on the other, and results of two increments as ccx writes them."""
    os.makedirs(folder, exist_ok=True)
    nodes = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    text = "*NODE, NSET=ALL\n"
    for body, shift in ((0, 0.0), (10, 1.0)):
        text += "".join(f"{body + i}, {x}., {y}., {z + shift}\n"
                        for i, (x, y, z) in enumerate(nodes, 1))
    text += ("*ELEMENT, TYPE=C3D8I, ELSET=LOW\n1, 1,2,3,4,\n5,6,7,8\n"
             "*ELEMENT, TYPE=C3D8I, ELSET=HIGH\n11, 11,12,13,14,15,16,17,18\n"
             "*ELSET, ELSET=BOTH, GENERATE\n1, 11, 10\n"
             "*SURFACE, NAME=TOP\nHIGH, S1\n*SURFACE, NAME=BASE\nLOW, S2\n"
             "*SURFACE INTERACTION, NAME=WOOD\n"
             "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, PROPERTIES=12, DEPVAR=11\n"
             "0.5, 0.31\n*FRICTION\n1., 1.\n"
             "*CONTACT PAIR, INTERACTION=WOOD, TYPE=NODE TO SURFACE\nTOP, BASE\n")
    write(f"{folder}/c.inp", text + STEP.format(1))
    results = "    1C\n    2C                             8\n"
    for increment, pressure in ((1, 0.5), (2, 2.0)):
        head = (f"    1PSTEP{'':24}{increment:2d}{increment:12d}{1:12d}\n"
                f"  100CL  101{increment/2:12.5E}           8                     0\n")
        results += head + " -4  DISP        4    1\n -5  D1          1    2    1    0\n"
        results += "".join(f" -1{n:10d}{0.0:12.5E}{0.0:12.5E}{-0.1*increment:12.5E}\n"
                           for n in range(11, 15)) + " -3\n"
        results += head + " -4  CONTACT     6    1\n -5  COPEN       1    4    1    1\n"
        for n, shear in ((13, 0.5), (12, 0.25), (11, 0.5)):
            values = (-0.1, 0.0, 0.0, pressure, shear*pressure, 0.0)
            results += f" -1{n:10d}" + "".join(f"{v:12.5E}" for v in values) + "\n"
        results += " -3\n"
    write(f"{folder}/c.frd", results + "    1PSTEP")


def test_contact():
    write_model("c")
    model = mesh.new_mesh(deck.Deck("c/c.inp").model)
    check("a model's elements, sets and pair", len(model.elements) == 2
          and model.element_sets["BOTH"] == [1, 11] and model.elements[1][7] == 8
          and model.pairs[0].slave == "TOP" and model.friction == {"WOOD": 0.5}, vars(model))
    write("old.csv", "step,increment,attempts,iterations,springs,increment_time,step_time,total_time,"
          "wall_seconds,cpu_seconds\n1,1,1,2,50,.5,.5,.5,.1,.25\n")
    seen = history.read_increments("old.csv")
    check("increments as version 0.1 wrote them", len(seen) == 1 and seen[0]["cpu_time"] == .25, seen)
    check("the skin of two bodies", len(model.skin()) == 12)
    check("areas of a face", faces.areas(model.nodes, model.slave_faces()[0][1])
          == {11: 0.25, 12: 0.25, 13: 0.25, 14: 0.25})
    r = Result([CONTACT, "c/c.frd", "--at", "1:1,last", "--csv", "c.csv"])
    table = rows("c.csv") if os.path.exists("c.csv") else []
    check("contact: table", r.status == 0 and len(table) == 8
          and [row["state"] for row in table[4:]] == ["slip", "stick", "slip", "open"]
          and float(table[4]["pressure"]) == 2.0 and float(table[4]["uz"]) == -0.2
          and read("c.csv").startswith("step,increment,time,pair,node,x (mm),y (mm),z (mm),ux (mm),"
                                       "uy (mm),uz (mm),area (mm^2),opening (mm),slip_1 (mm),"
                                       "slip_2 (mm),pressure (MPa),shear_1 (MPa),shear_2 (MPa),"
                                       "state\n"),
          f"{r.text}{table[4:]}")
    # quarters of a mm^2 with 2 MPa: one open, one stick, two slip
    check("contact: a row a face", "step 1, increment 2" in r.out and [
        line.split() for line in r.out.splitlines() if line.split()[:1] in (["face"], ["TOP"])][2:]
          == [["face", "largest_pressure", "(MPa)", "normal_force", "(N)", "area_open", "(mm^2)",
               "area_stick", "(mm^2)", "area_slip", "(mm^2)"],
              ["TOP", "2", "1.5", "0.25", "0.25", "0.5"]], r.text)
    points = [faces.Point(*[0]*3, "TOP", 1, *[0.0]*6, 0.5, *[0.0]*3, 3.0, 0.0, 0.0, state)
              for state in ("open", "closed")]
    row = faces.face_rows(points)[0]
    check("contact: stick and slip are unknown without friction", row[:4] == ("TOP", 3.0, 3.0, 0.5)
          and math.isnan(row.area_stick) and math.isnan(row.area_slip), row)
    for name, nodes in (("numbers", "11,\n12,\n13,\n14,\n"), ("a set", "corners\n")):
        write("c/n.inp", "*NSET,NSET=CORNERS\n11,12,13,14\n" + read("c/c.inp").replace(
            "*SURFACE, NAME=TOP\nHIGH, S1\n", f"*SURFACE, TYPE=NODE, NAME=TOP\n{nodes}"))
        r = Result([CONTACT, "c/c.frd", "--deck", "c/n.inp", "--csv", "n.csv"])
        check(f"contact: a slave surface of nodes, {name}", r.status == 0 and read("n.csv") == (
            read("c.csv").split("\n")[0] + "\n" + "\n".join(read("c.csv").split("\n")[5:])),
            r.text)
    rows_of = [(9, (0.1,)), (5, (0.3,)), (8, (0.2,)), (5, (0.1,)), (3, (0.0,))]
    openings = {(5, 0): 0.1, (5, 1): 0.3}
    springs = faces.by_pair(rows_of, [{3, 5, 8}, {5, 9}], lambda n, i: openings[n, i])
    check("a node of two surfaces: each pair's spring", springs
          == [{8: (0.2,), 5: (0.1,), 3: (0.0,)}, {9: (0.1,), 5: (0.3,)}], springs)
    springs = faces.by_pair([(5, (0.1,))], [{5, 8}, {5, 9}], lambda n, i: openings[n, i])
    check("... and one spring of two possible", springs == [{5: (0.1,)}, {}], springs)
    r = Result([CONTACT, "c/c.frd", "--at", "7"])
    check("contact: no such step", r.status == 2 and "'7'" in r.err, r.text)
    r = Result([CONTACT, "c/c.frd", "--at", "end"])
    check("contact: no step at all", r.status == 2 and "'end'" in r.err, r.text)
    r = Result([CONTACT, "no.frd"])
    check("contact: no file", r.status == 3 and "no.frd" in r.err, r.text)
    write("c/d.inp", MODEL + STEP.format(1))
    r = Result([CONTACT, "c/c.frd", "--deck", "c/d.inp"])
    check("contact: a deck without slave faces", r.status == 2, r.text)
    r = Result([CONTACT, "c/c.frd", "--pressure", "p.bmp"])
    check("contact: a picture of no known kind", r.status == 1 and "p.bmp" in r.err, r.text)
    # a run of two parts: the second step is in the second
    os.makedirs("two", exist_ok=True)
    for name in ("c.inp", "c.frd"):
        shutil.copy(f"c/{name}", f"two/{name}")
    write("two/c-2.frd", read("c/c.frd").replace(f"{1:12d}\n  100C", f"{2:12d}\n  100C"))
    write("two/run.json", json.dumps({"parts": [{"job": "c", "first_step": 1},
                                                {"job": "c-2", "first_step": 2}]}))
    header = "step,increment,attempts,iterations,springs,increment_time,step_time,total_time," \
             "wall_time (s),cpu_time (s)\n"
    write("two/c.increments.csv", header + "1,1,1,1,4,1,1,1,1,1\n1,2,1,1,4,1,1,1,1,1\n")
    write("two/c-2.increments.csv", header + "2,1,1,1,4,1,1,1,1,1\n")
    r = Result([CONTACT, "two", "--at", "1,2"])
    check("contact: a run of two parts, its last try left out", r.status == 0
          and "step 1, increment 2" in r.out and "step 2, increment 1" in r.out, r.text)
    if shutil.which("gnuplot") is None:
        skip("pictures", "gnuplot is not installed")
        return
    r = Result([CONTACT, "c/c.frd", "--at", "1:1,last", "--pressure", "p.svg", "--state", "s.svg",
                "--mesh", "m.svg", "--elements", "high"])
    sizes = [os.path.getsize(name) if os.path.exists(name) else 0
             for name in ("p.svg", "s.svg", "m.svg")]
    check("pictures", r.status == 0 and r.err == "" and min(sizes) > 3000, f"{r.text}\n{sizes}")
    seen = read("s.svg").replace(" ", "")
    check("the picture of states has the colours of open, slip and stick", all(
        f"rgb({colour})" in seen for colour in ("86,180,233", "0,158,115", "213,94,0")))
    r = Result([CONTACT, "c/c.frd", "--mesh", "n.svg", "--elements", "none"])
    check("a picture of no elements", r.status == 1 and not os.path.exists("n.svg"), r.text)


def test_whole_files():
    whole_file = importlib.import_module("tools.files.whole_file").whole_file
    write("w.csv.part", "mine")
    os.symlink("w.csv.part", "l.csv.part")
    write("w.csv", "before")
    os.symlink("w.csv", "l.csv")
    for name in ("w.csv", "l.csv"):
        with whole_file(name) as part:
            write(part, name)
        check(f"{name} is written, and what is called {name}.part stays",
              read("w.csv") == name and read(name + ".part") == "mine", read("w.csv"))
    check("a link stays a link", os.path.islink("l.csv") and os.path.islink("l.csv.part"))
    try:
        with whole_file("w.csv") as part:
            write(part, "half")
            raise KeyboardInterrupt
    except KeyboardInterrupt:
        pass
    check("a file that is not finished is not there", read("w.csv") == "l.csv"
          and not os.path.exists(part), os.listdir("."))


def main():
    folder = tempfile.mkdtemp(prefix="asperity-run-")
    os.chdir(folder)
    try:
        for test in (test_whole_run, test_springs, test_errors, test_resume, test_interruption,
                     test_terminal, test_no_terminal, test_names, test_pairs, test_history_options,
                     test_restart_files, test_readers, test_contact, test_whole_files):
            test()
    finally:
        os.chdir("/")
        shutil.rmtree(folder)
    if skipped:
        print(f"{skipped} skipped")
    print(f"{passed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
