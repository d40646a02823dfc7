"""The program as a process: how it is found, run, interrupted, and what it is not asked."""

import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import asperity
import numpy as np
import pytest
from asperity import program
from conftest import wood

EXAMPLES = Path(__file__).parents[2]/"examples"


def fake(folder, text):
    """A program that is none of ours."""
    path = folder/"asperity"
    path.write_text("#!/bin/sh\n" + text, encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def test_no_program(monkeypatch, tmp_path):
    monkeypatch.delenv("ASPERITY_PROGRAM", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(program.ProgramNotFoundError, match="no program asperity is on PATH.*cmake"):
        program.tenon()
    monkeypatch.setenv("ASPERITY_PROGRAM", str(tmp_path/"none"))
    with pytest.raises(program.ProgramNotFoundError, match="ASPERITY_PROGRAM = .*none is no program"):
        program.tenon()


@pytest.mark.parametrize(("text", "kind", "message"), [
    ("echo asperity 0.1.7", program.ProgramNotFoundError, "is 0.1.7; this package needs"),
    ("echo hello", program.ProgramNotFoundError, "is not asperity; this package needs"),
    ('[ "$1" = version ] && echo asperity VERSION && exit; echo asperity: error: no root >&2; exit 1',
     asperity.ComputationError, "^no root$"),
    ('[ "$1" = version ] && echo asperity VERSION && exit; kill -SEGV $$',
     asperity.ComputationError, "ended by signal 11"),
    ("echo no libgsl >&2; exit 127", program.ProgramNotFoundError, "is not asperity: no libgsl; this"),
])
def test_other_programs(monkeypatch, tmp_path, text, kind, message):
    monkeypatch.setenv("ASPERITY_PROGRAM",
                       str(fake(tmp_path, text.replace("VERSION", asperity.__version__))))
    with pytest.raises(kind, match=message):
        program.tenon()


def test_file_that_is_no_program(monkeypatch, tmp_path):
    path = fake(tmp_path, "")
    path.write_bytes(b"\0")
    monkeypatch.setenv("ASPERITY_PROGRAM", str(path))
    with pytest.raises(program.ProgramNotFoundError, match="cannot be run: "):
        program.tenon()


def test_program_that_is_built_anew(monkeypatch, tmp_path):
    """What was there before is forgotten."""
    monkeypatch.setenv("ASPERITY_PROGRAM", str(fake(tmp_path, "echo asperity 0.1.7")))
    with pytest.raises(program.ProgramNotFoundError, match=r"is 0\.1\.7"):
        program.find_program()
    path = fake(tmp_path, f"echo asperity {asperity.__version__}")
    os.utime(path, ns=(0, 1))
    assert program.find_program() == path


def test_interrupt(tmp_path, monkeypatch):
    """An interrupt ends the program with what that runs, and takes its folder away."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setenv("ASPERITY_PROGRAM", str(fake(
        tmp_path, f'[ "$1" = version ] && echo asperity {asperity.__version__} && exit\n'
        f'sleep 100 & trap "kill $!; wait" TERM; echo $! >"{tmp_path}/id"; wait')))
    # a shell's background jobs ignore it, and with them all that they start
    caller = subprocess.Popen([sys.executable, "-c", "from asperity import program; program.tenon()"],
                              stderr=subprocess.PIPE, text=True,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    for _ in range(600):
        if (tmp_path/"id").exists() and (tmp_path/"id").read_text(encoding="utf-8").endswith("\n"):
            break
        time.sleep(0.05)
    caller.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in caller.communicate(timeout=30)[1]
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path/"id").read_text(encoding="utf-8")), 0)
    assert not list(tmp_path.glob("asperity-*"))


def test_rank_of_a_study(monkeypatch):
    """Started by a rank of MPI, the program is none."""
    expected = program.tenon(amplitudes=8).data["moment"]
    for name, value in {"OMPI_COMM_WORLD_RANK": "1", "OMPI_COMM_WORLD_SIZE": "2", "PMI_RANK": "1",
                        "PMI_SIZE": "2", "PMIX_RANK": "1", "SLURM_PROCID": "1",
                        "SLURM_STEP_NUM_TASKS": "2"}.items():
        monkeypatch.setenv(name, value)
    np.testing.assert_array_equal(program.tenon(amplitudes=8).data["moment"], expected)


def test_odd_names(tmp_path, monkeypatch):
    """Names that look like options, with blanks, quotes and bytes that are no text."""
    monkeypatch.chdir(tmp_path)
    record = (EXAMPLES/"records/cyclic_1.csv").read_bytes()
    expected = program.hysteresis(EXAMPLES/"records/cyclic_1.csv").data["damping"]
    for name in "-record.csv", "a b;'$x\".csv", "h\udcf6lzern.csv":
        (tmp_path/name).write_bytes(record)
        np.testing.assert_array_equal(program.hysteresis(name).data["damping"], expected)
    program.run("press", csv="-press.csv")
    assert (tmp_path/"-press.csv").exists()


def test_what_stands_alone():
    """A text where several are usual."""
    one = program.fit(EXAMPLES/"fit/press.csv", kind="press", free="eta", fix={
        "pair": "transverse-tangential", "initial_separation": 0.2372, "machine_compliance": 0.004})
    assert one.summary["parameter"].tolist() == ["eta"]
    profile = sorted((EXAMPLES/"surface/profiles").glob("*.csv"))
    found = program.surface(profile[0], perpendicular=str(profile[-1]), case=None)
    assert found.tables["profiles"].rows == 2
    swept = program.run("press", sweep="sigma=0.04,0.06").data
    assert set(swept["sigma"].tolist()) == {0.04, 0.06}


@pytest.mark.parametrize(("call", "kind", "message"), [
    (lambda: program.run("press --help"), asperity.InputError, "'press --help' finds no values"),
    (lambda: program.run("shear", case_text=""), asperity.InputError, "case"),
    (lambda: program.run("curve", separation=np.linspace(0.0, 0.2, 20_000)), asperity.InputError,
     "too long for a command line"),
    (lambda: program.tenon(properties=wood(), eta=100.0), asperity.InputError, "eta is given beside"),
    (lambda: program.tenon(properties=asperity.Law(wood())), TypeError, "it must be Properties"),
    (lambda: program.law_properties("none.nml", pair="transverse-tangential"), program.FileError,
     "none.nml: cannot be read"),
    (lambda: program.law_properties(program.run("press")), asperity.InputError,
     "press ran without friction_coefficient and critical_slip: give them"),
    (lambda: program.run("curve").summary, KeyError, "curve has no table summary; there are data"),
])
def test_refusals(call, kind, message):
    with pytest.raises(kind, match=message):
        call()


def test_properties_of_a_press():
    """Friction, that it has none of, is filled in; what it has stays."""
    pressed = program.run("press", sigma=0.05)
    filled = program.law_properties(pressed, pair="transverse-tangential", critical_slip=0.2)
    assert filled == wood(sigma=0.05, initial_separation=0.2, critical_slip=0.2)


def test_short_words():
    """A result in a line or two, though it holds hundreds of values."""
    assert len(repr(program.run("press"))) < 1000
